"""Ends the full screen after a signal, a lost connection, stuck output or a fault.

A terminal that takes no output holds the main thread, and with it every key and every handler of the event
loop. So the watchdog, which gets the signals, watches the output too. It takes the next signal whatever
fails. The robots halt first, then the text is kept; the process ends in time.
"""

from __future__ import annotations

import asyncio
import os
import select
import signal
import threading
import time
import traceback
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from pathlib import Path
from types import FrameType
from typing import Any

from textual.app import App

from donnie_tui.process.confinement import make_folder, open_text
from donnie_tui.process.disconnection import ReaderWatch
from donnie_tui.process.signals import (
    LEAVING,
    Handler,
    Watchdog,
    attempt,
    can_suspend,
    end_process,
    heeded,
    is_hung_up,
    numbers_of,
    suspend,
)
from donnie_tui.tui.environment import is_page
from donnie_tui.tui.startup import SessionHandle

CRASHED = 1
"""The return code of Textual after an internal error; the text is kept for the next start."""
FAULT = "fault.txt"
"""The file with the last fault, in the folder of the copies."""


class Shutdown:
    """Takes signals and faults from ``begin`` to ``end_watchdog``."""

    def __init__(
        self,
        app: App[int],
        session: SessionHandle,
        folder: Path,
        *,
        stop_all: Callable[[], object],
        repaint: Callable[[], object],
        after_keys: Callable[[Callable[[], None]], object],
    ) -> None:
        """``folder`` holds the copies; ``stop_all`` is as the key of that name.

        ``after_keys`` runs a function after the keys typed before.
        """
        self._app, self._session, self._folder = app, session, folder
        self._stop_all, self._repaint, self._after_keys = stop_all, repaint, after_keys
        self._watchdog: ScreenWatchdog | None = None
        self._readers: ReaderWatch | None = None
        """Readers of a page's server, which may be gone."""

    def begin(self) -> None:
        """Handle signals and a lost connection, which end the screen. SIGINT only stops the program."""
        loop = asyncio.get_running_loop()

        def notify(number: int) -> None:
            with suppress(RuntimeError):  # the loop may be gone
                loop.call_soon_threadsafe(self._signalled, number)

        def stuck() -> None:
            if self._session.stop_real_robot():
                notify(0)

        watchdog = ScreenWatchdog(
            halt=self._session.halt,
            before_rest=self._session.stop_real_robot,
            notify=notify,
            on_stuck=stuck,
            part=self._part,
            writer=lambda: getattr(self._app._driver, "_writer_thread", None),
        )
        with suppress(ValueError):
            watchdog.begin()
            self._watchdog = watchdog
            if is_page():
                self._readers = ReaderWatch()

    def end_watchdog(self) -> None:
        """End the watchdog. Call it in the main thread, once nothing is written to the screen any more.

        It also ends Textual's thread that reads keys: Textual itself ends it only after a last write, which a
        closed terminal does not take.
        """
        if (ended := getattr(self._app._driver, "exit_event", None)) is not None:
            ended.set()
        if self._readers is not None:
            self._readers.close()
        if self._watchdog is not None:
            self._watchdog.end()

    @property
    def left(self) -> tuple[int, float] | None:
        """The signal that ends the process, and when it came."""
        return self._watchdog.left if self._watchdog is not None else None

    def close_session(self) -> None:
        """Close the session after ``end_watchdog``. After a signal the process still ends in time."""
        left = self.left
        if left is None:
            self._session.close()
            return
        with Watchdog({}, part=self._part_from_session) as watchdog:
            watchdog.leave(*left)
            self._session.close()

    # --- in the screen's thread

    def _signalled(self, number: int) -> None:
        if number == signal.SIGINT:
            self._interrupt()
        elif number == BACK:
            if self._watchdog is not None:
                self._watchdog.back()
            self._repaint()
        elif number == REST:
            if self._watchdog is None or not self._watchdog.rest():
                self._session.say("suspend-impossible")
        elif number:
            self.leave(number)
        else:
            self._session.say("stuck-stopped")

    def _interrupt(self) -> None:
        """Stop all programs, as the key for it does."""
        if not self._session.give_up_search() and self._session.runs:
            self._stop_all()
        if self._watchdog is not None:
            self._watchdog.answered.set()

    def leave(self, number: int) -> None:
        """Leave because of a signal, after the keys typed before it."""
        self._session.halt()
        self._session.keep_text()
        self._session.is_leaving = True
        self._after_keys(lambda: self._go(number))

    def _go(self, number: int) -> None:
        self._session.keep_text()
        self._app.exit(128 + number)

    def save_from_fault(self) -> None:
        """Save what can be saved while an uncaught exception is handled."""
        with suppress(Exception):
            self._session.halt()
        with suppress(Exception):
            self._session.keep_text()
        with suppress(OSError):
            make_folder(self._folder)
            with open_text(self._folder / FAULT, "w") as file:
                file.write(traceback.format_exc())

    # --- in the thread of the watchdog

    def _part(self, number: int) -> None:
        """End the process if the screen does not leave by itself, after saving what a moment allows."""

        def save() -> None:
            self._session.keep_text()
            self._session.close()

        def code() -> int:
            give_back(self._app._driver)
            return 128 + number

        end_process(code, (self._session.stop_real_robot, save))

    def _part_from_session(self, number: int) -> None:
        """End the session, after the text was kept."""
        end_process(lambda: 128 + number, (self._session.stop_real_robot,))


