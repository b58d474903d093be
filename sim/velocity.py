"""The velocity drive: all robots of a world in one loop, each driven by a velocity for an unbounded time.

A tick is divided into substeps in which no robot goes farther than ``FARTHEST`` or turns more than
``WIDEST``. In each, every robot in turn goes along the chord of its arc, pushes what gives way, and turns;
where something stops it, it stays there and may still turn. A robot with room round all of its tick takes it
at once. Both come to the same place, because the chords of an arc end on the arc.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import atan2, ceil, degrees, hypot, isfinite, radians, sin, tan
from random import Random
from typing import TYPE_CHECKING

from msgspec import Struct

from devices.ports.drive import (
    TICK,
    BlobReading,
    BumperReading,
    DriveState,
    MarkReading,
    MetricPose,
    RangerReading,
    Velocity,
)
from devices.ports.robot import GripResult
from sim.geometry import Placement, Spot, relative
from sim.motion import TOUCHING, TURN_SKIN
from sim.readings import Instruments
from sim.scene import Bounds, Drive, Limits, Localization, Model, Wheels
from sim.sensors import head_of
from sim.vehicle import Vehicle, Whereabouts

if TYPE_CHECKING:
    from sim.motion import Surroundings
    from sim.scene import Scene
    from sim.world import World

FARTHEST = 0.02
"""Metres of a substep."""
WIDEST = 2.0
"""Degrees of a substep."""
MOST = 1000
"""Substeps of a tick: above 200 m/s they get longer, but nothing is passed through."""
STANDING = Velocity()


class VelocityLoop:
    """All robots of a world. No program may run in this world meanwhile."""

    def __init__(self, world: World) -> None:
        self._world = world
        self._ticks = 0
        self.is_paused = False
        """Whether time stands still."""
        self.drives: dict[str, RobotDrive] = {}
        """The robots by name, in the order of the world."""
        for name in world.scene.robot_names:
            chance = Random(f"{world.seed} {name}") if world.seed else None
            self.drives[name] = RobotDrive(world, name, chance)

    @property
    def scene(self) -> Scene:
        """The scene with its changes, except the places of things."""
        return self._world.scene

    @property
    def time(self) -> float:
        """Simulated seconds since the loop began."""
        return self._ticks * TICK

    def advance(self) -> None:
        """Run a tick: take the velocities, then move all robots."""
        if self.is_paused:
            return
        moving = [each for each in self.drives.values() if each.begin_tick()]
        if moving:
            count = min(MOST, max(each.substeps() for each in moving))
            for each in moving:
                each.take_at_once()
            for _ in range(count):
                for each in moving:
                    each.move(TICK / count)
        self._ticks += 1

    def pose(self, name: str) -> MetricPose:
        """The pose of a robot or a top-level thing. KeyError if there is none."""
        if name in self.drives:
            return self.drives[name].state().truth
        model, ground = self._model(name), self._world.ground
        return _metric(ground.place(model.index) if model.index in ground.movable else model.pose)

    def put(self, name: str, pose: MetricPose) -> None:
        """Put a robot or a movable thing to a pose. KeyError for anything else."""
        if name in self.drives:
            self.drives[name].set_pose(pose)
            return
        model, ground = self._model(name), self._world.ground
        if model.index not in ground.movable:
            raise KeyError(name)
        ground.put(model.index, Placement(pose.x, pose.y, model.pose.z, pose.yaw))

    def change(self, index: int, **properties: object) -> None:
        """Change the colour or mark of a model, by its index."""
        self._world.change(index, **properties)

    def reset(self) -> None:
        """Put all robots and things to their starts. Velocities stay."""
        self._world.reset()
        for drive in self.drives.values():
            drive.set_odometry(MetricPose())

    def _model(self, name: str) -> Model:
        for model in self.scene.models:
            if model.parent is None and model.name == name:
                return model
        raise KeyError(name)


class RobotDrive:
    """One robot. Its devices are in the order of the world file; ``part`` is the index of one model of it."""

    def __init__(self, world: World, name: str, chance: Random | None) -> None:
        """``chance``: of the noise of its sensors."""
        self.name = name
        self._world = world
        self._robot = world.inhabitant(name)
        self._chance = chance
        scene, model = world.scene, world.scene.robot(name)
        self._wheels = model.wheels or Wheels()
        self._bounds = self._wheels.velocity_bounds or Limits()
        self._counted = None if self._wheels.localization is Localization.GPS else Spot(0.0, 0.0, 0.0)
        """Where it believes it is, if it counts its wheels' turns."""
        self._mounted: dict[int, _Mounted] = {}
        for each in scene.tree(model.index):
            head = head_of(each, scene)
            frame = model.pose if head is None else scene.models[head].pose
            self._mounted[each.index] = _Mounted(
                Instruments((each,), frame), head, relative(frame, model.pose)
            )
        self._turned: dict[int, float] = {}
        """Degrees that heads have turned, by their models' index."""
        self.is_held = False
        """Whether it stands whatever was asked for."""
        self._users = 0
        self._asked = STANDING
        self._wanted = STANDING
        """What was asked for when the tick began."""
        self._speed = STANDING
        self._is_stalled = False
        self._has_moved = False
        """In this tick, at once."""

    def subscribe(self) -> None:
        """Add a user. Only a robot with users drives."""
        self._users += 1

    def unsubscribe(self) -> None:
        """Remove a user. When the last one leaves, the robot stops at once."""
        self._users = max(0, self._users - 1)
        if self._users == 0:
            self._asked = self._speed = STANDING

    def drive(self, velocity: Velocity) -> None:
        """Set the velocity from the next tick on, until the next call. ValueError for infinite numbers."""
        if not all(isfinite(each) for each in (velocity.ahead, velocity.left, velocity.turn)):
            raise ValueError("a velocity is made of finite numbers")
        if self._users:
            self._asked = self._possible(velocity)

    def state(self) -> DriveState:
        truth = _metric(self._vehicle.here.truth)
        believed = truth if self._counted is None else _metric(self._counted)
        return DriveState(believed, truth, self._speed, self._is_stalled)

    def set_pose(self, pose: MetricPose) -> None:
        """Put the robot to a pose. Its velocity stays."""
        spot = Spot(pose.x, pose.y, pose.yaw % 360.0)
        self._vehicle.go_to(Whereabouts(spot, spot))

    def set_odometry(self, pose: MetricPose) -> None:
        """Set the believed pose. No effect on a robot that knows its true pose."""
        if self._counted is not None:
            self._counted = Spot(pose.x, pose.y, pose.yaw % 360.0)

    def rangers(self, part: int | None = None) -> tuple[RangerReading, ...]:
        around, chance = self._around, self._chance
        return tuple(each for it, spot in self._at(part) for each in it.rangers(around, spot, chance))

    def bumpers(self, part: int | None = None) -> tuple[BumperReading, ...]:
        return tuple(each for it, spot in self._at(part) for each in it.bumpers(self._around, spot))

    def blobs(self, part: int | None = None) -> tuple[BlobReading, ...]:
        return tuple(each for it, spot in self._at(part) for each in it.blobs(self._around, spot))

    def marks(self, part: int | None = None) -> tuple[MarkReading, ...]:
        around, yaw_of = self._around, self._yaw_of
        return tuple(each for it, spot in self._at(part) for each in it.marks(around, spot, yaw_of))

    def turn_head(self, part: int, degrees: float) -> None:
        """Set how many degrees a head is turned from its start, with everything mounted on it."""
        self._turned[part] = degrees

    def grip(self) -> GripResult:
        """Take the thing between the paddles of its first gripper. RobotProblem ``no-gripper``."""
        return self._robot.grip()

    def release(self) -> GripResult:
        return self._robot.release()

    def beams(self) -> tuple[bool, bool]:
        """Whether something is in the outer and in the inner beam of that gripper."""
        return self._vehicle.hand.beams_broken(self._here)

    # --- the loop's

    def begin_tick(self) -> bool:
        """Take the requested velocity. Returns whether there is anything to do."""
        self._is_stalled = self._has_moved = False
        self._wanted = STANDING if self.is_held else self._asked
        if self.is_held:
            self._speed = STANDING
        if self._users and not self.is_held:
            self._vehicle.clock.seconds += TICK
        if self._wheels.acceleration_bounds is None:
            self._speed = self._wanted
        return self._speed != STANDING or self._wanted != STANDING

    def substeps(self) -> int:
        """The number of substeps of this tick."""
        way, turn = 0.0, 0.0
        for each in (self._speed, self._wanted):
            way, turn = max(way, hypot(each.ahead, each.left)), max(turn, abs(each.turn))
        return ceil(max(1.0, way * TICK / FARTHEST, turn * TICK / WIDEST))

    def take_at_once(self) -> None:
        """Run the whole tick at once, if the velocity is constant and nothing is near."""
        speed = self._speed
        if speed != self._wanted or abs(speed.turn * TICK) > 45.0:
            return
        here, around = self._here, self._around
        way, angle, chord = _chord(speed, TICK)
        there = here.ahead(chord, here.yaw + angle)
        half = radians(speed.turn * TICK / 2)
        aside = here.ahead(way / 2 * (tan(half) / half if half else 1.0), here.yaw + angle - degrees(half))
        # the arc lies within the triangle of its ends and the place where its tangents meet
        if around.has_room(here.x, here.y, there.x, there.y) and around.has_room(
            here.x, here.y, aside.x, aside.y
        ):
            self._go(chord, angle)
            self._turn(speed.turn * TICK)
            self._has_moved = True

    def move(self, seconds: float) -> None:
        """One substep."""
        if self._has_moved:
            return
        before = self._speed
        self._speed = self._gained(seconds)
        mean = _mean(before, self._speed)
        _, angle, chord = _chord(mean, seconds)
        vehicle = self._vehicle
        if chord > TOUCHING:
            towards = self._here.yaw + angle
            way = vehicle.way(towards, chord)
            vehicle.take_along(way, towards)
            self._is_stalled |= way.metres < chord - TOUCHING
            if way.metres > 0.0:
                self._go(way.metres, angle)
        turn = mean.turn * seconds
        if turn:
            free = vehicle.mover.turn_contact(self._here, 1 if turn > 0 else -1)
            if free < abs(turn):
                self._is_stalled = True
                turn = max(0.0, free - TURN_SKIN) * (1 if turn > 0 else -1)
            self._turn(turn)

    # --- inside

    def _at(self, part: int | None) -> Iterator[tuple[Instruments, Spot]]:
        """The devices of one model, or of all, and where that frame is."""
        for index, it in self._mounted.items():
            if part in (None, index):
                turned = self._turned.get(it.head, 0.0) if it.head is not None else 0.0
                frame, here = it.frame, self._here
                yield (
                    it.instruments,
                    here if it.head is None else here.mounted(frame.x, frame.y, frame.yaw + turned),
                )

    @property
    def _vehicle(self) -> Vehicle:
        """The vehicle, made again after a change of the world."""
        return self._robot.get_ready()

    @property
    def _around(self) -> Surroundings:
        return self._vehicle.mover.around

    @property
    def _here(self) -> Spot:
        return self._vehicle.here.truth

    def _go(self, metres: float, angle: float) -> None:
        """Straight on, ``angle`` degrees from its front."""
        vehicle = self._vehicle
        vehicle.go_to(vehicle.ahead(vehicle.here, metres, angle))
        if self._counted is not None:
            self._counted = vehicle.odometry.ahead(self._counted, metres, angle)

    def _turn(self, turn: float) -> None:
        if turn:
            vehicle = self._vehicle
            vehicle.go_to(vehicle.turned(vehicle.here, turn))
            if self._counted is not None:
                self._counted = vehicle.odometry.turned(self._counted, turn)

    def _possible(self, velocity: Velocity) -> Velocity:
        """The velocity within the bounds of the robot's world and of its wheels."""
        drive, bounds = self._wheels.drive, self._bounds
        ahead = _within(bounds.x, velocity.ahead)
        left = _within(bounds.y, velocity.left) if drive is Drive.OMNI else 0.0
        turn = _within(bounds.yaw, velocity.turn)
        bend = self._vehicle.rates.bend
        if bend is not None:
            most = degrees(abs(ahead) / bend)
            turn = max(-most, min(most, turn))
        return Velocity(ahead, left, turn)

    def _gained(self, seconds: float) -> Velocity:
        """The velocity after that many seconds."""
        speed, wanted, gains = self._speed, self._wanted, self._wheels.acceleration_bounds
        if gains is None:
            return wanted
        return Velocity(
            speed.ahead + _within(gains.x, wanted.ahead - speed.ahead, seconds),
            speed.left + _within(gains.y, wanted.left - speed.left, seconds),
            speed.turn + _within(gains.yaw, wanted.turn - speed.turn, seconds),
        )

    def _yaw_of(self, model: int) -> float:
        it, ground = self._world.scene.models[model], self._world.ground
        if it.root not in ground.movable:
            return it.pose.yaw
        return it.pose.yaw + ground.place(it.root).yaw - ground.start(it.root).yaw


