"""What the driver does about each weakness of the original: the table of docs/wire-protocol.md, row by row.

Each test is named after its row. Time is virtual; the board is the simulated one.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import pytest

from devices.firmware_double.board import SimulatedBoard
from devices.firmware_double.faults import BadWire
from devices.firmware_double.surroundings import OpenFloor, Place, Switch
from devices.firmware_double.virtual_line import VirtualLine
from devices.ports.robot import LinkNews, RobotProblem
from devices.wire.commands import CONFIGURE, FILLER, PING, STOP, Drive, frame, head, motors
from devices.wire.connection import Connection
from devices.wire.link_config import LinkConfig
from devices.wire.link_state import TRANSITIONS, Happening, LinkState, following
from devices.wire.outbox import Outbox
from devices.wire.telemetry import WheelCounter
from tests.wire.bench import FAR, Bench, board_that_drives_on

HALF_A_FRAME = bytes.fromhex("aabb3228")
"""Announces fifty bytes, and swallows whatever comes next as them."""


def adopt(board: SimulatedBoard) -> tuple[VirtualLine, list[tuple[float, bytes]]]:
    """A line to a board that streams already and is not reset by the port's opening."""
    line = VirtualLine(board, resets_on_open=False)
    line.written = written = []
    line.connect()
    return line, written


class Touch(OpenFloor):
    """Presses what it is told to, whenever it is told to."""

    def __init__(self) -> None:
        self.pressed: frozenset[Switch] = frozenset()

    def touched(self, place: Place) -> frozenset[Switch]:
        return self.pressed


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


# --- parse and garbage


def test_parse_text_between_the_frames_goes_to_the_log_and_loses_no_frame() -> None:
    bench = Bench()
    before = bench.line.telemetry

    bench.drive(0.3)

    assert {"FOUND S0", "Payload reveived", "Checksum success!"} <= set(bench.texts)
    assert bench.line.telemetry.bad_frames == before.bad_frames == 0


def test_garbage_bad_frames_are_counted_and_nobody_is_told() -> None:
    bench = Bench()
    bench.line.wire.noise = 0.002

    bench.drive(3.0)

    assert bench.line.telemetry.bad_frames > 10
    assert (bench.is_up, bench.news) == (True, [LinkNews.CONNECTED])


def test_garbage_one_frame_with_a_bumper_is_not_believed_and_two_are() -> None:
    connection = streaming()
    pressed, free = (frame(0x42, bytes((6, 0, n, 0, 0, 0, 0))) for n in (1, 0))

    believed = []
    for told in (pressed, free, pressed, pressed, free, free):
        connection.received(told, 1.0)
        believed.append(connection.telemetry.bumpers[1])

    assert believed == [False, False, False, True, True, False]


def streaming() -> Connection:
    """As a Connection is once a board has answered, at second 1."""
    connection = Connection(LinkConfig())
    connection.open(0.0)
    connection.opened(0.0)
    connection.received(frame(0xC7, b"\x2b"), 0.1)
    for now in (0.1, 0.2, 0.3):
        connection.actions(now)
    connection.received(frame(0x81, bytes(8)), 1.0)
    assert connection.state is LinkState.STREAMING
    return connection


# --- ticks


def counted(*raw: int) -> int:
    counter = WheelCounter(60)
    for each in raw:
        counter.count(each)
    return counter.total


def test_ticks_go_on_where_the_boards_counter_wraps() -> None:
    assert counted(32760, 32767, -32768, -32710) == 66
    assert counted(-32760, -32768, 32767) == -9


def test_ticks_of_a_torn_frame_are_not_counted() -> None:
    counter = WheelCounter(60)

    assert [counter.count(raw) for raw in (100, 104, 362, 108, 112)] == [0, 4, 0, 4, 4]


def test_ticks_of_a_jump_that_a_second_frame_confirms_are_counted() -> None:
    assert counted(0, 200, 205) == 205


