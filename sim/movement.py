"""Movements, played in time: how a robot gets elsewhere, and what it tells on the way.

Where nobody can disturb it, a robot's way is found at once and then played. Where others may act meanwhile,
or something has to be pushed, it goes in small fixed ticks, each of which looks at the world anew. Both come
to the same where only one robot moves (a property test holds it).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from math import inf

from devices.ports.robot import Motion, StoppedBy
from sim.clock import Mark
from sim.ramps import NEARLY, Rate
from sim.vehicle import Vehicle, Whereabouts

MOST_REPORTS = 1000
"""Of a longer movement only every so many-th step is told, so that a huge one stays short."""

Going = tuple[int, StoppedBy | None]
"""Whole steps or degrees done, and why no more."""


class Movement(ABC):
    """A movement of ``asked`` steps or degrees, as fast as ``rate``, the ``every``-th of which are told."""

    def __init__(self, vehicle: Vehicle, motion: Motion, asked: int, rate: Rate, every: int) -> None:
        self._vehicle = vehicle
        self._motion = motion
        self._asked = asked
        self._course = rate.over(asked)
        self._every = every
        self._start = vehicle.here
        self._whole = 0
        """Steps or degrees done."""
        self._told = 0

    def run(self) -> Going:
        """Play it. The clock has begun."""
        stopped_by = None
        while stopped_by is None and self._whole < self._asked:
            stopped_by = self._go_on()
        if stopped_by is not StoppedBy.USER:
            self._tell(self._whole)
        return self._whole, stopped_by

    @abstractmethod
    def _go_on(self) -> StoppedBy | None:
        """Go some of the way. Answers why no more can be gone."""

    def _stride(self, count: int) -> int:
        return self._every * -(-count // (self._every * MOST_REPORTS))

    def _tell_in_passing(self) -> None:
        """After a tick that came to a whole step or degree."""
        if self._whole % self._stride(self._asked) == 0:
            self._tell(self._whole)

    def _tell(self, whole: int) -> None:
        if whole > self._told:
            self._told = whole
            self._vehicle.report(self._motion)


class Sweeping(Movement):
    """A movement that can be found at once as far as nobody else can act."""

    def _go_on(self) -> StoppedBy | None:
        room = self._room()
        return self._sweep(room) if room else self._tick()

    @abstractmethod
    def _sweep(self, room: int) -> StoppedBy | None:
        """Up to ``room`` whole steps or degrees, in which nobody else acts, at once."""

    @abstractmethod
    def _tick(self) -> StoppedBy | None:
        """A little way, while others may act."""

    def _room(self) -> int:
        """Whole steps or degrees that can be gone at once."""
        seconds, left = self._vehicle.clock.undisturbed(), self._asked - self._whole
        if seconds == inf:
            return left
        return min(left, int(self._course.further(self._whole, seconds) + NEARLY))

    def _play(
        self, count: int, amount: float, at: Callable[[float], Whereabouts], room: int
    ) -> tuple[float, bool]:
        """Let ``amount`` steps or degrees happen, ``count`` whole ones, telling them.

        Answers how many happened, and whether that is all.
        """
        vehicle, course, begun = self._vehicle, self._course, self._whole
        seconds = course.seconds(begun, amount)

        def passing(spent: float) -> None:
            vehicle.pass_by(at(course.further(begun, spent)))
            vehicle.show()

        spent = vehicle.clock.spend(seconds, self._marks(count, at, room), passing)
        return (amount, True) if spent >= seconds else (course.further(begun, spent), False)

    def _marks(self, count: int, at: Callable[[float], Whereabouts], room: int) -> list[Mark]:
        """When to tell what of the next ``count`` steps or degrees; to the last one if nobody can disturb."""
        if count == 0 or self._vehicle.watcher is None:
            return []
        begun = self._whole
        is_all = room == self._asked - begun
        stride = self._stride(begun + count if is_all else self._asked)
        first = begun // stride * stride + stride
        amounts = [*range(first, begun + count, stride)]
        if is_all or (begun + count) % stride == 0:
            amounts.append(begun + count)
        seconds = self._course.seconds
        return [(seconds(begun, n - begun), self._telling(n, at, n - begun)) for n in amounts]

    def _telling(self, whole: int, at: Callable[[float], Whereabouts], amount: int) -> Callable[[], None]:
        def tell() -> None:
            self._vehicle.pass_by(at(amount))
            self._tell(whole)

        return tell
