"""Voice and cues through a private PulseAudio whose sink is recorded."""

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

from devices.audio.cues import seconds_of
from devices.audio.service import AudioService, AudioSettings
from devices.ports.audio import AudioNotice, Cue, NoticeCode, Urgency, Utterance
from tests.conftest import ROOT
from tests.sessions.learner import BACKSPACE, CTRL_D, Learner
from tests.timeouts import TIMEOUT

RATE = 22_050
CHUNK = RATE // 20
"""Frames: a twentieth of a second."""

LOUD = 500
MOST_CHUNKS = 400
"""Chunks after which the test gives up: twenty seconds of sound."""

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(
        not (shutil.which("pulseaudio") and shutil.which("parec")), reason="needs pulseaudio and parec"
    ),
]


class Recorder:
    """Records the sink, in stereo."""

    def __init__(self, recording: subprocess.Popen[bytes], server: subprocess.Popen[bytes]) -> None:
        self._recording = recording
        self.server = server

    def next_chunk(self) -> array[int]:
        assert self._recording.stdout is not None
        return array("h", self._recording.stdout.read(4 * CHUNK))

    def first_sound(self) -> array[int] | None:
        """The first loud chunk, None if there is none."""
        return next((chunk for _ in range(MOST_CHUNKS) if max(chunk := self.next_chunk()) > LOUD), None)

    def chunks_until_silence(self) -> int:
        """How many chunks pass until half a second of silence begins."""
        silent = 0
        for number in range(MOST_CHUNKS):
            silent = 0 if max(self.next_chunk()) > LOUD else silent + 1
            if silent == 10:
                return number - 9
        return MOST_CHUNKS


