"""What is close: bumpers, and the place of a gripper."""

from __future__ import annotations

from collections.abc import Iterable
from math import inf

from devices.ports.values import frozen
from sim.fittings import Gripper
from sim.geometry import Edge, contains, edges_apart
from sim.parts import Part
from sim.sensors.sight import Around
from sim.sensors.spot import Spot

TOUCH = 0.01
"""Metres: what is nearer to a bumper presses it."""


@frozen
class Bar:
    """A bumper where it is mounted, in the robot's frame: a bar across the direction in which it looks."""

    x: float
    y: float
    yaw: float
    length: float

    def is_pressed(self, around: Around, spot: Spot) -> bool:
        """Whether something solid touches it."""
        bar = self._bar(spot)
        return any(part.solid and _apart(bar, part) <= TOUCH for part in _near(around, bar))

    def _bar(self, spot: Spot) -> Edge:
        place = spot.mounted(self.x, self.y, self.yaw)
        left, right = (
            place.ahead(self.length / 2, place.yaw + 90),
            place.ahead(self.length / 2, place.yaw - 90),
        )
        return left.x, left.y, right.x, right.y


def _near(around: Around, bar: Edge) -> Iterable[Part]:
    ax, ay, bx, by = bar
    return around.within(min(ax, bx) - TOUCH, min(ay, by) - TOUCH, max(ax, bx) + TOUCH, max(ay, by) + TOUCH)


def _apart(bar: Edge, part: Part) -> float:
    if contains(part.points, bar[0], bar[1]):
        return 0.0
    return min((edges_apart(bar, edge) for edge in part.outline), default=inf)


@frozen
class Beams:
    """The two light beams of a gripper where it is mounted, in the robot's frame."""

    x: float
    y: float
    yaw: float
    length: float
    """Metres of the gripper, along the direction in which it looks."""
    width: float
    gripper: Gripper
