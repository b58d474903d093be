"""What stands on the screen, and how much of an answer may come at once so that Fenrir says all of it.

Fenrir compares the screen before and after with ``difflib``, which looks first for the longest part of both.
That must be what has moved up. Where an answer is said again that stands there it may be the answer, which
is then silent, and the lines above it are said. With fewer lines at once more stays than is new.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence

from donnie_tui.i18n.first_words import PROMPT

FEWEST = 2
"""Lines at once; where not even these would be found the answer is one line over and over."""


class OnScreen:
    """The rows that were printed last."""

    def __init__(self) -> None:
        self._lines: deque[str] = deque()
        self._prompt = PROMPT
        """What stands where the cursor is; what is typed behind it is taken to be the same each time."""

    def add(self, lines: Sequence[str], prompt: str, rows: int) -> None:
        """They were printed, and the prompt, on a screen of so many rows."""
        self._lines += self._new_lines(lines)
        self._prompt = prompt
        while len(self._lines) > rows:
            self._lines.popleft()

    def most_heard(self, block: Sequence[str], rows: int) -> int:
        """How many of these lines may be printed at once; all of them where that makes no difference."""
        if len(set(block).intersection(self._lines)) < FEWEST:
            return len(block)
        sizes = range(len(block), FEWEST - 1, -1)
        return next((size for size in sizes if self._are_heard(block[:size], rows)), len(block))

    def _are_heard(self, block: Sequence[str], rows: int) -> bool:
        from difflib import SequenceMatcher  # slow to load

        before = [*self._lines, self._prompt][-rows:]
        after = [*self._lines, *self._new_lines(block), ""][-rows:]
        silent = [False] * len(after)
        for same in SequenceMatcher(None, before, after, autojunk=False).get_matching_blocks():
            silent[same.b : same.b + same.size] = [True] * same.size
        return [line for line, is_silent in zip(after, silent, strict=True) if line and not is_silent] == [
            *block
        ]

    def _new_lines(self, block: Sequence[str]) -> list[str]:
        """The prompt's line is ended, where there is one."""
        return [self._prompt, *block] if self._prompt and block else [*block]
