"""The room that a robot has: how far it is from its edge to the edge of what stands around it.

One measure for all that is told of distances, that of its range sensors: free steps between the robot's body
and the thing. Picture in, numbers out.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, inf

from devices.ports.robot import Pose
from sim.geometry import (
    Edge,
    Point,
    angle_of,
    contains,
    edges,
    edges_apart,
    nearest_on_edge,
    outline_contact,
    placed,
    seen_from,
)
from sim.picture import Picture

HALF_A_CENTIMETRE = 0.1
"""In steps."""
Outlines = Sequence[Sequence[Point]]


class Room:
    """A robot at one place of a picture. All lengths in steps, all directions in compass degrees.

    What its middle is in, such as a floor drawn as a box, is not in its way: so it is for the simulator.
    """

    def __init__(self, picture: Picture, pose: Pose) -> None:
        self._pose = pose
        self._body = picture.body or (((0.0, 0.0),),)
        self.walls: Outlines = [each for each in picture.walls if not contains(each, pose.x, pose.y)]
        things = (points for each in picture.things for points in each.outlines)
        self.all: Outlines = (*self.walls, *things)

    def ahead(self, outlines: Outlines, heading: float) -> float:
        """How far the robot could be moved to ``heading``, as it stands, until it touches; or infinity."""
        mine = self._edges(90.0 - heading)
        gaps = (outline_contact(mine, edges(self._seen(points, heading)))[0] for points in outlines)
        return min(gaps, default=inf)

    def nearest(self, outlines: Outlines) -> tuple[float, float]:
        """How far away its nearest edge is, and in which direction from the robot's middle."""
        theirs = [edge for points in outlines for edge in edges(self._seen(points, 90.0))]
        gap = min((edges_apart(a, b) for a in self._edges(0.0) for b in theirs), default=inf)
        x, y = min((nearest_on_edge(edge) for edge in theirs), key=_length2, default=(0.0, 0.0))
        return gap, 90.0 - angle_of(x, y)

    @staticmethod
    def whole(steps: float) -> int:
        """Whole steps of whole centimetres, as range sensors count them."""
        return floor(steps + HALF_A_CENTIMETRE)

    def _edges(self, angle: float) -> tuple[Edge, ...]:
        """The body's, around the origin, seen by who looks to ``angle``."""
        turned = 90.0 - self._pose.heading - angle
        return tuple(edge for points in self._body for edge in edges(placed(points, 0.0, 0.0, turned)))

    def _seen(self, points: Sequence[Point], heading: float) -> tuple[Point, ...]:
        return seen_from(points, self._pose.x, self._pose.y, 90.0 - heading)


def _length2(point: Point) -> float:
    return point[0] * point[0] + point[1] * point[1]
