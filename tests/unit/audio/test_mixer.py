"""How sounds are added up, without a device."""

from __future__ import annotations

from array import array

from devices.audio.cues import SAMPLE_RATE
from devices.audio.mixer import Mixer


def constant(level: int, frames: int) -> array[int]:
    return array("h", [level]) * (2 * frames)


def test_without_sound_the_mixer_gives_silence_and_counts_it() -> None:
    mixer = Mixer()

    assert mixer.mix(100) == constant(0, 100)
    assert mixer.frames == 100
    assert not mixer.is_playing


def test_a_voice_and_a_cue_are_added_up() -> None:
    mixer = Mixer()
    mixer.speak(array("h", [1000] * 30), on_end=lambda: None)
    mixer.cue("bump", constant(200, 10), delay=0.0)

    assert mixer.mix(20) == constant(1200, 10) + constant(1000, 10)
    assert mixer.mix(20) == constant(1000, 10) + constant(0, 10)


def test_what_is_too_loud_is_clipped_and_does_not_wrap() -> None:
    mixer = Mixer()
    for _ in range(2):
        mixer.speak(array("h", [30_000, -30_000]), on_end=lambda: None)

    assert mixer.mix(2).tolist() == [32_767, 32_767, -32_768, -32_768]


def test_the_end_of_a_sentence_is_reported_once() -> None:
    ends: list[str] = []
    mixer = Mixer()
    mixer.speak(array("h", [1] * 10), on_end=lambda: ends.append("end"))
    mixer.mix(9)
    assert ends == []

    mixer.mix(1)
    mixer.mix(10)
    assert ends == ["end"]


def test_a_silenced_sentence_does_not_sound_and_its_end_is_not_reported() -> None:
    ends: list[str] = []
    mixer = Mixer()
    mixer.speak(array("h", [1000] * 10), on_end=lambda: ends.append("end"))
    mixer.cue("scan", constant(50, 10), delay=0.0)
    mixer.silence(speech=True, cues=False)

    assert mixer.mix(20) == constant(50, 10) + constant(0, 10)
    assert ends == []


def test_silencing_cues_leaves_the_voice_alone() -> None:
    mixer = Mixer()
    mixer.speak(array("h", [1000] * 10), on_end=lambda: None)
    mixer.cue("scan", constant(50, 10), delay=0.0)
    mixer.silence(speech=False, cues=True)

    assert mixer.mix(10) == constant(1000, 10)


def test_a_cue_may_start_in_the_last_frame() -> None:
    mixer = Mixer()
    mixer.cue("bump", constant(7, 2), delay=9 / SAMPLE_RATE)

    assert mixer.mix(10) == constant(0, 9) + constant(7, 1)
    assert mixer.mix(10) == constant(7, 1) + constant(0, 9)
    assert mixer.frames == 20


def test_two_cues_sound_together_with_a_voice() -> None:
    mixer = Mixer()
    mixer.speak(array("h", [1] * 10), on_end=lambda: None)
    mixer.cue("found", constant(10, 10), delay=0.0)
    mixer.cue("found", constant(100, 10), delay=0.0)

    assert mixer.mix(10) == constant(111, 10)


def test_a_cue_may_start_later() -> None:
    mixer = Mixer()
    mixer.cue("bump", constant(7, 10), delay=25 / SAMPLE_RATE)

    assert mixer.mix(20) == constant(0, 20)
    assert mixer.mix(20) == constant(0, 5) + constant(7, 10) + constant(0, 5)


def test_of_three_cues_the_oldest_that_is_no_bump_ends() -> None:
    mixer = Mixer()
    mixer.cue("bump", constant(1, 50), delay=0.0)
    mixer.cue("found", constant(10, 50), delay=0.0)
    mixer.cue("bump", constant(100, 50), delay=0.0)

    assert mixer.mix(10) == constant(101, 10)


def test_consecutive_cues_all_sound_however_much_is_mixed_at_once() -> None:
    mixer = Mixer()
    for number in range(4):
        mixer.cue("found", constant(1, 10), delay=10 * number / SAMPLE_RATE)

    assert mixer.mix(50) == constant(1, 40) + constant(0, 10)


def test_a_cue_that_starts_later_ends_the_oldest_only_then() -> None:
    mixer = Mixer()
    for level, delay in ((1, 0), (10, 0), (100, 20)):
        mixer.cue("found", constant(level, 30), delay=delay / SAMPLE_RATE)

    assert mixer.mix(60) == constant(11, 20) + constant(110, 10) + constant(100, 20) + constant(0, 10)
