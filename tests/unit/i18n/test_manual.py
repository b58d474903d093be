"""The chapters of the manual as the linear mode tells them: a fact a line, none too wide for braille."""

import pytest

from donnie_tui.i18n.catalogue.manual import CHAPTERS
from donnie_tui.i18n.help import ENTRIES
from donnie_tui.i18n.manual import chapter_lines, sections
from donnie_tui.i18n.words import Words

LANGUAGES = ("en", "pt", "es")


def all_lines(language: str, detail: str) -> list[str]:
    words = Words(language, detail)
    return [line for chapter in CHAPTERS for line in chapter_lines(words, chapter)]


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_line_is_one_sentence_or_one_line_of_a_program(language: str) -> None:
    """L8."""
    told = all_lines(language, "normal")

    assert len(told) > len(CHAPTERS) * 3
    assert [line for line in told if ". " in line or len(line) > 80] == []
    assert [line for line in told if line != line.strip()] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_at_detail_brief_a_line_fits_forty_cells_and_no_word_is_lost(language: str) -> None:
    """L8, B1."""
    told = all_lines(language, "brief")

    assert [line for line in told if len(line) > 40] == []
    assert " ".join(told) == " ".join(all_lines(language, "normal"))


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_line_of_a_program_stays_whole(language: str) -> None:
    examples = [line for line in all_lines(language, "normal") if not line.endswith(".")]

    assert examples
    assert [line for line in examples if line not in all_lines(language, "brief")] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_as_a_page_it_has_a_heading_for_each_chapter_and_an_example_of_each_command(language: str) -> None:
    """L28."""
    words = Words(language)
    told = sections(words)

    assert [each.heading for each in told[:-1]] == [words(f"manual-{chapter}") for chapter in CHAPTERS]
    assert all(each.lines for each in told)
    assert [words.help(entry)[-1] for entry in ENTRIES if words.help(entry)[-1] not in told[-1].lines] == []
