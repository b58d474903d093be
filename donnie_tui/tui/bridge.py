"""From the program's thread to the screen: what happened is put into a mailbox, and the screen is woken.

Rules: the program never waits for the screen; the mailbox is bounded, so a program that talks without end
costs no memory (what did not fit is counted); one message at a time is under way, so the screen's own queue
never fills. Nothing here touches a widget.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Mapping
from typing import NamedTuple

from msgspec import Struct
from textual.message import Message

from devices.ports.robot import Bearing, Pose, StoppedBy
from donnie_tui.core.events import (
    Announced,
    Answered,
    BeltShown,
    Error,
    Event,
    Moved,
    Outcome,
    Passing,
    PlacedThing,
    Pointed,
    Read,
    Reset,
    RunEnded,
    RunStarted,
    Scanned,
    Sensed,
    Spoke,
    Stamped,
    ThingsMoved,
    Turned,
)
from donnie_tui.core.transcript import printed_lines
from donnie_tui.core.wording import Wording

MOST_LINES = 100_000
"""Lines that wait for the screen at most: as many as the log keeps, so that it misses none it could show."""
MOST_POSES = 5_000
MOST_LOOKS = 50


class LogLine(NamedTuple):
    """One line of the log, and what kind of thing it is about (``kind-...`` in the catalogue)."""

    text: str
    kind: str
    is_repeated: bool = False
    """Whether it was said before: LAST does not count it again."""


class Mail(Struct, frozen=True):
    """What happened since the last look."""

    lines: tuple[LogLine, ...]
    missed: int
    """Lines that did not fit."""
    poses: tuple[Pose, ...]
    readings: tuple[Read, ...]
    """The last reading of each sensor that was read."""
    belt: tuple[int, ...] | None
    looks: tuple[Read | Scanned, ...] = ()
    """What sensors looked along since the robot moved last."""
    others: tuple[tuple[str, Pose], ...] = ()
    """Where the other robots are now."""
    things: tuple[PlacedThing, ...] | None = None
    """What is elsewhere than at the start of the world; None if nothing was moved since."""
    distances: Mapping[Bearing, int] | None = None
    """What is known of them now; None if that is what it was."""


NO_MAIL = Mail((), 0, (), (), None)


class Happened(Message):
    """There is mail. Two of them are as good as one."""

    def can_replace(self, message: Message) -> bool:
        return isinstance(message, Happened)


class Began(Message):
    """A run began, with the robot here; ``fresh``: at its start, without a past."""

    def __init__(self, program: str, pose: Pose, *, fresh: bool = False) -> None:
        super().__init__()
        self.program = program
        self.pose = pose
        self.fresh = fresh


class Ended(Message):
    """A run of ``robot`` ended, where there are several; ``errors`` are its mistakes."""

    def __init__(self, event: RunEnded, errors: tuple[Error, ...], robot: str | None = None) -> None:
        super().__init__()
        self.event = event
        self.errors = errors
        self.robot = robot

    @property
    def asks_to_quit(self) -> bool:
        """Whether QUIT was reached where it is allowed."""
        return self.event.outcome is Outcome.QUIT


class Bridge:
    """A listener of the hub. ``post`` may be called from any thread."""

    def __init__(
        self,
        post: Callable[[Message], object],
        wording: Wording,
        pose: Callable[[], Pose],
        own: Callable[[], str] = str,
    ) -> None:
        """``pose`` and ``own`` tell where the robot is that is talked to, and its name."""
        self._post = post
        self._wording = wording
        self._pose = pose
        self._own = own
        self._lock = threading.Lock()
        self._lines: deque[LogLine] = deque(maxlen=MOST_LINES)
        self._missed = 0
        self._poses: deque[Pose] = deque(maxlen=MOST_POSES)
        self._readings: dict[tuple[str, str], Read] = {}
        self._belt: tuple[int, ...] | None = None
        self._looks: deque[Read | Scanned] = deque(maxlen=MOST_LOOKS)
        self._others: dict[str, Pose] = {}
        self._things: tuple[PlacedThing, ...] | None = None
        self._distances: Mapping[Bearing, int] | None = None
        self._sensed: Mapping[Bearing, int] = {}
        """What the screen knows of them, or is to know."""
        self._errors: deque[Error] = deque(maxlen=100)
        self._stopped_by: dict[str | None, StoppedBy | None] = {}
        """What ended the last movement of each robot before its end."""
        self._awake = False
        self._is_beginning = False
        """Whether a run has begun that the screen has not begun yet."""

    def __call__(self, stamped: Stamped) -> None:
        """Told by the stream, in the thread that published."""
        event = stamped.event
        if isinstance(event, Pointed):
            return
        if isinstance(event, (Moved, Turned)):
            self._stopped_by[stamped.robot] = event.stopped_by
        is_own = stamped.robot is None or stamped.robot == self._own()
        self._remember(event) if is_own else self._remember_other(stamped.robot or "", event)
        kind, is_repeated = self._kind(stamped), isinstance(event, Answered) and event.is_repeated
        lines = tuple(LogLine(text, kind, is_repeated) for text in printed_lines(stamped, self._wording))
        with self._lock:
            self._missed += max(0, len(self._lines) + len(lines) - MOST_LINES)
            self._lines.extend(lines)
        self._wake(event, stamped.robot, is_own)

    def _remember(self, event: Event) -> None:
        with self._lock:
            match event:
                case Passing(pose=pose):
                    self._go_to(pose)
                case Moved(pose=pose) | Turned(pose=pose):
                    self._go_to(pose)
                case Read(sensor=sensor, argument=argument):
                    self._readings[sensor, argument] = event
                    self._looks.append(event)
                case Scanned():
                    self._looks.append(event)
                case BeltShown(levels=levels):
                    self._belt = levels
                case ThingsMoved(places=places):
                    self._things = places
                case Sensed(distances=distances) if distances != self._sensed:
                    self._distances = self._sensed = distances
                case Error():
                    self._errors.append(event)
                case _:
                    pass

    def _go_to(self, pose: Pose) -> None:
        """What was looked along before is not shown from there."""
        self._poses.append(pose)
        self._looks.clear()

    def _remember_other(self, name: str, event: Event) -> None:
        with self._lock:
            match event:
                case Passing(pose=pose) | Moved(pose=pose) | Turned(pose=pose) | RunEnded(pose=pose):
                    self._others[name] = pose
                case Reset(pose=pose):
                    self._others[name] = pose
                case ThingsMoved(places=places):
                    self._things = places
                case _:
                    pass

    def _kind(self, stamped: Stamped) -> str:
        stopped_by = self._stopped_by.get(stamped.robot)
        match stamped.event:
            case Spoke():
                return "spoke"
            case Error():
                return "error"
            case Answered():
                return "answer"
            case Announced(code="moved" | "turned") if stopped_by is not None:
                return stopped_by.value
            case Announced(code=code):
                return code
            case _:
                return ""

    def _wake(self, event: Event, robot: str | None, is_own: bool) -> None:
        match event:
            case RunStarted(program=program, how=how) if is_own:
                self._is_beginning = True
                self._post(Began(program, self._pose(), fresh=how is not None and how.begins_anew))
            case RunEnded() if is_own:
                self._post(Ended(event, self._taken_errors(), robot))
            case _:
                self._call()

    def _call(self) -> None:
        with self._lock:
            if self._awake or not self._has_mail:
                return
            self._awake = True
        self._post(Happened())

    @property
    def _has_mail(self) -> bool:
        moved = self._poses or self._others or self._things is not None
        sensed = self._readings or self._looks or self._distances is not None
        return bool(self._lines or moved or sensed)

    def _taken_errors(self) -> tuple[Error, ...]:
        with self._lock:
            errors = tuple(self._errors)
            self._errors.clear()
        return errors

    def begun(self) -> None:
        """The screen shows the beginning of the run: what is in the mailbox may follow. In its thread."""
        self._is_beginning = False

    def take(self) -> Mail:
        """Empty the mailbox: for the screen, in its thread. What happens in a run waits for its beginning."""
        with self._lock:
            if self._is_beginning:
                return NO_MAIL
            readings = tuple(self._readings.values())
            mail = Mail(
                tuple(self._lines),
                self._missed,
                tuple(self._poses),
                readings,
                self._belt,
                tuple(self._looks),
                tuple(self._others.items()),
                self._things,
                self._distances,
            )
            self._lines.clear()
            self._poses.clear()
            self._readings.clear()
            self._looks.clear()
            self._others.clear()
            self._things = self._distances = None
            self._missed, self._belt, self._awake = 0, None, False
        return mail
