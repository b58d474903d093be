"""Plane geometry: points, angles and poses in, numbers out. Metres, and degrees counter-clockwise from x.

Angles stay degrees, as world files and learners give them, so that right angles stay exact. Sweeps look along
the positive x axis: callers turn the scene so that the motion goes there. ``pose_of`` converts to the port's
steps and compass degrees.

A raster lists the squares of a grid that a polygon covers, row by row, in time that grows with its edges and
rows. A square counts if it shares more than a border with the polygon; squares may be taken smaller than the
grid's cells, so that touching the rim of a cell does not count.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from math import atan2, ceil, cos, degrees, floor, hypot, inf, radians, sin, sqrt

from msgspec import Struct

from devices.ports.robot import STEP, Pose

Point = tuple[float, float]
Edge = tuple[float, float, float, float]
"""x and y of both ends."""

HAIR = 1e-9
"""The largest rounding error, in metres."""
_QUARTERS = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))


@lru_cache(maxsize=4096)
def direction(angle: float) -> Point:
    """The unit vector at ``angle``; exact at multiples of 90."""
    turned = angle % 360.0
    if turned % 90.0 == 0.0:
        return _QUARTERS[int(turned // 90.0) % 4]
    turned = radians(turned)
    return cos(turned), sin(turned)


def angle_of(x: float, y: float) -> float:
    """The angle of a vector, above -180 to 180."""
    return degrees(atan2(y, x))


def normal(angle: float) -> float:
    """The same angle, from above -180 to 180."""
    turned = angle % 360.0
    return turned - 360.0 if turned > 180.0 else turned


def placed(points: Iterable[Point], x: float, y: float, angle: float) -> tuple[Point, ...]:
    """Points of a frame that lies at (x, y), turned by ``angle``, seen from outside it."""
    c, s = direction(angle)
    return tuple([(x + c * px - s * py, y + s * px + c * py) for px, py in points])


def seen_from(points: Iterable[Point], x: float, y: float, angle: float) -> tuple[Point, ...]:
    """The reverse of ``placed``: points from outside, seen from a frame at (x, y), turned by ``angle``."""
    c, s = direction(angle)
    return tuple([(c * (px - x) + s * (py - y), c * (py - y) - s * (px - x)) for px, py in points])


def edges(points: Sequence[Point]) -> tuple[Edge, ...]:
    """The edges of a closed polygon."""
    return tuple([(*points[i - 1], *points[i]) for i in range(len(points))])


def signed_area(points: Sequence[Point]) -> float:
    """Square metres, positive where the points run counter-clockwise."""
    return sum(ax * by - bx * ay for ax, ay, bx, by in edges(points)) / 2


def is_convex(points: Sequence[Point]) -> bool:
    """Whether no corner turns the other way (and the outline goes round once)."""
    count = len(points)
    signs = set()
    turned = 0.0
    for i in range(count):
        (ax, ay), (bx, by), (cx, cy) = points[i - 2], points[i - 1], points[i]
        cross = (bx - ax) * (cy - by) - (by - ay) * (cx - bx)
        turned += atan2(cross, (bx - ax) * (cx - bx) + (by - ay) * (cy - by))
        if cross != 0.0:
            signs.add(cross > 0.0)
    return len(signs) <= 1 and abs(turned) < 7.0


def contains(points: Sequence[Point], x: float, y: float) -> bool:
    """Whether the point lies inside the polygon (even-odd)."""
    inside = False
    ax, ay = points[-1]
    for bx, by in points:
        if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
            inside = not inside
        ax, ay = bx, by
    return inside


def nearest_on_edge(edge: Edge) -> Point:
    """The point of the edge that is nearest to the origin."""
    ax, ay, bx, by = edge
    dx, dy = bx - ax, by - ay
    length2 = dx * dx + dy * dy
    t = -(ax * dx + ay * dy) / length2 if length2 else 0.0
    if t <= 0.0:
        t = 0.0
    elif t > 1.0:
        t = 1.0
    return ax + t * dx, ay + t * dy


def nearest_seen(
    points: Sequence[Point], x: float, y: float, facing: Point, aside: Point, most: float = inf
) -> float:
    """``nearest_in_wedge`` of a polygon from (x, y), where the wedge's middle and half angle are directions.

    The same to the last bit, but nothing beyond ``most`` is looked for. Most readings are made this way.
    """
    (c, s), (wc, ws) = facing, aside
    px, py = points[-1]
    bx, by = c * (px - x) + s * (py - y), c * (py - y) - s * (px - x)
    left_b, right_b = ws * bx - wc * by, ws * bx + wc * by
    nearest = most
    for px, py in points:
        ax, ay, left_a, right_a = bx, by, left_b, right_b
        dx, dy = px - x, py - y
        bx, by = c * dx + s * dy, c * dy - s * dx
        along, across = ws * bx, wc * by
        left_b, right_b = along - across, along + across
        if (
            (left_a < 0.0 and left_b < 0.0)
            or (right_a < 0.0 and right_b < 0.0)
            or (ax < 0.0 and bx < 0.0)
            or (ax > nearest and bx > nearest)
        ):
            continue
        part = _clipped((ax, ay, bx, by), left_a, left_b, right_a, right_b)
        if part is not None:
            nearest = min(nearest, hypot(*nearest_on_edge(part)))
    return nearest


class Wedge(Struct, frozen=True):
    """A narrow cone on the floor: up to 45 degrees to either side of its middle."""

    x: float
    y: float
    yaw: float
    facing: Point
    """The direction of its middle, which is ``yaw``."""
    aside: Point
    """The direction of its half angle."""
    reach: float

    def metres(self, points: Sequence[Point], middle: Point, radius: float, most: float) -> float:
        """To a polygon in a circle: 0 inside of it, ``most`` where it isn't in the wedge, or farther."""
        x, y = self.x, self.y
        dx, dy, near = middle[0] - x, middle[1] - y, radius + HAIR
        if dx * dx + dy * dy <= near * near and contains(points, x, y):
            return 0.0
        return nearest_seen(points, x, y, self.facing, self.aside, most)


