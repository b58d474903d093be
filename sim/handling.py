"""Moving things: pushing them, and carrying them with the gripper.

The robot and the things that it pushes move as one, straight ahead, until one of them meets an immovable
thing. So nothing is pushed into a wall, another robot, or a thing that another robot holds. Turning pushes
nothing.

The gripper takes a thing that is between its paddles or a step in front of them. A held thing is part of the
robot's body: it moves and bumps with the robot, and the robot's sensors do not see it. It keeps its
orientation.
"""

from __future__ import annotations

from collections.abc import Container, Sequence
from math import hypot

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.robot import STEP, Grip, RobotProblem
from sim.geometry import (
    Edge,
    Placement,
    Point,
    Spot,
    contains,
    direction,
    edges,
    nearest_on_edge,
    outline_contact,
    overlapping,
    passes_by,
    placed,
    seen_from,
)
from sim.ground import Ground, Moment
from sim.motion import TOUCHING, WIDEST_SKIN, Contact, Mover, less_skin
from sim.parts import Part
from sim.rangers import Bar, Beams

MOST = 20
"""Things that a robot can push at a time; one more acts like a wall."""


class Advance(Struct, frozen=True):
    """The result of a short way straight on: the free metres, and the pushed things with their metres."""

    metres: float
    pushed: tuple[tuple[int, float], ...]
    """Roots of things, and metres."""


class Pushing:
    """Short ways of one robot."""

    def __init__(self, ground: Ground, mover: Mover) -> None:
        self._ground = ground
        self._mover = mover
        self._last: tuple[tuple[Spot, float, float], Moment, Advance] | None = None
        """What was asked last, when, and the answer."""

    def advance(self, spot: Spot, angle: float, length: float) -> Advance:
        """Compute ``length`` metres (at most a step) to ``angle``; nothing moves yet."""
        asked, ground, root = (spot, angle, length), self._ground, self._mover.around.root
        # a tick asks before and after the others have had their turn
        last = self._last
        if last is None or last[0] != asked or not ground.is_unchanged(root, last[1]):
            last = self._last = asked, ground.moment(root), self._found(spot, angle, length)
        return last[2]

    def _found(self, spot: Spot, angle: float, length: float) -> Advance:
        done, joined, waiting = 0.0, dict[int, _Joined](), list[_Joined]()
        on_the_way = self._mover.on_the_way(spot, angle, length)
        while done < length:
            here = spot.ahead(done, angle) if done else spot
            contact = self._mover.contact_with_any(on_the_way, here, angle, joined)
            for thing in waiting:
                contact = thing.nearer(contact, done, joined)
            if contact.metres >= length - done - TOUCHING:
                done = length
                break
            done += contact.metres
            assert contact.part is not None
            root = contact.part.root
            if not self._gives_way(contact.part) or len(joined) == MOST:
                break
            joined[root] = self._join(root, done, angle, length - done)
            waiting = [thing for thing in (*waiting, joined[root]) if thing.may_meet_more_than(joined)]
        moved = ((root, done - thing.since) for root, thing in joined.items())
        return Advance(done, tuple((root, metres) for root, metres in moved if metres > 0.0))

    def take_along(self, advance: Advance, angle: float) -> None:
        """Move the pushed things; the caller moves the robot itself."""
        dx, dy = direction(angle)
        for root, metres in advance.pushed:
            place = self._ground.place(root)
            self._ground.put(root, replace(place, x=place.x + metres * dx, y=place.y + metres * dy))

    def _gives_way(self, part: Part) -> bool:
        return part.root in self._ground.pushable and not self._ground.is_attached(part.root)

    def _join(self, root: int, since: float, angle: float, length: float) -> _Joined:
        """Add a thing that is pushed from here on, ``length`` metres at most."""
        outlines = [part.points for part in self._ground.parts_of(root) if part.solid]
        others = self._in_the_way(root, outlines, length)
        mine = [_seen(points, angle) for points in outlines]
        seen = ((part, _seen(part.points, angle)) for part in others)
        ahead = ((part, edges_, _least_gap(mine, edges_)) for part, edges_ in seen)
        return _Joined(
            since, angle, outlines, mine, [each for each in ahead if each[2] - WIDEST_SKIN < length]
        )

    def _in_the_way(self, root: int, outlines: list[tuple[Point, ...]], length: float) -> list[Part]:
        if not outlines:
            return []
        reach = length + WIDEST_SKIN
        xs, ys = zip(*(point for points in outlines for point in points), strict=True)
        box = (min(xs) - reach, min(ys) - reach, max(xs) + reach, max(ys) + reach)
        floor = frozenset(part.rank for part in self._ground.around_start(root))
        close = self._ground.within(self._mover.around.root, *box, floor)
        return [part for part in close if part.solid and part.root != root]


