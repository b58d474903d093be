"""The lines that wait to be printed, between the threads that tell and the one that prints.

Rules: nothing but printable text gets through; nothing is lost; telling never waits, so that it holds
nobody else; and no program eats the memory: the robot whose program tells faster than anybody reads is held
back behind its own lines (``wait_for_room``), until it is stopped. What is answered to a word that was typed
meanwhile is printed first.
"""

from __future__ import annotations

import threading
from collections import Counter, deque
from collections.abc import Callable, Iterable

from donnie_tui.core.answer_log import LONGEST_ANSWER
from donnie_tui.core.harmless import printable

CAPACITY = 500
"""Lines that may wait before a program is held back."""


class Told:
    """Lines in the order in which they were told."""

    def __init__(self, nudge: Callable[[], None], capacity: int = CAPACITY) -> None:
        """``nudge`` is called when the first line comes after there was none."""
        self._nudge = nudge
        self._capacity = capacity
        self._lines: list[tuple[str, str | None]] = []
        """Each with the robot that told it."""
        self._waiting = Counter[str | None]()
        """How many lines of each robot wait."""
        self._first: list[str] = []
        """What is printed before them."""
        self._kept: deque[str] = deque(maxlen=LONGEST_ANSWER)
        self._changed = threading.Condition()
        self.holds_back = False
        """Whether a program that tells too much waits."""
        self.count = 0
        """Lines that were ever told."""

    def put(self, lines: Iterable[str], kept: Iterable[str] | None = None, robot: str | None = None) -> None:
        """Tell some lines, from any thread. What would print as an empty line is left out.

        ``kept`` is what is remembered of it, where that is not what is printed; ``robot`` is who tells it.
        """
        said = [line for line in map(_shown, lines) if line]
        kept_lines = said if kept is None else [line for line in map(_shown, kept) if line]
        with self._changed:
            was_empty = not self
            self._lines += [(line, robot) for line in said]
            self._waiting[robot] += len(said)
            self._kept += kept_lines
            self.count += len(said) or len(kept_lines)
        if was_empty and said:
            self._nudge()

    def put_first(self, lines: Iterable[str], *, is_kept: bool = True) -> None:
        """Tell some lines before all that waits, in their order; from any thread."""
        said = [line for line in map(_shown, lines) if line]
        with self._changed:
            self._first += said
            self._kept += said if is_kept else []
            self.count += len(said)
        self._nudge()

    def wait_for_room(self, robot: str | None) -> None:
        """In the thread of that robot's program: return once there is room for what it tells next."""
        if self._has_room(robot):
            return
        with self._changed:
            self._changed.wait_for(lambda: self._has_room(robot))

    def take(self, most: int | None = None) -> list[str]:
        """The lines that wait, so many of them at most."""
        with self._changed:
            lines = self._first[:most]
            self._first = self._first[len(lines) :]
            lines += self._forget(len(self._lines) if most is None else most - len(lines))
        return lines

    def _forget(self, count: int) -> list[str]:
        """The oldest lines, which wait no more. Under the lock."""
        gone, self._lines = self._lines[:count], self._lines[count:]
        self._waiting.subtract(robot for _, robot in gone)
        self._changed.notify_all()
        return [line for line, _ in gone]

    def take_kept(self) -> list[str]:
        """What is to be remembered of what was told since the last time, the newest lines of it."""
        with self._changed:
            lines = list(self._kept)
            self._kept.clear()
        return lines

    def trim(self, kept: int) -> int:
        """Leave only the ``kept`` newest lines. How many were left out."""
        with self._changed:
            return len(self._forget(max(0, len(self._lines) - kept)))

    @property
    def has_first(self) -> bool:
        """Whether something waits that is printed before all else."""
        return bool(self._first)

    def __len__(self) -> int:
        return len(self._first) + len(self._lines)

    def hold_back(self) -> None:
        """From now on the program that tells too much waits. Only while another thread prints."""
        self.holds_back = True

    def let_pass(self) -> None:
        """Nobody waits any more: the program was stopped, or is over."""
        with self._changed:
            self.holds_back = False
            self._changed.notify_all()

    def _has_room(self, robot: str | None) -> bool:
        return not self.holds_back or self._waiting[robot] < self._capacity


def _shown(line: str) -> str:
    """Without blanks at its ends."""
    return printable(line).strip()
