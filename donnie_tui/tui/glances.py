"""When a running program is looked at, for what no event tells: where it is, and what it has counted.

Rule: each look takes from the program's time. So it is looked at soon after something was heard of it, and
in silence more and more seldom.
"""

from __future__ import annotations

from collections.abc import Callable

from textual.timer import Timer

SOON, SELDOM = 1 / 5, 1.0
"""Seconds from one look to the next: at least, and at most."""


class Glances:
    """Looks again and again, from ``begin`` to ``end``."""

    def __init__(self, look: Callable[[], None], later: Callable[[float, Callable[[], None]], Timer]) -> None:
        """``later`` sets a timer."""
        self._look, self._later = look, later
        self._rest = SOON
        self._timer: Timer | None = None

    @property
    def are_on(self) -> bool:
        return self._timer is not None

    def begin(self) -> None:
        if self._timer is None:
            self._look_in(SOON)

    def heard(self) -> None:
        """Something happened: the next look is soon."""
        if self._timer is not None and self._rest > SOON:
            self._timer.stop()
            self._look_in(SOON)

    def end(self) -> None:
        if self._timer is not None:
            self._timer.stop()
            self._timer = None

    def _look_in(self, seconds: float) -> None:
        self._rest = seconds
        self._timer = self._later(seconds, self._glance)

    def _glance(self) -> None:
        self._look_in(min(2 * self._rest, SELDOM))
        self._look()
