"""A world as letters for paper: what each letter means, and the floor made of these letters, in braille.

Letters are small and have one meaning each, so that six-dot braille can distinguish them. Free floor is
``.``, a wall ``#``. The northern row is the first.

Text is North American ASCII braille, one sign a cell: uncontracted, without signs for capitals, with the
accents of Portuguese and Spanish braille. The braille pages have 40 cells by 25 lines: a map to scale, and a
legend next to or after it. The file is BRF (ASCII braille, a form feed after each page) for an embosser or a
braille display.
"""

from __future__ import annotations

import re
import textwrap
import unicodedata
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import dropwhile
from string import ascii_lowercase
from typing import TYPE_CHECKING

from msgspec import Struct

from devices.ports.robot import Pose
from donnie_tui.core.map_grid import FREE, WALL
from donnie_tui.core.wording import (
    Wording,
    colour_initials,
    facing,
    letters_of_several_colours,
    name_of,
    shade,
)
from language.locales import own_words

if TYPE_CHECKING:
    from sim.picture import Picture, Thing

MOST_ROBOTS = 6
"""Robots with a letter of their own; the others share one."""
MOST_NAMES = 3
"""Kinds of things that the legend names for a letter."""


class ChartedRobot(Struct, frozen=True):
    """A robot at its start."""

    name: str
    pose: Pose
    letter: str = ""


class ColourMark(Struct, frozen=True):
    """The initial of the colour of a thing that differs from others in colour only."""

    row: int
    column: int
    """The middle of the thing, in the cells of the picture."""
    thing: Thing
    initial: str


class Chart(Struct, frozen=True):
    """A world as rows of letters with a legend."""

    rows: tuple[str, ...]
    cell: int
    """Steps that a letter is wide and high."""
    robots: tuple[ChartedRobot, ...]
    legend: Mapping[str, str]
    """The meaning of every letter, and of ``#``."""
    marks: tuple[ColourMark, ...] = ()


def chart(picture: Picture, pose: Pose, robot: str | None, wording: Wording) -> Chart:
    """The world in which ``robot`` starts at ``pose``; None if there is no robot."""
    things = [each for each in picture.things if not each.is_robot]
    others = [ChartedRobot(each.name or each.kind, _pose(each)) for each in picture.things if each.is_robot]
    me = [] if robot is None else [ChartedRobot(robot, pose)]
    robots = _lettered([*me, *others], {each.letter.lower() for each in things})
    legend = {WALL: wording("paper-legend-wall")} if picture.has_walls else {}
    taken = [*(each.letter for each in picture.things), *(each.letter for each in robots)]
    marks = colour_marks(picture, colour_initials(wording, taken))
    legend |= _robots_legend(robots, wording) | _things_legend(things, marks, wording)
    return Chart(_rows(picture, robots, bool(me)), picture.cell, robots, legend, marks)


def shrunk(rows: Sequence[str], across: int, down: int, strong: str = "") -> tuple[str, ...]:
    """Shrinks the rows: each block becomes its first letter of ``strong``, things, walls, floor."""
    return tuple(
        "".join(
            _strongest([row[x : x + across] for row in rows[y : y + down]], strong)
            for x in range(0, len(rows[0]), across)
        )
        for y in range(0, len(rows), down)
    )


def _strongest(block: Iterable[str], strong: str) -> str:
    def rank(letter: str) -> tuple[bool, bool, bool]:
        return letter in strong, letter not in (FREE, WALL), letter == WALL

    return max("".join(block), key=rank)


def colour_marks(picture: Picture, initials: Mapping[str, str]) -> tuple[ColourMark, ...]:
    """The marks in reading order. ``initials``: the letter of each colour."""
    mixed = letters_of_several_colours(picture.things)
    found = list[ColourMark]()
    for each in picture.things:
        cell = picture.at(each.x, each.y) if each.letter in mixed and not each.is_robot else None
        if cell is not None and each.colour in initials:
            found.append(ColourMark(*cell, each, initials[each.colour]))
    return tuple(sorted(found, key=lambda each: (each.row, each.column)))


