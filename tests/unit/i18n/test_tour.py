"""The tour has no page without lines, and what it says to type is understood in its language."""

import re
from types import ModuleType

import pytest

from donnie_tui import LANGUAGES
from donnie_tui.core import use_cases
from donnie_tui.i18n.catalogue import screen_tour, tour
from donnie_tui.i18n.tour import PAGES, SCREEN_PAGES, page, screen_page
from donnie_tui.i18n.words import Words
from language import keywords

PLACE = re.compile(r"\{(\w+)\}")
WORD = re.compile(r"\b[A-ZÁÂÃÇÉÊÍÓÔÕÚÑ]{2,}\b")
ARGUMENTS = {"F"}


def keys() -> dict[str, str]:
    """A key for each place."""
    return dict.fromkeys(PLACE.findall(" ".join(each.en for each in screen_tour.SENTENCES.values())), "F5")


def pages(topic: ModuleType, name: str) -> dict[int, int]:
    """How many lines each page has."""
    found = [re.fullmatch(rf"{name}-(\d+)-(\d+)", code) for code in topic.SENTENCES]
    numbers = [(int(each[1]), int(each[2])) for each in found if each]
    return {page: max(line for at, line in numbers if at == page) for page, _ in numbers}


def test_every_page_is_told_to_its_last_line() -> None:
    words = Words("en")

    assert pages(tour, "tour") == {number: len(page(number, words)) for number in range(1, PAGES + 1)}
    assert pages(screen_tour, "screen-tour") == {
        number: len(screen_page(number, words, keys())) for number in range(1, SCREEN_PAGES + 1)
    }


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("topic", [tour, screen_tour], ids=["linear", "screen"])
def test_every_word_of_the_tour_is_one_that_can_be_typed(language: str, topic: ModuleType) -> None:
    ours = {word for each in use_cases.USE_CASES for word in each.word(language).split()}
    theirs = {word for each in keywords.all_words(language) for word in each.split()}
    texts = [sentence.text(language) for sentence in topic.SENTENCES.values()]
    used = {word for text in texts for word in WORD.findall(text)}

    assert used - ours - theirs == set()
