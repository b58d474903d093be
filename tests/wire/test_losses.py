"""A line that falls silent, is pulled out or restarts ends the drive; nothing goes on by itself.

Each test is named after its row of the table of weaknesses in docs/wire-protocol.md. Time is virtual.
"""

from __future__ import annotations

import pytest

from devices.ports.robot import LinkNews
from devices.wire.commands import CONFIGURE, FILLER, STOP, Drive, frame
from devices.wire.connection import Connection
from tests.wire.bench import FAR, Bench, streaming

# --- host watchdog


def test_host_watchdog_a_drive_that_nobody_renews_ends() -> None:
    """As when the program's thread was killed, or hangs."""
    bench = Bench()
    bench.drive(0.5)
    assert bench.board.is_driving

    bench.line.advance(0.5)

    assert not bench.board.is_driving


def test_host_watchdog_silence_is_a_lost_link_and_ends_the_drive() -> None:
    bench = Bench()
    bench.drive(0.5)
    bench.board.is_mute = True

    assert bench.drive(1.0) is False
    assert bench.news == [LinkNews.CONNECTED, LinkNews.LOST]
    bench.line.advance(0.1)
    assert not bench.board.is_driving


def test_host_watchdog_a_line_that_is_dead_both_ways_is_stopped_by_force() -> None:
    bench = Bench()
    bench.drive(0.5)
    bench.board.is_mute, bench.line.wire.cut = True, 1.0

    bench.drive(1.0)
    bench.line.advance(1.5)

    assert not bench.board.is_driving


def test_host_watchdog_a_short_pause_of_the_board_is_no_loss() -> None:
    bench = Bench()
    bench.board.is_mute = True
    bench.line.advance(0.4)
    bench.board.is_mute = False
    bench.line.advance(0.4)

    assert bench.news == [LinkNews.CONNECTED]


def test_host_watchdog_a_line_that_speaks_again_is_told_once_and_greeted_anew() -> None:
    bench = Bench()
    bench.board.is_mute = True
    bench.line.advance(2.0)
    lost_at = bench.line.now()
    bench.board.is_mute = False
    bench.line.advance(2.0)

    assert bench.news == [LinkNews.CONNECTED, LinkNews.LOST, LinkNews.RESTORED]
    assert bench.sent_since(lost_at)[-8:].count(STOP) > 0
    assert FILLER in bench.sent_since(lost_at)


def test_host_watchdog_the_wheels_stop_where_they_were_told_to_without_anybody_asking() -> None:
    bench = Bench()
    bench.drive(2.0, until=341.0)

    assert not bench.board.is_driving
    assert bench.board.wheels.right == pytest.approx(341 + 12, abs=10)


# --- unplug


def test_unplug_is_told_ends_the_drive_and_the_port_is_looked_for_until_it_is_back() -> None:
    bench = Bench()
    bench.drive(0.3)
    bench.line.is_plugged = False
    assert bench.drive(0.5) is False
    bench.line.advance(5.0)
    assert bench.news == [LinkNews.CONNECTED, LinkNews.LOST]

    bench.line.is_plugged = True
    bench.line.advance(4.0)

    assert bench.news == [LinkNews.CONNECTED, LinkNews.LOST, LinkNews.RESTORED]
    assert not bench.board.is_driving


def test_unplug_the_port_is_tried_again_within_a_second() -> None:
    bench = Bench()
    bench.line.is_plugged = False
    bench.line.advance(3.0)
    resets = bench.board.resets
    bench.line.is_plugged = True
    bench.line.advance(1.0)

    assert bench.board.resets == resets + 1


# --- replug, reset, brown-out


def test_reset_in_the_middle_of_a_drive_is_told_and_the_drive_is_forgotten() -> None:
    bench = Bench()
    bench.drive(0.5)
    bench.board.reset()
    bench.board.advance(0.4)

    assert bench.drive(2.0) is False
    bench.line.advance(3.0)

    assert bench.is_up
    assert not bench.board.is_driving
    assert bench.news == [LinkNews.CONNECTED, LinkNews.LOST, LinkNews.RESTARTED]


def test_reset_that_is_over_before_the_silence_is_a_loss_is_told_as_a_restart() -> None:
    connection = streaming()
    connection.take_news()
    connection.drive(connection.permit, Drive.FORWARD, FAR, 1.0)
    permit = connection.permit

    connection.received(frame(0xC7, b"\x2b"), 1.1)

    assert connection.take_news() == [(LinkNews.RESTARTED, "")]
    assert (connection.driving_since, connection.permit == permit) == (None, False)
    assert CONFIGURE in written_by(connection, 1.1, 1.4)


def written_by(connection: Connection, begins: float, ends: float) -> list[bytes]:
    times = [begins + n * 0.01 for n in range(round((ends - begins) / 0.01))]
    actions = [action for now in times for action in connection.actions(now)]
    return [data for action in actions if (data := getattr(action, "data", None))]


def test_reset_a_move_is_not_taken_up_again_when_the_board_is_back() -> None:
    bench = Bench()
    bench.drive(0.5)
    permit = bench.line.permit()
    bench.board.reset()
    bench.line.advance(5.0)

    assert bench.is_up
    assert bench.line.drive(permit, Drive.FORWARD, FAR) is False
    bench.line.advance(1.0)
    assert not bench.board.is_driving
