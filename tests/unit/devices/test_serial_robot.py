"""The real robot walks and turns by its encoders, on a simulated board in virtual time; its pose and its
reset."""

from __future__ import annotations

from math import degrees

import pytest

from devices.board_simulator.floor import AxlePose, Chassis
from devices.ports.robot import STEP, Motion, Pose, StoppedBy, TurnResult, WalkResult
from devices.serial_robot.config import RobotConfig
from devices.wire.frames import MotorDrive
from tests.unit.devices.robots import NEAR, Real
from tests.walled_floor import WalledFloor


def test_the_documented_constants_make_341_counts_a_step_and_4_a_degree() -> None:
    assert RobotConfig().counts_a_step == pytest.approx(341.04, abs=0.01)
    assert RobotConfig().counts_a_degree == pytest.approx(4.048, abs=0.001)


# --- walking and turning


@pytest.mark.parametrize("steps", [1, 2, 7, -3])
def test_a_walk_is_counted_by_the_encoders_and_ends_where_it_should(steps: int) -> None:
    real = Real()

    moved = real.robot.forward(steps) if steps > 0 else real.robot.backward(-steps)

    assert (moved.asked, moved.walked, moved.stopped_by) == (abs(steps), abs(steps), None)
    assert real.board.wheels.place.y / STEP == pytest.approx(steps, abs=NEAR)
    assert moved.pose.y == pytest.approx(steps, abs=NEAR)
    assert real.stands


def test_a_hundred_and_fifty_steps_are_counted_although_the_counters_wrap() -> None:
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


def test_the_next_movement_corrects_the_overshoot_of_one() -> None:
    real = Real()
    for _ in range(30):
        real.robot.forward(1)
        real.robot.turn(12)

    assert real.board.wheels.place.yaw == pytest.approx(AxlePose().yaw - 2 * 3.14159, abs=0.05)
    assert (real.robot.pose().heading + 180) % 360 == pytest.approx(180, abs=3)


def test_no_steps_and_no_degrees_are_done_at_once_and_negative_steps_are_refused() -> None:
    real = Real()
    real.link.written = []
    before, pose = real.robot.time(), real.robot.pose()

    assert real.robot.forward(0) == real.robot.backward(0) == WalkResult(0, 0, None, pose)
    assert real.robot.turn(0) == TurnResult(0, 0, None, pose)
    assert (real.robot.time(), real.link.written, real.watcher.progress) == (before, [], [])
    for walk in (real.robot.forward, real.robot.backward):
        with pytest.raises(ValueError, match="negative"):
            walk(-1)


def test_a_halt_stops_the_wheels() -> None:
    real = Real()
    real.link.drive(real.link.permit(), MotorDrive.FORWARD, 1e9)
    real.link.advance(0.1)
    assert real.board.is_driving
    real.robot.halt()
    real.link.advance(0.1)

    assert not real.board.is_driving


def test_a_moving_picture_gets_a_pose_after_a_twentieth_of_a_second() -> None:
    """The wheels are looked at every 0.02 seconds, so each third time."""
    real = Real()
    began = real.robot.time()
    real.robot.forward(3)

    assert len(real.watcher.passed) == pytest.approx((real.robot.time() - began) / 0.06, rel=0.1)
    heights = [each.y for each in real.watcher.passed]
    assert heights == sorted(heights)


def test_poses_for_a_moving_picture_are_a_twentieth_of_a_second_apart() -> None:
    real = Real()
    for now in (0.04, 0.05, 0.09, 0.1, 0.14, 0.2):
        real.robot._report_passing(Pose(now, 0.0, 0.0), now)

    assert [each.x for each in real.watcher.passed] == [0.05, 0.1, 0.2]


UNEVEN = Chassis(walking=(340.5, 326.6), turning=(170.5, 162.0))
"""As the wheels of the recorded board."""


ASTRAY = 1.25
"""Degrees of tolerance for the heading after a turn, whatever preceded it: five counts."""


