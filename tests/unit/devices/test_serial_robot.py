"""What the commands of the real robot come to, on a simulated board in virtual time."""

from __future__ import annotations

from collections.abc import Callable
from math import degrees

import pytest

from devices.firmware_double.chassis import Chassis
from devices.firmware_double.surroundings import Place, Switch, Walls
from devices.ports.robot import STEP, Bearing, LinkNews, Met, Motion, Robot, RobotProblem, StoppedBy
from devices.serial_robot.config import RobotConfig
from devices.serial_robot.scanning import angles, sightings
from tests.unit.devices.robots import Real, Sonars, wall_ahead

NEAR = 0.1
"""Steps by which the board's true place may differ from what was asked, after a walk."""


def test_the_documented_constants_make_341_counts_a_step_and_4_a_degree() -> None:
    assert RobotConfig().counts_a_step == pytest.approx(341.04, abs=0.01)
    assert RobotConfig().counts_a_degree == pytest.approx(4.048, abs=0.001)


# --- walking and turning


@pytest.mark.parametrize("steps", [1, 2, 7])
def test_a_walk_is_counted_by_the_encoders_and_ends_where_it_should(steps: int) -> None:
    real = Real()

    moved = real.robot.forward(steps)

    assert (moved.asked, moved.walked, moved.stopped_by) == (steps, steps, None)
    assert real.board.wheels.place.y / STEP == pytest.approx(steps, abs=NEAR)
    assert moved.pose.y == pytest.approx(steps, abs=NEAR)
    assert real.stands


def test_backward_goes_the_other_way() -> None:
    real = Real()

    assert real.robot.backward(3).pose.y == pytest.approx(-3, abs=NEAR)
    assert real.board.wheels.place.y / STEP == pytest.approx(-3, abs=NEAR)


def test_a_hundred_and_fifty_steps_go_by_the_place_where_the_counters_wrap() -> None:
    real = Real()

    moved = real.robot.forward(150)

    assert (moved.walked, moved.stopped_by) == (150, None)
    assert real.board.wheels.right > 32768
    assert moved.pose.y == pytest.approx(150, abs=NEAR)


@pytest.mark.parametrize("asked", [90, -90, 10, -360, 725])
def test_a_turn_is_counted_by_the_encoders(asked: int) -> None:
    real = Real()

    turned = real.robot.turn(asked)

    assert (turned.asked, turned.turned, turned.stopped_by) == (asked, asked, None)
    assert 90 - degrees(real.board.wheels.place.yaw) == pytest.approx(asked, abs=2)
    assert (turned.pose.heading - asked + 180) % 360 - 180 == pytest.approx(0, abs=2)
    assert real.stands


def test_what_one_movement_goes_too_far_the_next_one_makes_up_for() -> None:
    real = Real()
    for _ in range(30):
        real.robot.forward(1)
        real.robot.turn(12)

    assert real.board.wheels.place.yaw == pytest.approx(Place().yaw - 2 * 3.14159, abs=0.05)
    assert (real.robot.pose().heading + 180) % 360 == pytest.approx(180, abs=3)


UNEVEN = Chassis(walking=(340.5, 326.6), turning=(170.5, 162.0))
"""As the wheels of the recorded board."""
ASTRAY = 1.25
"""Degrees that the heading may be off, behind a turn, after whatever way: five counts."""


def astray(real: Real, wanted: float) -> float:
    """Degrees by which the robot looks elsewhere."""
    return (real.robot.pose().heading - wanted + 180) % 360 - 180


@pytest.mark.parametrize("turn", [10, -10])
def test_a_turn_makes_up_for_what_the_walks_before_it_were_uneven_by(turn: int) -> None:
    """Each step of these wheels leads 1.7 degrees aside."""
    real = Real()
    real.board.wheels._chassis = UNEVEN

    for number in range(1, 37):
        real.robot.forward(1)
        real.robot.turn(turn)
        assert astray(real, number * turn) == pytest.approx(0, abs=ASTRAY)

    assert 90 - degrees(real.board.wheels.place.yaw) == pytest.approx(36 * turn, abs=ASTRAY)