def with_marks(
    rows: Sequence[str], marks: Iterable[ColourMark], across: int = 1, down: int = 1
) -> tuple[tuple[str, ...], frozenset[str]]:
    """The rows with the initials in the midst of things, and the letters of these things.

    ``across``, ``down``: cells that a letter stands for. All things of a letter are marked, or none: one
    without room would have no colour.
    """

    def at(row: int, column: int) -> str:
        return rows[row][column] if 0 <= row < len(rows) and 0 <= column < len(rows[0]) else ""

    def room(mark: ColourMark) -> tuple[int, int] | None:
        """The place of the second letter, after or under the first."""
        row, column, letter = mark.row // down, mark.column // across, mark.thing.letter.lower()
        after = (((row, x), (row, x - 1)) for x in (column, column + 1))
        under = (((y, column), (y - 1, column)) for y in (row, row + 1))
        for place, first in (*after, *under):
            if at(*place).lower() == at(*first).lower() == letter:
                return place
        return None

    places = [(each, room(each)) for each in marks]
    letters = {each.thing.letter for each, _ in places}
    letters -= {each.thing.letter for each, place in places if place is None}
    drawn = [list(row) for row in rows]
    for mark, place in places:
        if place is not None and mark.thing.letter in letters:
            drawn[place[0]][place[1]] = mark.initial
    return tuple("".join(row) for row in drawn), frozenset(letters)


def _pose(thing: Thing) -> Pose:
    return Pose(thing.x, thing.y, thing.heading)


def _lettered(robots: Iterable[ChartedRobot], taken: set[str]) -> tuple[ChartedRobot, ...]:
    """Each robot with a free letter of its name; surplus robots share the last one."""
    lettered: list[ChartedRobot] = []
    taken = set(taken)
    shared = next((each for each in reversed(ascii_lowercase) if each not in taken), "z")
    for robot in robots:
        letter = shared
        if len(lettered) < MOST_ROBOTS:
            wanted = (*robot.name.lower(), *ascii_lowercase)
            free = (each for each in wanted if each in ascii_lowercase and each not in taken | {shared})
            letter = next(free, shared)
        taken.add(letter)
        lettered.append(ChartedRobot(robot.name, robot.pose, letter))
    return tuple(lettered)


def _robots_legend(robots: Sequence[ChartedRobot], wording: Wording) -> dict[str, str]:
    named, others = robots[:MOST_ROBOTS], robots[MOST_ROBOTS:]
    legend = {
        each.letter: wording("paper-legend-robot", name=each.name, facing=facing(each.pose, wording))
        for each in named
    }
    if others:
        legend[others[0].letter] = wording("paper-legend-robots", count=len(others))
    return legend


def _things_legend(things: Iterable[Thing], marks: Iterable[ColourMark], wording: Wording) -> dict[str, str]:
    """The names and the colours for each letter; the colours after their initials, if they have some."""
    initials = {each.thing.index: f"{each.initial.lower()} " for each in marks}
    names: dict[str, list[str]] = {}
    colours: dict[str, list[str]] = {}
    for thing in things:
        letter = thing.letter.lower()
        names.setdefault(letter, []).append(name_of(thing, wording))
        colours.setdefault(letter, []).append(initials.get(thing.index, "") + shade(thing, wording))
    return {
        letter: ", ".join(dict.fromkeys((*list(dict.fromkeys(names[letter]))[:MOST_NAMES], *colours[letter])))
        for letter in sorted(names)
    }


def _rows(picture: Picture, robots: Sequence[ChartedRobot], has_me: bool) -> tuple[str, ...]:
    rows = [list(row.lower()) for row in picture.rows]
    bodies = [each for each in picture.things if each.is_robot]
    for body, robot in zip(bodies, robots[has_me:], strict=True):
        for row, column in _cells(picture, body):
            if rows[row][column] == body.letter.lower():
                rows[row][column] = robot.letter
    for robot in robots:
        cell = picture.at(robot.pose.x, robot.pose.y)
        if cell is not None:
            rows[cell[0]][cell[1]] = robot.letter
    return tuple("".join(row) for row in rows)


def _cells(picture: Picture, thing: Thing) -> Iterable[tuple[int, int]]:
    """The squares of the box around a thing."""
    first = picture.at(thing.x - thing.width / 2, thing.y + thing.depth / 2)
    last = picture.at(thing.x + thing.width / 2, thing.y - thing.depth / 2)
    if first is None or last is None:
        return ()
    return [(y, x) for y in range(first[0], last[0] + 1) for x in range(first[1], last[1] + 1)]


# --- braille pages

ASCII = " A1B'K2L@CIF/MSP\"E3H9O6R^DJG>NTQ,*5<-U8V.%[$+X!&;:4\\0Z7(_?W]#Y)="
"""The 64 cells in the order of their dots: dot 1 counts 1, dot 2 counts 2, dot 3 counts 4 and so on."""
FULL_CELL = "="
NUMBER = "#"

