"""Whose belt is felt, and the belt in words for those who have none: on request, or whenever it changes.

Of several robots in a world only the one that is talked to is felt.
"""

from __future__ import annotations

from collections.abc import Callable

from donnie_tui.core.belt import OFF, BeltSettings, Levels, in_words, rows_in_words
from donnie_tui.core.events import Announced, BeltShown, RunEnded, Stamped
from donnie_tui.core.team import Team
from donnie_tui.core.wording import Wording


class ChosenBelt:
    """A listener that shows the chosen robot's levels, and none once its run is over, whatever happened."""

    def __init__(self, chosen: Callable[[], str | None], show: Callable[[Levels], None]) -> None:
        """``chosen``: the robot's name as its events have it, None where there is but one."""
        self._chosen = chosen
        self._show = show
        self._levels: dict[str | None, Levels] = {}
        self._shown = OFF

    def __call__(self, stamped: Stamped) -> None:
        match stamped.event:
            case BeltShown(levels=levels):
                self._levels[stamped.robot] = levels
            case RunEnded():
                self._levels[stamped.robot] = OFF
            case _:
                pass
        levels = self._levels.get(self._chosen(), OFF)
        if levels != self._shown:
            self._shown = levels
            self._show(levels)


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
