"""The parts of a world as pymunk bodies, in layers, for collisions and sight.

Only this module and ``rays`` know pymunk. A ray of pymunk's with a radius can't be trusted: its trees are
searched with the thin ray (measured: two of three thick rays through a field of boxes missed). So a sweep
asks ``index`` for a box of candidates, and the quick test for a free way sends a thin ray through a thickened
layer.

The ground decides where movable parts are and which robot holds what, and owns the lock for all of this. A
layer is built from the parts at the start and then moved, so it is the same whenever it is built.
"""

from __future__ import annotations

import atexit
import gc
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from math import inf, nextafter, radians
from weakref import WeakSet

import pymunk

from sim.geometry import (
    HAIR,
    Placement,
    Point,
    Wedge,
    contains,
    edges,
    nearest_seen,
    placed,
)
from sim.index import NO_ROOT, Box, Entry, InView, MovingRoots, StillParts, Views, entries_of, is_whole
from sim.parts import BODY, NOTHING, RANGED, SIGHT, Part, Sighted, parts_of
from sim.rays import Hit, Rays
from sim.scene import Scene


class Layer:
    """The ranks of parts by place. A part belongs to a root; a movable root has its own body.

    A question is about all but a ``group``, those of a ``category``.
    """

    def __init__(self, parts: Iterable[Part], thickness: float, movable: Mapping[int, Placement]) -> None:
        """``movable``: the roots that may move, and where each is now, as ``parts`` are."""
        self._space = pymunk.Space()
        _ALIVE.add(self)
        self._thickness = thickness
        self._rank_of: dict[pymunk.Shape, int] = {}
        self._rays: Rays[int] = Rays(self._space)
        self._start = dict(movable)
        self._bodies = {root: self._moving_body() for root in movable}
        for part in parts:
            self._add(part)

    def first_hits(
        self, x: float, y: float, ends: Sequence[Point], group: int, category: int, but: frozenset[int]
    ) -> list[Hit[int]]:
        """The parts that rays from one place to each of ``ends`` hit first, and where on the way.

        Ignores the parts ``but``.
        """
        wanted = _filter(group, category)
        if not but:
            return self._rays.first_hits(x, y, ends, wanted)
        return [self._first_hit_but(x, y, end, wanted, but) for end in ends]

    def _first_hit_but(
        self, x: float, y: float, end: Point, wanted: pymunk.ShapeFilter, but: frozenset[int]
    ) -> Hit[int]:
        met = self._space.segment_query((x, y), end, 0.0, wanted)
        ranked = [(hit.alpha, self._rank_of[hit.shape]) for hit in met if hit.shape is not None]
        alpha, rank = min((hit for hit in ranked if hit[1] not in but), default=(1.0, None))
        return rank, alpha

    def room(self, x: float, y: float, most: float) -> float:
        """Metres from a place to the nearest part, at most ``most``; below 0 inside of one."""
        return self._rays.distance(x, y, most)

    def move(self, root: int, now: Placement) -> None:
        """Put a movable root there."""
        start, body = self._start[root], self._bodies[root]
        turn = now.yaw - start.yaw
        ((dx, dy),) = placed(((start.x, start.y),), 0.0, 0.0, turn)
        body.angle = radians(turn)
        body.position = now.x - dx, now.y - dy
        self._space.reindex_shapes_for_body(body)

    def group(self, root: int, group: int) -> None:
        """Put a movable root's shapes into a group (0: none); a query for a group skips its shapes."""
        for shape in self._bodies[root].shapes:
            before = shape.filter
            shape.filter = pymunk.ShapeFilter(group, before.categories, before.mask)

    def free(self) -> None:
        """Free pymunk's memory; the layer can't be used afterwards."""
        self._rays.clear()
        del self._rays, self._space
        self._bodies.clear()
        self._rank_of.clear()

    def _moving_body(self) -> pymunk.Body:
        body = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
        self._space.add(body)
        return body

    def _add(self, part: Part) -> None:
        body = self._bodies.get(part.root, self._space.static_body)
        sight = (SIGHT if part.seen or part.solid else 0) | (RANGED if part.seen else 0)
        category = pymunk.ShapeFilter(categories=BODY | sight)
        for shape in _shapes(body, part, self._thickness):
            shape.filter = category
            self._rank_of[shape] = part.rank
            self._rays.own(shape, part.rank)
            self._space.add(shape)


_NONE = frozenset[int]()
_ALIVE: WeakSet[Layer] = WeakSet()


@cache
def _filter(group: int, category: int) -> pymunk.ShapeFilter:
    return pymunk.ShapeFilter(group, mask=category)


@atexit.register
def _free_all() -> None:
    """Free all layers at exit: pymunk calls back into Python, which crashes at the interpreter's end."""
    for each in tuple(_ALIVE):
        each.free()
    gc.collect()


def _shapes(body: pymunk.Body, part: Part, radius: float) -> Iterable[pymunk.Shape]:
    """Shapes for its polygon, ``radius`` thicker: the polygon if it is whole, else its edges."""
    if is_whole(part):
        return [pymunk.Poly(body, part.points, radius=radius)]
    return [pymunk.Segment(body, (ax, ay), (bx, by), radius) for ax, ay, bx, by in edges(part.points)]


