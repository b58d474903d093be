"""The simulated robot: the port's commands, told in steps and compass degrees, over metres and the world.

It walks a step (0.05 m) and turns 45 degrees in a second of robot time; sensors take no time. What a command
comes to is computed at once, then played: progress is told at its times, at any speed in the same order.
"""

from __future__ import annotations

from collections.abc import Callable
from math import copysign

from devices.ports.robot import (
    STEP,
    Bearing,
    Motion,
    Moved,
    Pace,
    Pose,
    Sighting,
    StoppedBy,
    Turned,
    Watcher,
)
from sim.clock import Clock, Mark
from sim.motion import Mover, body_of, guard_distance
from sim.physics import Surroundings
from sim.placement import Placement
from sim.scene import Scene
from sim.sensors import CENTIMETRES_A_STEP, Seen, Spot, senses_of
from sim.turns import Seat

STEPS_A_SECOND = 1.0
DEGREES_A_SECOND = 45.0
DEGREES_A_REPORT = 10
MOST_REPORTS = 1000
"""Of a longer movement only every so many-th step is told, so that a huge one stays short."""

_BEARINGS = {Motion.FORWARD: Bearing.FRONT, Motion.BACKWARD: Bearing.BACK}


class SimulatedRobot:
    """One robot of a scene. All but ``halt``, ``pose``, ``time`` and ``speed`` is the program's thread's."""

    def __init__(
        self,
        scene: Scene,
        name: str | None = None,
        *,
        pace: Pace,
        watcher: Watcher | None = None,
        speed: float | None = None,
        seed: int = 0,
        seat: Seat | None = None,
    ) -> None:
        """The robot called ``name``, or the world's first one.

        KeyError if the world has no such robot. ``seed`` is for sensors with noise, which no world has yet.
        """
        if not scene.robots:
            raise KeyError(name or "")
        self._model = scene.robot(name) if name is not None else scene.models[scene.robots[0]]
        self._scene = scene
        self._watcher = watcher
        self.seed = seed
        self._senses = senses_of(scene, self._model.index)
        body = body_of(scene, self._model.index)
        guard = guard_distance(body, self._senses.rangers)
        self._around = Surroundings(scene, self._model.index, guard)
        self._mover = Mover(self._around, body, self._senses)
        self._clock = Clock(pace, speed, seat)
        self._start = Spot(self._model.pose.x, self._model.pose.y, self._model.pose.yaw % 360.0)
        self._spot = self._start

    @property
    def name(self) -> str:
        return self._model.name

    @property
    def colours(self) -> frozenset[str]:
        return self._senses.eyes.families if self._senses.eyes is not None else frozenset()

    @property
    def speed(self) -> float | None:
        """A multiple of real time; None is unlimited. Any thread may set it, at any time."""
        return self._clock.speed

    @speed.setter
    def speed(self, speed: float | None) -> None:
        if speed is not None and not speed > 0:
            raise ValueError("a speed is above 0, or None")
        self._clock.speed = speed

    @property
    def stands_in(self) -> tuple[str, ...]:
        """Names of the things that the robot's world puts it inside of; they are not there for it."""
        return tuple(self._scene.models[root].name for root in self._around.stands_in)

    @property
    def placement(self) -> Placement:
        """Where it is in truth."""
        return Placement(self._spot.x, self._spot.y, self._model.pose.z, self._spot.yaw)

    def join(self) -> None:
        """Take part in the world's order; returns when it is this robot's turn, or after a stop.

        The program's thread calls it before the first statement, and ``leave`` when the run is over.
        """
        self._clock.join()

    def leave(self) -> None:
        """Take part no more, having joined or not: nobody waits for this robot any longer."""
        self._clock.leave()

    def reset(self) -> None:
        """Back to the start: place, heading and time."""
        self._spot = self._start
        self._clock.reset()

    def forward(self, steps: int) -> Moved:
        """Walk forward. ValueError if ``steps`` is negative."""
        return self._walk(Motion.FORWARD, steps)

    def backward(self, steps: int) -> Moved:
        """Walk backward. ValueError if ``steps`` is negative."""
        return self._walk(Motion.BACKWARD, steps)

    def turn(self, degrees: int) -> Turned:
        start = self._spot
        self._clock.begin()
        turnable = -self._mover.turn(start, -degrees)
        side = Motion.RIGHT if degrees >= 0 else Motion.LEFT
        sign = 1 if degrees >= 0 else -1

        def turned_by(seconds: float) -> Spot:
            return _turned(start, sign * seconds * DEGREES_A_SECOND)

        def exactly(turned: int) -> Spot:
            return _turned(start, sign * turned)

        marks = self._marks(side, abs(turnable), DEGREES_A_REPORT, DEGREES_A_SECOND, exactly)
        seconds = abs(turnable) / DEGREES_A_SECOND
        spent = self._play(seconds, marks, turned_by)
        if spent < seconds:
            done = int(spent * DEGREES_A_SECOND + 1e-6)
            self._spot = exactly(done)
            return Turned(degrees, sign * done, StoppedBy.USER, self.pose())
        self._spot = exactly(abs(turnable))
        stopped_by = None if turnable == degrees else StoppedBy.COLLISION
        return Turned(degrees, turnable, stopped_by, self.pose())

    def wait(self, seconds: float) -> bool:
        asked = max(0.0, seconds)
        if not self._clock.begin():
            return False
        spent = self._clock.spend(asked, ()) if self._clock.undisturbed() >= asked else 0.0
        return spent >= asked or (not self._clock.was_halted() and self._clock.elapse(asked - spent))

    def time(self) -> float:
        return self._clock.seconds

    def pose(self) -> Pose:
        return _pose(self._spot)

    def distance(self, bearing: Bearing) -> int:
        self._clock.begin()
        return self._senses.steps(self._around, self._spot, bearing)

    def scan(self) -> tuple[Sighting, ...]:
        self._clock.begin()
        return tuple(self._sighting(seen) for seen in self._senses.look(self._around, self._spot))

    def halt(self) -> None:
        self._clock.halt()

    def _walk(self, motion: Motion, steps: int) -> Moved:
        if steps < 0:
            raise ValueError("a walk has no negative steps")
        start, bearing = self._spot, _BEARINGS[motion]
        angle = start.yaw + (180.0 if motion is Motion.BACKWARD else 0.0)
        self._clock.begin()
        walk = self._mover.walk(start, bearing, steps, self._clock.goes_on)

        def walked_by(seconds: float) -> Spot:
            return start.ahead(seconds * STEPS_A_SECOND * STEP, angle)

        def exactly(walked: int) -> Spot:
            return start.ahead(walked * STEP, angle)

        marks = self._marks(motion, walk.steps, 1, STEPS_A_SECOND, exactly)
        seconds = walk.metres / STEP / STEPS_A_SECOND
        spent = self._play(seconds, marks, walked_by)
        if spent < seconds:
            self._spot = walked_by(spent)
            walked = min(walk.steps, int(spent * STEPS_A_SECOND + 1e-6))
            return Moved(steps, walked, StoppedBy.USER, self.pose())
        self._spot = start.ahead(walk.metres, angle)
        return Moved(steps, walk.steps, walk.stopped_by, self.pose())

    def _marks(
        self, motion: Motion, count: int, every: int, a_second: float, at: Callable[[int], Spot]
    ) -> list[Mark]:
        """When to tell what of a movement of ``count`` steps or degrees; the rest at its end is told too."""
        if count == 0 or self._watcher is None:
            return []
        stride = every * -(-count // (every * MOST_REPORTS))
        amounts = [*range(stride, count, stride), count]
        return [(amount / a_second, self._telling(motion, at, amount)) for amount in amounts]

    def _telling(self, motion: Motion, at: Callable[[int], Spot], amount: int) -> Callable[[], None]:
        def tell() -> None:
            self._spot = at(amount)
            if self._watcher is not None:
                self._watcher.progressed(motion, self.pose())

        return tell

    def _play(self, seconds: float, marks: list[Mark], place: Callable[[float], Spot]) -> float:
        """Let the movement happen. Answers the seconds that it took."""

        def passing(spent: float) -> None:
            self._spot = place(spent)
            if self._watcher is not None:
                self._watcher.passing(self.pose())

        return self._clock.spend(seconds, marks, passing)

    def _sighting(self, seen: Seen) -> Sighting:
        name = self._scene.models[seen.root].name
        return Sighting(
            degrees=-round(seen.degrees, 9) + 0.0,
            steps=seen.centimetres / CENTIMETRES_A_STEP,
            colour=seen.colour.family,
            name="" if ":" in name else name,
        )


def _turned(spot: Spot, degrees: float) -> Spot:
    """After a turn to the right. Whole degrees stay exact."""
    return Spot(spot.x, spot.y, (spot.yaw - degrees) % 360.0)


def _pose(spot: Spot) -> Pose:
    """In steps and compass degrees; rounded far below what matters, so that three steps are not 2.9999."""
    heading = round((90.0 - spot.yaw) % 360.0, 9) % 360.0
    return Pose(_whole(spot.x), _whole(spot.y), heading)


def _whole(metres: float) -> float:
    steps = round(metres / STEP, 9)
    return copysign(steps, 1.0) if steps == 0 else steps
