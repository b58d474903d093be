"""The lines that the learner typed in this session and in earlier ones, and the keys that recall them.

The file that keeps them is optional. A problem with it is not reported and affects nothing else.
"""

from __future__ import annotations

import contextlib
import os

from donnie_tui.process.confinement import make_folder, open_bytes, open_descriptor

KEPT = 1000
"""Lines that are remembered."""
LARGEST_FILE = 4 * 1024 * 1024
"""Bytes; a larger file was not written by Donnie."""
LONGEST_LINE = 2000


class LineHistory:
    """Typed lines, oldest first."""

    def __init__(self, file: str | None = None) -> None:
        self._file = file
        self.lines: list[str] = _read(file)[-KEPT:] if file else []

    def remember(self, line: str) -> None:
        """Adds a line, unless it is empty or the same as the last."""
        line = line.strip()
        if not line or len(line) > LONGEST_LINE or self.lines[-1:] == [line]:
            return
        self.lines.append(line)
        del self.lines[:-KEPT]
        if self._file:
            with contextlib.suppress(OSError, ValueError):
                _add(self._file, [line])

    def trim(self) -> None:
        """Shortens the file to the remembered lines, when it has grown to twice as many."""
        file = self._file
        if file and len(_read(file)) > 2 * KEPT:
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
