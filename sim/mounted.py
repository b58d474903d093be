"""What is mounted on a robot, for words and for maps: where it looks, how wide, how far. Values only.

In the robot's frame: degrees clockwise from its front, steps ahead and to the right. A camera is here too: no
picture is made of what it sees, but its field of view is known.
"""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum
from math import ceil, cos, radians, sin

from devices.ports.robot import STEP
from devices.ports.values import Frozen
from sim.geometry import normal
from sim.scene import Model, Scene
from sim.sensors.rangers import Beams, Cone
from sim.sensors.senses import senses_of

ARC = 10
"""Degrees between the points of a drawn arc."""

Line = tuple[tuple[float, float], ...]
"""Points to the right and ahead, in steps."""


class Device(Enum):
    RANGER = "ranger"
    EYES = "eyes"
    """Tells colours apart: a blobfinder."""
    CAMERA = "camera"
    BUMPER = "bumper"
    GRIPPER = "gripper"


class Mounted(Frozen):
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
        )
        for each in senses.rangers
    )
    eyes = (
        _field(Device.EYES, each.x, each.y, each.yaw, 2 * each.half_angle, each.maximum, 0.0, each.offset)
        for each in (senses.eyes.views if senses.eyes else ())
    )
    bumpers = (Mounted(Device.BUMPER, 0.0 - normal(each.yaw)) for each in senses.bumpers)
    gripper = [_gripper(senses.beams)] if senses.beams else []
    return (*rangers, *eyes, *_cameras(scene, model), *bumpers, *gripper)


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
    """From metres ahead and to the left to steps to the right and ahead."""
    angle = radians(yaw)
    return -(y + metres * sin(angle)) / STEP, (x + metres * cos(angle)) / STEP
