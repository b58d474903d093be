"""The map of a world: the floor with one robot's trail, other robots, moved things, rays and labels.

Values only, for every front end, as ``map_grid``. A ray shows what a sensor looked along last; it disappears
when the robot moves. A thing that was pushed or held is shown where it is now, and its old place is free
floor.

``MapScale`` shows several cells as one square, with the most important letter in it. ``labels`` places names
next to things, on free floor only, so that they hide nothing.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import pairwise, takewhile
from math import cos, radians, sin
from typing import TYPE_CHECKING

from msgspec.structs import replace

from devices.ports.robot import Bearing, Pose
from donnie_tui.core.events import PlacedThing, Read, Scanned
from donnie_tui.core.map_grid import FREE, Bounds, Cell, Kind, MapGrid, arrow_of, cells_between
from donnie_tui.core.wording import (
    Wording,
    colour_initials,
    coloured_thing,
    letters_of_several_colours,
    name_of,
    shade,
)

if TYPE_CHECKING:
    from donnie_tui.core.timeline import Timeline
    from sim.picture import Picture, Thing


RAY = "'"
LONGEST_RAY = 100
"""Cells."""

Line = tuple[tuple[float, float], ...]
"""Points to the right of the robot and ahead of it, in steps."""

_DEGREES_OF = {each.words: each.value for each in Bearing}
"""As ``read`` events name the directions."""


class MapScene:
    """The content of every cell, as letters."""

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
        self._resting = {self.grid.cell_at(each.x, each.y): each for each in picture.things if each.is_robot}
        """The other robots where they stand at the start."""

    # --- what happens

    def begin(self, pose: Pose) -> frozenset[Cell]:
        """Starts at that pose, without a trail and rays. Events report whether things are back.

        Returns the cells that may look different.
        """
        gone = self._rays | frozenset(self.others.values())
        self._pose = pose
        self._rays = frozenset()
        self._robots.clear()
        return gone | self.place_things(self._places) | self.grid.begin(pose)

    def move(self, pose: Pose) -> frozenset[Cell]:
        """Moves the robot there. Returns the cells that look different, none if it is there already."""
        if pose == self._pose:
            return frozenset()
        rays, self._rays = self._rays, frozenset()
        self._pose = pose
        return self.grid.move(pose) | rays

    def move_other(self, name: str, pose: Pose) -> frozenset[Cell]:
        """Moves another robot there."""
        before = self._robots.get(name)
        now = (self.grid.cell_of(pose), arrow_of(pose.heading))
        if now == before:
            return frozenset()
        changed = set(self._lift_robot(name)) if before is None else {before[0]}
        self._robots[name] = now
        return frozenset(changed | {now[0]})

    def place_things(self, places: Iterable[PlacedThing]) -> frozenset[Cell]:
        """Places the things that are not at their start."""
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
        """Shows what a sensor looked along: to what it found, or to the end of its range."""
        rays = set(self._rays)
        for degrees, steps in _looks(event):
            angle = radians(self._pose.heading + degrees)
            there = self.cell_at(self._pose.x + steps * sin(angle), self._pose.y + steps * cos(angle))
            rays.update(cells_between(self.grid.robot, there, LONGEST_RAY))
        changed = frozenset(rays) - self._rays
        self._rays = frozenset(rays)
        return changed

    def show_fields(self, lines: Iterable[Line]) -> frozenset[Cell]:
        """Shows lines in the robot's frame, such as a camera's field of view, up to the first wall."""
        rays = set(self._rays)
        for line in lines:
            places = [self._place_of(*point) for point in line]
            for start, end in pairwise(places):
                way = (*cells_between(start, end, LONGEST_RAY), end)
                rays.update(takewhile(lambda cell: self.grid.kind(cell) is not Kind.WALL, way))
        changed = frozenset(rays) - self._rays
        self._rays = frozenset(rays)
        return changed

    def hide(self, kinds: Iterable[Kind]) -> frozenset[Cell]:
        """Shows none of these marks: trail, rays or goals. Returns the cells that may look different."""
        self.grid.hidden = frozenset(kinds)
        return self.grid.marked | self._rays

    def _place_of(self, right: float, ahead: float) -> Cell:
        """The cell at that many steps to the right and ahead of the robot."""
        angle = radians(self._pose.heading)
        east = right * cos(angle) + ahead * sin(angle)
        north = ahead * cos(angle) - right * sin(angle)
        return self.cell_at(self._pose.x + east, self._pose.y + north)

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

    @property
    def standing(self) -> frozenset[Cell]:
        """The cells of all things and robots, where they are now, and of goals."""
        things = frozenset(self._things) - self._lifted
        return things.union(self._drawn, self.others.values(), self.grid.goals, (self.robot,))

    @property
    def letters_of_several_colours(self) -> frozenset[str]:
        """See ``wording.letters_of_several_colours``."""
        return letters_of_several_colours(self.picture.things)

    def has_room_for_colour(self, cell: Cell) -> bool:
        """Whether it is the middle of a thing of several squares: its colour has room there."""
        thing = self.thing(cell)
        return thing is not None and cell == self.cell_at(thing.x, thing.y) and self.grid.is_wide(thing)

    def place(self, cell: Cell) -> tuple[int, int]:
        return self.grid.place(cell)

    def cell_at(self, x: float, y: float) -> Cell:
        """The cell of a place in steps."""
        return self.grid.cell_at(x, y)

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
            return RAY if self._has_ray(cell) else FREE
        resting = self._resting_at(cell)
        return self.grid.letter(cell) if resting is None else arrow_of(resting.heading)

    def _has_ray(self, cell: Cell) -> bool:
        return cell in self._rays and Kind.RAY not in self.grid.hidden

    def _resting_at(self, cell: Cell) -> Thing | None:
        """The robot that has stood there from the start."""
        resting = self._resting.get(cell)
        return resting if self.thing(cell) is resting else None

    def name_of_robot(self, cell: Cell) -> str:
        """The robot whose arrow is there; empty for the only one."""
        resting = self._resting_at(cell)
        if cell == self.grid.robot:
            return self.grid.name if self._resting or self._robots else ""
        return self.robot_at(cell) or (resting.name if resting is not None else "")

    def colour_of_robot(self, cell: Cell) -> str:
        """The colour word of the other robot there, empty if none is known."""
        name = self.name_of_robot(cell)
        robots = (each for each in self.grid.picture.things if each.is_robot and each.name == name)
        return next((each.colour for each in robots), "")

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
            return Kind.RAY if self._has_ray(cell) else Kind.FREE
        return kind

    def thing(self, cell: Cell) -> Thing | None:
        """What stands there now."""
        if cell in self._drawn:
            return self._drawn[cell]
        return None if cell in self._lifted else self._things.get(cell)

    def colour(self, cell: Cell) -> str:
        """The colour word of what is shown there, empty if nothing has one."""
        thing = self.thing(cell) if self.kind(cell) is Kind.THING else None
        return thing.colour if thing else ""

    def _cells_of(self, thing: Thing) -> Iterable[Cell]:
        return _cells_in_box(self.grid, thing)


def _by_cell(grid: MapGrid, things: Iterable[Thing]) -> dict[Cell, Thing]:
    """The thing of each cell; of several the one whose middle is nearest."""
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
    """The cells that a thing fills well, at least one; with ``margin`` also those around it."""
    picture = grid.picture
    across, up = max(1, round(thing.width / picture.cell)), max(1, round(thing.depth / picture.cell))
    half = picture.cell / 2
    low = grid.cell_at(thing.x - across * half + half, thing.y - up * half + half)
    left, right = low.x - margin, low.x + across - 1 + margin
    bottom, top = low.y - margin, low.y + up - 1 + margin
    for x in range(max(left, -1), min(right, picture.width) + 1):
        for y in range(max(bottom, -1), min(top, picture.height) + 1):
            yield Cell(x, y)


def _looks(event: Read | Scanned) -> Iterable[tuple[float, int]]:
    """The angles that were measured, clockwise from ahead, and the distances in steps."""
    if isinstance(event, Scanned):
        for group in event.objects:
            sign = -1 if group.side == "left" else 1
            yield sign * group.degrees, group.steps
    elif event.sensor == "distance" and event.argument in _DEGREES_OF:
        yield _DEGREES_OF[event.argument], max(0, event.value)


_WEIGHT = {
    kind: weight
    for weight, kind in enumerate(
        (
            Kind.FREE,
            Kind.RAY,
            Kind.TRAIL,
            Kind.START,
            Kind.GOAL,
            Kind.WALL,
            Kind.THING,
            Kind.OTHER,
            Kind.ROBOT,
        )
    )
}
"""Of several things in one square, the one with the highest rank is shown."""

LARGEST = 64
"""Cells along the side of a square."""


class MapScale:
    """A scene in squares of ``factor`` by ``factor`` cells. With a factor of 1 it is the scene itself."""

    def __init__(self, scene: MapScene, factor: int = 1) -> None:
        self.scene = scene
        self.factor = factor

    @property
    def bounds(self) -> Bounds:
        bounds, factor = self.scene.bounds, self.factor
        return Bounds(
            bounds.left // factor, bounds.bottom // factor, bounds.right // factor, bounds.top // factor
        )

    @property
    def robot(self) -> Cell:
        return self.square_of(self.scene.robot)

    def square_of(self, cell: Cell) -> Cell:
        """The square in which a cell is."""
        return Cell(cell.x // self.factor, cell.y // self.factor)

    def squares_of(self, cells: Iterable[Cell]) -> frozenset[Cell]:
        return frozenset(map(self.square_of, cells))

    def cell_of(self, square: Cell) -> Cell:
        """The cell of the scene that the square shows."""
        return self._heaviest(square) if self.factor > 1 else square

    def _heaviest(self, square: Cell) -> Cell:
        kind, factor = self.scene.kind, self.factor
        x, y = square.x * factor, square.y * factor
        cells = (Cell(x + east, y + north) for north in range(factor) for east in range(factor))
        return max(cells, key=lambda cell: _WEIGHT[kind(cell)])

    def shown(self, square: Cell) -> tuple[str, str]:
        """The letter of a square, and what it is painted as.

        That is a kind; of things ``thing-`` and the colour, of other robots ``other-`` and theirs.
        """
        cell = self.cell_of(square)
        kind = self.scene.kind(cell)
        look = kind.value
        if kind is Kind.OTHER or (kind is Kind.THING and self.scene.name_of_robot(cell)):
            look = f"other-{self.scene.colour_of_robot(cell)}"
        elif kind is Kind.THING:
            look = f"thing-{self.scene.colour(cell)}"
        return self.scene.letter(cell), look


def factor_for(bounds: Bounds, columns: int, rows: int) -> int:
    """The smallest factor with which the whole floor is seen in that many columns and rows."""
    factor = 1
    while factor < LARGEST and (bounds.width > columns * factor or bounds.height > rows * factor):
        factor += 1
    return factor


def floor_rows(scene: MapScene, columns: int, rows: int) -> tuple[str, ...]:
    """The whole floor in letters, two columns a square, in that many columns and rows."""
    scale = MapScale(scene, factor_for(scene.bounds, columns // 2, rows))
    return scale.bounds.rows(lambda cell: _in_two_columns(*scale.shown(cell)))


def _in_two_columns(letter: str, look: str) -> str:
    return letter * 2 if look == Kind.WALL.value or look.startswith("thing-") else f"{letter} "


MOST = 300
"""Names; a floor with more things has no room for them."""


def labels(scale: MapScale, columns: int, wording: Wording) -> dict[Cell, str]:
    """The label texts by square, ``columns`` characters each. A name without room is left out."""
    written: dict[Cell, str] = {}
    scene = scale.scene
    named = [(names, scene.cell_at(each.x, each.y)) for each, names in _named(scene.things[:MOST], wording)]
    named += [((name,), cell) for name, cell in scene.others.items()]
    for names, cell in named:
        square = scale.square_of(cell)
        any(_write(f" {name} ", scale, square, columns, written) for name in names)
    return written


def _named(things: Sequence[Thing], wording: Wording) -> Iterator[tuple[Thing, tuple[str, ...]]]:
    """The possible names of each thing, the best first; with the colour where a letter has several."""
    colours: dict[str, set[str]] = {}
    for each in things:
        colours.setdefault(each.letter, set()).add(each.colour)
    for each in things:
        if len(colours[each.letter]) > 1:
            yield each, (coloured_thing(each, wording), shade(each, wording))
        else:
            yield each, (name_of(each, wording),)


def _write(name: str, scale: MapScale, square: Cell, columns: int, written: dict[Cell, str]) -> bool:
    """Writes a name to the east of a thing, else to the west. Returns whether there was room."""
    pieces = [name[at : at + columns].ljust(columns) for at in range(0, len(name), columns)]
    for first in (_beyond(scale, square, 1), _beyond(scale, square, -1) - len(pieces) + 1):
        squares = [Cell(first + index, square.y) for index in range(len(pieces))]
        if all(_is_free(scale, each) and each not in written for each in squares):
            written.update(zip(squares, pieces, strict=True))
            return True
    return False


def _beyond(scale: MapScale, square: Cell, step: int) -> int:
    """The first column next to the thing."""
    x = square.x + step
    while _kind(scale, Cell(x, square.y)) in (Kind.THING, Kind.OTHER):
        x += step
    return x


def _kind(scale: MapScale, square: Cell) -> Kind:
    return scale.scene.kind(scale.cell_of(square))


def _is_free(scale: MapScale, square: Cell) -> bool:
    return scale.bounds.left <= square.x <= scale.bounds.right and _kind(scale, square) in (
        Kind.FREE,
        Kind.TRAIL,
        Kind.RAY,
    )


# --- the map at a moment of the past

WIDEST, HIGHEST = 78, 22
"""Squares of a map: what a terminal of 80 by 24 shows at once."""


def map_at(timeline: Timeline, picture: Picture, robot: str | None) -> MapScene | None:
    """The map at this position, with that robot's trail. None if the robot's place is not known yet."""
    trail = timeline.trail(robot)
    if not trail:
        return None
    scene = MapScene(picture, trail[0])
    scene.place_things(timeline.things)
    for pose in trail[1:]:
        scene.move(pose)
    for other in timeline.robots:
        pose_of_other = timeline.pose(other)
        if other is not None and other != robot and pose_of_other is not None:
            scene.move_other(other, pose_of_other)
    return scene


def rows_of(scene: MapScene, wording: Wording) -> tuple[str, ...]:
    """The map's rows, the northern one first; of a large map the part around the robot.

    In the middle of a thing that differs from others in colour only is the initial of its colour.
    """
    part = scene.bounds.part(scene.robot, WIDEST, HIGHEST)
    mixed, initials = scene.letters_of_several_colours, colour_initials(wording)

    def shown(cell: Cell) -> str:
        letter = scene.letter(cell)
        return (
            initials.get(scene.colour(cell), letter)
            if letter in mixed and scene.has_room_for_colour(cell)
            else letter
        )

    return part.rows(shown)
