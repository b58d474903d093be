"""Standard input and output, and everything that the linear mode waits for: keys, signals, news, slow tasks.

A signal only wakes the main thread, which decides what follows, between two steps and never in the middle of
one. The exceptions are a terminal that takes no more output and a search for a robot: the main thread could
not notice Ctrl+C then. So it has ``stop_at_once`` called in another thread (Ctrl+Z ``before_suspending``), or
calls ``give_up`` itself, which takes no lock. A main thread that hangs decides nothing: then the watchdog
does what is in ``last``, and ends the process.
"""

from __future__ import annotations

import os
import select
import signal
import threading
import time
from collections import deque
from collections.abc import Callable, Sequence
from typing import TypeVar

from donnie_tui.commands.interaction import SLOW, SLOW_AGAIN, GivenUp
from donnie_tui.linear.greeting import Terminal
from donnie_tui.process.disconnection import ReaderWatch
from donnie_tui.process.signals import (
    LEAVING,
    Nudges,
    Task,
    Watchdog,
    can_suspend,
    end_process,
    suspend,
)

T = TypeVar("T")

MOST_AHEAD = 64 * 1024
"""Bytes that are taken from the terminal before they are read as lines."""
_TAKEN = (signal.SIGINT, signal.SIGTSTP, *LEAVING)


class Gone(Exception):
    """Raised when the terminal takes no more output, or a signal ends Donnie.

    It is no ``OSError``, because a problem with a file ends no conversation.
    """


class Console:
    """Standard input and output with their signals. ``close`` leaves everything as it was found."""

    def __init__(self, terminal: Terminal | None) -> None:
        """``terminal`` is None where lines can't be edited key by key."""
        self.interrupted = False
        """Whether Ctrl+C was pressed and had no effect yet."""
        self.has_news = False
        """Whether something was published that can't wait until the line is finished."""
        self.leaving: int | None = None
        """The signal that ends Donnie."""
        self.stop_at_once: Callable[[], None] = lambda: None
        self.give_up: Callable[[], bool] = lambda: False
        """Ends a search for a robot, which keeps the main thread from waiting here; whether there was one."""
        self._has_given_up = False
        self.last: Sequence[Task] = ()
        """Stops the robot and keeps the text, in parallel, if the main thread hangs at the end."""
        self.has_run_away: Callable[[], bool] = lambda: False
        """Whether the robot still drives after every attempt to stop it."""
        self.before_suspending: Callable[[], object] = lambda: None
        """Stops a robot that can't be left alone, and returns once it stands."""
        self.on_not_suspended: Callable[[], object] = lambda: None
        """Says that Ctrl+Z has no effect here."""
        self.on_key: Callable[[], None] | None = None
        """Called as soon as something is typed, Ctrl+C included, even if it is read much later."""
        self.lines_wait: Callable[[], bool] = lambda: False
        """Whether lines wait that are printed as soon as no line is being typed."""
        self.when_idle: Callable[[], None] | None = None
        """Called before a wait, if all that was typed is read."""
        self.once_idle: list[Callable[[], None]] = []
        """Each called once, before a wait for a line: they don't delay a running program."""
        self._ahead = b""
        """What was typed while no line was being read."""
        self.repaint: Callable[[], str] = str
        """The text of the current line, which is written again after a suspension."""
        self._terminal = terminal
        self._is_writing = False
        self._numbers = deque[int]()
        """Signals that were not acted on yet."""
        self._nudges = Nudges()
        self._watchdog = Watchdog(
            dict.fromkeys(_TAKEN, self._on_signal), part=self._part, on_number=self._pass_on
        )
        self._watchdog.begin()
        self._watch = ReaderWatch()
        if terminal:
            terminal.take()

    def edit(self, on: bool) -> None:
        """Let Donnie edit lines key by key (``on``), or leave editing to the terminal."""
        if self._terminal and on:
            self._terminal.take()
        elif self._terminal:
            self._terminal.give_back()

    @property
    def code_when_gone(self) -> int:
        """The exit code after ``Gone``."""
        return 128 + (self.leaving or signal.SIGHUP)

    # --- waiting

    def now(self) -> float:
        """Seconds of real time, from an arbitrary start."""
        return time.monotonic()

    def nudge(self) -> None:
        """Wake the main thread. From any thread."""
        self._nudges.nudge()

    def wait(self, seconds: float | None = None, *, reading: bool = False) -> bool:
        """Wait for a signal, a nudge, or (``reading``) input, at most so long. True if there is input."""
        is_watching = reading or (self.on_key is not None and len(self._ahead) < MOST_AHEAD)
        watched: list[Nudges | int] = [self._nudges, 0] if is_watching else [self._nudges]
        at_once = seconds == 0 or (reading and bool(self._ahead))
        has_to_do = self.when_idle is not None or (reading and bool(self.once_idle))
        if has_to_do and not at_once and not (is_watching and _has_typed()):
            self._work_while_idle(reading)
        ready, _, _ = select.select(watched, [], [], 0 if at_once else seconds)
        self._watchdog.take()
        if self._numbers or self._nudges in ready:
            self._nudges.numbers()
        while self._numbers:
            self._act_on(self._numbers.popleft())
        if 0 in ready and not reading:
            self._read_ahead()
        return reading and (0 in ready or bool(self._ahead))

    def _work_while_idle(self, reading: bool) -> None:
        if self.when_idle is not None:
            self.when_idle()
        while reading and self.once_idle:
            self.once_idle.pop()()

    def has_input(self) -> bool:
        """Whether something was typed already; signals and nudges are left to the next wait."""
        return bool(self._ahead) or _has_typed()

    def read(self) -> bytes:
        """Read what was typed; nothing once input has ended. Call it when ``wait`` reports input."""
        ahead, self._ahead = self._ahead, b""
        return ahead or self._typed()

    def _read_ahead(self) -> None:
        """Report keys at once, also while a long answer is printed. The end of the input is found again."""
        typed = self._typed()
        self._ahead += typed
        if not typed:
            self.on_key = None

    def _typed(self) -> bytes:
        try:
            data = os.read(0, 4096)
        except OSError:
            return b""
        if self.on_key is not None:
            self.on_key()
        return data

    def rest(self, seconds: float) -> None:
        """Wait for that time, even if something happens meanwhile."""
        until = self.now() + seconds
        while (left := until - self.now()) > 0:
            self.wait(left)

    def is_disturbed_within(self, seconds: float, *, reading: bool) -> bool:
        """Wait so long. Whether Ctrl+C, a signal or (``reading``) a key came before."""
        until = self.now() + seconds
        while (left := until - self.now()) > 0:
            if self.wait(left, reading=reading) or self.take_interrupt() or self.leaving is not None:
                return True
        return False

    def take_interrupt(self) -> bool:
        """Whether Ctrl+C was pressed since the last time."""
        interrupted, self.interrupted = self.interrupted, False
        return interrupted

    def pressed_interrupt(self) -> bool:
        """As ``take_interrupt``, a Ctrl+C included that has woken no wait yet."""
        self.wait(0)
        return self.take_interrupt()

    def take_news(self) -> bool:
        """Whether there is something that can't wait, since the last time."""
        has_news, self.has_news = self.has_news, False
        return has_news

    def _act_on(self, number: int) -> None:
        if number == signal.SIGINT:
            self.interrupted, self._has_given_up = not self._has_given_up, False
            if self.on_key is not None:
                self.on_key()
        elif number in LEAVING:
            self.leaving = self.leaving or number
        elif number == signal.SIGTSTP:
            self._suspend()

    def _pass_on(self, number: int) -> None:
        """Pass a signal on to the main thread, from any thread."""
        self._numbers.append(number)
        self._nudges.nudge()

    def _part(self, number: int) -> None:
        """End the process without the main thread, which hangs; restore the terminal as far as possible."""
        returned = (self._terminal.give_back,) if self._terminal else ()
        end_process(lambda: 1 if self.has_run_away() else 128 + number, (*self.last, *returned))

    def _suspend(self) -> None:
        """Ctrl+Z: stop the robot and give the terminal back until the process is continued."""
        if not can_suspend():
            self.on_not_suspended()
            self.has_news = True
            return
        self.before_suspending()
        if self._terminal:
            self._terminal.give_back()
        suspend()
        if self._terminal:
            self._terminal.take()
            self.write(self.repaint())

    def _on_signal(self, number: int, frame: object) -> None:  # noqa: ARG002 -- a signal handler is given both
        if number == signal.SIGTSTP:
            # the suspension follows once output is taken; the robot can't wait for that
            if self._is_writing and can_suspend():
                self._watchdog.deputy.do(self.before_suspending)
            return
        if self.give_up():
            self._has_given_up = self._has_given_up or number == signal.SIGINT
        if self._is_writing:
            self._is_writing = False
            self._watchdog.deputy.do(self.stop_at_once)

    # --- writing

    def write(self, text: str) -> None:
        """Write all of it at once. Raises ``Gone`` where the output is closed."""
        data = memoryview(text.encode("utf-8", "replace"))
        while data:
            self._is_writing = True
            try:
                written = os.write(1, data)
            except OSError:
                raise Gone from None
            finally:
                self._is_writing = False
            data = data[written:]

    def columns(self) -> int:
        return _size()[0]

    def rows(self) -> int:
        return _size()[1]

    def close(self) -> None:
        self._watch.close()
        if self._terminal:
            self._terminal.give_back()
        self._watchdog.end()
        self._nudges.close()


