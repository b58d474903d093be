"""The events: everything that happens, as values. Names and fields are a contract (scripts rely on them).

The transient ones are the exception, neither numbered nor recorded: ``Passing`` and ``Sensed``, where the
robot is just now and what is around it, are for a living picture and depend on the clock of the machine; the
others are about the front end.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from enum import Enum

from devices.ports.hints import ClassVar, TypeAlias
from devices.ports.robot import Bearing, Grip, Met, Pose, Pushed, StoppedBy
from devices.ports.values import Frozen, field


class Outcome(Enum):
    """How a run ended."""

    COMPLETED = "completed"
    FAILED = "failed"
    STOPPED = "stopped"
    QUIT = "quit"


class HowStarted(Frozen):
    """A run as it was asked for: its text, and from where it goes on."""

    text: str
    first_line: int
    fresh: bool
    """Whether the robot is put back to its start first and the variables are forgotten."""
    terminal: bool
    trace: bool
    pose: Pose
    """Where the robot stands as it begins."""
    language: str = "en"
    detail: str = "normal"
    named: bool = False
    """Whether the world has several robots, so that events say whose they are."""
    together: tuple[str, ...] = ()
    """The robots that started at the same moment, this one among them; empty for one alone."""
    deed: str = ""
    """What the gripper did in place of a program, ``GRIP`` or ``RELEASE``; else empty."""
    refused: bool = False
    """Whether mistakes of form keep it from running."""

    @property
    def is_together(self) -> bool:
        """Whether several robots start at the same moment."""
        return len(self.together) > 1

    @property
    def begins_anew(self) -> bool:
        """Whether the robot is at its start, without a past; not for what is refused, if it is alone."""
        return self.fresh and (self.is_together or not self.refused)


TYPED = "typed"
"""What a program is called that was typed and has no file."""


class RunStarted(Frozen):
    program: str
    world: str
    robot: str
    seed: int
    version: str
    how: HowStarted | None = field(default=None, metadata={"private": True})
    """What is needed to run it again."""


class Statement(Frozen):
    """A statement is about to run; only with ``--trace``."""

    line: int
    column: int
    depth: int


class Spoke(Frozen):
    text: str


class Announced(Frozen):
    """A sentence of Donnie's own. ``code`` says what it is about, ``text`` is in the learner's language."""

    code: str
    text: str


class Moved(Frozen):
    """``asked`` and ``walked`` in steps, forward or backward as ``command`` says."""

    command: str
    asked: int
    walked: int
    stopped_by: StoppedBy | None
    pose: Pose
    forward: bool = field(metadata={"private": True})
    met: Met | None = field(default=None, metadata={"private": True})
    """What stopped it, where that is known."""
    pushed: tuple[Pushed, ...] = field(default=(), metadata={"private": True})


class Turned(Frozen):
    """``asked`` and ``turned`` in degrees, in the direction of the command."""

    command: str
    asked: int
    turned: int
    stopped_by: StoppedBy | None
    pose: Pose
    right: bool = field(metadata={"private": True})
    """Whether the command was a turn to the right."""
    met: Met | None = field(default=None, metadata={"private": True})
    pushed: tuple[Pushed, ...] = field(default=(), metadata={"private": True})


class SeenGroup(Frozen):
    """Things that SCAN sees at one angle."""

    side: str
    """``left``, ``right`` or ``ahead``."""
    degrees: int
    steps: int
    colours: tuple[str, ...]


class Scanned(Frozen):
    objects: tuple[SeenGroup, ...]


class Read(Frozen):
    """A sensor was read: ``distance``, ``position`` or ``colour``."""

    sensor: str
    argument: str
    value: int


class Waited(Frozen):
    seconds: int


class CueSounded(Frozen):
    EVENT: ClassVar[str] = "cue"
    name: str
    bearing: float
    steps: float | None


class BeltShown(Frozen):
    """14 levels, 0 off to 3 strong: the upper row of seven, then the lower."""

    EVENT: ClassVar[str] = "belt"
    levels: tuple[int, ...]


class GripperUsed(Frozen):
    """The gripper closed or opened; ``thing`` is the name of what it took or let go, where that has one."""

    EVENT: ClassVar[str] = "gripper"
    outcome: Grip
    thing: str
    kind: str = field(default="", metadata={"private": True})
    """What it is in its world, and its colour."""
    colour: str = field(default="", metadata={"private": True})


class PlacedThing(Frozen):
    """Where a thing of the world is now, with what the world's file calls it."""

    name: str
    pose: Pose
    index: int = field(default=0, metadata={"private": True})
    """Its number among the world's models; names may be equal."""


