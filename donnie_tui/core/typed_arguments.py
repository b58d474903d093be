"""What was typed behind a word: numbers, or the number of a line with its text.

The same for both front ends. Rule: what is anything else is None and never taken for nothing, so that a slip
of the fingers deletes no line.
"""

from __future__ import annotations

LARGEST_NUMBER = 10_000_000
"""No program has so many lines, no session so many answers, no world so many squares."""
_MOST_CHARACTERS = 8


def numbers_in(typed: str, *, most: int) -> tuple[int, ...] | None:
    """At most so many whole numbers, blanks or commas between them."""
    words = typed.replace(",", " ").split()
    if len(words) > most or not all(map(_is_whole, words)):
        return None
    found = tuple(map(int, words))
    return found if all(abs(each) <= LARGEST_NUMBER for each in found) else None


def number_in(typed: str, default: int) -> int | None:
    """The one number that stands there, or ``default`` where nothing does."""
    found = numbers_in(typed, most=1)
    return found if found is None else next(iter(found), default)


def count_in(typed: str, default: int) -> int | None:
    """As ``number_in``, from 1."""
    found = number_in(typed, default)
    return None if found is None or found < 1 else found


def number_and_text(typed: str) -> tuple[int, str] | None:
    """``3 FW 2`` is line 3 with its text, which may be empty."""
    word, _blank, text = typed.partition(" ")
    found = numbers_in(word, most=1)
    return (found[0], text.strip()) if found else None


def _is_whole(word: str) -> bool:
    return len(word) <= _MOST_CHARACTERS and word.removeprefix("-").isdecimal()
