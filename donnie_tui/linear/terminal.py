"""The terminal's attributes: taken for typing key by key, and always given back. Imports almost nothing.

Rule: what was typed before is kept; it waits in the terminal and is read as soon as somebody reads.
"""

from __future__ import annotations

import os
import termios

_LFLAG, _IFLAG, _CC = 3, 0, 6


def is_editable(environment: os._Environ[str] | dict[str, str]) -> bool:
    """Whether lines can be edited here: a terminal at both ends that knows more than printing."""
    return os.isatty(0) and os.isatty(1) and environment.get("TERM") not in (None, "", "dumb")


class Terminal:
    """Standard input as a terminal. ``take`` and ``give_back`` may be called any number of times."""

    def __init__(self) -> None:
        self._found = termios.tcgetattr(0)

    def take(self, *, signals: bool = True) -> None:
        """Key by key, without an echo of its own. Without ``signals`` Ctrl+C is a key like any other."""
        wanted = termios.tcgetattr(0)
        wanted[_LFLAG] &= ~(termios.ECHO | termios.ICANON | termios.IEXTEN)
        wanted[_LFLAG] = wanted[_LFLAG] | termios.ISIG if signals else wanted[_LFLAG] & ~termios.ISIG
        wanted[_IFLAG] &= ~termios.IXON  # a stray Ctrl+S would silence everything
        wanted[_IFLAG] |= termios.ICRNL
        wanted[_CC][termios.VMIN], wanted[_CC][termios.VTIME] = 1, 0
        _apply(wanted)

    def give_back(self) -> None:
        """As it was found; quietly, since the terminal may be gone."""
        try:
            _apply(self._found)
        except (termios.error, OSError):
            return


def size() -> tuple[int, int]:
    """Columns and rows, 80 by 24 where nobody knows."""
    try:
        columns, rows = os.get_terminal_size(1)
    except OSError:
        return 80, 24
    return columns or 80, rows or 24


def _apply(attributes: list[int | list[bytes | int]]) -> None:
    termios.tcsetattr(0, termios.TCSANOW, attributes)
