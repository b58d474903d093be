"""When what was typed is written down for the case that the power fails or Donnie is killed.

Rule: while somebody thinks, it is written. In a burst, where each line would have the whole program written
anew, it is put off: until nothing more is typed, though a line may be half done by then or a program run,
and for no longer than ``SOON``.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

SOON = 1.0
"""Seconds between two copies in a burst."""


class Quiet(Protocol):
    """What the console knows of the typing."""

    when_idle: Callable[[], None] | None

    def now(self) -> float: ...

    def has_input(self) -> bool: ...


class Safekeeping:
    """Looks at each prompt."""

    def __init__(self, console: Quiet, unsaved: Callable[[], object], write: Callable[[], None]) -> None:
        """``unsaved`` tells what is not saved, ``write`` writes it down, or removes what was."""
        self._console = console
        self._unsaved, self._write = unsaved, write
        self._copied: object = ()
        self._due = console.now()

    def look(self) -> None:
        """A prompt is shown."""
        if self._console.has_input() and self._console.now() < self._due:
            self._console.when_idle = self._keep
        else:
            self._keep()

    def end(self) -> None:
        """What was put off is wanted no more."""
        self._console.when_idle = None

    def _keep(self) -> None:
        self.end()
        unsaved = self._unsaved()
        if unsaved != self._copied:
            self._copied, self._due = unsaved, self._console.now() + SOON
            self._write()
