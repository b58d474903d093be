"""The devices that clients open: each answers requests, takes commands and reads its sensor.

Metres and radians here, as on the wire; the port below has degrees.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Sequence
from math import atan2, cos, degrees, hypot, radians, sin
from typing import TYPE_CHECKING, Any, Protocol

from devices.player.codec import Interface, MessageType, body_of
from devices.ports.drive import TICK, MetricPose, Velocity, VelocityDrive
from devices.ports.robot import Grip, GripResult
from sim.colours import colour_of
from sim.geometry import Placement, normal, relative

if TYPE_CHECKING:
    from sim.scene import Model
    from sim.velocity import VelocityLoop

Values = tuple[Any, ...]
Datum = tuple[int, bytes]
"""A subtype and a body."""


_FARTHEST = 1e6
"""The largest number of metres, radians or their speeds that a command may have."""


def _is_usable(value: float) -> bool:
    return abs(value) <= _FARTHEST


class Reporter(Protocol):
    """Learns what clients do with the robots, by their names."""

    def opened(self, name: str) -> bool:
        """A client opens a robot that no other has opened. False: it can't now."""

    def left(self, name: str) -> None:
        """No client has it open any more."""

    def said(self, name: str, text: str) -> None: ...

    def sounded(self, name: str, file: str) -> None: ...

    def gripped(self, name: str, result: GripResult) -> None: ...

    def vibrated(self, name: str, motor: int, letter: str) -> None:
        """A cell of the belt's frame, by its number, which counts the frame's start too."""

    def on_tick(self) -> None:
        """Before each tick."""


class Equipment:
    """A device that anyone may open, that has no data and refuses all requests."""

    interface: int = 0

    def __init__(self, index: int, driver: str) -> None:
        """``driver``: the name that clients see."""
        self.index = index
        self.driver = driver
        self.users = 0

    def open(self) -> bool:
        """False: it can't be opened now."""
        self.users += 1
        return True

    def close(self) -> None:
        self.users -= 1

    def command(self, subtype: int, values: Values) -> None:
        """Only while it is open."""

    def request(self, subtype: int, values: Values) -> bytes | None:  # noqa: ARG002 -- the table's form
        """The body of the reply; None: refused."""
        return self.geometry() if subtype == 1 else None

    def geometry(self) -> bytes | None:
        return None

    def step(self) -> None:
        """Before each tick."""

    def data(self) -> Iterator[Datum]:
        yield from ()

    def _datum(self, *values: object, subtype: int = 1) -> Datum:
        return subtype, body_of(self.interface, MessageType.DATA, subtype, *values)

    def _ack(self, subtype: int, *values: object) -> bytes:
        return body_of(self.interface, MessageType.ACK, subtype, *values)


class MountedDevice(Equipment):
    """A device on a robot."""

    def __init__(
        self, index: int, driver: str, model: Model, drive: VelocityDrive, loop: VelocityLoop
    ) -> None:
        super().__init__(index, driver)
        self._model, self._drive, self._loop = model, drive, loop
        self.reporter: Reporter
        self.begin()

    def begin(self) -> None:
        """Sets the state that it has before a client opens it."""

    def geometry(self) -> bytes | None:
        return self._ack(1, *self._place()) if self.interface == Interface.POSITION2D else None

    def _place(self) -> tuple[float, ...]:
        """Its pose on its robot, of a robot itself 0, and its size."""
        on_robot = relative(self._model.pose, self._loop.scene.models[self._model.root].pose)
        return (*pose3d(on_robot), *box3d(self._model.size))


class WheelDevice(MountedDevice):
    """A robot. It stands as soon as the last client has closed it."""

    interface = Interface.POSITION2D

    def begin(self) -> None:
        self._goal: MetricPose | None = None

    def open(self) -> bool:
        if not self.users and not self.reporter.opened(self._drive.name):
            return False
        self._drive.subscribe()
        return super().open()

    def close(self) -> None:
        super().close()
        self._drive.unsubscribe()
        if not self.users:
            self._goal = None
            self.reporter.left(self._drive.name)

    def command(self, subtype: int, values: Values) -> None:
        if not all(map(_is_usable, values)):
            return
        match subtype:
            case 1:
                self._go(values[0], values[1], values[2])
            case 2:
                self._goal = MetricPose(values[0], values[1], degrees(values[2]))
            case 3:
                self._go(values[0], 0.0, values[1])

    def request(self, subtype: int, values: Values) -> bytes | None:
        match subtype:
            case 2 | 4:
                return b""
            case 5 if all(map(_is_usable, values)):
                self._drive.set_odometry(MetricPose(values[0], values[1], degrees(values[2])))
                return b""
            case 6:
                self._drive.set_odometry(MetricPose())
                return b""
        return super().request(subtype, values)

    def step(self) -> None:
        if self._goal is not None:
            self._drive.drive(towards(self._goal, self._drive.state().believed))

    def data(self) -> Iterator[Datum]:
        state = self._drive.state()
        here, speed = state.believed, state.velocity
        rates = (speed.ahead, speed.left, radians(speed.turn))
        yield self._datum(here.x, here.y, angle(here.yaw), *rates, int(state.is_stalled))

    def _go(self, ahead: float, left: float, turn: float) -> None:
        self._goal = None
        self._drive.drive(Velocity(ahead, left, degrees(turn)))


