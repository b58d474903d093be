"""Which cues are heard, and when (C4, C5). Pure: time comes in as a parameter.

At most two sound at once, the same kind at least 70 ms apart, scan pings 300 ms apart. Ticks, of steps
and turns, are left out where they come too fast: the events have counted them. What is told once waits in
line, one behind the other: what a scan found comes all at once, and the end of the program with it. A bump
is never left out: it waits its 70 ms, and whatever plays it ends the oldest other sound for it. Each kind
waits so long and no longer: only when it comes faster than it could be heard, for a while, is it left out.
"""

from __future__ import annotations

AT_ONCE = 2
NEVER_LEFT_OUT = "bump"

_APART = {"scan": 0.300}
_APART_OTHERWISE = 0.070
_LONGEST_WAITS = {"bump": 1.0, "scan": 0.5, "obstacle": 1.0, "found": 2.0, "done": 3.0, "error": 3.0}
"""Seconds. The last two have room behind any line."""
_ROUNDING = 1e-6


class CuePolicy:
    """Remembers what sounds. Not thread-safe: its owner holds a lock."""

    def __init__(self) -> None:
        self._last_start: dict[str, float] = {}
        self._sounds: list[tuple[float, float]] = []
        """Beginnings and ends, of what is still to come too."""
        self._line_ends = float("-inf")

    def admit(self, name: str, seconds: float, now: float) -> float | None:
        """Seconds to wait before the cue of ``seconds`` length starts, or None if it is left out."""
        self._sounds = [known for known in self._sounds if known[1] > now]
        earliest = self._last_start.get(name, float("-inf")) + _APART.get(name, _APART_OTHERWISE)
        start = self._start_of(name, seconds, now, earliest if earliest - now > _ROUNDING else now)
        if start is None or start - now > _LONGEST_WAITS.get(name, 0.0):
            return None
        self._last_start[name] = start
        self._sounds.append((start, start + seconds))
        return start - now

    def clear(self) -> None:
        """Everything was silenced."""
        self._sounds.clear()
        self._last_start.clear()
        self._line_ends = float("-inf")

    def _start_of(self, name: str, seconds: float, now: float, earliest: float) -> float | None:
        if name == NEVER_LEFT_OUT:
            return earliest
        if name not in _LONGEST_WAITS:
            return earliest if self._has_room(earliest, seconds) else None
        if name in _APART and earliest > now:
            return None
        return self._stand_in_line(name, seconds, now, max(earliest, self._line_ends))

    def _stand_in_line(self, name: str, seconds: float, now: float, earliest: float) -> float | None:
        starts = [earliest, *sorted(end for _, end in self._sounds if end > earliest)]
        start = next(each for each in starts if self._has_room(each, seconds))
        if start - now <= _LONGEST_WAITS[name]:
            self._line_ends = start + seconds
        return start

    def _has_room(self, start: float, seconds: float) -> bool:
        """Whether at no moment of such a sound two others sound."""
        begun = [begin for begin, _ in self._sounds if start < begin < start + seconds]
        return all(self._sounding(moment) < AT_ONCE for moment in (start, *begun))

    def _sounding(self, moment: float) -> int:
        return sum(begin <= moment < end for begin, end in self._sounds)
