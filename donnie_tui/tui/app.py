"""The full-screen application: the screen first, the work behind it.

What Textual calls is here, and the putting together; ``beginning``, ``keyboard``, ``ending`` and
``screen_host`` do the rest. Rules: the first frame needs nothing but Textual, so it is there at once; the
session and all that belongs to it are loaded afterwards. Whatever ends the application, the robot is halted,
the text is kept and the terminal given back.
"""

from __future__ import annotations

import os
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import RenderableType
from rich.text import Text
from textual import events
from textual.screen import Screen

from donnie_tui.commands.keys import KeyTable
from donnie_tui.i18n.first_words import early
from donnie_tui.robot.search import Search
from donnie_tui.settings.folders import UNSAVED, state_folder
from donnie_tui.settings.settings import Settings
from donnie_tui.tui.beginning import Beginning
from donnie_tui.tui.coming import Coming
from donnie_tui.tui.ending import Ending
from donnie_tui.tui.environment import is_plain, wants_mouse
from donnie_tui.tui.keyboard import STOPS, Keyboard, bindings
from donnie_tui.tui.screen_host import ScreenHost
from donnie_tui.tui.screens.workplace import Workplace
from donnie_tui.tui.session_behind import SessionBehind
from donnie_tui.tui.terminal import TerminalApp, use_mouse
from donnie_tui.tui.widgets.command_line import CommandLine
from donnie_tui.tui.widgets.editor import Editor
from donnie_tui.tui.widgets.rows import KeyLine, TextRows

if TYPE_CHECKING:
    from donnie_tui.bootstrap import Donnie
    from donnie_tui.tui.bridge import Began, Ended
    from donnie_tui.tui.brought import Brought
    from donnie_tui.tui.work import Work

WIPE = "\x1b[0m\x1b[H\x1b[2J"