_THIN = 0.0
"""Metres by which everything is thickened for rays."""
MOST_ROOM = 5.0
"""Metres: no more room than that is looked for."""


class Layout:
    """All parts of a scene, behind the queries of ``Ground``."""

    def __init__(
        self,
        scene: Scene,
        start: Mapping[int, Placement],
        now: Mapping[int, Placement],
        groups: Mapping[int, int],
        guards: Iterable[float],
    ) -> None:
        """``now`` and ``groups`` belong to the ground, which calls ``changed`` and ``group`` for them."""
        self._start, self._now, self._groups = start, now, groups
        self.at_start = tuple(parts_of(scene))
        self._parts = list(self.at_start)
        self._ranks: dict[int, list[int]] = {root: [] for root in start}
        for part in self.at_start:
            if part.root in self._ranks:
                self._ranks[part.root].append(part.rank)
        self._still = StillParts([part for part in self.at_start if part.root not in start])
        at_start = {root: [self.at_start[rank] for rank in ranks] for root, ranks in self._ranks.items()}
        self._views = Views(self._still)
        self.moving = MovingRoots(at_start, start)
        self._of_root = {root: tuple(parts) for root, parts in at_start.items()}
        """The parts of movable roots, where these were when they were last placed."""
        self._entries: dict[int, list[Entry]] = {}
        """Of these parts, as far as a box was asked for since."""
        self._whole = {part.rank: is_whole(part) for parts in at_start.values() for part in parts}
        self._frames: dict[int, tuple[Point, ...]] = {}
        """Parts that have moved, by rank, as seen from their roots."""
        self._unplaced = set[int]()
        """The movable roots whose parts were not placed since they moved."""
        for root, place in now.items():
            if place != start[root]:
                self.moving.move(root, place)
                self._unplaced.add(root)
        self._layers: dict[float, _Kept] = {}
        """Of what may move, by the distance that is kept; of everything, for the distance 0."""
        self._still_layers: dict[float, Layer] = {}
        """The same of what never moves."""
        for guard in guards:
            self.keep(guard)
        self.around_start = {root: self._inside_of(root) for root in start}
        """The parts of others inside which a movable root stands at the start."""

    def keep(self, guard: float) -> None:
        """Make layers for ``free_way`` and ``still_room`` with that distance (metres)."""
        if guard not in self._layers:
            wanted = [part for part in self.at_start if part.solid or part.seen]
            still = [part for part in wanted if part.root not in self._start]
            self._still_layers[guard] = Layer(still, guard, {})
            self._layers[guard] = self._made([part for part in wanted if part.root in self._start], guard)

    def changed(self, root: int) -> None:
        """Note that a root has moved."""
        self._unplaced.add(root)
        for kept in self._layers.values():
            kept.stale.add(root)

    def group(self, root: int) -> None:
        """Note that a root belongs to another robot now, or to none."""
        for kept in self._layers.values():
            kept.layer.group(root, self._groups[root])

    def parts(self) -> Sequence[Part]:
        """Everything, in order."""
        for root in tuple(self._unplaced):
            self._place_parts(root)
        return self._parts

    def parts_of(self, root: int) -> tuple[Part, ...]:
        """The parts of a movable root."""
        if root in self._unplaced:
            self._place_parts(root)
        return self._of_root[root]

    def within(
        self, asker: int, roots: Iterable[int], box: Box, but: frozenset[int], has_still: bool = True
    ) -> list[Part]:
        """As ``Ground.within``. ``roots``: the movable ones that may be in the box."""
        left, bottom, right, top = box
        found = self._still.within(left, bottom, right, top) if has_still else {}
        group, groups = asker + 1, self._groups
        for root in roots:
            if groups.get(root, 0) == group:
                continue
            for its_left, its_bottom, its_right, its_top, part in self._entries_of(root):
                if its_left <= right and left <= its_right and its_bottom <= top and bottom <= its_top:
                    found[part.rank] = part
        if len(found) < 2:
            return [part for rank, part in found.items() if rank not in but]
        return [found[rank] for rank in sorted(found) if rank not in but]

    def first_hits(
        self, asker: int, x: float, y: float, ends: Sequence[Point], ranging: bool, but: frozenset[int]
    ) -> list[Hit[Part]]:
        category = RANGED if ranging else SIGHT
        if _THIN not in self._layers:  # many robots never look along rays
            self._layers[_THIN] = self._made(self.at_start, _THIN)
        hits = self._updated(self._layers[_THIN], asker).first_hits(x, y, ends, asker + 1, category, but)
        return [(None if rank is None else self._placed(rank), way) for rank, way in hits]

    def nearest_still(self, wedge: Wedge, height: float | None, but: frozenset[int]) -> Sighted:
        """As ``Ground.nearest``, for still parts."""
        reach, views = wedge.reach, self._views
        known = views.first
        while True:
            known, in_view = views.of(wedge, known if known < reach else reach)
            found = _nearest(in_view, wedge, height, but, NOTHING) if in_view else NOTHING
            if known >= reach or found[0] <= known:
                return found
            known *= 2.0

    def nearest_moving(
        self,
        asker: int,
        roots: Iterable[int],
        wedge: Wedge,
        height: float | None,
        but: frozenset[int],
        nearest: Sighted,
    ) -> Sighted:
        """As ``nearest_still``, for the movable ``roots``, compared with the ``nearest`` so far."""
        group, groups = asker + 1, self._groups
        views = [
            (0.0, part.rank, *part.middle, part.reach + HAIR, part)
            for root in roots
            if groups.get(root, 0) != group
            for part in self.parts_of(root)
            if part.seen
        ]
        return _nearest(views, wedge, height, but, nearest) if views else nearest

    def free_of_still(self, x: float, y: float, end: Point, guard: float, but: frozenset[int]) -> float:
        return self._still_layers[guard].first_hits(x, y, (end,), 0, BODY, but)[0][1]

    def free_of_moving(
        self, asker: int, x: float, y: float, end: Point, guard: float, but: frozenset[int]
    ) -> float:
        moving = self._updated(self._layers[guard], asker)
        return moving.first_hits(x, y, (end,), asker + 1, BODY, but)[0][1]

    def still_room(self, x: float, y: float, guard: float) -> float:
        return self._still_layers[guard].room(x, y, MOST_ROOM)

    def has_others(self, asker: int, roots: Iterable[int]) -> bool:
        """Whether any of these roots is not part of the asker's body."""
        group, groups = asker + 1, self._groups
        return any(groups.get(root, 0) != group for root in roots)

    # --- inside

    def _inside_of(self, root: int) -> tuple[Part, ...]:
        here = self._start[root]
        box = (here.x, here.y, here.x, here.y)
        close = self.within(root, self.moving.within(NO_ROOT, *box), box, frozenset())
        return tuple(part for part in close if part.root != root and contains(part.points, here.x, here.y))

    def _updated(self, kept: _Kept, asker: int) -> Layer:
        """The layer for the asker, except the asker's own parts, which it does not see."""
        if kept.stale:
            self._update(kept, asker)
        return kept.layer

    def _made(self, parts: Iterable[Part], thickness: float) -> _Kept:
        kept = _Kept(Layer(parts, thickness, self._start))
        for root, group in self._groups.items():
            kept.layer.group(root, group)
        kept.stale.update(root for root, now in self._now.items() if now != self._start[root])
        return kept

    def _update(self, kept: _Kept, asker: int) -> None:
        """Update a layer after movements, except the asker's own."""
        stale = kept.stale
        if len(stale) == 1 and asker in stale:
            return
        for root in stale:
            kept.layer.move(root, self._now[root])
        stale.clear()

    def _placed(self, rank: int) -> Part:
        """The part at its current place."""
        root = self.at_start[rank].root
        if root in self._unplaced:
            self._place_parts(root)
        return self._parts[rank]

    def _entries_of(self, root: int) -> list[Entry]:
        parts, entries = self.parts_of(root), self._entries.get(root)
        if entries is None:
            whole = self._whole
            entries = [entry for part in parts for entry in entries_of(part, whole[part.rank])]
            self._entries[root] = entries
        return entries

    def _place_parts(self, root: int) -> None:
        start, now = self._start[root], self._now[root]
        self._unplaced.discard(root)
        self._entries.pop(root, None)
        for rank in self._ranks[root]:
            part = self.at_start[rank]
            if rank not in self._frames:
                self._frames[rank] = part.seen_from(start)
            self._parts[rank] = part if now == start else part.moved(self._frames[rank], now)
        self._of_root[root] = tuple([self._parts[rank] for rank in self._ranks[root]])


