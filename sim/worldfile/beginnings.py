"""Robots that begin inside of something: Stage lets them stand there, and so do we, but it is a slip.

A thing without a pose stands at 0 0, where the robot mostly is. What surrounds a robot without touching it,
a room or a bitmap's walls, is no slip.
"""

from __future__ import annotations

from collections.abc import Iterator

from sim.geometry import overlapping, placed
from sim.notes import Note, NoteKind
from sim.parts import Body, Part, body_of, parts_of
from sim.scene import Model, Scene

MOST = 50
"""Robots that are looked at."""


def standing_inside(scene: Scene) -> Iterator[Note]:
    """A remark for each robot and thing of which one begins inside the other."""
    if not scene.robots:
        return
    parts = tuple(part for part in parts_of(scene) if part.solid)
    told = set[int]()
    for index in scene.robots[:MOST]:
        robot, body = scene.models[index], body_of(scene, index)
        others = (part for part in parts if part.root not in (index, *told))
        for root in dict.fromkeys(part.root for part in others if _is_in(robot, body, part)):
            details = {"name": robot.spoken_name[:60], "thing": _called(scene.models[root])}
            yield Note(NoteKind.WARNING, "starts-inside", "", 0, 0, details)
        told.add(index)


def _is_in(robot: Model, body: Body, part: Part) -> bool:
    here, (x, y), reach = robot.pose, part.middle, part.reach + body.radius
    if (x - here.x) ** 2 + (y - here.y) ** 2 > reach * reach:
        return False
    mine = (placed(points, here.x, here.y, here.yaw) for points in body.polygons)
    return any(overlapping(points, part.points) for points in mine)


def _called(model: Model) -> str:
    """In the words of the file: the one that made it, and its name if it has one."""
    name = "" if ":" in model.spoken_name else model.spoken_name
    return (name if name and model.kind in (model.type, *name.split()) else f"{model.kind} {name}").strip()[
        :60
    ]
