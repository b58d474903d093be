"""Worlds in words: of a built-in world, and of one whose author wrote a file of words."""

from __future__ import annotations

import re
from enum import Enum
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from donnie_tui.process.confinement import open_bytes
from worlds import path

if TYPE_CHECKING:
    from pathlib import Path

WORDS = ".toml"
"""``maze.toml`` next to ``maze.world`` has its words."""
ENGLISH = "en"
LARGEST = 100_000
"""Bytes of words that are read."""
MOST_DOTS = 200
"""In a line."""


class Difficulty(Enum):
    """How much of the language a world's task needs."""

    EASY = "easy"
    """A few commands in a row."""
    MEDIUM = "medium"
    """Sensors and loops."""
    HARD = "hard"
    """A program that decides for itself."""
    UNSTATED = ""
    """The author of a world doesn't state it."""


class About(Struct, frozen=True):
    """The words about a world in one language."""

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


def about(name: str, language: str) -> About:
    """The words about a built-in world, in English if the language is missing. Raises ``KeyError``."""
    texts = _read(_file_of(path(name)))
    return _about(texts, language if language in texts else ENGLISH)


class BadWords(Exception):
    """A file of words that can't be used."""

    def __init__(self, file: Path, key: str = "", line: str = "", limit: int = 0) -> None:
        super().__init__(f"{file}: {key or line}")
        self.file = file
        self.key = key
        """The key that is missing or no text, such as ``en.title``; empty for an unreadable file."""
        self.line = line
        """The line that can't be read, if it is known."""
        self.limit = limit
        """The allowed number of bytes, if the file has more."""


def words_file(world: str) -> str | None:
    """The path of the file with the author's words for a world file; None if there is none."""
    file = _file_of(world)
    return str(file) if file.is_file() else None


def about_file(world: str, language: str) -> About | None:
    """The words about a world file from its file of words, None without one. Raises ``BadWords``.

    In that language if it is there, else in English, else in the first one of the file.
    """
    file = _file_of(world)
    if not file.is_file():
        return None
    texts = _read(file)
    others = (each for each, text in texts.items() if isinstance(text, dict))
    written = [each for each in (language, ENGLISH, *others) if each in texts]
    if not written:
        raise BadWords(file, language)
    for key in ("title", "description", "task"):
        if not isinstance(texts[written[0]], dict) or not isinstance(texts[written[0]].get(key), str):
            raise BadWords(file, f"{written[0]}.{key}")
    if texts.get("difficulty", "") not in [each.value for each in Difficulty]:
        raise BadWords(file, "difficulty")
    return _about(texts, written[0])


def _file_of(world: str) -> Path:
    """The file of its words."""
    from pathlib import Path

    return Path(world).with_suffix(WORDS)


def _read(file: Path) -> dict[str, Any]:
    try:
        with open_bytes(file) as stream:
            data = stream.read(LARGEST + 1)
        if len(data) > LARGEST:
            raise BadWords(file, limit=LARGEST)
        return parsed(data)
    except OSError:
        raise BadWords(file) from None
    except (ValueError, RecursionError) as problem:
        place = re.search(r"line (\d+)", str(problem))
        raise BadWords(file, line=place[1] if place else "") from None


def parsed(data: bytes) -> dict[str, Any]:
    """Raises ``ValueError``, also for too many dots in a line: such a key takes tomllib minutes."""
    import tomllib

    text = data.decode("utf-8-sig").replace("\r\n", "\n")
    for number, line in enumerate(text.split("\n"), start=1):
        if line.count(".") > MOST_DOTS:
            raise ValueError(f"too many dots (at line {number}, column 1)")
    return tomllib.loads(text)


def _about(texts: dict[str, Any], language: str) -> About:
    words = texts[language]
    return About(
        words["title"], words["description"].strip(), words["task"], Difficulty(texts.get("difficulty", ""))
    )
