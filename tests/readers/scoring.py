"""Compares what a reader said after each command with the printed answer.

once      share of printed lines that were said exactly as often as they were printed
in order  share of printed words that were said in their order
clean     commands whose answer was said once, in order, and nothing else
noise     share of said words that belong to no answer
"""

from __future__ import annotations

import difflib
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

_WORD = re.compile(r"[^\W_]+")

Words = tuple[str, ...]


def words_of(text: str) -> Words:
    return tuple(_WORD.findall(text.lower()))


@dataclass(frozen=True, slots=True)
class Phase:
    """A command, the printed lines of its answer, and the words said until the next command."""

    command: str
    printed: tuple[str, ...]
    heard: tuple[str, ...]
    prompt: str = "> "
    """Of the next command; in a block it begins with the level."""

    @property
    def printed_words(self) -> Words:
        return tuple(word for line in self.printed for word in words_of(line))

    @property
    def spoken_words(self) -> Words:
        """Without the prompt, which is no answer."""
        words = tuple(word for text in self.heard for word in words_of(text))
        prompt = words_of(self.prompt)
        return words[: -len(prompt)] if prompt and words[-len(prompt) :] == prompt else words

    @property
    def is_clean(self) -> bool:
        return self.spoken_words == self.printed_words

    def lines_once(self) -> int:
        """How many of the printed lines were said as often as they were printed."""
        wanted = Counter(filter(None, map(words_of, self.printed)))
        heard = _lines_in(self.spoken_words, wanted)
        return sum(count for line, count in wanted.items() if heard[line] == count)

    def words_in_order(self) -> int:
        matcher = difflib.SequenceMatcher(None, self.printed_words, self.spoken_words, autojunk=False)
        return sum(block.size for block in matcher.get_matching_blocks())


def _lines_in(heard: Words, lines: Iterable[Words]) -> Counter[Words]:
    """How often each line was said. A long line does not count as the short one that it begins with."""
    longest_first = sorted(lines, key=len, reverse=True)
    found: Counter[Words] = Counter()
    at = 0
    while at < len(heard):
        line = next((each for each in longest_first if heard[at : at + len(each)] == each), None)
        if line is not None:
            found[line] += 1
        at += len(line) if line else 1
    return found


@dataclass(frozen=True, slots=True)
class Score:
    """Shares from 0 to 1; ``clean`` of ``phases``."""

    once: float
    in_order: float
    clean: int
    phases: int
    noise: float

    def __str__(self) -> str:
        return (
            f"once {self.once:.1%}  in order {self.in_order:.1%}  clean {self.clean}/{self.phases}"
            f"  noise {self.noise:.1%}"
        )


def score(phases: Sequence[Phase]) -> Score:
    printed = sum(len(phase.printed_words) for phase in phases)
    heard = sum(len(phase.spoken_words) for phase in phases)
    in_order = sum(phase.words_in_order() for phase in phases)
    lines = sum(1 for phase in phases for line in phase.printed if words_of(line))
    return Score(
        once=sum(phase.lines_once() for phase in phases) / max(lines, 1),
        in_order=in_order / max(printed, 1),
        clean=sum(phase.is_clean for phase in phases),
        phases=len(phases),
        noise=(heard - in_order) / max(heard, 1),
    )


CELLS = 40
"""Of a braille display."""


def shown(phase: Phase) -> bool:
    """Whether what a braille display shows in the end is of the last line of the answer: what is before
    the cursor, one blank behind it. A line that leaves no room for the cursor is shown from its 41st cell.
    """
    line = phase.printed[-1]
    begin = (len(line) + 1) // CELLS * CELLS
    return phase.heard[-1:] == (line[begin:].strip(),)


def is_whole(phase: Phase) -> bool:
    """Whether it is the whole line."""
    return phase.heard[-1:] == phase.printed[-1:]
