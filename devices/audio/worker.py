"""The audio worker: obeys requests from its input until that ends, then ends itself. Renders sentences.

The main thread reads and responds. A second thread opens the device, loads the voice and renders, so it can't
delay a ``Silence`` or a ``Ping``. Speech that was requested before a silence must not sound after it: each
sentence carries the number of silences before it, and is dropped if there was another one since.

pyttsx3 is used only as a renderer: ``save_to_file`` and ``runAndWait``. Its ``say`` and ``stop`` are not
used: on Linux the one repeats and drops sentences, the other stops nothing and hangs. It accepts unknown
voices silently and keeps the old one, so each setting is read back. The system's espeak-ng is preferred to
the one in espeakng-loader.

Started by ``process`` only: ``python -m devices.audio.worker DEVICE VOICE PARENT SOUNDS VOICES``."""

from __future__ import annotations

import ctypes
import importlib
import os
import queue
import signal
import sys
import threading
from array import array
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, BinaryIO

from msgspec import Struct

from devices.audio.cues import (
    CUE_NAMES,
    SAMPLE_RATE,
    NotWav,
    UserSounds,
    load_user_sounds,
    read_mono,
    render_cue,
)
from devices.audio.players import Player, open_player, scratch_file
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
from devices.ports.audio import Cue, VoiceSettings, base_language

_MOST_TRIES = 5
_MOST_POLLS = 1_000
_POLL_SECONDS = 0.001
_SYSTEM_LIBRARY = "libespeak-ng.so.1"


class NoVoice(Exception):
    """Nothing here can speak, or not in that language."""


class InstalledVoice(Struct, frozen=True):
    """A voice that a synthesiser has."""

    identifier: str
    """The synthesiser's own name for it, such as ``roa/pt-br``."""
    languages: tuple[str, ...]
    """Language tags, in any case, such as ``pt-br``."""


class Renderer:
    """A voice for each language that has one. Belongs to one thread."""

    def __init__(self, preferred: Mapping[str, tuple[str, ...]], prefer_bundled: bool = False) -> None:
        """Load it, some 0.1 s. ``preferred``: the tags of the voices of each language, the best one first.

        ``prefer_bundled`` ignores the system's espeak-ng. Raises ``NoVoice``.
        """
        _make_espeak_findable(prefer_bundled)
        self._engine = _start_engine()
        self._speaks_espeak = self._engine.driver_name == "espeak"
        self._pause = threading.Event()
        self._try_it()
        self._voices = self._working_voices(preferred)
        if not self._voices:
            raise NoVoice

    @property
    def languages(self) -> tuple[str, ...]:
        """The languages whose voice was found, and accepted when it was tried."""
        return tuple(self._voices)

    def render(self, text: str, language: str, settings: VoiceSettings) -> array[int]:
        """16-bit mono samples at ``SAMPLE_RATE``. Raises ``NoVoice`` instead of using another language's
        voice."""
        voice = self._voices.get(base_language(language))
        if voice is None or not self._takes(voice):
            raise NoVoice
        if not text.strip():  # pyttsx3 would never return
            return array("h")
        self._set("rate", settings.words_per_minute)
        self._set("volume", round(settings.volume, 2))
        if self._speaks_espeak:  # the other drivers know no pitch
            self._set("pitch", settings.pitch)
        return self._rendered(text)

    def _try_it(self) -> None:
        """Render a first sentence: pyttsx3 postpones all settings until it has rendered one."""
        if not self._rendered("a"):
            raise NoVoice

    def _rendered(self, text: str) -> array[int]:
        self._wait_until_idle()
        with scratch_file() as (path, _):
            self._engine.save_to_file(text, path)
            self._engine.runAndWait()
            return _samples(path)

    def _set(self, name: str, value: float) -> None:
        """Set it until it has the value: espeak-ng applies it later, and loses it if another call comes
        between."""
        for _ in range(_MOST_TRIES):
            if self._engine.getProperty(name) == value:
                return
            self._engine.setProperty(name, value)
            self._wait_until_idle()

    def _wait_until_idle(self) -> None:
        """Wait until espeak-ng is idle.

        Otherwise pyttsx3, which ends every loop with a cancel if espeak-ng is busy, would lose pending
        settings or the next sentence.
        """
        if self._speaks_espeak:
            espeak = importlib.import_module("pyttsx3.drivers._espeak")
            for _ in range(_MOST_POLLS):
                if not espeak.IsPlaying():
                    return
                self._pause.wait(_POLL_SECONDS)

    def _working_voices(self, preferred: Mapping[str, tuple[str, ...]]) -> dict[str, InstalledVoice]:
        offered = [
            InstalledVoice(each.id, _tags(each.languages)) for each in self._engine.getProperty("voices")
        ]
        chosen = {language: choose_voice(tags, offered) for language, tags in preferred.items()}
        return {language: voice for language, voice in chosen.items() if voice and self._takes(voice)}

    def _takes(self, voice: InstalledVoice) -> bool:
        self._engine.setProperty("voice", voice.identifier)
        return bool(self._engine.getProperty("voice") == voice.identifier)


def _samples(path: str) -> array[int]:
    try:
        return read_mono(path)
    except NotWav as reason:
        raise NoVoice from reason


def _make_espeak_findable(prefer_bundled: bool) -> None:
    """Load the bundled library globally, under its own name, so pyttsx3 finds it by that name."""
    if not sys.platform.startswith("linux") or (not prefer_bundled and _is_loadable(_SYSTEM_LIBRARY)):
        return
    try:
        import espeakng_loader

        os.environ["ESPEAK_DATA_PATH"] = espeakng_loader.get_data_path()
        ctypes.CDLL(espeakng_loader.get_library_path(), mode=ctypes.RTLD_GLOBAL)
    except (ImportError, OSError, RuntimeError):
        os.environ.pop("ESPEAK_DATA_PATH", None)  # pyttsx3 may still find one


def _is_loadable(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True


def _start_engine() -> Any:  # pyttsx3 ships no types
    try:
        import pyttsx3

        return pyttsx3.init()
    except (
        Exception
    ) as reason:  # a driver raises what its system raises; all of it means that there is no voice
        raise NoVoice from reason


def _tags(languages: object) -> tuple[str, ...]:
    """pyttsx3's drivers give strings or bytes, or nothing."""
    tags = languages if isinstance(languages, list | tuple) else ()
    return tuple(tag.decode("ascii", "ignore") if isinstance(tag, bytes) else str(tag) for tag in tags)


def choose_voice(preferred: Iterable[str], voices: Iterable[InstalledVoice]) -> InstalledVoice | None:
    """The best of ``voices`` by the tags that are preferred, or None if none of them has one."""
    offered = [(_tags_of(voice), voice) for voice in voices if _is_complete(voice)]
    for wanted in preferred:
        for tags, voice in offered:
            if wanted in tags:
                return voice
    return None


def _tags_of(voice: InstalledVoice) -> frozenset[str]:
    own_name = voice.identifier.lower().rsplit("/", 1)[-1]
    return frozenset({tag.lower().replace("_", "-") for tag in voice.languages} | {own_name})


def _is_complete(voice: InstalledVoice) -> bool:
    """espeak-ng lists MBROLA voices even where their data, a separate package, are missing."""
    return not voice.identifier.lower().startswith("mb/")


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
