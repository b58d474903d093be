"""How the text of a setting is read, wherever it was given. Each reader raises ``ValueError``.

Loudness and pace out of range are clamped, not refused.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping

from devices.ports.hints import TypeAlias
from donnie_tui import LANGUAGES
from donnie_tui.settings import OFF, ON

Sound: TypeAlias = bool | str
"""On, off, or the WAV file into which a run's cues are written."""

SLOWEST, FASTEST = 0.1, 1000.0
LARGEST_SEED = 2**63 - 1
LONGEST_PROGRESS = 3600
"""Seconds between two signs of life of a long run."""

RATES, PERCENTS = (80, 450), (0, 100)
"""The least and the most: words a minute, and of pitch and loudness."""

SPEECH = ("auto", "off", "text", "ssip", "tts", "robot")

_WAV = "wav:"


def read_switch(text: str) -> bool:
    """On or off, in the ways in which files and variables write it."""
    folded = text.strip().lower()
    if folded not in ON + OFF:
        raise ValueError(text)
    return folded in ON


def one_of(words: tuple[str, ...]) -> Callable[[str], str]:
    """A reader of these words."""

    def read(text: str) -> str:
        folded = text.strip().lower()
        if folded not in words:
            raise ValueError(text)
        return folded

    return read


def read_text(text: str) -> str:
    """Any that is not empty."""
    if not text or "\0" in text:
        raise ValueError(text)
    return text


def read_line(text: str) -> str:
    """Any, an empty one too."""
    return read_text(text) if text else ""


def read_language(text: str) -> str:
    """``pt`` also as ``pt-BR`` or ``pt_BR.UTF-8``."""
    language = text.strip().lower().replace("_", "-").split("-")[0]
    return one_of(LANGUAGES)(language)


def read_folders(text: str) -> tuple[str, ...]:
    """Folders, apart as in PATH."""
    folders = folders_of(read_text(text))
    if not folders:
        raise ValueError(text)
    return folders


def folders_of(text: str) -> tuple[str, ...]:
    """The same of any text; an empty one has none."""
    given = (each for each in text.split(os.pathsep) if each.strip())
    return tuple(os.path.expanduser(each) for each in given)  # noqa: PTH111 -- pathlib's raises


# --- numbers


def read_speed(text: str) -> float | None:
    """Times the real robot's pace, or None for ``max``."""
    if text.strip().lower() == "max":
        return None
    speed = float(text.strip().replace(",", "."))
    if math.isnan(speed) or not SLOWEST <= speed <= FASTEST:
        raise ValueError(text)
    return speed


def read_seed(text: str) -> int:
    seed = int(text)
    if not 0 <= seed <= LARGEST_SEED:
        raise ValueError(text)
    return seed


def read_progress(text: str) -> str:
    if not 0 <= int(text) <= LONGEST_PROGRESS:
        raise ValueError(text)
    return str(int(text))


def read_free(text: str) -> str:
    """A letter of a braille alphabet, or ``dot``."""
    if text != "dot" and not (len(text) == 1 and text.isascii() and text.isalpha()):
        raise ValueError(text)
    return text


# --- voice and cues


def read_speech(text: str) -> str:
    """``on`` is the own voice, whatever would be chosen."""
    return "tts" if text.strip().lower() == "on" else one_of(SPEECH)(text)


def read_sound(text: str) -> Sound:
    path = text.strip()[len(_WAV) :]
    if text.strip().lower().startswith(_WAV) and path and "\0" not in text:
        return path
    return read_switch(text)


def read_rate(text: str) -> int:
    """Words a minute."""
    return _clamped(text, *RATES)


def read_percent(text: str) -> int:
    return _clamped(text, *PERCENTS)


def read_cues(text: str) -> Mapping[str, int]:
    """The volumes of cues in percent, by name: ``step-forward 0, bump 50``."""
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
