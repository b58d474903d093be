"""Programs that nobody waits for and that tell nothing: that they have ended is told (L25)."""

from __future__ import annotations

from collections.abc import Iterable

from donnie_tui.bootstrap import Donnie
from donnie_tui.core.events import Outcome, RunEnded, Stamped
from donnie_tui.core.transcript import said_by, told_lines


class SilentEnds:
    """Listens from before they begin until the last of them is over."""

    def __init__(self, donnie: Donnie, robots: Iterable[str | None]) -> None:
        """``robots``: whose programs begin, by the names in their events."""
        self._donnie = donnie
        self._running = set(robots)
        self._silent = set(self._running)
        self._leave = donnie.session.hub.subscribe(self._hear)

    def close(self) -> None:
        """None of them begins."""
        self._leave()

    def _hear(self, stamped: Stamped) -> None:
        """Any thread's."""
        if stamped.robot not in self._running:
            return
        if isinstance(stamped.event, RunEnded):
            self._end(stamped.robot, stamped.event.outcome)
        elif told_lines(stamped, self._donnie.words):
            self._silent.discard(stamped.robot)

    def _end(self, robot: str | None, outcome: Outcome) -> None:
        self._running.discard(robot)
        if robot in self._silent and outcome is Outcome.COMPLETED:
            words = self._donnie.words
            self._donnie.tell(said_by(robot, words("linear-done"), words))
        if not self._running:
            self._leave()
