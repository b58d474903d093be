"""Events in words: the lines that linear mode prints, the log shows and the voice speaks.

``SentencePublisher`` publishes the answers to STATE, HISTORY, POS and HELP as announcements; ``History`` has
the movements for them.

The voice takes its text from here, so that all that is spoken is also printed. Text from a program is made
printable here, so that it can't move a cursor.

``SummaryFilter`` sums up movements that come faster than a learner can follow. While a program runs at the
robot's pace, at most ``MOST`` lines are printed in a second. Only the sentences "a movement was done" and
"this is where it led" may be summed up. What the program says, what is seen, obstacles, mistakes and answers
are always printed. Each comes after the sum of what was before it, but for the words of the program, which a
sum does not interrupt. The stream keeps everything: a recording, the trail and the log have every movement.

Each listener that prints or speaks asks ``before`` and ``passes`` about each event. All of them get the same
answers, so that the voice speaks what is printed.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Protocol, TextIO

from msgspec import Struct, field

from devices.ports.robot import Pose, StoppedBy
from donnie_tui.core.events import (
    BELT_LINK,
    Announced,
    Answered,
    Error,
    Event,
    LineFile,
    Moved,
    Pointed,
    RunEnded,
    RunStarted,
    Spoke,
    Stamped,
    Turned,
)
from donnie_tui.core.hub import Hub
from donnie_tui.core.wording import BRAILLE_CELLS, Wording, compass_heading, position_in_words, whole_steps
from language.source import printable

if TYPE_CHECKING:
    from pathlib import Path


MOST_MOVEMENTS = 10_000
"""Movements that HISTORY remembers, the newest ones. An endless program makes millions."""


class History:
    """The newest movements, oldest first."""

    def __init__(self, most: int = MOST_MOVEMENTS) -> None:
        self.movements: deque[tuple[int, Moved | Turned]] = deque(maxlen=most)
        """Each with its number, from 1."""
        self._last_number = 0

    def remember(self, event: Moved | Turned) -> None:
        self._last_number += 1
        self.movements.append((self._last_number, event))

    def forget(self) -> None:
        self.movements.clear()
        self._last_number = 0

    @property
    def forgotten(self) -> int:
        """How many movements came before those that are remembered."""
        return self._last_number - len(self.movements)


class SentencePublisher:
    """Makes sentences with the wording and publishes them."""

    def __init__(self, hub: Hub, wording: Wording) -> None:
        self._hub = hub
        self._say = wording

    def announce(self, code: str, sentence: str | None = None, **values: object) -> None:
        """Publishes one sentence. ``sentence`` is its code in the catalogue where that is not ``code``."""
        self._hub.publish(Announced(code, self._say(sentence or code, **values)))

    def place(self, code: str, pose: Pose) -> None:
        """Publishes the robot's place, with ``code`` as the subject."""
        self._hub.publish(Announced(code, position_in_words(pose, self._say)))

    def help(self, topic: str | None) -> None:
        for line in self._say.help(topic):
            self._hub.publish(Announced("help", line))

    def no_movement(self, code: str, pose: Pose) -> None:
        self.announce(code, "no-movement", **_whole(pose))

    def movement(self, code: str, number: int, event: Moved | Turned) -> None:
        done = event.turned if isinstance(event, Turned) else event.walked
        has_crashed = event.stopped_by not in (None, StoppedBy.LINK)
        self.announce(
            code,
            "movement-turned" if isinstance(event, Turned) else "movement-walked",
            number=number,
            command=event.command,
            done=done,
            crashed=self._say("crashed" if has_crashed else "not-crashed"),
            **_whole(event.pose),
        )


def _whole(pose: Pose) -> dict[str, int]:
    return {"x": whole_steps(pose.x), "y": whole_steps(pose.y), "heading": compass_heading(pose)}


LONGEST_SOURCE = 60
"""Characters of a source line that are quoted with a mistake."""

MOST_CALLS = 10
"""Calls that are listed for a mistake in a procedure."""

OF_NO_ROBOT = ("help", "more-mistakes", "driven", "clients", BELT_LINK)
"""Announcements about no robot, or that name it themselves."""


