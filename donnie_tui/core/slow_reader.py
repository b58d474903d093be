"""Lines on their way to somebody who may read slowly, or not at all: a pipe with a name.

A thread of its own writes, so that no listener holds the stream of events. Who is left too far behind gets
no more, which whoever writes is told as of any file that takes no more. What waits at the end is still
written as long as somebody reads.
"""

from __future__ import annotations

import errno
import os
import threading
from collections import deque

MOST_WAITING = 4_000_000
"""Bytes, and the line that reaches it."""
PATIENCE = 1.0
"""Seconds without a byte taken until, at the end, nobody is believed to read."""


class SlowReader:
    """Takes lines as a file does. ``number`` is an open file, which stays its owner's."""

    def __init__(self, number: int) -> None:
        self._number = os.dup(number)  # the owner's may be closed, and used again, while this thread writes
        self._changed = threading.Condition()
        self._waiting: deque[bytes] = deque()
        self._bytes = 0
        """So many wait."""
        self._is_over = False
        self._problem: OSError | None = None
        threading.Thread(target=self._work, name="slow reader", daemon=True).start()

    @property
    def closed(self) -> bool:
        return self._is_over

    def write(self, text: str) -> int:
        """Returns at once. Raises ``OSError`` where nobody takes what came before."""
        data = text.encode("utf-8", "backslashreplace")
        with self._changed:
            if self._problem is None and self._bytes >= MOST_WAITING:
                self._give_up(_too_slow())
            if self._problem is not None:
                raise self._problem
            self._waiting.append(data)
            self._bytes += len(data)
            self._changed.notify_all()
        return len(text)

    def flush(self) -> None:
        """Nothing more can be done."""

    def close(self) -> None:
        """Wait until all is written, or nobody takes it."""
        with self._changed:
            self._is_over = True
            self._changed.notify_all()
            while self._waiting and self._changed.wait(PATIENCE):
                pass  # something was taken
            if self._waiting:
                self._give_up(_too_slow())

    def _give_up(self, problem: OSError) -> None:
        """Under the lock."""
        self._problem = problem
        self._waiting.clear()
        self._bytes = 0
        self._changed.notify_all()

    # --- the thread

    def _work(self) -> None:
        try:
            while (data := self._next()) is not None:
                self._write(data)
        except OSError as problem:
            with self._changed:
                self._give_up(problem)
        finally:
            os.close(self._number)

    def _next(self) -> bytes | None:
        """It stays in the line until it is written: the end waits for it."""
        with self._changed:
            self._changed.wait_for(lambda: self._waiting or self._is_over or self._problem)
            return self._waiting[0] if self._waiting else None

    def _write(self, data: bytes) -> None:
        """As long as it is not given up."""
        left = memoryview(data)
        while left and self._problem is None:
            left = left[os.write(self._number, left) :]
            with self._changed:
                self._changed.notify_all()
        with self._changed:
            if self._problem is None:
                self._waiting.popleft()
                self._bytes -= len(data)
            self._changed.notify_all()


def _too_slow() -> OSError:
    return OSError(errno.EAGAIN, os.strerror(errno.EAGAIN))