class HeadDevice(MountedDevice):
    """A part that turns by itself on its robot, with all that is mounted on it."""

    interface = Interface.POSITION2D

    def begin(self) -> None:
        self._mount = relative(self._model.pose, self._loop.scene.models[self._model.root].pose)
        self._turned = self._rate = 0.0
        self._goal: float | None = None

    def command(self, subtype: int, values: Values) -> None:
        if not all(map(_is_usable, values)):
            return
        if subtype in (1, 3):
            rate = degrees(values[2 if subtype == 1 else 1])
            self._goal, self._rate = None, max(-FASTEST_TURN, min(FASTEST_TURN, rate))
        elif subtype == 2:
            self._goal = degrees(values[2])

    def request(self, subtype: int, values: Values) -> bytes | None:
        return b"" if subtype in (2, 4, 5, 6) else super().request(subtype, values)

    def close(self) -> None:
        super().close()
        if not self.users:
            self._goal, self._rate = None, 0.0

    def step(self) -> None:
        if self._goal is not None:
            self._rate = _turn(self._goal - self._here().yaw)
        if self._rate and not (self._loop.is_paused or self._drive.is_held):
            self._turned += self._rate * TICK
            self._drive.turn_head(self._model.index, self._turned)

    def data(self) -> Iterator[Datum]:
        here = self._here()
        yield self._datum(here.x, here.y, angle(here.yaw), 0.0, 0.0, radians(self._rate), 0)

    def _here(self) -> Placement:
        base = self._drive.state().believed
        mount = Placement(self._mount.x, self._mount.y, 0.0, self._mount.yaw + self._turned)
        return Placement(base.x, base.y, 0.0, base.yaw).then(mount)


NEAR = 0.02
"""Metres: so near a goal a robot only turns to its heading."""
FASTEST, FASTEST_TURN = 0.4, degrees(1.0)
"""Metres and degrees a second on the way to a goal."""


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


SONARS = (-45.0, 0.0, 45.0, 135.0, 180.0, -135.0)
"""Where the six sonars of Donnie look, in the order that the original's clients know."""


