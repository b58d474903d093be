"""Words behind which nothing may stand, or a number from 1."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from donnie_tui.core.typed_words import count_in
from donnie_tui.linear.desk import Desk
from donnie_tui.linear.runs import Runs

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
        number = count_in(rest, default)
        if number is not None:
            do(desk, number)
        return number is not None

    return handler
