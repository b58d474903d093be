"""Decides what is written to the board next, and when, and makes sure that a stopped robot stands.

``Outbox`` is the only one that decides what is sent: of each kind of frame only the newest is kept, a stop
precedes everything else, the drive command is repeated, and the board never gets more than its buffer holds,
because it drops what doesn't fit, stops included.

A stop can be lost with the half frame before it, and a board that reports nothing may be driving. So
``StopSequence`` ends a stop only once the wheels are seen to stand: first stops, then zeros and stops, then
force. If they turn even after that, it says so.
"""

from __future__ import annotations

from enum import Enum, auto
from math import inf

from devices.wire.frames import AS_ORIGINAL, CONFIGURE, FILLER, STOP, MotorDrive, drive_frame
from devices.wire.link_state import LinkConfig

STOPS = 2
"""A stop is sent at least twice, because a frame can be lost."""


class Outbox:
    """The frames to be sent. Times are seconds on the link's clock."""

    def __init__(self, config: LinkConfig) -> None:
        self._config = config
        self.wiring = AS_ORIGINAL
        self.clear()

    def clear(self) -> None:
        """Forget everything, for a port that was just opened."""
        self._waiting: dict[int, bytes] = {}
        self._drive = MotorDrive.STOP
        self._stops = 0
        self._is_at_once = False
        """Whether the next stop need not wait for the gap after the frame before it."""
        self._must_flush = self._must_configure = False
        self._all_read_at = -inf
        """When the board has read all that was written, by an estimate."""
        self._free_at = self._quiet_until = -inf
        self._repeat_at = inf

    @property
    def is_empty(self) -> bool:
        """Whether everything was written, except for what is repeated."""
        return not (self._must_flush or self._must_configure or self._stops or self._waiting)

    @property
    def has_stops(self) -> bool:
        """Whether a requested stop was not yet written as often as it must be."""
        return bool(self._stops)

    def flush(self) -> None:
        """Send zeros before anything else, to complete a half frame that the board may hold."""
        self._must_flush = True

    def configure(self) -> None:
        self._must_configure = True

    def stop(self) -> None:
        """Send two stops at once, make STOP the drive command, and forget the drive that waited."""
        self._drive = MotorDrive.STOP
        self._is_at_once = self._is_at_once or not self._stops
        self._stops = STOPS

    def drive(self, drive: MotorDrive, now: float) -> None:
        """Make ``drive`` the drive command; it replaces stops that were not sent yet."""
        if drive is not self._drive:
            self._drive, self._stops, self._is_at_once, self._repeat_at = drive, 0, False, now

    def repeat_soon(self) -> None:
        """Repeat the drive command as soon as possible: the board may have missed it."""
        self._repeat_at = -inf

    def put(self, frame: bytes) -> None:
        """Send a frame when there is time; a newer one of its type replaces it."""
        self._waiting[frame[3]] = frame

    def due(self, now: float) -> bytes | None:
        """What is to be written now, if anything. It counts as written."""
        wanted = self._wanted(now)
        if wanted is None or not self._fits(wanted, now):
            return None
        self._sent(wanted, now)
        return wanted

    def next_at(self, now: float) -> float:
        """When to ask again; ``now`` at the earliest, infinity if nothing is to be repeated."""
        if self.is_empty:
            return max(now, self._repeat_at, self._free_at, self._quiet_until)
        return max(now, self._quiet_until, -inf if self._is_at_once else self._free_at)

    def _wanted(self, now: float) -> bytes | None:
        if now < self._quiet_until:
            return None
        if self._must_flush:
            return FILLER
        if self._is_at_once and not self._must_configure:
            return STOP
        if now < self._free_at:
            return None
        if self._must_configure:
            return CONFIGURE
        if self._stops:
            return STOP
        if now >= self._repeat_at:
            return drive_frame(self._drive, self.wiring)
        return next(iter(self._waiting.values()), None)

    def _fits(self, frame: bytes, now: float) -> bool:
        """Whether the board's buffer has room for it."""
        unread = max(0.0, self._all_read_at - now) * self._config.bytes_a_second
        return unread + len(frame) <= self._config.most_outstanding

    def _sent(self, frame: bytes, now: float) -> None:
        self._all_read_at = max(self._all_read_at, now) + len(frame) / self._config.bytes_a_second
        self._free_at = now + self._config.gap
        if frame is FILLER:
            self._must_flush = False
            self._quiet_until = now + self._config.flush_pause
        elif frame is CONFIGURE:
            self._must_configure = False
        elif self._stops:
            self._stops, self._is_at_once = self._stops - 1, False
            self._repeat_at = now + self._config.repeat
        elif frame is drive_frame(self._drive, self.wiring):
            self._repeat_at = now + self._config.repeat
        else:
            del self._waiting[frame[3]]


