"""How the full screen begins: a greeting at once, then the session behind it, then the first file.

Rules: the first frame waits for nothing; what takes long is done beside the screen and told; keys that are
typed meanwhile wait for what they are meant for.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import TYPE_CHECKING

from textual.app import App

from donnie_tui.commands.interaction import SLOW
from donnie_tui.commands.keys import KeyTable
from donnie_tui.i18n.first_words import early
from donnie_tui.robot.search import Search
from donnie_tui.settings.parsing import SERIAL
from donnie_tui.settings.settings import Settings
from donnie_tui.tui.screens.workplace import Workplace
from donnie_tui.tui.session_behind import SessionBehind

if TYPE_CHECKING:
    from donnie_tui.bootstrap import Donnie
    from donnie_tui.tui.brought import Brought
    from donnie_tui.tui.work import Work


_TITLES = ("pane-program-empty", "pane-map-empty", "pane-inspector", "pane-log")
"""Of the panes, before there is a program and a world."""


class Beginning:
    """From the empty screen to the learner's work."""

    def __init__(
        self,
        app: App[int],
        behind: SessionBehind,
        place: Workplace,
        settings: Settings,
        *,
        search: Search | None,
        assemble: Callable[[], Donnie],
        work_with: Callable[[Donnie], Work],
        let_keys: Callable[[], None],
    ) -> None:
        """``work_with`` begins the work with what ``assemble`` made; ``let_keys`` lets those go on that wait.

        ``search``: what gives up the search for a robot, where ``assemble`` looks for one.
        """
        self._app, self._behind, self._place, self._settings = app, behind, place, settings
        self._search, self._assemble = search, assemble
        self._work_with, self._let_keys = work_with, let_keys
        self._is_searching = False
        self.is_opening = False
        """While the first file is read."""
        self.trouble: Exception | None = None
        """What kept the work from being loaded."""
        self._was_slow = False
        """Whether it was told that the world takes a while: then it is told when it is there."""
        self._greeting: tuple[str, ...] = ()
        """What was shown before there was a voice."""

    @property
    def holds_keys(self) -> bool:
        """While a robot is looked for, or the first file is read: what is typed then waits."""
        return self._is_searching or self.is_opening

    def greet(self, key_table: KeyTable, brought: Brought | None = None) -> None:
        """The titles, and which keys there are; or what was told in the world before."""
        language, place = self._settings.language, self._place
        for pane, code in zip(place.panes, _TITLES, strict=True):
            pane.entitle(early(code, language))
        place.status.say(f" {early('status-starting', language)}")
        if brought is not None:
            place.log_rows.looks.update(brought.looks)
            place.log_lines(brought.log)
            return
        named = (("run", "RUN"), ("help", "HELP"))
        keys = {name: key_table.label(name, language) or word for name, word in named}
        about_keys = early("screen-start-keys", language).format(**keys)
        self._greeting = (early("screen-start", language), about_keys)
        place.log_lines((line, "") for line in self._greeting)

    # --- the session

    def begin(self) -> None:
        """The screen is there; now what it shows. A failure is told by the caller, on the normal screen."""
        try:
            if self._search is None and self._has_shipped_world:
                self._begin_work(self._assemble())
            else:
                self._is_searching = True
                if self._settings.robot.startswith(SERIAL):  # of a configuration file nobody knows that yet
                    self._tell_of_search()
                self._app.run_worker(self._search_and_begin())
        except Exception as trouble:  # noqa: BLE001 -- raised again once the terminal is given back
            self._fail(trouble)

    async def _search_and_begin(self) -> None:
        """Looking for a robot takes some seconds, in which the keys that give it up are heard.

        A learner's own world may be large, and takes as long as it takes.
        """
        slowly = self._app.set_timer(SLOW, self._tell_of_world)
        if self._search is not None:
            loop = asyncio.get_running_loop()
            self._search.on_slow = lambda: loop.call_soon_threadsafe(self._tell_early, "connect-waiting")
        try:
            await asyncio.to_thread(self._assemble_and_keep)
            slowly.stop()
            if self._behind.found is not None:
                self._begin_work(self._behind.found)
        except Exception as trouble:  # noqa: BLE001 -- as above
            self._fail(trouble)
        self._is_searching = False
        self._let_waiting_keys()

    def _assemble_and_keep(self) -> None:
        self._behind.found = self._assemble()

    def _begin_work(self, donnie: Donnie) -> None:
        donnie.outlets.audible.say_printed(*self._greeting)
        work = self._work_with(donnie)
        if self._was_slow:
            work.talk.tell_sentences(work.words("slow-world-done", name=self._world_name))
        self._app.call_after_refresh(donnie.get_ready_to_move)

    def _fail(self, trouble: Exception) -> None:
        self.trouble = trouble
        self._app.exit(2)

    @property
    def _has_shipped_world(self) -> bool:
        """Those are ready to be read: no time passes."""
        import worlds

        return self._settings.world in worlds.names()

    # --- what takes long is told

    def _tell_of_search(self) -> None:
        if self._search is not None:
            self._tell_early("connect-trying")

    def _tell_of_world(self) -> None:
        if self._search is None:
            self._tell_early("slow-world", name=self._world_name)
            self._was_slow = True

    @property
    def _world_name(self) -> str:
        return Path(self._settings.world).name

    def _tell_early(self, code: str, **values: object) -> None:
        """In print alone: there is no voice before there is a session."""
        from donnie_tui.i18n.words import Words

        words = Words(self._settings.language, self._settings.verbosity)
        sentence = words(code, **values)
        self._place.log_lines([(sentence, "")])
        self._place.status.say(f" {sentence}")

    # --- the first file

    def open_with(self, opening: Coroutine[None, None, None]) -> None:
        """Keys are for what is opened; where that takes long, they are for what there is."""
        self.is_opening = True
        self._app.set_timer(SLOW, self._opened)
        self._app.run_worker(self._open(opening), group="opening")

    async def _open(self, opening: Coroutine[None, None, None]) -> None:
        await opening
        if self._behind.work is not None:
            self._behind.work.look()
        self._opened()

    def _opened(self) -> None:
        if self.is_opening:
            self.is_opening = False
            self._let_waiting_keys()

    def _let_waiting_keys(self) -> None:
        if not self.holds_keys:
            self._let_keys()