def run_in_background(
    console: Console,
    task: Callable[[], T],
    report: Callable[[], object],
    *,
    first: float = SLOW,
    show: Callable[[], object] = lambda: None,
    may_be_left: bool = False,
) -> T:
    """Run ``task`` in a thread of its own and return its result; call ``report`` each time it still runs.

    The main thread waits, so that signals count. ``first`` is the time until the first report; ``show``
    prints what the task itself publishes. Raises what the task raises, ``Gone`` for a signal that ends
    Donnie, and ``GivenUp`` for Ctrl+C if the task ``may_be_left``, since it changes nothing.
    """
    results: list[T] = []
    problems: list[BaseException] = []

    def run() -> None:
        try:
            results.append(task())
        except BaseException as problem:  # noqa: BLE001 -- raised again by the main thread
            problems.append(problem)
        console.nudge()

    def is_over() -> bool:
        return bool(results or problems)

    def must_end() -> bool:
        return console.leaving is not None or (may_be_left and console.interrupted)

    threading.Thread(target=run, name="background", daemon=True).start()
    due = console.now() + first
    while not is_over():
        if not must_end():
            console.wait(max(0.0, due - console.now()))
        if must_end() and not is_over():
            if console.leaving is not None:
                raise Gone
            console.take_interrupt()
            raise GivenUp
        if console.now() >= due and not is_over():
            report()
            due = console.now() + SLOW_AGAIN
        show()
    if problems:
        raise problems[0]
    return results[0]


def _has_typed() -> bool:
    return bool(select.select([0], [], [], 0)[0])


def _size() -> tuple[int, int]:
    """Columns and rows, 80 by 24 where they are unknown."""
    try:
        columns, rows = os.get_terminal_size(1)
    except OSError:
        return 80, 24
    return columns or 80, rows or 24
