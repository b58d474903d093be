"""The start of the full screen: a greeting at once, then the session, then the first file.

The first frame waits for nothing. Long tasks run in the background and are reported. Keys that are
typed meanwhile wait until the session can take them.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import TYPE_CHECKING

from textual.app import App
from textual.timer import Timer

from donnie_tui.commands.interaction import SLOW
from donnie_tui.commands.keys import KeyTable
from donnie_tui.i18n.first_words import early
from donnie_tui.settings.parsing import is_far
from donnie_tui.settings.settings import Settings
from donnie_tui.tui.environment import first_steps, is_page, with_keys
from donnie_tui.tui.screens.main_screen import MainScreen

if TYPE_CHECKING:
    from donnie_tui.bootstrap import Donnie
    from donnie_tui.core.recovery import UnsavedCopy
    from donnie_tui.robot.search import Search
    from donnie_tui.tui.controller import ScreenController, ScreenState

_TITLES = ("pane-program-empty", "pane-map-empty", "pane-inspector", "pane-log")
"""Titles of the panes, before there is a program and a world."""


class SessionHandle:
    """The screen's reference to the session: empty first, then assembled, then with its controller.

    Keys, signals and faults may come before there is a session. What stops the robots works in any thread.
    """

    def __init__(
        self, search: Search | None, typed: Callable[[], str] = str, copies: Path | None = None
    ) -> None:
        """``search`` gives up the first search for a robot, if there is one.

        ``typed`` is the program that was typed before there is a session; it is kept in ``copies``.
        """
        self._search, self._typed, self._copies = search, typed, copies
        self._copy: UnsavedCopy | None = None
        """The copy of the text typed before there was a session, once it was written."""
        self.assembled: Donnie | None = None
        """Kept so that ``close`` also ends it if the learner leaves before there is a controller."""
        self.controller: ScreenController | None = None
        """None until it is loaded."""
        self.is_leaving = False
        """Whether a signal came. From then on keys write text and run no command."""

    @property
    def runs(self) -> bool:
        """Whether any robot has something to stop."""
        controller = self.controller
        return controller is not None and (
            controller.ctx.runs.is_busy or bool(controller.donnie.team.running)
        )

    @property
    def next_world(self) -> str:
        """The world in which the screen opens again; empty if it does not."""
        return self.controller.next_world if self.controller is not None else ""

    @property
    def left_for_linear(self) -> bool:
        return self.controller is not None and self.controller.left_for_linear

    def give_up_search(self) -> bool:
        """Cancel the search for a robot; True if there was one."""
        controller = self.controller
        search = controller.donnie.connection.search if controller is not None else self._search
        return search is not None and search.give_up()

    def halt(self) -> None:
        """Stop all robots, and cancel the search for one."""
        self.give_up_search()
        if self.controller is not None:
            self.controller.ctx.runs.note_stop()
            self.controller.donnie.team.stop()

    def stop_real_robot(self) -> bool:
        """Stop a real robot; True if it was driving."""
        return self.controller is not None and self.controller.donnie.stop_real_robot()

    def point(self, words: str) -> None:
        """Speak words about the pointed square or row."""
        if self.controller is not None:
            self.controller.point(words)

    def say(self, code: str, **values: object) -> None:
        """Answer with a sentence of the catalogue."""
        if self.controller is not None:
            self.controller.ctx.answer(code, **values)

    def keep_text(self) -> None:
        """Write the unsaved copies, for the next start."""
        if self.controller is not None:
            self.controller.workspace.write_copies()
            if self._copy is not None:
                self._copy.want_none()
                self._copy.write_quietly()
            self.controller.donnie.rescue_world()
        elif self._copies is not None and (text := self._typed()).strip():
            from donnie_tui.core.recovery import CopyFolder, UnsavedCopy

            if self._copy is None:
                self._copy = UnsavedCopy(CopyFolder(str(self._copies)))
            self._copy.want(text if text.endswith("\n") else f"{text}\n")
            self._copy.write_quietly()

    def code_at_end(self, code: int, report: Callable[[str], object]) -> int:
        """See ``Donnie``; after ``close``."""
        donnie = self.controller.donnie if self.controller is not None else self.assembled
        return code if donnie is None else donnie.code_at_end(code, report)

    def close(self) -> None:
        """End the session, after the screen has closed."""
        if self.controller is not None:
            self.controller.close()
        elif self.assembled is not None:
            self.assembled.close()


class Startup:
    """Loads the session after the empty screen is shown."""

    def __init__(
        self,
        app: App[int],
        session: SessionHandle,
        place: MainScreen,
        settings: Settings,
        *,
        search: Search | None,
        assemble: Callable[[], Donnie],
        start_controller: Callable[[Donnie], object],
        release_keys: Callable[[], None],
    ) -> None:
        """``start_controller`` takes the result of ``assemble``; ``release_keys`` releases waiting keys.

        ``search`` gives up the search for a robot, if ``assemble`` looks for one.
        """
        self._app, self._session, self._place, self._settings = app, session, place, settings
        self._search, self._assemble = search, assemble
        self._start_controller, self._release_keys = start_controller, release_keys
        self.is_opening = False
        """While the first file is read."""
        self.trouble: Exception | None = None
        """The reason why the session could not be loaded."""
        self._was_slow = False
        """Whether a slow world was reported, so that its end is reported, too."""
        self._greeting: tuple[str, ...] = ()
        """The sentences shown before there was a voice."""

    @property
    def holds_keys(self) -> bool:
        """Whether keys wait: until the session is loaded and the first file is read."""
        return self._session.controller is None or self.is_opening

    def greet(self, key_table: KeyTable, restored: ScreenState | None = None) -> None:
        """Show the titles, and the keys or the log of the world before."""
        language, place = self._settings.language, self._place
        for pane, code in zip(place.panes, _TITLES, strict=True):
            pane.entitle(early(code, language))
        place.status.say(f" {early('status-starting', language)}")
        if restored is not None:
            place.log_rows.looks.update(restored.looks)
            place.log_lines(restored.log)
            return
        title, steps = first_steps(language, key_table)
        place.editor.show_first_steps(steps)
        if place.is_small:
            place.program_pane.entitle(title)
        about_keys = with_keys("screen-start-keys", language, key_table)
        self._greeting = (early("screen-start-page" if is_page() else "screen-start", language), about_keys)
        place.log_lines((line, "") for line in self._greeting)

    # --- the session

    def begin(self) -> None:
        """Load the session. The caller reports a failure, on the normal screen."""
        try:
            if self._search is None and self._has_shipped_world:
                self._use(self._assemble())
            else:
                if is_far(self._settings.robot):  # of a configuration file that is not known yet
                    self._report_search()
                self._app.run_worker(self._search_and_begin())
        except Exception as trouble:  # noqa: BLE001 -- raised again once the terminal is given back
            self._fail(trouble)

    async def _search_and_begin(self) -> None:
        """Search for a robot, which takes some seconds and can be given up, and load the session.

        A learner's own world may be large and load slowly.
        """
        slowly = self._app.set_timer(SLOW, self._report_world)
        if self._search is not None:
            loop = asyncio.get_running_loop()
            self._search.on_slow = lambda: loop.call_soon_threadsafe(self._print, "connect-waiting")
        try:
            await asyncio.to_thread(self._assemble_and_keep)
            slowly.stop()
            if self._session.assembled is not None:
                self._use(self._session.assembled)
        except Exception as trouble:  # noqa: BLE001 -- as above
            self._fail(trouble)

    def _assemble_and_keep(self) -> None:
        self._session.assembled = self._assemble()

    def _use(self, donnie: Donnie) -> None:
        donnie.outlets.audible.say_printed(*self._greeting)
        self._start_controller(donnie)
        self._release_waiting_keys()
        if self._was_slow:
            donnie.say("slow-world-done", name=self._world_name)
        self._app.call_after_refresh(donnie.get_ready_to_move)

    def _fail(self, trouble: Exception) -> None:
        self.trouble = trouble
        self._app.exit(2)

    @property
    def _has_shipped_world(self) -> bool:
        """Whether the world is built in and compiled, so that it loads at once."""
        import worlds

        return self._settings.world in worlds.names()

    # --- reports

    def _report_search(self) -> None:
        if self._search is not None:
            self._print("connect-trying")

    def _report_world(self) -> None:
        if self._search is None:
            self._print("slow-world", name=self._world_name)
            self._was_slow = True

    @property
    def _world_name(self) -> str:
        return Path(self._settings.world).name

    def _print(self, code: str, **values: object) -> None:
        """Print a sentence; there is no voice without a session."""
        from donnie_tui.i18n.words import Words

        words = Words(self._settings.language, self._settings.verbosity)
        sentence = words(code, **values)
        self._place.log_lines([(sentence, "")])
        self._place.status.say(f" {sentence}")

    # --- the first file

    def open_with(self, opening: Coroutine[None, None, None]) -> None:
        """Read the first file. Keys wait for it, but not for a slow one."""
        self.is_opening = True
        slowly = self._app.set_timer(SLOW, self._opened)
        self._app.run_worker(self._open(opening, slowly), group="opening")

    async def _open(self, opening: Coroutine[None, None, None], slowly: Timer) -> None:
        await opening
        slowly.stop()
        if self._session.controller is not None:
            self._session.controller.display.update()
        self._opened()

    def _opened(self) -> None:
        if self.is_opening:
            self.is_opening = False
            self._release_waiting_keys()

    def _release_waiting_keys(self) -> None:
        if not self.holds_keys:
            self._release_keys()
