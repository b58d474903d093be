"""What there is to meet and to see in a world: its parts where they lie now, found fast by layers of them.

Where the movable roots are, and which robot holds what, is the ground's to say, and so is the lock under
which all of this happens. A layer is built of the parts at the start and has moved what moved since, so it is
the same whenever it is made.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from sim.geometry import Point, contains
from sim.layer import Layer
from sim.parts import BODY, RANGED, SIGHT, Part, parts_of
from sim.placement import Placement
from sim.rays import Hit
from sim.scene import Scene

MOST_ROOM = 5.0
"""Metres: no more room than that is looked for."""


class Layout:
    """All parts of a scene. For what robots ask see ``Ground``."""

    def __init__(
        self,
        scene: Scene,
        start: Mapping[int, Placement],
        now: Mapping[int, Placement],
        groups: Mapping[int, int],
        guards: Iterable[float],
    ) -> None:
        """``now`` and ``groups`` are the ground's own: ``changed`` and ``group`` tell that they differ."""
        self._start, self._now, self._groups = start, now, groups
        self._at_start = tuple(parts_of(scene))
        self._parts = list(self._at_start)
        self._ranks: dict[int, list[int]] = {root: [] for root in start}
        for part in self._at_start:
            if part.root in self._ranks:
                self._ranks[part.root].append(part.rank)
        self._thin = self._made(self._at_start, 0.0)
        self._layers = {0.0: self._thin}
        for guard in guards:
            self.keep(guard)
        self.around_start = {root: self._inside_of(root) for root in start}
        """The parts of others inside which a movable root stands at the start."""

    def keep(self, guard: float) -> None:
        """Have a layer for ``free_way`` and ``room`` with that distance (metres)."""
        if guard not in self._layers:
            wanted = [part for part in self._at_start if part.solid or part.seen]
            self._layers[guard] = self._made(wanted, guard)

    def changed(self, root: int) -> None:
        """It is elsewhere now."""
        for kept in self._layers.values():
            kept.stale.add(root)

    def group(self, root: int) -> None:
        """It belongs to another robot now, or to none."""
        for kept in self._layers.values():
            kept.layer.group(root, self._groups[root])

    def parts(self) -> Sequence[Part]:
        """Everything, in order."""
        self._bring_up(self._thin, None)
        return self._parts

    def parts_of(self, root: int) -> tuple[Part, ...]:
        """The parts of a movable root."""
        self._bring_up(self._thin, None)
        return tuple(self._parts[rank] for rank in self._ranks[root])

    def within(
        self, asker: int, left: float, bottom: float, right: float, top: float, but: frozenset[int]
    ) -> list[Part]:
        ranks = self._layer_for(asker, 0.0).within(left, bottom, right, top)
        group, groups, parts = asker + 1, self._groups, self._parts
        found = [parts[rank] for rank in sorted(ranks - but)]
        return [part for part in found if groups.get(part.root, 0) != group]

    def first_hits(
        self, asker: int, x: float, y: float, ends: Sequence[Point], ranging: bool, but: frozenset[int]
    ) -> list[Hit[Part]]:
        category = RANGED if ranging else SIGHT
        hits = self._layer_for(asker, 0.0).first_hits(x, y, ends, asker + 1, category, but)
        return [(None if rank is None else self._parts[rank], way) for rank, way in hits]

    def free_way(
        self, asker: int, x: float, y: float, end: Point, guard: float, but: frozenset[int]
    ) -> float:
        return self._layer_for(asker, guard).first_hits(x, y, (end,), asker + 1, BODY, but)[0][1]

    def room(self, asker: int, x: float, y: float, guard: float) -> float:
        return self._layer_for(asker, guard).room(x, y, MOST_ROOM, asker + 1)

    # --- inside

    def _inside_of(self, root: int) -> tuple[Part, ...]:
        here = self._start[root]
        close = self.within(root, here.x, here.y, here.x, here.y, frozenset())
        return tuple(part for part in close if part.root != root and contains(part.points, here.x, here.y))

    def _layer_for(self, asker: int, thickness: float) -> Layer:
        """Up to date for who asks, but for where that one is itself: it doesn't see itself."""
        kept = self._layers[thickness]
        if kept.stale:
            self._bring_up(kept, asker)
        return kept.layer

    def _made(self, parts: Iterable[Part], thickness: float) -> _Kept:
        kept = _Kept(Layer(parts, thickness, self._start))
        for root, group in self._groups.items():
            kept.layer.group(root, group)
        kept.stale.update(root for root, now in self._now.items() if now != self._start[root])
        return kept

    def _bring_up(self, kept: _Kept, asker: int | None) -> None:
        """Let a layer know what was moved, but for the asker itself."""
        stale = kept.stale
        if len(stale) == 1 and asker in stale:
            return
        for root in stale:
            kept.layer.move(root, self._now[root])
            if kept is self._thin:
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
