"""What the counts of two wheels mean: poses, headings, progress, and wheels that turn the wrong way.

Of the original robot a count is 2 pi times 21 mm by 900, and its wheels are 68 mm apart.
"""

from __future__ import annotations

from math import cos, degrees, pi, radians, sin

import pytest

from devices.ports.robot import Met, Motion, Pose, StoppedBy
from devices.serial_robot.config import RobotConfig, axle_length, wheel_radius
from devices.serial_robot.movement import (
    HeadingTracker,
    Progress,
    WheelOdometry,
    WheelProgress,
    met_something,
    whole,
)
from devices.wire.connection import travelled
from devices.wire.frames import MotorDrive
from devices.wire.telemetry import Telemetry, WheelCounter

CONFIG = RobotConfig()
COUNT = 2 * pi * 0.021 / 900
"""Metres."""


def counts(right: int, left: int, at: float = 0.0) -> Telemetry:
    return Telemetry(at=at, right=right, left=left)


# --- how much was done


@pytest.mark.parametrize(
    ("units", "done"), [(-3.0, 0), (0.94, 0), (0.96, 1), (1.0, 1), (1.94, 1), (1.96, 2), (-0.5, 0)]
)
def test_a_twentieth_of_a_step_or_degree_may_be_missing(units: float, done: int) -> None:
    assert whole(units) == done


@pytest.mark.parametrize(
    ("amount", "every", "units", "reports"),
    [
        (3, 1, [0.5, 0.96, 0.99, 2.5, 2.96], [0.96, 2.5, 2.96]),
        (25, 10, [9.0, 10.0, 19.96, 24.0, 25.0, 30.0], [10.0, 19.96, 25.0]),
        (3, 1, [3.0], [3.0, 3.0, 3.0]),
    ],
)
def test_each_step_and_each_ten_degrees_are_reported_once(
    amount: int, every: int, units: list[float], reports: list[float]
) -> None:
    """Each report has the pose of its moment."""
    made: list[object] = []
    progress = Progress(Motion.FORWARD, amount, every, lambda motion, pose: made.append((motion, pose.y)))
    for each in units:
        progress.reached(each, Pose(0.0, each, 0.0))

    assert made == [(Motion.FORWARD, each) for each in reports]


@pytest.mark.parametrize(
    ("units", "stopped_by", "done", "reported"),
    [
        (2.9, None, 3, 3),
        (2.9, StoppedBy.OBSTACLE, 2, 0),
        (3.4, StoppedBy.USER, 3, 0),
        (0.2, StoppedBy.LINK, 0, 0),
    ],
)
def test_what_ended_early_counts_as_far_as_it_came(
    units: float, stopped_by: StoppedBy | None, done: int, reported: int
) -> None:
    made: list[Pose] = []
    progress = Progress(Motion.FORWARD, 3, 1, lambda _, pose: made.append(pose))

    assert progress.finished(units, stopped_by, Pose(0, 0, 0)) == done
    assert len(made) == reported


@pytest.mark.parametrize(
    ("stopped_by", "way", "sides", "where"),
    [
        (StoppedBy.OBSTACLE, 0.0, [45.0], 0.0),
        (StoppedBy.OBSTACLE, 180.0, [], 180.0),
        (StoppedBy.COLLISION, 0.0, [-45.0, 0.0, 135.0], 0.0),
        (StoppedBy.COLLISION, 180.0, [135.0, -135.0, 45.0], 135.0),
        (StoppedBy.COLLISION, 180.0, [45.0, -170.0], -170.0),
        (StoppedBy.COLLISION, 180.0, [], 180.0),
        (StoppedBy.USER, 0.0, [0.0], None),
        (StoppedBy.STALL, 0.0, [0.0], None),
        (None, 0.0, [0.0], None),
    ],
)
def test_of_the_bumpers_the_nearest_to_the_way_has_met_something(
    stopped_by: StoppedBy | None, way: float, sides: list[float], where: float | None
) -> None:
    assert met_something(stopped_by, way, sides) == (None if where is None else Met("something", "", where))


# --- where the robot is


def test_a_pose_follows_from_the_counts_since_the_start() -> None:
    """Seven steps ahead, a quarter of a turn to the right, and three steps back."""
    odometry = WheelOdometry(CONFIG, counts(100, 200), Pose(2.0, -3.0, 90.0))
    step = 0.05 / COUNT
    assert odometry.follow(counts(100, 200)) == Pose(2.0, -3.0, 90.0)
    ahead = round(7 * step)
    seven = odometry.follow(counts(100 + ahead, 200 + ahead))
    assert (seven.x, seven.y, seven.heading) == pytest.approx((9.0, -3.0, 90.0), abs=0.002)
    quarter = round(pi / 2 * 0.068 / 2 / COUNT)
    turned = odometry.follow(counts(100 + ahead - quarter, 200 + ahead + quarter))
    assert (turned.x, turned.y, turned.heading) == pytest.approx((9.0, -3.0, 180.0), abs=0.1)
    back = ahead - round(3 * step)
    backed = odometry.follow(counts(100 + back - quarter, 200 + back + quarter))
    assert (backed.x, backed.y, backed.heading) == pytest.approx((9.0, 0.0, 180.0), abs=0.1)


