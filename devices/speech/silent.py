"""The speaker that always works: it says nothing, and says it at once."""

from __future__ import annotations

from devices.ports.audio import Utterance


class SilentSpeaker:
    """A ``Speaker`` without a voice; the printed line is all there is."""

    def say(self, utterance: Utterance) -> None:
        """Nothing is heard."""

    def silence(self) -> None:
        """Nothing was heard."""

    def close(self) -> None:
        """Nothing is held."""
