"""How many polygons Stage makes of a picture: it follows the borders of the dark pixels until each is closed.

Where two dark pixels touch at a corner only, Stage goes on with the border that it sorts first, so that
some borders come out as one polygon and others as two. Here they are followed in the same order.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from sim.bitmap.pixels import Picture

_SET = re.compile(b"\1")

MOST_EDGES = 200_000
"""Beyond it (a picture full of dots) nobody counts."""


def count_outlines(picture: Picture) -> int | None:
    """The number of polygons, holes included; None where the borders are too long to follow."""
    leaving: dict[tuple[int, int], list[tuple[int, int]]] = {}
    for i, (start, end) in enumerate(_borders(picture)):
        if i == MOST_EDGES:
            return None
        leaving.setdefault(start, []).append(end)
    for ends in leaving.values():
        ends.sort(reverse=True)
    return sum(1 for start in sorted(leaving) for _ in _followed(leaving, start))


def _followed(
    leaving: dict[tuple[int, int], list[tuple[int, int]]], start: tuple[int, int]
) -> Iterator[None]:
    """One turn for each border that is followed from ``start`` until nothing leads on."""
    while start in leaving:
        at = start
        while (ends := leaving.get(at)) is not None:
            following = ends.pop()
            if not ends:
                del leaving[at]
            at = following
        yield


def _borders(picture: Picture) -> Iterator[tuple[tuple[int, int], tuple[int, int]]]:
    """The edges of dark pixels beside light ones, clockwise round the dark, y downwards."""
    empty = bytes(picture.width)
    rows = (empty, *picture.rows, empty)
    for y in range(picture.height + 1):
        above, below = rows[y], rows[y + 1]
        if above != below:
            yield from _level(above, below, y)
        if y < picture.height and any(below):
            yield from _upright(below, y)


def _level(above: bytes, below: bytes, y: int) -> Iterator[tuple[tuple[int, int], tuple[int, int]]]:
    for x in _differences(above, below):
        yield ((x, y), (x + 1, y)) if below[x] else ((x + 1, y), (x, y))


def _upright(row: bytes, y: int) -> Iterator[tuple[tuple[int, int], tuple[int, int]]]:
    left, right = b"\0" + row, row + b"\0"
    for x in _differences(left, right):
        yield ((x, y), (x, y + 1)) if left[x] else ((x, y + 1), (x, y))


def _differences(one: bytes, other: bytes) -> Iterator[int]:
    """Where two rows differ; found without a look at every pixel."""
    both = int.from_bytes(one) ^ int.from_bytes(other)
    return (match.start() for match in _SET.finditer(both.to_bytes(len(one))))
