"""The results of a simulated robot's commands, in steps and compass degrees."""

import threading

import pytest

from devices.ports.robot import Bearing, Motion, Pose, Robot, StoppedBy
from sim.robot import SimulatedRobot
from sim.world import World
from tests.unit.sim.floors import BOX_ROBOT, IDEAL, Diary, Unpaced, ideal, robot, scene


def test_the_simulated_robot_fulfils_the_port() -> None:
    it: Robot = ideal()

    assert it.name == "donnie"
    assert it.colours == {"red", "green", "blue"}


def test_a_pose_in_metres_is_reported_in_steps_and_compass_degrees() -> None:
    assert ideal(start=(2, 3, 0)).pose() == Pose(2.0, 3.0, 0.0)


@pytest.mark.parametrize(
    ("heading", "x", "y"), [(0, 0, 7), (90, 7, 0), (180, 0, -7), (270, -7, 0), (360, 0, 7)]
)
def test_forward_moves_in_the_direction_of_the_heading(heading: int, x: int, y: int) -> None:
    it = ideal(start=(0, 0, heading))

    moved = it.forward(7)

    assert (moved.walked, moved.stopped_by) == (7, None)
    assert moved.pose == Pose(x, y, heading % 360)


def test_backward_moves_the_other_way_and_keeps_the_heading() -> None:
    assert ideal().backward(5).pose == Pose(0, -5, 0)


def test_fifty_steps_one_by_one_are_fifty_steps() -> None:
    it = ideal()
    for _ in range(50):
        it.forward(1)

    assert it.pose().y == pytest.approx(50, abs=1e-9)


def test_thirty_six_tens_are_a_full_turn() -> None:
    it = ideal()
    for _ in range(36):
        it.turn(10)

    assert it.pose().heading == 0.0


@pytest.mark.parametrize(
    ("degrees", "heading"), [(90, 90), (-90, 270), (720, 0), (-725, 355), (1, 1), (0, 0)]
)
def test_a_turn_of_any_size_ends_at_the_exact_heading(degrees: int, heading: int) -> None:
    turned = ideal().turn(degrees)

    assert (turned.turned, turned.stopped_by, turned.pose.heading) == (degrees, None, heading)


def test_a_negative_walk_is_the_callers_mistake() -> None:
    with pytest.raises(ValueError, match="negative"):
        ideal().forward(-1)


def test_a_thousand_million_steps_on_an_endless_floor_take_no_time() -> None:
    assert ideal().forward(1_000_000_000).walked == 1_000_000_000


@pytest.mark.parametrize(("away", "walked"), [(4, 3), (3, 2), (5, 4), (2, 1), (1, 0)])
def test_the_robot_stops_a_step_before_a_thing_ahead(away: int, walked: int) -> None:
    moved = ideal([("red", 0, away)]).forward(9)

    assert (moved.walked, moved.stopped_by, moved.pose.y) == (walked, StoppedBy.OBSTACLE, walked)


def test_a_wait_shorter_than_a_second_takes_its_time() -> None:
    it = ideal()
    it.wait(0.25)

    assert it.time() == 0.25


def test_a_walk_that_ended_at_an_obstacle_is_walked_again_from_the_same_place() -> None:
    it = ideal([("red", 0, 5)])
    first = it.forward(9)
    it.backward(first.walked)

    again = it.forward(9)

    assert (first.walked, again) == (4, first)
    assert it.pose() == first.pose


def test_the_back_sensor_stops_a_backward_walk() -> None:
    moved = ideal([("red", 0, -4)]).backward(5)

    assert (moved.walked, moved.stopped_by, moved.pose.y) == (3, StoppedBy.OBSTACLE, -3)


def test_after_an_obstacle_the_robot_can_turn_and_leave() -> None:
    it = ideal([("red", 0, 4)])
    it.forward(9)

    assert it.forward(1).walked == 0
    it.turn(180)
    assert it.forward(9).walked == 9


def test_a_robot_with_only_side_sensors_bumps_into_a_thing_ahead_and_can_leave() -> None:
    it = robot(BOX_ROBOT + "blind( pose [ 0 0 0 0 ] ) model( size [ 0.1 0.1 1 ] pose [ 0.52 0 0 0 ] )")

    bumped = it.forward(20)
    again = it.forward(1)
    away = it.backward(3)

    assert (bumped.walked, bumped.stopped_by) == (7, StoppedBy.COLLISION)
    assert bumped.pose.x == pytest.approx((0.52 - 0.05 - 0.1) / 0.05, abs=0.01)
    assert (again.walked, again.stopped_by) == (0, StoppedBy.COLLISION)
    assert (away.walked, away.stopped_by) == (3, None)


