"""A robot's gripper: it takes a thing that is between its paddles or a step before them, and carries it.

What is held is part of the robot's body: it goes where the robot goes, bumps where it bumps, and is not seen
by its sensors. It is held as it lay; nothing jumps.
"""

from __future__ import annotations

from math import hypot

from devices.ports.robot import STEP, Grip, RobotProblem
from sim.geometry import Point, contains, nearest_on_edge, placed, seen_from
from sim.ground import Ground
from sim.motion import Mover
from sim.parts import Part
from sim.placement import Placement, Spot
from sim.sensors import Beams


class Hand:
    """The gripper of one robot, if it has one."""

    def __init__(self, mover: Mover) -> None:
        self._mover = mover
        self._ground: Ground = mover.around.ground
        self._robot = mover.around.root
        self.held: int | None = None
        """The root that it holds."""
        self._held_at = Placement()
        """Where that is in the robot's frame."""

    def grip(self, spot: Spot) -> Grip:
        """RobotProblem ``no-gripper`` if it has none."""
        beams = self._beams()
        if self.held is not None:
            return Grip.HOLDS_ALREADY
        root = self._nearest(beams, spot)
        if root is None:
            return Grip.NOTHING_THERE
        self._take(root, spot)
        return Grip.GRIPPED

    def release(self) -> Grip:
        """What was held stays where it is. RobotProblem ``no-gripper`` if it has none."""
        self._beams()
        if self.held is None:
            return Grip.HOLDS_NOTHING
        self.let_go()
        return Grip.RELEASED

    def let_go(self) -> None:
        """Hold nothing."""
        if self.held is not None:
            self._ground.attach(self.held, None)
            self.held = None
            self._mover.hold(())

    def carry(self, spot: Spot) -> None:
        """The robot is there now, and so is what it holds."""
        if self.held is not None:
            it = self._held_at
            ((x, y),) = placed(((it.x, it.y),), spot.x, spot.y, spot.yaw)
            self._ground.put(self.held, Placement(x, y, it.z, it.yaw + spot.yaw))

    def _beams(self) -> Beams:
        beams = self._mover.senses.beams
        if beams is None:
            raise RobotProblem("no-gripper")
        return beams

    def _nearest(self, beams: Beams, spot: Spot) -> int | None:
        """The root, free to be gripped, that comes nearest to the middle of the gripper."""
        place = spot.mounted(beams.x, beams.y, beams.yaw)
        near = self._mover.around.near(place.x, place.y, beams.length / 2 + beams.width + STEP)
        reached = [
            (distance, part.root)
            for part in near
            if self._is_free(part) and (distance := _distance(part, place, beams)) is not None
        ]
        return min(reached, default=(0.0, None))[1]

    def _is_free(self, part: Part) -> bool:
        return part.root in self._ground.grippable and not self._ground.is_attached(part.root)

    def _take(self, root: int, spot: Spot) -> None:
        place = self._ground.place(root)
        ((x, y),) = seen_from(((place.x, place.y),), spot.x, spot.y, spot.yaw)
        self._held_at = Placement(x, y, place.z, place.yaw - spot.yaw)
        outlines = (part.points for part in self._ground.parts_of(root) if part.solid)
        self._ground.attach(root, self._robot)
        self._mover.hold(tuple(seen_from(points, spot.x, spot.y, spot.yaw) for points in outlines))
        self.held = root


def _distance(part: Part, place: Spot, beams: Beams) -> float | None:
    """From the gripper's middle to the part, if that comes between the paddles or a step before them."""
    points = seen_from(part.points, place.x, place.y, place.yaw)
    if contains(points, 0.0, 0.0):
        return 0.0
    zone = (-beams.length / 2, -beams.width / 2, beams.length / 2 + STEP, beams.width / 2)
    clipped = _clipped(points, zone)
    if not clipped:
        return None
    pairs = zip(clipped, (*clipped[1:], clipped[0]), strict=True)
    nearest = (nearest_on_edge((*a, *b)) for a, b in pairs)
    return min(hypot(x, y) for x, y in nearest)


def _clipped(points: tuple[Point, ...], zone: tuple[float, float, float, float]) -> tuple[Point, ...]:
    """The part of a polygon within left, bottom, right and top (Sutherland and Hodgman)."""
    left, bottom, right, top = zone
    for axis, bound, sign in ((0, left, 1), (0, right, -1), (1, bottom, 1), (1, top, -1)):
        points = tuple(_beyond(points, axis, bound, sign))
    return points


def _beyond(points: tuple[Point, ...], axis: int, bound: float, sign: int) -> list[Point]:
    """The part of a polygon on one side of a line across an axis."""
    kept: list[Point] = []
    for i, after in enumerate(points):
        before = points[i - 1]
        was, now = sign * (before[axis] - bound), sign * (after[axis] - bound)
        if was < 0.0 < now or now < 0.0 < was:
            t = was / (was - now)
            kept.append((before[0] + t * (after[0] - before[0]), before[1] + t * (after[1] - before[1])))
        if now >= 0.0:
            kept.append(after)
    return kept
