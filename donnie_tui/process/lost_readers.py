"""Hears that whoever read the output is gone, where no terminal says so.

``ssh robot donnie run`` has no terminal. If that line is lost, or Ctrl+C pressed at home, nobody sends a
signal: only the next line that is printed would find out, and a robot may walk for minutes without one. So
the loss of a reader is the same as the loss of a terminal: SIGHUP.
"""

from __future__ import annotations

import os
import select
import signal
import threading
from stat import S_ISFIFO, S_ISSOCK

_OUTPUTS = (1, 2)


class ReaderWatch:
    """From its making, where SIGHUP must be handled already, to ``close``. Costs nothing at a terminal."""

    def __init__(self) -> None:
        self._thread: threading.Thread | None = None
        outputs = [each for each in _OUTPUTS if _is_read_by_somebody(each)]
        if outputs and hasattr(select, "poll"):
            self._reading, self._writing = os.pipe()
            self._thread = threading.Thread(target=self._watch, args=(outputs,), name="readers", daemon=True)
            self._thread.start()

    def close(self) -> None:
        """No signal comes any more."""
        if self._thread is not None:
            os.close(self._writing)
            self._thread.join()
            os.close(self._reading)
            self._thread = None

    def _watch(self, outputs: list[int]) -> None:
        poll = select.poll()
        for number in (self._reading, *outputs):
            poll.register(number, 0)  # an end that is gone is told unasked
        ready = {number for number, _ in poll.poll()}
        if self._reading not in ready:
            os.kill(os.getpid(), signal.SIGHUP)


def _is_read_by_somebody(number: int) -> bool:
    """Whether it is a pipe or a socket."""
    try:
        mode = os.fstat(number).st_mode
    except OSError:
        return False
    return S_ISFIFO(mode) or S_ISSOCK(mode)
