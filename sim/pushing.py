"""What a robot's way takes along: things that give way when they are pushed, and those that these push.

Rule: robot and things move as one, straight on, until one of them meets what doesn't give way. So nothing is
pushed into a wall, another robot, or what another robot holds. Turning pushes nothing.
"""

from __future__ import annotations

from collections.abc import Container, Sequence
from math import inf

from devices.ports.values import Frozen, replace
from sim.geometry import Edge, Point, direction, edges, is_beside, outline_contact, overlapping, seen_from
from sim.ground import Ground
from sim.motion import WIDEST_SKIN, Contact, Mover, less_skin
from sim.parts import Part
from sim.placement import Spot

MOST = 20
"""Things that one robot can push at a time; one more is like a wall."""
SLACK = 1e-6
"""Metres by which what may be met is searched wider than computing errs."""


class Advance(Frozen):
    """A short way straight on: how many metres of it are free, and what it takes along for how many."""

    metres: float
    pushed: tuple[tuple[int, float], ...]
    """Roots of things, and metres."""


class Pushing:
    """Short ways of one robot."""

    def __init__(self, ground: Ground, mover: Mover) -> None:
        self._ground = ground
        self._mover = mover
        self._asked: tuple[Spot, float, float, int] | None = None
        self._answer = Advance(0.0, ())

    def advance(self, spot: Spot, angle: float, length: float) -> Advance:
        """What would become of ``length`` metres (at most a step) to ``angle``; nothing moves yet."""
        asked = (spot, angle, length, self._ground.changes_for(self._mover.around.root))
        if asked != self._asked:  # a tick asks before and after the others have had their turn
            self._answer, self._asked = self._found(spot, angle, length), asked
        return self._answer

    def _found(self, spot: Spot, angle: float, length: float) -> Advance:
        done, joined = 0.0, dict[int, _Joined]()
        on_the_way = self._mover.on_the_way(spot, angle, length)
        while done < length:
            here = spot.ahead(done, angle) if done else spot
            contact = self._mover.contact_with_any(on_the_way, here, angle, joined)
            for thing in joined.values():
                contact = thing.nearer(contact, done, joined)
            if contact.metres >= length - done:
                done = length
                break
            done += contact.metres
            assert contact.part is not None
            root = contact.part.root
            if not self._gives_way(contact.part) or len(joined) == MOST:
                break
            joined[root] = self._join(root, done, angle, length - done)
        moved = ((root, done - thing.since) for root, thing in joined.items())
        return Advance(done, tuple((root, metres) for root, metres in moved if metres > 0.0))

    def take_along(self, advance: Advance, angle: float) -> None:
        """Move what the way pushes; the robot itself is moved by whoever drives it."""
        dx, dy = direction(angle)
        for root, metres in advance.pushed:
            place = self._ground.place(root)
            self._ground.put(root, replace(place, x=place.x + metres * dx, y=place.y + metres * dy))

    def _gives_way(self, part: Part) -> bool:
        return part.root in self._ground.pushable and not self._ground.is_attached(part.root)

    def _join(self, root: int, since: float, angle: float, length: float) -> _Joined:
        """A thing that is pushed from now on, ``length`` metres at most."""
        outlines = [part.points for part in self._ground.parts_of(root) if part.solid]
        others = self._in_the_way(root, outlines, length)
        mine = [_seen(points, angle) for points in outlines]
        ahead = ((part, _least_gap(mine, _seen(part.points, angle))) for part in others)
        return _Joined(since, angle, outlines, [(part, gap) for part, gap in ahead if gap < length])

    def _in_the_way(self, root: int, outlines: list[tuple[Point, ...]], length: float) -> list[Part]:
        if not outlines:
            return []
        reach = length + 2 * WIDEST_SKIN
        xs, ys = zip(*(point for points in outlines for point in points), strict=True)
        box = (min(xs) - reach, min(ys) - reach, max(xs) + reach, max(ys) + reach)
        floor = frozenset(part.rank for part in self._ground.around_start(root))
        close = self._ground.within(self._mover.around.root, *box, floor)
        return [part for part in close if part.solid and part.root != root]


class _Joined:
    """A thing that is pushed along, and what it may meet on its way: nothing farther is measured."""

    __slots__ = ("_ahead", "_angle", "_outlines", "since")

    def __init__(
        self, since: float, angle: float, outlines: list[tuple[Point, ...]], ahead: list[tuple[Part, float]]
    ) -> None:
        """``since`` so many metres of the robot's way; the parts ``ahead``, none nearer than that."""
        self.since = since
        self._angle = angle
        self._outlines = outlines
        self._ahead = ahead

    def nearer(self, nearest: Contact, done: float, joined: Container[int]) -> Contact:
        """What it meets first after ``done`` metres of the robot's way, if that is before ``nearest``."""
        moved, outlines = done - self.since, list[tuple[Point, ...]]()
        for part, gap in self._ahead:
            if gap - moved > nearest.metres or part.root in joined:
                continue
            outlines = outlines or self._moved(moved)
            apart = gap - moved + WIDEST_SKIN > SLACK
            metres = min(_gap(points, part, self._angle, apart) for points in outlines)
            if metres < nearest.metres:
                nearest = Contact(metres, part)
        return nearest

    def _moved(self, metres: float) -> list[tuple[Point, ...]]:
        dx, dy = direction(self._angle)
        return [_shifted(points, (metres * dx, metres * dy)) for points in self._outlines]


def _least_gap(mine: Sequence[Sequence[Edge]], other: Sequence[Edge]) -> float:
    """Metres along x up to which polygons surely don't touch the other one; infinity: they pass it by."""
    low, high = min(edge[1] for edge in other), max(edge[1] for edge in other)
    ends = [
        max(edge[0] for edge in edges_)
        for edges_ in mine
        if min(edge[1] for edge in edges_) <= high + SLACK and max(edge[1] for edge in edges_) >= low - SLACK
    ]
    return min(edge[0] for edge in other) - max(ends) - WIDEST_SKIN - SLACK if ends else inf


def _shifted(points: tuple[Point, ...], by: Point) -> tuple[Point, ...]:
    return tuple((x + by[0], y + by[1]) for x, y in points)


def _gap(points: tuple[Point, ...], other: Part, angle: float, apart: bool) -> float:
    """Metres that a polygon goes to ``angle`` until it meets a part; none if it reaches into it already.

    ``apart``: it is known not to.
    """
    mine, others = _seen(points, angle), _seen(other.points, angle)
    if not apart and not is_beside(mine, others) and overlapping(points, other.points):
        return 0.0
    return less_skin(*outline_contact(mine, others))


def _seen(points: tuple[Point, ...], angle: float) -> tuple[Edge, ...]:
    return edges(seen_from(points, 0.0, 0.0, angle))
