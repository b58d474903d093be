"""The worker's side: obeys requests from its input until that ends, then ends itself.

The main thread reads and responds. A second thread opens the device, loads the voice and renders, so it can't
delay a ``Silence`` or a ``Ping``. Speech that was requested before a silence must not sound after it: each
sentence carries the number of silences before it, and is dropped if there was another one since.

Started by ``process`` only: ``python -m devices.audio.worker DEVICE VOICE PARENT SOUNDS``.
"""

from __future__ import annotations

import os
import queue
import signal
import sys
import threading
from array import array
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import BinaryIO

from devices.audio.cues import CUE_NAMES, SAMPLE_RATE, UserSounds, load_user_sounds, render_cue
from devices.audio.players import Player, open_player
from devices.audio.process import (
    CAN_DIE_WITH_PARENT,
    AudioResponse,
    Ping,
    PlayCue,
    Pong,
    Say,
    Silence,
    Silenced,
    SoundReady,
    SpeechFinished,
    SpeechRefused,
    SpeechStarted,
    VoiceReady,
    die_with_parent,
    request_from,
    to_line,
)
from devices.audio.renderer import NoVoice, Renderer
from devices.ports.audio import Cue, VoiceSettings


class AudioWorker:
    """Obeys requests. ``respond`` may be called by any thread."""

    def __init__(
        self,
        respond: Callable[[AudioResponse], None],
        device: str,
        prefer_bundled_voice: bool,
        user_sounds: UserSounds,
        preferred_voices: Mapping[str, tuple[str, ...]],
    ) -> None:
        """``preferred_voices``: the tags of the voices of each language, the best one first."""
        self._respond = respond
        self._device = device
        self._prefer_bundled_voice = prefer_bundled_voice
        self._user_sounds = user_sounds
        self._preferred_voices = preferred_voices
        self._player: Player | None = None
        self._lock = threading.Lock()
        self._silences = 0
        self._sentences: queue.SimpleQueue[tuple[int, Say]] = queue.SimpleQueue()

    def run(self, requests: BinaryIO) -> None:
        """Obey ``requests`` until they end."""
        threading.Thread(target=self._speak_for_ever, name="voice", daemon=True).start()
        for line in requests:
            self._obey(line)

    def _obey(self, line: bytes) -> None:
        match request_from(line):
            case Say() as sentence:
                self._sentences.put((self._silences, sentence))
            case PlayCue() as request:
                self._play(request)
            case Silence(number=number, speech=speech, cues=cues):
                self._silence(speech, cues)
                self._respond(Silenced(number))
            case Ping(number=number):
                self._respond(self._pong(number))
            case None:
                pass

    def _play(self, request: PlayCue) -> None:
        if self._player is None or request.name not in CUE_NAMES:
            return
        cue = Cue(request.name, request.bearing, request.steps)
        self._player.cue(request.name, render_cue(cue, request.volume, self._user_sounds), request.delay)

    def _silence(self, speech: bool, cues: bool) -> None:
        with self._lock:
            self._silences += speech
            if self._player is not None:
                self._player.silence(speech, cues)

    def _pong(self, number: int) -> Pong:
        frames = None if self._player is None else self._player.frames
        is_playing = self._player is not None and self._player.is_playing
        return Pong(number, -1 if frames is None else frames, is_playing)

    def _speak_for_ever(self) -> None:
        self._player = open_player(self._device)
        self._respond(SoundReady("" if self._player is None else self._player.name))
        renderer = self._load_voice()
        while True:
            silences, sentence = self._sentences.get()
            self._speak(renderer, silences, sentence)

    def _load_voice(self) -> Renderer | None:
        try:
            renderer = Renderer(self._preferred_voices, self._prefer_bundled_voice)
        except NoVoice:
            self._respond(VoiceReady(()))
            return None
        self._respond(VoiceReady(renderer.languages))
        return renderer

    def _speak(self, renderer: Renderer | None, silences: int, sentence: Say) -> None:
        if silences != self._silences:
            return
        samples = _rendered(renderer, sentence)
        if samples is None:
            self._respond(SpeechRefused(sentence.number))
            return
        with self._lock:
            if silences != self._silences or self._player is None:
                return
            self._respond(SpeechStarted(sentence.number, len(samples) / SAMPLE_RATE))
            self._player.speak(samples, lambda: self._respond(SpeechFinished(sentence.number)))


def _rendered(renderer: Renderer | None, sentence: Say) -> array[int] | None:
    settings = VoiceSettings(sentence.words_per_minute, sentence.pitch, sentence.volume).clamped()
    try:
        return None if renderer is None else renderer.render(sentence.text, sentence.language, settings)
    except NoVoice:
        return None


def main() -> None:
    """Arguments: a device, ``system`` or ``bundled``, the parent's process id, a folder with the learner's
    own sounds or an empty string, and the voices such as ``en=en,en-gb pt=pt-br,pt``. Requests on input 0,
    responses on output 1."""
    _end_with(int(sys.argv[3]))
    requests, responses = _take_streams()
    user_sounds, _broken = load_user_sounds(Path(sys.argv[4]) if sys.argv[4] else None)
    preferred = {
        code: tuple(tags.split(",")) for code, tags in (each.split("=") for each in sys.argv[5].split())
    }
    worker = AudioWorker(_responder(responses), sys.argv[1], sys.argv[2] == "bundled", user_sounds, preferred)
    worker.run(requests)
    _end_group()


def _end_with(parent: int) -> None:
    die_with_parent()
    if CAN_DIE_WITH_PARENT and os.getppid() != parent:  # it ended before die_with_parent was called
        os._exit(0)


def _take_streams() -> tuple[BinaryIO, BinaryIO]:
    """The pipes, under descriptors that no library knows. 0 then reads nothing, 1 writes to the log, as 2
    does."""
    requests, responses = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb", buffering=0)
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.dup2(2, 1)
    os.close(nothing)
    return requests, responses


def _responder(responses: BinaryIO) -> Callable[[AudioResponse], None]:
    lock = threading.Lock()

    def respond(response: AudioResponse) -> None:
        with lock:
            try:
                responses.write(to_line(response))
            except OSError:  # the parent is gone: the end of the requests follows
                return

    return respond


def _end_group() -> None:
    """End this process and the players that it started at once: a thread of a library must not delay it."""
    if hasattr(os, "getpgrp") and os.getpgrp() == os.getpid():
        os.killpg(os.getpid(), signal.SIGKILL)
    os._exit(0)


if __name__ == "__main__":
    main()
