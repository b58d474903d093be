"""The ports for voice and sound, and the notices about them.

Every method returns at once.
"""

from __future__ import annotations

import math
from enum import Enum
from typing import Protocol

from msgspec import Struct
from msgspec.structs import replace

PUNCTUATION = ("none", "some", "all")
CUES = (
    *("step-forward", "step-back", "turn-right", "turn-left", "obstacle", "bump", "scan", "found"),
    *(
        "grip",
        "release",
        "nothing",
        "belt",
        "done",
        "goal",
        "solved",
        "error",
        "waiting",
        "block-opened",
        "block-closed",
    ),
)
"""Every cue, in the order in which CUES plays them."""


class Urgency(Enum):
    """Which of several utterances is said first."""

    ALERT = 0
    ANSWER = 1
    PROGRAM = 2
    """Of SPEAK: never dropped, never reordered."""
    PROGRESS = 3
    HINT = 4


class Utterance(Struct, frozen=True):
    """A text to be spoken, exactly as it was printed."""

    text: str
    urgency: Urgency
    language: str
    """Its code, such as ``en`` or ``pt``."""


class Cue(Struct, frozen=True):
    """A short sound with a direction and, where it has one, a distance."""

    name: str
    bearing: float = 0.0
    """Degrees from the robot's front, positive to the right."""
    steps: float | None = None


class VoiceSettings(Struct, frozen=True):
    """How the voice sounds. ``clamped`` brings values into their ranges."""

    words_per_minute: int = 180
    """80 to 450."""
    pitch: int = 50
    """0 to 100."""
    volume: float = 1.0
    """0 to 1."""
    punctuation: str = "some"
    """``none``, ``some`` (what programs need) or ``all``."""
    chosen: frozenset[str] = frozenset()
    """Which of rate, pitch and volume the learner set, by these names. speech-dispatcher has its own defaults
    for the others."""

    def clamped(self) -> VoiceSettings:
        """The nearest valid settings; a value that is no number becomes the default."""
        return replace(
            self,
            words_per_minute=round(_clamp(self.words_per_minute, 80, 450, 180)),
            pitch=round(_clamp(self.pitch, 0, 100, 50)),
            volume=_clamp(self.volume, 0.0, 1.0, 1.0),
            punctuation=self.punctuation if self.punctuation in PUNCTUATION else "some",
        )


def _clamp(value: float, lowest: float, highest: float, default: float) -> float:
    return default if math.isnan(value) else min(max(value, lowest), highest)


def base_language(language: str) -> str:
    """``pt`` for ``pt``, ``pt-BR`` and ``pt_BR``."""
    return language.lower().replace("_", "-").split("-", 1)[0]


class Speaker(Protocol):
    """A voice."""

    def say(self, utterance: Utterance) -> None: ...

    def silence_speech(self) -> None:
        """Stop speaking, and drop the utterances that wait."""


class CuePlayer(Protocol):
    """Plays cues."""

    def play(self, cue: Cue) -> None: ...

    def silence_cues(self) -> None: ...


class NoticeCode(Enum):
    """What the learner must know about voice and sound: the codes of translated sentences.

    Each is reported at most once, ``VOICE_MISSING`` once a language.
    """

    NO_SOUND_DEVICE = "no-sound-device"
    """This machine has no sound. Everything is printed."""
    NO_VOICE = "no-voice"
    """There are cues, but no voice: espeak-ng is missing or broken."""
    VOICE_MISSING = "voice-missing"
    """No voice reads ``language``; texts in it are only printed."""
    AUDIO_GAVE_UP = "audio-gave-up"
    """The audio worker failed three times in a minute. Everything is only printed until the next start."""
    SPEECH_BACKLOG = "speech-backlog"
    """The program speaks faster than the voice, for hours; from now on some of it is only printed."""
    SSIP_SILENT = "ssip-silent"
    """speech-dispatcher accepts sentences and never reports their end: it has no sound device."""
    SSIP_LOST = "ssip-lost"
    """speech-dispatcher was lost three times in a minute. Everything is only printed until the next start."""


class AudioNotice(Struct, frozen=True):
    """One notice."""

    code: NoticeCode
    language: str = ""
    """``en``, ``pt`` or ``es``, where the code is about one."""
