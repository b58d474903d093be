"""The Textual application: shows the main screen at once and loads the session after its first frame.

Textual calls these methods. When the application ends, for any reason, the robots are halted, the text is
kept and the terminal is given back.
"""

from __future__ import annotations

import os
from collections.abc import Awaitable, Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import RenderableType
from rich.text import Text
from textual import events
from textual.message import Message
from textual.screen import Screen

from donnie_tui.commands.keys import PALETTE, KeyTable
from donnie_tui.i18n.first_words import early
from donnie_tui.settings.folders import UNSAVED, state_path
from donnie_tui.settings.settings import Settings
from donnie_tui.tui.environment import is_page, is_plain, may_need_linear
from donnie_tui.tui.keyboard import STOPS, Dialogs, Keyboard, bindings
from donnie_tui.tui.screens.main_screen import MainScreen
from donnie_tui.tui.shutdown import CRASHED, Shutdown
from donnie_tui.tui.startup import SessionHandle, Startup
from donnie_tui.tui.terminal import TerminalApp
from donnie_tui.tui.widgets.command_line import CommandLine, Pane
from donnie_tui.tui.widgets.editor import Editor
from donnie_tui.tui.widgets.rows import KeyLine, Slider, TextRows

if TYPE_CHECKING:
    from donnie_tui.bootstrap import Donnie
    from donnie_tui.robot.search import Search
    from donnie_tui.tui.controller import ScreenController, ScreenState
    from donnie_tui.tui.event_queue import RunBegan, RunFinished

