"""How a movement's way and time belong together: at one pace, or faster at first and slower at the end.

Amounts are steps or degrees, from the movement's start. A bounded acceleration makes a trapezoid of the
speed: the top is reached only where the way is long enough for it. A movement knows from the start where it
is to end; what stops it before stops it at once.
"""

from __future__ import annotations

from functools import cache
from math import floor, inf, sqrt
from typing import Protocol

from devices.ports.values import frozen

TICK = 1 / 20
"""Seconds of robot time at most in which a robot that others may disturb takes the world to stand still."""
NEARLY = 1e-6
"""Steps or degrees by which a sum of fractions may miss whole ones."""
_FINEST = 1e-5
"""Steps: no tick is shorter, however slowly a robot begins."""


@frozen
class Rate:
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
