"""A floor drawn in letters: a text in; the text of a world file, or all mistakes with their places, out.

``#`` is a wall, ``.`` free floor, ``^ > v <`` a robot and where it looks; other letters are things. Under the
drawing each letter has a line: ``c chair green AS throne``. A letter alone is a thing
of its usual size; letters that touch are one thing as large as they are. Of several colours each is for one
thing, in reading order. The first robot is at 0 0. What ``donnie world NAME --map`` prints is such a text.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from functools import cache, cached_property
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from msgspec import Struct

import worlds
from devices.ports.robot import STEP
from donnie_tui.i18n.words import Words
from donnie_tui.world.things import (
    WALL_HEIGHT,
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


Box: TypeAlias = tuple[float, float, float, float]
"""Its first column and row, and where they end."""


class Group(Struct, frozen=True):
    """Equal letters that touch: one thing."""

    letter: str
    squares: frozenset[Square]

    @property
    def first(self) -> Square:
        """In reading order."""
        return min(self.squares)

    @property
    def box(self) -> Box:
        """In squares from the first letter of the drawing."""
        rows, columns = ([each[at] for each in self.squares] for at in (0, 1))
        return min(columns), min(rows), max(columns) + 1, max(rows) + 1


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

    def __init__(self, lines: Sequence[str], first: int) -> None:
        """``first``: the number of the first line."""
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
    drawing = _Drawing(text)
    slips = [*drawing.legend.slips, *drawing.slips_of_rows()]
    slips = slips or [*drawing.slips_of_robots()] or [*drawing.slips_of_colours()]
    if slips:
        raise BadDrawing(slips)
    return drawing.built()


class _Drawing:
    """A drawing with its legend, and the world file that it means."""

    def __init__(self, text: str) -> None:
        lines = [each.rstrip(" ") for each in text.splitlines()]
        begin = next((number for number, each in enumerate(lines) if each), len(lines))
        below = enumerate(lines[begin:], start=begin)
        end = next((number for number, each in below if not each or _MEANING.match(each)), len(lines))
        self.legend = _Legend(lines[end:], end + 1)
        self._first = begin + 1
        """The number of the first row's line."""
        self._rows, self._colours = _unmarked(lines[begin:end], self.legend)
        """``_colours``: of the things at these squares."""
        self._step = self.legend.scale * STEP
        self._used, self._numbers = Counter[str](), Counter[str]()
        """How many things have a name, and a letter."""

    @cached_property
    def _robots(self) -> tuple[Square, ...]:
        """In reading order; those amid the letters of their bodies last, as a printed map has them."""
        rows = self._rows
        found = (
            Square(row, at) for row, line in enumerate(rows) for at in range(len(line)) if line[at] in ARROWS
        )

        def has_body(cell: Square) -> bool:
            near = (rows[row][column : column + 1] for row, column in _around(cell) if 0 <= row < len(rows))
            return any(each in self.legend.bodies for each in near if each)

        return tuple(sorted(found, key=lambda cell: (has_body(cell), cell)))

    @cached_property
    def _groups(self) -> tuple[Group, ...]:
        """The things; letters around a robot are none."""
        return tuple(each for each in groups_in(self._rows) if each.letter not in self.legend.bodies)

    @cached_property
    def _origin(self) -> Square:
        """The middle of the world's 0 0."""
        return self._robots[0] if self._robots else Square(len(self._rows) // 2, len(self._rows[0]) // 2)

    # --- mistakes

    def slips_of_rows(self) -> Iterator[Slip]:
        """Each letter without a meaning once."""
        legend, rows = self.legend, self._rows
        if not rows:
            yield Slip("drawing-empty")
            return
        if len(rows) > MOST_SIDE:
            yield self._slip("drawing-high", Square(MOST_SIDE, 0), most=MOST_SIDE)
        known = {WALL, FREE, *ARROWS, *legend.things, *legend.wrong, *legend.bodies}
        reported = set[str]()
        for row, line in enumerate(rows[:MOST_SIDE]):
            if len(line) > MOST_SIDE:
                yield self._slip("drawing-wide", Square(row, MOST_SIDE), most=MOST_SIDE)
                return
            if len(line) != len(rows[0]):
                column = min(len(line), len(rows[0]))
                yield self._slip("drawing-ragged", Square(row, column), count=len(line), first=len(rows[0]))
            for column, letter in enumerate(line):
                if letter not in known | reported:
                    reported.add(letter)
                    yield _bad_letter(letter, self._first + row, column + 1, known)

    def slips_of_robots(self) -> Iterator[Slip]:
        names, count, line = self.legend.robots, len(self._robots), self.legend.line_of_robots
        if not count and not self.legend.has_none:
            yield Slip("drawing-no-robot")
        elif names and len(names) != count and "…" not in names:
            yield Slip("drawing-robot-names", line, 1, {"names": len(names), "count": count})
        elif len({fold_name(each) for each in names}) != len(names):
            yield Slip("drawing-name-twice", line, 1)
        elif count > 1 and not names:
            yield self._slip("drawing-robots", sorted(self._robots)[1], count=count)

    def slips_of_colours(self) -> Iterator[Slip]:
        """Things of one letter with more or fewer colours than there are things."""
        for letter, (described, line, column) in self.legend.things.items():
            groups, known = [each for each in self._groups if each.letter == letter], len(described.colours)
            if described.marks:
                known = sum(not each.squares.isdisjoint(self._colours) for each in groups)
            if (known > 1 or described.marks) and known != len(groups):
                yield Slip("drawing-colours", line, column, {"count": len(groups), "colours": known})

    def _slips_of_room(self, scene: Scene, names: Sequence[str], walls: Sequence[Box]) -> Iterator[Slip]:
        """Things of one letter that are larger than the free floor around it, and robots inside something."""
        boxes = [(self._box(each), each) for each in self._groups]
        solid: list[tuple[Box, Group | None]] = [*((each, None) for each in walls), *boxes]
        for mine, group in boxes:
            in_the_way = (each for box, each in solid if each is not group and _overlap(mine, box))
            other = next(in_the_way, group)
            if len(group.squares) == 1 and other is not group:
                sides = {"width": round(mine[2] - mine[0]), "depth": round(mine[3] - mine[1])}
                kinds = {"thing": self._kind(group), "other": self._kind(other)}
                yield self._slip("drawing-thing-room", group.first, **kinds, **sides)
        cells = dict(zip(names, self._robots, strict=True))
        for note in scene.report.notes if self.legend.scale == 1 else ():
            cell = cells.get(str(note.details.get("name"))) if note.code == "starts-inside" else None
            if cell is not None:
                yield self._slip("drawing-robot-room", cell, thing=note.details["thing"])

    def _slip(self, code: str, cell: Square, **values: object) -> Slip:
        return Slip(code, self._first + cell.row, cell.column + 1, values)

    def _kind(self, group: Group | None) -> str:
        return "wall" if group is None else self.legend.things[group.letter][0].kind

    def _box(self, group: Group) -> Box:
        """Of one letter the usual size of the thing around it."""
        left, top, right, bottom = group.box
        if len(group.squares) > 1:
            return left, top, right, bottom
        across, along = (round(each / self._step, 6) / 2 for each in usual_sizes()[self._kind(group)][:2])
        return left + 0.5 - across, top + 0.5 - along, left + 0.5 + across, top + 0.5 + along

    # --- the world file

    def built(self) -> Built:
        from sim.worldfile import Code, WorldError, load_text, rectangles  # loads the parser

        rows, scale = self._rows, self.legend.scale
        walls = [*rectangles(bytes(each == WALL for each in row) for row in rows)]
        count, names = len(walls) + len(self._groups), self._robot_names()
        placed = [self._thing(each) for each in self._groups]
        robots = (self._robot(cell, name) for cell, name in zip(self._robots, names, strict=True))
        lines = [*map(self._wall, walls), "", *placed, "", *robots]
        text = world_text(placed, lines)
        try:
            if count > MOST_PIECES:
                raise WorldError(Code.TOO_MUCH, "", limit=MOST_PIECES)
            scene = load_text(text, Path(worlds.SCENES, "drawing.world"), allowed=(Path(worlds.SCENES),))
        except WorldError:
            values = {"count": count, "most": MOST_PIECES}
            raise BadDrawing([Slip("drawing-much", values=values)]) from None
        slips = [*self._slips_of_room(scene, names, walls)]
        if slips:
            raise BadDrawing(slips)
        return Built(text, len(rows[0]) * scale, len(rows) * scale, len(names), len(self._groups))

    def _robot_names(self) -> list[str]:
        names = [each for each in self.legend.robots if each != "…"] or ["donnie"]
        more = (f"{names[0]}{number}" for number in range(2, MOST_PIECES))
        return [*names, *(each for each in more if each not in names)][: len(self._robots)]

    def _middle(self, box: Box) -> tuple[float, float]:
        """Metres to the east and to the north of the first robot."""
        left, top, right, bottom = box
        east = (left + right - 1) / 2 - self._origin.column
        north = self._origin.row - (top + bottom - 1) / 2
        return round(east * self._step, 6) + 0.0, round(north * self._step, 6) + 0.0

    def _wall(self, box: Box) -> str:
        x, y = self._middle(box)
        width, depth = ((box[at + 2] - box[at]) * self._step for at in (0, 1))
        return f"wall( pose [ {x:g} {y:g} 0 0 ] size [ {width:.6g} {depth:.6g} {WALL_HEIGHT:g} ] )"

    def _robot(self, cell: Square, name: str) -> str:
        x, y = self._middle((cell.column, cell.row, cell.column + 1, cell.row + 1))
        heading = _HEADING[self._rows[cell.row][cell.column]]
        return f"donnie( name {quoted(name)} pose [ {x:g} {y:g} 0 {heading} ] )"

    def _thing(self, group: Group) -> str:
        described, scale = self.legend.things[group.letter][0], self.legend.scale
        left, top, right, bottom = group.box
        is_usual = len(group.squares) == 1
        width, depth = round(right - left) * scale, round(bottom - top) * scale
        angle, size = (0, "") if is_usual else fitted(described.kind, width, depth, scale)
        colours = () if described.marks else described.colours
        colour = colours[self._numbers[group.letter] % len(colours)] if colours else ""
        self._numbers[group.letter] += 1
        marked = (self._colours[each] for each in sorted(group.squares) if each in self._colours)
        name = described.name or described.kind.replace("_", " ")
        self._used[name] += 1
        name = name if self._used[name] == 1 else f"{name} {self._used[name]}"
        return thing_line(described.kind, next(marked, colour), name, (*self._middle(group.box), angle), size)


def _overlap(mine: Box, other: Box) -> bool:
    return mine[0] < other[2] and other[0] < mine[2] and mine[1] < other[3] and other[1] < mine[3]
