"""Standard input, output and error of the commands, and the signals that end a command early.

Output is always UTF-8; a character that has no UTF-8 becomes an escape. If the reader of the output is gone,
output ends and ``on_broken`` is called. Input is read line by line; undecodable bytes become replacement
characters, and a missing or failing input is at its end.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing, contextmanager
from typing import TextIO

from donnie_tui.process.disconnection import ReaderWatch
from donnie_tui.process.signals import (
    LEAVING,
    Deputy,
    Handler,
    TakenSignals,
    Task,
    Watchdog,
    can_suspend,
    end_process,
    heeded,
    suspend,
)


class Output:
    """Lines for people and scripts. Any thread may write."""

    def __init__(self, out: TextIO | None = None, err: TextIO | None = None) -> None:
        self.out = _prepared(out or sys.stdout)
        self._err = _prepared(err or sys.stderr)
        self.is_broken = False
        """Whether nothing can be written any more."""
        self.problem: str | None = None
        """The reason, unless the reader has just closed the pipe."""
        self.on_broken: Callable[[], None] = lambda: None
        self._is_writing, self._is_complaining = threading.RLock(), threading.RLock()

    def line(self, text: str) -> None:
        """Write a line of the result, without anything that a terminal would obey."""
        self.text(f"{_shown(text)}\n")

    @property
    def is_terminal(self) -> bool:
        return self.out.isatty()

    def text(self, text: str) -> None:
        self._write(lambda: self.out.write(text))

    def data(self, content: bytes) -> None:
        """Write the content of a file."""
        self._write(lambda: self.out.buffer.write(content))

    def _write(self, write: Callable[[], int]) -> None:
        if self.is_broken:
            return
        try:
            with self._is_writing:
                write()
                self.out.flush()
        except BrokenPipeError:
            self._give_up(None)
        except (OSError, ValueError) as problem:
            self._give_up(getattr(problem, "strerror", None) or str(problem))

    def complaint(self, *sentences: str) -> None:
        """Write Donnie's own diagnostics to standard error, a line each."""
        try:
            with self._is_complaining:
                self._err.writelines(f"{_shown(each)}\n" for each in sentences)
                self._err.flush()
        except (OSError, ValueError):
            _throw_away(self._err)

    def is_stuck(self) -> bool:
        """Whether a write of another thread does not end: nothing reads the output. Waits a moment for it."""
        return not (_is_free_soon(self._is_writing) and _is_free_soon(self._is_complaining))

    def finish(self) -> None:
        """Flush the output. A lost terminal does not change the exit code."""
        for stream in (self.out, self._err):
            try:
                stream.flush()
            except (OSError, ValueError):
                _throw_away(stream)

    def _give_up(self, problem: str | None) -> None:
        """Write no more, and call ``on_broken``."""
        self.is_broken, self.problem = True, problem
        _throw_away(self.out)
        self.on_broken()


_LONGEST_WRITE = 1.0
"""Seconds; a write takes far less, unless nothing reads it."""


def _is_free_soon(lock: threading.RLock) -> bool:
    is_free = lock.acquire(timeout=_LONGEST_WRITE)
    if is_free:
        lock.release()
    return is_free


class Guarded:
    """A stream for listeners that must not fail: a failed write ends the output instead."""

    def __init__(self, output: Output) -> None:
        self._output = output

    def write(self, text: str) -> int:
        self._output.text(text)
        return len(text)

    def flush(self) -> None:
        """Does nothing: every write is flushed already."""

    @property
    def closed(self) -> bool:
        return self._output.is_broken


def _shown(text: str) -> str:
    """Make a text printable, as names in files, worlds and boards may contain anything."""
    if text.isprintable():
        return text
    from language.source import printable

    return printable(text)


def _prepared(stream: TextIO | None) -> TextIO:
    """The stream as UTF-8, or an empty one if the process was started without it."""
    if stream is None:
        return open(os.devnull, "w", encoding="utf-8")  # noqa: PTH123 -- lives as long as the process
    reconfigure = getattr(stream, "reconfigure", None)
    if reconfigure is not None and stream in (sys.stdout, sys.stderr):
        reconfigure(encoding="utf-8", errors="backslashreplace")
    return stream


