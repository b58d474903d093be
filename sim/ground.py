"""Where everything of a world is now: one ground that all its robots share, from any thread.

Robots, and things that can be pushed or gripped, may be put elsewhere; the rest lies still. What was moved is
worked out when somebody asks for it, so that a robot alone pays nothing for moving. The first question, or
the first movement, loads pymunk and lays everything out: until then all is where it started.
"""

from __future__ import annotations

import threading
from collections.abc import Mapping, Sequence
from math import ceil, log
from typing import TYPE_CHECKING

from sim.geometry import Point, contains
from sim.parts import BODY, RANGED, SIGHT, Part, parts_of
from sim.placement import Placement
from sim.scene import Model, Scene

if TYPE_CHECKING:
    from sim.layer import Layer
    from sim.rays import Hit

_FINENESS = 1.1
"""Guard distances are rounded up to powers of this, so that many kinds of robots share a few layers."""

MOST_ROOM = 5.0
"""Metres: no more room than that is looked for."""


class Ground:
    """The parts of a scene. ``root`` is always the index of a top-level model."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.pushable = frozenset(model.index for model in _things(scene) if model.pushable)
        """The roots of things that give way to a robot."""
        self.grippable = frozenset(model.index for model in _things(scene) if model.grippable)
        """The roots of things that a gripper can take."""
        self._lock = threading.RLock()
        self._at_start = tuple(parts_of(scene))
        movable = sorted({*scene.robots, *self.pushable, *self.grippable})
        self._start = {root: scene.models[root].pose for root in movable}
        self._now = dict(self._start)
        self._groups: dict[int, int] = {root: root + 1 for root in scene.robots}
        self._parts = list(self._at_start)
        self._ranks: dict[int, list[int]] = {root: [] for root in self._start}
        for part in self._at_start:
            if part.root in self._ranks:
                self._ranks[part.root].append(part.rank)
        self._changes = 0
        self._own_changes: dict[int, int] = {}
        self.fastest = 0.0
        """Metres a second: no point of anything that moves in its turn is faster."""
        self.jumps = 0
        """Counts what moved out of turn, or became faster: what was known to be far may be near now."""
        self._layers: dict[float, _Kept] = {}
        self._guards: dict[float, None] = {}
        """The guard distances that were asked for before it has begun."""
        self._around_start: dict[int, tuple[Part, ...]] = {}

    def begin(self) -> None:
        """Lay everything out, unless that was done: it takes longer than all the rest of a world's start."""
        with self._lock:
            if not self._layers:
                for thickness in (0.0, *self._guards):
                    self._layer(thickness)
                self._around_start = {root: self._inside_of(root) for root in self._start}

    # --- where things are

    @property
    def movable(self) -> frozenset[int]:
        """The roots that may be put elsewhere: robots, and things to push or to grip."""
        return frozenset(self._start)

    def place(self, root: int) -> Placement:
        """Where a movable root is now."""
        return self._now[root]

    def start(self, root: int) -> Placement:
        return self._start[root]

    def around_start(self, root: int) -> tuple[Part, ...]:
        """The parts of others inside which a movable root stands at the start."""
        self.begin()
        return self._around_start[root]

    def put(self, root: int, now: Placement) -> None:
        """Put a movable root there."""
        with self._lock:
            if now != self._now[root]:
                self.begin()
            self._now[root] = now
            self._changes += 1
            self._own_changes[root] = self._own_changes.get(root, 0) + 1
            for kept in self._layers.values():
                kept.stale.add(root)

    def quicken(self, speed: float) -> None:
        """Something may be that fast from now on (metres a second)."""
        if speed > self.fastest:
            self.fastest = speed
            self.jumps += 1

    def put_things_back(self) -> None:
        """To where they started, but for those that a robot holds."""
        for root in self.moved():
            if root not in self.scene.robots and not self.is_attached(root):
                self.put(root, self._start[root])
                self.jumps += 1

    def moved(self) -> Mapping[int, Placement]:
        """The movable roots that are not where they started, and where they are."""
        with self._lock:
            return {root: now for root, now in self._now.items() if now != self._start[root]}

    def attach(self, root: int, robot: int | None) -> None:
        """A thing is part of that robot's body from now on; of none if it is None."""
        with self._lock:
            self._groups[root] = 0 if robot is None else robot + 1
            self.jumps += 1
            self._changes += 1
            for kept in self._layers.values():
                kept.layer.group(root, self._groups[root])

    def is_attached(self, root: int) -> bool:
        """Whether a robot holds that thing."""
        return self._groups.get(root, 0) != 0 and root not in self.scene.robots

    # --- what robots ask. ``asker``: its own body, and what is attached to it, is not there for it

    def parts(self) -> tuple[Part, ...]:
        """Everything, in order."""
        with self._lock:
            self._bring_up_parts()
            return tuple(self._parts)

    def parts_of(self, root: int) -> tuple[Part, ...]:
        """The parts of a movable root."""
        with self._lock:
            self._bring_up_parts()
            return tuple(self._parts[rank] for rank in self._ranks[root])

    def within(
        self, asker: int, left: float, bottom: float, right: float, top: float, but: frozenset[int]
    ) -> list[Part]:
        """All parts that come into a box, and perhaps some more, in order; without the ranks ``but``."""
        with self._lock:
            ranks = self._layer_for(asker, 0.0).within(left, bottom, right, top)
            group, groups, parts = asker + 1, self._groups, self._parts
            found = [parts[rank] for rank in sorted(ranks - but)]
            return [part for part in found if groups.get(part.root, 0) != group]

    def first_hits(
        self, asker: int, x: float, y: float, ends: Sequence[Point], ranging: bool, but: frozenset[int]
    ) -> list[Hit[Part]]:
        """What looks from one place to each of ``ends`` meet first, and where on the way."""
        category = RANGED if ranging else SIGHT
        with self._lock:
            hits = self._layer_for(asker, 0.0).first_hits(x, y, ends, asker + 1, category, but)
            return [(None if rank is None else self._parts[rank], way) for rank, way in hits]

    def free_way(
        self, asker: int, x: float, y: float, end: Point, guard: float, but: frozenset[int]
    ) -> float:
        """The part of the way, from 0 to 1, on which nothing comes nearer than ``guard``.

        That is one that ``guarded`` has answered.
        """
        with self._lock:
            return self._layer_for(asker, guard).first_hits(x, y, (end,), asker + 1, BODY, but)[0][1]

    def room(self, asker: int, x: float, y: float, guard: float) -> float:
        """How far round a place nothing comes nearer than ``guard``, some metres at most; below 0: none."""
        with self._lock:
            return self._layer_for(asker, guard).room(x, y, MOST_ROOM, asker + 1)

    def changes_for(self, asker: int) -> int:
        """Another number whenever something was moved that is not the asker itself."""
        return self._changes - self._own_changes.get(asker, 0)

    def guarded(self, guard: float) -> float:
        """Prepare for ``free_way`` with that distance (metres). Answers the one that is really kept."""
        rounded: float = _FINENESS ** ceil(log(guard) / log(_FINENESS))
        with self._lock:
            if not self._layers:
                self._guards[rounded] = None
            elif rounded not in self._layers:
                self._bring_up_parts()
                self._layer(rounded)
        return rounded

    # --- inside

    def _inside_of(self, root: int) -> tuple[Part, ...]:
        here = self._start[root]
        close = self.within(root, here.x, here.y, here.x, here.y, frozenset())
        return tuple(part for part in close if part.root != root and contains(part.points, here.x, here.y))

    def _layer_for(self, asker: int, thickness: float) -> Layer:
        """The layer as it is now for a question of ``asker``. Under the lock, as all that follows."""
        if not self._layers:
            self.begin()
        kept = self._layers[thickness]
        if kept.stale:
            self._bring_up(kept, asker)
        return kept.layer

    def _layer(self, thickness: float) -> None:
        from sim.layer import Layer  # pymunk: a third of a start, and for those who move only

        wanted = (
            self._parts if thickness == 0.0 else [part for part in self._parts if part.solid or part.seen]
        )
        kept = _Kept(Layer(wanted, thickness, self._now))
        for root, group in self._groups.items():
            kept.layer.group(root, group)
        self._layers[thickness] = kept

    def _bring_up_parts(self) -> None:
        if self._layers:
            self._bring_up(self._layers[0.0], None)

    def _bring_up(self, kept: _Kept, asker: int | None) -> None:
        """Let a layer know what was moved, but for the asker itself."""
        stale = kept.stale
        if len(stale) == 1 and asker in stale:
            return
        for root in stale:
            kept.layer.move(root, self._now[root])
            if kept is self._layers[0.0]:
                self._place_parts(root)
        stale.clear()

    def _place_parts(self, root: int) -> None:
        start, now = self._start[root], self._now[root]
        for rank in self._ranks[root]:
            part = self._at_start[rank]
            self._parts[rank] = part if now == start else part.moved(start, now)


class _Kept:
    """A layer, and what was moved since it was last asked."""

    __slots__ = ("layer", "stale")

    def __init__(self, layer: Layer) -> None:
        self.layer = layer
        self.stale: set[int] = set()


def _things(scene: Scene) -> list[Model]:
    """What stands for itself and is no robot."""
    robots = frozenset(scene.robots)
    return [model for model in scene.models if model.parent is None and model.index not in robots]
