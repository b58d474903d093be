"""SLOWER and FASTER go through the speeds and stop at the ends."""

from itertools import pairwise

from donnie_tui import LANGUAGES
from donnie_tui.core.speeds import SPEEDS, faster, slower, speed_words
from donnie_tui.i18n.words import Words


def test_faster_and_slower_undo_each_other() -> None:
    for one, other in pairwise(SPEEDS):
        assert faster(one) == other
        assert slower(other) == one


def test_there_is_nothing_beyond_the_ends() -> None:
    assert faster(None) is None
    assert slower(SPEEDS[0]) == SPEEDS[0]
    assert slower(0.3) == 0.3
    assert faster(0.3) == SPEEDS[0]


def test_the_fastest_has_a_word() -> None:
    assert [speed_words(each, Words()) for each in (0.5, 5.0, None)] == ["0.5", "5", "max"]


def test_a_speed_is_told_with_the_languages_decimal_sign() -> None:
    assert [speed_words(0.5, Words(language)) for language in LANGUAGES] == ["0.5", "0,5", "0,5"]
