"""What was said and what was typed: answers to repeat, spell, search and save; lines to recall.

An answer is all that was printed between two prompts. The number of answers is bounded; of a very long answer
the last lines are kept.

Typed lines are kept over sessions, in a file that is optional. A problem with it is not reported and affects
nothing else.
"""

from __future__ import annotations

import contextlib
import os
from collections import deque
from collections.abc import Sequence
from typing import TYPE_CHECKING
from unicodedata import normalize

from donnie_tui.process.confinement import make_folder, open_bytes, open_descriptor
from language.source import fold_name, quoted

if TYPE_CHECKING:
    from donnie_tui.core.wording import Wording

KEPT_ANSWERS = 1000
"""Answers that are remembered."""
LONGEST_ANSWER = 200
"""Lines of one answer that are remembered, its last ones."""
MOST_FOUND = 20
"""Lines that FIND prints, the newest ones."""
LONGEST_SPELLED = 200
"""Characters that are spelled, at most."""
LONGEST_SPELLING = 38
"""Characters of a line of spelling."""
KEPT_LINES = 1000
"""Typed lines that are remembered."""
LARGEST_FILE = 4 * 1024 * 1024
"""Bytes; a larger file of typed lines was not written by Donnie."""
LONGEST_LINE = 2000
"""Characters of a typed line that is remembered."""


# --- what was said


class AnswerLog:
    """The answers so far, oldest first."""

    def __init__(self) -> None:
        self._answers: deque[deque[str]] = deque(maxlen=KEPT_ANSWERS)
        self._goes_on = False

    def add(self, lines: Sequence[str]) -> None:
        if lines:
            self._answers.append(deque(lines, maxlen=LONGEST_ANSWER))

    def add_lines(self, lines: Sequence[str]) -> None:
        """Adds lines to the current answer; in how many pieces they arrive depends on the machine."""
        for line in lines:
            self.add_line(line)

    def add_line(self, line: str) -> None:
        """Adds one line to the current answer."""
        if self._goes_on:
            self._answers[-1].append(line)
        else:
            self.add((line,))
        self._goes_on = True

    def end_answer(self) -> None:
        """Ends the current answer; the next line begins another one."""
        self._goes_on = False

    @property
    def has_begun(self) -> bool:
        """Whether anything was printed since the last answer ended."""
        return self._goes_on

    def last(self, which: int = 1) -> tuple[str, ...]:
        """The ``which``-th last answer, empty if there is none."""
        return tuple(self._answers[-which]) if 1 <= which <= len(self._answers) else ()

    def last_line(self, which: int = 1) -> str:
        """The last line of that answer, which mostly holds the result; empty if there is none."""
        return next(iter(self.last(which)[-1:]), "")

    def last_word(self) -> str:
        """The last word without the punctuation after it; empty if nothing was said."""
        return next(iter(self.last_line().rstrip(".,:;!?").split()[-1:]), "")

    def found(self, typed: str) -> tuple[str, ...]:
        """The newest lines that have the word, in any case and without accents, oldest first."""
        wanted = fold_name(typed)
        hits = [line for answer in self._answers for line in answer if wanted in fold_name(line)]
        return tuple(hits[-MOST_FOUND:])

    def text(self) -> str:
        """All answers as one text."""
        return "".join(f"{line}\n" for answer in self._answers for line in answer)

    def __len__(self) -> int:
        return len(self._answers)


def none_so_far(log: AnswerLog, wording: Wording) -> str:
    """The sentence that there is no such answer: none at all, or fewer."""
    return wording("answers-so-far", count=len(log)) if len(log) else wording("answer-nothing-said")


def found_in_words(log: AnswerLog, typed: str, wording: Wording) -> tuple[str, ...]:
    """The number of lines that contain the word, and the lines; or the sentence that none does."""
    found = log.found(typed)
    if not found:
        return (wording("find-none", word=quoted(typed)),)
    return (wording("find-count", count=len(found)), *found)


def letter_by_letter(text: str, wording: Wording) -> tuple[str, ...]:
    """Spells a text in lines of bounded length, with names for signs and blanks.

    Of a long text only the beginning is spelled; for an empty one, a sentence says that nothing was said.
    """
    if not text:
        return (wording("answer-nothing-said"),)
    names = [_name(each, wording) for each in normalize("NFC", text[:LONGEST_SPELLED])]
    lines = [""]
    for name in names:
        longer = f"{lines[-1]}, {name}" if lines[-1] else name
        if lines[-1] and len(longer) > LONGEST_SPELLING:
            lines.append(name)
        else:
            lines[-1] = longer
    return tuple(f"{line}." for line in lines if line)


