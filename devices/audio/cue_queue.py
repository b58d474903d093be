"""Which cues are played, and when. No I/O; times come in as parameters.

- At most two cues sound at once. The same kind starts at least 70 ms apart, scan pings 300 ms apart.
- Ticks, of steps and turns, are dropped where they come too fast: the events have counted them.
- Cues of single events wait for each other: all things that a scan found come at once, and the end of the
  program with them.
- A bump is never dropped: it waits its 70 ms, and the player ends the oldest other sound for it.
- Each kind waits for a limited time. A cue is dropped only if for a while cues come faster than they can be
  played.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Mapping

from msgspec import Struct

from devices.audio.cues import CUE_NAMES, normalized, seconds_of
from devices.audio.messages import PlayCue
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
        """For the cues from now on."""
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
