"""When cues are heard, what they are made of, and how they are added up; without a device."""

from __future__ import annotations

import itertools
import math
import wave
from array import array
from pathlib import Path

import pytest

from devices.ports.audio import Cue, CuePlayer
from devices.sound.cue_policy import CuePolicy
from devices.sound.mixer import Mixer
from devices.sound.silent import SilentCuePlayer
from devices.sound.tones import CUE_NAMES, SAMPLE_RATE, pitch_of_level, render, seconds_of

TICKS = ("step-forward", "step-back", "turn-right", "turn-left")
TELL_PLACE = ("obstacle", "scan", "found", "belt", "block-opened", "block-closed")


def admitted(*cues: tuple[str, float, float]) -> list[float | None]:
    """The answers for cues given as name, length and time."""
    policy = CuePolicy()
    return [policy.admit(name, seconds, now) for name, seconds, now in cues]


def test_at_most_two_cues_sound_at_once() -> None:
    ticks = ("step-forward", 0.045, 0.0), ("turn-left", 0.055, 0.0), ("step-back", 0.05, 0.04)
    assert admitted(*ticks) == [0.0, 0.0, None]


def test_a_third_cue_is_heard_when_one_of_two_has_ended() -> None:
    ticks = ("step-forward", 0.045, 0.0), ("turn-left", 0.055, 0.0), ("step-back", 0.05, 0.046)
    assert admitted(*ticks) == [0.0, 0.0, 0.0]


def test_what_is_told_once_waits_in_line_and_is_not_left_out() -> None:
    """A step, a scan that finds three things, the end of the program: all at the same robot time."""
    found = ("found", 0.25, 0.0)
    waits = admitted(
        ("step-forward", 0.045, 0.0), ("scan", 0.09, 0.0), found, found, found, ("done", 0.32, 0.0)
    )

    assert waits == pytest.approx([0.0, 0.0, 0.09, 0.34, 0.59, 0.84])


def test_a_line_begins_when_one_of_two_ticks_has_ended() -> None:
    ticks = ("step-forward", 0.045, 0.0), ("belt", 0.06, 0.0)
    assert admitted(*ticks, ("scan", 0.09, 0.0)) == pytest.approx([0.0, 0.0, 0.045])


def test_steps_are_heard_beside_what_waits_in_line() -> None:
    found, step = ("found", 0.25, 0.0), ("step-forward", 0.045, 0.3)
    assert admitted(found, found, found, step) == pytest.approx([0.0, 0.25, 0.5, 0.0])


def test_a_line_never_runs_far_behind_and_the_end_of_the_program_is_still_heard() -> None:
    waits = admitted(*[("found", 0.25, 0.0)] * 1000, ("done", 0.32, 0.0), ("error", 0.33, 0.0))

    assert max(wait for wait in waits[:1000] if wait is not None) <= 2.0
    assert None not in waits[1000:]


@pytest.mark.parametrize(("name", "apart"), [("step-forward", 0.07), ("turn-left", 0.07), ("scan", 0.3)])
def test_the_same_kind_keeps_its_distance(name: str, apart: float) -> None:
    assert admitted((name, 0.04, 1.0), (name, 0.04, 1.0 + apart - 0.01)) == [0.0, None]
    assert admitted((name, 0.04, 1.0), (name, 0.04, 1.0 + apart)) == [0.0, 0.0]


def test_different_kinds_need_no_distance() -> None:
    assert admitted(("step-forward", 0.04, 0.0), ("scan", 0.09, 0.0)) == [0.0, 0.0]


def test_a_bump_is_heard_however_much_sounds() -> None:
    assert admitted(("found", 0.25, 0.0), ("belt", 0.06, 0.0), ("bump", 0.18, 0.0)) == [0.0, 0.0, 0.0]


def test_a_second_bump_waits_its_turn() -> None:
    waits = admitted(("bump", 0.18, 0.0), ("bump", 0.18, 0.0), ("bump", 0.18, 0.02))

    assert waits == pytest.approx([0.0, 0.07, 0.12])


