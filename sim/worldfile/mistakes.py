"""Mistakes in a world file as ``WorldError``: code, file, place and parameters; i18n has the sentences.

For a missing file or model the nearest name in the world's folders is offered, if it could be included.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from difflib import get_close_matches
from enum import Enum
from itertools import islice
from pathlib import Path

from donnie_tui.process.confinement import open_bytes

MOST_FILES = 300
"""Files of a folder that are looked at."""
LONGEST = 200_000
"""Bytes of each that are searched."""
NEAR = 0.7
"""The least similarity of two names, from 0 to 1."""


def near_name(name: str, known: Iterable[str]) -> str:
    """The name that is most like it, or has it as a part (``sofa`` in ``small_sofa``); empty if none is."""
    if not 0 < len(name) < 60:
        return ""
    names = sorted(known)
    close = get_close_matches(name, names, 1, NEAR)
    return next(iter([*close, *(each for each in names if name in each.split("_"))]), "")


def near_file(path: str, folders: Iterable[Path]) -> str:
    """The file to include that is called most like it."""
    by_stem = {file.stem: file.name for file in _includes(folders)}
    return by_stem.get(near_name(Path(path).stem, by_stem), "")


def defining(model: str, folders: Iterable[Path]) -> str:
    """The file to include that defines a model; empty if none does."""
    pattern = re.compile(rb"^[ \t]*define\s+" + re.escape(model.encode()) + rb"\s", re.MULTILINE)
    return next((file.name for file in _includes(folders) if pattern.search(_start(file))), "")


def worlds_in(folder: Path) -> str:
    """The first world file in a folder."""
    return min((str(file) for file in _files(folder) if file.suffix == ".world"), default="")


def near_world(path: Path) -> str:
    """The world file in the same folder that is called most like it, but for the suffix, which all have."""
    files = (file for file in _files(path.parent) if file.suffix == ".world")
    by_stem = {file.stem: str(path.with_name(file.name)) for file in files}
    return by_stem.get(near_name(path.stem, by_stem), "")


def _includes(folders: Iterable[Path]) -> Iterator[Path]:
    for folder in dict.fromkeys(folders):
        yield from sorted(file for file in _files(folder) if file.suffix == ".inc")


def _files(folder: Path) -> tuple[Path, ...]:
    try:
        return tuple(each for each in islice(folder.iterdir(), MOST_FILES) if each.is_file())
    except OSError:
        return ()


def _start(file: Path) -> bytes:
    try:
        if not file.is_file():
            return b""
        with open_bytes(file) as stream:
            return stream.read(LONGEST)
    except OSError:
        return b""


class Code(Enum):
    """The kind of a mistake. The details of each are named after it."""

    # files
    FILE_NOT_FOUND = "file-not-found"  # path, nearest
    IS_FOLDER = "is-folder"  # path, nearest: a world in it
    FILE_UNREADABLE = "file-unreadable"  # path, reason
    NO_FILE = "file-no-file"  # path: of a device or a pipe
    FILE_TOO_LARGE = "file-too-large"  # path, limit (bytes)
    INCLUDE_CYCLE = "include-cycle"  # path
    INCLUDE_OUTSIDE = "include-outside"  # path, folder: of that file
    INCLUDE_TOO_DEEP = "include-too-deep"  # limit
    TOO_MANY_FILES = "too-many-files"  # limit
    NO_WORLD_FILE = "no-world-file"  # a configuration that names neither a world nor a real robot
    BAD_ADDRESS = "bad-address"  # found
    BITMAP_NOT_FOUND = "bitmap-not-found"  # path
    BITMAP_OUTSIDE = "bitmap-outside"  # path, folder
    BITMAP_UNREADABLE = "bitmap-unreadable"  # path
    BITMAP_DAMAGED = "bitmap-damaged"  # path
    BITMAP_TOO_LARGE = "bitmap-too-large"  # given, limit (pixels)
    BITMAPS_TOO_LARGE = "bitmaps-too-large"  # given, limit (pixels)
    BITMAP_TOO_MANY_LAYERS = "bitmap-too-many-layers"  # given, limit
    # text
    UNKNOWN_CHARACTER = "unknown-character"  # found
    COMMENT_SIGN = "comment-sign"  # found: how comments begin in other languages
    UNTERMINATED_STRING = "unterminated-string"
    BAD_NUMBER = "bad-number"  # found
    NUMBER_TOO_LARGE = "number-too-large"  # found
    NESTED_TOO_DEEP = "nested-too-deep"  # limit
    UNEXPECTED = "unexpected"  # found
    UNCLOSED = "unclosed"  # found: the sign that was opened
    MISPLACED = "misplaced"  # found: a word that stands at the top level only
    # meaning
    UNKNOWN_TYPE = "unknown-type"  # found, nearest
    MISSING_INCLUDE = "missing-include"  # found, path: the file that defines it
    DEFINE_CYCLE = "define-cycle"  # found
    TOO_MUCH = "too-much"  # what, limit
    WRONG_TYPE = "wrong-type"  # name
    WRONG_COUNT = "wrong-count"  # name, given
    OUT_OF_RANGE = "out-of-range"  # name
    TOO_FEW_POINTS = "too-few-points"  # given


class WorldError(Exception):
    """A world file that can't be used."""

    def __init__(
        self,
        code: Code,
        file: str,
        line: int = 1,
        column: int = 1,
        expected: tuple[str, ...] = (),
        **details: str | int | float,
    ) -> None:
        super().__init__(f"{file}:{line}:{column}: {code.value}")
        self.code = code
        self.file = file
        self.line = line
        self.column = column
        self.expected = expected
        """Classes (``name``, ``number``, ``string``, ``tuple``), or the words and signs themselves."""
        self.details: Mapping[str, str | int | float] = details
