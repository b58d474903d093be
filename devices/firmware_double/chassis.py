"""The wheels under a simulated board: how fast they turn, how far they roll on, and where that leads."""

from __future__ import annotations

from math import cos, exp, pi, sin

from devices.firmware_double.surroundings import Place, Surroundings
from devices.ports.values import Frozen
from devices.wire.commands import Drive

Rates = tuple[float, float]
"""Counts a second of the right wheel and of the left one."""


class Chassis(Frozen):
    """A robot's mechanics. Lengths in metres. The speeds are the ones recorded, made equal on both sides: the
    real board gives its wheels 115 and 120 of 255 so that the robot goes straight."""

    walking: Rates = (340.5, 340.5)
    walking_back: Rates = (340.5, 340.5)
    turning: Rates = (171.0, 171.0)
    lag: float = 0.025
    """Seconds in which a wheel comes to two thirds of a new speed."""
    wheel_radius: float = 0.021
    axle_length: float = 0.068
    counts_a_turn: int = 900


class Wheels:
    """Two wheels, as the firmware drives them."""

    def __init__(self, chassis: Chassis, surroundings: Surroundings, place: Place, seconds: float) -> None:
        """``seconds``: of one pass of the board's loop."""
        self.place = place
        self.right = self.left = 0.0
        """Counts since the board began."""
        self.is_stuck = False
        """A fault: the wheels don't turn, whatever the motors do."""
        self.is_left_stuck = self.is_right_stuck = False
        """The same of one of them."""
        self._surroundings = surroundings
        self._chassis = chassis
        self._seconds = seconds
        self._keeps = exp(-seconds / chassis.lag)
        self._metres_a_count = 2 * pi * chassis.wheel_radius / chassis.counts_a_turn
        self._wanted: Rates = (0.0, 0.0)
        self._speed: Rates = (0.0, 0.0)

    @property
    def is_driven(self) -> bool:
        """Whether the motors are on."""
        return self._wanted != (0.0, 0.0)

    def drive(self, data: bytes) -> None:
        """Four bytes of a MOTOR frame: a wheel at zero stops both; other speeds are all the same."""
        right, right_speed, left, left_speed = data
        wanted = {drive.value[::2]: self._rates(drive) for drive in Drive if drive is not Drive.STOP}
        if right_speed and left_speed:
            self._wanted = wanted.get(bytes((right, left)), self._wanted)
        else:
            self._wanted = (0.0, 0.0)

    def off(self) -> None:
        """The board was reset: its pins float."""
        self._wanted = (0.0, 0.0)
        self.right = self.left = 0.0

    def roll(self) -> None:
        """One pass of the board's loop."""
        if self._wanted == self._speed == (0.0, 0.0):
            return
        self._speed = (self._nearer(0), self._nearer(1))
        if self.is_stuck:
            return
        right, left = (speed * self._seconds for speed in self._speed)
        right, left = 0.0 if self.is_right_stuck else right, 0.0 if self.is_left_stuck else left
        self.right += right
        self.left += left
        self._go(right * self._metres_a_count, left * self._metres_a_count)

    def _nearer(self, wheel: int) -> float:
        wanted = self._wanted[wheel]
        speed = wanted + (self._speed[wheel] - wanted) * self._keeps
        return wanted if abs(speed - wanted) < 1.0 else speed

    def _go(self, right: float, left: float) -> None:
        ahead, turned, here = (right + left) / 2, (right - left) / self._chassis.axle_length, self.place
        middle = here.yaw + turned / 2
        there = Place(here.x + ahead * cos(middle), here.y + ahead * sin(middle), here.yaw + turned)
        if self._surroundings.is_free(there):
            self.place = there

    def _rates(self, drive: Drive) -> Rates:
        chassis = self._chassis
        match drive:
            case Drive.FORWARD:
                return chassis.walking
            case Drive.BACKWARD:
                return -chassis.walking_back[0], -chassis.walking_back[1]
            case Drive.LEFT:
                return chassis.turning[0], -chassis.turning[1]
            case _:
                return -chassis.turning[0], chassis.turning[1]
