"""Lines on their way into a file that may take no more: a full disk, a pipe that nobody reads.

Rule: that is told once, and ends the writing and nothing else.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TextIO


class LineFile:
    """Each writing is a whole number of lines, and is there at once. The owner of ``out`` closes it."""

    def __init__(self, out: TextIO, on_failure: Callable[[OSError], None] | None = None) -> None:
        self._out = out
        self._on_failure = on_failure
        self._has_failed = False

    @property
    def takes_more(self) -> bool:
        return not (self._has_failed or self._out.closed)

    def write(self, lines: str) -> None:
        """Only while it takes more."""
        try:
            self._out.write(lines)
            self._out.flush()
        except OSError as problem:
            self._has_failed = True
            if self._on_failure:
                self._on_failure(problem)
