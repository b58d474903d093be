"""Where the robot is, and which way it should look, from the counts of its wheels."""

from __future__ import annotations

import threading
from math import cos, degrees, pi, radians, sin

from devices.ports.robot import STEP, Pose
from devices.serial_robot.config import RobotConfig
from devices.wire.commands import MotorDrive
from devices.wire.connection import travelled
from devices.wire.telemetry import Telemetry

MOST_DEVIATION = 180.0
"""Counts, some 45 degrees, that a turn corrects; with more, the robot was carried somewhere else."""
TURNED_BY_HAND = 8.0
"""Counts between two movements above which a person turned the robot; fewer are wheels that roll out."""


class WheelOdometry:
    """Dead reckoning from the start pose. Any thread may ask. Metres and radians inside."""

    def __init__(self, config: RobotConfig) -> None:
        self._metres_a_count = 2 * pi * config.wheel_radius / config.counts_a_turn
        self._axle = config.axle_length
        self._lock = threading.Lock()
        self._right = self._left = 0
        self._x = self._y = 0.0
        self._yaw = pi / 2

    def begin(self, telemetry: Telemetry, start: Pose) -> None:
        """The robot is at ``start``, with the present counts."""
        with self._lock:
            self._right, self._left = telemetry.right, telemetry.left
            self._x, self._y, self._yaw = start.x * STEP, start.y * STEP, radians(90.0 - start.heading)

    def follow(self, telemetry: Telemetry) -> Pose:
        """The pose after the movement of the wheels since the last call."""
        with self._lock:
            right = (telemetry.right - self._right) * self._metres_a_count
            left = (telemetry.left - self._left) * self._metres_a_count
            self._right, self._left = telemetry.right, telemetry.left
            turned = (right - left) / self._axle
            ahead, middle = (right + left) / 2, self._yaw + turned / 2
            self._x += ahead * cos(middle)
            self._y += ahead * sin(middle)
            self._yaw += turned
            heading = round((90.0 - degrees(self._yaw)) % 360.0, 3) % 360.0
            return Pose(round(self._x / STEP, 3) + 0.0, round(self._y / STEP, 3) + 0.0, heading)


class HeadingTracker:
    """The heading that the commanded turns add up to, against the one that the wheels report.

    A turn corrects the difference: what the last turn overshot, and what uneven wheels added in a walk. But
    where a hand, a collision or a lost link turned the robot, its new heading is accepted. All values are
    counts of each wheel, to the right. Only for the program's thread.
    """

    def __init__(self, telemetry: Telemetry) -> None:
        self.begin(telemetry)

    def begin(self, telemetry: Telemetry) -> None:
        """Accept the present heading as the wanted one."""
        self._wanted = self._last = _turned(telemetry)

    def deviation(self, telemetry: Telemetry) -> float:
        """By how much the robot looks too far to the right, as a movement begins."""
        now = _turned(telemetry)
        if abs(now - self._last) > TURNED_BY_HAND:
            self._wanted += now - self._last
        if abs(now - self._wanted) > MOST_DEVIATION:
            self._wanted = now
        self._last = now
        return now - self._wanted

    def finished(self, counts: float, telemetry: Telemetry) -> None:
        """A movement has ended that was to turn the robot by ``counts``: 0 for a walk."""
        self._wanted += counts
        self._last = _turned(telemetry)


def _turned(telemetry: Telemetry) -> float:
    return travelled(MotorDrive.RIGHT, telemetry.right, telemetry.left)
