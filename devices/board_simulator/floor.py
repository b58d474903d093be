"""Where a simulated robot stands, what its sensors meet there, and how its wheels move it.

Lengths in metres; angles in radians, counted to the left from east.
"""

from __future__ import annotations

from enum import Enum, auto
from math import cos, exp, pi, sin
from typing import Protocol

from msgspec import Struct

from devices.wire.frames import MotorDrive


class AxlePose(Struct, frozen=True):
    """The pose of the middle of the robot's axle."""

    x: float = 0.0
    y: float = 0.0
    yaw: float = pi / 2
    """North by default."""


class BumperSwitch(Enum):
    """The four bumper switches, by the corners of the robot; its front is N."""

    NE = auto()
    NW = auto()
    SW = auto()
    SE = auto()


class Floor(Protocol):
    """The surroundings of a board."""

    def centimetres(self, place: AxlePose, sonar: int, head: int) -> float | None:
        """What a sonar (0 to 6, the board's order) measures; ``head`` is the servo's angle. None: no echo."""

    def touched(self, place: AxlePose) -> frozenset[BumperSwitch]:
        """The bumpers that are pressed there."""

    def is_free(self, place: AxlePose) -> bool:
        """Whether the robot fits there."""


class EmptyFloor:
    """An endless floor without things."""

    def centimetres(self, place: AxlePose, sonar: int, head: int) -> float | None:  # noqa: ARG002 -- the protocol's
        return None

    def touched(self, place: AxlePose) -> frozenset[BumperSwitch]:  # noqa: ARG002
        return frozenset()

    def is_free(self, place: AxlePose) -> bool:  # noqa: ARG002
        return True


Rates = tuple[float, float]
"""Counts a second of the right wheel and of the left one."""


class Chassis(Struct, frozen=True):
    """A robot's mechanics. The default speeds are the recorded ones, made equal on both sides.

    The real board gives its wheels 115 and 120 of 255 so that the robot goes straight.
    """

    walking: Rates = (340.5, 340.5)
    walking_back: Rates = (340.5, 340.5)
    turning: Rates = (171.0, 171.0)
    lag: float = 0.025
    """Seconds in which a wheel reaches two thirds of a new speed."""
    wheel_radius: float = 0.021
    axle_length: float = 0.068
    counts_a_turn: int = 900


CHASSIS_2018 = Chassis(walking=(171.0, 171.0), walking_back=(171.0, 171.0), turning=(340.5, 340.5))
"""With the newer firmware the same frames walk at half the speed, and turn at twice the speed."""


class SimulatedWheels:
    """Two wheels, as the firmware drives them."""

    def __init__(self, chassis: Chassis, floor: Floor, place: AxlePose, seconds: float) -> None:
        """``seconds``: of one pass of the board's loop."""
        self.chassis = chassis
        self.place = place
        self.right = self.left = 0.0
        """Counts since the board started."""
        self.is_stuck = False
        """A fault: the wheels don't turn, whatever the motors do."""
        self.is_left_stuck = self.is_right_stuck = False
        """The same fault of one wheel."""
        self.encoders = (1, 1)
        """A fault where one isn't 1: -1 if the phases of the right or the left encoder are swapped."""
        self.motors = (1, 1)
        """The same for the leads of a motor."""
        self.strengths = (1.0, 1.0)
        """A fault where they differ: one wheel is slower than its motor's voltage makes it."""
        self.share = 1.0
        """Of the speed that the motors are commanded."""
        self._floor = floor
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
        """Obey the four bytes of a MOTOR frame: a wheel at zero stops both; all other speeds are the same.

        As a direction the firmware knows 0F and anything else.
        """
        right, right_speed, left, left_speed = data
        rates = {drive.value[::2]: self._rates(drive) for drive in MotorDrive if drive is not MotorDrive.STOP}
        if right_speed and left_speed:
            senses = bytes(0x0F if sense == 0x0F else 0xF0 for sense in (right, left))
            self._wanted = self._as_wired(rates[senses])
        else:
            self._wanted = (0.0, 0.0)

    def _as_wired(self, rates: Rates) -> Rates:
        right, left = (
            rate * sense * strength
            for rate, sense, strength in zip(rates, self.motors, self.strengths, strict=True)
        )
        return right, left

    def reset(self) -> None:
        """The board was reset: its motor pins are off, its counts at zero."""
        self._wanted = (0.0, 0.0)
        self.right = self.left = 0.0

    def roll(self) -> None:
        """One pass of the board's loop."""
        if self._wanted == self._speed == (0.0, 0.0):
            return
        self._speed = (self._next_speed(0), self._next_speed(1))
        if self.is_stuck:
            return
        right, left = (speed * self._seconds for speed in self._speed)
        right, left = 0.0 if self.is_right_stuck else right, 0.0 if self.is_left_stuck else left
        self.right += right * self.encoders[0]
        self.left += left * self.encoders[1]
        self._move(right * self._metres_a_count, left * self._metres_a_count)

    def _next_speed(self, wheel: int) -> float:
        wanted = self._wanted[wheel] * self.share
        speed = wanted + (self._speed[wheel] - wanted) * self._keeps
        return wanted if abs(speed - wanted) < 1.0 else speed

    def _move(self, right: float, left: float) -> None:
        ahead, turned, here = (right + left) / 2, (right - left) / self.chassis.axle_length, self.place
        middle = here.yaw + turned / 2
        there = AxlePose(here.x + ahead * cos(middle), here.y + ahead * sin(middle), here.yaw + turned)
        if self._floor.is_free(there):
            self.place = there

    def _rates(self, drive: MotorDrive) -> Rates:
        chassis = self.chassis
        match drive:
            case MotorDrive.FORWARD:
                return chassis.walking
            case MotorDrive.BACKWARD:
                return -chassis.walking_back[0], -chassis.walking_back[1]
            case MotorDrive.LEFT:
                return chassis.turning[0], -chassis.turning[1]
            case _:
                return -chassis.turning[0], chassis.turning[1]
