"""A link begins and ends with a robot that stands, whatever the board was doing.

Each test is named after its row of the table of weaknesses in docs/wire-protocol.md. Time is virtual.
"""

from __future__ import annotations

import pytest

from devices.board_simulator.board import SimulatedBoard
from devices.board_simulator.robot import VirtualLink
from devices.ports.robot import LinkNotice, RobotProblem
from devices.wire.connection import BoardConnection
from devices.wire.frames import CONFIGURE, FILLER, STOP, MotorDrive, drive_frame, encode_frame
from devices.wire.link_state import LinkConfig, LinkState
from tests.noisy_wire import NoisyWire
from tests.wire.bench import HALF_A_FRAME, Bench, abandoned_board


def adopt(board: SimulatedBoard) -> tuple[VirtualLink, list[tuple[float, bytes]]]:
    """A link to a board that streams already and is not reset when the port is opened."""
    link = VirtualLink(board, resets_on_open=False)
    link.written = written = []
    link.connect()
    return link, written


# --- open


def test_open_a_board_that_was_reset_is_configured_and_stopped() -> None:
    bench = Bench()

    assert [data for _, data in bench.written][:3] == [CONFIGURE, STOP, STOP]
    assert (bench.is_up, bench.notices) == (True, [LinkNotice.CONNECTED])


def test_open_a_board_that_streams_already_gets_zeros_a_pause_configuration_and_stop() -> None:
    link, written = adopt(abandoned_board(HALF_A_FRAME))

    assert [data for _, data in written][:3] == [FILLER, CONFIGURE, STOP]
    assert len(FILLER) == 52
    assert written[1][0] - written[0][0] >= 0.1
    assert link.state is LinkState.STREAMING


def test_open_stops_an_abandoned_robot_even_in_the_middle_of_a_frame() -> None:
    board = abandoned_board(HALF_A_FRAME)
    assert board.is_driving

    adopt(board)

    assert not board.is_driving


def test_open_without_an_answer_fails_after_six_seconds_and_closes_the_port() -> None:
    bench = Bench(connected=False)
    bench.board.is_mute = True

    with pytest.raises(RobotProblem) as caught:
        bench.link.connect()

    assert (caught.value.code, bench.link.state) == ("no-answer", LinkState.CLOSED)
    assert bench.link.now() == pytest.approx(6.0, abs=0.2)


def test_open_old_bytes_from_before_the_reset_are_not_taken_for_an_answer() -> None:
    connection = BoardConnection(LinkConfig())
    connection.open()
    connection.opened(0.0)
    connection.received(encode_frame(0x81, bytes(8)) * 50, 0.0)
    for now in (0.0, 0.1, 0.2, 0.3, 0.4, 0.5):
        connection.actions(now)

    assert connection.state is LinkState.WAITING


# --- shutdown


def test_shutdown_sends_two_stops_and_waits_a_tenth_of_a_second() -> None:
    bench = Bench()
    bench.drive(0.5)
    asked = bench.link.now()

    bench.link.close()

    assert bench.sent_since(asked)[:2] == [STOP, STOP]
    assert bench.link.now() - asked >= 0.1 - 1e-9
    assert (bench.board.is_driving, bench.link.state) == (False, LinkState.CLOSED)


# --- a full buffer of the system


def test_a_port_that_accepts_nothing_is_lost_and_later_gets_zeros_and_a_stop() -> None:
    bench = Bench(resets_on_open=False)
    bench.drive(0.3)
    bench.link.is_blocked = True
    bench.board.receive(drive_frame(MotorDrive.FORWARD)[:4])
    assert bench.drive(0.5) is False
    bench.link.is_blocked = False
    asked = bench.link.now()

    bench.link.advance(2.0)

    assert bench.sent_since(asked)[:3] == [FILLER, CONFIGURE, STOP]
    assert bench.notices == [LinkNotice.CONNECTED, LinkNotice.LOST, LinkNotice.RESTORED]
    assert not bench.board.is_driving


# --- shutdown


def test_shutdown_waits_until_a_board_in_the_middle_of_half_a_frame_stands() -> None:
    bench = Bench()
    bench.drive(0.5)
    bench.board.receive(HALF_A_FRAME)
    began = bench.link.now()

    bench.link.close()

    assert not bench.board.is_driving
    assert bench.link.now() - began < 1.3


def test_shutdown_of_a_robot_that_stands_takes_as_long_as_two_stops() -> None:
    bench = Bench()
    bench.link.advance(0.5)
    began = bench.link.now()

    bench.link.close()

    assert bench.sent_since(began) == [STOP, STOP]
    assert bench.link.now() - began < 0.1


def test_shutdown_of_a_board_that_receives_nothing_ends() -> None:
    bench = Bench()
    bench.drive(0.5)
    bench.board.wire = NoisyWire(cut=1.0, seed=1)
    bench.link.close()

    assert bench.link.state is LinkState.CLOSED
