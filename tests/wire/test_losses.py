"""A board that falls silent, is unplugged or restarts ends the drive, and no drive resumes by itself.

Each test is named after its row of the table of weaknesses in docs/wire-protocol.md. Time is virtual.
"""

from __future__ import annotations

import pytest

from devices.ports.robot import LinkNotice
from devices.wire.connection import BoardConnection
from devices.wire.frames import CONFIGURE, FILLER, STOP, MotorDrive, encode_frame
from tests.wire.bench import FAR, Bench, streaming

# --- host watchdog


def test_host_watchdog_a_drive_that_is_not_renewed_ends() -> None:
    """As when the program's thread was killed, or hangs."""
    bench = Bench()
    bench.drive(0.5)
    assert bench.board.is_driving

    bench.link.advance(0.5)

    assert not bench.board.is_driving


def test_host_watchdog_silence_is_a_lost_link_and_ends_the_drive() -> None:
    bench = Bench()
    bench.drive(0.5)
    bench.board.is_mute = True

    assert bench.drive(1.0) is False
    assert bench.notices == [LinkNotice.CONNECTED, LinkNotice.LOST]
    bench.link.advance(0.1)
    assert not bench.board.is_driving


def test_host_watchdog_a_board_that_is_cut_off_both_ways_is_stopped_by_force() -> None:
    bench = Bench()
    bench.drive(0.5)
    bench.board.is_mute, bench.board.wire.cut = True, 1.0

    bench.drive(1.0)
    bench.link.advance(1.5)

    assert not bench.board.is_driving


def test_host_watchdog_a_short_pause_of_the_board_is_no_loss() -> None:
    bench = Bench()
    bench.board.is_mute = True
    bench.link.advance(0.4)
    bench.board.is_mute = False
    bench.link.advance(0.4)

    assert bench.notices == [LinkNotice.CONNECTED]


def test_host_watchdog_a_board_that_sends_again_is_reported_once_and_configured_again() -> None:
    bench = Bench()
    bench.board.is_mute = True
    bench.link.advance(2.0)
    lost_at = bench.link.now()
    bench.board.is_mute = False
    bench.link.advance(2.0)

    assert bench.notices == [LinkNotice.CONNECTED, LinkNotice.LOST, LinkNotice.RESTORED]
    assert bench.sent_since(lost_at)[-8:].count(STOP) > 0
    assert FILLER in bench.sent_since(lost_at)


def test_host_watchdog_the_wheels_stop_at_the_end_of_a_drive_by_themselves() -> None:
    bench = Bench()
    bench.drive(2.0, until=341.0)

    assert not bench.board.is_driving
    assert bench.board.wheels.right == pytest.approx(341 + 12, abs=10)


# --- unplug


def test_unplug_is_reported_ends_the_drive_and_the_port_is_retried_until_it_is_back() -> None:
    bench = Bench()
    bench.drive(0.3)
    bench.link.is_plugged = False
    assert bench.drive(0.5) is False
    bench.link.advance(5.0)
    assert bench.notices == [LinkNotice.CONNECTED, LinkNotice.LOST]

    bench.link.is_plugged = True
    bench.link.advance(4.0)

    assert bench.notices == [LinkNotice.CONNECTED, LinkNotice.LOST, LinkNotice.RESTORED]
    assert not bench.board.is_driving


def test_unplug_the_port_is_retried_within_a_second() -> None:
    bench = Bench()
    bench.link.is_plugged = False
    bench.link.advance(3.0)
    resets = bench.board.resets
    bench.link.is_plugged = True
    bench.link.advance(1.0)

    assert bench.board.resets == resets + 1


# --- replug, reset, brown-out


def test_reset_in_the_middle_of_a_drive_is_reported_and_the_drive_is_dropped() -> None:
    bench = Bench()
    bench.drive(0.5)
    bench.board.reset()
    bench.board.advance(0.4)

    assert bench.drive(2.0) is False
    bench.link.advance(3.0)

    assert bench.is_up
    assert not bench.board.is_driving
    assert bench.notices == [LinkNotice.CONNECTED, LinkNotice.LOST, LinkNotice.RESTARTED]


def test_reset_that_is_shorter_than_a_loss_is_reported_as_a_restart() -> None:
    connection = streaming()
    connection.take_notices()
    connection.drive(connection.permit, MotorDrive.FORWARD, FAR, 1.0)
    permit = connection.permit

    connection.received(encode_frame(0xC7, b"\x2b"), 1.1)

    assert connection.take_notices() == [(LinkNotice.RESTARTED, "")]
    assert (connection.driving_since, connection.permit == permit) == (None, False)
    assert CONFIGURE in written_by(connection, 1.1, 1.4)


def written_by(connection: BoardConnection, begins: float, ends: float) -> list[bytes]:
    times = [begins + n * 0.01 for n in range(round((ends - begins) / 0.01))]
    actions = [action for now in times for action in connection.actions(now)]
    return [data for action in actions if (data := getattr(action, "data", None))]


def test_reset_a_drive_does_not_resume_when_the_board_is_back() -> None:
    bench = Bench()
    bench.drive(0.5)
    permit = bench.link.permit()
    bench.board.reset()
    bench.link.advance(5.0)

    assert bench.is_up
    assert bench.link.drive(permit, MotorDrive.FORWARD, FAR) is False
    bench.link.advance(1.0)
    assert not bench.board.is_driving
