"""What the sonars and the bumpers of the real robot mean, in steps.

Rules: 0 is unknown and no distance; what is beyond the reliable range is far; an obstacle is one only if two
refreshes in a row say so, for an echo from 2.56 metres looks like one from 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from enum import Enum, auto
from math import inf

from devices.ports.robot import FARTHEST, STEP, Bearing
from devices.serial_robot.config import RobotConfig
from devices.wire.telemetry import REMEMBERED, RangeSample, Telemetry

CENTIMETRES_A_STEP = round(STEP * 100)
ROUNDED_OFF = 1
"""Centimetres that a sonar may tell too little: it rounds down, and measures to a centimetre."""
NO_ECHO = 141
"""What the firmware tells where no echo comes back; a thing at exactly 1.41 metres looks the same."""
ALMOST = 0.05
"""Seconds: two refreshes are remembered between 0.38 and 0.4 seconds."""


class Ahead(Enum):
    """Whether the robot may begin a step."""

    FREE = auto()
    DOUBTFUL = auto()
    """The newest measurement says no, or nothing; it is too early to believe it."""
    BLOCKED = auto()


def centimetres(sample: RangeSample, sonar: int, farthest: float) -> float | None:
    """What a sonar told; None if it told nothing, infinity if it is too far to tell."""
    told = sample.centimetres[sonar]
    if told == 0:
        return None
    return inf if told == NO_ECHO or told > farthest * 100 else float(told)


def steps_told(told: float | None) -> int:
    """Whole steps, or as far as sensors reach: where nothing is known, nothing is near."""
    if told is None or told == inf:
        return FARTHEST
    return int(told) // CENTIMETRES_A_STEP


class Senses:
    """The sensors of one robot."""

    def __init__(self, config: RobotConfig) -> None:
        self._config = config

    def sonar_at(self, bearing: Bearing) -> int | None:
        """The board's number of the sonar that looks there; None if there is none."""
        return self._config.sonars.index(bearing) if bearing in self._config.sonars else None

    def newest(self, telemetry: Telemetry, sonar: int) -> float | None:
        """Centimetres; infinity for far, None for unknown."""
        if not telemetry.ranges:
            return None
        return centimetres(telemetry.ranges[-1], sonar, self._config.farthest)

    def known(self, telemetry: Telemetry) -> dict[Bearing, int]:
        """Whole steps, for each bearing whose sonar has told something."""
        sonars = ((bearing, self.sonar_at(bearing)) for bearing in Bearing)
        told = ((each, self.newest(telemetry, sonar)) for each, sonar in sonars if sonar is not None)
        return {bearing: steps_told(distance) for bearing, distance in told if distance is not None}

    def ahead(self, telemetry: Telemetry, sonar: int | None, needed: float, sense: int) -> Ahead:
        """Whether ``needed`` steps from here are free, going forward (``sense`` 1) or backward (-1).

        Every measurement counts from where the robot was when it came in.
        """
        if sonar is None:
            return Ahead.FREE
        verdicts = [self._is_near(each, telemetry, sonar, needed, sense) for each in telemetry.ranges]
        if verdicts and verdicts[-1] is False:
            return Ahead.FREE
        if not _spans_two_refreshes(telemetry.ranges) or False in verdicts:
            return Ahead.DOUBTFUL
        return Ahead.BLOCKED if True in verdicts else Ahead.FREE

    def _is_near(
        self, sample: RangeSample, telemetry: Telemetry, sonar: int, needed: float, sense: int
    ) -> bool | None:
        """None if the sonar told nothing."""
        told = centimetres(sample, sonar, self._config.farthest)
        if told is None:
            return None
        counts = (telemetry.right + telemetry.left - sample.right - sample.left) / 2
        gone = sense * counts / self._config.counts_a_step * CENTIMETRES_A_STEP
        return told - gone + ROUNDED_OFF < needed * CENTIMETRES_A_STEP

    def touches(self, telemetry: Telemetry, places: Iterable[int]) -> bool:
        return any(telemetry.bumpers[place] for place in places)


def _spans_two_refreshes(samples: Sequence[RangeSample]) -> bool:
    return len(samples) > 1 and samples[-1].at - samples[0].at >= REMEMBERED - ALMOST
