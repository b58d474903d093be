"""What arrives: frames among text and garbage, counts that wrap or are torn, the battery, a ping.

Each test is named after its row of the table of weaknesses in docs/wire-protocol.md. Time is virtual.
"""

from __future__ import annotations

from devices.ports.robot import LinkNews
from devices.wire.commands import PING, frame
from devices.wire.telemetry import WheelCounter
from tests.wire.bench import Bench, streaming

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
