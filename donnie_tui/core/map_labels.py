"""Names written on the map: beside each thing, on free floor only, so that nothing else is hidden."""

from __future__ import annotations

from donnie_tui.core.map_grid import Cell, Kind
from donnie_tui.core.map_scale import MapScale
from donnie_tui.core.naming import name_of
from donnie_tui.core.wording import Wording

MOST = 300
"""Names; a floor with more things has no room for them."""


def labels(scale: MapScale, columns: int, wording: Wording) -> dict[Cell, str]:
    """What is written into which squares, ``columns`` characters each. A name without room is left out."""
    written: dict[Cell, str] = {}
    scene = scale.scene
    named = [(name_of(each, wording), scene.cell_at(each.x, each.y)) for each in scene.things[:MOST]]
    named += list(scene.others.items())
    for name, cell in named:
        _write(f" {name} ", scale, scale.square_of(cell), columns, written)
    return written


def _write(name: str, scale: MapScale, square: Cell, columns: int, written: dict[Cell, str]) -> None:
    """To the east of it, else to the west."""
    pieces = [name[at : at + columns].ljust(columns) for at in range(0, len(name), columns)]
    for first in (_beyond(scale, square, 1), _beyond(scale, square, -1) - len(pieces) + 1):
        squares = [Cell(first + index, square.y) for index in range(len(pieces))]
        if all(_is_free(scale, each) and each not in written for each in squares):
            written.update(zip(squares, pieces, strict=True))
            return


def _beyond(scale: MapScale, square: Cell, step: int) -> int:
    """The first column beside what stands there."""
    x = square.x + step
    while _kind(scale, Cell(x, square.y)) in (Kind.THING, Kind.OTHER):
        x += step
    return x


def _kind(scale: MapScale, square: Cell) -> Kind:
    return scale.scene.kind(scale.cell_of(square))


def _is_free(scale: MapScale, square: Cell) -> bool:
    return scale.bounds.left <= square.x <= scale.bounds.right and _kind(scale, square) in (
        Kind.FREE,
        Kind.TRAIL,
    )
