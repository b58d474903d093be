"""One stream of events and its listeners.

Rules: every listener hears every event in the same order, also when a listener publishes in answer to
one; a publisher never waits for a screen, so listeners must be quick. Threads may publish at any time.
Whoever publishes delivers what was queued up to its own event and no more: what others queue meanwhile is
delivered by a thread of the stream, so that nobody works for others without end. A program goes on once its
event was delivered, by whichever thread: what is answered to it comes before what the program tells next, so
that a run is the same whoever else tells something meanwhile. A program that tells more than is read waits
behind its event (``gates``), outside of any delivery: that holds nobody else.
Where a world has several robots, each has a channel into the one stream.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from enum import Enum, auto
from math import inf

from devices.ports.hints import Protocol, TypeAlias
from donnie_tui.core.events import TRANSIENT, Answered, Chimed, Event, Pointed, Stamped

Listener: TypeAlias = Callable[[Stamped], None]
Leave: TypeAlias = Callable[[], None]
Gate: TypeAlias = Callable[[str | None], None]
"""Called with a robot's name in its program's thread: returns once there is room for more from it."""

MOST_WAITING = 10_000
"""Events that wait to be delivered before a program is slowed down."""
LONGEST_HOLD = 0.05
"""Seconds that it waits then for each event; a listener that hangs holds no program for ever."""
LONGEST_TURN = 0.5
"""Seconds that it waits for another thread to deliver its event; for a listener that hangs, once."""
LAST_WORD = 2.0
"""Seconds that a run waits at its end until everybody has heard of it."""

_NOBODY = 0
_HANDED_OVER = -1
"""Who delivers where it is no thread that is known yet."""


class _End(Enum):
    """Why a thread delivers no more. Its own: behind the lock another one may deliver already."""

    NOTHING_WAITS = auto()
    OTHERS_WAIT = auto()


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
        self._moved = threading.Condition(self._lock)
        self._listeners = _Listeners(self._lock)
        self._waiting: deque[tuple[int, Stamped, _Listeners]] = deque()
        self._queued = self._delivered = 0
        self._awaited = 0
        """How many threads wait for something to be delivered."""
        self._deliverer = _NOBODY
        """The thread that delivers."""
        self._hangs_at = -1
        """How many had been delivered when a program last gave up waiting for its event."""
        self._last_own: float = 0
        """The last event that this one has to deliver."""
        self._gates: tuple[Gate, ...] = ()
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

    def publish(self, event: Event, t: float, robot: str | None, own: _Listeners) -> int:
        """Tell the channel's ``own`` listeners, then everybody. Answers its place in the order."""
        with self._lock:
            is_ours = self._queue(self._stamp(event, t, robot), own)
            place = self._queued
        if is_ours:
            self._deliver()
        return place

    # --- programs that tell faster than anybody reads

    def add_gate(self, gate: Gate) -> Leave:
        """Have programs wait behind their events until ``gate`` returns. The answer ends it."""
        self._gates = (*self._gates, gate)
        return lambda: self._remove_gate(gate)

    def _remove_gate(self, gate: Gate) -> None:
        self._gates = tuple(each for each in self._gates if each != gate)

    def wait_for_room(self, robot: str | None, place: int) -> None:
        """In the thread of that robot's program, behind its event at ``place``; never in the midst of a
        delivery."""
        if self._delivers_here():
            return
        if self._delivered < place and self._delivered != self._hangs_at:
            self._wait_for_delivery(place)
        if len(self._waiting) > MOST_WAITING:
            self._wait_for(lambda: len(self._waiting) <= MOST_WAITING, LONGEST_HOLD)
        for gate in self._gates:
            gate(robot)

    def wait_until_heard(self, seconds: float) -> None:
        """Return once everybody has heard what was published so far, or after so many seconds."""
        if self._delivers_here():
            return
        until = self._queued
        self._wait_for(lambda: self._delivered >= until, seconds)

    def _wait_for_delivery(self, place: int) -> None:
        if not self._wait_for(lambda: self._delivered >= place, LONGEST_TURN):
            self._hangs_at = self._delivered

    def _wait_for(self, happened: Callable[[], bool], seconds: float) -> bool:
        """Whether it happened in time."""
        with self._moved:
            self._awaited += 1
            has_happened = self._moved.wait_for(happened, seconds)
            self._awaited -= 1
        return has_happened

    # --- delivering

    def _delivers_here(self) -> bool:
        return self._deliverer == threading.get_ident()

    def _queue(self, stamped: Stamped, own: _Listeners) -> bool:
        """Whether the caller is to deliver; else somebody does already. Under the lock."""
        self._queued += 1
        self._waiting.append((self._queued, stamped, own))
        if self._deliverer == _NOBODY:
            self._deliverer, self._last_own = threading.get_ident(), self._queued
            return True
        if self._delivers_here():
            self._last_own = max(self._last_own, self._queued)
        return False

    def _stamp(self, event: Event, t: float, robot: str | None) -> Stamped:
        if isinstance(event, TRANSIENT):
            return Stamped(0, t, event, robot)
        self._seq += 1
        return Stamped(self._seq, t, event, robot)

    def _deliver(self) -> None:
        """Up to the last event of this thread; then another one goes on."""
        while not isinstance(entry := self._next(), _End):
            self._tell(*entry)
            self._delivered += 1
        if entry is _End.OTHERS_WAIT:
            threading.Thread(target=self._deliver_rest, name="stream", daemon=True).start()

    def _next(self) -> tuple[Stamped, tuple[Listener, ...]] | _End:
        """The next event for this thread to deliver; else whether it has to find another one."""
        with self._lock:
            if self._awaited:
                self._moved.notify_all()
            if not self._waiting:
                self._deliverer = _NOBODY
                return _End.NOTHING_WAITS
            number, stamped, own = self._waiting[0]
            if number > self._last_own:
                self._deliverer = _HANDED_OVER
                return _End.OTHERS_WAIT
            self._waiting.popleft()
            return stamped, own.all + self._listeners.all

    def _deliver_rest(self) -> None:
        """In a thread of the stream's own: until nothing waits."""
        with self._lock:
            self._deliverer, self._last_own = threading.get_ident(), inf
        try:
            self._deliver()
        except Exception:  # nobody is here to catch it; who publishes next delivers what is left
            import logging  # slow to load, and never needed as long as all is well

            logging.getLogger(__name__).exception("a listener failed")

    def _tell(self, stamped: Stamped, listeners: tuple[Listener, ...]) -> None:
        try:
            for listener in listeners:
                listener(stamped)
        except BaseException:
            with self._lock:
                self._delivered += 1
                self._deliverer = _NOBODY
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
        self._program = _NOBODY
        """The thread of the program that may be held back."""

    def subscribe(self, listener: Listener) -> Leave:
        """Listen from now on, to the other robots of the stream too. The answer ends it."""
        return self._stream.subscribe(listener)

    def subscribe_to_own(self, listener: Listener) -> Leave:
        """Listen to this robot only, before the listeners to all."""
        return self._own.add(listener)

    def publish(self, event: Event) -> None:
        """Tell everybody. Returns once it is delivered, or queued behind an event that is being delivered.

        What a front end answers is no robot's. A program waits here where it tells more than is read.
        """
        robot = None if isinstance(event, (Answered, Pointed, Chimed)) else self.robot
        place = self._stream.publish(event, self._clock(), robot, self._own)
        if self._program == threading.get_ident():
            self._stream.wait_for_room(self.robot, place)

    def add_gate(self, gate: Gate) -> Leave:
        """As the stream does."""
        return self._stream.add_gate(gate)

    def hold_back_here(self) -> None:
        """From now on this thread, which is a program's, waits where it tells more than is read."""
        self._program = threading.get_ident()

    def hold_back_nobody(self) -> None:
        self._program = _NOBODY

    def wait_until_heard(self, seconds: float = LAST_WORD) -> None:
        """Return once everybody has heard what was published so far, or after so many seconds."""
        self._stream.wait_until_heard(seconds)
