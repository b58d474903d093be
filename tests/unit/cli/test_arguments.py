"""Options stand before or after the command. The first other word is the command or the file."""

import re
from argparse import Namespace
from inspect import get_annotations
from pathlib import Path

import pytest

from donnie_tui.cli.main import handler_of
from donnie_tui.cli.options import COMMANDS, COMMON, SUBCOMMANDS, Invocation, WrongUsage, understand
from donnie_tui.i18n.words import Words
from donnie_tui.settings.settings import BadOption
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

    assert (wrong.value.code, wrong.value.what) == ("usage-no-number", "--from")


def test_an_unknown_value_is_reported_with_its_option_and_the_possible_values() -> None:
    with pytest.raises(BadOption) as bad:
        understand(["format", "a.gd", "--to", "fr"], Words())

    assert (bad.value.key, bad.value.value, bad.value.wanted) == ("to", "fr", "en, pt, es")


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