def test_a_flood_of_bumps_never_runs_far_behind() -> None:
    waits = admitted(*(("bump", 0.18, number / 1000) for number in range(1000)))

    heard = [wait for wait in waits if wait is not None]
    assert len(heard) > 10
    assert max(heard) <= 1.0


def test_a_fast_simulation_is_heard_as_a_steady_tick() -> None:
    heard = [
        wait for wait in admitted(*(("step-forward", 0.045, n / 1000) for n in range(1000))) if wait == 0.0
    ]

    assert 13 <= len(heard) <= 15


def test_after_a_silence_the_same_cue_is_heard_at_once() -> None:
    policy = CuePolicy()
    policy.admit("scan", 0.09, 0.0)
    policy.clear()

    assert policy.admit("scan", 0.09, 0.01) == 0.0


def sides(samples: array[int]) -> tuple[float, float]:
    """Energy on the left and on the right."""
    return float(sum(x * x for x in samples[0::2])), float(sum(x * x for x in samples[1::2]))


def decibels_to_the_right(cue: Cue) -> float:
    left, right = sides(render(cue))
    return 10 * math.log10((right + 1) / (left + 1))


def crossings(cue: Cue) -> int:
    """How often the sound changes its sign: pitch, for cues of one length."""
    left = render(cue)[0::2]
    return sum((a < 0) != (b < 0) for a, b in itertools.pairwise(left))


def test_the_cues_have_their_agreed_names() -> None:
    assert set(CUE_NAMES) == {*TICKS, *TELL_PLACE, "bump", "done", "error", "waiting"}


@pytest.mark.parametrize("name", CUE_NAMES)
def test_a_cue_written_as_wav_has_its_length_and_is_heard(name: str, tmp_path: Path) -> None:
    file = tmp_path / "cue.wav"
    with wave.open(str(file), "wb") as written:
        written.setparams((2, 2, SAMPLE_RATE, 0, "NONE", ""))
        written.writeframes(render(Cue(name)).tobytes())

    with wave.open(str(file), "rb") as read:
        seconds = read.getnframes() / read.getframerate()
        loudest = max(array("h", read.readframes(read.getnframes())))
    assert seconds == pytest.approx(seconds_of(name), abs=0.001)
    assert seconds <= (0.060 if name in TICKS else 0.350)
    assert 4_000 < loudest < 20_000


@pytest.mark.parametrize("name", CUE_NAMES)
def test_a_cue_begins_and_ends_without_a_click(name: str) -> None:
    samples = render(Cue(name, bearing=30.0, steps=10.0))

    assert max(abs(sample) for sample in samples[:4] + samples[-4:]) < 2_000


@pytest.mark.parametrize("name", CUE_NAMES)
def test_the_same_cue_is_the_same_bytes(name: str) -> None:
    assert render(Cue(name, 20.0, 5.0)) == render(Cue(name, 20.0, 5.0))


def test_turning_right_and_left_are_on_their_sides_by_themselves() -> None:
    assert decibels_to_the_right(Cue("turn-right")) > 12
    assert decibels_to_the_right(Cue("turn-left")) < -12


@pytest.mark.parametrize("name", CUE_NAMES)
@pytest.mark.parametrize("bearing", [45.0, 90.0, 135.0])
def test_left_and_right_are_twelve_decibels_apart(name: str, bearing: float) -> None:
    assert decibels_to_the_right(Cue(name, bearing)) > 12
    assert decibels_to_the_right(Cue(name, -bearing)) < -12


def test_bearings_beyond_a_turn_are_the_same_as_within() -> None:
    assert render(Cue("scan", 405.0)) == render(Cue("scan", 45.0))


def test_one_ear_tells_left_from_right() -> None:
    assert render(Cue("obstacle", 60.0))[0::2] != render(Cue("obstacle", -60.0))[1::2]


