"""Where everything in a world is now. All robots share one ground, from any thread.

Robots, and things that can be pushed or gripped, may move; the rest stays. Positions are computed on request,
so that a robot alone pays nothing for moving. The first request or movement loads pymunk and lays everything
out (``layout``).
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable, Mapping, Sequence
from math import ceil, floor, hypot, inf, log
from typing import TYPE_CHECKING

from devices.ports.robot import STEP
from sim.geometry import Placement
from sim.index import FEW
from sim.scene import Model, Scene

if TYPE_CHECKING:
    from sim.clock import Glide, Now
    from sim.geometry import Point
    from sim.layout import Layout
    from sim.parts import Part
    from sim.rays import Hit

_FINENESS = 1.1
"""Guard distances are rounded up to powers of this, so that many kinds of robots share a few layers."""


class Ground:
    """The parts of a scene. ``root`` is always the index of a top-level model."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.pushable = frozenset(model.index for model in _things(scene) if model.pushable)
        """The roots of things that give way to a robot."""
        self.grippable = frozenset(model.index for model in _things(scene) if model.grippable)
        """The roots of things that a gripper can take."""
        self._lock = threading.RLock()
        movable = sorted({*scene.robots, *self.pushable, *self.grippable})
        self._start = {root: scene.models[root].pose.within_a_turn() for root in movable}
        self._now = dict(self._start)
        self._groups: dict[int, int] = {root: root + 1 for root in scene.robots}
        self._changes = 0
        self._own_changes: dict[int, int] = {}
        self.fastest = 0.0
        """Metres a second: no point of anything that moves in its turn is faster."""
        self.jumps = 0
        """Counts what moved out of turn, or became faster: what was known to be far may be near now."""
        self._glides: dict[int, Glide] = {}
        """Of the robots that glide, which are put to where they are now when that matters."""
        self._glide_squares: dict[tuple[int, int], list[Glide]] = {}
        """The same by the squares of a grid through which they glide."""
        self._now_in_turn: Callable[[], Now] = _at_once
        self._cut_glides: Callable[[], None] = _nothing
        self._widest_guard = 0.0
        self._extents: dict[int, float] = {}
        """Metres from the place of each movable root to its farthest point; empty before it was asked."""
        self._layout: Layout | None = None
        self._guards: dict[float, None] = {}
        """The guard distances that were asked for before all was laid out."""

    def begin(self) -> None:
        """Lay everything out, unless that was done: it takes longer than all the rest of a world's start."""
        with self._lock:
            if self._layout is None:
                self._lay_out()

    # --- robots that glide

    def follow(self, now: Callable[[], Now], cut_glides: Callable[[], None]) -> None:
        """``now``: the time of the world; ``cut_glides``: to be called where something moves out of turn."""
        self._now_in_turn, self._cut_glides = now, cut_glides

    def jump(self) -> None:
        """Something moves out of turn, or becomes faster."""
        self.jumps += 1
        if self._glides:
            self._cut_glides()

    def begin_glide(self, glide: Glide) -> None:
        """From now on the robot is where the glide leads."""
        with self._lock:
            self._glides[glide.root] = glide
            for square in _squares(*glide.box):
                self._glide_squares.setdefault(square, []).append(glide)
            self._change(glide.root)

    def end_glide(self, root: int) -> None:
        """The robot is where it is put again."""
        with self._lock:
            glide = self._glides.pop(root)
            for square in _squares(*glide.box):
                self._glide_squares[square].remove(glide)

    def is_alone(self, asker: int, x: float, y: float, reach: float, seconds: float) -> bool:
        """Whether nothing that may move comes within ``reach`` of a place in so many seconds.

        And no sensor or body of another robot finds anything there that is ``reach`` less its own guard away.
        """
        margin = reach + self._widest_guard + seconds * self.fastest + 1.5 * STEP
        with self._lock:
            self._measure_extents()
            layout = self._layout or self._lay_out()
            for root in layout.moving.within(x - margin, y - margin, x + margin, y + margin):
                now = self._now[root]
                if root != asker and hypot(now.x - x, now.y - y) < margin + self._extents[root]:
                    return False
        return True

    def roots_within(self, asker: int, x: float, y: float, reach: float) -> list[int]:
        """What may move, and comes within ``reach`` of a place; perhaps some more, in no order."""
        with self._lock:
            self._update(asker, x - reach, y - reach, x + reach, y + reach)
            layout = self._layout or self._lay_out()
            return [
                root
                for root in layout.moving.within(x - reach, y - reach, x + reach, y + reach)
                if root != asker
            ]

    def _measure_extents(self) -> None:
        """Of all roots that may move."""
        if not self._extents:
            self._extents = dict.fromkeys(self._start, 0.0)
            for part in (self._layout or self._lay_out()).at_start:
                if part.root in self._start:
                    start = self._start[part.root]
                    far = max(hypot(px - start.x, py - start.y) for px, py in part.points)
                    self._extents[part.root] = max(self._extents[part.root], far)

    def _update(self, asker: int, left: float, bottom: float, right: float, top: float) -> None:
        """Put the robots that glide through a box to where they are now. Under the lock."""
        if not self._glides:
            return
        met = self._gliding(left, bottom, right, top)
        now = self._now_in_turn() if met else (0.0, 0.0)
        for glide in met:
            if glide.root != asker and (place := glide.new_place(now)) is not None:
                self._put(glide.root, place)

    def _gliding(self, left: float, bottom: float, right: float, top: float) -> list[Glide]:
        """The glides that may lead through a box, each once."""
        squares = (right - left + 2 * _SQUARE) * (top - bottom + 2 * _SQUARE) / _SQUARE**2
        if max(squares, FEW) >= len(self._glides):
            glides: Iterable[Glide] = self._glides.values()
        else:
            table = self._glide_squares
            found = [table[square] for square in _squares(left, bottom, right, top) if square in table]
            glides = {glide.root: glide for each in found for glide in each}.values()
        return [
            glide
            for glide in glides
            if glide.box[0] <= right
            and left <= glide.box[2]
            and glide.box[1] <= top
            and bottom <= glide.box[3]
        ]

    def _update_all(self) -> None:
        self._update(-1, -inf, -inf, inf, inf)

    # --- where things are

    @property
    def movable(self) -> frozenset[int]:
        """The roots that may be put elsewhere: robots, and things to push or to grip."""
        return frozenset(self._start)

    def place(self, root: int) -> Placement:
        """Where a movable root is now."""
        return self._now[root]

    def start(self, root: int) -> Placement:
        """Where it was at the start, its heading from 0 to below 360."""
        return self._start[root]

    def around_start(self, root: int) -> tuple[Part, ...]:
        """The parts of others inside which a movable root stands at the start."""
        with self._lock:
            return (self._layout or self._lay_out()).around_start[root]

    def put(self, root: int, now: Placement) -> None:
        """Put a movable root there."""
        with self._lock:
            self._put(root, now)

    def _put(self, root: int, now: Placement) -> None:
        if now != self._now[root]:
            self.begin()
        self._now[root] = now
        self._change(root)
        if self._layout is not None:
            self._layout.changed(root)

    def _change(self, root: int) -> None:
        self._changes += 1
        self._own_changes[root] = self._own_changes.get(root, 0) + 1

    def quicken(self, speed: float) -> None:
        """Something may be that fast from now on (metres a second)."""
        if speed > self.fastest:
            self.fastest = speed
            self.jump()

    def put_things_back(self) -> None:
        """To where they started, but for those that a robot holds."""
        for root in self.moved():
            if root not in self.scene.robots and not self.is_attached(root):
                self.put(root, self._start[root])
                self.jump()

    def moved(self) -> Mapping[int, Placement]:
        """The movable roots that are not where they started, and where they are."""
        with self._lock:
            if self._glides:
                self._update_all()
            return {root: now for root, now in self._now.items() if now != self._start[root]}

    def attach(self, root: int, robot: int | None) -> None:
        """A thing is part of that robot's body from now on; of none if it is None."""
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
            if self._glides:
                self._update_all()
            return tuple((self._layout or self._lay_out()).parts())

    def parts_of(self, root: int) -> tuple[Part, ...]:
        """The parts of a movable root."""
        with self._lock:
            return (self._layout or self._lay_out()).parts_of(root)

    def within(
        self, asker: int, left: float, bottom: float, right: float, top: float, but: frozenset[int]
    ) -> list[Part]:
        """All parts that come into a box, and perhaps some more, in order; without the ranks ``but``."""
        with self._lock:
            if self._glides:
                self._update(asker, left, bottom, right, top)
            return (self._layout or self._lay_out()).within(asker, left, bottom, right, top, but)

    def first_hits(
        self, asker: int, x: float, y: float, ends: Sequence[Point], ranging: bool, but: frozenset[int]
    ) -> list[Hit[Part]]:
        """What looks from one place to each of ``ends`` meet first, and where on the way."""
        with self._lock:
            if self._glides:
                self._update_along(asker, ((x, y), *ends))
            return (self._layout or self._lay_out()).first_hits(asker, x, y, ends, ranging, but)

    def seen_within(self, x: float, y: float, end: Point) -> float:
        """The part of a way up to something that a ranger sees and that never moves, or 1."""
        with self._lock:
            return (self._layout or self._lay_out()).seen_within(x, y, end)

    def free_way(
        self, asker: int, x: float, y: float, end: Point, guard: float, but: frozenset[int]
    ) -> float:
        """The part of the way, from 0 to 1, on which nothing comes nearer than ``guard``.

        That is one that ``guarded`` has answered.
        """
        with self._lock:
            if self._glides:
                left, right, bottom, top = min(x, end[0]), max(x, end[0]), min(y, end[1]), max(y, end[1])
                self._update(asker, left - guard, bottom - guard, right + guard, top + guard)
            return (self._layout or self._lay_out()).free_way(asker, x, y, end, guard, but)

    def still_room(self, x: float, y: float, guard: float) -> float:
        """How far round a place nothing that never moves comes nearer than ``guard``; below 0: none.

        Some metres at most.
        """
        with self._lock:
            return (self._layout or self._lay_out()).still_room(x, y, guard)

    def may_meet_others(self, asker: int, x: float, y: float, end: Point, guard: float) -> bool:
        """Whether anything that may move might be nearer than ``guard`` to a way."""
        left, right, bottom, top = min(x, end[0]), max(x, end[0]), min(y, end[1]), max(y, end[1])
        box = left - guard, bottom - guard, right + guard, top + guard
        with self._lock:
            if self._glides and any(glide.root != asker for glide in self._gliding(*box)):
                return True
            return (self._layout or self._lay_out()).others_within(asker, *box)

    def _update_along(self, asker: int, points: Sequence[Point]) -> None:
        xs, ys = zip(*points, strict=True)
        self._update(asker, min(xs), min(ys), max(xs), max(ys))

    def changes_for(self, asker: int) -> int:
        """Another number whenever something was moved that is not the asker itself."""
        return self._changes - self._own_changes.get(asker, 0)

    def guarded(self, guard: float) -> float:
        """Prepare for ``free_way`` with that distance (metres). Answers the one that is really kept."""
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
        from sim.layout import Layout  # pymunk, a third of a start: loaded at the first movement

        self._layout = Layout(self.scene, self._start, self._now, self._groups, self._guards)
        return self._layout


_SQUARE = 1.0
"""Metres: the side of a square in which glides are looked for."""


def _squares(left: float, bottom: float, right: float, top: float) -> list[tuple[int, int]]:
    columns = range(floor(left / _SQUARE), floor(right / _SQUARE) + 1)
    rows = range(floor(bottom / _SQUARE), floor(top / _SQUARE) + 1)
    return [(column, row) for column in columns for row in rows]


def _at_once() -> Now:
    return 0.0, 0.0


def _nothing() -> None: ...


def _things(scene: Scene) -> list[Model]:
    """What stands for itself and is no robot."""
    robots = frozenset(scene.robots)
    return [model for model in scene.models if model.parent is None and model.index not in robots]
