"""What the service knows of its worker: its state, what it has found, and by when it must respond.

IDLE -> STARTING -> READY        the first sentence or cue starts the worker
STARTING, READY -> IDLE          it failed, and will be started again
any -> SILENT, GIVEN_UP, CLOSED  final: no device, three failures in a minute, the end

All of it is without I/O; times come in as parameters.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from enum import Enum, auto
from types import MappingProxyType

from devices.audio.messages import Pong

RESPONSE_LIMIT = 3.0
"""Seconds without a response or a frame played, after which a worker counts as frozen."""

START_LIMIT = 10.0
"""Seconds for opening the device and loading the voice, on a slow machine with a cold disk."""

SILENCE_LIMIT = 0.12
"""Seconds; silence must follow within 0.15, and killing the group takes a few milliseconds."""

PING_INTERVAL = 1.0
"""Seconds between heartbeats. They are sent only while something should sound: an idle worker may sleep."""

MOST_FAILURES = 3
FAILURE_WINDOW = 60.0


class WorkerState(Enum):
    """The state of the worker."""

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
    def is_final(self) -> bool:
        """Whether no worker will be started any more."""
        return self in _FINAL

    def may_become(self, state: WorkerState) -> bool:
        return state in _NEXT[self]


_S = WorkerState
_RUNNING = frozenset({_S.STARTING, _S.READY})
_FINAL = frozenset({_S.SILENT, _S.GIVEN_UP, _S.CLOSED})
_NEXT: Mapping[WorkerState, frozenset[WorkerState]] = MappingProxyType(
    {
        _S.IDLE: frozenset({_S.STARTING, _S.GIVEN_UP, _S.CLOSED}),
        _S.STARTING: frozenset({_S.READY, _S.IDLE, _S.SILENT, _S.GIVEN_UP, _S.CLOSED}),
        _S.READY: frozenset({_S.IDLE, _S.GIVEN_UP, _S.CLOSED}),
        _S.SILENT: frozenset({_S.CLOSED}),
        _S.GIVEN_UP: frozenset({_S.CLOSED}),
        _S.CLOSED: frozenset(),
    }
)


class Awaited(Enum):
    """What a worker must do in time."""

    START = auto()
    PONG = auto()
    SPEECH_STARTED = auto()
    SPEECH_FINISHED = auto()
    SILENCED = auto()
    PLAYBACK = auto()
    """Play frames, while the player reports that it plays."""


class Deadlines:
    """The times by which one worker must do what is awaited."""

    def __init__(self) -> None:
        self._times: dict[Awaited, float] = {}
        self._frames = -1

    def expect(self, what: Awaited, by: float) -> None:
        """An earlier deadline for the same is kept."""
        self._times.setdefault(what, by)

    def met(self, *what: Awaited) -> None:
        """It was done, or is no longer awaited."""
        for each in what:
            self._times.pop(each, None)

    def expects(self, what: Awaited) -> bool:
        return what in self._times

    def heartbeat(self, frames: int, is_playing: bool, now: float) -> None:
        """``frames``: given to the device so far, -1 if that is unknown."""
        if not is_playing or frames < 0 or frames != self._frames:
            self.met(Awaited.PLAYBACK)
        if is_playing and frames >= 0:
            self.expect(Awaited.PLAYBACK, now + RESPONSE_LIMIT)
        self._frames = frames

    def postpone(self, seconds: float) -> None:
        """This process itself did not run for so long, being suspended or starved."""
        self._times = {what: time + seconds for what, time in self._times.items()}

    def overdue(self, now: float) -> Awaited | None:
        """What should have been done by ``now``, or None."""
        return next((what for what, time in self._times.items() if now >= time), None)

    def next_at(self) -> float | None:
        """When to check again."""
        return min(self._times.values(), default=None)


class WorkerStatus:
    """What is known of one worker, or of none yet. The next worker gets a new status."""

    def __init__(self) -> None:
        self.deadlines = Deadlines()
        self.player = ""
        """The name of the player that it opened; empty while that is unknown."""
        self.languages: tuple[str, ...] | None = None
        """The languages that it has voices for; None while that is unknown."""
        self._next_ping: float | None = None

    @property
    def is_ready(self) -> bool:
        """Whether it has reported both the device and the voices."""
        return bool(self.player) and self.languages is not None

    @property
    def has_no_voice(self) -> bool:
        """Whether it looked for voices and found none."""
        return self.languages == ()

    def can_read(self, base_language: str) -> bool:
        return base_language in (self.languages or ())

    def must_ping(self, has_sent: bool, now: float) -> bool:
        """Whether to send a heartbeat now: with every other request, and then as long as a sentence lasts.

        The response is then awaited.
        """
        is_time = self._next_ping is not None and now >= self._next_ping
        if not (is_time or has_sent) or self.deadlines.expects(Awaited.PONG):
            return False
        self._next_ping = None
        self.deadlines.expect(Awaited.PONG, now + RESPONSE_LIMIT)
        return True

    def pong_received(self, pong: Pong, is_speaking: bool, now: float) -> None:
        self.deadlines.met(Awaited.PONG)
        self.deadlines.heartbeat(pong.frames, pong.is_playing, now)
        if is_speaking or pong.is_playing:
            self._next_ping = now + PING_INTERVAL

    def next_at(self) -> float | None:
        """When to check it again."""
        times = (self.deadlines.next_at(), self._next_ping)
        return min((time for time in times if time is not None), default=None)


class FailureCounter:
    """Counts failures; three in a minute are too many."""

    def __init__(self) -> None:
        self._times: deque[float] = deque(maxlen=MOST_FAILURES)

    def add(self, now: float) -> bool:
        """One more at ``now``. True if it is time to give up."""
        self._times.append(now)
        return len(self._times) == MOST_FAILURES and now - self._times[0] <= FAILURE_WINDOW
