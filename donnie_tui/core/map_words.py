"""The map in words: rows, columns and squares, the map in letters, what is around the robot, and a pointer.

Squares are named by their place in steps, x to the east and y to the north, as WHERE does. Rows and columns
are runs of equal squares. They give the floor and the robot, not its trail, and nothing is left out: the row
of the grid can be rebuilt from them.

AROUND gives the number of things, then each direction clockwise from ahead (or from north). Every thing in
range is named exactly once, in the direction of its nearest edge. A direction with neither thing nor wall is
free. Steps are counted from the robot's edge to that of the thing or wall, as DISTANCE does: straight on
where the robot would hit it, else to the nearest point. Directions are 4, 8 at detail full, or the 12 hours
of a clock face.

A pointer has a square, what is there, and the way to the next thing. Places are given as the robot sees them;
from one square to another as if the robot stood on the first.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from math import hypot
from string import ascii_lowercase
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.robot import Pose
from donnie_tui.core.describe import place_of, size_in_words, things_in_words, walls_in_words
from donnie_tui.core.map_grid import FREE, START, TRAIL, WALL, Bounds, Cell, Kind, MapGrid
from donnie_tui.core.map_scene import MapScene
from donnie_tui.core.wording import (
    COMPASS,
    SIDES,
    Wording,
    colour_initials,
    coloured,
    coloured_thing,
    keys_of,
    letters_of_several_colours,
    meant,
    name_of,
    shade,
    specific_name_of,
    spelled,
)
from language.keywords import COLOURS

if TYPE_CHECKING:
    from sim.picture import Picture, Room, Thing
    from worlds.words import About


WIDEST, HIGHEST = 40, 18
"""Squares of the picture: what a braille display shows of a line, and what a screen reader takes at once."""

_START = "*"
"""The start of a path: no letter, as things have letters."""
_OF_THE_ROBOT = "ov"
"""Letters that its trail and its arrow may have."""

_LINE = {"brief": 40, "normal": 60, "full": 80}
"""Characters of a line of runs."""


def map_in_words(
    picture: Picture, pose: Pose, wording: Wording, about: About | None = None
) -> tuple[str, ...]:
    """The size of the floor, the number of things, and the place of each, the nearest first."""
    return (*floor_in_words(picture, pose, wording, about), *things_in_words(picture, pose, wording))


def floor_in_words(
    picture: Picture, pose: Pose, wording: Wording, about: About | None = None
) -> tuple[str, ...]:
    """The floor's size and the number of things; its walls too, unless a text ``about`` it exists."""
    walls = () if about else walls_in_words(picture, pose, wording)
    count = len(picture.things)
    return (
        size_in_words(picture, wording),
        *walls,
        wording("world-things", count=count) if count else wording("world-bare"),
    )


def row_in_words(grid: MapGrid, y: int, wording: Wording) -> tuple[str, ...]:
    """The squares from west to east that are ``y`` steps to the north."""
    bounds, row = grid.bounds, grid.row_at(y)
    if not bounds.bottom <= row <= bounds.top:
        ends = _places(grid, bounds)
        return (wording("map-no-row", row=y, first=ends["bottom"], last=ends["top"]),)
    cells = [Cell(x, row) for x in range(bounds.left, bounds.right + 1)]
    return tuple(_runs_in_words(grid, "map-row", y, cells, wording))


def column_in_words(grid: MapGrid, x: int, wording: Wording) -> tuple[str, ...]:
    """The squares from south to north that are ``x`` steps to the east."""
    bounds, column = grid.bounds, grid.column_at(x)
    if not bounds.left <= column <= bounds.right:
        ends = _places(grid, bounds)
        return (wording("map-no-column", column=x, first=ends["left"], last=ends["right"]),)
    cells = [Cell(column, y) for y in range(bounds.bottom, bounds.top + 1)]
    return tuple(_runs_in_words(grid, "map-column", x, cells, wording))


def square_in_words(grid: MapGrid, x: int, y: int, pose: Pose, wording: Wording) -> str:
    """What is at a place, and where that is from the robot."""
    cell = grid.cell_at(x, y)
    what = square_content(grid, cell, wording) if cell in grid.bounds else _beyond(grid, wording)
    return wording("map-square", x=x, y=y, what=what, place=place_of(x, y, pose, wording))


