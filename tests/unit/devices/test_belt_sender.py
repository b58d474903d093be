"""What is sent to the belt and when: the newest levels, often enough, and never more."""

from __future__ import annotations

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from devices.belt import AFTER_RESYNC, HOLD, MOTORS, OFF, PERIOD, RESYNC, BeltSender, encode_frame
from tests.simulated_belt import SimulatedBelt

DARK = encode_frame(OFF)
FRONT = (0, 0, 0, 3, 0, 0, 0) * 2
LEVELS = st.tuples(*[st.integers(0, 3)] * MOTORS)


def awake() -> BeltSender:
    """A sender that has resynchronised, at second 0."""
    sender = BeltSender()
    assert sender.next(-1.0) == RESYNC
    return sender


def sent(sender: BeltSender, start: float, end: float) -> list[tuple[float, bytes]]:
    """Everything that it sends in that time, polled each millisecond."""
    moments = [start + each / 1000 for each in range(round((end - start) * 1000))]
    said = [(moment, sender.next(moment)) for moment in moments]
    return [(moment, data) for moment, data in said if data]


def test_a_frame_has_the_motors_in_its_second_and_fourth_row() -> None:
    levels = (1, 2, 3, 0, 0, 0, 3, 3, 0, 0, 0, 0, 2, 1)

    assert encode_frame(levels) == b"Z" + b"PPPPPPP" + b"CBAPPPA" + b"PPPPPPP" + b"APPPPBC" + b"PPPPPPP"


@pytest.mark.parametrize("levels", [(), (0,) * 13, (4,) * MOTORS, (-1,) * MOTORS])
def test_invalid_levels_are_refused(levels: tuple[int, ...]) -> None:
    with pytest.raises(ValueError, match="14 motors"):
        BeltSender().show(levels, 0.0)


def test_a_new_connection_begins_with_a_resync_and_silence() -> None:
    sender = BeltSender()
    sender.show(FRONT, 0.0)

    assert sent(sender, 0.0, AFTER_RESYNC + 0.005) == [(0.0, RESYNC), (AFTER_RESYNC, encode_frame(FRONT))]


def test_while_a_motor_is_on_a_frame_is_sent_every_40_milliseconds() -> None:
    sender = awake()
    sender.show(FRONT, 0.0)

    assert [moment for moment, _ in sent(sender, 0.0, 0.2)] == pytest.approx(
        [0.0, 0.04, 0.08, 0.12, 0.16], abs=0.0011
    )


def test_off_is_one_dark_frame_and_then_silence() -> None:
    sender = awake()
    sender.show(FRONT, 0.0)
    sender.next(0.0)
    sender.show(OFF, 1.0)

    assert [data for _, data in sent(sender, 1.0, 3.0)] == [DARK]
    assert sender.wait(3.0) is None


def test_a_belt_that_was_never_on_is_sent_nothing() -> None:
    sender = awake()
    sender.show(OFF, 0.0)

    assert sent(sender, 0.0, 1.0) == []


def test_only_the_newest_levels_are_sent() -> None:
    sender = awake()
    for number in range(500):
        sender.show((number % 3,) * MOTORS, number / 1000)
    sender.show(FRONT, 0.5)

    assert [data for _, data in sent(sender, 0.9, 0.95)] == [encode_frame(FRONT), encode_frame(FRONT)]


def test_a_pulse_of_no_length_is_felt_for_a_quarter_second() -> None:
    sender = awake()
    sender.show(FRONT, 0.0)
    sender.show(OFF, 0.0)

    frames = sent(sender, 0.0, 1.0)
    assert frames[-1][1] == DARK
    assert frames[-1][0] == pytest.approx(HOLD, abs=PERIOD + 0.002)
    assert {data for _, data in frames[:-1]} == {encode_frame(FRONT)}


def test_a_complaint_of_the_board_is_answered_with_a_resync() -> None:
    sender = awake()
    sender.show(FRONT, 0.0)
    sender.next(0.0)
    sender.receive(b"E2\r\n")

    assert [data for _, data in sent(sender, 0.04, 0.075)] == [RESYNC, encode_frame(FRONT)]


def test_the_answers_to_a_resync_are_no_complaints() -> None:
    """However late they are read: the thread that wrote the resync may sleep until the next frame is due."""
    sender = awake()
    sender.show(FRONT, 0.0)
    sender.next(0.0)
    sender.receive(b"E1\r\n")
    assert sender.next(PERIOD) == RESYNC
    sender.receive(b"E2\r\nE1\r\n")

    assert sent(sender, PERIOD, 0.1)[0][1] == encode_frame(FRONT)


