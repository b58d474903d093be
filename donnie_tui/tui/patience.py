"""Whatever takes longer than a second is told in words, and then again and again; the screen goes on."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Protocol, TypeVar

from textual.timer import Timer

from donnie_tui.commands.interaction import SLOW, SLOW_AGAIN

T = TypeVar("T")


class Clock(Protocol):
    """Whoever has timers."""

    def later(self, seconds: float, do: Callable[[], None]) -> Timer: ...

    def every(self, seconds: float, do: Callable[[], None]) -> Timer: ...


class Reminder:
    """Tells of what takes long until it is stopped."""

    def __init__(self, clock: Clock, tell: Callable[[], None]) -> None:
        self._timers = (clock.later(SLOW, tell), clock.every(SLOW_AGAIN, tell))

    def stop(self) -> None:
        for each in self._timers:
            each.stop()


async def patiently(clock: Clock, do: Callable[[], T], tell_slow: Callable[[], None]) -> T:
    """Do what may take long beside the screen, telling if it does."""
    reminder = Reminder(clock, tell_slow)
    try:
        return await asyncio.to_thread(do)
    finally:
        reminder.stop()