def test_ticks_begin_anew_after_a_restart_and_make_no_jump() -> None:
    bench = Bench()
    bench.drive(1.0)
    bench.line.stop()
    bench.line.advance(0.5)
    before = bench.line.telemetry

    bench.board.reset()
    bench.line.advance(3.0)

    after = bench.line.telemetry
    assert bench.is_up
    assert (after.right, after.left) == (before.right, before.left)
    assert after.era > before.era


def test_ticks_make_no_jump_after_a_restart_that_was_too_short_for_a_silence() -> None:
    connection = streaming()
    for told in (
        frame(0x81, bytes(8)),
        frame(0x81, bytes((0, 50) * 2 + (0, 0) * 2)),
        frame(0xC7, b"\x2b"),
        *[frame(0x81, bytes(8))] * 3,
    ):
        connection.received(told, 1.1)

    assert (connection.telemetry.right, connection.telemetry.left) == (50, 50)


def test_ticks_that_are_torn_while_driving_leave_the_count_right() -> None:
    bench = Bench()
    for _ in range(10):
        bench.board.is_torn = True
        bench.drive(0.1)
    bench.line.stop()
    bench.line.advance(0.5)

    assert bench.line.telemetry.right == int(bench.board.wheels.right)


# --- rate


def test_rate_frames_are_forty_milliseconds_apart_and_fit_the_boards_buffer() -> None:
    bench = Bench()
    began = bench.line.now()
    permit = bench.line.permit()

    for n in range(300):
        bench.line.drive(permit, (Drive.LEFT, Drive.RIGHT)[n % 2], FAR)
        bench.line.put(head(n % 180))
        bench.line.advance(0.01)

    times = [at for at, _ in bench.written if at > began]
    assert min(b - a for a, b in pairwise(times)) >= 0.04 - 1e-9


def test_rate_the_board_loses_no_frame_while_set_points_change_all_the_time() -> None:
    bench = Bench()
    permit = bench.line.permit()
    for n in range(500):
        bench.line.drive(permit, (Drive.LEFT, Drive.RIGHT)[n % 2], FAR)
        bench.line.advance(0.01)
    bench.line.stop()
    bench.line.advance(0.3)

    assert bench.texts.count("Checksum success!") == len(bench.written)
    assert "Checksum Error!" not in bench.texts


def test_rate_never_more_than_the_boards_buffer_is_outstanding() -> None:
    outbox = Outbox(LinkConfig())
    outbox.flush()
    sent, unread = [], 0.0
    for step in range(200):
        outbox.drive(Drive.LEFT, step * 0.001)
        outbox.stop()
        if wanted := outbox.due(step * 0.001):
            sent.append(wanted)
            unread += len(wanted)
        assert unread <= 63
        unread = max(0.0, unread - 0.7)
    assert sent.count(STOP) >= 2


def test_rate_of_set_points_that_wait_only_the_newest_is_sent() -> None:
    bench = Bench()
    bench.drive(0.1, Drive.FORWARD)
    began = bench.line.now()
    permit = bench.line.permit()
    for drive in (Drive.LEFT, Drive.RIGHT, Drive.BACKWARD):
        bench.line.drive(permit, drive, FAR)
    bench.line.advance(0.1)

    sent = bench.sent_since(began)
    assert motors(Drive.BACKWARD) in sent
    assert motors(Drive.LEFT) not in sent
    assert motors(Drive.RIGHT) not in sent


def test_rate_a_stop_goes_before_everything_that_waits_and_forgets_it() -> None:
    bench = Bench()
    bench.drive(0.1)
    bench.line.put(head(10))
    bench.line.drive(bench.line.permit(), Drive.LEFT, FAR)
    began = bench.line.now()

    bench.line.stop()
    bench.line.advance(1.0)

    assert bench.sent_since(began)[0] == STOP
    assert motors(Drive.LEFT) not in bench.sent_since(began)
    assert head(10) in bench.sent_since(began)


# --- lost command


