"""Adds up what sounds at the same time, for a device or for a file: one voice and at most two cues.

The player asks for the next frames. Their count is the heartbeat by which a dead sound server is noticed,
because it freezes without an error.
"""

from __future__ import annotations

import threading
import wave
from array import array
from collections.abc import Callable
from dataclasses import dataclass
from typing import BinaryIO

from devices.audio.cue_queue import MOST_SIMULTANEOUS, NEVER_DROPPED, CueScheduler
from devices.audio.cues import CUE_NAMES, SAMPLE_RATE, render_cue, seconds_of
from devices.ports.audio import Cue


@dataclass(slots=True)
class _Track:
    samples: array[int]
    """16-bit, stereo, interleaved."""
    name: str = ""
    """The cue's; empty for the voice."""
    position: int = 0
    """Frames already mixed; negative while the track waits for its start."""
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
        """Frames mixed so far."""
        return self._frames

    @property
    def is_playing(self) -> bool:
        return bool(self._tracks)

    def speak(self, mono: array[int], on_end: Callable[[], None]) -> None:
        """Start a sentence. ``on_end`` is called in the player's thread, unless it is silenced before."""
        self._add(_Track(in_stereo(mono), on_end=on_end))

    def cue(self, name: str, stereo: array[int], delay: float) -> None:
        """Start a cue in ``delay`` seconds; the oldest ends for it if two sound then."""
        self._add(_Track(stereo, name, -max(0, round(delay * SAMPLE_RATE))))

    def silence(self, speech: bool, cues: bool) -> None:
        """Drop the voice, the cues, or both."""
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
        """At most ``frames`` frames, in all of which the same tracks sound together."""
        self._tracks = _limited(self._tracks)
        until = min((-track.position for track in self._tracks if track.position < 0), default=frames)
        mixed = _sum(self._tracks, min(frames, until))
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


def _limited(tracks: list[_Track]) -> list[_Track]:
    """Without the oldest cues, bumps last of all, if more than two would sound now."""
    sounding = [track for track in tracks if track.name and track.position >= 0]
    by_worth = sorted(sounding, key=lambda track: track.name == NEVER_DROPPED)
    surplus = by_worth[: max(0, len(sounding) - MOST_SIMULTANEOUS)]
    return [track for track in tracks if not any(track is other for other in surplus)]


def _sum(tracks: list[_Track], frames: int) -> array[int]:
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


# --- cues in a file

LONGEST = 3600.0
"""Seconds that are written at most, 300 MB; what comes later is dropped."""

_TAIL = 0.5
"""Seconds that are written at once after the end, until the last cue is over."""

_CHUNK = SAMPLE_RATE
"""Frames that are mixed at once."""


class WavCueWriter:
    """Writes cues into a WAV file, each at its robot time: the same bytes for the same run.

    The rules of what sounds together are those of the loudspeaker. It writes as it goes, so a long run takes
    no memory. Raises ``OSError`` if the file can't be written.
    """

    def __init__(self, out: BinaryIO) -> None:
        """``out`` is closed with the writer."""
        self._out = out  # given only the name, wave prints a complaint if it can't open the file
        self._file = wave.open(self._out, "wb")  # noqa: SIM115 -- ``close`` closes it
        self._file.setnchannels(2)
        self._file.setsampwidth(2)
        self._file.setframerate(SAMPLE_RATE)
        self._mixer, self._scheduler = Mixer(), CueScheduler()

    @property
    def is_full(self) -> bool:
        """Whether everything from now on is dropped."""
        return self._mixer.frames >= LONGEST * SAMPLE_RATE

    def add(self, cue: Cue, at: float) -> None:
        """A cue at ``at`` seconds from the beginning; never before one that was added earlier."""
        if self.is_full or cue.name not in CUE_NAMES:
            return
        self.write_until(at)
        wait = self._scheduler.schedule(cue.name, seconds_of(cue.name), at)
        if wait is not None:
            self._mixer.cue(cue.name, render_cue(cue), wait)

    def write_until(self, at: float) -> None:
        """Write what sounds until then."""
        until = round(min(at, LONGEST) * SAMPLE_RATE)
        while (frames := min(_CHUNK, until - self._mixer.frames)) > 0:
            self._file.writeframesraw(self._mixer.mix(frames).tobytes())

    def close(self) -> None:
        """Let the last cue sound to its end. May be called twice."""
        try:
            while self._mixer.is_playing and not self.is_full:
                self.write_until(self._mixer.frames / SAMPLE_RATE + _TAIL)
            self._file.close()
        finally:
            self._out.close()
