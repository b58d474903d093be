"""Worlds that others wrote for Stage have the same models in the same places as in Stage."""

import json
from pathlib import Path

import pytest

from sim.scene import Model
from sim.world import World
from sim.worldfile import load_world
from tests.unit.sim.floors import Unpaced

WORLDS = (
    "donnie/donnie.world",
    "worlds/simple.world",
    "worlds/roomba.world",
    "worlds/lsp_test.world",
    "worlds/everything.world",
)


@pytest.mark.parametrize("world", WORLDS)
def test_a_world_has_the_models_that_stage_builds(shared: Path, world: str) -> None:
    truth = json.loads((shared / "stage" / "truth.json").read_text(encoding="utf-8"))[world]

    scene = load_world(shared / "stage" / world)

    assert [(m.type, m.name) for m in scene.models] == [(m["type"], m["name"]) for m in truth]
    for model, expected in zip(scene.models, truth, strict=True):
        compare(model, expected)
        parent = None if model.parent is None else scene.models[model.parent].name
        assert parent == expected["parent"]


def compare(model: Model, expected: dict[str, object]) -> None:
    x, y, z, yaw = expected["global_pose"]  # type: ignore[misc]
    assert (model.pose.x, model.pose.y, model.pose.z) == pytest.approx((x, y, z), abs=1e-3)
    assert (model.pose.yaw - yaw + 180) % 360 == pytest.approx(180, abs=1e-3)
    assert list(model.size) == pytest.approx(expected["size"])
    colour = [model.colour.red, model.colour.green, model.colour.blue]
    assert colour == pytest.approx(expected["color"][:3], abs=1e-3)  # type: ignore[index]
    returns = ("obstacle_return", "ranger_return", "fiducial_return", "gripper_return")
    assert [getattr(model, name) for name in returns] == [expected[name] for name in returns]
    assert [model.origin.x, model.origin.y, model.origin.z, model.origin.yaw] == expected["origin"]
    assert model.boundary == expected["boundary"]
    points = [point for shape in (*model.polygons, *model.walls) for point in shape.points]
    if points and not model.origin.x:  # Stage's box leaves the origin out
        (left, bottom), (right, top) = (
            tuple(f(axis) for axis in zip(*points, strict=True)) for f in (min, max)
        )
        assert [left, bottom, right, top] == pytest.approx(expected["block_bbox"], abs=1e-3)
    area = abs(expected["block_signed_area"])  # type: ignore[arg-type]
    assert model.stage_area == pytest.approx(area, rel=0.02, abs=1e-6)
    assert model.stage_blocks == expected["blocks"]
    sensors = expected.get("sensors", [])
    assert [
        ([s.pose.x, s.pose.y, s.pose.z, s.pose.yaw], [s.minimum, s.maximum], s.samples, pytest.approx(s.fov))
        for s in model.sensors
    ] == [(s["pose"], s["range"], s["samples"], s["fov_deg"]) for s in sensors]  # type: ignore[attr-defined]


@pytest.mark.parametrize("world", WORLDS)
def test_the_first_robot_of_a_stage_world_can_be_driven(shared: Path, world: str) -> None:
    robot = World(load_world(shared / "stage" / world)).robot(pace=Unpaced())

    robot.turn(90)
    robot.forward(100)
    robot.turn(-45)
    moved = robot.forward(100_000)

    assert moved.stopped_by is not None  # every one of these worlds has walls, and they hold


def test_the_original_donnie_does_not_drive_through_its_walls(shared: Path) -> None:
    robot = World(load_world(shared / "stage" / "donnie" / "donnie.world")).robot(pace=Unpaced())

    for _ in range(8):
        robot.forward(200)
        robot.turn(47)
        pose = robot.pose()
        assert -4 < pose.x < 37
        assert -4 < pose.y < 37
