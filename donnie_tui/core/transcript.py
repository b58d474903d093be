"""The words of an event as lines of text: what linear mode prints, the log shows and the voice says.

Whatever is spoken is printed: the voice takes its text from here too. What a program brings along is made
printable here, so that no text of a learner's can move a cursor.
"""

from __future__ import annotations

from collections.abc import Sequence

from donnie_tui.core.events import Announced, Answered, Error, Event, Pointed, Spoke, Stamped
from donnie_tui.core.harmless import printable
from donnie_tui.core.wording import Wording

LONGEST_SOURCE = 60
"""Characters of a source line that are quoted with a mistake."""

MOST_CALLS = 10
"""Calls that are told of a mistake deep inside."""

OF_NO_ROBOT = ("help", "more-mistakes")
"""Announcements that are about the language and not about what a robot does."""


def told_lines(stamped: Stamped, wording: Wording) -> tuple[str, ...]:
    """The lines that tell the event, with the robot's name before them where the world has several."""
    lines = lines_of(stamped.event, wording)
    if stamped.robot is None or (isinstance(stamped.event, Announced) and stamped.event.code in OF_NO_ROBOT):
        return lines
    return tuple(said_by(stamped.robot, line, wording) for line in lines)


def said_by(robot: str | None, sentence: str, wording: Wording) -> str:
    """A sentence about a robot, with its name before it; ``robot`` is None where the world has but one."""
    return sentence if robot is None else wording("robot-says", robot=printable(robot), text=sentence)


def lines_said_by(robot: str | None, lines: Sequence[str], wording: Wording) -> tuple[str, ...]:
    """Lines about a robot, its name before the first of them."""
    return (*(said_by(robot, each, wording) for each in lines[:1]), *lines[1:])


def lines_of(event: Event, wording: Wording) -> tuple[str, ...]:
    """The lines that tell the event, none if it is not told in words."""
    match event:
        case Spoke(text=text) | Announced(text=text) | Answered(text=text) | Pointed(text=text):
            return tuple(printable(line) for line in text.splitlines()) or ("",)
        case Error():
            return tuple(printable(line) for line in _lines_of_error(event, wording))
        case _:
            return ()


def _lines_of_error(error: Error, wording: Wording) -> tuple[str, ...]:
    """At most three lines: where and what, the line itself, what was meant; at full the calls too."""
    lines = [wording("error-at", line=error.line, column=error.column, message=error.message)]
    if error.source_line:
        lines.append(wording("error-line", line=error.line, text=_quoted(error)))
    if error.hint:
        lines.append(error.hint)
    if wording.detail == "full":
        lines += [wording("called-from", line=line) for line in error.calls[:MOST_CALLS]]
    return tuple(lines)


def _quoted(error: Error) -> str:
    """The source line, or of a long one the part with the mistake."""
    line = error.source_line
    if len(line) <= LONGEST_SOURCE:
        return line
    start = max(0, min(error.column - 1, len(line)) - LONGEST_SOURCE // 2)
    return line[start : start + LONGEST_SOURCE].strip()
