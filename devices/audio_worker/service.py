"""Carries out what the conductor decides: owns the writer thread and the audio worker process.

Everything that others call takes a lock for microseconds, notes what is wanted and returns: in every
state, with no device, a hung server, a dead worker, a full queue (S1). Starting, killing and telling are
the writer thread's, outside of the lock. The thread is made by the first thing to be heard and sleeps
while there is nothing to do.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping
from pathlib import Path
from time import monotonic
from typing import assert_never

from devices.audio_worker.conductor import Conductor
from devices.audio_worker.lifetime import State
from devices.audio_worker.messages import Answer
from devices.audio_worker.notices import AudioNotice
from devices.audio_worker.process import WorkerProcess
from devices.audio_worker.steps import Kill, Send, Start, Step, Tell
from devices.ports.audio import Cue, Utterance
from devices.ports.values import Frozen, field
from devices.sound.player import AUTO_DEVICE
from devices.speech.voices import VoiceSettings

_AWAY = 0.5
"""Seconds that the writer may oversleep before its own process is taken to have stood still."""

_CLOSING_SECONDS = 2.0


class AudioSettings(Frozen):
    """How Donnie sounds, and through what."""

    voice: VoiceSettings = field(default_factory=VoiceSettings)
    cue_volumes: Mapping[str, float] = field(default_factory=dict)
    """0 to 1 by the name of a cue; 1 where none is given, 0 switches it off."""
    device: str = AUTO_DEVICE
    """``auto``; ``null`` for one that throws everything away, ``none`` for a machine without one."""
    log: Path | None = None
    """Where the libraries' complaints go; nowhere if None. Never the terminal."""
    sounds: Path | None = None
    """A folder with the learner's own sounds, ``NAME.wav`` for a cue's name."""


