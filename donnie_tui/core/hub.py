"""One stream of events and its listeners.

Rules: all listeners get the events in the same order, also where a listener publishes an answer to one. A
publisher never waits for a screen, so listeners must be quick. Any thread may publish at any time.

A publishing thread delivers the queue up to its own event and no further. A thread of the stream delivers
what others queue meanwhile, so that no publisher works for others without end. A program continues once its
event was delivered, by any thread. So the answers to an event come before the program's next event, and a run
is the same whatever other threads publish.

A program that publishes faster than the listeners read waits after its event (``add_gate``), outside of any
delivery: that stops no other thread.

In a world of several robots, each has a channel into the one stream.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from enum import Enum, auto
from math import inf
from typing import TypeAlias

from donnie_tui.core.events import TRANSIENT, Answered, Chimed, Event, Pointed, Stamped

Listener: TypeAlias = Callable[[Stamped], None]
Leave: TypeAlias = Callable[[], None]
Gate: TypeAlias = Callable[[str | None], None]
"""Called with a robot's name in its program's thread. Returns once there is room for more events."""

MOST_WAITING = 10_000
"""Events that wait to be delivered before a program is slowed down."""
LONGEST_HOLD = 0.05
"""Seconds that it then waits for each event, so that no hanging listener holds a program for ever."""
LONGEST_TURN = 0.5
"""Seconds that it waits for another thread to deliver its event; only once where a listener hangs."""
LAST_WORD = 2.0
"""Seconds that a run waits at its end until all its events were delivered."""


class _NoThread(Enum):
    """In place of the number of a thread."""

    NONE = auto()
    HANDED_OVER = auto()
    """The thread that delivers is about to begin."""


class _End(Enum):
    """Why a thread stops delivering. Once the lock is free, another thread may deliver already."""

    NOTHING_WAITS = auto()
    OTHERS_WAIT = auto()


class _Listeners:
    """Listeners that can be added and removed during a delivery."""

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
        self._moved = threading.Condition(self._lock)
        self._listeners = _Listeners(self._lock)
        self._waiting: deque[tuple[int, Stamped, _Listeners]] = deque()
        self._queued = self._delivered = 0
        self._awaited = 0
        """How many threads wait for something to be delivered."""
        self._deliverer: int | _NoThread = _NoThread.NONE
        """The thread that delivers."""
        self._hangs_at: int | None = None
        """The number of delivered events when a program last gave up waiting for its event."""
        self._last_own: float
        """The last event that the delivering thread must deliver."""
        self._gates: tuple[Gate, ...] = ()
        self._seq = 0

    def subscribe(self, listener: Listener) -> Leave:
        """Adds a listener to all channels. The returned function removes it."""
        return self._listeners.add(listener)

    def listeners(self) -> _Listeners:
        """A new list of listeners, for one channel."""
        return _Listeners(self._lock)

    def pass_on(self, stamped: Stamped) -> None:
        """Delivers a recorded event unchanged."""
        with self._lock:
            if not self._queue(stamped, self.listeners()):
                return
        self._deliver()

    def publish(self, event: Event, t: float, robot: str | None, own: _Listeners) -> int:
        """Publishes to the ``own`` listeners, then to all. Returns the event's place in the order."""
        with self._lock:
            is_numbered = not isinstance(event, TRANSIENT)
            self._seq += is_numbered
            is_ours = self._queue(Stamped(self._seq if is_numbered else 0, t, event, robot), own)
            place = self._queued
        if is_ours:
            self._deliver()
        return place

    # --- programs that publish faster than listeners read

    def add_gate(self, gate: Gate) -> Leave:
        """Makes programs wait after their events until ``gate`` returns. The returned function removes it."""
        self._gates = (*self._gates, gate)
        return lambda: self._remove_gate(gate)

    def _remove_gate(self, gate: Gate) -> None:
        self._gates = tuple(each for each in self._gates if each != gate)

    def wait_for_room(self, robot: str | None, place: int) -> None:
        """Waits after the event at ``place``, in that program's thread; never during a delivery."""
        if self._delivers_here():
            return
        may_wait = self._delivered < place and self._delivered != self._hangs_at
        if may_wait and not self._wait_for(lambda: self._delivered >= place, LONGEST_TURN):
            self._hangs_at = self._delivered
        if len(self._waiting) > MOST_WAITING:
            self._wait_for(lambda: len(self._waiting) <= MOST_WAITING, LONGEST_HOLD)
        for gate in self._gates:
            gate(robot)

    def wait_until_delivered(self, seconds: float) -> None:
        """Returns once all published events were delivered, or after that many seconds."""
        if self._delivers_here():
            return
        until = self._queued
        self._wait_for(lambda: self._delivered >= until, seconds)

    def _wait_for(self, happened: Callable[[], bool], seconds: float) -> bool:
        """Waits; returns whether it happened in time."""
        with self._moved:
            self._awaited += 1
            has_happened = self._moved.wait_for(happened, seconds)
            self._awaited -= 1
        return has_happened

    # --- delivering

    def _delivers_here(self) -> bool:
        return self._deliverer == threading.get_ident()

    def _queue(self, stamped: Stamped, own: _Listeners) -> bool:
        """Queues an event, under the lock. Returns whether the caller must deliver it."""
        self._queued += 1
        self._waiting.append((self._queued, stamped, own))
        if self._deliverer is _NoThread.NONE:
            self._deliverer, self._last_own = threading.get_ident(), self._queued
            return True
        if self._delivers_here():
            self._last_own = max(self._last_own, self._queued)
        return False

    def _deliver(self) -> None:
        """Delivers up to the last event of this thread; then another thread continues."""
        while not isinstance(entry := self._next(), _End):
            stamped, listeners = entry
            try:
                for listener in listeners:
                    listener(stamped)
            except BaseException:
                with self._lock:
                    self._delivered += 1
                    self._deliverer = _NoThread.NONE
                raise
            self._delivered += 1
        if entry is _End.OTHERS_WAIT:
            threading.Thread(target=self._deliver_rest, name="stream", daemon=True).start()

    def _next(self) -> tuple[Stamped, tuple[Listener, ...]] | _End:
        """The next event for this thread to deliver, else the reason to stop."""
        with self._lock:
            if self._awaited:
                self._moved.notify_all()
            if not self._waiting:
                self._deliverer = _NoThread.NONE
                return _End.NOTHING_WAITS
            number, stamped, own = self._waiting[0]
            if number > self._last_own:
                self._deliverer = _NoThread.HANDED_OVER
                return _End.OTHERS_WAIT
            self._waiting.popleft()
            return stamped, own.all + self._listeners.all

    def _deliver_rest(self) -> None:
        """Delivers until the queue is empty, in a thread of the stream."""
        with self._lock:
            self._deliverer, self._last_own = threading.get_ident(), inf
        try:
            self._deliver()
        except Exception:  # no caller can catch it; the next publisher delivers the rest
            import logging  # slow to load, and never needed as long as all is well

            logging.getLogger(__name__).exception("a listener failed")


