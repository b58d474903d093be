"""How the wheels of a simulated board turn and where they take it.

Of the original robot a count is 2 pi times 21 mm by 900, and its wheels are 68 mm apart.
"""

from __future__ import annotations

from math import cos, exp, pi, sin
from typing import Any

import pytest

from devices.board_simulator.floor import CHASSIS_2018, AxlePose, Chassis, EmptyFloor, SimulatedWheels
from devices.wire.frames import MotorDrive

COUNT = 2 * pi * 0.021 / 900
"""Metres."""
PASS = 0.001
FORWARD, BACKWARD, LEFT, RIGHT, STOP = (
    MotorDrive.FORWARD,
    MotorDrive.BACKWARD,
    MotorDrive.LEFT,
    MotorDrive.RIGHT,
    MotorDrive.STOP,
)


def wheels(chassis: Chassis | None = None, place: AxlePose | None = None) -> SimulatedWheels:
    return SimulatedWheels(chassis or Chassis(), EmptyFloor(), place or AxlePose(), PASS)


def rolled(made: SimulatedWheels, drive: MotorDrive, passes: int = 1000) -> tuple[float, float]:
    """The counts of the right and the left wheel after so many milliseconds."""
    made.drive(bytes(drive.value))
    for _ in range(passes):
        made.roll()
    return made.right, made.left


def counts_after(rate: float, passes: int) -> float:
    """A wheel that comes nearer to its speed by the same share in each pass, and has it from 1 count on."""
    speed = counted = 0.0
    for _ in range(passes):
        speed = rate + (speed - rate) * exp(-PASS / 0.025)
        speed = rate if abs(speed - rate) < 1.0 else speed
        counted += speed * PASS
    return counted


@pytest.mark.parametrize(
    ("drive", "original", "newer"),
    [
        (FORWARD, (340.5, 340.5), (171.0, 171.0)),
        (BACKWARD, (-340.5, -340.5), (-171.0, -171.0)),
        (LEFT, (171.0, -171.0), (340.5, -340.5)),
        (RIGHT, (-171.0, 171.0), (-340.5, 340.5)),
        (STOP, (0.0, 0.0), (0.0, 0.0)),
    ],
)
def test_each_drive_turns_the_wheels_at_its_recorded_rates(
    drive: MotorDrive, original: tuple[float, float], newer: tuple[float, float]
) -> None:
    for chassis, rates in ((Chassis(), original), (CHASSIS_2018, newer)):
        made = wheels(chassis)
        assert rolled(made, drive) == pytest.approx([counts_after(each, 1000) for each in rates])
        assert made.is_driven is (drive is not STOP)


@pytest.mark.parametrize("passes", [1, 2, 25, 200])
def test_a_wheel_has_two_thirds_of_its_speed_after_a_fortieth_of_a_second(passes: int) -> None:
    made = wheels()
    assert rolled(made, FORWARD, passes) == pytest.approx([counts_after(340.5, passes)] * 2)
    before = made.right
    made.roll()
    if passes == 25:
        assert (made.right - before) / PASS == pytest.approx(340.5 * (1 - exp(-1.04)))


def test_a_wheel_rolls_out_when_its_motor_is_off_and_then_stands() -> None:
    made = wheels()
    before, _ = rolled(made, FORWARD)
    after, _ = rolled(made, STOP)

    assert after - before == pytest.approx(340.5 * 0.025, abs=0.3)
    assert not made.is_driven
    assert rolled(made, STOP, 10) == (after, after)


def test_wheels_that_stand_ask_the_floor_nothing() -> None:
    class Floor(EmptyFloor):
        asked = 0

        def is_free(self, place: AxlePose) -> bool:
            self.asked += 1
            return super().is_free(place)

    floor = Floor()
    made = SimulatedWheels(Chassis(), floor, AxlePose(), PASS)
    assert not made.is_driven
    for _ in range(5):
        made.roll()
    assert (made.right, made.left, made.place, floor.asked) == (0.0, 0.0, AxlePose(), 0)
    rolled(made, FORWARD, 5)
    assert floor.asked == 5


@pytest.mark.parametrize(
    ("data", "rates"),
    [
        (b"\x0f\x01\xf0\x01", (340.5, 340.5)),  # any speed is the same
        (b"\x0f\x7f\x00\x7f", (340.5, 340.5)),  # what is not 0F is the other way
        (b"\xf0\x7f\x0e\x7f", (-171.0, 171.0)),
        (b"\x0f\x00\xf0\x7f", (0.0, 0.0)),  # a wheel at zero stops both
        (b"\x0f\x7f\xf0\x00", (0.0, 0.0)),
    ],
)
def test_the_bytes_of_a_motor_frame_are_obeyed_as_by_the_firmware(
    data: bytes, rates: tuple[float, float]
) -> None:
    made = wheels()
    made.drive(data)
    for _ in range(500):
        made.roll()

    assert (made.right, made.left) == pytest.approx([counts_after(each, 500) for each in rates])


