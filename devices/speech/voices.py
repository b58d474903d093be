"""Which voice reads which language, and how fast, high and loud (S10, S11). Pure.

A language is read by a voice of that language or not at all: Portuguese from Brazil, then from Portugal;
never by another language's voice.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

from devices.ports.values import Frozen, replace

LANGUAGES = ("en", "pt", "es")
"""The languages that Donnie talks in, as ``Utterance.language`` writes them."""

PUNCTUATION = ("none", "some", "all")

_PREFERENCES = {
    "en": ("en", "en-gb", "en-us"),
    "pt": ("pt-br", "pt", "pt-pt"),
    "es": ("es", "es-es", "es-419", "es-mx"),
}


class Voice(Frozen):
    """A voice that a synthesiser offers."""

    identifier: str
    """What the synthesiser wants to hear back, such as ``roa/pt-br``."""
    languages: tuple[str, ...]
    """Language tags, in any case, such as ``pt-br``."""


class VoiceSettings(Frozen):
    """How the voice sounds. Out-of-range values are clamped by ``clamped``, not refused."""

    words_per_minute: int = 180
    """80 to 450."""
    pitch: int = 50
    """0 to 100."""
    volume: float = 1.0
    """0 to 1."""
    punctuation: str = "some"
    """``none``, ``some`` (what programs need) or ``all``."""
    chosen: frozenset[str] = frozenset()
    """Which of rate, pitch and volume somebody asked for, by these names. A speech-dispatcher has ways of its
    own for the others."""

    def clamped(self) -> VoiceSettings:
        """The nearest settings that a voice can have; what is no number becomes the default."""
        return replace(
            self,
            words_per_minute=round(_clamp(self.words_per_minute, 80, 450, 180)),
            pitch=round(_clamp(self.pitch, 0, 100, 50)),
            volume=_clamp(self.volume, 0.0, 1.0, 1.0),
            punctuation=self.punctuation if self.punctuation in PUNCTUATION else "some",
        )


def base_language(language: str) -> str:
    """``pt`` for ``pt``, ``pt-BR`` and ``pt_BR``."""
    return language.lower().replace("_", "-").split("-", 1)[0]


def choose_voice(language: str, voices: Iterable[Voice]) -> Voice | None:
    """The best of ``voices`` for ``language``, or None if none of them reads it."""
    offered = [(_tags(voice), voice) for voice in voices if _is_complete(voice)]
    for wanted in _PREFERENCES.get(base_language(language), ()):
        for tags, voice in offered:
            if wanted in tags:
                return voice
    return None


def _tags(voice: Voice) -> frozenset[str]:
    own_name = voice.identifier.lower().rsplit("/", 1)[-1]
    return frozenset({tag.lower().replace("_", "-") for tag in voice.languages} | {own_name})


def _is_complete(voice: Voice) -> bool:
    """MBROLA voices are listed by espeak-ng even where their data, a package of its own, is missing."""
    return not voice.identifier.lower().startswith("mb/")


def _clamp(value: float, lowest: float, highest: float, default: float) -> float:
    return default if math.isnan(value) else min(max(value, lowest), highest)