class RangeFinder(MountedDevice):
    """Sonars, or a laser: one sensor with its samples, or several with one each."""

    interface = Interface.RANGER

    def begin(self) -> None:
        yaws = [round(normal(each.pose.yaw)) for each in self._model.sensors]
        self._is_donnie = sorted(yaws) == sorted(map(round, SONARS))
        """Whether these are the sonars of the robot Donnie."""
        self._order = [yaws.index(round(each)) for each in SONARS] if self._is_donnie else [*range(len(yaws))]
        root = self._model.root
        tree = self._loop.scene.tree(root)
        others = [each.index for each in tree if len(each.sensors) == 1 and each.parent != root]
        self._seventh = others[0] if self._is_donnie and others else None
        """The head's sonar, which clients of Donnie's take for one more of these."""

    def geometry(self) -> bytes | None:
        sensors = [self._model.sensors[each] for each in self._order]
        sizes = [each.size for each in sensors]
        return self._ack(1, *self._place(), [pose3d(each.pose) for each in sensors], sizes)

    def request(self, subtype: int, values: Values) -> bytes | None:
        if subtype != 5:
            return super().request(subtype, values)
        first = self._model.sensors[self._order[0]]
        view = radians(first.fov)
        resolution = self._loop.scene.settings.get("resolution", 0.02)
        step = float(resolution) if isinstance(resolution, (int, float)) else 0.02
        bounds = (first.minimum, first.maximum, step, 1 / TICK)
        return self._ack(5, -view / 2, view / 2, view / first.samples, *bounds)

    def data(self) -> Iterator[Datum]:
        (reading,) = self._drive.rangers(self._model.index)
        pairs = [(reading.sensors[each], reading.returns[each]) for each in self._order]
        if self._seventh is not None:
            (head,) = self._drive.rangers(self._seventh)
            pairs.append((head.sensors[0], head.returns[0]))
        ranges: list[float] = []
        seen: list[float] = []
        for samples, returns in pairs:
            only = slice(len(samples) // 2, len(samples) // 2 + 1) if len(pairs) > 1 else slice(None)
            ranges += samples[only]
            seen += returns[only]
        if ranges:
            yield self._datum(ranges)
            yield self._datum(seen, subtype=3)


class BumperBars(MountedDevice):
    interface = Interface.BUMPER

    def geometry(self) -> bytes | None:
        return self._ack(1, [(*pose3d(each.pose), each.length, 0.0) for each in self._model.bumpers])

    def data(self) -> Iterator[Datum]:
        pressed = self._drive.bumpers(self._model.index)[0].pressed
        yield self._datum(bytes(pressed))


HALF_HEIGHT = 0.3
"""Metres: a seen thing is taken to be twice as high."""


class ColourFinder(MountedDevice):
    """Coloured things in the columns and rows of a picture."""

    interface = Interface.BLOBFINDER

    def data(self) -> Iterator[Datum]:
        finder = self._model.blobfinder
        assert finder is not None
        width, height = finder.image
        blobs = []
        for seen in self._drive.blobs(self._model.index)[0].blobs:
            red, green, blue = seen.colour
            left, right = (
                max(0, min(width - 1, int((finder.fov / 2 - each) / finder.fov * width)))
                for each in (seen.left, seen.right)
            )
            rows = degrees(atan2(HALF_HEIGHT, seen.metres)) / finder.fov * width
            top, bottom = (max(0, min(height - 1, int(height / 2 + each))) for each in (-rows, rows))
            area = (right - left + 1) * (bottom - top + 1)
            colour = red << 16 | green << 8 | blue
            middle = ((left + right) // 2, (top + bottom) // 2)
            blobs.append((0, colour, area, *middle, left, right, top, bottom, seen.metres))
        yield self._datum(width, height, blobs)


class MarkReader(MountedDevice):
    """Fiducial marks, and the one that its own robot shows."""

    interface = Interface.FIDUCIAL

    def request(self, subtype: int, values: Values) -> bytes | None:
        if subtype == 8:
            self._loop.change(self._model.index, fiducial_return=float(values[0]))
        own = self._loop.scene.models[self._model.index].fiducial_return
        found = max(0, int(own))
        return self._ack(subtype, found) if subtype in (7, 8) else super().request(subtype, values)

    def geometry(self) -> bytes | None:
        return self._ack(1, *self._place(), 0.1, 0.1)

    def data(self) -> Iterator[Datum]:
        marks = []
        for mark in self._drive.marks(self._model.index)[0].marks:
            x, y = mark.metres * cos(radians(mark.degrees)), mark.metres * sin(radians(mark.degrees))
            marks.append((mark.number, x, y, 0.0, 0.0, 0.0, angle(mark.yaw), *(0.0,) * 6))
        yield self._datum(marks)


OPEN, CLOSED, MOVING = 1, 2, 3


class Paddles(MountedDevice):
    """A gripper. What is between its paddles when they have closed is carried along."""

    interface = Interface.GRIPPER

    def begin(self) -> None:
        gripper = self._model.gripper
        self._wanted = CLOSED if gripper is not None and gripper.closed else OPEN
        self._ticks_left = 0

    def command(self, subtype: int, values: Values) -> None:  # noqa: ARG002 -- it has none
        wanted = {1: OPEN, 2: CLOSED}.get(subtype, self._wanted)
        if wanted != self._wanted:
            self._wanted, self._ticks_left = wanted, round(1.0 / TICK)
            if wanted == OPEN and (released := self._drive.release()).outcome is Grip.RELEASED:
                self.reporter.gripped(self._drive.name, released)

    def geometry(self) -> bytes | None:
        return self._ack(1, *self._place(), *box3d(self._model.size), 2, 0)

    def step(self) -> None:
        if self._ticks_left and not self._loop.is_paused:
            self._ticks_left -= 1
            if not self._ticks_left and self._wanted == CLOSED:
                taken = self._drive.grip()
                if taken.outcome is Grip.GRIPPED:
                    self.reporter.gripped(self._drive.name, taken)

    def data(self) -> Iterator[Datum]:
        outer, inner = self._drive.beams()
        yield self._datum(MOVING if self._ticks_left else self._wanted, outer << 2 | inner << 3, 0)


LONGEST_TEXT = 1000
"""Characters of a text that is said."""


class ServiceDevice(Equipment):
    """A device that belongs to a robot and is no model of its own."""

    def __init__(self, index: int, driver: str, robot: str, reporter: Reporter) -> None:
        super().__init__(index, driver)
        self._robot, self._reporter = robot, reporter


class SpeechDevice(ServiceDevice):
    """Texts that are said in a robot's name."""

    interface = Interface.SPEECH

    def command(self, subtype: int, values: Values) -> None:
        if subtype == 1 and values[0]:
            shown = (each if each.isprintable() else " " for each in values[0][:LONGEST_TEXT])
            self._reporter.said(self._robot, "".join(shown))


class BeltFrames(ServiceDevice):
    """Texts that are frames of the belt: a letter for each of its cells."""

    interface = Interface.SPEECH

    def command(self, subtype: int, values: Values) -> None:
        for motor, letter in enumerate(values[0][:LONGEST_FRAME] if subtype == 1 else ""):
            self._reporter.vibrated(self._robot, motor, letter)


LONGEST_FRAME = 36


class DigitalOutputs(ServiceDevice):
    """Digital outputs, such as the belt's: they show what was asked for last."""

    interface = Interface.DIO

    def __init__(self, index: int, driver: str, robot: str, reporter: Reporter) -> None:
        super().__init__(index, driver, robot, reporter)
        self._last: Values = (0, 0)

    def command(self, subtype: int, values: Values) -> None:
        if subtype == 1:
            self._last = values
            self._reporter.vibrated(self._robot, values[0], chr(values[1] & 0x7F))

    def data(self) -> Iterator[Datum]:
        yield self._datum(*self._last)


class SoundDevice(ServiceDevice):
    """Sounds by the names of their files, of which none is opened."""

    interface = Interface.SOUND

    def command(self, subtype: int, values: Values) -> None:
        if subtype == 1:
            self._reporter.sounded(self._robot, values[0].partition(b"\0")[0].decode("ascii", "replace"))


class Battery(Equipment):
    """A battery that is always full."""

    interface = Interface.POWER

    def data(self) -> Iterator[Datum]:
        yield self._datum(8, 0.0, 100.0, 0.0, 0.0, 0)


class Whole(Equipment):
    """The simulation: where things are, and putting them elsewhere. It works without being opened."""

    interface = Interface.SIMULATION

    def __init__(self, index: int, driver: str, loop: VelocityLoop) -> None:
        super().__init__(index, driver)
        self._loop = loop
        models = loop.scene.models
        self._names = {_whole_name(model, models): model.index for model in reversed(models)}

    def command(self, subtype: int, values: Values) -> None:  # noqa: ARG002 -- it has none
        if subtype == 1:
            self._loop.is_paused = not self._loop.is_paused
        elif subtype == 2:
            self._loop.reset()

    def request(self, subtype: int, values: Values) -> bytes | None:
        index = self._names.get(values[0]) if values else None
        if subtype in (5, 6):
            return self._property(subtype, values, index)
        if index is None:
            return None
        model = self._loop.scene.models[index]
        try:
            match subtype:
                case 1:
                    here = self._here(model)
                    return self._ack(1, values[0], here.x, here.y, angle(here.yaw))
                case 3:
                    here = self._here(model)
                    pose = (here.x, here.y, model.pose.z, 0.0, 0.0, angle(here.yaw))
                    return self._ack(3, values[0], *pose, self._loop.time * 1e6)
                case 2 | 4 if model.parent is None and all(map(_is_usable, values[1:])):
                    yaw = values[3] if subtype == 2 else values[6]
                    self._loop.put(model.name, MetricPose(values[1], values[2], degrees(yaw)))
                    return b""
        except KeyError:  # it can't move, or several have this name
            pass
        return None

    def _here(self, model: Model) -> MetricPose:
        if model.parent is None:
            return self._loop.pose(model.spoken_name)
        local = relative(model.pose, self._loop.scene.models[model.parent].pose)
        return MetricPose(local.x, local.y, local.yaw)

    def _property(self, subtype: int, values: Values, index: int | None) -> bytes | None:
        """Numbers in the byte order of the clients."""
        name, what, number, given = values
        if what == "time" and len(given) == 8 and subtype == 5:
            return self._ack(5, name, what, number, struct.pack("<Q", round(self._loop.time * 1e6)))
        if what != "color" or len(given) != 16 or index is None:
            return None
        if subtype == 5:
            colour = self._loop.scene.models[index].colour
            rgba = struct.pack("<ffff", colour.red, colour.green, colour.blue, colour.alpha)
            return self._ack(5, name, what, number, rgba)
        parts = struct.unpack("<ffff", given)
        if not all(0.0 <= each <= 1.0 for each in parts):
            return None
        self._loop.change(index, colour=colour_of("", *parts))
        return b""


def _whole_name(model: Model, models: Sequence[Model]) -> str:
    if model.parent is None:
        return model.name
    return f"{_whole_name(models[model.parent], models)}.{model.name}"


def angle(of_degrees: float) -> float:
    """In radians, above -pi and up to pi."""
    return radians(normal(of_degrees))


def pose3d(place: Placement) -> tuple[float, ...]:
    return place.x, place.y, place.z, 0.0, 0.0, angle(place.yaw)


def box3d(size: tuple[float, float, float]) -> tuple[float, float, float]:
    """The width (y) comes first."""
    return size[1], size[0], size[2]
