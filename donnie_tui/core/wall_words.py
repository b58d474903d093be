"""The walls of a world in words, where its author wrote none: all around, or on which sides of the robot.

A way out is looked for on the map, square by square: what can't be left has walls all around.
"""

from __future__ import annotations

from math import inf
from typing import TYPE_CHECKING

from devices.ports.robot import Pose
from donnie_tui.core.wording import Wording

if TYPE_CHECKING:
    from sim.picture import Picture

_SIDES = ("north", "east", "south", "west")
_WALL = "#"


def walls_in_words(picture: Picture, pose: Pose, wording: Wording) -> tuple[str, ...]:
    """One sentence about the walls as they are seen from ``pose``; none where there are none."""
    if not picture.has_walls:
        return ()
    if not _has_way_out(picture, pose):
        return (wording("walls-around"),)
    from sim.room import Room  # a world without walls needs no geometry

    room = Room(picture, pose)
    gaps = {side: room.ahead(room.walls, 90.0 * quarter) for quarter, side in enumerate(_SIDES)}
    seen = [wording(f"place-{side}", steps=room.whole(gap)) for side, gap in gaps.items() if gap < inf]
    return (wording("walls-seen", sides=", ".join(seen)) if seen else wording("walls-aside"),)


def _has_way_out(picture: Picture, pose: Pose) -> bool:
    """Whether free squares lead from there over the edge of the map."""
    waiting = [picture.at(pose.x, pose.y)]
    seen = set(waiting)
    while waiting:
        if (square := waiting.pop()) is None:
            return True
        row, column = square
        for beside in ((row - 1, column), (row + 1, column), (row, column - 1), (row, column + 1)):
            if not _is_on(picture, *beside):
                return True
            if beside not in seen and picture.rows[beside[0]][beside[1]] != _WALL:
                seen.add(beside)
                waiting.append(beside)
    return False


def _is_on(picture: Picture, row: int, column: int) -> bool:
    return 0 <= row < picture.height and 0 <= column < picture.width
