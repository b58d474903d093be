"""Pausing, stepping and stopping a running program: one state, one table, one condition variable.

Front ends make requests from any thread and never block. The program's thread looks at its checkpoints
(``reached``) and in its waits (``sleep``); only that thread ever waits here. A pause begins at the program's
next look: until then the state is PAUSING, from then on PAUSED.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from enum import Enum, auto
from math import inf

from language.diagnostics import Stopped

LONGEST_WAIT = 3600.0
"""Seconds that one wait of the condition variable may take; longer sleeps wait several times."""

_NOWHERE = (0, 0)

FOREVER = 1e12
"""Seconds; a longer sleep makes no difference."""


class ControlState(Enum):
    """The activity of a program, now or from its next checkpoint on."""

    RUNNING = auto()
    PAUSING = auto()
    """A pause was requested; the program holds at its next checkpoint or wait."""
    PAUSED = auto()
    """The program holds."""
    STEPPING = auto()
    """It holds again before its next statement."""
    STEPPING_OVER = auto()
    """It holds again before its next statement that is not inside a call."""
    RUNNING_TO = auto()
    """It holds again before the next statement on a certain line."""
    STOPPING = auto()
    ENDED = auto()


class ControlRequest(Enum):
    """A change of the state. The program's thread requests HOLD and END, front ends the others."""

    PAUSE = auto()
    RESUME = auto()
    STEP = auto()
    STEP_OVER = auto()
    RUN_TO = auto()
    STOP = auto()
    HOLD = auto()
    END = auto()


_S, _R = ControlState, ControlRequest
_HOLDABLE = (_S.PAUSING, _S.STEPPING, _S.STEPPING_OVER, _S.RUNNING_TO)
_ALIVE = (_S.RUNNING, _S.PAUSED, *_HOLDABLE)

TRANSITIONS: dict[tuple[ControlState, ControlRequest], ControlState] = {
    **{(state, _R.PAUSE): _S.PAUSING for state in _ALIVE if state is not _S.PAUSED},
    **{(state, _R.RESUME): _S.RUNNING for state in _ALIVE},
    **{(state, _R.STEP): _S.STEPPING for state in _ALIVE},
    **{(state, _R.STEP_OVER): _S.STEPPING_OVER for state in _ALIVE},
    **{(state, _R.RUN_TO): _S.RUNNING_TO for state in _ALIVE},
    **{(state, _R.STOP): _S.STOPPING for state in _ALIVE},
    **{(state, _R.HOLD): _S.PAUSED for state in (_S.RUNNING, *_HOLDABLE)},
    **{(state, _R.END): _S.ENDED for state in (*_ALIVE, _S.STOPPING)},
}
"""The next state after each request; one that is not listed changes nothing."""


