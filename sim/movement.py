"""Movements over time, and the events on the way.

A ``Walk`` goes straight, forward or backward, step by step, and pushes what gives way. A ``Turn`` is on the
spot. A ``Bend``, for a car, follows the smallest circle that it can drive.

If nothing can interfere, the way is computed at once and then played. If other robots may act
meanwhile, or something is pushed, the movement advances in small fixed ticks, each of which looks at the
world again. With one moving robot both give the same result (a property test checks it).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from functools import lru_cache
from math import ceil, inf, radians, sin

from devices.ports.robot import DEGREES_A_REPORT, STEP, Bearing, Motion, StoppedBy
from sim.clock import Landing, Mark
from sim.motion import TOUCHING
from sim.vehicle import NEARLY, TICK, Course, Rate, Vehicle, Whereabouts, moving, turning, walk_stops

MOST_REPORTS = 1000
"""A longer movement reports only every n-th step, so that a huge one has few reports."""

Going = tuple[int, StoppedBy | None]
"""Whole steps or degrees done, and why no more."""


class Movement(ABC):
    """A movement of ``asked`` steps or degrees at ``rate``; it reports every ``every``-th of them."""

    def __init__(self, vehicle: Vehicle, motion: Motion, asked: int, rate: Rate, every: int) -> None:
        self._vehicle = vehicle
        self._motion = motion
        self._asked = asked
        self._course = rate.over(asked)
        self._every = every
        self._start = vehicle.here
        self._whole = 0
        """Steps or degrees done."""
        self._reported = 0
        self._began = vehicle.clock.seconds
        """The robot's time at which it began; later by what it lost where less was free than expected."""

    def run(self) -> Going:
        """Play it. The clock has begun."""
        stopped_by = None
        while stopped_by is None and self._whole < self._asked:
            stopped_by = self._go_on()
        if stopped_by is not StoppedBy.USER:
            self._report(self._whole)
        return self._whole, stopped_by

    @abstractmethod
    def _go_on(self) -> StoppedBy | None:
        """Go a part of the way. Returns what ends the movement, if anything."""

    def _stride(self, count: int) -> int:
        return self._every * -(-count // (self._every * MOST_REPORTS))

    def _when(self, done: float) -> float:
        """The robot's time at which so much is done, independent of the division into ticks."""
        return self._began + self._course.seconds(0.0, done)

    def _come_to(self, done: float) -> None:
        """Note how much is done, perhaps less than the passed time allows."""
        self._began = self._vehicle.clock.seconds - self._course.seconds(0.0, done)

    def _report_progress(self) -> None:
        """Reports progress after a tick that came to a whole step or degree."""
        if self._vehicle.watcher is not None and self._whole % self._stride(self._asked) == 0:
            self._report(self._whole)

    def _report(self, whole: int) -> None:
        if whole > self._reported:
            self._reported = whole
            self._vehicle.report(self._motion)


class Sweeping(Movement):
    """A movement that is computed at once while no other robot can act."""

    def _go_on(self) -> StoppedBy | None:
        if not self._vehicle.clock.others_glide and (room := self._room()):
            return self._sweep(room)
        is_gliding = self._vehicle.glides and self._vehicle.clock.is_active()
        end = self._free_to() if is_gliding else self._whole
        landed = self._glide(end) if end > self._whole else None
        return self._tick() if landed is None else self._land(end, *landed)

    def _glide(self, end: int) -> tuple[Landing, int] | None:
        """Go on to that many steps or degrees, see ``Vehicle.glide``."""
        return self._vehicle.glide(
            self._at(end),
            self._when(end),
            lambda: self._course.times(self._began, self._stops(end)),
            lambda count: self._at(self._stops(end)[count - 1]),
            self._guard,
        )

    @property
    @abstractmethod
    def _guard(self) -> float:
        """Metres from the robot's centre beyond which nothing can interfere."""

    @abstractmethod
    def _at(self, done: float) -> Whereabouts:
        """The place after that many steps or degrees."""

    @abstractmethod
    def _free_to(self) -> int:
        """The steps or degrees done after the next glide, up to which nothing is in the way now."""

    @abstractmethod
    def _stops(self, end: int) -> Sequence[float]:
        """Steps or degrees that are done after each tick up to ``end``."""

    @abstractmethod
    def _land(self, end: int, landing: Landing, count: int) -> StoppedBy | None:
        """After a glide to ``end``. ``count``: its ticks, if not all; see ``Landing``."""

    @abstractmethod
    def _sweep(self, room: int) -> StoppedBy | None:
        """Up to ``room`` whole steps or degrees at once, while no other robot acts."""

    @abstractmethod
    def _tick(self) -> StoppedBy | None:
        """Move for a tick, while others may act."""

    def _room(self) -> int:
        """The whole steps or degrees that can be done at once."""
        left = self._asked - self._whole
        seconds = self._vehicle.clock.undisturbed()
        if seconds == inf:
            return left
        return min(left, int(self._course.further(self._whole, seconds) + NEARLY))

    def _play(
        self, count: int, amount: float, at: Callable[[float], Whereabouts], room: int
    ) -> tuple[float, bool]:
        """Move ``amount`` steps or degrees, ``count`` whole ones, and report them.

        Returns how many were done, and whether that is all.
        """
        vehicle, course, begun = self._vehicle, self._course, self._whole
        seconds = course.seconds(begun, amount)

        def passing(spent: float) -> None:
            vehicle.pass_by(at(course.further(begun, spent)))
            vehicle.show()

        marks, end = self._marks(count, at, room), self._when(begun + amount)
        spent = vehicle.clock.spend(seconds, marks, passing, end)
        return (amount, True) if spent >= seconds else (course.further(begun, spent), False)

    def _marks(self, count: int, at: Callable[[float], Whereabouts], room: int) -> list[Mark]:
        """When to report which of the next ``count`` steps; up to the last if nothing interferes."""
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
        return [(seconds(begun, n - begun), self._reporter(n, at, n - begun)) for n in amounts]

    def _reporter(self, whole: int, at: Callable[[float], Whereabouts], amount: int) -> Callable[[], None]:
        def report() -> None:
            self._vehicle.pass_by(at(amount))
            self._report(whole)

        return report


class Walk(Sweeping):
    """Straight forward or backward."""

    def __init__(self, vehicle: Vehicle, motion: Motion, steps: int, rate: Rate) -> None:
        """RobotProblem ``cannot-drive`` if the rate is 0."""
        super().__init__(vehicle, motion, steps, moving(rate), 1)
        self._bearing = Bearing.BACK if motion is Motion.BACKWARD else Bearing.FRONT
        self._turned = 180.0 if motion is Motion.BACKWARD else 0.0
        self._angle = self._start.truth.yaw + self._turned
        self._done = 0.0
        """Steps, with fractions."""
        self._has_swept = False
        """Whether the next step is in ticks: there is something to push, or another robot acts."""
        self._looked = vehicle.moment
        """When the sensors were looked at before this step."""

    def _room(self) -> int:
        return super()._room() if self._is_whole and not self._has_swept else 0

    @property
    def _is_whole(self) -> bool:
        return abs(self._done - self._whole) < NEARLY

    def _at(self, steps: float) -> Whereabouts:
        return self._vehicle.ahead(self._start, steps * STEP, self._turned)

    def _sweep(self, room: int) -> StoppedBy | None:
        vehicle, begun = self._vehicle, self._whole
        plan = vehicle.mover.walk(vehicle.here.truth, self._bearing, room, vehicle.clock.is_active)
        amount = plan.metres / STEP
        done, is_all = self._play(plan.steps, amount, lambda steps: self._at(begun + steps), room)
        self._done = begun + done
        self._whole = begun + min(plan.steps, int(done + NEARLY))
        vehicle.go_to(self._at(self._done))
        if not is_all:
            return StoppedBy.USER if vehicle.clock.was_halted() else None
        self._has_swept = True
        return plan.stopped_by

    def _tick(self) -> StoppedBy | None:
        vehicle = self._vehicle
        is_clear = vehicle.is_clear()
        if not is_clear and self._is_barred():
            return StoppedBy.OBSTACLE
        following = self._next_stop()
        length = (following - self._done) * STEP
        free = length if is_clear else vehicle.way(self._angle, length).metres
        if free < TOUCHING:
            return StoppedBy.COLLISION
        if not vehicle.clock.elapse_until(self._when(self._done + free / STEP)):
            return StoppedBy.USER
        self._go(following, length, free)
        return None

    @property
    def _guard(self) -> float:
        return self._vehicle.mover.walking_guard

    def _free_to(self) -> int:
        """The next whole step."""
        vehicle = self._vehicle
        return self._whole + vehicle.mover.has_free_step(vehicle.here.truth, self._bearing)

    def _stops(self, end: int) -> Sequence[float]:
        return walk_stops(self._course, self._done, end)

    def _land(self, end: int, landing: Landing, count: int) -> StoppedBy | None:
        if landing is Landing.WHOLE:
            self._done = end
            self._arrive(end)
            return None
        stops = (self._done, *self._stops(end))
        over = count if landing is Landing.HALTED else count - 1
        self._done = stops[over]
        self._vehicle.go_to(self._at(self._done))
        if landing is Landing.HALTED:
            return StoppedBy.USER
        length = (stops[count] - self._done) * STEP
        self._go(stops[count], length, length)
        return None

    def _next_stop(self) -> float:
        """A step further if no robot is near or acts, and no moving picture is shown; else a tick further."""
        vehicle = self._vehicle
        is_alone = vehicle.clock.speed is None and self._is_whole and super()._room() > 0
        if is_alone and not vehicle.mover.is_robot_near(vehicle.here.truth, STEP):
            return self._whole + 1
        return min(self._asked, self._course.next_stop(self._done))

    def _push(self, free: float) -> float:
        """Push the things in the way. Returns how many metres are free now."""
        way = self._vehicle.way(self._angle, free)
        self._vehicle.take_along(way, self._angle)
        return way.metres

    def _is_barred(self) -> bool:
        """Check the sensors before every step, and within a step if something else has moved."""
        vehicle, mover, here = self._vehicle, self._vehicle.mover, self._vehicle.here.truth
        if self._is_whole:
            self._looked = vehicle.moment
            return mover.is_blocked(here, self._bearing)
        rest = self._whole + 1 - self._done
        return not vehicle.is_unchanged(self._looked) and mover.is_met(here, self._bearing, rest)

    def _go(self, following: float, length: float, free: float) -> None:
        """Go as far as was free before this robot's turn, and still is."""
        vehicle = self._vehicle
        metres = free if vehicle.is_clear() else self._push(free)
        has_come = metres >= length - TOUCHING
        self._done = following if has_come else self._done + metres / STEP
        if not has_come:
            self._come_to(self._done)
        vehicle.go_to(self._at(self._done))
        vehicle.show()
        if has_come and following == round(following):
            self._arrive(round(following))

    def _arrive(self, whole: int) -> None:
        """Finish a step."""
        self._whole, self._has_swept = whole, False
        self._report_progress()


MOST_GLIDED = 360
"""Degrees of a turn that no watcher sees, in one glide."""


class Turn(Sweeping):
    """A turn on the spot. ``sign``: 1 counter-clockwise, -1 clockwise."""

    def __init__(self, vehicle: Vehicle, motion: Motion, degrees: int, rate: Rate, sign: int) -> None:
        """RobotProblem ``cannot-turn`` if the rate is 0."""
        super().__init__(vehicle, motion, degrees, turning(rate), DEGREES_A_REPORT)
        self._sign = sign

    def _at(self, degrees: float) -> Whereabouts:
        return self._vehicle.turned(self._start, self._sign * degrees)

    def _room(self) -> int:
        """All degrees or none, so that others see the same headings however the turn is divided."""
        left = self._asked - self._whole
        seconds = self._course.seconds(self._whole, left)
        return left if self._vehicle.clock.undisturbed() >= seconds else 0

    def _sweep(self, room: int) -> StoppedBy | None:
        vehicle, begun = self._vehicle, self._whole
        free = self._free(room)
        done, is_all = self._play(free, free, lambda degrees: self._at(begun + degrees), room)
        self._whole = begun + int(done + NEARLY)
        vehicle.go_to(self._at(self._whole))
        if not is_all:
            self._come_to(self._whole)
            return StoppedBy.USER if vehicle.clock.was_halted() else None
        return StoppedBy.COLLISION if free < room else None

    def _tick(self) -> StoppedBy | None:
        vehicle = self._vehicle
        wanted = _in_a_tick(self._course, self._whole, self._asked)
        free = self._free(wanted)
        if free == 0:
            return StoppedBy.COLLISION
        if not vehicle.clock.elapse_until(self._when(self._whole + free)):
            return StoppedBy.USER
        self._turn_on(free)
        vehicle.show()
        self._report_progress()
        return None

    @property
    def _guard(self) -> float:
        return self._vehicle.mover.turning_guard

    def _free_to(self) -> int:
        """The next report, or the end; the same where there is no room to turn."""
        begun = self._whole
        most = MOST_GLIDED if self._vehicle.watcher is None else DEGREES_A_REPORT - begun % DEGREES_A_REPORT
        wanted, here = min(self._asked - begun, most), self._vehicle.here.truth
        return begun + wanted * self._vehicle.mover.has_free_turn(here, self._sign * wanted)

    def _stops(self, end: int) -> Sequence[int]:
        return _turned(self._course, self._whole, end)

    def _land(self, end: int, landing: Landing, count: int) -> StoppedBy | None:
        vehicle = self._vehicle
        if landing is Landing.WHOLE:
            self._whole = end
        else:
            stops = (self._whole, *self._stops(end))
            self._whole = stops[count if landing is Landing.HALTED else count - 1]
            vehicle.go_to(self._at(self._whole))
            if landing is Landing.HALTED:
                return StoppedBy.USER
            self._turn_on(stops[count] - self._whole)
        self._report_progress()
        return None

    def _turn_on(self, wanted: int) -> None:
        """Turns on by that many degrees, of which perhaps fewer are free now."""
        done = self._free(wanted)
        self._whole += done
        if done < wanted:
            self._come_to(self._whole)
        self._vehicle.go_to(self._at(self._whole))

    def _free(self, degrees: int) -> int:
        return abs(self._vehicle.mover.turn(self._vehicle.here.truth, self._sign * degrees))


def _in_a_tick(course: Course, whole: int, end: int) -> int:
    """Degrees of the tick that begins there."""
    to_report = DEGREES_A_REPORT - whole % DEGREES_A_REPORT
    return min(max(1, int(course.further(whole, TICK))), end - whole, to_report)


@lru_cache(maxsize=100)
def _turned(course: Course, whole: int, end: int) -> Sequence[int]:
    """Degrees that are done after each tick up to ``end``."""
    stops = list[int]()
    while whole < end:
        whole += _in_a_tick(course, whole, end)
        stops.append(whole)
    return stops


class Bend(Movement):
    """A car's turn, driving forward on a circle of ``radius`` metres: straight pieces, turned by degrees."""

    def __init__(
        self, vehicle: Vehicle, motion: Motion, degrees: int, rate: Rate, sign: int, radius: float
    ) -> None:
        """RobotProblem ``cannot-turn`` if the rate is 0."""
        super().__init__(vehicle, motion, degrees, turning(rate), DEGREES_A_REPORT)
        self._sign = sign
        chord = 2 * radius * sin(radians(0.5))
        self._pieces = ceil(chord / STEP)
        """Of each degree, none longer than a step."""
        self._length = chord / self._pieces
        self._piece = 0

    def _go_on(self) -> StoppedBy | None:
        vehicle = self._vehicle
        if vehicle.mover.is_blocked(vehicle.here.truth, Bearing.FRONT):
            return StoppedBy.OBSTACLE
        if not self._advance():
            return StoppedBy.COLLISION
        done = self._whole + self._piece / self._pieces
        if not vehicle.clock.elapse_until(self._when(done + 1 / self._pieces)):
            return StoppedBy.USER
        if not self._advance(really=True):
            return StoppedBy.COLLISION
        vehicle.show()
        self._report_progress()
        return None

    def _advance(self, really: bool = False) -> bool:
        """Whether the next piece is free; if so, and ``really``, drive it."""
        vehicle = self._vehicle
        angle = vehicle.here.truth.yaw + self._sign * 0.5
        way = vehicle.way(angle, self._length)
        there = vehicle.ahead(vehicle.here, self._length, self._sign * 0.5)
        turned = self._sign if self._piece == self._pieces - 1 else 0
        if way.metres < self._length - TOUCHING or vehicle.mover.turn(there.truth, turned) != turned:
            return False
        if really:
            vehicle.take_along(way, angle)
            vehicle.go_to(vehicle.turned(there, turned))
            self._piece = (self._piece + 1) % self._pieces
            self._whole += abs(turned)
        return True