def _throw_away(stream: TextIO) -> None:
    """Redirect the stream to nowhere, so that the interpreter's last flush can't fail."""
    try:
        with open(os.devnull, "wb") as nowhere:  # noqa: PTH123
            os.dup2(nowhere.fileno(), stream.fileno())
    except (OSError, ValueError):
        return


class Input:
    """Standard input. Make it before anything is read, as the decoding can't be changed later."""

    def __init__(self) -> None:
        self._stream = sys.stdin
        reconfigure = getattr(self._stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors="replace")

    @property
    def is_terminal(self) -> bool:
        return is_terminal(self._stream)

    def line(self, longest: int = -1) -> str | None:
        """Read a line, without blanks around it and cut to ``longest`` characters; None at the end."""
        try:
            typed = self._stream.readline(longest) if self._stream is not None else ""
        except (OSError, ValueError):  # a lost terminal; closed
            typed = ""
        return typed.strip() if typed else None


_STOPPED = 130
"""The exit code of a command that a signal ended."""

_MOMENT = 0.05
"""Seconds until a signal also ends the voice."""

_LONGEST_REST = 2.5
"""Seconds that the main thread waits before a suspension; it may hold a lock that the stop needs."""

_LONGEST_SPEECH = 2400
"""Moments that the voice may speak after the end: two minutes."""


@contextmanager
def stopped_by_signals(
    stop: Callable[[], None],
    last: Sequence[Task] = (),
    code: Callable[[], int] = lambda: _STOPPED,
) -> Iterator[threading.Event]:
    """Each signal sets the event and has ``stop`` called in another thread.

    ``last`` and ``code`` are as in ``on_signals``.
    """
    stopped = threading.Event()

    def stop_all() -> None:
        stopped.set()
        stop()

    watchdog = _watchdog(heeded, last, code, on_number=lambda _number: watchdog.deputy.do(stop_all))
    with watchdog, closing(ReaderWatch()):
        yield stopped


@contextmanager
def on_signals(
    on_signal: Callable[[], None], last: Sequence[Task] = (), code: Callable[[], int] = lambda: _STOPPED
) -> Iterator[None]:
    """Each signal calls ``on_signal``, which interrupts the main thread anywhere: it must take no lock.

    The loss of the output's reader counts as a signal. If the main thread hangs, ``last`` runs and
    the process ends with ``code``, unless the signal was Ctrl+C.
    """
    with _watchdog(lambda *_: on_signal(), last, code), closing(ReaderWatch()):
        yield


def _watchdog(
    handler: Handler,
    last: Sequence[Task],
    code: Callable[[], int],
    on_number: Callable[[int], object] = int,
) -> Watchdog:
    handlers = dict.fromkeys((signal.SIGINT, *LEAVING), handler)
    return Watchdog(handlers, part=lambda _number: end_process(code, last), on_number=on_number)


@contextmanager
def stopped_by_suspension(
    stop: Callable[[], bool], refuse: Callable[[], object]
) -> Iterator[threading.Event]:
    """Ctrl+Z calls ``stop`` first, in another thread; it returns once all stands. The event is set if it had
    something to stop. ``refuse`` is called instead if Ctrl+Z has no effect."""
    stopped = threading.Event()

    def rest() -> None:
        if not can_suspend():
            refuse()
            return
        has_stopped = stop()
        if has_stopped:
            stopped.set()
        suspend()

    if not hasattr(signal, "SIGTSTP") or signal.getsignal(signal.SIGTSTP) is signal.SIG_IGN:
        yield stopped
        return
    with (
        closing(Deputy()) as deputy,
        TakenSignals({signal.SIGTSTP: lambda *_: deputy.see_done(rest, _LONGEST_REST)}),
    ):
        yield stopped


def let_sound(is_still_within: Callable[[float], bool], stopped: threading.Event) -> None:
    """Wait until voice and cues have finished, or a signal stops them."""
    for _ in range(_LONGEST_SPEECH):
        if stopped.is_set() or is_still_within(_MOMENT):
            return


def is_terminal(stream: object) -> bool:
    """Whether a stream is a terminal; False for a missing or a closed one."""
    try:
        return bool(stream is not None and stream.isatty())  # type: ignore[attr-defined] # a stream, or closed
    except ValueError:
        return False