def test_lost_command_the_set_point_is_said_again_every_two_tenths_of_a_second() -> None:
    bench = Bench()
    began = bench.line.now()

    bench.drive(2.0)

    again = [at for at, data in bench.written if at > began and data == motors(Drive.FORWARD)]
    assert len(again) == pytest.approx(10, abs=1)


def test_lost_command_a_drive_that_the_board_missed_happens_all_the_same() -> None:
    bench = Bench()
    bench.line.wire.cut = 1.0
    bench.drive(0.1)
    bench.line.wire.cut = 0.0
    bench.board.receive(bytes(60))

    bench.drive(0.5)

    assert bench.board.is_driving


def test_lost_command_a_checksum_error_in_the_text_brings_it_sooner() -> None:
    bench = Bench()
    bench.drive(0.1)
    began = bench.line.now()
    bench.board.receive(motors(Drive.FORWARD)[:-1] + b"\x00")

    bench.drive(0.1)

    assert motors(Drive.FORWARD) in bench.sent_since(began)


# --- stop and e-stop


def test_stop_is_on_the_wire_within_fifty_milliseconds_whatever_else_is() -> None:
    bench = Bench()
    for n in range(50):
        bench.drive(0.1 + n * 0.003, (Drive.LEFT, Drive.RIGHT)[n % 2])
        bench.line.put(head(n))
        asked = bench.line.now()
        bench.line.stop()
        bench.line.advance(0.3)

        assert next(at for at, data in bench.written if at > asked and data == STOP) - asked <= 0.05


def test_stop_does_not_wait_for_the_gap_after_another_frame() -> None:
    bench = Bench()
    for drive in (Drive.LEFT, Drive.RIGHT, Drive.FORWARD):
        began = bench.line.now()
        while motors(drive) not in bench.sent_since(began):
            bench.drive(0.02, drive)
        asked = bench.line.now()
        bench.line.stop()
        bench.line.advance(0.5)

        assert next(at for at, data in bench.written if at > asked and data == STOP) - asked < 0.011


def test_stop_is_sent_twice_at_least() -> None:
    bench = Bench()
    bench.drive(0.3)
    asked = bench.line.now()
    bench.line.stop()
    bench.line.advance(0.1)

    assert bench.sent_since(asked)[:2] == [STOP, STOP]


def test_stop_is_repeated_until_the_wheels_are_still_then_zeros_then_force() -> None:
    """The board hears nothing any more: its input is gone, its output is not."""
    bench = Bench()
    bench.drive(0.3)
    bench.line.wire.cut = 1.0
    resets = bench.board.resets
    asked = bench.line.now()

    bench.line.stop()
    bench.line.advance(0.6)
    assert FILLER in bench.sent_since(asked)
    assert (bench.board.resets, bench.board.is_driving) == (resets, True)
    bench.line.advance(0.6)

    assert (bench.board.resets, bench.board.is_driving) == (resets + 1, False)


def test_stop_that_was_lost_twice_is_said_again_within_a_tenth_of_a_second() -> None:
    bench = Bench()
    bench.drive(0.3)
    bench.line.wire.cut = 1.0
    bench.line.stop()
    bench.line.advance(0.05)
    bench.line.wire.cut = 0.0
    bench.board.receive(bytes(10))

    bench.line.advance(0.15)

    assert not bench.board.is_driving


def test_stop_after_half_a_frame_needs_no_more_than_the_zeros() -> None:
    bench = Bench()
    bench.drive(0.3)
    bench.board.receive(HALF_A_FRAME)
    resets = bench.board.resets

    bench.line.stop()
    bench.line.advance(1.0)

    assert (bench.board.is_driving, bench.board.resets) == (False, resets)


def test_stop_does_not_reset_a_robot_that_somebody_pushes() -> None:
    bench = Bench()
    resets = bench.board.resets
    bench.line.stop()
    for _ in range(100):
        bench.board.wheels.right += 5
        bench.line.advance(0.02)

    assert bench.board.resets == resets


