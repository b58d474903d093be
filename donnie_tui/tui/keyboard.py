"""The keyboard: which keys there are, and what a pressed key does and when.

A stop waits for nothing. Whatever else a key does comes after what was typed before it.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Iterable
from typing import TYPE_CHECKING

from textual import events
from textual.app import App
from textual.binding import Binding, BindingsMap
from textual.widgets import Input, TextArea

from donnie_tui.commands.keys import MENU, PALETTE, KeyTable, after_menu, key_label
from donnie_tui.process.signals import has_unread
from donnie_tui.tui.key_queue import Dialogs, KeyQueue
from donnie_tui.tui.screens.main_screen import MainScreen
from donnie_tui.tui.startup import SessionHandle

if TYPE_CHECKING:
    from donnie_tui.i18n.words import Words
    from donnie_tui.tui.screens.pages import KeyMenu

LOOK, LOOKS = 0.02, 25
"""Seconds between two looks whether all that was typed is taken, and how many looks there are."""

STOPS = ("stop", "stop_all")
"""Commands that run at once, whatever was typed before."""


def bindings(key_table: KeyTable) -> BindingsMap:
    """The keys of the table, and those that no setting changes."""
    of_commands = [
        Binding(key, f"do('{name}')", priority=True)
        for name, keys in key_table.all.items()
        for key in keys
        if " " not in key
    ]
    return BindingsMap(
        [
            *of_commands,
            Binding(MENU, "key_menu", priority=True),
            Binding(PALETTE, "command_palette", priority=True),
            Binding("ctrl+c", "do('stop_all', True)", priority=True),
            Binding("tab", "app.focus_next"),
            Binding("shift+tab", "app.focus_previous"),
        ]
    )


class Keyboard:
    """Takes each key, and runs the command that it means."""

    def __init__(
        self,
        app: App[int],
        session: SessionHandle,
        place: MainScreen,
        key_table: KeyTable,
        *,
        dialogs: Dialogs,
        feed: Callable[[events.Event], Awaitable[None]],
        must_wait: Callable[[], bool],
        do: Callable[[str], None],
    ) -> None:
        """``feed`` has Textual take an event; ``do`` runs a command of the table.

        ``must_wait``: whether there is nothing yet that keys could be for.
        """
        self._app, self._session, self._place, self._key_table = app, session, place, key_table
        self._dialogs = dialogs
        self._feed, self._must_wait, self._do = feed, must_wait, do
        self._queue = KeyQueue(app, self._take, must_wait)
        self._was_told = False
        """Whether the last key was Esc, and was answered with what Esc does."""
        self._menu: KeyMenu | None = None
        """The list of the keys after the menu key, while one of them is waited for."""

    @property
    def waiting_text(self) -> str:
        """What was typed and can't be taken yet. Works in any thread."""
        return self._queue.held_text

    def hold(self, typed: Iterable[events.Event]) -> None:
        """Takes these keys before any others, once the session is loaded."""
        self._queue.hold(*typed)

    def give_up(self) -> list[events.Event]:
        """What was typed and not taken."""
        return self._queue.give_up()

    async def on_event(self, event: events.Event) -> None:
        """Take an event of the application, which may be a key."""
        is_typed = isinstance(event, (events.Key, events.Paste)) and not event.is_forwarded
        controller = self._session.controller
        if is_typed and controller is not None:
            controller.key_pressed(event, self._app.focused)
        elif isinstance(event, events.MouseDown) and controller is not None:
            controller.display.acted()
        if is_typed and self._is_stop_key(event) and self._session.give_up_search():
            return
        if not is_typed or self._is_stop(event):
            await self._feed(event)
        elif self._queue.is_holding or self._must_wait():
            self._queue.hold(event)
        else:
            await self._take(event)

    async def _take(self, event: events.Event) -> None:
        """A key whose turn it is. What is no letter to write may mean something further up: the next wait."""
        if isinstance(event, events.Key) and (
            self._did_by_menu(event) or self._closed_tour(event) or self._is_too_late(event)
        ):
            return
        await self._feed(event)
        if isinstance(event, events.Key) and not (event.is_printable and self._is_writing):
            self._queue.follow(submits=event.key == "enter" and not isinstance(self._app.focused, TextArea))

    def _closed_tour(self, event: events.Key) -> bool:
        """Esc in the tour closes it, and the next one may have been meant for it."""
        tour = self._place.tour if self._app.screen is self._place else None
        if event.key != "escape" or tour is None or not tour.has_focus:
            return False
        self._place.close_tour()
        self._dialogs.note_gone()
        return True

    @property
    def _is_writing(self) -> bool:
        """Whether a letter is just a letter; elsewhere it may call for something."""
        return isinstance(self._app.focused, (Input, TextArea))

    def _is_too_late(self, event: events.Key) -> bool:
        """Esc may be meant for a question or a page just gone, and never drives a real robot at first."""
        if self._app.screen is not self._place:
            return False
        has_gone, was_told, self._was_told = self._dialogs.forget_gone(), self._was_told, False
        name, controller = self._key_table.command_of(event.key), self._session.controller
        if event.key != "escape" or name is None or controller is None or self._session.runs:
            return False
        if not has_gone and (was_told or not controller.donnie.connection.is_real):
            return False
        self._was_told = True
        from donnie_tui.commands.declarations import BY_NAME
        from donnie_tui.commands.lookup import word_of

        self._session.say("esc-again", word=word_of(BY_NAME[name], controller.words.language))
        return True

    def _is_stop(self, event: events.Event) -> bool:
        return self._is_stop_key(event) and self._session.runs

    def _is_stop_key(self, event: events.Event) -> bool:
        return isinstance(event, events.Key) and event.key in ("ctrl+c", *self._key_table.of("stop"))

    def release(self) -> None:
        """Take the keys that had to wait."""
        self._queue.do(lambda: None)

    def when_taken(self, command: Callable[[], None], looks: int = LOOKS) -> None:
        """Runs ``command`` once all keys were taken, or after ``looks`` looks: some keys may never be."""
        self._app.call_later(self._when_taken, command, looks)

    def _when_taken(self, command: Callable[[], None], looks: int) -> None:
        is_read = looks < LOOKS and not has_unread(0)  # at the second look what was read is here, too
        if looks and (self._must_wait() or not is_read):
            self._app.set_timer(LOOK, lambda: self.when_taken(command, looks - 1))
        elif looks:
            self._queue.do(command)
        else:
            command()

    def act(self, name: str) -> None:
        """A key of this command was pressed. Stopping comes first, all else after what was typed before."""
        if name in STOPS:
            self._do(name)
        else:
            self._queue.do(lambda: self._do_in_turn(name))

    def _do_in_turn(self, name: str) -> None:
        """Running from the command line runs what is typed there."""
        line = self._place.command_line
        if name == "run" and line.has_focus and line.value.strip():
            line.finish()
        else:
            self._do(name)

    # --- the keys after the menu key

    def open_menu(self, words: Words) -> None:
        """A list of them, and the next letter."""
        from donnie_tui.tui.screens.pages import KeyMenu

        self._menu = KeyMenu(self._key_table.all, words, self._session.point, is_plain=self._place.is_plain)
        self._app.push_screen(self._menu, self._menu_is_gone)

    def _menu_is_gone(self, _answer: None) -> None:
        if self._menu is not None:  # left without a command
            self._dialogs.note_gone()
        self._menu = None

    def _did_by_menu(self, event: events.Key) -> bool:
        """The letter after the menu key counts at once, whether its list is seen yet or not.

        One that means nothing there closes it, too: what comes next is no command.
        """
        menu = self._menu
        if menu is None or event.key in menu.READING:
            return False
        name, self._menu = menu.names.get(after_menu(event.key)), None
        menu.leave()
        self._queue.do(lambda: self._do_in_turn(name) if name else self._report_no_key(event))
        return True

    def _report_no_key(self, event: events.Key) -> None:
        if self._session.controller is not None:
            language = self._session.controller.words.language
            typed = event.character if event.is_printable else None
            label = typed or key_label(event.key, language)
            self._session.say("menu-no-key", key=f"{key_label(MENU, language)} {label}")
