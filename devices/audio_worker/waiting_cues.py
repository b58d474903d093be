"""The cues that wait to be played: how loud, until when they are worth it, and until when they sound."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Mapping

from devices.audio_worker.messages import PlayCue
from devices.ports.audio import Cue
from devices.ports.values import Frozen
from devices.sound.cue_policy import NEVER_LEFT_OUT, CuePolicy
from devices.sound.tones import CUE_NAMES, seconds_of

ON_ITS_WAY = 0.1
"""Seconds from the order to the ear, of which a worker and a device need some."""

_LATE = 0.1
"""Seconds behind which what waits is planned anew: the worker was not there when it was due."""

STALE_CUE = 1.0
"""Seconds after which a cue that could not be played would only mislead. A bump is told even then."""

_MOST_WAITING = 16


class _WaitingCue(Frozen):
    cue: Cue
    due: float


class WaitingCues:
    """What is to be played. Not thread-safe."""

    def __init__(self, volumes: Mapping[str, float]) -> None:
        """``volumes``: 0 to 1 by the name of a cue, 1 where none is given; 0 leaves it out."""
        self._volumes = dict(volumes)
        self._policy = CuePolicy()
        self._waiting: deque[_WaitingCue] = deque(maxlen=_MOST_WAITING)
        self._sound_until = float("-inf")

    def set_volumes(self, volumes: Mapping[str, float]) -> None:
        """For the cues from now on."""
        self._volumes = dict(volumes)

    def offer(self, cue: Cue, now: float) -> bool:
        """Let it wait for its time. False if it is left out."""
        if cue.name not in CUE_NAMES or not self._volume_of(cue):
            return False
        return self._plan(cue, now)

    def take(self, now: float) -> Iterator[PlayCue]:
        """All that wait, but for those that it is too late for."""
        if self._waiting and now - self._waiting[0].due > _LATE:
            self._plan_anew(now)
        while self._waiting:
            waiting = self._waiting.popleft()
            cue, wait = waiting.cue, max(0.0, waiting.due - now)
            yield PlayCue(cue.name, cue.bearing, cue.steps, self._volume_of(cue), wait)

    def are_over(self, now: float) -> bool:
        """Whether nothing sounds, nor waits that it is not too late for: a server may hang."""
        waits = any(now - waiting.due <= STALE_CUE for waiting in self._waiting)
        return not waits and now >= self._sound_until + ON_ITS_WAY

    def hush(self, now: float) -> bool:
        """Nothing played until now is heard any more. Whether something sounds now."""
        self._waiting.clear()
        self._policy.clear()
        is_audible, self._sound_until = now < self._sound_until, float("-inf")
        return is_audible

    def clear(self) -> None:
        """Nothing waits any more, nor sounds."""
        self._waiting.clear()
        self._sound_until = float("-inf")

    def _plan(self, cue: Cue, now: float) -> bool:
        seconds = seconds_of(cue.name)
        wait = self._policy.admit(cue.name, seconds, now)
        if wait is None:
            return False
        self._waiting.append(_WaitingCue(cue, now + wait))
        self._sound_until = max(self._sound_until, now + wait + seconds)
        return True

    def _plan_anew(self, now: float) -> None:
        known = tuple(self._waiting)
        self._waiting.clear()
        self._policy.clear()
        for waiting in known:
            if now - waiting.due <= STALE_CUE or waiting.cue.name == NEVER_LEFT_OUT:
                self._plan(waiting.cue, now)

    def _volume_of(self, cue: Cue) -> float:
        return min(max(self._volumes.get(cue.name, 1.0), 0.0), 1.0)
