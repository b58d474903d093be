"""What every back end makes of a program."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol, TypeAlias, TypeVar

from language.control import ExecutionControl
from language.runtime import Actions, Frame, Memory

Trace: TypeAlias = Callable[[int, int, int], None]
"""Told the line, the column and the number of open calls before each statement."""

_MOST_FRAMES = 100
"""What ``frames`` tells of a deep recursion."""

_Level = TypeVar("_Level")


class Runnable(Protocol):
    """A compiled program."""

    def run(
        self, actions: Actions, control: ExecutionControl, memory: Memory, *, trace: Trace | None = None
    ) -> None:
        """Run to the end, in this thread.

        Raises ``ProgramError``, ``Stopped``, ``QuitRequested``, or whatever an action raised. The memory
        holds the program's variables and procedures then, as it does after the end.
        """

    def frames(self) -> tuple[Frame, ...]:
        """The open calls and the program, innermost first; from any thread, empty unless it runs.

        Of a recursion deeper than 100 only the innermost frames and the program are told.
        """


def told_levels(levels: list[_Level]) -> list[_Level]:
    """Of levels from the program inwards those that ``frames`` tells, innermost first."""
    told = levels if len(levels) <= _MOST_FRAMES else [levels[0], *levels[1 - _MOST_FRAMES :]]
    return told[::-1]
