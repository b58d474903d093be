"""Stepping back through what happened, on the map and in words, and coming back to now.

Nothing is undone in the world: whatever is done next is done from where the robot really is.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from donnie_tui.core.timeline import Timeline
from donnie_tui.tui.running import Answer, Doing

if TYPE_CHECKING:
    from donnie_tui.tui.workbench import Workbench


class Past:
    """The moment that the map shows."""

    def __init__(self, work: Workbench) -> None:
        self._work = work
        self._timeline: Timeline | None = None
        """None while it shows the present."""

    def step_back(self) -> None:
        """Show what was before: where everything was, and what is undone, in words."""
        work = self._work
        if work.running.doing not in (Doing.READY, Doing.PAUSED):
            work.talk.tell(Answer("screen-busy"))
            return
        is_now = self._timeline is None
        timeline = self._timeline = self._timeline or work.donnie.chronicle.timeline()
        told = work.running.told_back(timeline, is_now=is_now)
        work.display.show_past(timeline)
        work.talk.tell_sentences(*told)

    def to_present(self) -> None:
        """Whatever is done now is done from where the robot really is."""
        if self._timeline is not None:
            self._timeline.go_to(len(self._timeline))
            self._work.display.show_past(self._timeline)
            self._timeline = None

    def forget(self) -> None:
        """Another robot is talked to: it has a past of its own, and the map shows now."""
        self._timeline = None
        self._work.display.show_past(self._work.donnie.chronicle.timeline())
