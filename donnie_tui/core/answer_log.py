"""What was told, answer by answer, to be said again, spelled, searched and saved. Bounded.

An answer is what was told between two prompts; of a very long one the last lines are kept.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from unicodedata import normalize

from donnie_tui.core.wording import Wording
from language.source import fold_name

KEPT = 1000
"""Answers that are remembered."""
LONGEST_ANSWER = 200
"""Lines of one answer that are remembered, its last ones."""
MOST_FOUND = 20
"""Lines that FIND tells, the newest ones."""
LONGEST_SPELLED = 200
"""Characters that are spelled."""
LONGEST_LINE = 38
"""Characters of a line of spelling."""


class AnswerLog:
    """The answers so far, oldest first."""

    def __init__(self) -> None:
        self._answers: deque[deque[str]] = deque(maxlen=KEPT)
        self._goes_on = False
        self._said_again: deque[str] = deque()
        """What is told again, and not remembered when it comes."""

    def add(self, lines: Sequence[str]) -> None:
        if lines:
            self._answers.append(deque(lines, maxlen=LONGEST_ANSWER))

    def add_line(self, line: str) -> None:
        """Where answers come line by line: one more of the answer that is being told."""
        if self._said_again and line == self._said_again[0]:
            self._said_again.popleft()
            return
        if self._goes_on:
            self._answers[-1].append(line)
        else:
            self.add((line,))
        self._goes_on = True

    def end_answer(self) -> None:
        """What comes line by line from now on is another answer."""
        self._goes_on = False
        self._said_again.clear()

    @property
    def has_begun(self) -> bool:
        """Whether anything was told since the last answer ended."""
        return self._goes_on

    def again(self, which: int = 1) -> tuple[str, ...]:
        """As ``last``, to be told line by line without being remembered twice."""
        lines = self.last(which)
        self._said_again = deque(lines)
        return lines

    def last(self, which: int = 1) -> tuple[str, ...]:
        """The ``which``-th last answer, empty if there is none."""
        return tuple(self._answers[-which]) if 1 <= which <= len(self._answers) else ()

    def last_line(self, which: int = 1) -> str:
        """Of that answer its last line, where what counts mostly stands alone; empty if there is none."""
        return next(iter(self.last(which)[-1:]), "")

    def last_word(self) -> str:
        """Without the signs behind it; empty if nothing was said."""
        return next(iter(self.last_line().rstrip(".,:;!?").split()[-1:]), "")

    def found(self, typed: str) -> tuple[str, ...]:
        """The newest lines that have the word, in any case and without accents, oldest first."""
        wanted = fold_name(typed)
        hits = [line for answer in self._answers for line in answer if wanted in fold_name(line)]
        return tuple(hits[-MOST_FOUND:])

    def text(self) -> str:
        """All of it, a line each."""
        return "".join(f"{line}\n" for answer in self._answers for line in answer)

    def __len__(self) -> int:
        return len(self._answers)


def none_so_far(log: AnswerLog, wording: Wording) -> str:
    """That there is no such answer: none at all, or fewer."""
    return wording("answers-so-far", count=len(log)) if len(log) else wording("answer-nothing-said")


LONGEST_TOLD = 40
"""Characters of a word that is told not to have been said."""


def found_in_words(log: AnswerLog, typed: str, wording: Wording) -> tuple[str, ...]:
    """How many lines have the word, and those; or that none has."""
    found = log.found(typed)
    if not found:
        return (wording("find-none", word=typed[:LONGEST_TOLD]),)
    return (wording("find-count", count=len(found)), *found)


def spelled(text: str, sign_names: dict[str, str], wording: Wording) -> tuple[str, ...]:
    """Character by character, signs and blanks by name, as many lines as that takes.

    Of a long text its beginning; of an empty one, that nothing was said. ``sign_names`` has the code of the
    name of each sign.
    """
    if not text:
        return (wording("answer-nothing-said"),)
    names = [_name(each, sign_names, wording) for each in normalize("NFC", text[:LONGEST_SPELLED])]
    lines = [""]
    for name in names:
        longer = f"{lines[-1]}, {name}" if lines[-1] else name
        if lines[-1] and len(longer) > LONGEST_LINE:
            lines.append(name)
        else:
            lines[-1] = longer
    return tuple(f"{line}." for line in lines if line)


def _name(character: str, sign_names: dict[str, str], wording: Wording) -> str:
    if character == " ":
        return wording("spell-blank")
    if character in sign_names:
        return wording(sign_names[character])
    return wording("spell-capital", letter=character) if character.isupper() else character
