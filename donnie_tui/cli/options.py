"""The options of every command in one table, and the command line read by it.

The first word that is neither an option nor an option's value is the command, or else the program's file. A
common option may stand before or after the command.
"""

from __future__ import annotations

import argparse
import os
import re
from collections.abc import Iterator, Mapping
from enum import IntEnum
from typing import TYPE_CHECKING, NoReturn

from msgspec import Struct

from donnie_tui import __version__
from donnie_tui.cli.streams import Output
from donnie_tui.i18n.words import Words
from donnie_tui.settings.settings import BY_KEY, CONFINED, DEVICES, BadOption, Refusal, Settings, resolve
from language.locales import first_page, languages
from language.source import quoted

if TYPE_CHECKING:
    from donnie_tui.linear.greeting import Greeting


class ExitCode(IntEnum):
    """How a command ended."""

    DONE = 0
    FAILED = 1
    """The program had a mistake."""
    UNUSABLE = 2
    """Wrong usage, or a world, file or device that can't be used."""
    STOPPED = 130
    """By the user."""


ALLOW = "allow"
"""The one common option that may be given several times."""

COMMON = {
    "world": "NAME_OR_FILE",
    ALLOW: "FOLDER",
    "robot": "sim|serial|serial:PORT|double|player://HOST:PORT/INDEX",
    "profile": "auto|2016|2018",
    "camera": "NUMBER|DEVICE|FILE|FOLDER",
    "lang": "|".join(languages()),
    "speed": "N|max",
    "seed": "N",
    "speech": "auto|off|text|ssip|tts|robot",
    "sound": "on|off|wav:FILE",
    "verbosity": "brief|normal|full",
    "record": "FILE",
    "events": "FILE|-",
    "belt": "PORT",
    "confined": "FOLDER",
    "devices": "PORT,PORT",
}
"""The options of every command with the form of their values, which ``settings`` reads."""


class OptionSpec(Struct, frozen=True):
    """An option or argument of one command, in the terms of argparse."""

    names: tuple[str, ...]
    help: str
    """The code of its sentence."""
    metavar: str | None = None
    """None: the option is a switch."""
    dest: str | None = None
    nargs: str | None = None
    default: str | None = None
    type: type[int] | None = None
    choices: tuple[str, ...] | None = None
    group: str = ""
    """Options of one group exclude each other."""


_FILE = OptionSpec(("file",), "option-file", "FILE", nargs="?")
_FILES = OptionSpec(("file",), "option-file-or-input", "FILE", nargs="+")
_PORT = OptionSpec(("port",), "option-port", "PORT", nargs="?")
_MODES = (
    OptionSpec(("--linear", "--screen-reader", "-t", "-T"), "option-linear", group="mode"),
    OptionSpec(("--visual",), "option-visual", group="mode"),
    OptionSpec(("--plain",), "option-plain"),
)


class Subcommand(Struct, frozen=True):
    """A command of ``donnie``, or the program itself."""

    handler: str
    """A module of this package and its function, which takes an ``Order`` and returns the exit code."""
    options: tuple[OptionSpec, ...]


def _command(handler: str, *options: OptionSpec) -> Subcommand:
    return Subcommand(handler, options)


