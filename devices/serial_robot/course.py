"""Which way the robot is to look by the turns that were asked for, against what its wheels say that it does.

A turn makes up for the difference: what the last one went too far, and what a walk between them was uneven
by. But where a hand, a collision or a lost line turned the robot, it is taken as it stands.
"""

from __future__ import annotations

from devices.wire.commands import Drive
from devices.wire.connection import travelled
from devices.wire.telemetry import Telemetry

MOST_ASTRAY = 180.0
"""Counts, some 45 degrees, that a turn makes up for; more, and the robot has been somewhere else."""
BY_HAND = 8.0
"""Counts between two movements from which on somebody turned the robot; less are wheels coming to rest."""


class Course:
    """All in counts of each wheel, to the right. The program's thread's."""

    def __init__(self, telemetry: Telemetry) -> None:
        self.begin(telemetry)

    def begin(self, telemetry: Telemetry) -> None:
        """As it looks now is how it is to look."""
        self._wanted = self._left_at = _turned(telemetry)

    def astray(self, telemetry: Telemetry) -> float:
        """By how much it looks too far to the right, as a movement begins."""
        now = _turned(telemetry)
        if abs(now - self._left_at) > BY_HAND:
            self._wanted += now - self._left_at
        if abs(now - self._wanted) > MOST_ASTRAY:
            self._wanted = now
        self._left_at = now
        return now - self._wanted

    def went(self, counts: float, telemetry: Telemetry) -> None:
        """A movement came to its end, and so much was asked for: none of a walk."""
        self._wanted += counts
        self._left_at = _turned(telemetry)


def _turned(telemetry: Telemetry) -> float:
    return travelled(Drive.RIGHT, telemetry.right, telemetry.left)
