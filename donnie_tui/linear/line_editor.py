"""The line that is being typed: bytes become keys, and keys change the line. No input or output.

``KeyDecoder`` keeps the bytes of an incomplete key until the rest arrives. A lone ESC looks like the
beginning of an arrow key, so the reader calls ``give_up_waiting`` if nothing more comes for ``ESCAPE_DELAY``.
An unknown sequence is ignored as a whole, so that no key types rubbish.

``EditLine`` returns each change as the bytes that a terminal needs. They are as few as readline writes,
because a screen reader says what is written: a character typed at the end writes only itself.

A cluster is what one key deletes and one arrow passes: a character with the marks on it. Characters
joined into one emoji are one cluster, two cells wide.
"""

from __future__ import annotations

import codecs
import re
import unicodedata
from collections.abc import Callable
from enum import Enum, auto

from msgspec import Struct

from donnie_tui.core.wording import Wording
from donnie_tui.outlets.audible import Audible, TypingEcho

ESCAPE_DELAY = 0.05
"""Seconds after which ESC is a key and not the beginning of one."""


class Act(Enum):
    """The purpose of a key."""

    TEXT = auto()
    ENTER = auto()
    ESCAPE = auto()
    INTERRUPT = auto()
    """Ctrl+C, before it is a signal."""
    CLOSE = auto()
    """Ctrl+D: leaves on an empty line, deletes elsewhere."""
    BACKSPACE = auto()
    DELETE = auto()
    LEFT = auto()
    RIGHT = auto()
    HOME = auto()
    END = auto()
    OLDER = auto()
    NEWER = auto()
    KILL_AFTER = auto()
    KILL_BEFORE = auto()
    KILL_WORD = auto()
    COMPLETE = auto()
    """Tab, unless it is a part of a pasted text."""


class KeyPress(Struct, frozen=True):
    """One key. ``text`` is what TEXT types."""

    act: Act
    text: str = ""


_CONTROLS = {
    "\n": Act.ENTER,
    "\r": Act.ENTER,
    "\x01": Act.HOME,
    "\x02": Act.LEFT,
    "\x03": Act.INTERRUPT,
    "\x04": Act.CLOSE,
    "\x05": Act.END,
    "\x06": Act.RIGHT,
    "\x08": Act.BACKSPACE,
    "\x0b": Act.KILL_AFTER,
    "\x0e": Act.NEWER,
    "\x10": Act.OLDER,
    "\x15": Act.KILL_BEFORE,
    "\x17": Act.KILL_WORD,
    "\x7f": Act.BACKSPACE,
}
_LETTERS = {
    "A": Act.OLDER,
    "B": Act.NEWER,
    "C": Act.RIGHT,
    "D": Act.LEFT,
    "F": Act.END,
    "H": Act.HOME,
}
_NUMBERS = {"1": Act.HOME, "3": Act.DELETE, "4": Act.END, "7": Act.HOME, "8": Act.END}

_TEXT = re.compile(r"[^\x00-\x1f\x7f-\x9f]+")
_SEQUENCE = r"\x1b(?:\[\[[A-E]|\[([0-9:;<=>?]*)[ -/]*([@-~])|O([A-Za-z]))"
_UNFINISHED = r"\x1b(?:\[\[?|\[[0-9:;<=>?]*[ -/]*|O)?\Z"
"""Patterns, made with the first ESC."""
_LONGEST_SEQUENCE = 32


class KeyDecoder:
    """Decodes bytes, and remembers those of an incomplete key."""

    def __init__(self) -> None:
        self._decode = codecs.getincrementaldecoder("utf-8")("replace").decode
        self._pending = ""

    @property
    def is_waiting(self) -> bool:
        """Whether an ESC arrived that may be the beginning of more."""
        return bool(self._pending)

    def feed(self, data: bytes) -> list[KeyPress]:
        """The keys that are complete now."""
        text = self._pending + self._decode(data)
        self._pending = ""
        keys: list[KeyPress] = []
        at = 0
        while at < len(text):
            if text[at] == "\x1b" and _is_unfinished(text, at):
                self._pending = text[at:]
                break
            at = _next_key(text, at, keys)
        return keys

    def give_up_waiting(self) -> list[KeyPress]:
        """The keys if nothing more comes: the ESC was a key."""
        pending, self._pending = self._pending, ""
        if not pending:
            return []
        return [KeyPress(Act.ESCAPE), *([KeyPress(Act.TEXT, pending[1:])] if pending[1:] else [])]


