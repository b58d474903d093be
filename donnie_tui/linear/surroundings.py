"""The words about the world: WORLD, MAP and MAP PICTURE. The picture is printed only when it is asked for."""

from __future__ import annotations

from donnie_tui.core import numbers
from donnie_tui.core.describe import name_of, things_in_words
from donnie_tui.core.map_grid import FREE, START, WALL, Bounds, Cell, MapGrid
from donnie_tui.linear.desk import Desk

WIDEST, HIGHEST = 40, 18
"""Squares of the picture: what a braille display shows of a line, and what a screen reader takes at once."""


def say_where(desk: Desk) -> None:
    """Where the robot is."""
    pose = desk.session.pose
    facing = desk.session.teller.facing(pose)
    desk.answer("position", facing=facing, x=numbers.whole(pose.x), y=numbers.whole(pose.y))


def say_world(desk: Desk) -> None:
    """What its author says of the world, what stands in it, and what to try there."""
    about = desk.donnie.world.about(desk.say.language)
    if about is not None:
        desk.answer("world-title", name=desk.donnie.world.name, title=about.title)
        desk.tell(*about.description.replace(". ", ".\n").splitlines())
    say_map(desk)
    if about is not None:
        desk.answer("world-task", task=about.task)


def say_map(desk: Desk) -> None:
    """How many things there are and where each is, seen from the robot, the nearest first."""
    things = things_in_words(desk.donnie.picture(), desk.session.pose, desk.say)
    desk.answer("world-things" if things else "world-bare", count=len(things))
    desk.tell(*things)


def draw_map(desk: Desk) -> None:
    """What the letters mean, then the squares around the robot, the northern row first."""
    grid = MapGrid(desk.donnie.picture(), desk.session.pose)
    window = _window(grid)
    rows = [
        "".join(grid.letter(Cell(x, y)) for x in range(window.left, window.right + 1))
        for y in range(window.top, window.bottom - 1, -1)
    ]
    shown = set("".join(rows))
    desk.answer("linear-picture", robot=grid.letter(grid.robot), width=window.width, height=window.height)
    for letter, code in ((WALL, "linear-picture-wall"), (FREE, "linear-picture-free")):
        if letter in shown:
            desk.answer(code, letter=letter)
    meant = {thing.letter: name_of(thing, desk.say) for thing in grid.picture.things}
    for letter in sorted(shown & meant.keys()):
        desk.answer("linear-picture-thing", letter=letter, name=meant[letter])
    desk.tell(*(row.replace(START, FREE) for row in rows))


def _window(grid: MapGrid) -> Bounds:
    """At most so many squares, with the robot in them."""
    bounds = grid.bounds
    left, right = _part(bounds.left, bounds.right, grid.robot.x, WIDEST)
    bottom, top = _part(bounds.bottom, bounds.top, grid.robot.y, HIGHEST)
    return Bounds(left, bottom, right, top)


def _part(first: int, last: int, middle: int, most: int) -> tuple[int, int]:
    begin = max(first, min(middle - most // 2, last - most + 1))
    return begin, min(last, begin + most - 1)
