"""The floor under a simulated board: the walls and things of a world, as its sensors meet them.

Nothing moves there: the board has no gripper and pushes nothing.
"""

from __future__ import annotations

from math import degrees, isfinite, radians
from typing import TYPE_CHECKING

from devices.board_simulator.floor import AxlePose, BumperSwitch
from devices.ports.robot import STEP, Bearing, Pose
from devices.serial_robot.config import RobotConfig
from sim.geometry import overlapping, placed

if TYPE_CHECKING:
    from sim.geometry import Spot
    from sim.scene import Scene

TOUCH = 0.003
"""Metres before a thing at which a bumper is pressed."""

_SONARS = RobotConfig().sonars
"""The directions of the original board's sonars, independent of the driver's settings."""

_PRESSED_BY = {
    0: (BumperSwitch.NE, BumperSwitch.NW),
    45: (BumperSwitch.NW,),
    -45: (BumperSwitch.NE,),
    135: (BumperSwitch.SW,),
    -135: (BumperSwitch.SE,),
    180: (BumperSwitch.SE, BumperSwitch.SW),
}
"""The bumpers that are pressed by something in that direction, degrees to the left of the robot's front."""


class SceneFloor:
    """The floor around a board that stands in the place of the world's first robot."""

    def __init__(self, scene: Scene) -> None:
        from sim.ground import Ground
        from sim.motion import Mover

        self._mover = Mover(Ground(scene), scene.robots[0])

    def centimetres(self, place: AxlePose, sonar: int, head: int) -> float | None:
        """The distance of the nearest thing in the sonar's cone; None without a thing or a sonar there."""
        bearing, turned = _looks(sonar, head)
        if bearing is None:
            return None
        spot, around = _spot(place), self._mover.around
        metres = min(
            (each.metres(around, spot, turned) for each in self._mover.senses.at(bearing)), default=None
        )
        return None if metres is None or not isfinite(metres) else metres * 100

    def touched(self, place: AxlePose) -> frozenset[BumperSwitch]:
        """The bumpers that something is close to."""
        spot = _spot(place)
        return frozenset(
            switch
            for left, switches in _PRESSED_BY.items()
            if self._mover.contact(spot, spot.yaw + left, TOUCH).metres < TOUCH
            for switch in switches
        )

    def is_free(self, place: AxlePose) -> bool:
        """Whether the robot's body overlaps nothing solid there."""
        spot, body = _spot(place), self._mover.body
        mine = tuple(placed(points, spot.x, spot.y, spot.yaw) for points in body.polygons)
        close = self._mover.around.near(spot.x, spot.y, body.radius)
        return not any(part.solid and overlapping(points, part.points) for part in close for points in mine)


def place_of(start: Pose) -> AxlePose:
    """A pose in steps and compass degrees as the board's pose."""
    return AxlePose(start.x * STEP, start.y * STEP, radians(90.0 - start.heading))


def _looks(sonar: int, head: int) -> tuple[Bearing | None, float]:
    """The bearing of a sonar of the body, or of the one on the head, and how far that is turned left."""
    if sonar < len(_SONARS):
        return _SONARS[sonar], 0.0
    return Bearing.FRONT, 90.0 - head


def _spot(place: AxlePose) -> Spot:
    from sim.geometry import Spot

    return Spot(place.x, place.y, degrees(place.yaw))