def printed_lines(stamped: Stamped, wording: Wording) -> tuple[str, ...]:
    """The lines of an event, with the robot's name before them where the world has several."""
    lines = lines_of(stamped.event, wording)
    if stamped.robot is None or (isinstance(stamped.event, Announced) and stamped.event.code in OF_NO_ROBOT):
        return lines
    return tuple(with_robot_name(stamped.robot, line, wording) for line in lines)


def with_robot_name(robot: str | None, sentence: str, wording: Wording) -> str:
    """A sentence about a robot, with its name before it; ``robot`` is None if the world has but one."""
    return sentence if robot is None else wording("robot-says", robot=printable(robot), text=sentence)


def lines_with_robot_name(robot: str | None, lines: Sequence[str], wording: Wording) -> tuple[str, ...]:
    """Lines about a robot, its name before the first of them."""
    return (*(with_robot_name(robot, each, wording) for each in lines[:1]), *lines[1:])


def lines_of(event: Event, wording: Wording) -> tuple[str, ...]:
    """The lines of an event; none if it is not printed."""
    match event:
        case Spoke(text=text) | Announced(text=text) | Answered(text=text) | Pointed(text=text):
            return tuple(printable(line) for line in text.splitlines()) or ("",)
        case Error():
            return tuple(printable(line) for line in _lines_of_error(event, wording))
        case _:
            return ()


def _lines_of_error(error: Error, wording: Wording) -> tuple[str, ...]:
    """At most three lines: place and mistake, the source line, what was meant; at full also the calls.

    At brief a mistake that makes its line too long is on a line of its own, after the source line.
    """
    lines = [wording("error-at", line=error.line, column=error.column, message=error.message)]
    is_too_long = wording.detail == "brief" and len(lines[0]) > BRAILLE_CELLS
    if error.source_line and is_too_long:
        at = wording("error-at", line=error.line, column=error.column, message=_quoted(error))
        lines = [at, error.message]
    elif error.source_line:
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
"""Lines that are printed in a second, where some of them can be summed up."""
SECOND = 1.0

_MOVEMENTS = ("moved", "turned")
"""Codes of the announcements that follow a movement."""


class TranscriptFilter(Protocol):
    """Decides which events are printed, and what is printed before them."""

    def before(self, stamped: Stamped) -> tuple[str, ...]:
        """Lines to print before the event, which sum up what was left out."""

    def passes(self, stamped: Stamped) -> bool:
        """Whether the event itself is printed."""


class UnfilteredTranscript:
    """Prints everything as it happens."""

    def before(self, stamped: Stamped) -> tuple[str, ...]:  # noqa: ARG002 -- as in the protocol
        return ()

    def passes(self, stamped: Stamped) -> bool:  # noqa: ARG002 -- as in the protocol
        return True


class _Omitted(Struct):
    """The movements of one robot that were left out."""

    steps: int = 0
    turns: int = 0
    movements: int = 0
    only: tuple[str, ...] = ()
    """The lines of the last movement; they are printed if it is the only one."""
    place: tuple[str, ...] = ()
    """The lines for the place after the last movement."""


class _Decision(Struct):
    """The decision about the current event."""

    stamped: Stamped | None = None
    before: tuple[str, ...] = ()
    passes: bool = True


class _Robot(Struct):
    last: Moved | Turned | None = None
    """Its last movement."""
    is_decided: bool = False
    """Whether the sentence of that movement was decided on; the next one is about the place."""
    omitted: _Omitted = field(default_factory=_Omitted)
    speaks: bool = False
    """Whether its program has spoken."""