def _beyond(grid: MapGrid, wording: Wording) -> str:
    """The sentence for a place outside: no floor outside of the walls; without walls, floor without end."""
    return wording("cell-outside" if grid.picture.has_walls else "cell-beyond")


def square_content(grid: MapGrid, cell: Cell, wording: Wording) -> str:
    """What a square shows, the robot's trail and start included."""
    kind = grid.kind(cell)
    if kind is Kind.ROBOT:
        return _robot_words(grid, wording)
    if kind is not Kind.THING:
        return wording(f"cell-{kind.value}", number=grid.goals.get(cell))
    thing = grid.thing(cell)
    return grid.letter(cell) if thing is None else specific_name_of(thing, wording)


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
    rows = window.rows(grid.letter)
    shown = set("".join(rows)) - {TRAIL, START}
    names = names_of_letters(grid.picture, wording)
    shown_as = _braille_letters(names) | {FREE: free, START: _START}
    colours = _colours_in(grid, window)
    initials = colour_initials(wording, {*shown_as.values(), *_OF_THE_ROBOT})
    shown_colours = [each for each in initials if each in colours.values()]
    of_path = ({wording("cell-start"): _START} if START in "".join(rows) else {}) | (
        {wording("cell-trail"): TRAIL} if TRAIL in "".join(rows) else {}
    )
    legend = [wording("picture-letter", name=name, letter=sign) for name, sign in of_path.items()]
    legend += [
        wording("picture-letter", name=names[letter], letter=shown_as[letter])
        for letter in sorted(shown & names.keys())
    ]
    legend += [
        wording("picture-letter", name=wording(f"colour-{each}"), letter=initials[each].lower())
        for each in shown_colours
    ]
    goals = sorted({number for cell, number in grid.goals.items() if cell in window})
    letters = {
        number: next(grid.letter(cell) for cell in grid.goals if grid.goals[cell] == number)
        for number in goals
    }
    legend += [
        wording("picture-letter", name=wording("cell-goal", number=number), letter=letters[number])
        for number in goals
    ]
    title = wording(
        "picture-title-named" if grid.name else "picture-title",
        name=grid.name,
        robot=grid.letter(grid.robot),
        width=window.width,
        height=window.height,
    )
    part = _part_in_words(grid, window, wording)
    drawn = [[shown_as.get(each, each) for each in row] for row in rows]
    for cell, colour in colours.items():
        drawn[window.top - cell.y][cell.x - window.left] = initials[colour].lower()
    return (title, *part, *legend, *("".join(row) for row in drawn))


def _colours_in(grid: MapGrid, window: Bounds) -> dict[Cell, str]:
    """The middles of things that differ in colour only, where an initial has room, with their colours."""
    mixed = letters_of_several_colours(grid.picture.things)
    middles = {
        grid.cell_at(each.x, each.y): each
        for each in grid.picture.things
        if each.letter in mixed and each.colour in COLOURS and grid.is_wide(each)
    }
    return {
        cell: each.colour
        for cell, each in middles.items()
        if cell in window and grid.letter(cell) == each.letter
    }


def _part_in_words(grid: MapGrid, window: Bounds, wording: Wording) -> tuple[str, ...]:
    """The part of the world that the picture shows, if it is not all of it."""
    if window == grid.bounds:
        return ()
    parts = (("picture-part", window), ("picture-whole", grid.bounds))
    return tuple(wording(code, **_places(grid, bounds)) for code, bounds in parts)


def _places(grid: MapGrid, bounds: Bounds) -> dict[str, int]:
    """The limits in steps."""
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
    """The runs, in as many lines as they need; each names the place where it continues."""
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


RANGE = 10
"""Steps that are looked at in each direction."""


class Face(Struct, frozen=True):
    """The directions into which the surroundings are divided, and their names."""

    first: float
    """The compass heading of the first one."""
    codes: tuple[str, ...]
    """The code of the sentence that names each sector; with ``{hour}`` for a clock face."""
    every: int = 1
    """Which of them are named when free: 1 for each, 3 for each third, from the first one on."""

    @property
    def width(self) -> float:
        """Degrees of a sector."""
        return 360 / len(self.codes)

    def heading(self, sector: int) -> float:
        """The compass heading of a sector's middle."""
        return self.first + sector * self.width

    def sector(self, heading: float) -> int:
        """The sector of a compass heading."""
        return round((heading - self.first) / self.width) % len(self.codes)


