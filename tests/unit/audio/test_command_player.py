"""The command-line player, with scripts in place of the real ones."""

from __future__ import annotations

import shutil
import subprocess
import sys
import threading
import wave
from array import array
from pathlib import Path
from types import SimpleNamespace

import pytest

from devices.audio.cues import SAMPLE_RATE
from devices.audio.players import CommandPlayer, find_command_player, open_player
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the commands exist on Unix only")


KEEP = 'case "$1" in -q) shift;; esac; cat "$1" > "$HOME/$(basename "$0").wav"'
HANG = "while :; do :; done"
PLAY_THE_TRIAL_THEN_HANG = f'[ -e "$HOME/tried" ] || {{ : > "$HOME/tried"; exit 0; }}; {HANG}'


@pytest.fixture
def commands(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder that is searched before the system's own; its players all fail at first."""
    folder = tmp_path / "bin"
    folder.mkdir()
    for name in ("pw-play", "paplay", "aplay"):
        provide(folder, name, "exit 1")
    monkeypatch.setenv("PATH", f"{folder}:/usr/bin:/bin")
    monkeypatch.setenv("HOME", str(tmp_path))
    return folder


def provide(folder: Path, name: str, script: str) -> None:
    file = folder / name
    file.write_text(f"#!/bin/sh\n{script}\n")
    file.chmod(0o755)


def found() -> CommandPlayer:
    player = find_command_player()
    assert player is not None
    return player


def played(path: Path) -> tuple[int, int, array[int]]:
    """Channels, rate and samples of what a command was given."""
    with wave.open(str(path), "rb") as file:
        return file.getnchannels(), file.getframerate(), array("h", file.readframes(file.getnframes()))


@pytest.mark.usefixtures("commands")
def test_commands_that_all_fail_are_no_player() -> None:
    assert find_command_player() is None


@pytest.mark.parametrize("name", ["pw-play", "paplay", "aplay"])
def test_the_command_that_works_is_chosen(commands: Path, tmp_path: Path, name: str) -> None:
    """It is tried with ten milliseconds of silence."""
    provide(commands, name, KEEP)

    assert found().name == name
    assert played(tmp_path / f"{name}.wav") == (2, 22_050, array("h", [0, 0]) * 220)


def test_a_command_that_hangs_is_tried_for_two_seconds(monkeypatch: pytest.MonkeyPatch) -> None:
    did: list[object] = []

    class Hanging:
        def wait(self, seconds: float | None = None) -> int:
            did.append(seconds)
            if seconds is not None:
                raise subprocess.TimeoutExpired("pw-play", seconds)
            return -9

        def kill(self) -> None:
            did.append("kill")

    monkeypatch.setattr(shutil, "which", lambda name: name if name == "pw-play" else None)
    monkeypatch.setattr(subprocess, "Popen", lambda *_, **_options: Hanging())

    assert find_command_player() is None
    assert did == [2.0, "kill", None]


def test_a_sentence_reaches_the_command_as_wav_and_its_end_is_reported(
    commands: Path, tmp_path: Path
) -> None:
    provide(commands, "aplay", KEEP)
    ended = threading.Event()
    found().speak(array("h", [1, -2, 3]), on_end=ended.set)

    assert ended.wait(TIMEOUT)
    assert played(tmp_path / "aplay.wav") == (2, SAMPLE_RATE, array("h", [1, 1, -2, -2, 3, 3]))


def test_a_silenced_command_is_killed(commands: Path) -> None:
    provide(commands, "paplay", PLAY_THE_TRIAL_THEN_HANG)
    player = found()
    ended = threading.Event()
    player.speak(array("h", [1]), on_end=ended.set)
    player.cue("bump", array("h", [1, 1]), delay=0.0)
    processes = [sound.process for sound in player._sounds]
    player.silence(speech=True, cues=True)

    assert [process.wait(TIMEOUT) for process in processes] == [-9, -9]
    assert not player.is_playing
    assert not ended.is_set()


def test_the_voice_and_the_cues_are_silenced_each_alone(commands: Path) -> None:
    provide(commands, "paplay", PLAY_THE_TRIAL_THEN_HANG)
    player = found()
    assert (player.name, player.frames, player.is_playing) == ("paplay", None, False)

    def left(*, speech: bool, cues: bool) -> list[str]:
        player.close()
        player.speak(array("h", [1]), on_end=lambda: None)
        player.cue("bump", array("h", [1, 1]), delay=0.0)
        player.silence(speech, cues)
        return [each.cue for each in player._sounds]

    assert left(speech=False, cues=False) == ["", "bump"]
    assert player.is_playing
    assert left(speech=True, cues=False) == ["bump"]
    assert left(speech=False, cues=True) == [""]
    player.close()
    assert not player.is_playing


def test_of_three_cues_the_oldest_that_is_no_bump_ends(commands: Path) -> None:
    provide(commands, "paplay", PLAY_THE_TRIAL_THEN_HANG)
    player = found()
    for name in ("bump", "found", "scan"):
        player.cue(name, array("h", [1, 1]) * 60 * SAMPLE_RATE, delay=0.0)
    still_there = [sound.cue for sound in player._sounds]
    player.close()

    assert still_there == ["bump", "scan"]


def test_cues_that_wait_for_each_other_end_none(commands: Path) -> None:
    provide(commands, "paplay", PLAY_THE_TRIAL_THEN_HANG)
    player = found()
    for number in range(4):
        player.cue("found", array("h", [1, 1]) * 60 * SAMPLE_RATE, delay=60.0 * number)
    still_there = [sound.cue for sound in player._sounds]
    player.close()

    assert still_there == ["found"] * 4


def test_a_cue_that_waits_is_preceded_by_silence(commands: Path, tmp_path: Path) -> None:
    provide(commands, "pw-play", KEEP)
    player = found()
    player.cue("bump", array("h", [7, 7]), delay=2 / SAMPLE_RATE)
    for process in [sound.process for sound in player._sounds]:
        process.wait(TIMEOUT)

    assert played(tmp_path / "pw-play.wav")[2] == array("h", [0, 0, 0, 0, 7, 7])


def test_a_command_that_fails_reports_no_end(commands: Path) -> None:
    provide(commands, "paplay", '[ -e "$HOME/tried" ] && exit 1; : > "$HOME/tried"')
    ended = threading.Event()
    player = found()
    player.speak(array("h", [1]), on_end=ended.set)
    for thread in [thread for thread in threading.enumerate() if thread.name == "player"]:
        thread.join(TIMEOUT)

    assert not ended.is_set()
    assert not player.is_playing


# --- which player


@pytest.mark.parametrize(
    ("platform", "device", "working", "tried", "name"),
    [
        ("linux", "auto", "PULSEAUDIO", ["PULSEAUDIO"], "miniaudio"),
        ("linux", "auto", "ALSA", ["PULSEAUDIO", "ALSA"], "miniaudio"),
        ("linux", "auto", "", ["PULSEAUDIO", "ALSA"], "command"),
        ("darwin", "auto", "", ["COREAUDIO"], "command"),
        ("win32", "auto", "WINMM", ["WASAPI", "DSOUND", "WINMM"], "miniaudio"),
        ("openbsd7", "auto", "", ["SNDIO", "AUDIO4", "OSS"], "command"),
        ("linux", "null", "NULL", ["NULL"], "miniaudio"),
        ("linux", "null", "", ["NULL"], None),
        ("linux", "none", "ALSA", [], None),
    ],
)
def test_each_sound_server_is_tried_and_then_the_commands(
    monkeypatch: pytest.MonkeyPatch,
    platform: str,
    device: str,
    working: str,
    tried: list[str],
    name: str | None,
) -> None:
    made: list[dict[str, object]] = []

    class Error(Exception):
        pass

    class Device:
        def __init__(self, **options: object) -> None:
            made.append(options)
            if options["backends"] != [working]:
                raise Error

        def start(self, source: object) -> None: ...

    class Names:
        """A backend for each name; miniaudio may know fewer of them."""

        def __getitem__(self, name: str) -> str:
            return name

    fake = SimpleNamespace(PlaybackDevice=Device, MiniaudioError=Error, Backend=Names())
    monkeypatch.setitem(sys.modules, "miniaudio", fake)
    monkeypatch.setattr(sys, "platform", platform)
    monkeypatch.setattr(
        "devices.audio.players.find_command_player", lambda: CommandPlayer("command", ("true",))
    )
    player = open_player(device)

    assert [each["backends"] for each in made] == [[each] for each in tried]
    for each in made:
        assert (each["nchannels"], each["sample_rate"], each["buffersize_msec"]) == (2, 22_050, 30)
        assert each["app_name"] == "Donnie"
    assert (None if player is None else player.name) == name


def test_without_the_library_the_commands_play(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "miniaudio", None)
    monkeypatch.setattr("devices.audio.players.find_command_player", lambda: CommandPlayer("command", ()))
    player = open_player("auto")

    assert player is not None
    assert player.name == "command"
