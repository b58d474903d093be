"""What can be written behind ``donnie``: the commands, their options, and help in the learner's language.

Each command has a parser of its own with the common options in it, so that an option may stand before or
behind the command. The first word that is no option and no option's value is the command, or the program.
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Callable
from dataclasses import dataclass
from typing import NoReturn

from donnie_tui.i18n.words import Words

COMMON = ("world", "robot", "lang", "speed", "seed", "speech", "sound", "verbosity", "record", "events")
"""The options that mean the same everywhere; their values are read in ``settings``."""

TO_COME = ("challenge", "replay", "devices", "doctor", "stop", "serve")
COMMANDS = ("run", "check", "format", "worlds", "world", *TO_COME)

_PLACEHOLDERS = {
    "world": "NAME_OR_FILE",
    "robot": "sim",
    "lang": "en|pt|es",
    "speed": "N|max",
    "seed": "N",
    "speech": "auto|off|text|tts",
    "sound": "on|off",
    "verbosity": "brief|normal|full",
    "record": "FILE",
    "events": "FILE|-",
}


class WrongUsage(Exception):
    """The command line can't be understood. ``problem`` in the words of the parser."""

    def __init__(self, problem: str) -> None:
        super().__init__(problem)
        self.problem = problem


@dataclass(frozen=True, slots=True)
class Invocation:
    """What was asked for."""

    command: str
    """Empty for the program itself."""
    options: dict[str, str]
    """The common ones that were given, by key."""
    arguments: argparse.Namespace


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise WrongUsage(message)


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
        return Invocation(command, {}, argparse.Namespace())
    parsed = _parser(command, words).parse_args(rest)
    options = {key: getattr(parsed, key) for key in COMMON if getattr(parsed, key, None) is not None}
    return Invocation(command, options, parsed)


def _parser(command: str, words: Words) -> argparse.ArgumentParser:
    parser = _Parser(
        prog=f"donnie {command}".strip(),
        description=words(f"usage-{command or 'donnie'}"),
        epilog=None if command else words("usage-commands", commands=", ".join(COMMANDS[:5])),
        add_help=False,
        allow_abbrev=False,
    )
    _ADD[command](parser, words)
    common = parser.add_argument_group(words("usage-options"))
    for key in COMMON:
        common.add_argument(f"--{key}", metavar=_PLACEHOLDERS[key], help=words(f"option-{key}"))
    common.add_argument("-h", "-H", "--help", action="help", help=words("option-help"))
    return parser


def _add_front_end(parser: argparse.ArgumentParser, words: Words) -> None:
    from donnie_tui import __version__

    parser.add_argument("file", nargs="?", metavar="FILE", help=words("option-file"))
    mode = parser.add_mutually_exclusive_group()
    mode.add_argument("--linear", "-t", "-T", action="store_true", help=words("option-linear"))
    mode.add_argument("--visual", action="store_true", help=words("option-visual"))
    parser.add_argument("-f", "-F", metavar="FILE", dest="run", help=words("option-f"))
    parser.add_argument("-m", "-M", action="store_true", dest="mute", help=words("option-m"))
    parser.add_argument("-l", "-L", action="store_true", dest="log", help=words("option-l"))
    parser.add_argument("--version", action="version", version=__version__, help=words("option-version"))


def _add_run(parser: argparse.ArgumentParser, words: Words) -> None:
    parser.add_argument("file", nargs="+", metavar="FILE", help=words("option-file-or-input"))
    parser.add_argument("--trace", action="store_true", help=words("option-trace"))


def _add_check(parser: argparse.ArgumentParser, words: Words) -> None:
    parser.add_argument("file", nargs="+", metavar="FILE", help=words("option-file-or-input"))


def _add_format(parser: argparse.ArgumentParser, words: Words) -> None:
    parser.add_argument("file", nargs="+", metavar="FILE", help=words("option-file-or-input"))
    parser.add_argument("--to", choices=("en", "pt", "es"), help=words("option-to"))
    parser.add_argument("-w", "--write", action="store_true", help=words("option-write"))


def _add_nothing(parser: argparse.ArgumentParser, words: Words) -> None:
    """The command takes the common options only."""


def _add_world(parser: argparse.ArgumentParser, words: Words) -> None:
    parser.add_argument("name", nargs="?", metavar="NAME", help=words("option-world"))
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--map", action="store_true", help=words("option-map"))
    form.add_argument("--report", action="store_true", help=words("option-report"))
    form.add_argument("--json", action="store_true", help=words("option-json"))
    form.add_argument("--svg", metavar="FILE", help=words("option-svg"))
    form.add_argument("--brf", metavar="FILE", help=words("option-brf"))


_ADD: dict[str, Callable[[argparse.ArgumentParser, Words], None]] = {
    "": _add_front_end,
    "run": _add_run,
    "check": _add_check,
    "format": _add_format,
    "worlds": _add_nothing,
    "world": _add_world,
}


def language_before_parsing(arguments: list[str], environment: dict[str, str] | os._Environ[str]) -> str:
    """The language in which wrong usage is told: the option's if it is sound, else the environment's."""
    from donnie_tui.settings import language_of

    for at, each in enumerate(arguments):
        key, _, value = each.partition("=")
        if key == "--lang":
            given = value or (arguments[at + 1] if at + 1 < len(arguments) else "")
            return language_of({"LANG": given})
    return language_of(
        {"LANG": environment.get("DONNIE_LANG", "")} if environment.get("DONNIE_LANG") else environment
    )
