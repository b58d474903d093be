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
from itertools import chain, count, cycle
from pathlib import Path
from typing import TypeAlias

from msgspec import Struct

import worlds
from devices.ports.robot import STEP
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.world import things
from donnie_tui.world.loading import allowed_folders, scene_of
from language.locales import languages
from language.source import fold_name, quoted
from sim.picture import Thing, all_things
from sim.scene import Scene

WALL, FREE, ARROWS = "#", ".", "^>v<"
MOST_SIDE = 400
"""Letters of a line, and lines."""
MOST_PIECES = 2000
"""Walls and things of a drawing; a world file has room for more."""
MOST_SLIPS = 20
"""Mistakes that are listed."""
_BORDER = 1e-6
"""Steps."""
_NOWHERE = (-1, 0)
"""The place of what is about the whole drawing."""
_HEADING = {"^": 90, ">": 0, "v": -90, "<": 180}
"""As world files have it: counter-clockwise from the east."""


Square: TypeAlias = tuple[int, int]
"""Line and column of the text, counted from 0."""


class Group(Struct, frozen=True):
    """Equal letters that touch: one thing."""

    letter: str
    squares: tuple[Square, ...]
    """In reading order."""
    colour: str = ""
    """That of the mark among the letters, if there is one."""


def groups_in(rows: Sequence[str], marks: Mapping[str, Mapping[str, str]] = {}) -> Iterator[Group]:
    """The things of a drawing, in reading order: equal letters that touch, also at corners.

    ``marks``: of each letter the colours by the marks that may stand in its midst.
    """
    floor = _squares(rows)
    left = {square: letter for square, letter in floor.items() if letter not in (WALL, FREE, *ARROWS)}
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
            colour = next((colours[floor[each]] for each in sorted(found) if floor[each] in colours), "")
            yield Group(letter, tuple(sorted(found)), colour)


def _squares(rows: Sequence[str]) -> dict[Square, str]:
    """All letters by their squares."""
    return {(row, column): letter for row, line in enumerate(rows) for column, letter in enumerate(line)}


def _around(square: Square) -> Iterator[Square]:
    """A square and those that touch it."""
    row, column = square
    return ((row + down, column + right) for down in (-1, 0, 1) for right in (-1, 0, 1))


# --- the world


def world_of(text: str, file: str, wording: Words) -> tuple[str, Mapping[str, int]]:
    """The world file that a drawing means, and what is in it: ``width`` and ``depth`` in steps, and so on.

    Raises ``Unusable`` with a sentence for each mistake in ``file``.
    """
    return _Drawing(text, file, wording).built()


_LEGEND_LINE = re.compile(rf"(\w|[{re.escape(ARROWS)}])\s+\w\w")
"""How a line says what a letter means: ``c chair green``. A row has no blanks."""
_CERTAIN_ROW = re.compile(rf"[{WALL}{FREE}]\S*")
"""One up to which the drawing goes; others may also be lines of the legend."""


@cache
def _meaning() -> re.Pattern[str]:
    """A line that says what a letter means, with or without "is", "=" or ":"."""
    verbs = (Words(each)("map-legend", letter="", name="").strip(" .") for each in languages())
    joint = rf"\s*[=:]|\s+(?:{'|'.join(map(re.escape, verbs))})(?=\s)|(?=\s)|$"
    return re.compile(rf"\s*(?P<letter>[\^>v<](?:\s+[\^>v<])*|[^\W_])(?:{joint})\s*(?P<meaning>.*?)\.?\s*")


def _is_sentence(text: str, code: str, **values: object) -> bool:
    return any(text == Words(each)(code, **values) for each in languages())


