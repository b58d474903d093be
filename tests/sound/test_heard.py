"""What really sounds: voice and cues through a private PulseAudio with a sink that can be recorded."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import time
from array import array
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from devices.audio_worker.notices import AudioNotice, NoticeCode
from devices.audio_worker.service import AudioService, AudioSettings
from devices.ports.audio import Cue, Urgency, Utterance
from devices.sound.tones import seconds_of
from tests.conftest import ROOT
from tests.sessions.learner import BACKSPACE, CTRL_D, Learner

RATE = 22_050
CHUNK = RATE // 20
"""Frames: a twentieth of a second."""

LOUD = 500
PATIENCE = 400
"""Chunks after which what must come will not come any more: twenty seconds of sound."""

pytestmark = pytest.mark.skipif(
    not (shutil.which("pulseaudio") and shutil.which("parec")), reason="needs pulseaudio and parec"
)


class Ear:
    """Hears the sink, in stereo."""

    def __init__(self, recording: subprocess.Popen[bytes], server: subprocess.Popen[bytes]) -> None:
        self._recording = recording
        self.server = server

    def hear(self) -> array[int]:
        assert self._recording.stdout is not None
        return array("h", self._recording.stdout.read(4 * CHUNK))

    def hears_something(self) -> array[int] | None:
        """The first loud chunk, None if there is none."""
        return next((chunk for _ in range(PATIENCE) if max(chunk := self.hear()) > LOUD), None)

    def chunks_until_silence(self) -> int:
        """How many chunks pass until half a second of silence begins."""
        silent = 0
        for number in range(PATIENCE):
            silent = 0 if max(self.hear()) > LOUD else silent + 1
            if silent == 10:
                return number - 9
        return PATIENCE


@pytest.fixture
def ear(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Iterator[Ear]:
    folder = tmp_path_factory.mktemp("pulse")
    socket = folder / "native"
    server = subprocess.Popen(
        [
            "pulseaudio", "-n", "--daemonize=no", "--exit-idle-time=-1", "--disable-shm=yes",
            "--use-pid-file=no", "-L", f"module-native-protocol-unix socket={socket} auth-anonymous=1",
            "-L", f"module-null-sink sink_name=ear rate={RATE}",
        ],
        env=_environment(folder), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip
    monkeypatch.setenv("PULSE_SERVER", f"unix:{socket}")
    recording = subprocess.Popen(
        ["/bin/sh", "-c", f'while ! [ -S "{socket}" ]; do sleep 0.05; done; exec parec -d ear.monitor '
         f"--format=s16le --rate={RATE} --channels=2 --latency-msec=20"],
        env={**_environment(folder), "PULSE_SERVER": f"unix:{socket}"}, stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
    )  # fmt: skip
    try:
        made = Ear(recording, server)
        made.hear()  # the sink is there
        yield made
    finally:
        for process in (recording, server):
            process.kill()
            process.wait()


def _environment(folder: Path) -> dict[str, str]:
    return {**os.environ, "XDG_RUNTIME_DIR": str(folder), "HOME": str(folder)}


@pytest.fixture
def audio(ear: Ear) -> Iterator[AudioService]:
    del ear
    notices: list[AudioNotice] = []
    made = AudioService(AudioSettings(), notices.append)
    yield made
    made.close()
    assert notices == []


def test_a_sentence_is_heard_and_ends_when_it_is_silenced(ear: Ear, audio: AudioService) -> None:
    sentence = "one two three four five six seven eight nine ten " * 8
    audio.say(Utterance(sentence, Urgency.PROGRAM, "en"))
    assert ear.hears_something()
    audio.silence_speech()
    assert ear.chunks_until_silence() < 60
    assert audio.is_quiet


def test_a_cue_is_heard_on_its_side(ear: Ear, audio: AudioService) -> None:
    audio.play(Cue("bump", 90.0, None))
    heard = ear.hears_something()
    assert heard
    assert max(heard[1::2]) > 4 * max(heard[0::2])


# --- a whole session


def test_a_key_at_the_terminal_ends_the_own_voice(ear: Ear, tmp_path: Path) -> None:
    """V3: and what is asked for next is heard."""
    learner = greeted(ear, Learner(tmp_path, "--speech", "tts"))
    learner.types(f'SPEAK "{"one two three four five six seven eight nine ten " * 4}"\r\r')
    learner.sees_prompt()
    assert ear.hears_something()
    learner.types("W")
    assert ear.chunks_until_silence() < 60
    learner.types("HERE\r")
    assert ear.hears_something()


def test_the_goodbye_is_heard(ear: Ear, tmp_path: Path) -> None:
    """V7: who has only the own voice hears that Donnie was left."""
    learner = greeted(ear, Learner(tmp_path, "--speech", "tts"))
    learner.types(CTRL_D)

    assert ear.hears_something()
    assert learner.leaves() == 0


def greeted(ear: Ear, learner: Learner) -> Learner:
    """Who has heard enough of the greeting."""
    learner.sees_prompt()
    assert ear.hears_something()
    learner.types(f" {BACKSPACE}")
    assert ear.chunks_until_silence() < 60
    return learner


def test_the_end_of_a_program_is_heard_to_its_end(ear: Ear, tmp_path: Path) -> None:
    """C1: its cue is longer than what is left to do; only a stop ends it."""
    (tmp_path / "a.gd").write_text("TR 10")
    options = ("--speech", "off", "--sound", "on", "--speed", "max")
    command = (sys.executable, "-m", "donnie_tui", "run", "a.gd", *options)
    with subprocess.Popen(command, cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(ROOT)}) as run:
        assert ear.hears_something()
        loud = 1 + ear.chunks_until_silence()

        assert run.wait() == 0
    assert loud * CHUNK / RATE >= seconds_of("done")


# --- the sound server hangs, or is gone

LONG = "one two three four five six seven eight nine ten " * 8


def eventually(is_so: Callable[[], bool]) -> bool:
    end = time.monotonic() + 20
    while not is_so() and time.monotonic() < end:
        time.sleep(0.01)
    return is_so()


def test_a_server_that_hung_is_heard_again(ear: Ear, audio: AudioService) -> None:
    """S6: a player that stands still is replaced, and the sentence said again."""
    audio.say(Utterance(LONG, Urgency.PROGRAM, "en"))
    assert ear.hears_something()
    before = audio.worker_pid
    ear.server.send_signal(signal.SIGSTOP)
    try:
        assert eventually(lambda: audio.worker_pid != before)
    finally:
        ear.server.send_signal(signal.SIGCONT)
    assert ear.hears_something()


def test_a_device_that_is_gone_is_told_once_and_nobody_waits(ear: Ear) -> None:
    notices: list[AudioNotice] = []
    service = AudioService(AudioSettings(), notices.append)
    try:
        service.say(Utterance(LONG, Urgency.PROGRAM, "en"))
        assert ear.hears_something()
        ear.server.kill()

        assert eventually(lambda: bool(notices))
        assert service.is_quiet
        service.say(Utterance(LONG, Urgency.PROGRAM, "en"))
        assert service.is_quiet
        assert notices[0].code in (NoticeCode.NO_SOUND_DEVICE, NoticeCode.AUDIO_GAVE_UP)
        assert len(notices) == 1
    finally:
        service.close()
