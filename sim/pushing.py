"""What a robot's way takes along: things that give way when they are pushed, and those that these push.

Rule: robot and things move as one, straight on, until one of them meets what doesn't give way. So nothing is
pushed into a wall, another robot, or what another robot holds. Turning pushes nothing.
"""

from __future__ import annotations

from dataclasses import replace

from devices.ports.values import frozen
from sim.geometry import Edge, Point, direction, edges, outline_contact, overlapping, seen_from
from sim.ground import Ground
from sim.motion import NO_CONTACT, WIDEST_SKIN, Contact, Mover, less_skin
from sim.parts import Part
from sim.sensors import Spot

MOST = 20
"""Things that one robot can push at a time; one more is like a wall."""


@frozen
class Advance:
    """A short way straight on: how many metres of it are free, and what it takes along for how many."""

    metres: float
    pushed: tuple[tuple[int, float], ...]
    """Roots of things, and metres."""


class Pushing:
    """Short ways of one robot."""

    def __init__(self, ground: Ground, mover: Mover) -> None:
        self._ground = ground
        self._mover = mover

    def advance(self, spot: Spot, angle: float, length: float) -> Advance:
        """What would become of ``length`` metres (at most a step) to ``angle``; nothing moves yet."""
        done, joined = 0.0, dict[int, float]()
        while done < length:
            contact = self._contact(spot, angle, done, length - done, joined)
            if contact.metres >= length - done:
                done = length
                break
            done += contact.metres
            assert contact.part is not None
            root = contact.part.root
            if not self._gives_way(contact.part) or len(joined) == MOST:
                break
            joined[root] = done
        return Advance(done, tuple((root, done - since) for root, since in joined.items() if done > since))

    def take_along(self, advance: Advance, angle: float) -> None:
        """Move what the way pushes; the robot itself is moved by whoever drives it."""
        dx, dy = direction(angle)
        for root, metres in advance.pushed:
            place = self._ground.place(root)
            self._ground.put(root, replace(place, x=place.x + metres * dx, y=place.y + metres * dy))

    def _gives_way(self, part: Part) -> bool:
        return part.root in self._ground.pushable and not self._ground.is_attached(part.root)

    def _contact(
        self, spot: Spot, angle: float, done: float, length: float, joined: dict[int, float]
    ) -> Contact:
        """What the robot, or something that it pushes, meets first after ``done`` metres."""
        here = spot.ahead(done, angle) if done else spot
        nearest = self._mover.contact(here, angle, length, but=joined.keys())
        for root, since in joined.items():
            met = self._contact_of_thing(root, angle, done - since, length, joined)
            if met.metres < nearest.metres:
                nearest = met
        return nearest

    def _contact_of_thing(
        self, root: int, angle: float, moved: float, length: float, joined: dict[int, float]
    ) -> Contact:
        """What a thing meets first that was pushed ``moved`` metres from where the ground has it."""
        dx, dy = direction(angle)
        shift = moved * dx, moved * dy
        outlines = [_shifted(part, shift) for part in self._ground.parts_of(root) if part.solid]
        nearest = NO_CONTACT
        for other in self._in_the_way(root, outlines, length, joined):
            metres = min(_gap(points, other, angle) for points in outlines)
            if metres < nearest.metres:
                nearest = Contact(metres, other)
        return nearest

    def _in_the_way(
        self, root: int, outlines: list[tuple[Point, ...]], length: float, joined: dict[int, float]
    ) -> list[Part]:
        if not outlines:
            return []
        reach = length + 2 * WIDEST_SKIN
        xs, ys = zip(*(point for points in outlines for point in points), strict=True)
        box = (min(xs) - reach, min(ys) - reach, max(xs) + reach, max(ys) + reach)
        floor = frozenset(part.rank for part in self._ground.around_start(root))
        close = self._ground.within(self._mover.around.root, *box, floor)
        return [part for part in close if part.solid and part.root != root and part.root not in joined]


def _shifted(part: Part, by: Point) -> tuple[Point, ...]:
    return tuple((x + by[0], y + by[1]) for x, y in part.points)


def _gap(points: tuple[Point, ...], other: Part, angle: float) -> float:
    """Metres that a polygon goes to ``angle`` until it meets a part; none if it reaches into it already."""
    if overlapping(points, other.points):
        return 0.0
    return less_skin(*outline_contact(_seen(points, angle), _seen(other.points, angle)))


def _seen(points: tuple[Point, ...], angle: float) -> tuple[Edge, ...]:
    return edges(seen_from(points, 0.0, 0.0, angle))
