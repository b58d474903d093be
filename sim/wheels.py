"""What a robot's wheels do: how fast they take it, how tightly it turns, how wrong it counts.

A robot goes a step (0.05 m) and turns 45 degrees in a second, slower where its world bounds its velocity
or its acceleration. A movement's way and time belong together: at one pace, or faster at first and slower at
the end. Amounts are steps or degrees, from the movement's start. A bounded acceleration makes a trapezoid of
the speed: the top is reached only where the way is long enough for it. A movement knows from the start where
it is to end; what stops it before stops it at once.
Odometry counts with an error that is drawn once, from a seed, as in Stage.
"""

from __future__ import annotations

from functools import cache
from math import degrees, floor, inf, sqrt
from typing import TYPE_CHECKING, Protocol

from devices.ports.robot import STEP, RobotProblem
from devices.ports.values import Frozen
from sim.fittings import Bounds, Drive, Limits, Localization, Wheels
from sim.placement import Spot

if TYPE_CHECKING:
    from random import Random


TICK = 1 / 20
"""Seconds of robot time at most in which a robot that others may disturb takes the world to stand still."""
NEARLY = 1e-6
"""Steps or degrees by which a sum of fractions may miss whole ones."""
_FINEST = 1e-5
"""Steps: no tick is shorter, however slowly a robot begins."""


class Rate(Frozen):
    """How fast something goes at most, and how fast it comes there, and to rest again. 0: not at all."""

    top: float
    """Steps or degrees a second."""
    up: float = inf
    """A second more."""
    down: float = inf

    def over(self, asked: float) -> Course:
        """A movement of so much."""
        return _even(self.top) if self.up == self.down == inf else Ramped(self, asked)


class Course(Protocol):
    """Way and time of one movement."""

    def seconds(self, done: float, further: float) -> float:
        """How long it takes to go ``further`` where ``done`` was gone before."""

    def further(self, done: float, seconds: float) -> float:
        """How much is gone in ``seconds`` where ``done`` was gone before."""

    def next_stop(self, done: float) -> float:
        """Where a tick of a walk ends that begins after ``done`` steps: at the next whole one at most."""


class Even:
    """At one pace from start to end."""

    def __init__(self, rate: float) -> None:
        self._rate = rate
        self._ticks_a_step = max(1, -floor(-(1.0 / (rate * TICK) - NEARLY)))

    def seconds(self, done: float, further: float) -> float:  # noqa: ARG002 -- the same everywhere
        return further / self._rate

    def further(self, done: float, seconds: float) -> float:  # noqa: ARG002 -- the same everywhere
        return seconds * self._rate

    def next_stop(self, done: float) -> float:
        ticks = self._ticks_a_step
        return (floor(done * ticks + NEARLY) + 1) / ticks


_even = cache(Even)


class Ramped:
    """Faster, evenly, slower; on a short way only faster and slower."""

    def __init__(self, rate: Rate, asked: float) -> None:
        slowness = 1.0 / rate.up + 1.0 / rate.down
        self._up, self._down, self._asked = rate.up, rate.down, asked
        self._top = min(rate.top, sqrt(2.0 * asked / slowness))
        self._rising, self._falling = (self._top**2 / (2.0 * each) for each in (rate.up, rate.down))
        """The ways on which it gets faster and slower."""
        self._risen, fall = self._top / rate.up, self._top / rate.down
        """Seconds."""
        level = asked - self._rising - self._falling
        self._falls = self._risen + (level / self._top if self._top and level > 0.0 else 0.0)
        self._end = self._falls + fall

    def seconds(self, done: float, further: float) -> float:
        return self._when(done + further) - self._when(done)

    def further(self, done: float, seconds: float) -> float:
        return self._where(self._when(done) + seconds) - done

    def next_stop(self, done: float) -> float:
        whole = floor(done + NEARLY) + 1.0
        there = max(done + self.further(done, TICK), done + _FINEST)
        return whole if there > whole - _FINEST else there

    def _when(self, way: float) -> float:
        left = self._asked - way
        if left < self._falling:
            return self._end - sqrt(2.0 * max(0.0, left) / self._down)
        if way < self._rising:
            return sqrt(2.0 * max(0.0, way) / self._up)
        return self._risen + ((way - self._rising) / self._top if self._top else 0.0)

    def _where(self, when: float) -> float:
        if when >= self._end:
            return self._asked
        if when > self._falls:
            return self._asked - self._down * (self._end - when) ** 2 / 2.0
        if when < self._risen:
            return self._up * when**2 / 2.0
        return self._rising + self._top * (when - self._risen)


STEPS_A_SECOND = 1.0
DEGREES_A_SECOND = 45.0
LEAST = 1e-3
"""A velocity below this part of the usual one is none: a command would take for ever."""
LEAST_GAIN = 1e-2
"""The same of an acceleration: what a second adds to the velocity, as a part of the usual one."""


class Rates(Frozen):
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


class Odometry(Frozen):
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
