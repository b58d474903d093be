"""Keys in their turn, with queues that are emptied by hand and a clock that is moved by hand."""

import asyncio
from collections import deque
from collections.abc import Awaitable, Callable
from functools import partial
from types import SimpleNamespace

from donnie_tui.tui.keyboard import LOOKS, KeyQueue


class Pump:
    """What has a queue."""

    def __init__(self, parent: "Pump | None" = None) -> None:
        self._parent = parent
        self.queue: deque[Callable[[], Awaitable[None] | None]] = deque()
        self.is_closing = False

    def call_later(self, do, *given) -> bool:
        """As Textual's: False if it takes nothing any more, because it is closing."""
        if not self.is_closing:
            self.queue.append(partial(do, *given))
        return not self.is_closing

    async def work(self, most: int = 1000) -> None:
        while self.queue and most:
            most -= 1
            waiting = self.queue.popleft()()
            if waiting is not None:
                await waiting


class Timer:
    """As Textual's: what it calls runs in a task of its own, which ends when it is stopped."""

    def __init__(self, call: Callable[[], object]) -> None:
        self._call = call
        self._task: asyncio.Task | None = None

    async def ring(self) -> None:
        async def ringing() -> None:
            waiting = self._call()
            if waiting is not None:
                await waiting

        self._task = asyncio.create_task(ringing())
        await asyncio.wait([self._task])

    def stop(self) -> None:
        if self._task is not None:
            self._task.cancel()


class Application(Pump):
    """An application with a widget that has the focus, and what was done in it."""

    def __init__(self) -> None:
        super().__init__()
        self.focused = Pump(self)
        self.timers: list[Timer] = []
        self.done: list[str] = []
        self.turns = KeyQueue(self, self._feed)

    def set_timer(self, _seconds: float, call: Callable[[], object]) -> Timer:
        self.timers.append(Timer(call))
        return self.timers[-1]

    async def _feed(self, key: SimpleNamespace) -> None:
        await asyncio.sleep(0)
        self.done.append(key.name)
        if key.name.startswith("F"):
            self.turns.do(partial(self.done.append, f"{key.name} done"))

    def press(self, *names: str) -> None:
        for name in names:
            self.turns.hold(SimpleNamespace(name=name))

    def do(self, name: str) -> None:
        self.turns.do(partial(self.done.append, name))

    async def time_out(self) -> None:
        for _ in range(LOOKS):
            await self.timers[-1].ring()

    async def go_on(self) -> None:
        for _ in range(100):
            await self.focused.work()
            await self.work()


async def test_a_command_does_not_overtake_earlier_letters_on_a_slow_machine():
    app = Application()
    app.focused.call_later(app.done.append, "letter")
    app.do("run")
    for _ in range(LOOKS - 1):
        await app.timers[-1].ring()
    await app.focused.work(1)  # a step, at last
    await app.work(1)

    for _ in range(LOOKS - 1):
        await app.timers[-1].ring()

    assert app.done == ["letter"]
    await app.go_on()
    assert app.done == ["letter", "run"]


async def test_keys_after_a_command_of_a_removed_widget_are_all_handled_once():
    app = Application()
    app.do("run")
    app.focused = Pump(app)  # the other one is gone, with its queue
    app.press("a", "b", "c")
    await app.time_out()
    await app.work()

    assert app.done == ["run", "a", "b", "c"]
    assert not app.turns.is_holding


async def test_a_command_whose_widget_is_closing_takes_the_rest_of_its_way_at_once():
    app = Application()
    panel = Pump(app)
    app.focused = row = Pump(panel)
    app.do("run")
    app.press("a", "b")
    panel.is_closing, app.focused = True, Pump(app)
    await row.work()
    await app.go_on()

    assert app.done == ["run", "a", "b"]  # no timer rang


async def test_a_command_after_its_timeout_is_not_repeated_nor_the_next_one_early():
    app = Application()
    app.do("run")
    slow, app.focused = app.focused, Pump(app)
    await app.time_out()
    await app.work()
    app.focused.call_later(app.done.append, "letter")
    app.do("save")
    for _ in range(20):  # the first one's way, to its end
        await slow.work()
        await app.work()

    assert app.done == ["run"]
    await app.go_on()
    assert app.done == ["run", "letter", "save"]


async def test_a_command_after_another_one_waits_for_it_and_none_is_lost():
    app = Application()
    app.do("run")
    app.do("save")
    app.press("a", "F", "b")
    await app.go_on()

    assert app.done == ["run", "save", "a", "F", "F done", "b"]
    assert not app.turns.is_holding
