"""What is told while the robot moves: each whole step, or each ten degrees and the rest, once and in time."""

from __future__ import annotations

from collections.abc import Callable

from devices.ports.robot import Motion, Pose

LACKING = 0.05
"""Of a step or a degree, that a whole one may lack and still be done."""


def whole(units: float) -> int:
    """The whole steps or degrees of what was done; never less than none."""
    return max(0, int(units + LACKING))


class Progress:
    """Of one movement of ``amount`` steps or degrees; ``every`` so many are told."""

    def __init__(self, motion: Motion, amount: int, every: int, tell: Callable[[Motion, Pose], None]) -> None:
        self._motion, self._amount, self._every, self._tell = motion, amount, every, tell
        self._told = 0

    def reached(self, units: float, pose: Pose) -> None:
        """So many were done by now, and the robot is there."""
        while (following := min(self._amount, self._told + self._every)) > self._told:
            if whole(units) < following:
                return
            self._told = following
            self._tell(self._motion, pose)