SUBCOMMANDS: dict[str, Subcommand] = {
    "": _command(
        "front_end.start",
        _FILE,
        *_MODES,
        OptionSpec(("-f", "-F"), "option-f", "FILE", dest="run"),
        OptionSpec(("-m", "-M"), "option-m", dest="mute"),
        OptionSpec(("-l", "-L"), "option-l", dest="log"),
    ),
    "run": _command(
        "run.run",
        _FILES,
        OptionSpec(("--trace",), "option-trace"),
        OptionSpec(("--challenge",), "option-challenge", "NAME"),
    ),
    "check": _command("programs.check", _FILES),
    "challenge": _command(
        "programs.challenge",
        OptionSpec(("what",), "option-challenge-what", "NAME", nargs="*"),
        *_MODES,
        OptionSpec(("--json",), "option-challenge-json"),
        OptionSpec(("--csv",), "option-csv", "FILE"),
        OptionSpec(("--feedback",), "option-feedback", "FOLDER"),
    ),
    "format": _command(
        "programs.format_files",
        _FILES,
        OptionSpec(("--to",), "option-to", f"{{{','.join(languages())}}}", choices=languages()),
        OptionSpec(("-w", "--write"), "option-write"),
    ),
    "worlds": _command("world.list_worlds"),
    "world": _command(
        "world.describe_world",
        OptionSpec(("name",), "option-world-name", "NAME", nargs="*"),
        OptionSpec(("--from",), "option-drawing", "DRAWING", dest="drawing", group="form"),
        OptionSpec(("--map",), "option-map", group="form"),
        OptionSpec(("--report",), "option-report", group="form"),
        OptionSpec(("--json",), "option-json", group="form"),
        OptionSpec(("--svg",), "option-svg", "FILE", group="form"),
        OptionSpec(("--brf",), "option-brf", "FILE", group="form"),
    ),
    "replay": _command(
        "replay.replay",
        OptionSpec(("file",), "option-recording", "FILE"),
        OptionSpec(("--backwards",), "option-backwards"),
        OptionSpec(("--from",), "option-from", "N", dest="start", type=int),
        OptionSpec(("--step",), "option-step"),
        OptionSpec(("--map",), "option-replay-map"),
        OptionSpec(("--check",), "option-recheck"),
        OptionSpec(("--challenge",), "option-replay-challenge", "NAME"),
        OptionSpec(("--svg",), "option-replay-svg", "FILE"),
        OptionSpec(("--png",), "option-replay-png", "FILE"),
        OptionSpec(("--gif",), "option-replay-gif", "FILE"),
        OptionSpec(("--swell",), "option-replay-swell", "FILE"),
        OptionSpec(("--csv",), "option-replay-csv", "FILE"),
        OptionSpec(("--report",), "option-replay-report", "WORDS"),
    ),
    "doctor": _command("doctor.doctor"),
    "devices": _command("devices.list_devices", OptionSpec(("port",), "option-ports", "PORT", nargs="*")),
    "stop": _command("devices.stop", _PORT, OptionSpec(("--wait",), "option-wait")),
    "calibrate": _command(
        "calibrate.calibrate", OptionSpec(("what",), "option-calibrate", "colour", nargs="?")
    ),
    "serve": _command(
        "front_end.serve",
        OptionSpec(("--port",), "option-serve-port", "N", default="8000"),
        OptionSpec(("--listen",), "option-listen", "ADDRESS"),
        OptionSpec(("--sessions",), "option-sessions", "N", default="8"),
        OptionSpec(("--idle",), "option-idle", "N", default="60"),
    ),
    "player": _command(
        "front_end.serve_clients",
        OptionSpec(("file",), "option-player-file", "FILE.cfg"),
        OptionSpec(("--port",), "option-player-port", "N", default="6665"),
        OptionSpec(("--host",), "option-player-host", "ADDRESS", default="127.0.0.1"),
        *_MODES,
    ),
}
"""Each command; the program itself stands under the empty name."""

RUN_ORIGINAL = "run.run_original"
"""The handler of the program itself with ``-f``."""

COMMANDS = tuple(name for name in SUBCOMMANDS if name)
CHALLENGE_ORDERS = ("check", "test", "new")
"""The words after ``donnie challenge`` that are no name of a challenge; a name starts a session."""


class WrongUsage(Refusal):
    """A command line that can't be understood."""


class Invocation(Struct, frozen=True):
    """A parsed command line."""

    command: str
    """Empty for the program itself."""
    options: dict[str, str]
    """The common options that were given, by key."""
    arguments: argparse.Namespace


_RECORDING = ("", "run", "replay", "player", "serve")
"""The commands that write a recording, events or cues; the others write none though a setting asks for it."""


class Order(Struct, frozen=True):
    """A command with everything that it needs."""

    invocation: Invocation
    settings: Settings
    words: Words
    output: Output
    environment: Mapping[str, str]
    greeting: Greeting | None = None
    """What the linear mode has printed already."""

    @property
    def outputs(self) -> tuple[tuple[str, str], ...]:
        """The options that name a file to be written, and the files."""
        written = _written_as_it_happens(self.settings) if self.invocation.command in _RECORDING else ()
        return (*written, *_pages(self.invocation))


def _written_as_it_happens(settings: Settings) -> Iterator[tuple[str, str]]:
    if settings.record is not None:
        yield "--record", settings.record
    if settings.events not in (None, "-"):
        yield "--events", str(settings.events)
    if isinstance(settings.sound, str):
        yield "--sound", settings.sound


def _pages(invocation: Invocation) -> Iterator[tuple[str, str]]:
    """The output files of ``donnie world`` and ``donnie replay``."""
    for option in ("svg", "brf", "png", "gif", "swell", "csv"):
        name = getattr(invocation.arguments, option, None)
        if name:
            yield f"--{option}", name
    if isinstance(typed := getattr(invocation.arguments, "report", None), str):
        from donnie_tui.core.reports import asked  # slow to load, and few commands report

        if (found := asked(typed)) and found[1]:
            yield "--report", found[1]


