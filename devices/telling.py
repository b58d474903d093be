"""Tells a listener one thing after the other, in a thread of its own that lives while there is news.

Rule: whoever has news never waits for whoever listens. A listener that hangs, because nobody reads what it
prints, holds only the news behind it.
"""

from __future__ import annotations

import logging
import threading
from collections import deque
from collections.abc import Callable
from typing import Generic, ParamSpec

MOST_WAITING = 256
"""News that wait for a listener that hangs; what comes then is left out."""
LONGEST_HEARING = 0.5
"""Seconds that somebody waits for a listener at the most."""

_LOG = logging.getLogger(__name__)
_P = ParamSpec("_P")


class Telling(Generic[_P]):
    """The news of one device. Any thread may have some."""

    def __init__(self, name: str, listener: Callable[_P, None] | None) -> None:
        """``listener`` is called with what ``tell`` is given; what it raises is logged."""
        self._name = name
        self._listener = listener
        self._waiting: deque[Callable[[], None]] = deque()
        self._moved = threading.Condition(threading.RLock())
        self._thread: threading.Thread | None = None

    def tell(self, *values: _P.args, **named: _P.kwargs) -> None:
        """Have it told, behind what waits; returns at once."""
        listener = self._listener
        if listener is None:
            return
        with self._moved:
            if len(self._waiting) >= MOST_WAITING:
                _LOG.warning("%s: nobody listens; left out: %s", self._name, values)
                return
            self._waiting.append(lambda: listener(*values, **named))
            if self._thread is None:
                self._thread = threading.Thread(target=self._work, name=f"news {self._name}", daemon=True)
                self._thread.start()

    def wait(self, seconds: float = LONGEST_HEARING) -> None:
        """Until all was told, or that long; at once for the listener itself."""
        if self._thread is threading.current_thread():
            return
        with self._moved:
            self._moved.wait_for(lambda: self._thread is None, seconds)

    def _work(self) -> None:
        while self._tell_next():
            pass

    def _tell_next(self) -> bool:
        with self._moved:
            if not self._waiting:
                self._thread = None
                self._moved.notify_all()
                return False
            news = self._waiting.popleft()
        try:
            news()
        except Exception:  # noqa: BLE001 -- the next news are for it as well
            _LOG.exception("a listener failed")
        return True
