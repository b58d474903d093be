"""The devices that clients open: each answers requests, takes commands and reads its sensor.

Metres and radians here, as on the wire; the port below has degrees.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from math import atan2, cos, degrees, hypot, radians, sin
from typing import TYPE_CHECKING, Protocol

from msgspec import Struct

from devices.player.codec import Interface, Values
from devices.ports.audio import CUES
from devices.ports.drive import TICK, MetricPose, Velocity
from devices.ports.robot import Grip, GripResult
from donnie_tui.core.events import CueSounded, Event, GripperUsed, Spoke
from sim.colours import colour_of
from sim.geometry import Placement, Spot, normal, relative

if TYPE_CHECKING:
    from sim.scene import Model
    from sim.velocity import VelocityLoop

Datum = tuple[int, Values]
"""A subtype and its values."""

_FARTHEST = 1e6
"""The largest distance, angle or speed of a command, in metres and radians."""


def _are_usable(values: Values) -> bool:
    return all(abs(each) <= _FARTHEST for each in values)


class Reporter(Protocol):
    """Learns what clients do with the robots, by their names."""

    def opened(self, name: str) -> bool:
        """A client opens the robot as the first one. False refuses it."""

    def left(self, name: str) -> None:
        """The last client has closed it."""

    def happened(self, name: str, event: Event) -> None: ...

    def vibrated(self, name: str, motor: int, letter: str) -> None:
        """A client sets a cell of the belt's frame; its number counts the frame's start, too."""

    def on_tick(self) -> None:
        """Before each tick."""


class DeviceContext(Struct):
    """The place of a device, and the objects that it works with."""

    interface: Interface
    index: int
    driver: str
    """The name that clients see."""
    robot: str
    """The name of its robot; empty if it belongs to none."""
    loop: VelocityLoop
    reporter: Reporter


class Equipment:
    """The base class: a device that can be opened, has no data and refuses all requests."""

    def __init__(self, context: DeviceContext) -> None:
        self.interface, self.index = context.interface, context.index
        self.driver, self.users = context.driver, 0
        self._robot, self._loop, self._reporter = context.robot, context.loop, context.reporter

    def open(self) -> bool:
        """Opens the device. False refuses it."""
        self.users += 1
        return True

    def close(self) -> None:
        self.users -= 1

    def command(self, subtype: int, values: Values) -> None:
        """Takes a command that its interface has. Called only while the device is open."""

    def request(self, subtype: int, values: Values) -> Values | None:  # noqa: ARG002 -- the table's form
        """The content of the reply; None refuses the request."""
        return self.geometry() if subtype == 1 else None

    def geometry(self) -> Values | None:
        return None

    def step(self) -> None:
        """Before each tick."""

    def data(self) -> Iterator[Datum]:
        yield from ()


class MountedDevice(Equipment):
    """A device on a robot, or the robot itself."""

    def __init__(self, context: DeviceContext, model: Model) -> None:
        super().__init__(context)
        self._model, self._drive = model, context.loop.drives[context.robot]
        self._on_robot = relative(model.pose, context.loop.scene.models[model.root].pose)
        self.begin()

    def begin(self) -> None:
        """Sets the state before a client opens it."""

    def _place(self) -> tuple[float, ...]:
        """Its pose on its robot (0 for a robot) and its size."""
        here, z = self._on_robot, local_z(self._model, self._loop.scene.models)
        return (here.x, here.y, z, 0.0, 0.0, angle(here.yaw), *box3d(self._model.size))


class PositionDevice(MountedDevice):
    """A device that drives or turns by velocities, or to a goal."""

    _goal: MetricPose | None = None

    def geometry(self) -> Values | None:
        return self._place()

    def command(self, subtype: int, values: Values) -> None:
        if subtype == 2 and _are_usable(values):
            self._goal = MetricPose(values[0], values[1], degrees(values[2]))
        elif subtype in (1, 3) and _are_usable(values):
            ahead, left, turn = values[:3] if subtype == 1 else (values[0], 0.0, values[1])
            self._goal = None
            self.drive(Velocity(ahead, left, degrees(turn)))

    def drive(self, velocity: Velocity) -> None:
        """Drives at these velocities until the next command."""

    def request(self, subtype: int, values: Values) -> Values | None:
        return () if subtype in (2, 4, 5, 6) else super().request(subtype, values)


class WheelDevice(PositionDevice):
    """A robot, which stops when the last client has closed it."""

    def open(self) -> bool:
        if not self.users and not self._reporter.opened(self._robot):
            return False
        self._drive.subscribe()
        return super().open()

    def close(self) -> None:
        super().close()
        self._drive.unsubscribe()
        if not self.users:
            self._goal = None
            self._reporter.left(self._robot)

    def drive(self, velocity: Velocity) -> None:
        self._drive.drive(velocity)

    def request(self, subtype: int, values: Values) -> Values | None:
        if subtype in (5, 6):
            x, y, yaw = values or (0.0, 0.0, 0.0)
            if not _are_usable(values):
                return None
            self._drive.set_odometry(MetricPose(x, y, degrees(yaw)))
        return super().request(subtype, values)

    def step(self) -> None:
        if self._goal is not None:
            self._drive.drive(towards(self._goal, self._drive.state().believed))

    def data(self) -> Iterator[Datum]:
        state = self._drive.state()
        here, speed = state.believed, state.velocity
        rates = (speed.ahead, speed.left, radians(speed.turn))
        yield 1, (here.x, here.y, angle(here.yaw), *rates, int(state.is_stalled))


class HeadDevice(PositionDevice):
    """A head: a part that turns on its robot, with everything mounted on it."""

    _turned = _rate = 0.0

    def drive(self, velocity: Velocity) -> None:
        self._rate = max(-FASTEST_TURN, min(FASTEST_TURN, velocity.turn))

    def close(self) -> None:
        super().close()
        if not self.users:
            self._goal, self._rate = None, 0.0

    def step(self) -> None:
        if self._goal is not None:
            self._rate = _turn(self._goal.yaw - self._here().yaw)
        if self._rate and not (self._loop.is_paused or self._drive.is_held):
            self._turned += self._rate * TICK
            self._drive.turn_head(self._model.index, self._turned)

    def data(self) -> Iterator[Datum]:
        here = self._here()
        yield 1, (here.x, here.y, angle(here.yaw), 0.0, 0.0, radians(self._rate), 0)

    def _here(self) -> Spot:
        base, mount = self._drive.state().believed, self._on_robot
        return Spot(base.x, base.y, base.yaw).mounted(mount.x, mount.y, mount.yaw + self._turned)


NEAR, FASTEST, FASTEST_TURN = 0.02, 0.4, degrees(1.0)
"""Metres: so near a goal a robot only turns to its heading; metres and degrees a second on the way to it."""


def towards(goal: MetricPose, here: MetricPose) -> Velocity:
    """The velocity of the next tick on the way to a goal: turn to it, drive, turn to its heading."""
    dx, dy = goal.x - here.x, goal.y - here.y
    if abs(dx) <= NEAR and abs(dy) <= NEAR:
        return Velocity(turn=_turn(goal.yaw - here.yaw))
    aside = degrees(angle(degrees(atan2(dy, dx)) - here.yaw))
    if abs(aside) > 5.0:
        return Velocity(turn=_turn(aside))
    return Velocity(min(FASTEST, hypot(dx, dy) / TICK), 0.0, _turn(aside))


def _turn(by: float) -> float:
    rate = degrees(angle(by)) / TICK
    return max(-FASTEST_TURN, min(FASTEST_TURN, rate))


SONARS = (-45, 0, 45, 135, 180, -135)
"""The directions of Donnie's six sonars, in the order of the original's clients."""


class RangeFinder(MountedDevice):
    """Sonars, or a laser: one sensor with its samples, or several with one each."""

    def begin(self) -> None:
        yaws = [round(normal(each.pose.yaw)) for each in self._model.sensors]
        is_donnie = sorted(yaws) == sorted(SONARS)
        self._order = [yaws.index(each) for each in SONARS] if is_donnie else [*range(len(yaws))]
        root, tree = self._model.root, self._loop.scene.tree(self._model.root)
        others = [each.index for each in tree if len(each.sensors) == 1 and each.parent != root]
        self._seventh = others[:1] if is_donnie else []
        """The head's sonar, which clients of Donnie's take for one more of these."""

    def geometry(self) -> Values | None:
        sensors = [self._model.sensors[each] for each in self._order]
        sizes = [each.size for each in sensors]
        return (*self._place(), [pose3d(each.pose) for each in sensors], sizes)

    def request(self, subtype: int, values: Values) -> Values | None:
        if subtype != 5:
            return super().request(subtype, values)
        first = self._model.sensors[self._order[0]]
        view = radians(first.fov)
        resolution = self._loop.scene.settings.get("resolution", 0.02)
        step = float(resolution) if isinstance(resolution, (int, float)) else 0.02
        bounds = (first.minimum, first.maximum, step, 1 / TICK)
        return (-view / 2, view / 2, view / first.samples, *bounds)

    def data(self) -> Iterator[Datum]:
        (reading,) = self._drive.rangers(self._model.index)
        pairs = [(reading.sensors[each], reading.returns[each]) for each in self._order]
        heads = [head for each in self._seventh for head in self._drive.rangers(each)]
        pairs += [(head.sensors[0], head.returns[0]) for head in heads]
        ranges: list[float] = []
        seen: list[float] = []
        for samples, returns in pairs:
            only = slice(len(samples) // 2, len(samples) // 2 + 1) if len(pairs) > 1 else slice(None)
            ranges += samples[only]
            seen += returns[only]
        if ranges:
            yield 1, (ranges,)
            yield 3, (seen,)


class BumperBars(MountedDevice):
    def geometry(self) -> Values | None:
        return ([(*pose3d(each.pose), each.length, 0.0) for each in self._model.bumpers],)

    def data(self) -> Iterator[Datum]:
        yield 1, (bytes(self._drive.bumpers(self._model.index)[0].pressed),)


HALF_HEIGHT = 0.3
"""Metres: seen things count as twice as high."""


class ColourFinder(MountedDevice):
    """A blob finder: coloured things in the columns and rows of a picture."""

    def data(self) -> Iterator[Datum]:
        finder = self._model.blobfinder
        assert finder is not None
        width, height = finder.image
        blobs = []
        for seen in self._drive.blobs(self._model.index)[0].blobs:
            red, green, blue = seen.colour
            left, right = (_pixel(0.5 - each / finder.fov, width) for each in (seen.left, seen.right))
            rows = int(degrees(atan2(HALF_HEIGHT, seen.metres)) / finder.fov * height)
            top, bottom = max(0, height // 2 - rows), min(height - 1, height // 2 + rows)
            area = (right - left) * (bottom - top)
            colour = red << 16 | green << 8 | blue
            middle = ((left + right) // 2, (top + bottom) // 2)
            blobs.append((0, colour, area, *middle, left, right, top, bottom, seen.metres))
        yield 1, (width, height, blobs)


def _pixel(share: float, size: int) -> int:
    return max(0, min(size - 1, int(share * size)))


class MarkReader(MountedDevice):
    """A fiducial finder: marks, and the one of its own robot."""

    def request(self, subtype: int, values: Values) -> Values | None:
        if subtype == 8:
            self._loop.change(self._model.index, fiducial_return=float(values[0]))
        own = self._loop.scene.models[self._model.index].fiducial_return
        return (max(0, int(own)),) if subtype in (7, 8) else super().request(subtype, values)

    def geometry(self) -> Values | None:
        return (*self._place(), 0.1, 0.1)

    def data(self) -> Iterator[Datum]:
        marks = []
        for mark in self._drive.marks(self._model.index)[0].marks:
            x, y = mark.metres * cos(radians(mark.degrees)), mark.metres * sin(radians(mark.degrees))
            marks.append((mark.number, x, y, 0.0, 0.0, 0.0, angle(mark.yaw), *(0.0,) * 6))
        yield 1, (marks,)


OPEN, CLOSED, MOVING = 1, 2, 3


class GripperDevice(MountedDevice):
    """A gripper. It carries the thing between its closed paddles."""

    def begin(self) -> None:
        gripper = self._model.gripper
        self._wanted = CLOSED if gripper is not None and gripper.closed else OPEN
        self._ticks_left = 0

    def command(self, subtype: int, values: Values) -> None:  # noqa: ARG002 -- it has none
        wanted = {1: OPEN, 2: CLOSED}.get(subtype, self._wanted)
        if wanted != self._wanted:
            self._wanted, self._ticks_left = wanted, round(1.0 / TICK)
            if wanted == OPEN:
                self._report(self._drive.release(), Grip.RELEASED)

    def geometry(self) -> Values | None:
        return (*self._place(), *box3d(self._model.size), 2, 0)

    def step(self) -> None:
        if self._ticks_left and not self._loop.is_paused:
            self._ticks_left -= 1
            if not self._ticks_left and self._wanted == CLOSED:
                self._report(self._drive.grip(), Grip.GRIPPED)

    def _report(self, done: GripResult, success: Grip) -> None:
        if done.outcome is success:
            event = GripperUsed(done.outcome, done.name, done.kind, done.colour)
            self._reporter.happened(self._robot, event)

    def data(self) -> Iterator[Datum]:
        outer, inner = self._drive.beams()
        yield 1, (MOVING if self._ticks_left else self._wanted, outer << 2 | inner << 3, 0)


LONGEST_TEXT, LONGEST_FRAME = 1000, 36
"""Characters of a spoken text and of a frame of the belt."""


class SpeechDevice(Equipment):
    """Takes texts that are spoken in a robot's name."""

    def command(self, subtype: int, values: Values) -> None:  # noqa: ARG002 -- there is one
        if values[0]:
            shown = (each if each.isprintable() else " " for each in values[0][:LONGEST_TEXT])
            self._reporter.happened(self._robot, Spoke("".join(shown)))


