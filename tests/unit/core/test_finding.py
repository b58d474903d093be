"""A word is found where it stands, whatever its accents and the size of its letters."""

import pytest

from donnie_tui.core.finding import Place, found_from, not_to_replace
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
def test_the_next_place_from_there_on_and_once_round(wanted, row, column, found):
    assert found_from(LINES, wanted, row, column) == found


def test_nothing_is_found_where_nothing_is():
    assert found_from((), "FW", 0) is None


@pytest.mark.parametrize(
    ("wanted", "told"),
    [
        ("BK", "BK is not in the program."),
        ("fw", "Line 1 has FW. REPLACE takes a word as it is written there."),
        ("ola", "Line 4 has Ola\u0301. REPLACE takes a word as it is written there."),
    ],
)
def test_what_is_written_otherwise_is_not_told_to_be_missing(wanted, told):
    assert not_to_replace(LINES, wanted, Words()) == told
