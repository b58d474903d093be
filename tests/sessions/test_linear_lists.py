"""Long lists in the linear mode begin with their length. The manual can be a page too."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.sessions.typed_lines import printed_by

pytestmark = pytest.mark.slow

DEEDS = [line for number in range(20) for line in (f"VAR v{number} = {number}", f"TR {number}")]
"""Twenty answers."""


@pytest.mark.parametrize(
    ("word", "count", "first"),
    [
        ("LIST", 40, "1: VAR v0 = 0"),
        ("TRAIL 19", 19, "TR 1: now facing 1 degree"),
        ("TYPED 30", 30, "11: VAR v5 = 5"),
        ("SHOW VARIABLES", 20, "v0 is 0."),
        ("SHOW LOG", 20, "I turned 0 degrees"),
        ("LAST", 20, "I turned 0 degrees"),
    ],
)
def test_a_long_list_begins_with_its_number(word: str, count: int, first: str, tmp_path: Path) -> None:
    """The number comes first, so that a listener knows the length."""
    said = printed_by(tmp_path, "en", [*DEEDS, "", word, "NEW"])

    assert said[22] == f"{count} lines."
    assert said[23].startswith(first)


def test_a_short_list_has_no_number(tmp_path: Path) -> None:
    assert "lines." not in " ".join(
        printed_by(tmp_path, "en", [*DEEDS, "", "TRAIL 18", "TYPED 9", "NEW"])[:-3]
    )


def test_many_mistakes_begin_with_the_number_of_their_lines(tmp_path: Path) -> None:
    said = printed_by(tmp_path, "en", [*["FWD 1"] * 7, "", "ERRORS"])

    assert said[said.index("21 lines.") + 1] == "Error, line 1, column 1: I do not know FWD."


@pytest.mark.parametrize(
    ("language", "typed", "heading"),
    [
        ("en", "REPORT manual m.html", "Moving"),
        ("pt", "RELATÓRIO manual m.html", "Andar"),
        ("es", "INFORME manual m.html", "Moverse"),
    ],
)
def test_the_manual_is_written_as_a_page_with_headings(
    language: str, typed: str, heading: str, tmp_path: Path
) -> None:
    """A page has headings that a screen reader finds."""
    printed_by(tmp_path, language, [typed])
    page = (tmp_path / "m.html").read_text("utf-8")

    assert f'<html lang="{language}">' in page
    assert f"<h2>{heading}</h2>" in page
    assert page.count("<h2>") == 9


@pytest.mark.parametrize(
    ("language", "typed", "everything"),
    [
        ("en", "HELP", "HELP ALL"),
        ("pt", "AJUDA", "AJUDA TUDO"),
        ("es", "AYUDA", "AYUDA TODO"),
    ],
)
def test_help_alone_has_ten_words_and_names_the_word_for_all(
    language: str, typed: str, everything: str, tmp_path: Path
) -> None:
    few = printed_by(tmp_path, language, [typed])[2:-2]
    many = printed_by(tmp_path, language, [everything])[2:-2]

    assert len(few) == 13
    assert everything in few[-1]
    assert len(many) > 100
