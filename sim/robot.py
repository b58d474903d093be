"""The simulated robot: the port's commands in steps and compass degrees, carried out in the world.

Sensors take no time. ``movement`` computes movements and plays them. The vehicle and its sensors are made
when the robot is first asked to move or to look; a program that only speaks does not need them.
"""

from __future__ import annotations

import threading
from functools import cached_property, partial
from typing import TYPE_CHECKING

from devices.ports.robot import (
    STEP,
    Bearing,
    Grip,
    GripResult,
    Met,
    Motion,
    Pace,
    Pose,
    Pushed,
    Sighting,
    StoppedBy,
    TurnResult,
    WalkResult,
    Watcher,
)
from sim.clock import Clock, Seat
from sim.colours import families
from sim.geometry import Placement, pose_of
from sim.ground import MOST_LOOKS, Ground, Moment

if TYPE_CHECKING:
    from collections.abc import Callable, Hashable
    from random import Random

    from sim.cameras import Found, Seen
    from sim.geometry import Spot
    from sim.movement import Bend, Movement, Turn, Walk
    from sim.vehicle import Rate, Vehicle, Whereabouts


_Outcome = tuple[int, StoppedBy | None, Met | None]
_FINAL = (StoppedBy.OBSTACLE, StoppedBy.COLLISION)