class _Joined:
    """A pushed thing, and the parts that it may meet on its way."""

    __slots__ = ("_ahead", "_angle", "_mine", "_outlines", "since")

    def __init__(
        self,
        since: float,
        angle: float,
        outlines: list[tuple[Point, ...]],
        mine: list[tuple[Edge, ...]],
        ahead: list[tuple[Part, tuple[Edge, ...], float]],
    ) -> None:
        """``since``: metres of the robot's way where it begins; ``ahead``: parts, each with its gap.

        ``mine`` and the edges of the parts are seen along the way.
        """
        self.since = since
        self._angle = angle
        self._outlines = outlines
        self._mine = mine
        self._ahead = ahead

    def may_meet_more_than(self, joined: Container[int]) -> bool:
        """Whether it may meet something that isn't pushed yet."""
        return any(part.root not in joined for part, _, _ in self._ahead)

    def nearer(self, nearest: Contact, done: float, joined: Container[int]) -> Contact:
        """The first contact after ``done`` metres of the robot's way, if it is before ``nearest``."""
        moved = done - self.since
        outlines, mine = self._outlines, self._mine
        for part, others, gap in self._ahead:
            if gap - WIDEST_SKIN - moved > nearest.metres or part.root in joined:
                continue
            if moved and outlines is self._outlines:
                outlines = self._moved(moved)
                mine = [_seen(points, self._angle) for points in outlines]
            pairs, apart = zip(outlines, mine, strict=True), gap > moved
            metres = min(_gap(points, seen, part, others, apart) for points, seen in pairs)
            if metres < nearest.metres:
                nearest = Contact(metres, part)
        return nearest

    def _moved(self, metres: float) -> list[tuple[Point, ...]]:
        dx, dy = (metres * each for each in direction(self._angle))
        return [tuple((x + dx, y + dy) for x, y in points) for points in self._outlines]


def _least_gap(mine: Sequence[Sequence[Edge]], other: Sequence[Edge]) -> float:
    """Metres along x up to which polygons surely don't touch the other one; below 0 where they might."""
    return min(edge[0] for edge in other) - max(edge[0] for edges_ in mine for edge in edges_)


def _gap(
    points: tuple[Point, ...], mine: Sequence[Edge], other: Part, others: Sequence[Edge], apart: bool
) -> float:
    """Metres that a polygon can move until it meets a part; none if it reaches into it already.

    ``mine``, ``others``: their edges, seen along the way. ``apart``: they are known not to overlap.
    """
    if not apart and not passes_by(mine, others) and overlapping(points, other.points):
        return 0.0
    return less_skin(*outline_contact(mine, others))


def _seen(points: tuple[Point, ...], angle: float) -> tuple[Edge, ...]:
    return edges(seen_from(points, 0.0, 0.0, angle))


class Hand:
    """The gripper of one robot, if it has one."""

    def __init__(self, mover: Mover) -> None:
        self._mover = mover
        self._ground: Ground = mover.around.ground
        self._robot = mover.around.root
        self.held: int | None = None
        """The held root."""
        self._held_at = Placement()
        """The place of the held root in the robot's frame."""

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
        """Release the held thing at its place. RobotProblem ``no-gripper`` if the robot has none."""
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

    def beams_broken(self, spot: Spot) -> tuple[bool, bool]:
        """Whether something is in the outer beam, at the tips of the paddles, and in the inner one."""
        if self.held is not None:
            return True, True
        beams, around = self._beams(), self._mover.around
        tips = Spot(beams.x, beams.y, beams.yaw).ahead(beams.length / 2, beams.yaw)
        places = ((tips.x, tips.y), (beams.x, beams.y))
        bars = (Bar(*at, beams.yaw, beams.width) for at in places)
        outer, inner = (bar.is_pressed(around, spot, self._ground.grippable) for bar in bars)
        return outer, inner

    def carry(self, spot: Spot) -> None:
        """Move the held thing with the robot, which is at ``spot``."""
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
        """The grippable root nearest to the middle of the gripper."""
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
    """The distance from the gripper's middle to a part between the paddles or a step before them."""
    points = seen_from(part.points, place.x, place.y, place.yaw)
    if contains(points, 0.0, 0.0):
        return 0.0
    zone = (-beams.length / 2, -beams.width / 2, beams.length / 2 + STEP, beams.width / 2)
    clipped = _clipped(points, zone)
    if not clipped:
        return None
    return min(hypot(*nearest_on_edge(edge)) for edge in edges(clipped))


def _clipped(points: tuple[Point, ...], zone: tuple[float, float, float, float]) -> tuple[Point, ...]:
    """The part of a polygon within left, bottom, right and top (Sutherland and Hodgman)."""
    left, bottom, right, top = zone
    for axis, least, most in ((0, left, right), (1, bottom, top)):
        points = tuple(_beyond(points, axis, least, is_least=True))
        points = tuple(_beyond(points, axis, most, is_least=False))
    return points


def _beyond(points: tuple[Point, ...], axis: int, bound: float, is_least: bool) -> list[Point]:
    """The part of a polygon on one side of a line across an axis, which is the least or the most there."""
    sides = [each[axis] - bound if is_least else bound - each[axis] for each in points]
    kept: list[Point] = []
    for i, (after, now) in enumerate(zip(points, sides, strict=True)):
        before, was = points[i - 1], sides[i - 1]
        if (was < 0.0) != (now < 0.0):
            t = was / (was - now)
            kept.append((before[0] + t * (after[0] - before[0]), before[1] + t * (after[1] - before[1])))
        if now >= 0.0:
            kept.append(after)
    return kept
