"""Names written on the map: beside each thing, on free floor only, so that nothing else is hidden."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from donnie_tui.core.map_grid import Cell, Kind
from donnie_tui.core.map_scale import MapScale
from donnie_tui.core.naming import coloured_thing, name_of, shade
from donnie_tui.core.wording import Wording

if TYPE_CHECKING:
    from sim.picture import Thing

MOST = 300
"""Names; a floor with more things has no room for them."""


def labels(scale: MapScale, columns: int, wording: Wording) -> dict[Cell, str]:
    """What is written into which squares, ``columns`` characters each. A name without room is left out."""
    written: dict[Cell, str] = {}
    scene = scale.scene
    named = [(names, scene.cell_at(each.x, each.y)) for each, names in _named(scene.things[:MOST], wording)]
    named += [((name,), cell) for name, cell in scene.others.items()]
    for names, cell in named:
        square = scale.square_of(cell)
        any(_write(f" {name} ", scale, square, columns, written) for name in names)
    return written


def _named(things: Sequence[Thing], wording: Wording) -> Iterator[tuple[Thing, tuple[str, ...]]]:
    """What each may be called, the best first: the colour, too, where a letter has several."""
    colours: dict[str, set[str]] = {}
    for each in things:
        colours.setdefault(each.letter, set()).add(each.colour)
    for each in things:
        if len(colours[each.letter]) > 1:
            yield each, (coloured_thing(each, wording), shade(each, wording))
        else:
            yield each, (name_of(each, wording),)


def _write(name: str, scale: MapScale, square: Cell, columns: int, written: dict[Cell, str]) -> bool:
    """To the east of it, else to the west. Whether there was room."""
    pieces = [name[at : at + columns].ljust(columns) for at in range(0, len(name), columns)]
    for first in (_beyond(scale, square, 1), _beyond(scale, square, -1) - len(pieces) + 1):
        squares = [Cell(first + index, square.y) for index in range(len(pieces))]
        if all(_is_free(scale, each) and each not in written for each in squares):
            written.update(zip(squares, pieces, strict=True))
            return True
    return False


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
