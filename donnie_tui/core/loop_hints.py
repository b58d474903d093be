"""Hints for loops that get nowhere: walks that can't begin, and a wait for a wall that isn't there.

Each is given once a run.
"""

from __future__ import annotations

from typing import Protocol, TypeGuard

from devices.ports.robot import Bearing, Robot
from donnie_tui.core.events import Moved
from donnie_tui.core.transcript import SentencePublisher

WALKS = 3
"""Walks of 0 steps by one command, without another walk between them."""
READINGS = 200
"""Readings of one distance."""


class _Simulated(Protocol):
    """A robot that knows its world."""

    @property
    def is_in_the_open(self) -> bool:
        """Whether its world has nothing that a distance sensor could ever find."""


def _knows_its_world(robot: object) -> TypeGuard[_Simulated]:
    return hasattr(robot, "is_in_the_open")


class LoopHints:
    """Counts one robot's walks and readings in a run."""

    def __init__(self, robot: Robot, sentences: SentencePublisher) -> None:
        self._robot = robot
        self._sentences = sentences
        self._command = ""
        self.begin_run()

    def begin_run(self) -> None:
        self._walks = 0
        self._readings: dict[Bearing, int] = {}

    def walked(self, moved: Moved) -> None:
        is_blocked = moved.asked > 0 and moved.walked == 0
        if not is_blocked or moved.command != self._command:
            self._walks = 0
        self._walks += is_blocked
        self._command = moved.command
        if self._walks == WALKS:
            ahead = Bearing.FRONT if moved.forward else Bearing.BACK
            steps = self._robot.known_distances().get(ahead)
            if steps is not None:
                self._sentences.announce("hint", "hint-no-nearer", steps=steps)

    def read(self, bearing: Bearing) -> None:
        self._readings[bearing] = self._readings.get(bearing, 0) + 1
        if self._readings[bearing] != READINGS or not _knows_its_world(self._robot):
            return
        if self._robot.is_in_the_open:
            self._sentences.announce("hint", "hint-no-wall")
