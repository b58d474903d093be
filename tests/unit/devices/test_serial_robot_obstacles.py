"""The real robot stops at obstacles, at collisions, and where its wheels don't turn."""

from __future__ import annotations

import pytest

from devices.board_simulator.floor import BumperSwitch
from devices.ports.robot import STEP, Met, StoppedBy
from devices.serial_robot.config import RobotConfig
from tests.unit.devices.robots import NEAR, Real, Sonars, wall_ahead

# --- obstacles


@pytest.mark.parametrize(("away", "walked"), [(4, 3), (3, 2), (6, 5), (2, 1), (1.5, 0), (1, 0)])
def test_a_step_that_would_leave_less_than_one_free_is_not_begun(away: float, walked: int) -> None:
    real = Real(wall_ahead(away))

    moved = real.robot.forward(9)

    assert (moved.walked, moved.stopped_by) == (walked, StoppedBy.OBSTACLE)
    assert moved.met == Met("something", "", 0.0)
    assert real.board.wheels.place.y / STEP == pytest.approx(walked, abs=NEAR)
    assert real.stands


def test_the_back_sensor_stops_a_backward_walk() -> None:
    real = Real(wall_ahead(-4))

    back = real.robot.backward(9)

    assert (back.walked, back.stopped_by) == (3, StoppedBy.OBSTACLE)
    assert back.met == Met("something", "", 180.0)
    assert real.robot.forward(1).stopped_by is None


@pytest.mark.parametrize("overshot", [-20, 0, 20])
def test_a_walk_that_may_not_begin_ends_wherever_the_last_one_ended(overshot: int) -> None:
    """Also if that came too far: less than nothing of this walk is done then."""
    real = Real(wall_ahead(-1), stops_at=20.0)
    real.robot.forward(1)
    real.robot.backward(1)
    real.robot._overshoot = float(overshot)

    assert real.robot.backward(2).stopped_by is StoppedBy.OBSTACLE


def test_ranges_a_single_near_echo_is_no_obstacle() -> None:
    """A thing 2.6 metres away looks near once in a while."""
    sonars = Sonars(far=150.0)
    real = Real(sonars)
    glimpses = iter(range(10_000))
    sonars.far[1] = lambda place: 4.0 if next(glimpses) % 2 else 150.0

    moved = real.robot.forward(6)

    assert (moved.walked, moved.stopped_by) == (6, None)


def test_ranges_a_false_echo_before_the_first_step_delays_it_and_does_not_prevent_it() -> None:
    sonars = Sonars(far=150.0)
    real = Real(sonars)
    real.robot.wait(1.0)
    echoes = iter([4.0])
    sonars.far[1] = lambda place: next(echoes, 150.0)
    while real.link.telemetry.ranges[-1].centimetres[1] != 4:
        real.link.advance(0.02)

    assert real.robot.forward(2).stopped_by is None


def test_ranges_an_unknown_distance_is_no_obstacle() -> None:
    real = Real(Sonars(far=256.0))

    assert real.link.telemetry.ranges[-1].centimetres[1] == 0
    assert real.robot.forward(2).stopped_by is None


def test_after_an_obstacle_the_robot_turns_and_leaves() -> None:
    real = Real(wall_ahead(3))
    real.robot.forward(9)
    real.robot.turn(180)

    assert real.robot.forward(2).stopped_by is None


# --- bumpers and stalls


@pytest.mark.parametrize(("switch", "side"), [(BumperSwitch.NE, 45.0), (BumperSwitch.NW, -45.0)])
def test_a_front_bumper_ends_a_walk_forward_and_reports_its_side(switch: BumperSwitch, side: float) -> None:
    sonars = Sonars()
    real = Real(sonars, at=[(2.5, lambda: setattr(sonars, "pressed", frozenset({switch})))])

    moved = real.robot.forward(9)

    assert (moved.walked, moved.stopped_by) == (2, StoppedBy.COLLISION)
    assert moved.met == Met("something", "", side)
    assert moved.pose.y == pytest.approx(2.5, abs=0.3)
    assert real.stands


def test_a_back_bumper_ends_a_walk_back_but_not_one_forward() -> None:
    sonars = Sonars()
    real = Real(sonars)
    sonars.pressed = frozenset({BumperSwitch.SW})
    real.robot.wait(0.1)

    assert (real.robot.backward(1).stopped_by, real.robot.forward(1).stopped_by) == (
        StoppedBy.COLLISION,
        None,
    )


def test_a_bumper_that_is_pressed_during_a_turn_ends_it_and_one_pressed_before_does_not() -> None:
    sonars = Sonars()
    real = Real(sonars, at=[(1.0, lambda: setattr(sonars, "pressed", frozenset({BumperSwitch.NE})))])

    turned = real.robot.turn(90)
    assert (turned.stopped_by, turned.met) == (StoppedBy.COLLISION, Met("something", "", 45.0))
    assert real.robot.turn(-30).stopped_by is None


def test_the_configuration_places_the_bumpers() -> None:
    sonars = Sonars()
    real = Real(sonars, RobotConfig(front_bumpers=frozenset({3}), back_bumpers=frozenset({0})))
    sonars.pressed = frozenset({BumperSwitch.SE})
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


def test_wheels_that_get_stuck_on_the_way_are_a_stall_and_the_finished_steps_count() -> None:
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
