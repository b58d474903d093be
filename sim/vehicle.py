"""A moving robot: its true and its believed pose, its drive and its load.

A robot walks one step (0.05 m) or turns 45 degrees in a second, more slowly where its world limits its
velocity or acceleration. A limited acceleration makes a trapezoid of the speed: the top speed is reached only
if the way is long enough. A movement has its end from the start; an obstacle stops it at once. Amounts are
steps or degrees from the start of the movement. Odometry has an error that is drawn once, from a seed, as in
Stage.
"""

from __future__ import annotations

from functools import cache, cached_property, lru_cache
from math import degrees, floor, inf, radians, sqrt
from typing import TYPE_CHECKING, TypeAlias

from msgspec import Struct

from devices.ports.robot import STEP, Grip, Motion, RobotProblem, Watcher
from sim.clock import SLICE, Clock, Glide, Landing
from sim.geometry import Placement, Spot, pose_of
from sim.ground import Ground, Moment
from sim.handling import Hand
from sim.motion import SIGHT, Mover
from sim.scene import Bounds, Drive, Limits, Localization, Wheels

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from random import Random

    from sim.handling import Advance, Pushing
    from sim.motion import Meeting


TICK = 1 / 20
"""The longest tick in seconds of robot time: in it a robot that others may disturb sees nothing move."""
NEARLY = 1e-6
"""Steps or degrees by which a sum of fractions may miss whole ones."""
_FINEST = 1e-5
"""Steps: no tick is shorter, however slowly a robot begins."""


class Rate(Struct, frozen=True):
    """The top speed of a movement, and its acceleration and deceleration. 0: it can't move."""

    top: float
    """Steps or degrees a second."""
    up: float = inf
    """A second more."""
    down: float = inf

    def over(self, asked: float) -> Course:
        """The course of a movement of so much."""
        return _even(self.top) if self.up == self.down == inf else Ramped(self, asked)


class Even:
    """The distance of a movement over time, at one speed."""

    def __init__(self, rate: float) -> None:
        self._rate = rate
        self._ticks_a_step = max(1, -floor(-(1.0 / (rate * TICK) - NEARLY)))

    def seconds(self, done: float, further: float) -> float:  # noqa: ARG002 -- the same everywhere
        """The seconds to go ``further`` after ``done``."""
        return further / self._rate

    def further(self, done: float, seconds: float) -> float:  # noqa: ARG002 -- the same everywhere
        """The distance in ``seconds`` after ``done``."""
        return seconds * self._rate

    def times(self, began: float, done: Sequence[float]) -> list[float]:
        """The times at which each of these amounts is done, if it began at that time."""
        rate = self._rate
        return [began + each / rate for each in done]

    def next_stop(self, done: float) -> float:
        """Where a tick of a walk ends that begins after ``done`` steps: at the next whole one at most."""
        ticks = self._ticks_a_step
        return (floor(done * ticks + NEARLY) + 1) / ticks


_even = cache(Even)


class Ramped:
    """The same with acceleration and deceleration; a short one never reaches the top speed."""

    def __init__(self, rate: Rate, asked: float) -> None:
        slowness = 1.0 / rate.up + 1.0 / rate.down
        self._up, self._down, self._asked = rate.up, rate.down, asked
        self._top = min(rate.top, sqrt(2.0 * asked / slowness))
        self._rising, self._falling = (self._top**2 / (2.0 * each) for each in (rate.up, rate.down))
        """The ways on which it gets faster and slower."""
        self._risen, fall = self._top / rate.up, self._top / rate.down
        """Seconds."""
        level = asked - self._rising - self._falling
        self._falls = self._risen + (level / self._top if level > 0.0 else 0.0)
        self._end = self._falls + fall

    def seconds(self, done: float, further: float) -> float:
        return self._when(done + further) - self._when(done)

    def further(self, done: float, seconds: float) -> float:
        return self._where(self._when(done) + seconds) - done

    def times(self, began: float, done: Sequence[float]) -> list[float]:
        return [began + self.seconds(0.0, each) for each in done]

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


Course: TypeAlias = Even | Ramped
"""The distance of a movement over time."""


@lru_cache(maxsize=200)
def walk_stops(course: Course, done: float, end: float) -> tuple[float, ...]:
    """Where the ticks of a walk from ``done`` to ``end`` steps end."""
    stops = list[float]()
    while done < end:
        done = min(end, course.next_stop(done))
        stops.append(done)
    return tuple(stops)


STEPS_A_SECOND = 1.0
DEGREES_A_SECOND = 45.0
LEAST = 1e-3
"""A velocity below this part of the usual one is none: a command would take for ever."""
LEAST_GAIN = 1e-2
"""The same of an acceleration: what a second adds to the velocity, as a part of the usual one."""


