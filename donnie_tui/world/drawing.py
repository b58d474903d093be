"""A floor drawn in letters: a text in; the text of a world file, or all mistakes with their places, out.

``#`` is a wall, ``.`` free floor, ``^ > v <`` a robot and where it looks; other letters are things. Under the
drawing each letter has a line: ``c chair green AS throne``. A letter alone is a thing
of its usual size; letters that touch are one thing as large as they are. Of several colours each is for one
thing, in reading order. The first robot is at 0 0. What ``donnie world NAME --map`` prints is such a text.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from msgspec import Struct

import worlds
from devices.ports.robot import STEP
from donnie_tui.i18n.words import Words
from donnie_tui.world.things import (
    BadDrawing,
    Description,
    Slip,
    description_of,
    fitted,
    quoted,
    thing_line,
    usual_sizes,
    world_text,
)
from language.locales import languages
from language.source import fold_name

if TYPE_CHECKING:
    from sim.scene import Scene

WALL, FREE, ARROWS = "#", ".", "^>v<"
MOST_SIDE = 400
"""Letters of a line, and lines."""
LARGEST_SCALE = 100
"""Steps that a letter stands for."""
MOST_PIECES = 2000
"""Walls and things of a drawing; a world file has room for more."""
_HEADING = {"^": 90, ">": 0, "v": -90, "<": 180}
"""As world files have it: counter-clockwise from the east."""


class Square(NamedTuple):
    """A square of the drawing, counted from its first letter."""

    row: int
    column: int


class Group(Struct, frozen=True):
    """Equal letters that touch: one thing."""

    letter: str
    squares: frozenset[Square]

    @property
    def first(self) -> Square:
        """In reading order."""
        return min(self.squares)


class Built(Struct, frozen=True):
    """A drawing as a world file, and what is in it."""

    text: str
    width: int
    """Steps from west to east."""
    depth: int
    robots: int
    things: int


# --- the drawing and its legend


class _Legend:
    """The lines under a drawing."""

    def __init__(self) -> None:
        self.things: dict[str, tuple[Description, int, int]] = {}
        """By their letters, with the line and the column of the description."""
        self.wrong = set[str]()
        """The letters whose descriptions have mistakes."""
        self.bodies = set[str]()
        """The letters around robots in a map that was printed."""
        self.robots: list[str] = []
        self.line_of_robots = 0
        self.has_none = False
        """Whether it says that there is no robot."""
        self.scale = 1
        """Steps that a letter is wide and high."""
        self.slips: list[Slip] = []

    def read(self, lines: Sequence[str], first: int) -> None:
        """``first``: the number of the first line."""
        rest = list[tuple[int, str]]()
        for number, line in enumerate(lines, start=first):
            if line.strip() and not self._is_general(line.strip(), number):
                rest.append((number, line))
        for number, line in rest:
            self._read_letter(line, number)

    def _is_general(self, line: str, number: int) -> bool:
        """Whether it is about robots, walls, the floor or the scale."""
        arrows = re.match(r"[\^>v<](\s+[\^>v<])*\s+", line)
        if arrows:
            names = [each.strip() for each in _without_verb(line[arrows.end() :])[0].split(",")]
            self.robots, self.line_of_robots = [each for each in names if each], number
            return True
        if any(line == Words(each)("map-no-robot") for each in languages()):
            self.has_none = True
            return True
        steps = next(filter(None, (each.fullmatch(line) for each in _scales())), None)
        if steps is not None:
            self.scale = max(1, min(LARGEST_SCALE, int(steps[1])))
        return steps is not None or line.split()[0] in (WALL, FREE)

    def _read_letter(self, line: str, number: int) -> None:
        indent = len(line) - len(line.lstrip())
        letter, following = line[indent], line[indent + 1 :]
        if set(line.strip()) <= {WALL, FREE}:
            self.slips.append(Slip("drawing-gap", number, indent + 1))
        elif not letter.isalnum() or following[:1] not in ("", " ", "=", ":"):
            self.slips.append(Slip("drawing-legend", number, indent + 1, {"found": line.split()[0][:40]}))
        elif letter in self.things:
            self.slips.append(Slip("drawing-letter-twice", number, indent + 1, {"letter": letter}))
        else:
            self._describe(letter, following, number, indent + 2)

    def _describe(self, letter: str, following: str, number: int, column: int) -> None:
        text, skipped = _without_verb(following)
        names = {each.strip() for each in text.rstrip(".").split(",")}
        if names <= {*self.robots, "…"}:
            self.bodies.add(letter)
            return
        place = number, column + skipped
        try:
            self.things[letter] = (description_of(text, *place), *place)
        except BadDrawing as bad:
            self.slips += bad.slips
            self.wrong.add(letter)


@cache
def _scales() -> tuple[re.Pattern[str], ...]:
    sentences = (re.escape(Words(each)("map-scale", steps="@")) for each in languages())
    return tuple(re.compile(each.replace("@", r"(\d+)", 1).replace("@", r"\d+")) for each in sentences)


def _without_verb(text: str) -> tuple[str, int]:
    """Without the ``=`` or ``is`` at the beginning and the full stop at the end; how much it skips."""
    verbs = {Words(each)("map-legend", letter="", name="").strip(" .") for each in languages()}
    found = re.match(rf"\s*(=|:|(?:{'|'.join(map(re.escape, sorted(verbs)))})(?=\s))?\s*", text)
    skipped = found.end() if found else 0
    return text[skipped:].rstrip().removesuffix("."), skipped


def groups_in(rows: Sequence[str]) -> tuple[Group, ...]:
    """The things of a drawing, in reading order: equal letters that touch, also at corners."""
    letters = {
        Square(row, column): letter
        for row, line in enumerate(rows)
        for column, letter in enumerate(line)
        if letter not in (WALL, FREE, *ARROWS)
    }
    found = list[Group]()
    left = dict(letters)
    for first, letter in letters.items():
        if first not in left:
            continue
        del left[first]
        waiting, cells = [first], {first}
        while waiting:
            here = waiting.pop()
            for near in _around(here):
                if left.get(near) == letter:
                    del left[near]
                    cells.add(near)
                    waiting.append(near)
        found.append(Group(letter, frozenset(cells)))
    return tuple(found)


def _around(cell: Square) -> Iterator[Square]:
    for down in (-1, 0, 1):
        for right in (-1, 0, 1):
            if down or right:
                yield Square(cell.row + down, cell.column + right)


_MEANING = re.compile(rf"(\w|[{re.escape(ARROWS)}])\s+\w\w")
"""How a line says what a letter means: ``c chair green``. A row has no blanks."""


def _rows_and_legend(text: str) -> tuple[list[str], int, _Legend]:
    """The rows, the number of the first one's line, and what is under them."""
    lines = [each.rstrip(" ") for each in text.splitlines()]
    begin = next((number for number, each in enumerate(lines) if each), len(lines))
    ends = (
        number for number in range(begin, len(lines)) if not lines[number] or _MEANING.match(lines[number])
    )
    end = next(ends, len(lines))
    legend = _Legend()
    legend.read(lines[end:], end + 1)
    return lines[begin:end], begin + 1, legend


