"""The world as bodies: which things are where, found fast. Only this room and the rays know pymunk.

pymunk finds what could be touched or seen (its trees, its rays); exact contacts are computed in geometry.
A ray of pymunk's with a radius must not be trusted: its trees are searched with the thin ray (measured: of
thick rays through a field of boxes two in three missed). So a sweep asks for a box of candidates, and the
quick test for a free way sends a thin ray through bodies that are that much thicker.
"""

from __future__ import annotations

import atexit
import gc
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from weakref import WeakSet

import pymunk

from sim.colours import Colour
from sim.geometry import Edge, Point, contains, edges, is_convex, signed_area
from sim.rays import Hit, Rays
from sim.scene import Model, Scene

_BODY, _SIGHT, _RANGED = 1, 2, 4


@dataclass(frozen=True, slots=True, eq=False)
class Part:
    """One polygon of the world, where it lies."""

    rank: int
    """Its number in the world: queries answer in this order, so that runs repeat exactly."""
    root: int
    """The index of the top-level model to which it belongs."""
    model: Model
    """The model whose polygon it is."""
    place: Point
    """Where that model stands."""
    bottom: float
    """Metres above the floor."""
    top: float
    points: tuple[Point, ...]
    outline: tuple[Edge, ...]
    solid: bool
    seen: bool
    """Whether rangers see it."""
    colour: Colour
    blob: bool
    """Whether blobfinders notice it."""


class Surroundings:
    """Everything around one robot: the parts of all other models, none of which moves.

    A part inside which the robot's centre stands from the start, such as a floor drawn as a box, is not there
    for it.
    ``guard`` (metres): ``free_way`` keeps that distance from everything.
    """

    def __init__(self, scene: Scene, robot: int, guard: float) -> None:
        here = scene.models[robot].pose
        everything = list(_parts(scene, robot))
        self.parts = tuple(part for part in everything if not contains(part.points, here.x, here.y))
        self.stands_in = tuple(
            dict.fromkeys(part.root for part in everything if contains(part.points, here.x, here.y))
        )
        self._space, self._halo = pymunk.Space(), pymunk.Space()
        _ALIVE.add(self)
        self._owner: dict[pymunk.Shape, Part] = {}
        self._rays: Rays[Part] = Rays(self._space)
        for part in self.parts:
            self._add(part, guard)

    def near(self, x: float, y: float, reach: float) -> tuple[Part, ...]:
        """All parts that come within ``reach`` of a place, and perhaps some more, in order."""
        return self.within(x - reach, y - reach, x + reach, y + reach)

    def within(self, left: float, bottom: float, right: float, top: float) -> tuple[Part, ...]:
        """All parts that come into a box, and perhaps some more, in order."""
        found = self._space.bb_query(pymunk.BB(left, bottom, right, top), pymunk.ShapeFilter())
        return tuple(sorted({self._owner[shape] for shape in found}, key=_rank)) if found else ()

    def first_hits(self, x: float, y: float, ends: Sequence[Point], ranging: bool = False) -> list[Hit[Part]]:
        """The parts that looks from one place to each of ``ends`` meet first, and where on the way.

        ``ranging``: as a ranger sees, to which some things are invisible.
        """
        return self._rays.first_hits(x, y, ends, _TO_RANGERS if ranging else _TO_EYES)

    def free_way(self, x: float, y: float, to_x: float, to_y: float) -> float:
        """The part of the way, from 0 to 1, on which nothing comes nearer than the guard distance."""
        hit = self._halo.segment_query_first((x, y), (to_x, to_y), 0.0, pymunk.ShapeFilter())
        return 1.0 if hit is None else hit.alpha

    def free(self) -> None:
        """Give pymunk's memory back. Nothing may be asked from now on."""
        del self._rays, self._space, self._halo
        self._owner.clear()

    def _add(self, part: Part, guard: float) -> None:
        sight = (_SIGHT if part.seen or part.solid else 0) | (_RANGED if part.seen else 0)
        category = pymunk.ShapeFilter(categories=_BODY | sight)
        for shape in _bodies(self._space, part.points, 0.0):
            shape.filter = category
            self._owner[shape] = part
            self._rays.own(shape, part)
            self._space.add(shape)
        if part.solid or part.seen:
            self._halo.add(*_bodies(self._halo, part.points, guard))


_TO_EYES, _TO_RANGERS = pymunk.ShapeFilter(mask=_SIGHT), pymunk.ShapeFilter(mask=_RANGED)

_ALIVE: WeakSet[Surroundings] = WeakSet()


@atexit.register
def _free_all() -> None:
    """pymunk frees a space by calls back into Python, which are gone at the interpreter's end: a crash."""
    for each in tuple(_ALIVE):
        each.free()
    gc.collect()


def _rank(part: Part) -> int:
    return part.rank


def _parts(scene: Scene, robot: int) -> Iterator[Part]:
    rank = 0
    for model in scene.models:
        if model.root != robot:
            for points, (bottom, top) in zip(model.outlines(), model.heights(), strict=True):
                yield _part(scene, model, rank, points, bottom, top)
                rank += 1


def _part(
    scene: Scene, model: Model, rank: int, points: tuple[Point, ...], bottom: float, top: float
) -> Part:
    return Part(
        rank=rank,
        root=model.root,
        model=model,
        place=(model.pose.x, model.pose.y),
        bottom=bottom,
        top=top,
        points=points,
        outline=edges(points),
        solid=model.solid or model.index in scene.robots,
        seen=model.seen,
        colour=model.colour,
        blob=model.blob_return != 0,
    )


def _bodies(space: pymunk.Space, points: tuple[Point, ...], radius: float) -> Iterable[pymunk.Shape]:
    """A polygon for pymunk, ``radius`` thicker: as it is where it is convex, else its edges."""
    if abs(signed_area(points)) > 1e-9 and is_convex(points):
        return [pymunk.Poly(space.static_body, points, radius=radius)]
    return [pymunk.Segment(space.static_body, (ax, ay), (bx, by), radius) for ax, ay, bx, by in edges(points)]
