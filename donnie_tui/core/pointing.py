"""A pointer on the map: its square, what is there in words, and the way to the next thing.

Uses the words of MAP and AROUND. Places are given as the robot sees them. From one square to another, they
are given as if the robot stood on the first.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot
from typing import TYPE_CHECKING

from msgspec.structs import replace

from donnie_tui.core.describe import place_of
from donnie_tui.core.map_grid import Cell, Kind
from donnie_tui.core.map_scene import MapScene
from donnie_tui.core.wording import Wording, colour_initials, coloured, coloured_thing, name_of, shade

if TYPE_CHECKING:
    from sim.picture import Thing


@dataclass(slots=True)
class Pointer:
    """The pointer's place. ``cell`` None: on the robot, wherever the robot moves."""

    scene: MapScene
    cell: Cell | None = None
    marked: Cell | None = None
    """The marked square, from which the way is described."""

    @property
    def here(self) -> Cell:
        return self.cell or self.scene.robot

    def move(self, east: int, north: int) -> None:
        """Moves by cells, within the floor."""
        bounds, cell = self.scene.bounds, self.here
        x = min(max(cell.x + east, bounds.left), bounds.right)
        y = min(max(cell.y + north, bounds.bottom), bounds.top)
        self.cell = Cell(x, y)

    def go(self, cell: Cell) -> None:
        """Moves to that cell, or to the nearest one of the floor."""
        here = self.here
        self.move(cell.x - here.x, cell.y - here.y)

    def to_robot(self) -> None:
        self.cell = None

    def to_next_thing(self, forward: bool) -> bool:
        """Moves to the next thing by its distance from the robot; False if there is none."""
        order = self._things_by_distance()
        if not order:
            return False
        index = order.index(self.here) if self.here in order else (-1 if forward else 0)
        self.cell = order[(index + (1 if forward else -1)) % len(order)]
        return True

    def _things_by_distance(self) -> list[Cell]:
        scene, pose = self.scene, self.scene.pose
        cells = [scene.cell_at(each.x, each.y) for each in scene.things]
        cells += scene.others.values()
        distances = {
            cell: hypot(scene.place(cell)[0] - pose.x, scene.place(cell)[1] - pose.y) for cell in cells
        }
        return sorted(distances, key=lambda cell: (distances[cell], cell))

    def mark(self) -> None:
        self.marked = self.here

    # --- in words

    def words(self, wording: Wording) -> str:
        """The content of the pointer's square, and where it is from the robot."""
        x, y = self.scene.place(self.here)
        place = place_of(x, y, self.scene.pose, wording)
        return wording("map-square", x=x, y=y, what=content(self.scene, self.here, wording), place=place)

    def way(self, wording: Wording) -> str:
        """The way from the marked square to this one; from the robot's where none is marked."""
        from_x, from_y = self.scene.place(self.marked or self.scene.robot)
        x, y = self.scene.place(self.here)
        pose = replace(self.scene.pose, x=float(from_x), y=float(from_y))
        place = place_of(x, y, pose, wording)
        return wording("map-way", from_x=from_x, from_y=from_y, x=x, y=y, place=place)


def content(scene: MapScene, cell: Cell, wording: Wording) -> str:
    """What a square shows, a thing with its colour and a robot with its name."""
    kind, thing = scene.kind(cell), scene.thing(cell)
    if kind is Kind.OTHER:
        return scene.robot_at(cell) or wording("cell-other")
    if kind is Kind.ROBOT and scene.grid.name:
        return scene.grid.name
    if kind is not Kind.THING:
        return wording(f"cell-{kind.value}", number=scene.grid.goals.get(cell, 0))
    if thing is None:
        return scene.letter(cell)
    return coloured_thing(thing, wording)


def legend(scene: MapScene, wording: Wording) -> tuple[str, ...]:
    """The meanings of the map's letters; the things of this floor come last, with their colours."""
    letters: dict[str, list[Thing]] = {}
    for thing in scene.things:
        letters.setdefault(thing.letter, []).append(thing)
    goals = ("goal",) if scene.grid.goals else ()
    fixed = ("robot", "start", *goals, "trail", "wall", "ray", "free", "outside")
    return (
        *(wording(f"legend-{each}", name=scene.grid.name or wording("cell-robot")) for each in fixed),
        *(
            wording("map-legend", letter=letter, name=_in_their_colours(things, wording))
            for letter, things in sorted(letters.items())
        ),
    )


def _in_their_colours(things: Sequence[Thing], wording: Wording) -> str:
    """ "box, red", or what they are called and each colour once: "flower: R red, B blue"."""
    if len({each.colour for each in things}) == 1:
        return coloured_thing(things[0], wording) if len(things) == 1 else _of_all(things[0], wording)
    initials = colour_initials(wording)
    shades = dict.fromkeys(
        f"{initials.get(each.colour, '')} {shade(each, wording)}".strip() for each in things
    )
    return f"{name_of(things[0], wording)}: {', '.join(shades)}"


def _of_all(thing: Thing, wording: Wording) -> str:
    """What is true of all things of its kind and colour."""
    return coloured(thing.kind, "", thing.colour, wording)
