"""The chapters of the manual as the linear mode prints them: a fact a line, none too wide for braille."""

import pytest

from donnie_tui.i18n.help import CHAPTERS, ENTRIES, chapter_lines, sections
from donnie_tui.i18n.words import Words

LANGUAGES = ("en", "pt", "es")


def all_lines(language: str, detail: str) -> list[str]:
    words = Words(language, detail)
    return [line for chapter in CHAPTERS for line in chapter_lines(words, chapter)]


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_line_is_one_sentence_or_one_line_of_a_program(language: str) -> None:
    found = all_lines(language, "normal")

    assert len(found) > len(CHAPTERS) * 3
    assert [line for line in found if ". " in line or len(line) > 80] == []
    assert [line for line in found if line != line.strip()] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_line_at_detail_brief_fits_forty_cells_and_keeps_every_word(language: str) -> None:
    found = all_lines(language, "brief")

    assert [line for line in found if len(line) > 40] == []
    assert " ".join(found) == " ".join(all_lines(language, "normal"))


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_line_of_a_program_stays_whole(language: str) -> None:
    examples = [line for line in all_lines(language, "normal") if not line.endswith(".")]

    assert examples
    assert [line for line in examples if line not in all_lines(language, "brief")] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_manual_as_a_page_has_a_heading_for_each_chapter_and_all_examples(language: str) -> None:
    words = Words(language)
    found = sections(words)

    assert [each.heading for each in found[:-1]] == [words(f"manual-{chapter}") for chapter in CHAPTERS]
    assert all(each.lines for each in found)
    assert [words.help(entry)[-1] for entry in ENTRIES if words.help(entry)[-1] not in found[-1].lines] == []