def test_where_a_hand_turned_the_robot_a_turn_begins() -> None:
    real = Real()
    real.robot.forward(1)
    real.board.wheels.left += 60 * 4.048
    real.line.advance(0.2)

    turned = real.robot.turn(90)

    assert turned.turned == 90
    assert astray(real, 30 + 90) == pytest.approx(0, abs=ASTRAY)


def test_where_a_stuck_wheel_turned_the_robot_a_turn_begins() -> None:
    real = Real(at=[(2.0, lambda: setattr(real.board.wheels, "is_right_stuck", True))])
    assert real.robot.forward(9).stopped_by is StoppedBy.STALL
    real.board.wheels.is_right_stuck = False
    stood = real.robot.pose().heading
    assert 10 < stood < 45

    real.robot.turn(90)

    assert astray(real, stood + 90) == pytest.approx(0, abs=ASTRAY)


@pytest.mark.parametrize("back", [True, False])
def test_after_a_walk_that_a_lost_stop_made_too_long_the_next_one_is_whole(back: bool) -> None:
    """The way back was once waited for without end, the way on was once shorter by what was too far."""
    real = Real()
    wire = real.line.wire
    real.pace.due = [(0.9, lambda: setattr(wire, "cut", 1.0)), (1.6, lambda: setattr(wire, "cut", 0.0))]
    real.robot.forward(1)
    before = real.board.wheels.place.y / STEP
    assert before > 1.5

    moved = real.robot.backward(2) if back else real.robot.forward(2)

    assert (moved.walked, moved.stopped_by) == (2, None)
    assert abs(real.board.wheels.place.y / STEP - before) == pytest.approx(2, abs=NEAR)


def test_nothing_is_driven_for_nothing() -> None:
    real = Real()
    before = real.robot.time()

    moved, turned = real.robot.forward(0), real.robot.turn(0)

    assert (moved.walked, turned.turned, real.robot.time()) == (0, 0, before)


def test_a_negative_walk_is_the_callers_mistake() -> None:
    with pytest.raises(ValueError, match="negative"):
        Real().robot.forward(-1)


def test_each_step_is_told_once_and_each_ten_degrees_and_the_rest() -> None:
    real = Real()
    real.robot.forward(4)
    real.robot.turn(-25)

    assert real.diary.progress == [Motion.FORWARD] * 4 + [Motion.LEFT] * 3
    assert len(real.diary.passed) > 20


def test_a_walk_goes_on_between_its_steps_without_a_stop() -> None:
    """One step a second, as the original walks; stopping at each would take longer."""
    real = Real()
    real.robot.forward(10)

    assert real.robot.time() == pytest.approx(10.2, abs=0.4)


def test_another_wheel_makes_another_step() -> None:
    real = Real(config=RobotConfig(wheel_radius=0.042))
    real.robot.forward(4)

    assert real.board.wheels.place.y / STEP == pytest.approx(2, abs=NEAR)


# --- obstacles


@pytest.mark.parametrize(("away", "walked"), [(4, 3), (3, 2), (6, 5), (2, 1), (1.5, 0), (1, 0)])
def test_a_step_that_would_leave_less_than_one_free_is_not_begun(away: float, walked: int) -> None:
    real = Real(wall_ahead(away))

    moved = real.robot.forward(9)

    assert (moved.walked, moved.stopped_by) == (walked, StoppedBy.OBSTACLE)
    assert moved.met == Met("something", "", 0.0)
    assert real.board.wheels.place.y / STEP == pytest.approx(walked, abs=NEAR)
    assert real.stands


def test_the_back_sensor_stops_the_way_back() -> None:
    real = Real(wall_ahead(-4))

    assert (real.robot.backward(9).walked, real.robot.forward(1).stopped_by) == (3, None)


def test_ranges_an_echo_that_is_there_once_and_not_twice_is_no_obstacle() -> None:
    """What is 2.6 metres away looks near, once in a while."""
    sonars = Sonars(far=150.0)
    real = Real(sonars)
    glimpses = iter(range(10_000))
    sonars.far[1] = lambda place: 4.0 if next(glimpses) % 2 else 150.0

    moved = real.robot.forward(6)

    assert (moved.walked, moved.stopped_by) == (6, None)


def test_ranges_a_false_echo_before_the_first_step_is_waited_for_and_not_believed() -> None:
    sonars = Sonars(far=150.0)
    real = Real(sonars)
    real.robot.wait(1.0)
    echoes = iter([4.0])
    sonars.far[1] = lambda place: next(echoes, 150.0)
    while real.line.telemetry.ranges[-1].centimetres[1] != 4:
        real.line.advance(0.02)

    assert real.robot.forward(2).stopped_by is None