class BeltFrames(Equipment):
    """Takes texts that are frames of the belt: a letter for each cell."""

    def command(self, subtype: int, values: Values) -> None:  # noqa: ARG002 -- as above
        for motor, letter in enumerate(values[0][:LONGEST_FRAME]):
            self._reporter.vibrated(self._robot, motor, letter)


class DigitalOutputs(Equipment):
    """Digital outputs, such as the belt's: they have the last values."""

    _last: Values = (0, 0)

    def command(self, subtype: int, values: Values) -> None:  # noqa: ARG002 -- as above
        self._last = values
        self._reporter.vibrated(self._robot, values[0], chr(values[1] & 0x7F))

    def data(self) -> Iterator[Datum]:
        yield 1, self._last


class SoundDevice(Equipment):
    """Plays built-in sounds by the names of files, which are never opened."""

    def command(self, subtype: int, values: Values) -> None:  # noqa: ARG002 -- as above
        file = values[0].partition(b"\0")[0].decode("ascii", "replace").replace("\\", "/")
        base = file.rpartition("/")[2].partition(".")[0].lower()
        if base in CUES:
            self._reporter.happened(self._robot, CueSounded(base, 0.0, None))


class Battery(Equipment):
    """A battery that is always full."""

    def data(self) -> Iterator[Datum]:
        yield 1, (8, 0.0, 100.0, 0.0, 0.0, 0)


