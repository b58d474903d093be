"""What there is of a worker, and what may follow on what.

IDLE -> STARTING -> READY        the worker is started by the first thing to be heard
STARTING, READY -> IDLE          it failed, and will be started anew
any -> SILENT, GIVEN_UP, CLOSED  for good: no device, three failures in a minute, the end
"""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum, auto
from types import MappingProxyType


class State(Enum):
    """What there is of a worker."""

    IDLE = auto()
    STARTING = auto()
    READY = auto()
    SILENT = auto()
    GIVEN_UP = auto()
    CLOSED = auto()

    @property
    def is_running(self) -> bool:
        return self in _RUNNING

    @property
    def is_for_good(self) -> bool:
        """Whether no worker will be started any more."""
        return self in _FOR_GOOD

    def may_become(self, state: State) -> bool:
        return state in _NEXT[self]


_RUNNING = frozenset({State.STARTING, State.READY})
_FOR_GOOD = frozenset({State.SILENT, State.GIVEN_UP, State.CLOSED})
_NEXT: Mapping[State, frozenset[State]] = MappingProxyType(
    {
        State.IDLE: frozenset({State.STARTING, State.GIVEN_UP, State.CLOSED}),
        State.STARTING: frozenset({State.READY, State.IDLE, State.SILENT, State.GIVEN_UP, State.CLOSED}),
        State.READY: frozenset({State.IDLE, State.GIVEN_UP, State.CLOSED}),
        State.SILENT: frozenset({State.CLOSED}),
        State.GIVEN_UP: frozenset({State.CLOSED}),
        State.CLOSED: frozenset(),
    }
)
