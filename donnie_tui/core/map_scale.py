"""The map seen from further away: several cells as one square, with the letter that matters most in it."""

from __future__ import annotations

from collections.abc import Iterable

from donnie_tui.core.map_grid import Bounds, Cell, Kind
from donnie_tui.core.map_scene import MapScene

_WEIGHT = {
    kind: weight
    for weight, kind in enumerate(
        (Kind.FREE, Kind.RAY, Kind.TRAIL, Kind.START, Kind.WALL, Kind.THING, Kind.OTHER, Kind.ROBOT)
    )
}
"""Of several things in one square the heaviest is shown."""

LARGEST = 64
"""Cells along the side of a square."""


class MapScale:
    """A scene in squares of ``factor`` by ``factor`` cells. With a factor of 1 it is the scene itself."""

    def __init__(self, scene: MapScene, factor: int = 1) -> None:
        self.scene = scene
        self.factor = factor

    @property
    def bounds(self) -> Bounds:
        bounds, factor = self.scene.bounds, self.factor
        return Bounds(
            bounds.left // factor, bounds.bottom // factor, bounds.right // factor, bounds.top // factor
        )

    @property
    def robot(self) -> Cell:
        return self.square_of(self.scene.robot)

    def square_of(self, cell: Cell) -> Cell:
        """The square in which a cell is."""
        return Cell(cell.x // self.factor, cell.y // self.factor)

    def squares_of(self, cells: Iterable[Cell]) -> frozenset[Cell]:
        return frozenset(map(self.square_of, cells))

    def cell_of(self, square: Cell) -> Cell:
        """The cell of the scene that the square shows."""
        return self._heaviest(square) if self.factor > 1 else square

    def _heaviest(self, square: Cell) -> Cell:
        if self.square_of(self.scene.robot) == square:
            return self.scene.robot
        kind, factor = self.scene.kind, self.factor
        x, y = square.x * factor, square.y * factor
        cells = (Cell(x + east, y + north) for north in range(factor) for east in range(factor))
        return max(cells, key=lambda cell: _WEIGHT[kind(cell)])

    def shown(self, square: Cell) -> tuple[str, str]:
        """The letter of a square, and what it is painted as: a kind, or ``thing-`` and its colour."""
        cell = self.cell_of(square)
        kind = self.scene.kind(cell)
        look = f"thing-{self.scene.colour(cell)}" if kind is Kind.THING else kind.value
        return self.scene.letter(cell), look


def factor_for(bounds: Bounds, columns: int, rows: int) -> int:
    """The smallest factor with which the whole floor is seen in so many columns and rows."""
    factor = 1
    while factor < LARGEST and (bounds.width > columns * factor or bounds.height > rows * factor):
        factor += 1
    return factor
