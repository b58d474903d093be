"""The map of a replay: the floor of the recorded world as the robot finds it of whom is told.

Among several robots the map says whose it is: all of them are arrows.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from donnie_tui.core.harmless import printable
from donnie_tui.core.replay import map_at, rows_of
from donnie_tui.core.timeline import Timeline
from donnie_tui.i18n.words import Words

if TYPE_CHECKING:
    from sim.picture import Picture
    from sim.scene import Scene


class ReplayMap:
    """Each robot's picture of the floor is made once."""

    def __init__(self, scene: Scene, words: Words) -> None:
        self._scene = scene
        self._words = words
        self._pictures: dict[str | None, Picture] = {}

    def lines(self, timeline: Timeline, robot: str | None) -> tuple[str, ...]:
        """The map at this position, from north to south; empty where nothing tells where that robot is."""
        if not timeline.trail(robot):
            return ()
        scene = map_at(timeline, self._picture(robot), robot)
        rows = rows_of(scene) if scene is not None else ()
        if robot is None or not rows:
            return rows
        return (self._words("replay-map-of", robot=printable(robot)), *rows)

    def _picture(self, robot: str | None) -> Picture:
        from sim.picture import picture

        if robot not in self._pictures:
            is_known = robot in self._scene.robot_names
            self._pictures[robot] = picture(self._scene, robot if is_known else None)
        return self._pictures[robot]