def test_ranges_what_nothing_is_known_about_is_no_obstacle() -> None:
    real = Real(Sonars(far=256.0))

    assert real.line.telemetry.ranges[-1].centimetres[1] == 0
    assert real.robot.forward(2).stopped_by is None


def test_after_an_obstacle_the_robot_turns_and_leaves() -> None:
    real = Real(wall_ahead(3))
    real.robot.forward(9)
    real.robot.turn(180)

    assert real.robot.forward(2).stopped_by is None


# --- bumpers and stalls


@pytest.mark.parametrize(("switch", "side"), [(Switch.NE, 45.0), (Switch.NW, -45.0)])
def test_a_front_bumper_ends_a_walk_forward_and_tells_its_side(switch: Switch, side: float) -> None:
    sonars = Sonars()
    real = Real(sonars, at=[(2.5, lambda: setattr(sonars, "pressed", frozenset({switch})))])

    moved = real.robot.forward(9)

    assert (moved.walked, moved.stopped_by) == (2, StoppedBy.COLLISION)
    assert moved.met == Met("something", "", side)
    assert moved.pose.y == pytest.approx(2.5, abs=0.3)
    assert real.stands


def test_a_back_bumper_ends_a_walk_back_and_hinders_none_forward() -> None:
    sonars = Sonars()
    real = Real(sonars)
    sonars.pressed = frozenset({Switch.SW})
    real.robot.wait(0.1)

    assert (real.robot.backward(1).stopped_by, real.robot.forward(1).stopped_by) == (
        StoppedBy.COLLISION,
        None,
    )


def test_a_bumper_that_is_pressed_meanwhile_ends_a_turn_and_one_that_was_before_does_not() -> None:
    sonars = Sonars()
    real = Real(sonars, at=[(1.0, lambda: setattr(sonars, "pressed", frozenset({Switch.NE})))])

    turned = real.robot.turn(90)
    assert (turned.stopped_by, turned.met) == (StoppedBy.COLLISION, Met("something", "", 45.0))
    assert real.robot.turn(-30).stopped_by is None


def test_bumpers_are_where_the_configuration_says() -> None:
    sonars = Sonars()
    real = Real(sonars, RobotConfig(front_bumpers=frozenset({3}), back_bumpers=frozenset({0})))
    sonars.pressed = frozenset({Switch.SE})
    real.robot.wait(0.1)

    assert real.robot.forward(1).stopped_by is StoppedBy.COLLISION


@pytest.mark.parametrize("is_walk", [True, False])
def test_host_watchdog_wheels_that_do_not_turn_are_a_stall(is_walk: bool) -> None:
    real = Real()
    real.board.wheels.is_stuck = True

    done = real.robot.forward(3) if is_walk else real.robot.turn(90)

    assert done.stopped_by is StoppedBy.STALL
    assert real.robot.time() == pytest.approx(0.6, abs=0.2)
    assert real.stands


def test_wheels_that_get_stuck_on_the_way_are_a_stall_and_what_was_walked_counts() -> None:
    real = Real()
    real.pace.due = [(3.5, lambda: setattr(real.board.wheels, "is_stuck", True))]

    moved = real.robot.forward(9)

    assert (moved.walked, moved.stopped_by) == (3, StoppedBy.STALL)


@pytest.mark.parametrize("wheel", ["is_left_stuck", "is_right_stuck"])
@pytest.mark.parametrize("is_walk", [True, False], ids=["walk", "turn"])
def test_one_stuck_wheel_is_a_stall_although_the_other_one_turns(wheel: str, is_walk: bool) -> None:
    real = Real()
    real.pace.due = [(1.2, lambda: setattr(real.board.wheels, wheel, True))]

    done = real.robot.forward(9) if is_walk else real.robot.turn(360)

    assert done.stopped_by is StoppedBy.STALL
    assert real.robot.time() == pytest.approx(1.8, abs=0.2)
    assert real.stands


# --- the user's stop, a pause, an exception