def _name(character: str, wording: Wording) -> str:
    if character == " ":
        return wording("spell-blank")
    if character in _SPELLING_OF_SIGN:
        return wording(_SPELLING_OF_SIGN[character])
    return wording("spell-capital", letter=character) if character.isupper() else character


CODE_OF_SIGN = {
    "=": "sign-equals",
    "==": "sign-double-equals",
    "<>": "sign-different",
    "<": "sign-less",
    ">": "sign-greater",
    "<=": "sign-less-or-equal",
    ">=": "sign-greater-or-equal",
    "+": "sign-plus",
    "-": "sign-minus",
    "*": "sign-star",
    "/": "sign-slash",
    "(": "sign-opening-parenthesis",
    ")": "sign-closing-parenthesis",
    "[": "sign-opening-bracket",
    "]": "sign-closing-bracket",
    ",": "sign-comma",
    ":": "sign-colon",
    ";": "sign-semicolon",
    ".": "sign-full-stop",
    "!": "sign-exclamation",
    "?": "sign-question",
    "#": "sign-hash",
    "$": "sign-dollar",
    "%": "sign-percent",
    "&": "sign-ampersand",
    "@": "sign-at",
    "'": "sign-apostrophe",
    "’": "sign-apostrophe",
    "‘": "sign-apostrophe",
    '"': "sign-quote",
    "“": "sign-quote",
    "”": "sign-quote",
    "\\": "sign-backslash",
    "_": "sign-underscore",
    "^": "sign-caret",
    "`": "sign-grave",
    "{": "sign-opening-brace",
    "}": "sign-closing-brace",
    "|": "sign-bar",
    "~": "sign-tilde",
    "…": "sign-ellipsis",
    "¿": "sign-opening-question",
    "¡": "sign-opening-exclamation",
    "«": "sign-opening-angle-quote",
    "»": "sign-closing-angle-quote",
}
"""The codes of the names of signs: a screen reader may leave a lone sign out, so sentences name it."""

_SPELLING_OF_SIGN = {
    sign: code.replace("sign-", "spell-") for sign, code in CODE_OF_SIGN.items() if len(sign) == 1
}
"""The codes of their names where letters are spelled."""


# --- what was typed


class LineHistory:
    """Typed lines, oldest first."""

    def __init__(self, file: str | None = None) -> None:
        self._file = file
        self.lines: list[str] = _read(file)[-KEPT_LINES:] if file else []

    def remember(self, line: str) -> None:
        """Adds a line, unless it is empty or the same as the last."""
        line = line.strip()
        if not line or len(line) > LONGEST_LINE or self.lines[-1:] == [line]:
            return
        self.lines.append(line)
        del self.lines[:-KEPT_LINES]
        if self._file:
            with contextlib.suppress(OSError, ValueError):
                _add(self._file, [line])

    def trim(self) -> None:
        """Shortens the file to the remembered lines, when it has grown to twice as many."""
        file = self._file
        if file and len(_read(file)) > 2 * KEPT_LINES:
            with contextlib.suppress(OSError):
                from pathlib import Path  # slow to load, needed only when the file is too long

                shorter = Path(f"{file}.new")
                shorter.unlink(missing_ok=True)
                _add(str(shorter), self.lines)
                shorter.replace(file)


class Recall:
    """Recalls line by line, from the line that is being typed."""

    def __init__(self, past: LineHistory, draft: str = "") -> None:
        self._lines = [*past.lines, draft]
        self._at = len(past.lines)

    def older(self, typed: str) -> str | None:
        """The line before, or None at the oldest. ``typed`` is kept for the way back."""
        return self._go(-1, typed)

    def newer(self, typed: str) -> str | None:
        return self._go(1, typed)

    def _go(self, step: int, typed: str) -> str | None:
        if not 0 <= self._at + step < len(self._lines):
            return None
        self._lines[self._at] = typed
        self._at += step
        return self._lines[self._at]


def _read(file: str) -> list[str]:
    """The lines of the file, none if it can't be read or holds something else."""
    try:
        with open_bytes(file) as kept:
            data = kept.read(LARGEST_FILE + 1)
        text = data.decode() if len(data) <= LARGEST_FILE else ""
    except (OSError, ValueError):
        return []
    lines = (line.strip() for line in text.split("\n"))
    return [line for line in lines if line and line.isprintable() and len(line) <= LONGEST_LINE]


def _add(file: str, lines: list[str]) -> None:
    """Appends lines to a file that only the learner's account may read, as programs may be private."""
    make_folder(os.path.split(file)[0])
    handle = open_descriptor(file, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o600)
    with os.fdopen(handle, "w", encoding="utf-8") as out:
        out.writelines(f"{line}\n" for line in lines)
