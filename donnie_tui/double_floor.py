"""The floor of a simulated board: the walls and things of a world as lines, where there are not too many."""

from __future__ import annotations

from itertools import pairwise
from math import hypot, radians
from typing import TYPE_CHECKING

from devices.firmware_double.surroundings import OpenFloor, Place, Segment, Surroundings, Walls
from devices.ports.robot import STEP, Pose

if TYPE_CHECKING:
    from sim.scene import Scene

MOST_LINES = 400
"""The board looks at each of them many times a second."""


def floor_of(scene: Scene, start: Pose) -> Surroundings | None:
    """What the board's sonars and bumpers meet; None if the world has more than a board can look at."""
    from sim.picture import drawings

    me, walls, radius = scene.robots[0], list[Segment](), 0.0
    for drawing in drawings(scene):
        if drawing.thing is not None and drawing.thing.index == me:
            radius = max(hypot(x - start.x, y - start.y) * STEP for line in drawing.outlines for x, y in line)
        else:
            walls += (segment for line in drawing.outlines for segment in _segments(line))
        if len(walls) > MOST_LINES:
            return None
    return Walls(walls, radius) if walls else OpenFloor()


def place_of(start: Pose) -> Place:
    """A pose in steps and compass degrees, as the board has it."""
    return Place(start.x * STEP, start.y * STEP, radians(90.0 - start.heading))


def _segments(outline: tuple[tuple[float, float], ...]) -> list[Segment]:
    """Its edges, closed, in metres."""
    metres = [(x * STEP, y * STEP) for x, y in outline]
    return [(*one, *other) for one, other in pairwise([*metres, metres[0]])]
