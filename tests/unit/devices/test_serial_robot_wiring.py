"""Robots that are wired in another way, or have the newer firmware; unequal wheels; and a stop that fails."""

from __future__ import annotations

from math import pi, radians
from types import SimpleNamespace
from typing import Any

import pytest
from msgspec.structs import replace

from devices.board_simulator.board import SimulatedBoard
from devices.board_simulator.floor import AxlePose
from devices.ports.robot import STEP, LinkNotice, Met, Motion, Pose, StoppedBy
from devices.serial_robot.config import RobotConfig, axle_length, wheel_radius
from devices.serial_robot.movement import Progress
from devices.serial_robot.robot import _mirrored, _overshoot_of
from devices.serial_robot.senses import head_angle
from devices.wire.frames import MotorDrive, Wiring, drive_frame, head_frame
from tests.unit.devices.robots import NEAR, Real, Sonars, wall_ahead

KNOWN = RobotConfig(finds_profile=False)
MOST_COUNTS = 100
"""Those after which the movement must end, and those that the wheels roll on."""


def distance(real: Real) -> float:
    """Counts by which the wheels have really turned, the farther one of them."""
    return max(abs(real.board.wheels.right), abs(real.board.wheels.left))


# --- swapped phases


@pytest.mark.parametrize("encoders", [(-1, 1), (1, -1), (-1, -1)], ids=["right", "left", "both"])
@pytest.mark.parametrize("command", ["forward", "backward", "right", "left"])
def test_a_wheel_that_counts_the_wrong_way_ends_the_movement_at_once(
    encoders: tuple[int, int], command: str
) -> None:
    real = Real(config=KNOWN)
    real.board.wheels.encoders = encoders

    match command:
        case "forward" | "backward":
            done = getattr(real.robot, command)(4)
        case _:
            done = real.robot.turn(90 if command == "right" else -90)

    assert done.stopped_by is StoppedBy.WRONG_WAY
    assert distance(real) < MOST_COUNTS
    assert real.stands


def test_a_walk_toward_a_wall_with_swapped_phases_ends_before_it() -> None:
    real = Real(wall_ahead(4), config=KNOWN)
    real.board.wheels.encoders = (-1, -1)

    for _ in range(20):
        real.robot.forward(4)

    assert real.board.wheels.place.y / STEP < 3.5
    assert real.stands


def test_a_robot_that_turns_only_one_wheel_back_and_forth_makes_no_progress() -> None:
    real = Real(config=KNOWN)
    real.board.wheels.strengths = (1.0, -0.05)

    moved = real.robot.forward(4)

    assert moved.stopped_by is StoppedBy.WRONG_WAY
    assert real.robot.time() < 1.2


@pytest.mark.parametrize("strengths", [(1.0, 0.85), (0.9, 1.0)])
def test_unequal_wheels_walk_and_the_next_turn_corrects_them(strengths: tuple[float, float]) -> None:
    real = Real(config=KNOWN)
    real.board.wheels.strengths = strengths

    assert real.robot.forward(2).stopped_by is None
    assert real.robot.turn(90).stopped_by is None
    assert real.robot.pose().heading == pytest.approx(90, abs=3)


# --- settings


@pytest.mark.parametrize("encoders", [(-1, 1), (1, -1), (-1, -1)])
@pytest.mark.parametrize("motors", [(1, 1), (-1, 1), (-1, -1)])
def test_the_settings_correct_swapped_wires(encoders: tuple[int, int], motors: tuple[int, int]) -> None:
    board = SimulatedBoard(boot_loader=0.0, passes=250)
    board.wheels.encoders, board.wheels.motors = encoders, motors
    real = Real(config=replace(KNOWN, wiring=Wiring(motors, encoders)), board=board)

    assert real.robot.forward(3).stopped_by is None
    assert board.wheels.place.y / STEP == pytest.approx(3, abs=NEAR)
    assert real.robot.turn(90).stopped_by is None
    assert board.wheels.place.yaw == pytest.approx(0, abs=radians(3))
    assert real.robot.backward(3).stopped_by is None
    assert board.wheels.place.x / STEP == pytest.approx(-3, abs=2 * NEAR)


# --- the firmware of 2018


def newer(floor: Sonars | None = None) -> SimulatedBoard:
    return SimulatedBoard.of_2018(floor, boot_loader=0.0, passes=250)


def test_with_its_profile_the_newer_firmware_walks_turns_and_looks() -> None:
    sonars = Sonars()
    real = Real(config=RobotConfig().as_of_2018(), board=newer(sonars))

    assert real.robot.forward(3).stopped_by is None
    assert real.board.wheels.place.y / STEP == pytest.approx(3, abs=NEAR)
    assert real.robot.turn(90).stopped_by is None
    assert real.board.wheels.place.yaw == pytest.approx(0, abs=radians(3))
    sonars.far[6] = lambda place: 50.0 if real.board.head < 60 else None
    (seen,) = real.robot.scan()
    assert seen.degrees > 30


