"""What a run says that has told nothing for a while: how far the robot has walked, or where it is."""

from __future__ import annotations

from math import hypot

from donnie_tui.linear.desk import Desk
from language.control import ControlState
from language.parser import parse
from language.syntax import Number, Walk


def sign_of_life(desk: Desk) -> None:
    run = desk.session.run
    if run is None:
        _tell_of_others(desk)
    elif run.control.state is ControlState.PAUSED:
        desk.answer_of_robot("linear-paused")
    else:
        _tell_of_own(desk)


def _tell_of_others(desk: Desk) -> None:
    """The robot that is talked to has done; those that run together with it have not."""
    for session in desk.donnie.team.running[:1]:
        desk.answer_of(session.hub.robot, "linear-still-running")


def _tell_of_own(desk: Desk) -> None:
    frames = desk.session.frames
    line = frames[0].line if frames else 0
    lines = desk.program.lines
    text = lines[line - 1].strip() if 0 < line <= len(lines) else ""
    walked = _walked(desk)
    if walked:
        _tell_walk(desk, walked, text)
    elif text:
        desk.answer("linear-still-at", line=line, text=text)
    else:
        desk.answer("linear-still-running" if frames else "linear-still-reading")


def _walked(desk: Desk) -> int:
    """Steps since the robot last stood."""
    before, now = desk.heard.trail.last_pose, desk.session.pose
    return round(hypot(now.x - before.x, now.y - before.y)) if before else 0


def _tell_walk(desk: Desk, walked: int, text: str) -> None:
    """Of how many, where the line says just that."""
    program = parse(text).program
    statement = program.body[0] if program and len(program.body) == 1 else None
    if isinstance(statement, Walk) and isinstance(statement.steps, Number):
        desk.answer("still-walking-of", done=walked, asked=statement.steps.value)
    else:
        desk.answer("still-walking", done=walked)
