"""What a robot's wheels do: how fast they take it, how tightly it turns, how wrong it counts.

A robot goes a step (0.05 m) and turns 45 degrees in a second, slower where its world bounds its velocity; an
acceleration is not simulated. Odometry counts with an error that is drawn once, from a seed, as in Stage.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from devices.ports.robot import STEP, RobotProblem
from devices.ports.values import frozen
from sim.fittings import Drive, Limits, Localization, Wheels
from sim.sensors import Spot

if TYPE_CHECKING:
    from random import Random

STEPS_A_SECOND = 1.0
DEGREES_A_SECOND = 45.0
LEAST = 1e-3
"""A velocity below this part of the usual one is none: a command would take for ever."""


@frozen
class Rates:
    """How fast a robot is. 0: it can't do that."""

    forward: float = STEPS_A_SECOND
    """Steps a second."""
    backward: float = STEPS_A_SECOND
    right: float = DEGREES_A_SECOND
    """Degrees a second."""
    left: float = DEGREES_A_SECOND
    bend: float | None = None
    """Metres: the radius of the smallest circle that a car drives; None turns on the spot."""


def rates_of(wheels: Wheels | None) -> Rates:
    """Without wheels: the usual ones."""
    if wheels is None:
        return Rates()
    bounds = wheels.velocity_bounds or Limits()
    forward = _bounded(bounds.x[1] / STEP, STEPS_A_SECOND)
    backward = _bounded(-bounds.x[0] / STEP, STEPS_A_SECOND)
    right, left = (_bounded(most, DEGREES_A_SECOND) for most in (-bounds.yaw[0], bounds.yaw[1]))
    if wheels.drive is not Drive.CAR:
        return Rates(forward, backward, right, left)
    bend = max(wheels.wheelbase, STEP)
    curving = forward * STEP / bend * DEGREES_A_RADIAN
    return Rates(forward, backward, min(right, curving), min(left, curving), bend)


DEGREES_A_RADIAN = 57.29577951308232


def _bounded(most: float, usual: float) -> float:
    return min(usual, most) if most >= LEAST * usual else 0.0


def moving(rate: float) -> float:
    """The rate; RobotProblem ``cannot-drive`` where it is 0."""
    if rate == 0.0:
        raise RobotProblem("cannot-drive")
    return rate


def turning(rate: float) -> float:
    """The rate; RobotProblem ``cannot-turn`` where it is 0."""
    if rate == 0.0:
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
