"""Signals that somebody takes for a while, and gives back as they were found.

Rule: the main thread takes them and gives them back. A handler that needs what might be held has a ``Deputy``
do it.
"""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Mapping
from contextlib import suppress
from types import FrameType
from typing import Self, TypeAlias

Handler: TypeAlias = Callable[[int, FrameType | None], object]


def numbers_of(*names: str) -> tuple[int, ...]:
    """Those of the signals that there are on this platform."""
    return tuple(getattr(signal, name) for name in names if hasattr(signal, name))


LEAVING = numbers_of("SIGTERM", "SIGHUP", "SIGQUIT")
"""They want us to leave."""


class TakenSignals:
    """Taken from the making to ``give_back``, or the end of ``with``."""

    def __init__(self, handlers: Mapping[int, Handler]) -> None:
        """Raises ``ValueError`` outside of the main thread."""
        self._found = {number: signal.signal(number, handler) for number, handler in handlers.items()}
        self._are_taken = True

    def handler_before(self, number: int) -> Handler | None:
        """What handled this one when it was taken; None where that was no function."""
        found = self._found[number]
        return found if callable(found) else None

    def give_back(self) -> None:
        """Any number of times."""
        if self._are_taken:
            self._are_taken = False
            for number, handler in self._found.items():
                signal.signal(number, handler)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.give_back()


class WakingSignals(TakenSignals):
    """They wake whoever waits for input from here too, with their numbers."""

    def __init__(self, handlers: Mapping[int, Handler]) -> None:
        super().__init__(handlers)
        self._reading, self._writing = os.pipe()
        os.set_blocking(self._reading, False)
        os.set_blocking(self._writing, False)
        self._fd_before = signal.set_wakeup_fd(self._writing, warn_on_full_buffer=False)

    def fileno(self) -> int:
        """For ``select``."""
        return self._reading

    def numbers(self) -> bytes:
        """Those that came since the last time, and a 0 for each nudge. Never waits."""
        try:
            return os.read(self._reading, 4096)
        except BlockingIOError:
            return b""

    def nudge(self) -> None:
        """Wake whoever waits. From any thread."""
        with suppress(OSError):
            os.write(self._writing, b"\0")

    def give_back(self) -> None:
        if self._are_taken:
            signal.set_wakeup_fd(self._fd_before)
        super().give_back()

    def close(self) -> None:
        """Behind ``give_back``, once nobody waits here any more."""
        os.close(self._reading)
        os.close(self._writing)
