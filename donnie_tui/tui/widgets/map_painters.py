"""Painters of the map's squares: letters, or a picture of coloured blocks.

A painter gives the size of a square and its content; the map does the rest. In letters nothing
is shown by colour alone. A picture shows twice as many rows of squares, as half blocks, and only if a
learner asks for it; robots and marks on the floor are letters there, too.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Protocol

from msgspec import Struct
from rich.segment import Segment
from rich.style import Style
from textual.geometry import Size

if TYPE_CHECKING:
    from donnie_tui.core.map_grid import Cell
    from donnie_tui.core.map_scene import MapScale

Look = Callable[[str], Style]
"""The style of a kind, or of ``thing-`` or ``other-`` and a colour."""

_UPPER, _LOWER, _FULL = "▀", "▄", "█"


class Extent(Struct, frozen=True):
    """The size of a square in columns and rows, or the squares that share one row."""

    columns: int
    rows: int
    stacked: int = 1


class Painter(Protocol):
    """A way to paint squares."""

    extents: tuple[Extent, ...]
    """From the farthest to the nearest zoom."""

    def fitting(self, floor: Size, room: Size) -> int:
        """The index of the extent that shows a floor of that many squares at zoom 0."""

    def paint(self, scale: MapScale, square: Cell, extent: Extent, row: int, look: Look) -> Segment:
        """Paint a row of a square, of the upper one if they are stacked."""


class Letters:
    """Paints things and robots as letters, with initials if there is room."""

    extents: tuple[Extent, ...] = (Extent(1, 1), Extent(2, 1), Extent(4, 2), Extent(6, 3))

    def __init__(self) -> None:
        self.initials: Mapping[str, str] = {}
        """The initials of colour words, in the learner's language."""
        self.mixed: frozenset[str] = frozenset()
        """The letters of things that come in several colours."""

    def fitting(self, floor: Size, room: Size) -> int:
        return int(2 * floor.width <= room.width)

    def paint(self, scale: MapScale, square: Cell, extent: Extent, row: int, look: Look) -> Segment:
        letter, kind = scale.shown(square)
        return Segment(self._filled(scale, square, kind, letter, extent, row), look(kind))

    def _filled(self, scale: MapScale, square: Cell, kind: str, letter: str, extent: Extent, row: int) -> str:
        """The text of a wide square: walls and things fill it, others are a letter and blanks."""
        _thing, is_thing, colour = kind.partition("thing-")
        if is_thing and letter in self.mixed:
            initial = self.initials.get(colour, letter)
            if extent.columns > 1:
                letter += initial
            elif scale.factor == 1 and scale.scene.has_room_for_colour(square):
                letter = initial
        elif _is_robot(kind) and extent.columns > 1:
            letter += scale.scene.name_of_robot(scale.cell_of(square))[:1]
        if is_thing or kind == "wall":
            return (letter * extent.columns)[: extent.columns]
        return (letter if not row else "").ljust(extent.columns)


def _is_robot(kind: str) -> bool:
    return kind == "robot" or kind.startswith("other-")


class Blocks:
    """Paints walls and things as blocks of their colours, on a blank floor."""

    extents: tuple[Extent, ...] = (Extent(1, 1, 2), Extent(2, 1), Extent(4, 2), Extent(6, 3))

    def fitting(self, floor: Size, room: Size) -> int:
        return int(2 * floor.width <= room.width and floor.height <= room.height)

    def paint(self, scale: MapScale, square: Cell, extent: Extent, row: int, look: Look) -> Segment:
        letter, kind = scale.shown(square)
        below = square._replace(y=square.y - 1)
        if extent.stacked == 1 or below.y < scale.bounds.bottom:
            if extent.stacked == 1 and _is_solid(kind):
                return Segment(_FULL * extent.columns, look(kind))
            if not _is_solid(kind):
                return _on_floor(letter if not row else " ", kind, extent.columns, look)
            return Segment(_UPPER, look(kind))
        return _stacked((letter, kind), scale.shown(below), look)


def _stacked(upper: tuple[str, str], lower: tuple[str, str], look: Look) -> Segment:
    """Paint two squares in one row: a robot has priority, then blocks, then marks on the floor."""
    for letter, kind in (upper, lower):
        if _is_robot(kind):
            return Segment(letter, look(kind))
    above, below = (_is_solid(kind) for _, kind in (upper, lower))
    if not above and not below:
        letter, kind = upper if upper[1] != "free" else lower
        return _on_floor(letter, kind, 1, look)
    if above and below:
        top, bottom = look(upper[1]), look(lower[1])
        if top.color == bottom.color:
            return Segment(_FULL, top)
        # A background can't be the text's own colour. A bright one is dark on a console: best that of a wall.
        is_own = bottom.color is None or bottom.color.is_default
        if is_own or (upper[1] == "wall" and not (top.color is None or top.color.is_default)):
            return Segment(_LOWER, Style(color=bottom.color, bgcolor=top.color))
        return Segment(_UPPER, Style(color=top.color, bgcolor=bottom.color))
    return Segment(_UPPER if above else _LOWER, look(upper[1] if above else lower[1]))


def _is_solid(kind: str) -> bool:
    return kind == "wall" or kind.startswith("thing-")


def _on_floor(letter: str, kind: str, columns: int, look: Look) -> Segment:
    return Segment((" " if kind == "free" else letter).ljust(columns), look(kind))
