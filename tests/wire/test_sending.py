"""What the link sends: as fast as the board reads, again where it is lost, and a stop before everything else.

Each test is named after its row of the table of weaknesses in docs/wire-protocol.md. Time is virtual.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import inf

import pytest

from devices.wire.frames import CONFIGURE, FILLER, STOP, MotorDrive, drive_frame, head_frame
from devices.wire.link_state import LinkConfig
from devices.wire.outbox import Outbox
from tests.wire.bench import FAR, HALF_A_FRAME, Bench

# --- rate


def test_rate_frames_are_forty_milliseconds_apart_and_fit_the_boards_buffer() -> None:
    bench = Bench()
    began = bench.link.now()
    permit = bench.link.permit()

    for n in range(300):
        bench.link.drive(permit, (MotorDrive.LEFT, MotorDrive.RIGHT)[n % 2], FAR)
        bench.link.put(head_frame(n % 180))
        bench.link.advance(0.01)

    times = [at for at, _ in bench.written if at > began]
    assert min(b - a for a, b in pairwise(times)) >= 0.04 - 1e-9


def test_rate_the_board_loses_no_frame_while_drives_change_all_the_time() -> None:
    bench = Bench()
    permit = bench.link.permit()
    for n in range(500):
        bench.link.drive(permit, (MotorDrive.LEFT, MotorDrive.RIGHT)[n % 2], FAR)
        bench.link.advance(0.01)
    bench.link.stop()
    bench.link.advance(0.3)

    assert bench.texts.count("Checksum success!") == len(bench.written)
    assert "Checksum Error!" not in bench.texts


def test_rate_never_more_than_the_boards_buffer_is_outstanding() -> None:
    outbox = Outbox(LinkConfig())
    outbox.flush()
    sent, unread = [], 0.0
    for step in range(200):
        outbox.drive(MotorDrive.LEFT, step * 0.001)
        outbox.stop()
        if wanted := outbox.due(step * 0.001):
            sent.append(wanted)
            unread += len(wanted)
        assert unread <= 63
        unread = max(0.0, unread - 0.7)
    assert sent.count(STOP) >= 2


def test_rate_of_drives_that_wait_only_the_newest_is_sent() -> None:
    bench = Bench()
    bench.drive(0.1, MotorDrive.FORWARD)
    began = bench.link.now()
    permit = bench.link.permit()
    for drive in (MotorDrive.LEFT, MotorDrive.RIGHT, MotorDrive.BACKWARD):
        bench.link.drive(permit, drive, FAR)
    bench.link.advance(0.1)

    sent = bench.sent_since(began)
    assert drive_frame(MotorDrive.BACKWARD) in sent
    assert drive_frame(MotorDrive.LEFT) not in sent
    assert drive_frame(MotorDrive.RIGHT) not in sent


def test_rate_a_stop_precedes_all_other_frames_and_drops_the_drive() -> None:
    bench = Bench()
    bench.drive(0.1)
    bench.link.put(head_frame(10))
    bench.link.drive(bench.link.permit(), MotorDrive.LEFT, FAR)
    began = bench.link.now()

    bench.link.stop()
    bench.link.advance(1.0)

    assert bench.sent_since(began)[0] == STOP
    assert drive_frame(MotorDrive.LEFT) not in bench.sent_since(began)
    assert head_frame(10) in bench.sent_since(began)


def test_rate_a_frame_waits_until_the_board_has_room_for_it() -> None:
    """Seven stops of nine bytes are 63."""
    outbox = Outbox(LinkConfig(bytes_a_second=9.0))
    sent = []
    for now in [0.0] * 8 + [0.9, 1.0]:
        outbox.drive(MotorDrive.LEFT, now)
        outbox.stop()
        sent.append(outbox.due(now))

    assert sent == [STOP] * 7 + [None, None, STOP]


EXACT = LinkConfig(gap=0.0625, repeat=0.25, flush_pause=0.125, bytes_a_second=512.0)
"""Times that binary numbers hold exactly."""
FORWARD, LEFT = drive_frame(MotorDrive.FORWARD), drive_frame(MotorDrive.LEFT)


def written(outbox: Outbox, *times: float) -> list[bytes | None]:
    return [outbox.due(now) for now in times]


def test_rate_of_each_kind_the_newest_frame_is_sent_when_it_is_time() -> None:
    outbox = Outbox(EXACT)
    assert (outbox.is_empty, outbox.next_at(5.0), outbox.due(5.0)) == (True, inf, None)
    outbox.put(head_frame(10))
    outbox.put(head_frame(20))
    assert (outbox.is_empty, outbox.next_at(5.0)) == (False, 5.0)
    assert written(outbox, 5.0, 5.0625) == [head_frame(20), None]
    assert (outbox.is_empty, outbox.next_at(6.0)) == (True, inf)


@pytest.mark.parametrize("request_of", [Outbox.flush, Outbox.configure, Outbox.stop])
def test_rate_an_outbox_with_one_request_is_not_empty(request_of: Callable[[Outbox], None]) -> None:
    outbox = Outbox(EXACT)
    request_of(outbox)
    assert (outbox.is_empty, outbox.next_at(5.0)) == (False, 5.0)


def test_rate_zeros_and_the_configuration_precede_a_stop() -> None:
    outbox = Outbox(EXACT)
    outbox.put(head_frame(10))
    outbox.stop()
    outbox.configure()
    outbox.flush()
    assert written(outbox, 1.0, 1.124) == [FILLER, None]
    assert outbox.next_at(1.0) == 1.125
    assert written(outbox, 1.125, 1.1875, 1.249, 1.25) == [CONFIGURE, STOP, None, STOP]
    assert outbox.next_at(1.25) == 1.3125
    assert written(outbox, 1.312, 1.3125, 1.375) == [None, head_frame(10), None]


def test_rate_a_port_that_was_just_opened_is_sent_nothing_of_before() -> None:
    outbox = Outbox(EXACT)
    outbox.drive(MotorDrive.FORWARD, 1.0)
    assert outbox.due(1.0) == FORWARD
    for prepare in (outbox.flush, outbox.configure, outbox.stop):
        prepare()
    outbox.put(head_frame(10))
    outbox.clear()

    assert (outbox.is_empty, outbox.has_stops, outbox.due(9.0)) == (True, False, None)
    outbox.put(head_frame(20))
    assert outbox.due(1.01) == head_frame(20)


# --- lost command


def test_lost_command_a_drive_is_repeated_from_the_moment_it_was_sent() -> None:
    outbox = Outbox(EXACT)
    outbox.drive(MotorDrive.FORWARD, 1.0)
    assert (outbox.next_at(0.5), outbox.next_at(1.5)) == (1.0, 1.5)
    assert written(outbox, 0.99, 1.0, 1.249) == [None, FORWARD, None]
    assert outbox.next_at(1.0) == 1.25
    outbox.drive(MotorDrive.FORWARD, 1.1)  # the same is no new one
    assert written(outbox, 1.249, 1.25) == [None, FORWARD]
    outbox.repeat_soon()
    assert outbox.next_at(1.25) == 1.3125
    assert written(outbox, 1.3, 1.3125, 1.5) == [None, FORWARD, None]
    outbox.drive(MotorDrive.LEFT, 1.5)
    assert written(outbox, 1.5, 1.74, 1.75) == [LEFT, None, LEFT]


def test_lost_command_the_drive_is_repeated_every_two_tenths_of_a_second() -> None:
    bench = Bench()
    began = bench.link.now()

    bench.drive(2.0)

    again = [at for at, data in bench.written if at > began and data == drive_frame(MotorDrive.FORWARD)]
    assert len(again) == pytest.approx(10, abs=1)


def test_lost_command_a_drive_that_the_board_missed_is_repeated() -> None:
    bench = Bench()
    bench.board.wire.cut = 1.0
    bench.drive(0.1)
    bench.board.wire.cut = 0.0
    bench.board.receive(bytes(60))

    bench.drive(0.5)

    assert bench.board.is_driving


def test_lost_command_a_checksum_error_in_the_text_repeats_it_sooner() -> None:
    bench = Bench()
    bench.drive(0.1)
    began = bench.link.now()
    bench.board.receive(drive_frame(MotorDrive.FORWARD)[:-1] + b"\x00")

    bench.drive(0.1)

    assert drive_frame(MotorDrive.FORWARD) in bench.sent_since(began)


# --- stop and emergency stop


def test_stop_is_on_the_wire_within_fifty_milliseconds_whatever_else_is_sent() -> None:
    bench = Bench()
    for n in range(50):
        bench.drive(0.1 + n * 0.003, (MotorDrive.LEFT, MotorDrive.RIGHT)[n % 2])
        bench.link.put(head_frame(n))
        asked = bench.link.now()
        bench.link.stop()
        bench.link.advance(0.3)

        assert next(at for at, data in bench.written if at > asked and data == STOP) - asked <= 0.05


def test_stop_does_not_wait_for_the_gap_after_another_frame() -> None:
    bench = Bench()
    for drive in (MotorDrive.LEFT, MotorDrive.RIGHT, MotorDrive.FORWARD):
        began = bench.link.now()
        while drive_frame(drive) not in bench.sent_since(began):
            bench.drive(0.02, drive)
        asked = bench.link.now()
        bench.link.stop()
        bench.link.advance(0.5)

        assert next(at for at, data in bench.written if at > asked and data == STOP) - asked < 0.011


def test_stop_is_written_at_once_then_after_the_gap_and_then_repeated() -> None:
    outbox = Outbox(EXACT)
    outbox.put(head_frame(10))
    assert written(outbox, 1.0) == [head_frame(10)]
    outbox.stop()
    outbox.stop()
    assert (outbox.has_stops, outbox.next_at(1.01)) == (True, 1.01)
    assert written(outbox, 1.03125, 1.09) == [STOP, None]
    assert outbox.has_stops
    outbox.stop()  # two more, but the next one is not at once again
    assert outbox.next_at(1.04) == 1.09375
    assert written(outbox, 1.0937, 1.09375, 1.15, 1.15625) == [None, STOP, None, STOP]
    assert (outbox.has_stops, outbox.next_at(1.2)) == (False, 1.40625)
    assert written(outbox, 1.4, 1.40625, 1.65, 1.65625) == [None, STOP, None, STOP]


def test_stop_that_was_not_sent_is_replaced_by_a_drive() -> None:
    outbox = Outbox(EXACT)
    outbox.stop()
    outbox.drive(MotorDrive.LEFT, 1.0)

    assert not outbox.has_stops
    assert written(outbox, 1.0, 1.0625, 1.25) == [LEFT, None, LEFT]


def test_stop_is_sent_twice_at_least() -> None:
    bench = Bench()
    bench.drive(0.3)
    asked = bench.link.now()
    bench.link.stop()
    bench.link.advance(0.1)

    assert bench.sent_since(asked)[:2] == [STOP, STOP]


def test_stop_is_repeated_until_the_wheels_are_still_then_zeros_then_force() -> None:
    """The board receives nothing any more, but still sends."""
    bench = Bench()
    bench.drive(0.3)
    bench.board.wire.cut = 1.0
    resets = bench.board.resets
    asked = bench.link.now()

    bench.link.stop()
    bench.link.advance(0.6)
    assert FILLER in bench.sent_since(asked)
    assert (bench.board.resets, bench.board.is_driving) == (resets, True)
    bench.link.advance(0.6)

    assert (bench.board.resets, bench.board.is_driving) == (resets + 1, False)


def test_stop_that_was_lost_twice_is_repeated_within_a_tenth_of_a_second() -> None:
    bench = Bench()
    bench.drive(0.3)
    bench.board.wire.cut = 1.0
    bench.link.stop()
    bench.link.advance(0.05)
    bench.board.wire.cut = 0.0
    bench.board.receive(bytes(10))

    bench.link.advance(0.15)

    assert not bench.board.is_driving


def test_stop_after_half_a_frame_needs_no_more_than_the_zeros() -> None:
    bench = Bench()
    bench.drive(0.3)
    bench.board.receive(HALF_A_FRAME)
    resets = bench.board.resets

    bench.link.stop()
    bench.link.advance(1.0)

    assert (bench.board.is_driving, bench.board.resets) == (False, resets)


def test_stop_does_not_reset_a_robot_that_is_pushed() -> None:
    bench = Bench()
    resets = bench.board.resets
    bench.link.stop()
    for _ in range(100):
        bench.board.wheels.right += 5
        bench.link.advance(0.02)

    assert bench.board.resets == resets


def test_stop_makes_the_permit_of_an_earlier_drive_void() -> None:
    bench = Bench()
    permit = bench.link.permit()
    bench.link.drive(permit, MotorDrive.FORWARD, FAR)
    bench.link.stop()

    assert bench.link.drive(permit, MotorDrive.FORWARD, FAR) is False
    bench.link.advance(0.5)
    assert not bench.board.is_driving
