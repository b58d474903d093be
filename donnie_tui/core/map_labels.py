"""Names written on the map: beside each thing, on free floor only, so that nothing else is hidden."""

from __future__ import annotations

from donnie_tui.core.describe import name_of
from donnie_tui.core.map_grid import Cell, Kind
from donnie_tui.core.map_scale import MapScale
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
        _write(f" {name}", scale, scale.square_of(cell), columns, written)
    return written


def _write(name: str, scale: MapScale, square: Cell, columns: int, written: dict[Cell, str]) -> None:
    east = Cell(square.x + 1, square.y)
    while _kind(scale, east) in (Kind.THING, Kind.OTHER) and east.x <= scale.bounds.right:
        east = Cell(east.x + 1, east.y)
    pieces = [name[at : at + columns].ljust(columns) for at in range(0, len(name), columns)]
    squares = [Cell(east.x + index, east.y) for index in range(len(pieces))]
    if all(_is_free(scale, each) and each not in written for each in squares):
        written.update(zip(squares, pieces, strict=True))


def _kind(scale: MapScale, square: Cell) -> Kind:
    return scale.scene.kind(scale.cell_of(square))


def _is_free(scale: MapScale, square: Cell) -> bool:
    return square.x <= scale.bounds.right and _kind(scale, square) in (Kind.FREE, Kind.TRAIL)
