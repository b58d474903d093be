"""The full screen for the commands: dialogs, pages in windows, and the panes."""

from __future__ import annotations

import asyncio
import os
from collections import Counter
from collections.abc import Callable, Coroutine, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from textual.app import SuspendNotSupported

from donnie_tui.bootstrap import Donnie
from donnie_tui.commands.context import Context
from donnie_tui.commands.declarations import BY_NAME
from donnie_tui.commands.files import may_lose_all
from donnie_tui.commands.interaction import MapPane, Option, answered
from donnie_tui.commands.keys import KeyTable
from donnie_tui.commands.lookup import word_of
from donnie_tui.commands.preferences import Preferences
from donnie_tui.core.map_scene import Line
from donnie_tui.core.map_words import Pointer
from donnie_tui.core.runner import RunRequest
from donnie_tui.core.session_log import AnswerLog
from donnie_tui.core.wording import spelled
from donnie_tui.core.workspace import Workspace
from donnie_tui.i18n.help import SCREEN_TOUR_PAGES, manual
from donnie_tui.i18n.words import Words
from donnie_tui.tui.controller import ScreenController
from donnie_tui.tui.environment import is_page, pager, run_pager
from donnie_tui.tui.keyboard import Dialogs
from donnie_tui.tui.pane_text import help_lines, help_text, keys_here, tour_pages
from donnie_tui.tui.run_view import Reminder
from donnie_tui.tui.screens.main_screen import MainScreen
from donnie_tui.tui.screens.pages import Help, KeyCapture, Tour, TourStrip
from donnie_tui.tui.terminal import TerminalApp
from donnie_tui.tui.widgets.command_line import CommandLine
from language.source import quoted

if TYPE_CHECKING:
    from pathlib import Path

    from donnie_tui.core.runner import Run

T = TypeVar("T")


def connect(
    app: TerminalApp,
    dialogs: Dialogs,
    place: MainScreen,
    key_table: KeyTable,
    donnie: Donnie,
    workspace: Workspace,
    preferences: Preferences,
) -> ScreenController:
    """Connect a session with the screen."""
    interaction = ScreenInteraction(app, dialogs, place, key_table, donnie.words)
    past = place.command_line.past
    ctx = Context(donnie, interaction, workspace, AnswerLog(), past, preferences, screen=interaction)
    interaction._controller = controller = ScreenController(app, place, key_table, ctx)
    return controller


