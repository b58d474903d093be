"""Keeps the copies of a front end's programs as they are wanted, for the case of a crash.

Rule: whoever types waits for no disk. Copies are written in a thread of their own, which is there only while
there is something to write; each program's by one thread at a time, and what is wanted meanwhile is written
once that is done.
"""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Callable, Iterable

from donnie_tui.core.copies import Copies
from donnie_tui.core.documents import DocumentError


class CopyKeeping:
    """Brings copies up to what is wanted of them."""

    def __init__(self, not_kept: Callable[[DocumentError], object]) -> None:
        """``not_kept`` is told once, in another thread, why something can't be written down."""
        self._not_kept, self._has_failed = not_kept, False
        self._lock = threading.Lock()
        self._in_work: set[Copies] = set()

    def bring_up(self, copies: Copies) -> None:
        """Have done what is wanted of them; from any thread."""
        with self._lock:
            if copies in self._in_work or not copies.is_behind:
                return
            self._in_work.add(copies)
        threading.Thread(target=self._work, args=(copies,), name="copies", daemon=True).start()

    def forget(self, copies: Copies) -> None:
        """The text is safe elsewhere, or given up."""
        copies.want_none()
        self.bring_up(copies)

    def _work(self, copies: Copies) -> None:
        while self._goes_on(copies):
            try:
                copies.settle()
            except DocumentError as error:
                self._tell(error)

    def _goes_on(self, copies: Copies) -> bool:
        """Decided under the lock, so that what is wanted just now is done by this thread or the next."""
        with self._lock:
            if not copies.is_behind:
                self._in_work.discard(copies)
            return copies in self._in_work

    def _tell(self, error: DocumentError) -> None:
        with self._lock:
            told, self._has_failed = self._has_failed, True
        if not told:
            self._not_kept(error)


def settle_all(each_copies: Iterable[Copies]) -> None:
    """All done once this returns, for whoever leaves. Quietly: who would hear it?"""
    for copies in each_copies:
        with contextlib.suppress(DocumentError, OSError):
            copies.settle()
