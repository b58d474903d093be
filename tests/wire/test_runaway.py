"""A stop that fails is known and reported: the wheels are watched after everything that can be done."""

from __future__ import annotations

import pytest

from devices.ports.robot import LinkNotice
from devices.wire.frames import FILLER, STOP, MotorDrive, Wiring, drive_frame
from devices.wire.link_state import LinkConfig
from devices.wire.outbox import Outbox, StopSequence
from tests.wire.bench import Bench


def deaf_while_driving() -> Bench:
    """Its board has no reset wire."""
    bench = Bench(resets_on_open=False)
    bench.drive(0.5)
    bench.board.is_deaf = True
    return bench


def test_wheels_that_turn_after_every_stage_are_reported_once() -> None:
    bench = deaf_while_driving()

    bench.link.stop()
    bench.link.advance(5.0)

    assert bench.board.is_driving
    assert bench.link.has_run_away
    assert bench.notices == [LinkNotice.CONNECTED, LinkNotice.RUNAWAY]


def test_the_stops_are_repeated_after_that_and_end_when_the_board_obeys() -> None:
    bench = deaf_while_driving()
    bench.link.stop()
    bench.link.advance(3.0)

    bench.board.is_deaf = False
    bench.link.advance(1.0)

    assert not bench.board.is_driving
    assert not bench.link.has_run_away
    asked = bench.link.now()
    bench.drive(0.3)
    bench.link.stop()
    bench.link.advance(1.0)
    assert STOP in bench.sent_since(asked)
    assert bench.notices == [LinkNotice.CONNECTED, LinkNotice.RUNAWAY]


def test_a_board_that_its_reset_wire_stops_has_not_run_away() -> None:
    bench = Bench()
    bench.drive(0.5)
    bench.board.wire.cut = 1.0

    bench.link.stop()
    bench.link.advance(1.5)

    assert not bench.board.is_driving
    assert LinkNotice.RUNAWAY not in bench.notices


def test_a_silent_board_has_not_run_away() -> None:
    bench = Bench(resets_on_open=False)
    bench.drive(0.5)
    bench.board.is_mute = True

    bench.link.stop()
    bench.link.advance(5.0)

    assert not bench.link.has_run_away
    assert bench.notices == [LinkNotice.CONNECTED, LinkNotice.LOST]


@pytest.mark.parametrize("is_deaf", [True, False])
def test_waiting_for_a_stop_says_whether_the_robot_stands(is_deaf: bool) -> None:
    bench = Bench(resets_on_open=False)
    bench.drive(0.5)
    bench.board.is_deaf = is_deaf
    bench.link.stop()
    began = bench.link.now()

    assert bench.link.await_stop() is not is_deaf
    assert bench.link.now() - began < (2.0 if is_deaf else 0.3)


def test_a_connection_lost_in_a_drive_is_known_until_the_board_was_stopped() -> None:
    bench = Bench(resets_on_open=False)
    bench.drive(0.5)
    assert not bench.link.may_drive_on

    bench.link.is_plugged = False
    bench.link.advance(1.0)
    assert bench.link.may_drive_on

    bench.link.is_plugged = True
    bench.link.advance(2.0)
    assert not bench.link.may_drive_on
    assert not bench.board.is_driving


@pytest.mark.parametrize("seconds", [0.7, 3.0])
@pytest.mark.parametrize("is_deaf", [True, False])
def test_a_robot_that_comes_back_driving_has_run_away_only_if_it_does_not_obey(
    seconds: float, is_deaf: bool
) -> None:
    bench = Bench(resets_on_open=False)
    bench.drive(0.5)
    bench.link.is_plugged = False
    bench.link.advance(seconds)
    bench.board.is_deaf = is_deaf
    bench.link.is_plugged = True
    bench.link.advance(4.0)

    assert bench.board.is_driving is is_deaf
    assert bench.notices == [
        LinkNotice.CONNECTED,
        LinkNotice.LOST,
        LinkNotice.RESTORED,
        *([LinkNotice.RUNAWAY] if is_deaf else []),
    ]


def test_a_robot_that_ran_away_and_was_switched_off_has_not_run_away_any_more() -> None:
    bench = deaf_while_driving()
    bench.link.stop()
    bench.link.advance(3.0)
    assert bench.link.has_run_away

    bench.link.is_plugged = False
    bench.link.advance(1.0)

    assert not bench.link.has_run_away


def test_a_connection_lost_while_the_robot_stands_needs_no_guard() -> None:
    bench = Bench(resets_on_open=False)
    bench.link.is_plugged = False
    bench.link.advance(1.0)

    assert not bench.link.may_drive_on


def test_reversed_motors_get_the_other_directions_and_a_stop_stays_a_stop() -> None:
    """The directions of the frames are those of the firmware: 0F and F0."""
    reversed_left = Wiring(motors=(1, -1))

    assert drive_frame(MotorDrive.FORWARD, reversed_left)[4:8] == bytes((0x0F, 0x7F, 0x0F, 0x7F))
    assert drive_frame(MotorDrive.RIGHT, reversed_left)[4:8] == bytes((0xF0, 0x66, 0x0F, 0x66))
    assert drive_frame(MotorDrive.STOP, Wiring(motors=(-1, -1))) == STOP


