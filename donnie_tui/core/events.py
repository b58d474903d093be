"""Events: everything that happens, as values, and as JSON lines for scripts (``--events``).

Names and fields are a contract, since scripts rely on them. Transient events are the exception: they are
neither numbered nor recorded. ``Passing`` and ``Sensed`` depend on the machine's clock and are for a moving
picture; the others are about the front end.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from enum import Enum
from typing import ClassVar, TextIO, TypeAlias

from msgspec import Struct, field

from devices.ports.robot import Bearing, Grip, Met, Pose, Pushed, StoppedBy


def _name(kind: str) -> str:
    """The name of a kind of events in the stream: ``RunStarted`` is ``run_started``."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", kind).lower()


class _Event(Struct, frozen=True, tag_field="event", tag=_name):
    """An event; its name is in the field ``event`` of the stream."""


class Outcome(Enum):
    """How a run ended."""

    COMPLETED = "completed"
    FAILED = "failed"
    STOPPED = "stopped"
    QUIT = "quit"


class HowStarted(Struct, frozen=True):
    """The request that began a run: its text, and where it starts."""

    text: str
    first_line: int
    fresh: bool
    """Whether the robot is put back to its start first and the variables are forgotten."""
    terminal: bool
    trace: bool
    pose: Pose
    """Where the robot is when the run begins."""
    language: str = "en"
    detail: str = "normal"
    named: bool = False
    """Whether the world has several robots, so that events say whose they are."""
    together: tuple[str, ...] = ()
    """The robots that started at the same moment, this one among them; empty for one alone."""
    refused: bool = False
    """Whether mistakes of form prevent the run."""

    @property
    def is_together(self) -> bool:
        """Whether several robots start at the same moment."""
        return len(self.together) > 1

    @property
    def begins_anew(self) -> bool:
        """Whether the robot is at its start, without a past; not for what is refused, if it is alone."""
        return self.fresh and (self.is_together or not self.refused)


TYPED = "typed"
"""The name of a program that was typed and has no file."""


class RunStarted(_Event, frozen=True):
    PRIVATE: ClassVar[tuple[str, ...]] = ("how",)
    program: str
    world: str
    robot: str
    seed: int
    version: str
    how: HowStarted | None = None
    """What is needed to run it again."""


class Statement(_Event, frozen=True):
    """A statement is about to run; only with ``--trace``."""

    line: int
    column: int
    depth: int


class Spoke(_Event, frozen=True):
    text: str


class Announced(_Event, frozen=True):
    """A sentence from Donnie. ``code`` is its subject, ``text`` is in the learner's language."""

    code: str
    text: str


class Moved(_Event, frozen=True):
    """``asked`` and ``walked`` in steps, forward or backward as ``command`` says."""

    OPTIONAL: ClassVar[tuple[str, ...]] = ("true_pose",)
    PRIVATE: ClassVar[tuple[str, ...]] = ("forward", "met", "pushed")
    command: str
    asked: int
    walked: int
    stopped_by: StoppedBy | None
    pose: Pose
    forward: bool
    met: Met | None = None
    """What stopped it, where that is known."""
    pushed: tuple[Pushed, ...] = ()
    true_pose: Pose | None = None
    """Where the robot is, if its odometry has errors: ``pose`` is then where it believes it is."""


class Turned(_Event, frozen=True):
    """``asked`` and ``turned`` in degrees, in the direction of the command."""

    OPTIONAL: ClassVar[tuple[str, ...]] = ("true_pose",)
    PRIVATE: ClassVar[tuple[str, ...]] = ("right", "met", "pushed")
    command: str
    asked: int
    turned: int
    stopped_by: StoppedBy | None
    pose: Pose
    right: bool
    """Whether the command was a turn to the right."""
    met: Met | None = None
    pushed: tuple[Pushed, ...] = ()
    true_pose: Pose | None = None
    """Where the robot is, if its odometry has errors: ``pose`` is then where it believes it is."""


STANDING = "standing"


class Driven(_Event, frozen=True):
    """A client of Player drives the robot so from here on: ``forward``, ``backward-left``, ``right``, ...

    Also once a second while it drives on.
    """

    motion: str
    pose: Pose


class SeenGroup(Struct, frozen=True):
    """Things that SCAN sees at one angle."""

    side: str
    """``left``, ``right`` or ``ahead``."""
    degrees: int
    steps: int
    colours: tuple[str, ...]


class SeenMark(Struct, frozen=True):
    """A fiducial mark that SCAN sees. ``number`` is None if it is too far away to be read."""

    number: int | None
    side: str
    degrees: int
    steps: int