@pytest.mark.parametrize("yaw", [pi / 2, 0.3, -2.0])
def test_a_walk_leads_along_the_heading(yaw: float) -> None:
    made = wheels(place=AxlePose(1.0, 2.0, yaw))
    counts, _ = rolled(made, FORWARD)
    way = counts * COUNT

    assert made.place.x == pytest.approx(1 + way * cos(yaw))
    assert made.place.y == pytest.approx(2 + way * sin(yaw))
    assert made.place.yaw == pytest.approx(yaw)
    assert AxlePose() == AxlePose(0.0, 0.0, pi / 2)


@pytest.mark.parametrize(("drive", "sense"), [(LEFT, 1), (RIGHT, -1)])
def test_a_turn_is_about_the_middle_of_the_axle(drive: MotorDrive, sense: int) -> None:
    made = wheels(place=AxlePose(1.0, 2.0, 0.5))
    right, left = rolled(made, drive)

    assert (made.place.x, made.place.y) == pytest.approx((1.0, 2.0))
    assert made.place.yaw == pytest.approx(0.5 + (right - left) * COUNT / 0.068)
    assert (made.place.yaw - 0.5) * sense > 0


def test_one_wheel_alone_leads_around_the_other_one() -> None:
    """In an arc about the left wheel, half an axle from the middle."""
    made = wheels(place=AxlePose(0.0, 0.0, 0.0))
    made.is_left_stuck = True
    right, left = rolled(made, FORWARD)
    turned = right * COUNT / 0.068

    assert left == 0.0
    assert made.place.yaw == pytest.approx(turned)
    assert (made.place.x, made.place.y) == pytest.approx(
        (0.034 * sin(turned), 0.034 * (1 - cos(turned))), abs=1e-5
    )


def test_a_pass_leads_along_the_chord_of_its_arc() -> None:
    made = SimulatedWheels(Chassis(), EmptyFloor(), AxlePose(0.0, 0.0, 0.0), 1.0)
    made.is_left_stuck = True
    right, left = rolled(made, FORWARD, 1)
    ahead, turned = 340.5 * COUNT / 2, 340.5 * COUNT / 0.068

    assert (right, left) == (340.5, 0.0)
    assert made.place.yaw == pytest.approx(turned)
    assert (made.place.x, made.place.y) == pytest.approx((ahead * cos(turned / 2), ahead * sin(turned / 2)))


def test_a_wheel_has_its_speed_once_less_than_one_count_is_missing() -> None:
    made = wheels(Chassis(walking=(2.0, 1.5)))
    made._keeps = 0.5
    counted = [rolled(made, FORWARD, 1) for _ in range(2)]

    assert counted == [pytest.approx((0.001, 0.0015)), pytest.approx((0.003, 0.003))]


@pytest.mark.parametrize(
    ("fault", "value", "right", "left", "ahead"),
    [
        ("is_stuck", True, 0, 0, 0),
        ("is_right_stuck", True, 0, 1, 0.5),
        ("is_left_stuck", True, 1, 0, 0.5),
        ("encoders", (-1, 1), -1, 1, 1),
        ("encoders", (1, -1), 1, -1, 1),
        ("encoders", (2, 1), 2, 1, 1),
        ("encoders", (1, 2), 1, 2, 1),
        ("motors", (-1, -1), -1, -1, -1),
        ("motors", (-1, 1), -1, 1, 0),
        ("motors", (2, 1), 2, 1, 1.5),
        ("motors", (1, 2), 1, 2, 1.5),
        ("strengths", (1.0, 0.5), 1, 0.5, 0.75),
        ("strengths", (0.5, 1.0), 0.5, 1, 0.75),
        ("share", 0.25, 0.25, 0.25, 0.25),
    ],
)
def test_a_fault_changes_the_counts_or_the_way_of_a_wheel(
    fault: str, value: Any, right: float, left: float, ahead: float
) -> None:
    """Of the counts of a whole wheel; ``ahead`` is the share of the way of both."""
    made = wheels(place=AxlePose(0.0, 0.0, 0.0))
    setattr(made, fault, value)
    passes = 100
    counted = rolled(made, FORWARD, passes)

    assert counted == pytest.approx(
        [counts_after(340.5 * abs(each), passes) * (1 if each > 0 else -1) for each in (right, left)]
    )
    straight = counts_after(340.5, passes) * COUNT
    assert made.place.x == pytest.approx(straight * ahead, rel=0.03)


def test_a_reset_board_counts_from_0_and_its_motors_are_off() -> None:
    made = wheels()
    rolled(made, FORWARD, 200)
    place = made.place
    made.reset()

    assert (made.right, made.left, made.is_driven) == (0.0, 0.0, False)
    assert made.place == place
    made.roll()
    assert 0.2 < made.right < 0.35  # it still rolls


def test_a_robot_that_does_not_fit_stays_where_it_is_and_its_wheels_slip() -> None:
    class Full(EmptyFloor):
        def is_free(self, place: AxlePose) -> bool:
            return place.y <= 0.01

    made = SimulatedWheels(Chassis(), Full(), AxlePose(), PASS)
    counted, _ = rolled(made, FORWARD)

    assert counted == pytest.approx(counts_after(340.5, 1000))
    assert made.place.y == pytest.approx(0.01, abs=340.5 * PASS * COUNT)