def test_stop_makes_every_drive_void_that_was_asked_before() -> None:
    bench = Bench()
    permit = bench.line.permit()
    bench.line.drive(permit, Drive.FORWARD, FAR)
    bench.line.stop()

    assert bench.line.drive(permit, Drive.FORWARD, FAR) is False
    bench.line.advance(0.5)
    assert not bench.board.is_driving


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


def test_ranges_of_before_a_loss_are_forgotten() -> None:
    """Somebody may have carried the robot: what was far may be near now."""
    bench = Bench()
    bench.line.advance(1.0)
    assert bench.line.telemetry.ranges

    bench.board.is_mute = True
    bench.line.advance(0.6)

    assert bench.news == [LinkNews.CONNECTED, LinkNews.LOST]
    assert bench.line.telemetry.ranges == ()


# --- battery and ping


def test_the_battery_is_told_once_until_it_is_charged() -> None:
    bench = Bench()
    for millivolts in (8000, 7000, 7200, 6900, 7500, 7000):
        bench.board.millivolts = millivolts
        bench.line.advance(1.5)

    assert bench.news == [LinkNews.CONNECTED, LinkNews.BATTERY_LOW, LinkNews.BATTERY_LOW]
    assert bench.line.telemetry.millivolts == 7000


def test_garbage_one_frame_with_a_low_battery_is_not_believed_and_two_are() -> None:
    connection = streaming()
    told: list[tuple[int | None, int]] = []
    for millivolts in (8000, 8000, 6000, 8000, 6000, 6000):
        connection.received(frame(0x66, millivolts.to_bytes(2, "little")), 1.0)
        told.append((connection.telemetry.millivolts, len(connection.take_news())))

    believed = [millivolts for millivolts, _ in told]
    assert believed == [None, 8000, 8000, 8000, 8000, 6000]
    assert [news for _, news in told[1:]] == [0, 0, 0, 0, 1]


def test_a_ping_of_the_board_is_answered() -> None:
    bench = Bench()
    bench.line.advance(2.5)

    assert PING in bench.sent_since(0.0)


# --- the table of states

S, H = LinkState, Happening


@pytest.mark.parametrize(
    ("state", "happening", "leads_to"),
    [
        (S.CLOSED, H.OPEN, S.OPENING),
        (S.OPENING, H.OPENED, S.WAITING),
        (S.OPENING, H.FAILED, S.LOST),
        (S.WAITING, H.READY, S.STREAMING),
        (S.WAITING, H.SILENCE, S.LOST),
        (S.WAITING, H.FAILED, S.LOST),
        (S.STREAMING, H.RESTARTED, S.WAITING),
        (S.STREAMING, H.SILENCE, S.LOST),
        (S.STREAMING, H.FAILED, S.LOST),
        (S.LOST, H.OPEN, S.OPENING),
        (S.LOST, H.HEARD, S.WAITING),
        (S.LOST, H.RESTARTED, S.WAITING),
        *((state, H.CLOSE, S.CLOSED) for state in S),
    ],
)
def test_each_happening_leads_where_the_table_says(state: S, happening: H, leads_to: S) -> None:
    assert following(state, happening) is leads_to


def test_nothing_leads_from_lost_to_streaming_but_a_greeting() -> None:
    assert {happening for (state, happening), to in TRANSITIONS.items() if to is S.STREAMING} == {H.READY}
    assert {state for (state, _), to in TRANSITIONS.items() if to is S.STREAMING} == {S.WAITING}


@pytest.mark.parametrize("act", [lambda c: c.drive(0, Drive.FORWARD, FAR, 1.0), lambda c: c.stop(1.0)])
def test_a_closed_line_drives_nothing_and_needs_nothing(act: Callable[[Connection], object]) -> None:
    connection = Connection(LinkConfig())
    act(connection)

    assert (connection.driving_since, connection.actions(1.0)) == (None, [])