def _nearest(
    views: Iterable[InView], wedge: Wedge, height: float | None, but: frozenset[int], nearest: Sighted
) -> Sighted:
    """The nearest thing in the wedge. ``nearest`` was found before; of two equally near, the first counts.

    ``views``: the nearest first.
    """
    x, y, facing, aside = wedge.x, wedge.y, wedge.facing, wedge.aside
    (c, s), (wc, ws), (least, found) = facing, aside, nearest
    most = nextafter(min(least, wedge.reach), inf)
    for bound, rank, its_x, its_y, radius, part in views:
        if bound > most:
            break
        dx, dy = its_x - x, its_y - y
        along = dx * c + dy * s
        if abs(dy * c - dx * s) * wc - along * ws > radius or along - radius > most or rank in but:
            continue
        if height is None or part.bottom <= height <= part.top:
            is_inside = dx * dx + dy * dy <= radius * radius and contains(part.points, x, y)
            metres = 0.0 if is_inside else nearest_seen(part.points, x, y, facing, aside, most)
            if metres < most and (found is None or metres < least or rank < found.rank):
                least, found, most = metres, part, nextafter(metres, inf)
    return least, found


class _Kept:
    """A layer, and the roots that moved since its last query."""

    __slots__ = ("layer", "stale")

    def __init__(self, layer: Layer) -> None:
        self.layer = layer
        self.stale: set[int] = set()
