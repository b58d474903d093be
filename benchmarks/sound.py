"""How soon sound begins and ends, how long its callers wait, and what a thousand sentences cost.

Everything is measured end to end: the service, its worker process, the device. The recorder is the sink of a
private PulseAudio where pulseaudio and parec are installed; its own 10 ms are included. While cues are played
two processes compute. Without a recorder only the callers' waiting and the cost are measured. Run: ``python
benchmarks/sound.py``
"""

from __future__ import annotations

import os
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from array import array
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from devices.audio.cues import SAMPLE_RATE
from devices.audio.process import (
    Say,
    Silenced,
    SpeechFinished,
    SpeechRefused,
    SpeechStarted,
    VoiceReady,
    to_line,
)
from devices.audio.service import AudioService, AudioSettings
from devices.audio.supervisor import WorkerState
from devices.audio.worker import AudioWorker
from devices.ports.audio import Cue, Urgency, Utterance

SENTENCES, SILENCES, CUES, UTTERANCES = 30, 30, 100, 1000
PATIENCE = 30.0
LOUD = 300
CHUNK = SAMPLE_RATE // 200
LONG = "one two three four five six seven eight nine ten " * 4


class Recorder:
    """Records when the sink was loud lately, by this machine's clock."""

    def __init__(self, recording: subprocess.Popen[bytes]) -> None:
        self._recording = recording
        self._changed = threading.Condition()
        self._loud: list[float] = []
        self._recorded_until = 0.0
        threading.Thread(target=self._listen, daemon=True).start()

    def until_loud(self, since: float) -> float:
        """Seconds from ``since`` to the first sound after it."""
        with self._changed:
            if not self._changed.wait_for(lambda: self._loud and self._loud[-1] > since, PATIENCE):
                sys.exit("nothing is recorded")
            return next(each for each in self._loud if each > since) - since

    def until_silent(self, since: float, silence: float = 0.4) -> float:
        """Seconds from ``since`` to the last sound before a silence of that length."""
        with self._changed:
            self._changed.wait_for(
                lambda: self._recorded_until > max(since, *self._loud[-1:]) + silence, PATIENCE
            )
            return max(0.0, self._loud[-1] - since)

    def _listen(self) -> None:
        assert self._recording.stdout is not None
        while len(chunk := self._recording.stdout.read(4 * CHUNK)) == 4 * CHUNK:
            with self._changed:
                self._recorded_until = time.monotonic()
                if max(array("h", chunk)) > LOUD:
                    self._loud.append(self._recorded_until)
                self._changed.notify_all()


def main() -> None:
    """Measure and print."""
    waits()
    grows()
    if shutil.which("pulseaudio") and shutil.which("parec"):
        with private_recorder() as recorder, ready() as audio:
            first_sound(recorder, audio)
            silence(recorder, audio)
            with busy():
                cues(recorder, audio)
    else:
        print("when it sounds: not measured, pulseaudio and parec are not installed")


def waits() -> None:
    """The longest time that ``say`` and ``play`` take, in different states of the worker."""
    _print_waits("no device", AudioSettings(device="none"), None)
    _print_waits("starting", AudioSettings(device="null"), None)
    _print_waits("ready", AudioSettings(device="null"), _nothing)
    _print_waits("frozen worker", AudioSettings(device="null"), lambda audio: _signal(audio, "STOP"))
    _print_waits("killed worker", AudioSettings(device="null"), lambda audio: _signal(audio, "KILL"))


def _print_waits(name: str, settings: AudioSettings, trouble: Callable[[AudioService], None] | None) -> None:
    audio = AudioService(settings, _nothing)
    try:
        if trouble is not None:
            audio.warm_up()
            audio.wait_until_ready(PATIENCE)
            trouble(audio)
        said = [_saying(audio, number) for number in range(UTTERANCES)]
        played = [_playing(audio) for _ in range(UTTERANCES)]
    finally:
        audio.close()
    _print(f"say blocks its caller, {name}", said, 0.005)
    _print(f"play blocks its caller, {name}", played, 0.002)


def _nothing(_: object) -> None:
    return


def _signal(audio: AudioService, name: str) -> None:
    if audio.worker_pid is not None:
        os.killpg(audio.worker_pid, getattr(signal, f"SIG{name}"))


def _saying(audio: AudioService, number: int) -> float:
    utterance = Utterance(f"{number}.", Urgency.PROGRAM, "en")
    began = time.perf_counter()
    audio.say(utterance)
    return time.perf_counter() - began


def _playing(audio: AudioService) -> float:
    began = time.perf_counter()
    audio.play(Cue("found"))
    return time.perf_counter() - began


def grows() -> None:
    """By how much the worker's side grows, in a process of its own, with a player that ends each sentence at
    once."""
    code = "from sound import speak_a_thousand; speak_a_thousand()"
    done = subprocess.run(
        (sys.executable, "-c", code), cwd=Path(__file__).parent, capture_output=True, text=True, check=False
    )
    print(done.stdout.splitlines()[-1] if done.returncode == 0 else f"not measured: {done.stderr[-200:]}")


class _PlayerAtOnce:
    """Reports the end of every sentence at once."""

    name, frames, is_playing = "at once", 0, False

    def speak(self, mono: array[int], on_end: Callable[[], None]) -> None:
        del mono
        on_end()

    def cue(self, name: str, stereo: array[int], delay: float) -> None: ...

    def silence(self, speech: bool, cues: bool) -> None: ...

    def close(self) -> None: ...


