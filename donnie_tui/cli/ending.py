"""What ends a command that takes its time: a signal, or the last word of the voice."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager

from donnie_tui.process.lost_readers import ReaderWatch
from donnie_tui.process.signals import LEAVING, Deputy, TakenSignals, suspend

_MOMENT = 0.05
"""Seconds within which a signal ends the voice too."""

_LONGEST_REST = 2.0
"""Seconds that the main thread waits for a rest to begin; it may hold what the stop before it needs."""

_LONGEST_SPEECH = 2400
"""Moments that the voice may take behind the end: two minutes."""


@contextmanager
def stopped_by_signals(stop: Callable[[], None]) -> Iterator[threading.Event]:
    """Any of them, any number of times, sets the event and has ``stop`` called, in another thread."""
    stopped = threading.Event()

    def heed() -> None:
        stopped.set()
        stop()

    with closing(Deputy()) as deputy, heard_signals(lambda: deputy.do(heed)):
        yield stopped


@contextmanager
def heard_signals(heard: Callable[[], None]) -> Iterator[None]:
    """Any of them calls ``heard``, in the midst of whatever the main thread does: it must take no lock.

    The loss of whoever reads the output is one of them.
    """
    handlers = dict.fromkeys((signal.SIGINT, *LEAVING), lambda *_: heard())
    with TakenSignals(handlers), closing(ReaderWatch()):
        yield


@contextmanager
def stopped_by_suspension(stop: Callable[[], bool]) -> Iterator[threading.Event]:
    """Ctrl+Z calls ``stop`` first, in another thread; it returns once all stands. The event is set if it had
    something to stop."""
    stopped = threading.Event()

    def rest() -> None:
        has_stopped = stop()
        if has_stopped:
            stopped.set()
        suspend()

    number = getattr(signal, "SIGTSTP", None)
    if number is None or signal.getsignal(number) is signal.SIG_IGN:
        yield stopped
        return
    with (
        closing(Deputy()) as deputy,
        TakenSignals({number: lambda *_: deputy.see_done(rest, _LONGEST_REST)}),
    ):
        yield stopped


def let_sound(is_still_within: Callable[[float], bool], stopped: threading.Event) -> None:
    """All is done before its words are said: voice and cues get their time, until somebody stops them."""
    for _ in range(_LONGEST_SPEECH):
        if stopped.is_set() or is_still_within(_MOMENT):
            return
