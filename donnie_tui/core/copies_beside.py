"""Writes copies of programs in a thread of its own, which is there only while there is something to write.

Rule: whoever types waits for no disk. Each program's copy is written by one thread at a time; what is wanted
meanwhile is written once that is done.
"""

from __future__ import annotations

import threading
from collections.abc import Callable

from donnie_tui.core.copies import Copies
from donnie_tui.core.documents import DocumentError


class CopiesBeside:
    """Brings copies up to what is wanted of them."""

    def __init__(self, failed: Callable[[DocumentError], None]) -> None:
        """``failed`` is told, in that thread, what could not be written."""
        self._failed = failed
        self._lock = threading.Lock()
        self._in_work: set[Copies] = set()

    def bring_up(self, copies: Copies) -> None:
        """Have done what is wanted of them; from any thread."""
        with self._lock:
            if copies in self._in_work or not copies.is_behind:
                return
            self._in_work.add(copies)
        threading.Thread(target=self._work, args=(copies,), name="copies", daemon=True).start()

    def _work(self, copies: Copies) -> None:
        while self._goes_on(copies):
            try:
                copies.settle()
            except DocumentError as error:
                self._failed(error)

    def _goes_on(self, copies: Copies) -> bool:
        """Decided under the lock, so that what is wanted just now is done by this thread or the next."""
        with self._lock:
            if not copies.is_behind:
                self._in_work.discard(copies)
            return copies in self._in_work