def test_a_direction_byte_that_is_not_0f_is_the_other_one_as_the_firmware_reads_it() -> None:
    bench = Bench()
    bench.board.receive(bytes.fromhex("aabb05280f7f557fdd"))
    bench.link.advance(0.1)

    right, left = bench.board.wheels.right, bench.board.wheels.left
    assert right > 0
    assert left == right


@pytest.mark.parametrize(("last_count", "has_failed"), [(0.3, True), (0.2, False)])
def test_wheels_have_run_away_if_they_counted_in_the_last_half_of_the_watch(
    last_count: float, has_failed: bool
) -> None:
    """The frames of a board, or the program that reads them, may have to wait for their turn."""
    config = LinkConfig(runaway=0.5)
    stopping = StopSequence(config, Outbox(config))
    stopping.begin(0.0, was_driving=True)
    forced = [now for now in (0.5, 1.0) if stopping.must_force(now, now, now)]
    stopping.forced(1.0)

    stopping.must_force(1.5, 1.0 + last_count, 1.0 + last_count)

    assert forced == [1.0]
    assert stopping.is_exhausted
    assert stopping.has_failed is has_failed


EXACT = LinkConfig(still=0.125, stop_again=0.125, runaway=0.5, gap=0.0625, repeat=9.0)
"""Times that binary numbers hold exactly."""


def begun() -> tuple[StopSequence, Outbox]:
    """A stop at 0 s, whose two frames were sent."""
    outbox = Outbox(EXACT)
    stopping = StopSequence(EXACT, outbox)
    stopping.begin(0.0, was_driving=True)
    assert [outbox.due(0.0), outbox.due(0.0625)] == [STOP, STOP]
    return stopping, outbox


def test_a_robot_that_did_not_drive_is_sent_stops_and_not_watched() -> None:
    outbox = Outbox(EXACT)
    stopping = StopSequence(EXACT, outbox)
    stopping.begin(0.0, was_driving=False)

    assert (outbox.has_stops, stopping.is_over, stopping.next_at()) == (True, True, None)


@pytest.mark.parametrize(
    ("now", "received", "moved", "stands"),
    [
        (0.25, 0.25, 0.125, True),
        (0.25, 0.125, 0.12, False),  # the last frame is old
        (0.249, 0.125, 0.0, True),
        (0.25, 0.25, 0.126, False),  # a wheel has counted
        (0.24, 0.124, 0.0, False),  # no frame since the stop but at once
    ],
)
def test_wheels_stand_if_fresh_frames_have_not_counted_for_a_while(
    now: float, received: float, moved: float, stands: bool
) -> None:
    stopping, _ = begun()

    assert stopping.must_force(now, received, moved) is False
    assert stopping.is_over is stands


def test_a_stop_is_repeated_until_the_wheels_stand() -> None:
    stopping, outbox = begun()
    assert stopping.next_at() == 0.125
    stopping.must_force(0.124, 0.12, 0.12)
    assert outbox.due(0.125) is None
    stopping.must_force(0.125, 0.12, 0.12)
    assert outbox.due(0.125) == STOP
    assert stopping.next_at() == 0.25
    stopping.begin(0.2, was_driving=True)  # as if it were not stopping yet
    assert stopping.next_at() == 0.25
    stopping.cancel()
    assert (stopping.is_over, stopping.next_at()) == (True, None)


@pytest.mark.parametrize(("moved", "has_failed"), [(1.751, True), (1.75, False)])
def test_zeros_then_force_then_nothing_more_can_be_done(moved: float, has_failed: bool) -> None:
    stopping, outbox = begun()

    def look(now: float) -> bool:
        return stopping.must_force(now, now, now)

    assert (look(0.499), outbox.due(0.499)) == (False, STOP)
    assert (look(0.5), outbox.due(0.5), outbox.has_stops) == (False, FILLER, True)
    assert not look(0.999)
    assert (look(1.0), outbox.due(1.0)) == (True, FILLER)
    stopping.forced(1.5)
    assert (look(1.999), stopping.is_exhausted) == (False, False)
    assert stopping.next_at() == 2.0
    assert stopping.must_force(2.0, 1.0, moved) is False
    assert (stopping.is_exhausted, stopping.has_failed, stopping.is_over) == (True, has_failed, False)
    assert stopping.next_at() == 1.999 + 0.125
    stopping.lost()
    assert (stopping.is_exhausted, stopping.has_failed) == (True, False)
    assert (look(2.1), stopping.has_failed) == (False, True)  # a wheel counts again
    assert (look(9.0), stopping.has_failed) == (False, True)
    stopping.restart(10.0)
    assert (stopping.is_exhausted, look(10.4), outbox.is_empty) == (False, False, False)
    assert (look(10.5), look(11.0)) == (False, True)
    assert stopping.must_force(11.2, 11.2, 11.0) is False
    assert stopping.is_over
    stopping.restart(12.0)
    assert stopping.is_over