class _Mounted(Struct, frozen=True):
    """The devices of one model of a robot."""

    instruments: Instruments
    head: int | None
    """The model that turns with them on the robot; None: they are on the robot itself."""
    frame: Placement
    """Where that is on the robot, before it turns."""


def _within(bounds: Bounds, value: float, seconds: float = 1.0) -> float:
    return min(max(value, min(0.0, bounds[0]) * seconds), max(0.0, bounds[1]) * seconds)


def _mean(one: Velocity, other: Velocity) -> Velocity:
    return Velocity((one.ahead + other.ahead) / 2, (one.left + other.left) / 2, (one.turn + other.turn) / 2)


def _chord(speed: Velocity, seconds: float) -> tuple[float, float, float]:
    """The length of the driven arc; the direction of its chord, in degrees from the front, and its length."""
    turn = speed.turn * seconds
    half = radians(turn / 2)
    if speed.left:
        way, towards = hypot(speed.ahead, speed.left) * seconds, degrees(atan2(speed.left, speed.ahead))
    else:
        way, towards = abs(speed.ahead) * seconds, 180.0 if speed.ahead < 0.0 else 0.0
    return way, towards + turn / 2, way * (sin(half) / half if half else 1.0)


def _metric(place: Placement | Spot) -> MetricPose:
    return MetricPose(place.x, place.y, place.yaw % 360.0)