def nearest_in_wedge(outline: Iterable[Edge], half_angle: float) -> float:
    """The distance from the origin to the nearest point of the edges within a wedge, or infinity.

    The wedge reaches ``half_angle`` degrees (at most 90) to either side of the positive x axis.
    """
    point = nearest_point_in_wedge(outline, half_angle)
    return inf if point is None else hypot(*point)


def nearest_point_in_wedge(outline: Iterable[Edge], half_angle: float) -> Point | None:
    """That point itself; None if there is none."""
    c, s = direction(half_angle)
    parts = (_in_wedge(edge, c, s) for edge in outline)
    points = (nearest_on_edge(part) for part in parts if part is not None)
    return min(points, key=lambda point: hypot(*point), default=None)


def _in_wedge(edge: Edge, c: float, s: float) -> Edge | None:
    """The part of the edge within the wedge whose half angle has that cosine and sine."""
    ax, ay, bx, by = edge
    left_a, left_b = s * ax - c * ay, s * bx - c * by
    right_a, right_b = s * ax + c * ay, s * bx + c * by
    if (left_a < 0.0 and left_b < 0.0) or (right_a < 0.0 and right_b < 0.0) or (ax < 0.0 and bx < 0.0):
        return None
    return _clipped(edge, left_a, left_b, right_a, right_b)


def _clipped(edge: Edge, left_a: float, left_b: float, right_a: float, right_b: float) -> Edge | None:
    """The part of the edge whose ends ``a`` and ``b`` are so far within both sides of a wedge."""
    ax, ay, bx, by = edge
    start, end = 0.0, 1.0
    if left_a < 0.0:
        start = left_a / (left_a - left_b)
    elif left_b < 0.0:
        end = left_a / (left_a - left_b)
    if right_a < 0.0:
        start = max(start, right_a / (right_a - right_b))
    elif right_b < 0.0:
        end = min(end, right_a / (right_a - right_b))
    if ax < 0.0:
        start = max(start, ax / (ax - bx))
    elif bx < 0.0:
        end = min(end, ax / (ax - bx))
    if start > end:
        return None
    return ax + start * (bx - ax), ay + start * (by - ay), ax + end * (bx - ax), ay + end * (by - ay)


def disc_contact(radius: float, edge: Edge, skin: float = 0.0) -> float:
    """How far a disc moves along x from the origin until it is within ``skin`` of the edge, or infinity.

    A disc that touches already may leave: it is stopped only if it would come nearer. What it would pass
    without its skin is not met.
    """
    contact = _disc_contact(radius + skin, edge)
    return inf if skin and contact < inf and _disc_contact(radius, edge) == inf else contact