def test_a_long_robot_next_to_a_wall_turns_until_it_touches() -> None:
    it = robot(BOX_ROBOT + "blind( pose [ 0 0 0 0 ] ) model( size [ 1 0.1 1 ] pose [ 0 0.14 0 0 ] )")

    turned = it.turn(-90)

    assert turned.stopped_by is StoppedBy.COLLISION
    assert -90 < turned.turned < 0
    assert turned.pose.heading == (90 + turned.turned) % 360
    assert it.turn(-turned.turned).stopped_by is None


def test_other_robots_are_in_the_way() -> None:
    it = robot(BOX_ROBOT + "blind( pose [ 0 0 0 0 ] ) blind( pose [ 1 0 0 0 ] obstacle_return 0 )")

    moved = it.forward(30)

    assert moved.stopped_by is StoppedBy.COLLISION
    assert moved.pose.x == pytest.approx((1 - 0.2) / 0.05, abs=0.01)


def test_a_thing_around_the_start_of_a_robot_is_no_obstacle_for_it() -> None:
    it = robot(IDEAL + 'model( name "floor" size [ 2 2 1 ] ) ideal( pose [ 0 0 0 90 ] )')

    assert it.stands_in == ("floor",)
    assert it.forward(40).walked == 40
    assert it.distance(Bearing.FRONT) == 60


def test_a_robot_put_halfway_into_a_box_can_leave_it_but_not_go_deeper() -> None:
    it = robot(BOX_ROBOT + "blind( pose [ 0 0 0 0 ] ) model( size [ 0.2 0.2 1 ] pose [ 0.15 0 0 0 ] )")

    assert it.forward(1).stopped_by is StoppedBy.COLLISION
    assert it.backward(5).walked == 5


def test_reset_puts_everything_back() -> None:
    it = ideal(start=(1, 2, 90))
    it.forward(3)
    it.turn(45)

    it.reset()

    assert it.pose() == Pose(1, 2, 90)
    assert it.time() == 0.0


def test_a_world_without_that_robot_is_refused() -> None:
    with pytest.raises(KeyError):
        World(scene(IDEAL + 'ideal( name "donnie" )')).robot("marvin", pace=Unpaced())
    with pytest.raises(KeyError):
        World(scene("model()")).robot(pace=Unpaced())


# --- time ----------------------------------------------------------------------------------------


def test_a_step_takes_a_second_and_a_right_angle_two() -> None:
    it = ideal()
    it.forward(5)
    after_walk = it.time()
    it.turn(-90)
    after_turn = it.time()
    it.wait(1.5)

    assert (after_walk, after_turn, it.time()) == (5.0, 7.0, 8.5)


def test_sensors_take_no_time() -> None:
    it = ideal([("red", 0, 9)])
    it.scan()
    it.distance(Bearing.FRONT)

    assert it.time() == 0.0


def test_a_negative_wait_takes_no_time() -> None:
    it = ideal()

    assert it.wait(-3) is True
    assert it.time() == 0.0


@pytest.mark.parametrize("speed", [0.25, 1.0, 5.0, 100.0])
def test_real_time_is_the_same_run_with_sleeps_between(speed: float) -> None:
    pace, diary = Unpaced(), Diary()
    it = robot(IDEAL + "ideal( pose [ 0 0 0 90 ] )", pace, diary, speed)

    it.forward(3)
    it.wait(2)

    assert it.time() == pytest.approx(5)
    assert sum(pace.slept) == pytest.approx(5 / speed)
    assert max(pace.slept) <= 1 / 20 + 1e-9
    assert [pose.y for pose in diary.passed] == sorted(pose.y for pose in diary.passed)
    assert len(diary.progress) == 3


def test_unlimited_speed_never_sleeps_and_reports_no_poses_on_the_way() -> None:
    pace, diary = Unpaced(), Diary()
    it = robot(IDEAL + "ideal()", pace, diary)

    it.forward(3)

    assert pace.slept == []
    assert diary.passed == []


@pytest.mark.parametrize("speed", [None, 2.0])
def test_every_step_is_reported_at_its_time(speed: float | None) -> None:
    diary = Diary()
    it = robot(IDEAL + "ideal( pose [ 0 0 0 90 ] )", None, diary, speed)
    diary.robot = it

    it.forward(10)

    assert [(motion, pose.y) for motion, pose, _ in diary.progress] == [
        (Motion.FORWARD, step) for step in range(1, 11)
    ]
    assert [seconds for _, _, seconds in diary.progress] == pytest.approx(list(range(1, 11)))


