"""Whose belt is felt: of several robots in a world only the one that is talked to."""

from __future__ import annotations

from collections.abc import Callable

from donnie_tui.core.belt import OFF, Levels
from donnie_tui.core.events import BeltShown, RunEnded, Stamped


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