class Scanned(_Event, frozen=True):
    objects: tuple[SeenGroup, ...]
    marks: tuple[SeenMark, ...] = ()


class Read(_Event, frozen=True):
    """A sensor was read: ``distance``, ``position`` or ``colour``."""

    sensor: str
    argument: str
    value: int


class Waited(_Event, frozen=True):
    seconds: int


class CueSounded(_Event, frozen=True, tag="cue"):
    name: str
    bearing: float
    steps: float | None


class BeltShown(_Event, frozen=True, tag="belt"):
    """14 levels, 0 off to 3 strong: the upper row of seven, then the lower."""

    levels: tuple[int, ...]


class GripperUsed(_Event, frozen=True, tag="gripper"):
    """The gripper closed or opened; ``thing`` is the name of what it took or let go, where that has one."""

    PRIVATE: ClassVar[tuple[str, ...]] = ("kind", "colour")
    outcome: Grip
    thing: str
    kind: str = ""
    """What it is in its world, and its colour."""
    colour: str = ""


class PlacedThing(Struct, frozen=True):
    """Where a thing of the world is now, with what the world's file calls it."""

    PRIVATE: ClassVar[tuple[str, ...]] = ("index",)
    name: str
    pose: Pose
    index: int = 0
    """Its number among the world's models; names may be equal."""


class ThingsMoved(_Event, frozen=True, tag="things"):
    """All things that are not at their start: pushed, held, or put down again."""

    places: tuple[PlacedThing, ...]


class Reset(_Event, frozen=True):
    """The robot was put back to its start, with its memory cleared."""

    pose: Pose


class SoundSwitched(_Event, frozen=True, tag="sound"):
    on: bool


class Link(_Event, frozen=True):
    """What happened to the connection to a real robot."""

    state: str
    """The value of a ``LinkNotice``."""
    reason: str
    """The port, the system's own words or volts; empty where nothing more is known."""


BELT_LINK = "belt-link"
"""The code of the announcement that the belt's connection was lost or restored, during a run or not."""

INTERNAL = "internal"
"""The kind of an internal error of Donnie. All other kinds are the language's."""


class Error(_Event, frozen=True):
    """A mistake in the program. ``source_line`` is the line as typed, for front ends that print it."""

    PRIVATE: ClassVar[tuple[str, ...]] = ("source_line", "calls", "code", "meant", "topic", "fixed_line")
    kind: str
    line: int
    column: int
    message: str
    hint: str | None
    source_line: str = ""
    calls: tuple[int, ...] = ()
    """The lines of the calls that led there, innermost first."""
    code: str = ""
    """Which of the mistakes of its kind it is, where that is known."""
    meant: str = ""
    """What was probably meant."""
    topic: str = ""
    """The command that it is about, as the canonical word of its help."""
    fixed_line: int = field(default=0, name="mended_line")
    """The line to change, where it differs from the one in which the mistake was found."""


class RunEnded(_Event, frozen=True):
    OPTIONAL: ClassVar[tuple[str, ...]] = ("true_pose",)
    outcome: Outcome
    pose: Pose
    variables: Mapping[str, int]
    seconds: float
    true_pose: Pose | None = None
    """As in ``Moved``."""


class Passing(_Event, frozen=True):
    """Where the robot is while it moves; transient."""

    pose: Pose


class Sensed(_Event, frozen=True):
    """The known distances around the robot, in steps; published on request of a screen; transient."""

    distances: Mapping[Bearing, int]


class Answered(_Event, frozen=True):
    """A front end's answer to its own commands, such as "Saved."; printed and spoken; transient."""

    text: str
    in_print_only: bool = False
    """Whether the answer is printed and not spoken, as that to QUIET."""
    at_once: bool = False
    """Whether it answers a command typed during a run: it is printed before lines that wait."""
    is_repeated: bool = False
    """Whether it repeats an earlier answer, which is not stored again."""


class Pointed(_Event, frozen=True):
    """The content of the square under the pointer; for the status line and the voice, not kept; transient."""

    text: str


class Chimed(_Event, frozen=True):
    """A front end's own cue, such as for an opened block; fields as of ``CueSounded``; transient."""

    name: str
    bearing: float = 0.0
    steps: float | None = None


TRANSIENT = (Passing, Sensed, Answered, Pointed, Chimed)

RecordedEvent: TypeAlias = (
    RunStarted
    | Statement
    | Spoke
    | Announced
    | Moved
    | Turned
    | Driven
    | Scanned
    | Read
    | Waited
    | CueSounded
    | BeltShown
    | GripperUsed
    | ThingsMoved
    | Reset
    | SoundSwitched
    | Link
    | Error
    | RunEnded
)
Event: TypeAlias = RecordedEvent | Passing | Sensed | Answered | Pointed | Chimed


