"""What becomes of a key: it stops at once, waits for its turn, counts behind the menu key, or goes on.

Rules: a stop waits for nothing; whatever else a key does comes after what was typed before it.
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import TYPE_CHECKING

from textual import events
from textual.app import App
from textual.binding import Binding, BindingsMap
from textual.widgets import Input, TextArea

from donnie_tui.commands.keys import MENU, PALETTE, KeyTable, behind_menu, key_label
from donnie_tui.tui.coming import Coming
from donnie_tui.tui.screens.workplace import Workplace
from donnie_tui.tui.session_behind import SessionBehind
from donnie_tui.tui.turns import Turns

if TYPE_CHECKING:
    from donnie_tui.i18n.words import Words
    from donnie_tui.tui.screens.pages import KeyMenu

STOPS = ("stop", "stop_all")
"""What is done at once, whatever was typed before."""


def bindings(key_table: KeyTable) -> BindingsMap:
    """The keys of the table, and those that are everybody's."""
    own = [
        Binding(key, f"do('{name}')", show=False, priority=True)
        for name, keys in key_table.all.items()
        for key in keys
        if " " not in key
    ]
    return BindingsMap(
        [
            *own,
            Binding(MENU, "key_menu", show=False, priority=True),
            Binding(PALETTE, "command_palette", show=False, priority=True),
            Binding("ctrl+c", "do('stop_all', True)", show=False, priority=True),
            Binding("tab", "app.focus_next", show=False),
            Binding("shift+tab", "app.focus_previous", show=False),
        ]
    )


class Keyboard:
    """The way of each key, from when it comes until something is done."""

    def __init__(
        self,
        app: App[int],
        behind: SessionBehind,
        place: Workplace,
        key_table: KeyTable,
        *,
        coming: Coming,
        feed: Callable[[events.Event], Awaitable[None]],
        must_wait: Callable[[], bool],
        do: Callable[[str], None],
    ) -> None:
        """``feed`` has Textual take an event; ``do`` does an action of the table.

        ``must_wait``: whether there is nothing yet that keys could be for.
        """
        self._app, self._behind, self._place, self._key_table = app, behind, place, key_table
        self._coming = coming
        self._feed, self._must_wait, self._do = feed, must_wait, do
        self._turns = Turns(app, self._take, must_wait)
        self._menu: KeyMenu | None = None
        """The list of the keys behind a key, while one of them is waited for."""

    async def hear(self, event: events.Event) -> None:
        """Whatever comes to the application, keys among it."""
        is_typed = isinstance(event, (events.Key, events.Paste)) and not event.is_forwarded
        work = self._behind.work
        if is_typed and work is not None:
            work.key_pressed(event, self._app.focused)
        elif isinstance(event, events.MouseDown) and work is not None:
            work.display.acted()
        if is_typed and self._is_stop_key(event) and self._behind.give_up_search():
            return
        if not is_typed or self._is_stop(event):
            await self._feed(event)
        elif self._turns.is_holding or self._must_wait():
            self._turns.hold(event)
        else:
            await self._take(event)

    async def _take(self, event: events.Event) -> None:
        """A key whose turn it is. What is no letter to write may mean something further up: the next wait."""
        if isinstance(event, events.Key) and (self._did_by_menu(event) or self._is_too_late(event)):
            return
        await self._feed(event)
        if isinstance(event, events.Key) and not (event.is_printable and self._is_writing):
            self._turns.follow(submits=event.key == "enter" and isinstance(self._app.focused, Input))

    @property
    def _is_writing(self) -> bool:
        """Whether a letter is just a letter; elsewhere it may call for something."""
        return isinstance(self._app.focused, (Input, TextArea))

    def _is_too_late(self, event: events.Key) -> bool:
        """Esc right behind a question may be meant for it: it drives no robot until it is pressed again."""
        if self._app.screen is not self._place or not self._coming.forget_gone():
            return False
        name, work = self._key_table.command_of(event.key), self._behind.work
        if event.key != "escape" or name is None or work is None or self._behind.runs:
            return False
        from donnie_tui.commands.declarations import BY_NAME
        from donnie_tui.commands.lookup import word_of

        work.talk.tell_sentences(work.words("esc-again", word=word_of(BY_NAME[name], work.words.language)))
        return True

    def _is_stop(self, event: events.Event) -> bool:
        return self._is_stop_key(event) and self._behind.runs

    def _is_stop_key(self, event: events.Event) -> bool:
        return isinstance(event, events.Key) and event.key in ("ctrl+c", *self._key_table.of("stop"))

    def let_go(self) -> None:
        """Those that had to wait."""
        self._turns.do(lambda: None)

    def act(self, name: str) -> None:
        """A key of this action was pressed. Stopping comes first, all else after what was typed before it."""
        if name in STOPS:
            self._do(name)
        else:
            self._turns.do(lambda: self._do_in_turn(name))

    def _do_in_turn(self, name: str) -> None:
        """Running from the command line runs what is typed there."""
        line = self._place.command_line
        if name == "run" and line.has_focus and line.value.strip():
            line.finish()
        else:
            self._do(name)

    # --- the keys behind the menu key

    def open_menu(self, words: Words) -> None:
        """A list of them, and the next letter."""
        from donnie_tui.tui.screens.pages import KeyMenu

        self._menu = KeyMenu(self._key_table.all, words, self._behind.point)
        self._app.push_screen(self._menu, self._menu_is_gone)

    def _menu_is_gone(self, _answer: None) -> None:
        self._menu = None

    def _did_by_menu(self, event: events.Key) -> bool:
        """The letter behind the menu key counts at once, whether its list is seen yet or not.

        One that means nothing there closes it, too: what comes next is no command.
        """
        menu = self._menu
        if menu is None or event.key in menu.READING:
            return False
        name, self._menu = menu.names.get(behind_menu(event.key)), None
        menu.leave()
        self._turns.do(lambda: self._do_in_turn(name) if name else self._tell_nothing_done(event))
        return True

    def _tell_nothing_done(self, event: events.Key) -> None:
        if self._behind.work is not None:
            words = self._behind.work.words
            own = event.character if event.is_printable else None
            label = own or key_label(event.key, words.language)
            self._behind.work.talk.tell_sentences(
                words("menu-no-key", key=f"{key_label(MENU, words.language)} {label}")
            )
