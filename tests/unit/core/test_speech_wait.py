"""A program can wait until the voice has said its sentence."""

from __future__ import annotations

from donnie_tui.core.outlets import LONGEST, SLICE, SpeechWait


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
