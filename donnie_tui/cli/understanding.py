"""What a command line asks for. One that plainly begins to work is understood here, argparse (slow to load)
is only asked about all others.

The first word that is no option and no option's value is the command, or the program.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import SimpleNamespace

from devices.ports.hints import TYPE_CHECKING
from donnie_tui.cli.arguments import COMMANDS, COMMON, TO_COME, Invocation
from donnie_tui.i18n.words import Words

if TYPE_CHECKING:
    from argparse import Namespace

_SWITCHES = {
    **dict.fromkeys(("--linear", "-t", "-T"), "linear"),
    "--visual": "visual",
    "--plain": "plain",
    **dict.fromkeys(("-m", "-M"), "mute"),
    **dict.fromkeys(("-l", "-L"), "log"),
}
"""What the program itself takes without a value."""


def command_of(arguments: list[str]) -> tuple[str, list[str]]:
    """The command, empty for none, and the arguments without it."""
    index = _first_word(arguments)
    if index is None or arguments[index] not in COMMANDS:
        return "", arguments
    return arguments[index], arguments[:index] + arguments[index + 1 :]


def _first_word(arguments: list[str]) -> int | None:
    skip = False
    for index, each in enumerate(arguments):
        if skip:
            skip = False
        elif each == "--":
            return None
        elif each.startswith("--"):
            skip = each[2:] in COMMON
        elif each.lower() == "-f":
            return None
        elif not each.startswith("-") or each == "-":
            return index
    return None


def understand(arguments: list[str], words: Words) -> Invocation:
    """Raises ``WrongUsage``. Prints help and leaves where that is asked for, as argparse does.

    Of a command that is still to come only the name is understood.
    """
    command, rest = command_of(arguments)
    if command in TO_COME:
        return Invocation(command, {}, SimpleNamespace())
    parsed = (None if command else plainly(rest)) or _parsed(command, rest, words)
    options = {key: getattr(parsed, key) for key in COMMON if getattr(parsed, key, None) is not None}
    return Invocation(command, options, parsed)


def plainly(arguments: list[str]) -> SimpleNamespace | None:
    """What argparse would find in a line without a command, or None where that may need a closer look."""
    given: dict[str, object] = {"file": None, "run": None, **dict.fromkeys(_SWITCHES.values(), False)}
    given |= dict.fromkeys(COMMON)
    rest = iter(arguments)
    for each in rest:
        name, equals, value = each.partition("=")
        if each in _SWITCHES:
            given[_SWITCHES[each]] = True
        elif name[:2] == "--" and name[2:] in COMMON:
            given[name[2:]] = value = value if equals else next(rest, "")
            if not value or value.startswith("-"):
                return None
        elif not each or each.startswith("-") or given["file"] is not None:
            return None
        else:
            given["file"] = each
    return None if given["linear"] and given["visual"] else SimpleNamespace(**given)


def _parsed(command: str, arguments: list[str], words: Words) -> Namespace:
    from donnie_tui.cli.parsers import parser_of

    told = words if any(_may_ask_for_help(each) for each in arguments) else _untold
    return parser_of(command, told).parse_args(arguments)


def _may_ask_for_help(argument: str) -> bool:
    """``--help``, or an ``h`` among letters such as ``-mh``."""
    return argument == "--help" or (argument[:1] == "-" and argument[1:2] != "-" and "h" in argument.lower())


def _untold(_code: str) -> str:
    """Nobody reads the help: its fifty sentences need not be made."""
    return ""


def language_before_parsing(
    arguments: list[str], environment: Mapping[str, str], file: Mapping[str, object]
) -> str:
    """The language in which help and wrong usage are told: the first sound one of all sources."""
    from donnie_tui.settings.chosen import BadOption, resolve

    for given in (_language_option(arguments), {}):
        try:
            return resolve(given, environment, file)[0].language
        except BadOption:
            continue
    return "en"


def _language_option(arguments: list[str]) -> dict[str, str]:
    """What ``--lang`` says, wherever it stands."""
    for at, each in enumerate(arguments):
        key, _, value = each.partition("=")
        if key == "--lang":
            return {"lang": value or "".join(arguments[at + 1 : at + 2])}
    return {}
