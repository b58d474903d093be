"""Detects a program that keeps its turn too long while the other robots wait, and reports it.

The order of turns is correct, but a blind learner can't know why nothing happens. The report is made once for
each run, as an answer. It is no part of the recorded stream, since it depends on the machine's speed.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from time import monotonic
from typing import TypeAlias

from donnie_tui.core.events import Answered, RunStarted, Stamped
from donnie_tui.core.team import Team
from donnie_tui.core.wording import Wording
from language.control import ControlState

LONGEST_TURN = 3.0
"""Seconds of real time that a program may keep its turn without a report."""
CHECK_INTERVAL = 0.5
"""Seconds between two checks, while any program runs."""

_AT_REST = (ControlState.PAUSING, ControlState.PAUSED, ControlState.STOPPING, ControlState.ENDED)
"""States without a report: a learner who pauses or stops a program knows why nothing happens."""

Turn: TypeAlias = tuple[str, float]
"""The robot whose turn it is while others wait, and the world's time."""


class TurnMonitor:
    """Checks whether the turn changes: ``check`` once, in any thread; ``watch`` in the background."""

    def __init__(
        self,
        team: Team,
        turn: Callable[[], Turn | None],
        wording: Wording,
        *,
        is_excused: Callable[[], bool] = lambda: False,
        now: Callable[[], float] = monotonic,
    ) -> None:
        """``turn`` returns None while no robot waits. ``is_excused``: the reason is known, such as a
        voice."""
        self._team, self._turn, self._say = team, turn, wording
        self._is_excused, self._now = is_excused, now
        self._seen: Turn | None = None
        self._since = 0.0
        self._reported: set[str] = set()
        """Robots whose runs were reported."""
        self._lock = threading.Lock()
        self._is_watching = False
        self._closed = threading.Event()

    def watch(self) -> None:
        """Starts checking whenever programs run."""
        self._team.stream.subscribe(self._on_event)

    def close(self) -> None:
        self._closed.set()

    def check(self) -> None:
        """Reports a program that has kept its turn for a while."""
        turn = None if self._is_excused() else self._turn()
        if turn is None or turn != self._seen or self._rests(turn[0]):
            self._seen, self._since = turn, self._now()
            return
        name = turn[0]
        if self._now() - self._since >= LONGEST_TURN and name not in self._reported:
            self._reported.add(name)
            self._team.chosen.hub.publish(Answered(self._say("holds-up", name=name)))

    def _rests(self, name: str) -> bool:
        run = self._team.session(name).run
        return run is None or run.control.state in _AT_REST

    def _on_event(self, stamped: Stamped) -> None:
        """Called in the thread of the program that begins."""
        if not isinstance(stamped.event, RunStarted):
            return
        with self._lock:
            self._reported.discard(stamped.event.robot)
            if self._is_watching or self._closed.is_set():
                return
            self._is_watching = True
        threading.Thread(target=self._check_repeatedly, name="turn monitor", daemon=True).start()

    def _check_repeatedly(self) -> None:
        while not self._closed.wait(CHECK_INTERVAL):
            with self._lock:
                if not self._team.running:
                    self._is_watching = False
                    self._seen = None
                    return
            self.check()
