"""Telling a recording again: when each event was, and going through it at a pace, forwards and backwards.

The program's time is kept, divided by the speed; nothing here knows how it is told. All waiting goes through
the control, so that a stop takes effect at once.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from donnie_tui.core.events import RunEnded, RunStarted, Stamped
from donnie_tui.core.map_grid import Cell
from donnie_tui.core.map_scene import MapScene
from donnie_tui.core.timeline import Timeline
from language.control import ExecutionControl

if TYPE_CHECKING:
    from sim.picture import Picture

WIDEST, HIGHEST = 78, 22
"""Squares of a map: what a terminal of 80 by 24 shows at once."""

LONGEST_PAUSE = 5.0
"""Seconds of real time that a replay is silent at most: nobody waits for a WAIT 1000 again."""


class Replay:
    """One way through a recording. ``speed``: times the robot's own pace; None is as fast as possible."""

    def __init__(self, timeline: Timeline, control: ExecutionControl, speed: float | None) -> None:
        self.timeline = timeline
        self.control = control
        self.speed = speed
        self._moments = moments_of(timeline.events)

    def forwards(self, tell: Callable[[Stamped], None]) -> bool:
        """From here to the end. False if it was stopped."""
        while self.timeline.at < len(self.timeline):
            if not self._pause(self.timeline.at, self.timeline.at + 1):
                return False
            stamped = self.timeline.forward()
            assert stamped is not None  # the end is not reached
            tell(stamped)
        return True

    def backwards(self, tell: Callable[[tuple[Stamped, ...]], None]) -> bool:
        """From here to the start, step by step. False if it was stopped."""
        while self.timeline.at > 0:
            before = self.timeline.at
            undone = self.timeline.step_back()
            tell(undone)
            if not self._pause(before, self.timeline.at):
                return False
        return True

    def _pause(self, one: int, other: int) -> bool:
        """Let the time between two positions go by."""
        seconds = abs(self._moment(other) - self._moment(one))
        return self.control.sleep(min(LONGEST_PAUSE, seconds / self.speed) if self.speed else 0.0)

    def _moment(self, at: int) -> float:
        return self._moments[at - 1] if at else 0.0


def moments_of(events: Iterable[Stamped]) -> array[float]:
    """When each event was, in seconds from the first: one run after the other, robots beside each other.

    Each run has a time of its own, from 0; it began at the moment that the whole had come to.
    """
    moments, now = array("d"), 0.0
    began: dict[str | None, float] = {}
    running: set[str | None] = set()
    together = 0.0
    for stamped in events:
        if isinstance(stamped.event, RunStarted):
            how = stamped.event.how
            if not running:
                together = now
            began[stamped.robot] = together if how and how.together else now
            running.add(stamped.robot)
        now = max(now, began.get(stamped.robot, now) + stamped.t) if stamped.robot in running else now
        moments.append(now)
        if isinstance(stamped.event, RunEnded):
            running.discard(stamped.robot)
    return moments


def map_at(timeline: Timeline, picture: Picture, robot: str | None) -> MapScene | None:
    """The map as it was at this position, with that robot's trail. None where nothing tells its place yet."""
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


def rows_of(scene: MapScene) -> tuple[str, ...]:
    """The map, or of a large one the part around the robot; the northern row first."""
    part = scene.bounds.part(scene.robot, WIDEST, HIGHEST)
    return tuple(
        "".join(scene.letter(Cell(x, y)) for x in range(part.left, part.right + 1))
        for y in range(part.top, part.bottom - 1, -1)
    )