def test_an_idle_belt_gets_one_resync() -> None:
    sender = awake()
    sender.receive(b"E2\r\n")

    assert sender.wait(10.0) is None
    assert sent(sender, 10.0, 10.1) == []


def test_other_bytes_of_the_board_are_noise() -> None:
    sender = awake()
    sender.show(FRONT, 0.0)
    sender.next(0.0)
    sender.receive(bytes(each for each in range(256) if each != ord("E")))

    assert {data for _, data in sent(sender, 0.0, 1.0)} == {encode_frame(FRONT)}


def test_a_sender_waits_until_its_next_frame_is_due_and_for_ever_once_the_belt_is_dark() -> None:
    sender = BeltSender()
    assert sender.wait(5.0) == 0.0
    assert sender.next(5.0) == RESYNC
    assert (sender.wait(5.0), sender.is_over(5.0)) == (None, True)
    sender.show(FRONT, 6.0)
    assert (sender.wait(6.0), sender.is_over(6.0)) == (0.0, False)
    assert sender.next(6.0) == encode_frame(FRONT)
    assert (sender.wait(6.01), sender.next(6.03)) == (pytest.approx(0.03), b"")
    sender.show(OFF, 7.0)
    assert (sender.wait(7.0), sender.is_over(7.0)) == (0.0, False)
    assert sender.next(7.0) == DARK
    assert (sender.wait(7.0), sender.is_over(7.0), sender.next(8.0)) == (None, True, b"")


def test_a_belt_whose_pulse_was_not_sent_yet_is_not_over() -> None:
    sender = awake()
    sender.show(FRONT, 0.0)
    sender.show(OFF, 0.0)

    assert [sender.is_over(now) for now in (0.1, 0.249, 0.25)] == [False, False, True]
    assert sender.next(0.25) == b""


@pytest.mark.parametrize(
    ("later", "felt"),
    [
        ((2, 0.1), [3, 3, 2, 2]),
        ((3, 0.1), [3, 3, 3, 3]),
        ((0, 0.1), [3, 3, 0, 0]),
    ],
)
def test_a_motor_keeps_its_strongest_level_for_a_quarter_second(
    later: tuple[int, float], felt: list[int]
) -> None:
    """In frames at 0.2, 0.249, 0.25 and 0.34 seconds, after a change at 0.1 and off at 0.11 where it was
    as strong again."""
    level, at = later
    shown = []
    for now in (0.2, 0.249, 0.25, 0.34):
        sender = awake()
        sender.show((3,) * MOTORS, 0.0)
        sender.show((level,) * MOTORS, at)
        if level == 3:
            sender.show(OFF, 0.11)
        data = sender.next(now)
        shown.append("PCBA".index(chr(data[8])) if data else 0)

    assert shown == felt


def test_a_reopened_port_is_sent_a_resync_at_once() -> None:
    sender = awake()
    sender.show(FRONT, 0.0)
    sender.next(0.0)
    sender.start_over()

    assert [sender.next(now) for now in (0.01, 0.02, 0.04)] == [RESYNC, b"", encode_frame(FRONT)]


@given(st.lists(st.tuples(st.floats(0.0, 0.3), LEVELS), max_size=30), st.binary(max_size=40))
@example([(0.0, OFF), (0.0, (*OFF[1:], 1))], b"Z")
def test_whatever_is_shown_the_board_ends_dark_and_synchronised(
    shown: list[tuple[float, tuple[int, ...]]], rubbish: bytes
) -> None:
    """From any state of the board: it has received garbage before."""
    sender, board, now = BeltSender(), SimulatedBelt(), 0.0
    board.feed(rubbish, now)
    for pause, levels in [*shown, (0.0, OFF)]:
        sender.show(levels, now)
        for moment, data in sent(sender, now, now + pause):
            sender.receive(board.feed(data, moment))
        now += pause
    ends = sent(sender, now, now + 1.0)
    answers = [(data, board.feed(data, moment)) for moment, data in ends]

    assert b"".join(answer for data, answer in answers if data != RESYNC) == b""
    assert set(board.motors(now + 0.9)) == {"P"}


def test_a_frame_takes_less_than_the_period_on_the_wire() -> None:
    assert len(encode_frame(OFF)) * 10 / 9600 < PERIOD
