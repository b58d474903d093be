"""Bytes of a terminal become keys. No input or output: bytes in, keys out.

Rules: bytes that are incomplete wait for the rest; a lone ESC can't be told from the beginning of an arrow
key, so whoever feeds the decoder calls ``give_up_waiting`` once nothing more has come for ``ESCAPE_DELAY``.
A sequence that is not known is swallowed whole, so that no key types rubbish.
"""

from __future__ import annotations

import codecs
import re
from enum import Enum, auto

from devices.ports.values import Frozen

ESCAPE_DELAY = 0.05
"""Seconds after which ESC is ESC."""


class Act(Enum):
    """What a key is for."""

    TEXT = auto()
    ENTER = auto()
    ESCAPE = auto()
    INTERRUPT = auto()
    """Ctrl+C, where it is no signal yet."""
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
    """Tab, where it is a key and not a part of a pasted text."""


class Key(Frozen):
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
    """Remembers the bytes of a key that has not come whole."""

    def __init__(self) -> None:
        self._decode = codecs.getincrementaldecoder("utf-8")("replace").decode
        self._pending = ""

    @property
    def is_waiting(self) -> bool:
        """Whether an ESC has come that may be the beginning of more."""
        return bool(self._pending)

    def feed(self, data: bytes) -> list[Key]:
        """The keys that are complete now."""
        text = self._pending + self._decode(data)
        self._pending = ""
        keys: list[Key] = []
        at = 0
        while at < len(text):
            if text[at] == "\x1b" and _is_unfinished(text, at):
                self._pending = text[at:]
                break
            at = _next_key(text, at, keys)
        return keys

    def give_up_waiting(self) -> list[Key]:
        """Nothing more came: the ESC was a key of its own."""
        pending, self._pending = self._pending, ""
        if not pending:
            return []
        return [Key(Act.ESCAPE), *([Key(Act.TEXT, pending[1:])] if pending[1:] else [])]


def _is_unfinished(text: str, at: int) -> bool:
    """Whether the sequence that begins there may go on."""
    return len(text) - at < _LONGEST_SEQUENCE and bool(re.compile(_UNFINISHED).match(text, at))


def _next_key(text: str, at: int, keys: list[Key]) -> int:
    """Append the key at ``at``, if it means anything; the answer is where the next one begins."""
    typed = _TEXT.match(text, at)
    if typed:
        keys.append(Key(Act.TEXT, typed[0]))
        return typed.end()
    if text[at] == "\x1b":
        return _escape(text, at, keys)
    if text[at] == "\t":  # in the middle of what came at once it is a part of a pasted text
        keys.append(Key(Act.TEXT, " ") if at + 1 < len(text) else Key(Act.COMPLETE))
    elif text[at] in _CONTROLS:
        keys.append(Key(_CONTROLS[text[at]]))
    return at + 1


def _escape(text: str, at: int, keys: list[Key]) -> int:
    sequence = re.compile(_SEQUENCE).match(text, at)
    if not sequence:
        keys.append(Key(Act.ESCAPE))
        return at + 1
    parameters, final, letter = sequence.groups()
    act = _act(parameters or "", final or "", letter or "")
    if act:
        keys.append(Key(act))
    return sequence.end()


def _act(parameters: str, final: str, letter: str) -> Act | None:
    if letter:
        return Act.ENTER if letter == "M" else _LETTERS.get(letter)
    if parameters.strip("0123456789;"):
        return None
    return _NUMBERS.get(parameters.split(";")[0]) if final == "~" else _LETTERS.get(final)
