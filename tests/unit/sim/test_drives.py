"""Robots that drive differently from Donnie: slower, as a car, or with odometry."""

from itertools import pairwise
from math import hypot, pi, sqrt

import pytest

from devices.ports.robot import Bearing, Pose, RobotProblem, StoppedBy
from sim.geometry import overlapping, placed
from sim.parts import body_of
from sim.robot import SimulatedRobot
from sim.world import World
from tests.unit.sim.floors import Diary, Unpaced, scene


def driven(settings: str, rest: str = "", seed: int = 0, name: str | None = None) -> SimulatedRobot:
    text = f"define it position ( size [ 0.2 0.1 0.1 ] {settings} )\nit( pose [ 0 0 0 90 ] )\n{rest}"
    return World(scene(text), seed=seed).robot(name, pace=Unpaced())


BOUNDS = "velocity_bounds [ {} {} 0 0 0 0 {} {} ]"


def test_a_robot_drives_no_faster_than_its_world_allows() -> None:
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


def test_a_command_that_a_robot_cannot_do_at_all_is_refused() -> None:
    stuck = driven(BOUNDS.format(0, 0.5, 0, 0))

    assert stuck.forward(2).walked == 2
    with pytest.raises(RobotProblem, match="cannot-drive"):
        stuck.backward(1)
    with pytest.raises(RobotProblem, match="cannot-turn"):
        stuck.turn(10)


LEAST_SPEED = "velocity_bounds [ -{0} {0} 0 0 0 0 -{1} {1} ]"
LEAST_GAIN = "acceleration_bounds [ -{0} {0} 0 0 0 0 -{1} {1} ]"


@pytest.mark.parametrize(
    ("limits", "metres", "degrees"), [(LEAST_SPEED, 5e-5, 0.045), (LEAST_GAIN, 5e-4, 0.45)]
)
def test_a_robot_may_be_a_thousand_times_as_slow_as_usual_and_get_faster_a_hundred_times_as_slowly(
    limits: str, metres: float, degrees: float
) -> None:
    """Usual are 0.05 m and 45 degrees a second."""
    for part, is_possible in ((1.01, True), (0.99, False)):
        robot = driven(limits.format(f"{metres * part:.9f}", f"{degrees * part:.9f}"))
        for command in (robot.forward, robot.turn):
            if is_possible:
                command(1)
            else:
                with pytest.raises(RobotProblem):
                    command(1)


# --- getting faster and slower

GAINS = "acceleration_bounds [ {} {} 0 0 0 0 {} {} ]"
"""As the wheels have it: metres and degrees a second, a second more."""


def seconds(robot: SimulatedRobot, steps: int = 0, degrees: int = 0) -> float:
    before = robot.time()
    if degrees:
        robot.turn(degrees)
    else:
        (robot.forward if steps > 0 else robot.backward)(abs(steps))
    return robot.time() - before


def test_a_long_way_is_a_trapezoid_of_speed() -> None:
    """At 0.025 m/s² it is at 0.05 m/s after 2 s and 1 step, and stops from there in the last one."""
    robot = driven(GAINS.format(-0.025, 0.025, -90, 90))

    assert seconds(robot, 10) == pytest.approx(2 + 8 + 2)
    assert seconds(robot, 3) == pytest.approx(2 + 1 + 2)
    assert seconds(robot, -10) == pytest.approx(12)


def test_a_short_way_never_reaches_the_top_speed() -> None:
    """Half of the way faster, half slower: twice the root of way by acceleration."""
    robot = driven(GAINS.format(-0.025, 0.025, -90, 90))

    assert seconds(robot, 2) == pytest.approx(4)
    assert seconds(robot, 1) == pytest.approx(2 * sqrt(0.05 / 0.025))
    assert seconds(robot, degrees=20) == pytest.approx(2 * sqrt(20 / 90))


