"""How far a robot can walk or turn among the things around it, and what stops it.

``Surroundings`` are the ground without the robot, or the pushed thing, itself. A part that contains its
centre from the start, such as a floor drawn as a box, is not an obstacle for it.

A free way is not checked step by step: a thin ray through thickened bodies finds the first step
that needs a closer look. ``careful`` looks at every step; both give the same result (a property test checks
it).
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Sequence
from functools import cached_property
from math import dist, floor, hypot, inf
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.robot import CENTIMETRES_A_STEP, STEP, Bearing, Met, StoppedBy
from sim.geometry import (
    Edge,
    Point,
    Spot,
    Wedge,
    angle_of,
    disc_contact,
    edges,
    nearest_on_edge,
    nearest_point_in_wedge,
    normal,
    outline_contact,
    overlapping,
    placed,
    seen_from,
    turn_contact,
)
from sim.ground import Ground
from sim.index import Box
from sim.parts import Body, Outline, Part, Sighted, body_of
from sim.rangers import Around, Height, Ranger
from sim.scene import Scene
from sim.sensors import Senses, senses_of

if TYPE_CHECKING:
    from sim.rays import Hit


__all__ = ["OtherRobots", "Part", "Surroundings"]


SAFE = 1e-6
"""Metres by which a circle of free room is taken smaller."""


_Room = tuple[float, float, float]
"""A circle in which nothing that never moves comes near: its middle and its radius."""
_NO_ROOM: _Room = 0.0, 0.0, -1.0


class OtherRobots:
    """The other robots around a robot."""

    def __init__(self, around: Surroundings) -> None:
        self._around = around
        self._robots = frozenset(around.ground.scene.robots)
        self._has_any = len(self._robots) > 1

    def is_any_near(self, spot: Spot, reach: float) -> bool:
        """Whether a robot comes within ``reach`` of a place; perhaps also if it is a little farther."""
        around = self._around
        roots = around.ground.roots_within(around.root, spot.x, spot.y, reach) if self._has_any else ()
        return any(root in self._robots for root in roots)

    def within(self, left: float, bottom: float, right: float, top: float) -> list[Part]:
        """All parts that come into a box, and perhaps some more, in order."""
        found = self._around.within(left, bottom, right, top)
        return [part for part in found if part.root in self._robots]

    def first_hits(self, x: float, y: float, ends: Sequence[Point], ranging: bool = False) -> list[Hit[Part]]:
        """The robots that rays hit first, unless something else is before them."""
        hits = self._around.first_hits(x, y, ends, ranging)
        return [hit if hit[0] and hit[0].root in self._robots else (None, 1.0) for hit in hits]

    def nearest(self, wedge: Wedge, height: Height) -> Sighted:
        """The nearest robot in a wedge, which nothing hides."""
        around = self._around
        return around.ground.nearest(around.root, wedge, height, self._things, has_still=False)

    @cached_property
    def _things(self) -> frozenset[int]:
        """The ranks of movable things."""
        ground = self._around.ground
        roots = ground.movable - self._robots
        return frozenset(part.rank for root in roots for part in ground.parts_of(root)) | self._around.absent


class Surroundings:
    """Everything on the ground but one root and what is attached to it."""

    def __init__(self, ground: Ground, root: int, ignored: frozenset[int] = frozenset()) -> None:
        """``root``: the index of a top-level model. ``ignored``: ranks of parts that are not there for it."""
        self.ground = ground
        self.root = root
        self._guard = 0.0
        self._room = _NO_ROOM
        self.has_company = len(ground.movable) > 1
        """Whether anything else on the ground may move."""
        self._ignored = ignored

    @cached_property
    def stands_in(self) -> tuple[int, ...]:
        """The roots inside which it stands from the start."""
        return tuple(dict.fromkeys(part.root for part in self.ground.around_start(self.root)))

    @cached_property
    def absent(self) -> frozenset[int]:
        """The ranks of parts that are not there for it."""
        return self._ignored | frozenset(part.rank for part in self.ground.around_start(self.root))

    def without(self, roots: frozenset[int]) -> Surroundings:
        """The surroundings without these roots."""
        ignored = (part.rank for root in roots if root != self.root for part in self.ground.parts_of(root))
        return Surroundings(self.ground, self.root, self._ignored | frozenset(ignored))

    def keep(self, guard: float) -> None:
        """Prepare ``free_way`` for this distance (metres) from everything."""
        self._guard = self.ground.guarded(guard)
        self._room = _NO_ROOM

    @property
    def parts(self) -> tuple[Part, ...]:
        """Everything, in order."""
        return tuple(
            part for part in self.ground.parts() if part.root != self.root and part.rank not in self.absent
        )

    def near(self, x: float, y: float, reach: float) -> list[Part]:
        """All parts that come within ``reach`` of a place, and perhaps some more, in order."""
        box = x - reach, y - reach, x + reach, y + reach
        its_x, its_y, radius = self._room
        has_still = reach > self._guard or hypot(x - its_x, y - its_y) >= radius
        return self.ground.within(self.root, *box, self.absent, has_still)

    def within(self, left: float, bottom: float, right: float, top: float) -> list[Part]:
        """All parts that come into a box, and perhaps some more, in order."""
        return self.ground.within(self.root, left, bottom, right, top, self.absent)

    def first_hits(self, x: float, y: float, ends: Sequence[Point], ranging: bool = False) -> list[Hit[Part]]:
        """The first hits of rays from one place to each of ``ends``.

        ``ranging``: as a ranger sees, to which some things are invisible.
        """
        return self.ground.first_hits(self.root, x, y, ends, ranging, self.absent)

    def nearest(self, wedge: Wedge, height: Height) -> Sighted:
        """The nearest thing that a ranger sees in a wedge."""
        return self.ground.nearest(self.root, wedge, height, self.absent)

    def has_room(self, x: float, y: float, to_x: float, to_y: float, straight: bool = False) -> bool:
        """Whether a way is known to keep the guard distance, and all between two of them; False says nothing.

        Still parts are known to be away from a circle, which is computed again if a way begins outside the
        last one. If a way leads out of the circle and is ``straight``, a ray checks this one way.
        """
        if self.absent:
            return False
        its_x, its_y, radius = self._room
        if hypot(x - its_x, y - its_y) >= radius:
            radius = max(0.0, self.ground.still_room(x, y, self._guard) - SAFE)
            self._room = its_x, its_y, radius = x, y, radius
        if hypot(to_x - its_x, to_y - its_y) >= radius and not (
            straight and self.ground.is_free_of_still(x, y, (to_x, to_y), self._guard)
        ):
            return False
        return not self.has_company or not self.ground.may_meet_others(
            self.root, x, y, (to_x, to_y), self._guard
        )

    def free_way(self, x: float, y: float, to_x: float, to_y: float) -> float:
        """The part of the way, from 0 to 1, on which nothing comes nearer than the guard distance."""
        return self.ground.free_way(self.root, x, y, (to_x, to_y), self._guard, self.absent)


SKIN = 1e-4
"""Metres that a robot keeps from what it bumped into, so that it can turn and leave."""
WIDEST_SKIN = 0.005
"""Metres that it keeps along its way from what it would only graze."""
TURN_SKIN = 0.02
"""Degrees that it keeps when it turns."""
TOUCHING = 1e-9
"""Tolerance in metres: a shorter way is none, and one that is short by less is complete."""
STEPS_A_QUESTION = 100
"""Steps that need a closer look, between two questions whether to go on: some hundredths of a second."""

Going = Callable[[], bool]


def _always() -> bool:
    return True


class WalkOutcome(Struct, frozen=True):
    """The steps of a walk, and what ended it."""

    metres: float
    steps: int
    stopped_by: StoppedBy | None
    """None with fewer steps than asked: there is something that gives way, and has to be pushed."""


class Contact(Struct, frozen=True):
    """The first thing that a body meets, and after how many metres; infinity if the way is free."""

    metres: float
    part: Part | None


NO_CONTACT = Contact(inf, None)


class Mover:
    """A robot's body and sensors among its surroundings."""

    def __init__(self, ground: Ground, robot: int) -> None:
        """``robot``: the index of its model."""
        self.senses: Senses = senses_of(ground.scene, robot)
        self.body: Body = body_of(ground.scene, robot)
        self._bare = self.body
        self._stuck: tuple[Spot, int] | None = None
        """Where it can't turn a degree to one side, because of what never moves."""
        self._outlined: tuple[float, Sequence[Edge]] | None = None
        """Its edges at the angle to its way at which it looked last."""
        self._boxed: tuple[float, Box] | None = None
        """A box around these."""
        self._apart_since = -1
        """The ground's ``jumps`` when the robot was known to reach into nothing."""
        self.around = Surroundings(ground, robot)
        self._keep_guard()
        self._barring = self._without_what_gives_way(ground)
        self._others = OtherRobots(self.around)
        self._guards = {
            bearing: tuple(_short_sighted(ranger) for ranger in self.senses.at(bearing))
            for bearing in (Bearing.FRONT, Bearing.BACK)
        }

    def hold(self, outlines: tuple[Outline, ...]) -> None:
        """Make these polygons, in the robot's frame, part of the body in place of earlier ones."""
        self.body = self._bare.holding(outlines) if outlines else self._bare
        self._stuck = None
        self._keep_guard()

    def walk(
        self, start: Spot, bearing: Bearing, steps: int, going: Going = _always, careful: bool = False
    ) -> WalkOutcome:
        """Up to ``steps`` steps forward or backward: ``bearing`` is FRONT or BACK.

        Along a very long wall this takes its time: ``going`` is asked now and then whether to go on; if
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
                return WalkOutcome(0.0, 0, StoppedBy.USER)
            if self.is_blocked(here, bearing):
                return WalkOutcome(done * STEP, done, StoppedBy.OBSTACLE)
            contact = self.contact(here, angle, STEP)
            if contact.metres < STEP - TOUCHING:
                return WalkOutcome(done * STEP + contact.metres, done, self._stopped_by(contact))
            done += 1
        return WalkOutcome(steps * STEP, steps, None)

    def turn(self, spot: Spot, degrees: int) -> int:
        """How many of ``degrees`` (counter-clockwise if positive) the robot can turn, whole ones."""
        sign = 1 if degrees > 0 else -1
        if degrees == 0 or self._stuck == (spot, sign):
            return 0
        nearest = self.turn_contact(spot, sign)
        return degrees if nearest >= abs(degrees) else sign * max(0, floor(nearest - TURN_SKIN))

    def has_free_step(self, spot: Spot, bearing: Bearing) -> bool:
        """Whether a whole step is free, and is the same however it is divided."""
        angle = spot.yaw + (180.0 if bearing is Bearing.BACK else 0.0)
        there = spot.ahead(STEP, angle)
        if self.around.has_room(spot.x, spot.y, there.x, there.y, straight=True):
            return True
        return self._is_free(spot, angle) and not self.is_blocked(spot, bearing)

    def has_free_turn(self, spot: Spot, degrees: int) -> bool:
        """As ``has_free_step``, for a turn."""
        return self.turn(spot, degrees) == degrees and not self._reaches_into_any(
            spot, self._touchable(spot, self.body.radius)
        )

    def turn_contact(self, spot: Spot, sign: int) -> float:
        """Degrees (1: counter-clockwise, -1: clockwise) until the body touches something, or infinity."""
        if self.body.is_round and not self.around.has_company:
            return inf
        close, nearest = self._in_the_way_of_turning(spot), inf
        reach = self.body.radius + SKIN
        outline = self.body.outline(spot.yaw) if close else ()
        for part in close:
            shifted = edges(seen_from(part.points, spot.x, spot.y, 0.0))
            if all(hypot(*nearest_on_edge(edge)) > reach for edge in shifted):
                continue  # quicker to know than where the corners come to
            degrees = turn_contact(outline, shifted, sign)
            if degrees < nearest:
                nearest = degrees
                if degrees < 1.0 and part.root not in self.around.ground.movable:
                    self._stuck = spot, sign
        return nearest

    def contact(self, spot: Spot, angle: float, length: float, but: Container[int] = ()) -> Contact:
        """What is met first on the next ``length`` metres (at most a step) to ``angle``, or a bit beyond.

        ``but``: roots that are not in the way.
        """
        return self.contact_with_any(self.on_the_way(spot, angle, length), spot, angle, but)

    def on_the_way(self, spot: Spot, angle: float, length: float) -> list[Part]:
        """What can be met on the next ``length`` metres, and perhaps some more."""
        close = self._along_the_way(spot, angle, length)
        return [part for part in close if self._is_before(part, spot, angle, length)] if close else close

    def _along_the_way(self, spot: Spot, angle: float, length: float) -> list[Part]:
        """What the body may touch here or on its way, and perhaps some more."""
        middle, reach = spot.ahead(length / 2, angle), self.body.radius + length / 2 + 2 * WIDEST_SKIN
        here = middle.x, middle.y
        close = self._touchable(middle, reach)
        return [part for part in close if dist(part.middle, here) < part.reach + reach] if close else close

    def _is_before(self, part: Part, spot: Spot, angle: float, length: float) -> bool:
        """Whether the boxes of the body and of a part meet, if the body moves ``length`` metres."""
        left, bottom, right, top = self._box_along(spot.yaw - angle)
        points = seen_from(part.points, spot.x, spot.y, angle)
        xs, ys = [x for x, _ in points], [y for _, y in points]
        return min(xs) <= right + length and max(xs) >= left and min(ys) <= top and max(ys) >= bottom

    def contact_with_any(
        self, parts: Iterable[Part], spot: Spot, angle: float, but: Container[int]
    ) -> Contact:
        """The first contact with one of ``parts``, except those of the roots ``but``."""
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
        close = self.around.near(spot.x, spot.y, self.guard + metres)
        return not any(part.solid or part.seen for part in close)

    def is_blocked(self, spot: Spot, bearing: Bearing) -> bool:
        """Whether the next step would leave less than one step of free space before a sensor."""
        return self._sees(self._barring, spot, bearing, 2.0)

    def is_met(self, spot: Spot, bearing: Bearing, rest: float) -> bool:
        """The same for the ``rest`` of a step, because of a robot that has come near meanwhile."""
        return self.is_robot_near(spot, 0.0) and self._sees(self._others, spot, bearing, rest + 1.0)

    def is_robot_near(self, spot: Spot, metres: float) -> bool:
        """Whether another robot can stop the next step, or could if it came so much nearer."""
        return self._others.is_any_near(spot, self.guard + metres)

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
        contact, squarely = outline_contact(self._outline(spot.yaw - angle), obstacle)
        return less_skin(contact, squarely)

    def _outline(self, angle: float) -> Sequence[Edge]:
        """The body's edges when it looks to ``angle``: mostly along its way."""
        if self._outlined is None or self._outlined[0] != angle:
            self._outlined = angle, self.body.outline(angle)
        return self._outlined[1]

    def _box_along(self, angle: float) -> Box:
        """A box around the body when it looks to ``angle``, wider than its skin."""
        if self._boxed is None or self._boxed[0] != angle:
            reach, skin = self.body.radius, 2 * WIDEST_SKIN
            if self.body.is_round:
                left, bottom, right, top = -reach, -reach, reach, reach
            else:
                xs, ys, _, _ = zip(*self._outline(angle), strict=True)
                left, bottom, right, top = min(xs), min(ys), max(xs), max(ys)
            self._boxed = angle, (left - skin, bottom - skin, right + skin, top + skin)
        return self._boxed[1]

    def _in_the_way_of_turning(self, spot: Spot) -> list[Part]:
        """A round body has room to turn from all that lies still: only what moves can have come closer."""
        here, reach = (spot.x, spot.y), self.body.radius + SKIN
        close = self._touchable(spot, self.body.radius)
        if self.body.is_round:
            close = [part for part in close if part.root in self.around.ground.movable]
        in_reach = [part for part in close if dist(part.middle, here) <= part.reach + reach]
        return [part for part in in_reach if not self._overlaps(spot, part)]

    def _touchable(self, spot: Spot, reach: float) -> list[Part]:
        return [part for part in self.around.near(spot.x, spot.y, reach) if part.solid]

    def _is_free(self, spot: Spot, angle: float) -> bool:
        """Whether the body reaches into nothing, and touches nothing on the next step."""
        close = self._along_the_way(spot, angle, STEP)
        if self._reaches_into_any(spot, close):
            return False
        ahead = [part for part in close if self._is_before(part, spot, angle, STEP)]
        return self.contact_with_any(ahead, spot, angle, ()).metres >= STEP - TOUCHING

    def _reaches_into_any(self, spot: Spot, close: Iterable[Part]) -> bool:
        if any(self._overlaps(spot, part) for part in close):
            return True
        self._apart_since = self.around.ground.jumps
        return False

    def _overlaps(self, spot: Spot, part: Part) -> bool:
        """Whether the robot already reaches into the thing: its world put it there. It may only leave.

        If it reaches into nothing, it can't come into what lies still but by a jump.
        """
        ground = self.around.ground
        if self._apart_since == ground.jumps and part.root not in ground.movable:
            return False
        if dist(part.middle, (spot.x, spot.y)) > part.reach + self.body.radius + SKIN:
            return False
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
        self._outlined = self._boxed = None
        radius = self.body.radius
        farthest = max((hypot(each.x, each.y) for each in self.senses.rangers), default=0.0)
        self.guard = max(radius + STEP, farthest + 2 * STEP) + 0.01
        """Metres from its centre beyond which nothing touches it within a step, nor blocks its sensors."""
        self.walking_guard = max(radius + STEP / 10 + 2 * WIDEST_SKIN, farthest + 2 * STEP + 0.01)
        """Metres from its way beyond which nothing touches a robot that walks, nor blocks its sensors."""
        self.turning_guard = radius + 2 * SKIN
        """Metres from its centre beyond which nothing touches a robot that turns."""
        self.around.keep(self.guard)


