"""The lines that wait to be printed, between the threads that tell and the one that prints.

Rules: nothing but printable text gets through; nothing is lost; and no program eats the memory: one that
tells faster than anybody reads is held back, until it is stopped.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Iterable

from donnie_tui.core.answer_log import LONGEST_ANSWER

CAPACITY = 500
"""Lines that may wait before a program is held back."""


class Told:
    """Lines in the order in which they were told."""

    def __init__(self, nudge: Callable[[], None], capacity: int = CAPACITY) -> None:
        """``nudge`` is called when the first line comes after there was none."""
        self._nudge = nudge
        self._capacity = capacity
        self._lines: list[str] = []
        self._kept: deque[str] = deque(maxlen=LONGEST_ANSWER)
        self._changed = threading.Condition()
        self._holds_back = False
        self.count = 0
        """Lines that were ever told."""

    def put(self, lines: Iterable[str], kept: Iterable[str] | None = None) -> None:
        """Tell some lines, from any thread. What would print as an empty line is left out.

        ``kept`` is what is remembered of it, where that is not what is printed.
        """
        said = [line for line in map(printable, lines) if line]
        kept_lines = said if kept is None else [line for line in map(printable, kept) if line]
        with self._changed:
            self._changed.wait_for(self._has_room)
            was_empty = not self._lines
            self._lines += said
            self._kept += kept_lines
            self.count += len(said) or len(kept_lines)
        if was_empty and said:
            self._nudge()

    def put_now(self, line: str) -> None:
        """Tell a line before all that waits, from the thread that prints, which waits for nobody."""
        with self._changed:
            self._lines.insert(0, printable(line))
            self.count += 1

    def take(self, most: int | None = None) -> list[str]:
        """The lines that wait, so many of them at most."""
        with self._changed:
            lines = self._lines[:most]
            self._lines = self._lines[len(lines) :]
            self._changed.notify_all()
        return lines

    def take_kept(self) -> list[str]:
        """What is to be remembered of what was told since the last time, the newest lines of it."""
        with self._changed:
            lines = list(self._kept)
            self._kept.clear()
        return lines

    def trim(self, kept: int) -> int:
        """Leave only the ``kept`` newest lines. How many were left out."""
        with self._changed:
            left_out = max(0, len(self._lines) - kept)
            del self._lines[:left_out]
            self._changed.notify_all()
        return left_out

    def __len__(self) -> int:
        return len(self._lines)

    def hold_back(self) -> None:
        """From now on whoever tells too much waits. Only while another thread prints."""
        self._holds_back = True

    def let_pass(self) -> None:
        """Nobody waits any more: the program was stopped, or is over."""
        with self._changed:
            self._holds_back = False
            self._changed.notify_all()

    def _has_room(self) -> bool:
        return not self._holds_back or len(self._lines) < self._capacity


def printable(line: str) -> str:
    """The line without anything that steers a terminal, and without blanks at its ends."""
    return "".join(character if character.isprintable() else " " for character in line).strip()
