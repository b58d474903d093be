"""What is mounted on the models of a world: wheels, sensors, grippers. Values only, as the files give them.

Metres, kilograms, seconds, and degrees counter-clockwise, each in the frame of the model that carries it.
"""

from __future__ import annotations

from enum import Enum

from devices.ports.values import Frozen, field
from sim.colours import Colour
from sim.placement import Placement


class RangeNoise(Frozen):
    """How far off a range sensor may be; without a seed it is never off.

    Readings are drawn evenly from plus or minus these amounts. Names and meaning are Stage's.
    """

    constant: float = 0.0
    """Metres."""
    proportional: float = 0.0
    """Of the distance."""
    angle: float = 0.0
    """Degrees."""


class RangeSensor(Frozen):
    """One sensor of a ranger, in the ranger's frame."""

    pose: Placement = field(default_factory=Placement)
    minimum: float = 0.0
    maximum: float = 5.0
    fov: float = 5.729577951308232
    """Degrees; the default is Stage's tenth of a radian."""
    samples: int = 1
    """1: a cone, covered whole. More: so many thin rays, spread evenly over the field of view."""
    noise: RangeNoise = field(default_factory=RangeNoise)
    thickness: float = 0.02
    """Metres up and down; it looks from the middle of that."""


class Blobfinder(Frozen):
    """What a blobfinder tells apart, and where it looks."""

    maximum: float
    fov: float
    colours: tuple[Colour, ...]
    """Empty: every colour."""
    pan: float = 0.0
    image: tuple[int, int] = (80, 60)
    """Pixels, across and down."""


class FiducialFinder(Frozen):
    """Finds the models that have a ``fiducial_return`` and the same key."""

    minimum: float = 0.0
    maximum: float = 8.0
    maximum_id: float = 5.0
    """Metres up to which it also tells which one it is."""
    fov: float = 180.0


class Bumper(Frozen):
    """One bumper: a bar of that length across the direction in which its pose looks, touched or not."""

    pose: Placement
    length: float


class Camera(Frozen):
    """Kept so that its field of view can be drawn; no picture is made."""

    minimum: float = 0.2
    maximum: float = 8.0
    fov: tuple[float, float] = (70.0, 40.0)
    """Degrees, across and up."""
    pan: float = 0.0
    tilt: float = 0.0


class Gripper(Frozen):
    """Two paddles that close round a thing, and a lift. Proportions of the model's size, as in Stage."""

    paddle_length: float = 0.66
    paddle_width: float = 0.1
    paddle_height: float = 0.4
    closed: bool = False
    lifted: bool = False
    autosnatch: bool = False
    """Whether it closes by itself round what breaks a beam."""


class Drive(Enum):
    DIFF = "diff"
    OMNI = "omni"
    CAR = "car"


class Localization(Enum):
    GPS = "gps"
    """It knows exactly where it is."""
    ODOM = "odom"
    """It counts its wheels' turns, with errors."""


Bounds = tuple[float, float]
"""The least and the most."""


class Limits(Frozen):
    """Bounds of a velocity (or, a second more, of an acceleration): metres and degrees a second."""

    x: Bounds = (-1.0, 1.0)
    y: Bounds = (-1.0, 1.0)
    yaw: Bounds = (-90.0, 90.0)


class OdometryError(Frozen):
    """The most that odometry is off, as a part of what is driven or turned.

    Of a value E a part between -E/2 and E/2 is drawn once at the start, as in Stage.
    """

    x: float = 0.03
    y: float = 0.03
    yaw: float = 0.05


class Wheels(Frozen):
    """How a position model drives, and what it knows about where it is."""

    drive: Drive = Drive.DIFF
    localization: Localization = Localization.GPS
    localization_origin: Placement | None = None
    """None: the file gives none."""
    odom_error: OdometryError = field(default_factory=OdometryError)
    velocity_bounds: Limits | None = None
    """None: the file sets none; Stage's own are those of ``Limits``."""
    acceleration_bounds: Limits | None = None
    wheelbase: float = 1.0
    """Metres between the axles of a car."""
