"""Arguments of a word are numbers, or they are not understood."""

import pytest

from donnie_tui.commands.interaction import count_in, number_and_text, numbers_in


@pytest.mark.parametrize(
    ("typed", "found"),
    [
        ("", ()),
        ("3", (3,)),
        ("2 5", (2, 5)),
        ("-3, 12", (-3, 12)),
        ("10000000", (10_000_000,)),
        ("٣", (3,)),
        ("--3", None),
        ("-", None),
        ("+3", None),
        ("3x", None),
        ("²", None),
        ("1 2 3", None),
        ("10000001", None),
        ("9" * 5000, None),
    ],
)
def test_only_whole_numbers_are_understood(typed, found):
    assert numbers_in(typed, most=2) == found


@pytest.mark.parametrize(("typed", "found"), [("", 7), ("3", 3), ("0", 0), ("abc", None), ("1 2", None)])
def test_a_missing_number_is_the_default_and_rubbish_is_an_error(typed, found):
    assert count_in(typed, 7) == (found or None)


@pytest.mark.parametrize(
    ("typed", "found"),
    [("3 FW 2", (3, "FW 2")), ("3", (3, "")), ("3  FW 2 ", (3, "FW 2")), ("FW 2", None), ("", None)],
)
def test_a_line_is_its_number_and_its_text(typed, found):
    assert number_and_text(typed) == found
