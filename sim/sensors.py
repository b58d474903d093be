"""All sensors of one robot, gathered from everything attached to it, with readings in steps.

``Mounted`` describes each of them for words and maps in the robot's frame: where it looks, how wide, how far;
degrees clockwise from its front, steps ahead and to the right. Cameras are included for their field of view.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from enum import Enum
from math import ceil, cos, hypot, inf, radians, sin
from typing import TYPE_CHECKING

from msgspec import Struct

from devices.ports.robot import CENTIMETRES_A_STEP, STEP, Bearing, RobotProblem
from sim.cameras import HALF_CIRCLE, Found, MarkFinder, Seen, View
from sim.geometry import Placement, Spot, normal, seen_from
from sim.rangers import Around, Bar, Beams, Cone, Fan, Height, Ranger, fan_angles
from sim.scene import Model, RangeSensor, Scene

if TYPE_CHECKING:
    from random import Random


HALF_SECTOR = 22.5
"""Degrees: a sensor that looks at most so far off one of the robot's bearings measures it."""


class Senses(Struct, frozen=True):
    """All the sensors of one robot."""

    rangers: tuple[Ranger, ...]
    views: tuple[View, ...]
    """Of its cameras that distinguish colours."""
    finders: tuple[MarkFinder, ...]
    bumpers: tuple[Bar, ...]
    beams: Beams | None
    """Of its first gripper."""
    by_bearing: Mapping[Bearing, tuple[Ranger, ...]]
    by_name: Mapping[str, tuple[Ranger, ...]]
    """The sensors of each part that the world gives a name."""

    def at(self, bearing: Bearing) -> tuple[Ranger, ...]:
        """The sensors of a bearing; empty if there is none."""
        return self.by_bearing[bearing]

    def steps(self, around: Around, spot: Spot, bearing: Bearing, chance: Random | None = None) -> int:
        """Whole steps to the nearest thing there, or as far as the sensors reach.

        ``chance``: sensors with noise have it; without, every reading is exact. RobotProblem
        ``no-sensor`` (bearing, in words): nothing looks there.
        """
        rangers = self.by_bearing[bearing]
        if not rangers:
            raise RobotProblem("no-sensor", bearing=bearing.words)
        return _steps(rangers, around, spot, chance)

    def named_steps(self, around: Around, spot: Spot, name: str, chance: Random | None = None) -> int:
        """As ``steps``, of the sensors with that name. Raises ``KeyError``."""
        return _steps(self.by_name[name], around, spot, chance)

    def all_steps(self, around: Around, spot: Spot) -> dict[Bearing, int]:
        """The exact steps of each bearing that has sensors."""
        return {
            bearing: self.steps(around, spot, bearing)
            for bearing, rangers in self.by_bearing.items()
            if rangers
        }

    def look(self, around: Around, spot: Spot) -> tuple[Seen, ...]:
        """Every coloured thing in view once, from left to right, as seen by the camera nearest to it.

        RobotProblem ``no-eyes``: it has no blobfinder.
        """
        if not self.views:
            raise RobotProblem("no-eyes")
        nearest: dict[int, Seen] = {}
        for view in self.views:
            for seen in view.look(around, spot):
                known = nearest.get(seen.root)
                if known is None or seen.centimetres < known.centimetres:
                    nearest[seen.root] = seen
        return tuple(sorted(nearest.values(), key=lambda thing: (-thing.degrees, thing.root)))

    def marks(self, around: Around, spot: Spot) -> tuple[Found, ...]:
        """The marks of the fiducial finders, finder by finder."""
        return tuple(found for finder in self.finders for found in finder.look(around, spot))

    def marks_ahead(self, around: Around, spot: Spot) -> list[Found]:
        """Each mark in the half circle ahead once, as the finder reads it best, from left to right."""
        ahead = [each for each in self.marks(around, spot) if abs(each.degrees) <= HALF_CIRCLE]
        ahead.sort(key=lambda each: (each.number == 0, each.metres))
        once = {each.model: each for each in reversed(ahead)}
        return sorted(once.values(), key=lambda each: (-each.degrees, each.model))


def _steps(rangers: tuple[Ranger, ...], around: Around, spot: Spot, chance: Random | None) -> int:
    nearest, farthest = inf, 0.0
    for each in rangers:
        reading = each.centimetres(around, spot) if chance is None else each.noisy(around, spot, chance)
        if reading is None:
            farthest = max(farthest, each.maximum)
        elif reading < nearest:
            nearest = reading
    return (int(farthest * 100 + 0.5) if nearest == inf else int(nearest)) // CENTIMETRES_A_STEP


