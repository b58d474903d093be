"""Replays a recording: its times, its pace forwards and backwards, its map, and steps back in words.

The program's time is kept, divided by the speed. The caller decides how events are shown. All waiting goes
through the control, so that a stop takes effect at once.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from devices.ports.robot import Pose
from donnie_tui.core.events import (
    TYPED,
    Announced,
    BeltShown,
    CueSounded,
    Driven,
    Error,
    Event,
    GripperUsed,
    Link,
    Moved,
    Read,
    Reset,
    RunEnded,
    RunStarted,
    Scanned,
    SoundSwitched,
    Spoke,
    Stamped,
    Statement,
    ThingsMoved,
    Turned,
    Waited,
    event_name,
)
from donnie_tui.core.map_grid import Cell
from donnie_tui.core.map_scene import MapScene
from donnie_tui.core.timeline import Timeline, is_main_event
from donnie_tui.core.transcript import printed_lines, with_robot_name
from donnie_tui.core.wording import Wording, colour_initials, facing, whole_steps
from language.control import ExecutionControl
from language.source import printable

if TYPE_CHECKING:
    from sim.picture import Picture


WIDEST, HIGHEST = 78, 22
"""Squares of a map: what a terminal of 80 by 24 shows at once."""

LONGEST_PAUSE = 5.0
"""Seconds of real time that a replay pauses at most, so that a WAIT 1000 is not waited for again."""


class Replay:
    """One pass through a recording. ``speed``: times the robot's own pace; None is as fast as possible."""

    def __init__(self, timeline: Timeline, control: ExecutionControl, speed: float | None) -> None:
        self.timeline = timeline
        self.control = control
        self.speed = speed
        self._moments = moments_of(timeline.events)

    def forwards(self, show: Callable[[Stamped], None]) -> bool:
        """Plays from here to the end. False if it was stopped."""
        while self.timeline.at < len(self.timeline):
            if not self._pause(self.timeline.at, self.timeline.at + 1):
                return False
            stamped = self.timeline.forward()
            assert stamped is not None  # the end is not reached
            show(stamped)
        return True

    def backwards(self, show: Callable[[tuple[Stamped, ...]], None]) -> bool:
        """Plays from here to the start, step by step. False if it was stopped."""
        while self.timeline.at > 0:
            before = self.timeline.at
            undone = self.timeline.step_back()
            show(undone)
            if not self._pause(before, self.timeline.at):
                return False
        return True

    def _pause(self, one: int, other: int) -> bool:
        """Waits as long as the time between two positions."""
        seconds = abs(self._moment(other) - self._moment(one))
        return self.control.sleep(min(LONGEST_PAUSE, seconds / self.speed) if self.speed else 0.0)

    def _moment(self, at: int) -> float:
        return self._moments[at - 1] if at else 0.0


def moments_of(events: Iterable[Stamped]) -> array[float]:
    """The times of the events in seconds from the first: run after run, robots in parallel.

    Each run has its own time from 0; it is added to the time at which the run began.
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
    """The map at this position, with that robot's trail. None where the robot's place is not known yet."""
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

    return tuple(
        "".join(shown(Cell(x, y)) for x in range(part.left, part.right + 1))
        for y in range(part.top, part.bottom - 1, -1)
    )


LONGEST_QUOTE = 60
"""Characters of spoken text that are quoted."""

_PARTS = {"step-forward": "walk", "step-back": "walk", "turn-right": "turn", "turn-left": "turn"}
"""Cues during a movement, by its kind."""


def undone_in_words(undone: Iterable[Stamped], timeline: Timeline, wording: Wording) -> str:
    """One sentence for a step that was undone: "Before FW 3: position 0, 2."

    ``undone`` is the result of ``Timeline.step_back``, empty at the start; ``timeline`` is already before the
    step.
    """
    events = tuple(undone)
    if not events:
        return wording("undone-start")
    done = next((each for each in events if is_main_event(each.event)), events[-1])
    return with_robot_name(done.robot, _undone(done.event, timeline.pose(done.robot), wording), wording)


def _undone(event: Event, pose: Pose | None, wording: Wording) -> str:
    what = _what(event, wording)
    match event:
        case Moved() if pose is not None:
            return wording("undone-walk", what=what, x=whole_steps(pose.x), y=whole_steps(pose.y))
        case Turned() if pose is not None:
            return wording("undone-turn", what=what, facing=facing(pose, wording))
        case _:
            place = _place(event, pose, wording)
            return " ".join(filter(None, (wording("undone", what=what), place)))


def redone_in_words(step: Iterable[Stamped], wording: Wording) -> str:
    """One sentence for a step that printed nothing: "Start of a.gd." Else empty."""
    events = tuple(step)
    if not events or any(printed_lines(each, wording) for each in events):
        return ""
    done = next((each for each in events if is_main_event(each.event)), events[-1])
    return with_robot_name(done.robot, wording("redone", what=_what(done.event, wording)), wording)


def _what(event: Event, wording: Wording) -> str:
    match event:
        case Moved(command=command) | Turned(command=command):
            return _quoted(command)
        case Spoke(text=text) | Announced(text=text):
            return _quoted(text)
        case Waited(seconds=seconds):
            return wording("undone-waited", seconds=seconds)
        case GripperUsed(outcome=outcome):
            return wording(f"undone-gripper-{outcome.value}")
        case Error(line=line):
            return wording("undone-error", line=line)
        case RunStarted(program=program):
            is_typed = program == TYPED
            return wording(f"undone-run-{'typed' if is_typed else 'started'}", program=_quoted(program))
        case RunEnded() | Driven() | Scanned() | SoundSwitched() | Link() | Reset():
            return wording(f"undone-{event_name(event).replace('_', '-')}")
        case _:
            return _trifle(event, wording)


def _trifle(event: Event, wording: Wording) -> str:
    """Words for a minor event, which is a step of its own only while a program is held within a step."""
    match event:
        case Statement(line=line):
            return wording("undone-statement", line=line)
        case Read(value=value):
            return wording("undone-read", value=value)
        case CueSounded(name=name) if name in _PARTS:
            return wording(f"undone-part-{_PARTS[name]}")
        case BeltShown() | ThingsMoved() | CueSounded():
            return wording(f"undone-{event_name(event).replace('_', '-')}")
        case _:
            return wording("undone-something")


def _place(event: Event, pose: Pose | None, wording: Wording) -> str:
    """The robot's place after the step back, if that changed."""
    part = _PARTS.get(event.name) if isinstance(event, CueSounded) else None
    if pose is None or not (part or isinstance(event, RunStarted | RunEnded | Reset)):
        return ""
    if part == "turn":
        return wording("undone-facing", facing=facing(pose, wording))
    return wording("undone-position", x=whole_steps(pose.x), y=whole_steps(pose.y))


def _quoted(text: str) -> str:
    shown = printable(" ".join(text.split())).rstrip(".")
    return shown if len(shown) <= LONGEST_QUOTE else f"{shown[: LONGEST_QUOTE - 1]}…"
