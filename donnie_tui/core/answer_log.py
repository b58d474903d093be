"""The latest answers, so that a learner can repeat, spell, search and save them.

An answer is all that was printed between two prompts. The number of answers is bounded; of a very long answer
the last lines are kept. ``TranscriptLog`` writes every printed line into a file.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, TextIO
from unicodedata import normalize

from donnie_tui.core.events import LineFile, Stamped
from donnie_tui.core.transcript import printed_lines
from donnie_tui.core.wording import Wording
from language.source import fold_name, quoted

if TYPE_CHECKING:
    from pathlib import Path

KEPT = 1000
"""Answers that are remembered."""
LONGEST_ANSWER = 200
"""Lines of one answer that are remembered, its last ones."""
MOST_FOUND = 20
"""Lines that FIND prints, the newest ones."""
LONGEST_SPELLED = 200
"""Characters that are spelled, at most."""
LONGEST_LINE = 38
"""Characters of a line of spelling."""


class AnswerLog:
    """The answers so far, oldest first."""

    def __init__(self) -> None:
        self._answers: deque[deque[str]] = deque(maxlen=KEPT)
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


def spelled(text: str, wording: Wording) -> tuple[str, ...]:
    """Spells a text in lines of bounded length, with names for signs and blanks.

    Of a long text only the beginning is spelled; for an empty one, a sentence says that nothing was said.
    """
    if not text:
        return (wording("answer-nothing-said"),)
    names = [_name(each, wording) for each in normalize("NFC", text[:LONGEST_SPELLED])]
    lines = [""]
    for name in names:
        longer = f"{lines[-1]}, {name}" if lines[-1] else name
        if lines[-1] and len(longer) > LONGEST_LINE:
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


class TranscriptLog:
    """Writes every printed line of the stream to a file.

    A full disk ends the log and nothing else; ``on_failure`` is called once.
    """

    def __init__(
        self, out: TextIO, wording: Wording, on_failure: Callable[[OSError], None] | None = None
    ) -> None:
        self._file = LineFile(out, on_failure)
        self._wording = wording

    def __call__(self, stamped: Stamped) -> None:
        lines = printed_lines(stamped, self._wording)
        if lines and self._file.takes_more:
            self._file.write("".join(f"{line}\n" for line in lines))


def next_log(folder: Path) -> Path:
    """The first free name after all used ones: ``log_001.txt``, ``log_002.txt``."""
    numbers = [re.fullmatch(r"log_(\d{1,9})\.txt", each.name) for each in folder.iterdir()]
    highest = max((int(each[1]) for each in numbers if each), default=0)
    return folder / f"log_{highest + 1:03}.txt"


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
}
"""The codes of the names of signs: a screen reader may leave a lone sign out, so sentences name it."""

_SPELLING_OF_SIGN = {
    sign: code.replace("sign-", "spell-") for sign, code in CODE_OF_SIGN.items() if len(sign) == 1
}
"""The codes of their names where letters are spelled."""
