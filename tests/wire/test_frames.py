"""What the link receives: frames among text and garbage, counts that wrap or are torn, the battery, a ping.

Each test is named after its row of the table of weaknesses in docs/wire-protocol.md. Time is virtual.
"""

from __future__ import annotations

import pytest

from devices.ports.robot import LinkNotice
from devices.wire.frames import PING, encode_frame
from devices.wire.link_state import LinkConfig
from devices.wire.telemetry import RangeSample, Telemetry, TelemetryTracker, WheelCounter, unwrapped
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
    bench.board.wire.noise = 0.002

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


@pytest.mark.parametrize(
    ("difference", "way"),
    [
        *((0, 0), (5, 5), (-5, -5), (32767, 32767), (32768, -32768), (-32768, -32768), (-32769, 32767)),
        *((65535, -1), (-65535, 1), (65536, 0)),
    ],
)
def test_ticks_that_wrapped_went_the_shorter_way(difference: int, way: int) -> None:
    assert unwrapped(difference) == way


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


# --- everything that is known of a board

FREE, PRESSED = (False,) * 6, (False, True, False, False, False, False)
METRE = (100,) * 7


def test_nothing_is_known_of_a_board_at_first() -> None:
    known = TelemetryTracker(LinkConfig()).telemetry(0.0, 0)
    assert known == Telemetry(
        at=0.0, epoch=0, right=0, left=0, counted_at=0.0, changed_at=0.0, both_moved_at=0.0, ranges=(),
        bumpers=FREE, millivolts=None, frames=0, bad_frames=0,
    )  # fmt: skip
    assert known == Telemetry()


def test_what_the_frames_of_a_board_say_is_known() -> None:
    tracker = TelemetryTracker(LinkConfig())
    tracker.count_wheels(100, 200, 1.0)  # where they begin
    tracker.count_wheels(110, 200, 2.0)
    tracker.add_ranges(METRE, 2.5)
    tracker.count_wheels(110, 197, 3.0)
    tracker.add_bumpers(PRESSED)
    tracker.add_bumpers(PRESSED)
    tracker.millivolts, tracker.frames = 7400, 6

    assert tracker.telemetry(4.0, 2) == Telemetry(
        at=4.0, epoch=0, right=10, left=-3, counted_at=3.0, changed_at=3.0, both_moved_at=2.0,
        ranges=(RangeSample(2.5, 10, 0, METRE),), bumpers=PRESSED, millivolts=7400, frames=6, bad_frames=2,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("counts", "changed_at", "both_moved_at"),
    [
        ([(0, 0), (0, 0)], 0.0, 0.0),
        ([(0, 0), (5, 0), (5, 0)], 1.0, 0.0),
        ([(0, 0), (0, 5), (0, 5)], 1.0, 0.0),
        ([(0, 0), (5, 5), (5, 5)], 1.0, 1.0),
        ([(0, 0), (5, 5), (5, 9)], 2.0, 1.0),
        ([(0, 0), (5, 5), (9, 5)], 2.0, 1.0),
    ],
)
def test_it_is_known_when_a_wheel_and_when_both_have_last_counted(
    counts: list[tuple[int, int]], changed_at: float, both_moved_at: float
) -> None:
    tracker = TelemetryTracker(LinkConfig())
    for now, (right, left) in enumerate(counts):
        tracker.count_wheels(right, left, float(now))

    known = tracker.telemetry(9.0, 0)
    assert (known.changed_at, known.both_moved_at) == (changed_at, both_moved_at)


@pytest.mark.parametrize(
    ("encoders", "counted"),
    [((1, 1), "10 20"), ((-1, 1), "-10 20"), ((1, -1), "10 -20"), ((-1, -1), "-10 -20")],
)
def test_counts_are_whole_and_have_the_senses_of_the_encoders(
    encoders: tuple[int, int], counted: str
) -> None:
    tracker = TelemetryTracker(LinkConfig())
    tracker.encoders = encoders
    tracker.count_wheels(0, 0, 1.0)
    tracker.count_wheels(10, 20, 2.0)

    known = tracker.telemetry(3.0, 0)
    assert f"{known.right} {known.left}" == counted


def test_after_a_restart_the_counts_go_on_and_all_else_is_forgotten() -> None:
    """Also of the last frames: one more of its kind is no confirmation."""
    tracker = TelemetryTracker(LinkConfig())
    for counts in ((0, 0), (10, 20), (5000, 6000)):
        tracker.count_wheels(*counts, 1.0)
    tracker.add_ranges(METRE, 1.0)
    for _ in range(2):
        tracker.add_bumpers(PRESSED)
    tracker.rebase()

    assert tracker.telemetry(2.0, 0) == Telemetry(
        at=2.0, epoch=1, right=10, left=20, counted_at=1.0, changed_at=1.0, both_moved_at=1.0
    )
    tracker.add_bumpers(PRESSED)
    tracker.count_wheels(5001, 6001, 3.0)
    tracker.count_wheels(5003, 6004, 3.0)
    known = tracker.telemetry(3.0, 0)
    assert (known.bumpers, known.right, known.left) == (FREE, 12, 23)
    tracker.rebase()
    assert tracker.telemetry(4.0, 0).epoch == 2


@pytest.mark.parametrize(
    ("times", "remembered"),
    [
        ([0.6, 0.8, 1.0], [0.6, 0.8, 1.0]),
        ([0.59, 0.8, 1.0], [0.8, 1.0]),
        ([1.0, 1.25, 1.5], [1.25, 1.5]),
        ([1.0, 1.25, 9.0], [9.0]),
    ],
)
def test_the_ranges_of_two_refreshes_are_remembered(times: list[float], remembered: list[float]) -> None:
    tracker = TelemetryTracker(LinkConfig())
    for at in times:
        tracker.add_ranges(METRE, at)

    assert [each.at for each in tracker.telemetry(9.0, 0).ranges] == remembered


def test_of_a_board_that_reports_too_often_sixty_four_ranges_are_remembered() -> None:
    tracker = TelemetryTracker(LinkConfig())
    for number in range(70):
        tracker.add_ranges((number,) * 7, 1.0)

    kept = tracker.telemetry(1.0, 0).ranges
    assert [each.centimetres[0] for each in kept] == [*range(6, 70)]


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
