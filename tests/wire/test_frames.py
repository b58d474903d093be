"""What the link receives: frames among text and garbage, counts that wrap or are torn, the battery, a ping.

Each test is named after its row of the table of weaknesses in docs/wire-protocol.md. Time is virtual.
"""

from __future__ import annotations

from devices.ports.robot import LinkNotice
from devices.wire.frames import PING, encode_frame
from devices.wire.telemetry import WheelCounter
from tests.wire.bench import Bench, streaming

# --- parse and garbage


def test_parse_text_between_the_frames_goes_to_the_log_and_loses_no_frame() -> None:
    bench = Bench()
    before = bench.link.telemetry

    bench.drive(0.3)

    assert {"FOUND S0", "Payload reveived", "Checksum success!"} <= set(bench.texts)
    assert bench.link.telemetry.bad_frames == before.bad_frames == 0


def test_garbage_bad_frames_are_counted_and_not_reported() -> None:
    bench = Bench()
    bench.link.wire.noise = 0.002

    bench.drive(3.0)

    assert bench.link.telemetry.bad_frames > 10
    assert (bench.is_up, bench.notices) == (True, [LinkNotice.CONNECTED])


def test_garbage_one_frame_with_a_bumper_is_ignored_and_two_count() -> None:
    connection = streaming()
    pressed, free = (encode_frame(0x42, bytes((6, 0, n, 0, 0, 0, 0))) for n in (1, 0))

    believed = []
    for report in (pressed, free, pressed, pressed, free, free):
        connection.received(report, 1.0)
        believed.append(connection.telemetry.bumpers[1])

    assert believed == [False, False, False, True, True, False]


# --- ticks


def counted(*raw: int) -> int:
    counter = WheelCounter(60)
    for each in raw:
        counter.count(each)
    return counter.total


def test_ticks_continue_where_the_boards_counter_wraps() -> None:
    assert counted(32760, 32767, -32768, -32710) == 66
    assert counted(-32760, -32768, 32767) == -9


def test_ticks_of_a_torn_frame_are_not_counted() -> None:
    counter = WheelCounter(60)

    assert [counter.count(raw) for raw in (100, 104, 362, 108, 112)] == [0, 4, 0, 4, 4]


def test_ticks_of_a_jump_that_a_second_frame_confirms_are_counted() -> None:
    assert counted(0, 200, 205) == 205


def test_ticks_make_no_jump_after_a_restart() -> None:
    bench = Bench()
    bench.drive(1.0)
    bench.link.stop()
    bench.link.advance(0.5)
    before = bench.link.telemetry

    bench.board.reset()
    bench.link.advance(3.0)

    after = bench.link.telemetry
    assert bench.is_up
    assert (after.right, after.left) == (before.right, before.left)
    assert after.epoch > before.epoch


def test_ticks_make_no_jump_after_a_restart_that_was_too_short_for_a_silence() -> None:
    connection = streaming()
    for frame in (
        encode_frame(0x81, bytes(8)),
        encode_frame(0x81, bytes((0, 50) * 2 + (0, 0) * 2)),
        encode_frame(0xC7, b"\x2b"),
        *[encode_frame(0x81, bytes(8))] * 3,
    ):
        connection.received(frame, 1.1)

    assert (connection.telemetry.right, connection.telemetry.left) == (50, 50)


def test_ticks_that_are_torn_while_driving_leave_the_count_right() -> None:
    bench = Bench()
    for _ in range(10):
        bench.board.is_torn = True
        bench.drive(0.1)
    bench.link.stop()
    bench.link.advance(0.5)

    assert bench.link.telemetry.right == int(bench.board.wheels.right)


def test_ranges_of_before_a_loss_are_forgotten() -> None:
    """A person may have carried the robot: what was far may be near now."""
    bench = Bench()
    bench.link.advance(1.0)
    assert bench.link.telemetry.ranges

    bench.board.is_mute = True
    bench.link.advance(0.6)

    assert bench.notices == [LinkNotice.CONNECTED, LinkNotice.LOST]
    assert bench.link.telemetry.ranges == ()


# --- battery and ping


def test_a_low_battery_is_reported_once_until_it_is_charged() -> None:
    bench = Bench()
    for millivolts in (8000, 7000, 7200, 6900, 7500, 7000):
        bench.board.millivolts = millivolts
        bench.link.advance(1.5)

    assert bench.notices == [LinkNotice.CONNECTED, LinkNotice.BATTERY_LOW, LinkNotice.BATTERY_LOW]
    assert bench.link.telemetry.millivolts == 7000


def test_garbage_one_frame_with_a_low_battery_is_ignored_and_two_count() -> None:
    connection = streaming()
    seen: list[tuple[int | None, int]] = []
    for millivolts in (8000, 8000, 6000, 8000, 6000, 6000):
        connection.received(encode_frame(0x66, millivolts.to_bytes(2, "little")), 1.0)
        seen.append((connection.telemetry.millivolts, len(connection.take_notices())))

    believed = [millivolts for millivolts, _ in seen]
    assert believed == [None, 8000, 8000, 8000, 8000, 6000]
    assert [notices for _, notices in seen[1:]] == [0, 0, 0, 0, 1]


def test_a_ping_of_the_board_is_answered() -> None:
    bench = Bench()
    bench.link.advance(2.5)

    assert PING in bench.sent_since(0.0)
