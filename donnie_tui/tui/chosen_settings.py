"""Shows the session as the settings say, from the beginning and after each change."""

from __future__ import annotations

from typing import TYPE_CHECKING

from donnie_tui.settings.settings import Settings
from donnie_tui.tui.intake import CALM, FRAME, Intake

if TYPE_CHECKING:
    from donnie_tui.tui.application import Host
    from donnie_tui.tui.while_typing import WhileTyping
from donnie_tui.tui.workbench import Workbench


class ChosenSettings:
    """What settings change on the screen."""

    def __init__(self, work: Workbench, host: Host, intake: Intake, typing: WhileTyping) -> None:
        self._work = work
        self._host = host
        self._intake = intake
        self._typing = typing
        self._offer_words()
        self._pace_motion()

    @property
    def _settings(self) -> Settings:
        return self._work.ctx.preferences.settings

    def apply(self, key: str) -> None:
        """Show the session as the setting of that name says."""
        if key == "lang":
            self._work.display.relabel()
            self._typing.check_now()
        elif key == "completion":
            self._offer_words()
        elif key == "motion":
            self._pace_motion()
        self._host.wear(self._settings)
        self._work.look()

    def _offer_words(self) -> None:
        wanted = self._settings.completion
        self._work.workplace.editor.complete = self._typing.completion if wanted else None

    def _pace_motion(self) -> None:
        is_calm = self._settings.motion == "reduced"
        self._intake.frame = CALM if is_calm else FRAME
