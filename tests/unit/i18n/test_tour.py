"""The tour has no page without lines, and what it says to type is understood in its language."""

import re

import pytest

from donnie_tui import LANGUAGES
from donnie_tui.core import use_cases
from donnie_tui.i18n.catalogue.tour import SENTENCES
from donnie_tui.i18n.tour import PAGES, page, tour
from donnie_tui.i18n.words import Words
from language import keywords

WORD = re.compile(r"\b[A-ZÁÂÃÇÉÊÍÓÔÕÚÑ]{2,}\b")
ARGUMENTS = {"F"}


def pages() -> dict[int, int]:
    """How many lines each page has."""
    found = [re.fullmatch(r"tour-(\d+)-(\d+)", code) for code in SENTENCES]
    numbers = [(int(each[1]), int(each[2])) for each in found if each]
    return {page: max(line for at, line in numbers if at == page) for page, _ in numbers}


def test_every_page_is_told_to_its_last_line() -> None:
    assert sorted(pages()) == list(range(1, PAGES + 1))
    assert pages() == {number: len(page(number, Words("en"))) for number in range(1, PAGES + 1)}
    assert len(tour(Words("en"))) == sum(pages().values())


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_word_of_the_tour_is_one_that_can_be_typed(language: str) -> None:
    ours = {word for each in use_cases.USE_CASES for word in each.word(language).split()}
    theirs = {word for each in keywords.all_words(language) for word in each.split()}
    texts = [sentence.text(language) for sentence in SENTENCES.values()]
    used = {word for text in texts for word in WORD.findall(text)}

    assert used - ours - theirs == set()