def _disc_contact(radius: float, edge: Edge) -> float:
    x, y = nearest_on_edge(edge)
    if x * x + y * y <= radius * radius:
        return 0.0 if x > 1e-12 else inf
    ax, ay, bx, by = edge
    contacts = [_point_contact(radius, ax, ay), _point_contact(radius, bx, by)]
    length = hypot(bx - ax, by - ay)
    if length > 0.0:
        contacts.append(_face_contact(radius, edge, length))
    return min(contacts)


def _point_contact(radius: float, x: float, y: float) -> float:
    if abs(y) >= radius or x < 0.0:
        return inf
    return max(0.0, x - sqrt(radius * radius - y * y))


def _face_contact(radius: float, edge: Edge, length: float) -> float:
    """Where the disc touches the inside of the edge, not its ends."""
    ax, ay, bx, by = edge
    nx, ny = (by - ay) / length, (ax - bx) / length
    if nx > 0.0:
        nx, ny = -nx, -ny
    if nx > -1e-12:
        return inf
    contact = (nx * ax + ny * ay + radius) / nx
    along = ((contact - radius * nx - ax) * (bx - ax) + (-radius * ny - ay) * (by - ay)) / (length * length)
    # after a stop the two lie as far apart as they touch, but for what computing errs
    return max(0.0, contact) if contact >= -1e-9 and 0.0 <= along <= 1.0 else inf


def outline_contact(mover: Sequence[Edge], obstacle: Sequence[Edge]) -> tuple[float, float]:
    """How far the mover's edges go along x until they touch the obstacle's, or infinity.

    Second: about how squarely they meet, from 0 (grazing) to 1. What the mover passes does not touch it,
    even without a gap between them.
    """
    nearest, squarely = inf, 1.0
    if passes_by(mover, obstacle):
        return nearest, squarely
    others = [(other, min(other[0], other[2])) for other in obstacle]
    for mine in mover:
        end = max(mine[0], mine[2])
        for other, start in others:
            if start - end > nearest + 1e-9:  # farther than what was found
                continue
            contact = _edge_gap(mine, other)
            if contact < nearest:
                nearest, squarely = contact, max(_slope(mine), _slope(other))
    return nearest, squarely


def passes_by(mover: Iterable[Edge], obstacle: Sequence[Edge]) -> bool:
    """Whether the mover passes the obstacle, or only slides along its side, on its way along x."""
    ys, others = [edge[1] for edge in mover], [edge[1] for edge in obstacle]
    return min(others) > max(ys, default=-inf) - HAIR or max(others) < min(ys, default=inf) + HAIR


def _edge_gap(mine: Edge, other: Edge) -> float:
    """The least gap along x between two edges where their heights overlap.

    Without min and max, which take most of the time: nothing is asked as often as this.
    """
    ax, ay, bx, by = mine
    cx, cy, dx, dy = other
    low, high = (by, ay) if by < ay else (ay, by)
    its_low, its_high = (dy, cy) if dy < cy else (cy, dy)
    if its_low > low:
        low = its_low
    if its_high < high:
        high = its_high
    if low > high:
        return inf
    if cy == dy:
        first = last = dx if dx < cx else cx
    else:
        first, last = cx + (low - cy) * (dx - cx) / (dy - cy), cx + (high - cy) * (dx - cx) / (dy - cy)
    if ay == by:
        end = bx if bx > ax else ax
        first, last = first - end, last - end
    else:
        first -= ax + (low - ay) * (bx - ax) / (by - ay)
        last -= ax + (high - ay) * (bx - ax) / (by - ay)
    if first < -1e-9 and last < -1e-9:
        return inf
    gap = last if last < first else first
    return gap if gap > 0.0 else 0.0


def _slope(edge: Edge) -> float:
    length = hypot(edge[2] - edge[0], edge[3] - edge[1])
    return abs(edge[3] - edge[1]) / length if length > 0.0 else 1.0


