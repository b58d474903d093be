"""The settings of voice and cues as text. Numbers out of range are clamped, not refused."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TypeAlias

Sound: TypeAlias = bool | str
"""On, off, or the WAV file into which a run's cues are written."""

SPEAK = ("here", "robot", "both")
PUNCTUATION = ("none", "some", "all")
KEY_ECHO = ("none", "characters", "words")

SOUND_WANTED = "on, off, wav:FILE"
RATE_WANTED = "80-450"
PERCENT_WANTED = "0-100"
CUES_WANTED = "NAME 0-100, NAME 0-100"

_WAV = "wav:"
_ON = frozenset({"on", "yes", "true", "1"})
_OFF = frozenset({"off", "no", "false", "0"})


def read_sound(text: str) -> Sound:
    """Raises ``ValueError``."""
    folded = text.strip().lower()
    if folded in _ON or folded in _OFF:
        return folded in _ON
    if folded.startswith(_WAV) and text.strip()[len(_WAV) :] and "\0" not in text:
        return text.strip()[len(_WAV) :]
    raise ValueError(text)


def read_rate(text: str) -> int:
    """Words a minute. Raises ``ValueError``."""
    return _clamped(text, 80, 450)


def read_percent(text: str) -> int:
    """Raises ``ValueError``."""
    return _clamped(text, 0, 100)


def read_cues(text: str) -> Mapping[str, int]:
    """The volumes of cues in percent, by name: ``step-forward 0, bump 50``. Raises ``ValueError``."""
    volumes: dict[str, int] = {}
    for each in text.split(","):
        name, _, percent = each.strip().partition(" ")
        if not name or not name.replace("-", "").isalpha():
            raise ValueError(text)
        volumes[name.lower()] = read_percent(percent)
    return volumes


def _clamped(text: str, lowest: int, highest: int) -> int:
    number = float(text.strip().rstrip("%").replace(",", "."))
    if math.isnan(number):
        raise ValueError(text)
    return round(min(max(number, lowest), highest))
