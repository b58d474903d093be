"""The belt in words, for those who have none: on request, or whenever what it shows has changed."""

from __future__ import annotations

from donnie_tui.core.belt import OFF, in_words
from donnie_tui.core.events import Announced, BeltShown, Stamped
from donnie_tui.core.hub import Hub
from donnie_tui.core.wording import Wording


class BeltTelling:
    """Listens to the belt's events. ``is_on``: every change is told."""

    def __init__(self, hub: Hub, wording: Wording) -> None:
        self.is_on = False
        self._hub = hub
        self._say = wording
        self._levels = OFF
        self._told = ""
        hub.subscribe(self._hear)

    def now(self) -> str:
        """What the belt shows."""
        return in_words(self._levels, self._say)

    def _hear(self, stamped: Stamped) -> None:
        if isinstance(stamped.event, BeltShown):
            self._levels = stamped.event.levels
            self._tell()

    def _tell(self) -> None:
        """Strikes and what is felt again between them say the same: that is told once."""
        words = self.now()
        if self.is_on and words != self._told:
            self._hub.publish(Announced("belt", words))
        self._told = words
