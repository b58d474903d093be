"""What takes the belt's bytes and never answers as a belt does is told, once, and not too soon."""

from __future__ import annotations

import pytest

from devices.belt.board import BeltBoard
from devices.belt.doubt import ASKED_AGAIN, GIVEN_UP, Doubt, Next
from devices.belt.frame import RESYNC

SOON = 0.1


@pytest.mark.parametrize(
    "said", [b"", b"\xaa\xbb\x34\x02" * 20, b"hello\r\n"], ids=["mute", "robot", "other"]
)
def test_what_never_answers_is_asked_once_more_and_then_told_once(said: bytes) -> None:
    doubt = Doubt(10.0)
    doubt.heard(said)
    moments = (SOON, ASKED_AGAIN, ASKED_AGAIN + SOON, GIVEN_UP, GIVEN_UP + SOON)

    nothing = Next.NOTHING
    assert [doubt.next(10.0 + each) for each in moments] == [nothing, Next.ASK, nothing, Next.TELL, nothing]


@pytest.mark.parametrize("asked_at", [0.0, ASKED_AGAIN], ids=["at once", "asked again"])
def test_a_belt_answers_a_resync_and_nothing_is_told(asked_at: float) -> None:
    doubt, answer = Doubt(0.0), BeltBoard().feed(RESYNC, asked_at)
    asked = [doubt.next(ASKED_AGAIN)] if asked_at else []
    for byte in answer:  # however it is cut
        doubt.heard(bytes([byte]))

    assert asked in ([], [Next.ASK])
    assert doubt.next(GIVEN_UP + SOON) is Next.NOTHING
