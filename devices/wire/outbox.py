"""What is to be written next, and when: the only one that decides what goes onto the wire.

Of each kind of frame only the newest is kept, a stop goes before everything else, the set-point is said again
and again, and the board never gets more than its buffer holds: what doesn't fit, it drops, stops as well.
"""

from __future__ import annotations

from math import inf

from devices.wire.commands import CONFIGURE, FILLER, STOP, Drive, motors
from devices.wire.link_config import LinkConfig

STOPS = 2
"""A stop is sent twice at least, for a frame can be lost."""


class Outbox:
    """Frames on their way to the board. Times are seconds on the line's clock."""

    def __init__(self, config: LinkConfig) -> None:
        self._config = config
        self.clear()

    def clear(self) -> None:
        """A line begins: nothing is on its way."""
        self._waiting: dict[int, bytes] = {}
        self._drive = Drive.STOP
        self._stops = 0
        self._is_at_once = False
        self._must_flush = self._must_configure = False
        self._unread = 0.0
        self._counted_at = self._free_at = self._quiet_until = -inf
        self._repeat_at = inf

    @property
    def is_empty(self) -> bool:
        """Whether everything was written, but for what is repeated."""
        return not (self._must_flush or self._must_configure or self._stops or self._waiting)

    @property
    def has_stops(self) -> bool:
        """Whether a stop was asked for that was not written as often as it must."""
        return self._stops > 0

    def flush(self) -> None:
        """Have zeros sent before anything else, to end what the board may hold half of."""
        self._must_flush = True

    def configure(self) -> None:
        self._must_configure = True

    def stop(self) -> None:
        """Two stops at once, and the set-point is to stand. What waited to be driven is forgotten."""
        self._drive = Drive.STOP
        self._is_at_once = self._is_at_once or not self._stops
        self._stops = STOPS

    def drive(self, drive: Drive, now: float) -> None:
        """Make ``drive`` the set-point, soon; it takes the place of stops that were not sent yet."""
        if drive is not self._drive or self._stops:
            self._drive, self._stops, self._is_at_once, self._repeat_at = drive, 0, False, now

    def hurry(self, now: float) -> None:
        """Say the set-point again as soon as may be: the board may have missed it."""
        self._repeat_at = min(self._repeat_at, now)

    def put(self, frame: bytes) -> None:
        """Have a frame sent when there is time; a newer one of its type takes its place."""
        self._waiting[frame[3]] = frame

    def due(self, now: float) -> bytes | None:
        """What is to be written now, if anything. It counts as written."""
        wanted = self._wanted(now)
        if wanted is None or not self._fits(wanted, now):
            return None
        self._sent(wanted, now)
        return wanted

    def next_at(self, now: float) -> float:
        """When to ask again; now at the earliest, infinity if nothing is to be repeated."""
        if self.is_empty:
            return max(now, self._repeat_at, self._free_at, self._quiet_until)
        earliest = (
            self._quiet_until if self._is_at_once and self._stops else max(self._free_at, self._quiet_until)
        )
        return max(now, earliest)

    def _wanted(self, now: float) -> bytes | None:
        if now < self._quiet_until:
            return None
        if self._must_flush:
            return FILLER
        if self._stops and self._is_at_once and not self._must_configure:
            return STOP
        if now < self._free_at:
            return None
        if self._must_configure:
            return CONFIGURE
        if self._stops:
            return STOP
        if now >= self._repeat_at:
            return motors(self._drive)
        return next(iter(self._waiting.values()), None)

    def _fits(self, frame: bytes, now: float) -> bool:
        self._unread = max(0.0, self._unread - (now - self._counted_at) * self._config.bytes_a_second)
        self._counted_at = now
        return self._unread + len(frame) <= self._config.most_outstanding

    def _sent(self, frame: bytes, now: float) -> None:
        self._unread += len(frame)
        self._free_at = now + self._config.gap
        if frame is FILLER:
            self._must_flush = False
            self._quiet_until = now + self._config.flush_pause
        elif frame is CONFIGURE:
            self._must_configure = False
        elif frame is STOP and self._stops:
            self._stops, self._is_at_once = self._stops - 1, False
            self._repeat_at = now + self._config.repeat
        elif frame is motors(self._drive):
            self._repeat_at = now + self._config.repeat
        else:
            self._waiting.pop(frame[3], None)
