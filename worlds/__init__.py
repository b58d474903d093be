"""The worlds that come with Donnie: files that Stage can load too, each with words in three languages.

Data only: reading a world's file is the simulator's business. ``scenes`` holds the scenarios, ``manual`` the
worlds of the manual's chapter on world files, step by step.
"""

from __future__ import annotations

from enum import Enum
from pathlib import Path

from devices.ports.values import frozen

SCENES = Path(__file__).resolve().parent / "scenes"
"""The folder with the world files of the scenarios and what they include."""
MANUAL = SCENES.parent / "manual"
"""The folder with the worlds of the manual."""

_ORDER = (
    *("open_floor", "living_room", "corridor", "colour_garden", "object_field"),
    *("two_robots", "race_track", "cave", "factory", "maze"),
    *("empty", "helloworld", "bigbob1", "bigbob2", "bigbob_yaws", "bigbob3", "bigbob_drive"),
    *("bigbob4", "bigbob5", "bigbob6", "bigbob_oranges", "bigbob7"),
)
"""Easy scenarios first, the manual's steps as they come there; what is not named here follows by name."""


class Difficulty(Enum):
    """How much of the language the task of a world needs."""

    EASY = "easy"
    """A few commands in a row."""
    MEDIUM = "medium"
    """Sensors and loops."""
    HARD = "hard"
    """A program that decides for itself."""


@frozen
class About:
    """What is said of a world in one language."""

    title: str
    description: str
    """Some sentences that need no picture, a line each."""
    task: str
    """Something to try there."""
    difficulty: Difficulty

    @property
    def sentences(self) -> tuple[str, ...]:
        """The description, sentence by sentence."""
        return tuple(self.description.split("\n"))


def names() -> tuple[str, ...]:
    """The names of the worlds, in the order in which to offer them: scenarios first, then the manual's."""
    return (*scenarios(), *_names_in(MANUAL))


def scenarios() -> tuple[str, ...]:
    """The names of the worlds that are no step of the manual."""
    return _names_in(SCENES)


def _names_in(folder: Path) -> tuple[str, ...]:
    found = {file.stem for file in folder.glob("*.world")}
    return tuple(name for name in _ORDER if name in found) + tuple(sorted(found.difference(_ORDER)))


def path(name: str) -> Path:
    """The world file. KeyError if there is no such world."""
    for folder in (SCENES, MANUAL):
        if name in _names_in(folder):
            return folder / f"{name}.world"
    raise KeyError(name)


def about(name: str, language: str) -> About:
    """What to say of a world in ``en``, ``pt`` or ``es``. KeyError if there is no such world or language."""
    import tomllib  # slow to load, and a start needs no words

    told = tomllib.loads(path(name).with_suffix(".toml").read_text(encoding="utf-8"))
    words = told[language]
    return About(words["title"], words["description"].strip(), words["task"], Difficulty(told["difficulty"]))
