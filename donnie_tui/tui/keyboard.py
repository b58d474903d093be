"""The keyboard: the key bindings, and the order in which keys and commands take effect.

A stop acts at once. Every other command of a key acts after the keys typed before it.

Textual handles a key with priority at once, while letters wait in the queue of the widget with the focus. In
one burst (a paste over SSH, a fast braille keyboard) F5 would run a program whose last letters are still to
come. So the command of a key follows the letters through the same queues, and later keys wait until it is
done. An arrow, Backspace or Tab is taken by the first widget on the way up that knows it, while letters are
taken at once: letters after it wait too, until it is up.

Keys for a dialog wait as well, until it is shown: they answer its question.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Awaitable, Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

from textual import events
from textual.app import App
from textual.binding import Binding, BindingsMap
from textual.events import Event, Key, Paste
from textual.message_pump import MessagePump
from textual.screen import Screen
from textual.timer import Timer
from textual.widgets import Input, TextArea

from donnie_tui.commands.interaction import SLOW
from donnie_tui.commands.keys import MENU, PALETTE, KeyTable, after_menu, key_label
from donnie_tui.process.signals import has_unread
from donnie_tui.tui.screens.main_screen import MainScreen
from donnie_tui.tui.startup import SessionHandle

if TYPE_CHECKING:
    from donnie_tui.i18n.words import Words
    from donnie_tui.tui.screens.pages import KeyMenu

TAKEN_LOOK, TAKEN_LOOKS = 0.02, 25
"""Seconds between two looks whether all that was typed is taken, and how many looks there are."""

ROUNDS = 3
"""Passes from the widget up to the application: for the key, for what it submits, for what that posts."""
LOOK = 0.5
"""Seconds between two checks of the progress of a key's command."""
LOOKS = 4
"""Checks without progress after which the command runs anyway: a widget on the way may be gone.
A slow machine makes progress, and a pause counts as one check however long it is."""

STOPS = ("stop", "stop_all")
"""Commands that run at once, whatever was typed before."""


KeyCommand: TypeAlias = Callable[[], None]
T = TypeVar("T")


