"""What every robot can do, simulated or real, and the values it answers with.

Steps and degrees are the learner's units and exist only at this border: a step is 0.05 m, the heading
is a compass (0 north, 90 east, clockwise). The methods of ``Robot`` are the program's thread's, which they
block until it is done; they return early, with ``StoppedBy.USER``, once the pace that the robot was made with
tells them to. Any thread may ask ``pose``, ``time`` and ``known_distances``, and may ``halt``.
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum

from devices.ports.hints import Protocol
from devices.ports.values import Frozen

STEP = 0.05
"""Metres in a step (the manual gives none; fixed by the language specification, section 4)."""

FARTHEST = 60
"""Steps that a sensor tells when nothing is within its range (manual, section 8)."""


class Bearing(Enum):
    """Where a sensor looks, as a compass angle in degrees relative to the robot's front."""

    FRONT = 0
    FRONT_RIGHT = 45
    BACK_RIGHT = 135
    BACK = 180
    BACK_LEFT = 225
    FRONT_LEFT = 315


class StoppedBy(Enum):
    """Why a movement did less than it was asked."""

    OBSTACLE = "obstacle"
    COLLISION = "collision"
    STALL = "stall"
    """A real robot's wheels don't turn although its motors are on."""
    LINK = "link"
    """The line to a real robot was lost."""
    USER = "stopped"


class Motion(Enum):
    """What a robot is doing while it reports progress."""

    FORWARD = "forward"
    BACKWARD = "backward"
    RIGHT = "right"
    LEFT = "left"


class Pose(Frozen):
    """A place and a direction: x steps to the east, y steps to the north, heading in compass degrees."""

    x: float
    y: float
    heading: float


class Met(Frozen):
    """What an obstacle or a collision was with, where the robot knows."""

    kind: str
    """What it is in its world, such as ``chair``; ``wall`` for any wall, ``robot`` for another robot,
    ``something`` where the robot felt it and can't tell."""
    name: str
    """Its own name in its world, or an empty string."""
    degrees: float
    """Where it is: from the robot's front, positive to the right, above -180 to 180."""


class Pushed(Frozen):
    """A thing that a movement pushed along."""

    kind: str
    """What it is in its world, such as ``cone``."""
    name: str
    """Its own name in its world, or an empty string."""
    colour: str
    """An English colour word of the language."""
    steps: float


class Moved(Frozen):
    """A finished walk. ``asked`` and ``walked`` are whole steps, in the direction of the command."""

    asked: int
    walked: int
    stopped_by: StoppedBy | None
    pose: Pose
    met: Met | None = None
    pushed: tuple[Pushed, ...] = ()
    """In the order in which they were met."""


class Turned(Frozen):
    """A finished turn. ``asked`` and ``turned`` are whole degrees, positive to the right."""

    asked: int
    turned: int
    stopped_by: StoppedBy | None
    pose: Pose
    met: Met | None = None
    pushed: tuple[Pushed, ...] = ()
    """By a car, which drives its turns."""


class Sighting(Frozen):
    """One thing that the robot sees."""

    degrees: float
    """From the robot's front, positive to the right, -90 to 90."""
    steps: float
    colour: str
    """An English colour word of the language, such as ``red``; an empty string where it can't be known."""
    name: str
    """The thing's name in its world, or an empty string."""


class Grip(Enum):
    """What became of gripping or releasing."""

    GRIPPED = "gripped"
    RELEASED = "released"
    NOTHING_THERE = "nothing-there"
    """Nothing that can be gripped is between the paddles or a step before them."""
    HOLDS_ALREADY = "holds-already"
    HOLDS_NOTHING = "holds-nothing"


class Gripped(Frozen):
    """A finished attempt to grip or to release. ``name``: the thing's, or empty where it has none."""

    outcome: Grip
    name: str = ""
    kind: str = ""
    """What the thing is in its world, and its colour; empty where there is none."""
    colour: str = ""


class RobotProblem(Exception):
    """Raised by a robot's method: it lacks what it was asked for, or can't be reached.

    ``code`` names the sentence (``no-sensor``, ``no-eyes``, ``link-lost``, ...), ``values`` what it needs. A
    movement that was under way has ended before, and the motors are off as far as that can be known.
    """

    def __init__(self, code: str, **values: str | int) -> None:
        super().__init__(code)
        self.code = code
        self.values = values


class LinkNews(Enum):
    """What happens to the line to a real robot, and is told at once."""

    CONNECTED = "connected"
    LOST = "lost"
    RESTORED = "restored"
    RESTARTED = "restarted"
    """The robot's board began anew; whatever it was doing is forgotten, and it stands."""
    BATTERY_LOW = "battery-low"


class Watcher(Protocol):
    """Told by a robot, in the program's thread, how far it has come."""

    def progressed(self, motion: Motion, pose: Pose) -> None:
        """A whole step was walked, or ten degrees (or the rest of a turn) were turned."""

    def passing(self, pose: Pose) -> None:
        """Where the robot is just now, some 20 times a second of real time; for display only."""


class Pace(Protocol):
    """Real time, as far as a robot has to do with it."""

    def sleep(self, seconds: float) -> bool:
        """Wait. False as soon as the program must stop; it holds on while the program is paused."""


class Robot(Protocol):
    """A robot that GoDonnie can program."""

    @property
    def name(self) -> str: ...

    @property
    def colours(self) -> frozenset[str]:
        """The colour words that the robot can tell apart."""

    def forward(self, steps: int) -> Moved: ...

    def backward(self, steps: int) -> Moved: ...

    def turn(self, degrees: int) -> Turned:
        """Turn on the spot, to the right if positive, to the left if negative."""

    def wait(self, seconds: float) -> bool:
        """Let ``seconds`` of robot time pass. False if it was cut short."""

    def time(self) -> float:
        """Robot time in seconds since the robot was made or last reset."""

    def pose(self) -> Pose: ...

    def distance(self, bearing: Bearing) -> int:
        """Whole steps from that sensor to the nearest obstacle in its cone, or the sensor's maximum."""

    def known_distances(self) -> Mapping[Bearing, int]:
        """What is known of the distances just now, for who only looks, also while a command goes on.

        Nothing happens for it: no command begins, nothing is sent or drawn by lot, so it has no noise.
        Bearings that no sensor looks to, or whose sensor has told nothing, are missing.
        """

    def scan(self) -> tuple[Sighting, ...]:
        """What is visible from 90 degrees left to 90 right, from left to right."""

    def halt(self) -> None:
        """Motors off. From any thread, at any time; never raises."""
