"""The learner's text as characters: folding that moves no offset, and places in lines and columns.

``fold`` returns a text of the same length without case and accents, so an offset in the folded text is an
offset in the learner's text. Only letters lose their marks: ≠ stays what it is. Columns count visible
characters: a letter with a combining accent is one, a tab is one, a byte order mark is none. ``printable``
and ``cleaned`` put a blank in the place of each character that could control a terminal or can't be encoded,
so that columns stay the same.
"""

from __future__ import annotations

import re
import unicodedata
from bisect import bisect_right

MARK = "\u0300"
"""Stands for every combining mark in a folded text."""

UNSEEN = "\u200b"
"""Stands for every character without width in a folded text; it counts as white space."""

DASHES = "\u2013\u2014"
"""Begin a comment in a folded text, like two hyphens."""

COMMENT_MARK = f"(?:--|[{DASHES}\u2015])"
"""A regular expression for the beginning of a comment in a text as it was typed."""

_FOLD_CACHE_LIMIT = 4096

_SAME_AS = dict.fromkeys("\ufeff\u200b\u200c\u200d\u200e\u200f\u2060", UNSEEN) | {
    "\u2015": "\u2014",
    "\u2010": "-",
    "\u2011": "-",
    "\u2212": "-",
}

_not_ascii = re.compile(r"[^\x00-\x7f]")
_line_break = re.compile(r"\r\n?|\n")
_folds: dict[str, str] = {}


def fold(text: str) -> str:
    """The text without case and accents, character for character."""
    if text.isascii():
        return text.lower()
    return _not_ascii.sub(_fold_match, text).lower()


def fold_name(text: str) -> str:
    """A word for comparisons: composed and decomposed accents are the same."""
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
    letter = parts[0] if _is_marked_letter(parts) else character
    small = letter.casefold()
    if len(small) != 1:
        small = letter.lower()
    return small if len(small) == 1 else letter


def _is_marked_letter(parts: str) -> bool:
    """Whether a decomposed character is a letter with marks, or another form of one character."""
    return len(parts) == 1 or (parts[0].isalpha() and all(map(unicodedata.combining, parts[1:])))


class Lines:
    """The lines of a text. Only CR, LF and CR LF end a line."""

    def __init__(self, text: str, first_line: int = 1) -> None:
        self._starts = [0, *line_breaks(text)]
        self._widthless = widthless(fold(text))
        self._first_line = first_line

    def place(self, offset: int) -> tuple[int, int]:
        """The line and the column of a character."""
        row = bisect_right(self._starts, offset) - 1
        start = self._starts[row]
        return row + self._first_line, column(start, offset, self._widthless)


def widthless(folded: str) -> list[int]:
    """The offsets of characters without width."""
    if folded.isascii():
        return []
    return [match.start() for match in re.finditer(f"[{MARK}{UNSEEN}]", folded)]


def column(line_start: int, offset: int, widthless_offsets: list[int]) -> int:
    """The column, from 1, of the character at ``offset`` in the line that begins at ``line_start``."""
    unseen = bisect_right(widthless_offsets, offset - 1) - bisect_right(widthless_offsets, line_start - 1)
    return offset - line_start + 1 - unseen


def line_breaks(text: str) -> list[int]:
    """The offset after each line break."""
    return [match.end() for match in _line_break.finditer(text)]


def lines_in(text: str) -> list[str]:
    """The lines of a program; form feeds and similar characters end no line."""
    lines = with_newlines(text).split("\n")
    return lines if lines[-1] else lines[:-1]


def with_newlines(text: str) -> str:
    """The text with one kind of line break."""
    return text.replace("\r\n", "\n").replace("\r", "\n")


HARMFUL = "[\x00-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\ud800-\udfff]"
"""Control characters, line ends, marks that reverse the direction of text, and halves of characters.

A pattern, compiled on first use, since a start needs none.
"""


LONGEST_QUOTE = 40
"""Characters of what was typed that an answer repeats."""


def printable(text: str) -> str:
    """The text as one line."""
    return text if text.isprintable() else re.sub(HARMFUL, " ", text)


def quoted(text: str, longest: int = LONGEST_QUOTE) -> str:
    """What was typed, as an answer repeats it: on one line, cut if it has over ``longest`` characters."""
    shown = printable(text)
    return shown if len(shown) <= longest else f"{shown[: longest - 1]}…"


def cleaned(text: str) -> str:
    """The text with its lines: tabs and the language's own line ends (CR, LF) stay."""
    return text if text.isprintable() else re.sub(rf"(?![\t\r\n]){HARMFUL}", " ", text)
