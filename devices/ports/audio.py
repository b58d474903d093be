"""What makes Donnie audible. Every method returns at once; the silent ones always work."""

from __future__ import annotations

from enum import Enum

from devices.ports.hints import Protocol
from devices.ports.values import Frozen


class Urgency(Enum):
    """Who goes first when several things want to be said (speech specification, S7)."""

    ALERT = 0
    ANSWER = 1
    PROGRAM = 2
    """What SPEAK says: never dropped, never reordered."""
    PROGRESS = 3
    HINT = 4


class Utterance(Frozen):
    """One sentence to be spoken, exactly as it was printed."""

    text: str
    urgency: Urgency
    language: str
    """``en``, ``pt`` or ``es``."""


class Cue(Frozen):
    """A short sound with a direction and, where it has one, a distance."""

    name: str
    bearing: float = 0.0
    """Degrees from the robot's front, positive to the right."""
    steps: float | None = None


class Speaker(Protocol):
    """A voice."""

    def say(self, utterance: Utterance) -> None: ...

    def silence(self) -> None:
        """Stop speaking and forget what was queued."""

    def close(self) -> None: ...


class CuePlayer(Protocol):
    """Plays cues."""

    def play(self, cue: Cue) -> None: ...

    def silence(self) -> None: ...

    def close(self) -> None: ...