def test_a_limit_that_accelerates_forward_brakes_backward() -> None:
    """0.1 m/s² forward, 0.0125 m/s² backward: half a second and a quarter of a step, four seconds and two."""
    robot = driven(GAINS.format(-0.0125, 0.1, -45, 45))

    assert seconds(robot, 10) == pytest.approx(0.5 + 7.75 + 4)
    assert seconds(robot, -10) == pytest.approx(4 + 7.75 + 0.5)
    assert seconds(robot, 1) == pytest.approx(sqrt(2 * 0.05 * (1 / 0.1 + 1 / 0.0125)))


def test_a_turn_has_its_own_acceleration() -> None:
    """45 degrees a second: 22.5 degrees to the top speed at 45 degrees a second, a second."""
    robot = driven(GAINS.format(-1, 1, -22.5, 45))

    assert seconds(robot, degrees=-90) == pytest.approx(1 + (90 - 22.5 - 45) / 45 + 2)
    assert seconds(robot, degrees=90) == pytest.approx(2 + (90 - 45 - 22.5) / 45 + 1)


def test_the_speed_limit_and_the_acceleration_limit_count_together() -> None:
    robot = driven(BOUNDS.format(-0.025, 0.025, -90, 90) + GAINS.format(-0.0125, 0.0125, -90, 90))

    assert seconds(robot, 10) == pytest.approx(2 + (10 - 1) / 0.5 + 2)


def test_a_car_gets_faster_on_its_circle_as_straight_on() -> None:
    robot = driven('drive "car" wheelbase 0.5 ' + GAINS.format(-0.01, 0.01, -900, 900))

    assert seconds(robot, degrees=90) == pytest.approx(0.5 * pi / 2 / 0.05 + 0.05 / 0.01, rel=1e-3)


def test_a_robot_that_cannot_get_faster_or_slower_says_that_it_cannot_drive() -> None:
    stuck = driven(GAINS.format(0, 1, -90, 0))

    with pytest.raises(RobotProblem, match="cannot-drive"):
        stuck.forward(1)
    with pytest.raises(RobotProblem, match="cannot-turn"):
        stuck.turn(10)


def test_each_step_of_a_ramp_is_reported_at_its_time() -> None:
    diary = Diary()
    text = "define it position ( size [ 0.2 0.1 0.1 ] acceleration_bounds [ -0.025 0.025 0 0 0 0 -9 9 ] )"
    robot = World(scene(f"{text}\nit( pose [ 0 0 0 90 ] )")).robot(pace=Unpaced(), watcher=diary)
    diary.robot = robot

    robot.forward(4)

    assert [at for _, _, at in diary.progress] == pytest.approx([2, 3, 4, 6])
    assert [round(pose.y, 6) for _, pose, _ in diary.progress] == [1, 2, 3, 4]


@pytest.mark.parametrize("speed", [1.0, 7.0, None])
def test_a_ramp_takes_the_same_robot_time_at_every_speed(speed: float | None) -> None:
    text = "define it position ( size [ 0.2 0.1 0.1 ] acceleration_bounds [ -0.01 0.025 0 0 0 0 -9 20 ] )"
    pace = Unpaced()
    robot = World(scene(f"{text}\nit( pose [ 0 0 0 90 ] )")).robot(pace=pace, speed=speed)

    robot.forward(7)
    robot.turn(-200)

    steps = 7 - 0.5 * (0.05 / 0.025 + 0.05 / 0.01) + 2 + 5
    degrees = 45 / 20 / 2 + 45 / 9 / 2
    assert robot.time() == pytest.approx(steps + 200 / 45 + degrees)
    assert sum(pace.slept) == pytest.approx(robot.time() / speed if speed else 0)


def test_a_robot_that_is_stopped_on_a_ramp_stands_where_it_was_then() -> None:
    text = "define it position ( size [ 0.2 0.1 0.1 ] acceleration_bounds [ -0.025 0.025 0 0 0 0 -9 9 ] )"
    pace = Unpaced(stop_after=1.0)
    robot = World(scene(f"{text}\nit( pose [ 0 0 0 90 ] )")).robot(pace=pace, speed=1.0)

    moved = robot.forward(9)

    assert (moved.walked, moved.stopped_by) == (0, StoppedBy.USER)
    assert moved.pose.y == pytest.approx(0.25)


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