@pytest.fixture
def recorder(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Iterator[Recorder]:
    folder = tmp_path_factory.mktemp("pulse")
    socket = folder / "native"
    server = subprocess.Popen(
        [
            "pulseaudio", "-n", "--daemonize=no", "--exit-idle-time=-1", "--disable-shm=yes",
            "--use-pid-file=no", "-L", f"module-native-protocol-unix socket={socket} auth-anonymous=1",
            "-L", f"module-null-sink sink_name=recorder rate={RATE}",
        ],
        env=_environment(folder), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip
    monkeypatch.setenv("PULSE_SERVER", f"unix:{socket}")
    recording = subprocess.Popen(
        ["/bin/sh", "-c", f'while ! [ -S "{socket}" ]; do sleep 0.05; done; exec parec -d recorder.monitor '
         f"--format=s16le --rate={RATE} --channels=2 --latency-msec=20"],
        env={**_environment(folder), "PULSE_SERVER": f"unix:{socket}"}, stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
    )  # fmt: skip
    try:
        made = Recorder(recording, server)
        made.next_chunk()  # the sink is there
        yield made
    finally:
        for process in (recording, server):
            process.kill()
            process.wait()


def _environment(folder: Path) -> dict[str, str]:
    return {**os.environ, "XDG_RUNTIME_DIR": str(folder), "HOME": str(folder)}


@pytest.fixture
def audio(recorder: Recorder) -> Iterator[AudioService]:
    del recorder
    notices: list[AudioNotice] = []
    made = AudioService(AudioSettings(), notices.append)
    yield made
    made.close()
    assert notices == []


def test_a_sentence_sounds_and_ends_when_it_is_silenced(recorder: Recorder, audio: AudioService) -> None:
    sentence = "one two three four five six seven eight nine ten " * 8
    audio.say(Utterance(sentence, Urgency.PROGRAM, "en"))
    assert recorder.first_sound()
    audio.silence_speech()
    assert recorder.chunks_until_silence() < 60
    assert audio.is_quiet


def test_a_cue_sounds_on_its_side(recorder: Recorder, audio: AudioService) -> None:
    audio.play(Cue("bump", 90.0, None))
    chunk = recorder.first_sound()
    assert chunk
    assert max(chunk[1::2]) > 4 * max(chunk[0::2])


# --- a whole session


def test_a_key_at_the_terminal_ends_the_own_voice(recorder: Recorder, tmp_path: Path) -> None:
    """The answer to the next command is spoken again."""
    learner = after_greeting(recorder, Learner(tmp_path, "--speech", "tts"))
    learner.types(f'SPEAK "{"one two three four five six seven eight nine ten " * 4}"\r\r')
    learner.sees_prompt()
    assert recorder.first_sound()
    learner.types("W")
    assert recorder.chunks_until_silence() < 60
    learner.types("HERE\r")
    assert recorder.first_sound()


def test_the_goodbye_is_spoken(recorder: Recorder, tmp_path: Path) -> None:
    """A learner with Donnie's own voice alone knows by it that Donnie has ended."""
    learner = after_greeting(recorder, Learner(tmp_path, "--speech", "tts"))
    learner.types(CTRL_D)

    assert recorder.first_sound()
    assert learner.leaves() == 0


def after_greeting(recorder: Recorder, learner: Learner) -> Learner:
    """The learner, after the greeting was interrupted."""
    learner.sees_prompt()
    assert recorder.first_sound()
    learner.types(f" {BACKSPACE}")
    assert recorder.chunks_until_silence() < 60
    return learner


def test_the_cue_of_the_programs_end_sounds_to_its_end(recorder: Recorder, tmp_path: Path) -> None:
    """Its cue is longer than what is left to do; only a stop shortens it.

    Five runs, as the recorder of a busy machine loses some sound, while a cue that is cut is cut each time.
    """
    (tmp_path / "a.gd").write_text("TR 10")
    # the last part of the cue fades, and may be below what counts as loud
    assert any((loud_chunks(recorder, tmp_path) + 1) * CHUNK / RATE >= seconds_of("done") for _ in range(5))


def loud_chunks(recorder: Recorder, folder: Path) -> int:
    """How many chunks of a run are loud."""
    options = ("--speech", "off", "--sound", "on", "--speed", "max")
    command = (sys.executable, "-m", "donnie_tui", "run", "a.gd", *options)
    with subprocess.Popen(command, cwd=folder, env={**os.environ, "PYTHONPATH": str(ROOT)}) as run:
        assert recorder.first_sound()
        loud, silent = 1, 0
        while run.poll() is None or silent < 10:  # on a busy machine another cue may sound long before
            silent = 0 if max(recorder.next_chunk()) > LOUD else silent + 1
            loud += not silent
    assert run.returncode == 0
    return loud


# --- the sound server hangs, or is gone

LONG = "one two three four five six seven eight nine ten " * 8


def eventually(is_so: Callable[[], bool]) -> bool:
    end = time.monotonic() + TIMEOUT
    while not is_so() and time.monotonic() < end:
        time.sleep(0.01)
    return is_so()


def test_after_a_hang_of_the_sound_server_the_sentence_is_said_again(
    recorder: Recorder, audio: AudioService
) -> None:
    """A player that plays no frames is replaced, and the sentence is said again."""
    audio.say(Utterance(LONG, Urgency.PROGRAM, "en"))
    assert recorder.first_sound()
    before = audio.worker_pid
    recorder.server.send_signal(signal.SIGSTOP)
    try:
        assert eventually(lambda: audio.worker_pid != before)
    finally:
        recorder.server.send_signal(signal.SIGCONT)
    assert recorder.first_sound()


def test_a_device_that_disappears_is_reported_once_and_no_caller_waits(recorder: Recorder) -> None:
    notices: list[AudioNotice] = []
    service = AudioService(AudioSettings(), notices.append)
    try:
        service.say(Utterance(LONG, Urgency.PROGRAM, "en"))
        assert recorder.first_sound()
        recorder.server.kill()

        assert eventually(lambda: bool(notices))
        assert service.is_quiet
        service.say(Utterance(LONG, Urgency.PROGRAM, "en"))
        assert service.is_quiet
        assert notices[0].code in (NoticeCode.NO_SOUND_DEVICE, NoticeCode.AUDIO_GAVE_UP)
        assert len(notices) == 1
    finally:
        service.close()
