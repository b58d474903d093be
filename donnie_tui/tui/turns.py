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
"""Seconds between two looks at how far the deed has come."""
LOOKS = 4
"""That many looks without a step, and it is done anyway: a widget on the way may have gone. A slow machine
makes steps, and only one look however long it stands still."""

Deed: TypeAlias = Callable[[], None]


class Turns:
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
        self._deed: Deed | None = None
        self._then: deque[tuple[Deed, int]] = deque()
        """What else is to be done, and for how many rounds that goes."""
        self._patience: Timer | None = None
        self._steps = 0

    @property
    def is_holding(self) -> bool:
        """Whether keys have to wait just now."""
        return self._deed is not None or bool(self._held)

    def hold(self, event: Event) -> None:
        """A key that comes after the deed."""
        self._held.append(event)

    def do(self, deed: Deed, rounds: int = ROUNDS) -> None:
        """Do it once everything that came before has been."""
        if self._deed is not None:
            self._then.append((deed, rounds))
            return
        self._deed = deed
        self._pass_on(self._first(), deed, rounds)
        self._look_later(deed, LOOKS)

    def follow(self, *, submits: bool) -> None:
        """What comes now waits until the last key has done what it does; ``submits``: by way of a message."""
        if self._deed is None:
            self.do(lambda: None, ROUNDS if submits else 0)

    def _first(self) -> MessagePump:
        return self._app.focused or self._app.screen

    def _pass_on(self, pump: MessagePump, deed: Deed, rounds: int) -> None:
        """To the end of one queue after the other, as keys that nobody takes go."""
        self._steps += deed is self._deed
        if pump is not self._app:
            pump.call_later(self._pass_on, pump._parent or self._app, deed, rounds)
        elif rounds:
            pump.call_later(self._pass_on, self._first(), deed, rounds - 1)
        else:
            pump.call_later(self._act, deed)

    def _look_later(self, deed: Deed, looks: int) -> None:
        steps = self._steps
        self._patience = self._app.set_timer(PATIENCE, lambda: self._look(deed, looks, steps))

    def _look(self, deed: Deed, looks: int, steps: int) -> None:
        """In the timer's own task, which ends when the timer is stopped: nothing is done here."""
        if deed is not self._deed:
            return
        if self._steps != steps:
            self._look_later(deed, LOOKS)
        elif looks > 1:
            self._look_later(deed, looks - 1)
        else:
            self._app.call_later(self._act, deed)

    async def _act(self, deed: Deed) -> None:
        """Once: what was done already, because it took too long to come, may still come."""
        if deed is not self._deed:
            return
        self._deed = None
        if self._patience is not None:
            self._patience.stop()
            self._patience = None
        deed()
        if self._then and self._deed is None:
            self.do(*self._then.popleft())
        while self._held and self._deed is None and not self._must_wait():
            await self._feed(self._held.popleft())
