"""The commands have words in three languages that never hide those of GoDonnie, and one handler each."""

import re

import pytest

from donnie_tui.commands.declarations import BY_NAME, COMMANDS, Command
from donnie_tui.commands.lookup import (
    MOST_WORDS,
    find,
    help_line,
    help_of,
    line_command,
    typed_form,
    word_of,
    words_of,
)
from donnie_tui.core.reports import asked
from donnie_tui.i18n.words import Words
from language import keywords
from language.locales import languages
from language.source import fold_name
from tests.tools.commands_page import entry
from tests.unit.i18n.sentences import CODES

WORDS = [
    (each, word) for each in COMMANDS for language in languages() for word in words_of(each.name, language)
]


def test_a_word_of_godonnie_is_a_command_only_if_it_means_the_same() -> None:
    others = [word for command, word in WORDS if not command.is_godonnie]

    assert [word for word in others if keywords.is_reserved(word.split()[0])] == []


@pytest.mark.parametrize(
    "command", [each for each in COMMANDS if each.is_godonnie], ids=lambda each: each.name
)
def test_a_command_of_godonnie_is_listed_by_the_word_of_godonnie(command: Command) -> None:
    assert all(keywords.is_reserved(words_of(command.name, each)[0]) for each in languages())


def test_no_key_runs_two_commands() -> None:
    keys = [key for each in COMMANDS for key in each.keys]

    assert [key for key in keys if keys.count(key) > 1] == []


def test_a_command_has_as_many_words_as_are_looked_at() -> None:
    assert max(len(word.split()) for _, word in WORDS) == MOST_WORDS


def test_no_word_means_two_things() -> None:
    meanings = {(fold_name(word), command.name) for command, word in WORDS}

    assert len({word for word, _ in meanings}) == len(meanings)


def test_a_word_is_found_in_every_case_and_without_accents() -> None:
    for command, word in WORDS:
        found = [find(each) for each in (f"  {word.lower()}  ", fold_name(word), word.upper())]

        assert found == [(command, "")] * 3, word


def test_the_text_after_a_word_is_its_argument() -> None:
    for command, word in WORDS:
        is_statement = command.is_godonnie and not command.argument
        is_backward = word == "BACK"  # BACK 3 is BW 3
        takes_no_number = is_statement or command.needs_name or is_backward

        assert find(f"{word.lower()}  3 ") == (None if takes_no_number else (command, "3")), word
        assert find(f"{word.lower()}  it ") == (None if is_statement else (command, "it")), word


@pytest.mark.parametrize("line", ["speed = 3", "LIST [2]", "where=1", "openx", "FW 3", "", "x" * 1000])
def test_a_name_in_the_learners_program_is_no_command(line: str) -> None:
    assert find(line) is None


@pytest.mark.parametrize("above", ["", "FW 1", "IF 1 == 1 THEN", "foo", "FWD 3"])
def test_each_command_may_be_a_line_of_the_program(above: str) -> None:
    """Also below a line with a mistake."""
    assert [word for _, word in WORDS if line_command(word, above) != find(word)] == []


@pytest.mark.parametrize(
    ("line", "above"),
    [
        ("map = 2", ""),
        ("map [2]", ""),
        ("SPEAK map", ""),
        ("map", "FW"),
        ("n", "VAR"),
        ("copy", "PROCEDURE"),
        ("last", "VAR last = 1\nSPEAK last +"),
        ("STEP 3", ""),
        ("MOVE 3", ""),
        ("BACK 2", ""),
        ("TURN 90", ""),
        ("QUIT FW 1", ""),
    ],
)
def test_a_line_that_is_godonnie_or_meant_for_the_robot_stays_in_the_program(line: str, above: str) -> None:
    assert line_command(line, above) is None


@pytest.mark.parametrize("line", ["MOVE 5 7 2", "GO TO 3", "CHANGE 3 FW 2", "SAVE LOG said.txt", "FIND wall"])
def test_an_argument_may_follow_on_a_line_of_the_program(line: str) -> None:
    assert line_command(line) == find(line)


def test_the_longer_of_two_words_with_the_same_beginning_counts() -> None:
    assert [find(line)[0].name for line in ("SAVE x", "save as x", "Save Log x")] == [
        "save",
        "save_as",
        "save_log",
    ]


@pytest.mark.parametrize("language", languages())
def test_the_help_of_each_fits_forty_characters(language: str) -> None:
    """A braille display of 40 cells shows the whole line."""
    lines = [help_line(each, Words(language)) for each in COMMANDS if not each.is_visual]

    assert [line for line in lines if len(line) > 40] == []


def test_every_command_has_its_purpose_and_every_argument_its_example() -> None:
    assert {f"action-{name}" for name in BY_NAME} <= set(CODES)
    assert {f"help-typed-{each.argument}" for each in COMMANDS if each.argument} <= set(CODES)


def test_a_visual_command_names_a_command_that_says_the_same() -> None:
    named = {each.in_words for each in COMMANDS if each.is_visual} - {""}

    assert not {each.in_words for each in COMMANDS if not each.is_visual} - {""}
    assert all(not BY_NAME[name].is_visual for name in named)


@pytest.mark.parametrize("language", languages())
def test_each_word_is_explained_with_its_form_and_an_example(language: str) -> None:
    words = Words(language)
    for command in (each for each in COMMANDS if not each.is_godonnie):
        word = word_of(command, language)
        what, form, *_, example = help_of(word, words)

        assert word in what
        assert word in form
        assert word in example
        assert ("," in form) == bool(command.argument and not command.required), word


@pytest.mark.parametrize("language", languages())
def test_the_example_of_a_command_can_be_typed(language: str) -> None:
    typed = [(each, find(typed_form(each, Words(language)))) for each in COMMANDS]

    assert [command.name for command, found in typed if not found or found[0] is not command] == []


def test_a_command_without_a_key_is_listed_by_its_word() -> None:
    """Few keys are free. A command has a word and a row in the palette in any case."""
    words = Words("en")

    assert entry(Command("trail", "world"), words)[0].startswith("- **TRAIL**: ")
    assert help_line(Command("trail", "world"), words) == f"TRAIL: {words('action-trail')}"


def test_the_form_shows_required_and_optional_arguments() -> None:
    words = Words("en")

    assert help_of("move", words)[1:] == (
        "You write: MOVE line before or thing east north.",
        "Example: MOVE 5 2.",
    )
    assert help_of("LIST", words)[1] == "You write: LIST, or LIST first last."
    assert help_of("STEP", words)[1:] == ("You write: STEP.", "Example: STEP.")
    assert help_of("FW", words) == help_of("RUN", words) == ()


@pytest.mark.parametrize("language", languages())
def test_help_of_report_lists_the_possible_reports(language: str) -> None:
    """Each word of it is understood."""
    said = help_of("REPORT", Words(language))[2:4]

    subjects = [asked(f"{word} x") for line in said for word in re.findall(r"\w+", line)[1:]]
    assert sorted(found[0] for found in subjects if found) == [
        *("distances", "help", "list", "manual", "map", "paper", "run", "trail")
    ]
    assert max(map(len, said)) <= 40