class ScreenInteraction:
    """``commands.interaction.Interaction`` and ``Screen`` of the application.

    A question begins with ``asyncio.sleep(0)``: a command runs at once up to its first question, and the
    rest of it in a worker, which Textual needs for a dialog. Everything shown is also spoken.
    """

    can_edit = is_attended = True

    def __init__(
        self, app: TerminalApp, dialogs: Dialogs, place: MainScreen, key_table: KeyTable, words: Words
    ) -> None:
        self._app, self._dialogs, self._place, self._words = app, dialogs, place, words
        self.key_table = key_table
        self._controller: ScreenController
        self._finishing = asyncio.Lock()
        self._tour_page = 0
        """The page on which the learner left the tour, from 0."""

    # --- questions

    async def ask(
        self,
        question: str,
        text: str = "",
        accepts: Callable[[str], str | None] | None = None,
    ) -> str | None:
        return await self._typed_answer(question, text, accepts) or None

    async def _typed_answer(
        self,
        question: str,
        text: str,
        accepts: Callable[[str], str | None] | None,
        answers: Sequence[str] = (),
    ) -> str | None:
        """None after Esc; empty after Enter alone. In the plain layout there is no list to be read out."""
        from donnie_tui.tui.screens.dialogs import Question

        await asyncio.sleep(0)
        listed = () if self._place.is_plain else answers
        keys, point = self._words("ask-keys-list" if listed else "ask-keys"), self._controller.point
        asked = Question(question, keys, point, value=text, accepts=accepts, answers=listed)
        return await self._dialogs.answer_of(asked)

    async def ask_file(
        self, question: str, text: str, recent: Callable[[], Sequence[Path]], *, is_new: bool = False
    ) -> str | Path | None:
        if self._place.is_plain:
            return await self.ask(question, text)
        from donnie_tui.tui.screens.file_panel import FilePanel

        await asyncio.sleep(0)
        panel = FilePanel(
            question,
            text,
            recent,
            self._words,
            self._controller.point,
            checking=self._dialogs.checking,
            is_new=is_new,
        )
        return await self._dialogs.answer_of(panel) or None

    async def choose(
        self,
        question: str,
        options: Sequence[Option],
        printed: Sequence[str] = (),  # noqa: ARG002 -- for front ends without lists
    ) -> str | None:
        """Options with the same text are one row."""
        from donnie_tui.tui.screens.dialogs import Chooser

        rows = {each.text: each for each in reversed(options)}
        listed = [each for each in options if rows[each.text] is each]
        await asyncio.sleep(0)
        keys, nothing = self._words("chooser-keys"), self._words("palette-nothing")
        is_plain, point = self._place.is_plain, self._controller.point
        return await self._dialogs.answer_of(
            Chooser(question, keys, nothing, listed, point, is_plain=is_plain)
        )

    async def press_key(self, question: str, accepts: Callable[[str], str | None]) -> str | None:
        await asyncio.sleep(0)
        keys, after_menu = self._words("keys-capture"), self._words("keys-second-key")
        capture = KeyCapture(question, keys, after_menu, accepts, self._controller.point)
        return await self._dialogs.answer_of(capture)

    async def confirm(self, question: str) -> bool | None:
        def unclear(typed: str) -> str | None:
            is_clear = not typed.strip() or answered(typed) is not None
            return None if is_clear else f"{self._words('yes-or-no')} {question}"

        answers = tuple(spelled(each, self._words.language, "answers") for each in ("yes", "no"))
        typed = await self._typed_answer(question, "", unclear, answers)
        return None if typed is None else bool(answered(typed))

    async def edit_line(self, question: str, text: str = "") -> str | None:
        return await self.ask(question, text)

    async def show_pages(
        self,
        title: str,
        lines: Sequence[str],
        printed: Sequence[str] | None = None,  # noqa: ARG002 -- for front ends without windows
    ) -> None:
        self._open_page(title, lines)

    # --- time

    async def background(
        self,
        task: Callable[[], T],
        slow: str,
        *,
        may_be_left: bool = False,
        is_slow: bool = False,
    ) -> T:
        """If the learner runs another command meanwhile, the log says that nothing changed."""
        del may_be_left
        await asyncio.sleep(0)
        if is_slow:
            return await asyncio.to_thread(task)
        reminder = Reminder(self._app, lambda: self._controller.ctx.say(slow))
        try:
            return await asyncio.to_thread(task)
        except asyncio.CancelledError:
            self._controller.ctx.answer("answer-unchanged")
            raise
        finally:
            reminder.stop()

    async def finish(self, task: Coroutine[Any, Any, T]) -> T:
        await asyncio.sleep(0)
        return await asyncio.shield(asyncio.ensure_future(self._finish(task)))

    async def _finish(self, task: Coroutine[Any, Any, T]) -> T:
        async with self._finishing:
            return await task

    async def finished(self) -> None:
        if self._finishing.locked():
            await asyncio.sleep(0)
            async with self._finishing:
                pass

    async def follow(self, runs: Sequence[tuple[str | None, Run]]) -> bool:  # noqa: ARG002 -- the screen continues
        return False

    async def wait(self, seconds: float) -> bool:
        await asyncio.sleep(0)
        await asyncio.sleep(seconds)
        return False

    def print_soon(self) -> None:
        """The log shows every line at once."""

    def continue_on_enter(self, more: Callable[[], Coroutine[Any, Any, None]]) -> None:
        """Do nothing: the full screen shows pages as windows."""

    def setting_changed(self, key: str) -> None:
        self._controller.apply_setting(key)

    def before_robot_changes(self) -> None:
        """Let the current robot keep the text, if there is any."""
        text, path = self._place.editor.text, self._controller.workspace.document.path
        if text.strip():
            team, name = self._controller.donnie.team, path.name if path else self._words("new-program")
            team.give(team.chosen.name, RunRequest(text, name))

    def robot_changed(self) -> None:
        self._controller.run_view.robot_changed()

    async def type_again(self, line: str) -> None:
        again = self._controller.run_line(line)
        if again is not None:
            await asyncio.sleep(0)
            await again

    # --- ways out

    async def enter_world(self, name: str) -> None:
        self._controller.change_world(name)

    async def switch_mode(self) -> None:
        self._controller.switch_to_linear()

    async def quit(self) -> None:
        if await may_lose_all(self._controller.ctx):
            self._controller.leave()

    # --- what only a screen can do

    @property
    def map(self) -> MapPane:
        return self._place.map

    @property
    def log_text(self) -> str:
        return "".join(f"{line}\n" for line in self._place.log_rows.lines)

    def focus(self, pane: str) -> None:
        place = self._place
        panes = {"program": place.program_pane, "map": place.map_pane, "log": place.log_pane}
        if pane == "variables":
            place.toggle_inspector()
        else:
            place.go_to(panes[pane])

    async def complete(self) -> None:
        from donnie_tui.tui.screens.dialogs import Completions

        editor = self._place.editor
        editor.focus()
        assistant, text, at = self._controller.assistant, editor.text, editor.offset_of_cursor
        found = assistant.completion(text, at)
        if found.typed and not found.words:  # the word is whole: what may follow it
            found = assistant.completion(f"{text[:at]} {text[at:]}", at + 1)
            if found.listed:
                editor.insert(" ")
        shown = found.listed
        if not shown:
            self._controller.ctx.answer("screen-nothing-to-complete")
            return
        await asyncio.sleep(0)
        below = editor.cursor_screen_offset
        keys, room = self._words("completion-keys"), self._place.room_around(below.y)
        listed = Completions(shown, keys, below, room, self._controller.point)
        word, letter = await self._dialogs.answer_of(listed) or ("", "")
        if word:
            editor.put_in_place_of(found.typed, word)
        elif letter:
            editor.insert(letter)

    def mark_mistakes(self) -> None:
        self._controller.assistant.check_now()

    def place_cursor(self, line: int, column: int) -> None:
        self._place.editor.go_to(line, column)

    def explore(self, change: Callable[[Pointer], object]) -> None:
        """Move the pointer with the focus on the map, so that the cursor is on the spoken square."""
        place = self._place
        if not place.map.has_focus:
            place.go_to(place.map_pane)
        place.map.explore(change)

    def show_sensor_ranges(self, lines: Iterable[Line]) -> None:
        self._controller.display.show_fields(lines)

    def search_log(self, word: str, lines: int) -> None:
        is_marked = self._place.log_rows.search(word)
        self._controller.display.entitle_log((quoted(word), lines) if is_marked else None)

    @property
    def log_kinds(self) -> Mapping[str, int]:
        return Counter(kind for _text, kind in self._place.log_rows.with_kinds)

    @property
    def log_filter(self) -> str:
        return self._place.log_rows.only

    def filter_log(self, kind: str) -> None:
        self._place.log_rows.filter(kind)
        self._controller.display.entitle_log()

    def show_in_pager(self, text: str) -> None:
        """Shows text in the pager, with the terminal's ways of reading; without one, on a page of Donnie."""
        command = pager(os.environ)
        try:
            if command is None:
                raise SuspendNotSupported
            with self._app.suspend():  # Textual takes the screen up again only after a block without failure
                try:
                    run_pager(command, text)
                except OSError as problem:
                    reason = problem.strerror or str(problem)
                    self._controller.ctx.answer("screen-pager-failed", reason=reason)
        except SuspendNotSupported:
            self._open_page(self._words("pane-log"), text.splitlines())

    def show_help(self, *, is_everything: bool) -> None:
        """Show the words of the first lesson, or all words. F1 in the help opens the manual."""
        if is_everything:
            lines = help_text(self._words, self.key_table)
        else:
            lines = help_lines(self._place, self._words, self.key_table)
        self._open_page(self._words("help-title"), lines, "help-keys", self.show_manual)

    def show_keys(self) -> None:
        heading, *lines = keys_here(self._place, self._words, self.key_table)
        self._open_page(heading.rstrip(":."), lines)

    def show_tour(self) -> None:
        """Show the tour from the page that was left; below the panes, if there is room."""

        place, point = self._place, self._controller.point
        if place.tour is not None:
            place.tour.action_turn(1)
            return
        has_room = not (place.is_plain or place.is_small)
        pages = tour_pages(self._words, self.key_table)
        if has_room:
            place.show_tour(TourStrip(pages, self._tour_page, self._turned_strip, point))
        else:
            self._dialogs.open(Tour(pages, self._tour_page, self._turned_tour, point))

    def _turned_strip(self, page: int) -> None:
        self._controller.display.looked()
        if page == SCREEN_TOUR_PAGES:
            self._place.close_tour()
        self._turned_tour(page)

    def _turned_tour(self, page: int) -> None:
        """Remember the page for the next TOUR; after the last page, begin the first challenge."""
        self._tour_page = page % SCREEN_TOUR_PAGES
        if page == SCREEN_TOUR_PAGES:
            word = word_of(BY_NAME["challenge"], self._words.language)
            self._app.post_message(CommandLine.Typed(f"{word} 1"))

    def repaint(self) -> None:
        self._app.repaint()

    def show_manual(self) -> None:
        self._open_page(self._words("manual-title"), manual(self._words))

    @property
    def is_plain(self) -> bool:
        return self._place.is_plain

    @property
    def is_page(self) -> bool:
        return is_page()

    def _open_page(
        self,
        title: str,
        lines: Sequence[str],
        keys: str = "page-keys",
        further: Callable[[], None] | None = None,
    ) -> None:
        self._dialogs.open(Help(title, self._words(keys), tuple(lines), self._controller.point, further))