class Rates(Struct, frozen=True):
    """The rates of a robot. 0: it can't move so."""

    forward: Rate = Rate(STEPS_A_SECOND)
    """In steps."""
    backward: Rate = Rate(STEPS_A_SECOND)
    right: Rate = Rate(DEGREES_A_SECOND)
    """In degrees."""
    left: Rate = Rate(DEGREES_A_SECOND)
    bend: float | None = None
    """Metres: the radius of the smallest circle that a car drives; None turns on the spot."""


def rates_of(wheels: Wheels | None) -> Rates:
    """The rates of the wheels, or the usual ones where there are none."""
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
    """The rates towards both bounds; an acceleration one way is a deceleration the other way."""
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


class Odometry(Struct, frozen=True):
    """Computes the believed place from driven distances. Errors are fractions."""

    along: float = 0.0
    turn: float = 0.0

    @property
    def is_exact(self) -> bool:
        return self.along == 0.0 and self.turn == 0.0

    def ahead(self, belief: Spot, metres: float, turned: float) -> Spot:
        """The belief after that many metres in the direction ``turned`` from the front."""
        return belief.ahead(metres * (1.0 + self.along), belief.yaw + turned)

    def turned(self, belief: Spot, degrees: float) -> Spot:
        """The belief after that many degrees counter-clockwise."""
        return Spot(belief.x, belief.y, (belief.yaw + degrees * (1.0 + self.turn)) % 360.0)


def odometry_of(wheels: Wheels | None, chance: Random | None) -> Odometry:
    """Exact without ``chance``, and for a robot that knows where it is."""
    if wheels is None or chance is None or wheels.localization is not Localization.ODOM:
        return Odometry()
    error = wheels.odom_error
    return Odometry((chance.random() - 0.5) * error.x, (chance.random() - 0.5) * error.yaw)


CLEARANCE = 0.3
"""Metres: a robot that has that much room more than it needs looks around again only after a while."""


class Whereabouts(Struct, frozen=True):
    """The true and the believed place of a robot."""

    truth: Spot
    belief: Spot


