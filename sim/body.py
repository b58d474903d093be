"""What of a robot bumps into things: its own shape, what is attached to it, and what it holds."""

from __future__ import annotations

from collections.abc import Iterable
from math import hypot

from devices.ports.values import frozen
from sim.geometry import Edge, Point, contains, edges, nearest_on_edge, placed, seen_from
from sim.scene import Scene

ROUND = 0.9
"""A body whose inner circle is at least this part of its outer one turns like a disc, in the outer one."""

Outline = tuple[Point, ...]


@frozen
class Body:
    """Polygons in the robot's own frame."""

    polygons: tuple[Outline, ...]
    radius: float
    """Metres from its centre of rotation to its farthest point."""
    is_round: bool

    def outline(self, angle: float) -> tuple[Edge, ...]:
        """Its edges when it looks to ``angle``, around the origin."""
        return tuple(edge for points in self.polygons for edge in edges(placed(points, 0.0, 0.0, angle)))

    def holding(self, held: Iterable[Outline]) -> Body:
        """The same body with more polygons, in its frame."""
        return _body((*self.polygons, *held))


def body_of(scene: Scene, robot: int) -> Body:
    """The robot's own shape, solid whatever its file says, and everything solid that is attached to it."""
    frame = scene.models[robot].pose
    solid = (model for model in scene.tree(robot) if model.solid or model.index == robot)
    outlines = (points for model in solid for points in model.outlines())
    return _body(tuple(seen_from(points, frame.x, frame.y, frame.yaw) for points in outlines))


def _body(polygons: tuple[Outline, ...]) -> Body:
    radius = max((hypot(x, y) for points in polygons for x, y in points), default=0.0)
    inner = max((_inner_radius(points) for points in polygons), default=0.0)
    return Body(polygons, radius, inner >= ROUND * radius)


def _inner_radius(points: Outline) -> float:
    if not contains(points, 0.0, 0.0):
        return 0.0
    return min(hypot(*nearest_on_edge(edge)) for edge in edges(points))
