"""The cue player that always works: not a sound, not a byte."""

from __future__ import annotations

from devices.ports.audio import Cue


class SilentCuePlayer:
    """A ``CuePlayer`` without a loudspeaker; every cue has its sentence elsewhere."""

    def play(self, cue: Cue) -> None:
        """Nothing is heard."""

    def silence(self) -> None:
        """Nothing was heard."""

    def close(self) -> None:
        """Nothing is held."""