_SIGNS = {",": "1", ";": "2", ":": "3", ".": "'", "-": "-", "'": "'", "_": "-", "/": "-"}


def braille(text: str, language: str) -> str:
    """The text in a language; what has no sign there becomes a blank."""
    cells: list[str] = []
    in_number = False
    for letter in unicodedata.normalize("NFC", text).lower():
        is_digit = "0" <= letter <= "9"
        if is_digit and not in_number:
            cells.append(NUMBER)
        cells.append(_cell(letter, language))
        in_number = is_digit
    return "".join(cells)


def _cell(letter: str, language: str) -> str:
    if "0" <= letter <= "9":
        return "JABCDEFGHI"[int(letter)]
    special = own_words(language, "words", "braille", letter)
    if special or letter in _SIGNS:
        return special[0] if special else _SIGNS[letter]
    plain = unicodedata.normalize("NFD", letter)[0]
    return plain.upper() if "a" <= plain <= "z" else " "


def dots(cell: str) -> tuple[int, ...]:
    """The raised dots of a cell: 1, 2, 3 down the left column, 4, 5, 6 down the right one."""
    pattern = f"{ASCII.index(cell):b}"
    return tuple(dot for dot, bit in enumerate(reversed(pattern), 1) if bit == "1")


_INITIAL = re.compile(r"((?:, |1 )\w) (?=\w)")
"""A letter alone after a comma, which in braille is a 1."""
CELLS, LINES = 40, 25
_HEADING = 2
"""Lines above the map: its name, its scale."""
_SLENDER = 5 / 3
"""A braille cell with its gaps is 6 mm wide and 10 mm high."""


def braille_pages(title: str, chart: Chart, wording: Wording) -> str:
    """The pages of a world, with the line ends and form feeds of embossers."""
    legend = _page_legend(chart, wording)
    page = LINES - _HEADING
    across = _scale(chart, page)
    beside = _scale(chart, page - len(legend)) if len(legend) < page else 0
    down = _down(across)
    rows = _map(chart, across, down)
    heading = _heading(title, across * chart.cell, down * chart.cell, wording)
    lines = [*heading, *rows]
    if beside != across:  # the legend would make the map smaller: it has pages of its own
        lines += [""] * (LINES - len(lines))
    return _paged([*lines, *legend])


def _scale(chart: Chart, most_lines: int) -> int:
    """How many letters of the chart a cell stands for, so that all of the chart fits."""
    across = 1
    while len(chart.rows[0]) > CELLS * across or len(chart.rows) > most_lines * _down(across):
        across += 1
    return across


def _down(across: int) -> int:
    return round(across * _SLENDER)


def _map(chart: Chart, across: int, down: int) -> list[str]:
    robots = "".join({each.letter for each in chart.robots})
    rows, _ = with_marks(shrunk(chart.rows, across, down, robots), chart.marks, across, down)
    return [row.upper().replace(FREE, " ").replace(WALL, FULL_CELL).rstrip() for row in rows]


def _heading(title: str, width: int, height: int, wording: Wording) -> list[str]:
    scale = wording("paper-cell", width=width, height=height)
    return [braille(each, wording.language)[:CELLS] for each in (title, scale)]


def _page_legend(chart: Chart, wording: Wording) -> list[str]:
    lines = [braille(wording("paper-north"), wording.language)]
    for letter, meaning in chart.legend.items():
        sign = FULL_CELL if letter == WALL else letter.upper()
        lines.append(f"{sign}  {braille(meaning, wording.language)}")
    return [part for line in lines for part in wrapped(line, CELLS)]


def wrapped(line: str, width: int) -> list[str]:
    """A line of a legend in several; the initial of a colour stays with its colour."""
    kept = _INITIAL.sub("\\1\N{NO-BREAK SPACE}", line)
    parts = textwrap.wrap(kept, width, subsequent_indent="   ")
    return [part.replace("\N{NO-BREAK SPACE}", " ") for part in parts]


def _paged(lines: list[str]) -> str:
    return "".join(_page(lines[start : start + LINES]) for start in range(0, len(lines), LINES))


def _page(lines: list[str]) -> str:
    return "".join(f"{line}\r\n" for line in _without_end(lines)) + "\f"


def _without_end(lines: list[str]) -> Iterator[str]:
    """The lines without the blank ones at the foot of the page."""
    return reversed([*dropwhile(lambda line: not line, reversed(lines))])
