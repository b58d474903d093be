"""What plays sound, in the audio worker only: miniaudio, or a command-line player instead.

Only this module loads miniaudio, and only when a player is opened. ``open_player`` returns None if no player
finds a device. Nothing is written to a terminal, because the worker has none.

Where miniaudio has no wheel or no device, ``pw-play``, ``paplay`` or ``aplay`` plays. Each sound is one
process, in the audio worker's process group, so ending the group ends the sound. It gets the sound in memory
where the system allows that (Linux), elsewhere in a temporary file.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from array import array
from collections.abc import Callable, Generator, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from devices.audio.cues import SAMPLE_RATE
from devices.audio.mixer import MOST_SIMULTANEOUS, NEVER_DROPPED, Mixer, in_stereo, new_wav
from devices.audio.process import CAN_DIE_WITH_PARENT, die_with_parent

AUTO_DEVICE = "auto"
NULL_DEVICE = "null"
"""Takes the sound at the right pace and throws it away: for tests and trials."""

NO_DEVICE = "none"
"""As on a machine without one."""

_BUFFER_MILLISECONDS = 30
_BACKENDS = {
    "linux": ("PULSEAUDIO", "ALSA"),
    "darwin": ("COREAUDIO",),
    "win32": ("WASAPI", "DSOUND", "WINMM"),
}
_OTHER_BACKENDS = ("SNDIO", "AUDIO4", "OSS")


class Player(Protocol):
    """Plays one sentence and a few cues at a time. Any thread may call it; no call waits for sound."""

    name: str
    """``miniaudio``, or the command's name."""

    @property
    def frames(self) -> int | None:
        """Frames given to the device so far: a heartbeat. None if unknown."""

    @property
    def is_playing(self) -> bool: ...

    def speak(self, mono: array[int], on_end: Callable[[], None]) -> None:
        """Start a sentence; ``on_end`` is called in another thread, unless the sentence is silenced."""

    def cue(self, name: str, stereo: array[int], delay: float) -> None:
        """Start a cue in ``delay`` seconds."""

    def silence(self, speech: bool, cues: bool) -> None: ...

    def close(self) -> None: ...


def open_player(device: str) -> Player | None:
    """The best player for ``device``, one of the names above; None if nothing can make a sound."""
    if device == NO_DEVICE:
        return None
    player = _open_miniaudio(
        ("NULL",) if device == NULL_DEVICE else _BACKENDS.get(sys.platform, _OTHER_BACKENDS)
    )
    if player is None and device != NULL_DEVICE:
        return find_command_player()
    return player


class MiniaudioPlayer(Mixer):
    """A mixer that a miniaudio device empties all the time, so a cue starts at once."""

    name = "miniaudio"

    def __init__(self, device: Any) -> None:  # miniaudio ships no types
        super().__init__()
        self._device = device
        source = _source(self)
        next(source)
        self._device.start(source)

    def close(self) -> None:
        self._device.close()


def _source(mixer: Mixer) -> Generator[array[int], int, None]:
    """The generator that miniaudio asks for frames."""
    wanted = yield array("h")
    while True:
        wanted = yield mixer.mix(wanted)


def _open_miniaudio(backends: Iterable[str]) -> MiniaudioPlayer | None:
    """Tries each backend by itself: miniaudio gives up if the first that it finds has no device."""
    try:
        import miniaudio
    except (ImportError, OSError):  # no wheel for this platform, or one that does not fit
        return None
    for backend in backends:
        try:
            device = miniaudio.PlaybackDevice(
                nchannels=2,
                sample_rate=SAMPLE_RATE,
                buffersize_msec=_BUFFER_MILLISECONDS,
                backends=[miniaudio.Backend[backend]],
                app_name="Donnie",
            )
            return MiniaudioPlayer(device)
        except (miniaudio.MiniaudioError, KeyError):
            continue
    return None


_COMMANDS = (("pw-play",), ("paplay",), ("aplay", "-q"))
_TRIAL_SECONDS = 2.0
_TRIAL_SOUND = array("h", bytes(4 * (SAMPLE_RATE // 100)))


def find_command_player() -> CommandPlayer | None:
    """The first command that exists and plays ten milliseconds of silence without an error."""
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
    """By the clock, as if the command started at once; a delay is played as silence."""


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
            by_worth = sorted(cues, key=lambda sound: sound.cue == NEVER_DROPPED)
            self._kill(by_worth[: max(0, len(cues) + 1 - MOST_SIMULTANEOUS)])
        self._start(silence + stereo, name, None, delay)

    def silence(self, speech: bool, cues: bool) -> None:
        with self._lock:
            self._kill([sound for sound in self._sounds if (cues if sound.cue else speech)])

    def close(self) -> None:
        self.silence(speech=True, cues=True)

    def _start(
        self, stereo: array[int], cue: str, on_end: Callable[[], None] | None, delay: float = 0.0
    ) -> None:
        now = time.monotonic()
        ends = now + len(stereo) / 2 / SAMPLE_RATE
        with self._lock, _as_file(stereo) as (path, descriptors):
            try:
                sound = _Sound(_run((*self._command, path), descriptors), cue, now + delay, ends)
            except OSError:  # the command was removed, or there are no more processes
                return  # the supervisor notices a sentence that never ends
            self._sounds.append(sound)
        waiter = threading.Thread(target=self._wait, args=(sound, on_end), name="player", daemon=True)
        waiter.start()

    def _wait(self, sound: _Sound, on_end: Callable[[], None] | None) -> None:
        has_played = sound.process.wait() == 0  # otherwise the missing end reveals the failure
        with self._lock:
            was_silenced = sound not in self._sounds
            self._sounds = [other for other in self._sounds if other is not sound]
        if on_end is not None and has_played and not was_silenced:
            on_end()

    def _kill(self, sounds: list[_Sound]) -> None:
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
    """Run it in the worker's process group; the system ends it with the worker."""
    return subprocess.Popen(
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        pass_fds=descriptors,
        preexec_fn=die_with_parent if CAN_DIE_WITH_PARENT else None,
    )


@contextmanager
def scratch_file() -> Iterator[tuple[str, tuple[int, ...]]]:
    """A path for one WAV file, in memory where the system allows that, so that nothing is left behind, and
    the descriptors that a child needs to open it."""
    if hasattr(os, "memfd_create"):
        descriptor = os.memfd_create("donnie-sound")
        try:
            yield f"/proc/self/fd/{descriptor}", (descriptor,)
        finally:
            os.close(descriptor)
    else:
        with tempfile.TemporaryDirectory(prefix="donnie-sound-") as folder:
            yield str(Path(folder, "sound.wav")), ()


@contextmanager
def _as_file(stereo: array[int]) -> Iterator[tuple[str, tuple[int, ...]]]:
    """A file with the sound, as ``scratch_file`` gives it."""
    with scratch_file() as (path, descriptors):
        with new_wav(path) as file:
            file.writeframes(stereo.tobytes())
        yield path, descriptors
