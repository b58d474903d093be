"""What the sonars and bumpers of the real robot mean, in steps; and what a scan with its head sees.

Rules: 0 is unknown and no distance. What is beyond the reliable range is far. An obstacle counts only if two
refreshes in a row show it, because an echo from 2.56 metres looks like one from 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from enum import Enum, auto
from math import inf

from devices.camera import ColouredThing
from devices.ports.robot import CENTIMETRES_A_STEP, FARTHEST, STEP, Bearing, Sighting
from devices.serial_robot.config import RobotConfig
from devices.wire.telemetry import REMEMBERED, RangeSample, Telemetry

ROUNDED_OFF = 1
"""Centimetres by which a sonar may report too little: it rounds down to a whole centimetre."""
NO_ECHO = 141
"""What the firmware reports without an echo; a thing at exactly 1.41 metres looks the same."""
TOLERANCE = 0.05
"""Seconds: the samples of two refreshes span between 0.38 and 0.4 seconds."""


class Clearance(Enum):
    """Whether the robot may begin a step."""

    FREE = auto()
    DOUBTFUL = auto()
    """The newest measurement shows an obstacle, or nothing; it is not confirmed yet."""
    BLOCKED = auto()


def centimetres(sample: RangeSample, sonar: int, farthest: float) -> float | None:
    """What a sonar measured; None if unknown, infinity if it is too far to be reliable."""
    measured = sample.centimetres[sonar]
    if measured == 0:
        return None
    return inf if measured == NO_ECHO or measured > farthest * 100 else float(measured)


def to_steps(measured: float | None) -> int:
    """Whole steps of some centimetres; where nothing is known, the farthest: nothing is near."""
    if measured is None or measured == inf:
        return FARTHEST
    return round(measured) // CENTIMETRES_A_STEP


class BoardSensors:
    """The sensors of one robot."""

    def __init__(self, config: RobotConfig) -> None:
        self._config = config

    def sonar_at(self, bearing: Bearing) -> int | None:
        """The board's number of the sonar in that direction; None if there is none."""
        return self._config.sonars.index(bearing) if bearing in self._config.sonars else None

    def newest(self, telemetry: Telemetry, sonar: int) -> float | None:
        """The newest reading of a sonar in centimetres; infinity for far, None for unknown."""
        if not telemetry.ranges:
            return None
        return centimetres(telemetry.ranges[-1], sonar, self._config.farthest)

    def known(self, telemetry: Telemetry) -> dict[Bearing, int]:
        """Whole steps, for each bearing whose sonar has measured something."""
        sonars = ((bearing, self.sonar_at(bearing)) for bearing in Bearing)
        newest = ((each, self.newest(telemetry, sonar)) for each, sonar in sonars if sonar is not None)
        return {bearing: to_steps(distance) for bearing, distance in newest if distance is not None}

    def ahead(self, telemetry: Telemetry, sonar: int | None, needed: float, sense: int) -> Clearance:
        """Whether ``needed`` steps from here are free, going forward (``sense`` 1) or backward (-1).

        Every measurement counts from where the robot was when it came in.
        """
        if sonar is None:
            return Clearance.FREE
        verdicts = [self._is_near(each, telemetry, sonar, needed, sense) for each in telemetry.ranges]
        if verdicts and verdicts[-1] is False:
            return Clearance.FREE
        if not _spans_two_refreshes(telemetry.ranges) or False in verdicts:
            return Clearance.DOUBTFUL
        return Clearance.BLOCKED if True in verdicts else Clearance.FREE

    def _is_near(
        self, sample: RangeSample, telemetry: Telemetry, sonar: int, needed: float, sense: int
    ) -> bool | None:
        """None if the sonar measured nothing."""
        measured = centimetres(sample, sonar, self._config.farthest)
        if measured is None:
            return None
        counts = (telemetry.right + telemetry.left - sample.right - sample.left) / 2
        moved = sense * counts / self._config.counts_a_step * CENTIMETRES_A_STEP
        return measured - moved + ROUNDED_OFF < needed * CENTIMETRES_A_STEP

    def is_close(self, telemetry: Telemetry, bearing: Bearing, metres: float) -> bool:
        """Whether all measurements of two refreshes in that direction are below a limit."""
        sonar = self.sonar_at(bearing)
        if sonar is None or not _spans_two_refreshes(telemetry.ranges):
            return False
        measured = (centimetres(each, sonar, self._config.farthest) for each in telemetry.ranges)
        return all(each is not None and each < metres * 100 for each in measured)

    def touches(self, telemetry: Telemetry, places: Iterable[int]) -> bool:
        return any(telemetry.bumpers[place] for place in places)


def _spans_two_refreshes(samples: Sequence[RangeSample]) -> bool:
    return len(samples) > 1 and samples[-1].at - samples[0].at >= REMEMBERED - TOLERANCE


# --- a scan with the sonar on the head

HEAD_AHEAD = 90
"""The servo's angle for straight ahead; 0 is full left, 180 full right, unless the head is mirrored."""
SAME_THING = 10.0
"""Centimetres by which two neighbouring measurements of one thing may differ."""


def head_angle(degrees: int, *, is_mirrored: bool = False) -> int:
    """The servo's angle for a direction from the robot's front, positive to the right. Beyond 90 degrees
    there is nothing: the head turns as far as it can."""
    turned = min(HEAD_AHEAD, max(-HEAD_AHEAD, degrees))
    return HEAD_AHEAD - turned if is_mirrored else HEAD_AHEAD + turned


def scan_angles(stride: int) -> range:
    """Degrees from the robot's front, positive to the right, from left to right."""
    return range(-HEAD_AHEAD, HEAD_AHEAD + 1, stride)


def sightings(measurements: Iterable[tuple[int, float | None]]) -> tuple[Sighting, ...]:
    """The things in a scan of degrees and centimetres; a sonar knows neither colours nor names.

    Neighbours at nearly the same distance are one thing: in their middle, and as near as the nearest.
    """
    things: list[list[tuple[int, float]]] = []
    previous: float = inf
    for degrees, measured in measurements:
        far = inf if measured is None else measured
        if far < inf:
            if abs(far - previous) <= SAME_THING:
                things[-1].append((degrees, far))
            else:
                things.append([(degrees, far)])
        previous = far
    return tuple(_sighting(thing) for thing in things)


def _sighting(thing: Sequence[tuple[int, float]]) -> Sighting:
    middle = (thing[0][0] + thing[-1][0]) / 2
    return Sighting(middle, min(far for _, far in thing) / (STEP * 100), "", "")


def coloured_sightings(
    things: Iterable[ColouredThing], measurements: Sequence[tuple[int, float | None]]
) -> tuple[Sighting, ...]:
    """What a camera saw, as far as it knows, or the sonar measures in its direction; without an echo it is
    far."""
    return tuple(
        Sighting(
            min(HEAD_AHEAD, max(-HEAD_AHEAD, each.degrees)), _steps_to(each, measurements), each.colour, ""
        )
        for each in things
    )


def _steps_to(thing: ColouredThing, measurements: Sequence[tuple[int, float | None]]) -> float:
    """The nearest echo between its borders; of a narrow thing, that in the nearest direction."""
    if thing.metres is not None:
        return thing.metres / STEP
    across = [measured for degrees, measured in measurements if thing.low <= degrees <= thing.high]
    if not across:
        nearest_first = sorted(measurements, key=lambda each: abs(each[0] - thing.degrees))
        across = [measured for _, measured in nearest_first[:1]]
    far = min((each for each in across if each is not None), default=inf)
    return FARTHEST if far == inf else far / CENTIMETRES_A_STEP
