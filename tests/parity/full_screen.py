"""The full screen in this process. Each line typed in its command line has an ``Outcome``.

The only module of the net that knows how the full screen is put together.
"""

from __future__ import annotations

import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

from textual.pilot import Pilot
from textual.screen import Screen

from donnie_tui.bootstrap import assemble
from donnie_tui.core.run_state import RunState
from donnie_tui.settings.settings import Settings
from donnie_tui.tui.app import DonnieApp
from donnie_tui.tui.screens.dialogs import Chooser, Question
from donnie_tui.tui.screens.file_panel import FilePanel
from donnie_tui.tui.screens.pages import Help
from tests.parity.outcome import Outcome, Recorder
from tests.timeouts import TIMEOUT


class FullScreen:
    """An application without a terminal, and a typist at its command line."""

    def __init__(self, app: DonnieApp, pilot: Pilot[int]) -> None:
        assert app.controller is not None
        self._app, self._pilot = app, pilot
        self._recorder = Recorder(app.controller.donnie)

    async def begin(self) -> None:
        await self._wait_until_idle()
        self._recorder.take()

    async def prepare(self, *lines: str) -> None:
        """Type lines of which nothing is compared."""
        for line in lines:
            await self._enter(line)
            await self._leave_question()
        self._recorder.take()

    async def type(self, line: str) -> Outcome:
        """Type a line; where it leads to a question or a page, leave that without an answer."""
        await self._enter(line)
        published, left_for = self._recorder.take(), self._left_for
        asked, listed = ("", ()) if left_for else _in_front(self._app.screen)
        await self._leave_question()
        return Outcome(published, asked, listed, self._recorder.take(), left_for)

    async def _enter(self, line: str) -> None:
        command_line = self._app.main_screen.command_line
        command_line.value = line
        command_line.finish()
        await self._wait_until_idle()

    async def _leave_question(self) -> None:
        while self._app.screen is not self._app.main_screen and not self._left_for:
            await self._pilot.press("escape")
            await self._wait_until_idle()

    @property
    def _left_for(self) -> str:
        if self._app.session.next_world:
            return f"world {self._app.session.next_world}"
        if self._app.session.left_for_linear:
            return "other mode"
        return "" if self._app.is_running and not self._app._exit else "end"

    async def _wait_until_idle(self) -> None:
        """Return once the screen has nothing to do and no program is on its way to a hold or an end."""
        end = time.monotonic() + TIMEOUT
        while time.monotonic() < end:
            if self._app.startup.trouble is not None:
                raise self._app.startup.trouble
            if self._left_for:
                return
            await self._pilot.pause()
            if self._is_at_rest():
                await self._pilot.pause()
                if self._is_at_rest():
                    return
        raise AssertionError(f"the screen never came to rest: {self._app.main_screen.log_rows.lines[-9:]}")

    def _is_at_rest(self) -> bool:
        app = self._app
        if self._left_for:
            return True
        assert app.controller is not None
        is_asking = app.screen is not app.main_screen
        if not is_asking and any(not worker.is_finished for worker in app.workers):
            return False
        is_followed = (app.controller.ctx.runs.state is RunState.READY) == (
            app.controller.donnie.session.run is None
        )
        return is_followed and self._recorder.is_at_rest(app.controller.ctx.runs)


def _in_front(screen: Screen[object]) -> tuple[str, tuple[str, ...]]:
    """The question, or the title and the rows of a list or a page."""
    match screen:
        case Question() | FilePanel():
            return screen._asked, ()
        case Chooser():
            return screen._title_words, tuple(each.text for each in screen._choices)
        case Help():
            return screen._title_words, tuple(screen._lines)
        case _:
            return "", ()


@asynccontextmanager
async def full_screen(settings: Settings, text: str, folder: Path) -> AsyncIterator[FullScreen]:
    """A screen with the program ``text`` in its editor, which has not run yet."""
    app = DonnieApp(
        settings, None, text=text, assemble=lambda: assemble(settings, terminal=True), folder=folder
    )
    try:
        async with app.run_test(size=(80, 24)) as pilot:
            end = time.monotonic() + TIMEOUT
            while (
                (app.controller is None or app.startup.is_opening)
                and app.startup.trouble is None
                and time.monotonic() < end
            ):
                await pilot.pause()
            screen = FullScreen(app, pilot)
            await screen.begin()
            yield screen
    finally:
        app.session.close()
