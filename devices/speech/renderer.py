"""Turns a sentence into sound with pyttsx3, in the audio worker only.

pyttsx3 is used as a renderer and nothing else: ``save_to_file`` and ``runAndWait``. Its ``say`` and its
``stop`` are called nowhere (S5): on Linux the one repeats and swallows, the other cuts nothing and hangs.
It accepts unknown voices without a word and keeps the old one, so what was set is read back (S10).

The system's espeak-ng comes first, then the one that espeakng-loader brings.
"""

from __future__ import annotations

import ctypes
import importlib
import os
import sys
import tempfile
import threading
from array import array
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from devices.sound.wav_file import NotWav, read_mono
from devices.speech.voices import LANGUAGES, Voice, VoiceSettings, base_language, choose_voice

_MOST_TRIES = 5
_MOST_POLLS = 1_000
_POLL_SECONDS = 0.001
_SYSTEM_LIBRARY = "libespeak-ng.so.1"


class NoVoice(Exception):
    """Nothing here can speak, or not in the language asked for."""


class Renderer:
    """A voice for each language that has one. Belongs to one thread."""

    def __init__(self, prefer_bundled: bool = False) -> None:
        """Load it, some 0.1 s. ``prefer_bundled`` passes a system's espeak-ng over. Raises ``NoVoice``."""
        _make_espeak_findable(prefer_bundled)
        self._engine = _start_engine()
        self._speaks_espeak = self._engine.driver_name == "espeak"
        self._pause = threading.Event()
        self._try_it()
        self._voices = self._working_voices()
        if not self._voices:
            raise NoVoice

    @property
    def languages(self) -> tuple[str, ...]:
        """Those that a voice was found for, and that took it when it was tried."""
        return tuple(self._voices)

    def render(self, text: str, language: str, settings: VoiceSettings) -> array[int]:
        """16-bit mono samples at ``SAMPLE_RATE``. Raises ``NoVoice`` rather than use another language's."""
        voice = self._voices.get(base_language(language))
        if voice is None or not self._takes(voice):
            raise NoVoice
        if not text.strip():  # pyttsx3 would wait for ever
            return array("h")
        self._set("rate", settings.words_per_minute)
        self._set("volume", round(settings.volume, 2))
        if self._speaks_espeak:  # the other drivers know no pitch
            self._set("pitch", settings.pitch)
        return self._rendered(text)

    def _try_it(self) -> None:
        """A first sentence: pyttsx3 keeps all settings for later until it has rendered one."""
        if not self._rendered("a"):
            raise NoVoice

    def _rendered(self, text: str) -> array[int]:
        self._settle()
        with _scratch_file() as path:
            self._engine.save_to_file(text, path)
            self._engine.runAndWait()
            return _samples(path)

    def _set(self, name: str, value: float) -> None:
        """Set it until it is set: espeak-ng takes it later, and loses it if something else comes between."""
        for _ in range(_MOST_TRIES):
            if self._engine.getProperty(name) == value:
                return
            self._engine.setProperty(name, value)
            self._settle()

    def _settle(self) -> None:
        """Wait until espeak-ng has done what it was told.

        Otherwise pyttsx3, which ends every loop with a cancel if it finds espeak-ng busy, would throw away
        settings on their way, or the next sentence.
        """
        if self._speaks_espeak:
            espeak = importlib.import_module("pyttsx3.drivers._espeak")
            for _ in range(_MOST_POLLS):
                if not espeak.IsPlaying():
                    return
                self._pause.wait(_POLL_SECONDS)

    def _working_voices(self) -> dict[str, Voice]:
        offered = [Voice(each.id, _tags(each.languages)) for each in self._engine.getProperty("voices")]
        chosen = {language: choose_voice(language, offered) for language in LANGUAGES}
        return {language: voice for language, voice in chosen.items() if voice and self._takes(voice)}

    def _takes(self, voice: Voice) -> bool:
        self._engine.setProperty("voice", voice.identifier)
        return bool(self._engine.getProperty("voice") == voice.identifier)


def _samples(path: str) -> array[int]:
    try:
        return read_mono(path)
    except NotWav as reason:
        raise NoVoice from reason


def _make_espeak_findable(prefer_bundled: bool) -> None:
    """Load the bundled library globally, under its own name, so that pyttsx3 finds it by that name."""
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
    except Exception as reason:  # a driver raises what its system raises; all of it means: no voice
        raise NoVoice from reason


def _tags(languages: object) -> tuple[str, ...]:
    """pyttsx3's drivers give strings or bytes, or nothing."""
    tags = languages if isinstance(languages, list | tuple) else ()
    return tuple(tag.decode("ascii", "ignore") if isinstance(tag, bytes) else str(tag) for tag in tags)


@contextmanager
def _scratch_file() -> Iterator[str]:
    """A path to write one WAV file to: in memory where the system can, so that nothing is left behind."""
    if hasattr(os, "memfd_create"):
        descriptor = os.memfd_create("donnie-voice")
        try:
            yield f"/proc/self/fd/{descriptor}"
        finally:
            os.close(descriptor)
    else:
        with tempfile.TemporaryDirectory(prefix="donnie-voice-") as folder:
            yield str(Path(folder, "voice.wav"))
