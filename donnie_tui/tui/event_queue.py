"""The queue of events from the program's thread to the screen's.

The program never waits for the screen. The queue is bounded, so a program that speaks without end costs no
memory; lines that did not fit are counted. One message at a time is under way, so Textual's own queue never
fills. Nothing here touches a widget.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from msgspec import Struct, field
from textual.message import Message
from textual.timer import Timer

from devices.ports.robot import Bearing, Pose, StoppedBy
from donnie_tui.core.events import (
    Announced,
    Answered,
    BeltShown,
    Driven,
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
from donnie_tui.tui.widgets.rows import MOST_LINES

MOST_POSES = 5_000
MOST_MEASURED = 100
"""Readings that are kept between two batches."""
MOST_LOOKS = 50


FRAME = 1 / 20
"""Seconds between two batches, which limits how often the map moves."""
CALM = 1 / 2
"""As ``FRAME``, with reduced motion: whole squares, at most twice a second."""
FLUSH = 1 / 5
"""Seconds between two writes into the log."""


class LogLine(NamedTuple):
    """One line of the log, and what kind of thing it is about (``kind-...`` in the catalogue)."""

    text: str
    kind: str
    is_repeated: bool = False
    """Whether it repeats an earlier answer, which LAST does not count again."""


class EventBatch(Struct):
    """The events since the queue was last emptied."""

    lines: deque[LogLine] = field(default_factory=lambda: deque(maxlen=MOST_LINES))
    missed: int = 0
    """Lines that did not fit."""
    poses: deque[Pose] = field(default_factory=lambda: deque(maxlen=MOST_POSES))
    readings: dict[tuple[str, str], Read] = field(default_factory=dict)
    """The last reading of each sensor that was read, by the sensor and what it was asked."""
    belt: tuple[int, ...] | None = None
    looks: deque[Read | Scanned] = field(default_factory=lambda: deque(maxlen=MOST_LOOKS))
    """The rays of sensors since the robot's last move."""
    others: dict[str, Pose] = field(default_factory=dict)
    """Where the other robots are now."""
    things: tuple[PlacedThing, ...] | None = None
    """The things that are not at their start; None if nothing has moved since."""
    distances: Mapping[Bearing, int] | None = None
    """The current distances; None if they are unchanged."""
    measured: deque[Read] = field(default_factory=lambda: deque(maxlen=MOST_MEASURED))
    """All readings in order; of very many the newest."""

    @property
    def wakes(self) -> bool:
        """Whether the screen has to show something now. Levels of the belt wait for the next event."""
        moved = self.poses or self.others or self.things is not None
        sensed = self.readings or self.looks or self.distances is not None
        return bool(self.lines or moved or sensed)


class EventsQueued(Message):
    """Posted when events wait; a second message adds nothing."""

    def can_replace(self, message: Message) -> bool:
        return isinstance(message, EventsQueued)


class RunBegan(Message):
    """A run began with the robot at this pose; ``fresh``: at its start, without a past."""

    def __init__(self, pose: Pose, *, fresh: bool = False) -> None:
        super().__init__()
        self.pose = pose
        self.fresh = fresh


class RunFinished(Message):
    """A run ended, of ``robot`` if there are several; ``errors`` are its mistakes."""

    def __init__(self, event: RunEnded, errors: tuple[Error, ...], robot: str | None = None) -> None:
        super().__init__()
        self.event = event
        self.errors = errors
        self.robot = robot

    @property
    def asks_to_quit(self) -> bool:
        """Whether the run reached a QUIT that is allowed."""
        return self.event.outcome is Outcome.QUIT


