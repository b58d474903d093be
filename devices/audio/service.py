"""Voice and cues through one audio worker process. What the rest of Donnie uses:

``AudioService(AudioSettings(), on_notice)`` starts nothing. It is a ``Speaker`` and a ``CuePlayer``. Call
``warm_up`` after the first prompt or frame; ``close`` leaves nothing running.

Every call takes a lock for microseconds, notes what is wanted and returns: also without a device, with a
server that hangs, a dead worker or a full queue. One writer thread starts and kills the worker and calls the
listener, outside of the lock. The first sentence or cue starts the thread, and it sleeps while there is
nothing to do.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping
from pathlib import Path
from time import monotonic
from typing import assert_never

from msgspec import Struct, field

from devices.audio.players import AUTO_DEVICE
from devices.audio.process import AudioResponse, WorkerProcess
from devices.audio.pronunciation import ENGLISH_ONLY, SpokenLanguage
from devices.audio.supervisor import (
    KillWorker,
    Notify,
    SendRequest,
    StartWorker,
    Step,
    WorkerState,
    WorkerSupervisor,
)
from devices.ports.audio import AudioNotice, Cue, Utterance, VoiceSettings

_AWAY = 0.5
"""Seconds that the writer may oversleep before its process counts as suspended."""

_CLOSING_SECONDS = 2.0


class AudioSettings(Struct, frozen=True):
    """How Donnie sounds, and through what."""

    voice: VoiceSettings = field(default_factory=VoiceSettings)
    cue_volumes: Mapping[str, float] = field(default_factory=dict)
    """0 to 1 by the name of a cue; 1 where none is given, 0 switches it off."""
    device: str = AUTO_DEVICE
    """``auto``; ``null`` for one that throws everything away, ``none`` for a machine without one."""
    log: Path | None = None
    """Where the libraries' messages go; nowhere if None. Never the terminal."""
    sounds: Path | None = None
    """A folder with the learner's own sounds, ``NAME.wav`` for a cue's name."""
    languages: Mapping[str, SpokenLanguage] = field(default_factory=lambda: ENGLISH_ONLY)
    """By code, the languages that are spoken."""