class Vehicle:
    """Shared by all movements of one robot. Only ``here`` is for other threads."""

    def __init__(
        self, ground: Ground, robot: int, clock: Clock, watcher: Watcher | None, chance: Random | None
    ) -> None:
        """A robot that stands at its start. ``robot``: the index of its model; ``chance``: of its errors."""
        self.mover = Mover(ground, robot)
        self.clock = clock
        self._wheels = ground.scene.models[robot].wheels
        self.rates = rates_of(self._wheels)
        self.watcher = watcher
        self.hand = Hand(self.mover)
        self._root = robot
        self._z = ground.start(robot).z
        self._ground = ground
        self._jumps = -1
        self.quicken()
        self.pushed: dict[int, float] = {}
        """Roots of things that the movement has pushed so far, and how many metres."""
        self.here = self._begin(chance)

    @cached_property
    def _pushing(self) -> Pushing:
        from sim.handling import Pushing  # loaded at the first movement

        return Pushing(self._ground, self.mover)

    @cached_property
    def meeting(self) -> Meeting:
        """Finds what ended a movement."""
        from sim.motion import Meeting  # loaded at the first movement

        return Meeting(self.mover, self._ground.scene, self._root)

    def begin_anew(self, chance: Random | None) -> None:
        """Reset to the start with an empty gripper; the held thing stays in its place."""
        self.hand.let_go()
        self.go_to(self._begin(chance))

    def _begin(self, chance: Random | None) -> Whereabouts:
        """Forget everything, and return the start."""
        self.odometry = odometry_of(self._wheels, chance)
        self._leaps = self.odometry.is_exact and self.watcher is None
        self._shown = self._clear_until = -inf
        start = self._ground.start(self._root)
        spot = Spot(start.x, start.y, start.yaw)
        return Whereabouts(spot, spot)

    def pass_by(self, where: Whereabouts) -> None:
        """Update this robot's pose for queries; the ground gets it at the end of the movement."""
        self.here = where

    def go_to(self, where: Whereabouts) -> None:
        """Set the pose, and publish it to the other robots."""
        self.here = where
        if self.mover.around.has_company:
            self._ground.put(self._root, self._placed(where))
            self.hand.carry(where.truth)
            if not self.clock.takes_part:
                self._ground.jump()

    def _placed(self, where: Whereabouts) -> Placement:
        spot = where.truth
        return Placement(spot.x, spot.y, self._z, spot.yaw)

    def quicken(self) -> None:
        """Report to the ground how fast points of the changed body may be."""
        self._clear_until = -inf
        rates = self.rates
        turning = radians(max(rates.right.top, rates.left.top)) * self.mover.body.radius
        self._ground.quicken(max(rates.forward.top, rates.backward.top) * STEP + turning)

    @property
    def moment(self) -> Moment:
        """See ``Ground.moment``."""
        return self._ground.moment(self._root)

    def is_unchanged(self, since: Moment) -> bool:
        """Whether nothing else has moved since that moment."""
        return self._ground.is_unchanged(self._root, since)

    def is_clear(self) -> bool:
        """Whether nothing can come in the way of the next tick.

        The result stays valid for a while; another robot's last tick moves it a step at most.
        """
        seconds, ground = self.clock.seconds, self._ground
        if self._clear_until >= seconds + TICK and self._jumps == ground.jumps:
            return True
        self._clear_until, self._jumps = -inf, ground.jumps
        if self.clock.takes_part and not self.glides and self.mover.is_far(self.here.truth, CLEARANCE + STEP):
            self._clear_until = seconds + CLEARANCE / (2 * ground.fastest)
        return self._clear_until >= seconds + TICK

    def is_alone(self) -> bool:
        """Whether nothing that may move is so near that it could stop a movement, and it holds nothing."""
        here, reach = self.here.truth, max(self.mover.guard, self.mover.body.radius + SIGHT)
        return not self._ground.roots_within(self._root, here.x, here.y, reach)

    def ahead(self, start: Whereabouts, metres: float, turned: float) -> Whereabouts:
        """So far from ``start`` in the direction that is ``turned`` degrees from the front."""
        truth = start.truth.ahead(metres, start.truth.yaw + turned)
        if self.odometry.is_exact:
            return Whereabouts(truth, truth)
        return Whereabouts(truth, self.odometry.ahead(start.belief, metres, turned))

    def leap(self, steps: int, rate: Rate, turned: float) -> bool:
        """Go straight at once, if nothing is near, watches or waits. False: did nothing.

        The same result as a ``Walk``; this is the fast way for most commands of most programs.
        RobotProblem ``cannot-drive`` if the rate is 0.
        """
        if not self._leaps or not self.clock.may_leap():
            return False
        here, metres = self.here.truth, steps * STEP
        there = here.ahead(metres, here.yaw + turned)
        seconds = moving(rate).over(steps).seconds(0.0, metres / STEP)
        if not self.mover.around.has_room(here.x, here.y, there.x, there.y):
            return False
        self.clock.leap(seconds)
        self.go_to(Whereabouts(there, there))
        return True

    def turned(self, start: Whereabouts, degrees: float) -> Whereabouts:
        """Turned counter-clockwise. Whole degrees stay exact."""
        it = start.truth
        truth = Spot(it.x, it.y, (it.yaw + degrees) % 360.0)
        if self.odometry.is_exact:
            return Whereabouts(truth, truth)
        return Whereabouts(truth, self.odometry.turned(start.belief, degrees))

    @property
    def glides(self) -> bool:
        """Whether it glides where nothing is near: in company, at unlimited speed, with empty hands."""
        clock = self.clock
        return clock.speed is None and clock.takes_part and self.hand.held is None

    def glide(
        self,
        there: Whereabouts,
        last: float,
        times: Callable[[], Sequence[float]],
        at: Callable[[int], Whereabouts],
        guard: float,
    ) -> tuple[Landing, int] | None:
        """Go straight on to a place, or turn there, until the time ``last``; ``guard`` as for ``Glide``.

        ``times``: at the end of each tick; ``at``: where that many ticks lead. Answers how it ended, and
        after how many ticks if not as a whole; None, and nothing has happened, where it must not begin.
        """
        ground, root, here = self._ground, self._root, self.here.truth
        way = here.x, here.y, there.truth.x, there.truth.y
        glide = Glide(root, self.clock, times, lambda count: self._placed(at(count)), way, guard)
        if not ground.begin_glide(glide):
            return None
        landing, end = Landing.HALTED, None
        try:
            landing = self.clock.follow(glide, last)
            if landing is Landing.WHOLE:
                self.here, end = there, self._placed(there)
        finally:
            ground.end_glide(root, end)
        return landing, glide.count or 0

    def way(self, angle: float, length: float) -> Advance:
        """Compute that many metres (at most a step) to ``angle``, from here."""
        return self._pushing.advance(self.here.truth, angle, length)

    def grip(self) -> Grip:
        """See ``Hand.grip``."""
        outcome = self.hand.grip(self.here.truth)
        self.quicken()
        return outcome

    def release(self) -> Grip:
        """See ``Hand.release``."""
        outcome = self.hand.release()
        self.quicken()
        return outcome

    def take_along(self, advance: Advance, angle: float) -> None:
        """Move the things that the way pushes."""
        for root, metres in advance.pushed:
            self.pushed[root] = self.pushed.get(root, 0.0) + metres
        self._pushing.take_along(advance, angle)

    def show(self) -> None:
        """Reports the current pose, some 20 times a second of real time; not at unlimited speed."""
        speed, seconds = self.clock.speed, self.clock.seconds
        if speed is not None and self.watcher is not None and seconds - self._shown > 0.9 * SLICE * speed:
            self._shown = seconds
            self.watcher.passing(pose_of(self.here.truth))

    def report(self, motion: Motion) -> None:
        """Reports one more whole step, or that many degrees."""
        if self.watcher is not None:
            self.watcher.progressed(motion, pose_of(self.here.belief))
