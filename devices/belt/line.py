"""The belt on its serial line: one thread owns the port, writes what is due and tries again when it is gone.

Rules: nobody waits for the belt; what can't be sent now is never sent later; a belt that is lost is told
once, and once more when it is back. Closing turns its motors off.
"""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable
from contextlib import suppress
from enum import Enum
from time import monotonic
from typing import Protocol

import serial

from devices.belt.frame import BAUD, OFF, frame
from devices.belt.sender import PERIOD, BeltSender

_LOG = logging.getLogger(__name__)

RETRY = 1.0
"""Seconds between two attempts to open a line that was lost."""

LONGEST_GOODBYE = 1.0
"""Seconds that closing may take: the last pulse, and the frame that turns everything off."""

_WRITE_TIMEOUT = 0.2
_MOST_HEARD = 256
_GONE = (OSError, serial.SerialException, ValueError)
"""What pyserial raises when a device is unplugged: all of these, depending on where it notices."""


class BeltNews(Enum):
    """What is told about the belt."""

    LOST = "lost"
    RESTORED = "restored"


class Line(Protocol):
    """As much of a serial port as the belt needs."""

    def write(self, data: bytes, /) -> int | None: ...

    def read(self, size: int = 1, /) -> bytes: ...

    def close(self) -> None: ...


class BeltProblem(Exception):
    """The belt's line can't be opened. ``reason`` is the system's word for it."""

    def __init__(self, reason: str, *, errno: int | None = None) -> None:
        super().__init__(reason)
        self.reason = reason
        self.errno = errno


def open_line(port: str) -> Line:
    """A serial line at the belt's speed. Any address that pyserial knows. Raises ``BeltProblem``."""
    try:
        return serial.serial_for_url(
            port, baudrate=BAUD, timeout=0, write_timeout=_WRITE_TIMEOUT, exclusive=True
        )
    except _GONE as problem:
        reason = getattr(problem, "strerror", None) or str(problem)
        raise BeltProblem(reason, errno=getattr(problem, "errno", None)) from None


class SerialBelt:
    """A belt that shows levels from any thread and answers at once."""

    def __init__(
        self, port: str, on_news: Callable[[BeltNews], None], opened: Callable[[str], Line] = open_line
    ):
        """Opens the port. Raises ``BeltProblem``. ``on_news`` is called in the belt's own thread."""
        self._port = port
        self._on_news = on_news
        self._open = opened
        self._line: Line | None = opened(port)
        self._sender = BeltSender()
        self._changed = threading.Condition()
        self._is_closing = False
        self._thread = threading.Thread(target=self._work, name="belt", daemon=True)
        self._thread.start()

    def show(self, levels: tuple[int, ...]) -> None:
        with self._changed:
            self._sender.show(levels, monotonic())
            self._changed.notify()

    def close(self) -> None:
        """Motors off, once the last pulse was felt, and the port is free."""
        with self._changed:
            self._is_closing = True
            self._sender.show(OFF, monotonic())
            self._changed.notify()
        self._thread.join(LONGEST_GOODBYE)

    # --- the belt's thread

    def _work(self) -> None:
        while not self._is_done():
            try:
                self._step()
            except _GONE as problem:
                self._lose(problem)
        self._turn_off()

    def _is_done(self) -> bool:
        return self._is_closing and (self._line is None or self._sender.is_over(monotonic()))

    def _step(self) -> None:
        line = self._line
        if line is None:
            self._try_again()
            return
        received = line.read(_MOST_HEARD)
        with self._changed:
            self._sender.heard(received, monotonic())
        if getattr(
            line, "out_waiting", 0
        ):  # an earlier frame still waits in the system: this one is left out
            self._rest(PERIOD / 4)
        elif due := self._due():
            line.write(due)
        else:
            self._rest(None)

    def _due(self) -> bytes:
        with self._changed:
            return self._sender.next(monotonic())

    def _rest(self, seconds: float | None) -> None:
        """So long, or until something is due or shown."""
        with self._changed:
            if not self._is_done():
                self._changed.wait(self._sender.wait(monotonic()) if seconds is None else seconds)

    def _lose(self, problem: Exception) -> None:
        _LOG.info("the belt's line failed: %s", problem)
        self._close_line()
        self._on_news(BeltNews.LOST)

    def _try_again(self) -> None:
        with self._changed:
            if self._is_closing:
                return
            self._changed.wait(RETRY)
        try:
            self._line = self._open(self._port)
        except BeltProblem:
            return
        with self._changed:
            self._sender.start_over()
        self._on_news(BeltNews.RESTORED)

    def _turn_off(self) -> None:
        """Whatever happened before: the last thing on the line is a dark frame."""
        if self._line is not None:
            with suppress(*_GONE):
                self._line.write(frame(OFF))
        self._close_line()

    def _close_line(self) -> None:
        line, self._line = self._line, None
        if line is not None:
            with suppress(*_GONE):
                line.close()
