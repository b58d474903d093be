"""What the link sends: as fast as the board reads, again where it is lost, and a stop before everything else.

Each test is named after its row of the table of weaknesses in docs/wire-protocol.md. Time is virtual.
"""

from __future__ import annotations

from itertools import pairwise

import pytest

from devices.wire.frames import FILLER, STOP, MotorDrive, drive_frame, head_frame
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


# --- lost command


def test_lost_command_the_drive_is_repeated_every_two_tenths_of_a_second() -> None:
    bench = Bench()
    began = bench.link.now()

    bench.drive(2.0)

    again = [at for at, data in bench.written if at > began and data == drive_frame(MotorDrive.FORWARD)]
    assert len(again) == pytest.approx(10, abs=1)


def test_lost_command_a_drive_that_the_board_missed_is_repeated() -> None:
    bench = Bench()
    bench.link.wire.cut = 1.0
    bench.drive(0.1)
    bench.link.wire.cut = 0.0
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
    bench.link.wire.cut = 1.0
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
    bench.link.wire.cut = 1.0
    bench.link.stop()
    bench.link.advance(0.05)
    bench.link.wire.cut = 0.0
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
