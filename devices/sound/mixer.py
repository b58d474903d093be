"""Adds up what sounds at the same time: one voice and at most two cues. No device, no clock.

Whatever plays asks for the next frames; the count of frames given out is the heartbeat by which a dead
sound server is noticed, since it freezes without an error.
"""

from __future__ import annotations

import threading
from array import array
from collections.abc import Callable
from dataclasses import dataclass

from devices.sound.cue_policy import AT_ONCE, NEVER_LEFT_OUT
from devices.sound.tones import SAMPLE_RATE


@dataclass(slots=True)
class _Track:
    samples: array[int]
    """16-bit, stereo, interleaved."""
    name: str = ""
    """The cue's; empty for the voice."""
    position: int = 0
    """Frames already given out; negative while the track waits for its start."""
    on_end: Callable[[], None] | None = None

    @property
    def frames(self) -> int:
        return len(self.samples) // 2


class Mixer:
    """Thread-safe. ``mix`` is called by the player's thread, everything else by any."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._tracks: list[_Track] = []
        self._frames = 0

    @property
    def frames(self) -> int:
        """Frames given out so far."""
        return self._frames

    @property
    def is_playing(self) -> bool:
        return bool(self._tracks)

    def speak(self, mono: array[int], on_end: Callable[[], None]) -> None:
        """Start a sentence. ``on_end`` is called, in the player's thread, unless it is hushed before."""
        self._add(_Track(in_stereo(mono), on_end=on_end))

    def cue(self, name: str, stereo: array[int], delay: float) -> None:
        """Start a cue in ``delay`` seconds; the oldest ends for it if two sound then."""
        self._add(_Track(stereo, name, -max(0, round(delay * SAMPLE_RATE))))

    def hush(self, speech: bool, cues: bool) -> None:
        """Forget the voice, the cues, or both; what was asked before is not heard after."""
        with self._lock:
            self._tracks = [track for track in self._tracks if not (cues if track.name else speech)]

    def mix(self, frames: int) -> array[int]:
        """The next ``frames`` frames."""
        mixed, ended = array("h"), list[_Track]()
        with self._lock:
            while (left := frames - len(mixed) // 2) > 0:
                mixed.extend(self._mix_until_one_starts(left, ended))
            self._frames += frames
        for track in ended:
            if track.on_end is not None:
                track.on_end()
        return mixed

    def _mix_until_one_starts(self, frames: int, ended: list[_Track]) -> array[int]:
        """At most ``frames`` frames, in all of which the same sound together."""
        self._tracks = _two_cues_at_most(self._tracks)
        until = min((-track.position for track in self._tracks if track.position < 0), default=frames)
        mixed = _add_up(self._tracks, min(frames, until))
        ended += [track for track in self._tracks if track.position >= track.frames]
        self._tracks = [track for track in self._tracks if track.position < track.frames]
        return mixed

    def _add(self, track: _Track) -> None:
        with self._lock:
            self._tracks.append(track)


def in_stereo(mono: array[int]) -> array[int]:
    """The same samples on both sides."""
    stereo = array("h", bytes(4 * len(mono)))
    stereo[0::2] = mono
    stereo[1::2] = mono
    return stereo


def _two_cues_at_most(tracks: list[_Track]) -> list[_Track]:
    """Without the oldest cues, bumps last of all, if more than two would sound now."""
    sounding = [track for track in tracks if track.name and track.position >= 0]
    by_worth = sorted(sounding, key=lambda track: track.name == NEVER_LEFT_OUT)
    surplus = by_worth[: max(0, len(sounding) - AT_ONCE)]
    return [track for track in tracks if not any(track is other for other in surplus)]


def _add_up(tracks: list[_Track], frames: int) -> array[int]:
    parts = [part for track in tracks if (part := _take(track, frames)) is not None]
    if not parts:
        return array("h", bytes(4 * frames))
    if len(parts) == 1:
        return parts[0]
    return array("h", (min(max(sum(samples), -32_768), 32_767) for samples in zip(*parts, strict=True)))


def _take(track: _Track, frames: int) -> array[int] | None:
    """The track's next frames, with silence after its end; None while it waits."""
    begin, end = track.position, track.position + frames
    track.position = end
    if begin < 0:
        return None
    part = track.samples[2 * begin : 2 * end]
    part.extend(array("h", bytes(4 * frames - 2 * len(part))))
    return part