class SummaryFilter:
    """The filter for a learner at a prompt: sums up movements that come too fast.

    What a program says itself is not interrupted: from its first words on, the sum comes before the
    next movement that is printed, or after an obstacle, a mistake, or the program's end.
    """

    def __init__(
        self,
        wording: Wording,
        now: Callable[[], float],
        is_wanted: Callable[[], bool],
        is_known: Callable[[Error], bool] = lambda _: False,
    ) -> None:
        """``now`` in seconds. ``is_wanted`` is called at each event: False if the robot has no pace.

        ``is_known``: whether a mistake was reported before, which is not said again.
        """
        self._say, self._now, self._is_wanted, self._is_known = wording, now, is_wanted, is_known
        self._robots: dict[str | None, _Robot] = {}
        self._printed_at: deque[float] = deque(maxlen=MOST)
        self._decided = _Decision()

    def before(self, stamped: Stamped) -> tuple[str, ...]:
        return self._decision_on(stamped).before

    def passes(self, stamped: Stamped) -> bool:
        return self._decision_on(stamped).passes

    def _decision_on(self, stamped: Stamped) -> _Decision:
        """Decides once for each event, which the listeners get one after the other."""
        if self._decided.stamped is not stamped:
            self._decided = self._decide(stamped)
        return self._decided

    def _decide(self, stamped: Stamped) -> _Decision:
        if isinstance(stamped.event, Error) and self._is_known(stamped.event):
            return _Decision(stamped, self._summed_up(), passes=False)
        if not self._is_wanted():
            return _Decision(stamped, self._summed_up())
        robot = self._robots.setdefault(stamped.robot, _Robot())
        if isinstance(stamped.event, Moved | Turned):
            robot.last, robot.is_decided = stamped.event, False
        lines = printed_lines(stamped, self._say)
        may_wait = _is_routine(stamped, robot)
        is_spoken = isinstance(stamped.event, Spoke)
        robot.speaks = is_spoken or (robot.speaks and not isinstance(stamped.event, RunStarted))
        ends = isinstance(stamped.event, RunEnded) or (lines and not may_wait and not is_spoken)
        is_speaking = any(each.speaks for each in self._robots.values())
        has_time = self._has_room() and (may_wait or not is_speaking)
        before = self._summed_up() if ends or has_time else ()
        if may_wait and not self._has_room():
            _keep(robot, lines)
            return _Decision(stamped, before, passes=False)
        self._printed_at.extend([self._now()] * len(lines))
        robot.is_decided = robot.is_decided or may_wait
        return _Decision(stamped, before)

    def _has_room(self) -> bool:
        return len(self._printed_at) < MOST or self._now() - self._printed_at[0] >= SECOND

    def _summed_up(self) -> tuple[str, ...]:
        """The lines for what was left out."""
        lines: list[str] = []
        for name, robot in self._robots.items():
            omitted, robot.omitted = robot.omitted, _Omitted()
            if omitted.movements > 1:
                alone = "more-turns" if omitted.turns else "more-steps"
                code = "more-moves" if omitted.turns and omitted.steps else alone
                sentence = self._say(code, steps=omitted.steps, turns=omitted.turns)
                lines.append(with_robot_name(name, sentence, self._say))
            else:
                lines += omitted.only
            lines += omitted.place
        self._printed_at.extend([self._now()] * len(lines))
        return tuple(lines)


def _is_routine(stamped: Stamped, robot: _Robot) -> bool:
    """Whether the event only confirms the last movement or its end place."""
    is_of_movement = isinstance(stamped.event, Announced) and stamped.event.code in _MOVEMENTS
    return is_of_movement and robot.last is not None and robot.last.stopped_by is None


def _keep(robot: _Robot, lines: tuple[str, ...]) -> None:
    """Adds the lines to what is summed up later."""
    omitted, movement = robot.omitted, robot.last
    if robot.is_decided:
        omitted.place = lines
        return
    robot.is_decided = True
    omitted.place = ()
    omitted.movements += 1
    omitted.only = lines
    if isinstance(movement, Moved):
        omitted.steps += movement.walked
    else:
        omitted.turns += 1


class TranscriptLog:
    """Writes every printed line of the stream to a file.

    A full disk ends the log and nothing else; ``on_failure`` is called once.
    """

    def __init__(
        self, out: TextIO, wording: Wording, on_failure: Callable[[OSError], None] | None = None
    ) -> None:
        self._file = LineFile(out, on_failure)
        self._wording = wording

    def __call__(self, stamped: Stamped) -> None:
        lines = printed_lines(stamped, self._wording)
        if lines and self._file.takes_more:
            self._file.write("".join(f"{line}\n" for line in lines))


def next_log(folder: Path) -> Path:
    """The first free name after all used ones: ``log_001.txt``, ``log_002.txt``."""
    numbers = [re.fullmatch(r"log_(\d{1,9})\.txt", each.name) for each in folder.iterdir()]
    highest = max((int(each[1]) for each in numbers if each), default=0)
    return folder / f"log_{highest + 1:03}.txt"
