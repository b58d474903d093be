"""A program can wait until the voice has said its sentence."""

from __future__ import annotations

import pytest

from donnie_tui.core.voice import LONGEST, SLICE, SpeechWait


def test_a_program_without_a_voice_does_not_wait() -> None:
    SpeechWait().wait(lambda: True)


def test_a_program_waits_until_all_is_said() -> None:
    looks = iter((False, False, True))
    speech_wait = SpeechWait()
    speech_wait.is_quiet_within = lambda _: next(looks)
    speech_wait.wait(lambda: True)
    assert next(looks, None) is None


def test_a_stop_ends_the_wait_at_the_next_look() -> None:
    asked: list[float] = []
    speech_wait = SpeechWait()
    speech_wait.is_quiet_within = lambda seconds: asked.append(seconds) is not None
    speech_wait.wait(lambda: False)
    assert asked == [SLICE]


def test_a_hanging_voice_does_not_hold_a_program_forever() -> None:
    asked: list[float] = []
    speech_wait = SpeechWait()
    speech_wait.is_quiet_within = lambda seconds: asked.append(seconds) is not None
    speech_wait.wait(lambda: True)
    assert sum(asked) <= LONGEST + SLICE


def test_a_stop_is_looked_for_each_twentieth_of_a_second_and_half_a_minute_is_the_longest() -> None:
    asked: list[float] = []
    speech_wait = SpeechWait()
    speech_wait.is_quiet_within = lambda seconds: asked.append(seconds) is not None
    speech_wait.wait(lambda: True)

    assert asked == [0.05] * 600


def test_programs_that_wait_are_counted_until_they_go_on() -> None:
    """Also if the voice fails, or the turn monitor would excuse a program forever."""
    speech_wait, counts = SpeechWait(), list[int]()

    def failing(seconds: float) -> bool:
        counts.append(speech_wait.waiting)
        if len(counts) == 1:
            speech_wait.wait(lambda: True)
            return True
        raise OSError

    speech_wait.is_quiet_within = failing
    with pytest.raises(OSError):
        speech_wait.wait(lambda: True)

    assert (counts, speech_wait.waiting) == ([1, 2], 0)