class DonnieApp(TerminalApp, inherit_bindings=False):
    """One learner at one terminal."""

    CSS_PATH = "styles/donnie.tcss"
    TITLE = "Donnie"

    def __init__(
        self,
        settings: Settings,
        file: Path | None = None,
        *,
        text: str | None = None,
        assemble: Callable[[], Donnie],
        search: Search | None = None,
        folder: Path | None = None,
        brought: Brought | None = None,
    ) -> None:
        """``text``: what the other mode left, unsaved changes included. ``folder`` holds the copies.

        ``brought``: what came along from another world.

        ``search``: what gives up the search for a robot, where ``assemble`` looks for one.
        """
        super().__init__(settings)
        self._settings, self._file, self._text, self._brought = settings, file, text, brought
        self._language = settings.language
        self._state = Path(folder or state_folder(os.environ))
        self.workplace = Workplace(
            self.size, plain=is_plain(settings), focus=brought.focus if brought else ""
        )
        self.key_table = KeyTable()
        self._bind(settings.keys)
        self._behind = SessionBehind(search)
        self._coming = Coming(self, self.workplace, self._let_keys)
        self._keyboard = self._with_keyboard()
        self.beginning = Beginning(
            self,
            self._behind,
            self.workplace,
            settings,
            search=search,
            assemble=assemble,
            work_with=self._work_with,
            let_keys=self._let_keys,
        )
        self.ending = Ending(
            self,
            self._behind,
            self._state / UNSAVED,
            stop_all=lambda: self.do("stop_all"),
            repaint=self.repaint,
        )
        self._host = self._as_host()
        self._first_word: str | None = None
        """What was asked for in the empty program before there was anything to do it with."""

    def _with_keyboard(self) -> Keyboard:
        return Keyboard(
            self,
            self._behind,
            self.workplace,
            self.key_table,
            coming=self._coming,
            feed=super().on_event,
            must_wait=lambda: self.beginning.holds_keys or self._coming.holds_keys,
            do=self.do,
        )

    def _as_host(self) -> ScreenHost:
        return ScreenHost(
            self,
            self.workplace,
            self.key_table,
            begin_with=self.beginning.open_with,
            wear=self.wear,
            repaint=self.repaint,
            point=self._behind.point,
            coming=self._coming,
        )

    def _work_with(self, donnie: Donnie) -> Work:
        from donnie_tui.tui.work import Work

        work = self._behind.work = Work(
            self._host,
            donnie,
            self._state,
            self._settings,
            self._brought.workspace if self._brought else None,
        )
        work.begin(self._file, self._text, self._brought)
        if self._first_word is not None:
            self.call_later(self._do_first_word, self._first_word)
        return work

    # --- what there is, and how it was left

    @property
    def work(self) -> Work | None:
        """None until it is loaded."""
        return self._behind.work

    @property
    def trouble(self) -> Exception | None:
        """What kept it from being loaded."""
        return self.beginning.trouble

    @property
    def is_opening(self) -> bool:
        """While the first file is read."""
        return self.beginning.is_opening

    @property
    def left_for_linear(self) -> bool:
        return self._host.left_for_linear

    @property
    def next_world(self) -> str:
        """The world in which the screen is to come back."""
        return self._host.next_world

    def close_session(self) -> None:
        """After the screen is gone: nothing is left running."""
        self._behind.close()

    # --- looks

    def wear(self, settings: Settings) -> None:
        """The look, the layout and the keys that somebody chose."""
        self.wear_theme(settings)
        if settings.plain is not None:
            self.workplace.set_plain(settings.plain)
        self._language = settings.language
        self._bind(settings.keys)
        use_mouse(self._driver, wanted=wants_mouse(settings))

    def _bind(self, chosen: str) -> None:
        """The keys of the table, with those that somebody chose in their place."""
        self.key_table.choose(chosen)
        self._bindings = bindings(self.key_table)

    def get_default_screen(self) -> Screen[None]:
        return self.workplace

    def on_mount(self) -> None:
        self.ending.begin()
        self.app_resume_signal.subscribe(self, lambda _: self.show_cursor())
        self.beginning.greet(self.key_table, self._brought)
        self.call_after_refresh(self.beginning.begin)

    def watch_app_focus(self, has_focus: bool) -> None:
        """A page of a browser, or a window behind another, begins without the focus: nothing has it yet."""
        place = self.workplace
        if has_focus and place.is_mounted and self.screen is place and place.focused is None:
            place.set_focus(place.first_focus)  # before the next key

    def _display(self, screen: Screen[Any], renderable: RenderableType | None) -> None:
        """A new layout, or another screen, is painted once: Textual would leave it out while one is held."""
        if renderable is not None:
            self.workplace.hold_nothing()
        super()._display(screen, renderable)

    @property
    def is_read_by_rows(self) -> bool:
        return self.workplace.is_plain

    # --- doing

    async def on_event(self, event: events.Event) -> None:
        await self._keyboard.hear(event)

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Actions belong to the workplace, but a stop is always possible; else Ctrl+C copies."""
        if action == "do":
            only_while_running = len(parameters) > 1
            return self._stops(parameters) or (self.screen is self.workplace and not only_while_running)
        if action in ("key_menu", "command_palette"):
            return self.screen is self.workplace
        return super().check_action(action, parameters)

    def _stops(self, parameters: tuple[object, ...]) -> bool:
        return self._behind.runs and parameters[0] in STOPS

    def _let_keys(self) -> None:
        """Those that waited; as it ends there is nothing more that they could be for."""
        if self.screen_stack:
            self._keyboard.let_go()

    def action_do(self, name: str, _only_while_running: bool = False) -> None:
        """A key was pressed."""
        self._keyboard.act(name)

    async def action_quit(self) -> None:
        self.do("quit")

    def action_key_menu(self) -> None:
        """The keys behind a key."""
        if self.work is not None and self.screen is self.workplace:
            self._keyboard.open_menu(self.work.words)

    def action_command_palette(self) -> None:
        """Every action to choose from; there once there are words."""
        if self.work is not None and self.screen is self.workplace:
            self._await(self._choose_action(self.work))

    async def _choose_action(self, work: Work) -> None:
        from donnie_tui.tui.screens.pages import palette

        chosen = await self._host.choose(*palette(work.words, self.key_table))
        if chosen is not None:
            asking = work.do(chosen)
            if asking is not None:
                await asking

    def do(self, name: str) -> None:
        """Do an action of the table."""
        if self.work is not None:
            self._await(self.work.do(name))
        else:
            self.workplace.log_lines([(early("screen-starting", self._language), "")])

    def on_key_line_clicked(self, event: KeyLine.Clicked) -> None:
        self._keyboard.act(event.action)

    def on_command_line_typed(self, event: CommandLine.Typed) -> None:
        if self.work is not None:
            self._await(self.work.typed(event.text))

    def _await(self, asking: Awaitable[None] | None) -> None:
        """An action that asks something has its effect when it is answered."""
        if asking is not None:
            self.run_worker(self._finish(asking, self._coming.begins()), exclusive=True)

    async def _finish(self, asking: Awaitable[None], name: object) -> None:
        try:
            await asking
        finally:
            self._coming.done(name)
        if self.work is not None and self.is_running:
            self.work.look()

    # --- what happened

    def on_began(self, event: Began) -> None:
        if self.work is not None:
            self.work.began(event)

    def on_happened(self) -> None:
        if self.work is not None:
            self.work.happened()

    def on_run_held(self) -> None:
        if self.work is not None:
            self.work.held()

    def on_ended(self, event: Ended) -> None:
        """QUIT, typed with other commands, leaves once they are done."""
        if self.work is not None:
            self.work.ended(event)
            if event.asks_to_quit:
                self.do("quit")

    def on_editor_first_word_typed(self, event: Editor.FirstWordTyped) -> None:
        """At the very start it counts too: once there is something to do it with."""
        if self.work is None:
            self._first_word = event.name
        else:
            self._do_first_word(event.name)

    def _do_first_word(self, name: str) -> None:
        """It is not meant as the program's text."""
        self.workplace.editor.load_text("")
        self.do(name)

    def on_editor_line_finished(self, event: Editor.LineFinished) -> None:
        if self.work is not None:
            self.work.line_finished(event.row)

    def on_map_view_explored(self) -> None:
        if self.work is not None:
            self.work.explored()

    def on_text_rows_read(self, event: TextRows.Read) -> None:
        """Whoever moves through rows hears each: of the help, of the keys behind a key, of the log."""
        if event.has_focus and event.text:
            self._behind.point(event.text)

    def on_workplace_entered(self) -> None:
        if self.work is not None:
            self.work.entered()

    def on_workplace_looked(self) -> None:
        if self.work is not None:
            self.work.display.looked()

    def on_text_area_changed(self) -> None:
        if self.work is not None:
            self.work.edited()

    # --- ending

    def on_unmount(self) -> None:
        """A terminal can still get stuck on the way out; what has none needs nothing more.

        A console has no other screen to go back to: what was painted must not be in the shell's way.
        """
        if self.is_headless:
            self.ending.end_lifeline()
        elif self._driver is not None:
            self._driver.write(WIPE)

    def panic(self, *_renderables: object) -> None:
        self._fatal_error()

    def _fatal_error(self) -> None:
        """A fault of ours, of which Textual prints pages: the robot stops, the text is kept, one sentence."""
        self.ending.save_from_fault()
        if not self._exit_renderables:
            self._exit_renderables.append(Text(early("screen-fault", self._language)))
        self._close_messages_no_wait()
