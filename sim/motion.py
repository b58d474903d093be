"""How far a robot gets: walks and turns of one body among things as they are now.

Nothing is stepped through where the way is free: a thin ray through thickened bodies finds the first step
that needs a closer look. ``careful`` looks at every step; both give the same (a property test holds it).
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable
from math import floor, hypot, inf

from devices.ports.robot import STEP, Bearing, StoppedBy
from devices.ports.values import Frozen, replace
from sim.geometry import disc_contact, edges, outline_contact, overlapping, placed, seen_from, turn_contact
from sim.ground import Ground
from sim.parts import Body, Outline, body_of
from sim.physics import OtherRobots, Part, Surroundings
from sim.placement import Spot
from sim.sensors import CENTIMETRES_A_STEP, Around, Ranger, Senses, senses_of

SKIN = 1e-4
"""Metres that a robot keeps from what it bumped into, so that it can turn and leave."""
WIDEST_SKIN = 0.005
"""Metres that it keeps along its way from what it would only graze."""
TOUCHING = 1e-9
"""Metres that don't count: a way that is shorter is none, one that lacks less is whole."""
STEPS_A_QUESTION = 100
"""Steps that need a closer look, between two questions whether to go on: some hundredths of a second."""

Going = Callable[[], bool]


def _always() -> bool:
    return True


class Walk(Frozen):
    """What becomes of a walk."""

    metres: float
    steps: int
    stopped_by: StoppedBy | None
    """None with fewer steps than asked: there is something that gives way, and has to be pushed."""


class Contact(Frozen):
    """What a body meets first on its way, and after how many metres; infinity if the way is free."""

    metres: float
    part: Part | None


NO_CONTACT = Contact(inf, None)


