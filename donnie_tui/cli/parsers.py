"""The options of every command, as argparse takes them, with help in the learner's language.

Each command has a parser of its own with the common options in it, so that an option may stand before or
behind the command.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable
from typing import NoReturn, TypeAlias

from donnie_tui import LANGUAGES
from donnie_tui.cli.arguments import COMMANDS, COMMON, TO_COME, WrongUsage
from donnie_tui.settings.chosen import BadOption

_PLACEHOLDERS = {
    "world": "NAME_OR_FILE",
    "robot": "sim|serial|serial:PORT|double",
    "belt": "PORT",
    "lang": "en|pt|es",
    "speed": "N|max",
    "seed": "N",
    "speech": "auto|off|text|ssip|tts|robot",
    "sound": "on|off|wav:FILE",
    "verbosity": "brief|normal|full",
    "record": "FILE",
    "events": "FILE|-",
}


_PROBLEMS = (
    (r"the following arguments are required: (.*)", "usage-missing"),
    (r"unrecognized arguments: (.*)", "usage-unrecognized"),
    (r"argument ([^:]*): expected .*", "usage-without-value"),
    (r"argument ([^:]*): invalid int .*", "usage-no-number"),
    (r"argument ([^:]*): not allowed with.*", "usage-not-together"),
)
"""What argparse complains about, and our sentence for it."""

_LONGEST_QUOTE = 40
Tells: TypeAlias = Callable[[str], str]
"""The sentence of a code."""


class _Parser(argparse.ArgumentParser):
    """Complains by code, in no language."""

    def error(self, message: str) -> NoReturn:
        choice = re.fullmatch(r"argument --([^:]*): invalid choice: (.*) \(choose from (.*)\)", message)
        if choice:
            raise BadOption(choice[1], choice[2].strip("'\""), choice[3].replace("'", ""))
        for pattern, code in _PROBLEMS:
            found = re.fullmatch(pattern, message)
            if found:
                raise WrongUsage(code, found[1][:_LONGEST_QUOTE])
        raise WrongUsage("usage-unrecognized", message[:_LONGEST_QUOTE])


def _formatter(words: Tells) -> type[argparse.HelpFormatter]:
    """Help with the first word in the learner's language; the lines of a text stay lines."""

    class Formatter(argparse.HelpFormatter):
        def add_usage(self, usage, actions, groups, prefix=None):  # type: ignore[no-untyped-def] # argparse's own
            super().add_usage(usage, actions, groups, prefix or f"{words('usage-prefix')} ")

        def _fill_text(self, text: str, width: int, indent: str) -> str:
            return "\n".join(
                super(Formatter, self)._fill_text(each, width, indent) for each in text.split("\n")
            )

    return Formatter


def parser_of(command: str, words: Tells) -> argparse.ArgumentParser:
    """Of a command, or of the program itself. ``words`` are only asked where help may be wanted."""
    parser = _Parser(
        prog=f"donnie {command}".strip(),
        description=words(f"usage-{command or 'donnie'}"),
        epilog=None if command else _all_commands(words),
        formatter_class=_formatter(words),
        add_help=False,
        allow_abbrev=False,
    )
    _ADD[command](parser.add_argument_group(words("usage-arguments")), words)
    common = parser.add_argument_group(words("usage-options"))
    for key in COMMON:
        common.add_argument(f"--{key}", metavar=_PLACEHOLDERS[key], help=words(f"option-{key}"))
    common.add_argument("-h", "-H", "--help", action="help", help=words("option-help"))
    return parser


def _all_commands(words: Tells) -> str:
    """A line each, with what it is for."""
    known = (each for each in COMMANDS if each not in TO_COME)
    return "\n".join([words("usage-commands"), *(f"{each}: {words(f'usage-{each}')}" for each in known)])


def _add_front_end(parser: argparse._ArgumentGroup, words: Tells) -> None:
    from donnie_tui import __version__

    parser.add_argument("file", nargs="?", metavar="FILE", help=words("option-file"))
    mode = parser.add_mutually_exclusive_group()
    mode.add_argument("--linear", "-t", "-T", action="store_true", help=words("option-linear"))
    mode.add_argument("--visual", action="store_true", help=words("option-visual"))
    parser.add_argument("--plain", action="store_true", help=words("option-plain"))
    parser.add_argument("-f", "-F", metavar="FILE", dest="run", help=words("option-f"))
    parser.add_argument("-m", "-M", action="store_true", dest="mute", help=words("option-m"))
    parser.add_argument("-l", "-L", action="store_true", dest="log", help=words("option-l"))
    parser.add_argument("--version", action="version", version=__version__, help=words("option-version"))


def _add_run(parser: argparse._ArgumentGroup, words: Tells) -> None:
    parser.add_argument("file", nargs="+", metavar="FILE", help=words("option-file-or-input"))
    parser.add_argument("--trace", action="store_true", help=words("option-trace"))


def _add_check(parser: argparse._ArgumentGroup, words: Tells) -> None:
    parser.add_argument("file", nargs="+", metavar="FILE", help=words("option-file-or-input"))


def _add_format(parser: argparse._ArgumentGroup, words: Tells) -> None:
    parser.add_argument("file", nargs="+", metavar="FILE", help=words("option-file-or-input"))
    parser.add_argument("--to", choices=LANGUAGES, help=words("option-to"))
    parser.add_argument("-w", "--write", action="store_true", help=words("option-write"))


def _add_nothing(parser: argparse._ArgumentGroup, words: Tells) -> None:
    """The command takes the common options only."""


def _add_world(parser: argparse._ArgumentGroup, words: Tells) -> None:
    parser.add_argument("name", nargs="?", metavar="NAME", help=words("option-world"))
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--map", action="store_true", help=words("option-map"))
    form.add_argument("--report", action="store_true", help=words("option-report"))
    form.add_argument("--json", action="store_true", help=words("option-json"))
    form.add_argument("--svg", metavar="FILE", help=words("option-svg"))
    form.add_argument("--brf", metavar="FILE", help=words("option-brf"))


def _add_replay(parser: argparse._ArgumentGroup, words: Tells) -> None:
    parser.add_argument("file", metavar="FILE", help=words("option-recording"))
    parser.add_argument("--backwards", action="store_true", help=words("option-backwards"))
    parser.add_argument("--from", dest="start", type=int, metavar="N", help=words("option-from"))
    parser.add_argument("--step", action="store_true", help=words("option-step"))
    parser.add_argument("--map", action="store_true", help=words("option-replay-map"))
    parser.add_argument("--check", action="store_true", help=words("option-recheck"))


def _add_devices(parser: argparse._ArgumentGroup, words: Tells) -> None:
    parser.add_argument("port", nargs="*", metavar="PORT", help=words("option-ports"))


def _add_port(parser: argparse._ArgumentGroup, words: Tells) -> None:
    parser.add_argument("port", nargs="?", metavar="PORT", help=words("option-port"))


def _add_serve(parser: argparse._ArgumentGroup, words: Tells) -> None:
    parser.add_argument("--port", metavar="PORT", default="8000", help=words("option-serve-port"))


_ADD: dict[str, Callable[[argparse._ArgumentGroup, Tells], None]] = {
    "": _add_front_end,
    "run": _add_run,
    "replay": _add_replay,
    "devices": _add_devices,
    "stop": _add_port,
    "calibrate": _add_nothing,
    "serve": _add_serve,
    "check": _add_check,
    "format": _add_format,
    "worlds": _add_nothing,
    "world": _add_world,
    "doctor": _add_nothing,
}
