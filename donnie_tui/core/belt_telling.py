"""The belt in words, for those who have none: on request, or whenever what it shows has changed."""

from __future__ import annotations

from donnie_tui.core.belt import OFF, BeltSettings, Levels, in_words, rows_in_words
from donnie_tui.core.belt_watching import ChosenBelt
from donnie_tui.core.events import Announced
from donnie_tui.core.team import Team
from donnie_tui.core.wording import Wording


class BeltTelling:
    """Listens to the belt's events. ``is_on``: every change is told."""

    def __init__(self, team: Team, wording: Wording, settings: BeltSettings | None = None) -> None:
        self.is_on = False
        self._team = team
        self._say = wording
        self._settings = settings
        self._levels = OFF
        self._told = ""
        team.stream.subscribe(ChosenBelt(lambda: team.chosen.hub.robot, self._hear))

    def now(self) -> str:
        """What the belt shows."""
        return in_words(self._levels, self._say, self._settings)

    def rows(self) -> tuple[str, ...]:
        """What it shows, then both rows of motors, each with its level."""
        return (self.now(), *rows_in_words(self._levels, self._say))

    def _hear(self, levels: Levels) -> None:
        """Strikes and what is felt again between them say the same: that is told once."""
        self._levels = levels
        words = self.now()
        if self.is_on and words != self._told:
            self._team.chosen.hub.publish(Announced("belt", words))
        self._told = words
