"""Notices that the audio worker is frozen (S6). Pure: time comes in as a parameter.

Everything that should be answered has a date by which it is; a player that plays must move on. And a
count of failures tells when to give up.
"""

from __future__ import annotations

from collections import deque
from enum import Enum, auto

ANSWER_LIMIT = 3.0
"""Seconds without an answer or a moving frame that make a worker a frozen one."""

START_LIMIT = 10.0
"""Seconds for opening the device and loading the voice, on a slow machine with a cold disk."""

HUSH_LIMIT = 0.12
"""Seconds; silence must follow within 0.15, and ending the group takes a few milliseconds."""

MOST_FAILURES = 3
FAILURE_WINDOW = 60.0


class Due(Enum):
    """What the worker owes us."""

    START = auto()
    PONG = auto()
    STARTED = auto()
    FINISHED = auto()
    HUSHED = auto()
    MOVEMENT = auto()
    """Of the frames, while the player says that it plays."""


class Watch:
    """The dates of one worker."""

    def __init__(self) -> None:
        self._dates: dict[Due, float] = {}
        self._frames = -1

    def expect(self, what: Due, by: float) -> None:
        """``what`` should come by then; a date that stands already is kept."""
        self._dates.setdefault(what, by)

    def came(self, *what: Due) -> None:
        """It came, or is no longer wanted."""
        for each in what:
            self._dates.pop(each, None)

    def expects(self, what: Due) -> bool:
        return what in self._dates

    def saw(self, frames: int, is_playing: bool, now: float) -> None:
        """A heartbeat: ``frames`` given to the device so far, -1 if that is unknown."""
        if not is_playing or frames < 0 or frames != self._frames:
            self.came(Due.MOVEMENT)
        if is_playing and frames >= 0:
            self.expect(Due.MOVEMENT, now + ANSWER_LIMIT)
        self._frames = frames

    def postpone(self, seconds: float) -> None:
        """We ourselves were away for so long (suspended, or starved): nobody owes us anything for that."""
        self._dates = {what: date + seconds for what, date in self._dates.items()}

    def overdue(self, now: float) -> Due | None:
        """What should have come by ``now``, or None."""
        return next((what for what, date in self._dates.items() if now >= date), None)

    def next_date(self) -> float | None:
        """When to look again."""
        return min(self._dates.values(), default=None)


class Failures:
    """Three in a minute are enough."""

    def __init__(self) -> None:
        self._times: deque[float] = deque(maxlen=MOST_FAILURES)

    def add(self, now: float) -> bool:
        """One more at ``now``. True if it is time to give up."""
        self._times.append(now)
        return len(self._times) == MOST_FAILURES and now - self._times[0] <= FAILURE_WINDOW