def compass_point(typed: str) -> int | None:
    """The point of the compass that a word means, in eighths clockwise from north; None if it means none."""
    point = meant(typed, "compass")
    return keys_of("compass").index(point) if point else None


def compass_words(language: str) -> tuple[str, ...]:
    """The points of the compass, clockwise from north, as they are typed in a language."""
    return tuple(spelled(point, language, "compass") for point in keys_of("compass"))


def around_in_words(
    grid: MapGrid,
    pose: Pose,
    wording: Wording,
    *,
    compass: int | None = None,
    clock: bool = False,
    held: int | None = None,
) -> tuple[str, ...]:
    """The number of things in range, then a line for each thing, wall or free direction.

    ``compass``: by the compass, beginning with that point; else as the robot looks. ``held``: the index of
    the thing in the robot's gripper, which is not around it.
    """
    face = _face(pose.heading, wording.detail, compass=compass, clock=clock)
    from sim.picture import Room  # only AROUND needs geometry

    things = grid.picture.things
    around = tuple(each for each in things if each.index != held)
    room = Room(replace(grid.picture, things=around), pose)
    sectors = _things_by_sector(around, room, face)
    count = sum(map(len, sectors))
    lines = [wording("around-things" if count else "around-none", count=count, steps=RANGE)]
    lines += [wording("around-held", thing=_named(each, wording)) for each in things if each not in around]
    for sector, found in enumerate(sectors):
        lines += _sector_in_words(room, face, sector, found, wording)
    return tuple(lines)


def _face(heading: float, detail: str, *, compass: int | None, clock: bool) -> Face:
    full = detail == "full"
    if clock:
        return Face(heading, ("around-hour",) * 12, 1 if full else 3)
    codes = [f"around-{each}" for each in SIDES]
    if compass is not None:
        codes = [f"compass-{each}" for each in (*COMPASS[compass:], *COMPASS[:compass])]
    first = heading if compass is None else compass * 45.0
    return Face(first, tuple(codes if full else codes[::2]))


def _things_by_sector(things: Iterable[Thing], room: Room, face: Face) -> list[list[tuple[int, Thing]]]:
    """The things in range with their distances, the nearest first, by sector."""
    found: list[list[tuple[int, Thing]]] = [[] for _ in face.codes]
    for thing in things:
        gap, heading = room.nearest(thing.outlines)
        if (steps := _in_range(room, gap)) is not None:
            sector = face.sector(heading)
            straight = _in_range(room, room.ahead(thing.outlines, face.heading(sector)))
            found[sector].append((steps if straight is None else straight, thing))
    return [sorted(each, key=lambda found: (found[0], found[1].name)) for each in found]


def _sector_in_words(
    room: Room, face: Face, sector: int, things: list[tuple[int, Thing]], wording: Wording
) -> Iterator[str]:
    where = wording(face.codes[sector], hour=sector or 12)
    wall, free = (_in_range(room, room.ahead(each, face.heading(sector))) for each in (room.walls, room.all))
    found = [(steps, _named(thing, wording)) for steps, thing in things]
    is_named = sector % face.every == 0
    if wall is not None and (found or is_named):
        found = sorted([*found, (wall, wording("cell-wall"))], key=lambda each: each[0])
    for steps, name in found:
        yield wording("around-thing", where=where, thing=name, steps=steps)
    if not found and is_named:
        yield wording("around-free", where=where, steps=RANGE if free is None else free)


def _in_range(room: Room, steps: float) -> int | None:
    """Whole steps; None out of range."""
    whole = room.whole(min(steps, RANGE + 1))
    return whole if whole <= RANGE else None


def _named(thing: Thing, wording: Wording) -> str:
    return specific_name_of(thing, wording) if wording.detail == "brief" else coloured_thing(thing, wording)


