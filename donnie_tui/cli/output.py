"""Standard output and standard error of the commands, which have no other owner.

Always UTF-8; a character that has none becomes an escape. A reader that goes away is no mistake: output
ends, and whoever writes is told.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable

from devices.ports.hints import TextIO


class Output:
    """Lines for people and scripts. Any thread may write."""

    def __init__(self, out: TextIO | None = None, err: TextIO | None = None) -> None:
        self.out = _prepared(out or sys.stdout, 1)
        self._err = _prepared(err or sys.stderr, 2)
        self.is_broken = False
        """Nothing can be written any more."""
        self.problem: str | None = None
        """Why, unless the reader just went away."""
        self.on_broken: Callable[[], None] = _nothing

    def line(self, text: str) -> None:
        """One line of what was asked for, without anything that a terminal would obey."""
        self.text(f"{_shown(text)}\n")

    def text(self, text: str) -> None:
        if self.is_broken:
            return
        try:
            self.out.write(text)
            self.out.flush()
        except BrokenPipeError:
            self._give_up(None)
        except (OSError, ValueError) as problem:
            self._give_up(getattr(problem, "strerror", None) or str(problem))

    def complaint(self, sentence: str) -> None:
        """A diagnostic of our own, to standard error."""
        try:
            self._err.write(f"{_shown(sentence)}\n")
            self._err.flush()
        except (OSError, ValueError):
            _throw_away(self._err)

    def _give_up(self, problem: str | None) -> None:
        """Write no more, and let whoever runs something know."""
        self.is_broken, self.problem = True, problem
        _throw_away(self.out)
        self.on_broken()


class Guarded:
    """A stream for listeners that must not fail: what can't be written ends the output instead."""

    def __init__(self, output: Output) -> None:
        self._output = output

    def write(self, text: str) -> int:
        self._output.text(text)
        return len(text)

    def flush(self) -> None:
        """Every write is flushed already."""

    @property
    def closed(self) -> bool:
        return self._output.is_broken


def _shown(text: str) -> str:
    """Names out of files, worlds and boards may hold anything."""
    if text.isprintable():
        return text
    from donnie_tui.core.harmless import printable

    return printable(text)


def _prepared(stream: TextIO | None, number: int) -> TextIO:
    """The stream as UTF-8, or a place for nothing where the process was started without one."""
    if stream is None:
        return open(os.devnull, "w", encoding="utf-8")  # noqa: PTH123 -- lives as long as the process
    reconfigure = getattr(stream, "reconfigure", None)
    if reconfigure is not None and _is_ours(stream, number):
        reconfigure(encoding="utf-8", errors="backslashreplace")
    return stream


def _is_ours(stream: TextIO, number: int) -> bool:
    return stream in (sys.stdout, sys.stderr) and number in (1, 2)


def _throw_away(stream: TextIO) -> None:
    """Let the interpreter's last flush go nowhere, quietly."""
    try:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
    except (OSError, ValueError):
        return


def _nothing() -> None:
    return
