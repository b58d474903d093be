"""Learners' text as characters: folding that moves no offset, and places in lines and columns.

Rule: nothing is ever rewritten. ``fold`` answers a text of the same length, in which case and accents
are gone, so that an offset in the folded text is an offset in what the learner wrote. Columns count what
is seen: a letter with a combining accent is one, a tab is one, a byte order mark is none.
"""

from __future__ import annotations

import re
import unicodedata
from bisect import bisect_right

from language.syntax import Span

MARK = "\u0300"
"""Stands for every combining mark in a folded text."""

UNSEEN = "\u200b"
"""Stands for every character without width in a folded text; it counts as white space."""

DASHES = "\u2013\u2014"
"""Begin a comment in a folded text, as two hyphens do."""

COMMENT_MARK = f"(?:--|[{DASHES}\u2015])"
"""What begins a comment in a text as it was typed, for a regular expression."""

_FOLD_CACHE_LIMIT = 4096

_SAME_AS = dict.fromkeys("\ufeff\u200b\u200c\u200d\u200e\u200f\u2060", UNSEEN) | {
    "\u2015": "\u2014",
    "\u2010": "-",
    "\u2011": "-",
    "\u2212": "-",
}

_not_ascii = re.compile(r"[^\x00-\x7f]")
_line_end = re.compile(r"\r\n?|\n")
_folds: dict[str, str] = {}


def fold(text: str) -> str:
    """The text without case and accents, character for character."""
    if text.isascii():
        return text.lower()
    return _not_ascii.sub(_fold_match, text).lower()


def fold_name(text: str) -> str:
    """A word as the language compares it: composed and decomposed accents are the same."""
    return fold(text).replace(MARK, "")


def _fold_match(match: re.Match[str]) -> str:
    character = match.group()
    folded = _folds.get(character)
    if folded is None:
        if len(_folds) >= _FOLD_CACHE_LIMIT:
            _folds.clear()
        folded = _folds[character] = _folded(character)
    return folded


def _folded(character: str) -> str:
    if character in _SAME_AS:
        return _SAME_AS[character]
    if unicodedata.combining(character):
        return MARK
    parts = unicodedata.normalize("NFD", character)
    letter = parts[0] if all(map(unicodedata.combining, parts[1:])) else character
    small = letter.casefold()
    if len(small) != 1:
        small = letter.lower()
    return small if len(small) == 1 else letter


class Lines:
    """Where the lines of a text begin. CR, LF and CR LF end a line, and nothing else does."""

    def __init__(self, text: str, first_line: int = 1) -> None:
        self._starts = [0, *line_ends(text)]
        self._widthless = widthless(fold(text))
        self._first_line = first_line

    def __len__(self) -> int:
        return len(self._starts)

    def place(self, offset: int) -> tuple[int, int]:
        """The line and the column of a character."""
        row = bisect_right(self._starts, offset) - 1
        start = self._starts[row]
        return row + self._first_line, column(start, offset, self._widthless)

    def span(self, start: int, end: int) -> Span:
        line, start_column = self.place(start)
        return Span(start, end, line, start_column)

    def offset(self, line: int, column_: int = 1) -> int:
        """Where that column of that line is. Raises ``IndexError`` for a line that there is not."""
        row = line - self._first_line
        if row < 0:
            raise IndexError(line)
        offset = self._starts[row] + column_ - 1
        for each in self._widthless[bisect_right(self._widthless, self._starts[row] - 1) :]:
            if each > offset:
                break
            offset += 1
        return offset


def widthless(folded: str) -> list[int]:
    """The offsets of what takes no place on the screen."""
    if folded.isascii():
        return []
    return [match.start() for match in re.finditer(f"[{MARK}{UNSEEN}]", folded)]


def column(line_start: int, offset: int, widthless_offsets: list[int]) -> int:
    """The column, from 1, of the character at ``offset`` in the line that begins at ``line_start``."""
    unseen = bisect_right(widthless_offsets, offset - 1) - bisect_right(widthless_offsets, line_start - 1)
    return offset - line_start + 1 - unseen


def line_ends(text: str) -> list[int]:
    """The offset behind each line end."""
    return [match.end() for match in _line_end.finditer(text)]


def lines_in(text: str) -> list[str]:
    """The lines of a program; form feeds and the like end none."""
    lines = with_newlines(text).split("\n")
    return lines if lines[-1] else lines[:-1]


def with_newlines(text: str) -> str:
    """The text with one kind of line end."""
    return text.replace("\r\n", "\n").replace("\r", "\n")