# --- reading a command line ----------------------------------------------------------------------------


def understand(arguments: list[str], words: Words) -> Invocation:
    """Parse the command and its options. For help or the version, prints it and exits.

    Raises ``WrongUsage`` or ``BadOption``.
    """
    first = _first_word(arguments)
    typed = arguments[first] if first is not None else ""
    command = typed if typed in COMMANDS else ""
    rest = arguments[:first] + arguments[first + 1 :] if command and first is not None else arguments
    _refuse_second_limit(rest)
    try:
        parsed = _parsed(command, rest, words)
        _refuse_empty(command, parsed)
        if command == "challenge" and len(parsed.what) == 1 and parsed.what[0] not in CHALLENGE_ORDERS:
            (name,) = parsed.what
            rest.remove(name)
            command, typed, rest = "", "", [*rest, "--world", f"challenge:{name}"]
            parsed = _parsed("", rest, words)
    except WrongUsage:
        if not command:
            _refuse_misspelt(typed)
        raise
    if not command:
        _refuse_misspelt(typed)
    options = {key: getattr(parsed, key) for key in COMMON if getattr(parsed, key) is not None}
    if ALLOW in options:
        options[ALLOW] = os.pathsep.join(options[ALLOW])
    return Invocation(command, options, parsed)


def _parsed(command: str, arguments: list[str], words: Words) -> argparse.Namespace:
    """Options may stand between the words; not where help is printed or after ``--``, which argparse would
    spoil."""
    parser = parser_of(command, words)
    if any(each in arguments for each in (*_HELP, "--")):
        return parser.parse_args(arguments)
    parser.usage = ""  # argparse would make it from sentences, which takes time, and nothing prints it
    return parser.parse_intermixed_args(arguments)


def _refuse_second_limit(arguments: list[str]) -> None:
    """Raises ``WrongUsage`` if a second value would replace the teacher's."""
    for each in (CONFINED.option, DEVICES.option):
        if sum(given == each or given.startswith(f"{each}=") for given in arguments) > 1:
            raise WrongUsage("usage-twice", what=each)


def _refuse_empty(command: str, parsed: argparse.Namespace) -> None:
    """Raises ``WrongUsage`` for an empty value, which a shell gives for a variable that is not set."""
    own = {each.dest or each.names[0].lstrip("-"): each for each in SUBCOMMANDS[command].options}
    for name, value in vars(parsed).items():
        if value != "" and not (isinstance(value, list) and "" in value):
            continue
        if name not in own:
            raise WrongUsage("usage-without-value", what=BY_KEY[name].option)
        option = own[name].names[0]
        if option.startswith("-"):
            raise WrongUsage("usage-without-value", what=option)
        raise WrongUsage("usage-missing", what=own[name].metavar or option)


def _refuse_misspelt(typed: str) -> None:
    """Raises ``WrongUsage`` for a word that is no file but nearly a command."""
    if not typed or os.path.lexists(typed):
        return
    from language.suggestions import edit_distance, nearest

    one_letter = (
        each for each in COMMANDS if each[0] == typed[0].lower() and edit_distance(typed, each) == 1
    )
    near = nearest(typed, COMMANDS, COMMANDS) or next(one_letter, None)  # "rn" is too short to be near "run"
    if near is not None:
        raise WrongUsage("usage-near-command", what=typed, near=near)


def _first_word(arguments: list[str]) -> int | None:
    """The place of the command, or of the program's file, among the options; None without either."""
    skip = False
    for index, each in enumerate(arguments):
        if skip:
            skip = False
        elif each == "--" or each.lower() == "-f":
            return None
        elif each.startswith("--"):
            skip = any(each == BY_KEY[key].option for key in COMMON)
        elif not each.startswith("-") or each == "-":
            return index
    return None


def language_before_parsing(
    arguments: list[str], environment: Mapping[str, str], file: Mapping[str, object]
) -> str:
    """The language of help and complaints: the first that can be read of options, environment, settings."""
    for options in (_language_option(arguments), {}):
        try:
            return resolve(options, environment, file)[0].language
        except BadOption:
            continue
    return "en"


def _language_option(arguments: list[str]) -> dict[str, str]:
    for at, each in enumerate(arguments):
        key, _, value = each.partition("=")
        if key == "--lang":
            return {"lang": value or "".join(arguments[at + 1 : at + 2])}
    return {}


# --- argparse --------------------------------------------------------------------------------------------

_PROBLEMS = (
    (r"the following arguments are required: (.*)", "usage-missing"),
    (r"unrecognized arguments: (.*)", "usage-unrecognized"),
    (r"argument ([^:]*): expected .*", "usage-without-value"),
    (r"argument ([^:]*): invalid int .*", "usage-no-number"),
    (r"argument ([^:]*): not allowed with argument ([^/]*).*", "usage-not-together"),
)
"""The errors of argparse, each with the code of its sentence."""

