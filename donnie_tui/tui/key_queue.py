"""The order of keys: what was typed before a key is done before what that key does.

Textual handles a key with priority at once, while letters wait in the queue of the widget with the focus. In
one burst (a paste over SSH, a fast braille keyboard) F5 would run a program whose last letters are still to
come. So the command of a key follows the letters through the same queues, and later keys wait until it is
done. An arrow, Backspace or Tab is taken by the first widget on the way up that knows it, while letters are
taken at once: letters after it wait too, until it is up.

Keys for a dialog wait as well, until it is shown: what is typed after the key of a question is its answer.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Awaitable, Callable
from typing import Any, TypeAlias, TypeVar

from textual.app import App
from textual.events import Event, Key, Paste
from textual.message_pump import MessagePump
from textual.screen import Screen
from textual.timer import Timer

from donnie_tui.commands.interaction import SLOW

ROUNDS = 3
"""Passes from the widget up to the application: for the key, for what it submits, for what that posts."""
LOOK = 0.5
"""Seconds between two checks of the progress of a key's command."""
LOOKS = 4
"""Checks without progress after which the command runs anyway: a widget on the way may be gone.
A slow machine makes progress, and a pause counts as one check however long it is."""

KeyCommand: TypeAlias = Callable[[], None]
T = TypeVar("T")


class KeyQueue:
    """Keeps the order. ``feed`` takes an event as if it came just now."""

    def __init__(
        self,
        app: App[int],
        feed: Callable[[Event], Awaitable[None]],
        must_wait: Callable[[], bool] = lambda: False,
    ) -> None:
        """``must_wait``: whether there is nothing yet that keys are for; ``do`` lets them go on later."""
        self._app = app
        self._feed, self._must_wait = feed, must_wait
        self._held: deque[Event] = deque()
        self._command: KeyCommand | None = None
        self._then: deque[tuple[KeyCommand, int]] = deque()
        """Further commands, and for how many rounds each is passed on."""
        self._timer: Timer | None = None
        self._steps = 0

    @property
    def is_holding(self) -> bool:
        """Whether keys have to wait just now."""
        return self._command is not None or bool(self._held)

    @property
    def held_text(self) -> str:
        """What the waiting keys would write. Works in any thread."""
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
        """Do it once everything that came before has been."""
        if self._command is not None:
            self._then.append((command, rounds))
            return
        self._command = command
        self._pass_on(self._first(), command, rounds)
        self._look_later(command, LOOKS)

    def follow(self, *, submits: bool) -> None:
        """What comes now waits until the last key has done what it does; ``submits``: by way of a message."""
        if self._command is None:
            self.do(lambda: None, ROUNDS if submits else 0)

    def _first(self) -> MessagePump:
        return self._app.focused or self._app.screen

    def _pass_on(self, pump: MessagePump, command: KeyCommand, rounds: int) -> None:
        """To the end of one queue after the other, in the way of a key that no widget takes."""
        self._steps += command is self._command
        if pump is not self._app:
            pump.call_later(self._pass_on, pump._parent or self._app, command, rounds)
        elif rounds:
            pump.call_later(self._pass_on, self._first(), command, rounds - 1)
        else:
            pump.call_later(self._act, command)

    def _look_later(self, command: KeyCommand, looks: int) -> None:
        steps = self._steps
        self._timer = self._app.set_timer(LOOK, lambda: self._look(command, looks, steps))

    def _look(self, command: KeyCommand, looks: int, steps: int) -> None:
        """In the timer's own task, which ends when the timer is stopped: nothing is done here."""
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
        """The command that asks just now."""
        self._timer: Timer | None = None
        self._screen: Screen[Any] | None = None
        """What was called for and is not there yet."""
        self._has_gone = False
        """Whether a question or a page has gone since ``forget_gone``."""

    @property
    def holds_keys(self) -> bool:
        in_front = self._app.screen
        return in_front is self._screen or (in_front is self._place and self._asking is not None)

    def begin(self) -> object:
        """A command that asks begins. What is returned is to be given to ``done``."""
        self._asking = object()
        self._wait_a_moment()
        return self._asking

    def done(self, asking: object) -> None:
        """The command is done. An earlier one, which another has replaced, counts no more."""
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

    def open(self, page: Screen[None]) -> None:
        """Show something to read."""
        self._call_for(page)
        self._app.push_screen(page, lambda _: self.note_gone())

    def _call_for(self, screen: Screen[Any]) -> None:
        """It is in front from now on, and there once its own queue is emptied."""
        self._screen = screen
        screen.call_later(self._is_there, screen)

    def _gone(self, screen: Screen[Any]) -> None:
        """It was answered, or is not wanted any more."""
        self._is_there(screen)
        self.note_gone()
        if self._asking is not None:
            self._wait_a_moment()

    def note_gone(self) -> None:
        """Something that was in front of the main screen has gone: the next Esc may be meant for it."""
        self._has_gone = True

    def forget_gone(self) -> bool:
        """Whether something has gone since this was asked last."""
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
