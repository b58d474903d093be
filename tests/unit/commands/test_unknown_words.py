"""A misspelt command is answered with the nearest command. The learner's names stay usable."""

import pytest

from donnie_tui.commands.lookup import LARGEST_PROGRAM, Unknown, find, unknown_word
from language.parser import parse


def meant(line: str, *lines: str, language: str = "en") -> str | None:
    unknown = unknown_word(line, lines, language, parse)
    return unknown.meant if unknown else None


@pytest.mark.parametrize(
    ("line", "language", "word"),
    [
        ("LISTT", "en", "LIST"),
        ("listt 2 5", "en", "LIST"),
        ("AJUSTES", "es", "AJUSTAR"),
        ("stpe back", "en", "STEP BACK"),
        ("AO REDR", "pt", "AO REDOR"),
        ("WHRE", "en", "WHERE"),
        ("QIUT", "en", "QUIT"),
        ("RUNN", "en", "RUN"),
        ("HLEP", "en", "HELP"),
        ("HLEP FW", "en", None),
        ("SAIRR", "pt", "SAIR"),
        ("SUBMIT", "en", None),
        ("CAMINAR 3", "es", None),
        ("ANDAR 3", "pt", None),
    ],
)
def test_the_nearest_word_of_the_language_is_found(line: str, language: str, word: str | None) -> None:
    assert meant(line, language=language) == word


@pytest.mark.parametrize(
    "line", ["MOVE FORWARD 3", "move back 2", "GO FORWARD", "MOVER PARA FRENTE 3", "MOVER ADELANTE 3"]
)
def test_what_beginners_say_is_no_command(line: str) -> None:
    assert find(line) is None


def test_the_command_move_takes_lines() -> None:
    found = find("MOVE 5 2")
    assert found is not None
    assert (found[0].name, found[1]) == ("move", "5 2")


def test_an_unknown_word_is_reported_as_it_was_typed() -> None:
    assert unknown_word("listt 2", (), "en", parse) == Unknown("listt", "LIST")


def test_the_nearest_word_is_found_after_other_lines_and_within_a_block() -> None:
    assert meant("LISTT", "FW 2", "REPEAT 2 TIMES") == "LIST"


@pytest.mark.parametrize(
    "line", ["SPEK 3", "FWW 3", "listt = 3", "listt [2]", "", "7", "LIS7", "L1ST 2", "bananas", "x" * 99]
)
def test_a_line_that_may_be_godonnie_is_left_alone(line: str) -> None:
    assert meant(line) is None


def test_a_name_of_the_learners_program_is_left_alone() -> None:
    assert meant("Listt", "PROCEDURE listt: DO FW 1 END PROCEDURE") is None


def test_an_unknown_word_after_a_command_is_its_value() -> None:
    assert meant("listt", "FW") is None


def test_a_huge_program_is_not_searched() -> None:
    assert meant("LISTT", "x" * LARGEST_PROGRAM) is None
    comment = "-- ".ljust(LARGEST_PROGRAM - len("LISTT"), "x")
    assert meant("LISTT", comment) == "LIST"
    assert meant("LISTT", f"{comment}x") is None


@pytest.mark.parametrize(
    ("word", "name"),
    [
        ("NEAR", "around"),
        ("PERTO", "around"),
        ("CERCA", "around"),
        ("CONFIGURAR", "set"),
        ("EDIT 2", "change"),
        ("ELIMINAR 2", "delete"),
        ("CARREGAR a.gd", "open"),
    ],
)
def test_common_synonyms_mean_the_same(word: str, name: str) -> None:
    found = find(word)

    assert found is not None
    assert found[0].name == name
