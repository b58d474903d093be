"""The parts of a world as bodies of pymunk, all thickened by the same amount: found fast, moved cheaply.

Only this room and the rays know pymunk. A ray of pymunk's with a radius must not be trusted: its trees are
searched with the thin ray (measured: of thick rays through a field of boxes two in three missed). So a sweep
asks for a box of candidates, and the quick test for a free way sends a thin ray through a thickened layer.
"""

from __future__ import annotations

import atexit
import gc
from collections.abc import Iterable, Mapping, Sequence
from math import radians
from weakref import WeakSet

import pymunk

from sim.geometry import Point, edges, is_convex, placed, signed_area
from sim.parts import BODY, RANGED, SIGHT, Part
from sim.placement import Placement
from sim.rays import Hit, Rays


class Layer:
    """Ranks of parts, by place. A part belongs to a root; a root that may move has a body of its own.

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

    def within(self, left: float, bottom: float, right: float, top: float) -> set[int]:
        """All parts that come into a box, and perhaps some more."""
        found = self._space.bb_query(pymunk.BB(left, bottom, right, top), _ANY)
        return {self._rank_of[shape] for shape in found}

    def first_hits(
        self, x: float, y: float, ends: Sequence[Point], group: int, category: int, but: frozenset[int]
    ) -> list[Hit[int]]:
        """What looks from one place to each of ``ends`` meet first, and where on the way.

        As if the parts ``but`` were not there.
        """
        wanted = pymunk.ShapeFilter(group, mask=category)
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

    def room(self, x: float, y: float, most: float, group: int) -> float:
        """Metres from a place to the nearest part, at most ``most``; below 0 inside of one."""
        nearest = self._space.point_query_nearest((x, y), most, pymunk.ShapeFilter(group))
        return most if nearest is None else nearest.distance

    def move(self, root: int, now: Placement) -> None:
        """Put a movable root there."""
        start, body = self._start[root], self._bodies[root]
        turn = now.yaw - start.yaw
        ((dx, dy),) = placed(((start.x, start.y),), 0.0, 0.0, turn)
        body.angle = radians(turn)
        body.position = now.x - dx, now.y - dy
        self._space.reindex_shapes_for_body(body)

    def group(self, root: int, group: int) -> None:
        """Give a movable root's shapes to a group (0: to none): who asks for a group does not see it."""
        for shape in self._bodies[root].shapes:
            before = shape.filter
            shape.filter = pymunk.ShapeFilter(group, before.categories, before.mask)

    def free(self) -> None:
        """Give pymunk's memory back. Nothing may be asked from now on."""
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
        for shape in _shapes(body, part.points, self._thickness):
            shape.filter = category
            self._rank_of[shape] = part.rank
            self._rays.own(shape, part.rank)
            self._space.add(shape)


_ANY = pymunk.ShapeFilter()
_ALIVE: WeakSet[Layer] = WeakSet()


@atexit.register
def _free_all() -> None:
    """pymunk frees a space by calls back into Python, which are gone at the interpreter's end: a crash."""
    for each in tuple(_ALIVE):
        each.free()
    gc.collect()


def _shapes(body: pymunk.Body, points: tuple[Point, ...], radius: float) -> Iterable[pymunk.Shape]:
    """A polygon for pymunk, ``radius`` thicker: as it is where it is convex, else its edges."""
    if abs(signed_area(points)) > 1e-9 and is_convex(points):
        return [pymunk.Poly(body, points, radius=radius)]
    return [pymunk.Segment(body, (ax, ay), (bx, by), radius) for ax, ay, bx, by in edges(points)]