class AudioService:
    """Voice and cues through one worker process. Any thread may call any method."""

    def __init__(self, settings: AudioSettings, on_notice: Callable[[AudioNotice], None]) -> None:
        """Starts nothing. ``on_notice`` is called by the writer thread; it must not block or raise."""
        self._settings = settings
        self._on_notice = on_notice
        self._supervisor = WorkerSupervisor(settings.voice, settings.cue_volumes, settings.languages)
        self._changed = threading.Condition()
        self._writer: threading.Thread | None = None
        self._process: WorkerProcess | None = None
        self._generation = 0

    @property
    def worker_pid(self) -> int | None:
        """The number of the running worker and of its process group; None while there is none."""
        process = self._process
        return None if process is None else process.pid

    @property
    def state(self) -> WorkerState:
        return self._supervisor.state

    @property
    def is_speaking(self) -> bool:
        """Whether the worker has a sentence to say."""
        return self._supervisor.is_speaking

    @property
    def is_quiet(self) -> bool:
        """Whether no sentence is being said or waits."""
        with self._changed:
            return self._supervisor.is_quiet

    @property
    def player(self) -> str:
        """The name of the worker's player, such as ``miniaudio``; empty while there is none."""
        with self._changed:
            return self._supervisor.player

    @property
    def languages(self) -> tuple[str, ...]:
        """The languages of the voices that the worker found."""
        with self._changed:
            return self._supervisor.languages

    @property
    def is_mute(self) -> bool:
        """Whether nothing will ever sound any more: there is no device, or the worker was given up."""
        return self._supervisor.state.is_final

    def wait_until_ready(self, seconds: float) -> bool:
        """Wait until the worker is ready or never will be. False if that took longer than ``seconds``."""
        with self._changed:
            return self._changed.wait_for(
                lambda: self.state is WorkerState.READY or self.state.is_final, seconds
            )

    def warm_up(self) -> None:
        """Start the worker in the background, so the first sentence is not late."""
        with self._changed:
            self._supervisor.warm_up()
            self._wake()

    def say(self, utterance: Utterance) -> None:
        with self._changed:
            self._supervisor.say(utterance, monotonic())
            self._wake()

    def play(self, cue: Cue) -> None:
        with self._changed:
            self._supervisor.play(cue, monotonic())
            self._wake()

    def silence_speech(self) -> None:
        with self._changed:
            self._supervisor.silence_speech(monotonic())
            self._wake()

    def silence_cues(self) -> None:
        with self._changed:
            self._supervisor.silence_cues(monotonic())
            self._wake()

    def set_voice(self, voice: VoiceSettings) -> None:
        """Rate, pitch and volume of the sentences from now on; clamped."""
        with self._changed:
            self._supervisor.set_voice(voice)

    def set_cue_volumes(self, volumes: Mapping[str, float]) -> None:
        """Volumes of the cues from now on, as in ``AudioSettings``."""
        with self._changed:
            self._supervisor.set_cue_volumes(volumes)

    def wait_until_quiet(self, seconds: float) -> bool:
        """Wait until everything was said. False if that took longer than ``seconds``.

        In the main thread Ctrl+C ends it, with ``KeyboardInterrupt``.
        """
        with self._changed:
            return self._changed.wait_for(lambda: self._supervisor.is_quiet, seconds)

    def wait_until_silent(self, seconds: float) -> bool:
        """Wait until no sentence or cue sounds. False if that took longer than ``seconds``."""
        with self._changed:
            return self._changed.wait_for(lambda: self._supervisor.is_silent(monotonic()), seconds)

    def close(self) -> None:
        """End the worker and everything that it started, for good. May be called twice."""
        with self._changed:
            self._supervisor.close()
            self._changed.notify_all()
            writer = self._writer
        if writer is not None and writer is not threading.current_thread():
            writer.join(_CLOSING_SECONDS)

    def _wake(self) -> None:
        if self._writer is None and self._supervisor.state is not WorkerState.CLOSED:
            self._writer = threading.Thread(target=self._write, name="audio writer", daemon=True)
            self._writer.start()
        self._changed.notify_all()

    # --- the writer thread

    def _write(self) -> None:
        while True:
            with self._changed:
                steps = self._next_steps()
            for step in steps:
                self._carry_out(step)
            if self._supervisor.state is WorkerState.CLOSED and not steps:
                return

    def _next_steps(self) -> tuple[Step, ...]:
        """Sleep until there is something to do, or the service is closed. Holds the lock except in sleep."""
        while True:
            steps = self._supervisor.advance(monotonic())
            if steps or self._supervisor.state is WorkerState.CLOSED:
                return steps
            self._changed.notify_all()  # wakes the threads that wait until it is quiet
            self._sleep(self._supervisor.next_at())

    def _sleep(self, until: float | None) -> None:
        self._changed.wait(None if until is None else max(0.0, until - monotonic()))
        overslept = 0.0 if until is None else monotonic() - until
        if overslept > _AWAY:
            self._supervisor.was_away(overslept + _AWAY)

    def _carry_out(self, step: Step) -> None:
        match step:
            case SendRequest(request=request):
                if self._process is not None:
                    self._process.send(request)
            case StartWorker(prefer_bundled_voice=prefer_bundled):
                self._start_worker(prefer_bundled)
            case KillWorker():
                self._kill_worker()
            case Notify(notice=notice):
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
                {code: each.voices for code, each in self._settings.languages.items()},
                on_response=lambda response: self._received(generation, response),
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

    # --- called by the reading thread of a worker, perhaps of one that was replaced meanwhile

    def _received(self, generation: int, response: AudioResponse) -> None:
        with self._changed:
            if generation == self._generation:
                self._supervisor.received(response, monotonic())
                self._changed.notify_all()

    def _ended(self, generation: int) -> None:
        with self._changed:
            if generation == self._generation:
                self._supervisor.ended(monotonic())
                self._changed.notify_all()
