"""The line begins and ends with a robot that stands, whatever the board was in the midst of.

Each test is named after its row of the table of weaknesses in docs/wire-protocol.md. Time is virtual.
"""

from __future__ import annotations

import pytest

from devices.firmware_double.board import SimulatedBoard
from devices.firmware_double.faults import BadWire
from devices.firmware_double.virtual_line import VirtualLine
from devices.ports.robot import LinkNews, RobotProblem
from devices.wire.commands import CONFIGURE, FILLER, STOP, Drive, frame, motors
from devices.wire.connection import Connection
from devices.wire.link_config import LinkConfig
from devices.wire.link_state import LinkState
from tests.wire.bench import HALF_A_FRAME, Bench, board_that_drives_on


def adopt(board: SimulatedBoard) -> tuple[VirtualLine, list[tuple[float, bytes]]]:
    """A line to a board that streams already and is not reset by the port's opening."""
    line = VirtualLine(board, resets_on_open=False)
    line.written = written = []
    line.connect()
    return line, written


# --- open


def test_open_a_board_that_was_reset_is_configured_and_told_to_stop() -> None:
    bench = Bench()

    assert [data for _, data in bench.written][:3] == [CONFIGURE, STOP, STOP]
    assert (bench.is_up, bench.news) == (True, [LinkNews.CONNECTED])


def test_open_a_board_that_streams_already_gets_zeros_a_pause_configuration_and_stop() -> None:
    line, written = adopt(board_that_drives_on(HALF_A_FRAME))

    assert [data for _, data in written][:3] == [FILLER, CONFIGURE, STOP]
    assert len(FILLER) == 52
    assert written[1][0] - written[0][0] >= 0.1
    assert line.state is LinkState.STREAMING


def test_open_stops_a_robot_whose_program_is_gone_even_in_the_middle_of_a_frame() -> None:
    board = board_that_drives_on(HALF_A_FRAME)
    assert board.is_driving

    adopt(board)

    assert not board.is_driving


def test_open_without_an_answer_fails_after_six_seconds_and_lets_go_of_the_port() -> None:
    bench = Bench(connected=False)
    bench.board.is_mute = True

    with pytest.raises(RobotProblem) as told:
        bench.line.connect()

    assert (told.value.code, bench.line.state) == ("no-answer", LinkState.CLOSED)
    assert bench.line.now() == pytest.approx(6.0, abs=0.2)


def test_open_old_bytes_from_before_the_reset_are_not_taken_for_an_answer() -> None:
    connection = Connection(LinkConfig())
    connection.open(0.0)
    connection.opened(0.0)
    connection.received(frame(0x81, bytes(8)) * 50, 0.0)
    for now in (0.0, 0.1, 0.2, 0.3, 0.4, 0.5):
        connection.actions(now)

    assert connection.state is LinkState.WAITING


# --- shutdown


def test_shutdown_stops_twice_and_gives_it_a_tenth_of_a_second() -> None:
    bench = Bench()
    bench.drive(0.5)
    asked = bench.line.now()

    bench.line.close()

    assert bench.sent_since(asked)[:2] == [STOP, STOP]
    assert bench.line.now() - asked >= 0.1 - 1e-9
    assert (bench.board.is_driving, bench.line.state) == (False, LinkState.CLOSED)


# --- a full buffer, of the system's


def test_a_port_that_takes_nothing_is_lost_and_greeted_with_zeros_and_a_stop_when_it_does() -> None:
    bench = Bench(resets_on_open=False)
    bench.drive(0.3)
    bench.line.is_blocked = True
    bench.board.receive(motors(Drive.FORWARD)[:4])
    assert bench.drive(0.5) is False
    bench.line.is_blocked = False
    asked = bench.line.now()

    bench.line.advance(2.0)

    assert bench.sent_since(asked)[:3] == [FILLER, CONFIGURE, STOP]
    assert bench.news == [LinkNews.CONNECTED, LinkNews.LOST, LinkNews.RESTORED]
    assert not bench.board.is_driving


# --- shutdown


def test_shutdown_waits_until_a_board_in_the_middle_of_half_a_frame_stands() -> None:
    bench = Bench()
    bench.drive(0.5)
    bench.board.receive(HALF_A_FRAME)
    began = bench.line.now()

    bench.line.close()

    assert not bench.board.is_driving
    assert bench.line.now() - began < 1.3


def test_shutdown_of_a_robot_that_stands_takes_as_long_as_two_stops() -> None:
    bench = Bench()
    bench.line.advance(0.5)
    began = bench.line.now()

    bench.line.close()

    assert bench.sent_since(began) == [STOP, STOP]
    assert bench.line.now() - began < 0.1


def test_shutdown_of_a_board_that_hears_nothing_any_more_ends() -> None:
    bench = Bench()
    bench.drive(0.5)
    bench.line.wire = BadWire(cut=1.0, seed=1)
    bench.line.close()

    assert bench.line.state is LinkState.CLOSED
