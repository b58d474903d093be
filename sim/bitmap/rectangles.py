"""Solid pixels as few rectangles: runs of a row, joined downwards where the next row has the same run."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from sim.bitmap.pixels import Picture

_RUN = re.compile(b"\x01+")


class Rectangle(NamedTuple):
    """In pixels, y downwards; the right and bottom borders belong to the next pixel."""

    left: int
    top: int
    right: int
    bottom: int


def rectangles(picture: Picture) -> Iterator[Rectangle]:
    """The solid area of a picture, without gaps and overlaps."""
    growing: dict[tuple[int, int], int] = {}
    for y, row in enumerate((*picture.rows, b"")):
        runs = {match.span() for match in _RUN.finditer(row)}
        for (left, right), top in [item for item in growing.items() if item[0] not in runs]:
            del growing[left, right]
            yield Rectangle(left, top, right, y)
        for run in sorted(runs):
            growing.setdefault(run, y)
