"""Delivers a device's notices to its listener in the background, one after the other.

Rule: the device never waits for its listener. A listener that hangs, for example on a terminal that takes no
output, holds up only the notices that follow.
"""

from __future__ import annotations

import logging
import threading
from collections import deque
from collections.abc import Callable
from typing import Generic, ParamSpec

MOST_PENDING = 256
"""Notices that wait for a listener that hangs; later ones are dropped and logged."""
DELIVERY_TIMEOUT = 0.5
"""Seconds that a caller of ``wait`` waits by default."""

_LOG = logging.getLogger(__name__)
_P = ParamSpec("_P")


class Notifier(Generic[_P]):
    """The notices of one device. Any thread may send some. Its own thread lives while notices are pending."""

    def __init__(self, name: str, listener: Callable[_P, None] | None) -> None:
        """``listener`` is called with the arguments of ``notify``; what it raises is logged."""
        self._name = name
        self._listener = listener
        self._pending: deque[Callable[[], None]] = deque()
        self._changed = threading.Condition(threading.RLock())
        self._thread: threading.Thread | None = None

    def notify(self, *values: _P.args, **named: _P.kwargs) -> None:
        """Queue a notice and return at once."""
        listener = self._listener
        if listener is None:
            return
        with self._changed:
            if len(self._pending) >= MOST_PENDING:
                _LOG.warning("%s: its listener hangs; dropped: %s", self._name, values)
                return
            self._pending.append(lambda: listener(*values, **named))
            if self._thread is None:
                self._thread = threading.Thread(target=self._deliver, name=f"news {self._name}", daemon=True)
                self._thread.start()

    def wait(self, seconds: float = DELIVERY_TIMEOUT) -> None:
        """Wait until all notices are delivered, or that long. Called by the listener, it returns at once."""
        if self._thread is threading.current_thread():
            return
        with self._changed:
            self._changed.wait_for(lambda: self._thread is None, seconds)

    def _deliver(self) -> None:
        while True:
            with self._changed:
                if not self._pending:
                    self._thread = None
                    self._changed.notify_all()
                    return
                deliver_next = self._pending.popleft()
            try:
                deliver_next()
            except Exception:  # noqa: BLE001 -- the listener gets the following notices all the same
                _LOG.exception("a listener failed")