class Pointer(Struct):
    """The pointer's place. ``cell`` None: on the robot, wherever the robot moves."""

    scene: MapScene
    cell: Cell | None = None
    marked: Cell | None = None
    """The marked square, from which the way is described."""

    @property
    def here(self) -> Cell:
        return self.cell or self.scene.robot

    def move(self, east: int, north: int) -> None:
        """Moves by cells, within the floor."""
        bounds, cell = self.scene.bounds, self.here
        x = min(max(cell.x + east, bounds.left), bounds.right)
        y = min(max(cell.y + north, bounds.bottom), bounds.top)
        self.cell = Cell(x, y)

    def go(self, cell: Cell) -> None:
        """Moves to that cell, or to the nearest one of the floor."""
        here = self.here
        self.move(cell.x - here.x, cell.y - here.y)

    def to_robot(self) -> None:
        self.cell = None

    def to_next_thing(self, forward: bool) -> bool:
        """Moves to the next thing by its distance from the robot; False if there is none."""
        order = self._things_by_distance()
        if not order:
            return False
        index = order.index(self.here) if self.here in order else (-1 if forward else 0)
        self.cell = order[(index + (1 if forward else -1)) % len(order)]
        return True

    def _things_by_distance(self) -> list[Cell]:
        scene, pose = self.scene, self.scene.pose
        cells = {*(scene.cell_at(each.x, each.y) for each in scene.things), *scene.others.values()}

        def distance(cell: Cell) -> float:
            x, y = scene.place(cell)
            return hypot(x - pose.x, y - pose.y)

        return sorted(cells, key=lambda cell: (distance(cell), cell))

    def mark(self) -> None:
        self.marked = self.here

    # --- in words

    def words(self, wording: Wording) -> str:
        """The content of the pointer's square, and where it is from the robot."""
        x, y = self.scene.place(self.here)
        place = place_of(x, y, self.scene.pose, wording)
        return wording("map-square", x=x, y=y, what=content(self.scene, self.here, wording), place=place)

    def way(self, wording: Wording) -> str:
        """The way from the marked square to this one; from the robot's where none is marked."""
        from_x, from_y = self.scene.place(self.marked or self.scene.robot)
        x, y = self.scene.place(self.here)
        pose = replace(self.scene.pose, x=float(from_x), y=float(from_y))
        place = place_of(x, y, pose, wording)
        return wording("map-way", from_x=from_x, from_y=from_y, x=x, y=y, place=place)


def content(scene: MapScene, cell: Cell, wording: Wording) -> str:
    """What a square shows, a thing with its colour and a robot with its name."""
    kind, thing = scene.kind(cell), scene.thing(cell)
    if kind is Kind.OTHER:
        return scene.robot_at(cell) or wording("cell-other")
    if kind is Kind.ROBOT and scene.grid.name:
        return scene.grid.name
    if kind is not Kind.THING:
        return wording(f"cell-{kind.value}", number=scene.grid.goals.get(cell))
    if thing is None:
        return scene.letter(cell)
    return coloured_thing(thing, wording)


def legend(scene: MapScene, wording: Wording) -> tuple[str, ...]:
    """The meanings of the letters that are shown; the things of this floor come last, with their colours."""
    letters: dict[str, list[Thing]] = {}
    for thing in scene.things:
        letters.setdefault(thing.letter, []).append(thing)
    goals = ("goal",) if scene.grid.goals else ()
    trail = () if Kind.TRAIL in scene.grid.hidden else ("start", *goals, "trail")
    ray = () if Kind.RAY in scene.grid.hidden else ("ray",)
    fixed = ("robot", *(trail or goals), "wall", *ray, "free", "outside")
    return (
        *(wording(f"legend-{each}", name=scene.grid.name or wording("cell-robot")) for each in fixed),
        *(
            wording("map-legend", letter=letter, name=_in_their_colours(things, wording))
            for letter, things in sorted(letters.items())
        ),
    )


def _in_their_colours(things: Sequence[Thing], wording: Wording) -> str:
    """ "box, red", or what they are called and each colour once: "flower: R red, B blue"."""
    first, *others = things
    if all(each.colour == first.colour for each in others):
        return _of_all(first, wording) if others else coloured_thing(first, wording)
    initials = colour_initials(wording)
    shades = dict.fromkeys(
        f"{initials.get(each.colour, '')} {shade(each, wording)}".strip() for each in things
    )
    return f"{name_of(first, wording)}: {', '.join(shades)}"


def _of_all(thing: Thing, wording: Wording) -> str:
    """What is true of all things of its kind and colour."""
    return coloured(thing.kind, "", thing.colour, wording)
