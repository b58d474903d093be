"""Finds the parts in a box or a wedge: a grid for still parts, circles for movable ones.

The grid is made once. A root that moves costs one entry in a table; its parts are placed only when a
query comes near it. The still parts in view of a sensor are kept for the next query from
about the same place to about the same side.
"""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Collection, Iterable, Mapping, Sequence
from math import dist, floor, hypot, inf, sqrt

from msgspec import Struct

from sim.geometry import HAIR, Placement, Point, Wedge, direction, edges, is_convex, signed_area
from sim.parts import Part

Box = tuple[float, float, float, float]
"""Left, bottom, right and top."""
Entry = tuple[float, float, float, float, Part]
"""A box, and the part of which it holds all or an edge."""

MARGIN = 1e-9
"""Metres added to each side of a box, for rounding errors."""
LEAST, MOST = 0.25, 2.0
"""Metres of a square's side."""
FEW = 40
"""About how many parts the first search around a place looks for."""
NO_ROOT = -1
"""The asker of a query that belongs to no root."""
VIEWED_FROM = 1.0
"""Metres of the side of a square from which views are kept."""
_NEARER = 0.75 * VIEWED_FROM
"""Metres by which a thing may be nearer to some place in the square than to the middle of the square."""
SECTOR = 30.0
"""Degrees of the directions that share a view."""
MOST_VIEWS = 20_000
"""Views that are kept; with more, all are dropped."""
MOST_SQUARES = 256
"""A part in more squares than this is checked in every query."""


