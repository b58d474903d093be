"""Plays through ``pw-play``, ``paplay`` or ``aplay``, where miniaudio has no wheel or no device.

One process a sound, in the audio worker's process group, so that ending the group ends the sound. The
sound is handed over in memory where the system can (Linux), in a file that is gone afterwards elsewhere.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import threading
import time
import wave
from array import array
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from devices.sound.cue_policy import AT_ONCE, NEVER_LEFT_OUT
from devices.sound.lifeline import CAN_DIE_WITH_PARENT, die_with_parent
from devices.sound.mixer import in_stereo
from devices.sound.tones import SAMPLE_RATE

_COMMANDS = (("pw-play",), ("paplay",), ("aplay", "-q"))
_TRIAL_SECONDS = 2.0
_TRIAL_SOUND = array("h", bytes(4 * (SAMPLE_RATE // 100)))


def find_command_player() -> CommandPlayer | None:
    """The first command that is there and plays ten milliseconds of silence without complaint."""
    for name, *options in _COMMANDS:
        program = shutil.which(name)
        if program and _plays((program, *options)):
            return CommandPlayer(name, (program, *options))
    return None


@dataclass(slots=True, eq=False)
class _Sound:
    process: subprocess.Popen[bytes]
    cue: str
    """Empty for the voice."""
    begins: float
    ends: float
    """By the clock, as far as the command is at once; what waits is preceded by silence."""


class CommandPlayer:
    """A ``Player`` that starts a command for each sound."""

    def __init__(self, name: str, command: tuple[str, ...]) -> None:
        self.name = name
        self._command = command
        self._lock = threading.Lock()
        self._sounds: list[_Sound] = []

    @property
    def frames(self) -> int | None:
        return None

    @property
    def is_playing(self) -> bool:
        return bool(self._sounds)

    def speak(self, mono: array[int], on_end: Callable[[], None]) -> None:
        self._start(in_stereo(mono), "", on_end)

    def cue(self, name: str, stereo: array[int], delay: float) -> None:
        silence = array("h", bytes(4 * round(max(0.0, delay) * SAMPLE_RATE)))
        with self._lock:
            begins = time.monotonic() + delay
            cues = [sound for sound in self._sounds if sound.cue and sound.begins <= begins < sound.ends]
            by_worth = sorted(cues, key=lambda sound: sound.cue == NEVER_LEFT_OUT)
            self._forget(by_worth[: max(0, len(cues) + 1 - AT_ONCE)])
        self._start(silence + stereo, name, None, delay)

    def hush(self, speech: bool, cues: bool) -> None:
        with self._lock:
            self._forget([sound for sound in self._sounds if (cues if sound.cue else speech)])

    def close(self) -> None:
        self.hush(speech=True, cues=True)

    def _start(
        self, stereo: array[int], cue: str, on_end: Callable[[], None] | None, delay: float = 0.0
    ) -> None:
        now = time.monotonic()
        ends = now + len(stereo) / 2 / SAMPLE_RATE
        with self._lock, _as_file(stereo) as (path, descriptors):
            try:
                sound = _Sound(_run((*self._command, path), descriptors), cue, now + delay, ends)
            except OSError:  # the command went away, or there is no process to be had
                return  # a sentence that never ends is noticed by the other side
            self._sounds.append(sound)
        waiter = threading.Thread(target=self._wait, args=(sound, on_end), name="player", daemon=True)
        waiter.start()

    def _wait(self, sound: _Sound, on_end: Callable[[], None] | None) -> None:
        heard = sound.process.wait() == 0  # otherwise the missing end tells that something is wrong
        with self._lock:
            was_hushed = sound not in self._sounds
            self._sounds = [other for other in self._sounds if other is not sound]
        if on_end is not None and heard and not was_hushed:
            on_end()

    def _forget(self, sounds: list[_Sound]) -> None:
        self._sounds = [sound for sound in self._sounds if sound not in sounds]
        for sound in sounds:
            sound.process.kill()


def _plays(command: tuple[str, ...]) -> bool:
    with _as_file(_TRIAL_SOUND) as (path, descriptors):
        try:
            process = _run((*command, path), descriptors)
        except OSError:
            return False
        try:
            return process.wait(_TRIAL_SECONDS) == 0
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            return False


def _run(command: tuple[str, ...], descriptors: tuple[int, ...]) -> subprocess.Popen[bytes]:
    """In the worker's process group, and ended by the system if the worker is."""
    return subprocess.Popen(
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        pass_fds=descriptors,
        preexec_fn=die_with_parent if CAN_DIE_WITH_PARENT else None,
    )


@contextmanager
def _as_file(stereo: array[int]) -> Iterator[tuple[str, tuple[int, ...]]]:
    """A path to the sound as a WAV file, and the descriptors that a child needs to open it."""
    if hasattr(os, "memfd_create"):
        descriptor = os.memfd_create("donnie-sound")
        try:
            path = f"/proc/self/fd/{descriptor}"
            _write_wav(path, stereo)
            yield path, (descriptor,)
        finally:
            os.close(descriptor)
    else:
        with tempfile.TemporaryDirectory(prefix="donnie-sound-") as folder:
            file = Path(folder, "sound.wav")
            _write_wav(str(file), stereo)
            yield str(file), ()


def _write_wav(path: str, stereo: array[int]) -> None:
    with wave.open(path, "wb") as file:
        file.setnchannels(2)
        file.setsampwidth(2)
        file.setframerate(SAMPLE_RATE)
        file.writeframes(stereo.tobytes())
