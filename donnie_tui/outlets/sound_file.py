"""``--sound wav:FILE``: the cues of what happens, written into a file at their robot times.

Cues only, so that the bytes are the same on every machine, with whatever voice. Of several runs, each begins
where the one before ended.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from devices.ports.audio import Cue
from devices.sound.wav_render import WavRenderer
from donnie_tui.core.events import CueSounded, RunEnded, SoundSwitched, Stamped


class SoundFile:
    """Listens to the stream and writes. What can't be written is told once."""

    def __init__(self, path: str, tell: Callable[[OSError], None]) -> None:
        """Raises ``OSError`` where it can't be written at all."""
        self._renderer, self._tell = WavRenderer(Path(path)), tell
        self._on = True
        self._began = 0.0
        self._failed = False

    def __call__(self, stamped: Stamped) -> None:
        if self._failed:
            return
        try:
            self._hear(stamped)
        except OSError as problem:
            self._failed = True
            self._tell(problem)

    def _hear(self, stamped: Stamped) -> None:
        at = self._began + stamped.t
        match stamped.event:
            case SoundSwitched(on=on):
                self._on = on
            case CueSounded(name=cue, bearing=bearing, steps=steps) if self._on:
                self._renderer.add(Cue(cue, bearing, steps), at)
            case RunEnded():
                self._renderer.go_on_to(at)
                self._began = at

    def close(self) -> None:
        """Finish the file."""
        try:
            self._renderer.close()
        except OSError as problem:
            if not self._failed:
                self._tell(problem)