class _Stage(Enum):
    STANDING = auto()
    STOP_SENT = auto()
    FLUSHED = auto()
    FORCED = auto()
    UNKNOWN = auto()
    """All was done that can be; the board is silent, as one that restarts."""
    FAILED = auto()
    """The wheels turn after all was done that can be."""


class StopSequence:
    """Stops one drive after the other, and watches the wheels until they stand."""

    def __init__(self, config: LinkConfig, outbox: Outbox) -> None:
        self._config = config
        self._outbox = outbox
        self._stage = _Stage.STANDING
        self._since = self._again_at = 0.0

    @property
    def is_over(self) -> bool:
        return self._stage is _Stage.STANDING

    @property
    def has_failed(self) -> bool:
        """Whether the wheels were seen to turn after every stage. The stops are repeated all the same."""
        return self._stage is _Stage.FAILED

    @property
    def is_exhausted(self) -> bool:
        """Whether all was done that can be, and its effect was waited for."""
        return self._stage in (_Stage.UNKNOWN, _Stage.FAILED)

    def begin(self, now: float, *, was_driving: bool) -> None:
        """Stop. Only a robot that was driving is watched: one that is pushed must not be reset."""
        self._outbox.stop()
        if was_driving and self.is_over:
            self._stage, self._since = _Stage.STOP_SENT, now
            self._again_at = now + self._config.stop_again

    def cancel(self) -> None:
        """The robot drives again, or its board is known to have restarted."""
        self._stage = _Stage.STANDING

    def lost(self) -> None:
        """Nothing is known of the wheels any more."""
        if self.has_failed:
            self._stage = _Stage.UNKNOWN

    def restart(self, now: float) -> None:
        """The link is back before the wheels were seen to stand: everything that can be done begins anew."""
        if not self.is_over:
            self._stage, self._since = _Stage.STOP_SENT, now

    def must_force(self, now: float, counted_at: float, changed_at: float) -> bool:
        """Check the wheels and repeat what is due. True, once, if the robot must be stopped by force now.

        ``counted_at`` and ``changed_at``: when the wheels' counts came last, and when they last changed.
        """
        if self.is_over or self._stands(now, counted_at, changed_at):
            self._stage = _Stage.STANDING
            return False
        if now >= self._again_at:
            self._again_at = now + self._config.stop_again
            self._outbox.repeat_soon()
        if self.has_failed or now - self._since < self._config.runaway:
            return False
        if self._stage in (_Stage.FORCED, _Stage.UNKNOWN):
            is_turning = now - changed_at < max(self._config.still, self._config.runaway / 2)
            self._stage = _Stage.FAILED if is_turning else _Stage.UNKNOWN
            return False
        self._since = now
        self._outbox.flush()
        self._outbox.stop()
        self._stage = _Stage.FORCED if self._stage is _Stage.FLUSHED else _Stage.FLUSHED
        return self._stage is _Stage.FORCED

    def forced(self, now: float) -> None:
        """The restart by force is over; it takes up to half a second."""
        self._since = now

    def next_at(self) -> float | None:
        """When to check again, at the latest."""
        if self.is_over:
            return None
        runaway = inf if self.is_exhausted else self._since + self._config.runaway
        return min(self._again_at, runaway)

    def _stands(self, now: float, counted_at: float, changed_at: float) -> bool:
        """Counts have come since the stop, and have been the same for a while."""
        still = self._config.still
        return counted_at - self._since >= still and now - changed_at >= still and now - counted_at < still
