"""Going back in words: what is undone, and where the robot is then."""

from __future__ import annotations

from collections.abc import Iterable

from devices.ports.robot import Pose
from donnie_tui.core import poses
from donnie_tui.core.events import (
    TYPED,
    Announced,
    BeltShown,
    CueSounded,
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
from donnie_tui.core.harmless import printable
from donnie_tui.core.telling import facing
from donnie_tui.core.timeline import Timeline, is_deed
from donnie_tui.core.transcript import said_by, told_lines
from donnie_tui.core.wording import Wording

LONGEST_QUOTE = 60
"""Characters of what was said that are told again."""

_PARTS = {"step-forward": "walk", "step-back": "walk", "turn-right": "turn", "turn-left": "turn"}
"""Cues of a movement that goes on, by what it is."""


def told_back(undone: Iterable[Stamped], timeline: Timeline, wording: Wording) -> str:
    """One sentence for a step that was undone, ``timeline`` standing before it: "Back: FW 3. Position 0, 2."

    ``undone`` is what ``Timeline.step_back`` gave; at the start of everything it is empty.
    """
    events = tuple(undone)
    if not events:
        return wording("undone-start")
    done = next((each for each in events if is_deed(each.event)), events[-1])
    sentence = wording("undone", what=_what(done.event, wording))
    place = _place(done.event, timeline.pose(done.robot), wording)
    text = f"{sentence} {place}" if place else sentence
    return said_by(done.robot, text, wording)


def told_forward(step: Iterable[Stamped], wording: Wording) -> str:
    """One sentence for a step of which nothing was told: "Start of a.gd." Empty where something was."""
    events = tuple(step)
    if not events or any(told_lines(each, wording) for each in events):
        return ""
    done = next((each for each in events if is_deed(each.event)), events[-1])
    return said_by(done.robot, wording("redone", what=_what(done.event, wording)), wording)


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
        case RunEnded() | Scanned() | SoundSwitched() | Link() | Reset():
            return wording(f"undone-{event_name(event).replace('_', '-')}")
        case _:
            return _trifle(event, wording)


def _trifle(event: Event, wording: Wording) -> str:
    """What only stands alone where a step had not ended: while a program is held within it."""
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
    """Where the robot is again, where that has changed."""
    part = _PARTS.get(event.name) if isinstance(event, CueSounded) else None
    if pose is None or not (part or isinstance(event, Moved | Turned | RunStarted | RunEnded | Reset)):
        return ""
    if isinstance(event, Turned) or part == "turn":
        return wording("undone-facing", facing=facing(pose, wording))
    return wording("undone-position", x=poses.whole(pose.x), y=poses.whole(pose.y))


def _quoted(text: str) -> str:
    shown = printable(" ".join(text.split())).rstrip(".")
    return shown if len(shown) <= LONGEST_QUOTE else f"{shown[: LONGEST_QUOTE - 1]}…"