LOOK = 0.5
"""Seconds between two checks of the output."""
MOST_LOOKS = 5
"""Checks with the same waiting piece, after which the terminal counts as stuck, and again after as many: a
key may have started a robot meanwhile."""
ANSWER = 0.3
"""Seconds that the screen has to stop a program by itself, and to say where."""
LEAVE = 2.0
"""Seconds that the screen has to leave by itself after a signal."""
LONGEST_REST = 2.0
"""Seconds that the main thread waits before a suspension; it may hold a lock that the stop needs."""

BACK: int = signal.SIGCONT if hasattr(signal, "SIGCONT") else -1
"""The signal that the process continues; other programs may have written over the screen."""

REST: int = signal.SIGTSTP if hasattr(signal, "SIGTSTP") else -2
"""The signal of Ctrl+Z in other programs."""

_HANGING_UP = signal.SIGHUP if hasattr(signal, "SIGHUP") else signal.SIGTERM
"""Handled as if it had come: the terminal is gone if the thread that writes to it has ended."""


class ScreenWatchdog(Watchdog):
    """Watches the output too. From ``begin`` to ``end``, both in the main thread."""

    def __init__(
        self,
        *,
        halt: Callable[[], object],
        before_rest: Callable[[], object],
        notify: Callable[[int], object],
        on_stuck: Callable[[], object],
        part: Callable[[int], object],
        writer: Callable[[], Any],
    ) -> None:
        """``halt`` stops all robots, ``notify`` passes a signal on to the screen, ``part`` ends the process.

        ``before_rest``: as ``Console.before_suspending``; ``on_stuck``: the terminal takes nothing;
        ``writer``: Textual's thread that writes, or None.
        """
        handlers: dict[int, Handler] = dict.fromkeys((signal.SIGINT, *LEAVING), heeded)
        handlers |= dict.fromkeys(numbers_of("SIGTSTP"), self._rest)
        handlers |= dict.fromkeys(numbers_of("SIGCONT"), self._back)
        super().__init__(handlers, part=part, halt=halt, on_number=self._act_on, leave=LEAVE)
        self._before_rest, self._notify = before_rest, notify
        self._on_stuck, self._writer = on_stuck, writer
        self.answered = threading.Event()
        """Set once the screen has handled an interrupt."""
        self._awaited_backs = 0
        """Suspensions after which the terminal was taken again before their signal ``BACK`` was handled."""
        self._is_leaving = False
        self._head: object = None
        self._looks = 0
        self._due = time.monotonic() + LOOK

    def _rest(self, number: int, _frame: FrameType | None) -> None:
        """Stop the robot at once, and let the screen suspend the process.

        Textual takes locks for a suspension, which the interrupted main thread may hold.
        """
        if can_suspend():
            self.deputy.see_done(self._before_rest, LONGEST_REST)
        self._notify(number)

    def _back(self, number: int, _frame: FrameType | None) -> None:
        self._notify(number)

    # --- in the screen's thread, outside of any handler

    def rest(self) -> bool:
        """Suspend the process until it is continued. False if nothing would continue it."""
        if not can_suspend():
            return False
        self.deputy.see_done(self._before_rest, LONGEST_REST)  # a key may have started it meanwhile
        found = self._signals.handler_before(REST)
        if found is not None:
            found(REST, None)
        else:
            suspend()
        self._take_terminal()
        self._awaited_backs += 1
        return True

    def back(self) -> None:
        """Take the terminal again after a suspension, unless ``rest`` has done that."""
        if self._awaited_backs:
            self._awaited_backs -= 1
        else:
            self._take_terminal()

    def _take_terminal(self) -> None:
        found = self._signals.handler_before(BACK)
        if found is not None:
            found(BACK, None)

    # --- the thread

    def _wait(self) -> None:
        select.select([self._signals], [], [], LOOK)
        if time.monotonic() >= self._due:  # many signals must not put it off
            attempt(self._look_at_terminal)
            self._due = time.monotonic() + LOOK

    def _act_on(self, number: int) -> None:
        if number == signal.SIGINT:
            self._interrupt(number)
        elif number in LEAVING and not self._is_leaving:
            self._is_leaving = True
            self._notify(number)

    def _interrupt(self, number: int) -> None:
        self.answered.clear()
        attempt(partial(self._notify, number))
        if not self.answered.wait(ANSWER):
            self.deputy.do(self._halt)

    def _look_at_terminal(self) -> None:
        """Leave if the terminal is gone; report output that has not been written since the last check."""
        if is_hung_up(0):  # an idle screen writes nothing, and no signal may come
            self._hang_up()
        writer = self._writer()
        head = _first(writer)
        self._looks = self._looks + 1 if head is not None and head is self._head else 0
        self._head = head
        if self._looks and self._looks % MOST_LOOKS == 0:
            self._on_stuck()
            if not writer.is_alive():
                self._hang_up()

    def _hang_up(self) -> None:
        self.leave(_HANGING_UP)
        self._act_on(_HANGING_UP)


def _first(writer: Any) -> object:
    """The oldest piece of output that is not written yet."""
    try:
        return writer._queue.queue[0]  # Textual does not report that it is stuck
    except (AttributeError, IndexError):
        return None


def give_back(driver: Any) -> None:
    """Restore the terminal as far as possible at once; it may take no output, or be gone."""
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
"""Sequences for the normal screen: a cursor, no mouse, no bracketed paste, plain keys."""
