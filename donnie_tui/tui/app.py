"""The full-screen application: the screen first, the work behind it.

Rules: the first frame needs nothing but Textual, so it is there at once; the session and all that belongs to
it are loaded afterwards. Whatever ends the application, the robot is halted, the text is kept and the
terminal given back.
"""

from __future__ import annotations

import asyncio
import os
import signal
import sys
import threading
import traceback
from collections.abc import Awaitable, Callable, Coroutine, Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import RenderableType
from rich.text import Text
from textual import events
from textual.app import App, SuspendNotSupported
from textual.binding import Binding, BindingsMap
from textual.geometry import Offset
from textual.screen import Screen
from textual.timer import Timer
from textual.widgets import Input, TextArea

from donnie_tui.device_settings import SERIAL
from donnie_tui.folders import state_folder
from donnie_tui.i18n import first_screen
from donnie_tui.robot_search import Search
from donnie_tui.settings import LANGUAGES, Settings
from donnie_tui.tui import themes
from donnie_tui.tui.actions import MENU
from donnie_tui.tui.key_table import KeyTable
from donnie_tui.tui.lifeline import BACK, Lifeline, give_back
from donnie_tui.tui.outside import leave_behind
from donnie_tui.tui.printable import Printable
from donnie_tui.tui.screens.workplace import Workplace
from donnie_tui.tui.terminal import is_plain, use_mouse, wants_mouse
from donnie_tui.tui.thrift import Painted
from donnie_tui.tui.turns import Turns
from donnie_tui.tui.widgets.command_line import CommandLine
from donnie_tui.tui.widgets.editor import Editor

if TYPE_CHECKING:
    from donnie_tui.bootstrap import Donnie
    from donnie_tui.tui.bridge import Began, Ended
    from donnie_tui.tui.screens.chooser import Choice
    from donnie_tui.tui.screens.key_menu import KeyMenu
    from donnie_tui.tui.work import Work

SHOW_CURSOR = "\x1b[?25h"
WIPE = "\x1b[0m\x1b[H\x1b[2J"

FAULT = "fault.txt"
"""Beside the copies: what went wrong at last, for whoever mends it."""

SWITCH = 0.0002
"""Seconds that a program which computes may keep the interpreter from the screen. A key passes from thread to
thread some five times until it is seen, so Python's own 0.005 would be felt."""

_STOPS = ("stop", "stop_all")
"""What is done at once, whatever was typed before."""

SLOW = 1.0
"""Seconds after which somebody is told what takes so long."""

CRASHED = 1
"""Textual's return code after a fault of ours; the text is kept for the next start."""