def _unmarked(rows: Sequence[str], legend: _Legend) -> tuple[list[str], dict[Square, str]]:
    """The rows with the letter of the thing in place of each mark of a colour, and the colours there."""
    meant_by: dict[str, dict[str, str]] = {}
    for letter, (described, _, _) in legend.things.items():
        for mark, colour in zip(described.marks, described.colours, strict=False):
            if mark not in legend.things:
                meant_by.setdefault(mark, {})[letter] = colour
    drawn, colours = [list(row) for row in rows], dict[Square, str]()
    for row, line in enumerate(rows):
        for column, mark in enumerate(line):
            around = _around(Square(row, column)) if mark in meant_by else ()
            near = [rows[y][x] for y, x in around if 0 <= y < len(rows) and 0 <= x < len(rows[y])]
            letter = next((each for each in near if each in meant_by[mark]), "")
            if letter:
                drawn[row][column], colours[Square(row, column)] = letter, meant_by[mark][letter]
    return ["".join(row) for row in drawn], colours


def _slips_in(rows: Sequence[str], first: int, legend: _Legend) -> Iterator[Slip]:
    """The mistakes of the rows, each letter without a meaning once."""
    if not rows:
        yield Slip("drawing-empty")
        return
    if len(rows) > MOST_SIDE:
        yield Slip("drawing-high", first + MOST_SIDE, 1, {"most": MOST_SIDE})
    known = {WALL, FREE, *ARROWS, *legend.things, *legend.wrong, *legend.bodies}
    reported = set[str]()
    for number, row in enumerate(rows[:MOST_SIDE], start=first):
        if len(row) > MOST_SIDE:
            yield Slip("drawing-wide", number, MOST_SIDE + 1, {"most": MOST_SIDE})
            return
        if len(row) != len(rows[0]):
            column = min(len(row), len(rows[0])) + 1
            yield Slip("drawing-ragged", number, column, {"count": len(row), "first": len(rows[0])})
        for column, letter in enumerate(row, start=1):
            if letter not in known | reported:
                reported.add(letter)
                yield _bad_letter(letter, number, column, known)


