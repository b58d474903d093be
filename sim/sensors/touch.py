"""Sensors for what is close: bumpers, and the two light beams between the paddles of a gripper."""

from __future__ import annotations

from collections.abc import Iterable
from math import inf

from devices.ports.values import frozen
from sim.fittings import Gripper
from sim.geometry import Edge, along, contains, edges_apart
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
    """The beams of a gripper where it is mounted, in the robot's frame. They see what can be gripped only."""

    x: float
    y: float
    yaw: float
    length: float
    """Metres of the gripper, along the direction in which it looks."""
    width: float
    gripper: Gripper

    def broken_by(self, around: Around, spot: Spot, closed: float = 0.0) -> tuple[Part | None, Part | None]:
        """What breaks the inner and the outer beam; ``closed`` from 0, open, to 1, when the paddles meet."""
        inner, outer = (self._broken_by(around, spot, closed, inset) for inset in (0.75, 0.25))
        return inner, outer

    def _broken_by(self, around: Around, spot: Spot, closed: float, inset: float) -> Part | None:
        beam = self._beam(spot, closed, inset)
        xs, ys = (beam[0], beam[2]), (beam[1], beam[3])
        parts = around.within(min(xs), min(ys), max(xs), max(ys))
        return next((part for part in parts if part.model.grippable and _breaks(part, beam)), None)

    def _beam(self, spot: Spot, closed: float, inset: float) -> Edge:
        """A quarter and three quarters of the paddles' length from their ends, as in Stage."""
        place = spot.mounted(self.x, self.y, self.yaw)
        middle = place.ahead(self.length * (0.5 - inset * self.gripper.paddle_length), place.yaw)
        half = (1.0 - closed) * self.width * (0.5 - self.gripper.paddle_width)
        left, right = middle.ahead(half, place.yaw + 90), middle.ahead(half, place.yaw - 90)
        return left.x, left.y, right.x, right.y


def _breaks(part: Part, beam: Edge) -> bool:
    return contains(part.points, beam[0], beam[1]) or any(along(beam, edge) <= 1.0 for edge in part.outline)