def test_unequal_wheels_drive_along_the_chord_of_their_arc() -> None:
    odometry = WheelOdometry(CONFIG, counts(0, 0), Pose(0.0, 0.0, 0.0))
    pose = odometry.follow(counts(500, 300))
    turned, ahead = 200 * COUNT / 0.068, 400 * COUNT / 0.05

    assert pose.heading == pytest.approx(360 - degrees(turned), abs=0.001)
    assert (pose.x, pose.y) == pytest.approx((-ahead * sin(turned / 2), ahead * cos(turned / 2)), abs=0.001)


def test_a_heading_is_from_0_to_below_360() -> None:
    odometry = WheelOdometry(CONFIG, counts(0, 0), Pose(0.0, 0.0, 0.0))

    assert odometry.follow(counts(1, -1)).heading == pytest.approx(360 - degrees(2 * COUNT / 0.068), abs=1e-3)


@pytest.mark.parametrize(
    ("start", "moved", "pose"),
    [
        (Pose(0.0, 0.0, 0.0), 0, "0.0 0.0 0.0"),
        (Pose(0.0, 0.0, 0.0), -1, "0.0 -0.003 0.0"),  # never -0.0
        (Pose(0.0, 0.0, 270.0), 1, "-0.003 0.0 270.0"),
        (Pose(1.2346, -1.2346, 12.3456), 0, "1.235 -1.235 12.346"),
        (Pose(0.0, 0.0, 359.9996), 0, "0.0 0.0 0.0"),
    ],
)
def test_a_pose_is_in_thousandths_and_has_no_negative_zero(start: Pose, moved: int, pose: str) -> None:
    """A count is 0.00293 steps."""
    now = WheelOdometry(CONFIG, counts(0, 0), start).follow(counts(moved, moved))

    assert f"{now.x} {now.y} {now.heading}" == pose


@pytest.mark.parametrize(
    ("right", "left", "deviation"),
    [
        (96, 104, 4.0),  # its wheels rolled out
        (92, 108, 8.0),
        (91, 109, 0.0),  # a person turned it
        (104, 96, -4.0),
        (109, 91, 0.0),
    ],
)
def test_a_turn_corrects_what_rolled_out_and_not_what_a_person_turned(
    right: int, left: int, deviation: float
) -> None:
    heading = HeadingTracker(counts(100, 100))

    assert heading.deviation(counts(right, left)) == deviation
    assert heading.deviation(counts(right, left)) == deviation


@pytest.mark.parametrize(("walked", "deviation"), [(180, 180.0), (181, 0.0), (-180, -180.0)])
def test_a_turn_corrects_what_uneven_wheels_have_turned_up_to_a_limit(walked: int, deviation: float) -> None:
    heading = HeadingTracker(counts(0, 0))
    heading.finished(0, counts(1000 - walked, 1000 + walked))

    assert heading.deviation(counts(1000 - walked, 1000 + walked)) == deviation


def test_what_a_turn_overshot_is_left_for_the_next_one() -> None:
    heading = HeadingTracker(counts(0, 0))
    heading.finished(365.0, counts(-370, 370))
    assert heading.deviation(counts(-371, 371)) == 6.0
    heading.begin(counts(-371, 371))
    assert heading.deviation(counts(-371, 371)) == 0.0


@pytest.mark.parametrize(
    ("drive", "way"),
    [
        *((MotorDrive.FORWARD, 20.0), (MotorDrive.BACKWARD, -20.0), (MotorDrive.LEFT, 10.0)),
        *((MotorDrive.RIGHT, -10.0), (MotorDrive.STOP, 0.0)),
    ],
)
def test_the_way_of_a_drive_is_the_mean_of_both_wheels(drive: MotorDrive, way: float) -> None:
    assert travelled(drive, 30, 10) == way


# --- wheels that turn the wrong way


@pytest.mark.parametrize(
    ("drive", "right", "left", "wrong", "is_reversed"),
    [
        (MotorDrive.FORWARD, 59, -59, False, False),
        (MotorDrive.FORWARD, 59, -60, True, False),
        (MotorDrive.FORWARD, -60, -60, True, True),
        (MotorDrive.FORWARD, -60, -30, True, True),
        (MotorDrive.FORWARD, -60, -29, True, False),
        (MotorDrive.BACKWARD, 60, 30, True, True),
        (MotorDrive.BACKWARD, -60, -60, False, False),
        (MotorDrive.LEFT, -60, 60, True, True),
        (MotorDrive.LEFT, 60, -60, False, False),
        (MotorDrive.RIGHT, 60, -60, True, True),
        (MotorDrive.RIGHT, -60, 60, False, False),
    ],
)
def test_a_wheel_that_goes_back_sixty_counts_is_wired_the_wrong_way(
    drive: MotorDrive, right: int, left: int, wrong: bool, is_reversed: bool
) -> None:
    progress = WheelProgress(drive, counts(0, 0), CONFIG)

    assert progress.is_wrong(counts(right, left, 0.1), 0.0, 0.1) is wrong
    assert progress.is_reversed is is_reversed


