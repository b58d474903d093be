"""The places of everything in a world. All robots share one ground, from any thread.

Robots, and things that can be pushed or gripped, may move; the rest stays. Positions are computed on request,
so that a robot alone pays nothing for moving. The first request or movement loads pymunk and lays everything
out (``layout``).
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Collection, Hashable, Iterable, Mapping, Sequence
from math import ceil, hypot, inf, log
from typing import TYPE_CHECKING

from donnie_tui.process import LazyValue, load_with, real_module
from sim.geometry import Placement
from sim.scene import Model, Scene

if TYPE_CHECKING:
    from devices.ports.robot import Sighting
    from sim.clock import Glide, Now
    from sim.geometry import Point, Wedge
    from sim.layout import Layout
    from sim.parts import Part, Sighted
    from sim.rays import Hit

_FINENESS = 1.1
"""Guard distances are rounded up to powers of this, so that many kinds of robots share a few layers."""


class Ground:
    """The parts of a scene. ``root`` is always the index of a top-level model."""

    def __init__(self, scene: Scene, looks: Looks | None = None) -> None:
        self.scene = scene
        self.looks = looks
        """Sightings, which worlds of one scene may share."""
        self.pushable = frozenset(model.index for model in _things(scene) if model.pushable)
        """The roots of things that a robot can push."""
        self.grippable = frozenset(model.index for model in _things(scene) if model.grippable)
        """The roots of things that a gripper can take."""
        self._lock = threading.RLock()
        movable = sorted({*scene.robots, *self.pushable, *self.grippable})
        self._start = {root: scene.models[root].pose.within_a_turn() for root in movable}
        self.movable = frozenset(movable)
        """The roots that may be put elsewhere: robots, and things to push or to grip."""
        self._now = dict(self._start)
        self._groups: dict[int, int] = {root: root + 1 for root in scene.robots}
        self._changes = 0
        self._own_changes: dict[int, int] = {}
        self.fastest = 0.0
        """Metres a second: no point of anything that moves in its turn is faster."""
        self.jumps = 0
        """Counts movements out of turn and increases of speed, after which known distances are invalid."""
        self._glides: dict[int, Glide] = {}
        """The glides of robots, whose places are updated when they matter."""
        self._now_in_turn: Callable[[], Now] = _at_once
        self._cut: Callable[[Collection[Glide]], None] = _nothing
        self._widest_guard = 0.0
        self._layout: Layout | None = None
        self._guards: dict[float, None] = {}
        """The guard distances requested before the layout."""

    def begin(self) -> None:
        """Lay everything out once; it takes longer than the rest of a world's start."""
        with self._lock:
            if self._layout is None:
                self._lay_out()

    # --- robots that glide

    def follow(self, now: Callable[[], Now], cut: Callable[[Collection[Glide]], None]) -> None:
        """``now`` gives the world's time; ``cut`` is called with glides to which something comes near."""
        self._now_in_turn, self._cut = now, cut

    def jump(self) -> None:
        """Note that something moved out of turn, or became faster."""
        self.jumps += 1
        with self._lock:
            if self._glides:
                self._cut(self._glides.values())

    def begin_glide(self, glide: Glide) -> bool:
        """Let the robot follow a glide. False if another glide leads too near."""
        with self._lock:
            moving = (self._layout or self._lay_out()).moving
            x, y, half, extent = glide.x, glide.y, glide.half, moving.extent(glide.root)
            if near := self._gliding_near(glide.root, x, y, half + extent):
                if any(glide.is_near_way(each.way, moving.extent(each.root)) for each in near):
                    return False
                self._cut([each for each in near if each.is_near_way(glide.way, extent)])
            self._glides[glide.root] = glide
            moving.cover(glide.root, x, y, half)
            return True

    def end_glide(self, root: int, now: Placement | None) -> None:
        """End a glide with the robot at ``now``; None: at its place of before, until it is put elsewhere."""
        with self._lock:
            del self._glides[root]
            self._put(root, self._now[root] if now is None else now)

    def _gliding_near(self, asker: int, x: float, y: float, reach: float) -> list[Glide]:
        """Other robots' glides that may come near to something within ``reach`` of a place."""
        assert self._layout is not None
        glides, reach = self._glides, reach + self._widest_guard
        near = self._layout.moving.close_to(asker, x, y, reach)
        return [glides[root] for root in near if root in glides] if near else []

    def _catch_up(self, asker: int, roots: Iterable[int]) -> None:
        """Put gliding robots to their current places. Under the lock."""
        glides = self._glides
        if glides and (gliding := [root for root in roots if root in glides and root != asker]):
            now = self._now_in_turn()
            for root in gliding:
                if (place := glides[root].new_place(now)) is not None:
                    self._place(root, place)

    def roots_within(self, asker: int, x: float, y: float, reach: float) -> list[int]:
        """Other movable roots within ``reach`` of a place, and perhaps some more, in no order."""
        with self._lock:
            roots = (self._layout or self._lay_out()).moving.close_to(asker, x, y, reach)
            self._catch_up(asker, roots)
            return roots

    def _others(self, asker: int, left: float, bottom: float, right: float, top: float) -> list[int]:
        """Other movable roots that may be in a box now, in no order. Under the lock."""
        roots = (self._layout or self._lay_out()).moving.within(asker, left, bottom, right, top)
        self._catch_up(asker, roots)
        return roots

    # --- where things are

    def place(self, root: int) -> Placement:
        """The place of a movable root."""
        return self._now[root]

    def start(self, root: int) -> Placement:
        """Its place at the start, with a heading from 0 to below 360."""
        return self._start[root]

    def around_start(self, root: int) -> tuple[Part, ...]:
        """The parts of others inside which a movable root stands at the start."""
        with self._lock:
            return (self._layout or self._lay_out()).around_start[root]

    def put(self, root: int, now: Placement) -> None:
        """Put a movable root to a place."""
        with self._lock:
            self._put(root, now)
            if self._glides and self._layout is not None:
                extent = self._layout.moving.extent(root)
                near = self._gliding_near(root, now.x, now.y, extent)
                self._cut([each for each in near if each.is_near(now.x, now.y, extent)])

    def _put(self, root: int, now: Placement) -> None:
        if self._layout is None and now != self._now[root]:
            self._lay_out()
        self._place(root, now)
        if self._layout is not None:
            self._layout.moving.move(root, now)

    def _place(self, root: int, now: Placement) -> None:
        before, self._now[root] = self._now[root], now
        self._changes += 1
        self._own_changes[root] = self._own_changes.get(root, 0) + 1
        if self._layout is not None and now != before:  # a robot that was seen at the end of its glide
            self._layout.changed(root)

    def quicken(self, speed: float) -> None:
        """Note that something may be this fast from now on (metres a second)."""
        if speed > self.fastest:
            self.fastest = speed
            self.jump()

    def put_things_back(self) -> None:
        """Put all things to their starts, except those that a robot holds."""
        for root in self.moved():
            if root not in self.scene.robots and not self.is_attached(root):
                self.put(root, self._start[root])
                self.jump()

    def moved(self) -> Mapping[int, Placement]:
        """The movable roots that are not at their starts, with their places."""
        with self._lock:
            self._catch_up(-1, self._glides)
            return {root: now for root, now in self._now.items() if now != self._start[root]}

    def attach(self, root: int, robot: int | None) -> None:
        """Make a thing part of a robot's body, or of none."""
        with self._lock:
            self._groups[root] = 0 if robot is None else robot + 1
            self.jump()
            self._changes += 1
            if self._layout is not None:
                self._layout.group(root)

    def is_attached(self, root: int) -> bool:
        """Whether a robot holds that thing."""
        return self._groups.get(root, 0) != 0 and root not in self.scene.robots

    # --- what robots ask. ``asker``: its own body, and what is attached to it, is not there for it

    def parts(self) -> tuple[Part, ...]:
        """Everything, in order."""
        with self._lock:
            self._catch_up(-1, self._glides)
            return tuple((self._layout or self._lay_out()).parts())

    def parts_of(self, root: int) -> tuple[Part, ...]:
        """The parts of a movable root."""
        with self._lock:
            return (self._layout or self._lay_out()).parts_of(root)

    def within(
        self,
        asker: int,
        left: float,
        bottom: float,
        right: float,
        top: float,
        but: frozenset[int],
        has_still: bool = True,
    ) -> list[Part]:
        """All parts that come into a box, and perhaps some more, in order; without the ranks ``but``.

        Without ``has_still`` only movable ones.
        """
        with self._lock:
            roots = self._others(asker, left, bottom, right, top)
            layout = self._layout or self._lay_out()
            return layout.within(asker, roots, (left, bottom, right, top), but, has_still)

    def first_hits(
        self, asker: int, x: float, y: float, ends: Sequence[Point], ranging: bool, but: frozenset[int]
    ) -> list[Hit[Part]]:
        """The first hits of rays from one place to each of ``ends``."""
        with self._lock:
            if self._glides:
                xs, ys = zip((x, y), *ends, strict=True)
                self._others(asker, min(xs), min(ys), max(xs), max(ys))
            return (self._layout or self._lay_out()).first_hits(asker, x, y, ends, ranging, but)

    def nearest(
        self, asker: int, wedge: Wedge, height: float | None, but: frozenset[int], has_still: bool = True
    ) -> Sighted:
        """The nearest thing for rangers, see ``rangers.Around``; without ``has_still`` only movable ones."""
        with self._lock:
            layout = self._layout or self._lay_out()
            nearest = layout.nearest_still(wedge, height, but) if has_still else (inf, None)
            reach = wedge.reach if nearest[1] is None else nearest[0]
            roots = layout.moving.in_wedge(asker, wedge, reach)
            if roots:
                self._catch_up(asker, roots)
                nearest = layout.nearest_moving(asker, roots, wedge, height, but, nearest)
            return nearest

    def free_way(
        self, asker: int, x: float, y: float, end: Point, guard: float, but: frozenset[int]
    ) -> float:
        """The part of the way, from 0 to 1, on which nothing comes nearer than ``guard``.

        ``guard`` is a distance that ``guarded`` has returned.
        """
        with self._lock:
            layout = self._layout or self._lay_out()
            way = layout.free_of_still(x, y, end, guard, but)
            if layout.has_others(asker, self._others(asker, *_around(x, y, end, guard))):
                way = min(way, layout.free_of_moving(asker, x, y, end, guard, but))
            return way

    def is_free_of_still(self, x: float, y: float, end: Point, guard: float) -> bool:
        """Whether nothing that never moves comes nearer to a way than ``guard``."""
        with self._lock:
            layout = self._layout or self._lay_out()
            return layout.free_of_still(x, y, end, guard, frozenset()) >= 1.0

    def still_room(self, x: float, y: float, guard: float) -> float:
        """The radius around a place without still parts nearer than ``guard``; below 0: none.

        At most some metres.
        """
        with self._lock:
            return (self._layout or self._lay_out()).still_room(x, y, guard)

    def may_meet_others(self, asker: int, x: float, y: float, end: Point, guard: float) -> bool:
        """Whether anything that may move might be nearer than ``guard`` to a way."""
        to_x, to_y = end
        reach = hypot(to_x - x, to_y - y) / 2 + guard
        with self._lock:
            layout = self._layout or self._lay_out()
            roots = layout.moving.close_to(asker, (x + to_x) / 2, (y + to_y) / 2, reach)
            return layout.has_others(asker, roots)

    def moment(self, asker: int) -> Moment:
        """A moment for ``is_unchanged``."""
        now = self._now_in_turn() if self._glides else _AT_REST
        return self._changes - self._own_changes.get(asker, 0), now

    def is_unchanged(self, asker: int, since: Moment) -> bool:
        """Whether nothing but the asker has moved since that moment."""
        with self._lock:
            changes, now = self.moment(asker)
            return changes == since[0] and not any(
                each.ticks(since[1]) < each.ticks(now) for each in self._glides.values() if each.root != asker
            )

    def guarded(self, guard: float) -> float:
        """Prepare ``free_way`` for a distance (metres). Returns the distance that is kept."""
        rounded: float = _FINENESS ** ceil(log(guard) / log(_FINENESS))
        with self._lock:
            self._widest_guard = max(self._widest_guard, rounded)
            if self._layout is None:
                self._guards[rounded] = None
            else:
                self._layout.keep(rounded)
        return rounded

    def _lay_out(self) -> Layout:
        """Under the lock, before anything has moved."""
        _load_pymunk()
        from sim.layout import Layout  # pymunk, a third of a start: loaded at the first movement

        self._layout = Layout(self.scene, self._start, self._now, self._groups, self._guards)
        return self._layout


