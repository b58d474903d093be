"""Lets a program wait until what it says was heard, where the learner wants that. A stop ends the wait."""

from __future__ import annotations

from collections.abc import Callable

SLICE = 0.05
"""Seconds between two looks whether to go on."""

LONGEST = 30.0
"""Seconds for one SPEAK; a voice that takes longer, or hangs, holds nobody."""


class UntilSaid:
    """Waits for nothing until it is given a voice."""

    def __init__(self) -> None:
        self.is_quiet_within: Callable[[float], bool] | None = None
        """Waits that many seconds at most until everything was said; False if that was not enough."""
        self.waiting = 0
        """Programs that wait just now."""

    def wait(self, goes_on: Callable[[], bool]) -> None:
        """Return once everything was said, or ``goes_on`` says no."""
        if self.is_quiet_within is None:
            return
        self.waiting += 1
        try:
            self._wait(self.is_quiet_within, goes_on)
        finally:
            self.waiting -= 1

    def _wait(self, is_quiet_within: Callable[[float], bool], goes_on: Callable[[], bool]) -> None:
        for _ in range(round(LONGEST / SLICE)):
            if is_quiet_within(SLICE) or not goes_on():
                return