class Hub:
    """One robot's channel into a stream; without a stream it makes its own."""

    def __init__(
        self, clock: Callable[[], float], robot: str | None = None, stream: Stream | None = None
    ) -> None:
        """``clock`` gives the robot's time; ``robot`` is its name where the world has several."""
        self._clock = clock
        self.robot = robot
        self._stream = stream or Stream()
        self._own = self._stream.listeners()
        self._program: int | _NoThread = _NoThread.NONE
        """The thread of the program that may have to wait."""

    def subscribe(self, listener: Listener) -> Leave:
        """Adds a listener, also to the other robots of the stream. The returned function removes it."""
        return self._stream.subscribe(listener)

    def subscribe_to_own(self, listener: Listener) -> Leave:
        """Adds a listener to this robot only, called before the listeners to all."""
        return self._own.add(listener)

    def publish(self, event: Event) -> None:
        """Publishes an event. Returns once it is delivered, or queued during another delivery.

        A front end's answer belongs to no robot. A program that publishes faster than listeners read waits
        here.
        """
        robot = None if isinstance(event, (Answered, Pointed, Chimed)) else self.robot
        place = self._stream.publish(event, self._clock(), robot, self._own)
        if self._program == threading.get_ident():
            self._stream.wait_for_room(self.robot, place)

    def add_gate(self, gate: Gate) -> Leave:
        """As ``Stream.add_gate``."""
        return self._stream.add_gate(gate)

    def hold_back_here(self) -> None:
        """Makes this program's thread wait where it publishes faster than listeners read."""
        self._program = threading.get_ident()

    def stop_holding_back(self) -> None:
        self._program = _NoThread.NONE

    def wait_until_delivered(self, seconds: float = LAST_WORD) -> None:
        """Returns once all published events were delivered, or after that many seconds."""
        self._stream.wait_until_delivered(seconds)
