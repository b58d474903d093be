"""The floor of a world as letters, with one robot, its start and its trail; places and paths in words.

Cells are counted from the south-west corner of the simulator's picture. A cell is one step wide, or several
in a very large world. The floor has no end: beyond the picture it is free. The trail is bounded: its oldest
cells are forgotten first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from enum import Enum
from itertools import islice, pairwise
from math import floor, hypot, remainder
from typing import TYPE_CHECKING, NamedTuple

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.robot import Pose
from donnie_tui.core.timeline import SAME_PLACE, DrivenPath, Trail, apart
from donnie_tui.core.wording import COMPASS, Wording, bearing, facing, position_in_words, whole_steps

if TYPE_CHECKING:
    from sim.picture import Picture, Thing

TRAIL, START, FREE, WALL = "o", "A", ".", "#"
LONGEST_TRAIL = 10_000
"""Cells of the trail that are kept; a learner's world has some 1600 in all."""
FARTHEST = 10**9
"""The distance in cells up to which the map follows the robot."""

_GOALS = "123456789*"
_ARROWS = ("^", "/", ">", "\\", "v", "/", "<", "\\")


class Cell(NamedTuple):
    """A square of the floor, counted from the corner of the picture; x to the east, y to the north."""

    x: int
    y: int


class Kind(Enum):
    """What a cell shows."""

    ROBOT = "robot"
    START = "start"
    GOAL = "goal"
    """A place of a challenge's goal."""
    TRAIL = "trail"
    WALL = "wall"
    FREE = "free"
    THING = "thing"
    OTHER = "other"
    """Another robot."""
    RAY = "ray"
    """The line along which a sensor measured."""


class Bounds(Struct, frozen=True):
    """The part of the floor that is worth showing, both ends included."""

    left: int
    bottom: int
    right: int
    top: int

    @property
    def width(self) -> int:
        return self.right - self.left + 1

    @property
    def height(self) -> int:
        return self.top - self.bottom + 1

    def __contains__(self, cell: Cell) -> bool:
        return self.around(cell) == self

    def around(self, cell: Cell) -> Bounds:
        """The same, widened so that the cell is inside."""
        return Bounds(
            min(self.left, cell.x), min(self.bottom, cell.y), max(self.right, cell.x), max(self.top, cell.y)
        )

    def part(self, cell: Cell, widest: int, highest: int) -> Bounds:
        """A part of at most that size, with the cell in its middle unless an edge is near."""
        left, right = _part(self.left, self.right, cell.x, widest)
        bottom, top = _part(self.bottom, self.top, cell.y, highest)
        return Bounds(left, bottom, right, top)

    def rows(self, letter: Callable[[Cell], str]) -> tuple[str, ...]:
        """The letters of each square, the northern row first."""
        columns = range(self.left, self.right + 1)
        return tuple(
            "".join(letter(Cell(x, y)) for x in columns) for y in range(self.top, self.bottom - 1, -1)
        )