class Mover:
    """One robot's body and senses among its surroundings."""

    def __init__(self, ground: Ground, robot: int) -> None:
        """``robot``: the index of its model."""
        self.senses: Senses = senses_of(ground.scene, robot)
        self.body: Body = body_of(ground.scene, robot)
        self._bare = self.body
        self.around = Surroundings(ground, robot)
        self._keep_guard()
        self._barring = self._without_what_gives_way(ground)
        self._others = OtherRobots(self.around)
        self._guards = {
            bearing: tuple(_short_sighted(ranger) for ranger in self.senses.at(bearing))
            for bearing in (Bearing.FRONT, Bearing.BACK)
        }

    def hold(self, outlines: tuple[Outline, ...]) -> None:
        """From now on these polygons, in the robot's frame, are part of its body; earlier ones are not."""
        self.body = self._bare.holding(outlines) if outlines else self._bare
        self._keep_guard()

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
            here = start if done == 0 else start.ahead(done * STEP, angle)
            free = 0 if careful else self._free_steps(here, angle, steps - done)
            if free:
                done += free
                continue
            if done % STEPS_A_QUESTION == STEPS_A_QUESTION - 1 and not going():
                return Walk(0.0, 0, StoppedBy.USER)
            if self.is_blocked(here, bearing):
                return Walk(done * STEP, done, StoppedBy.OBSTACLE)
            contact = self.contact(here, angle, STEP)
            if contact.metres < STEP - TOUCHING:
                return Walk(done * STEP + contact.metres, done, self._stopped_by(contact))
            done += 1
        return Walk(steps * STEP, steps, None)

    def turn(self, spot: Spot, degrees: int) -> int:
        """How many of ``degrees`` (counter-clockwise if positive) the robot can turn, whole ones."""
        if degrees == 0 or (self.body.is_round and not self.around.has_company):
            return degrees
        sign = 1 if degrees > 0 else -1
        outline, nearest = self.body.outline(spot.yaw), inf
        for part in self._in_the_way_of_turning(spot):
            shifted = edges(seen_from(part.points, spot.x, spot.y, 0.0))
            nearest = min(nearest, turn_contact(outline, shifted, sign))
        if nearest >= abs(degrees):
            return degrees
        return sign * max(0, floor(nearest - 0.02))

    def contact(self, spot: Spot, angle: float, length: float, but: Container[int] = frozenset()) -> Contact:
        """What is met first on the next ``length`` metres (at most a step) to ``angle``, or a bit beyond.

        ``but``: roots that are not in the way.
        """
        return self.contact_with_any(self.on_the_way(spot, angle, length), spot, angle, but)

    def on_the_way(self, spot: Spot, angle: float, length: float) -> list[Part]:
        """What can be met on the next ``length`` metres, and perhaps some more."""
        middle = spot.ahead(length / 2, angle)
        return self._touchable(middle, self.body.radius + length / 2 + 2 * WIDEST_SKIN)

    def contact_with_any(
        self, parts: Iterable[Part], spot: Spot, angle: float, but: Container[int]
    ) -> Contact:
        """Which of ``parts`` is met first, those with the roots ``but`` not in the way."""
        nearest = NO_CONTACT
        for part in parts:
            if part.root in but:
                continue
            metres = self._contact_with(part, spot, angle)
            if metres < nearest.metres:
                nearest = Contact(metres, part)
        return nearest

    def barring(self, spot: Spot, reach: float) -> list[Part]:
        """What can be the obstacle before a sensor, within ``reach`` metres."""
        return [part for part in self._barring.near(spot.x, spot.y, reach) if part.solid or part.seen]

    def touchable(self, spot: Spot) -> list[Part]:
        """What the body may touch here."""
        return self._touchable(spot, self.body.radius + 2 * WIDEST_SKIN)

    def is_far(self, spot: Spot, metres: float) -> bool:
        """Whether nothing can stop the next step or turn, even if all that is around came so much nearer."""
        close = self.around.near(spot.x, spot.y, self._guard + metres)
        return not any(part.solid or part.seen for part in close)

    def is_blocked(self, spot: Spot, bearing: Bearing) -> bool:
        """Whether the next step would leave less than one step of free space before a sensor."""
        return self._sees(self._barring, spot, bearing, 2.0)

    def is_met(self, spot: Spot, bearing: Bearing, rest: float) -> bool:
        """The same for the ``rest`` of a step, because of a robot that has come near meanwhile."""
        return bool(self._others) and self._sees(self._others, spot, bearing, rest + 1.0)

    def _sees(self, around: Around, spot: Spot, bearing: Bearing, steps: float) -> bool:
        near = steps * CENTIMETRES_A_STEP
        readings = (ranger.centimetres(around, spot) for ranger in self._guards[bearing])
        return any(reading is not None and reading < near for reading in readings)

    def _stopped_by(self, contact: Contact) -> StoppedBy | None:
        part = contact.part
        is_to_push = part is not None and part.root in self.around.ground.pushable
        return None if is_to_push else StoppedBy.COLLISION

    def _contact_with(self, part: Part, spot: Spot, angle: float) -> float:
        obstacle = edges(seen_from(part.points, spot.x, spot.y, angle))
        if self.body.is_round or self._overlaps(spot, part):
            return min(disc_contact(self.body.radius, edge, SKIN) for edge in obstacle)
        contact, squarely = outline_contact(self.body.outline(spot.yaw - angle), obstacle)
        return less_skin(contact, squarely)

    def _in_the_way_of_turning(self, spot: Spot) -> list[Part]:
        """A round body has room to turn from all that lies still: only what moves can have come closer."""
        close = self._touchable(spot, self.body.radius)
        if self.body.is_round:
            close = [part for part in close if part.root in self.around.ground.movable]
        return [part for part in close if not self._overlaps(spot, part)]

    def _touchable(self, spot: Spot, reach: float) -> list[Part]:
        return [part for part in self.around.near(spot.x, spot.y, reach) if part.solid]

    def _overlaps(self, spot: Spot, part: Part) -> bool:
        """Whether the robot already reaches into the thing: its world put it there. It may only leave."""
        mine = (placed(points, spot.x, spot.y, spot.yaw) for points in self.body.polygons)
        return any(overlapping(points, part.points) for points in mine)

    def _free_steps(self, here: Spot, angle: float, steps: int) -> int:
        there = here.ahead(steps * STEP, angle)
        if self.around.has_room(here.x, here.y, there.x, there.y):
            return steps
        part = self.around.free_way(here.x, here.y, there.x, there.y)
        return steps if part >= 1.0 else floor(part * steps)

    def _without_what_gives_way(self, ground: Ground) -> Surroundings:
        """What bars the way of a robot that walks up to all that it can push or grip, seen or not."""
        gives_way = ground.pushable if self.senses.beams is None else ground.pushable | ground.grippable
        return self.around.without(gives_way) if gives_way else self.around

    def _keep_guard(self) -> None:
        self._guard = guard_distance(self.body, self.senses.rangers)
        self.around.keep(self._guard)


def _short_sighted(ranger: Ranger) -> Ranger:
    """The same sensor, which looks only as far as a step needs: that is quicker."""
    return replace(ranger, maximum=min(ranger.maximum, 4 * STEP))


def less_skin(contact: float, squarely: float) -> float:
    """How far a body goes that would touch after ``contact`` metres, as squarely as that."""
    return max(0.0, contact - min(WIDEST_SKIN, SKIN / max(squarely, 1e-9)))


def guard_distance(body: Body, rangers: tuple[Ranger, ...]) -> float:
    """Metres from its centre beyond which nothing touches a robot within a step, nor blocks its sensors."""
    farthest = max((hypot(each.x, each.y) for each in rangers), default=0.0)
    return max(body.radius + STEP, farthest + 2 * STEP) + 0.01
