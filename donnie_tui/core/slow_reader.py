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

MOST_WAITING = 20_000
"""Lines; about four megabytes."""
PATIENCE = 1.0
"""Seconds without a byte taken until, at the end, nobody is believed to read."""


class SlowReader:
    """Takes lines as a file does. ``number`` is an open file, which stays its owner's."""

    def __init__(self, number: int) -> None:
        self._number = number
        self._changed = threading.Condition()
        self._waiting: deque[bytes] = deque()
        self._is_over = False
        self._problem: OSError | None = None
        threading.Thread(target=self._work, name="slow reader", daemon=True).start()

    @property
    def closed(self) -> bool:
        return self._is_over

    def write(self, text: str) -> int:
        """Returns at once. Raises ``OSError`` where nobody takes what came before."""
        with self._changed:
            if self._problem is None and len(self._waiting) >= MOST_WAITING:
                self._problem = OSError(errno.EAGAIN, os.strerror(errno.EAGAIN))
            if self._problem is not None:
                self._waiting.clear()
                raise self._problem
            self._waiting.append(text.encode("utf-8", "backslashreplace"))
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

    def _work(self) -> None:
        while (data := self._next()) is not None:
            try:
                while data:
                    data = data[os.write(self._number, data) :]
                    self._took()
            except OSError as problem:
                with self._changed:
                    self._problem = problem
                    self._waiting.clear()
                    self._changed.notify_all()
                return
            self._wrote()

    def _next(self) -> bytes | None:
        """It stays in the line until it is written: the end waits for it."""
        with self._changed:
            self._changed.wait_for(lambda: self._waiting or self._is_over)
            return self._waiting[0] if self._waiting else None

    def _took(self) -> None:
        with self._changed:
            self._changed.notify_all()

    def _wrote(self) -> None:
        with self._changed:
            if self._waiting:
                self._waiting.popleft()
            self._changed.notify_all()
