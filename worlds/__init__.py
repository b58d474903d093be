"""The worlds that come with Donnie: files that Stage can load too, each with words in three languages.

Data only: reading a world's file is the simulator's business. ``scenes`` holds the scenarios, ``manual`` the
worlds of the manual's chapter on world files, step by step.
"""

from __future__ import annotations

import os
import re
from enum import Enum

from devices.ports.hints import TYPE_CHECKING, Any
from devices.ports.values import Frozen

if TYPE_CHECKING:
    from pathlib import Path

_HERE = os.path.realpath(__path__[0])
SCENES = f"{_HERE}/scenes"
"""The folder with the world files of the scenarios and what they include."""
MANUAL = f"{_HERE}/manual"
"""The folder with the worlds of the manual."""

WORLD = ".world"
WORDS = ".toml"
"""Beside ``maze.world`` lies ``maze.toml`` with its words."""
LANGUAGES = ("en", "pt", "es")
LARGEST = 100_000
"""Bytes of words that are read."""
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
    UNTOLD = ""
    """The author of a world says nothing of it."""


class About(Frozen):
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


def _names_in(folder: str) -> tuple[str, ...]:
    found = {file.name.removesuffix(WORLD) for file in os.scandir(folder) if file.name.endswith(WORLD)}
    return tuple(name for name in _ORDER if name in found) + tuple(sorted(found.difference(_ORDER)))


def path(name: str) -> str:
    """The world file. KeyError if there is no such world."""
    for folder in (SCENES, MANUAL):
        if name in _names_in(folder):
            return f"{folder}/{name}{WORLD}"
    raise KeyError(name)


def about(name: str, language: str) -> About:
    """What to say of a world in ``en``, ``pt`` or ``es``. KeyError if there is no such world or language."""
    return _about(_read(_beside(path(name))), language)


class BadWords(Exception):
    """A file of words that can't be used."""

    def __init__(self, file: Path, key: str = "", line: str = "") -> None:
        super().__init__(f"{file}: {key or line}")
        self.file = file
        self.key = key
        """What is missing in it or is no text, such as ``en.title``; empty if it can't be read at all."""
        self.line = line
        """Where it can't be read, if that is known."""


def words_file(world: str) -> str | None:
    """The file with an author's words beside a world file; None where there is none."""
    file = _beside(world)
    return str(file) if file.is_file() else None


def words_beside(world: str, language: str) -> About | None:
    """What the author of a world file says of it in a file beside it, None without one. Raises ``BadWords``.

    In that language if it is there, else in English, else in any of the three.
    """
    file = _beside(world)
    if not file.is_file():
        return None
    told = _read(file)
    written = [each for each in (language, *LANGUAGES) if each in told]
    if not written:
        raise BadWords(file, language)
    for key in ("title", "description", "task"):
        if not isinstance(told[written[0]], dict) or not isinstance(told[written[0]].get(key), str):
            raise BadWords(file, f"{written[0]}.{key}")
    if told.get("difficulty", "") not in [each.value for each in Difficulty]:
        raise BadWords(file, "difficulty")
    return _about(told, written[0])


def _beside(world: str) -> Path:
    """The file of its words."""
    from pathlib import Path  # slow to load, and a start needs no words

    return Path(world).with_suffix(WORDS)


def _read(file: Path) -> dict[str, Any]:
    import tomllib  # slow to load, and a start needs no words

    try:
        with file.open("rb") as stream:
            return tomllib.loads(stream.read(LARGEST).decode("utf-8-sig").replace("\r\n", "\n"))
    except OSError:
        raise BadWords(file) from None
    except (ValueError, RecursionError) as problem:
        place = re.search(r"line (\d+)", str(problem))
        raise BadWords(file, line=place[1] if place else "") from None


def _about(told: dict[str, Any], language: str) -> About:
    words = told[language]
    return About(
        words["title"], words["description"].strip(), words["task"], Difficulty(told.get("difficulty", ""))
    )
