"""The program that is typed in a terminal, line by line.

Rules: lines keep their numbers from the first to the last, so that errors and listings agree. What is
typed waits until it is run; what was run stays, so that the whole can be saved or run again. After a
mistake of form nothing has run: one line is forgotten (the learner types it again), several lines are kept
(the learner mends the one that was wrong). No change is for good: another program that takes its place is one
that can be taken back like any other.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence

from devices.ports.values import Frozen
from donnie_tui.core.breakpoints import followed, shifted
from donnie_tui.core.harmless import cleaned
from language.outline import OutlineItem, block_depth, open_block
from language.source import lines_in

WORTH_SAVING = 5
"""Unsaved lines from which on a learner is asked first; fewer are kept without a question."""
ANOTHER_PROGRAM = 0
"""In the place of a line: what was done or taken back changed no line, but the program."""

LARGEST = 8 * 1024 * 1024
"""Characters that may be typed into one program."""


MOST_UNDONE = 50
"""Changes that can be taken back, and made again."""
MOST_LINES_KEPT = 1_000_000
"""Lines that are kept for that in all."""


class ProgramTooLong(Exception):
    """What is typed would exceed ``LARGEST``."""


class _File(Frozen):
    """Which program it is."""

    name: str | None
    kept: list[str]
    breakpoints: frozenset[int]


class _Before(Frozen):
    """The program before a change."""

    lines: list[str]
    run: int
    """How many of them had run."""
    runs: int
    """How often anything had been run then."""
    file: _File | None = None
    """Where the change was that another program took its place."""


class Batch(Frozen):
    """What is to be run now: its text and the number of its first line."""

    text: str
    first_line: int
    lines: int


class TypedProgram:
    """The lines so far, and how many of them have run."""

    def __init__(self) -> None:
        self.name: str | None = None
        """The file that it was opened from or saved to."""
        self.breakpoints: frozenset[int] = frozenset()
        """Lines, from 1; they go with the text."""
        self._lines: list[str] = []
        self._kept: list[str] = []
        self._run = 0
        self.was_brought = False
        """Whether what waits came from a file, or from before, and was never asked to run here."""
        self._size = 0
        self._runs = 0
        """How often what has run became another part, but by changes."""
        self._before: deque[_Before | int] = deque(maxlen=MOST_UNDONE)
        """What was before each of the last changes; how many lines, where one was added behind them."""
        self.refused: str | None = None
        """The line that was forgotten after a mistake, until another one is there."""
        self._undone: list[_Before] = []
        """What was there before each change that was taken back, since the last change."""

    @property
    def saved(self) -> bool:
        """Whether the lines are the same as in the file, or as in a new program."""
        return self._lines == self._kept

    def was_saved(self) -> None:
        """The file has these lines now."""
        self._kept = self._lines.copy()

    @property
    def saved_text(self) -> str:
        """What the file has, as far as it is known."""
        return "".join(f"{line}\n" for line in self._kept)

    @property
    def is_worth_saving(self) -> bool:
        """Whether enough would be lost that the learner must be asked first."""
        return not self.saved and (self.name is not None or len(self._lines) >= WORTH_SAVING)

    @property
    def lines(self) -> tuple[str, ...]:
        return tuple(self._lines)

    @property
    def text(self) -> str:
        return "".join(f"{line}\n" for line in self._lines)

    @property
    def is_waiting(self) -> bool:
        """Whether there is something that has not run yet."""
        return any(line.strip() for line in self._lines[self._run :])

    @property
    def depth(self) -> int:
        """How many blocks are open at the end of what waits."""
        return block_depth("\n".join(self._lines[self._run :]))

    @property
    def open_block(self) -> OutlineItem | None:
        """The innermost block that is open at the end of what waits."""
        return open_block("\n".join(self._lines[self._run :]), first_line=self._run + 1)

    @property
    def waiting(self) -> int:
        """How many lines have not run yet."""
        return len(self._lines) - self._run

    def add(self, line: str) -> None:
        """One line more at the end. Raises ``ProgramTooLong``."""
        self.refused = None
        line = self._grown_by(line)
        self._undone.clear()
        self._before.append(len(self._lines))
        self._lines.append(line)

    def take_batch(self, last: str | None = None) -> Batch:
        """Everything that waits, and ``last`` behind it, which is no part of the program."""
        waiting = self._lines[self._run :] + ([] if last is None else [last])
        return Batch("\n".join(waiting), self._run + 1, len(waiting))

    def batch_ran(self) -> None:
        self._run = len(self._lines)
        self.was_brought = False
        self._runs += 1

    def batch_was_refused(self) -> bool:
        """After a mistake of form. True if the lines were kept for mending, False if there was but one."""
        if sum(bool(line.strip()) for line in self._lines[self._run :]) > 1:
            return True
        self.refused = next((line for line in self._lines[self._run :] if line.strip()), None)
        del self._lines[self._run :]
        while self._before and isinstance(self._before[-1], int) and self._before[-1] >= self._run:
            self._before.pop()
        return False

    def replace(self, text: str, name: str | None, *, in_file: str | None = None) -> None:
        """Another program takes its place, and waits. ``in_file``: what its file has, where that differs."""
        self.refused = None
        self._undone.clear()
        if self._lines:
            self._before.append(self._now_as(self._file))
        self._lines = lines_in(text)
        self._run = 0
        self.was_brought = bool(self._lines)
        self._size = len(text)
        self._forget_oldest()
        self.breakpoints = frozenset()
        self.name = name
        self._kept = lines_in(text if in_file is None else in_file)

    def clear(self) -> None:
        self.replace("", None)

    def change(self, number: int, line: str) -> None:
        """Line ``number`` (from 1) is ``line`` from now on. Raises ``IndexError``, ``ProgramTooLong``."""
        self._check(number)
        line = self._grown_by(line)
        self._keep()
        self._lines[number - 1] = line
        self._touched(number)

    def insert(self, number: int, line: str) -> None:
        """``line`` becomes line ``number``; the ones from there on move down. Raises ``IndexError``."""
        if not 1 <= number <= len(self._lines) + 1:
            raise IndexError(number)
        line = self._grown_by(line)
        self._keep()
        self._lines.insert(number - 1, line)
        self.breakpoints = shifted(self.breakpoints, number - 1, number - 1, 1)
        self._touched(number)

    def forget_waiting(self) -> int:
        """Drop what has not run, and say how many lines that were."""
        waiting = self.waiting
        if waiting:
            self._keep()
        del self._lines[self._run :]
        self.was_brought = False
        return waiting

    def delete(self, first: int, last: int) -> None:
        """Lines ``first`` to ``last`` are gone. Raises ``IndexError`` unless both are there."""
        self._check(first)
        self._check(last)
        self._keep()
        del self._lines[first - 1 : last]
        self.breakpoints = shifted(self.breakpoints, first - 1, last, first - 1 - last)
        self._touched(first)

    def move(self, first: int, last: int, to: int) -> int:
        """Lines ``first`` to ``last`` stand before line ``to`` from now on. Returns where the first stands.

        Raises ``IndexError`` unless all are there; ``to`` may be the line behind the last one.
        """
        self._check(first)
        self._check(last)
        if not 1 <= to <= len(self._lines) + 1 or first <= to <= last + 1:
            raise IndexError(to)
        self._keep()
        moved = self._lines[first - 1 : last]
        del self._lines[first - 1 : last]
        at = to - 1 if to < first else to - 1 - len(moved)
        self._lines[at:at] = moved
        self._touched(min(first, to))
        return at + 1

    def rewrite(self, text: str) -> None:
        """The whole program is ``text`` from now on, as one change. Raises ``ProgramTooLong``."""
        text = self._grown_by(text)
        self._keep()
        before, self._lines = self._lines, lines_in(text)
        self.breakpoints = followed(self.breakpoints, before, self._lines)
        self._touched(first_difference(before, self._lines) + 1)

    def undo(self) -> int | None:
        """Take the last change back. The first line that is another one now, or None without a change.

        ``ANOTHER_PROGRAM`` where the change was that another program took its place. Lines that had run
        before the change have run again, unless something ran in between.
        """
        if not self._before:
            return None
        before = self._before.pop()
        self._undone.append(self._now_for(before))
        if isinstance(before, int):  # a line typed last is gone, whether it has run or not
            before = _Before(self._lines[:before], min(self._run, before), self._runs)
        return self._become(before)

    def redo(self) -> int | None:
        """Make the change again that was taken back last; as ``undo``."""
        if not self._undone:
            return None
        after = self._undone.pop()
        self._before.append(self._now_for(after))
        return self._become(after)

    @property
    def replaced(self) -> tuple[tuple[str, str | None], ...]:
        """The text and the file of the programs that UNDO or REDO would bring back and no file has so."""
        others = (each for each in (*self._before, *self._undone) if isinstance(each, _Before))
        return tuple(
            ("".join(f"{line}\n" for line in each.lines), each.file.name)
            for each in others
            if each.file is not None and each.lines != each.file.kept
        )

    @property
    def _now(self) -> _Before:
        return self._now_as(None)

    def _now_as(self, file: _File | None) -> _Before:
        return _Before(self._lines.copy(), self._run, self._runs, file)

    def _now_for(self, other: _Before | int) -> _Before:
        """To come back from that one."""
        is_another = isinstance(other, _Before) and other.file is not None
        return self._now_as(self._file if is_another else None)

    @property
    def _file(self) -> _File:
        return _File(self.name, self._kept, self.breakpoints)

    def _become(self, other: _Before) -> int:
        """Those lines from now on. The first one that is another one."""
        same = first_difference(other.lines, self._lines)
        self.breakpoints = followed(self.breakpoints, self._lines, other.lines)
        changes_what_ran = same < self._run
        self._lines, self._run = other.lines, 0 if changes_what_ran else self._run
        if other.runs == self._runs:
            self._run = other.run
        self._forget_oldest()
        return same + 1 if other.file is None else self._be(other.file)

    def _be(self, file: _File) -> int:
        self.name, self._kept, self.breakpoints = file.name, file.kept, file.breakpoints
        self.was_brought = bool(self._lines)
        self._size = sum(len(line) + 1 for line in self._lines)
        return ANOTHER_PROGRAM

    def _keep(self) -> None:
        """Remember the lines as they are."""
        self._undone.clear()
        self._before.append(self._now)
        self._forget_oldest()

    def _forget_oldest(self) -> None:
        """Of very long programs fewer changes can be taken back."""
        while len(self._before) > 1 and self._lines_kept > MOST_LINES_KEPT:
            self._before.popleft()
        while len(self._undone) > 1 and self._lines_kept > MOST_LINES_KEPT:
            self._undone.pop(0)

    @property
    def _lines_kept(self) -> int:
        kept = (*self._before, *self._undone)
        return sum(len(each.lines) for each in kept if not isinstance(each, int))

    def _grown_by(self, line: str) -> str:
        """The line as it is taken. What was ever typed counts, so that no list of lines need be added up."""
        line = cleaned(line)
        if self._size + len(line) + 1 > LARGEST:
            raise ProgramTooLong
        self._size += len(line) + 1
        return line

    def _check(self, number: int) -> None:
        if not 1 <= number <= len(self._lines):
            raise IndexError(number)

    def _touched(self, number: int) -> None:
        """A program whose part that had run was changed waits as a whole."""
        if number <= self._run:
            self._run = 0


def first_difference(one: Sequence[str], other: Sequence[str]) -> int:
    """Where the first line is that is not the same in both; the length of the shorter without one."""
    pairs = enumerate(zip(one, other, strict=False))
    return next((at for at, (left, right) in pairs if left != right), min(len(one), len(other)))
