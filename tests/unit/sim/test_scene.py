"""What a model of a scene is: where its outlines lie, how high, and whether it is solid or seen."""

from math import degrees

import pytest

from sim.geometry import Placement
from sim.scene import Limits, Model, moved
from tests.unit.sim.floors import BOX_ROBOT, scene


def model(more: str) -> Model:
    return scene(f"model( {more} )").models[0]


@pytest.mark.parametrize(
    ("more", "solid", "seen"),
    [
        ("", True, True),
        ("obstacle_return 0", False, True),
        ("obstacle_return 0 size [ 1 1 0.021 ]", False, True),
        ("obstacle_return 0 size [ 1 1 0.02 ]", False, False),  # a mark on the floor
        ("size [ 1 1 0.02 ]", True, True),
        ("obstacle_return 0 boundary 1 size [ 1 1 0.02 ]", True, True),
        ("obstacle_return -1 size [ 1 1 0.02 ]", True, True),
        ("ranger_return 0", True, True),
        ("ranger_return 0.5", True, True),
        ("ranger_return -0.5", True, False),
        ("obstacle_return 0 ranger_return -1", False, False),
    ],
)
def test_what_is_solid_and_what_rangers_see(more: str, solid: bool, seen: bool) -> None:
    it = model(more)

    assert (it.solid, it.seen) == (solid, seen)


@pytest.mark.parametrize(("value", "grippable"), [(0, False), (1, True), (0.5, True)])
def test_a_gripper_takes_what_its_world_says(value: float, grippable: bool) -> None:
    assert model(f"gripper_return {value}").grippable is grippable


def test_outlines_lie_in_the_world_with_their_heights() -> None:
    """2 m to the east and 1 m to the north, turned to the north; walls are in the same order."""
    it = model("size [ 0.4 0.2 0.3 ] pose [ 2 1 0.5 90 ]")

    ((*points,),) = it.outlines()
    xs, ys = zip(*points, strict=True)
    assert (min(xs), max(xs), min(ys), max(ys)) == pytest.approx((1.9, 2.1, 0.8, 1.2))
    assert [*it.heights()] == [pytest.approx((0.5, 0.8))]
    walled = model("size [ 0.4 0.2 0.3 ] boundary 1 pose [ 0 0 0.25 0 ]")
    assert len([*walled.outlines()]) == len([*walled.heights()]) == len(walled.polygons) + len(walled.walls)
    assert len(walled.walls) == 4
    assert [*walled.heights()] == [pytest.approx((0.25, 0.55))] * len([*walled.outlines()])


BLOCK = "block( points 4 point[0] [ 0 0 ] point[1] [ {0} 0 ] point[2] [ {0} {1} ] point[3] [ 0 {1} ] )"


@pytest.mark.parametrize(
    ("more", "area"),
    [
        ("size [ 2 3 1 ]", 6.0),
        ("size [ 2 3 1 ] boundary 1", 0.1),  # walls of a centimetre, 10 m of them
        (f"size [ 2 3 1 ] boundary 1 {BLOCK.format(1, 1)}", 6.0),
        (f"size [ 2 3 1 ] {BLOCK.format(1, 1)}", 6.0),
        (f"size [ 2 3 1 ] {BLOCK.format(1, 1)} {BLOCK.format(1, 1)}", 12.0),
        (f"size [ 2 3 1 ] {BLOCK.format(2, 1)} {BLOCK.format(1, 1)}", 9.0),
    ],
)
def test_the_area_of_stage_adds_up_all_blocks(more: str, area: float) -> None:
    assert model(more).stage_area == pytest.approx(area)


def test_a_robot_is_found_by_the_name_that_it_has_in_programs() -> None:
    it = scene(
        BOX_ROBOT
        + 'blind( name "a" ) blind( name "b" ) model( name "c" model( name "d" model( name "e" ) ) )'
    )

    assert it.robot_names == ("a", "b")
    assert (it.robot("a").index, it.robot("b").index) == it.robots
    for name in ("c", "e", ""):
        with pytest.raises(KeyError):
            it.robot(name)
    (root,) = [each for each in it.models if each.name == "c"]
    assert [each.name for each in it.tree(root.index)] == ["c", "d", "e"]
    assert [each.root for each in it.tree(root.index)] == [root.index] * 3


@pytest.mark.parametrize(
    ("now", "lid"),
    [
        (Placement(1, 2, 0.25, 30), (1.5, 2.0)),
        (Placement(5, 7, 0.25, 30), (5.5, 7.0)),
        (Placement(5, 7, 0.25, 120), (5.0, 7.5)),
        (Placement(5, 7, 0.25, 210), (4.5, 7.0)),
        (Placement(5, 7, 0.25, -60), (5.0, 6.5)),
    ],
)
def test_what_is_attached_keeps_its_place_on_what_is_moved(now: Placement, lid: tuple[float, float]) -> None:
    """The lid lies 0.5 m to the east, on a box that looks to 30 degrees."""
    aslant = "pose [ 0.433012702 -0.25 0 15 ]"
    it = scene(
        f"model( name 'box' pose [ 1 2 0.25 30 ] model( {aslant} ) ) model( pose [ 9 9 0 0 ] )".replace(
            "'", '"'
        )
    )

    after = moved(it, {0: now})

    assert after.models[0].pose == now
    pose = after.models[1].pose
    assert (pose.x, pose.y) == pytest.approx(lid)
    assert (pose.z, pose.yaw) == pytest.approx((it.models[1].pose.z, now.yaw + 15))
    assert after.models[2] is it.models[2]
    assert (after.robots, after.name) == (it.robots, it.name)


def test_a_sensor_has_what_stage_gives_it() -> None:
    """A cone of a tenth of a radian up to 5 m, with one sample."""
    (sensor,) = [each for one in scene("position( ranger( sensor( ) ) )").models for each in one.sensors]

    assert (sensor.minimum, sensor.maximum, sensor.samples) == (0, 5, 1)
    assert sensor.fov == pytest.approx(degrees(0.1))
    assert (sensor.pose, sensor.size) == (Placement(0, 0, 0, 0), (0.02, 0.02, 0.02))
    assert Limits() == Limits((-1, 1), (-1, 1), (-90, 90))
    noise = sensor.noise
    assert (noise.constant, noise.proportional, noise.angle) == (0, 0, 0)
