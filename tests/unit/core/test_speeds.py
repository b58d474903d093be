"""SLOWER and FASTER go through the speeds and stop at the ends."""

from itertools import pairwise

from donnie_tui.i18n.words import Words
from donnie_tui.settings.settings import SPEEDS, faster_than, slower_than, speed_words
from language.locales import languages


def test_faster_and_slower_undo_each_other() -> None:
    for one, other in pairwise(SPEEDS):
        assert faster_than(one) == other
        assert slower_than(other) == one


def test_there_is_no_speed_beyond_the_first_and_the_last() -> None:
    assert faster_than(None) is None
    assert slower_than(SPEEDS[0]) == SPEEDS[0]
    assert slower_than(0.3) == 0.3
    assert faster_than(0.3) == SPEEDS[0]


def test_the_fastest_has_a_word() -> None:
    assert [speed_words(each, Words()) for each in (0.5, 5.0, None)] == ["0.5", "5", "max"]


def test_a_speed_has_the_decimal_sign_of_the_language() -> None:
    assert [speed_words(0.5, Words(language)) for language in languages()] == ["0.5", "0,5", "0,5"]
