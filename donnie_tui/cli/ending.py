"""What ends a command that takes its time: a signal, or the last word of the voice."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

from donnie_tui.suspending import suspend

_SIGNALS = ("SIGINT", "SIGTERM", "SIGHUP", "SIGQUIT")

_MOMENT = 0.05
"""Seconds within which a signal ends the voice too."""

_LONGEST_SPEECH = 2400
"""Moments that the voice may take behind the end: two minutes."""


@contextmanager
def stopped_by_signals(stop: Callable[[], None]) -> Iterator[threading.Event]:
    """Any of them, any number of times, calls ``stop`` and sets the event."""
    stopped = threading.Event()

    def heard(_number: int, _frame: FrameType | None) -> None:
        stopped.set()
        stop()

    numbers = [getattr(signal, name) for name in _SIGNALS if hasattr(signal, name)]
    before = {number: signal.signal(number, heard) for number in numbers}
    try:
        yield stopped
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


@contextmanager
def stopped_by_suspension(stop: Callable[[], bool]) -> Iterator[threading.Event]:
    """Ctrl+Z calls ``stop`` first; the event is set if that says that it had something to stop."""
    stopped = threading.Event()

    def heard(_number: int, _frame: FrameType | None) -> None:
        has_stopped = stop()
        if has_stopped:
            stopped.set()
        suspend(after_stop=has_stopped)

    number = getattr(signal, "SIGTSTP", None)
    if number is None or signal.getsignal(number) is signal.SIG_IGN:
        yield stopped
        return
    before = signal.signal(number, heard)
    try:
        yield stopped
    finally:
        signal.signal(number, before)


def let_speak(is_quiet_within: Callable[[float], bool], stopped: threading.Event) -> None:
    """All is done before its words are said: the voice gets its time, until somebody stops it."""
    for _ in range(_LONGEST_SPEECH):
        if stopped.is_set() or is_quiet_within(_MOMENT):
            return