_HELP = ("-h", "-H", "--help")


class _Parser(argparse.ArgumentParser):
    """A parser whose errors and help are codes; they become sentences only when printed."""

    def __init__(self, command: str, sentence: Words) -> None:
        super().__init__(
            prog=f"donnie {command}".strip(),
            formatter_class=_formatter(sentence),
            add_help=False,
            allow_abbrev=False,
        )
        self._command, self._sentence = command, sentence

    def format_help(self) -> str:
        sentence = self._sentence
        if self.description is None:
            self.description = sentence(f"usage-{self._command or 'donnie'}")
            self.epilog = None if self._command else _all_commands(sentence)
            for group in self._action_groups[2:]:  # the first two are argparse's own, and empty
                group.title = sentence(str(group.title))
            for action in self._actions:
                action.help = sentence(str(action.help))
        return super().format_help()

    def error(self, message: str) -> NoReturn:
        choice = re.fullmatch(r"argument --([^:]*): invalid choice: (.*) \(choose from (.*)\)", message)
        if choice:
            raise BadOption(
                "bad-option",
                option=f"--{choice[1]}",
                value=quoted(choice[2].strip("'\"")),
                wanted=choice[3].replace("'", ""),
            )
        for pattern, code in _PROBLEMS:
            found = re.fullmatch(pattern, message)
            if found:
                if code == "usage-unrecognized":
                    self._refuse_misspelt(re.split(r"[ =]", found[1], maxsplit=1)[0])
                raise WrongUsage(code, what=quoted(", ".join(found.groups())))
        raise WrongUsage("usage-unrecognized", what=quoted(message))

    def _refuse_misspelt(self, option: str) -> None:
        """Raises ``WrongUsage`` if the word is nearly an option."""
        from language.suggestions import nearest

        options = [each for action in self._actions for each in action.option_strings if each[:2] == "--"]
        near = nearest(option, options) if option[:2] == "--" else None
        if near is not None:
            raise WrongUsage("usage-near-option", what=option, near=near)


def _formatter(sentence: Words) -> type[argparse.HelpFormatter]:
    """Help that begins with the word for "usage" in the learner's language and keeps the lines of a text."""

    class Formatter(argparse.HelpFormatter):
        def add_usage(self, usage, actions, groups, prefix=None):  # type: ignore[no-untyped-def] # argparse's own
            super().add_usage(usage, actions, groups, prefix or f"{sentence('usage-prefix')} ")

        def _fill_text(self, text: str, width: int, indent: str) -> str:
            return "\n".join(
                each if each.endswith(".md") else super(Formatter, self)._fill_text(each, width, indent)
                for each in text.split("\n")
            )

    return Formatter


def parser_of(command: str, sentence: Words) -> argparse.ArgumentParser:
    """The parser of a command, or of the program itself for the empty name."""
    parser = _Parser(command, sentence)
    arguments = parser.add_argument_group("usage-arguments")
    groups: dict[str, argparse._MutuallyExclusiveGroup] = {}
    for each in SUBCOMMANDS[command].options:
        if each.group and each.group not in groups:
            groups[each.group] = arguments.add_mutually_exclusive_group()
        _add(groups[each.group] if each.group else arguments, each)
    if not command:
        arguments.add_argument("--version", action="version", version=__version__, help="option-version")
    common = parser.add_argument_group("usage-options")
    for key, metavar in COMMON.items():
        action = "append" if key == ALLOW else "store"
        common.add_argument(BY_KEY[key].option, metavar=metavar, action=action, help=f"option-{key}")
    common.add_argument(*_HELP, action="help", help="option-help")
    return parser


def _add(parser: argparse._ActionsContainer, option: OptionSpec) -> None:
    given: dict[str, object] = {
        name: getattr(option, name)
        for name in ("metavar", "dest", "nargs", "default", "type", "choices")
        if getattr(option, name) is not None
    }
    if option.metavar is None:
        given["action"] = "store_true"
    parser.add_argument(*option.names, help=option.help, **given)  # type: ignore[arg-type] # as named


def _all_commands(sentence: Words) -> str:
    """The list of commands, a line each, with what it is for; then the document for beginners."""
    lines = [f"{each}: {sentence(f'usage-{each}')}" for each in COMMANDS]
    page = first_page(sentence.language)
    document = (sentence("first-page", file=page),) if page else ()
    return "\n".join((sentence("usage-commands"), *lines, *document))