@pytest.mark.parametrize(
    ("degrees", "headings"),
    [(90, [10, 20, 30, 40, 50, 60, 70, 80, 90]), (25, [10, 20, 25]), (-20, [350, 340]), (7, [7])],
)
def test_every_tenth_degree_of_a_turn_and_its_rest_are_reported(degrees: int, headings: list[int]) -> None:
    diary = Diary()
    it = robot(IDEAL + "ideal( pose [ 0 0 0 90 ] )", None, diary)

    it.turn(degrees)

    assert [pose.heading for _, pose, _ in diary.progress] == headings
    assert {motion for motion, _, _ in diary.progress} == {Motion.RIGHT if degrees > 0 else Motion.LEFT}


def test_a_huge_walk_is_reported_at_most_a_thousand_times() -> None:
    diary = Diary()

    robot(IDEAL + "ideal( pose [ 0 0 0 90 ] )", None, diary).forward(1_000_000_007)

    assert 500 <= len(diary.progress) <= 1000
    assert diary.progress[-1][1].y == 1_000_000_007


def test_a_stop_in_the_middle_of_a_walk_ends_it_there() -> None:
    it = robot(IDEAL + "ideal( pose [ 0 0 0 90 ] )", Unpaced(stop_after=2.5), None, 1.0)

    moved = it.forward(10)

    assert (moved.asked, moved.walked, moved.stopped_by) == (10, 2, StoppedBy.USER)
    assert moved.pose.y == pytest.approx(2.5)
    assert it.time() == pytest.approx(2.5)


def test_a_stop_in_the_middle_of_a_turn_ends_it_at_a_whole_degree() -> None:
    it = robot(IDEAL + "ideal( pose [ 0 0 0 90 ] )", Unpaced(stop_after=1.0), None, 1.0)

    turned = it.turn(-180)

    assert (turned.turned, turned.stopped_by, turned.pose.heading) == (-45, StoppedBy.USER, 315)


def test_a_stop_in_the_middle_of_a_wait_says_so() -> None:
    it = robot(IDEAL + "ideal()", Unpaced(stop_after=1.0), None, 1.0)

    assert it.wait(60) is False
    assert it.time() == pytest.approx(1.0)


class _Halting(Unpaced):
    """Calls halt from another thread while the robot walks."""

    it: SimulatedRobot

    def sleep(self, seconds: float) -> bool:
        if len(self.slept) == 30:
            other = threading.Thread(target=self.it.halt)
            other.start()
            other.join()
        return super().sleep(seconds)


def test_halt_from_another_thread_ends_the_movement_and_nothing_after_it() -> None:
    pace = _Halting()
    it = robot(IDEAL + "ideal( pose [ 0 0 0 90 ] )", pace, None, 1.0)
    pace.it = it

    moved = it.forward(10)
    after = it.forward(2)

    assert (moved.walked, moved.stopped_by) == (1, StoppedBy.USER)
    assert (after.walked, after.stopped_by) == (2, None)


class _Hurrying(Unpaced):
    it: SimulatedRobot

    def sleep(self, seconds: float) -> bool:
        self.it.speed = None
        return super().sleep(seconds)


def test_the_speed_changes_while_the_robot_walks() -> None:
    pace = _Hurrying()
    it = robot(IDEAL + "ideal( pose [ 0 0 0 90 ] )", pace, None, 1.0)
    pace.it = it

    assert it.forward(10).walked == 10
    assert len(pace.slept) == 1


def test_a_speed_is_above_zero() -> None:
    with pytest.raises(ValueError, match="above 0"):
        ideal().speed = 0.0


def test_the_same_program_gives_the_same_run() -> None:
    def run() -> list[object]:
        it = ideal([("red", 0, 9), ("green", 4, 4), ("blue", -5, 2)], (1, 1, 17))
        return [f(n) for n in range(1, 40) for f in (it.forward, it.turn, lambda _: it.scan(), it.backward)]

    assert run() == run()


LONG_WALL = "model( size [ 90000 0.1 1 ] pose [ 0 0.14 0 0 ] )"


def test_a_walk_along_an_endless_wall_can_be_stopped_while_it_is_computed() -> None:
    class Refusing(Unpaced):
        asked = 0

        def sleep(self, seconds: float) -> bool:
            self.asked += 1
            return self.asked < 3

    pace = Refusing()
    it = robot(BOX_ROBOT + "blind( pose [ 0 0 0 0 ] )" + LONG_WALL, pace)

    moved = it.forward(1_000_000_000)

    assert (moved.walked, moved.stopped_by, pace.asked) == (0, StoppedBy.USER, 3)


def test_halt_stops_a_walk_that_is_being_computed_too() -> None:
    pace = _Halting()
    pace.slept = [0.0] * 30
    pace.it = it = robot(BOX_ROBOT + "blind( pose [ 0 0 0 0 ] )" + LONG_WALL, pace)

    assert it.forward(1_000_000_000).stopped_by is StoppedBy.USER