class EventQueue:
    """A listener of the hub. ``post`` may be called from any thread."""

    def __init__(
        self,
        post: Callable[[Message], object],
        wording: Wording,
        pose: Callable[[], Pose],
        name: Callable[[], str] = str,
    ) -> None:
        """``pose`` and ``name`` return those of the current robot."""
        self._post = post
        self._wording = wording
        self._pose = pose
        self._name = name
        self._lock = threading.Lock()
        self._waiting = EventBatch()
        self._sensed: Mapping[Bearing, int] = {}
        """The distances that the screen has or will get."""
        self._errors: deque[Error] = deque(maxlen=100)
        self._stopped_by: dict[str | None, StoppedBy | None] = {}
        """What cut the last movement of each robot short."""
        self._awake = False
        self._is_beginning = False
        """Whether a run has begun that the screen does not show yet."""

    def __call__(self, stamped: Stamped) -> None:
        """Called by the stream, in the thread that published."""
        event = stamped.event
        if isinstance(event, Pointed):
            return
        if isinstance(event, (Moved, Turned)):
            self._stopped_by[stamped.robot] = event.stopped_by
        is_chosen = stamped.robot is None or stamped.robot == self._name()
        self._remember(event) if is_chosen else self._remember_other(stamped.robot or "", event)
        kind, is_repeated = self._kind(stamped), isinstance(event, Answered) and event.is_repeated
        lines = tuple(LogLine(text, kind, is_repeated) for text in printed_lines(stamped, self._wording))
        with self._lock:
            self._waiting.missed += max(0, len(self._waiting.lines) + len(lines) - MOST_LINES)
            self._waiting.lines.extend(lines)
        self._wake(event, stamped.robot, is_chosen)

    def _remember(self, event: Event) -> None:
        with self._lock:
            waiting = self._waiting
            match event:
                case Passing(pose=pose) | Moved(pose=pose) | Turned(pose=pose) | Driven(pose=pose):
                    waiting.poses.append(pose)
                    waiting.looks.clear()  # the rays of the place before
                case Read(sensor=sensor, argument=argument):
                    waiting.readings[sensor, argument] = event
                    waiting.measured.append(event)
                    waiting.looks.append(event)
                case Scanned():
                    waiting.looks.append(event)
                case BeltShown(levels=levels):
                    waiting.belt = levels
                case ThingsMoved(places=places):
                    waiting.things = places
                case Sensed(distances=distances) if distances != self._sensed:
                    waiting.distances = self._sensed = distances
                case Error():
                    self._errors.append(event)
                case _:
                    pass

    def _remember_other(self, name: str, event: Event) -> None:
        with self._lock:
            match event:
                case Passing(pose=pose) | Moved(pose=pose) | Turned(pose=pose) | RunEnded(pose=pose):
                    self._waiting.others[name] = pose
                case Driven(pose=pose) | Reset(pose=pose):
                    self._waiting.others[name] = pose
                case ThingsMoved(places=places):
                    self._waiting.things = places
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

    def _wake(self, event: Event, robot: str | None, is_chosen: bool) -> None:
        match event:
            case RunStarted(how=how) if is_chosen:
                self._is_beginning = True
                self._post(RunBegan(self._pose(), fresh=how is not None and how.begins_anew))
            case RunEnded():
                self._post(RunFinished(event, self._taken_errors() if is_chosen else (), robot))
                if not is_chosen:
                    self._call()
            case _:
                self._call()

    def _call(self) -> None:
        with self._lock:
            if self._awake or not self._waiting.wakes:
                return
            self._awake = True
        self._post(EventsQueued())

    def _taken_errors(self) -> tuple[Error, ...]:
        with self._lock:
            errors = tuple(self._errors)
            self._errors.clear()
        return errors

    def begun(self) -> None:
        """Release the events of a run whose beginning the screen shows. In the screen's thread."""
        self._is_beginning = False

    def take(self) -> EventBatch:
        """Empty the queue, in the screen's thread. The events of a run wait until its beginning is shown."""
        with self._lock:
            if self._is_beginning:
                return EventBatch()
            batch, self._waiting, self._awake = self._waiting, EventBatch(), False
        return batch


class EventReader:
    """Empties the queue in the screen's thread, at a limited rate."""

    def __init__(
        self,
        queue: EventQueue,
        words: Wording,
        *,
        set_timer: Callable[[float, Callable[[], None]], Timer],
        receive: Callable[[EventBatch], None],
        write: Callable[[Sequence[LogLine]], None],
    ) -> None:
        """``receive`` gets all events at once, ``write`` the lines for the log in larger pieces."""
        self.frame = FRAME
        self._queue = queue
        self._words = words
        self._set_timer = set_timer
        self._receive = receive
        self._write = write
        self._lines: list[LogLine] = []
        self.taken_at = self._written_at = -FLUSH
        """When the queue was emptied last, by the monotonic clock."""
        self._taking: Timer | None = None
        self._writing: Timer | None = None

    def on_queued(self) -> None:
        """Take waiting events now, or at the next allowed moment."""
        due = self.taken_at + self.frame - time.monotonic()
        if due <= 0:
            self.take()
        elif self._taking is None:
            self._taking = self._set_timer(due, self.take)

    def begun(self) -> None:
        """Take the events of a run whose beginning is shown now."""
        self._queue.begun()
        self.take()

    def take(self) -> None:
        """Empty the queue now."""
        if self._taking is not None:
            self._taking.stop()
            self._taking = None
        self.taken_at = time.monotonic()
        batch = self._queue.take()
        if batch.missed:
            self._lines.append(LogLine(self._words("answer-left-out", lines=batch.missed), "answer"))
        self._lines.extend(batch.lines)
        self._receive(batch)
        self._write_soon()

    def flush(self) -> None:
        """Take all events and write the log now."""
        self.take()
        self.write()

    def _write_soon(self) -> None:
        if not self._lines or self._writing is not None:
            return
        due = self._written_at + FLUSH - time.monotonic()
        if due > 0:
            self._writing = self._set_timer(due, self.write)
        else:
            self.write()

    def write(self) -> None:
        """Write the log now."""
        if self._writing is not None:
            self._writing.stop()
            self._writing = None
        self._written_at = time.monotonic()
        lines, self._lines = self._lines, []
        self._write(lines)
