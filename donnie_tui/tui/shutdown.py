"""The end of the full screen where nothing else works: by a signal, a lost connection, stuck output, a fault.

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
"""In the folder of the copies: what went wrong at last."""


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

        ``after_keys`` does something once what was typed before has been taken.
        """
        self._app, self._session, self._folder = app, session, folder
        self._stop_all, self._repaint, self._after_keys = stop_all, repaint, after_keys
        self._watchdog: ScreenWatchdog | None = None
        self._readers: ReaderWatch | None = None
        """Of a page: the server may be gone."""

    def begin(self) -> None:
        """From now on a signal or a lost connection ends the screen. SIGINT only stops the program."""
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
        """Call it in the main thread, once nothing is written to the screen any more."""
        if self._readers is not None:
            self._readers.close()
        if self._watchdog is not None:
            self._watchdog.end()

    def close_session(self) -> None:
        """Close the session after ``end_watchdog``. After a signal the process ends in time all the same."""
        left = self._watchdog.left if self._watchdog is not None else None
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
            self._repaint()
        elif number == REST:
            self._session.say("suspend-impossible")
        elif number:
            self.leave(number)
        else:
            self._session.say("stuck-stopped")

    def _interrupt(self) -> None:
        """As the key that stops all."""
        if not self._session.give_up_search() and self._session.runs:
            self._stop_all()
        if self._watchdog is not None:
            self._watchdog.answered.set()

    def leave(self, number: int) -> None:
        """Leaves because of a signal, after the keys that were typed before it."""
        self._session.halt()
        self._session.keep_text()
        self._session.is_leaving = True
        self._after_keys(lambda: self._go(number))

    def _go(self, number: int) -> None:
        self._session.keep_text()
        self._app.exit(128 + number)

    def save_from_fault(self) -> None:
        """Save what can be saved, while an exception that nothing caught is handled."""
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
        """The screen did not leave by itself: what can be saved in a moment, and the end."""

        def save() -> None:
            self._session.keep_text()
            self._session.close()

        def code() -> int:
            give_back(self._app._driver)
            return 128 + number

        end_process(code, (self._session.stop_real_robot, save))

    def _part_from_session(self, number: int) -> None:
        """The text is kept by then."""
        end_process(lambda: 128 + number, (self._session.stop_real_robot,))


LOOK = 0.5
"""Seconds between two looks at the output."""
MOST_LOOKS = 5
"""After so many at the same waiting piece the terminal counts as stuck. It is reported again after as many: a
key may have started a robot meanwhile."""
ANSWER = 0.3
"""Seconds in which the screen stops a program by itself, and says where."""
LEAVE = 2.0
"""Seconds in which the screen leaves by itself after a signal."""
LONGEST_REST = 2.0
"""Seconds that the main thread waits before it rests; it may hold what the robot's stop needs."""

BACK = getattr(signal, "SIGCONT", -1)
"""The signal that the process continues: whatever ran meanwhile wrote over the screen."""

REST = getattr(signal, "SIGTSTP", -2)
"""The signal of Ctrl+Z in other programs; passed on where it can't suspend the process."""

_HANGING_UP = getattr(signal, "SIGHUP", signal.SIGTERM)
"""As if it had come: the terminal is gone, where the thread that writes to it has ended."""


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
        """The screen has done what an interrupt asks for."""
        self._is_leaving = False
        self._head: object = None
        self._looks = 0
        self._due = time.monotonic() + LOOK

    def _rest(self, number: int, frame: FrameType | None) -> None:
        """Textual gives the terminal back before it rests; the robot comes before that."""
        if not can_suspend():
            self._notify(number)
            return
        self.deputy.see_done(self._before_rest, LONGEST_REST)
        found = self.handler_before(number)
        if found is not None:
            found(number, frame)
        else:
            suspend()

    def _back(self, number: int, frame: FrameType | None) -> None:
        """Textual takes the terminal again, but paints nothing if the size is what it was."""
        found = self.handler_before(number)
        if found is not None:
            found(number, frame)
        self._notify(number)

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
        """Leave if it is gone; report a piece of output that waited at the last look too."""
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
    """The oldest piece that is not written yet."""
    try:
        return writer._queue.queue[0]  # Textual does not report that it is stuck
    except (AttributeError, IndexError):
        return None


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
