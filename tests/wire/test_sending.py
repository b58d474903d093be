"""What is sent: as fast as the board takes it, again where it is lost, and a stop before all else.

Each test is named after its row of the table of weaknesses in docs/wire-protocol.md. Time is virtual.
"""

from __future__ import annotations

from itertools import pairwise

import pytest

from devices.wire.commands import FILLER, STOP, Drive, head, motors
from devices.wire.link_config import LinkConfig
from devices.wire.outbox import Outbox
from tests.wire.bench import FAR, HALF_A_FRAME, Bench

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
