"""What a movement of one robot ended at, and on which side of it that is."""

from __future__ import annotations

from collections.abc import Iterable
from math import hypot

from devices.ports.robot import STEP, Met, StoppedBy
from sim.geometry import Point, angle_of, edges, nearest_on_edge, nearest_point_in_wedge, normal, seen_from
from sim.motion import Mover
from sim.parts import Part
from sim.placement import Spot
from sim.scene import Scene

SIGHT = 3 * STEP
"""Metres beyond the body in which an obstacle stops a walk: less than two steps before a sensor, which may
look a bit to the side."""
WEDGE = 60.0
"""Degrees to either side of the way in which it is looked for."""
HALF = 90.0

WALL, ROBOT = "wall", "robot"


class Meeting:
    """Asked when a movement is over. It finds nothing where nothing was in the way."""

    def __init__(self, mover: Mover, scene: Scene, robot: int) -> None:
        """``robot``: the index of its model."""
        self._mover = mover
        self._scene = scene
        self._me = scene.models[robot]
        self._walls: dict[int, bool] = {}
        """Whether models are walls, as far as that was asked."""

    def walking(self, spot: Spot, turned: float, stopped_by: StoppedBy | None) -> Met | None:
        """After a walk in the direction that is ``turned`` degrees from the front of a robot at ``spot``."""
        if stopped_by is StoppedBy.OBSTACLE:
            found = self._mover.barring(spot, self._mover.body.radius + SIGHT)
            return self._nearest(found, spot, turned, WEDGE)
        if stopped_by is StoppedBy.COLLISION:
            part = self._mover.contact(spot, spot.yaw + turned, STEP).part
            return None if part is None else self._nearest([part], spot, turned, HALF)
        return None

    def turning(self, spot: Spot, stopped_by: StoppedBy | None) -> Met | None:
        """After a turn on the spot, or on a car's circle."""
        if stopped_by is StoppedBy.OBSTACLE:
            return self.walking(spot, 0.0, stopped_by)
        if stopped_by is StoppedBy.COLLISION:
            return self._nearest(self._mover.touchable(spot), spot, 0.0, None)
        return None

    def _nearest(
        self, parts: Iterable[Part], spot: Spot, turned: float, half_angle: float | None
    ) -> Met | None:
        """Of those that come within the wedge about the way; None: on any side."""
        found = [
            (point, part)
            for part in parts
            if (point := _nearest_point(part, spot, spot.yaw + turned, half_angle)) is not None
        ]
        if not found:
            return None
        point, part = min(found, key=lambda each: hypot(*each[0]))
        return self._met(part, normal(-angle_of(*point) - turned))

    def _met(self, part: Part, degrees: float) -> Met:
        model = self._scene.models[part.root]
        name = "" if ":" in model.spoken_name else model.spoken_name
        if model.index in self._scene.robots:
            return Met(ROBOT, name, degrees)
        return Met(WALL, "", degrees) if self._is_wall(part.root) else Met(model.kind, name, degrees)

    def _is_wall(self, root: int) -> bool:
        if root not in self._walls:
            from sim.picture import is_wall  # who meets nothing needs no picture

            self._walls[root] = is_wall(self._scene.models[root], self._me)
        return self._walls[root]


def _nearest_point(part: Part, spot: Spot, angle: float, half_angle: float | None) -> Point | None:
    """Its point nearest to the robot's centre, where the robot's way is the positive x axis."""
    outline = edges(seen_from(part.points, spot.x, spot.y, angle))
    if half_angle is not None:
        return nearest_point_in_wedge(outline, half_angle)
    return min((nearest_on_edge(edge) for edge in outline), key=lambda point: hypot(*point), default=None)