@pytest.mark.parametrize(("came", "is_reversed"), [(4, True), (5, False)])
def test_wheels_that_came_forward_first_are_not_reversed(came: int, is_reversed: bool) -> None:
    progress = WheelProgress(MotorDrive.FORWARD, counts(0, 0), CONFIG)
    assert not progress.is_wrong(counts(came, came, 0.1), 0.0, 0.1)
    assert progress.is_wrong(counts(came - 60, came - 60, 0.2), 0.0, 0.2)

    assert progress.is_reversed is is_reversed


@pytest.mark.parametrize(
    ("back", "since", "now", "wrong"),
    [
        (5, 0.0, 0.7, True),  # 0.5 s without progress since 0.1 s
        (4, 0.0, 0.7, False),  # its play
        (5, 0.0, 0.59, False),
        (5, 0.3, 0.7, False),  # it was commanded to turn later
        (5, 0.3, 0.9, True),
    ],
)
def test_a_wheel_that_comes_nowhere_for_half_a_second_is_wrong(
    back: int, since: float, now: float, wrong: bool
) -> None:
    progress = WheelProgress(MotorDrive.FORWARD, counts(0, 0), CONFIG)
    progress.is_wrong(counts(10, 10, 0.1), 0.0, 0.1)

    assert progress.is_wrong(counts(40, 10 - back, now), since, now) is wrong


@pytest.mark.parametrize(
    ("raw", "total"),
    [
        ([5, 15, 10], 5),
        ([32760, -32760], 16),
        ([-32760, 32760], -16),
        ([0, 60], 60),
        ([0, 61], 0),
        ([0, 61, 2], 2),
        ([0, 500, 560], 560),
        ([0, 500, 561], 0),
        ([0, 500, 3, 503], 3),
    ],
)
def test_a_count_that_jumps_needs_a_second_frame(raw: list[int], total: int) -> None:
    wheel = WheelCounter(60)
    moved = [wheel.count(each) for each in raw]

    assert (wheel.total, sum(moved)) == (total, total)
    wheel.rebase()
    assert (wheel.count(9999), wheel.count(9998), wheel.total) == (0, -1, total - 1)


# --- its measures


def test_a_step_and_a_degree_have_as_many_counts_as_the_wheels_and_the_axle_give() -> None:
    """Wheels twice as large with half the counts, and twice as far apart."""
    other = RobotConfig(wheel_radius=0.042, axle_length=0.136, counts_a_turn=450)

    assert other.counts_a_step == pytest.approx(CONFIG.counts_a_step / 4)
    assert other.counts_a_degree == pytest.approx(CONFIG.counts_a_degree / 2)


def test_a_calibration_derives_the_measures_from_counts() -> None:
    assert wheel_radius(3410.4, 900, 0.5) == pytest.approx(0.021, abs=1e-6)
    assert axle_length(1457.1, 900, 0.021, 360.0) == pytest.approx(0.068, abs=1e-5)
    assert axle_length(100.0, 900, 0.021, 90.0) == pytest.approx(2 * 100 * COUNT / radians(90))


def test_the_measures_of_a_robot_are_those_of_the_documentation() -> None:
    """docs/wire-protocol.md, "From counts to steps" and "What can go wrong, and what Donnie does"."""
    assert (CONFIG.wheel_radius, CONFIG.axle_length, CONFIG.counts_a_turn) == (0.021, 0.068, 900)
    assert (CONFIG.walk_coast, CONFIG.turn_coast) == (8, 5)
    assert (CONFIG.wrong_way, CONFIG.stall, CONFIG.farthest) == (60, 0.5, 2.0)
    assert (CONFIG.stop_timeout, CONFIG.poll, CONFIG.diagonal_limit) == (1.0, 0.02, 0.05)
    assert (CONFIG.head_pause, CONFIG.head_stride) == (0.6, 15)
    assert (CONFIG.head_sonar, CONFIG.front_bumpers, CONFIG.back_bumpers) == (6, {0, 1, 2}, {3, 4, 5})
    assert CONFIG.bumper_degrees == (45.0, 0.0, -45.0, 135.0, 180.0, -135.0)
    slower = CONFIG.slower(4.0)
    assert (slower.stall, slower.stop_timeout, slower.poll) == (2.0, 4 * CONFIG.stop_timeout, CONFIG.poll)


def test_with_the_newer_firmware_encoders_and_head_are_reversed_and_the_coasts_exchanged() -> None:
    newer = CONFIG.as_of_2018()

    assert (newer.wiring.encoders, newer.wiring.motors) == ((-1, -1), (1, 1))
    assert (newer.finds_profile, newer.head_is_mirrored) == (False, True)
    assert (newer.walk_coast, newer.turn_coast) == (5, 8)
    assert (CONFIG.finds_profile, CONFIG.head_is_mirrored) == (True, False)