def _bad_letter(letter: str, line: int, column: int, known: Iterable[str]) -> Slip:
    if letter == "\t":
        return Slip("drawing-tab", line, column)
    if letter.isspace():
        return Slip("drawing-blank", line, column)
    if not letter.isalnum():
        return Slip("drawing-sign", line, column, {"sign": letter})
    near = next((each for each in known if each == letter.swapcase() and each.isalpha()), "")
    return Slip(
        "drawing-letter-near" if near else "drawing-letter", line, column, {"letter": letter, "near": near}
    )


# --- the world


def world_of(text: str) -> Built:
    """The world that a drawing means. Raises ``BadDrawing`` with all mistakes."""
    rows, first, legend = _rows_and_legend(text)
    rows, colours = _unmarked(rows, legend)
    slips = [*legend.slips, *_slips_in(rows, first, legend)]
    robots = () if slips else _robots(rows, legend)
    if not slips:
        slips += _slips_of_robots(robots, first, legend)
    groups = groups_in(rows) if not slips else ()
    for letter, (described, line, column) in legend.things.items() if not slips else ():
        count, known = sum(each.letter == letter for each in groups), len(described.colours)
        if described.marks:
            known = sum(each.letter == letter and not each.squares.isdisjoint(colours) for each in groups)
        if (known > 1 or described.marks) and known != count:
            values = {"count": count, "colours": known}
            slips.append(Slip("drawing-colours", line, column, values))
    if slips:
        raise BadDrawing(slips)
    return _Builder(rows, first, legend, robots, colours).built(groups)


def _robots(rows: Sequence[str], legend: _Legend) -> tuple[Square, ...]:
    """In reading order; those amid the letters of their bodies last: a printed map has the first without."""
    found = (
        Square(row, column)
        for row, line in enumerate(rows)
        for column in range(len(line))
        if line[column] in ARROWS
    )

    def has_body(cell: Square) -> bool:
        near = (rows[row][column : column + 1] for row, column in _around(cell) if 0 <= row < len(rows))
        return any(each in legend.bodies for each in near if each)

    return tuple(sorted(found, key=lambda cell: (has_body(cell), cell)))