class StillParts:
    """The parts that never move."""

    def __init__(self, parts: Sequence[Part]) -> None:
        self._entries = [entry for part in parts for entry in entries_of(part, is_whole(part))]
        self._large: list[Entry] = []
        sizes = [max(right - left, top - bottom) for left, bottom, right, top, _ in self._entries]
        self._side = min(MOST, max(LEAST, 2.0 * sorted(sizes)[(len(sizes) - 1) // 2])) if sizes else MOST
        self._squares: dict[tuple[int, int], list[Entry]] = {}
        for entry in self._entries:
            columns, rows = self._reach(*entry[:4])
            if len(columns) * len(rows) > MOST_SQUARES:
                self._large.append(entry)
                continue
            for column in columns:
                for row in rows:
                    self._squares.setdefault((column, row), []).append(entry)

    def within(self, left: float, bottom: float, right: float, top: float) -> dict[int, Part]:
        """By rank, in no order."""
        side, squares = self._side, self._squares
        columns = range(floor(left / side), floor(right / side) + 1)
        rows = range(floor(bottom / side), floor(top / side) + 1)
        if len(columns) * len(rows) > len(squares):
            return _inside(self._entries, left, bottom, right, top)
        found = _inside(self._large, left, bottom, right, top) if self._large else {}
        for column in columns:
            for row in rows:
                for its_left, its_bottom, its_right, its_top, part in squares.get((column, row), ()):
                    if its_left <= right and left <= its_right and its_bottom <= top and bottom <= its_top:
                        found[part.rank] = part
        return found

    def reach_of(self, count: int) -> float:
        """The radius around a place with about that many parts."""
        squares = max(1, len(self._squares))
        return self._side * sqrt(count * squares / max(1, len(self._entries))) / 2

    def _reach(self, left: float, bottom: float, right: float, top: float) -> tuple[range, range]:
        side = self._side
        return (
            range(floor(left / side), floor(right / side) + 1),
            range(floor(bottom / side), floor(top / side) + 1),
        )


def _inside(
    entries: Iterable[Entry], left: float, bottom: float, right: float, top: float
) -> dict[int, Part]:
    return {
        part.rank: part
        for its_left, its_bottom, its_right, its_top, part in entries
        if its_left <= right and left <= its_right and its_bottom <= top and bottom <= its_top
    }


Circle = tuple[float, float, float]
"""Its middle's x and y, and its radius."""
DRIFT = 0.5
"""Metres that a root moves until what is near it must be found again."""
CLOSE = 0.75
"""Metres within which near roots are cached at least."""
InView = tuple[float, int, float, float, float, Part]
"""How far a part is at least; its rank; x, y and radius of a circle around it, a hair wider; the part."""


class Views:
    """The still parts that rangers see from each square of a grid, the nearest first."""

    def __init__(self, still: StillParts) -> None:
        self._still = still
        self.first = still.reach_of(FEW)
        """Metres up to which a view is first made."""
        self._around: dict[tuple[float, float], tuple[float, list[InView]]] = {}
        """By the square: what is in view up to a distance, on all sides."""
        self._kept: dict[tuple[float, float, float, Point], tuple[float, list[InView]]] = {}
        """The same by the square, the sector, and a sensor's half angle."""

    def of(self, wedge: Wedge, reach: float) -> tuple[float, list[InView]]:
        """The parts that may be in a wedge up to a distance, perhaps some more; and that distance.

        It is ``reach`` at least.
        """
        key = wedge.x // VIEWED_FROM, wedge.y // VIEWED_FROM, wedge.yaw % 360.0 // SECTOR, wedge.aside
        kept = self._kept.get(key)
        if kept is None or kept[0] < reach:
            kept = self._kept[key] = self._in_sector(*key, reach)
        return kept

    def _in_sector(
        self, column: float, row: float, sector: float, aside: Point, reach: float
    ) -> tuple[float, list[InView]]:
        place = column, row
        around = self._around.get(place)
        if around is None or around[0] < reach:
            if len(self._kept) >= MOST_VIEWS:
                self._kept.clear()
                self._around.clear()
            around = self._around[place] = reach, self._on_all_sides(*place, reach)
        (wc, ws), (c, s) = aside, direction(SECTOR / 2)
        wc, ws = wc * c - ws * s, ws * c + wc * s
        c, s = direction((sector + 0.5) * SECTOR)
        x, y = (column + 0.5) * VIEWED_FROM, (row + 0.5) * VIEWED_FROM
        known, views = around
        found = []
        for view in views:
            _, _, its_x, its_y, radius, _ = view
            dx, dy, radius = its_x - x, its_y - y, radius + _NEARER
            along = dx * c + dy * s
            if -radius <= along and abs(dy * c - dx * s) * wc - along * ws <= radius:
                found.append(view)
        return known, found

    def _on_all_sides(self, column: float, row: float, reach: float) -> list[InView]:
        x, y, far = (column + 0.5) * VIEWED_FROM, (row + 0.5) * VIEWED_FROM, reach + _NEARER
        found = self._still.within(x - far, y - far, x + far, y + far)
        views = [
            (
                dist(part.middle, (x, y)) - part.reach - _NEARER,
                part.rank,
                *part.middle,
                part.reach + HAIR,
                part,
            )
            for part in found.values()
            if part.seen
        ]
        views.sort()
        return views


class MovingRoots:
    """Movable roots: a circle around each, inside a wider one, its *range*, which changes rarely.

    The ranges near a robot are cached, the nearest first, until a root leaves its range.
    """

    def __init__(self, parts: Mapping[int, Sequence[Part]], now: Mapping[int, Placement]) -> None:
        """``parts`` of each root, at its place ``now``."""
        self._extents = {root: _extent(parts[root], place) + MARGIN for root, place in now.items()}
        self._circles: dict[int, Circle] = {}
        """Around each root."""
        self._ranges: dict[int, Circle] = {}
        self._widest = 0.0
        """Of the ranges."""
        self._side = max(2.0, 2.0 * max(self._extents.values(), default=0.0))
        self._squares: dict[tuple[int, int], set[int]] = {}
        """The ranges, square by square."""
        self._kept: dict[int, _Near] = {}
        """What is near a root."""
        self._reaches: dict[int, float] = {}
        """Metres up to which that was asked for, root by root."""
        self._farthest = 0.0
        """The most of these."""
        for root, place in now.items():
            self._ranges[root] = place.x, place.y, -inf
            self.move(root, place)

    def extent(self, root: int) -> float:
        """Metres from its place to its farthest point."""
        return self._extents[root]

    def move(self, root: int, now: Placement) -> None:
        """Note the new place of a root."""
        self.cover(root, now.x, now.y, 0.0)

    def cover(self, root: int, x: float, y: float, reach: float) -> None:
        """Note that a root stays within ``reach`` of a place until it is moved."""
        radius = self._extents[root] + reach
        self._circles[root] = x, y, radius
        its_x, its_y, most = self._ranges[root]
        if hypot(x - its_x, y - its_y) + radius > most:
            self._leave(root, x, y, radius + DRIFT)

    def _leave(self, root: int, x: float, y: float, radius: float) -> None:
        """Give a root another range."""
        before_x, before_y, before_radius = self._ranges[root]
        self._squares.get(self._square(before_x, before_y), set()).discard(root)
        self._squares.setdefault(self._square(x, y), set()).add(root)
        self._ranges[root] = x, y, radius
        self._widest = max(self._widest, radius)
        self._kept.pop(root, None)
        reach = self._farthest + self._widest + hypot(x - before_x, y - before_y)
        for asker in self._in_squares(x, y, reach) if self._kept else ():
            near = self._kept.get(asker)
            if near is None:
                continue
            bound = hypot(before_x - near.x, before_y - near.y) - before_radius
            if bound <= near.reach:
                del near.roots[bisect_left(near.roots, (bound, root))]
            bound = hypot(x - near.x, y - near.y) - radius
            if bound <= near.reach:
                insort(near.roots, (bound, root))

    def _near(self, asker: int, x: float, y: float, reach: float) -> tuple[list[tuple[float, int]], float]:
        """The others by the least distance of their ranges from about there, and the most that counts.

        Those up to there may come within ``reach`` of a place, the others can't.
        """
        near = self._kept.get(asker)
        if near is not None:
            most = reach + hypot(x - near.x, y - near.y)
            if most <= near.reach:
                return near.roots, most
        if asker not in self._ranges:
            return self._found(asker, x, y, reach).roots, reach
        its_x, its_y, _ = self._ranges[asker]
        most = reach + hypot(x - its_x, y - its_y)
        farthest = self._reaches[asker] = max(self._reaches.get(asker, CLOSE), most + DRIFT)
        self._farthest = max(self._farthest, farthest)
        near = self._kept[asker] = self._found(asker, its_x, its_y, farthest)
        return near.roots, most

    def close_to(self, asker: int, x: float, y: float, reach: float) -> list[int]:
        """The others that come within ``reach`` of a place, in no order."""
        near, most = self._near(asker, x, y, reach)
        found = list[int]()
        for bound, root in near:
            if bound > most:
                break
            its_x, its_y, radius = self._circles[root]
            if hypot(its_x - x, its_y - y) <= reach + radius:
                found.append(root)
        return found

    def within(self, asker: int, left: float, bottom: float, right: float, top: float) -> list[int]:
        """The others that may come into a box, in no order."""
        x, y = (left + right) / 2, (bottom + top) / 2
        near, most = self._near(asker, x, y, hypot(right - x, top - y))
        found = list[int]()
        for bound, root in near:
            if bound > most:
                break
            its_x, its_y, radius = self._circles[root]
            if left - radius <= its_x <= right + radius and bottom - radius <= its_y <= top + radius:
                found.append(root)
        return found

    def in_wedge(self, asker: int, wedge: Wedge, reach: float) -> list[int]:
        """The others that may come into a wedge up to a distance, in no order."""
        x, y = wedge.x, wedge.y
        near, most = self._near(asker, x, y, reach)
        found = list[int]()
        if near and near[0][0] <= most:
            (c, s), (wc, ws), circles = wedge.facing, wedge.aside, self._circles
            for bound, root in near:
                if bound > most:
                    break
                its_x, its_y, radius = circles[root]
                dx, dy = its_x - x, its_y - y
                along = dx * c + dy * s
                if -radius <= along <= reach + radius and abs(dy * c - dx * s) * wc - along * ws <= radius:
                    found.append(root)
        return found

    def _found(self, asker: int, x: float, y: float, reach: float) -> _Near:
        found = list[tuple[float, int]]()
        for root in self._in_squares(x, y, reach + self._widest):
            its_x, its_y, radius = self._ranges[root]
            bound = hypot(its_x - x, its_y - y) - radius
            if bound <= reach and root != asker:
                found.append((bound, root))
        found.sort()
        return _Near(x, y, reach, found)

    def _in_squares(self, x: float, y: float, reach: float) -> Collection[int]:
        """The roots whose ranges have their middles within ``reach`` of a place, and some more."""
        if (2.0 * reach / self._side) ** 2 > len(self._ranges):
            return self._ranges
        (left, bottom), (right, top) = self._square(x - reach, y - reach), self._square(x + reach, y + reach)
        squares, found = self._squares, list[int]()
        for column in range(left, right + 1):
            for row in range(bottom, top + 1):
                found.extend(squares.get((column, row), ()))
        return found

    def _square(self, x: float, y: float) -> tuple[int, int]:
        return floor(x / self._side), floor(y / self._side)


class _Near(Struct, frozen=True):
    """The roots whose ranges come within ``reach`` of a place: the middle of another one's range."""

    x: float
    y: float
    reach: float
    roots: list[tuple[float, int]]
    """Each with the least distance of its range, in order."""


def _extent(parts: Iterable[Part], place: Placement) -> float:
    return max((dist(point, (place.x, place.y)) for part in parts for point in part.points), default=0.0)


def is_whole(part: Part) -> bool:
    """Whether its polygon is solid for ``layout``."""
    return abs(signed_area(part.points)) > 1e-9 and is_convex(part.points)


def entries_of(part: Part, whole: bool) -> list[Entry]:
    """One box for a polygon that is ``whole``, one for each edge of another."""
    points = part.points
    pieces = (points,) if whole else tuple(((ax, ay), (bx, by)) for ax, ay, bx, by in edges(points))
    found = list[Entry]()
    for piece in pieces:
        xs, ys = zip(*piece, strict=True)
        found.append((min(xs) - MARGIN, min(ys) - MARGIN, max(xs) + MARGIN, max(ys) + MARGIN, part))
    return found