class DonnieApp(App[int], inherit_bindings=False):
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
    ) -> None:
        """``text``: what the other mode left, unsaved changes included. ``folder`` holds the copies.

        ``search``: what gives up the search for a robot, where ``assemble`` looks for one.
        """
        super().__init__(ansi_color=True if "NO_COLOR" in os.environ else None)  # the filters ask at once
        self.animation_level = "none"
        for name in themes.NAMES:
            self.register_theme(themes.theme(name))
        self.theme = themes.TERMINAL if self.no_color else themes.name_of(settings.theme)
        self._read_with = self.get_css_variables()
        """The colours and sizes with which the style sheets were read last."""
        self.stylesheet.set_variables(self._read_with)
        self._filters.append(Printable())
        self.workplace = Workplace(self.size, plain=is_plain(settings))
        self.key_table = KeyTable()
        self._menu: KeyMenu | None = None
        """The list of the keys behind a key, while one of them is waited for."""
        self._bind(settings.keys)
        self._turns = Turns(self, self._take)
        self._painted = Painted()
        self._lifeline: Lifeline | None = None
        self.work: Work | None = None
        """None until it is loaded."""
        self.trouble: Exception | None = None
        """What kept it from being loaded."""
        self.left_for_linear = False
        self.next_world = ""
        """The world in which the screen is to come back."""
        self._wants_linear = False
        self._was_slow = False
        """Whether it was told that the world takes a while: then it is told when it is there."""
        self._settings = settings
        self._language = LANGUAGES.index(settings.language)
        self._file, self._text = file, text
        self._assemble = assemble
        self.search = search
        self._is_searching = self.is_opening = False
        """While ``assemble`` looks for a robot, or the first file is read: what is typed then waits."""
        self._found: Donnie | None = None
        """What it made."""
        self._folder = Path(folder or state_folder(os.environ)) / "unsaved"

    def _bind(self, chosen: str) -> None:
        """The keys of the table, with those that somebody chose in their place."""
        self.key_table.choose(chosen)
        own = [
            Binding(key, f"do('{name}')", show=False, priority=True)
            for name, keys in self.key_table.all.items()
            for key in keys
            if " " not in key
        ]
        self._bindings = BindingsMap(
            [
                *own,
                Binding(MENU, "key_menu", show=False, priority=True),
                Binding(self.COMMAND_PALETTE_BINDING, "command_palette", show=False, priority=True),
                Binding("ctrl+c", "do('stop_all', True)", show=False, priority=True),
                Binding("tab", "app.focus_next", show=False),
                Binding("shift+tab", "app.focus_previous", show=False),
            ]
        )

    # --- beginning

    def get_theme_variable_defaults(self) -> dict[str, str]:
        """Before a theme of ours is chosen the style sheet is read with Textual's own."""
        return themes.theme(themes.DARK).variables

    def refresh_css(self, animate: bool = True) -> None:
        """Not as the application begins, when Textual asks for it too: nothing has changed by then."""
        variables = self.get_css_variables()
        if variables != self._read_with:
            self._read_with = variables
            super().refresh_css(animate)

    def get_default_screen(self) -> Screen[None]:
        return self.workplace

    def on_mount(self) -> None:
        self._handle_signals()
        self.app_resume_signal.subscribe(self, lambda _: self._show_cursor())
        place = self.workplace
        for pane, title in zip(
            place.panes,
            (first_screen.PROGRAM, first_screen.MAP, first_screen.VARIABLES, first_screen.LOG),
            strict=True,
        ):
            pane.entitle(title[self._language])
        keys = {name: self.key_table.label(name) or word for name, word in (("run", "RUN"), ("help", "HELP"))}
        about_keys = first_screen.START_KEYS[self._language].format(**keys)
        place.log_lines(((first_screen.START[self._language], ""), (about_keys, "")))
        place.status.say(f" {first_screen.STARTING[self._language]}")
        self.call_after_refresh(self._begin)

    def on_ready(self) -> None:
        self._show_cursor()

    def _show_cursor(self) -> None:
        """Textual hides the terminal's cursor; braille displays and console readers need it."""
        if self._driver is not None:
            self._driver.write(SHOW_CURSOR)

    def watch_app_focus(self, has_focus: bool) -> None:
        """A page of a browser, or a window behind another, begins without the focus: nothing has it yet."""
        place = self.workplace
        if has_focus and place.is_mounted and self.screen is place and place.focused is None:
            (place.command_line if place.is_plain else place.editor).focus()

    def _display(self, screen: Screen[Any], renderable: RenderableType | None) -> None:
        """Whatever is painted passes here. In the plain layout readers hear it: rows are written whole."""
        is_typing = isinstance(screen.focused, (TextArea, Input))
        thrifty = self._painted.less(
            renderable,
            rows=self.workplace.is_plain,
            typing=self.cursor_position if is_typing else None,
        )
        super()._display(screen, thrifty)

    def repaint(self) -> None:
        """All of it: something else may have written over the terminal."""
        self.refresh()
        self._show_cursor()

    def _set_pointer_shape(self, shape: str) -> None:
        """Nobody asks for it, it costs bytes, and a console shows it as letters."""

    def _begin(self) -> None:
        """The screen is there; now what it shows. A failure is told by the caller, on the normal screen."""
        try:
            if self.search is None and self._has_shipped_world:
                self._work_with(self._assemble())
            else:
                self._is_searching = True
                if self._settings.robot.startswith(SERIAL):  # of a configuration file nobody knows that yet
                    self._tell_of_search()
                self.run_worker(self._search_and_begin())
        except Exception as trouble:  # noqa: BLE001 -- raised again once the terminal is given back
            self._fail_to_begin(trouble)

    async def _search_and_begin(self) -> None:
        """Looking for a robot takes some seconds, in which the keys that give it up are heard.

        A learner's own world may be large, and takes as long as it takes.
        """
        slowly = self.set_timer(SLOW, self._tell_of_world)
        if self.search is not None:
            loop = asyncio.get_running_loop()
            self.search.on_slow = lambda: loop.call_soon_threadsafe(self._tell_early, "connect-waiting")
        try:
            await asyncio.to_thread(self._assemble_and_keep)
            slowly.stop()
            if self._found is not None:
                self._work_with(self._found)
        except Exception as trouble:  # noqa: BLE001 -- as above
            self._fail_to_begin(trouble)
        self._is_searching = False
        self._let_keys()

    def begin_with(self, opening: Coroutine[None, None, None]) -> None:
        """Keys are for what is opened; where that takes long, they are for what there is."""
        self.is_opening = True
        self.set_timer(SLOW, self._opened)
        self.run_worker(self._open(opening), group="opening")

    async def _open(self, opening: Coroutine[None, None, None]) -> None:
        await opening
        if self.work is not None:
            self.work.look()
        self._opened()

    def _opened(self) -> None:
        if self.is_opening:
            self.is_opening = False
            self._let_keys()

    def _let_keys(self) -> None:
        if not (self._is_searching or self.is_opening):
            self._turns.do(lambda: None)

    @property
    def _has_shipped_world(self) -> bool:
        """Those are ready to be read: no time passes."""
        import worlds

        return self._settings.world in worlds.names()

    def _tell_of_search(self) -> None:
        if self.search is not None:
            self._tell_early("connect-trying")

    def _tell_of_world(self) -> None:
        if self.search is None:
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
        self.workplace.log_lines([(sentence, "")])
        self.workplace.status.say(f" {sentence}")

    def _assemble_and_keep(self) -> None:
        """Whoever leaves meanwhile must be able to close it."""
        self._found = self._assemble()

    def _work_with(self, donnie: Donnie) -> None:
        from donnie_tui.tui.work import Work

        self.work = Work(self, donnie, self._folder, self._settings)
        self.work.begin(self._file, self._text)
        if self._was_slow:
            self.work.tell_sentences(self.work.words("slow-world-done", name=self._world_name))
        if self._wants_linear:
            self.work.switch_to_linear()

    def _fail_to_begin(self, trouble: Exception) -> None:
        self.trouble = trouble
        self.exit(2)

    def _give_up_search(self) -> bool:
        """Whether a robot was looked for."""
        search = self.work.donnie.connection.search if self.work is not None else self.search
        return search is not None and search.give_up()

    @property
    def cursor_position(self) -> Offset:
        """Where the terminal's own cursor stands: where the widget with the focus says, at every update."""
        place = getattr(self.focused, "cursor_screen_offset", None) if self.is_running else None
        return place if isinstance(place, Offset) else Offset(0, 0)

    @cursor_position.setter
    def cursor_position(self, _place: Offset) -> None:
        """Textual's editor and input line write here, also without the focus: not what is asked."""

    # --- doing

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Actions belong to the workplace, but a stop is always possible; else Ctrl+C copies."""
        if action == "do":
            only_while_running = len(parameters) > 1
            return self._stops(parameters) or (self.screen is self.workplace and not only_while_running)
        if action in ("key_menu", "command_palette"):
            return self.screen is self.workplace
        return super().check_action(action, parameters)

    def _stops(self, parameters: tuple[object, ...]) -> bool:
        return self._runs and parameters[0] in _STOPS

    @property
    def _runs(self) -> bool:
        """Whether anything could be stopped, of whichever robot."""
        work = self.work
        return work is not None and (work.running.is_busy or bool(work.donnie.team.running))

    def action_do(self, name: str, _only_while_running: bool = False) -> None:
        """A key was pressed. Stopping comes first, all else after what was typed before it."""
        if name in _STOPS:
            self.do(name)
        else:
            self._turns.do(lambda: self._do_in_turn(name))

    async def on_event(self, event: events.Event) -> None:
        is_typed = isinstance(event, (events.Key, events.Paste)) and not event.is_forwarded
        if is_typed and self.work is not None:
            self.work.key_pressed(event, self.focused)
        elif isinstance(event, events.MouseDown) and self.work is not None:
            self.work.display.acted()
        if is_typed and self._is_stop_key(event) and self._give_up_search():
            return
        if not is_typed or self._is_stop(event):
            await super().on_event(event)
        elif self._turns.is_holding or self._is_searching or self.is_opening:
            self._turns.hold(event)
        else:
            await self._take(event)

    async def _take(self, event: events.Event) -> None:
        """A key whose turn it is. What is no letter may mean something further up: letters behind it wait."""
        if isinstance(event, events.Key) and self._did_by_menu(event.key):
            return
        await super().on_event(event)
        if isinstance(event, events.Key) and not event.is_printable:
            self._turns.follow(submits=event.key == "enter" and isinstance(self.focused, Input))

    def _is_stop(self, event: events.Event) -> bool:
        return self._is_stop_key(event) and self._runs

    def _is_stop_key(self, event: events.Event) -> bool:
        return isinstance(event, events.Key) and event.key in ("ctrl+c", *self.key_table.of("stop"))

    def _do_in_turn(self, name: str) -> None:
        """Running from the command line runs what is typed there."""
        line = self.workplace.command_line
        if name == "run" and line.has_focus and line.value.strip():
            line.finish()
        else:
            self.do(name)

    def do(self, name: str) -> None:
        """Do an action of the table."""
        if self.work is not None:
            self._await(self.work.do(name))
        else:
            self.workplace.log_lines([(first_screen.ONE_MOMENT[self._language], "")])

    def on_command_line_typed(self, event: CommandLine.Typed) -> None:
        if self.work is not None:
            self._await(self.work.typed(event.text))

    def _await(self, asking: Awaitable[None] | None) -> None:
        """An action that asks something has its effect when it is answered."""
        if asking is not None:
            self.run_worker(self._finish(asking), exclusive=True)

    async def _finish(self, asking: Awaitable[None]) -> None:
        await asking
        if self.work is not None and self.is_running:
            self.work.look()

    async def action_quit(self) -> None:
        self.do("quit")

    def action_command_palette(self) -> None:
        """Every action to choose from; there once there are words."""
        if self.work is not None and self.screen is self.workplace:
            self._await(self._choose_action(self.work))

    async def _choose_action(self, work: Work) -> None:
        from donnie_tui.tui.screens.palette import palette

        chosen = await self.choose(*palette(work.words, self.key_table))
        if chosen is not None:
            asking = work.do(chosen)
            if asking is not None:
                await asking

    def action_key_menu(self) -> None:
        """The keys behind a key: a list of them, and the next letter."""
        if self.work is not None and self.screen is self.workplace:
            from donnie_tui.tui.screens.key_menu import KeyMenu

            self._menu = KeyMenu(self.key_table.all, self.work.words)
            self.push_screen(self._menu, self._menu_is_gone)

    def _menu_is_gone(self, _answer: None) -> None:
        self._menu = None

    def _did_by_menu(self, key: str) -> bool:
        """The letter behind the menu key counts at once, whether its list is seen yet or not."""
        if self._menu is None or (name := self._menu.names.get(key)) is None:
            return False
        menu, self._menu = self._menu, None
        menu.leave()
        self._turns.do(lambda: self._do_in_turn(name))
        return True

    # --- what the work asks of the application

    def wear(self, settings: Settings) -> None:
        """The look, the layout and the keys that somebody chose."""
        if not self.no_color:
            self.theme = themes.name_of(settings.theme)
        if settings.plain is not None:
            self.workplace.set_plain(settings.plain)
        self._language = LANGUAGES.index(settings.language)
        self._bind(settings.keys)
        use_mouse(self._driver, wanted=wants_mouse(settings))

    def enter_world(self, name: str) -> None:
        """The screen is left for a moment, and comes back in that world."""
        self.next_world = name
        self.exit(0)

    async def choose_word(self, words: Sequence[str], below: Offset) -> tuple[str, str]:
        from donnie_tui.tui.screens.completions import Completions

        return await self.push_screen_wait(Completions(words, below, self._point))

    def show_outside(self, text: str) -> bool:
        """In the terminal's pager. False where there is none, or no terminal."""
        from donnie_tui.tui.outside import show_in_pager

        try:
            with self.suspend():
                return show_in_pager(text)
        except SuspendNotSupported:
            return False

    def later(self, seconds: float, do: Callable[[], None]) -> Timer:
        return self.set_timer(seconds, do)

    def every(self, seconds: float, do: Callable[[], None]) -> Timer:
        return self.set_interval(seconds, do)

    async def ask(
        self, asked: str, keys: str, value: str, accepts: Callable[[str], str | None] | None
    ) -> str | None:
        from donnie_tui.tui.screens.question import Question

        return await self.push_screen_wait(Question(asked, keys, self._point, value=value, accepts=accepts))

    async def press_key(
        self, asked: str, keys: str, behind: str, accepts: Callable[[str], str | None]
    ) -> str | None:
        from donnie_tui.tui.screens.key_capture import KeyCapture

        return await self.push_screen_wait(KeyCapture(asked, keys, behind, accepts, self._point))

    async def choose(self, title: str, keys: str, nothing: str, choices: Sequence[Choice]) -> str | None:
        from donnie_tui.tui.screens.chooser import Chooser

        return await self.push_screen_wait(Chooser(title, keys, nothing, choices, self._point))

    def _point(self, words: str) -> None:
        if self.work is not None:
            self.work.point(words)

    def show_help(self, title: str, lines: tuple[str, ...]) -> None:
        from donnie_tui.tui.screens.help import Help

        self.push_screen(Help(title, lines))

    def leave(self, code: int = 0, *, for_linear: bool = False) -> None:
        self.left_for_linear = for_linear
        self.exit(code)

    # --- what happened

    def on_began(self, event: Began) -> None:
        if self.work is not None:
            self.work.began(event)

    def on_happened(self) -> None:
        if self.work is not None:
            self.work.happened()

    def on_paused(self) -> None:
        if self.work is not None:
            self.work.paused()

    def on_ended(self, event: Ended) -> None:
        """QUIT, typed with other commands, leaves once they are done."""
        if self.work is not None:
            self.work.ended(event)
            if event.asks_to_quit:
                self.do("quit")

    def on_editor_linear_typed(self) -> None:
        """At the very start it counts too: once there is something to change from."""
        if self.work is None:
            self._wants_linear = True
        else:
            self.work.linear_typed()

    def on_editor_line_finished(self, event: Editor.LineFinished) -> None:
        if self.work is not None:
            self.work.line_finished(event.row)

    def on_map_view_explored(self) -> None:
        if self.work is not None:
            self.work.explored()

    def on_workplace_looked(self) -> None:
        if self.work is not None:
            self.work.display.looked()

    def on_text_area_changed(self) -> None:
        if self.work is not None:
            self.work.edited()

    # --- ending

    def _handle_signals(self) -> None:
        """Somebody ends the process, or the line is lost. Ctrl+C from elsewhere only stops the program."""
        loop = asyncio.get_running_loop()

        def tell(number: int) -> None:
            with suppress(RuntimeError):  # the loop may be gone
                loop.call_soon_threadsafe(self._signalled, number)

        def stuck() -> None:
            if self._stop_real_robot():
                tell(0)

        lifeline = Lifeline(
            halt=lambda: self._halt(0),
            before_rest=self._stop_real_robot,
            tell=tell,
            on_stuck=stuck,
            part=self._part,
            writer=lambda: getattr(self._driver, "_writer_thread", None),
        )
        with suppress(ValueError):
            lifeline.begin()
            self._lifeline = lifeline

    def on_unmount(self) -> None:
        """A terminal can still get stuck on the way out; what has none needs nothing more.

        A console has no other screen to go back to: what was painted must not be in the shell's way.
        """
        if self.is_headless:
            self.end_lifeline()
        elif self._driver is not None:
            self._driver.write(WIPE)

    def end_lifeline(self) -> None:
        """In the main thread, once nothing is written to the screen any more."""
        if self._lifeline is not None:
            self._lifeline.end()

    def _signalled(self, number: int) -> None:
        if number == signal.SIGINT:
            self._interrupt()
        elif number == BACK:
            self.repaint()
        elif number:
            self._end(number)
        elif self.work is not None:
            self.work.tell_sentences(self.work.words("stuck-stopped"))

    def _end(self, number: int) -> None:
        self._halt(number)
        self.keep_text()
        self.exit(128 + number)

    def _interrupt(self) -> None:
        """As the key that stops all."""
        if not self._give_up_search() and self._runs:
            self.do("stop_all")
        if self._lifeline is not None:
            self._lifeline.answered.set()

    def _stop_real_robot(self) -> bool:
        return self.work is not None and self.work.donnie.stop_real_robot()

    def _part(self, number: int) -> None:
        """The screen did not leave by itself: what can be saved in a moment, and the end."""
        for last in (self.keep_text, self.close_session):
            saving = threading.Thread(target=last, daemon=True)
            saving.start()
            saving.join(1.0)
        give_back(self._driver)
        os._exit(128 + number)

    def _halt(self, _number: int) -> None:
        self._give_up_search()
        if self.work is not None:
            self.work.halt()

    def keep_text(self) -> None:
        """Write down what is not saved, for the next start."""
        if self.work is not None:
            self.work.files.keep_copy_now()

    def panic(self, *_renderables: object) -> None:
        self._fatal_error()

    def _fatal_error(self) -> None:
        """A fault of ours, of which Textual prints pages: the robot stops, the text is kept, one sentence."""
        with suppress(Exception):
            self._halt(0)
        with suppress(Exception):
            self.keep_text()
        with suppress(OSError):
            self._folder.mkdir(parents=True, exist_ok=True)
            (self._folder / FAULT).write_text(traceback.format_exc(), encoding="utf-8")
        if not self._exit_renderables:
            self._exit_renderables.append(Text(first_screen.FAULT[self._language]))
        self._close_messages_no_wait()

    def close_session(self) -> None:
        """After the screen is gone: nothing is left running."""
        if self.work is not None:
            self.work.close()
        elif self._found is not None:
            self._found.close()


