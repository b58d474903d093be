"""Mistakes in a world file: codes, places, parameters; the sentences are made elsewhere.

WorldError      the file can't be used; always with the file and the place where that shows
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum


class Code(Enum):
    """What is wrong. The details that come with each are named behind it."""

    # files
    FILE_NOT_FOUND = "file-not-found"  # path, nearest
    IS_FOLDER = "is-folder"  # path, nearest: a world in it
    FILE_UNREADABLE = "file-unreadable"  # path
    FILE_TOO_LARGE = "file-too-large"  # path, limit (bytes)
    INCLUDE_CYCLE = "include-cycle"  # path
    INCLUDE_OUTSIDE = "include-outside"  # path
    INCLUDE_TOO_DEEP = "include-too-deep"  # limit
    NO_WORLD_FILE = "no-world-file"  # a configuration that names neither a world nor a real robot
    BAD_ADDRESS = "bad-address"  # found
    BITMAP_NOT_FOUND = "bitmap-not-found"  # path
    BITMAP_OUTSIDE = "bitmap-outside"  # path
    BITMAP_UNREADABLE = "bitmap-unreadable"  # path
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
    TOO_MUCH = "too-much"  # limit
    WRONG_TYPE = "wrong-type"  # name
    WRONG_COUNT = "wrong-count"  # name, given
    OUT_OF_RANGE = "out-of-range"  # name
    WRONG_ORDER = "wrong-order"  # name: of two numbers the smaller comes first
    UNKNOWN_WORD = "unknown-word"  # name, found, nearest
    MISSING_POINT = "missing-point"  # name
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