def test_the_users_stop_ends_a_walk_and_what_was_walked_counts() -> None:
    real = Real(stops_at=2.5)

    moved = real.robot.forward(9)

    assert (moved.walked, moved.stopped_by) == (2, StoppedBy.USER)
    assert real.stands


def test_a_halt_from_another_thread_ends_a_walk_at_once() -> None:
    real = Real()
    real.pace.due = [(1.5, real.robot.halt)]

    moved = real.robot.forward(9)

    assert (moved.walked, moved.stopped_by) == (1, StoppedBy.USER)
    assert real.robot.time() < 2.0


def test_a_halt_before_a_command_does_not_concern_it() -> None:
    real = Real()
    real.robot.halt()

    assert real.robot.forward(1).stopped_by is None


def test_a_pause_in_the_middle_of_a_walk_stops_the_wheels_and_the_walk_goes_on_after_it() -> None:
    """A pace that holds lets no drive be renewed; the line's time goes on."""
    stood: list[bool] = []
    real = Real()

    def pause() -> None:
        real.line.advance(2.0)
        stood.append(not real.board.is_driving)

    real.pace.due = [(1.5, pause)]
    moved = real.robot.forward(3)

    assert (moved.walked, moved.stopped_by, stood) == (3, None, [True])
    assert real.board.wheels.place.y / STEP == pytest.approx(3, abs=NEAR)


def test_an_exception_of_who_watches_leaves_no_motor_on() -> None:
    real = Real()

    def fail() -> None:
        raise KeyError("a listener's own mistake")

    real.pace.due = [(1.5, fail)]
    with pytest.raises(KeyError):
        real.robot.forward(9)

    assert real.stands


# --- the line


def test_an_unplugged_robot_ends_the_walk_and_the_next_command_says_so() -> None:
    real = Real()
    real.pace.due = [(1.5, lambda: setattr(real.line, "is_plugged", False))]

    moved = real.robot.forward(9)

    assert (moved.walked, moved.stopped_by) == (1, StoppedBy.LINK)
    assert real.news == [LinkNews.CONNECTED, LinkNews.LOST]
    with pytest.raises(RobotProblem) as told:
        real.robot.forward(1)
    assert told.value.code == "link-lost"


def test_silence_ends_the_walk_within_half_a_second() -> None:
    real = Real()
    real.pace.due = [(1.0, lambda: setattr(real.board, "is_mute", True))]

    assert real.robot.forward(9).stopped_by is StoppedBy.LINK
    assert real.robot.time() == pytest.approx(1.5, abs=0.1)
    assert real.stands


def test_a_board_that_restarts_ends_the_walk_and_nothing_goes_on_by_itself() -> None:
    real = Real()
    real.pace.due = [(1.5, real.board.reset)]

    assert real.robot.forward(9).stopped_by is StoppedBy.LINK
    real.line.advance(5.0)
    with pytest.raises(RobotProblem):
        real.robot.forward(1)
    assert real.stands


def test_after_the_run_has_ended_a_restored_line_is_as_good_as_ever() -> None:
    real = Real()
    real.pace.due = [(1.5, real.board.reset)]
    real.robot.forward(9)
    real.line.advance(5.0)
    before = real.robot.pose()
    real.robot.halt()

    moved = real.robot.forward(2)

    assert (moved.walked, moved.stopped_by) == (2, None)
    assert moved.pose.y - before.y == pytest.approx(2, abs=0.2)


def unplug(real: Real) -> None:
    real.line.is_plugged = False


def restart(real: Real) -> None:
    real.board.reset()


def unplug_and_plug_in(real: Real) -> None:
    unplug(real)
    real.line.advance(1.0)
    real.line.is_plugged = True
    real.line.advance(5.0)


@pytest.mark.parametrize(
    "fault", [unplug, unplug_and_plug_in, restart], ids=["unplugged", "back", "restarted"]
)
@pytest.mark.parametrize("waits", [lambda it: it.wait(30), lambda it: it.scan()], ids=["wait", "scan"])
def test_a_line_lost_in_a_wait_or_a_scan_ends_the_program(
    fault: Callable[[Real], None], waits: Callable[[Robot], object]
) -> None:
    """It raises at once, and so does the next command: a program that went on would drive."""
    real = Real()
    real.pace.due = [(1.5, lambda: fault(real))]

    with pytest.raises(RobotProblem) as told:
        waits(real.robot)
    assert told.value.code == "link-lost"
    real.line.is_plugged = True
    real.line.advance(6.0)
    with pytest.raises(RobotProblem):
        real.robot.forward(1)
    assert real.stands
    real.robot.halt()
    assert real.robot.wait(1) is True


