"""Many rays at once through a pymunk space: what each hits first, and where; and how near anything is.

pymunk's public methods make four objects for each answer. Its library, called directly, is several times as
fast and gives the same result to the last bit (``benchmarks/rays.py``). That interface is private: where it
is missing, or a small trial differs from the public methods, these are used.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any, Generic, TypeVar

import pymunk

from sim.geometry import Point

Owner = TypeVar("Owner")
Hit = tuple[Owner | None, float]
"""Whose shape is hit first, and the part of the way up to there, 1 if nothing is hit."""

_Finder = Callable[[float, float, Sequence[Point], pymunk.ShapeFilter], list[Hit[Owner]]]


class Rays(Generic[Owner]):
    """The rays of one space. Every shape in it must have been given an owner."""

    def __init__(self, space: pymunk.Space, *, direct: bool = True) -> None:
        """``direct=False``: by pymunk's public method only."""
        self._space = space
        self._owners: dict[object, Owner] = {}
        library = _library() if direct else None
        self._key: Callable[[pymunk.Shape], object] = _itself if library is None else _pointer
        self.first_hits: _Finder[Owner] = (
            self._by_method if library is None else _direct(library, space, self._owners)
        )
        """What each of the thin rays from (x, y) to ``ends`` meets first, in their order."""
        self.distance: Callable[[float, float, float], float] = (
            self._distance_by_method if library is None else _direct_distance(library, space)
        )
        """Metres from a place to the nearest shape, at most that many; below 0 inside of one."""

    def own(self, shape: pymunk.Shape, owner: Owner) -> None:
        """Rays that hit ``shape`` return ``owner`` from now on."""
        self._owners[self._key(shape)] = owner

    def clear(self) -> None:
        """Every shape has left the space."""
        self._owners.clear()

    def _distance_by_method(self, x: float, y: float, most: float) -> float:
        nearest = self._space.point_query_nearest((x, y), most, _ANY)
        return most if nearest is None else nearest.distance

    def _by_method(
        self, x: float, y: float, ends: Sequence[Point], shapes: pymunk.ShapeFilter
    ) -> list[Hit[Owner]]:
        hits: list[Hit[Owner]] = []
        for end in ends:
            hit = self._space.segment_query_first((x, y), end, 0.0, shapes)
            if hit is None or hit.shape is None:
                hits.append((None, 1.0))
            else:
                hits.append((self._owners[hit.shape], hit.alpha))
        return hits


_ANY = pymunk.ShapeFilter()


def _itself(shape: pymunk.Shape) -> object:
    return shape


def _pointer(shape: pymunk.Shape) -> object:
    return shape._shape


def _direct(library: Any, space: pymunk.Space, owners: dict[object, Any]) -> _Finder[Any]:
    """A function that asks the library itself. ``library`` is pymunk's private module, which has no types."""
    ask, new = library.lib.cpSpaceSegmentQueryFirst, library.ffi.new
    info, start, end = new("cpSegmentQueryInfo *"), new("cpVect *")[0], new("cpVect *")
    inner, to = space._space, end[0]

    @cache
    def wanted_of(shapes: pymunk.ShapeFilter) -> Any:
        """Made once for each robot."""
        return new("cpShapeFilter *", tuple(shapes))[0]

    def first_hits(x: float, y: float, ends: Sequence[Point], shapes: pymunk.ShapeFilter) -> list[Hit[Any]]:
        start.x, start.y = x, y
        wanted = wanted_of(shapes)
        hits: list[Hit[Any]] = []
        for to.x, to.y in ends:
            shape = ask(inner, start, to, 0.0, wanted, info)
            hits.append((owners[shape], info.alpha) if shape else (None, 1.0))
        return hits

    return first_hits


def _direct_distance(library: Any, space: pymunk.Space) -> Callable[[float, float, float], float]:
    """The same for the distance of the nearest shape."""
    ask, new = library.lib.cpSpacePointQueryNearest, library.ffi.new
    info, place, wanted = new("cpPointQueryInfo *"), new("cpVect *"), new("cpShapeFilter *", tuple(_ANY))[0]
    inner, at = space._space, place[0]

    def distance(x: float, y: float, most: float) -> float:
        place.x, place.y = x, y
        return info.distance if ask(inner, at, most, wanted, info) else most

    return distance


@cache
def _library() -> Any:
    """pymunk's private module, or None if it is not as it was; Any, as it has no types."""
    try:
        library = importlib.import_module("pymunk._chipmunk_cffi")
        broken = (AttributeError, TypeError, KeyError, ValueError, library.ffi.error)
    except (ImportError, AttributeError):
        return None
    try:
        return library if _trial(library) else None
    except broken:
        return None


def _trial(library: Any) -> bool:
    """Whether both ways give the same, of a ray that hits and one that does not."""
    space = pymunk.Space()
    box = pymunk.Poly.create_box(space.static_body, (2.0, 2.0))
    space.add(box)
    by_method: Rays[str] = Rays(space, direct=False)
    by_method.own(box, "box")
    question = (-3.0, 0.5, ((3.0, 0.7), (-3.0, 9.0)), pymunk.ShapeFilter(mask=1))
    direct = _direct(library, space, {_pointer(box): "box"})
    if direct(*question) != by_method.first_hits(*question):
        return False
    distance, places = _direct_distance(library, space), ((3.0, 0.2, 5.0), (3.0, 0.2, 1.0), (0.5, 0.2, 5.0))
    return all(distance(*each) == by_method.distance(*each) for each in places)
