"""Which cues are heard (C4, C5). Pure: time comes in as a parameter.

At most two sound at once, the same kind at least 70 ms apart, scan pings 300 ms apart. What comes too
fast is left out: the events have counted it. A bump is never left out: it waits its 70 ms, and whatever
plays it ends the oldest other sound for it. Only when bumps come faster than they could be heard, for a
second, do further ones melt into those that wait.
"""

from __future__ import annotations

AT_ONCE = 2
NEVER_LEFT_OUT = "bump"

_APART = {"scan": 0.300}
_APART_OTHERWISE = 0.070
_LONGEST_WAIT = 1.0
_ROUNDING = 1e-6


class CuePolicy:
    """Remembers what sounds. Not thread-safe: its owner holds a lock."""

    def __init__(self) -> None:
        self._last_start: dict[str, float] = {}
        self._ends: list[float] = []

    def admit(self, name: str, seconds: float, now: float) -> float | None:
        """Seconds to wait before the cue of ``seconds`` length starts, or None if it is left out."""
        earliest = self._last_start.get(name, float("-inf")) + _APART.get(name, _APART_OTHERWISE)
        start = max(now, earliest) if earliest - now > _ROUNDING else now
        if name == NEVER_LEFT_OUT:
            if start - now > _LONGEST_WAIT:
                return None
        elif start > now or self._sounding(now) >= AT_ONCE:
            return None
        self._note(name, start, start + seconds, now)
        return start - now

    def clear(self) -> None:
        """Everything was silenced."""
        self._ends.clear()
        self._last_start.clear()

    def _sounding(self, now: float) -> int:
        return sum(end > now for end in self._ends)

    def _note(self, name: str, start: float, end: float, now: float) -> None:
        self._last_start[name] = start
        self._ends = [*(known for known in self._ends if known > now), end]
