"""The words of an event as lines of text: what linear mode prints, the log shows and the voice says.

Whatever is spoken is printed: the voice takes its text from here too. What a program brings along is made
printable here, so that no text of a learner's can move a cursor.

Movements that are told faster than anybody can listen are summed up (``SummingUp``). While a program runs at
a robot's pace, at most ``MOST`` lines are told in a second. Only what says no more than that a movement went
as it was asked may be summed up, and where it led: what the program says, what is seen, obstacles, mistakes
and answers are told always and in order, each after the sum of what was before it. Nothing is taken from the
stream: a recording, the trail and the log have every movement.

Whoever tells events asks ``before`` and ``passes`` about each of them; all of them get the same answers, so
that what is said is what is printed.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence

from devices.ports.hints import Protocol
from devices.ports.values import Mutable, field
from donnie_tui.core.events import (
    BELT_LINK,
    Announced,
    Answered,
    Error,
    Event,
    Moved,
    Pointed,
    RunEnded,
    Spoke,
    Stamped,
    Turned,
)
from donnie_tui.core.harmless import printable
from donnie_tui.core.wording import Wording

LONGEST_SOURCE = 60
"""Characters of a source line that are quoted with a mistake."""

MOST_CALLS = 10
"""Calls that are told of a mistake deep inside."""

OF_NO_ROBOT = ("help", "more-mistakes", BELT_LINK)
"""Announcements that are about the language or the belt and not about what a robot does."""


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


MOST = 4
"""Lines that are told in a second, where some of them can be summed up."""
SECOND = 1.0

_MOVEMENTS = ("moved", "turned")
"""Codes of the announcements that follow a movement."""


class Telling(Protocol):
    """What of the stream is told, and what is told before."""

    def before(self, stamped: Stamped) -> tuple[str, ...]:
        """Lines that sum up what was not told, to be told before the event."""

    def passes(self, stamped: Stamped) -> bool:
        """Whether the event itself is told."""


class TellingAll:
    """Everything is told as it happens."""

    def before(self, stamped: Stamped) -> tuple[str, ...]:  # noqa: ARG002 -- as Telling has it
        return ()

    def passes(self, stamped: Stamped) -> bool:  # noqa: ARG002 -- as Telling has it
        return True


class _Untold(Mutable):
    """What one robot did that was not told."""

    steps: int = 0
    turns: int = 0
    movements: int = 0
    only: tuple[str, ...] = ()
    """The lines of the first movement: where it is the only one, they are told after all."""
    place: tuple[str, ...] = ()
    """Where the last one led."""


class _Judgement(Mutable):
    """Of the event that is being told."""

    stamped: Stamped | None = None
    before: tuple[str, ...] = ()
    passes: bool = True


class _Robot(Mutable):
    last: Moved | Turned | None = None
    """Its last movement."""
    is_told: bool = False
    """Whether the sentence of that movement was judged; what comes after it is where it led."""
    untold: _Untold = field(default_factory=_Untold)


class SummingUp:
    """The telling of a conversation with somebody who listens."""

    def __init__(self, wording: Wording, now: Callable[[], float], is_wanted: Callable[[], bool]) -> None:
        """``now`` in seconds; ``is_wanted`` is asked at each event: not where the robot has no pace."""
        self._say, self._now, self._is_wanted = wording, now, is_wanted
        self._robots: dict[str | None, _Robot] = {}
        self._told_at: deque[float] = deque(maxlen=MOST)
        self._judged = _Judgement()

    def before(self, stamped: Stamped) -> tuple[str, ...]:
        return self._judge(stamped).before

    def passes(self, stamped: Stamped) -> bool:
        return self._judge(stamped).passes

    def _judge(self, stamped: Stamped) -> _Judgement:
        """Once for each event, which all listeners get one after the other."""
        if self._judged.stamped is not stamped:
            self._judged = self._judged_anew(stamped)
        return self._judged

    def _judged_anew(self, stamped: Stamped) -> _Judgement:
        if not self._is_wanted():
            return _Judgement(stamped, self._summed_up())
        robot = self._robots.setdefault(stamped.robot, _Robot())
        if isinstance(stamped.event, Moved | Turned):
            robot.last, robot.is_told = stamped.event, False
        lines = told_lines(stamped, self._say)
        may_wait = _goes_without_saying(stamped, robot)
        ends = isinstance(stamped.event, RunEnded) or (lines and not may_wait)
        before = self._summed_up() if ends or self._has_room() else ()
        if may_wait and not self._has_room():
            _keep(robot, lines)
            return _Judgement(stamped, before, passes=False)
        self._count(lines)
        robot.is_told = robot.is_told or may_wait
        return _Judgement(stamped, before)

    def _has_room(self) -> bool:
        return len(self._told_at) < MOST or self._now() - self._told_at[0] >= SECOND

    def _count(self, lines: tuple[str, ...]) -> None:
        self._told_at.extend([self._now()] * len(lines))

    # --- what was not told

    def _summed_up(self) -> tuple[str, ...]:
        lines: list[str] = []
        for name, robot in self._robots.items():
            lines += (said_by(name, each, self._say) for each in self._sum(robot.untold))
            lines += robot.untold.only if robot.untold.movements == 1 else ()
            lines += robot.untold.place
            robot.untold = _Untold()
        self._count(tuple(lines))
        return tuple(lines)

    def _sum(self, untold: _Untold) -> tuple[str, ...]:
        if untold.movements < 2:
            return ()
        code = "more-steps" if not untold.turns else "more-turns" if not untold.steps else "more-moves"
        return (self._say(code, steps=untold.steps, turns=untold.turns),)


def _goes_without_saying(stamped: Stamped, robot: _Robot) -> bool:
    """Whether it says only that the last movement was done, or where it led."""
    is_of_movement = isinstance(stamped.event, Announced) and stamped.event.code in _MOVEMENTS
    return is_of_movement and robot.last is not None and robot.last.stopped_by is None


def _keep(robot: _Robot, lines: tuple[str, ...]) -> None:
    """Add it to what is summed up later."""
    untold, movement = robot.untold, robot.last
    if robot.is_told:
        untold.place = lines
        return
    robot.is_told = True
    untold.place = ()
    untold.movements += 1
    untold.only = untold.only or lines
    if isinstance(movement, Moved):
        untold.steps += movement.walked
    else:
        untold.turns += 1