class ThingsMoved(Frozen):
    """All things that are elsewhere than at the start of the world: pushed, held, or put down again."""

    EVENT: ClassVar[str] = "things"
    places: tuple[PlacedThing, ...]


class Reset(Frozen):
    """The robot was put back to its start, and what it remembered is gone."""

    pose: Pose


class SoundSwitched(Frozen):
    EVENT: ClassVar[str] = "sound"
    on: bool


class Link(Frozen):
    """The line to a real robot: ``connected``, ``lost`` or ``restored``."""

    state: str
    reason: str


BELT_LINK = "belt-link"
"""The code of what is announced when the belt is lost or back, while a program runs or not."""

INTERNAL = "internal"
"""The kind of an error that is no mistake of the program: a fault of ours. The others are the language's."""


class Error(Frozen):
    """A mistake in the program. ``source_line`` is the line as typed, for those who print the error."""

    kind: str
    line: int
    column: int
    message: str
    hint: str | None
    source_line: str = field(default="", metadata={"private": True})
    calls: tuple[int, ...] = field(default=(), metadata={"private": True})
    """The lines of the calls that led there, innermost first."""
    code: str = field(default="", metadata={"private": True})
    """Which of the mistakes of its kind it is, where that is known."""
    meant: str = field(default="", metadata={"private": True})
    """What was probably meant."""
    topic: str = field(default="", metadata={"private": True})
    """The command that it is about, as the canonical word of its help."""
    mended_line: int = field(default=0, metadata={"private": True})
    """The line to change, where that is another than the one in which it was found."""


class RunEnded(Frozen):
    outcome: Outcome
    pose: Pose
    variables: Mapping[str, int]
    seconds: float


class Passing(Frozen):
    """Where the robot is while it moves; transient."""

    pose: Pose


class Sensed(Frozen):
    """What is known of the distances around the robot, in steps, told because somebody looks; transient."""

    distances: Mapping[Bearing, int]


class Answered(Frozen):
    """What a front end answers to a word of its own, such as "Saved."; told and spoken; transient."""

    text: str
    in_print_only: bool = False
    """The answer to QUIET is not said."""
    at_once: bool = False
    """To a word that was typed while a program runs: printed before what waits to be printed."""


class Pointed(Frozen):
    """What is where somebody points on the map; shown in the status line and spoken, not kept; transient."""

    text: str


class Chimed(Frozen):
    """A cue of a front end's own, such as that a block was opened; fields as of ``CueSounded``; transient."""

    name: str
    bearing: float = 0.0
    steps: float | None = None


TRANSIENT = (Passing, Sensed, Answered, Pointed, Chimed)

Event: TypeAlias = (
    RunStarted
    | Statement
    | Spoke
    | Announced
    | Moved
    | Turned
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
    | Passing
    | Sensed
    | Answered
    | Pointed
    | Chimed
)


class Stamped(Frozen):
    """An event with its number (from 1, 0 for a transient one) and its robot time in seconds."""

    seq: int
    t: float
    event: Event
    robot: str | None = None
    """The robot's name where a world has several."""


def event_name(event: Event | type[Event]) -> str:
    """The name of an event, or of a kind of events, in the stream, such as ``run_started``."""
    kind = event if isinstance(event, type) else type(event)
    given: str | None = getattr(kind, "EVENT", None)
    return given or re.sub(r"(?<!^)(?=[A-Z])", "_", kind.__name__).lower()


def as_record(stamped: Stamped, *, whole: bool = False) -> dict[str, object]:
    """The event as the stream writes it: the common fields first, then its own.

    ``whole``: also what the stream does not tell, so that the event can be made again from it.
    """
    record: dict[str, object] = {
        "seq": stamped.seq,
        "t": _plain(stamped.t, whole),
        "event": event_name(stamped.event),
    }
    if stamped.robot is not None:
        record["robot"] = stamped.robot
    return record | _fields(stamped.event, whole)


def _fields(value: object, whole: bool) -> dict[str, object]:
    import dataclasses  # slow to load, and few write events

    return {
        each.name: _plain(getattr(value, each.name), whole)
        for each in dataclasses.fields(value)  # type: ignore[arg-type] # only given dataclasses
        if whole or not each.metadata.get("private")
    }


def _plain(value: object, whole: bool) -> object:
    """Values as JSON has them. Numbers are rounded so far that no float shows its last digits."""
    match value:
        case float():
            return round(value, 6) + 0.0
        case Enum():
            return value.value
        case Mapping():
            return {key: _plain(each, whole) for key, each in value.items()}
        case tuple():
            return [_plain(each, whole) for each in value]
        case Pose() | Met() | Pushed() | SeenGroup() | PlacedThing() | HowStarted():
            return _fields(value, whole)
        case _:
            return value