def senses_of(scene: Scene, robot: int) -> Senses:
    """The sensors of a robot and of everything attached to it."""
    models = scene.tree(robot)
    frame = scene.models[robot].pose
    rangers = tuple(rangers_of(models, frame))
    by_bearing = {bearing: tuple(_towards(rangers, bearing)) for bearing in Bearing}
    beams = next((_beams(model, frame) for model in models if model.gripper), None)
    return Senses(
        rangers,
        tuple(_views(scene, models, frame, by_bearing)),
        tuple(finders_of(models, frame)),
        tuple(bumpers_of(models, frame)),
        beams,
        by_bearing,
        dict(_named(models, frame)),
    )


def rangers_of(models: tuple[Model, ...], frame: Placement) -> Iterator[Ranger]:
    """Their range sensors, in the order of the file, in a frame: that of the robot, or of its head."""
    for model in models:
        for sensor in model.sensors:
            x, y, yaw = _mounted(model.pose.then(sensor.pose), frame)
            yield _ranger(sensor, x, y, yaw, _height(model, sensor.pose.z + sensor.size[2] / 2))


def _ranger(sensor: RangeSensor, x: float, y: float, yaw: float, height: Height) -> Ranger:
    bounds = (sensor.minimum, sensor.maximum, height, sensor.noise)
    if sensor.samples == 1:
        return Cone(x, y, yaw, sensor.fov / 2, *bounds)
    return Fan(x, y, fan_angles(yaw, sensor.fov, sensor.samples), *bounds)


def _named(models: tuple[Model, ...], frame: Placement) -> Iterator[tuple[str, tuple[Ranger, ...]]]:
    """The sensors of each part of a robot, by its name; Stage's own names have a colon."""
    for model in models:
        rangers = tuple(rangers_of((model,), frame))
        if rangers and model.name and ":" not in model.name:
            yield model.name, rangers


def _towards(rangers: tuple[Ranger, ...], bearing: Bearing) -> Iterator[Ranger]:
    """The sensors, and parts of lasers, that look to a bearing."""
    angle = -float(bearing.value)
    for ranger in rangers:
        if isinstance(ranger, Cone):
            if abs(normal(ranger.yaw - angle)) <= max(HALF_SECTOR, ranger.half_angle):
                yield ranger
        elif (sector := ranger.towards(angle, HALF_SECTOR)) is not None:
            yield sector


def _views(
    scene: Scene,
    models: tuple[Model, ...],
    frame: Placement,
    by_bearing: Mapping[Bearing, tuple[Ranger, ...]],
) -> Iterator[View]:
    front = max((hypot(each.x, each.y) for each in by_bearing[Bearing.FRONT]), default=0.0)
    turns = _is_donnie(by_bearing)
    for model in models:
        if model.blobfinder is not None:
            is_on_head = turns or head_of(model, scene) is not None
            yield _head_view(model, front) if is_on_head else fixed_view(model, frame)


def _head_view(model: Model, front: float) -> View:
    """A camera on a head looks all over the half circle ahead."""
    finder = model.blobfinder
    assert finder is not None
    return View(0.0, 0.0, 0.0, HALF_CIRCLE, finder.maximum, front, finder.colours, _height(model))


def fixed_view(model: Model, frame: Placement) -> View:
    """The view of a camera without a head, which looks where it is mounted."""
    finder, (x, y, yaw) = model.blobfinder, _mounted(model.pose, frame)
    assert finder is not None
    half_angle = finder.fov / 2
    return View(x, y, yaw + finder.pan, half_angle, finder.maximum, 0.0, finder.colours, _height(model))


def _is_donnie(by_bearing: Mapping[Bearing, tuple[Ranger, ...]]) -> bool:
    """Whether it has a sonar at exactly each of Donnie's six bearings: then it has Donnie's head too."""
    return all(
        any(isinstance(each, Cone) and abs(normal(each.yaw + bearing.value)) < 1e-6 for each in rangers)
        for bearing, rangers in by_bearing.items()
    )


def head_of(model: Model, scene: Scene) -> int | None:
    """The part of a robot that drives by itself and carries this model, if there is any."""
    while model.parent is not None:
        if model.wheels is not None:
            return model.index
        model = scene.models[model.parent]
    return None


def finders_of(models: tuple[Model, ...], frame: Placement) -> Iterator[MarkFinder]:
    """Their fiducial finders."""
    for model in models:
        if model.fiducial_finder is not None:
            place = _mounted(model.pose, frame)
            yield MarkFinder(*place, model.fiducial_finder, model.fiducial_key, _height(model))


def bumpers_of(models: tuple[Model, ...], frame: Placement) -> Iterator[Bar]:
    """The bars of their bumpers."""
    for model in models:
        for bumper in model.bumpers:
            yield Bar(*_mounted(model.pose.then(bumper.pose), frame), bumper.length)


def _beams(model: Model, frame: Placement) -> Beams:
    assert model.gripper is not None
    shape = model.pose.then(model.origin)
    return Beams(*_mounted(shape, frame), model.size[0], model.size[1], model.gripper)


