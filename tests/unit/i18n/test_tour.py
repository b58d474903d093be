"""Each page of the tour has lines, and the words that it asks to type are understood in its language."""

import re

import pytest

from donnie_tui.commands.declarations import COMMANDS
from donnie_tui.commands.lookup import words_of
from donnie_tui.i18n.help import SCREEN_TOUR_PAGES, TOUR_PAGES, screen_tour_page, tour_page
from donnie_tui.i18n.words import Words
from language import keywords
from language.locales import languages
from tests.unit.i18n.sentences import codes_of, text

PLACE = re.compile(r"\{(\w+)\}")
WORD = re.compile(r"\b[A-ZÁÂÃÇÉÊÍÓÔÕÚÑ]{2,}\b")
ARGUMENTS = {"F"}
MISSPELT = {"FWW", "PFF", "AVV"}
"""The mistake that a learner makes and corrects."""


def keys() -> dict[str, str]:
    """A key for each place."""
    return dict.fromkeys(PLACE.findall(" ".join(text(code, "en") for code in codes_of("screen-tour"))), "F5")


def pages(topic: str) -> dict[int, int]:
    """How many lines each page has."""
    found = [re.fullmatch(rf"{topic}-(\d+)-(\d+)", code) for code in codes_of(topic)]
    numbers = [(int(each[1]), int(each[2])) for each in found if each]
    return {page: max(line for at, line in numbers if at == page) for page, _ in numbers}


def test_every_page_has_all_its_lines() -> None:
    words = Words("en")

    assert pages("tour") == {n: len(tour_page(n, words)) for n in range(1, TOUR_PAGES + 1)}
    assert pages("screen-tour") == {
        n: len(screen_tour_page(n, words, keys())) for n in range(1, SCREEN_TOUR_PAGES + 1)
    }


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("topic", ["tour", "screen-tour"])
def test_every_word_of_the_tour_can_be_typed(language: str, topic: str) -> None:
    ours = {word for each in COMMANDS for phrase in words_of(each.name, language) for word in phrase.split()}
    theirs = {word for each in keywords.all_words(language) for word in each.split()}
    texts = [text(code, language) for code in codes_of(topic)]
    used = {word for each in texts for word in WORD.findall(each)}

    assert used - ours - theirs == MISSPELT & used