def _is_unfinished(text: str, at: int) -> bool:
    """Whether the sequence that begins there may continue."""
    return len(text) - at < _LONGEST_SEQUENCE and bool(re.compile(_UNFINISHED).match(text, at))


def _next_key(text: str, at: int, keys: list[KeyPress]) -> int:
    """Append the key at ``at``, if it means anything. Returns where the next one begins."""
    typed = _TEXT.match(text, at)
    if typed:
        keys.append(KeyPress(Act.TEXT, typed[0]))
        return typed.end()
    if text[at] == "\x1b":
        return _escape(text, at, keys)
    if text[at] == "\t":  # in the middle of one read it is a part of a pasted text
        keys.append(KeyPress(Act.TEXT, " ") if at + 1 < len(text) else KeyPress(Act.COMPLETE))
    elif text[at] in _CONTROLS:
        keys.append(KeyPress(_CONTROLS[text[at]]))
    return at + 1


def _escape(text: str, at: int, keys: list[KeyPress]) -> int:
    sequence = re.compile(_SEQUENCE).match(text, at)
    if not sequence:
        keys.append(KeyPress(Act.ESCAPE))
        return at + 1
    act = _act(*sequence.groups(""))
    if act:
        keys.append(KeyPress(act))
    return sequence.end()


def _act(parameters: str, final: str, letter: str) -> Act | None:
    if letter:
        return Act.ENTER if letter == "M" else _LETTERS.get(letter)
    if parameters.strip("0123456789;"):
        return None
    return _NUMBERS.get(parameters.split(";")[0]) if final == "~" else _LETTERS.get(final)


class EditorEcho:
    """Lets the voice say each key of the editor, before the key changes the line."""

    def __init__(self, audible: Audible, words: Wording) -> None:
        self._echo = TypingEcho(audible, words)

    def __call__(self, key: KeyPress, before: str) -> None:
        """``before`` is the text before the cursor."""
        match key.act:
            case Act.BACKSPACE:
                self._echo.deleted(before)
            case Act.ENTER:
                self._echo.ended(before)
            case _:
                self._echo.typed(key.text, before)


LONGEST = 20_000
"""Clusters in one line; a longer one is not typed by hand."""


