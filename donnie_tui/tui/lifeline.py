"""What stops the robots when the screen can't: a thread that hears the signals and watches the output.

A terminal that takes no output holds the main thread, and with it every key and every handler of the event
loop. Rules: nothing here waits for that thread; whatever fails, the next signal is heeded. What is left of
the process after a signal is ended in time.
"""

from __future__ import annotations

import os
import select
import signal
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from types import FrameType
from typing import Any

from donnie_tui.process.signals import LEAVING, Deputy, Handler, WakingSignals, attempt, numbers_of, suspend

LOOK = 0.5
"""Seconds between two looks at the output."""
MOST_LOOKS = 5
"""So many at the same waiting piece, and the terminal takes nothing any more. Told again after as many: a key
may have started a robot meanwhile."""
ANSWER = 0.3
"""Seconds in which the screen stops a program by itself, and tells where."""
LEAVE = 2.0
"""Seconds in which the screen leaves by itself after a signal."""
LONGEST_REST = 2.0
"""Seconds that the main thread waits before it rests; it may hold what the robot's stop needs."""

BACK = getattr(signal, "SIGCONT", -1)
"""Told to the screen when the process goes on: whatever ran meanwhile wrote over it."""

_HANGING_UP = getattr(signal, "SIGHUP", signal.SIGTERM)
"""As if it had come: the terminal is gone, where the thread that writes to it has ended."""


class Lifeline:
    """Signals and the output, from ``begin`` to ``end``, both in the main thread."""

    def __init__(
        self,
        *,
        halt: Callable[[], object],
        before_rest: Callable[[], object],
        tell: Callable[[int], object],
        on_stuck: Callable[[], object],
        part: Callable[[int], object],
        writer: Callable[[], Any],
    ) -> None:
        """``halt`` stops all robots, ``tell`` passes a signal on to the screen, ``part`` ends the process.

        ``before_rest``: as ``Console.before_suspending``; ``on_stuck``: the terminal takes nothing;
        ``writer``: Textual's thread that writes, or None.
        """
        self._halt, self._before_rest, self._tell = halt, before_rest, tell
        self._on_stuck, self._part, self._writer = on_stuck, part, writer
        self.answered = threading.Event()
        """The screen has done what an interrupt asks for."""
        self._ended = threading.Event()
        self._leaving: int | None = None
        self._until = 0.0
        self._head: object = None
        self._looks = 0

    def begin(self) -> None:
        """Raises ``ValueError`` outside of the main thread."""
        handlers: dict[int, Handler] = dict.fromkeys((signal.SIGINT, *LEAVING), _woken)
        handlers |= dict.fromkeys(numbers_of("SIGTSTP"), self._rest)
        handlers |= dict.fromkeys(numbers_of("SIGCONT"), self._back)
        self._signals = WakingSignals(handlers)
        self._deputy = Deputy()
        self._thread = threading.Thread(target=self._watch, name="lifeline", daemon=True)
        self._thread.start()

    def end(self) -> None:
        """Everything as it was found."""
        if self._ended.is_set():
            return
        self._ended.set()
        self._signals.give_back()
        self._signals.nudge()
        self._thread.join(LEAVE)
        self._deputy.close()
        if not self._thread.is_alive():  # else it would read from whatever gets the number next
            self._signals.close()

    def _rest(self, number: int, frame: FrameType | None) -> None:
        """Textual gives the terminal back before it rests; the robot comes before that."""
        self._deputy.see_done(self._before_rest, LONGEST_REST)
        own = self._signals.handler_before(number)
        if own is not None:
            own(number, frame)
        else:
            suspend()

    def _back(self, number: int, frame: FrameType | None) -> None:
        """Textual takes the terminal again, but paints nothing where the size is what it was."""
        own = self._signals.handler_before(number)
        if own is not None:
            own(number, frame)
        self._tell(number)

    # --- the thread

    def _watch(self) -> None:
        due = time.monotonic() + LOOK
        while not self._ended.is_set():
            select.select([self._signals], [], [], LOOK)
            for number in self._signals.numbers():
                self._act_on(number)
            if time.monotonic() >= due:  # many signals must not put it off
                attempt(self._look_at_output)
                due = time.monotonic() + LOOK
            if self._leaving is not None and time.monotonic() >= self._until and not self._ended.is_set():
                attempt(partial(self._part, self._leaving))

    def _act_on(self, number: int) -> None:
        if number == signal.SIGINT:
            self._interrupt(number)
        elif number in LEAVING:
            self._leave(number)

    def _interrupt(self, number: int) -> None:
        self.answered.clear()
        attempt(partial(self._tell, number))
        if not self.answered.wait(ANSWER):
            attempt(self._halt)

    def _leave(self, number: int) -> None:
        attempt(self._halt)
        if self._leaving is None:
            self._leaving, self._until = number, time.monotonic() + LEAVE
            attempt(partial(self._tell, number))

    def _look_at_output(self) -> None:
        """Whether a piece of output waits that waited at the last look too."""
        writer = self._writer()
        head = _first(writer)
        self._looks = self._looks + 1 if head is not None and head is self._head else 0
        self._head = head
        if self._looks and self._looks % MOST_LOOKS == 0:
            self._on_stuck()
            if not writer.is_alive():
                self._leave(_HANGING_UP)


def _first(writer: Any) -> object:
    """The oldest piece that nobody has taken."""
    try:
        return writer._queue.queue[0]  # Textual tells nobody that it is stuck
    except (AttributeError, IndexError):
        return None


def _woken(_number: int, _frame: FrameType | None) -> None:
    """The signal's number has gone to the thread by itself."""


def give_back(driver: Any) -> None:
    """The terminal as far as it can be given back at once; it may take nothing, or be gone."""
    import termios

    with suppress(AttributeError, OSError, TypeError, termios.error):
        termios.tcsetattr(driver.fileno, termios.TCSANOW, driver.attrs_before)
    with suppress(OSError):
        os.set_blocking(2, False)
        try:
            os.write(2, _AS_BEFORE)
        finally:
            os.set_blocking(2, True)


_AS_BEFORE = b"\x1b[?1049l\x1b[?25h\x1b[?1000l\x1b[?1003l\x1b[?1006l\x1b[?2004l\x1b[<u\r\n"
"""The normal screen, a cursor, no mouse, no marked pasting, plain keys."""
