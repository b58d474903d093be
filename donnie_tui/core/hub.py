"""One stream of events and its listeners.

Rules: every listener hears every event in the same order, also when a listener publishes in answer to
one; a publisher never waits for a screen, so listeners must be quick. Threads may publish at any time.
Where a world has several robots, each has a channel into the one stream.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from typing import Protocol, TypeAlias

from donnie_tui.core.events import TRANSIENT, Answered, Chimed, Event, Pointed, Stamped

Listener: TypeAlias = Callable[[Stamped], None]
Leave: TypeAlias = Callable[[], None]


class _Listeners:
    """A list that may change while somebody goes through it."""

    def __init__(self, lock: threading.Lock) -> None:
        self._lock = lock
        self.all: tuple[Listener, ...] = ()

    def add(self, listener: Listener) -> Leave:
        with self._lock:
            self.all = (*self.all, listener)
        return lambda: self._remove(listener)

    def _remove(self, listener: Listener) -> None:
        with self._lock:
            self.all = tuple(each for each in self.all if each is not listener)


class Stream:
    """Numbers the events of all channels and hands them to the listeners."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._listeners = _Listeners(self._lock)
        self._waiting: deque[tuple[Stamped, _Listeners]] = deque()
        self._delivering = False
        self._seq = 0

    def subscribe(self, listener: Listener) -> Leave:
        """Listen to all channels from now on. The answer ends it."""
        return self._listeners.add(listener)

    def listeners(self) -> _Listeners:
        """Those of one channel."""
        return _Listeners(self._lock)

    def pass_on(self, stamped: Stamped) -> None:
        """Tell everybody what happened before, as it was then."""
        with self._lock:
            if not self._queue(stamped, self.listeners()):
                return
        self._deliver()

    def publish(self, event: Event, t: float, robot: str | None, own: _Listeners) -> None:
        """Tell the channel's ``own`` listeners, then everybody."""
        with self._lock:
            if not self._queue(self._stamp(event, t, robot), own):
                return
        self._deliver()

    def _queue(self, stamped: Stamped, own: _Listeners) -> bool:
        """Whether the caller is to deliver; else somebody does already. Under the lock."""
        self._waiting.append((stamped, own))
        was_delivering, self._delivering = self._delivering, True
        return not was_delivering

    def _stamp(self, event: Event, t: float, robot: str | None) -> Stamped:
        if isinstance(event, TRANSIENT):
            return Stamped(0, t, event, robot)
        self._seq += 1
        return Stamped(self._seq, t, event, robot)

    def _deliver(self) -> None:
        while True:
            with self._lock:
                if not self._waiting:
                    self._delivering = False
                    return
                stamped, own = self._waiting.popleft()
                listeners = own.all + self._listeners.all
            self._tell(stamped, listeners)

    def _tell(self, stamped: Stamped, listeners: tuple[Listener, ...]) -> None:
        try:
            for listener in listeners:
                listener(stamped)
        except BaseException:
            with self._lock:
                self._delivering = False
            raise


class HasHub(Protocol):
    """Whatever can be listened to."""

    @property
    def hub(self) -> Hub: ...


class Hub:
    """One robot's channel into the stream; a stream of its own where none is given."""

    def __init__(
        self, clock: Callable[[], float], robot: str | None = None, stream: Stream | None = None
    ) -> None:
        """``clock`` is the robot's time, ``robot`` its name where the world has several."""
        self._clock = clock
        self.robot = robot
        self._stream = stream or Stream()
        self._own = self._stream.listeners()

    def subscribe(self, listener: Listener) -> Leave:
        """Listen from now on, to the other robots of the stream too. The answer ends it."""
        return self._stream.subscribe(listener)

    def subscribe_to_own(self, listener: Listener) -> Leave:
        """Listen to this robot only, before the listeners to all."""
        return self._own.add(listener)

    def publish(self, event: Event) -> None:
        """Tell everybody. Returns once it is delivered, or queued behind an event that is being delivered.

        What a front end answers is no robot's.
        """
        robot = None if isinstance(event, (Answered, Pointed, Chimed)) else self.robot
        self._stream.publish(event, self._clock(), robot, self._own)
