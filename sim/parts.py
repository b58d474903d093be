"""The polygons of a world, each where it lies now: what there is to bump into and to see. Values only."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import dist

from devices.ports.values import frozen
from sim.colours import Colour
from sim.geometry import Edge, Point, edges, placed, seen_from
from sim.placement import Placement
from sim.scene import Model, Scene

BODY, SIGHT, RANGED = 1, 2, 4
"""Categories of parts: everything; what eyes can't see through; what rangers notice."""


@frozen
class Part:
    """One polygon of the world, where it lies. Equal to nothing but itself."""

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
    middle: Point
    """Of a circle around all of it."""
    reach: float
    """That circle's radius."""
    solid: bool
    seen: bool
    """Whether rangers see it."""
    colour: Colour
    blob: bool
    """Whether blobfinders notice it."""

    __eq__ = object.__eq__
    __hash__ = object.__hash__

    def moved(self, start: Placement, now: Placement) -> Part:
        """The same polygon after its top-level model went from ``start`` to ``now``."""
        local = seen_from((*self.points, self.place), start.x, start.y, start.yaw)
        *points, place = placed(local, now.x, now.y, now.yaw)
        return Part(
            self.rank,
            self.root,
            self.model,
            place,
            self.bottom,
            self.top,
            tuple(points),
            edges(points),
            *_circle(points),
            self.solid,
            self.seen,
            self.colour,
            self.blob,
        )


def parts_of(scene: Scene) -> Iterator[Part]:
    """Every polygon of the world at its start, in order."""
    rank = 0
    robots = frozenset(scene.robots)
    for model in scene.models:
        for points, (bottom, top) in zip(model.outlines(), model.heights(), strict=True):
            yield _part(model, rank, points, bottom, top, model.index in robots)
            rank += 1


def _part(
    model: Model, rank: int, points: tuple[Point, ...], bottom: float, top: float, is_robot: bool
) -> Part:
    middle, reach = _circle(points)
    return Part(
        rank=rank,
        root=model.root,
        model=model,
        place=(model.pose.x, model.pose.y),
        bottom=bottom,
        top=top,
        points=points,
        outline=edges(points),
        middle=middle,
        reach=reach,
        solid=model.solid or is_robot,
        seen=model.seen,
        colour=model.colour,
        blob=model.blob_return != 0,
    )


def _circle(points: Sequence[Point]) -> tuple[Point, float]:
    """A circle around a polygon, not the smallest one."""
    xs, ys = zip(*points, strict=True)
    middle = (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
    return middle, max(dist(middle, point) for point in points)
