"""What is known of the board, as one value that other threads may read, and how it is kept up to date.

Rule: nothing that ends a program's movement rests on one frame alone. A CRC of eight bits lets one bad frame
in 256 pass, and the firmware's own counters can be torn.
"""

from __future__ import annotations

from collections import deque

from msgspec import Struct

from devices.wire.frames import AS_ORIGINAL, BUMPERS
from devices.wire.link_state import LinkConfig

REFRESH = 0.2
"""Seconds in which every sonar has measured once more."""

REMEMBERED = 2 * REFRESH
"""Seconds of ranges that are remembered: a wrapped or missed echo rarely occurs twice."""

_MOST_REMEMBERED = 64


class RangeSample(Struct, frozen=True):
    """One report of the sonars."""

    at: float
    """Seconds on the link's clock."""
    right: int
    left: int
    """Counts of the wheels at that time."""
    centimetres: tuple[int, ...]
    """In the board's order; 0 is unknown."""


class Telemetry(Struct, frozen=True):
    """The board, as it was when the last bytes came in."""

    at: float = 0.0
    """Seconds on the link's clock when the last frame came."""
    epoch: int = 0
    """Grows when the counts begin anew: the board restarted, or the link was lost."""
    right: int = 0
    left: int = 0
    """Counts of the wheels since the link was first open; they neither wrap nor jump."""
    counted_at: float = 0.0
    """When the wheels' counts came last."""
    changed_at: float = 0.0
    """When they last differed from those before, or had none before."""
    both_moved_at: float = 0.0
    """Of the two wheels' last counts, the time of the older one: since then one wheel has not counted."""
    ranges: tuple[RangeSample, ...] = ()
    """Of the last two refreshes, oldest first."""
    bumpers: tuple[bool, ...] = (False,) * BUMPERS
    """Pressed in two frames that agree; in the board's order."""
    millivolts: int | None = None
    frames: int = 0
    bad_frames: int = 0


class WheelCounter:
    """One wheel's count, unwrapped. The raw count wraps every 4.8 metres, and is occasionally wrong once."""

    def __init__(self, jump: int) -> None:
        self.total = 0
        self._jump = jump
        self._last: int | None = None
        self._doubtful: int | None = None

    def rebase(self) -> None:
        """Take the next count as the wheel's position, not as a distance."""
        self._last = self._doubtful = None

    def count(self, raw: int) -> int:
        """Take a count of -32768 to 32767. Returns how far the wheel moved since the last trusted one."""
        if self._last is None:
            self._last = raw
            return 0
        moved = unwrapped(raw - self._last)
        if abs(moved) > self._jump and not self._is_confirmed(raw):
            self._doubtful = raw
            return 0
        self._last, self._doubtful = raw, None
        self.total += moved
        return moved

    def _is_confirmed(self, raw: int) -> bool:
        return self._doubtful is not None and abs(unwrapped(raw - self._doubtful)) <= self._jump


def unwrapped(difference: int) -> int:
    """The way between two raw counts, however they wrapped."""
    wrapped = difference % 65536
    return wrapped - 65536 if wrapped >= 32768 else wrapped


class TelemetryTracker:
    """Keeps the telemetry up to date while reports come in."""

    def __init__(self, config: LinkConfig) -> None:
        self._right = WheelCounter(config.tick_jump)
        self._left = WheelCounter(config.tick_jump)
        self._ranges: deque[RangeSample] = deque(maxlen=_MOST_REMEMBERED)
        self._last_bumpers = self._bumpers = (False,) * BUMPERS
        self._epoch = 0
        self.encoders = AS_ORIGINAL.encoders
        """The senses of the two counts, right and left."""
        self.millivolts: int | None = None
        self.counted_at = self.changed_at = 0.0
        """As in ``Telemetry``."""
        self._counts: tuple[int, int] | None = None
        self._right_moved_at = self._left_moved_at = 0.0
        self.frames = 0

    @property
    def right(self) -> int:
        return self._right.total

    @property
    def left(self) -> int:
        return self._left.total

    def rebase(self) -> None:
        """The board restarted, or the link was lost: forget what may have changed meanwhile."""
        self._right.rebase()
        self._left.rebase()
        self._counts = None
        self._ranges.clear()
        self._last_bumpers = self._bumpers = (False,) * BUMPERS
        self._epoch += 1

    def count_wheels(self, right: int, left: int, now: float) -> None:
        self.counted_at = now
        if self._counts != (right, left):
            self._counts, self.changed_at = (right, left), now
        if self._right.count(right * self.encoders[0]):
            self._right_moved_at = now
        if self._left.count(left * self.encoders[1]):
            self._left_moved_at = now

    def add_ranges(self, centimetres: tuple[int, ...], now: float) -> None:
        while self._ranges and self._ranges[0].at < now - REMEMBERED:
            self._ranges.popleft()
        self._ranges.append(RangeSample(now, self.right, self.left, centimetres))

    def add_bumpers(self, pressed: tuple[bool, ...]) -> None:
        if pressed == self._last_bumpers:
            self._bumpers = pressed
        self._last_bumpers = pressed

    def telemetry(self, now: float, bad_frames: int) -> Telemetry:
        return Telemetry(
            at=now,
            epoch=self._epoch,
            right=self.right,
            left=self.left,
            counted_at=self.counted_at,
            changed_at=self.changed_at,
            both_moved_at=min(self._right_moved_at, self._left_moved_at),
            ranges=tuple(self._ranges),
            bumpers=self._bumpers,
            millivolts=self.millivolts,
            frames=self.frames,
            bad_frames=bad_frames,
        )
