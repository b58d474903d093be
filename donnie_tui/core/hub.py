"""One stream of events and its listeners.

Rules: every listener hears every event in the same order, also when a listener publishes in answer to
one; a publisher never waits for a screen, so listeners must be quick. Threads may publish at any time.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from typing import TypeAlias

from donnie_tui.core.events import TRANSIENT, Event, Stamped

Listener: TypeAlias = Callable[[Stamped], None]


class Hub:
    """Numbers events, stamps them with robot time and hands them to the listeners."""

    def __init__(self, clock: Callable[[], float], robot: str | None = None) -> None:
        self._clock = clock
        self._robot = robot
        self._listeners: tuple[Listener, ...] = ()
        self._lock = threading.Lock()
        self._waiting: deque[Stamped] = deque()
        self._delivering = False
        self._seq = 0

    def subscribe(self, listener: Listener) -> Callable[[], None]:
        """Listen from now on. The answer ends it."""
        with self._lock:
            self._listeners = (*self._listeners, listener)
        return lambda: self._unsubscribe(listener)

    def publish(self, event: Event) -> None:
        """Tell everybody. Returns once it is delivered, or queued behind an event that is being delivered."""
        with self._lock:
            self._waiting.append(self._stamp(event))
            if self._delivering:
                return
            self._delivering = True
        self._deliver()

    def _stamp(self, event: Event) -> Stamped:
        if isinstance(event, TRANSIENT):
            return Stamped(0, self._clock(), event, self._robot)
        self._seq += 1
        return Stamped(self._seq, self._clock(), event, self._robot)

    def _deliver(self) -> None:
        while True:
            with self._lock:
                if not self._waiting:
                    self._delivering = False
                    return
                stamped = self._waiting.popleft()
                listeners = self._listeners
            self._tell(stamped, listeners)

    def _tell(self, stamped: Stamped, listeners: tuple[Listener, ...]) -> None:
        try:
            for listener in listeners:
                listener(stamped)
        except BaseException:
            with self._lock:
                self._delivering = False
            raise

    def _unsubscribe(self, listener: Listener) -> None:
        with self._lock:
            self._listeners = tuple(each for each in self._listeners if each is not listener)
