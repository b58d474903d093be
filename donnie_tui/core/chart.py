"""A world as letters for paper: what each letter means, and the floor made of these letters.

Letters are small and have one meaning each, so that six-dot braille can distinguish them. Free floor is
``.``, a wall ``#``. The northern row is the first.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
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
    """The world in which ``robot`` starts at ``pose``; None where there is no robot."""
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
    def rank(letter: str) -> int:
        return 3 if letter in strong else {FREE: 0, WALL: 1}.get(letter, 2)

    return max("".join(block), key=rank)


def colour_marks(picture: Picture, initials: Mapping[str, str]) -> tuple[ColourMark, ...]:
    """In reading order. ``initials``: of the colours."""
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
        """Where it is a second letter, after or under the first."""
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
    """Each robot with a letter of its name if that is free; those that are too many share the last one."""
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