def bindings(key_table: KeyTable) -> BindingsMap:
    """The bindings of the table, and those that no setting changes."""
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
        feed: Callable[[Event], Awaitable[None]],
        must_wait: Callable[[], bool],
        do: Callable[[str], None],
    ) -> None:
        """``feed`` has Textual take an event; ``do`` runs a command of the table.

        ``must_wait``: whether keys must wait because nothing can take them yet.
        """
        self._app, self._session, self._place, self._key_table = app, session, place, key_table
        self._dialogs = dialogs
        self._feed, self._must_wait, self._do = feed, must_wait, do
        self.queue = KeyQueue(app, self._take, must_wait)
        self._has_warned = False
        """Whether the last key was Esc, and its answer said what Esc does."""
        self._menu: KeyMenu | None = None
        """The shown key menu, until the next key."""

    async def on_event(self, event: Event) -> None:
        """Handle an event of the application, which may be a key."""
        is_typed = isinstance(event, (Key, Paste)) and not event.is_forwarded
        controller = self._session.controller
        if is_typed and controller is not None:
            controller.key_pressed(event, self._app.focused)
        elif isinstance(event, events.MouseDown) and controller is not None:
            controller.display.acted()
        if is_typed and self._is_stop_key(event) and self._session.give_up_search():
            return
        if not is_typed or self._is_stop(event):
            await self._feed(event)
        elif self.queue.is_holding or self._must_wait():
            self.queue.hold(event)
        else:
            await self._take(event)

    async def _take(self, event: Event) -> None:
        """Handle the next key. If it writes no letter, a parent widget may use it, so later keys wait."""
        if isinstance(event, Key) and (
            self._did_by_menu(event) or self._closed_tour(event) or self._is_too_late(event)
        ):
            return
        await self._feed(event)
        if isinstance(event, Key) and not (event.is_printable and self._is_writing):
            self.queue.follow(submits=event.key == "enter" and not isinstance(self._app.focused, TextArea))

    def _closed_tour(self, event: Key) -> bool:
        """Close the tour on Esc; the next Esc may have been meant for it, too."""
        tour = self._place.tour if self._app.screen is self._place else None
        if event.key != "escape" or tour is None or not tour.has_focus:
            return False
        self._place.close_tour()
        self._dialogs.note_gone()
        return True

    @property
    def _is_writing(self) -> bool:
        """Whether a letter is typed as text; elsewhere it may run a command."""
        return isinstance(self._app.focused, (Input, TextArea))

    def _is_too_late(self, event: Key) -> bool:
        """Whether Esc may be meant for a dialog that just closed. A first Esc never drives a real robot."""
        if self._app.screen is not self._place:
            return False
        has_gone, had_warned, self._has_warned = self._dialogs.forget_gone(), self._has_warned, False
        name, controller = self._key_table.command_of(event.key), self._session.controller
        if event.key != "escape" or name is None or controller is None or self._session.runs:
            return False
        if not has_gone and (had_warned or not controller.donnie.connection.is_real):
            return False
        self._has_warned = True
        from donnie_tui.commands.declarations import BY_NAME
        from donnie_tui.commands.lookup import word_of

        self._session.say("esc-again", word=word_of(BY_NAME[name], controller.words.language))
        return True

    def _is_stop(self, event: Event) -> bool:
        return self._is_stop_key(event) and self._session.runs

    def _is_stop_key(self, event: Event) -> bool:
        return isinstance(event, Key) and event.key in ("ctrl+c", *self._key_table.of("stop"))

    def release(self) -> None:
        """Handle the keys that had to wait."""
        self.queue.do(lambda: None)

    def when_taken(self, command: Callable[[], None], looks: int = TAKEN_LOOKS) -> None:
        """Run ``command`` once all keys were handled, or after ``looks`` checks: some may never be."""
        self._app.call_later(self._when_taken, command, looks)

    def _when_taken(self, command: Callable[[], None], looks: int) -> None:
        is_read = looks < TAKEN_LOOKS and not has_unread(0)  # at the second look what was read is here, too
        if looks and (self._must_wait() or not is_read):
            self._app.set_timer(TAKEN_LOOK, lambda: self.when_taken(command, looks - 1))
        elif looks:
            self.queue.do(command)
        else:
            command()

    def act(self, name: str) -> None:
        """Run the command of a pressed key: a stop at once, others after the keys typed before."""
        if name in STOPS:
            self._do(name)
        else:
            self.queue.do(lambda: self._do_in_turn(name))

    def _do_in_turn(self, name: str) -> None:
        """Run a command in its turn; RUN from the command line runs the line that is typed there."""
        line = self._place.command_line
        if name == "run" and line.has_focus and line.value.strip():
            line.finish()
        else:
            self._do(name)

    # --- the keys after the menu key

    def open_menu(self, words: Words) -> None:
        """Show the key menu, and take the next letter for it."""
        from donnie_tui.tui.screens.pages import KeyMenu

        self._menu = KeyMenu(self._key_table.all, words, self._session.point, is_plain=self._place.is_plain)
        self._app.push_screen(self._menu, self._menu_is_gone)

    def _menu_is_gone(self, clicked: str | None) -> None:
        if self._menu is not None:  # left without a key
            self._dialogs.note_gone()
        self._menu = None
        if clicked is not None:
            self.queue.do(lambda: self._do_in_turn(clicked))

    def _did_by_menu(self, event: Key) -> bool:
        """Handle the letter after the menu key, whether its list is shown yet or not.

        An unknown letter closes the menu, too, so that the next key is no command.
        """
        menu = self._menu
        if menu is None or event.key in menu.READING:
            return False
        name, self._menu = menu.names.get(after_menu(event.key)), None
        if event.key == "enter":
            name = name or menu.chosen
        menu.leave()
        self.queue.do(lambda: self._do_in_turn(name) if name else self._report_no_key(event))
        return True

    def _report_no_key(self, event: Key) -> None:
        if self._session.controller is not None:
            language = self._session.controller.words.language
            typed = event.character if event.is_printable else None
            label = typed or key_label(event.key, language)
            self._session.say("menu-no-key", key=f"{key_label(MENU, language)} {label}")


# --- the order of keys


