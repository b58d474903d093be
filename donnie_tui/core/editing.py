"""How a document is edited: the editor that shows it, its versions for UNDO, and where its lines move."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Protocol

import msgspec

if TYPE_CHECKING:
    from pathlib import Path

MOST_UNDONE = 50
"""Changes that can be undone, and redone."""
MOST_LINES_KEPT = 1_000_000
"""Lines that are kept for that in all."""


class TextEditor(Protocol):
    """A widget in which the learner edits a document key by key."""

    breakpoints: frozenset[int]

    @property
    def text(self) -> str: ...

    @property
    def line(self) -> int:
        """The line of the cursor, from 1."""
        ...

    def show(self, text: str, breakpoints: frozenset[int]) -> None:
        """Show another program; the history begins again."""

    def change_lines(self, lines: Sequence[str]) -> None:
        """Change the text into these lines, as one edit."""

    @property
    def cursor_location(self) -> tuple[int, int]:
        """The row and the column of the cursor, from 0."""
        ...

    def go_to(self, line: int) -> None: ...

    def select(self, row: int, start: int, end: int) -> None:
        """Select the columns of a row, with the cursor at their end."""

    def replace_range(self, start: int, end: int, text: str) -> None:
        """Replace the characters between two offsets; the cursor stays at its letter."""

    def undo(self) -> None: ...

    def redo(self) -> None: ...


# --- versions


class Origin(msgspec.Struct, frozen=True):
    """Which program a document held."""

    path: Path | None
    saved_lines: list[str]
    breakpoints: frozenset[int]


class Version(msgspec.Struct, frozen=True):
    """A document before a change."""

    lines: list[str]
    ran: int
    """How many of the lines had run."""
    runs: int
    """How many runs there had been."""
    origin: Origin | None = None
    """Where the change replaced the whole program."""


class UnsavedText(msgspec.Struct, frozen=True):
    """A program that another one took the place of, or that a copy keeps."""

    text: str
    path: Path | None = None
    """The file of the program, where it has one."""


class UndoHistory:
    """The versions of a document before its last changes, and before each UNDO since the last change."""

    def __init__(self) -> None:
        self._past: deque[Version | int] = deque(maxlen=MOST_UNDONE)
        """Only the number of lines, where a line was added at the end."""
        self._future: list[Version] = []

    def add(self, before: Version) -> None:
        """Remembers the version before a change; REDO has nothing left then."""
        self._future.clear()
        self._past.append(before)
        self._drop_oldest()

    def add_line(self, count: int) -> None:
        """As ``add``, for a line that was added after ``count`` lines."""
        self._future.clear()
        self._past.append(count)

    def forget_lines(self, first: int) -> None:
        """Forgets the last added lines, from index ``first`` on, which were dropped."""
        while self._past and isinstance(self._past[-1], int) and self._past[-1] >= first:
            self._past.pop()

    def forget_undone(self) -> None:
        """Leave nothing to redo."""
        self._future.clear()

    def undo(self, version: Callable[[bool], Version]) -> Version | int | None:
        """The version before the last change, or the number of its lines; None without a change.

        ``version`` returns the document as it is, its argument is whether the version is of another program.
        """
        if not self._past:
            return None
        before = self._past.pop()
        self._future.append(version(_is_another(before)))
        self._drop_oldest()
        return before

    def redo(self, version: Callable[[bool], Version]) -> Version | None:
        """The version before the last UNDO; None without one."""
        if not self._future:
            return None
        after = self._future.pop()
        self._past.append(version(_is_another(after)))
        self._drop_oldest()
        return after

    @property
    def replaced(self) -> tuple[UnsavedText, ...]:
        """The unsaved programs that UNDO or REDO would restore, the oldest first."""
        return tuple(
            UnsavedText(joined(each.lines), each.origin.path)
            for each in self._versions
            if each.origin is not None and each.lines != each.origin.saved_lines
        )

    @property
    def _versions(self) -> tuple[Version, ...]:
        return tuple(each for each in (*self._past, *self._future) if isinstance(each, Version))

    def _drop_oldest(self) -> None:
        """Drops the oldest versions; of a very long program fewer changes can be undone."""
        while len(self._past) > 1 and self._lines_kept > MOST_LINES_KEPT:
            self._past.popleft()
        while len(self._future) > 1 and self._lines_kept > MOST_LINES_KEPT:
            self._future.pop(0)

    @property
    def _lines_kept(self) -> int:
        return sum(len(each.lines) for each in self._versions)


def _is_another(version: Version | int) -> bool:
    return isinstance(version, Version) and version.origin is not None


def joined(lines: Sequence[str]) -> str:
    """The lines as a text in which each has its end."""
    return "".join(f"{line}\n" for line in lines)


# --- where lines move


def common_lines(before: Sequence[str], after: Sequence[str]) -> tuple[int, int]:
    """How many lines are the same at the beginning of both, and how many of the rest at their ends."""
    shorter = min(len(before), len(after))
    top = next((at for at in range(shorter) if before[at] != after[at]), shorter)
    rest = shorter - top
    return top, next((at for at in range(rest) if before[-1 - at] != after[-1 - at]), rest)


def shifted(lines: Iterable[int], first: int, last: int, added: int) -> frozenset[int]:
    """Moves the lines after ``last`` by ``added``, and drops the ones after ``first`` up to ``last``."""
    kept = (each for each in lines if not first < each <= last)
    return frozenset(each + added if each > last else each for each in kept)


def followed(lines: Iterable[int], before: Sequence[str], after: Sequence[str]) -> frozenset[int]:
    """The new numbers of lines after the program ``before`` became ``after``, found by a diff."""
    added = len(after) - len(before)
    top, same = common_lines(before, after)
    return shifted(lines, top, len(before) - same, added) if added else frozenset(lines)