def run_full_screen(
    settings: Settings, file: Path | None, *, text: str | None = None, donnie: Donnie | None = None
) -> int:
    """Work at the screen until the learner leaves; the exit code.

    ``text`` is the program that the other mode left, where it did, ``donnie`` its session. Raises
    ``SwitchMode`` if the learner goes to the linear mode, ``Unusable`` if the world or a device can't be
    used.
    """
    sys.setswitchinterval(SWITCH)
    if donnie:
        donnie.audible.move_to(is_linear=False)
    while True:
        app = _shown(settings, file, text, donnie)
        if not app.next_world:
            break
        settings, file, text = _in_next_world(app)
        donnie = None
    leave_behind(app.workplace.log_rows.lines)
    return CRASHED if app.return_code == CRASHED else app.return_value or 0


def _shown(settings: Settings, file: Path | None, text: str | None, donnie: Donnie | None) -> DonnieApp:
    """The screen until it is left. Raises as ``run_full_screen`` does."""
    search = Search(is_coming=True) if donnie is None and _takes_time(settings) else None
    app = DonnieApp(
        settings, file, text=text, assemble=lambda: donnie or _assembled(settings, search), search=search
    )
    try:
        app.run(mouse=wants_mouse(settings))
    except BaseException:
        app.close_session()
        raise
    finally:
        app.end_lifeline()
    has_failed = app.trouble is not None or app.return_code == CRASHED
    if app.left_for_linear and not has_failed:
        _switch(app)
    app.close_session()
    if app.trouble is not None:
        raise app.trouble
    return app


def _in_next_world(app: DonnieApp) -> tuple[Settings, Path | None, str]:
    """The settings as they were chosen, the program's file and its text."""
    settings = app.work.preferences.settings if app.work is not None else Settings()
    path = app.work.files.document.path if app.work is not None else None
    return replace(settings, world=app.next_world), path, app.workplace.editor.text


def _takes_time(settings: Settings) -> bool:
    """Whether a real robot is looked for, as a configuration file may ask for one too."""
    return settings.robot.startswith(SERIAL) or settings.world.endswith(".cfg")


def _assembled(settings: Settings, search: Search | None) -> Donnie:
    from donnie_tui.bootstrap import assemble

    return assemble(settings, terminal=True, is_linear=False, search=search)


def _switch(app: DonnieApp) -> None:
    from donnie_tui.switching import SwitchMode

    path = app.work.files.document.path if app.work is not None else None
    donnie = app.work.hand_over() if app.work is not None else None
    raise SwitchMode(app.workplace.editor.text, str(path) if path else None, donnie)
