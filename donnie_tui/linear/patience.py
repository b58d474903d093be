"""What may take long is done beside the conversation, which says after a second that it goes on.

Rule: it is waited for in the main thread, so that signals count; who has to leave waits no longer, nor who
gives up by Ctrl+C what may be left undone.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Generic, TypeVar

from donnie_tui.commands.interaction import SLOW, SLOW_AGAIN, GivenUp
from donnie_tui.linear.console import Console, Gone
from donnie_tui.linear.desk import Desk

T = TypeVar("T")


class _Doing(Generic[T]):
    """Something that is done in a thread of its own."""

    def __init__(self, do: Callable[[], T], nudge: Callable[[], None]) -> None:
        self._do, self._nudge = do, nudge
        self._done: T
        self._problem: BaseException | None = None
        self.is_over = False
        threading.Thread(target=self._run, name="beside", daemon=True).start()

    def _run(self) -> None:
        try:
            self._done = self._do()
        except BaseException as problem:  # noqa: BLE001 -- raised again by whoever waits
            self._problem = problem
        self.is_over = True
        self._nudge()

    def outcome(self) -> T:
        if self._problem is not None:
            raise self._problem
        return self._done


def aside(
    console: Console,
    do: Callable[[], T],
    tell: Callable[[], object],
    *,
    first: float = SLOW,
    show: Callable[[], object] = lambda: None,
    may_be_left: bool = False,
) -> T:
    """Do it, and answer what it answers; ``tell`` each time that it is time to say that it goes on.

    ``show`` prints what it tells itself. Raises what it raises, ``Gone`` for a signal to leave,
    and for Ctrl+C ``GivenUp`` where it ``may_be_left`` since it changes nothing.
    """
    doing = _Doing(do, console.nudge)
    due = console.now() + first

    def must_end() -> bool:
        return console.leaving is not None or (may_be_left and console.interrupted)

    while not doing.is_over:
        if not must_end():
            console.wait(max(0.0, due - console.now()))
        if must_end() and not doing.is_over:
            raise _why(console)
        if console.now() >= due and not doing.is_over:
            tell()
            due = console.now() + SLOW_AGAIN
        show()
    return doing.outcome()


def _why(console: Console) -> Exception:
    if console.leaving is not None:
        return Gone()
    console.take_interrupt()
    return GivenUp()


def patiently(
    desk: Desk,
    do: Callable[[], T],
    code: str,
    *,
    first: float = SLOW,
    may_be_left: bool = False,
    **values: object,
) -> T:
    """As ``aside``, telling it with the sentence ``code``."""
    return aside(
        desk.console,
        do,
        lambda: desk.answer(code, **values),
        first=first,
        show=desk.showing.show_told,
        may_be_left=may_be_left,
    )
