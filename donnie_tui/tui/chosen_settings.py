"""A setting that somebody chooses counts at once, in what is shown and what is heard, and is kept."""

from __future__ import annotations

from typing import TYPE_CHECKING

from donnie_tui.tui.intake import CALM, FRAME, Intake
from donnie_tui.tui.preferences import AUDIBLE
from donnie_tui.tui.running import Answer
from donnie_tui.words.sound_words import tell_what_is_missing

if TYPE_CHECKING:
    from donnie_tui.tui.application import Host
    from donnie_tui.tui.while_typing import WhileTyping
from donnie_tui.tui.workbench import Workbench


class ChosenSettings:
    """Brings the work up to the preferences."""

    def __init__(self, work: Workbench, host: Host, intake: Intake, typing: WhileTyping) -> None:
        self._work = work
        self._host = host
        self._intake = intake
        self._typing = typing
        self._offer_words()
        self._pace_motion()

    def prefer(self, key: str, typed: object) -> None:
        """Choose a setting from now on, and keep it."""
        work, preferences = self._work, self._work.preferences
        value = ("on" if typed else "off") if isinstance(typed, bool) else str(typed)
        if not preferences.understands(key, value):
            work.talk.tell(Answer(f"setting-{key}-wanted"))
            return
        preferences.choose(key, value)
        self._apply(key)
        problem = preferences.keep(key)
        told = next(each for each in preferences.all if each.key == key).told(work.words)
        work.talk.tell(Answer("setting-row", {"name": work.words(f"setting-{key}"), "value": told}))
        tell_what_is_missing(work.donnie, key)
        if problem is not None:
            work.talk.tell(Answer(problem.code, {"path": problem.path, "reason": problem.reason}))

    def _apply(self, key: str) -> None:
        work, settings = self._work, self._work.preferences.settings
        if key == "lang":
            work.words.language = settings.language
            work.display.relabel()
            self._typing.check_now()
        elif key == "verbosity":
            work.words.detail = settings.verbosity
        elif key == "speed":
            work.donnie.session.speed = settings.speed
        elif key in AUDIBLE:
            work.donnie.outlets.adjust_sound(**{key: getattr(settings, key)})
        elif key == "completion":
            self._offer_words()
        elif key == "motion":
            self._pace_motion()
        self._host.wear(settings)
        work.look()

    def _offer_words(self) -> None:
        wanted = self._work.preferences.settings.completion
        self._work.workplace.editor.complete = self._typing.completion if wanted else None

    def _pace_motion(self) -> None:
        is_calm = self._work.preferences.settings.motion == "reduced"
        self._intake.frame = CALM if is_calm else FRAME
