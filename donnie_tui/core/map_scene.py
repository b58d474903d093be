"""Everything that a map shows: the floor with one robot's trail, the other robots, what was moved, rays.

Values only, for every front end, as ``map_grid``. A ray is what a sensor looked along last; it goes when the
robot moves. What was pushed or held is shown where it is now; its old place is free floor.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import pairwise, takewhile
from math import cos, radians, sin
from typing import TYPE_CHECKING

from devices.ports.robot import Bearing, Pose
from devices.ports.values import replace
from donnie_tui.core.events import PlacedThing, Read, Scanned
from donnie_tui.core.map_grid import FREE, Bounds, Cell, Kind, MapGrid, arrow_of, cells_between

if TYPE_CHECKING:
    from sim.picture import Picture, Thing

RAY = "'"
LONGEST_RAY = 100
"""Cells."""

Line = tuple[tuple[float, float], ...]
"""Points to the right of the robot and ahead of it, in steps."""

_DEGREES_OF = {each.name.lower().replace("_", " "): each.value for each in Bearing}
"""As ``read`` events name the directions."""


class MapScene:
    """What is where, letter by letter."""

    def __init__(self, picture: Picture, pose: Pose, name: str = "") -> None:
        """``name``: the robot's; without one it is Donnie."""
        self.grid = MapGrid(picture, pose, name)
        self._pose = pose
        self._rays: frozenset[Cell] = frozenset()
        self._robots: dict[str, tuple[Cell, str]] = {}
        self._moved: dict[int, Thing] = {}
        self._places: tuple[PlacedThing, ...] = ()
        self._drawn: dict[Cell, Thing] = {}
        self._lifted: frozenset[Cell] = frozenset()
        self._things = _by_cell(self.grid, picture.things)

    # --- what happens

    def begin(self, pose: Pose) -> frozenset[Cell]:
        """The robot starts here: no trail, nothing looked at. Whether things are back is told by events.

        The cells that may look different.
        """
        gone = self._rays | frozenset(self.others.values())
        self._pose = pose
        self._rays = frozenset()
        self._robots.clear()
        return gone | self.place_things(self._places) | self.grid.begin(pose)

    def move(self, pose: Pose) -> frozenset[Cell]:
        """The robot is there now. The cells that look different."""
        rays, self._rays = self._rays, frozenset()
        self._pose = pose
        return self.grid.move(pose) | rays

    def move_other(self, name: str, pose: Pose) -> frozenset[Cell]:
        """Another robot is there now."""
        before = self._robots.get(name)
        now = (self.grid.cell_of(pose), arrow_of(pose.heading))
        if now == before:
            return frozenset()
        changed = set(self._lift_robot(name)) if before is None else {before[0]}
        self._robots[name] = now
        return frozenset(changed | {now[0]})

    def place_things(self, places: Iterable[PlacedThing]) -> frozenset[Cell]:
        """All things that are elsewhere than at the start."""
        before = self._lifted | frozenset(self._drawn)
        self._places = tuple(places)
        own = {each.index: each for each in self.grid.picture.things}
        self._moved = {
            each.index: replace(own[each.index], x=each.pose.x, y=each.pose.y)
            for each in self._places
            if each.index in own
        }
        self._lifted = frozenset(
            cell for cell, thing in self._things.items() if thing.index in self._moved or self._is_seen(thing)
        )
        self._drawn = {cell: thing for thing in self._moved.values() for cell in self._cells_of(thing)}
        return before | self._lifted | frozenset(self._drawn)

    def _is_seen(self, thing: Thing) -> bool:
        """Whether it is a robot that is shown where it is."""
        return thing.is_robot and thing.name in self._robots

    def _lift_robot(self, name: str) -> frozenset[Cell]:
        cells = frozenset(
            cell for cell, thing in self._things.items() if thing.is_robot and thing.name == name
        )
        self._lifted |= cells
        return cells

    def look_along(self, event: Read | Scanned) -> frozenset[Cell]:
        """Show what a sensor looked along: to what it found, or as far as it saw."""
        rays = set(self._rays)
        for degrees, steps in _looks(event):
            angle = radians(self._pose.heading + degrees)
            end = Pose(self._pose.x + steps * sin(angle), self._pose.y + steps * cos(angle), 0.0)
            there = self.grid.cell_of(end)
            rays.update(cells_between(self.grid.robot, there, LONGEST_RAY))
        changed = frozenset(rays) - self._rays
        self._rays = frozenset(rays)
        return changed

    def show_fields(self, lines: Iterable[Line]) -> frozenset[Cell]:
        """Lines in the robot's frame, such as the borders of a camera's view; each ends at the first wall."""
        rays = set(self._rays)
        for line in lines:
            places = [self._place_of(*point) for point in line]
            for start, end in pairwise(places):
                way = (*cells_between(start, end, LONGEST_RAY), end)
                rays.update(takewhile(lambda cell: self.grid.kind(cell) is not Kind.WALL, way))
        changed = frozenset(rays) - self._rays
        self._rays = frozenset(rays)
        return changed

    def _place_of(self, right: float, ahead: float) -> Cell:
        """Of steps to the right and ahead of the robot."""
        angle = radians(self._pose.heading)
        east = right * cos(angle) + ahead * sin(angle)
        north = ahead * cos(angle) - right * sin(angle)
        return self.grid.cell_of(Pose(self._pose.x + east, self._pose.y + north, 0.0))

    # --- what is there

    @property
    def picture(self) -> Picture:
        return self.grid.picture

    @property
    def bounds(self) -> Bounds:
        return self.grid.bounds

    @property
    def robot(self) -> Cell:
        return self.grid.robot

    @property
    def pose(self) -> Pose:
        return self._pose

    @property
    def others(self) -> Mapping[str, Cell]:
        """The cells of the other robots, by name."""
        return {name: cell for name, (cell, _) in self._robots.items()}

    @property
    def things(self) -> tuple[Thing, ...]:
        """All things, where they are now; robots that move apart."""
        return tuple(
            self._moved.get(each.index, each) for each in self.picture.things if not self._is_seen(each)
        )

    def place(self, cell: Cell) -> tuple[int, int]:
        return self.grid.place(cell)

    def cell_at(self, x: float, y: float) -> Cell:
        """The cell of a place in steps."""
        return self.grid.cell_of(Pose(x, y, 0.0))

    def robot_at(self, cell: Cell) -> str | None:
        """The name of the other robot that is there."""
        return next((name for name, (place, _) in self._robots.items() if place == cell), None)

    def letter(self, cell: Cell) -> str:
        """What the cell shows, one letter."""
        if cell == self.grid.robot:
            return self.grid.letter(cell)
        other = next((arrow for place, arrow in self._robots.values() if place == cell), None)
        if other is not None:
            return other
        if cell in self._drawn:
            return self._drawn[cell].letter
        kind = self.grid.kind(cell)
        if kind is Kind.FREE or (kind is Kind.THING and cell in self._lifted):
            return RAY if cell in self._rays else FREE
        return self.grid.letter(cell)

    def kind(self, cell: Cell) -> Kind:
        """What the cell shows, for words and colours."""
        if cell == self.grid.robot:
            return Kind.ROBOT
        if self._robots and self.robot_at(cell) is not None:
            return Kind.OTHER
        if cell in self._drawn:
            return Kind.THING
        kind = self.grid.kind(cell)
        if kind is Kind.FREE or (kind is Kind.THING and cell in self._lifted):
            return Kind.RAY if cell in self._rays else Kind.FREE
        return kind

    def thing(self, cell: Cell) -> Thing | None:
        """What stands there now."""
        if cell in self._drawn:
            return self._drawn[cell]
        return None if cell in self._lifted else self._things.get(cell)

    def colour(self, cell: Cell) -> str:
        """The colour word of what is shown there, empty where nothing has one."""
        thing = self.thing(cell) if self.kind(cell) is Kind.THING else None
        return thing.colour if thing else ""

    def _cells_of(self, thing: Thing) -> Iterable[Cell]:
        return _cells_in_box(self.grid, thing)