def turn_contact(mover: Sequence[Edge], obstacle: Sequence[Edge], sign: int) -> float:
    """Degrees that the mover turns round the origin until it touches the obstacle, or infinity.

    ``sign`` is 1 for counter-clockwise, -1 for clockwise.
    """
    nearest = inf
    for ax, ay, _, _ in mover:
        nearest = min(nearest, _arc_contact(ax, ay, obstacle, sign))
    for ax, ay, _, _ in obstacle:
        nearest = min(nearest, _arc_contact(ax, ay, mover, -sign))
    return nearest


def _arc_contact(x: float, y: float, outline: Iterable[Edge], sign: int) -> float:
    """Degrees that the point turns round the origin until it meets one of the edges."""
    radius, start, nearest = hypot(x, y), angle_of(x, y), inf
    for edge in outline:
        for px, py in at_radius(radius, edge):
            turned = (sign * (angle_of(px, py) - start)) % 360.0
            nearest = min(nearest, 0.0 if turned > 360.0 - 1e-7 else turned)
    return nearest


def at_radius(radius: float, edge: Edge) -> list[Point]:
    """The points of the edge at that distance from the origin."""
    ax, ay, bx, by = edge
    dx, dy = bx - ax, by - ay
    a, b, c = dx * dx + dy * dy, ax * dx + ay * dy, ax * ax + ay * ay - radius * radius
    root = b * b - a * c
    if a == 0.0 or root < 0.0:
        return []
    solutions = ((-b - sqrt(root)) / a, (-b + sqrt(root)) / a)
    return [(ax + t * dx, ay + t * dy) for t in solutions if 0.0 <= t <= 1.0]


def overlapping(mine: Sequence[Point], other: Sequence[Point]) -> bool:
    """Whether two polygons share more than a border."""
    if contains(other, *mine[0]) or contains(mine, *other[0]):
        return True
    others = edges(other)
    for ax, ay, bx, by in edges(mine):
        dx, dy = bx - ax, by - ay
        sides = [dx * (y - ay) - dy * (x - ax) for x, y in other]
        for i, edge in enumerate(others):
            if sides[i - 1] * sides[i] < 0.0 and _divides(edge, (ax, ay, bx, by)):
                return True
    return False


def _divides(line: Edge, edge: Edge) -> bool:
    """Whether the ends of an edge lie on the two sides of a line."""
    ax, ay, bx, by = line
    first = (bx - ax) * (edge[1] - ay) - (by - ay) * (edge[0] - ax)
    second = (bx - ax) * (edge[3] - ay) - (by - ay) * (edge[2] - ax)
    return first * second < 0.0


def along(ray: Edge, edge: Edge) -> float:
    """The part of the way along ``ray``, from 0 to 1, at which it meets the edge, or infinity."""
    ax, ay, bx, by = ray
    cx, cy, dx, dy = edge
    rx, ry, ex, ey = bx - ax, by - ay, dx - cx, dy - cy
    across = rx * ey - ry * ex
    if across == 0.0:
        return inf
    part = ((cx - ax) * ey - (cy - ay) * ex) / across
    on_edge = ((cx - ax) * ry - (cy - ay) * rx) / across
    return part if 0.0 <= part <= 1.0 and 0.0 <= on_edge <= 1.0 else inf


def edges_apart(mine: Edge, other: Edge) -> float:
    """The least distance between two edges."""
    if along(mine, other) <= 1.0:
        return 0.0
    ends = ((mine, other), (other, mine))
    return min(point_apart(edge[i], edge[i + 1], against) for edge, against in ends for i in (0, 2))


def point_apart(x: float, y: float, edge: Edge) -> float:
    """The distance of a point from an edge."""
    ax, ay, bx, by = edge
    return hypot(*nearest_on_edge((ax - x, ay - y, bx - x, by - y)))


class Placement(Struct, frozen=True):
    """Where something stands and where it looks."""

    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    yaw: float = 0.0

    def then(self, inner: Placement, lift: float = 0.0) -> Placement:
        """Where ``inner``, given relative to this, is outside; ``lift`` is added to its height."""
        c, s = direction(self.yaw)
        return Placement(
            self.x + c * inner.x - s * inner.y,
            self.y + s * inner.x + c * inner.y,
            self.z + lift + inner.z,
            self.yaw + inner.yaw,
        )

    def within_a_turn(self) -> Placement:
        """The same pose with its heading from 0 to below 360."""
        return Placement(self.x, self.y, self.z, self.yaw % 360.0)


