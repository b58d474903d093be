"""Parses what follows a command word: yes and no, on and off, numbers, a line with its text.

Anything else is None and never taken for nothing, so that a slip of the fingers deletes no line;
``read_count`` and ``read_numbers`` raise ``NotUnderstood``.
"""

from __future__ import annotations

from donnie_tui.commands.interaction import NotUnderstood
from donnie_tui.core.wording import meant


def read_count(argument: str, default: int) -> int:
    """A number from 1, or ``default`` where nothing was typed."""
    found = count_in(argument, default)
    if found is None:
        raise NotUnderstood
    return found


def read_numbers(argument: str, *, least: int = 0, most: int) -> tuple[int, ...]:
    """From ``least`` to ``most`` whole numbers, with blanks or commas between them."""
    found = numbers_in(argument, most=most)
    if found is None or len(found) < least:
        raise NotUnderstood
    return found


def detail_named(typed: str) -> str | None:
    """How much is to be printed: ``brief``, ``normal`` or ``full``; None for any other word."""
    return meant(typed, "details")


def answered(typed: str) -> bool | None:
    """Whether the answer is yes; None if it is neither yes nor no."""
    return {"yes": True, "no": False}.get(meant(typed, "answers") or "")


def switched(typed: str) -> bool | None:
    """Whether something is to be on; None if what was typed means neither on nor off."""
    return {"on": True, "off": False}.get(meant(typed, "switch") or "")


NO_REPLACEMENT = '""'
"""What is typed to delete a word everywhere."""


def replacement(typed: str | None) -> str | None:
    """What REPLACE puts in place of a word. None for no answer and for Enter alone, which change nothing.

    Two quotes delete the word: they are not typed by mistake.
    """
    return "" if typed == NO_REPLACEMENT else typed or None


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
