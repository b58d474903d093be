"""Writes lines to files that may stop accepting them: a full disk, a pipe without a reader.

Rule: such a failure is reported once, and ends the writing and nothing else.

``SlowReader`` writes to a named pipe in a thread of its own, so that a slow reader does not block the stream
of events. A reader that falls too far behind gets no more lines, and the writer gets an error as from a full
disk. At the end, the remaining lines are written as long as the reader takes them.
"""

from __future__ import annotations

import errno
import os
import threading
from collections import deque
from collections.abc import Callable
from typing import TextIO


class LineFile:
    """Writes whole lines and flushes each time. The owner of ``out`` closes it."""

    def __init__(self, out: TextIO, on_failure: Callable[[OSError], None] | None = None) -> None:
        self._out = out
        self._on_failure = on_failure
        self._has_failed = False

    @property
    def takes_more(self) -> bool:
        return not (self._has_failed or self._out.closed)

    def write(self, lines: str) -> None:
        """Writes lines, unless an earlier writing failed."""
        try:
            self._out.write(lines)
            self._out.flush()
        except OSError as problem:
            self._has_failed = True
            if self._on_failure:
                self._on_failure(problem)


MOST_WAITING = 4_000_000
"""Bytes, and the line that reaches it."""
LONGEST_STALL = 1.0
"""Seconds without progress after which, at the end, the reader counts as gone."""


class SlowReader:
    """A text output for a pipe. ``number`` is an open file, which its owner closes."""

    def __init__(self, number: int) -> None:
        self._number = os.dup(number)  # the owner's may be closed, and used again, while this thread writes
        self._changed = threading.Condition()
        self._waiting: deque[bytes] = deque()
        self._bytes = 0
        """Bytes in the queue."""
        self._is_over = False
        self._problem: OSError | None = None
        threading.Thread(target=self._work, name="slow reader", daemon=True).start()

    @property
    def closed(self) -> bool:
        return self._is_over

    def write(self, text: str) -> int:
        """Queues text and returns at once. Raises ``OSError`` where the reader takes nothing."""
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
        """Does nothing: the thread writes."""

    def close(self) -> None:
        """Waits until all is written, or the reader takes no more."""
        with self._changed:
            self._is_over = True
            self._changed.notify_all()
            while self._waiting and self._changed.wait(LONGEST_STALL):
                pass  # something was taken
            if self._waiting:
                self._give_up(_too_slow())

    def _give_up(self, problem: OSError) -> None:
        """Ends the writing. Called under the lock."""
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
        """The next bytes. They stay queued until they are written, as the end waits for them."""
        with self._changed:
            self._changed.wait_for(lambda: self._waiting or self._is_over or self._problem)
            return self._waiting[0] if self._waiting else None

    def _write(self, data: bytes) -> None:
        """Writes until all is done or the reader was given up."""
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