class AudioService:
    """Voice and cues through one worker process. Any thread may call anything; nothing waits for sound."""

    def __init__(self, settings: AudioSettings, on_notice: Callable[[AudioNotice], None]) -> None:
        """Starts nothing. ``on_notice`` is called by the writer thread; it must not block nor raise."""
        self._settings = settings
        self._on_notice = on_notice
        self._conductor = Conductor(settings.voice, settings.cue_volumes)
        self._changed = threading.Condition()
        self._writer: threading.Thread | None = None
        self._process: WorkerProcess | None = None
        self._generation = 0

    @property
    def worker_pid(self) -> int | None:
        """Of the running worker, which is its process group too; None while there is none."""
        process = self._process
        return None if process is None else process.pid

    @property
    def state(self) -> State:
        return self._conductor.state

    @property
    def is_speaking(self) -> bool:
        """Whether the worker has a sentence to say."""
        return self._conductor.is_speaking

    @property
    def is_quiet(self) -> bool:
        """Whether nothing is being said nor waits to be said."""
        with self._changed:
            return self._conductor.is_quiet

    @property
    def player(self) -> str:
        """By what the worker sounds, such as ``miniaudio``; empty while nothing does."""
        with self._changed:
            return self._conductor.player

    @property
    def languages(self) -> tuple[str, ...]:
        """Of the voices that the worker found."""
        with self._changed:
            return self._conductor.languages

    @property
    def is_mute(self) -> bool:
        """Whether nothing will ever sound any more: no device, or the worker was given up."""
        return self._conductor.state.is_for_good

    def wait_until_ready(self, seconds: float) -> bool:
        """Wait until the worker is ready or never will be, ``seconds`` at most; False if not in time."""
        settled = (State.READY, State.SILENT, State.GIVEN_UP, State.CLOSED)
        with self._changed:
            return self._changed.wait_for(lambda: self._conductor.state in settled, seconds)

    def warm_up(self) -> None:
        """Start the worker in the background, so that the first sentence is not late."""
        with self._changed:
            self._conductor.warm_up()
            self._wake()

    def say(self, utterance: Utterance) -> None:
        with self._changed:
            self._conductor.say(utterance, monotonic())
            self._wake()

    def play(self, cue: Cue) -> None:
        with self._changed:
            self._conductor.play(cue, monotonic())
            self._wake()

    def silence_speech(self) -> None:
        with self._changed:
            self._conductor.hush_speech(monotonic())
            self._wake()

    def silence_cues(self) -> None:
        with self._changed:
            self._conductor.hush_cues(monotonic())
            self._wake()

    def set_voice(self, voice: VoiceSettings) -> None:
        """Rate, pitch and volume of the sentences from now on; clamped."""
        with self._changed:
            self._conductor.set_voice(voice)

    def set_cue_volumes(self, volumes: Mapping[str, float]) -> None:
        """Volumes of the cues from now on, as in ``AudioSettings``."""
        with self._changed:
            self._conductor.set_cue_volumes(volumes)

    def wait_until_quiet(self, seconds: float) -> bool:
        """Wait until everything was said, ``seconds`` at most; False if that was not enough.

        In the main thread Ctrl+C ends it, by ``KeyboardInterrupt``.
        """
        with self._changed:
            return self._changed.wait_for(lambda: self._conductor.is_quiet, seconds)

    def wait_until_still(self, seconds: float) -> bool:
        """Wait until nothing is said nor sounds, ``seconds`` at most; False if that was not enough."""
        with self._changed:
            return self._changed.wait_for(lambda: self._conductor.is_still(monotonic()), seconds)

    def close(self) -> None:
        """End the worker and everything that it started; from then on all is silent. Twice is once."""
        with self._changed:
            self._conductor.close()
            self._changed.notify_all()
            writer = self._writer
        if writer is not None and writer is not threading.current_thread():
            writer.join(_CLOSING_SECONDS)

    def _wake(self) -> None:
        if self._writer is None and self._conductor.state is not State.CLOSED:
            self._writer = threading.Thread(target=self._write, name="audio writer", daemon=True)
            self._writer.start()
        self._changed.notify_all()

    def _write(self) -> None:
        while True:
            with self._changed:
                steps = self._next_steps()
            for step in steps:
                self._carry_out(step)
            if self._conductor.state is State.CLOSED and not steps:
                return

    def _next_steps(self) -> tuple[Step, ...]:
        """Sleep until there is something to do, or nothing ever again. Holds the lock but while asleep."""
        while True:
            steps = self._conductor.advance(monotonic())
            if steps or self._conductor.state is State.CLOSED:
                return steps
            self._changed.notify_all()  # for those who wait until it is quiet
            self._sleep(self._conductor.next_date())

    def _sleep(self, until: float | None) -> None:
        self._changed.wait(None if until is None else max(0.0, until - monotonic()))
        overslept = 0.0 if until is None else monotonic() - until
        if overslept > _AWAY:
            self._conductor.was_away(overslept + _AWAY)

    def _carry_out(self, step: Step) -> None:
        match step:
            case Send(order=order):
                if self._process is not None:
                    self._process.send(order)
            case Start(prefer_bundled_voice=prefer_bundled):
                self._start_worker(prefer_bundled)
            case Kill():
                self._kill_worker()
            case Tell(notice=notice):
                self._on_notice(notice)
            case _:
                assert_never(step)

    def _start_worker(self, prefer_bundled_voice: bool) -> None:
        with self._changed:
            self._generation += 1
            generation = self._generation
        try:
            self._process = WorkerProcess(
                self._settings.device,
                prefer_bundled_voice,
                self._settings.log,
                self._settings.sounds,
                on_answer=lambda answer: self._answered(generation, answer),
                on_end=lambda: self._ended(generation),
            )
        except OSError:  # no more processes, no log file, no interpreter
            self._ended(generation)

    def _kill_worker(self) -> None:
        with self._changed:
            self._generation += 1
        if self._process is not None:
            self._process.kill()
            self._process = None

    def _answered(self, generation: int, answer: Answer) -> None:
        with self._changed:
            if generation == self._generation:
                self._conductor.answered(answer, monotonic())
                self._changed.notify_all()

    def _ended(self, generation: int) -> None:
        with self._changed:
            if generation == self._generation:
                self._conductor.ended(monotonic())
                self._changed.notify_all()
