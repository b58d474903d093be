"""The map in words: rows and columns as runs of like squares, single squares, the picture with its legend.

Squares are told by their place in steps, x to the east and y to the north, as WHERE tells the robot's. Rows
tell the floor and the robot, not its trail. A row in words has all that is in the grid: it can be read back.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import groupby
from string import ascii_lowercase
from typing import TYPE_CHECKING

from devices.ports.robot import Pose
from donnie_tui.core.describe import place_of, size_in_words, things_in_words
from donnie_tui.core.map_grid import FREE, START, TRAIL, WALL, Bounds, Cell, Kind, MapGrid
from donnie_tui.core.naming import name_of, told_name_of
from donnie_tui.core.wall_words import walls_in_words
from donnie_tui.core.wording import Wording

if TYPE_CHECKING:
    from sim.picture import Picture
    from worlds.words import About

WIDEST, HIGHEST = 40, 18
"""Squares of the picture: what a braille display shows of a line, and what a screen reader takes at once."""

_OF_THE_ROBOT = "ov"
"""Letters that its trail and its arrow may have."""

_LINE = {"brief": 40, "normal": 60, "full": 80}
"""Characters of a line of runs."""


def map_in_words(
    picture: Picture, pose: Pose, wording: Wording, about: About | None = None
) -> tuple[str, ...]:
    """How large the floor is, how many things there are, and where each is, the nearest first."""
    return (*floor_in_words(picture, pose, wording, about), *things_in_words(picture, pose, wording))


def floor_in_words(
    picture: Picture, pose: Pose, wording: Wording, about: About | None = None
) -> tuple[str, ...]:
    """How large it is and how much stands there; where its walls are if nobody says anything ``about`` it."""
    walls = () if about else walls_in_words(picture, pose, wording)
    count = len(picture.things)
    return (
        size_in_words(picture, wording),
        *walls,
        wording("world-things", count=count) if count else wording("world-bare"),
    )


def row_in_words(grid: MapGrid, y: int, wording: Wording) -> tuple[str, ...]:
    """The squares from west to east that are ``y`` steps to the north."""
    bounds, cell = grid.bounds, _nearest_cell(grid, 0, y)
    if not bounds.bottom <= cell.y <= bounds.top:
        low, high = grid.place(Cell(0, bounds.bottom))[1], grid.place(Cell(0, bounds.top))[1]
        return (wording("map-no-row", row=y, first=low, last=high),)
    cells = [Cell(x, cell.y) for x in range(bounds.left, bounds.right + 1)]
    return tuple(_runs_in_words(grid, "map-row", y, cells, wording))


def column_in_words(grid: MapGrid, x: int, wording: Wording) -> tuple[str, ...]:
    """The squares from south to north that are ``x`` steps to the east."""
    bounds, cell = grid.bounds, _nearest_cell(grid, x, 0)
    if not bounds.left <= cell.x <= bounds.right:
        low, high = grid.place(Cell(bounds.left, 0))[0], grid.place(Cell(bounds.right, 0))[0]
        return (wording("map-no-column", column=x, first=low, last=high),)
    cells = [Cell(cell.x, y) for y in range(bounds.bottom, bounds.top + 1)]
    return tuple(_runs_in_words(grid, "map-column", x, cells, wording))


def square_in_words(grid: MapGrid, x: int, y: int, pose: Pose, wording: Wording) -> str:
    """What is at a place, and where that is from the robot."""
    cell = _nearest_cell(grid, x, y)
    what = _beyond(grid, wording) if _is_beyond(grid, cell) else square_content(grid, cell, wording)
    return wording("map-square", x=x, y=y, what=what, place=place_of(x, y, pose, wording))


def _is_beyond(grid: MapGrid, cell: Cell) -> bool:
    """Where the map has neither row nor column any more. A trail is floor anywhere."""
    bounds = grid.bounds
    is_on_it = bounds.left <= cell.x <= bounds.right and bounds.bottom <= cell.y <= bounds.top
    return not is_on_it and grid.kind(cell) is Kind.FREE


def _beyond(grid: MapGrid, wording: Wording) -> str:
    """Behind the walls there is no floor; without walls it never ends."""
    return wording("cell-outside" if grid.picture.has_walls else "cell-beyond")


def square_content(grid: MapGrid, cell: Cell, wording: Wording) -> str:
    """What a square shows, the robot's trail and start included."""
    kind = grid.kind(cell)
    thing = grid.thing(cell) if kind is Kind.THING else None
    if thing is not None:
        return told_name_of(thing, wording)
    if kind is Kind.ROBOT:
        return _robot_words(grid, wording)
    return grid.letter(cell) if kind is Kind.THING else wording(f"cell-{kind.value}")