Looks = dict["Hashable", tuple["Sighting", ...]]
"""The sightings of a robot, by all values that decide them."""
MOST_LOOKS = 20_000
"""Looks that are kept."""
Moment = tuple[int, "Now"]
"""The count of movements, and the world's time if a robot glides."""
_AT_REST: Now = (0.0, 0.0)


def _around(x: float, y: float, end: Point, guard: float) -> tuple[float, float, float, float]:
    """Left, bottom, right and top of the area within ``guard`` of a way."""
    to_x, to_y = end
    return min(x, to_x) - guard, min(y, to_y) - guard, max(x, to_x) + guard, max(y, to_y) + guard


def _at_once() -> Now:
    return _AT_REST


def _nothing(_glides: Collection[Glide]) -> None: ...


def _things(scene: Scene) -> list[Model]:
    """The top-level models that are not robots."""
    robots = frozenset(scene.robots)
    return [model for model in scene.models if model.parent is None and model.index not in robots]


def _load_pymunk() -> None:
    """Load pymunk without logging, to which it writes errors only: a thirtieth of a linear session."""

    def logger(name: str) -> LazyValue:
        return LazyValue(lambda: real_module("logging").getLogger(name))

    load_with("pymunk", logging=LazyValue(lambda: real_module("logging"), getLogger=logger))
