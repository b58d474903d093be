"""What is known of the board, as one value that other threads may read; and how it is kept.

Rule: nothing that ends a program's movement rests on one frame alone. A CRC of eight bits lets one bad frame
in 256 pass, and the firmware's own counters can be torn.
"""

from __future__ import annotations

from collections import deque

from devices.ports.values import Frozen
from devices.wire.link_config import LinkConfig
from devices.wire.reports import BUMPERS

REFRESH = 0.2
"""Seconds in which every sonar has measured once more."""

REMEMBERED = 2 * REFRESH
"""Seconds of ranges that are remembered: a wrapped or missed echo is rarely there twice."""

_MOST_REMEMBERED = 64


class RangeSample(Frozen):
    """What the sonars told once."""

    at: float
    """Seconds on the line's clock."""
    right: int
    left: int
    """Counts of the wheels by then."""
    centimetres: tuple[int, ...]
    """In the board's order; 0 is unknown."""


class Telemetry(Frozen):
    """The board, as it was when the last bytes came in."""

    at: float = 0.0
    """Seconds on the line's clock when the last frame came."""
    era: int = 0
    """Grows when the counts begin anew: the board restarted, or the line was lost."""
    right: int = 0
    left: int = 0
    """Counts of the wheels since the line was first open; they neither wrap nor jump."""
    moved_at: float = 0.0
    """When a wheel last counted."""
    both_moved_at: float = 0.0
    """Since when one of the wheels has not counted: of their last counts, the older one's."""
    ranges: tuple[RangeSample, ...] = ()
    """Of the last two refreshes, oldest first."""
    bumpers: tuple[bool, ...] = (False,) * BUMPERS
    """Pressed in two frames that agree; in the board's order."""
    millivolts: int | None = None
    frames: int = 0
    bad_frames: int = 0


class WheelCounter:
    """One wheel's count, unrolled: it wraps every 4.8 metres, and now and then tells nonsense once."""

    def __init__(self, jump: int) -> None:
        self.total = 0
        self._jump = jump
        self._last: int | None = None
        self._doubtful: int | None = None

    def rebase(self) -> None:
        """The next count is where the wheel stands, not how far it went."""
        self._last = self._doubtful = None

    def count(self, raw: int) -> int:
        """Take a count of -32768 to 32767. Answers how far the wheel went since the last believed one."""
        if self._last is None:
            self._last = raw
            return 0
        moved = _around(raw - self._last)
        if abs(moved) > self._jump and not self._is_confirmed(raw):
            self._doubtful = raw
            return 0
        self._last, self._doubtful = raw, None
        self.total += moved
        return moved

    def _is_confirmed(self, raw: int) -> bool:
        return self._doubtful is not None and abs(_around(raw - self._doubtful)) <= self._jump


def _around(difference: int) -> int:
    return (difference + 32768) % 65536 - 32768


class Instruments:
    """Keeps the telemetry while reports come in."""

    def __init__(self, config: LinkConfig) -> None:
        self._right = WheelCounter(config.tick_jump)
        self._left = WheelCounter(config.tick_jump)
        self._ranges: deque[RangeSample] = deque(maxlen=_MOST_REMEMBERED)
        self._last_bumpers = self._bumpers = (False,) * BUMPERS
        self._era = 0
        self._millivolts: int | None = None
        self._moved_at = 0.0
        self._right_moved_at = self._left_moved_at = 0.0
        self._frames = 0

    @property
    def right(self) -> int:
        return self._right.total

    @property
    def left(self) -> int:
        return self._left.total

    @property
    def moved_at(self) -> float:
        return self._moved_at

    def rebase(self) -> None:
        """The board began anew, or the line was lost: what it told before is no longer so."""
        self._right.rebase()
        self._left.rebase()
        self._ranges.clear()
        self._last_bumpers = self._bumpers = (False,) * BUMPERS
        self._era += 1

    def heard(self) -> None:
        self._frames += 1

    def counted(self, right: int, left: int, now: float) -> None:
        if self._right.count(right):
            self._moved_at = self._right_moved_at = now
        if self._left.count(left):
            self._moved_at = self._left_moved_at = now

    def measured(self, centimetres: tuple[int, ...], now: float) -> None:
        while self._ranges and self._ranges[0].at < now - REMEMBERED:
            self._ranges.popleft()
        self._ranges.append(RangeSample(now, self.right, self.left, centimetres))

    def touched(self, pressed: tuple[bool, ...]) -> None:
        if pressed == self._last_bumpers:
            self._bumpers = pressed
        self._last_bumpers = pressed

    def powered(self, millivolts: int) -> None:
        self._millivolts = millivolts

    def telemetry(self, now: float, bad_frames: int) -> Telemetry:
        return Telemetry(
            at=now,
            era=self._era,
            right=self.right,
            left=self.left,
            moved_at=self._moved_at,
            both_moved_at=min(self._right_moved_at, self._left_moved_at),
            ranges=tuple(self._ranges),
            bumpers=self._bumpers,
            millivolts=self._millivolts,
            frames=self._frames,
            bad_frames=bad_frames,
        )
