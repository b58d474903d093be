"""Where a simulated board is, and what its sensors meet there. Metres; radians, to the left from east."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum
from math import atan2, cos, hypot, pi, radians, sin
from typing import Protocol

from devices.ports.values import Frozen


class Place(Frozen):
    """Of the middle of the robot's axle."""

    x: float = 0.0
    y: float = 0.0
    yaw: float = pi / 2
    """North, as the robot begins."""


class Switch(Enum):
    """The four bumpers, with the angle from the robot's front at which each sits."""

    NE = -pi / 4
    NW = pi / 4
    SW = 3 * pi / 4
    SE = -3 * pi / 4


class Surroundings(Protocol):
    """What a board stands in."""

    def centimetres(self, place: Place, sonar: int, head: int) -> float | None:
        """What a sonar (0 to 6, the board's order) measures; ``head`` is the servo's angle. None: no echo."""

    def touched(self, place: Place) -> frozenset[Switch]:
        """The bumpers that are pressed there."""

    def is_free(self, place: Place) -> bool:
        """Whether the robot fits there."""


class OpenFloor:
    """Nothing, anywhere."""

    def centimetres(self, place: Place, sonar: int, head: int) -> float | None:  # noqa: ARG002 -- the protocol's
        return None

    def touched(self, place: Place) -> frozenset[Switch]:  # noqa: ARG002
        return frozenset()

    def is_free(self, place: Place) -> bool:  # noqa: ARG002
        return True


Segment = tuple[float, float, float, float]
"""A wall from x, y to x, y."""

SONAR_DEGREES = (-45, 0, 45, 135, 180, -135)
"""Where the original's sonars 0 to 5 look, to the left of the robot's front; 6 is on the head."""


class Walls:
    """Straight walls on an open floor, around a round robot; each sonar is one ray from its hull."""

    def __init__(self, segments: Sequence[Segment], radius: float = 0.0) -> None:
        """``radius``: of the robot, from which its sonars measure and at which it touches."""
        self._segments = tuple(segments)
        self._radius = radius

    def centimetres(self, place: Place, sonar: int, head: int) -> float | None:
        left = 90 - head if sonar >= len(SONAR_DEGREES) else SONAR_DEGREES[sonar]
        angle = place.yaw + radians(left)
        met = [far for each in self._segments if (far := _along(place, angle, each)) is not None]
        return max(0.0, (min(met) - self._radius) * 100) if met else None

    def touched(self, place: Place) -> frozenset[Switch]:
        directions = [
            _turned(atan2(y - place.y, x - place.x) - place.yaw)
            for x, y in (_nearest(place, each) for each in self._segments)
            if hypot(x - place.x, y - place.y) <= self._radius + TOUCH
        ]
        return frozenset(s for s in Switch for d in directions if abs(_turned(d - s.value)) <= pi / 4 + 1e-3)

    def is_free(self, place: Place) -> bool:
        near = (_nearest(place, each) for each in self._segments)
        return all(hypot(x - place.x, y - place.y) >= self._radius for x, y in near)


TOUCH = 0.003
"""Metres before a wall at which a bumper is pressed."""


def _along(place: Place, angle: float, wall: Segment) -> float | None:
    """How far the ray goes until it meets the wall."""
    x, y, to_x, to_y = wall
    dx, dy, wx, wy = cos(angle), sin(angle), to_x - x, to_y - y
    across = dx * wy - dy * wx
    if abs(across) < 1e-12:
        return None
    far = ((x - place.x) * wy - (y - place.y) * wx) / across
    share = ((x - place.x) * dy - (y - place.y) * dx) / across
    return far if far >= 0 and 0 <= share <= 1 else None


def _nearest(place: Place, wall: Segment) -> tuple[float, float]:
    x, y, to_x, to_y = wall
    wx, wy = to_x - x, to_y - y
    length = wx * wx + wy * wy
    share = ((place.x - x) * wx + (place.y - y) * wy) / length if length else 0.0
    share = min(1.0, max(0.0, share))
    return x + share * wx, y + share * wy


def _turned(angle: float) -> float:
    """The same direction, -pi to pi."""
    return (angle + pi) % (2 * pi) - pi
