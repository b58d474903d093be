"""Which squares of a grid a polygon covers: row by row, in time that grows with its edges and the rows only.

A square counts where it shares more than a border with the polygon; squares may be taken smaller than the
grid's cells, so that touching the rim of a cell does not count.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import ceil, floor

from devices.ports.values import Frozen
from sim.geometry import Edge, Point, edges

_FUZZ = 1e-9


class Raster(Frozen):
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
        ends = [_x_at(edge, min(high, max(low, y))) for y in (middle - half, middle + half)]
        if ay == by:
            ends = [ax, bx]
        yield from _stretch(row, min(ends), max(ends), raster, half)


def _crossed(edge: Edge, raster: Raster) -> Iterator[tuple[int, float]]:
    """Where an edge crosses the middle lines of rows; its lower end counts, its upper one does not."""
    low, high = min(edge[1], edge[3]), max(edge[1], edge[3])
    first = max(0, ceil((low - raster.bottom) / raster.cell))
    last = min(raster.height - 1, ceil((high - raster.bottom) / raster.cell) - 1)
    for row in range(first, last + 1):
        yield row, _x_at(edge, raster.bottom + row * raster.cell)


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


def _x_at(edge: Edge, y: float) -> float:
    ax, ay, bx, by = edge
    return ax if ay == by else ax + (y - ay) * (bx - ax) / (by - ay)