def test_the_newer_firmware_is_found_out_in_the_first_half_step_and_is_not_driven_on() -> None:
    real = Real(board=newer())

    first = real.robot.forward(3)

    assert (first.walked, first.stopped_by) == (0, StoppedBy.WRONG_WAY)
    assert abs(real.board.wheels.place.y) < STEP / 2
    assert real.notices[-1] is LinkNotice.PROFILE_2018
    assert real.stands
    assert real.robot.pose().y == pytest.approx(real.board.wheels.place.y / STEP, abs=0.02)

    before = real.board.wheels.place.y
    second = real.robot.forward(3)
    assert (second.walked, second.stopped_by) == (3, None)
    assert (real.board.wheels.place.y - before) / STEP == pytest.approx(3, abs=NEAR)


def test_only_the_first_movement_finds_it_out_and_only_where_no_profile_was_chosen() -> None:
    known = Real(config=KNOWN, board=newer())
    known.robot.forward(3)
    assert LinkNotice.PROFILE_2018 not in known.notices

    moved = Real()
    moved.robot.forward(2)
    moved.board.wheels.encoders = (-1, -1)
    assert moved.robot.forward(2).stopped_by is StoppedBy.WRONG_WAY
    assert LinkNotice.PROFILE_2018 not in moved.notices


def ended(counts: float, stopped_by: StoppedBy | None) -> Any:
    """A movement that came so far; its wheels were reversed if it ended by that."""
    is_reversed = stopped_by is StoppedBy.WRONG_WAY
    return SimpleNamespace(
        run=lambda: None, counts=counts, units=0.0, stopped_by=stopped_by, is_reversed=is_reversed
    )


@pytest.mark.parametrize(
    ("counts", "is_newer"),
    [([], True), ([60.0], True), ([60.5], False), ([60.5, 0.0], False), ([0.0, 60.5], False)],
)
def test_a_movement_of_more_than_sixty_counts_shows_that_the_firmware_is_not_the_newer_one(
    counts: list[float], is_newer: bool
) -> None:
    real = Real()
    for each in (*counts, -60.0):
        stopped_by = StoppedBy.USER if each >= 0 else StoppedBy.WRONG_WAY
        real.robot._run(ended(each, stopped_by), Progress(Motion.FORWARD, 1, 1, lambda *_: None))

    assert (LinkNotice.PROFILE_2018 in real.notices) is is_newer


@pytest.mark.parametrize(
    ("stopped_by", "counts", "overshoot"),
    [
        (None, 351.0, 10.0),
        (None, 331.0, -10.0),
        (StoppedBy.OBSTACLE, 351.0, 10.0),
        (None, 441.0, 100.0),
        (None, 441.5, 0.0),  # it was carried somewhere else
        (None, 241.0, -100.0),
        (None, 240.5, 0.0),
        (StoppedBy.USER, 351.0, 0.0),
        (StoppedBy.COLLISION, 351.0, 0.0),
    ],
)
def test_the_next_walk_corrects_what_a_walk_that_ended_as_planned_came_too_far(
    stopped_by: StoppedBy | None, counts: float, overshoot: float
) -> None:
    """341 counts are done."""
    assert _overshoot_of(ended(counts, stopped_by), 341.0) == overshoot


@pytest.mark.parametrize(
    ("pose", "began", "mirrored"),
    [
        (Pose(3.0, -1.0, 20.0), Pose(1.0, 2.0, 10.0), Pose(-1.0, 5.0, 0.0)),
        (Pose(0.0, 0.5, 300.0), Pose(0.0, 0.0, 350.0), Pose(0.0, -0.5, 40.0)),
        (Pose(0.0, 0.0, 10.0), Pose(0.0, 0.0, 0.0), Pose(0.0, 0.0, 350.0)),
    ],
)
def test_a_pose_that_was_counted_the_wrong_way_is_mirrored_at_the_beginning(
    pose: Pose, began: Pose, mirrored: Pose
) -> None:
    assert _mirrored(pose, began) == mirrored


def test_one_swapped_encoder_is_not_taken_for_the_newer_firmware() -> None:
    real = Real()
    real.board.wheels.encoders = (1, -1)
    real.robot.forward(2)

    assert LinkNotice.PROFILE_2018 not in real.notices


# --- the head


@pytest.mark.parametrize(
    ("degrees", "is_mirrored", "angle"),
    [
        (0, False, 90),
        (-120, False, 0),
        (120, False, 180),
        (-90, True, 180),
        (-120, True, 180),
        (45, True, 45),
    ],
)
def test_the_head_turns_no_farther_than_it_can(degrees: int, is_mirrored: bool, angle: int) -> None:
    turned = head_angle(degrees, is_mirrored=is_mirrored)

    assert turned == angle
    assert head_frame(turned)


# --- the three front sonars, and sonars by time


