"""Robots that are driven by velocities, and what their devices read: what a server for other programs needs.

Units are those of world files, because its clients know no steps: metres, seconds, and degrees
counter-clockwise, from the world's x axis or, for what is mounted on a robot, from its front.

All robots of a world move together, in ticks of ``TICK``. One thread calls ``advance`` and reads; any thread
may set a velocity, which counts from the next tick on.
"""

from __future__ import annotations

from msgspec import Struct

TICK = 0.1
"""Seconds. The velocities of all robots are taken at its start."""


class Velocity(Struct, frozen=True):
    """How a robot is driven, until it is driven otherwise."""

    ahead: float = 0.0
    """Metres a second; below 0 backward."""
    left: float = 0.0
    """The same sideways, of a robot that can go there."""
    turn: float = 0.0
    """Degrees a second, counter-clockwise."""


class MetricPose(Struct, frozen=True):
    """Where something is and where it looks: metres, and degrees from 0 to below 360."""

    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0


class DriveState(Struct, frozen=True):
    """A robot after the last tick."""

    believed: MetricPose
    """What it knows of its pose: the true one, or what it counted since its start at 0 0 0."""
    truth: MetricPose
    velocity: Velocity
    """At the end of the tick: as it was asked for, within the bounds of the world."""
    is_stalled: bool
    """Whether something stopped it in that tick."""


class RangerReading(Struct, frozen=True):
    """What one ranger measures: metres, or how far a sensor reaches where nothing is nearer."""

    name: str
    sensors: tuple[tuple[float, ...], ...]
    """The samples of each of its sensors, counter-clockwise; a sonar has one."""
    returns: tuple[tuple[float, ...], ...] = ()
    """How strongly what is there answers, as its world says; 0 if nothing is."""


class BumperReading(Struct, frozen=True):
    """Which of the bars of one bumper are pressed."""

    name: str
    pressed: tuple[bool, ...]


class ColourBlob(Struct, frozen=True):
    """A stretch of one colour in a blobfinder's view."""

    colour: tuple[int, int, int]
    """Red, green and blue, 0 to 255, exactly as the world says."""
    left: float
    """Degrees of its left border from the middle of the view."""
    right: float
    metres: float
    """To its nearest point."""


class BlobReading(Struct, frozen=True):
    """What one blobfinder sees, from left to right."""

    name: str
    blobs: tuple[ColourBlob, ...]


class Mark(Struct, frozen=True):
    """A fiducial mark, seen from its finder."""

    number: int
    """0 if it is too far away to be read."""
    degrees: float
    metres: float
    """To the middle of the thing that carries it."""
    yaw: float
    """Where that looks, from the finder's own direction."""


class MarkReading(Struct, frozen=True):
    """What one fiducial finder finds, from left to right."""

    name: str
    marks: tuple[Mark, ...]