def test_a_car_that_sees_an_obstacle_on_its_circle_stops_before_it() -> None:
    """0.1 m from its middle to the sensor: less than a step is left before the wall, and nothing touches."""
    sonar = "ranger( sensor( pose [ 0.1 0 0 0 ] range [ 0 3 ] fov 0 samples 1 ) )"
    car = driven(f'drive "car" wheelbase 0.5 {sonar}', "model( size [ 4 0.1 1 ] pose [ 0 0.45 0 0 ] )")

    turned = car.turn(90)

    assert turned.stopped_by is StoppedBy.OBSTACLE
    assert 0 < turned.turned < 90
    assert turned.pose.y * 0.05 < 0.4 - 0.1 - 0.05


def test_a_car_with_a_wide_circle_reports_every_ten_degrees() -> None:
    diary = Diary()
    text = 'define it position ( size [ 0.2 0.1 0.1 ] drive "car" wheelbase 8 )\nit( pose [ 0 0 0 90 ] )'
    car = World(scene(text)).robot(pace=Unpaced(), watcher=diary)

    car.turn(25)

    assert [round(pose.heading) for _, pose, _ in diary.progress] == [10, 20, 25]


# --- odometry

ODOM = 'localization "odom" odom_error [ 0.2 0.2 0.2 0.2 ]'


def test_a_robot_with_odometry_believes_to_be_elsewhere() -> None:
    world = World(scene(f"define it position ( {ODOM} ) it( pose [ 0 0 0 90 ] )"), seed=7)
    robot = world.robot(pace=Unpaced())

    believed = robot.forward(20).pose

    (truth,) = world.poses().values()
    assert (truth.x, truth.y) == pytest.approx((0, 1))
    assert believed == robot.pose()
    assert believed.y != pytest.approx(20, abs=0.01)
    assert believed.y == pytest.approx(20, abs=2)


def test_the_same_seed_gives_the_same_error_and_another_seed_another() -> None:
    def run(seed: int) -> list[Pose]:
        robot = driven(ODOM, seed=seed)
        return [robot.forward(5).pose, robot.turn(90).pose, robot.backward(9).pose]

    assert run(7) == run(7)
    assert run(7) != run(8)


def test_the_error_is_to_either_side_by_half_of_what_the_world_says() -> None:
    settings = 'localization "odom" odom_error [ 0.2 0 0 0.4 ]'

    robots = [driven(settings, seed=seed) for seed in range(1, 41)]
    along = [robot.forward(100).pose.y for robot in robots]
    turns = [robot.turn(100).pose.heading for robot in robots]

    assert 90 <= min(along) < 92 < 108 < max(along) <= 110
    assert 80 <= min(turns) < 84 < 116 < max(turns) <= 120


def test_there_is_no_error_without_a_seed() -> None:
    assert driven(ODOM).forward(20).pose == Pose(0, 20, 0)


def test_the_error_is_the_same_after_a_reset() -> None:
    robot = driven(ODOM, seed=3)
    first = robot.forward(9)
    robot.reset()

    assert robot.forward(9) == first


def test_walking_forward_and_back_returns_the_believed_place_too() -> None:
    robot = driven(ODOM, seed=7)
    robot.forward(9)

    assert robot.backward(9).pose.y == pytest.approx(0)


# --- robots of other worlds


@pytest.mark.parametrize("bearing", [Bearing.FRONT, Bearing.BACK])
def test_a_robot_without_sensors_says_so_and_can_be_driven(bearing: Bearing) -> None:
    robot = driven("")

    assert robot.forward(3).walked == 3
    with pytest.raises(RobotProblem, match="no-sensor"):
        robot.distance(bearing)
    with pytest.raises(RobotProblem, match="no-eyes"):
        robot.scan()


def test_a_car_does_not_swing_its_tail_into_anything() -> None:
    """Its front enters free floor. Only the turn moves its long tail to the post at its side."""
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