@pytest.mark.parametrize("name", TELL_PLACE)
def test_nearer_is_higher(name: str) -> None:
    pitches = [crossings(Cue(name, 0.0, float(steps))) for steps in range(0, 61, 5)]

    assert pitches == sorted(pitches, reverse=True)
    assert len(set(pitches)) == len(pitches)


def test_behind_is_duller() -> None:
    def sharpness(cue: Cue) -> float:
        left = render(cue)[0::2]
        steepness = sum((b - a) ** 2 for a, b in itertools.pairwise(left))
        return steepness / sum(a * a for a in left)

    assert sharpness(Cue("bump", 180.0)) < 0.7 * sharpness(Cue("bump", 0.0))


@pytest.mark.parametrize("wrong", [math.nan, math.inf, -math.inf, 1e300])
def test_a_place_that_is_none_still_sounds(wrong: float) -> None:
    for cue in (Cue("scan", wrong, 3.0), Cue("scan", 0.0, wrong)):
        assert max(render(cue)) > 1_000


def test_volume_goes_from_nothing_to_all() -> None:
    assert not any(render(Cue("bump"), 0.0))
    assert max(render(Cue("bump"), 0.5)) == pytest.approx(max(render(Cue("bump"), 1.0)) / 2, abs=2)
    assert render(Cue("bump"), 9.0) == render(Cue("bump"), 1.0)


def test_an_unknown_cue_is_an_error_here() -> None:
    with pytest.raises(KeyError):
        render(Cue("trumpet"))


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


def test_the_end_of_a_sentence_is_told_once() -> None:
    ends: list[str] = []
    mixer = Mixer()
    mixer.speak(array("h", [1] * 10), on_end=lambda: ends.append("end"))
    mixer.mix(9)
    assert ends == []

    mixer.mix(1)
    mixer.mix(10)
    assert ends == ["end"]


def test_a_hushed_sentence_is_not_heard_and_its_end_not_told() -> None:
    ends: list[str] = []
    mixer = Mixer()
    mixer.speak(array("h", [1000] * 10), on_end=lambda: ends.append("end"))
    mixer.cue("scan", constant(50, 10), delay=0.0)
    mixer.hush(speech=True, cues=False)

    assert mixer.mix(20) == constant(50, 10) + constant(0, 10)
    assert ends == []


def test_hushed_cues_leave_the_voice_alone() -> None:
    mixer = Mixer()
    mixer.speak(array("h", [1000] * 10), on_end=lambda: None)
    mixer.cue("scan", constant(50, 10), delay=0.0)
    mixer.hush(speech=False, cues=True)

    assert mixer.mix(10) == constant(1000, 10)


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


def test_cues_one_behind_the_other_are_all_heard_however_much_is_mixed_at_once() -> None:
    mixer = Mixer()
    for number in range(4):
        mixer.cue("found", constant(1, 10), delay=10 * number / SAMPLE_RATE)

    assert mixer.mix(50) == constant(1, 40) + constant(0, 10)


def test_a_cue_that_starts_later_ends_the_oldest_only_then() -> None:
    mixer = Mixer()
    for level, delay in ((1, 0), (10, 0), (100, 20)):
        mixer.cue("found", constant(level, 30), delay=delay / SAMPLE_RATE)

    assert mixer.mix(60) == constant(11, 20) + constant(110, 10) + constant(100, 20) + constant(0, 10)


def test_the_silent_player_takes_everything() -> None:
    player: CuePlayer = SilentCuePlayer()
    player.play(Cue("trumpet", math.nan))
    player.silence()
    player.close()
    player.play(Cue("bump"))


def test_a_deeper_block_sounds_higher() -> None:
    steps = [pitch_of_level(level) for level in range(1, 8)]
    assert steps == sorted(steps, reverse=True)
    assert steps[-1] >= 0
    assert pitch_of_level(100) == 0