class SimulationDevice(Equipment):
    """The simulation: reads and sets the poses of things. It works without being opened."""

    def __init__(self, context: DeviceContext) -> None:
        super().__init__(context)
        models = context.loop.scene.models
        self._names = {_whole_name(model, models): model.index for model in reversed(models)}

    def command(self, subtype: int, values: Values) -> None:  # noqa: ARG002 -- it has none
        if subtype == 1:
            self._loop.is_paused = not self._loop.is_paused
        elif subtype == 2:
            self._loop.reset()

    def request(self, subtype: int, values: Values) -> Values | None:
        index = self._names.get(values[0])
        if subtype in (5, 6):
            return self._property(subtype, values, index)
        if index is None:
            return None
        model = self._loop.scene.models[index]
        here = self._here(model)
        match subtype:
            case 1:
                return (values[0], here.x, here.y, angle(here.yaw))
            case 3:
                pose = (here.x, here.y, local_z(model, self._loop.scene.models), 0.0, 0.0, angle(here.yaw))
                return (values[0], *pose, self._loop.time * 1e6)
            case 2 | 4 if model.parent is None and _are_usable(values[1:]):
                yaw = values[3] if subtype == 2 else values[6]
                with suppress(KeyError):  # it can't move, or several have this name
                    self._loop.put(model.name, MetricPose(values[1], values[2], degrees(yaw)))
                    return ()
        return None

    def _here(self, model: Model) -> MetricPose:
        if model.parent is None:
            return self._loop.pose(model.spoken_name)
        local = relative(model.pose, self._loop.scene.models[model.parent].pose)
        return MetricPose(local.x, local.y, local.yaw)

    def _property(self, subtype: int, values: Values, index: int | None) -> Values | None:
        """Numbers in the byte order of the clients."""
        name, what, number, given = values
        if what == "time" and len(given) == 8 and subtype == 5:
            return (name, what, number, struct.pack("<Q", round(self._loop.time * 1e6)))
        if what != "color" or len(given) != 16 or index is None:
            return None
        if subtype == 5:
            colour = self._loop.scene.models[index].colour
            rgba = struct.pack("<ffff", colour.red, colour.green, colour.blue, colour.alpha)
            return (name, what, number, rgba)
        parts = struct.unpack("<ffff", given)
        if not all(0.0 <= each <= 1.0 for each in parts):
            return None
        self._loop.change(index, colour=colour_of("", *parts))
        return ()