def _short_sighted(ranger: Ranger) -> Ranger:
    """The same sensor, which looks only as far as a step needs: that is quicker."""
    return replace(ranger, maximum=min(ranger.maximum, 4 * STEP))


def less_skin(contact: float, squarely: float) -> float:
    """How far a body goes that would touch after ``contact`` metres, as squarely as that."""
    return max(0.0, contact - min(WIDEST_SKIN, SKIN / max(squarely, 1e-9)))


SIGHT = 3 * STEP
"""Metres beyond the body in which an obstacle stops a walk: less than two steps before a sensor, which may
look a bit to the side."""
WEDGE = 60.0
"""Degrees to either side of the way in which it is looked for."""
HALF = 90.0

WALL, ROBOT = "wall", "robot"


class Meeting:
    """Finds what ended a movement; nothing if the way was free."""

    def __init__(self, mover: Mover, scene: Scene, robot: int) -> None:
        """``robot``: the index of its model."""
        self._mover = mover
        self._scene = scene
        self._me = scene.models[robot]
        self._walls: dict[int, bool] = {}
        """Whether models are walls, as far as that was asked."""

    def walking(self, spot: Spot, stopped_by: StoppedBy | None, turned: float = 0.0) -> Met | None:
        """What the robot met in a walk, where it is at the end, ``turned`` degrees from its front."""
        if stopped_by is StoppedBy.OBSTACLE:
            found = self._mover.barring(spot, self._mover.body.radius + SIGHT)
            return self._nearest(found, spot, turned, WEDGE)
        if stopped_by is StoppedBy.COLLISION:
            part = self._mover.contact(spot, spot.yaw + turned, STEP).part
            return None if part is None else self._nearest([part], spot, turned, HALF)
        return None

    def turning(self, spot: Spot, stopped_by: StoppedBy | None) -> Met | None:
        """The thing that ended a turn on the spot, or on a car's circle."""
        if stopped_by is StoppedBy.OBSTACLE:
            return self.walking(spot, stopped_by)
        if stopped_by is StoppedBy.COLLISION:
            return self._nearest(self._mover.touchable(spot), spot, 0.0, None)
        return None

    def _nearest(
        self, parts: Iterable[Part], spot: Spot, turned: float, half_angle: float | None
    ) -> Met | None:
        """The nearest of those that come within the wedge about the way; None: on any side."""
        found = [
            (point, part)
            for part in parts
            if (point := _nearest_point(part, spot, spot.yaw + turned, half_angle)) is not None
        ]
        if not found:
            return None
        point, part = min(found, key=lambda each: hypot(*each[0]))
        return self._met(part, normal(-angle_of(*point) - turned))

    def _met(self, part: Part, degrees: float) -> Met:
        model = self._scene.models[part.root]
        if model.index in self._scene.robots:
            return Met(ROBOT, model.called, degrees)
        return Met(WALL, "", degrees) if self._is_wall(part.root) else Met(model.kind, model.called, degrees)

    def _is_wall(self, root: int) -> bool:
        if root not in self._walls:
            from sim.picture import is_wall  # loaded at the first obstacle

            self._walls[root] = is_wall(self._scene.models[root], self._me)
        return self._walls[root]


def _nearest_point(part: Part, spot: Spot, angle: float, half_angle: float | None) -> Point | None:
    """Its point nearest to the robot's centre, where the robot's way is the positive x axis."""
    outline = edges(seen_from(part.points, spot.x, spot.y, angle))
    if half_angle is not None:
        return nearest_point_in_wedge(outline, half_angle)
    return min((nearest_on_edge(edge) for edge in outline), key=lambda point: hypot(*point), default=None)
