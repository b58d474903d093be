"""The application as the work sees it: time, questions, other screens, and the ways out.

Rule: what is asked is said too, by ``point``. Other screens are loaded when they are first shown.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine, Sequence
from typing import TYPE_CHECKING, TypeVar

from textual.app import App, SuspendNotSupported
from textual.geometry import Offset
from textual.message import Message
from textual.screen import Screen
from textual.timer import Timer

from donnie_tui.commands.keys import KeyTable
from donnie_tui.settings.settings import Settings
from donnie_tui.tui.coming import Coming
from donnie_tui.tui.screens.workplace import Workplace

if TYPE_CHECKING:
    from donnie_tui.commands.interaction import Option
    from donnie_tui.tui.answer import Answer
    from donnie_tui.tui.screens.pages import Page


T = TypeVar("T")


class ScreenHost:
    """``application.Host`` of the work. ``next_world`` and ``left_for_linear`` tell how it was left."""

    def __init__(
        self,
        app: App[int],
        workplace: Workplace,
        key_table: KeyTable,
        *,
        begin_with: Callable[[Coroutine[None, None, None]], None],
        wear: Callable[[Settings], None],
        repaint: Callable[[], None],
        point: Callable[[str], None],
        coming: Coming,
    ) -> None:
        self._app = app
        self.workplace, self.key_table = workplace, key_table
        self.begin_with, self.wear, self.repaint = begin_with, wear, repaint
        self._point, self._coming = point, coming
        self.next_world = ""
        """The world in which the screen is to come back."""
        self.left_for_linear = False

    def post_message(self, message: Message) -> bool:
        return self._app.post_message(message)

    def later(self, seconds: float, do: Callable[[], None]) -> Timer:
        return self._app.set_timer(seconds, do)

    def every(self, seconds: float, do: Callable[[], None]) -> Timer:
        return self._app.set_interval(seconds, do)

    # --- questions

    async def ask(
        self, asked: str, keys: str, value: str, accepts: Callable[[str], str | None] | None
    ) -> str | None:
        from donnie_tui.tui.screens.dialogs import Question

        question = Question(asked, keys, self._point, value=value, accepts=accepts)
        return await self._answer_of(question)

    async def press_key(
        self, asked: str, keys: str, behind: str, accepts: Callable[[str], str | None]
    ) -> str | None:
        from donnie_tui.tui.screens.pages import KeyCapture

        return await self._answer_of(KeyCapture(asked, keys, behind, accepts, self._point))

    async def choose(self, title: str, keys: str, nothing: str, choices: Sequence[Option]) -> str | None:
        from donnie_tui.tui.screens.dialogs import Chooser

        return await self._answer_of(Chooser(title, keys, nothing, choices, self._point))

    async def choose_word(self, words: Sequence[str], below: Offset) -> tuple[str, str]:
        from donnie_tui.tui.screens.dialogs import Completions

        return await self._answer_of(Completions(words, below, self._point))

    async def _answer_of(self, screen: Screen[T]) -> T:
        """A question that nobody waits for any more, since something else was asked for, goes away."""
        self._coming.call_for(screen)
        try:
            return await self._app.push_screen_wait(screen)
        except asyncio.CancelledError:
            if screen in self._app.screen_stack:
                screen.pop_until_active()
                screen.dismiss()
            raise
        finally:
            self._coming.gone(screen)

    # --- something to read

    def show_help(
        self, title: str, lines: tuple[str, ...], further: Callable[[], None] | None = None
    ) -> None:
        from donnie_tui.tui.screens.pages import Help

        self._read(Help(title, lines, self._point, further))

    def show_tour(self, pages: Sequence[Page], at: int, turned: Callable[[int], None]) -> None:
        from donnie_tui.tui.screens.pages import Tour

        self._read(Tour(pages, at, turned, self._point))

    def _read(self, page: Screen[None]) -> None:
        self._coming.call_for(page)
        self._app.push_screen(page)

    def show_outside(self, text: str) -> Answer | None:
        """In the terminal's pager; or why that is impossible."""
        from donnie_tui.tui.outside import NO_PAGER, show_in_pager

        try:
            with self._app.suspend():
                return show_in_pager(text)
        except SuspendNotSupported:
            return NO_PAGER

    # --- ways out

    def enter_world(self, name: str) -> None:
        """The screen is left for a moment, and comes back in that world."""
        self.next_world = name
        self._app.exit(0)

    def leave(self, code: int = 0, *, for_linear: bool = False) -> None:
        self.left_for_linear = for_linear
        self._app.exit(code)
