"""Straight walls around a simulated board, as its sonars and bumpers meet them. Lengths in metres."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2, cos, hypot, pi, radians, sin

from devices.board_simulator.floor import AxlePose, BumperSwitch

Segment = tuple[float, float, float, float]
"""A wall from x, y to x, y."""

SONAR_DEGREES = (-45, 0, 45, 135, 180, -135)
"""Directions of the original's sonars 0 to 5, to the left of the robot's front; sonar 6 is on the head."""

SWITCH_DEGREES = {
    BumperSwitch.NW: 45,
    BumperSwitch.NE: -45,
    BumperSwitch.SW: 135,
    BumperSwitch.SE: -135,
}
"""Directions of the switches, counted in the same way."""

TOUCH = 0.003
"""Metres from a wall at which a bumper is pressed."""


class WalledFloor:
    """Straight walls around a round robot; each sonar is one ray from its hull."""

    def __init__(self, segments: Sequence[Segment], radius: float = 0.0) -> None:
        """``radius``: of the robot's hull, from which its sonars measure and at which it touches."""
        self._segments = tuple(segments)
        self._radius = radius

    def centimetres(self, place: AxlePose, sonar: int, head: int) -> float | None:
        left = 90 - head if sonar >= len(SONAR_DEGREES) else SONAR_DEGREES[sonar]
        angle = place.yaw + radians(left)
        met = [far for each in self._segments if (far := _distance_along(place, angle, each)) is not None]
        return max(0.0, (min(met) - self._radius) * 100) if met else None

    def touched(self, place: AxlePose) -> frozenset[BumperSwitch]:
        directions = [
            _wrapped(atan2(y - place.y, x - place.x) - place.yaw)
            for x, y in (_nearest(place, each) for each in self._segments)
            if hypot(x - place.x, y - place.y) <= self._radius + TOUCH
        ]
        return frozenset(
            switch
            for switch, degrees in SWITCH_DEGREES.items()
            for direction in directions
            if abs(_wrapped(direction - radians(degrees))) <= pi / 4 + 1e-3
        )

    def is_free(self, place: AxlePose) -> bool:
        near = (_nearest(place, each) for each in self._segments)
        return all(hypot(x - place.x, y - place.y) >= self._radius for x, y in near)


def _distance_along(place: AxlePose, angle: float, wall: Segment) -> float | None:
    """How far a ray in that direction goes until it meets the wall."""
    x, y, to_x, to_y = wall
    dx, dy, wx, wy = cos(angle), sin(angle), to_x - x, to_y - y
    across = dx * wy - dy * wx
    if abs(across) < 1e-12:
        return None
    far = ((x - place.x) * wy - (y - place.y) * wx) / across
    share = ((x - place.x) * dy - (y - place.y) * dx) / across
    return far if far >= 0 and 0 <= share <= 1 else None


def _nearest(place: AxlePose, wall: Segment) -> tuple[float, float]:
    """The point of the wall that is nearest."""
    x, y, to_x, to_y = wall
    wx, wy = to_x - x, to_y - y
    length = wx * wx + wy * wy
    share = ((place.x - x) * wx + (place.y - y) * wy) / length if length else 0.0
    share = min(1.0, max(0.0, share))
    return x + share * wx, y + share * wy


def _wrapped(angle: float) -> float:
    """The same direction, -pi to pi."""
    return (angle + pi) % (2 * pi) - pi