def names_of_letters(picture: Picture, wording: Wording) -> dict[str, str]:
    """What each letter of the floor stands for; no two have the same words."""
    names = {WALL: wording("cell-wall"), FREE: wording("cell-free")}
    for thing in picture.things:
        name = name_of(thing, wording)
        taken = name in (other for letter, other in names.items() if letter != thing.letter)
        names.setdefault(thing.letter, f"{name} {thing.letter}" if taken else name)
    return names


def picture_in_letters(grid: MapGrid, wording: Wording, free: str = FREE) -> tuple[str, ...]:
    """What the letters mean, then the squares around the robot, the northern row first.

    ``free`` is shown for a free square: a full stop, or a letter for those who read braille.
    """
    window = grid.bounds.part(grid.robot, WIDEST, HIGHEST)
    rows = [
        "".join(grid.letter(Cell(x, y)) for x in range(window.left, window.right + 1))
        for y in range(window.top, window.bottom - 1, -1)
    ]
    shown = set("".join(rows)) - {TRAIL, START}
    names = names_of_letters(grid.picture, wording)
    shown_as = _braille_letters(names) | {FREE: free, START: free}
    legend = [
        wording("picture-letter", name=names[letter], letter=shown_as[letter])
        for letter in sorted(shown & names.keys())
    ]
    title = wording(
        "picture-title-named" if grid.name else "picture-title",
        name=grid.name,
        robot=grid.letter(grid.robot),
        width=window.width,
        height=window.height,
    )
    part = _part_in_words(grid, window, wording)
    return (title, *part, *legend, *("".join(shown_as.get(each, each) for each in row) for row in rows))


def _part_in_words(grid: MapGrid, window: Bounds, wording: Wording) -> tuple[str, ...]:
    """Which part of the world the picture has, where it has not all of it."""
    if window == grid.bounds:
        return ()
    parts = (("picture-part", window), ("picture-whole", grid.bounds))
    return tuple(wording(code, **_places(grid, bounds)) for code, bounds in parts)


def _places(grid: MapGrid, bounds: Bounds) -> dict[str, int]:
    """Where it ends, in steps."""
    left, bottom = grid.place(Cell(bounds.left, bounds.bottom))
    right, top = grid.place(Cell(bounds.right, bounds.top))
    return {"left": left, "bottom": bottom, "right": right, "top": top}


def _braille_letters(names: dict[str, str]) -> dict[str, str]:
    """What is shown for each letter: six dots know no capitals, so a capital may need another letter."""
    unused = iter(each for each in ascii_lowercase if each not in names and each not in _OF_THE_ROBOT)
    return {
        letter: letter if letter.lower() == letter or letter.lower() not in names else next(unused, letter)
        for letter in names
    }


def _runs_in_words(
    grid: MapGrid, code: str, number: int, cells: list[Cell], wording: Wording
) -> Iterable[str]:
    """The runs, in as many lines as they need; each says from where it goes on."""
    names = names_of_letters(grid.picture, wording)
    start, runs = cells[0], list[str]()
    done = 0
    for name, same in groupby(cells, lambda cell: _floor_words(grid, cell, names, wording)):
        count = len(list(same))
        many = wording("cell-free-many") if name == names[FREE] else name
        run = f"{count} {many}" if count > 1 else name
        line = _line_of_runs(grid, code, number, start, [*runs, run], wording)
        if runs and len(line) > _LINE[wording.detail]:
            yield _line_of_runs(grid, code, number, start, runs, wording)
            start, runs = cells[done], []
        runs.append(run)
        done += count
    yield _line_of_runs(grid, code, number, start, runs, wording)


def _line_of_runs(
    grid: MapGrid, code: str, number: int, start: Cell, runs: list[str], wording: Wording
) -> str:
    x, y = grid.place(start)
    return wording(code, number=number, start=x if code == "map-row" else y, runs=", ".join(runs))


def _floor_words(grid: MapGrid, cell: Cell, names: dict[str, str], wording: Wording) -> str:
    return _robot_words(grid, wording) if cell == grid.robot else names.get(grid.floor_letter(cell), "?")


def _robot_words(grid: MapGrid, wording: Wording) -> str:
    return grid.name or wording("cell-robot")


def _nearest_cell(grid: MapGrid, x: int, y: int) -> Cell:
    return grid.cell_of(Pose(float(x), float(y), 0.0))
