"""Which cues are played and when, and what sounds at the same time, for a device or for a file.

- At most two cues sound at once. The same kind starts at least 70 ms apart, scan pings 300 ms apart.
- Ticks, of steps and turns, are dropped where they come too fast: the events have counted them.
- Cues of single events wait for each other: all things that a scan found come at once, and the end of the
  program with them.
- A bump is never dropped: it waits its 70 ms, and the player ends the oldest other sound for it.
- Each kind waits for a limited time. A cue is dropped only if for a while cues come faster than they can be
  played.

``CueScheduler`` and ``CueQueue`` do no I/O; times come in as parameters. ``Mixer`` adds up one voice and at
most two cues. The player asks it for the next frames. Their count is the heartbeat by which a dead sound
server is noticed, because it freezes without an error."""

from __future__ import annotations

import threading
import wave
from array import array
from collections import deque
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import BinaryIO

from msgspec import Struct

from devices.audio.cues import CUE_NAMES, SAMPLE_RATE, normalized, render_cue, seconds_of
from devices.audio.process import PlayCue
from devices.ports.audio import Cue

MOST_SIMULTANEOUS = 2
NEVER_DROPPED = "bump"

PLAYBACK_LATENCY = 0.1
"""Seconds from the request to the sound, in the worker and the device."""

STALE_CUE = 1.0
"""Seconds after which a cue that could not be played would only mislead. A bump is played even then."""

_APART = {"scan": 0.300}
_APART_OTHERWISE = 0.070
_LONGEST_WAITS = {"bump": 1.0, "scan": 0.5, "obstacle": 1.0, "found": 2.0, "done": 3.0, "error": 3.0}
"""Seconds. The last two are still played after the longest queue of others."""
_ROUNDING = 1e-6

_LATE = 0.1
"""Seconds of delay after which all that waits is scheduled again: the worker was not there in time."""

_MOST_WAITING = 16


class CueScheduler:
    """Knows what sounds and what will. Not thread-safe: its owner holds a lock."""

    def __init__(self) -> None:
        self._last_start: dict[str, float] = {}
        self._sounds: list[tuple[float, float]] = []
        """Starts and ends, future ones included."""
        self._queue_ends = float("-inf")

    def schedule(self, name: str, seconds: float, now: float) -> float | None:
        """Seconds to wait before the cue of ``seconds`` length starts, or None if it is dropped."""
        self._sounds = [known for known in self._sounds if known[1] > now]
        earliest = self._last_start.get(name, float("-inf")) + _APART.get(name, _APART_OTHERWISE)
        start = self._start_of(name, seconds, now, earliest if earliest - now > _ROUNDING else now)
        if start is None or start - now > _LONGEST_WAITS.get(name, 0.0):
            return None
        self._last_start[name] = start
        self._sounds.append((start, start + seconds))
        return start - now

    def clear(self) -> None:
        """All cues were silenced."""
        self._sounds.clear()
        self._last_start.clear()
        self._queue_ends = float("-inf")

    def _start_of(self, name: str, seconds: float, now: float, earliest: float) -> float | None:
        if name == NEVER_DROPPED:
            return earliest
        if name not in _LONGEST_WAITS:
            return earliest if self._has_room(earliest, seconds) else None
        if name in _APART and earliest > now:
            return None
        return self._queued_start(name, seconds, now, max(earliest, self._queue_ends))

    def _queued_start(self, name: str, seconds: float, now: float, earliest: float) -> float | None:
        starts = [earliest, *sorted(end for _, end in self._sounds if end > earliest)]
        start = next(each for each in starts if self._has_room(each, seconds))
        if start - now <= _LONGEST_WAITS[name]:
            self._queue_ends = start + seconds
        return start

    def _has_room(self, start: float, seconds: float) -> bool:
        """Whether at no moment of such a sound two others sound."""
        begun = [begin for begin, _ in self._sounds if start < begin < start + seconds]
        return all(self._sounding(moment) < MOST_SIMULTANEOUS for moment in (start, *begun))

    def _sounding(self, moment: float) -> int:
        return sum(begin <= moment < end for begin, end in self._sounds)


