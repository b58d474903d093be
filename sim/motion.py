"""How far a robot gets: walks and turns of one body among things that stand still, computed at once.

Nothing is stepped through where the way is free: a thin ray through thickened bodies finds the first step
that needs a closer look. ``careful`` looks at every step; both give the same (a property test holds it).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import floor, hypot, inf

from devices.ports.robot import STEP, Bearing, StoppedBy
from sim.geometry import (
    Edge,
    Point,
    contains,
    disc_contact,
    edges,
    nearest_on_edge,
    outline_contact,
    overlapping,
    placed,
    seen_from,
    turn_contact,
)
from sim.physics import Part, Surroundings
from sim.scene import Scene
from sim.sensors import CENTIMETRES_A_STEP, Ranger, Senses, Spot

SKIN = 1e-4
"""Metres that a robot keeps from what it bumped into, so that it can turn and leave."""
ROUND = 0.9
"""A body whose inner circle is at least this part of its outer one turns like a disc, in the outer one."""


STEPS_A_QUESTION = 100
"""Steps that need a closer look, between two questions whether to go on: some hundredths of a second."""

Going = Callable[[], bool]


def _always() -> bool:
    return True


@dataclass(frozen=True, slots=True)
class Body:
    """What of a robot bumps into things, in its own frame."""

    polygons: tuple[tuple[Point, ...], ...]
    radius: float
    """Metres from its centre of rotation to its farthest point."""
    is_round: bool

    def outline(self, angle: float) -> tuple[Edge, ...]:
        """Its edges when it looks to ``angle``, around the origin."""
        return tuple(edge for points in self.polygons for edge in edges(placed(points, 0.0, 0.0, angle)))


def body_of(scene: Scene, robot: int) -> Body:
    """The robot's own shape, solid whatever its file says, and everything solid that is attached to it."""
    frame = scene.models[robot].pose
    solid = (model for model in scene.tree(robot) if model.solid or model.index == robot)
    outlines = (points for model in solid for points in model.outlines())
    polygons = tuple(seen_from(points, frame.x, frame.y, frame.yaw) for points in outlines)
    radius = max((hypot(x, y) for points in polygons for x, y in points), default=0.0)
    inner = max((_inner_radius(points) for points in polygons), default=0.0)
    return Body(polygons, radius, inner >= ROUND * radius)


def _inner_radius(points: tuple[Point, ...]) -> float:
    if not contains(points, 0.0, 0.0):
        return 0.0
    return min(hypot(*nearest_on_edge(edge)) for edge in edges(points))


@dataclass(frozen=True, slots=True)
class Walk:
    """What becomes of a walk."""

    metres: float
    steps: int
    stopped_by: StoppedBy | None


class Mover:
    """One robot's body and senses among its surroundings."""

    def __init__(self, around: Surroundings, body: Body, senses: Senses) -> None:
        self._around = around
        self._body = body
        self._cones = {bearing: senses.at(bearing) for bearing in (Bearing.FRONT, Bearing.BACK)}

    def walk(
        self, start: Spot, bearing: Bearing, steps: int, going: Going = _always, careful: bool = False
    ) -> Walk:
        """Up to ``steps`` steps forward or backward: ``bearing`` is FRONT or BACK.

        Beside a very long wall this takes its time: ``going`` is asked now and then whether to go on; if
        not, the walk does not happen.
        """
        angle = start.yaw + (180.0 if bearing is Bearing.BACK else 0.0)
        done = 0
        while done < steps:
            here = start.ahead(done * STEP, angle)
            free = 0 if careful else self._free_steps(here, angle, steps - done)
            if free:
                done += free
                continue
            if done % STEPS_A_QUESTION == STEPS_A_QUESTION - 1 and not going():
                return Walk(0.0, 0, StoppedBy.USER)
            if self._is_blocked(here, bearing):
                return Walk(done * STEP, done, StoppedBy.OBSTACLE)
            contact = self.contact(here, angle)
            if contact < STEP:
                return Walk(done * STEP + contact, done, StoppedBy.COLLISION)
            done += 1
        return Walk(steps * STEP, steps, None)

    def turn(self, spot: Spot, degrees: int) -> int:
        """How many of ``degrees`` (counter-clockwise if positive) the robot can turn, whole ones."""
        if self._body.is_round or degrees == 0:
            return degrees
        sign = 1 if degrees > 0 else -1
        outline, nearest = self._body.outline(spot.yaw), inf
        for part in self._touchable(spot, self._body.radius):
            if not self._overlaps(spot, part):
                shifted = edges(seen_from(part.points, spot.x, spot.y, 0.0))
                nearest = min(nearest, turn_contact(outline, shifted, sign))
        if nearest >= abs(degrees):
            return degrees
        return sign * max(0, floor(nearest - 0.02))

    def contact(self, spot: Spot, angle: float) -> float:
        """Metres to the first contact on the step that goes to ``angle``; infinity if there is none."""
        middle = spot.ahead(STEP / 2, angle)
        nearest = inf
        for part in self._touchable(middle, self._body.radius + STEP / 2 + 2 * SKIN):
            nearest = min(nearest, self._contact_with(part, spot, angle))
        return nearest

    def _contact_with(self, part: Part, spot: Spot, angle: float) -> float:
        obstacle = edges(seen_from(part.points, spot.x, spot.y, angle))
        if self._body.is_round or self._overlaps(spot, part):
            return min(disc_contact(self._body.radius + SKIN, edge) for edge in obstacle)
        contact, squarely = outline_contact(self._body.outline(spot.yaw - angle), obstacle)
        return max(0.0, contact - min(0.005, SKIN / max(squarely, 1e-9)))

    def _touchable(self, spot: Spot, reach: float) -> list[Part]:
        return [part for part in self._around.near(spot.x, spot.y, reach) if part.solid]

    def _overlaps(self, spot: Spot, part: Part) -> bool:
        """Whether the robot already reaches into the thing: its world put it there. It may only leave."""
        mine = (placed(points, spot.x, spot.y, spot.yaw) for points in self._body.polygons)
        return any(overlapping(points, part.points) for points in mine)

    def _free_steps(self, here: Spot, angle: float, steps: int) -> int:
        there = here.ahead(steps * STEP, angle)
        part = self._around.free_way(here.x, here.y, there.x, there.y)
        return steps if part >= 1.0 else floor(part * steps)

    def _is_blocked(self, spot: Spot, bearing: Bearing) -> bool:
        """Whether the next step would leave less than one step of free space before a sensor."""
        readings = (cone.centimetres(self._around, spot) for cone in self._cones[bearing])
        return any(reading is not None and reading < 2 * CENTIMETRES_A_STEP for reading in readings)


def guard_distance(body: Body, rangers: tuple[Ranger, ...]) -> float:
    """Metres from its centre beyond which nothing touches a robot within a step, nor blocks its sensors."""
    farthest = max((hypot(each.x, each.y) for each in rangers), default=0.0)
    return max(body.radius + STEP, farthest + 2 * STEP) + 0.01
