"""The child's side of the audio worker: obeys orders from its input until that ends, then ends itself.

The main thread reads and answers; a second one opens the device, loads the voice and renders, so that
neither can keep a ``Hush`` or a ``Ping`` waiting. Rendering and starting to sound are kept apart from a
hush by a count of hushes: what was ordered before one is not heard after it (S2).
"""

from __future__ import annotations

import os
import queue
import signal
import sys
import threading
from array import array
from collections.abc import Callable
from pathlib import Path
from typing import BinaryIO

from devices.audio_worker.messages import (
    Answer,
    Finished,
    Hush,
    Hushed,
    Ping,
    PlayCue,
    Pong,
    Refused,
    Say,
    SoundReady,
    Started,
    VoiceReady,
    from_line,
    to_line,
)
from devices.ports.audio import Cue
from devices.sound.lifeline import CAN_DIE_WITH_PARENT, die_with_parent
from devices.sound.own_sounds import OwnSounds, load, sound_of
from devices.sound.player import Player, open_player
from devices.sound.tones import CUE_NAMES, SAMPLE_RATE
from devices.speech.renderer import NoVoice, Renderer
from devices.speech.voices import VoiceSettings


class AudioWorker:
    """Obeys. ``answer`` may be called by any thread."""

    def __init__(
        self,
        answer: Callable[[Answer], None],
        device: str,
        prefer_bundled_voice: bool,
        own_sounds: OwnSounds,
    ) -> None:
        self._answer = answer
        self._device = device
        self._prefer_bundled_voice = prefer_bundled_voice
        self._own_sounds = own_sounds
        self._player: Player | None = None
        self._lock = threading.Lock()
        self._hushes = 0
        self._sentences: queue.SimpleQueue[tuple[int, Say]] = queue.SimpleQueue()

    def run(self, orders: BinaryIO) -> None:
        """Obey ``orders`` until they end."""
        threading.Thread(target=self._speak_for_ever, name="voice", daemon=True).start()
        for line in orders:
            self._obey(line)

    def _obey(self, line: bytes) -> None:
        match from_line(line):
            case Say() as sentence:
                self._sentences.put((self._hushes, sentence))
            case PlayCue() as order:
                self._play(order)
            case Hush(number=number, speech=speech, cues=cues):
                self._hush(speech, cues)
                self._answer(Hushed(number))
            case Ping(number=number):
                self._answer(self._pong(number))
            case _:
                pass

    def _play(self, order: PlayCue) -> None:
        if self._player is None or order.name not in CUE_NAMES:
            return
        sound = sound_of(Cue(order.name, order.bearing, order.steps), order.volume, self._own_sounds)
        self._player.cue(order.name, sound, order.delay)

    def _hush(self, speech: bool, cues: bool) -> None:
        with self._lock:
            self._hushes += speech
            if self._player is not None:
                self._player.hush(speech, cues)

    def _pong(self, number: int) -> Pong:
        frames = None if self._player is None else self._player.frames
        is_playing = self._player is not None and self._player.is_playing
        return Pong(number, -1 if frames is None else frames, is_playing)

    def _speak_for_ever(self) -> None:
        self._player = open_player(self._device)
        self._answer(SoundReady("" if self._player is None else self._player.name))
        renderer = self._load_voice()
        while True:
            hushes, sentence = self._sentences.get()
            self._speak(renderer, hushes, sentence)

    def _load_voice(self) -> Renderer | None:
        try:
            renderer = Renderer(self._prefer_bundled_voice)
        except NoVoice:
            self._answer(VoiceReady([]))
            return None
        self._answer(VoiceReady(list(renderer.languages)))
        return renderer

    def _speak(self, renderer: Renderer | None, hushes: int, sentence: Say) -> None:
        if hushes != self._hushes:
            return
        samples = _rendered(renderer, sentence)
        if samples is None:
            self._answer(Refused(sentence.number))
        else:
            self._sound(samples, hushes, sentence.number)

    def _sound(self, samples: array[int], hushes: int, number: int) -> None:
        with self._lock:
            if hushes != self._hushes or self._player is None:
                return
            self._answer(Started(number, len(samples) / SAMPLE_RATE))
            self._player.speak(samples, lambda: self._answer(Finished(number)))


def main() -> None:
    """Arguments: a device, ``system`` or ``bundled``, the parent, a folder with the learner's own sounds or
    an empty string. Orders on input 0, answers on output 1.
    """
    _end_with(int(sys.argv[3]))
    orders, answers = _keep_streams_to_ourselves()
    own_sounds, _broken = load(Path(sys.argv[4]) if sys.argv[4] else None)
    worker = AudioWorker(_writer(answers), sys.argv[1], sys.argv[2] == "bundled", own_sounds)
    worker.run(orders)
    _end_group()


def _rendered(renderer: Renderer | None, sentence: Say) -> array[int] | None:
    settings = VoiceSettings(sentence.words_per_minute, sentence.pitch, sentence.volume).clamped()
    try:
        return None if renderer is None else renderer.render(sentence.text, sentence.language, settings)
    except NoVoice:
        return None


def _end_with(parent: int) -> None:
    die_with_parent()
    if CAN_DIE_WITH_PARENT and os.getppid() != parent:  # it ended before we could ask
        os._exit(0)


def _keep_streams_to_ourselves() -> tuple[BinaryIO, BinaryIO]:
    """Our pipes, under numbers that no library knows; 0 reads nothing, 1 writes where 2 does: to the log."""
    orders, answers = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb", buffering=0)
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.dup2(2, 1)
    os.close(nothing)
    return orders, answers


def _writer(answers: BinaryIO) -> Callable[[Answer], None]:
    lock = threading.Lock()

    def write(answer: Answer) -> None:
        with lock:
            try:
                answers.write(to_line(answer))
            except OSError:  # nobody listens any more: the end of our orders follows
                return

    return write


def _end_group() -> None:
    """Ourselves and the players that we started, at once: a library's thread must not hold us."""
    if hasattr(os, "getpgrp") and os.getpgrp() == os.getpid():
        os.killpg(os.getpid(), signal.SIGKILL)
    os._exit(0)
