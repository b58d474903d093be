"""Options stand before or behind the command; the first word that is neither is the command or the file."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from donnie_tui.cli.arguments import COMMANDS, TO_COME, WrongUsage
from donnie_tui.cli.parsers import parser_of
from donnie_tui.cli.understanding import plainly, understand
from donnie_tui.i18n.words import Words
from donnie_tui.settings.chosen import BadOption


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


@pytest.mark.parametrize("command", TO_COME)
def test_a_reserved_command_is_known_whatever_follows_it(command: str) -> None:
    assert understand([command, "--anything", "x"], Words()).command == command


@pytest.mark.parametrize("line", ["run", "check", "format", "--foo", "run x --foo", "a.gd b.gd", "--lang"])
def test_what_can_not_be_understood_is_wrong_usage(line: str) -> None:
    with pytest.raises(WrongUsage):
        understand(line.split(), Words())


def test_what_is_no_number_is_told_with_its_option() -> None:
    with pytest.raises(WrongUsage) as wrong:
        understand(["replay", "a.rec", "--from", "x"], Words())

    assert (wrong.value.code, wrong.value.what) == ("usage-no-number", "--from")


def test_what_is_no_choice_is_told_with_its_option_and_what_can_be_chosen() -> None:
    with pytest.raises(BadOption) as bad:
        understand(["format", "a.gd", "--to", "fr"], Words())

    assert (bad.value.key, bad.value.value, bad.value.wanted) == ("to", "fr", "en, pt, es")


@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_help_names_every_command_with_what_it_is_for(
    language: str, capsys: pytest.CaptureFixture[str]
) -> None:
    words = Words(language)
    with pytest.raises(SystemExit):
        understand(["--help"], words)

    told = capsys.readouterr().out.splitlines()
    for command in (each for each in COMMANDS if each not in TO_COME):
        assert any(line.startswith(f"{command}: {words(f'usage-{command}')[:30]}") for line in told), command
    assert not any(line.startswith(TO_COME) for line in told)


@pytest.mark.parametrize("language", ["en", "pt", "es"])
@pytest.mark.parametrize("command", ["", *(each for each in COMMANDS if each not in TO_COME)])
def test_help_is_there_for_every_command_in_every_language(
    command: str, language: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as left:
        understand([*command.split(), "--help"], Words(language))

    assert left.value.code == 0
    assert "--lang" in capsys.readouterr().out


@pytest.mark.parametrize("line", ["-h", "-H", "-th", "--linear -mH"])
def test_help_is_told_where_its_letter_stands_among_others(
    line: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        understand(line.split(), Words())

    assert Words()("option-speech") in capsys.readouterr().out


_PIECES = (
    *("--linear", "-t", "-T", "--visual", "--plain", "-m", "-M", "-l", "-L", "-ml", "-f", "--", "-", "-1"),
    *("--world", "--world=", "--world=maze", "--speed", "max", "--lang", "--lan", "--events", "=", "a=b"),
    *("walk.gd", "run", "maze", "", "two words", "--odd", "--odd=1", "--=1", "--sound", "on"),
)


@given(st.lists(st.sampled_from(_PIECES), max_size=6))
def test_what_is_understood_without_argparse_is_what_argparse_understands(line: list[str]) -> None:
    plain = plainly(line)

    if plain is not None:
        assert vars(plain) == vars(parser_of("", lambda _code: "").parse_args(line))


@pytest.mark.parametrize(
    "line",
    ["", "walk.gd", "--linear --speech off --sound=on --world maze a.gd", "-t -m -l", "--visual --plain"],
)
def test_what_is_plain_needs_no_argparse(line: str) -> None:
    assert plainly(line.split()) is not None