COMMANDS: dict[str, Callable[[Robot], object]] = {
    "forward": lambda it: it.forward(1),
    "turn": lambda it: it.turn(90),
    "scan": lambda it: it.scan(),
    "wait": lambda it: it.wait(1),
    "distance": lambda it: it.distance(Bearing.FRONT),
}


@pytest.mark.parametrize("command", COMMANDS)
def test_after_a_movement_that_lost_the_line_the_next_command_says_so_although_it_is_back(
    command: str,
) -> None:
    real = Real()
    real.pace.due = [(0.5, lambda: unplug(real))]
    assert real.robot.forward(9).stopped_by is StoppedBy.LINK
    real.line.is_plugged = True
    real.line.advance(5.0)
    assert real.news[-1] is LinkNews.RESTORED

    with pytest.raises(RobotProblem) as told:
        COMMANDS[command](real.robot)
    assert told.value.code == "link-lost"


def test_a_line_that_is_lost_and_back_while_a_walk_is_held_ends_the_walk() -> None:
    """All of it between two looks of the movement: by the state alone nothing has happened."""
    real = Real()
    real.pace.due = [(1.5, lambda: unplug_and_plug_in(real))]

    moved = real.robot.forward(9)
    assert (moved.walked, moved.stopped_by) == (1, StoppedBy.LINK)
    assert real.stands


def test_a_line_that_is_lost_while_a_sonar_is_waited_for_ends_the_program() -> None:
    """Right after its start not all of them have told something."""
    real = Real()
    assert real.robot.telemetry.ranges[-1].centimetres[0] == 0
    real.pace.due = [(0.0, lambda: unplug(real))]

    with pytest.raises(RobotProblem) as told:
        real.robot.distance(Bearing.FRONT_RIGHT)
    assert told.value.code == "link-lost"


def test_a_wait_after_a_long_loss_is_as_long_as_it_says() -> None:
    """However often the port was tried in vain meanwhile."""
    real = Real()
    real.pace.due = [(0.5, lambda: unplug(real))]
    real.robot.forward(9)
    real.line.advance(20.0)
    real.line.is_plugged = True
    real.line.advance(5.0)
    real.robot.halt()
    before = real.robot.time()

    assert real.robot.wait(7) is True
    assert real.robot.time() - before == pytest.approx(7, abs=0.1)


@pytest.mark.parametrize("command", ["turn", "scan", "distance", "wait"])
def test_without_a_line_no_command_is_begun(command: str) -> None:
    real = Real()
    real.line.is_plugged = False
    real.line.advance(0.1)
    commands: dict[str, Callable[[], object]] = {
        "turn": lambda: real.robot.turn(90),
        "scan": real.robot.scan,
        "wait": lambda: real.robot.wait(1),
        "distance": lambda: real.robot.distance(Bearing.FRONT),
    }

    with pytest.raises(RobotProblem) as told:
        commands[command]()
    assert told.value.code == "link-lost"


def test_a_mute_board_cannot_be_connected_to() -> None:
    real = Real()
    real.robot.close()
    real.board.is_mute = True

    with pytest.raises(RobotProblem) as told:
        real.robot.connect()
    assert told.value.code == "no-answer"


# --- waiting and sensing


def test_waiting_takes_the_robots_time_and_can_be_cut_short() -> None:
    real = Real()

    assert real.robot.wait(2.5) is True
    assert real.robot.time() == pytest.approx(2.5)
    real.pace.stops_at = 3.0
    assert real.robot.wait(10) is False


@pytest.mark.parametrize(
    ("bearing", "sonar"),
    [
        (Bearing.FRONT_RIGHT, 0),
        (Bearing.FRONT, 1),
        (Bearing.FRONT_LEFT, 2),
        (Bearing.BACK_LEFT, 3),
        (Bearing.BACK, 4),
        (Bearing.BACK_RIGHT, 5),
    ],
)
def test_each_sensor_is_the_boards_sonar_of_the_documented_order(bearing: Bearing, sonar: int) -> None:
    sonars = Sonars(far=100.0)
    sonars.far[sonar] = lambda place: 32.0
    real = Real(sonars)
    real.robot.wait(0.5)

    assert real.robot.distance(bearing) == 6


