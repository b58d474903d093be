"""Robots that drive otherwise than Donnie: slower, as a car, counting their wheels' turns."""

from itertools import pairwise
from math import hypot, pi

import pytest

from devices.ports.robot import Bearing, Pose, RobotProblem, StoppedBy
from sim.body import body_of
from sim.geometry import overlapping, placed
from sim.robot import SimulatedRobot
from sim.world import World
from tests.unit.sim.floors import Diary, Unpaced, scene


def driven(settings: str, rest: str = "", seed: int = 0, name: str | None = None) -> SimulatedRobot:
    text = f"define it position ( size [ 0.2 0.1 0.1 ] {settings} )\nit( pose [ 0 0 0 90 ] )\n{rest}"
    return World(scene(text), seed=seed).robot(name, pace=Unpaced())


BOUNDS = "velocity_bounds [ {} {} 0 0 0 0 {} {} ]"


def test_a_robot_goes_no_faster_than_its_world_lets_it() -> None:
    slow = driven(BOUNDS.format(-0.01, 0.025, -15, 30))

    times = [slow.time()]
    for command in (
        lambda: slow.forward(4),
        lambda: slow.backward(4),
        lambda: slow.turn(90),
        lambda: slow.turn(-90),
    ):
        command()
        times.append(slow.time())

    assert [after - before for before, after in pairwise(times)] == pytest.approx([8, 20, 6, 3])


def test_a_bound_above_the_usual_pace_changes_nothing() -> None:
    fast = driven(BOUNDS.format(-2, 2, -180, 180))

    fast.forward(5)
    fast.turn(90)

    assert fast.time() == pytest.approx(7)


def test_what_a_robot_cannot_do_at_all_is_said() -> None:
    stuck = driven(BOUNDS.format(0, 0.5, 0, 0))

    assert stuck.forward(2).walked == 2
    with pytest.raises(RobotProblem, match="cannot-drive"):
        stuck.backward(1)
    with pytest.raises(RobotProblem, match="cannot-turn"):
        stuck.turn(10)


def test_an_omni_drive_turns_on_the_spot_as_donnie_does() -> None:
    turned = driven('drive "omni"').turn(-450)

    assert (turned.turned, turned.pose) == (-450, Pose(0, 0, 270))


# --- cars


def test_a_car_turns_on_a_circle_of_its_wheelbase() -> None:
    car = driven('drive "car" wheelbase 0.5')

    turned = car.turn(90)

    assert (turned.turned, turned.stopped_by, turned.pose.heading) == (90, None, 90)
    assert (turned.pose.x, turned.pose.y) == pytest.approx((10, 10), abs=0.01)
    assert car.time() == pytest.approx(0.5 * pi / 2 / 0.05, rel=1e-3)


def test_a_car_that_turns_all_the_way_round_is_back() -> None:
    pose = driven('drive "car" wheelbase 0.5').turn(-360).pose

    assert (pose.heading, hypot(pose.x, pose.y)) == (0, pytest.approx(0, abs=1e-6))


def test_a_car_bumps_on_its_circle() -> None:
    car = driven('drive "car" wheelbase 0.5', "model( size [ 0.1 3 1 ] pose [ 0.4 0 0 0 ] )")

    turned = car.turn(90)

    assert turned.stopped_by is StoppedBy.COLLISION
    assert 0 < turned.turned < 90
    assert turned.pose.x * 0.05 < 0.35


def test_a_car_with_a_wide_circle_tells_every_ten_degrees() -> None:
    diary = Diary()
    text = 'define it position ( size [ 0.2 0.1 0.1 ] drive "car" wheelbase 8 )\nit( pose [ 0 0 0 90 ] )'
    car = World(scene(text)).robot(pace=Unpaced(), watcher=diary)

    car.turn(25)

    assert [round(pose.heading) for _, pose, _ in diary.progress] == [10, 20, 25]


# --- odometry

ODOM = 'localization "odom" odom_error [ 0.2 0.2 0.2 0.2 ]'


def test_a_robot_that_counts_its_wheels_believes_to_be_elsewhere() -> None:
    world = World(scene(f"define it position ( {ODOM} ) it( pose [ 0 0 0 90 ] )"), seed=7)
    robot = world.robot(pace=Unpaced())

    believed = robot.forward(20).pose

    (truth,) = world.poses().values()
    assert (truth.x, truth.y) == pytest.approx((0, 1))
    assert believed == robot.pose()
    assert believed.y != pytest.approx(20, abs=0.01)
    assert believed.y == pytest.approx(20, abs=2)


def test_the_same_seed_errs_the_same_and_another_otherwise() -> None:
    def run(seed: int) -> list[Pose]:
        robot = driven(ODOM, seed=seed)
        return [robot.forward(5).pose, robot.turn(90).pose, robot.backward(9).pose]

    assert run(7) == run(7)
    assert run(7) != run(8)


def test_without_a_seed_nothing_errs() -> None:
    assert driven(ODOM).forward(20).pose == Pose(0, 20, 0)


def test_a_reset_errs_the_same_again() -> None:
    robot = driven(ODOM, seed=3)
    first = robot.forward(9)
    robot.reset()

    assert robot.forward(9) == first


def test_walking_to_and_fro_leads_the_belief_back_too() -> None:
    robot = driven(ODOM, seed=7)
    robot.forward(9)

    assert robot.backward(9).pose.y == pytest.approx(0)


# --- robots of others


@pytest.mark.parametrize("bearing", [Bearing.FRONT, Bearing.BACK])
def test_a_robot_without_sensors_says_so_and_can_be_driven(bearing: Bearing) -> None:
    robot = driven("")

    assert robot.forward(3).walked == 3
    with pytest.raises(RobotProblem, match="no-sensor"):
        robot.distance(bearing)
    with pytest.raises(RobotProblem, match="no-eyes"):
        robot.scan()


def test_a_car_does_not_swing_its_tail_into_anything() -> None:
    """Its front goes into free floor; only the turn brings its long tail to the post beside it."""
    text = (
        'define it position ( size [ 1 0.1 0.1 ] origin [ -0.4 0 0 0 ] drive "car" wheelbase 0.3 )\n'
        "it( pose [ 0 0 0 0 ] )\nmodel( size [ 0.05 0.05 1 ] pose [ -0.8 -0.1 0 0 ] )"
    )
    it = scene(text)
    world = World(it)
    car = world.robot(pace=Unpaced())

    turned = car.turn(-45)

    assert turned.stopped_by is StoppedBy.COLLISION
    spot = world.poses()[car.name]
    bodies = [placed(points, spot.x, spot.y, spot.yaw) for points in body_of(it, 0).polygons]
    (post,) = it.models[1].outlines()
    assert not any(overlapping(body, post) for body in bodies)
