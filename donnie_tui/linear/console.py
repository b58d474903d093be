"""Everything that the linear mode waits for: keys, signals, and news from a running program.

Rule: signals do nothing by themselves but wake whoever waits; what follows from them is decided in the
main thread, between two steps and never in the middle of one. The exceptions are a terminal that takes no
more output and a search for a robot: then Ctrl+C could not be noticed, so it has ``stop_at_once``
called in another thread (Ctrl+Z ``before_suspending``), or calls ``give_up``, which takes no lock, itself.
"""

from __future__ import annotations

import os
import select
import signal
import time
from collections.abc import Callable

from donnie_tui.linear.terminal import Terminal, size
from donnie_tui.process.disconnection import ReaderWatch
from donnie_tui.process.signals import LEAVING, Deputy, WakingSignals, suspend

MOST_AHEAD = 64 * 1024
"""Bytes that are taken from the terminal before somebody reads them."""
_HEARD = (signal.SIGINT, signal.SIGTSTP, *LEAVING)


class Gone(Exception):
    """Nobody is there any more: the terminal takes nothing, or a signal wants us to leave.

    No ``OSError``: what goes wrong with a file ends no conversation.
    """


class Console:
    """Standard input and output with their signals. ``close`` leaves everything as it was found."""

    def __init__(self, terminal: Terminal | None) -> None:
        """``terminal`` is there where lines are edited key by key."""
        self.interrupted = False
        """Ctrl+C was pressed and nobody has answered yet."""
        self.has_news = False
        """Something was told that can't wait until the line is finished."""
        self.leaving: int | None = None
        """The signal that wants us to leave."""
        self.stop_at_once: Callable[[], None] = _nothing
        self.give_up: Callable[[], bool] = _nothing_waits
        """Ends a search for a robot, during which nobody waits here; whether there was one."""
        self._has_given_up = False
        self.before_suspending: Callable[[], object] = _nothing
        """Stops what can't be left alone, and returns once it stands."""
        self.on_key: Callable[[], None] | None = None
        """Called as soon as something is typed, Ctrl+C included, though nobody may read it for a while."""
        self.lines_wait: Callable[[], bool] = _nothing_waits
        """Whether something was told that is printed as soon as no line is being typed."""
        self.when_idle: Callable[[], None] | None = None
        """Called before somebody waits, with nothing typed that was not read."""
        self.once_idle: list[Callable[[], None]] = []
        """The same, each once, and while a line is waited for: a program that runs is not held up."""
        self._ahead = b""
        """What was typed where nobody was reading."""
        self.repaint: Callable[[], str] = str
        """What stands on the current line, to be written again after a suspension."""
        self._terminal = terminal
        self._is_writing = False
        self._deputy = Deputy()
        self._signals = WakingSignals(dict.fromkeys(_HEARD, self._heard))
        self._watch = ReaderWatch()
        if terminal:
            terminal.take()

    def edit(self, on: bool) -> None:
        """Whether lines are edited key by key, or by the terminal itself."""
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
        self._signals.nudge()

    def wait(self, seconds: float | None = None, *, reading: bool = False) -> bool:
        """Wait for a signal, a nudge, or (``reading``) input, at most so long. True if there is input."""
        is_watching = reading or (self.on_key is not None and len(self._ahead) < MOST_AHEAD)
        watched: list[WakingSignals | int] = [self._signals, 0] if is_watching else [self._signals]
        at_once = seconds == 0 or (reading and bool(self._ahead))
        has_to_do = self.when_idle is not None or (reading and bool(self.once_idle))
        if has_to_do and not at_once and not (is_watching and _has_typed()):
            self._use_the_time(reading)
        ready, _, _ = select.select(watched, [], [], 0 if at_once else seconds)
        if self._signals in ready:
            self._take_signals()
        if 0 in ready and not reading:
            self._look_ahead()
        return reading and (0 in ready or bool(self._ahead))

    def _use_the_time(self, reading: bool) -> None:
        if self.when_idle is not None:
            self.when_idle()
        while reading and self.once_idle:
            self.once_idle.pop()()

    def has_input(self) -> bool:
        """Whether something was typed already; signals and nudges are left to whoever waits."""
        return bool(self._ahead) or _has_typed()

    def read(self) -> bytes:
        """What was typed; nothing once input has ended. Call it when ``wait`` said so."""
        ahead, self._ahead = self._ahead, b""
        return ahead or self._typed()

    def _look_ahead(self) -> None:
        """Keys count at once, also while a long answer is printed. The end of the input is found again."""
        typed = self._typed()
        self._ahead += typed
        if not typed:
            self.on_key = None

    def _typed(self) -> bytes:
        try:
            data = os.read(0, 4096)
        except OSError:
            return b""
        self._tell_of_key()
        return data

    def _tell_of_key(self) -> None:
        if self.on_key is not None:
            self.on_key()

    def rest(self, seconds: float) -> None:
        """Let that time pass, whatever happens."""
        until = self.now() + seconds
        while (left := until - self.now()) > 0:
            self.wait(left)

    def take_interrupt(self) -> bool:
        """Whether Ctrl+C was pressed since the last time."""
        interrupted, self.interrupted = self.interrupted, False
        return interrupted

    def pressed_interrupt(self) -> bool:
        """As ``take_interrupt``, one that has just come and woken nobody yet included."""
        self.wait(0)
        return self.take_interrupt()

    def take_news(self) -> bool:
        """Whether there is something that can't wait, since the last time."""
        has_news, self.has_news = self.has_news, False
        return has_news

    def _take_signals(self) -> None:
        for number in self._signals.numbers():
            self._act_on(number)

    def _act_on(self, number: int) -> None:
        if number == signal.SIGINT:
            self.interrupted, self._has_given_up = not self._has_given_up, False
            self._tell_of_key()
        elif number in LEAVING:
            self.leaving = self.leaving or number
        elif number == signal.SIGTSTP:
            self._suspend()

    def _suspend(self) -> None:
        """Ctrl+Z: no robot drives, the terminal as it was, until we are brought back."""
        self.before_suspending()
        if self._terminal:
            self._terminal.give_back()
        suspend()
        if self._terminal:
            self._terminal.take()
            self.write(self.repaint())

    def _heard(self, number: int, frame: object) -> None:  # noqa: ARG002 -- a signal handler is given both
        if number == signal.SIGTSTP:
            if self._is_writing:  # we rest once output is taken again; the robot can't wait for that
                self._deputy.do(self.before_suspending)
            return
        if self.give_up():
            self._has_given_up = self._has_given_up or number == signal.SIGINT
        if self._is_writing:
            self._is_writing = False
            self._deputy.do(self.stop_at_once)

    # --- writing

    def write(self, text: str) -> None:
        """Write all of it at once. Raises ``Gone`` where nobody listens any more."""
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
        return size()[0]

    def rows(self) -> int:
        return size()[1]

    def close(self) -> None:
        self._watch.close()
        if self._terminal:
            self._terminal.give_back()
        self._signals.give_back()
        self._deputy.close()
        self._signals.close()


def _has_typed() -> bool:
    return bool(select.select([0], [], [], 0)[0])


def _nothing() -> None:
    return


def _nothing_waits() -> bool:
    return False