def _whole_name(model: Model, models: Sequence[Model]) -> str:
    if model.parent is None:
        return model.name
    return f"{_whole_name(models[model.parent], models)}.{model.name}"


STAGE, BELT = "stage", "vib_belt"


def _position_device(context: DeviceContext, model: Model) -> MountedDevice:
    return (WheelDevice if model.parent is None else HeadDevice)(context, model)


MOUNTED: Mapping[str, tuple[Callable[[DeviceContext, Model], MountedDevice], Callable[[Model], object]]] = {
    "position2d": (_position_device, lambda each: each.wheels),
    "ranger": (RangeFinder, lambda each: each.sensors),
    "bumper": (BumperBars, lambda each: each.bumpers),
    "blobfinder": (ColourFinder, lambda each: each.blobfinder),
    "fiducial": (MarkReader, lambda each: each.fiducial_finder),
    "gripper": (GripperDevice, lambda each: each.gripper),
}
"""The device of each interface of Stage's driver, and the models that can be one."""
_SERVICES = {"dio": DigitalOutputs, "sound": SoundDevice, "speech": SpeechDevice}


def service_of(interface: str, driver: str) -> type[Equipment] | None:
    """The device of a driver that has no model; None for other drivers."""
    if interface == "power":
        return None if driver == STAGE else Battery
    if interface == "simulation":
        return SimulationDevice if driver == STAGE else None
    if (interface, driver) == ("speech", BELT):
        return BeltFrames
    return _SERVICES.get(interface) if driver in (STAGE, "soxplayer", "gtts", BELT) else None


def local_z(model: Model, models: Sequence[Model]) -> float:
    """The height above its parent, from its world file."""
    parent = None if model.parent is None else models[model.parent]
    return model.pose.z - (0.0 if parent is None else parent.pose.z + parent.size[2])


def angle(of_degrees: float) -> float:
    """The angle in radians, above -pi and up to pi."""
    return radians(normal(of_degrees))


def pose3d(place: Placement) -> tuple[float, ...]:
    return place.x, place.y, place.z, 0.0, 0.0, angle(place.yaw)


def box3d(size: tuple[float, float, float]) -> tuple[float, float, float]:
    """The width (y) comes first."""
    return size[1], size[0], size[2]
