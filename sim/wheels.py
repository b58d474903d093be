"""What a robot's wheels do: how fast they take it, how tightly it turns, how wrong it counts.

A robot goes a step (0.05 m) and turns 45 degrees in a second, slower where its world bounds its velocity
or its acceleration. Odometry counts with an error that is drawn once, from a seed, as in Stage.
"""

from __future__ import annotations

from math import degrees, inf
from typing import TYPE_CHECKING

from devices.ports.robot import STEP, RobotProblem
from devices.ports.values import frozen
from sim.fittings import Bounds, Drive, Limits, Localization, Wheels
from sim.ramps import Rate
from sim.sensors import Spot

if TYPE_CHECKING:
    from random import Random

STEPS_A_SECOND = 1.0
DEGREES_A_SECOND = 45.0
LEAST = 1e-3
"""A velocity below this part of the usual one is none: a command would take for ever."""
LEAST_GAIN = 1e-2
"""The same of an acceleration: what a second adds to the velocity, as a part of the usual one."""


@frozen
class Rates:
    """How fast a robot is. 0: it can't do that."""

    forward: Rate = Rate(STEPS_A_SECOND)
    """In steps."""
    backward: Rate = Rate(STEPS_A_SECOND)
    right: Rate = Rate(DEGREES_A_SECOND)
    """In degrees."""
    left: Rate = Rate(DEGREES_A_SECOND)
    bend: float | None = None
    """Metres: the radius of the smallest circle that a car drives; None turns on the spot."""


def rates_of(wheels: Wheels | None) -> Rates:
    """Without wheels: the usual ones."""
    if wheels is None:
        return Rates()
    bounds, gains = wheels.velocity_bounds or Limits(), wheels.acceleration_bounds or _ANY
    backward, forward = _both_ways(bounds.x, gains.x, STEP, STEPS_A_SECOND)
    right, left = _both_ways(bounds.yaw, gains.yaw, 1.0, DEGREES_A_SECOND)
    if wheels.drive is not Drive.CAR:
        return Rates(forward, backward, right, left)
    bend = max(wheels.wheelbase, STEP)
    curving = _times(forward, degrees(STEP / bend))
    return Rates(forward, backward, _slower(right, curving), _slower(left, curving), bend)


_ANY = Limits((-inf, inf), (-inf, inf), (-inf, inf))


def _both_ways(speeds: Bounds, gains: Bounds, unit: float, usual: float) -> tuple[Rate, Rate]:
    """Towards the lower and the upper bounds: what gains speed one way loses it the other."""
    low, high = (_bounded(most / unit, usual) for most in (-speeds[0], speeds[1]))
    less, more = (most / unit for most in (-gains[0], gains[1]))
    if min(less, more) < LEAST_GAIN * usual:
        return Rate(0.0), Rate(0.0)
    return Rate(low, less, more), Rate(high, more, less)


def _times(rate: Rate, factor: float) -> Rate:
    return Rate(rate.top * factor, rate.up * factor, rate.down * factor)


def _slower(one: Rate, other: Rate) -> Rate:
    return Rate(min(one.top, other.top), min(one.up, other.up), min(one.down, other.down))


def _bounded(most: float, usual: float) -> float:
    return min(usual, most) if most >= LEAST * usual else 0.0


def moving(rate: Rate) -> Rate:
    """The rate; RobotProblem ``cannot-drive`` where it is 0."""
    if rate.top == 0.0:
        raise RobotProblem("cannot-drive")
    return rate


def turning(rate: Rate) -> Rate:
    """The rate; RobotProblem ``cannot-turn`` where it is 0."""
    if rate.top == 0.0:
        raise RobotProblem("cannot-turn")
    return rate


@frozen
class Odometry:
    """How a robot's belief about where it is follows from what it drives. Errors are parts of the whole."""

    along: float = 0.0
    turn: float = 0.0

    @property
    def is_exact(self) -> bool:
        return self.along == 0.0 and self.turn == 0.0

    def ahead(self, belief: Spot, metres: float, turned: float) -> Spot:
        """After so many metres in the direction that is ``turned`` from the front."""
        return belief.ahead(metres * (1.0 + self.along), belief.yaw + turned)

    def turned(self, belief: Spot, degrees: float) -> Spot:
        """After so many degrees counter-clockwise."""
        return Spot(belief.x, belief.y, (belief.yaw + degrees * (1.0 + self.turn)) % 360.0)


def odometry_of(wheels: Wheels | None, chance: Random | None) -> Odometry:
    """Exact without ``chance``, and for a robot that knows where it is."""
    if wheels is None or chance is None or wheels.localization is not Localization.ODOM:
        return Odometry()
    error = wheels.odom_error
    return Odometry((chance.random() - 0.5) * error.x, (chance.random() - 0.5) * error.yaw)