class EditLine:
    """The clusters and the cursor. Every method that changes them returns what is to be written."""

    def __init__(self, prompt_width: int, columns: Callable[[], int], text: str = "") -> None:
        """The prompt and ``text`` are printed already, and the cursor is after them.

        Of a prompt that is longer than a row the last row counts.
        """
        self._start = prompt_width % max(2, columns())
        self._columns = columns
        self._text = clusters(text)
        self._cursor = len(self._text)

    @property
    def text(self) -> str:
        return "".join(self._text)

    def do(self, act: Act) -> str:
        """Move or delete as ``act`` says."""
        match act:
            case Act.LEFT:
                return self._go(self._cursor - 1)
            case Act.RIGHT:
                return self._go(self._cursor + 1)
            case Act.HOME:
                return self._go(0)
            case Act.END:
                return self._go(len(self._text))
            case Act.BACKSPACE:
                return self._cut(self._cursor - 1, self._cursor)
            case Act.DELETE | Act.CLOSE:
                return self._cut(self._cursor, self._cursor + 1)
            case Act.KILL_AFTER:
                return self._cut(self._cursor, len(self._text))
            case Act.KILL_BEFORE:
                return self._cut(0, self._cursor)
            case Act.KILL_WORD:
                return self._cut(self._word_start(), self._cursor)
            case _:
                return ""

    @property
    def text_before(self) -> str:
        """The text before the cursor."""
        return "".join(self._text[: self._cursor])

    def complete(self, typed: str, word: str) -> str:
        """Replace ``typed``, the text before the cursor, with ``word``."""
        if word.startswith(typed):
            return self.type(word[len(typed) :]) if len(word) > len(typed) else ""
        first, added = self._cursor - len(clusters(typed)), clusters(word)
        return self._put(first, self._cursor, added, first + len(added))

    def type(self, text: str) -> str:
        """Insert ``text`` at the cursor, as far as it fits into ``LONGEST``."""
        room = LONGEST - len(self._text)
        first = max(0, self._cursor - 1)
        with_marks = clusters("".join(self._text[first : self._cursor]) + text)
        added = with_marks[: room + self._cursor - first]
        if added[:1] == self._text[first : self._cursor]:
            first, added = self._cursor, added[1:]
        return self._put(first, self._cursor, added, first + len(added)) if added else ""

    def replace(self, text: str) -> str:
        """Replace the whole line."""
        return self._put(0, len(self._text), clusters(text)[:LONGEST], None)

    def place_cursor(self) -> str:
        """Put the cursor where the offered text ends, if that is the right margin."""
        return _wrapped(self._text, self._places())

    def finish(self) -> str:
        """Bring the cursor to the last row, so that the next line begins below."""
        at = self._places()
        return "" if at[self._cursor][0] == at[-1][0] else self._go(len(self._text))

    # --- changes

    def _go(self, to: int) -> str:
        if not 0 <= to <= len(self._text):
            return ""
        at = self._places()
        move = self._move(at[self._cursor], at[to], passing=self._text[self._cursor : to])
        self._cursor = to
        return move

    def _cut(self, first: int, last: int) -> str:
        if first < 0 or last > len(self._text) or first == last:
            return ""
        return self._put(first, last, [], first)

    def _put(self, first: int, last: int, added: list[str], cursor: int | None) -> str:
        """Replace the clusters ``first`` to ``last`` with ``added``, and paint what that changes."""
        before = self._places()
        here = before[self._cursor]
        self._text[first:last] = added
        self._cursor = len(self._text) if cursor is None else cursor
        after = self._places()
        tail = self._text[first:]
        painted = self._move(here, before[first]) + "".join(tail)
        painted += _wrapped(tail, after)
        painted += _erased(before[-1], after[-1])
        return painted + self._move(after[-1], after[self._cursor])

    def _word_start(self) -> int:
        at = self._cursor
        while at and self._text[at - 1] == " ":
            at -= 1
        while at and self._text[at - 1] != " ":
            at -= 1
        return at

    # --- the terminal

    def _places(self) -> list[tuple[int, int]]:
        return places(0, self._start, self._text, max(2, self._columns()))

    def _move(self, here: tuple[int, int], there: tuple[int, int], passing: list[str] | None = None) -> str:
        """Moves the cursor; to the right over ``passing``, where given, by writing it again."""
        rows, cells = there[0] - here[0], there[1] - here[1]
        if passing and len(passing) == 1 and width(passing[0]) == cells:
            return passing[0]
        vertical = f"\x1b[{-rows}A" if rows < 0 else f"\x1b[{rows}B" if rows > 0 else ""
        return vertical + _sideways(cells)


def _sideways(cells: int) -> str:
    if cells > 0:
        return f"\x1b[{cells}C"
    return "\b" * -cells if cells > -4 else f"\x1b[{-cells}D"


def _wrapped(written: list[str], at: list[tuple[int, int]]) -> str:
    """A terminal stays on the last cell of a full row; this takes the cursor to the next row."""
    return " \r" if written and at[-1][1] == 0 else ""


def _erased(old_end: tuple[int, int], new_end: tuple[int, int]) -> str:
    """The text that clears the rest of a line that became shorter. The cursor is at its new end."""
    if new_end >= old_end:
        return ""
    return "\x1b[K" if new_end[0] == old_end[0] else "\x1b[J"


_JOINER = "\u200d"


def clusters(text: str) -> list[str]:
    """The text cut into clusters."""
    found: list[str] = []
    for character in text:
        if found and (_is_mark(character) or found[-1].endswith(_JOINER)):
            found[-1] += character
        else:
            found.append(character)
    return found


def width(cluster: str) -> int:
    """Cells that a cluster fills: 2 if it is wide, 0 if it is only a mark."""
    if unicodedata.east_asian_width(cluster[0]) in "WF":
        return 2
    return 0 if _is_mark(cluster[0]) else 1


def places(row: int, column: int, text: list[str], columns: int) -> list[tuple[int, int]]:
    """Where each cluster stands, as row and column, and where the next one would.

    The text begins at ``column`` of ``row``; a wide cluster that does not fit moves to the next row.
    """
    found: list[tuple[int, int]] = []
    for cluster in text:
        cells = width(cluster)
        if column + cells > columns:
            row, column = row + 1, 0
        found.append((row, column))
        column += cells
    if column >= columns:
        row, column = row + 1, 0
    return [*found, (row, column)]


def _is_mark(character: str) -> bool:
    return character == _JOINER or unicodedata.category(character) in ("Mn", "Me")
