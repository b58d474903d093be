"""Standard input of the commands that ask, line by line.

Rule: whatever is typed is a line; bytes that are no text become signs that no word has. Where there is no
standard input, or it fails, nothing more comes.
"""

from __future__ import annotations

import sys

from donnie_tui.cli.front_ends import is_terminal


class Input:
    """Made before anything is read: how bytes are taken can't be changed later."""

    def __init__(self) -> None:
        self._stream = sys.stdin
        reconfigure = getattr(self._stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors="replace")

    @property
    def is_terminal(self) -> bool:
        return is_terminal(self._stream)

    def line(self, longest: int = -1) -> str | None:
        """The next one without blanks around it, of a long one so many characters; None at the end."""
        try:
            typed = self._stream.readline(longest) if self._stream is not None else ""
        except (OSError, ValueError):  # a lost terminal; closed
            typed = ""
        return typed.strip() if typed else None
