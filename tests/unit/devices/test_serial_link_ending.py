"""However a link to a robot ends, the last frame is a stop: closed, its thread or its process gone."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import termios
import threading
from collections.abc import Iterator
from math import inf

import pytest

from devices.ports.robot import LinkNotice
from devices.serial_robot.link import SerialLink, open_board_port
from devices.wire.frames import STOP, MotorDrive, drive_frame
from devices.wire.link_state import LinkConfig, LinkState
from tests.board_on_pty import PtyBoard
from tests.conftest import ROOT
from tests.timeouts import TIMEOUT
from tests.unit.devices.test_serial_link import (
    FAR,
    HALF_A_FRAME,
    SLOW_MACHINE,
    Notices,
    can_drive,
    has_driven,
    started,
    until,
)


@pytest.fixture
def pty_board() -> Iterator[PtyBoard]:
    with PtyBoard(started()) as it:
        yield it


@pytest.fixture
def link(pty_board: PtyBoard) -> Iterator[SerialLink]:
    it = SerialLink(pty_board.path)
    it.connect()
    yield it
    it.close()


def test_shutdown_sends_two_stops_last(pty_board: PtyBoard) -> None:
    link = SerialLink(pty_board.path, SLOW_MACHINE)
    link.connect()
    assert can_drive(link, pty_board)

    link.close()

    assert until(lambda: not pty_board.board.is_driving)
    assert until(lambda: pty_board.received.endswith(STOP + STOP))
    assert until(lambda: link.state is LinkState.CLOSED)


def test_shutdown_sends_a_stop_last_although_the_boards_buffer_had_no_room_for_it(
    pty_board: PtyBoard,
) -> None:
    link = SerialLink(pty_board.path, SLOW_MACHINE)
    link.connect()
    assert can_drive(link, pty_board)
    link._connection._outbox._all_read_at = inf  # it believes that the board reads nothing

    link.close()

    assert until(lambda: not pty_board.board.is_driving)
    assert until(lambda: pty_board.received.endswith(STOP))


def test_shutdown_in_the_middle_of_half_a_frame_waits_until_the_wheels_stand(pty_board: PtyBoard) -> None:
    """The board takes the stops for the rest of a frame of fifty bytes."""
    link = SerialLink(pty_board.path, SLOW_MACHINE)
    link.connect()
    assert can_drive(link, pty_board)
    pty_board.disturb(HALF_A_FRAME)

    link.close()

    assert not pty_board.board.is_driving


def test_shutdown_of_a_lost_link_ends(pty_board: PtyBoard) -> None:
    notices = Notices()
    link = SerialLink(pty_board.path, LinkConfig(reopen=1000.0), notices)
    link.connect()
    link.drive(link.permit(), MotorDrive.FORWARD, FAR)
    pty_board.unplug()
    assert notices.wait_for(LinkNotice.LOST)

    link.close()

    assert until(lambda: link.state is LinkState.CLOSED)


def test_a_thread_that_ends_leaves_no_motor_on(pty_board: PtyBoard, link: SerialLink) -> None:
    """Its drive is not renewed."""

    driver = threading.Thread(target=can_drive, args=(link, pty_board))
    driver.start()
    driver.join()

    assert has_driven(pty_board)
    assert until(lambda: not pty_board.board.is_driving)


def test_process_killed_the_hang_up_flag_of_the_port_is_left_alone(pty_board: PtyBoard) -> None:
    """With it the system drops DTR when a program is killed, which resets the next board that is opened."""
    descriptor = os.open(pty_board.path, os.O_RDWR | os.O_NOCTTY)
    settings = termios.tcgetattr(descriptor)
    settings[2] |= termios.HUPCL
    termios.tcsetattr(descriptor, termios.TCSANOW, settings)
    port = open_board_port(pty_board.path)
    flags = termios.tcgetattr(descriptor)[2]
    port.close()
    os.close(descriptor)

    assert flags & termios.HUPCL


DRIVER = """
import select, signal, sys, time
from devices.serial_robot.link import SerialLink
from devices.wire.frames import MotorDrive
from devices.wire.link_state import LinkConfig
link = SerialLink(sys.argv[1], LinkConfig(silence=60.0, lease=60.0)); link.connect()
signal.signal(signal.SIGTERM, lambda *_: (link.close(), sys.exit(3)))
ends = time.monotonic() + 60
while time.monotonic() < ends:
    link.drive(link.permit(), MotorDrive.FORWARD, 1e9)
    {then}
    time.sleep(0.02)
"""


def driver(pty_board: PtyBoard, then: str) -> subprocess.Popen[str]:
    """A program that drives, and runs ``then`` in the same loop."""
    code = [sys.executable, "-c", DRIVER.format(then=then), pty_board.path]
    return subprocess.Popen(
        code,
        cwd=ROOT,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )


@pytest.mark.parametrize(
    "then",
    [
        "if select.select([sys.stdin], [], [], 0)[0]: raise KeyError",
        "sys.exit(0) if select.select([sys.stdin], [], [], 0)[0] else 0",
    ],
    ids=["exception", "exit"],
)
def test_a_program_that_ends_in_the_middle_of_a_drive_stops_the_robot(pty_board: PtyBoard, then: str) -> None:
    program = driver(pty_board, then)
    assert until(lambda: drive_frame(MotorDrive.FORWARD) in pty_board.received)
    assert program.stdin is not None
    program.stdin.close()  # it may end now
    assert program.wait(TIMEOUT) is not None

    assert until(lambda: not pty_board.board.is_driving)


def test_process_killed_the_next_program_stops_the_robot(pty_board: PtyBoard) -> None:
    program = driver(pty_board, "pass")
    assert has_driven(pty_board)
    program.send_signal(signal.SIGKILL)
    program.wait(TIMEOUT)
    assert pty_board.board.is_driving

    link = SerialLink(pty_board.path)
    link.connect()

    assert until(lambda: not pty_board.board.is_driving)
    link.close()


def test_a_signal_handler_may_close_the_link_in_the_middle_of_anything(pty_board: PtyBoard) -> None:
    program = driver(pty_board, "pass")
    assert has_driven(pty_board)
    program.send_signal(signal.SIGTERM)

    assert program.wait(TIMEOUT) == 3
    assert until(lambda: not pty_board.board.is_driving)
