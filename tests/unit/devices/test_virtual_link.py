"""The robot of ``--robot double``: its link and its pace in virtual time."""

from __future__ import annotations

import pytest

from devices.board_simulator.board import SimulatedBoard
from devices.board_simulator.floor import AxlePose
from devices.board_simulator.robot import SimulatedSerialRobot, VirtualLink
from devices.ports.robot import LinkNotice, Pose, RobotProblem
from devices.wire.frames import CONFIGURE, MotorDrive, drive_frame, head_frame
from devices.wire.link_state import LinkState

FORWARD = drive_frame(MotorDrive.FORWARD)


def linked(notices: list[tuple[LinkNotice, str]] | None = None) -> VirtualLink:
    heard = [] if notices is None else notices
    link = VirtualLink(
        SimulatedBoard(boot_loader=0.0), on_notice=lambda notice, reason: heard.append((notice, reason))
    )
    link.connect()
    return link


class Pace:
    """Waits as long as it is asked, without a clock, until it is stopped."""

    def __init__(self) -> None:
        self.slept = 0.0
        self.is_stopped = False

    def sleep(self, seconds: float) -> bool:
        self.slept += seconds
        return not self.is_stopped


@pytest.mark.parametrize(("speed", "real"), [(1.0, 2.0), (4.0, 0.5), (0.5, 4.0), (None, 0.0)])
def test_a_robot_waits_in_real_time_by_its_speed(speed: float | None, real: float) -> None:
    pace = Pace()
    robot = SimulatedSerialRobot(pace=pace, speed=speed)
    before, pace.slept = robot.time(), 0.0
    assert robot.wait(2.0)

    assert (robot.speed, pace.slept) == (speed, pytest.approx(real))
    assert robot.time() - before == pytest.approx(2.0)
    robot.speed, pace.slept = 2.0, 0.0
    assert robot.wait(1.0)
    assert (robot.speed, pace.slept) == (2.0, pytest.approx(0.5))


def test_a_wait_that_is_stopped_takes_no_robot_time() -> None:
    pace = Pace()
    robot = SimulatedSerialRobot(pace=pace)
    before, pace.is_stopped = robot.time(), True

    assert robot.wait(2.0) is False
    assert robot.time() == before


def test_a_reset_puts_the_robot_back_where_it_began() -> None:
    board = SimulatedBoard(boot_loader=0.0, place=AxlePose(1.0, 2.0, 0.0))
    robot = SimulatedSerialRobot(board, pace=Pace(), start=Pose(20.0, 40.0, 90.0))
    robot.forward(2)
    assert board.wheels.place != AxlePose(1.0, 2.0, 0.0)
    robot.reset()

    assert (board.wheels.place, robot.pose()) == (AxlePose(1.0, 2.0, 0.0), Pose(20.0, 40.0, 90.0))


def test_a_port_that_is_gone_and_a_board_that_is_mute_can_not_be_connected() -> None:
    unplugged, mute = VirtualLink(SimulatedBoard()), VirtualLink(SimulatedBoard())
    unplugged.is_plugged, mute.board.is_mute = False, True
    for link, code, values in (
        (unplugged, "no-port", {"port": "double", "reason": "unplugged"}),
        (mute, "no-answer", {"port": "double"}),
    ):
        with pytest.raises(RobotProblem) as caught:
            link.connect()
        assert (caught.value.code, caught.value.values, link.state) == (code, values, LinkState.CLOSED)
    assert unplugged.now() == 0.0
    assert 6.0 <= mute.now() < 9.0


def test_a_link_that_is_connected_or_closed_twice_stays_so() -> None:
    link = linked()
    resets, now = link.board.resets, link.now()
    link.connect()
    assert (link.board.resets, link.now(), link.state) == (resets, now, LinkState.STREAMING)
    for _ in range(2):
        link.close()
    assert link.state is LinkState.CLOSED


def test_closing_waits_until_the_wheels_stand() -> None:
    link = linked()
    link.drive(link.permit(), MotorDrive.FORWARD, 1e9)
    link.advance(0.2)
    link.close()

    assert not link.board.is_driving
    before = link.board.wheels.right
    link.advance(1.0)
    assert link.board.wheels.right == before


def test_time_passes_as_it_is_asked_for_however_long_a_poll_is() -> None:
    link = linked()
    for poll, seconds in ((0.01, 0.035), (0.5, 0.2), (0.03, 0.06)):
        before, link.poll = link.now(), poll
        link.advance(seconds)
        assert link.now() - before == pytest.approx(seconds)


def test_what_is_written_is_collected_with_its_time() -> None:
    link = linked()
    link.written, now = [], link.now()
    link.put(head_frame(20))
    link.advance(0.1)

    assert [data for _, data in link.written][-1] == head_frame(20)
    assert all(now < at <= now + 0.1 for at, _ in link.written)
    link.advance(0.1)
    assert link.board.head == 20


@pytest.mark.parametrize(
    ("fault", "reason"), [("is_plugged", "device disconnected"), ("is_blocked", "the port takes nothing")]
)
def test_a_lost_port_is_reported_with_its_reason_and_reopened(fault: str, reason: str) -> None:
    notices: list[tuple[LinkNotice, str]] = []
    link = linked(notices)
    assert notices == [(LinkNotice.CONNECTED, "double")]
    resets = link.board.resets
    setattr(link, fault, fault == "is_blocked")
    link.drive(link.permit(), MotorDrive.FORWARD, 1e9)
    link.advance(0.1)
    assert notices[1:] == [(LinkNotice.LOST, reason)]
    assert not link.board.is_driving
    link.advance(1.0)
    setattr(link, fault, fault != "is_blocked")
    link.advance(4.0)

    assert notices[2:] == [(LinkNotice.RESTORED, "double")]
    assert link.board.resets > resets


@pytest.mark.parametrize("has_reset_wire", [True, False])
def test_opening_restarts_a_board_on_usb_only(has_reset_wire: bool) -> None:
    board = SimulatedBoard(boot_loader=0.0)
    board.advance(1.1)
    board.receive(CONFIGURE + FORWARD)
    board.advance(0.3)
    assert board.is_driving
    link = VirtualLink(board, resets_on_open=has_reset_wire)
    link.connect()

    assert (board.resets, board.is_driving) == (int(has_reset_wire), False)
    assert link.state is LinkState.STREAMING
