"""How a robot is brought to stand, and how it is known to: stops, then zeros and stops, then by force.

A stop can be lost with the half frame before it, and a board that tells nothing may be driving. So a stop is
over only once the wheels are seen to stand.
"""

from __future__ import annotations

from enum import Enum, auto
from math import inf

from devices.wire.link_config import LinkConfig
from devices.wire.outbox import Outbox

LONGEST_STOP = 1.3
"""Seconds after which all was done that can be: twice ``runaway`` and a moment, with the usual times."""


class _Stage(Enum):
    STANDING = auto()
    ASKED = auto()
    FLUSHED = auto()
    FORCED = auto()


class Stopping:
    """One stop after the other."""

    def __init__(self, config: LinkConfig, outbox: Outbox) -> None:
        self._config = config
        self._outbox = outbox
        self._stage = _Stage.STANDING
        self._since = self._again_at = 0.0

    @property
    def is_over(self) -> bool:
        return self._stage is _Stage.STANDING

    def begin(self, now: float, *, was_driving: bool) -> None:
        """Stop. Only a robot that was driving is watched, so that a pushed one is not reset."""
        self._outbox.stop()
        if was_driving and self.is_over:
            self._stage, self._since, self._again_at = _Stage.ASKED, now, now + self._config.stop_again

    def forget(self) -> None:
        """The robot drives again, or its board is known to have begun anew."""
        self._stage = _Stage.STANDING

    def goes_on(self, now: float, heard_at: float, moved_at: float) -> bool:
        """Look at the wheels. True if the robot must be stopped by force now, which is asked for once."""
        if self.is_over or self._stands(now, heard_at, moved_at):
            self._stage = _Stage.STANDING
            return False
        if now >= self._again_at:
            self._again_at = now + self._config.stop_again
            self._outbox.hurry(now)
        if self._stage is _Stage.FORCED or now - self._since < self._config.runaway:
            return False
        self._since = now
        self._outbox.flush()
        self._outbox.stop()
        self._stage = _Stage.FORCED if self._stage is _Stage.FLUSHED else _Stage.FLUSHED
        return self._stage is _Stage.FORCED

    def next_at(self) -> float | None:
        """When to look again, at the latest."""
        if self.is_over:
            return None
        runaway = inf if self._stage is _Stage.FORCED else self._since + self._config.runaway
        return min(self._again_at, runaway)

    def _stands(self, now: float, heard_at: float, moved_at: float) -> bool:
        """Frames that came after the stop, and no count for a while."""
        still = self._config.still
        return heard_at - self._since >= still and now - moved_at >= still and now - heard_at < still
