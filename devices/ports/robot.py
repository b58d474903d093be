"""What every robot can do, simulated or real, and the values that it returns.

Steps and degrees are the learner's units, and exist only at this border and above: a step is 0.05 m, and the
heading is a compass (0 north, 90 east, clockwise). The program's thread calls the methods of ``Robot``, and
they block until they are done. They return early, with ``StoppedBy.USER``, when the robot's pace says so. Any
thread may call ``pose``, ``time``, ``known_distances`` and ``halt``.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from typing import Protocol

from msgspec import Struct

NETWORK_SCHEMES = ("socket", "rfc2217")
"""How the address of a serial port on the network begins, before ``://``. The library knows others, which
write files or are for tests."""

STEP = 0.05
"""Metres in a step (the manual gives none; GoDonnie's specification fixes it)."""

CENTIMETRES_A_STEP = round(STEP * 100)

DEGREES_A_REPORT = 10
"""Degrees of a turn after which a robot reports its progress."""

FARTHEST = 60
"""Steps that a sensor reports when nothing is within its range (manual, section 8)."""


class Bearing(Enum):
    """The direction of a sensor, as a compass angle in degrees relative to the robot's front."""

    FRONT = 0
    FRONT_RIGHT = 45
    BACK_RIGHT = 135
    BACK = 180
    BACK_LEFT = 225
    FRONT_LEFT = 315

    __hash__ = object.__hash__  # an Enum's own takes the hash of its name anew each time

    @property
    def words(self) -> str:
        """Its name in events and problems: ``front right``."""
        return self.name.lower().replace("_", " ")


class StoppedBy(Enum):
    """Why a movement did less than was asked."""

    OBSTACLE = "obstacle"
    COLLISION = "collision"
    STALL = "stall"
    """A real robot's wheels don't turn although its motors are on."""
    WRONG_WAY = "wrong-way"
    """A real robot's wheels count against the sense of the movement: it is wired in another way."""
    RUNAWAY = "runaway"
    """A real robot's wheels turn after the end, although all was done to stop them."""
    LINK = "link"
    """The connection to a real robot was lost."""
    USER = "stopped"


class Motion(Enum):
    """The kind of movement that progress is reported of."""

    FORWARD = "forward"
    BACKWARD = "backward"
    RIGHT = "right"
    LEFT = "left"


class Pose(Struct, frozen=True):
    """A place and a direction: x steps to the east, y steps to the north, heading in compass degrees."""

    x: float
    y: float
    heading: float


class Met(Struct, frozen=True):
    """What the robot met in an obstacle or a collision, where it knows."""

    kind: str
    """Its kind in its world, such as ``chair``; ``wall`` for any wall, ``robot`` for another robot,
    ``something`` where the robot only felt it."""
    name: str
    """Its name in its world, or an empty string."""
    degrees: float
    """Its direction: from the robot's front, positive to the right, above -180 to 180."""


class Pushed(Struct, frozen=True):
    """A thing that a movement pushed along."""

    kind: str
    """Its kind in its world, such as ``cone``."""
    name: str
    """Its name in its world, or an empty string."""
    colour: str
    """An English colour word of the language."""
    steps: float


class WalkResult(Struct, frozen=True):
    """A finished walk. ``asked`` and ``walked`` are whole steps, in the direction of the command."""

    asked: int
    walked: int
    stopped_by: StoppedBy | None
    pose: Pose
    met: Met | None = None
    pushed: tuple[Pushed, ...] = ()
    """In the order in which they were met."""


class TurnResult(Struct, frozen=True):
    """A finished turn. ``asked`` and ``turned`` are whole degrees, positive to the right."""

    asked: int
    turned: int
    stopped_by: StoppedBy | None
    pose: Pose
    met: Met | None = None
    pushed: tuple[Pushed, ...] = ()
    """By a car, which drives while it turns."""


class Sighting(Struct, frozen=True):
    """One thing that the robot sees."""

    degrees: float
    """From the robot's front, positive to the right, -90 to 90."""
    steps: float
    colour: str
    """An English colour word of the language, such as ``red``; an empty string where it can't be known."""
    name: str
    """The thing's name in its world, or an empty string."""
    mark: int | None = None
    """The number of a fiducial mark, 0 if it is too far away to be read; None for a coloured thing."""


class Grip(Enum):
    """The outcome of gripping or releasing."""

    GRIPPED = "gripped"
    RELEASED = "released"
    NOTHING_THERE = "nothing-there"
    """Nothing that can be gripped is between the paddles or a step before them."""
    HOLDS_ALREADY = "holds-already"
    HOLDS_NOTHING = "holds-nothing"


class GripResult(Struct, frozen=True):
    """A finished attempt to grip or to release. ``name``: the thing's, or empty if it has none."""

    outcome: Grip
    name: str = ""
    kind: str = ""
    """The thing's kind in its world, and its colour; empty if there is none."""
    colour: str = ""


class RobotProblem(Exception):
    """Raised by a robot's method: the robot lacks what was asked for, or can't be reached.

    ``code`` names the sentence (``no-sensor``, ``no-eyes``, ``link-lost``, ...), ``values`` its parameters.
    The movement that was under way has ended, and the motors are off as far as that can be known.
    """

    def __init__(self, code: str, **values: str | int) -> None:
        super().__init__(code)
        self.code = code
        self.values = values


class LinkNotice(Enum):
    """What happens to the connection to a real robot; it is reported at once."""

    CONNECTED = "connected"
    LOST = "lost"
    RESTORED = "restored"
    RESTARTED = "restarted"
    """The robot's board restarted; it has forgotten its commands, and stands."""
    BATTERY_LOW = "battery-low"
    RUNAWAY = "runaway"
    """The wheels turn although all was done to stop them."""
    PROFILE_2018 = "profile-2018"
    """The wheels count as with the firmware of 2018; from now on they are taken so."""


class Watcher(Protocol):
    """Receives a robot's progress, in the program's thread."""

    def progressed(self, motion: Motion, pose: Pose) -> None:
        """A whole step was walked, or ten degrees (or the rest of a turn) were turned."""

    def passing(self, pose: Pose) -> None:
        """The robot's present pose, some 20 times a second of real time; for display only."""

    def sense_failed(self, problem: RobotProblem) -> None:
        """A sense that a command needs has failed; the command continues without it."""


class Pace(Protocol):
    """The program's pace: it waits, and knows when the program must stop."""

    def sleep(self, seconds: float) -> bool:
        """Wait. False as soon as the program must stop. While the program is paused, it blocks."""


class Robot(Protocol):
    """A robot that GoDonnie can program."""

    @property
    def name(self) -> str: ...

    @property
    def colours(self) -> frozenset[str]:
        """The colour words that the robot can distinguish."""

    def forward(self, steps: int) -> WalkResult: ...

    def backward(self, steps: int) -> WalkResult: ...

    def turn(self, degrees: int) -> TurnResult:
        """Turn on the spot, to the right if positive, to the left if negative."""

    def wait(self, seconds: float) -> bool:
        """Let ``seconds`` of robot time pass. False if it was cut short."""

    def time(self) -> float:
        """Robot time in seconds since the robot was made or last reset."""

    def pose(self) -> Pose:
        """Where it believes it is."""

    def true_pose(self) -> Pose | None:
        """Where it is, if the world knows and the robot believes something else, now or later."""

    def distance(self, bearing: Bearing) -> int:
        """Whole steps from that sensor to the nearest obstacle in its cone, or the sensor's maximum."""

    def known_distances(self) -> Mapping[Bearing, int]:
        """What is known of the distances now, also while a command runs.

        It changes nothing: it begins no command, sends nothing and draws no random numbers, so it has no
        noise. Bearings without a sensor, or whose sensor has not measured yet, are missing.
        """

    def scan(self) -> tuple[Sighting, ...]:
        """What is visible from 90 degrees left to 90 right: things, then marks, each from left to right."""

    def halt(self) -> None:
        """Turn the motors off. From any thread, at any time; never raises."""


class Gripping(Protocol):
    """The methods of robots that may have a gripper."""

    def grip(self) -> GripResult:
        """Take what is between the paddles or just in front of them. Raises ``RobotProblem``."""

    def release(self) -> GripResult: ...


class NamedRangers(Protocol):
    """The methods of robots whose worlds may name their distance sensors."""

    @property
    def ranger_names(self) -> tuple[str, ...]: ...

    def named_distance(self, name: str) -> int:
        """As ``Robot.distance``, by one of these names."""


class KnowsItsWorld(Protocol):
    """The methods of simulated robots."""

    @property
    def is_in_the_open(self) -> bool:
        """Whether its world has nothing that a distance sensor could find."""
