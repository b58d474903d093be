"""A device that accepts the belt's bytes and never answers as a belt is reported, once, and not too soon."""

from __future__ import annotations

import pytest

from devices.belt import ASKED_AGAIN, GIVEN_UP, RESYNC, BeltCheck, BeltDetector
from tests.simulated_belt import SimulatedBelt

SOON = 0.1


@pytest.mark.parametrize(
    "said", [b"", b"\xaa\xbb\x34\x02" * 20, b"hello\r\n"], ids=["mute", "robot", "other"]
)
def test_a_device_that_never_answers_is_asked_once_more_and_then_reported_once(said: bytes) -> None:
    detector = BeltDetector(10.0)
    detector.receive(said)
    moments = (SOON, ASKED_AGAIN, ASKED_AGAIN + SOON, GIVEN_UP, GIVEN_UP + SOON)

    nothing = BeltCheck.NOTHING
    assert [detector.next(10.0 + each) for each in moments] == [
        nothing,
        BeltCheck.ASK,
        nothing,
        BeltCheck.REPORT_MISSING,
        nothing,
    ]


@pytest.mark.parametrize("asked_at", [0.0, ASKED_AGAIN], ids=["at once", "asked again"])
def test_a_belt_that_answers_a_resync_is_not_reported(asked_at: float) -> None:
    detector, answer = BeltDetector(0.0), SimulatedBelt().feed(RESYNC, asked_at)
    asked = [detector.next(ASKED_AGAIN)] if asked_at else []
    for byte in answer:  # in any chunks
        detector.receive(bytes([byte]))

    assert asked in ([], [BeltCheck.ASK])
    assert detector.next(GIVEN_UP + SOON) is BeltCheck.NOTHING


def test_a_complaint_before_much_noise_in_one_chunk_is_an_answer() -> None:
    """As a thread that slept reads it."""
    detector = BeltDetector(0.0)
    detector.receive(b"E1\r\n" + bytes(40))

    assert detector.next(GIVEN_UP + SOON) is BeltCheck.NOTHING


def test_a_device_is_asked_again_after_three_seconds_and_reported_after_four() -> None:
    """A board that opening restarted has begun by then."""
    detector = BeltDetector(10.0)
    answers = [detector.next(10.0 + each) for each in (0.0, 2.99, 3.0, 3.99, 4.0)]

    assert answers == [
        *([BeltCheck.NOTHING] * 2), BeltCheck.ASK, BeltCheck.NOTHING, BeltCheck.REPORT_MISSING,
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("parts", "check"),
    [
        ([b"E1", b"\r\n"], BeltCheck.NOTHING),
        ([b"xE2\r", b"\n"], BeltCheck.NOTHING),
        ([b"E1", b"\r!\n"], BeltCheck.REPORT_MISSING),
        ([b"E3\r\n"], BeltCheck.REPORT_MISSING),
    ],
)
def test_a_complaint_may_come_in_parts(parts: list[bytes], check: BeltCheck) -> None:
    detector = BeltDetector(0.0)
    for each in parts:
        detector.receive(each)
    detector.next(3.0)

    assert detector.next(4.0) is check