class _Drawing:
    """A drawing with its legend, and the world file that it means."""

    def __init__(self, text: str, file: str, wording: Words) -> None:
        self._file, self._words = file, wording
        self._slips = set[tuple[Square, str]]()
        """The place, and the sentence."""
        self._things = {WALL: things.Description(things.WALL)}
        """By their letters."""
        self._places: dict[str, Square] = {}
        """Where it is said what each letter means; letters without a thing are around robots, as in a map."""
        self._names: list[str] = []
        """Those of the robots."""
        self._has_none = False
        """Whether the legend says that there is no robot."""
        self._scale = 1
        """Steps that a letter is wide and high."""
        lines = [each.rstrip() for each in text.splitlines()]
        is_row = [bool(each) and not _LEGEND_LINE.match(each) for each in (*lines, "")]
        self._first = is_row.index(True) if any(is_row) else 0
        """The first row's line."""
        later = (at + 1 for at, line in enumerate(lines) if _CERTAIN_ROW.fullmatch(line))
        end = max([is_row.index(False, self._first), *later])
        for number, line in enumerate(lines):
            if line and not self._first <= number < end:
                self._read_legend(number, line)
        walls = [letter for letter, each in self._things.items() if each.kind == things.WALL]
        as_wall = dict.fromkeys(map(ord, walls), WALL)
        self._rows = [""] * self._first + [each.translate(as_wall) for each in lines[self._first : end]]
        """The text up to the last row, without the legend."""

    def _read_legend(self, number: int, line: str) -> None:
        text, digits, found = line.strip(), re.search(r"\d{1,2}", line), _meaning().fullmatch(line)
        first, steps = text.split()[0], int(digits[0]) if digits else 0
        letter, meaning = found.group("letter", "meaning") if found else ("", "")
        names = [things.name_in(each) for each in meaning.split(",") if each.strip()]
        if first in (WALL, FREE):
            return
        if _is_sentence(text, "map-no-robot"):
            self._has_none = True
        elif steps and _is_sentence(text, "map-scale", steps=steps):
            self._scale = steps
        elif found is None or letter in self._places:
            code = "drawing-letter-twice" if found else "drawing-legend"
            self._slip(code, (number, line.index(first)), letter=letter, found=quoted(first))
        elif letter[0] in ARROWS:
            self._names, self._places[ARROWS] = names, (number, 0)
        else:
            self._places[letter] = number, found.start("meaning")
            if not names or not {*names} <= {*self._names, "…"}:
                self._things[letter], mistakes = things.description_of(meaning, self._words)
                for at, message in mistakes.items():
                    self._add((number, found.start("meaning") + at), message)

    # --- mistakes

    def _add(self, place: Square, message: str) -> None:
        code, (line, column) = "drawing-error" if place == _NOWHERE else "world-error-at", place
        values = {"file": self._file, "line": line + 1, "column": column + 1, "message": message}
        self._slips.add((place, self._words(code, **values)))

    def _slip(self, code: str, place: Square = _NOWHERE, **values: object) -> None:
        self._add(place, self._words(code, **values))

    def _refuse_slips(self) -> None:
        """Raises ``Unusable`` if there are any."""
        if self._slips:
            shown = [sentence for _, sentence in sorted(self._slips)[:MOST_SLIPS]]
            if (more := len(self._slips) - len(shown)) > 0:
                shown.append(self._words("drawing-more", count=more))
            raise Unusable(*shown, self._words("world-new-mistakes", count=len(self._slips)))

    def _check_rows(self) -> None:
        """Raises ``Unusable`` where there is nothing to read, or too much."""
        rows, most = self._rows, self._first + MOST_SIDE
        beyond = [(at, MOST_SIDE) for at, line in enumerate(rows) if len(line) > MOST_SIDE]
        beyond += [(most, 0)] if len(rows) > most else []
        if beyond:
            self._slip("drawing-large", beyond[0], most=MOST_SIDE)
        if not rows:
            self._slip("drawing-empty")
        if beyond or not rows:
            self._refuse_slips()

    def _check_letters(self, groups: Sequence[Group]) -> None:
        """Lines of another length; each letter without a meaning once."""
        known, first = self._places, len(self._rows[self._first])
        for row, line in enumerate(self._rows):
            if row > self._first and len(line) != first:
                self._slip("drawing-ragged", (row, min(len(line), first)), count=len(line), first=first)
        unknown = {each.letter: each.squares[0] for each in reversed(groups) if each.letter not in known}
        for letter, square in unknown.items():
            near = letter.swapcase()
            code = "letter" if letter.isalnum() else "blank" if letter.isspace() else "sign"
            code = "letter-near" if letter.isalnum() and near in known else code
            self._slip(f"drawing-{code}", square, letter=letter, near=near)

    def _check_robots(self, robots: Sequence[Square]) -> None:
        names, count = {*map(fold_name, self._names)}, len(robots)
        second = (_NOWHERE, *robots[:2])[-1]  # or the only one
        place = self._places.get(ARROWS, second)
        if not (count or self._has_none):
            self._slip("drawing-no-robot")
        elif len(names) != count and (names or count > 1) and "…" not in names:
            self._slip("drawing-robot-names", place, names=len(names), count=count)

    def _check_colours(self, groups: Sequence[Group]) -> None:
        """Things of one letter with more or fewer colours than there are things."""
        for letter, described in self._things.items():
            found = [bool(each.colour) for each in groups if each.letter == letter]
            colours = sum(found) if described.marks else len(described.colours)
            if (colours > 1 or described.marks) and colours != len(found):
                self._slip("drawing-colours", self._places[letter], count=len(found), colours=colours)

    def _check_room(self, scene: Scene, drawn: Sequence[Group], robots: Sequence[Group]) -> None:
        """Things of one letter that are larger than the free floor around it, and robots inside something."""
        everything = [each for each in all_things(scene) if not each.is_robot]
        for group, mine in zip(drawn, everything, strict=True):
            over = (each for each in everything if each is not mine and _overlap(mine, each))
            other = next(over, None) if len(group.squares) == 1 else None
            if other is not None:
                thing, over_it = (things.word_for(each.kind, self._words) for each in (mine, other))
                sides = {"width": round(mine.width), "depth": round(mine.depth)}
                self._slip("drawing-thing-room", group.squares[0], thing=thing, other=over_it, **sides)
        place_of = {name: each.squares[0] for name, each in zip(scene.robot_names, robots, strict=True)}
        for note in scene.report.notes if self._scale == 1 else ():
            if note.code == "starts-inside":
                thing = things.word_for(str(note.details["thing"]), self._words)
                self._slip("drawing-robot-room", place_of[str(note.details["name"])], thing=thing)

    # --- the world file

    def built(self) -> tuple[str, Mapping[str, int]]:
        """As ``world_of``."""
        from sim.worldfile import rectangles  # loads the parser

        self._check_rows()
        rows = self._rows
        groups = [*groups_in(rows, {letter: each.marks for letter, each in self._things.items()})]
        bodies = {square for each in groups if each.letter not in self._things for square in each.squares}
        robots = [Group(letter, (square,)) for square, letter in _squares(rows).items() if letter in ARROWS]
        robots.sort(key=lambda each: (not bodies.isdisjoint(_around(each.squares[0])), each.squares))
        wide, deep = len(rows[self._first]), len(rows) - self._first
        self._origin = robots[0].squares[0] if robots else (self._first + deep // 2, wide // 2)
        widest = max(map(len, rows))
        of_walls = rectangles(bytes(each == WALL for each in row.ljust(widest)) for row in rows)
        walls = [Group(WALL, ((top, left), (bottom - 1, right - 1))) for left, top, right, bottom in of_walls]
        known = {letter for letter, each in self._things.items() if each.kind}
        drawn = [*walls, *(each for each in groups if each.letter in known)]
        self._check_letters(groups)
        self._check_robots([each.squares[0] for each in robots])
        self._check_colours(groups)
        if len(drawn) > MOST_PIECES:
            self._slip("drawing-much", count=len(drawn), most=MOST_PIECES)
            self._refuse_slips()
        names = [each for each in self._names if each != "…"] or ["donnie"]
        more = (each for each in (f"{names[0]}{number}" for number in count(2)) if each not in names)
        named = zip(robots, chain(names, more), strict=False)
        of_robots = [self._line(each, "donnie", name) for each, name in named]
        lines = [*self._lines(drawn)]
        text = things.world_text(lines[: len(walls)], lines[len(walls) :], of_robots)
        scene = scene_of(text, Path(worlds.SCENES, "drawing.world"), self._words, allowed_folders(()))
        self._check_room(scene, drawn, robots)
        self._refuse_slips()
        counts = {"width": wide * self._scale, "depth": deep * self._scale}
        return text, (counts | {"robots": len(robots), "things": len(drawn) - len(walls)})

    def _lines(self, drawn: Iterable[Group]) -> Iterator[str]:
        """Of walls, which have no names, and of things."""
        colours = {letter: cycle(each.colours or ("",)) for letter, each in self._things.items()}
        used = Counter[str]()
        for group in drawn:
            described, colour = self._things[group.letter], next(colours[group.letter])
            name = described.name or described.kind.replace("_", " ")
            used[name] += 1
            name = name if used[name] == 1 else f"{name} {used[name]}"
            name = "" if described.kind == things.WALL else name
            yield self._line(group, described.kind, name, group.colour or colour)

    def _line(self, group: Group, kind: str, name: str, colour: str = "") -> str:
        """A wall is as large as its letters, as is a thing of several, unless that is its usual size."""
        (ys, xs), (row, column), step = zip(*group.squares, strict=True), self._origin, self._scale * STEP
        east, north = (min(xs) + max(xs)) / 2 - column, row - (min(ys) + max(ys)) / 2
        angle, size = _HEADING.get(group.letter, 0), tuple[float, ...]()
        if len(group.squares) > 1:
            across, along, height = usual_sizes()[kind]
            width, depth = (max(xs) - min(xs) + 1) * step, (max(ys) - min(ys) + 1) * step
            slack = 0 if kind == things.WALL else step
            turns = {0: (width - across, depth - along), 90: (width - along, depth - across)}
            fits = [each for each, over in turns.items() if all(0 <= round(it, 3) <= slack for it in over)]
            angle, size = (fits[0], ()) if fits else (0, (width, depth, height))
        pose = round(east * step, 6) + 0.0, round(north * step, 6) + 0.0, angle
        return things.model_line(kind, pose, name, size, colour)


@cache
def usual_sizes() -> Mapping[str, tuple[float, float, float]]:
    """Metres, by kind: from west to east, from south to north, and up."""
    text = things.world_text([f"{kind}()" for kind in things.KINDS])
    scene = scene_of(text, Path(worlds.SCENES, "sizes.world"), Words(), allowed_folders(()))
    return {each.kind: each.size for each in scene.models}


def _overlap(mine: Thing, other: Thing) -> bool:
    """Whether their boxes have more in common than a border."""
    across, along = mine.width + other.width - _BORDER, mine.depth + other.depth - _BORDER
    return abs(mine.x - other.x) * 2 < across and abs(mine.y - other.y) * 2 < along
