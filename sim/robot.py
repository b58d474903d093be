"""The simulated robot: the port's commands, told in steps and compass degrees, over metres and the world.

Sensors take no time. What a movement comes to, and how it is played, is the business of ``movement``.
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

from devices.ports.robot import (
    STEP,
    Bearing,
    Grip,
    Gripped,
    Motion,
    Moved,
    Pace,
    Pose,
    Pushed,
    Sighting,
    StoppedBy,
    Turned,
    Watcher,
)
from sim.clock import Clock
from sim.ground import Ground
from sim.motion import Mover
from sim.placement import Placement, pose_of
from sim.sensors import CENTIMETRES_A_STEP, Seen
from sim.turns import Seat
from sim.vehicle import Vehicle
from sim.wheels import Rate, moving, odometry_of, rates_of, turning

if TYPE_CHECKING:
    from random import Random

    from sim.meeting import Meeting
    from sim.movement import Going, Movement
    from sim.placement import Spot


class SimulatedRobot:
    """One robot of a world. All but ``halt``, ``pose``, ``time``, ``speed`` and ``known_distances`` is the
    program's thread's."""

    def __init__(
        self,
        ground: Ground,
        robot: int,
        seat: Seat,
        *,
        pace: Pace,
        watcher: Watcher | None,
        speed: float | None,
        seed: int,
    ) -> None:
        """``robot``: the index of its model. ``seed``: of its errors; 0 makes none."""
        self._ground = ground
        self._model = ground.scene.models[robot]
        self._seed = seed
        self._mover = Mover(ground, robot)
        self._clock = Clock(pace, speed, seat)
        self._vehicle = Vehicle(self._mover, self._clock, rates_of(self._model.wheels), watcher)
        self._seen: tuple[Spot, int, dict[Bearing, int]] | None = None
        """What ``known_distances`` told last, from where, and after how many changes around."""
        self._begin_anew()

    @cached_property
    def _meeting(self) -> Meeting:
        from sim.meeting import Meeting  # those who move only

        return Meeting(self._mover, self._ground.scene, self._model.index)

    @property
    def name(self) -> str:
        return self._model.spoken_name

    @property
    def colours(self) -> frozenset[str]:
        eyes = self._mover.senses.eyes
        return eyes.families if eyes is not None else frozenset()

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
        return tuple(self._ground.scene.models[root].name for root in self._mover.around.stands_in)

    @property
    def placement(self) -> Placement:
        """Where it is in truth, in metres. ``pose`` is what the robot believes."""
        spot = self._vehicle.here.truth
        return Placement(spot.x, spot.y, self._model.pose.z, spot.yaw)

    @property
    def holds(self) -> int | None:
        """The index of the thing in its gripper."""
        return self._vehicle.hand.held

    def join(self) -> None:
        """Take part in the world's order; returns when it is this robot's turn, or after a stop.

        The program's thread calls it before the first statement, and ``leave`` when the run is over.
        """
        self._clock.join()

    def leave(self) -> None:
        """Take part no more, having joined or not: nobody waits for this robot any longer."""
        self._clock.leave()

    def reset(self) -> None:
        """Back to the start: place, heading, gripper, time; and all things, if no other robot takes part."""
        self._begin_anew()
        if not self._clock.has_company:
            self._ground.put_things_back()
        self._clock.reset()

    def forward(self, steps: int) -> Moved:
        """Walk forward. ValueError if ``steps`` is negative."""
        return self._walk(Motion.FORWARD, steps, self._vehicle.rates.forward)

    def backward(self, steps: int) -> Moved:
        """Walk backward. ValueError if ``steps`` is negative."""
        return self._walk(Motion.BACKWARD, steps, self._vehicle.rates.backward)

    def turn(self, degrees: int) -> Turned:
        """On the spot; a car drives forward on its smallest circle. RobotProblem ``cannot-turn``."""
        from sim.movement import Bend, Turn

        rates = self._vehicle.rates
        motion, sign = (Motion.RIGHT, -1) if degrees >= 0 else (Motion.LEFT, 1)
        rate = turning(rates.right if degrees >= 0 else rates.left)
        movement: Movement
        if rates.bend is None:
            movement = Turn(self._vehicle, motion, abs(degrees), rate, sign)
        else:
            movement = Bend(self._vehicle, motion, abs(degrees), rate, sign, rates.bend)
        turned, stopped_by = self._run(movement)
        met = self._meeting.turning(self._vehicle.here.truth, stopped_by)
        return Turned(degrees, -sign * turned, stopped_by, self.pose(), met, self._pushed())

    def wait(self, seconds: float) -> bool:
        asked = max(0.0, seconds)
        if not self._clock.begin():
            return False
        spent = self._clock.spend(asked, ()) if self._clock.undisturbed() >= asked else 0.0
        return spent >= asked or (not self._clock.was_halted() and self._clock.elapse(asked - spent))

    def time(self) -> float:
        return self._clock.seconds

    def pose(self) -> Pose:
        """Where the robot believes to be: the truth, unless it counts its wheels' turns with errors."""
        return pose_of(self._vehicle.here.belief)

    def distance(self, bearing: Bearing) -> int:
        """RobotProblem ``no-sensor`` (bearing) if nothing looks there."""
        self._clock.begin()
        return self._mover.senses.steps(self._mover.around, self._vehicle.here.truth, bearing, self._chance)

    def known_distances(self) -> dict[Bearing, int]:
        """Where nothing has moved since somebody looked, they are what they were."""
        spot, changes = self._vehicle.here.truth, self._vehicle.changes_around
        seen = self._seen
        if seen is None or seen[:2] != (spot, changes):
            seen = self._seen = spot, changes, self._mover.senses.all_steps(self._mover.around, spot)
        return dict(seen[2])

    def scan(self) -> tuple[Sighting, ...]:
        """RobotProblem ``no-eyes`` if it has none."""
        self._clock.begin()
        things = self._mover.senses.look(self._mover.around, self._vehicle.here.truth)
        return tuple(self._sighting(seen) for seen in things)

    def grip(self) -> Gripped:
        """Take the thing between the paddles, or a step before them. RobotProblem ``no-gripper``."""
        self._clock.begin()
        outcome = self._vehicle.grip()
        return self._gripped(outcome, self.holds)

    def release(self) -> Gripped:
        """Let go what is held; it stays there. RobotProblem ``no-gripper``."""
        self._clock.begin()
        held = self.holds
        return self._gripped(self._vehicle.release(), held)

    def halt(self) -> None:
        self._clock.halt()

    def _begin_anew(self) -> None:
        self._chance = self._new_chance() if self._seed else None
        self._vehicle.begin_anew(odometry_of(self._model.wheels, self._chance))

    def _new_chance(self) -> Random:
        from random import Random  # loaded where there is chance

        return Random(f"{self._seed} {self.name}")

    def _walk(self, motion: Motion, steps: int, rate: Rate) -> Moved:
        if steps < 0:
            raise ValueError("a walk has no negative steps")
        metres, turned = steps * STEP, 180.0 if motion is Motion.BACKWARD else 0.0
        if self._vehicle.leap(metres, turned, moving(rate).over(steps).seconds(0.0, metres / STEP)):
            return Moved(steps, steps, None, self.pose())
        from sim.movement import Walk

        walked, stopped_by = self._run(Walk(self._vehicle, motion, steps, rate))
        met = self._meeting.walking(self._vehicle.here.truth, turned, stopped_by)
        return Moved(steps, walked, stopped_by, self.pose(), met, self._pushed())

    def _run(self, movement: Movement) -> Going:
        self._vehicle.pushed.clear()
        return movement.run() if self._clock.begin() else (0, StoppedBy.USER)

    def _pushed(self) -> tuple[Pushed, ...]:
        """What the last movement pushed."""
        return tuple(self._as_pushed(root, metres) for root, metres in self._vehicle.pushed.items())

    def _as_pushed(self, root: int, metres: float) -> Pushed:
        model = self._ground.scene.models[root]
        return Pushed(model.kind, self._name_of(root), model.colour.family, metres / STEP)

    def _gripped(self, outcome: Grip, root: int | None) -> Gripped:
        if root is None:
            return Gripped(outcome)
        model = self._ground.scene.models[root]
        return Gripped(outcome, self._name_of(root), model.kind, model.colour.family)

    def _sighting(self, seen: Seen) -> Sighting:
        return Sighting(
            degrees=-round(seen.degrees, 9) + 0.0,
            steps=seen.centimetres / CENTIMETRES_A_STEP,
            colour=seen.colour.family,
            name=self._name_of(seen.root),
        )

    def _name_of(self, root: int | None) -> str:
        """As its world calls it; empty where it only has a number."""
        name = "" if root is None else self._ground.scene.models[root].spoken_name
        return "" if ":" in name else name
