"""What is about to be in front of the workplace: a question, a list, something to read.

Rule: what is typed behind the key of a question is its answer, and what is typed behind the answer is for
where that leads. So keys wait from when an action that asks begins until its question is there, and from the
answer until the action is done; no longer than a moment, for some of them look for robots.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from textual.app import App
from textual.screen import Screen
from textual.timer import Timer

from donnie_tui.commands.interaction import SLOW


class Coming:
    """Told of actions that ask, and of screens; ``let_keys`` lets those go on that waited."""

    def __init__(self, app: App[int], place: Screen[None], let_keys: Callable[[], None]) -> None:
        self._app, self._place, self._let_keys = app, place, let_keys
        self._asking: object | None = None
        """The action that is under way."""
        self._patience: Timer | None = None
        self._screen: Screen[Any] | None = None
        """What was called for and is not there yet."""
        self._has_gone = False
        """Whether a question has gone since ``forget_gone``."""

    @property
    def holds_keys(self) -> bool:
        in_front = self._app.screen
        return in_front is self._screen or (in_front is self._place and self._asking is not None)

    def begins(self) -> object:
        """An action that asks; answers what it is called when it is done."""
        self._asking = object()
        self._wait_a_moment()
        return self._asking

    def done(self, asking: object) -> None:
        """Of an earlier one, in whose place another was asked for, nobody waits any more."""
        if asking is self._asking:
            self._go_on()

    def call_for(self, screen: Screen[Any]) -> None:
        """It is in front from now on, and there once its own queue is emptied."""
        self._screen = screen
        screen.call_later(self._is_there, screen)

    def gone(self, screen: Screen[Any]) -> None:
        """It was answered, or nobody waits for it."""
        self._is_there(screen)
        self._has_gone = True
        if self._asking is not None:
            self._wait_a_moment()

    def forget_gone(self) -> bool:
        """Whether a question has gone since this was asked last."""
        has_gone, self._has_gone = self._has_gone, False
        return has_gone

    def _is_there(self, screen: Screen[Any]) -> None:
        if screen is self._screen:
            self._screen = None
            self._let_keys()

    def _wait_a_moment(self) -> None:
        if self._patience is not None:
            self._patience.stop()
        self._patience = self._app.set_timer(SLOW, self._go_on)

    def _go_on(self) -> None:
        self._asking = None
        if self._patience is not None:
            self._patience.stop()
            self._patience = None
        self._let_keys()