@pytest.mark.parametrize(("sonar", "side"), [(0, 45.0), (2, -45.0)])
def test_something_close_at_a_front_corner_ends_a_walk_forward(sonar: int, side: float) -> None:
    """The original's limit is 5 centimetres there; the sonar ahead sees nothing."""
    sonars = Sonars(far=150.0)
    real = Real(sonars)
    sonars.far[sonar] = lambda place: 30.0 - place.y * 100

    moved = real.robot.forward(9)

    assert moved.stopped_by is StoppedBy.OBSTACLE
    assert moved.met == Met("something", "", side)
    assert real.board.wheels.place.y == pytest.approx(0.26, abs=0.03)
    assert real.stands


def test_a_wall_along_the_way_farther_than_five_centimetres_ends_no_walk() -> None:
    sonars = Sonars(far=150.0)
    sonars.far = {0: lambda place: 5.5, 2: lambda place: 6.0}

    assert Real(sonars).robot.forward(3).stopped_by is None


def test_a_front_corner_ends_no_walk_backward() -> None:
    sonars = Sonars(far=150.0)
    sonars.far[0] = lambda place: 3.0

    assert Real(sonars).robot.backward(2).stopped_by is None


def test_something_that_comes_close_in_the_middle_of_a_step_ends_the_walk() -> None:
    """The steps alone would be looked at only before the next one."""
    sonars = Sonars(far=150.0)
    real = Real(sonars, at=[(1.7, lambda: sonars.far.update({1: lambda place: 4.0}))])

    moved = real.robot.forward(9)

    assert moved.stopped_by is StoppedBy.OBSTACLE
    assert real.board.wheels.place.y / STEP < 2.8


# --- a stop that fails


@pytest.mark.parametrize("is_walk", [True, False], ids=["walk", "turn"])
def test_a_stop_of_the_learner_that_fails_is_not_called_stopped(is_walk: bool) -> None:
    real = Real(stops_at=1.5)
    real.link.has_reset_wire = False
    real.pace.due = [(1.0, lambda: setattr(real.board, "is_deaf", True))]

    done = real.robot.forward(9) if is_walk else real.robot.turn(360)

    assert done.stopped_by is StoppedBy.RUNAWAY
    assert real.board.is_driving
    assert real.notices[-1] is LinkNotice.RUNAWAY


def test_a_walk_whose_own_end_fails_is_reported_too() -> None:
    real = Real(at=[(1.0, lambda: setattr(real.board, "is_deaf", True))])
    real.link.has_reset_wire = False

    assert real.robot.forward(2).stopped_by is StoppedBy.RUNAWAY


def test_a_stop_that_comes_before_the_first_count_waits_for_what_the_wheels_do() -> None:
    """The board obeys late, and then reads nothing more. Until then its frames showed standing wheels."""
    real = Real(stops_at=0.5)
    real.link.has_reset_wire = False
    real.board.is_deaf = True

    def begin_late() -> None:
        real.board.is_deaf = False
        real.board.receive(drive_frame(MotorDrive.FORWARD))
        real.board.is_deaf = True

    real.pace.due = [(0.5, begin_late)]

    done = real.robot.forward(9)

    assert done.stopped_by is StoppedBy.RUNAWAY
    assert real.board.is_driving


def test_a_stop_that_works_is_answered_within_a_moment() -> None:
    real = Real(stops_at=1.5)

    moved = real.robot.forward(9)

    assert moved.stopped_by is StoppedBy.USER
    assert real.robot.time() < 2.0
    assert not real.board.is_driving


def test_the_place_of_a_robot_is_the_same_with_settings_for_its_wires() -> None:
    board = SimulatedBoard(boot_loader=0.0, passes=250, place=AxlePose())
    board.wheels.encoders = (-1, -1)
    real = Real(config=replace(KNOWN, wiring=Wiring(encoders=(-1, -1))), board=board)
    real.robot.forward(2)

    assert real.robot.pose().y == pytest.approx(2, abs=NEAR)


def test_the_newer_firmware_gets_its_pings_answered_and_walks_on() -> None:
    """Without an answer it crawls after some four seconds."""
    real = Real(config=RobotConfig().as_of_2018(), board=newer())

    assert real.robot.forward(6).stopped_by is None
    assert real.robot.time() < 15


def test_a_calibration_turns_what_was_measured_into_wheels_and_an_axle() -> None:
    """Wheels of 5 cm radius roll 31.4 cm in a turn of 1920 counts; the axle is 20 cm long."""
    assert wheel_radius(1920, 1920, 2 * pi * 0.05) == pytest.approx(0.05)
    assert wheel_radius(960, 1920, 2 * pi * 0.05) == pytest.approx(0.1)
    assert wheel_radius(1920, 960, 2 * pi * 0.05) == pytest.approx(0.025)

    a_whole_turn = 1920 * (pi * 0.2) / (2 * pi * 0.05)
    assert axle_length(a_whole_turn, 1920, 0.05, 360) == pytest.approx(0.2)
    assert axle_length(a_whole_turn / 4, 1920, 0.05, 90) == pytest.approx(0.2)
    assert axle_length(a_whole_turn, 1920, 0.1, 360) == pytest.approx(0.4)
