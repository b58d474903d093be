"""Robot time: computed, never read. Real time is the same run with sleeps between.

The one place of the simulator that waits, and it waits through the pace only.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from devices.ports.robot import Pace

SLICE = 1 / 20
"""Seconds of real time between two looks at the speed and at the pace's answer."""

Mark = tuple[float, Callable[[], None]]
"""Seconds from the start of something, and what is to be told then."""


class Clock:
    """The time of one robot. ``speed``: a multiple of real time, None is unlimited; any thread may set it."""

    def __init__(self, pace: Pace, speed: float | None) -> None:
        self.speed = speed
        self.seconds = 0.0
        self._pace = pace
        self._halted = False

    def halt(self) -> None:
        """End the command that goes on now. From any thread."""
        self._halted = True

    def begin(self) -> None:
        """A command begins: an earlier halt is over."""
        self._halted = False

    def goes_on(self) -> bool:
        """Whether the command may go on. No time goes by."""
        return not self._halted and self._pace.sleep(0.0)

    def reset(self) -> None:
        self.seconds = 0.0

    def spend(
        self, seconds: float, marks: Sequence[Mark], passing: Callable[[float], None] | None = None
    ) -> float:
        """Let ``seconds`` go by, telling ``marks`` (in order) at their times and ``passing`` in every slice.

        Answers how many seconds went by: less than asked if it was halted or the pace said stop.
        """
        began, spent = self.seconds, 0.0
        for at, tell in (*marks, (seconds, None)):
            spent = self._reach(began, spent, at, passing)
            if spent < at or self._halted:
                return spent
            if tell is not None:
                tell()
        return spent

    def _reach(
        self, began: float, spent: float, until: float, passing: Callable[[float], None] | None
    ) -> float:
        while spent < until and not self._halted:
            speed = self.speed
            following = until if speed is None else min(until, spent + SLICE * speed)
            if speed is not None and not self._pace.sleep((following - spent) / speed):
                break
            spent = following
            self.seconds = began + spent
            if speed is not None and passing is not None:
                passing(spent)
        return spent