def relative(inner: Placement, outer: Placement) -> Placement:
    """Where something is in the frame of something else; the reverse of ``Placement.then``."""
    ((x, y),) = seen_from(((inner.x, inner.y),), outer.x, outer.y, outer.yaw)
    return Placement(x, y, inner.z - outer.z, inner.yaw - outer.yaw)


class Spot(Struct, frozen=True):
    """Where a robot, or something on it, is and where it looks."""

    x: float
    y: float
    yaw: float

    def ahead(self, metres: float, angle: float) -> Spot:
        """The spot that lies that far in the direction ``angle`` (of the world), looking the same way."""
        dx, dy = direction(angle)
        return Spot(self.x + metres * dx, self.y + metres * dy, self.yaw)

    def mounted(self, x: float, y: float, yaw: float) -> Spot:
        """The spot of something that is mounted there, in the frame of this one."""
        c, s = direction(self.yaw)  # as ``placed`` does it
        return Spot(self.x + c * x - s * y, self.y + s * x + c * y, self.yaw + yaw)


def pose_of(spot: Spot | Placement) -> Pose:
    """Rounded far below what matters, so that three steps are not 2.9999; adding 0 makes -0 a plain 0."""
    heading = 90.0 - spot.yaw
    if heading % 1.0:  # rarely; rounding takes longest
        heading = round(heading % 360.0, 9)
    heading %= 360.0
    return Pose(round(spot.x / STEP, 9) + 0.0, round(spot.y / STEP, 9) + 0.0, heading)


_FUZZ = 1e-9


class Raster(Struct, frozen=True):
    """A grid. The middle of its cell 0, 0 is at ``left``, ``bottom``."""

    left: float
    bottom: float
    cell: float
    width: int
    height: int


def covered(outline: tuple[Point, ...], raster: Raster, half: float) -> Iterator[tuple[int, int, int]]:
    """Row, first and last column of stretches of squares, each reaching ``half`` from its middle.

    Stretches may overlap.
    """
    crossings: dict[int, list[float]] = {}
    for edge in edges(outline):
        yield from _along(edge, raster, half)
        for row, x in _crossed(edge, raster):
            crossings.setdefault(row, []).append(x)
    for row, xs in crossings.items():
        xs.sort()
        for first, last in zip(xs[::2], xs[1::2], strict=True):
            yield from _stretch(row, first, last, raster, half)


def _along(edge: Edge, raster: Raster, half: float) -> Iterator[tuple[int, int, int]]:
    """The squares through which an edge goes."""
    ax, ay, bx, by = edge
    low, high = min(ay, by), max(ay, by)
    for row in _cells(low, high, raster.bottom, raster.cell, half, raster.height):
        middle = raster.bottom + row * raster.cell
        ends = [_crossing_x(edge, min(high, max(low, y))) for y in (middle - half, middle + half)]
        if ay == by:
            ends = [ax, bx]
        yield from _stretch(row, min(ends), max(ends), raster, half)


def _crossed(edge: Edge, raster: Raster) -> Iterator[tuple[int, float]]:
    """Where an edge crosses the middle lines of rows; its lower end counts, its upper one does not."""
    low, high = min(edge[1], edge[3]), max(edge[1], edge[3])
    first = max(0, ceil((low - raster.bottom) / raster.cell))
    last = min(raster.height - 1, ceil((high - raster.bottom) / raster.cell) - 1)
    for row in range(first, last + 1):
        yield row, _crossing_x(edge, raster.bottom + row * raster.cell)


def _stretch(
    row: int, first: float, last: float, raster: Raster, half: float
) -> Iterator[tuple[int, int, int]]:
    columns = _cells(first, last, raster.left, raster.cell, half, raster.width)
    if columns:
        yield row, columns[0], columns[-1]


def _cells(low: float, high: float, start: float, cell: float, half: float, count: int) -> range:
    """The cells whose squares reach between ``low`` and ``high``, more than their borders."""
    first = floor((low - half - start) / cell + _FUZZ) + 1
    last = ceil((high + half - start) / cell - _FUZZ) - 1
    return range(max(0, first), min(count - 1, last) + 1)


def _crossing_x(edge: Edge, y: float) -> float:
    ax, ay, bx, by = edge
    return ax if ay == by else ax + (y - ay) * (bx - ax) / (by - ay)