def _part(first: int, last: int, middle: int, most: int) -> tuple[int, int]:
    begin = max(first, min(middle - most // 2, last - most + 1))
    return begin, min(last, begin + most - 1)


class MapGrid:
    """One robot on one floor."""

    def __init__(self, picture: Picture, pose: Pose, name: str = "") -> None:
        """``name``: the robot's; without one it is Donnie."""
        self.picture = picture
        self.name = name
        self._trail: dict[Cell, None] = {}
        """In the order of the last visits."""
        self._goals: Mapping[Cell, int] = {}
        self.hidden: frozenset[Kind] = frozenset()
        """Marks that are not shown."""
        self.start = self.robot = self.cell_of(pose)
        self.begin(pose)

    def begin(self, pose: Pose) -> frozenset[Cell]:
        """Starts here, without a trail. Returns the cells that may look different."""
        before = frozenset((*self._trail, self.start, self.robot))
        self._trail.clear()
        self.start = self.robot = self.cell_of(pose)
        self._arrow = arrow_of(pose.heading)
        floor = Bounds(0, 0, self.picture.width - 1, self.picture.height - 1)
        self._bounds = floor.around(self.start)
        return before | {self.start}

    def move(self, pose: Pose) -> frozenset[Cell]:
        """Moves the robot there in a straight line. Returns the cells that look different."""
        cell, arrow = self.cell_of(pose), arrow_of(pose.heading)
        if (cell, arrow) == (self.robot, self._arrow):
            return frozenset()
        walked = cells_between(self.robot, cell, LONGEST_TRAIL)
        forgotten = self._walk(walked)
        self.robot, self._arrow = cell, arrow
        self._bounds = self._bounds.around(cell)
        return frozenset((*walked, cell, *forgotten))

    def _walk(self, cells: tuple[Cell, ...]) -> tuple[Cell, ...]:
        for cell in cells:
            self._trail.pop(cell, None)
            self._trail[cell] = None
        forgotten = tuple(islice(self._trail, max(0, len(self._trail) - LONGEST_TRAIL)))
        for cell in forgotten:
            del self._trail[cell]
        return forgotten

    def cell_of(self, pose: Pose) -> Cell:
        """The cell in which the robot's middle is."""
        return self.cell_at(pose.x, pose.y)

    def cell_at(self, x: float, y: float) -> Cell:
        """The cell of a place in steps."""
        return Cell(self.column_at(x), self.row_at(y))

    def column_at(self, x: float) -> int:
        """The column of cells that is ``x`` steps to the east."""
        return _nearest((x - self.picture.left) / self.picture.cell)

    def row_at(self, y: float) -> int:
        """The row of cells that is ``y`` steps to the north."""
        return _nearest((y - self.picture.bottom) / self.picture.cell)

    def place(self, cell: Cell) -> tuple[int, int]:
        """The middle of a cell in steps: x to the east, y to the north."""
        picture = self.picture
        return picture.left + cell.x * picture.cell, picture.bottom + cell.y * picture.cell

    def mark_goals(self, places: Iterable[tuple[int, float, float, float, float]]) -> None:
        """The numbers of goals with the west, south, east and north of their places, in steps."""
        found: dict[Cell, int] = {}
        floor = Bounds(0, 0, self.picture.width - 1, self.picture.height - 1)
        for number, west, south, east, north in places:
            low, high = self.cell_at(west, south), self.cell_at(east, north)
            for x in range(max(low.x, floor.left), min(high.x, floor.right) + 1):
                for y in range(max(low.y, floor.bottom), min(high.y, floor.top) + 1):
                    if self.floor_letter(Cell(x, y)) == FREE:
                        found.setdefault(Cell(x, y), number)
        self._goals = found

    @property
    def goals(self) -> Mapping[Cell, int]:
        """The number of the goal whose place is there, of those on free floor."""
        return {} if Kind.GOAL in self.hidden else self._goals

    @property
    def marked(self) -> frozenset[Cell]:
        """The cells with trail, the start or a goal, shown or hidden."""
        return frozenset((*self._trail, self.start, *self._goals))

    def thing(self, cell: Cell) -> Thing | None:
        """The thing at a cell; of several, the one whose middle is nearest."""
        letter, (x, y) = self.floor_letter(cell), self.place(cell)
        alike = [each for each in self.picture.things if each.letter == letter]
        return min(alike, key=lambda each: hypot(each.x - x, each.y - y), default=None)

    def is_wide(self, thing: Thing) -> bool:
        """Whether it takes several cells, with room for the initial of its colour in the middle."""
        return max(thing.width, thing.depth) >= 1.5 * self.picture.cell

    @property
    def bounds(self) -> Bounds:
        """The picture, and all cells beyond it where the robot was."""
        return self._bounds

    def letter(self, cell: Cell) -> str:
        """What the cell shows, one letter."""
        if cell == self.robot:
            return self._arrow
        if cell in self.goals:
            return _GOALS[min(self.goals[cell], len(_GOALS)) - 1]
        if self._is_start(cell):
            return START
        return TRAIL if self._has_trail(cell) else self.floor_letter(cell)

    def kind(self, cell: Cell) -> Kind:
        """What the cell shows, for words and colours."""
        if cell == self.robot:
            return Kind.ROBOT
        if cell in self.goals:
            return Kind.GOAL
        if self._is_start(cell):
            return Kind.START
        if self._has_trail(cell):
            return Kind.TRAIL
        return {WALL: Kind.WALL, FREE: Kind.FREE}.get(self.floor_letter(cell), Kind.THING)

    def _is_start(self, cell: Cell) -> bool:
        """Whether the visible trail begins there."""
        return cell == self.start and Kind.TRAIL not in self.hidden

    def _has_trail(self, cell: Cell) -> bool:
        return cell in self._trail and Kind.TRAIL not in self.hidden

    def floor_letter(self, cell: Cell) -> str:
        """The letter without the robot and its trail: ``WALL``, ``FREE`` or that of a thing."""
        if 0 <= cell.x < self.picture.width and 0 <= cell.y < self.picture.height:
            return self.picture.rows[self.picture.height - 1 - cell.y][cell.x]
        return FREE

    def rows(self) -> tuple[str, ...]:
        """The whole map, the northern row first."""
        return self._bounds.rows(self.letter)


def floor_size(picture: Picture) -> tuple[int, int]:
    """The steps from west to east and from south to north, without the walls around the floor."""
    columns = ["".join(column) for column in zip(*picture.rows, strict=True)]
    return _inner(columns) * picture.cell, _inner(picture.rows) * picture.cell


def _inner(lines: Sequence[str]) -> int:
    """The number of lines, without those at either end that are only wall."""
    walls = [line == WALL * len(line) for line in lines]
    return len(walls) - walls[0] - walls[-1] if len(walls) > 2 else len(walls)


def _nearest(cells: float) -> int:
    """The nearest whole number; halfway always goes up, so that all cells are equally wide."""
    return max(-FARTHEST, min(FARTHEST, floor(round(cells, 6) + 0.5)))


def arrow_of(heading: float) -> str:
    """An arrow in the four main directions (45 degrees each), a stroke between them."""
    return _ARROWS[round(heading / 45) % 8]


def cells_between(start: Cell, end: Cell, most: int) -> tuple[Cell, ...]:
    """The cells on the straight way from ``start`` to ``end``, without ``end``; at most the last ``most``."""
    length = max(abs(end.x - start.x), abs(end.y - start.y))
    first = max(0, length - most)
    return tuple(_on_the_way(start, end, step, length) for step in range(first, length))


def _on_the_way(start: Cell, end: Cell, step: int, length: int) -> Cell:
    """Rounded in integers: exact however far it is."""
    return Cell(
        start.x + ((end.x - start.x) * step * 2 + length) // (2 * length),
        start.y + ((end.y - start.y) * step * 2 + length) // (2 * length),
    )


# --- places and paths in words

DEFAULT_MOVES = 5
"""Moves that TRAIL gives without a number."""


LEGS_SAID, LEGS_AT_PICTURES = 200, 24
"""Legs that SHOW PATH gives of a path, and the legend of a picture."""


def path_in_words(path: DrivenPath, wording: Wording, most: int | None = None) -> tuple[str, ...]:
    """A driven path: its start, a sentence for each straight leg, and its length.

    Of more than ``most`` legs those in the middle are left out. Sentences say what is left out.
    """
    legs: list[tuple[Pose, Pose]] = []
    length = 0.0
    for here, there in pairwise(path.pieces[-1]):
        length += apart(here, there)
        is_still = apart(here, there) <= SAME_PLACE
        if legs and (is_still or _is_straight_on(*legs[-1], there)):
            legs[-1] = legs[-1][0], there
        elif not is_still:
            legs.append((here, there))
    if not legs and not path.has_gap:
        return (wording("trail-none"),)
    said = [_leg(*each, wording) for each in legs]
    if most is not None and len(legs) > most:
        first, last = most // 2, len(legs) - most // 2
        said[first:last] = [wording("path-left-out", count=last - first, **_whole(legs[last - 1][1]))]
    if path.has_gap:
        length += path.lengths[1]
        gap = wording("path-gap", steps=round(path.lengths[1]), **_whole(path.poses[1]))
        said.insert(0, gap)
    rounds = path.lengths[-1] - length
    return (
        wording("path-start", **_whole(path.poses[0])),
        *said,
        *([wording("path-rounds", steps=round(rounds))] if rounds >= 1 else []),
        wording("path-end", steps=round(path.lengths[-1])),
    )


def _is_straight_on(start: Pose, here: Pose, there: Pose) -> bool:
    turned = bearing(start.x, start.y, here.x, here.y) - bearing(here.x, here.y, there.x, there.y)
    return abs(remainder(turned, 360)) < 1


def _leg(here: Pose, there: Pose, wording: Wording) -> str:
    heading = round(bearing(here.x, here.y, there.x, there.y)) % 360
    point = f"compass-{COMPASS[heading // 45]}"
    towards = facing(replace(here, heading=heading), wording) if heading % 45 else wording(point)
    return wording("path-leg", steps=round(apart(here, there)), towards=towards, **_whole(there))


def _whole(pose: Pose) -> dict[str, int]:
    return {"x": whole_steps(pose.x), "y": whole_steps(pose.y)}


def place_in_words(pose: Pose, trail: Trail, wording: Wording, *, is_full: bool) -> tuple[str, ...]:
    """The answer to WHERE: the robot's place, and at full its last move."""
    place = position_in_words(pose, wording)
    return (place, *trail.in_words(1, wording)) if is_full else (place,)