def test_the_order_of_the_sonars_is_configuration() -> None:
    sonars = Sonars(far=100.0)
    sonars.far[3] = lambda place: 32.0
    order = list(RobotConfig().sonars)
    order[3], order[5] = order[5], order[3]
    real = Real(sonars, RobotConfig(sonars=tuple(order)))
    real.robot.wait(0.5)

    assert real.robot.distance(Bearing.BACK_RIGHT) == 6


@pytest.mark.parametrize("far", [None, 201.0, 255.0, 256.0])
def test_ranges_what_is_far_or_gives_no_echo_or_is_unknown_is_as_far_as_sensors_tell(
    far: float | None,
) -> None:
    real = Real(Sonars(far))

    assert real.robot.distance(Bearing.FRONT) == 60


def test_right_after_the_start_a_distance_waits_for_the_first_measurement() -> None:
    assert Real(wall_ahead(7)).robot.distance(Bearing.FRONT) == 7


def test_a_sensor_that_is_not_fitted_is_told_to_be_missing() -> None:
    real = Real(config=RobotConfig(sonars=(None, Bearing.FRONT, None, None, None, None)))

    with pytest.raises(RobotProblem) as told:
        real.robot.distance(Bearing.BACK)
    assert (told.value.code, told.value.values) == ("no-sensor", {"bearing": "back"})


def test_what_is_known_of_the_distances_costs_no_time_and_sends_nothing() -> None:
    """A sonar that has told nothing yet, or isn't fitted, is missing."""
    sonars = Sonars(far=32.0)
    sonars.far[4] = lambda place: 0.0
    real = Real(sonars, RobotConfig(sonars=(None, Bearing.FRONT, None, None, Bearing.BACK, None)))
    real.robot.wait(0.5)
    before, real.line.written = real.robot.time(), []

    assert real.robot.known_distances() == {Bearing.FRONT: 6}
    assert (real.robot.time(), real.line.written) == (before, [])


def test_of_a_line_that_is_lost_no_distance_is_known() -> None:
    real = Real(wall_ahead(7))
    real.robot.wait(0.5)
    assert real.robot.known_distances()[Bearing.FRONT] == 7

    real.line.is_plugged = False
    real.line.advance(0.1)

    assert real.robot.known_distances() == {}


def test_a_scan_tells_what_the_sonar_on_the_head_meets_and_no_colour() -> None:
    sonars = Sonars()
    real = Real(sonars)
    sonars.far[6] = lambda place: {60: 50.0, 75: 52.0, 150: 30.0}.get(real.board.head)

    seen = real.robot.scan()

    assert [(each.degrees, each.steps, each.colour, each.name) for each in seen] == [
        (-22.5, 10.0, "", ""),
        (60.0, 6.0, "", ""),
    ]
    real.line.advance(0.5)
    assert real.board.head == 90


def test_a_robot_without_a_camera_tells_no_colours() -> None:
    assert Real().robot.colours == frozenset()


def test_a_scan_without_a_head_says_what_is_missing() -> None:
    with pytest.raises(RobotProblem) as told:
        Real(config=RobotConfig(head_sonar=None)).robot.scan()
    assert told.value.code == "no-camera"


def test_a_stop_ends_a_scan() -> None:
    real = Real(stops_at=1.0)
    real.robot.scan()

    assert real.robot.time() < 1.5


def test_neighbours_equally_far_are_one_thing() -> None:
    met = [(-15, None), (0, 40.0), (15, 44.0), (30, 60.0), (45, float("inf")), (60, 61.0)]

    assert [(each.degrees, each.steps) for each in sightings(met)] == [(7.5, 8.0), (30, 12.0), (60, 12.2)]
    assert list(angles(45)) == [-90, -45, 0, 45, 90]


# --- place and time


def test_a_reset_makes_here_the_start() -> None:
    real = Real(Walls([]))
    real.robot.forward(2)
    real.robot.turn(90)

    real.robot.reset()

    pose = real.robot.pose()
    assert (pose.x, pose.y, pose.heading, real.robot.time()) == (0.0, 0.0, 0.0, 0.0)
