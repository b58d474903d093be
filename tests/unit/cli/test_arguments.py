"""Options stand before or after the command. The first other word is the command or the file."""

import os
import re
from argparse import Namespace
from inspect import get_annotations
from pathlib import Path

import pytest

from donnie_tui.cli.main import handler_of
from donnie_tui.cli.options import (
    COMMANDS,
    COMMON,
    SUBCOMMANDS,
    ExitCode,
    Invocation,
    Order,
    WrongUsage,
    language_before_parsing,
    parser_of,
    understand,
)
from donnie_tui.cli.streams import Output
from donnie_tui.i18n.words import Words
from donnie_tui.settings.settings import BadOption, resolve
from tests.conftest import ROOT


@pytest.mark.parametrize(
    ("line", "command", "options", "file"),
    [
        ("", "", {}, None),
        ("walk.gd", "", {}, "walk.gd"),
        ("./run", "", {}, "./run"),
        ("--lang pt walk.gd", "", {"lang": "pt"}, "walk.gd"),
        ("--lang=pt", "", {"lang": "pt"}, None),
        ("run walk.gd", "run", {}, ["walk.gd"]),
        ("--speed max run walk.gd --lang es", "run", {"speed": "max", "lang": "es"}, ["walk.gd"]),
        ("--world run walk.gd", "", {"world": "run"}, "walk.gd"),
        ("run -", "run", {}, ["-"]),
        ("run - --events -", "run", {"events": "-"}, ["-"]),
        ("check a.gd b.gd", "check", {}, ["a.gd", "b.gd"]),
        ("run -- --odd.gd", "run", {}, ["--odd.gd"]),
        ("check a.gd --lang pt b.gd", "check", {"lang": "pt"}, ["a.gd", "b.gd"]),
        ("run a=a.gd --trace b=b.gd", "run", {}, ["a=a.gd", "b=b.gd"]),
    ],
)
def test_a_command_line_is_understood(
    line: str, command: str, options: dict[str, str], file: str | list[str] | None
) -> None:
    found = understand(line.split(), Words())

    assert (found.command, found.options, found.arguments.file) == (command, options, file)


@pytest.mark.parametrize("flag", ["-t", "-T", "--linear"])
def test_the_flag_for_the_terminal_is_the_linear_mode(flag: str) -> None:
    assert understand([flag], Words()).arguments.linear


@pytest.mark.parametrize("line", [["-f", "run"], ["-F", "run"], ["-m", "-f", "run", "-l"]])
def test_the_original_flag_runs_whatever_file_it_names(line: list[str]) -> None:
    found = understand(line, Words())

    assert (found.command, found.arguments.run) == ("", "run")


@pytest.mark.parametrize("line", ["run", "check", "format", "--foo", "run x --foo", "a.gd b.gd", "--lang"])
def test_a_line_that_can_not_be_understood_is_wrong_usage(line: str) -> None:
    with pytest.raises(WrongUsage):
        understand(line.split(), Words())


def test_a_value_that_is_no_number_is_reported_with_its_option() -> None:
    with pytest.raises(WrongUsage) as wrong:
        understand(["replay", "a.rec", "--from", "x"], Words())

    assert (wrong.value.code, wrong.value.values) == ("usage-no-number", {"what": "--from"})


def test_an_unknown_value_is_reported_with_its_option_and_the_possible_values() -> None:
    with pytest.raises(BadOption) as bad:
        understand(["format", "a.gd", "--to", "fr"], Words())

    assert bad.value.values == {"option": "--to", "value": "fr", "wanted": "en, pt, es"}


def test_each_command_has_a_function_of_its_own() -> None:
    found = [handler_of(Invocation(each, {}, Namespace(run=None))) for each in ("", *COMMANDS)]

    assert len({*found}) == len(SUBCOMMANDS)
    for each in found:
        assert get_annotations(each).items() >= {"order": "Order", "return": "int"}.items(), each


def test_the_original_option_runs_a_program_without_a_front_end() -> None:
    run = handler_of(understand(["-f", "a.gd"], Words()))

    assert run is not handler_of(understand(["a.gd"], Words()))
    assert run.__module__ == "donnie_tui.cli.run"


@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_help_names_every_command_with_its_purpose(language: str, capsys: pytest.CaptureFixture[str]) -> None:
    words = Words(language)
    with pytest.raises(SystemExit):
        understand(["--help"], words)

    said = capsys.readouterr().out.splitlines()
    for command in COMMANDS:
        assert any(line.startswith(f"{command}: {words(f'usage-{command}')[:30]}") for line in said), command


