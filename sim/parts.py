"""The polygons of a world, each where it is now: obstacles and visible things. Values only.

A robot's ``Body`` is everything of it that can bump: its shape, what is attached to it, and what it holds.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import dist, hypot

from msgspec import Struct

from sim.colours import Colour
from sim.geometry import Edge, Placement, Point, contains, edges, nearest_on_edge, placed, seen_from
from sim.scene import Model, Scene

BODY, SIGHT, RANGED = 1, 2, 4
"""Categories of parts: everything; what eyes can't see through; what rangers notice."""


class Part(Struct, frozen=True):
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


ROUND = 0.9
"""A body whose inner circle is at least this part of its outer one turns like a disc, in the outer one."""

Outline = tuple[Point, ...]


class Body(Struct, frozen=True):
    """Polygons in the robot's own frame."""

    polygons: tuple[Outline, ...]
    radius: float
    """Metres from its centre of rotation to its farthest point."""
    is_round: bool

    def outline(self, angle: float) -> tuple[Edge, ...]:
        """Its edges when it looks to ``angle``, around the origin."""
        return tuple(edge for points in self.polygons for edge in edges(placed(points, 0.0, 0.0, angle)))

    def holding(self, held: Iterable[Outline]) -> Body:
        """The same body with more polygons, in its frame."""
        return _body((*self.polygons, *held))


def body_of(scene: Scene, robot: int) -> Body:
    """The robot's own shape, solid whatever its file says, and everything solid that is attached to it."""
    frame = scene.models[robot].pose
    solid = (model for model in scene.tree(robot) if model.solid or model.index == robot)
    outlines = (points for model in solid for points in model.outlines())
    return _body(tuple(seen_from(points, frame.x, frame.y, frame.yaw) for points in outlines))


def _body(polygons: tuple[Outline, ...]) -> Body:
    radius = max((hypot(x, y) for points in polygons for x, y in points), default=0.0)
    inner = max((_inner_radius(points) for points in polygons), default=0.0)
    return Body(polygons, radius, inner >= ROUND * radius)


def _inner_radius(points: Outline) -> float:
    if not contains(points, 0.0, 0.0):
        return 0.0
    return min(hypot(*nearest_on_edge(edge)) for edge in edges(points))
