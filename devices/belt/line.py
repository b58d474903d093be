"""The belt on its serial line: one thread owns the port, writes what is due and tries again when it is gone.

Rules: nobody waits for the belt, not for a network that doesn't answer either; what can't be sent now is
never sent later; a belt that is missing or lost is told once, and once more when it is back. Closing turns
its motors off.
"""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable
from contextlib import suppress
from enum import Enum
from time import monotonic
from typing import Protocol

from devices.belt.doubt import Doubt, Next
from devices.belt.frame import BAUD, OFF, frame
from devices.belt.sender import PERIOD, BeltSender
from devices.serial_port import GONE, PortProblem, open_port
from devices.telling import Telling

_LOG = logging.getLogger(__name__)

RETRY = 1.0
"""Seconds between two attempts to open a line that was lost."""

LONGEST_REST = 0.5
"""Seconds between two looks at a line on which nothing is due: so soon an unplugged belt is noticed."""

PATIENCE = 2.0
"""Seconds that whoever wants a belt waits for a device of this machine, which opens at once or never; for an
address of the network nobody waits."""

LONGEST_GOODBYE = 1.0
"""Seconds that closing may take: the last pulse, and the frame that turns everything off."""

_MOST_HEARD = 256


class BeltNews(Enum):
    """What is told about the belt."""

    MISSING = "missing"
    """It couldn't be opened, and is not tried again."""
    FOUND = "found"
    """It was opened when nobody waited for that any more."""
    UNANSWERED = "unanswered"
    """It takes what is sent, and never answers as a belt does; what is felt is sent all the same."""
    LOST = "lost"
    RESTORED = "restored"


class Line(Protocol):
    """As much of a serial port as the belt needs."""

    def write(self, data: bytes, /) -> int | None: ...

    def read(self, size: int = 1, /) -> bytes: ...

    def close(self) -> None: ...


def open_line(port: str) -> Line:
    """A serial line at the belt's speed. Raises ``PortProblem``."""
    return open_port(port, BAUD)


class SerialBelt:
    """A belt that shows levels from any thread and answers at once."""

    def __init__(
        self, port: str, on_news: Callable[[BeltNews, str], None], opened: Callable[[str], Line] = open_line
    ):
        """Opens the port. Raises ``PortProblem`` if it is known at once that it can't be; what is known later
        is news. ``on_news`` is called in a thread of its own, with the reason where there is one."""
        self._port = port
        self._telling = Telling(port, on_news)
        self._open = opened
        self._line: Line | None = None
        self._sender = BeltSender()
        self._doubt: Doubt | None = None
        """About the line that is open."""
        self._changed = threading.Condition()
        self._is_closing = False
        self._is_opening = self._is_awaited = True
        self._problem: Exception | None = None
        self._thread = threading.Thread(target=self._work, name="belt", daemon=True)
        self._thread.start()
        self._await_opening(0.0 if "://" in port else PATIENCE)

    def _await_opening(self, seconds: float) -> None:
        with self._changed:
            self._changed.wait_for(lambda: not self._is_opening, seconds)
            self._is_awaited = False
            problem = self._problem
        if problem is not None:
            raise problem

    def show(self, levels: tuple[int, ...]) -> None:
        with self._changed:
            self._sender.show(levels, monotonic())
            self._changed.notify()

    def close(self) -> None:
        """Motors off, once the last pulse was felt, and the port is free. A port that opens only later is
        made dark and let go of then."""
        with self._changed:
            self._is_closing = True
            self._sender.show(OFF, monotonic())
            self._changed.notify()
            is_opening = self._is_opening
        if not is_opening:
            self._thread.join(LONGEST_GOODBYE)

    # --- the belt's thread

    def _work(self) -> None:
        if not self._begin():
            return
        while not self._is_done():
            try:
                self._step()
            except GONE as problem:
                self._lose(problem)
        self._turn_off()

    def _begin(self) -> bool:
        """Open it for the first time. What came of it is told to who waits for it, or as news."""
        line, problem = None, None
        try:
            line = self._open(self._port)
        except Exception as error:  # noqa: BLE001 -- raised again where it is waited for
            problem = error
        with self._changed:
            self._line, self._problem, self._is_opening = line, problem, False
            is_news = not (self._is_awaited or self._is_closing)
            self._changed.notify_all()
        if is_news:
            _LOG.info("the belt's line: %s", problem or "opened")
            reason = problem.reason if isinstance(problem, PortProblem) else str(problem or "")
            self._telling.tell(BeltNews.MISSING if problem else BeltNews.FOUND, reason)
        return line is not None

    def _is_done(self) -> bool:
        return self._is_closing and (self._line is None or self._sender.is_over(monotonic()))

    def _step(self) -> None:
        line = self._line
        if line is None:
            self._try_again()
            return
        received = line.read(_MOST_HEARD)
        with self._changed:
            self._sender.heard(received)
        self._look_whether_it_is_one(received)
        if getattr(
            line, "out_waiting", 0
        ):  # an earlier frame still waits in the system: this one is left out
            self._rest(PERIOD / 4)
        elif due := self._due():
            line.write(due)
        else:
            self._rest()

    def _look_whether_it_is_one(self, received: bytes) -> None:
        if self._doubt is None:
            self._doubt = Doubt(monotonic())
        self._doubt.heard(received)
        match self._doubt.next(monotonic()):
            case Next.ASK:
                with self._changed:
                    self._sender.start_over()
            case Next.TELL:
                self._telling.tell(BeltNews.UNANSWERED, "")
            case Next.NOTHING:
                pass

    def _due(self) -> bytes:
        with self._changed:
            return self._sender.next(monotonic())

    def _rest(self, seconds: float | None = None) -> None:
        """So long, or until something is due or shown or it is time to look at the line again."""
        with self._changed:
            if self._is_done():
                return
            if seconds is None:
                seconds = self._sender.wait(monotonic())
            self._changed.wait(LONGEST_REST if seconds is None else seconds)

    def _lose(self, problem: Exception) -> None:
        _LOG.info("the belt's line failed: %s", problem)
        self._close_line()
        self._doubt = None
        self._telling.tell(BeltNews.LOST, "")

    def _try_again(self) -> None:
        with self._changed:
            if self._is_closing:
                return
            self._changed.wait(RETRY)
            self._is_opening = True
        try:
            self._line = self._open(self._port)
        except (PortProblem, *GONE):
            return
        finally:
            with self._changed:
                self._is_opening = False
        with self._changed:
            self._sender.start_over()
        self._telling.tell(BeltNews.RESTORED, "")

    def _turn_off(self) -> None:
        """Whatever happened before: the last thing on the line is a dark frame."""
        if self._line is not None:
            with suppress(*GONE):
                self._line.write(frame(OFF))
        self._close_line()

    def _close_line(self) -> None:
        line, self._line = self._line, None
        if line is not None:
            with suppress(*GONE):
                line.close()
