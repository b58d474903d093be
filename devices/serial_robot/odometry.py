"""Where the robot is, from how far its wheels went. Metres and radians inside, steps and degrees outside."""

from __future__ import annotations

import threading
from math import cos, degrees, pi, radians, sin

from devices.ports.robot import STEP, Pose
from devices.serial_robot.config import RobotConfig
from devices.wire.telemetry import Telemetry


class Odometry:
    """Dead reckoning: it follows the counts from wherever it was begun. Any thread may ask."""

    def __init__(self, config: RobotConfig) -> None:
        self._metres = 2 * pi * config.wheel_radius / config.counts_a_turn
        self._axle = config.axle_length
        self._lock = threading.Lock()
        self._right = self._left = 0
        self._x = self._y = 0.0
        self._yaw = pi / 2

    def begin(self, telemetry: Telemetry, start: Pose) -> None:
        """The robot is at its start, and its wheels are where they are."""
        with self._lock:
            self._right, self._left = telemetry.right, telemetry.left
            self._x, self._y, self._yaw = start.x * STEP, start.y * STEP, radians(90.0 - start.heading)

    def follow(self, telemetry: Telemetry) -> Pose:
        """Go as the wheels went since it was last asked."""
        with self._lock:
            right = (telemetry.right - self._right) * self._metres
            left = (telemetry.left - self._left) * self._metres
            self._right, self._left = telemetry.right, telemetry.left
            self._go(right, left)
            return self._pose()

    def _go(self, right: float, left: float) -> None:
        turned = (right - left) / self._axle
        ahead, middle = (right + left) / 2, self._yaw + turned / 2
        self._x += ahead * cos(middle)
        self._y += ahead * sin(middle)
        self._yaw += turned

    def _pose(self) -> Pose:
        heading = round((90.0 - degrees(self._yaw)) % 360.0, 3) % 360.0
        return Pose(round(self._x / STEP, 3) + 0.0, round(self._y / STEP, 3) + 0.0, heading)
