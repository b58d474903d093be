"""Who holds the others up: a program that computes without end keeps its turn, and all other robots wait.

Nothing is wrong with the order; but who hears nothing can't know why nothing happens. Rule: told once for
each run, as an answer, which is no part of the stream: how long a machine computes is no event.
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

PATIENCE = 3.0
"""Seconds of real time."""
GLANCE = 0.5
"""Seconds between two looks, while anybody runs."""

_AT_REST = (ControlState.PAUSING, ControlState.PAUSED, ControlState.STOPPING, ControlState.ENDED)
"""Whoever pauses or stops a program knows why nothing happens."""

Turn: TypeAlias = tuple[str, float]
"""Whose turn it is while others wait, and the time that the world has come to."""


class HoldingUp:
    """Looks whether the turn goes on. ``look`` may be called by anybody; ``watch`` calls it in a thread."""

    def __init__(
        self,
        team: Team,
        turn: Callable[[], Turn | None],
        wording: Wording,
        *,
        is_excused: Callable[[], bool] = lambda: False,
        now: Callable[[], float] = monotonic,
    ) -> None:
        """``turn`` is None where nobody waits; ``is_excused``: what all wait for is known, a voice say."""
        self._team, self._turn, self._say = team, turn, wording
        self._is_excused, self._now = is_excused, now
        self._seen: Turn | None = None
        self._since = 0.0
        self._told: set[str] = set()
        """Whose runs were told of."""
        self._lock = threading.Lock()
        self._is_watching = False
        self._closed = threading.Event()

    def watch(self) -> None:
        """From now on, whenever several robots may run."""
        self._team.stream.subscribe(self._hear)

    def close(self) -> None:
        self._closed.set()

    def look(self) -> None:
        """Tell who has held the others up for a while."""
        turn = None if self._is_excused() else self._turn()
        if turn is None or turn != self._seen or self._rests(turn[0]):
            self._seen, self._since = turn, self._now()
            return
        name = turn[0]
        if self._now() - self._since >= PATIENCE and name not in self._told:
            self._told.add(name)
            self._team.chosen.hub.publish(Answered(self._say("holds-up", name=name)))

    def _rests(self, name: str) -> bool:
        run = self._team.session(name).run
        return run is None or run.control.state in _AT_REST

    def _hear(self, stamped: Stamped) -> None:
        """In the thread of the program that begins."""
        if not isinstance(stamped.event, RunStarted):
            return
        with self._lock:
            self._told.discard(stamped.event.robot)
            if self._is_watching or self._closed.is_set():
                return
            self._is_watching = True
        threading.Thread(target=self._look_on, name="holding up", daemon=True).start()

    def _look_on(self) -> None:
        while not self._closed.wait(GLANCE):
            with self._lock:
                if not self._team.running:
                    self._is_watching = False
                    self._seen = None
                    return
            self.look()
