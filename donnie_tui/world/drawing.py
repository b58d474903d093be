"""A floor drawn in letters: a text in; the text of a world file, or all mistakes with their places, out.

``#`` is a wall, ``.`` free floor, ``^ > v <`` a robot and where it looks; other letters are things. Under the
drawing each letter has a line: ``c chair green AS throne``. A letter alone is a thing
of its usual size; letters that touch are one thing as large as they are. Of several colours each is for one
thing, in reading order. The first robot is at 0 0. What ``donnie world NAME --map`` prints is such a text.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from itertools import cycle
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from msgspec import Struct
from msgspec.structs import replace

import worlds
from devices.ports.robot import STEP
from donnie_tui.core.wording import Wording
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.world import things
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
MOST_SLIPS = 20
"""Mistakes that are listed."""
_HEADING = {"^": 90, ">": 0, "v": -90, "<": 180}
"""As world files have it: counter-clockwise from the east."""


class Slip(NamedTuple):
    """One mistake: its place (line 0: nowhere) and the sentence about it."""

    line: int
    column: int
    message: str


Square: TypeAlias = tuple[int, int]
"""Row and column of the drawing, counted from its first letter."""
Box: TypeAlias = tuple[float, float, float, float]
"""Its first column and row, and where they end."""


class Group(Struct, frozen=True):
    """Equal letters that touch: one thing."""

    letter: str
    squares: tuple[Square, ...]
    """In reading order."""
    colour: str = ""
    """That of the mark among the letters, if there is one."""

    @property
    def box(self) -> Box:
        """In squares from the first letter of the drawing."""
        rows, columns = zip(*self.squares, strict=True)
        return min(columns), min(rows), max(columns) + 1, max(rows) + 1


def groups_in(rows: Sequence[str], marks: Mapping[str, Mapping[str, str]] = {}) -> Iterator[Group]:
    """The things of a drawing, in reading order: equal letters that touch, also at corners.

    ``marks``: of each letter the colours by the marks that may stand in its midst.
    """
    left = {square: letter for square, letter in _squares(rows) if letter not in (WALL, FREE, *ARROWS)}
    marks = {letter: {mark: each[mark] for mark in {*each} - {*marks}} for letter, each in marks.items()}
    only_marks = {mark for each in marks.values() for mark in each}
    for first in sorted(left, key=lambda square: left[square] in only_marks):
        letter = left.get(first, "")
        colours, found, waiting = marks.get(letter, {}), list[Square](), {first} if letter else set()
        while waiting:
            here = waiting.pop()
            del left[here]
            found.append(here)
            waiting |= {each for each in _around(here) if left.get(each) in (letter, *colours)}
        if found:
            found.sort()
            colour = next((colours[rows[y][x]] for y, x in found if rows[y][x] in colours), "")
            yield Group(letter, tuple(found), colour)


def _squares(rows: Sequence[str]) -> Iterator[tuple[Square, str]]:
    """All of them, with their letters."""
    return (((row, column), letter) for row, line in enumerate(rows) for column, letter in enumerate(line))


def _around(square: Square) -> Iterator[Square]:
    """A square and those that touch it."""
    row, column = square
    return ((row + down, column + right) for down in (-1, 0, 1) for right in (-1, 0, 1))


# --- the legend


class _Legend:
    """The lines under a drawing."""

    def __init__(self, lines: Iterable[tuple[int, str]], wording: Wording) -> None:
        """``lines``: with their numbers."""
        self.things: dict[str, things.Description] = {}
        """By their letters."""
        self.places: dict[str, tuple[int, int]] = {}
        """Line and column of each description, also where it has mistakes."""
        self.bodies = set[str]()
        """The letters around robots in a map that was printed."""
        self.robots: list[str] = []
        self.line_of_robots = 0
        self.has_none = False
        """Whether it says that there is no robot."""
        self.scale = 1
        """Steps that a letter is wide and high."""
        self.slips: list[Slip] = []
        self._words = wording
        for number, line in lines:
            if line.strip():
                self._read(line, number)

    def _read(self, line: str, number: int) -> None:
        text, digits, found = line.strip(), re.search(r"\d{1,6}", line), _meaning().fullmatch(line)
        first, steps = text.split()[0], int(digits[0]) if digits else 0
        if _is_sentence(text, "map-no-robot"):
            self.has_none = True
        elif steps and _is_sentence(text, "map-scale", steps=steps):
            self.scale = min(LARGEST_SCALE, steps)
        elif found is None and first not in (WALL, FREE):
            code = "drawing-gap" if {*text} <= {WALL, FREE} else "drawing-legend"
            self._report(number, line.index(first), code, found=first[:40])
        elif found is not None:
            self._read_letter(found, number)

    def _read_letter(self, found: re.Match[str], number: int) -> None:
        letter, meaning = found["letter"], found["meaning"]
        names = [each.strip() for each in meaning.split(",") if each.strip()]
        if letter[0] in ARROWS:
            self.robots, self.line_of_robots = names, number
        elif letter in self.places:
            self._report(number, found.start("letter"), "drawing-letter-twice", letter=letter)
        elif names and {*names} <= {*self.robots, "…"}:
            self.bodies.add(letter)
        else:
            self.places[letter] = number, found.start("meaning") + 1
            text, name = things.split_name(meaning)
            try:
                self.things[letter] = replace(things.description_of(text, self._words), name=name or "")
            except things.BadDescription as bad:
                begin = found.start("meaning") + 1
                self.slips += (Slip(number, begin + at, each) for at, each in bad.mistakes.items())

    def _report(self, number: int, at: int, code: str, **values: object) -> None:
        self.slips.append(Slip(number, at + 1, self._words(code, **values)))


@cache
def _meaning() -> re.Pattern[str]:
    """A line that says what a letter means, with or without "is", "=" or ":"."""
    verbs = (Words(each)("map-legend", letter="", name="").strip(" .") for each in languages())
    joint = rf"\s*[=:]|\s+(?:{'|'.join(map(re.escape, verbs))})(?=\s)|(?=\s)|$"
    return re.compile(rf"\s*(?P<letter>[\^>v<](?:\s+[\^>v<])*|[^\W_])(?:{joint})\s*(?P<meaning>.*?)\.?\s*")


def _is_sentence(text: str, code: str, **values: object) -> bool:
    return any(text == Words(each)(code, **values) for each in languages())


# --- the world


class Built(Struct, frozen=True):
    """A drawing as a world file, and what is in it."""

    text: str
    width: int
    """Steps from west to east."""
    depth: int
    robots: int
    things: int


class _BadDrawing(Exception):
    """Its arguments are the mistakes."""


def world_of(text: str, file: str, wording: Wording) -> Built:
    """The world that a drawing means. Raises ``Unusable`` with a sentence for each mistake in ``file``."""
    try:
        return _Drawing(text, wording).built()
    except _BadDrawing as bad:
        slips = sorted({*bad.args})
    shown = (
        wording("world-error-at" if each.line else "drawing-error", file=file, **each._asdict())
        for each in slips[:MOST_SLIPS]
    )
    raise Unusable(*shown, wording("world-new-mistakes", count=len(slips)))


_LEGEND_LINE = re.compile(rf"(\w|[{re.escape(ARROWS)}])\s+\w\w")
"""How a line says what a letter means: ``c chair green``. A row has no blanks."""


class _Drawing:
    """A drawing with its legend, and the world file that it means."""

    def __init__(self, text: str, wording: Wording) -> None:
        lines = [each.rstrip(" ") for each in text.splitlines()]
        begin = next((at for at, each in enumerate(lines) if each), len(lines))
        below = enumerate(lines[begin:], start=begin)
        end = next((at for at, each in below if not each or _LEGEND_LINE.match(each)), len(lines))
        self._words = wording
        self._legend = legend = _Legend(enumerate(lines[end:], start=end + 1), wording)
        walls = {letter for letter, each in legend.things.items() if each.kind == things.WALL}
        self._rows = rows = [
            each.translate(dict.fromkeys(map(ord, walls), WALL)) for each in lines[begin:end]
        ]
        self._first = begin + 1
        """The number of the first row's line."""
        self._step = legend.scale * STEP
        _refuse(self._slips_of_size())
        marks = {letter: each.marks for letter, each in legend.things.items()}
        self._groups = [*groups_in(rows, marks)]
        known = ((each, legend.things.get(each.letter)) for each in self._groups)
        self._things = [(group, described) for group, described in known if described]
        bodies = {square for each in self._groups if each.letter in legend.bodies for square in each.squares}
        robots = (square for square, letter in _squares(rows) if letter in ARROWS)
        self._robots = sorted(robots, key=lambda each: (not bodies.isdisjoint(_around(each)), each))
        """In reading order; those amid the letters of their bodies last, as a printed map has them."""
        self._origin = next(iter(self._robots), (len(rows) // 2, len(rows[0]) // 2))

    # --- mistakes

    def _slip(self, code: str, square: tuple[int, int], **values: object) -> Slip:
        return Slip(self._first + square[0], square[1] + 1, self._words(code, **values))

    def _slips_of_size(self) -> Iterator[Slip]:
        rows = self._rows
        wide = next((row for row, line in enumerate(rows) if len(line) > MOST_SIDE), None)
        if not rows:
            yield Slip(0, 0, self._words("drawing-empty"))
        elif len(rows) > MOST_SIDE:
            yield self._slip("drawing-high", (MOST_SIDE, 0), most=MOST_SIDE)
        elif wide is not None:
            yield self._slip("drawing-wide", (wide, MOST_SIDE), most=MOST_SIDE)

    def _slips_of_letters(self) -> Iterator[Slip]:
        """In the legend; lines of another length; each letter without a meaning once."""
        yield from self._legend.slips
        known, first = {*self._legend.places, *self._legend.bodies}, len(self._rows[0])
        for row, count in enumerate(map(len, self._rows)):
            if count != first:
                yield self._slip("drawing-ragged", (row, min(count, first)), count=count, first=first)
        unknown = {
            each.letter: each.squares[0] for each in reversed(self._groups) if each.letter not in known
        }
        for letter, square in unknown.items():
            near = letter.swapcase() if letter.swapcase() in known else ""
            code = "sign" if not letter.isalnum() else "letter-near" if near else "letter"
            code = ("tab" if letter == "\t" else "blank") if letter.isspace() else code
            yield self._slip(f"drawing-{code}", square, letter=letter, near=near, sign=letter)

    def _slips_of_robots(self) -> Iterator[Slip]:
        names, count, place = self._legend.robots, len(self._robots), (self._legend.line_of_robots, 1)
        if not count and not self._legend.has_none:
            yield Slip(0, 0, self._words("drawing-no-robot"))
        elif names and len(names) != count and "…" not in names:
            yield Slip(*place, self._words("drawing-robot-names", names=len(names), count=count))
        elif len({*map(fold_name, names)}) != len(names):
            yield Slip(*place, self._words("drawing-name-twice"))
        elif count > 1 and not names:
            yield self._slip("drawing-robots", sorted(self._robots)[1], count=count)

    def _slips_of_colours(self) -> Iterator[Slip]:
        """Things of one letter with more or fewer colours than there are things."""
        for letter, described in self._legend.things.items():
            groups, colours = [each for each in self._groups if each.letter == letter], len(described.colours)
            if described.marks:
                colours = sum(bool(each.colour) for each in groups)
            if (colours > 1 or described.marks) and colours != len(groups):
                message = self._words("drawing-colours", count=len(groups), colours=colours)
                yield Slip(*self._legend.places[letter], message)

    def _slips_of_room(
        self, scene: Scene, walls: Sequence[Box], robots: Mapping[str, Square]
    ) -> Iterator[Slip]:
        """Things of one letter that are larger than the free floor around it, and robots inside something."""
        boxes = [(self._fitted(each, it.kind)[0], it.kind, each) for each, it in self._things]
        solid = [*((each, things.WALL, None) for each in walls), *boxes]
        for mine, kind, group in boxes:
            over = (other for box, other, each in solid if each is not group and _overlap(mine, box))
            other = next(over, None) if len(group.squares) == 1 else None
            if other is not None:
                names = {"thing": self._called(kind), "other": self._called(other)}
                sides = {"width": round(mine[2] - mine[0]), "depth": round(mine[3] - mine[1])}
                yield self._slip("drawing-thing-room", group.squares[0], **names, **sides)
        for note in scene.report.notes if self._legend.scale == 1 else ():
            square = robots.get(str(note.details.get("name"))) if note.code == "starts-inside" else None
            if square is not None:
                yield self._slip("drawing-robot-room", square, thing=self._called(str(note.details["thing"])))

    def _called(self, kind: str) -> str:
        return things.word_for(kind, self._words)

    # --- the world file

    def built(self) -> Built:
        """Raises ``_BadDrawing``."""
        from sim.worldfile import Code, WorldError, load_text, rectangles  # loads the parser

        for slips in (self._slips_of_letters(), self._slips_of_robots(), self._slips_of_colours()):
            _refuse(slips)
        rows, scale = self._rows, self._legend.scale
        walls = [*rectangles(bytes(each == WALL for each in row) for row in rows)]
        robots = dict(zip(self._robot_names(), self._robots, strict=True))
        text = things.world_text(
            [*map(self._wall, walls)],
            [*self._thing_lines()],
            [
                things.model_line("donnie", self._pose((x, y, x + 1, y + 1), _HEADING[rows[y][x]]), name)
                for name, (y, x) in robots.items()
            ],
        )
        try:
            if len(walls) + len(self._things) > MOST_PIECES:
                raise WorldError(Code.TOO_MUCH, "", limit=MOST_PIECES)
            scene = load_text(text, Path(worlds.SCENES, "drawing.world"), allowed=(Path(worlds.SCENES),))
        except WorldError:
            values = {"count": len(walls) + len(self._things), "most": MOST_PIECES}
            raise _BadDrawing(Slip(0, 0, self._words("drawing-much", **values))) from None
        _refuse(self._slips_of_room(scene, walls, robots))
        return Built(text, len(rows[0]) * scale, len(rows) * scale, len(robots), len(self._things))

    def _robot_names(self) -> list[str]:
        names = [each for each in self._legend.robots if each != "…"] or ["donnie"]
        more = (f"{names[0]}{number}" for number in range(2, MOST_PIECES))
        return [*names, *(each for each in more if each not in names)][: len(self._robots)]

    def _pose(self, box: Box, angle: float = 0) -> tuple[float, float, float]:
        """Of the middle: metres to the east and to the north of the first robot, and an angle."""
        (left, top, right, bottom), (row, column) = box, self._origin
        east, north = (left + right - 1) / 2 - column, row - (top + bottom - 1) / 2
        return round(east * self._step, 6) + 0.0, round(north * self._step, 6) + 0.0, angle

    def _wall(self, box: Box) -> str:
        width, depth = ((box[at + 2] - box[at]) * self._step for at in (0, 1))
        return things.model_line(things.WALL, self._pose(box), size=(width, depth, things.WALL_HEIGHT))

    def _thing_lines(self) -> Iterator[str]:
        colours = {letter: cycle(each.colours or ("",)) for letter, each in self._legend.things.items()}
        used = Counter[str]()
        for group, described in self._things:
            colour = next(colours[group.letter])
            name = described.name or described.kind.replace("_", " ")
            used[name] += 1
            name = name if used[name] == 1 else f"{name} {used[name]}"
            box, angle, size = self._fitted(group, described.kind)
            pose, colour = self._pose(box, angle), group.colour or colour
            yield things.model_line(described.kind, pose, name, size, colour)

    def _fitted(self, group: Group, kind: str) -> tuple[Box, int, tuple[float, ...]]:
        """Box, angle and size of a thing as large as its letters; no size where it is the usual one."""
        left, top, right, bottom = group.box
        width, depth, slack = (right - left) * self._step, (bottom - top) * self._step, self._step
        across, along, height = usual_sizes()[kind]
        if len(group.squares) == 1:
            east, south = (round(each / self._step - 1, 6) / 2 for each in (across, along))
            return (left - east, top - south, right + east, bottom + south), 0, ()
        for angle, mine, other in ((0, across, along), (90, along, across)):
            if 0 <= round(width - mine, 3) <= slack and 0 <= round(depth - other, 3) <= slack:
                return group.box, angle, ()
        return group.box, 0, (width, depth, height)


@cache
def usual_sizes() -> Mapping[str, tuple[float, float, float]]:
    """Metres, by kind: from west to east, from south to north, and up."""
    from sim.worldfile import load_text  # loads the parser

    text = things.world_text([f"{kind}()" for kind in things.KINDS])
    scene = load_text(text, Path(worlds.SCENES, "sizes.world"), allowed=(Path(worlds.SCENES),))
    return {each.kind: each.size for each in scene.models}


def _refuse(slips: Iterable[Slip]) -> None:
    found = [*slips]
    if found:
        raise _BadDrawing(*found)


def _overlap(mine: Box, other: Box) -> bool:
    return mine[0] < other[2] and other[0] < mine[2] and mine[1] < other[3] and other[1] < mine[3]