@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_help_ends_with_the_document_for_beginners_in_the_language(
    language: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        understand(["--help"], Words(language))

    named = Path(capsys.readouterr().out.splitlines()[-1].partition(": ")[2])
    assert named == ROOT / "docs" / language / "README.md"
    assert named.is_file()


@pytest.mark.parametrize("language", ["en", "pt", "es"])
@pytest.mark.parametrize("command", ["", *COMMANDS])
def test_help_is_there_for_every_command_in_every_language(
    command: str, language: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as left:
        understand([*command.split(), "--help"], Words(language))

    assert left.value.code == 0
    assert "--lang" in capsys.readouterr().out


@pytest.mark.parametrize("line", ["-h", "-H", "-th", "--linear -mH"])
def test_help_is_printed_where_its_letter_stands_among_others(
    line: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        understand(line.split(), Words())

    assert Words()("option-speech") in capsys.readouterr().out


@pytest.mark.parametrize("language", ["pt", "es"])
@pytest.mark.parametrize("command", ["", *COMMANDS])
def test_no_line_of_a_translated_help_is_english(
    command: str, language: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        understand([*command.split(), "--help"], Words("en"))
    english = sentences_in(capsys.readouterr().out)
    with pytest.raises(SystemExit):
        understand([*command.split(), "--help"], Words(language))

    assert not english & sentences_in(capsys.readouterr().out)


def sentences_in(text: str) -> set[str]:
    """The lines of a help with words of a language: at least two of four letters.

    No form of a value, no line of names of one option, and none of the usage, which begins with one in
    brackets.
    """
    lines = (" ".join(line.split()) for line in text.splitlines())
    return {
        line
        for line in lines
        if len(re.findall(r"\b[^\W\d_A-Z]{4,}\b", line)) > 1 and not re.search(r"\||^\[--|^-[-\w, ]+$", line)
    }


@pytest.mark.parametrize("language", ["pt", "es"])
@pytest.mark.parametrize("command", COMMANDS)
def test_the_frame_of_a_translated_help_is_translated(
    command: str, language: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """The words around the sentences, which argparse would print in English."""
    with pytest.raises(SystemExit):
        understand([command, "--help"], Words(language))
    first, *others = capsys.readouterr().out.splitlines()

    assert first.startswith(f"{Words(language)('usage-prefix')} donnie")
    assert f"{Words(language)('usage-options')}:" in others
    frame = [Words("en")(code) for code in ("usage-prefix", "usage-options", "usage-arguments")]
    assert [line for line in (first, *others) if line.startswith(tuple(frame))] == []


def test_the_common_options_are_described_with_the_forms_of_their_values() -> None:
    """The first column of the tables has ``--robot sim``, ``serial`` ... in the order of the help."""
    page = (ROOT / "docs" / "command-line.md").read_text(encoding="utf-8")
    rows = [line.split("|")[1].strip() for line in page.splitlines() if line.startswith("| `--")]
    for name, form in COMMON.items():
        row = next(each for each in rows if each.startswith((f"`--{name}`", f"`--{name} ")))
        documented = set(re.findall(r"[\w:/.-]+", row.replace(f"--{name}", ""))) | {"-"}

        for value in (each for each in form.replace(",", "|").split("|") if each.islower()):
            assert value in documented, (name, value, row)


USAGE = {
    "": "[--linear | --visual] [--plain] [-f FILE] [-m] [-l] [--version] [FILE]",
    "run": "[--trace] [--challenge NAME] FILE [FILE ...]",
    "check": "FILE [FILE ...]",
    "challenge": "[--linear | --visual] [--plain] [--json] [--csv FILE] [--feedback FOLDER] [NAME ...]",
    "format": "[--to {en,pt,es}] [-w] FILE [FILE ...]",
    "worlds": "",
    "world": "[--from DRAWING | --map | --report | --json | --svg FILE | --brf FILE] [NAME ...]",
    "replay": (
        "[--backwards] [--from N] [--step] [--map] [--check] [--challenge NAME]"
        " [--svg FILE] [--png FILE] [--gif FILE] [--swell FILE] [--csv FILE] [--report WORDS] FILE"
    ),
    "doctor": "",
    "devices": "[PORT ...]",
    "stop": "[--wait] [PORT]",
    "calibrate": "[colour]",
    "serve": "[--port N] [--listen ADDRESS] [--sessions N] [--idle N]",
    "player": "[--port N] [--host ADDRESS] [--linear | --visual] [--plain] FILE.cfg",
}
"""As docs/command-line.md has them."""
OF_ALL = (
    "[--world NAME_OR_FILE] [--allow FOLDER]"
    " [--robot sim|serial|serial:PORT|double|player://HOST:PORT/INDEX] [--profile auto|2016|2018]"
    " [--camera NUMBER|DEVICE|FILE|FOLDER] [--lang en|pt|es] [--speed N|max] [--seed N]"
    " [--speech auto|off|text|ssip|tts|robot] [--sound on|off|wav:FILE] [--verbosity brief|normal|full]"
    " [--record FILE] [--events FILE|-] [--belt PORT] [--confined FOLDER] [--devices PORT,PORT] [-h]"
)


@pytest.mark.parametrize("command", ["", *COMMANDS])
def test_each_command_has_its_options_and_those_of_all(command: str) -> None:
    usage = " ".join(parser_of(command, Words()).format_usage().split())

    assert f" {OF_ALL}" in usage
    assert (
        usage.replace(f" {OF_ALL}", "")
        == f"usage: donnie {command} {USAGE[command]}".replace("  ", " ").strip()
    )


@pytest.mark.parametrize(
    ("line", "given"),
    [
        ("--screen-reader", {"linear": True, "visual": False, "plain": False, "run": None, "log": False}),
        ("--visual --plain", {"linear": False, "visual": True, "plain": True}),
        ("-L -M -F a.gd", {"log": True, "mute": True, "run": "a.gd"}),
        ("run --trace a b --challenge c", {"trace": True, "file": ["a", "b"], "challenge": "c"}),
        ("format --write --to es a", {"write": True, "to": "es", "file": ["a"]}),
        ("format -w a", {"write": True, "to": None}),
        ("challenge check c a --json --csv t --feedback f", {"json": True, "csv": "t", "feedback": "f"}),
        ("challenge", {"what": [], "json": False}),
        ("challenge new c", {"what": ["new", "c"]}),
        ("world new w --from d", {"name": ["new", "w"], "drawing": "d"}),
        ("world new --from d w", {"name": ["new", "w"], "drawing": "d"}),
        ("challenge check a --json b", {"what": ["check", "a", "b"], "json": True}),
        ("world w --brf p", {"brf": "p", "svg": None, "map": False, "report": False, "json": False}),
        ("replay r --from 3 --step --check", {"file": "r", "start": 3, "step": True, "check": True}),
        ("replay r --map --backwards", {"map": True, "backwards": True, "start": None}),
        ("replay r --svg a --png b --gif c --swell d", {"svg": "a", "png": "b", "gif": "c", "swell": "d"}),
        ("devices a b", {"port": ["a", "b"]}),
        ("stop", {"port": None, "wait": False}),
        ("stop --wait p", {"port": "p", "wait": True}),
        ("calibrate colour", {"what": "colour"}),
        ("serve", {"port": "8000", "listen": None, "sessions": "8", "idle": "60"}),
        ("player f.cfg", {"file": "f.cfg", "port": "6665", "host": "127.0.0.1", "linear": False}),
    ],
)
def test_what_is_given_is_named(line: str, given: dict[str, object]) -> None:
    arguments = vars(understand(line.split(), Words()).arguments)
    assert {name: arguments[name] for name in given} == given


@pytest.mark.parametrize(
    ("line", "code", "what", "near"),
    [
        ("run", "usage-missing", "FILE", ""),
        ("--foo", "usage-unrecognized", "--foo", ""),
        ("--lang", "usage-without-value", "--lang", ""),
        ("--linear --visual", "usage-not-together", "--visual, --linear", ""),
        ("world a --map --json", "usage-not-together", "--json, --map", ""),
        ("--confined a --confined=b", "usage-twice", "--confined", ""),
        ("--devices=a --devices b", "usage-twice", "--devices", ""),
        ("chek a.gd", "usage-near-command", "chek", "check"),
        ("rn", "usage-near-command", "rn", "run"),
        ("Run", "usage-near-command", "Run", "run"),
        ("replya --foo", "usage-near-command", "replya", "replay"),
        ("xn --foo", "usage-unrecognized", "--foo", ""),
        ("--spech off", "usage-near-option", "--spech", "--speech"),
        ("run a.gd --lagn=pt b", "usage-near-option", "--lagn", "--lang"),
        ("-x", "usage-unrecognized", "-x", ""),
        (f"--{'x' * 50}", "usage-unrecognized", f"--{'x' * 37}…", ""),
    ],
)
def test_a_wrong_line_is_reported_with_what_is_wrong(line: str, code: str, what: str, near: str) -> None:
    with pytest.raises(WrongUsage) as wrong:
        understand(line.split(), Words())

    values = {"what": what, "near": near} if near else {"what": what}
    assert (wrong.value.code, wrong.value.values) == (code, values)


def test_an_empty_argument_too_many_is_no_option() -> None:
    with pytest.raises(WrongUsage) as wrong:
        understand(["doctor", ""], Words())

    assert (wrong.value.code, wrong.value.values) == ("usage-unrecognized", {"what": ""})


@pytest.mark.parametrize(
    ("arguments", "code", "what"),
    [
        ([""], "usage-missing", "FILE"),
        (["run", "a.gd", ""], "usage-missing", "FILE"),
        (["challenge", ""], "usage-missing", "NAME"),
        (["calibrate", ""], "usage-missing", "colour"),
        (["-f", ""], "usage-without-value", "-f"),
        (["--world=", "a.gd"], "usage-without-value", "--world"),
        (["--allow", "a", "--allow", ""], "usage-without-value", "--allow"),
        (["world", "a", "--from", ""], "usage-without-value", "--from"),
        (["replay", "a", "--svg", ""], "usage-without-value", "--svg"),
    ],
)
def test_an_empty_value_as_of_a_variable_that_is_not_set_is_missing(
    arguments: list[str], code: str, what: str
) -> None:
    with pytest.raises(WrongUsage) as wrong:
        understand(arguments, Words())

    assert (wrong.value.code, wrong.value.values) == (code, {"what": what})


def test_a_file_that_is_nearly_called_as_a_command_is_opened(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("chek").touch()
    assert understand(["chek"], Words()).arguments.file == "chek"


def test_a_challenge_by_its_name_is_a_session_and_folders_may_be_several() -> None:
    found = understand(["--allow", "a", "challenge", "corner", "--allow=b", "--linear"], Words())

    assert (found.command, found.arguments.linear) == ("", True)
    assert found.options == {"world": "challenge:corner", "allow": os.pathsep.join("ab")}


@pytest.mark.parametrize(
    ("arguments", "environment", "file", "language"),
    [
        (["--lang", "pt"], {"DONNIE_LANG": "es"}, {}, "pt"),
        (["run", "--lang=pt"], {}, {"lang": "es"}, "pt"),
        (["--lang", "xx"], {"DONNIE_LANG": "es"}, {}, "es"),
        (["--lang"], {}, {"lang": "pt"}, "pt"),
        (["--language", "pt"], {}, {}, "en"),
        ([], {"LANG": "es_ES"}, {}, "es"),
    ],
)
def test_the_language_of_complaints_is_the_first_that_can_be_read(
    arguments: list[str], environment: dict[str, str], file: dict[str, object], language: str
) -> None:
    assert language_before_parsing(arguments, environment, file) == language


def test_the_files_that_a_command_writes_are_known_with_their_options() -> None:
    settings = resolve({"record": "r", "events": "e", "sound": "wav:s"}, {}, {})[0]
    replayed = understand(["replay", "x", "--svg", "a", "--png", "b", "--gif", "c", "--swell", "d"], Words())
    described = understand(["world", "x", "--brf", "a"], Words())
    output = Output()

    assert Order(replayed, settings, Words(), output, {}).outputs == (
        *(("--record", "r"), ("--events", "e"), ("--sound", "s")),
        *(("--svg", "a"), ("--png", "b"), ("--gif", "c"), ("--swell", "d")),
    )
    assert Order(described, settings, Words(), output, {}).outputs == (("--brf", "a"),)
    printed = resolve({"events": "-", "sound": "off"}, {}, {})[0]
    assert Order(replayed, printed, Words(), output, {}).outputs[0] == ("--svg", "a")


def test_the_codes_with_which_commands_end_are_those_of_the_page() -> None:
    """``130``, as of other programs after Ctrl+C."""
    assert {each.name: each.value for each in ExitCode} == {
        "DONE": 0,
        "FAILED": 1,
        "UNUSABLE": 2,
        "STOPPED": 130,
    }


@pytest.mark.parametrize(("report", "outputs"), [("run r.svg", (("--report", "r.svg"),)), ("run", ())])
def test_the_file_of_a_report_is_an_output(report: str, outputs: tuple[tuple[str, str], ...]) -> None:
    replayed = understand(["replay", "x", "--report", report], Words())

    assert Order(replayed, resolve({}, {}, {})[0], Words(), Output(), {}).outputs == outputs


def test_the_name_of_a_challenge_is_no_file() -> None:
    assert understand(["challenge", "corner"], Words()).arguments.file is None


@pytest.mark.parametrize("word", ["bun", "fun", "rain"])
def test_a_short_word_with_another_first_letter_is_a_file(word: str) -> None:
    assert understand([word], Words()).arguments.file == word


def test_after_two_dashes_a_word_is_a_file() -> None:
    found = understand(["--", "run"], Words())

    assert (found.command, found.arguments.file) == ("", "run")
