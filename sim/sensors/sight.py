"""What sensors ask of the world around a robot, and Stage's height test where a world wants it.

Without that test a sensor sees things of every height. With it, only those between whose bottom and top
it looks; then rays are computed here, edge by edge, and not by the quick way, which knows no heights.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import inf
from typing import TYPE_CHECKING, Protocol

from sim.geometry import Point, along
from sim.parts import Part

if TYPE_CHECKING:
    from sim.rays import Hit

Height = float | None
"""Metres above the floor at which a sensor looks, or None: it sees things of every height."""


class Around(Protocol):
    """The world without the robot itself."""

    def within(self, left: float, bottom: float, right: float, top: float) -> Iterable[Part]:
        """All parts that come into a box, and perhaps some more, in order."""

    def first_hits(self, x: float, y: float, ends: Sequence[Point], ranging: bool = False) -> list[Hit[Part]]:
        """The parts that looks from one place to each of ``ends`` meet first, and where on the way."""


def at_height(part: Part, height: Height) -> bool:
    return height is None or part.bottom <= height <= part.top


def first_hits(
    around: Around, x: float, y: float, ends: Sequence[Point], height: Height, ranging: bool = False
) -> list[Hit[Part]]:
    """``Around.first_hits`` among the parts of that height."""
    if height is None:
        return around.first_hits(x, y, ends, ranging)
    parts = [part for part in _between(around, x, y, ends, ranging) if at_height(part, height)]
    return [_first(parts, (x, y, *end)) for end in ends]


def _between(around: Around, x: float, y: float, ends: Sequence[Point], ranging: bool) -> Iterator[Part]:
    xs, ys = [x, *(end[0] for end in ends)], [y, *(end[1] for end in ends)]
    for part in around.within(min(xs), min(ys), max(xs), max(ys)):
        if part.seen or (part.solid and not ranging):
            yield part


def _first(parts: Iterable[Part], ray: tuple[float, float, float, float]) -> Hit[Part]:
    first, nearest = None, inf
    for part in parts:
        for edge in part.outline:
            alpha = along(ray, edge)
            if alpha < nearest:
                first, nearest = part, alpha
    return (first, nearest) if first is not None else (None, 1.0)