class KeyQueue:
    """Keeps keys in order. ``feed`` handles an event as if it had just come."""

    def __init__(
        self,
        app: App[int],
        feed: Callable[[Event], Awaitable[None]],
        must_wait: Callable[[], bool] = lambda: False,
    ) -> None:
        """``must_wait``: whether nothing can take keys yet; ``do`` releases them later."""
        self._app = app
        self._feed, self._must_wait = feed, must_wait
        self._held: deque[Event] = deque()
        self._command: KeyCommand | None = None
        self._then: deque[tuple[KeyCommand, int]] = deque()
        """Further commands, each with its number of rounds."""
        self._timer: Timer | None = None
        self._steps = 0

    @property
    def is_holding(self) -> bool:
        """Whether keys have to wait."""
        return self._command is not None or bool(self._held)

    @property
    def held_text(self) -> str:
        """The text that the waiting keys would write. Works in any thread."""
        text = ""
        for event in tuple(self._held):
            if isinstance(event, Paste):
                text += event.text
            elif isinstance(event, Key):
                text = text[:-1] if event.key == "backspace" else text + _written(event)
        return text

    def hold(self, *events: Event) -> None:
        """Keeps keys until the command before them is done."""
        self._held.extend(events)

    def give_up(self) -> list[Event]:
        """Returns the waiting keys and forgets them."""
        held, self._held = [*self._held], deque()
        return held

    def do(self, command: KeyCommand, rounds: int = ROUNDS) -> None:
        """Run ``command`` after everything that came before it."""
        if self._command is not None:
            self._then.append((command, rounds))
            return
        self._command = command
        self._pass_on(self._first(), command, rounds)
        self._look_later(command, LOOKS)

    def follow(self, *, submits: bool) -> None:
        """Hold new keys until the last key has taken effect; ``submits``: it posts a message."""
        if self._command is None:
            self.do(lambda: None, ROUNDS if submits else 0)

    def _first(self) -> MessagePump:
        return self._app.focused or self._app.screen

    def _pass_on(self, pump: MessagePump, command: KeyCommand, rounds: int) -> None:
        """Send the command through one queue after the other, as a key that no widget takes."""
        self._steps += command is self._command
        if pump is not self._app:
            above = pump._parent or self._app
            if not pump.call_later(self._pass_on, above, command, rounds):  # it is closing
                self._pass_on(above, command, rounds)
        elif rounds:
            pump.call_later(self._pass_on, self._first(), command, rounds - 1)
        else:
            pump.call_later(self._act, command)

    def _look_later(self, command: KeyCommand, looks: int) -> None:
        steps = self._steps
        self._timer = self._app.set_timer(LOOK, lambda: self._look(command, looks, steps))

    def _look(self, command: KeyCommand, looks: int, steps: int) -> None:
        """Check the progress, in the timer's task, which ends when the timer stops; runs nothing itself."""
        if command is not self._command:
            return
        if self._steps != steps:
            self._look_later(command, LOOKS)
        elif looks > 1:
            self._look_later(command, looks - 1)
        else:
            self._app.call_later(self._act, command)

    async def _act(self, command: KeyCommand) -> None:
        """Runs the command once, even if it arrives again after its timeout."""
        if command is not self._command:
            return
        self._command = None
        if self._timer is not None:
            self._timer.stop()
            self._timer = None
        command()
        if self._then and self._command is None:
            self.do(*self._then.popleft())
        while self._held and self._command is None and not self._must_wait():
            await self._feed(self._held.popleft())


def _written(key: Key) -> str:
    return "\n" if key.key == "enter" else key.character or "" if key.is_printable else ""


class Dialogs:
    """Shows dialogs and pages; ``release_keys`` releases the keys that wait for them.

    Keys wait from the start of a command that asks until its question is shown, and from the answer until the
    command is done; no longer than a moment, for some commands look for robots.
    """

    def __init__(self, app: App[int], place: Screen[None], release_keys: Callable[[], None]) -> None:
        self._app, self._place, self._release_keys = app, place, release_keys
        self._asking: object | None = None
        """The command that may ask now."""
        self._timer: Timer | None = None
        self._screen: Screen[Any] | None = None
        """The screen that was pushed and is not shown yet."""
        self._has_gone = False
        """Whether a dialog or page has closed since ``forget_gone``."""

    @property
    def holds_keys(self) -> bool:
        in_front = self._app.screen
        return in_front is self._screen or (in_front is self._place and self._asking is not None)

    def begin(self) -> object:
        """Begin a command that may ask. Give the returned token to ``done``."""
        self._asking = object()
        self._wait_a_moment()
        return self._asking

    def done(self, asking: object) -> None:
        """End the command of this token, unless another command has replaced it."""
        if asking is self._asking:
            self._stop_waiting()

    async def answer_of(self, screen: Screen[T]) -> T:
        """Show a dialog. It disappears if another command is asked for before it is answered."""
        self._call_for(screen)
        try:
            return await self._app.push_screen_wait(screen)
        except asyncio.CancelledError:
            if screen in self._app.screen_stack:
                screen.pop_until_active()
                screen.dismiss()
            raise
        finally:
            self._gone(screen)

    @contextmanager
    def checking(self, screen: Screen[Any]) -> Iterator[None]:
        """Hold keys while an answer is checked: they may be for what follows the dialog."""
        self._screen = screen
        try:
            yield
        finally:
            self._is_there(screen)

    def open(self, page: Screen[None]) -> None:
        """Show something to read."""
        self._call_for(page)
        self._app.push_screen(page, lambda _: self.note_gone())

    def _call_for(self, screen: Screen[Any]) -> None:
        """Push a screen, and wait until its own queue is empty."""
        self._screen = screen
        screen.call_later(self._is_there, screen)

    def _gone(self, screen: Screen[Any]) -> None:
        """Note that a screen was answered or replaced."""
        self._is_there(screen)
        self.note_gone()
        if self._asking is not None:
            self._wait_a_moment()

    def note_gone(self) -> None:
        """Note that a dialog or page has closed: the next Esc may be meant for it."""
        self._has_gone = True

    def forget_gone(self) -> bool:
        """Whether a dialog or page has closed since the last call."""
        has_gone, self._has_gone = self._has_gone, False
        return has_gone

    def _is_there(self, screen: Screen[Any]) -> None:
        if screen is self._screen:
            self._screen = None
            self._release_keys()

    def _wait_a_moment(self) -> None:
        if self._timer is not None:
            self._timer.stop()
        self._timer = self._app.set_timer(SLOW, self._stop_waiting)

    def _stop_waiting(self) -> None:
        self._asking = None
        if self._timer is not None:
            self._timer.stop()
            self._timer = None
        self._release_keys()
