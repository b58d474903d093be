"""A word is found whatever its accents and the case of its letters."""

import pytest

from donnie_tui.core.program_text import Place, find_word, not_replaceable
from donnie_tui.i18n.words import Words

LINES = ("FW 1", 'SPEAK "ßßß"', "FW 22", 'SPEAK "Ola\u0301, olá!"')


@pytest.mark.parametrize(
    ("wanted", "row", "column", "found"),
    [
        ("fw", 0, 0, Place(0, 0, 2)),
        ("fw", 0, 1, Place(2, 0, 2)),
        ("FW", 2, 1, Place(0, 0, 2)),
        ("22", 0, 0, Place(2, 3, 5)),
        ("ß", 0, 0, Place(1, 7, 8)),
        ("ola", 0, 0, Place(3, 7, 11)),
        ("OLÁ", 3, 8, Place(3, 13, 16)),
        ("ola\u0301!", 0, 0, Place(3, 13, 17)),
        ("olá", 3, 14, Place(3, 7, 11)),
        ("1", 4, 0, Place(0, 3, 4)),
        ("BK", 0, 0, None),
        ("", 0, 0, None),
        ("\u0301", 0, 0, None),
    ],
)
def test_a_search_continues_from_the_cursor_and_wraps_around(wanted, row, column, found):
    assert find_word(LINES, wanted, row, column) == found


def test_a_missing_word_is_not_found():
    assert find_word((), "FW", 0) is None


@pytest.mark.parametrize(
    ("wanted", "answer"),
    [
        ("BK", "BK is not in the program."),
        ("fw", "Line 1 has FW. REPLACE takes a word as it is written there."),
        ("ola", "Line 4 has Ola\u0301. REPLACE takes a word as it is written there."),
    ],
)
def test_a_word_written_differently_is_reported_with_its_spelling(wanted, answer):
    assert not_replaceable(LINES, wanted, Words()) == answer
