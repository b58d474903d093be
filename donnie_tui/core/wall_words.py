"""The walls of a world in words, where its author wrote none: all around, or on which sides of the robot.

A way out is looked for on the map, run by run of squares: what can't be left has walls all around.
"""

from __future__ import annotations

from collections.abc import Iterator
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
    """Whether free squares lead from there over the edge of the map; looked for by runs of such squares."""
    rows, start = picture.rows, picture.at(pose.x, pose.y)
    waiting = [] if start is None else [start]
    seen = set[tuple[int, int]]()
    while waiting:
        row, column = waiting.pop()
        left, right = rows[row].rfind(_WALL, 0, column) + 1, rows[row].find(_WALL, column)
        if left == 0 or right < 0 or row in (0, picture.height - 1):
            return True
        if (row, left) not in seen:
            seen.add((row, left))
            waiting += [
                (beside, at) for beside in (row - 1, row + 1) for at in _runs(rows[beside], left, right)
            ]
    return start is None


def _runs(row: str, left: int, right: int) -> Iterator[int]:
    """The first square of each run of free ones between two columns."""
    for column in range(left, right):
        if row[column] != _WALL and (column == left or row[column - 1] == _WALL):
            yield column
