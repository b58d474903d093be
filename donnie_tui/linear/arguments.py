"""What stands behind a word: numbers, a line's number with its text, or nothing at all."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from donnie_tui.linear.desk import Desk
from donnie_tui.linear.runs import Runs

LARGEST_NUMBER = 10_000_000
"""No program has so many lines, and no session so many answers."""

Handler: TypeAlias = Callable[[Desk, Runs, str], bool | None]
"""Does the word with what stands behind it. False if that can't be understood."""


def alone(do: Callable[[Desk], None]) -> Handler:
    """For a word behind which nothing stands."""

    def handler(desk: Desk, _: Runs, rest: str) -> bool:
        if not rest:
            do(desk)
        return not rest

    return handler


def counted(do: Callable[[Desk, int], None], default: int) -> Handler:
    """For a word behind which a number may stand, from 1."""

    def handler(desk: Desk, _: Runs, rest: str) -> bool:
        given = numbers_in(rest, most=1)
        number = given[0] if given else default
        if given is None or number < 1:
            return False
        do(desk, number)
        return True

    return handler


def numbers_in(rest: str, *, most: int) -> list[int] | None:
    """At most so many whole numbers, or None if there is anything else."""
    words = rest.replace(",", " ").split()
    digits = [each.removeprefix("-") for each in words]
    if len(words) > most or not all(each.isdecimal() and len(each) < 9 for each in digits):
        return None
    found = [int(each) for each in words]
    return found if all(abs(each) <= LARGEST_NUMBER for each in found) else None


def pair(given: list[int]) -> tuple[int | None, int | None]:
    return (given[0] if given else None), (given[1] if len(given) > 1 else None)


def number_and_text(rest: str) -> tuple[int | None, str]:
    word, _, text = rest.partition(" ")
    number = numbers_in(word, most=1)
    return (number[0] if number else None), text.strip()
