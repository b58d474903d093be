"""Cues in a file, and the learner's sounds sounds."""

from __future__ import annotations

import wave
from array import array
from pathlib import Path

import pytest

from devices.audio.cues import (
    SAMPLE_RATE,
    NotWav,
    load_user_sounds,
    read_mono,
    render_cue,
    seconds_of,
    unknown_sound_files,
)
from devices.audio.mixer import WavCueWriter
from devices.ports.audio import Cue

EDGE = 8
"""Samples at the border of two consecutive sounds that are not checked."""


def written(path: Path, *cues: tuple[float, Cue], until: float = 0.0) -> bytes:
    renderer = WavCueWriter(path.open("wb"))
    for at, cue in cues:
        renderer.add(cue, at)
    renderer.write_until(until)
    renderer.close()
    return path.read_bytes()


def frames_of(path: Path) -> array[int]:
    with wave.open(str(path)) as file:
        assert (file.getnchannels(), file.getsampwidth(), file.getframerate()) == (2, 2, SAMPLE_RATE)
        return array("h", file.readframes(file.getnframes()))


def test_a_cue_sounds_at_its_time(tmp_path: Path) -> None:
    written(tmp_path / "a.wav", (1.0, Cue("bump")))
    samples = frames_of(tmp_path / "a.wav")
    assert not any(samples[: 2 * SAMPLE_RATE])
    assert samples[2 * SAMPLE_RATE :][: len(render_cue(Cue("bump")))] == render_cue(Cue("bump"))


def test_the_same_cues_are_the_same_bytes(tmp_path: Path) -> None:
    cues = [(step * 0.2, Cue("step-forward")) for step in range(10)]
    assert written(tmp_path / "a.wav", *cues) == written(tmp_path / "b.wav", *cues)


def test_everything_that_a_scan_found_sounds_and_the_file_ends_after_it(tmp_path: Path) -> None:
    found = [Cue("found", bearing, 4.0) for bearing in (-90.0, 90.0, -90.0, 90.0)]
    written(tmp_path / "a.wav", *((1.0, cue) for cue in (Cue("step-back"), Cue("scan"), *found, Cue("done"))))

    samples, at = frames_of(tmp_path / "a.wav"), 1.0 + seconds_of("scan")
    sides = []
    for cue in (*found, Cue("done")):
        first, last = (2 * round(each * SAMPLE_RATE) for each in (at, at + seconds_of(cue.name)))
        sides.append(
            (max(samples[first + EDGE : last - EDGE : 2]), max(samples[first + EDGE + 1 : last - EDGE : 2]))
        )
        at += seconds_of(cue.name)
    assert [(left > 1_000, right > 1_000) for left, right in sides] == [
        (True, False), (False, True), (True, False), (False, True), (True, True),
    ]  # fmt: skip
    assert len(samples) >= 2 * round(at * SAMPLE_RATE)


@pytest.mark.parametrize("frames", [1, 2.5 * SAMPLE_RATE])
def test_silence_lasts_as_long_as_the_run(tmp_path: Path, frames: float) -> None:
    written(tmp_path / "a.wav", until=frames / SAMPLE_RATE)
    assert len(frames_of(tmp_path / "a.wav")) == 2 * round(frames)


def test_a_file_ends_within_half_a_second_after_its_last_cue(tmp_path: Path) -> None:
    written(tmp_path / "a.wav", (0.0, Cue("bump")))
    seconds = len(frames_of(tmp_path / "a.wav")) / 2 / SAMPLE_RATE
    assert seconds_of("bump") <= seconds <= seconds_of("bump") + 0.5


def test_an_unknown_cue_is_not_written(tmp_path: Path) -> None:
    written(tmp_path / "a.wav", (1.0, Cue("trumpet")))
    assert not frames_of(tmp_path / "a.wav")


def test_a_file_is_closed_with_its_writer_which_may_be_closed_twice(tmp_path: Path) -> None:
    file = (tmp_path / "a.wav").open("wb")
    writer = WavCueWriter(file)
    writer.close()
    assert file.closed
    writer.close()


def test_simultaneous_cues_are_dropped_as_at_a_loudspeaker(tmp_path: Path) -> None:
    one = written(tmp_path / "one.wav", (0.0, Cue("step-forward")), until=1.0)
    ten = written(tmp_path / "ten.wav", *[(0.0, Cue("step-forward"))] * 10, until=1.0)
    assert one == ten


def test_an_endless_wait_does_not_fill_the_disk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("devices.audio.mixer.LONGEST", 3.0)
    renderer = WavCueWriter((tmp_path / "a.wav").open("wb"))
    renderer.add(Cue("bump"), 2.9)
    renderer.write_until(2.95)
    assert not renderer.is_full
    renderer.write_until(1e12)
    assert renderer.is_full
    renderer.add(Cue("bump"), 1e12)
    renderer.close()
    assert len(frames_of(tmp_path / "a.wav")) == 2 * 3 * SAMPLE_RATE


# --- the learner's sounds


def wav(
    path: Path, samples: array[int], *, width: int = 2, rate: int = SAMPLE_RATE, channels: int = 1
) -> None:
    with wave.open(str(path), "wb") as file:
        file.setnchannels(channels)
        file.setsampwidth(width)
        file.setframerate(rate)
        file.writeframes(samples.tobytes())


def test_a_learners_sound_replaces_the_built_in_one_and_is_panned(tmp_path: Path) -> None:
    wav(tmp_path / "bump.wav", array("h", [16_384] * 500))
    sounds, broken = load_user_sounds(tmp_path)
    assert (list(sounds), broken) == (["bump"], ())
    right = render_cue(Cue("bump", 90.0), 1.0, sounds)
    assert max(right[0::2]) == 0
    assert max(right[1::2]) == pytest.approx(16_384, abs=2)
    assert render_cue(Cue("done"), 1.0, sounds) == render_cue(Cue("done"))


def test_a_long_sound_is_cut_and_another_rate_keeps_its_pitch(tmp_path: Path) -> None:
    wav(tmp_path / "done.wav", array("h", [1000] * 2 * 88_200), rate=44_100, channels=2)
    sounds, _ = load_user_sounds(tmp_path)
    assert len(sounds["done"]) == SAMPLE_RATE


def test_a_file_that_is_no_sound_is_ignored_and_reported(tmp_path: Path) -> None:
    (tmp_path / "bump.wav").write_bytes(b"RIFF....garbage")
    wav(tmp_path / "done.wav", array("h", [1]), width=1)
    wav(tmp_path / "trumpet.wav", array("h", [1]))
    sounds, broken = load_user_sounds(tmp_path)
    assert (dict(sounds), broken) == ({}, ("bump.wav", "done.wav"))
    assert unknown_sound_files(tmp_path) == ("trumpet.wav",)


def test_a_missing_folder_has_no_sounds(tmp_path: Path) -> None:
    assert load_user_sounds(None) == ({}, ())
    assert load_user_sounds(tmp_path / "none") == ({}, ())
    assert load_user_sounds(tmp_path / ("x" * 300)) == ({}, ())  # as in a folder without permission
    assert unknown_sound_files(tmp_path / "none") == ()


def test_a_file_that_is_no_wav_is_refused(tmp_path: Path) -> None:
    with pytest.raises(NotWav):
        read_mono(tmp_path / "missing.wav")
