"""The shapes of models: blocks scaled to a size, the default block, the walls of a boundary."""

from __future__ import annotations

from collections.abc import Iterable

from sim.geometry import Placement, Point, placed
from sim.scene import Gripper, Polygon
from sim.worldfile.entities import Entity
from sim.worldfile.mistakes import Code, WorldError
from sim.worldfile.values import ValueReader

MOST_POINTS = 2000
"""Points of one block."""
WALL = 0.01
"""Metres: the thickness of a boundary."""

UNIT = Polygon(((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)), 0.0, 1.0)


def block(reader: ValueReader, entity: Entity) -> Polygon:
    """One block as it is written, not scaled yet."""
    count = reader.number(entity.settings, "points", 0)
    if not 3 <= count <= MOST_POINTS or count != int(count):
        raise WorldError(
            Code.TOO_FEW_POINTS,
            entity.file,
            entity.line,
            entity.column,
            ("3",),
            given=int(count) if count == int(count) else count,
            limit=MOST_POINTS,
        )
    points = tuple(_point(reader, entity, i) for i in range(int(count)))
    bottom, top = reader.pair(entity.settings["z"]) if "z" in entity.settings else (0.0, 1.0)
    return Polygon(points, min(bottom, top), max(bottom, top))


def _point(reader: ValueReader, entity: Entity, i: int) -> Point:
    name = f"point[{i}]"
    if name not in entity.settings:
        raise WorldError(Code.MISSING_POINT, entity.file, entity.line, entity.column, (name,), name=name)
    return reader.pair(entity.settings[name])


def rectangle(x: float, y: float, width: float, depth: float, top: float = 1.0) -> Polygon:
    """A block between (x, y) and the corner opposite."""
    return Polygon(((x, y), (x + width, y), (x + width, y + depth), (x, y + depth)), 0.0, top)


def gripper(it: Gripper, closed: float, lifted: float) -> tuple[Polygon, ...]:
    """The three blocks of Stage's gripper, as parts of its size: the base, the right and the left paddle.

    ``closed``: from 0, open, to 1, when the paddles meet. ``lifted``: from 0, at the floor, to 1.
    """
    base, width = 1.0 - it.paddle_length, it.paddle_width
    inwards = closed * (0.5 - width)
    bottom = lifted * (1.0 - it.paddle_height)
    paddles = (rectangle(base, y, it.paddle_length, width) for y in (inwards, 1.0 - width - inwards))
    risen = (Polygon(paddle.points, bottom, bottom + it.paddle_height) for paddle in paddles)
    return (rectangle(0.0, 0.0, base, 1.0), *risen)


def fitted(
    polygons: tuple[Polygon, ...], size: tuple[float, float, float], origin: Placement
) -> tuple[Polygon, ...]:
    """All blocks of a model together scaled and centred to its size, then shifted by its origin."""
    xs = [x for polygon in polygons for x, _ in polygon.points]
    ys = [y for polygon in polygons for _, y in polygon.points]
    if not xs:
        return ()
    scale_x, middle_x = _fit(xs, size[0])
    scale_y, middle_y = _fit(ys, size[1])
    top = max(polygon.top for polygon in polygons)
    scale_z = size[2] / top if top > 0 else 1.0

    def moved(points: Iterable[Point]) -> tuple[Point, ...]:
        flat = (((x - middle_x) * scale_x, (y - middle_y) * scale_y) for x, y in points)
        return placed(flat, origin.x, origin.y, origin.yaw)

    return tuple(Polygon(moved(p.points), p.bottom * scale_z, p.top * scale_z) for p in polygons)


def _fit(values: list[float], size: float) -> tuple[float, float]:
    low, high = min(values), max(values)
    return (size / (high - low) if high > low else 1.0), (low + high) / 2


def boundary(size: tuple[float, float, float], origin: Placement) -> tuple[Polygon, ...]:
    """Four thin walls inside the bounding box."""
    width, depth, height = size
    across, along = min(WALL, width / 2), min(WALL, depth / 2)
    x, y = -width / 2, -depth / 2
    walls = (
        rectangle(x, y, width, along, height),
        rectangle(x, -y - along, width, along, height),
        rectangle(x, y, across, depth, height),
        rectangle(-x - across, y, across, depth, height),
    )
    return tuple(Polygon(placed(wall.points, origin.x, origin.y, origin.yaw), 0.0, height) for wall in walls)


def has_default_block(kind: str, walled: bool) -> bool:
    """Whether a model without blocks is a box; what only looks has no body, what has walls is just these."""
    return kind not in ("ranger", "blobfinder", "fiducial") and not walled