LATER_STYLES = Path(__file__).parent / "styles" / "later.tcss"
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
        restored: ScreenState | None = None,
        typed: Sequence[events.Event] = (),
    ) -> None:
        """``text``: what the other mode left, unsaved changes included. ``folder`` holds the copies.

        ``search`` gives up the search for a robot, if ``assemble`` looks for one. ``restored`` is kept
        from the world before, and ``typed`` are the keys that were not taken there.
        """
        super().__init__(settings)
        self._settings, self._file, self._text, self._restored = settings, file, text, restored
        self._language = settings.language
        self._state_folder = Path(folder or state_path(os.environ))
        self.main_screen = MainScreen(
            self.size,
            plain=is_plain(settings),
            focus=restored.focus if restored else "",
            first_row=early("screen-start-words", settings.language) if may_need_linear() else "",
        )
        self.key_table = KeyTable(has_terminal=not is_page())
        self._bind(settings.keys)
        self.session = SessionHandle(
            search, lambda: self._keyboard.queue.held_text, self._state_folder / UNSAVED
        )
        self._dialogs = Dialogs(self, self.main_screen, self._release_keys)
        self._keyboard = Keyboard(
            self,
            self.session,
            self.main_screen,
            self.key_table,
            dialogs=self._dialogs,
            feed=super().on_event,
            must_wait=lambda: (
                self.startup.holds_keys or self._dialogs.holds_keys or bool(self.session.next_world)
            ),
            do=self.do,
        )
        self._keyboard.queue.hold(*typed)
        self.startup = Startup(
            self,
            self.session,
            self.main_screen,
            settings,
            search=search,
            assemble=assemble,
            start_controller=self._start_controller,
            release_keys=self._release_keys,
        )
        self.shutdown = Shutdown(
            self,
            self.session,
            self._state_folder / UNSAVED,
            stop_all=lambda: self.do("stop_all"),
            repaint=self.repaint,
            after_keys=self._keyboard.when_taken,
        )

    def _start_controller(self, donnie: Donnie) -> None:
        """Make the controller and load the styles of dialogs, which the main screen does not need."""
        from donnie_tui.bootstrap import open_workspace
        from donnie_tui.commands.preferences import Preferences
        from donnie_tui.tui.interaction import connect

        self.stylesheet.read(LATER_STYLES)
        restored, folder = self._restored, str(self._state_folder)
        controller = self.session.controller = connect(
            self,
            self._dialogs,
            self.main_screen,
            self.key_table,
            donnie,
            restored.workspace if restored else open_workspace(folder),
            Preferences(self._settings, os.environ),
        )
        opening = controller.begin(self._file, self._text, restored, folder)
        if opening is not None:
            self.startup.open_with(opening)

    @property
    def controller(self) -> ScreenController | None:
        """None until the session is loaded."""
        return self.session.controller

    # --- looks

    def apply_settings(self, settings: Settings) -> None:
        """Apply the settings, the layout and the keys among them."""
        super().apply_settings(settings)
        if settings.plain is not None:
            self.main_screen.set_plain(settings.plain)
        self._language = settings.language
        self._bind(settings.keys)

    def _bind(self, chosen: str) -> None:
        """Bind the keys of the table; the learner's choice replaces them."""
        self.key_table.choose(chosen)
        self._bindings = bindings(self.key_table)

    def get_default_screen(self) -> Screen[None]:
        return self.main_screen

    def on_mount(self) -> None:
        self.shutdown.begin()
        self.app_resume_signal.subscribe(self, lambda _: self.show_cursor())
        self.startup.greet(self.key_table, self._restored)
        self.call_after_refresh(self.startup.begin)

    def watch_app_focus(self, has_focus: bool) -> None:
        """Focus the first widget, since a page in a browser may begin without the focus."""
        place = self.main_screen
        if has_focus and place.is_mounted and self.screen is place and place.focused is None:
            place.set_focus(place.first_focus)  # before the next key

    def _display(self, screen: Screen[Any], renderable: RenderableType | None) -> None:
        """Paint a new layout or screen once, which Textual would leave out while painting is held."""
        if renderable is not None:
            self.main_screen.hold_nothing()
        super()._display(screen, renderable)

    @property
    def is_read_by_rows(self) -> bool:
        return self.main_screen.is_plain

    # --- keys and commands

    async def on_event(self, event: events.Event) -> None:
        await self._keyboard.on_event(event)

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Allow actions on the main screen, and a stop anywhere; otherwise Ctrl+C copies."""
        if action == "do":
            only_while_running = len(parameters) > 1
            is_stop = self.session.runs and parameters[0] in STOPS
            return is_stop or (self.screen is self.main_screen and not only_while_running)
        if action in ("key_menu", "command_palette"):
            return self.screen is self.main_screen
        return super().check_action(action, parameters)

    def _release_keys(self) -> None:
        """Handles the keys that waited, unless the application is ending."""
        if self.screen_stack:
            self._keyboard.release()

    def action_do(self, name: str, _only_while_running: bool = False) -> None:
        """Run the command of a pressed key."""
        self._keyboard.act(name)

    async def action_quit(self) -> None:
        self.do("quit")

    def action_key_menu(self) -> None:
        """List the keys that may follow the menu key."""
        if self.controller is not None and self.screen is self.main_screen:
            self._keyboard.open_menu(self.controller.words)

    def action_command_palette(self) -> None:
        """Offer every command, once the sentences are loaded."""
        if self.controller is not None and self.screen is self.main_screen:
            self._await(self._choose_command(self.controller))

    async def _choose_command(self, controller: ScreenController) -> None:
        from donnie_tui.tui.pane_text import TYPED_LINE, palette

        options = palette(controller.words, self.key_table, controller.ctx.preferences)
        chosen = await controller.ctx.interaction.choose(controller.words("palette-ask"), options)
        if chosen is not None:
            typed = chosen.removeprefix(TYPED_LINE)
            asking = controller.do(chosen) if typed == chosen else controller.run_line(typed)
            if asking is not None:
                await asking

    def do(self, name: str, argument: str | None = None) -> None:
        """Run a command of the table."""
        if self.session.is_leaving:
            return
        if self.controller is not None:
            self._await(self.controller.do(name, argument))
        else:
            self.main_screen.log_lines([(early("screen-starting", self._language), "")])

    def on_key_line_clicked(self, event: KeyLine.Clicked) -> None:
        if event.action == PALETTE:
            self.action_command_palette()
        else:
            self._keyboard.act(event.action)

    def on_slider_moved(self, event: Slider.Moved) -> None:
        if self.controller is not None:
            self.controller.look_at(event.step)

    def on_command_line_typed(self, event: CommandLine.Typed) -> None:
        if self.controller is not None and not self.session.is_leaving:
            self._await(self.controller.run_line(event.text))

    def _await(self, asking: Awaitable[None] | None) -> None:
        """Run the rest of a command that asks a question in a worker."""
        if asking is not None:
            self.run_worker(self._finish(asking, self._dialogs.begin()), exclusive=True)

    async def _finish(self, asking: Awaitable[None], name: object) -> None:
        try:
            await asking
        finally:
            self._dialogs.done(name)
        if self.controller is not None and self.is_running:
            self.controller.display.update()

    def keys_not_taken(self) -> list[events.Event]:
        """The keys that were typed for the next world, after this screen has closed."""
        waiting = (*self._keyboard.queue.give_up(), *self.messages_not_taken())
        return [*filter(None, map(_typed_again, waiting))]

    # --- messages

    def on_run_began(self, event: RunBegan) -> None:
        if self.controller is not None:
            self.controller.run_view.on_began(event)

    def on_events_queued(self) -> None:
        if self.controller is not None:
            self.controller.events.on_queued()

    def on_run_state_changed(self) -> None:
        if self.controller is not None:
            self.controller.run_view.on_state_changed()

    def on_run_finished(self, event: RunFinished) -> None:
        """Leave after a QUIT that was typed with other commands, once they have run."""
        if self.controller is not None:
            self.controller.run_view.on_finished(event)
            if self.controller.ctx.attempt is not None and self.controller.ctx.attempt.has_questions:
                self.do("questions")
            if event.asks_to_quit and event.robot in (None, self.controller.donnie.session.name):
                self.do("quit")

    def on_editor_line_word_typed(self, event: Editor.LineWordTyped) -> None:
        self.do(event.name, event.argument)

    def on_editor_line_finished(self, event: Editor.LineFinished) -> None:
        if self.controller is not None:
            self.controller.assistant.line_finished(event.row)

    def on_editor_gutter_clicked(self, event: Editor.GutterClicked) -> None:
        """Set or remove the breakpoint of the clicked line."""
        if self.controller is not None:
            self._await(self.controller.do("break_", str(event.line)))

    def on_pane_title_clicked(self, event: Pane.TitleClicked) -> None:
        """Offer what the clicked title names: the programs or the worlds."""
        place = self.main_screen
        action = {place.program_pane: "open", place.map_pane: "worlds"}.get(event.pane)
        if action is not None:
            self._keyboard.act(action)

    def on_status_line_clicked(self) -> None:
        """Open the settings, since the line shows the speed."""
        self._keyboard.act("set")

    def on_map_view_explored(self) -> None:
        if self.controller is not None:
            self.controller.on_explored()

    def on_map_view_edges_changed(self) -> None:
        if self.controller is not None:
            self.controller.display.entitle_map()

    def on_text_rows_read(self, event: TextRows.Read) -> None:
        """Speak each row that the learner moves to: of the help, the key menu, the log."""
        if event.has_focus and event.text:
            self.session.point(event.text)

    def on_main_screen_entered(self) -> None:
        """Speak the newly focused part, and show it in the status line."""
        if self.controller is not None:
            self.controller.point(self.controller.display.focus_sentence)

    def on_main_screen_looked(self) -> None:
        if self.controller is not None:
            self.controller.display.looked()

    on_editor_looked = on_main_screen_looked

    def on_editor_edited(self) -> None:
        if self.controller is not None:
            self.controller.assistant.edited()

    # --- the end

    def on_unmount(self) -> None:
        """End the watchdog if there is no terminal, which could get stuck while the screen closes.

        A console has no alternate screen, so what was painted is erased for the shell.
        """
        if self.is_headless:
            self.shutdown.end_watchdog()
        elif self._driver is not None:
            self._driver.write(WIPE)

    def panic(self, *_renderables: object) -> None:
        """Ends the screen as after any other fault: one of Textual's threads has failed."""
        self._return_code = CRASHED
        self._fatal_error()

    def _fatal_error(self) -> None:
        """Handle Donnie's own fault: stop the robot, keep the text, print a sentence, not Textual's pages."""
        self.shutdown.save_from_fault()
        if not self._exit_renderables:
            self._exit_renderables.append(Text(early("screen-fault", self._language)))
        self._close_messages_no_wait()


def _typed_again(message: Message | None) -> events.Event | None:
    """The same key or paste as a new event; None for any other message."""
    if isinstance(message, events.Key):
        return events.Key(message.key, message.character)
    return events.Paste(message.text) if isinstance(message, events.Paste) else None
