"""The worlds that come with Donnie: files that Stage can load too, each with words in three languages.

Data only: reading a world's file is the simulator's business.
"""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path

SCENES = Path(__file__).resolve().parent / "scenes"
"""The folder with the world files and what they include."""

_ORDER = ("open_floor", "living_room")
"""Easy ones first; what is not named here follows by name."""


@dataclass(frozen=True, slots=True)
class About:
    """What is said of a world in one language."""

    title: str
    description: str
    """Some sentences that need no picture."""
    task: str
    """Something to try there."""


def names() -> tuple[str, ...]:
    """The names of the worlds, in the order in which to offer them."""
    found = {file.stem for file in SCENES.glob("*.world")}
    return tuple(name for name in _ORDER if name in found) + tuple(sorted(found.difference(_ORDER)))


def path(name: str) -> Path:
    """The world file. KeyError if there is no such world."""
    if name not in names():
        raise KeyError(name)
    return SCENES / f"{name}.world"


def about(name: str, language: str) -> About:
    """What to say of a world in ``en``, ``pt`` or ``es``. KeyError if there is no such world or language."""
    path(name)
    words = tomllib.loads((SCENES / f"{name}.toml").read_text(encoding="utf-8"))[language]
    return About(words["title"], words["description"], words["task"])
