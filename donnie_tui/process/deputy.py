"""What signals ask for, done by a thread of its own: a handler interrupts the main thread in the midst of
anything, another handler included, so it must not take a lock that is held there.

Rule: a handler calls ``do`` and nothing else that might wait.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import suppress
from queue import Empty, SimpleQueue
from typing import TypeAlias

_LAST_DEEDS = 2.0
"""Seconds that ``close`` waits for what was asked for; it needs a few thousandths unless something hangs."""

Deed: TypeAlias = Callable[[], object]


class Deputy:
    """Does one thing after the other. From its making to ``close``."""

    def __init__(self) -> None:
        self._deeds: SimpleQueue[Deed | None] = SimpleQueue()  # its ``put`` may interrupt itself
        self._thread = threading.Thread(target=self._work, name="deputy", daemon=True)
        self._thread.start()

    def do(self, deed: Deed) -> None:
        """Have it done. Any thread, a signal's handler too; never waits."""
        self._deeds.put(deed)

    def see_done(self, deed: Deed, seconds: float) -> None:
        """Have it done and wait for that, at most so long: the caller may hold what the deed needs."""
        done: SimpleQueue[None] = SimpleQueue()

        def do_and_tell() -> None:
            try:
                deed()
            finally:
                done.put(None)

        self.do(do_and_tell)
        with suppress(Empty):
            done.get(timeout=seconds)

    def close(self) -> None:
        """All that was asked for is done, unless something hangs."""
        self._deeds.put(None)
        self._thread.join(_LAST_DEEDS)

    def _work(self) -> None:
        while (deed := self._deeds.get()) is not None:
            attempt(deed)


def attempt(deed: Deed) -> None:
    """Do it; a failure is logged, and nothing else: the next signal must be heeded all the same."""
    try:
        deed()
    except Exception:
        import logging  # slow to load, and not needed as long as all is well

        logging.getLogger(__name__).exception("what a signal asked for failed")