def _by_cell(grid: MapGrid, things: Iterable[Thing]) -> dict[Cell, Thing]:
    """Which thing each letter of the floor belongs to: of several the one whose middle is nearest."""
    found: dict[Cell, tuple[float, Thing]] = {}
    for thing in things:
        for cell in _cells_in_box(grid, thing, 1):
            if grid.floor_letter(cell) == thing.letter:
                x, y = grid.place(cell)
                distance = abs(x - thing.x) + abs(y - thing.y)
                if cell not in found or distance < found[cell][0]:
                    found[cell] = (distance, thing)
    return {cell: thing for cell, (_, thing) in found.items()}


def _cells_in_box(grid: MapGrid, thing: Thing, margin: int = 0) -> Iterable[Cell]:
    """The cells that a thing fills well, one at least; with ``margin`` those beside it too."""
    picture = grid.picture
    across, up = max(1, round(thing.width / picture.cell)), max(1, round(thing.depth / picture.cell))
    half = picture.cell / 2
    low = grid.cell_of(Pose(thing.x - across * half + half, thing.y - up * half + half, 0.0))
    left, right = low.x - margin, low.x + across - 1 + margin
    bottom, top = low.y - margin, low.y + up - 1 + margin
    for x in range(max(left, -1), min(right, picture.width) + 1):
        for y in range(max(bottom, -1), min(top, picture.height) + 1):
            yield Cell(x, y)


def _looks(event: Read | Scanned) -> Iterable[tuple[float, int]]:
    """The angles that were looked along, clockwise from ahead, and how far in steps."""
    if isinstance(event, Scanned):
        for group in event.objects:
            sign = -1 if group.side == "left" else 1
            yield sign * group.degrees, group.steps
    elif event.sensor == "distance" and event.argument in _DEGREES_OF:
        yield _DEGREES_OF[event.argument], max(0, event.value)