def _mounted(place: Placement, frame: Placement) -> tuple[float, float, float]:
    """A place of the world, converted to the robot's frame: x, y, yaw."""
    ((x, y),) = seen_from(((place.x, place.y),), frame.x, frame.y, frame.yaw)
    return round(x, 9), round(y, 9), normal(place.yaw - frame.yaw)


def _height(model: Model, above: float = 0.0) -> Height:
    return None if model.ignore_zloc else model.pose.z + above


ARC = 10
"""Degrees between the points of a drawn arc."""

Line = tuple[tuple[float, float], ...]
"""Points to the right and ahead, in steps."""


class Device(Enum):
    RANGER = "ranger"
    EYES = "eyes"
    """Distinguishes colours: a blobfinder."""
    CAMERA = "camera"
    MARKS = "marks"
    """Finds fiducial marks."""
    BUMPER = "bumper"
    GRIPPER = "gripper"


class Mounted(Struct, frozen=True):
    """One of the robot's devices."""

    device: Device
    degrees: float
    """Where it looks, above -180 to 180."""
    width: float = 0.0
    """Degrees of its field of view."""
    metres: float = 0.0
    """How far it looks."""
    lines: tuple[Line, ...] = ()
    """What a map shows of it: the border of a field of view, the paddles of a gripper."""
    name: str = ""
    """The name by which a program reads it."""


def mounted(scene: Scene, robot: str) -> tuple[Mounted, ...]:
    """The devices of a robot, kind by kind. KeyError if the world has no such robot."""
    model = scene.robot(robot)
    senses = senses_of(scene, model.index)
    rangers = (
        Mounted(
            Device.RANGER,
            0.0 - normal(each.yaw if isinstance(each, Cone) else (each.angles[0] + each.angles[-1]) / 2),
            2 * each.half_angle if isinstance(each, Cone) else abs(each.angles[-1] - each.angles[0]),
            each.maximum,
            name=next((name for name, those in senses.by_name.items() if each in those), ""),
        )
        for each in senses.rangers
    )
    finders = (
        Mounted(Device.MARKS, 0.0 - normal(each.yaw), each.finder.fov, each.finder.maximum)
        for each in senses.finders
    )
    eyes = (
        _field(Device.EYES, each.x, each.y, each.yaw, 2 * each.half_angle, each.maximum, 0.0, each.offset)
        for each in senses.views
    )
    bumpers = (Mounted(Device.BUMPER, 0.0 - normal(each.yaw)) for each in senses.bumpers)
    gripper = [_gripper(senses.beams)] if senses.beams else []
    return (*rangers, *eyes, *finders, *_cameras(scene, model), *bumpers, *gripper)


def _cameras(scene: Scene, robot: Model) -> Iterator[Mounted]:
    at = robot.pose
    for model in scene.tree(robot.index):
        if model.camera is not None:
            dx, dy = model.pose.x - at.x, model.pose.y - at.y
            c, s = cos(radians(at.yaw)), sin(radians(at.yaw))
            camera, yaw = model.camera, normal(model.pose.yaw - at.yaw + model.camera.pan)
            place = dx * c + dy * s, dy * c - dx * s
            yield _field(Device.CAMERA, *place, yaw, camera.fov[0], camera.maximum, camera.minimum, 0.0)


def _field(
    device: Device, x: float, y: float, yaw: float, width: float, metres: float, nearest: float, begins: float
) -> Mounted:
    """Two sides and an arc, without sides where it looks all round. ``metres`` count from ``begins``."""
    pieces = max(1, ceil(width / ARC))
    angles = [yaw + width / 2 - width * each / pieces for each in range(pieces + 1)]
    farthest = metres + begins
    arc = tuple(_ahead(x, y, angle, farthest) for angle in angles)
    sides = [
        (_ahead(x, y, angle, nearest), _ahead(x, y, angle, farthest)) for angle in (angles[0], angles[-1])
    ]
    return Mounted(device, 0.0 - normal(yaw), width, metres, (*(sides if width < 360.0 else ()), arc))


def _gripper(beams: Beams) -> Mounted:
    """The inner edges of its open paddles."""
    half = beams.width * (0.5 - beams.gripper.paddle_width)
    paddles = []
    for side in (90.0, -90.0):
        (right, ahead) = _ahead(beams.x, beams.y, beams.yaw + side, half)
        ends = (beams.length * (0.5 - beams.gripper.paddle_length), beams.length / 2)
        paddles.append(tuple(_ahead(ahead * STEP, -right * STEP, beams.yaw, end) for end in ends))
    return Mounted(Device.GRIPPER, 0.0 - normal(beams.yaw), lines=tuple(paddles))


def _ahead(x: float, y: float, yaw: float, metres: float) -> tuple[float, float]:
    """Converts metres ahead and to the left into steps to the right and ahead."""
    angle = radians(yaw)
    return -(y + metres * sin(angle)) / STEP, (x + metres * cos(angle)) / STEP