class SimulatedRobot:
    """One robot of a world. All but ``halt``, ``pose``, ``time``, ``speed``, ``known_distances`` and
    ``get_ready`` is the program's thread's."""

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
        self._watcher = watcher
        self._clock = Clock(pace, speed, seat)
        self._chance = self._new_chance()
        self._making = threading.Lock()
        """Held while the vehicle is made or reset."""
        self._vehicle: Vehicle | None = None
        self._refused: dict[tuple[Motion, int], _Outcome] = {}
        """Movements that did nothing if the robot stands, what ended them, and what was met."""
        self._refused_at: Whereabouts | None = None
        self._seen: tuple[Spot, Moment, dict[Bearing, int]] | None = None
        """The last result of ``known_distances``, its pose, and the number of changes in the world then."""
        self._scanned: tuple[Spot, int | None, Moment, tuple[Sighting, ...]] | None = None
        """The last result of ``scan``, its pose, what was held, and the number of changes then."""

    @property
    def name(self) -> str:
        return self._model.spoken_name

    @cached_property
    def colours(self) -> frozenset[str]:
        models = self._ground.scene.tree(self._model.index)
        return families(each.blobfinder.colours for each in models if each.blobfinder is not None)

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
        return tuple(self._ground.scene.models[root].name for root in self.get_ready().mover.around.stands_in)

    @property
    def is_in_the_open(self) -> bool:
        """Whether its world has nothing that a distance sensor could ever find, but for robots."""
        scene = self._ground.scene
        return not any(
            each.ranger_return > 0 and (each.polygons or each.walls)
            for each in scene.models
            if each.root not in scene.robots
        )

    @property
    def placement(self) -> Placement:
        """The true place, in metres. ``pose`` is the believed one."""
        if self._vehicle is None:
            return self._ground.start(self._model.index)
        spot = self._vehicle.here.truth
        return Placement(spot.x, spot.y, self._model.pose.z, spot.yaw)

    @property
    def situation(self) -> Hashable | None:
        """Equal if the robot and all around it are the same again; None if chance decides, too."""
        if self._chance is not None:
            return None
        vehicle = self._vehicle
        return () if vehicle is None else (vehicle.here, self.holds, vehicle.moment)

    @property
    def holds(self) -> int | None:
        """The index of the thing in its gripper."""
        return None if self._vehicle is None else self._vehicle.hand.held

    def get_ready(self) -> Vehicle:
        """The vehicle, made on first use. Any thread; repeated calls block no other thread."""
        return self._vehicle or self._made()

    def _made(self) -> Vehicle:
        with self._making:
            if self._vehicle is None:
                from sim.vehicle import Vehicle

                self._vehicle = Vehicle(
                    self._ground, self._model.index, self._clock, self._watcher, self._chance
                )
            return self._vehicle

    @cached_property
    def _movements(self) -> tuple[type[Walk], type[Turn], type[Bend]]:
        """The classes of movements, imported at the first movement and cached."""
        from sim.movement import Bend, Turn, Walk

        return Walk, Turn, Bend

    def join(self) -> None:
        """Take part in the world's order; returns when it is this robot's turn, or after a stop.

        The program's thread calls it before the first statement, and ``leave`` when the run is over.
        """
        self._clock.join()

    def leave(self) -> None:
        """Leave the turns, joined or not: no program waits for this robot any more."""
        self._clock.leave()

    def reset(self) -> None:
        """Reset place, heading, gripper and time; and all things, if no other robot takes part."""
        self.go_home()
        if not self._clock.has_company:
            self._ground.put_things_back()
        self._clock.reset()

    def go_home(self) -> None:
        """Put the robot to its start with an empty gripper; the held thing stays in its place."""
        with self._making:
            self._chance = self._new_chance()
            if self._vehicle is not None:
                self._vehicle.begin_anew(self._chance)

    def stand_on(self, ground: Ground, robot: int) -> None:
        """Keep the robot's place in a rebuilt world. ``robot``: the index of its model there."""
        with self._making:
            before, self._vehicle, self._seen, self._scanned = self._vehicle, None, None, None
            self._refused_at = None
            self._ground, self._model = ground, ground.scene.models[robot]
            if before is not None:
                from sim.vehicle import Vehicle

                vehicle = Vehicle(ground, robot, self._clock, self._watcher, self._chance)
                vehicle.odometry = before.odometry
                vehicle.go_to(before.here)
                self._vehicle = vehicle

    def forward(self, steps: int) -> WalkResult:
        """Walk forward. ValueError if ``steps`` is negative."""
        vehicle = self.get_ready()
        return self._walk(vehicle, Motion.FORWARD, steps, vehicle.rates.forward)

    def backward(self, steps: int) -> WalkResult:
        """Walk backward. ValueError if ``steps`` is negative."""
        vehicle = self.get_ready()
        return self._walk(vehicle, Motion.BACKWARD, steps, vehicle.rates.backward)

    def turn(self, degrees: int) -> TurnResult:
        """Turn on the spot; a car drives forward on its smallest circle. RobotProblem ``cannot-turn``."""
        vehicle, (_, on_the_spot, on_a_circle) = self.get_ready(), self._movements
        rates = vehicle.rates
        motion, sign = (Motion.RIGHT, -1) if degrees >= 0 else (Motion.LEFT, 1)
        rate = rates.right if degrees >= 0 else rates.left
        movement: Movement
        if rates.bend is None:
            movement = on_the_spot(vehicle, motion, abs(degrees), rate, sign)
        else:
            movement = on_a_circle(vehicle, motion, abs(degrees), rate, sign, rates.bend)
        turned, stopped_by, met = self._run(vehicle, (motion, degrees), movement, vehicle.meeting.turning)
        return TurnResult(degrees, -sign * turned, stopped_by, self.pose(), met, self._pushed(vehicle))

    def wait(self, seconds: float) -> bool:
        asked = max(0.0, seconds)
        if not self._clock.begin():
            return False
        spent = self._clock.spend(asked, ()) if self._clock.undisturbed() >= asked else 0.0
        return spent >= asked or (not self._clock.was_halted() and self._clock.elapse(asked - spent))

    def time(self) -> float:
        return self._clock.seconds

    def pose(self) -> Pose:
        """The believed pose: the true one, unless odometry has errors."""
        vehicle = self._vehicle
        return pose_of(self._ground.start(self._model.index) if vehicle is None else vehicle.here.belief)

    def true_pose(self) -> Pose | None:
        """None without errors of odometry."""
        vehicle = self._vehicle
        return None if vehicle is None or vehicle.odometry.is_exact else pose_of(vehicle.here.truth)

    def distance(self, bearing: Bearing) -> int:
        """RobotProblem ``no-sensor`` (bearing) if nothing looks there."""
        self._clock.begin()
        vehicle = self._vehicle or self._made()  # most commands of a program are this one
        mover = vehicle.mover
        return mover.senses.steps(mover.around, vehicle.here.truth, bearing, self._chance)

    @property
    def ranger_names(self) -> tuple[str, ...]:
        """The names of its distance sensors that ``named_distance`` takes."""
        return tuple(self.get_ready().mover.senses.by_name)

    def named_distance(self, name: str) -> int:
        """KeyError if no sensor has that name."""
        self._clock.begin()
        vehicle = self.get_ready()
        mover = vehicle.mover
        return mover.senses.named_steps(mover.around, vehicle.here.truth, name, self._chance)

    def known_distances(self) -> dict[Bearing, int]:
        """If nothing has moved since the last call, the distances are unchanged."""
        vehicle = self.get_ready()
        spot, moment = vehicle.here.truth, vehicle.moment
        seen = self._seen
        if seen is None or seen[0] != spot or not vehicle.is_unchanged(seen[1]):
            mover = vehicle.mover
            seen = self._seen = spot, moment, mover.senses.all_steps(mover.around, spot)
        return dict(seen[2])

    def scan(self) -> tuple[Sighting, ...]:
        """If nothing has moved since the last call, the sightings are unchanged.

        RobotProblem ``no-eyes`` if it has none, and no finder of marks either.
        """
        self._clock.begin()
        vehicle = self.get_ready()
        now, seen = (vehicle.here.truth, self.holds), self._scanned
        if seen is None or seen[:2] != now or not vehicle.is_unchanged(seen[2]):
            moment = vehicle.moment
            seen = self._scanned = (*now, moment, self._look(vehicle))
        return seen[3]

    def _look(self, vehicle: Vehicle) -> tuple[Sighting, ...]:
        """The sightings, cached while everything is at the same places."""
        looks = self._ground.looks
        if looks is None:
            return self._sightings(vehicle)
        key = (self._model.index, vehicle.here.truth, self.holds, tuple(self._ground.moved().items()))
        sightings = looks.get(key)
        if sightings is None:
            sightings = self._sightings(vehicle)
            if len(looks) < MOST_LOOKS:
                looks[key] = sightings
        return sightings

    def _sightings(self, vehicle: Vehicle) -> tuple[Sighting, ...]:
        senses, place = vehicle.mover.senses, (vehicle.mover.around, vehicle.here.truth)
        things = senses.look(*place) if senses.views or not senses.finders else ()
        marks = map(self._sighting_of_mark, senses.marks_ahead(*place))
        return (*map(self._sighting, things), *marks)

    def grip(self) -> GripResult:
        """Take the thing between the paddles, or a step before them. RobotProblem ``no-gripper``."""
        self._clock.begin()
        outcome = self.get_ready().grip()
        return self._gripped(outcome, self.holds)

    def release(self) -> GripResult:
        """Release the held thing, which stays there. RobotProblem ``no-gripper``."""
        self._clock.begin()
        held = self.holds
        return self._gripped(self.get_ready().release(), held)

    def halt(self) -> None:
        self._clock.halt()

    def _new_chance(self) -> Random | None:
        if not self._seed:
            return None
        from random import Random  # loaded where there is chance

        return Random(f"{self._seed} {self.name}")

    def _walk(self, vehicle: Vehicle, motion: Motion, steps: int, rate: Rate) -> WalkResult:
        if steps < 0:
            raise ValueError("a walk has no negative steps")
        turned = 180.0 if motion is Motion.BACKWARD else 0.0
        if vehicle.leap(steps, rate, turned):
            return WalkResult(steps, steps, None, pose_of(vehicle.here.belief))
        meeting = partial(vehicle.meeting.walking, turned=turned)
        walk = self._movements[0](vehicle, motion, steps, rate)
        walked, stopped_by, met = self._run(vehicle, (motion, steps), walk, meeting)
        return WalkResult(steps, walked, stopped_by, pose_of(vehicle.here.belief), met, self._pushed(vehicle))

    def _run(
        self,
        vehicle: Vehicle,
        command: tuple[Motion, int],
        movement: Movement,
        meeting: Callable[[Spot, StoppedBy | None], Met | None],
    ) -> _Outcome:
        """Run a movement: whole steps or degrees, what ended it, and what it met.

        A command that did nothing, with nothing movable near, does nothing again.
        """
        vehicle.pushed.clear()
        here = vehicle.here
        if not self._clock.begin():
            return 0, StoppedBy.USER, None
        refused = self._refused.get(command) if self._refused_at == here else None
        if refused is not None and vehicle.is_alone():
            return refused
        whole, stopped_by = movement.run()
        met = None if stopped_by is None else meeting(vehicle.here.truth, stopped_by)
        outcome = whole, stopped_by, met
        if stopped_by in _FINAL and vehicle.here == here and vehicle.is_alone():
            if self._refused_at != here:
                self._refused, self._refused_at = {}, here
            self._refused[command] = outcome
        return outcome

    def _pushed(self, vehicle: Vehicle) -> tuple[Pushed, ...]:
        """What the last movement pushed."""
        if not vehicle.pushed:
            return ()
        return tuple(self._as_pushed(root, metres) for root, metres in vehicle.pushed.items())

    def _as_pushed(self, root: int, metres: float) -> Pushed:
        model = self._ground.scene.models[root]
        return Pushed(model.kind, self._name_of(root), model.colour.family, metres / STEP)

    def _gripped(self, outcome: Grip, root: int | None) -> GripResult:
        if root is None:
            return GripResult(outcome)
        model = self._ground.scene.models[root]
        return GripResult(outcome, self._name_of(root), model.kind, model.colour.family)

    def _sighting(self, seen: Seen) -> Sighting:
        return Sighting(
            degrees=-round(seen.degrees, 9) + 0.0,
            steps=seen.steps,
            colour=seen.colour.family,
            name=self._name_of(seen.root),
        )

    def _sighting_of_mark(self, found: Found) -> Sighting:
        degrees = -round(found.degrees, 9) + 0.0
        return Sighting(degrees, found.steps, "", self._name_of(found.model), found.number)

    def _name_of(self, root: int | None) -> str:
        """As its world calls it; empty if it only has a number."""
        return "" if root is None else self._ground.scene.models[root].called
