"""What is around the robot, told by direction: how many things, then clockwise from ahead (or from north).

Every thing in range is named exactly once, in the direction in which its nearest edge is; a direction with
neither thing nor wall is free. Steps are counted from the robot's edge to that of the thing or wall, as
DISTANCE counts them: straight on where the robot would meet it, else as near as it is. Directions are 4, 8 at
detail full, or the 12 hours of a clock face.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from devices.ports.robot import Pose
from devices.ports.values import Frozen
from donnie_tui.core.map_grid import MapGrid
from donnie_tui.core.naming import coloured_thing, told_name_of
from donnie_tui.core.poses import COMPASS, SIDES
from donnie_tui.core.wording import Wording
from language.source import fold_name

if TYPE_CHECKING:
    from sim.picture import Thing
    from sim.room import Room

RANGE = 10
"""Steps that are looked at in each direction."""


_POINTS = (
    ("north", "norte"),
    ("northeast", "nordeste", "noreste"),
    ("east", "leste", "este"),
    ("southeast", "sudeste", "sureste"),
    ("south", "sul", "sur"),
    ("southwest", "sudoeste", "suroeste"),
    ("west", "oeste"),
    ("northwest", "noroeste"),
)
"""As they are typed, in any language."""


class Face(Frozen):
    """Into which directions the surroundings are cut, and what these are called."""

    sectors: int
    first: float
    """The compass heading of the first one."""
    codes: tuple[str, ...]
    """Of the sentence that names each sector; with ``{hour}`` for a clock face."""
    told_when_free: tuple[int, ...]

    def heading(self, sector: int) -> float:
        """The compass heading of a sector's middle."""
        return self.first + sector * 360 / self.sectors


def compass_point(typed: str) -> int | None:
    """The point of the compass that a word means, in eighths clockwise from north; None if it means none."""
    folded = fold_name(typed.strip())
    return next((point for point, words in enumerate(_POINTS) if folded in words), None)


def compass_words(language: str) -> tuple[str, ...]:
    """The points of the compass, clockwise from north, as they are typed in a language."""
    at = {"en": 0, "pt": 1, "es": -1}[language]
    return tuple(words[at] for words in _POINTS)


def around_in_words(
    grid: MapGrid, pose: Pose, wording: Wording, *, compass: int | None = None, clock: bool = False
) -> tuple[str, ...]:
    """The number of things in range, then a line for each thing, wall or free direction.

    ``compass``: by the compass, beginning with that point; else as the robot looks.
    """
    face = _face(pose.heading, wording.detail, compass=compass, clock=clock)
    from sim.room import Room  # who doesn't ask what is around needs no geometry

    room = Room(grid.picture, pose)
    sectors = _things_by_sector(grid, room, face)
    count = sum(map(len, sectors))
    lines = [wording("around-things" if count else "around-none", count=count, steps=RANGE)]
    for sector in range(face.sectors):
        lines += _sector_in_words(room, face, sector, sectors[sector], wording)
    return tuple(lines)


def _face(heading: float, detail: str, *, compass: int | None, clock: bool) -> Face:
    full = detail == "full"
    if clock:
        return Face(12, heading, ("around-hour",) * 12, tuple(range(12)) if full else (0, 3, 6, 9))
    step = 1 if full else 2
    codes = [f"around-{each}" for each in SIDES]
    if compass is not None:
        codes = [f"compass-{each}" for each in (*COMPASS[compass:], *COMPASS[:compass])]
    first = heading if compass is None else compass * 45.0
    return Face(8 // step, first, tuple(codes[::step]), tuple(range(8 // step)))


def _things_by_sector(grid: MapGrid, room: Room, face: Face) -> list[list[tuple[int, Thing]]]:
    """The things in range with their distances, the nearest first, by sector."""
    found: list[list[tuple[int, Thing]]] = [[] for _ in range(face.sectors)]
    for thing in grid.picture.things:
        gap, heading = room.nearest(thing.outlines)
        if (steps := _in_range(room, gap)) is not None:
            sector = round((heading - face.first) / (360 / face.sectors)) % face.sectors
            straight = _in_range(room, room.ahead(thing.outlines, face.heading(sector)))
            found[sector].append((steps if straight is None else straight, thing))
    return [sorted(each, key=lambda found: (found[0], found[1].name)) for each in found]


def _sector_in_words(
    room: Room, face: Face, sector: int, things: list[tuple[int, Thing]], wording: Wording
) -> Iterator[str]:
    where = wording(face.codes[sector], hour=sector or 12)
    wall, free = (_in_range(room, room.ahead(each, face.heading(sector))) for each in (room.walls, room.all))
    told = [(steps, _named(thing, wording)) for steps, thing in things]
    if wall is not None and (told or sector in face.told_when_free):
        told = sorted([*told, (wall, wording("cell-wall"))], key=lambda each: each[0])
    for steps, name in told:
        yield wording("around-thing", where=where, thing=name, steps=steps)
    if not told and sector in face.told_when_free:
        yield wording("around-free", where=where, steps=RANGE if free is None else free)


def _in_range(room: Room, steps: float) -> int | None:
    """Whole steps; None beyond what is told."""
    whole = room.whole(min(steps, RANGE + 1))
    return whole if whole <= RANGE else None


def _named(thing: Thing, wording: Wording) -> str:
    return told_name_of(thing, wording) if wording.detail == "brief" else coloured_thing(thing, wording)
