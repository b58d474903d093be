"""What happened lately: a listener that keeps the newest events, so that one can go back through them."""

from __future__ import annotations

from collections import deque

from devices.ports.hints import TYPE_CHECKING
from donnie_tui.core.events import TRANSIENT, Stamped

if TYPE_CHECKING:
    from donnie_tui.core.timeline import Timeline

MOST = 50_000
"""Events that are kept, the newest ones: a lesson has some thousands."""


class Chronicle:
    """Keeps what is not transient. Any thread may tell it, any may ask."""

    def __init__(self, most: int = MOST) -> None:
        self._events: deque[Stamped] = deque(maxlen=most)

    def __call__(self, stamped: Stamped) -> None:
        if not isinstance(stamped.event, TRANSIENT):
            self._events.append(stamped)

    @property
    def last_seq(self) -> int:
        """The number of the last event; 0 before any."""
        return self._events[-1].seq if self._events else 0

    def timeline(self) -> Timeline:
        """What is kept just now, seen from its end."""
        from donnie_tui.core.timeline import Timeline  # for who goes back

        timeline = Timeline(tuple(self._events.copy()))
        timeline.go_to(len(timeline))
        return timeline