class _WaitingCue(Struct, frozen=True):
    cue: Cue
    due: float


class CueQueue:
    """The cues that wait for the worker: how loud, and until when they are worth playing. Not thread-safe."""

    def __init__(self, volumes: Mapping[str, float]) -> None:
        """``volumes``: 0 to 1 by the name of a cue, 1 where none is given; 0 switches it off."""
        self._volumes = dict(volumes)
        self._scheduler = CueScheduler()
        self._waiting: deque[_WaitingCue] = deque(maxlen=_MOST_WAITING)
        self._sound_until = float("-inf")

    def set_volumes(self, volumes: Mapping[str, float]) -> None:
        """Set the volumes of later cues."""
        self._volumes = dict(volumes)

    def offer(self, cue: Cue, now: float) -> bool:
        """Queue it for its time. False if it is dropped."""
        if cue.name not in CUE_NAMES or not self._volume_of(cue):
            return False
        return self._schedule(normalized(cue), now)

    def take(self, now: float) -> Iterator[PlayCue]:
        """All that wait, except those that are too late."""
        if self._waiting and now - self._waiting[0].due > _LATE:
            self._reschedule(now)
        while self._waiting:
            waiting = self._waiting.popleft()
            cue, wait = waiting.cue, max(0.0, waiting.due - now)
            yield PlayCue(cue.name, cue.bearing, cue.steps, self._volume_of(cue), wait)

    def are_over(self, now: float) -> bool:
        """Whether no cue sounds, or waits that is not too late: a sound server may hang."""
        waits = any(now - waiting.due <= STALE_CUE for waiting in self._waiting)
        return not waits and now >= self._sound_until + PLAYBACK_LATENCY

    def silence(self, now: float) -> bool:
        """Drop all cues of until now. Whether one is sounding."""
        is_audible = now < self._sound_until
        self._scheduler.clear()
        self.clear()
        return is_audible

    def clear(self) -> None:
        """No cue waits or sounds any more."""
        self._waiting.clear()
        self._sound_until = float("-inf")

    def _schedule(self, cue: Cue, now: float) -> bool:
        seconds = seconds_of(cue.name)
        wait = self._scheduler.schedule(cue.name, seconds, now)
        if wait is None:
            return False
        self._waiting.append(_WaitingCue(cue, now + wait))
        self._sound_until = max(self._sound_until, now + wait + seconds)
        return True

    def _reschedule(self, now: float) -> None:
        known = tuple(self._waiting)
        self._waiting.clear()
        self._scheduler.clear()
        for waiting in known:
            if now - waiting.due <= STALE_CUE or waiting.cue.name == NEVER_DROPPED:
                self._schedule(waiting.cue, now)

    def _volume_of(self, cue: Cue) -> float:
        return min(max(self._volumes.get(cue.name, 1.0), 0.0), 1.0)


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
        """Mixes at most ``frames`` frames, in all of which the same tracks sound together."""
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
    """Drops the oldest cues, bumps last of all, if more than two would sound now."""
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


def new_wav(out: str | BinaryIO) -> wave.Wave_write:
    """A WAV file without samples: stereo, 16 bits, at ``SAMPLE_RATE``. Raises ``OSError``."""
    file = wave.open(out, "wb")  # noqa: SIM115 -- the caller closes it
    file.setnchannels(2)
    file.setsampwidth(2)
    file.setframerate(SAMPLE_RATE)
    return file


class WavCueWriter:
    """Writes cues into a WAV file, each at its robot time: the same bytes for the same run.

    The rules of what sounds together are those of the loudspeaker. It writes as it goes, so a long run takes
    no memory. Raises ``OSError`` if the file can't be written.
    """

    def __init__(self, out: BinaryIO) -> None:
        """``out`` is closed with the writer."""
        self._out = out  # given only the name, wave prints a complaint if it can't open the file
        self._file = new_wav(self._out)
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
