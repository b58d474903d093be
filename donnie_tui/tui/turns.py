"""Keys in their turn: what was typed just before a key is done before what that key does.

Textual hands a key with priority over at once, while letters wait in the queue of the widget with the focus.
In one burst (a paste over SSH, a fast braille keyboard) F5 would run a program whose last letters are still
to come. Rule: the deed follows the letters through the same queues, later keys wait until it is done. An
arrow, Backspace or Tab is taken by whoever knows it on the way up, while letters are taken at once: letters
behind it wait too, until it is up.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Awaitable, Callable
from typing import TypeAlias

from textual.app import App
from textual.events import Event
from textual.message_pump import MessagePump
from textual.timer import Timer

ROUNDS = 3
"""From the widget up to the application: a key that a binding takes, what it submits, what that posts."""
PATIENCE = 0.5
"""Seconds after which it is done anyway: a widget on the way may have gone."""

Deed: TypeAlias = Callable[[], None]


class Turns:
    """Keeps the order. ``feed`` takes an event as if it came just now."""

    def __init__(self, app: App[int], feed: Callable[[Event], Awaitable[None]]) -> None:
        self._app = app
        self._feed = feed
        self._held: deque[Event] = deque()
        self._deed: Deed | None = None
        self._patience: Timer | None = None

    @property
    def is_holding(self) -> bool:
        """Whether keys have to wait just now."""
        return self._deed is not None or bool(self._held)

    def hold(self, event: Event) -> None:
        """A key that comes after the deed."""
        self._held.append(event)

    def do(self, deed: Deed, rounds: int = ROUNDS) -> None:
        """Do it once everything that came before has been."""
        if self._patience is not None:
            self._patience.stop()
        self._deed = deed
        self._patience = self._app.set_timer(PATIENCE, self._act)
        self._pass_on(self._first(), deed, rounds)

    def follow(self, *, submits: bool) -> None:
        """What comes now waits until the last key has done what it does; ``submits``: by way of a message."""
        if self._deed is None:
            self.do(lambda: None, ROUNDS if submits else 0)

    def _first(self) -> MessagePump:
        return self._app.focused or self._app.screen

    def _pass_on(self, pump: MessagePump, deed: Deed, rounds: int) -> None:
        """To the end of one queue after the other, as keys that nobody takes go."""
        if pump is not self._app:
            pump.call_later(self._pass_on, pump._parent or self._app, deed, rounds)
        elif rounds:
            pump.call_later(self._pass_on, self._first(), deed, rounds - 1)
        elif deed is self._deed:
            pump.call_later(self._act)

    async def _act(self) -> None:
        deed, self._deed = self._deed, None
        if self._patience is not None:
            self._patience.stop()
            self._patience = None
        if deed is not None:
            deed()
        while self._held and self._deed is None:
            await self._feed(self._held.popleft())