def _slips_of_robots(robots: Sequence[Square], first: int, legend: _Legend) -> Iterator[Slip]:
    names = legend.robots
    if not robots and not legend.has_none:
        yield Slip("drawing-no-robot")
    elif names and len(names) != len(robots) and "…" not in names:
        values = {"names": len(names), "count": len(robots)}
        yield Slip("drawing-robot-names", legend.line_of_robots, 1, values)
    elif len({fold_name(each) for each in names}) != len(names):
        yield Slip("drawing-name-twice", legend.line_of_robots, 1)
    elif len(robots) > 1 and not names:
        second = sorted(robots)[1]
        values = {"count": len(robots)}
        yield Slip("drawing-robots", first + second.row, second.column + 1, values)


class _Builder:
    """Writes a drawing without mistakes of form as a world file."""

    def __init__(
        self,
        rows: Sequence[str],
        first: int,
        legend: _Legend,
        robots: Sequence[Square],
        colours: Mapping[Square, str],
    ) -> None:
        """``colours``: of the things at these squares."""
        self._rows, self._first, self._legend, self._robots = rows, first, legend, robots
        self._colours = colours
        self._origin = robots[0] if robots else Square(len(rows) // 2, len(rows[0]) // 2)
        self._used: dict[str, int] = {}

    def built(self, groups: Sequence[Group]) -> Built:
        from sim.worldfile import Code, WorldError, load_text  # loads the parser

        walls = tuple(rectangles(self._rows))
        things = [each for each in groups if each.letter not in self._legend.bodies]
        count, names = len(walls) + len(things), self._robot_names()
        placed = [self._thing(each, number) for each, number in _numbered(things)]
        robots = (self._robot(cell, name) for cell, name in zip(self._robots, names, strict=True))
        lines = [*(self._wall(*each) for each in walls), "", *placed, "", *robots]
        text = world_text(placed, lines)
        try:
            if count > MOST_PIECES:
                raise WorldError(Code.TOO_MUCH, "", limit=MOST_PIECES)
            scene = load_text(text, Path(worlds.SCENES, "drawing.world"), allowed=(Path(worlds.SCENES),))
        except WorldError:
            values = {"count": count, "most": MOST_PIECES}
            raise BadDrawing([Slip("drawing-much", values=values)]) from None
        slips = [*self._too_large(things, walls)]
        if self._legend.scale == 1:
            slips += self._robots_without_room(scene, dict(zip(names, self._robots, strict=True)))
        if slips:
            raise BadDrawing(slips)
        scale = self._legend.scale
        return Built(text, len(self._rows[0]) * scale, len(self._rows) * scale, len(names), len(things))

    def _robots_without_room(self, scene: Scene, cells: Mapping[str, Square]) -> Iterator[Slip]:
        for note in scene.report.notes:
            cell = cells.get(str(note.details.get("name"))) if note.code == "starts-inside" else None
            if cell is not None:
                values = {"thing": note.details["thing"]}
                yield Slip("drawing-robot-room", self._first + cell.row, cell.column + 1, values)

    def _too_large(self, things: Sequence[Group], walls: Sequence[tuple[Square, Square]]) -> Iterator[Slip]:
        """Things of one letter that are larger than the free floor around it."""
        boxes = [(self._box(each), each) for each in things]
        solid = [((top.column, top.row, bottom.column + 1, bottom.row + 1), None) for top, bottom in walls]
        for mine, group in boxes:
            other = next(
                (each for box, each in (*solid, *boxes) if each is not group and _overlap(mine, box)), group
            )
            if len(group.squares) == 1 and other is not group:
                values = {
                    "thing": self._legend.things[group.letter][0].kind,
                    "other": "wall" if other is None else self._legend.things[other.letter][0].kind,
                    "width": round(mine[2] - mine[0]),
                    "depth": round(mine[3] - mine[1]),
                }
                cell = group.first
                yield Slip("drawing-thing-room", self._first + cell.row, cell.column + 1, values)

    def _box(self, group: Group) -> tuple[float, float, float, float]:
        """Its first column and row and where they end, in squares; of one letter its usual size."""
        rows, columns = [each.row for each in group.squares], [each.column for each in group.squares]
        left, top, right, bottom = min(columns), min(rows), max(columns) + 1, max(rows) + 1
        if len(group.squares) > 1:
            return left, top, right, bottom
        usual = usual_sizes()[self._legend.things[group.letter][0].kind]
        across, along = (round(each / STEP / self._legend.scale, 6) for each in usual[:2])
        return left + 0.5 - across / 2, top + 0.5 - along / 2, left + 0.5 + across / 2, top + 0.5 + along / 2

    def _robot_names(self) -> list[str]:
        names = [each for each in self._legend.robots if each != "…"] or ["donnie"]
        more = (f"{names[0]}{number}" for number in range(2, MOST_PIECES))
        return (
            [*names, *(each for each in more if each not in names)][: len(self._robots)]
            if self._robots
            else []
        )

    def _place(self, row: float, column: float) -> tuple[float, float]:
        """Metres to the east and to the north of the first robot."""
        scale = self._legend.scale * STEP
        return round((column - self._origin.column) * scale, 6) + 0.0, round(
            (self._origin.row - row) * scale, 6
        ) + 0.0

    def _wall(self, top: Square, bottom: Square) -> str:
        x, y = self._place((top.row + bottom.row) / 2, (top.column + bottom.column) / 2)
        scale = self._legend.scale * STEP
        width, depth = (bottom.column - top.column + 1) * scale, (bottom.row - top.row + 1) * scale
        return f"wall( pose [ {x:g} {y:g} 0 0 ] size [ {width:.6g} {depth:.6g} 0.24 ] )"

    def _robot(self, cell: Square, name: str) -> str:
        x, y = self._place(*cell)
        heading = _HEADING[self._rows[cell.row][cell.column]]
        return f"donnie( name {quoted(name)} pose [ {x:g} {y:g} 0 {heading} ] )"

    def _thing(self, group: Group, number: int) -> str:
        described, scale = self._legend.things[group.letter][0], self._legend.scale
        rows, columns = [each.row for each in group.squares], [each.column for each in group.squares]
        place = self._place((min(rows) + max(rows)) / 2, (min(columns) + max(columns)) / 2)
        width, depth = max(columns) - min(columns) + 1, max(rows) - min(rows) + 1
        is_usual = len(group.squares) == 1
        angle, size = (0, "") if is_usual else fitted(described.kind, width * scale, depth * scale, scale)
        colours = described.colours
        colour = colours[number if len(colours) > 1 else 0] if colours and not described.marks else ""
        colour = next(
            (self._colours[each] for each in sorted(group.squares) if each in self._colours), colour
        )
        return thing_line(described.kind, colour, self._name(described), (*place, angle), size)

    def _name(self, described: Description) -> str:
        name = described.name or described.kind.replace("_", " ")
        self._used[name] = count = self._used.get(name, 0) + 1
        return name if count == 1 else f"{name} {count}"


def _overlap(mine: tuple[float, float, float, float], other: tuple[float, float, float, float]) -> bool:
    return mine[0] < other[2] and other[0] < mine[2] and mine[1] < other[3] and other[1] < mine[3]


def _numbered(groups: Iterable[Group]) -> Iterator[tuple[Group, int]]:
    """Each with its number among those of its letter, from 0."""
    counts: dict[str, int] = {}
    for each in groups:
        yield each, counts.get(each.letter, 0)
        counts[each.letter] = counts.get(each.letter, 0) + 1


def rectangles(rows: Sequence[str]) -> Iterator[tuple[Square, Square]]:
    """The walls as few rectangles: equal runs below each other are one. The first and last square of each."""
    open_runs: dict[tuple[int, int], int] = {}
    for number, line in enumerate([*rows, ""]):
        runs = [(each.start(), each.end() - 1) for each in re.finditer(f"{WALL}+", line)]
        for run in [each for each in open_runs if each not in runs]:
            yield Square(open_runs.pop(run), run[0]), Square(number - 1, run[1])
        for run in runs:
            open_runs.setdefault(run, number)
