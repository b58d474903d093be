"""What makes the air move, in the audio worker only: miniaudio, or a command-line player in its place.

The one module that loads miniaudio, and only when a player is opened. A player that finds no device says
so by ``open_player`` returning None; nothing is written to a terminal, because the worker has none.
"""

from __future__ import annotations

import sys
from array import array
from collections.abc import Callable, Generator, Iterable
from typing import Any, Protocol

from devices.sound.command_player import find_command_player
from devices.sound.mixer import Mixer
from devices.sound.tones import SAMPLE_RATE

AUTO_DEVICE = "auto"
NULL_DEVICE = "null"
"""Takes the sound at the right pace and throws it away: for tests, and for trying."""

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
        """Frames given to the device so far: a heartbeat. None if that can't be told."""

    @property
    def is_playing(self) -> bool: ...

    def speak(self, mono: array[int], on_end: Callable[[], None]) -> None:
        """Start a sentence; ``on_end`` follows, in another thread, unless it is hushed."""

    def cue(self, name: str, stereo: array[int], delay: float) -> None:
        """Start a cue in ``delay`` seconds."""

    def hush(self, speech: bool, cues: bool) -> None: ...

    def close(self) -> None: ...


def open_player(device: str) -> Player | None:
    """The best player for ``device``, a name from above; None if nothing here can make a sound."""
    if device == NO_DEVICE:
        return None
    player = _open_miniaudio(("NULL",) if device == NULL_DEVICE else _real_backends())
    if player is None and device != NULL_DEVICE:
        return find_command_player()
    return player


class MiniaudioPlayer:
    """A mixer that a miniaudio device empties, all the time, so that a cue starts at once."""

    name = "miniaudio"

    def __init__(self, device: Any) -> None:  # miniaudio ships no types
        self._mixer = Mixer()
        self._device = device
        source = _source(self._mixer)
        next(source)
        self._device.start(source)

    @property
    def frames(self) -> int | None:
        return self._mixer.frames

    @property
    def is_playing(self) -> bool:
        return self._mixer.is_playing

    def speak(self, mono: array[int], on_end: Callable[[], None]) -> None:
        self._mixer.speak(mono, on_end)

    def cue(self, name: str, stereo: array[int], delay: float) -> None:
        self._mixer.cue(name, stereo, delay)

    def hush(self, speech: bool, cues: bool) -> None:
        self._mixer.hush(speech, cues)

    def close(self) -> None:
        self._device.close()


def _source(mixer: Mixer) -> Generator[array[int], int, None]:
    """What miniaudio asks for frames."""
    wanted = yield array("h")
    while True:
        wanted = yield mixer.mix(wanted)


def _open_miniaudio(backends: Iterable[str]) -> MiniaudioPlayer | None:
    """Each backend by itself: miniaudio gives up where the first that it finds has no device."""
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


def _real_backends() -> tuple[str, ...]:
    return _BACKENDS.get(sys.platform, _OTHER_BACKENDS)