def astray(real: Real, wanted: float) -> float:
    """Degrees between the robot's heading and the wanted one."""
    return (real.robot.pose().heading - wanted + 180) % 360 - 180


@pytest.mark.parametrize("turn", [10, -10])
def test_a_turn_corrects_the_drift_of_uneven_wheels(turn: int) -> None:
    """Each step of these wheels turns the robot by 1.7 degrees."""
    real = Real()
    real.board.wheels.chassis = UNEVEN

    for number in range(1, 37):
        real.robot.forward(1)
        real.robot.turn(turn)
        assert astray(real, number * turn) == pytest.approx(0, abs=ASTRAY)

    assert 90 - degrees(real.board.wheels.place.yaw) == pytest.approx(36 * turn, abs=ASTRAY)


def test_a_turn_after_a_reset_does_not_correct_what_was_before_it() -> None:
    real = Real()
    real.board.wheels.chassis = UNEVEN
    real.robot.forward(3)
    assert abs(astray(real, 0)) > 2 * ASTRAY

    real.robot.reset()
    real.robot.turn(90)

    assert astray(real, 90) == pytest.approx(0, abs=ASTRAY)


def test_a_turn_begins_at_the_heading_to_which_a_hand_turned_the_robot() -> None:
    real = Real()
    real.robot.forward(1)
    real.board.wheels.left += 60 * 4.048
    real.link.advance(0.2)

    turned = real.robot.turn(90)

    assert turned.turned == 90
    assert astray(real, 30 + 90) == pytest.approx(0, abs=ASTRAY)


def test_a_turn_begins_at_the_heading_to_which_a_stuck_wheel_turned_the_robot() -> None:
    real = Real(at=[(2.0, lambda: setattr(real.board.wheels, "is_right_stuck", True))])
    assert real.robot.forward(9).stopped_by is StoppedBy.STALL
    real.board.wheels.is_right_stuck = False
    stood = real.robot.pose().heading
    assert 10 < stood < 45

    real.robot.turn(90)

    assert astray(real, stood + 90) == pytest.approx(0, abs=ASTRAY)


@pytest.mark.parametrize("back", [True, False])
def test_after_a_walk_that_a_lost_stop_made_too_long_the_next_one_is_exact(back: bool) -> None:
    """A regression: walking back never ended, and walking on was too short by the overshoot."""
    real = Real()
    wire = real.board.wire
    real.pace.due = [(0.9, lambda: setattr(wire, "cut", 1.0)), (1.6, lambda: setattr(wire, "cut", 0.0))]
    real.robot.forward(1)
    before = real.board.wheels.place.y / STEP
    assert before > 1.5

    moved = real.robot.backward(2) if back else real.robot.forward(2)

    assert (moved.walked, moved.stopped_by) == (2, None)
    assert abs(real.board.wheels.place.y / STEP - before) == pytest.approx(2, abs=NEAR)


def test_each_step_is_reported_once_and_each_ten_degrees_and_the_rest() -> None:
    real = Real()
    real.robot.forward(4)
    real.robot.turn(-25)

    assert real.watcher.progress == [Motion.FORWARD] * 4 + [Motion.LEFT] * 3
    assert len(real.watcher.passed) > 20


def test_a_walk_does_not_stop_between_its_steps() -> None:
    """One step a second, as the original walks; stopping after each step would take longer."""
    real = Real()
    real.robot.forward(10)

    assert real.robot.time() == pytest.approx(10.2, abs=0.4)


def test_a_step_depends_on_the_configured_wheel() -> None:
    real = Real(config=RobotConfig(wheel_radius=0.042))
    real.robot.forward(4)

    assert real.board.wheels.place.y / STEP == pytest.approx(2, abs=NEAR)


# --- place and time


def test_a_reset_makes_the_present_place_the_start() -> None:
    real = Real(WalledFloor([]))
    real.robot.forward(2)
    real.robot.turn(90)

    real.robot.reset()

    pose = real.robot.pose()
    assert (pose.x, pose.y, pose.heading, real.robot.time()) == (0.0, 0.0, 0.0, 0.0)
