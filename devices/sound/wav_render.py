"""Writes cues into a WAV file, each at its time: the same bytes for the same run, every time.

The rules of what sounds together are those of the loudspeaker (``cue_policy``, ``mixer``); time is robot
time. Written as it goes, so that a long run takes no memory.
"""

from __future__ import annotations

import wave
from pathlib import Path

from devices.ports.audio import Cue
from devices.sound.cue_policy import CuePolicy
from devices.sound.mixer import Mixer
from devices.sound.tones import CUE_NAMES, SAMPLE_RATE, render, seconds_of

LONGEST = 3600.0
"""Seconds that are written at most, 300 MB; what comes later is left out."""

_TAIL = 0.5
"""Seconds that are written at once behind the end, until the last cue is over."""

_CHUNK = SAMPLE_RATE
"""Frames that are mixed at once."""


class WavRenderer:
    """A file that is being written. Raises ``OSError`` where it can't be."""

    def __init__(self, path: Path) -> None:
        self._out = path.open("wb")  # by its name, wave complains aloud of what can't be opened
        self._file = wave.open(self._out, "wb")  # noqa: SIM115 -- closed with the run
        self._file.setnchannels(2)
        self._file.setsampwidth(2)
        self._file.setframerate(SAMPLE_RATE)
        self._mixer, self._policy = Mixer(), CuePolicy()

    @property
    def is_full(self) -> bool:
        """Whether what comes from now on is left out."""
        return self._mixer.frames >= LONGEST * SAMPLE_RATE

    def add(self, cue: Cue, at: float) -> None:
        """A cue at ``at`` seconds from the beginning; never before one that was added earlier."""
        if self.is_full or cue.name not in CUE_NAMES:
            return
        self.go_on_to(at)
        wait = self._policy.admit(cue.name, seconds_of(cue.name), at)
        if wait is not None:
            self._mixer.cue(cue.name, render(cue), wait)

    def go_on_to(self, at: float) -> None:
        """Write what sounds until then."""
        until = round(min(at, LONGEST) * SAMPLE_RATE)
        while (frames := min(_CHUNK, until - self._mixer.frames)) > 0:
            self._file.writeframesraw(self._mixer.mix(frames).tobytes())

    def close(self) -> None:
        """Let the last cue sound to its end. Twice is once."""
        try:
            while self._mixer.is_playing and not self.is_full:
                self.go_on_to(self._mixer.frames / SAMPLE_RATE + _TAIL)
            self._file.close()
        finally:
            self._out.close()