class ExecutionControl:
    """Connects one running program with its observers and the requests of front ends."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._changed = threading.Condition(threading.Lock())
        self._state = ControlState.RUNNING
        self._run_to_line = 0
        self._breakpoints: frozenset[int] = frozenset()
        self._held_at = _NOWHERE
        self._held_depth = inf
        self._over_depth = inf
        self._observers: list[Callable[[ControlState], None]] = []
        self._runtime: Callable[[ControlState], None] | None = None
        self._look: Callable[[], None] | None = None

    # --- for front ends, from any thread ---

    @property
    def state(self) -> ControlState:
        return self._state

    def stop(self) -> None:
        """End the program at its next checkpoint, in the middle of a wait or of a movement too."""
        self._change(ControlRequest.STOP)

    def pause(self) -> None:
        self._change(ControlRequest.PAUSE)

    def resume(self) -> None:
        self._change(ControlRequest.RESUME)

    def step(self) -> None:
        """Run to the next statement, into a called procedure."""
        self._change(ControlRequest.STEP)

    def step_over(self) -> None:
        """Run to the next statement, after a called procedure."""
        self._change(ControlRequest.STEP_OVER)

    def run_to(self, line: int) -> None:
        """Run to the next statement that begins on ``line``."""
        self._change(ControlRequest.RUN_TO, line)

    def break_at(self, lines: frozenset[int]) -> None:
        """From now on hold before each statement that begins on one of these lines, in every state.

        Needs a program that was compiled with hooks.
        """
        with self._changed:
            self._breakpoints = lines
            if self._runtime is not None:
                self._runtime(self._state)

    def look_before_each(self, look: Callable[[], None] | None) -> None:
        """From now on call ``look`` before each statement, in the program's thread; None ends that.

        Needs a program that was compiled with hooks. It slows down computations a lot.
        """
        with self._changed:
            self._look = look
            if self._runtime is not None:
                self._runtime(self._state)

    @property
    def held_at(self) -> tuple[int, int]:
        """Line and column of the statement before which the program holds; 0, 0 in the middle of one."""
        return self._held_at

    def observe(self, observer: Callable[[ControlState], None]) -> Callable[[], None]:
        """Call ``observer`` with the new state each time the state becomes or stops being PAUSED.

        The thread that made the change calls it without any lock; for a hold that is the program's own
        thread. Two threads may report close changes at once; only ``state`` is reliable.
        Returns a function that ends the observation.
        """
        self._observers.append(observer)
        return lambda: self._observers.remove(observer)

    # --- for the program's thread ---

    def sleep(self, seconds: float) -> bool:
        """Wait. False as soon as the program must stop. The time in which it is paused does not count."""
        remaining = float(min(seconds, FOREVER))
        while True:
            self._hold_if(lambda: self._state is ControlState.PAUSING, inf, _NOWHERE)
            with self._changed:
                if self._state in (ControlState.STOPPING, ControlState.ENDED):
                    return False
                if self._state is ControlState.PAUSING:
                    continue
                if remaining <= 0:
                    return True
                started = self._clock()
                self._changed.wait(min(remaining, LONGEST_WAIT))
                remaining -= self._clock() - started

    def reached(self, line: int, depth: int, column: int = 0) -> None:
        """A statement on ``line``, inside ``depth`` calls, is next: hold if requested; raises Stopped."""
        if self._holds_at(line, depth):  # checked again under the lock; most statements hold nothing
            self._hold_if(lambda: self._holds_at(line, depth), depth, (line, column))
        if self._state is ControlState.STOPPING:
            raise Stopped
        look = self._look  # read once: another thread may remove it
        if look is not None:
            look()

    def ended(self) -> None:
        """The program ended, in any way."""
        self._change(ControlRequest.END)

    # --- for the runtime ---

    def attach(self, runtime: Callable[[ControlState], None] | None) -> None:
        """Call ``runtime`` with the state, now and at every change, under the lock."""
        with self._changed:
            self._runtime = runtime
            if runtime is not None:
                runtime(self._state)

    def holds_on_lines(self) -> frozenset[int]:
        """The breakpoints, and the line of ``run_to`` in the state RUNNING_TO."""
        requested = {self._run_to_line} if self._state is ControlState.RUNNING_TO else set[int]()
        return self._breakpoints | requested

    @property
    def looks_before_each(self) -> bool:
        return self._look is not None

    def holds_to_depth(self) -> float:
        """The number of calls up to which ``step_over`` holds."""
        return self._over_depth

    # --- inside ---

    def _holds_at(self, line: int, depth: int) -> bool:
        match self._state:
            case ControlState.PAUSING | ControlState.STEPPING:
                return True
            case ControlState.STEPPING_OVER:
                return depth <= self._over_depth or line in self._breakpoints
            case ControlState.RUNNING_TO:
                return line == self._run_to_line or line in self._breakpoints
            case ControlState.RUNNING:
                return line in self._breakpoints
            case _:
                return False

    def _hold_if(self, wanted: Callable[[], bool], depth: float, place: tuple[int, int]) -> None:
        """If ``wanted``, pause at ``place``, notify observers, and wait for the next request."""
        with self._changed:
            holding = wanted()
            if holding:
                self._held_depth, self._held_at = depth, place
                self._apply(ControlRequest.HOLD)
        if holding:
            self._notify(ControlState.PAUSED)
            with self._changed:
                self._changed.wait_for(lambda: self._state is not ControlState.PAUSED)

    def _change(self, request: ControlRequest, line: int = 0) -> None:
        with self._changed:
            before = self._state
            if request is ControlRequest.RUN_TO:
                self._run_to_line = line
            elif request is ControlRequest.STEP_OVER and before is not ControlState.STEPPING_OVER:
                self._over_depth = self._held_depth if before is ControlState.PAUSED else inf
            after = self._apply(request)
        if before is ControlState.PAUSED and after is not before:
            self._notify(after)

    def _apply(self, request: ControlRequest) -> ControlState:
        """Change the state by the table and notify the runtime; under the lock."""
        self._state = TRANSITIONS.get((self._state, request), self._state)
        if self._runtime is not None:
            self._runtime(self._state)
        self._changed.notify_all()
        return self._state

    def _notify(self, state: ControlState) -> None:
        for observer in tuple(self._observers):
            observer(state)
