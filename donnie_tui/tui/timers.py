"""Timers of the screen: one that reports what takes long, and one that looks again and again."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from textual.app import App
from textual.timer import Timer

from donnie_tui.commands.interaction import SLOW, SLOW_AGAIN

SOON, SELDOM = 1 / 5, 1.0
"""Seconds between two updates of what no event reports: at least, and at most."""


class Reminder:
    """Reports what takes long, again and again until it is stopped."""

    def __init__(self, app: App[Any], report: Callable[[], None]) -> None:
        self._timers = (app.set_timer(SLOW, report), app.set_interval(SLOW_AGAIN, report))

    def stop(self) -> None:
        for each in self._timers:
            each.stop()


class Polling:
    """Looks again and again at what no event reports: the line that runs, and the variables.

    Each look takes from the program's time. So it comes soon after an event, and in silence more and more
    seldom.
    """

    def __init__(self, look: Callable[[], None], later: Callable[[float, Callable[[], None]], Timer]) -> None:
        """``later`` sets a timer."""
        self._look, self._later = look, later
        self._rest = SOON
        self._timer: Timer | None = None

    @property
    def is_on(self) -> bool:
        return self._timer is not None

    def begin(self) -> None:
        if self._timer is None:
            self._look_in(SOON)

    def on_event(self) -> None:
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
        self._timer = self._later(seconds, self._poll)

    def _poll(self) -> None:
        self._look_in(min(2 * self._rest, SELDOM))
        self._look()
