"""The polygons of a world at their current places: obstacles and visible things. Values only.

A robot's ``Body`` is everything of it that can bump: its shape, what is attached to it, and what it holds.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from heapq import heappop, heappush
from itertools import chain, islice
from math import dist, hypot, inf

from msgspec import Struct

from devices.ports.robot import STEP
from sim.colours import Colour
from sim.geometry import Edge, Placement, Point, contains, edges, nearest_on_edge, placed, seen_from
from sim.scene import Model, Scene

BODY, SIGHT, RANGED = 1, 2, 4
"""Categories of parts: everything; what eyes can't see through; what rangers notice."""


class Part(Struct, frozen=True):
    """A polygon of the world at its place. Equal only to itself."""

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

    @property
    def outline(self) -> tuple[Edge, ...]:
        """Its edges."""
        return edges(self.points)

    def seen_from(self, start: Placement) -> tuple[Point, ...]:
        """Its points, the place of its model and its middle, in the frame of a top-level model."""
        return seen_from((*self.points, self.place, self.middle), start.x, start.y, start.yaw)

    def moved(self, local: Sequence[Point], now: Placement) -> Part:
        """The polygon with its top-level model at ``now``. ``local``: the result of ``seen_from``."""
        *points, place, middle = placed(local, now.x, now.y, now.yaw)
        return Part(
            self.rank,
            self.root,
            self.model,
            place,
            self.bottom,
            self.top,
            tuple(points),
            middle,
            self.reach,
            self.solid,
            self.seen,
            self.colour,
            self.blob,
        )


Sighted = tuple[float, Part | None]
"""What a sensor sees, if anything, and how many metres away."""
NOTHING: Sighted = (inf, None)


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
    return middle, max([dist(middle, point) for point in points])


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


_ROOMS = (0.3, 0.12)
"""Metres around its middle that are free, the first for which there is a place: for 4 steps, or for 1."""
_FITS = 0.07
"""Metres that Donnie takes, rounded up."""
_REACH = 60
"""Steps to each side that are tried."""
_MOST_CHECKS = 1_000_000
"""Places times polygons that are compared."""

Square = tuple[int, int]
"""A place in steps."""


def free_place(scene: Scene) -> Square:
    """A free place, nearest to 0, 0, or to the middle of walls that exclude 0, 0.

    From where Donnie fits that is nearest, a way leads there: it starts in the room that is drawn around.
    """
    solid = [each for each in parts_of(scene) if each.solid]
    if not solid:
        return 0, 0
    xs, ys = zip(*(point for part in solid for point in part.points), strict=True)
    (west, east), (south, north) = (min(xs) / STEP, max(xs) / STEP), (min(ys) / STEP, max(ys) / STEP)
    is_inside = west < 0 < east and south < 0 < north
    is_walled = len(solid) > 1 and min(east - west, north - south) > 4
    middle = (0, 0) if is_inside or not is_walled else (round((west + east) / 2), round((south + north) / 2))
    most, reached = max(1, _MOST_CHECKS // len(solid)), list[Square]()

    def is_free(at: Square, room: float) -> bool:
        return not any(_is_near(part, at[0] * STEP, at[1] * STEP, room) for part in solid)

    def fits(at: Square) -> bool:
        return is_free(at, _FITS)

    places = [*islice(_around(*middle), most)]
    within = ((x, y) for x, y in places if west < x < east and south < y < north)
    start = next(filter(fits, chain(within if is_walled else (), places)), middle)
    for at in islice(_flooded(start, middle, fits), most):
        if is_free(at, _ROOMS[0]):
            return at
        reached.append(at)
    return next((at for room in _ROOMS[1:] for at in reached if is_free(at, room)), start)


def _around(x: int, y: int) -> Iterator[Square]:
    """Places, the nearest first; of equally near ones the northern and eastern first."""
    sides = range(-_REACH, _REACH + 1)
    near = sorted((_nearness(dx, dy), dx, dy) for dx in sides for dy in sides)
    return ((x + dx, y + dy) for _, dx, dy in near)


def _nearness(dx: int, dy: int) -> tuple[float, int, int]:
    return hypot(dx, dy), -dy, -dx


def _flooded(start: Square, middle: Square, fits: Callable[[Square], bool]) -> Iterator[Square]:
    """The places to which a way leads from ``start``, those near ``middle`` first."""
    seen, waiting = {start}, [(_nearness(start[0] - middle[0], start[1] - middle[1]), start)]
    while waiting:
        _, (x, y) = heappop(waiting)
        yield x, y
        for at in ((x, y + 1), (x + 1, y), (x, y - 1), (x - 1, y)):
            dx, dy = at[0] - middle[0], at[1] - middle[1]
            if at not in seen and max(abs(dx), abs(dy)) <= _REACH:
                seen.add(at)
                if fits(at):
                    heappush(waiting, (_nearness(dx, dy), at))


def _is_near(part: Part, x: float, y: float, room: float) -> bool:
    (px, py), reach = part.middle, part.reach + room
    if (x - px) ** 2 + (y - py) ** 2 > reach * reach:
        return False
    if contains(part.points, x, y):
        return True
    near = (nearest_on_edge((ax - x, ay - y, bx - x, by - y)) for ax, ay, bx, by in part.outline)
    return any(hypot(*each) < room for each in near)