def speak_a_thousand() -> None:
    """In the process of ``grows``: prints the growth, the last line."""
    from devices.audio import worker

    setattr(worker, "open_player", lambda _: _PlayerAtOnce())  # noqa: B010 -- not the player of the types
    ended = threading.Semaphore(0)
    order: list[int] = []

    def answer(each: object) -> None:
        match each:
            case SpeechFinished(number=number):
                order.append(number)
                ended.release()
            case VoiceReady(languages=languages) if languages:
                ended.release()
            case SpeechRefused() | VoiceReady():
                sys.exit("no voice")
            case SpeechStarted() | Silenced() | _:
                pass

    made = AudioWorker(answer, "null", False, {}, {"en": ("en", "en-gb", "en-us")})
    threading.Thread(target=made._speak_for_ever, daemon=True).start()
    ended.acquire()
    warm = UTTERANCES // 20
    _say(made, ended, range(warm))
    before = _resident()
    _say(made, ended, range(warm, warm + UTTERANCES))
    grown = (_resident() - before) / 1e6
    how = "all, in order" if order == list(range(warm + UTTERANCES)) else "NOT ALL IN ORDER"
    print(f"{UTTERANCES} sentences: {how}, grown by {grown:.2f} of 10 MB")
    sys.stdout.flush()
    os._exit(0)


def _say(made: AudioWorker, ended: threading.Semaphore, numbers: range) -> None:
    for number in numbers:
        made._obey(to_line(Say(number, f"I walked {number} steps forward.", "en", 180, 50, 1.0)))
    for _ in numbers:
        ended.acquire()


def _resident() -> int:
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@contextmanager
def private_recorder() -> Iterator[Recorder]:
    """A private PulseAudio whose sink is recorded."""
    with tempfile.TemporaryDirectory() as folder:
        socket = f"{folder}/native"
        own = {**os.environ, "XDG_RUNTIME_DIR": folder, "HOME": folder, "PULSE_SERVER": f"unix:{socket}"}
        sink = f"module-null-sink sink_name=recorder rate={SAMPLE_RATE}"
        line = f"module-native-protocol-unix socket={socket} auth-anonymous=1"
        quiet = {"env": own, "stderr": subprocess.DEVNULL}
        server = subprocess.Popen(
            ["pulseaudio", "-n", "--daemonize=no", "--exit-idle-time=-1", "--disable-shm=yes",
             "--use-pid-file=no", "-L", line, "-L", sink], stdout=subprocess.DEVNULL, **quiet,  # type: ignore[call-overload]
        )  # fmt: skip
        while not Path(socket).exists():
            time.sleep(0.05)
        recording = subprocess.Popen(
            ["parec", "-d", "recorder.monitor", "--format=s16le", f"--rate={SAMPLE_RATE}", "--channels=2",
             "--latency-msec=10"], stdout=subprocess.PIPE, **quiet,  # type: ignore[call-overload]
        )  # fmt: skip
        os.environ["PULSE_SERVER"] = f"unix:{socket}"
        try:
            yield Recorder(recording)
        finally:
            for each in (recording, server):
                each.kill()
                each.wait()


@contextmanager
def ready() -> Iterator[AudioService]:
    """With its voice loaded and used once."""
    audio = AudioService(AudioSettings(), lambda notice: sys.exit(f"{notice}"))
    audio.warm_up()
    audio.wait_until_ready(PATIENCE)
    if audio.state is not WorkerState.READY:
        sys.exit(f"no sound: {audio.state}")
    audio.say(Utterance("Warm.", Urgency.ANSWER, "en"))
    audio.wait_until_silent(PATIENCE)
    try:
        yield audio
    finally:
        audio.close()


@contextmanager
def busy() -> Iterator[None]:
    """Two processes that compute meanwhile."""
    computing = [subprocess.Popen((sys.executable, "-c", "while True: pass")) for _ in range(2)]
    try:
        yield
    finally:
        for each in computing:
            each.kill()
            each.wait()


def first_sound(recorder: Recorder, audio: AudioService) -> None:
    took = []
    for number in range(SENTENCES):
        asked = time.monotonic()
        audio.say(Utterance(f"I walked {number} steps.", Urgency.ANSWER, "en"))
        took.append(recorder.until_loud(asked))
        audio.silence_speech()
        recorder.until_silent(time.monotonic())
    _print("say to the first sound", took, 0.2)


def silence(recorder: Recorder, audio: AudioService) -> None:
    took = []
    for _ in range(SILENCES):
        audio.say(Utterance(LONG, Urgency.PROGRAM, "en"))
        audio.say(Utterance("This is silenced.", Urgency.PROGRAM, "en"))
        recorder.until_loud(time.monotonic())
        asked = time.monotonic()
        audio.silence_speech()
        took.append(recorder.until_silent(asked))
    _print("silence", took, 0.15)


def cues(recorder: Recorder, audio: AudioService) -> None:
    took = []
    for _ in range(CUES):
        asked = time.monotonic()
        audio.play(Cue("step-forward"))
        took.append(recorder.until_loud(asked))
        recorder.until_silent(time.monotonic(), silence=0.1)
    _print("cue to its sound, two processes computing", took, 0.1)


def _print(name: str, took: list[float], target: float) -> None:
    in_time = sum(each <= target for each in took)
    print(
        f"{name}: {_ms(statistics.median(took))} in the middle, {_ms(max(took))} at the most; "
        f"{in_time} of {len(took)} within {_ms(target)}"
    )


def _ms(seconds: float) -> str:
    return f"{1000 * seconds:.{2 if seconds < 0.002 else 0}f} ms"


if __name__ == "__main__":
    main()