class Stamped(Struct, frozen=True):
    """An event with its number (from 1, 0 for a transient one) and its robot time in seconds."""

    seq: int
    t: float
    event: Event
    robot: str | None = None
    """The robot's name where a world has several."""


def pose_of(event: Event) -> Pose | None:
    """Where the robot is with it, if it says so."""
    if isinstance(event, RunStarted):
        return event.how.pose if event.how is not None else None
    return event.pose if isinstance(event, Moved | Turned | Driven | RunEnded | Reset) else None


def begins_anew(event: Event) -> bool:
    """Whether the robot is at its start with it, without a past."""
    return isinstance(event, Reset) or (
        isinstance(event, RunStarted) and event.how is not None and event.how.begins_anew
    )


def event_name(event: Event | type[Event]) -> str:
    """The name of an event, or of a kind of events, in the stream, such as ``run_started``."""
    return str(event.__struct_config__.tag)


def as_record(stamped: Stamped, *, whole: bool = False) -> dict[str, object]:
    """The event as a record of the stream: the common fields first, then its own.

    ``whole``: with the fields that the stream leaves out, so that the event can be rebuilt.
    """
    record: dict[str, object] = {
        "seq": stamped.seq,
        "t": _plain(stamped.t, whole),
        "event": event_name(stamped.event),
    }
    if stamped.robot is not None:
        record["robot"] = stamped.robot
    return record | _fields(stamped.event, whole)


def _fields(value: Struct, whole: bool) -> dict[str, object]:
    """The fields of an event, without private ones and optional ones that are None."""
    private = () if whole else getattr(value, "PRIVATE", ())
    absent = [name for name in getattr(value, "OPTIONAL", ()) if getattr(value, name) is None]
    names = zip(value.__struct_fields__, value.__struct_encode_fields__, strict=True)
    shown = ((name, key) for name, key in names if name not in private and name not in absent)
    return {key: _plain(getattr(value, name), whole) for name, key in shown}


def _plain(value: object, whole: bool) -> object:
    """Values as JSON has them. Numbers are rounded, so that no float shows its last digits."""
    match value:
        case float():
            return round(value, 6) + 0.0
        case Enum():
            return value.value
        case Mapping():
            return {key: _plain(each, whole) for key, each in value.items()}
        case tuple():
            return [_plain(each, whole) for each in value]
        case Struct():
            return _fields(value, whole)
        case _:
            return value


class LineFile:
    """Writes whole lines and flushes each time. The owner of ``out`` closes it."""

    def __init__(self, out: TextIO, on_failure: Callable[[OSError], None] | None = None) -> None:
        self._out = out
        self._on_failure = on_failure
        self._has_failed = False

    @property
    def takes_more(self) -> bool:
        return not (self._has_failed or self._out.closed)

    def write(self, lines: str) -> None:
        """Writes lines, unless an earlier writing failed."""
        try:
            self._out.write(lines)
            self._out.flush()
        except OSError as problem:
            self._has_failed = True
            if self._on_failure:
                self._on_failure(problem)


class JsonLines:
    """Writes every event that is not transient as one line of JSON.

    A stream that accepts no more lines ends the writing and nothing else; ``on_failure`` is called once.
    """

    def __init__(
        self, out: TextIO, on_failure: Callable[[OSError], None] | None = None, *, whole: bool = False
    ) -> None:
        """``whole``: the events can be rebuilt from the lines."""
        self._file = LineFile(out, on_failure)
        self._whole = whole

    def __call__(self, stamped: Stamped) -> None:
        if not isinstance(stamped.event, TRANSIENT) and self._file.takes_more:
            self._file.write(as_line(stamped, whole=self._whole))


def as_line(stamped: Stamped, *, whole: bool = False) -> str:
    """One line with its newline. Keys keep the order of the contract."""
    return json_line(as_record(stamped, whole=whole))


_UNSAFE = "[\x7f-\x9f\u061c\u200e\u200f\u2028\u2029\u202a-\u202e\u2066-\u2069]"
"""Characters that a terminal obeys, or that change the direction of text."""


def json_line(record: Mapping[str, object]) -> str:
    """One line with its newline, with escapes for all that a terminal would obey."""
    import json  # few sessions write events

    line = json.dumps(record, ensure_ascii=False, separators=(",", ":"))
    if not line.isprintable():
        line = re.sub(_UNSAFE, lambda found: f"\\u{ord(found[0]):04x}", line)
    return line + "\n"
