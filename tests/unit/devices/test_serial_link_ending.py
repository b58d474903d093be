"""However a line to a robot ends, the last word is a stop: shut down, its thread or its process gone."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import termios
import threading
from collections.abc import Iterator

import pytest

from devices.firmware_double.on_pty import DoubleOnPty
from devices.ports.robot import LinkNews
from devices.serial_link import SerialLink
from devices.serial_link.port import OpenPort
from devices.wire.commands import STOP, Drive, motors
from devices.wire.link_config import LinkConfig
from devices.wire.link_state import LinkState
from tests.conftest import ROOT
from tests.patience import PATIENCE
from tests.unit.devices.test_serial_link import FAR, HALF_A_FRAME, News, started, until


@pytest.fixture
def double() -> Iterator[DoubleOnPty]:
    with DoubleOnPty(started()) as it:
        yield it


@pytest.fixture
def link(double: DoubleOnPty) -> Iterator[SerialLink]:
    it = SerialLink(double.path)
    it.connect()
    yield it
    it.close()


def test_shutdown_leaves_two_stops_as_the_last_words(double: DoubleOnPty) -> None:
    link = SerialLink(double.path)
    link.connect()
    link.drive(link.permit(), Drive.FORWARD, FAR)
    assert until(lambda: double.board.is_driving)

    link.close()

    assert until(lambda: not double.board.is_driving)
    assert double.heard.endswith(STOP + STOP)
    assert link.state is LinkState.CLOSED


def test_shutdown_the_last_word_is_a_stop_although_the_boards_buffer_had_no_room_for_one(
    double: DoubleOnPty,
) -> None:
    """It reads nothing any more, by the line's own account: after the first drive no frame fits."""
    link = SerialLink(double.path, LinkConfig(bytes_a_second=0.0, most_outstanding=56))
    link.connect()
    link.drive(link.permit(), Drive.FORWARD, FAR)
    assert until(lambda: double.board.is_driving)

    link.close()

    assert until(lambda: not double.board.is_driving)
    assert double.heard.endswith(STOP)


def test_shutdown_in_the_middle_of_half_a_frame_waits_until_the_wheels_stand(double: DoubleOnPty) -> None:
    """The board takes the stops for the rest of a frame of fifty bytes."""
    link = SerialLink(double.path)
    link.connect()
    link.drive(link.permit(), Drive.FORWARD, FAR)
    assert until(lambda: double.board.is_driving)
    double.disturb(HALF_A_FRAME)

    link.close()

    assert not double.board.is_driving


def test_shutdown_of_a_line_that_was_lost_ends(double: DoubleOnPty) -> None:
    news = News()
    link = SerialLink(double.path, LinkConfig(reopen=1000.0), news)
    link.connect()
    link.drive(link.permit(), Drive.FORWARD, FAR)
    double.unplug()
    assert news.wait_for(LinkNews.LOST)

    link.close()

    assert link.state is LinkState.CLOSED


def test_a_thread_that_is_gone_leaves_no_motor_on(double: DoubleOnPty, link: SerialLink) -> None:
    """Nobody renews what it drove."""
    gone = threading.Thread(target=lambda: link.drive(link.permit(), Drive.LEFT, FAR))
    gone.start()
    gone.join()

    assert until(lambda: double.board.is_driving)
    assert until(lambda: not double.board.is_driving)


def test_process_killed_the_hang_up_flag_of_the_port_is_left_alone(double: DoubleOnPty) -> None:
    """With it, the system drops DTR when a program is killed, which resets the next board that is opened."""
    fd = os.open(double.path, os.O_RDWR | os.O_NOCTTY)
    settings = termios.tcgetattr(fd)
    settings[2] |= termios.HUPCL
    termios.tcsetattr(fd, termios.TCSANOW, settings)
    port = OpenPort(double.path)
    flags = termios.tcgetattr(fd)[2]
    port.close()
    os.close(fd)

    assert flags & termios.HUPCL


DRIVER = """
import select, signal, sys, time
from devices.serial_link import SerialLink
from devices.wire.commands import Drive
link = SerialLink(sys.argv[1]); link.connect()
signal.signal(signal.SIGTERM, lambda *_: (link.close(), sys.exit(3)))
ends = time.monotonic() + 60
while time.monotonic() < ends:
    link.drive(link.permit(), Drive.FORWARD, 1e9)
    {then}
    time.sleep(0.02)
"""


def driver(double: DoubleOnPty, then: str) -> subprocess.Popen[str]:
    """A program that drives, and does something else at the same time."""
    code = [sys.executable, "-c", DRIVER.format(then=then), double.path]
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
def test_a_program_that_ends_in_the_middle_of_a_drive_stops_the_robot(double: DoubleOnPty, then: str) -> None:
    program = driver(double, then)
    assert until(lambda: motors(Drive.FORWARD) in double.heard)
    assert program.stdin is not None
    program.stdin.close()  # it may end now
    assert program.wait(PATIENCE) is not None

    assert until(lambda: not double.board.is_driving)


def test_process_killed_it_leaves_a_robot_that_the_next_one_stops(double: DoubleOnPty) -> None:
    program = driver(double, "pass")
    assert until(lambda: double.board.is_driving)
    program.send_signal(signal.SIGKILL)
    program.wait(PATIENCE)
    assert double.board.is_driving

    link = SerialLink(double.path)
    link.connect()

    assert not double.board.is_driving
    link.close()


def test_a_signals_handler_may_close_the_link_in_the_midst_of_anything(double: DoubleOnPty) -> None:
    program = driver(double, "pass")
    assert until(lambda: double.board.is_driving)
    program.send_signal(signal.SIGTERM)

    assert program.wait(PATIENCE) == 3
    assert until(lambda: not double.board.is_driving)
