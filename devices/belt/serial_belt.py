"""The belt on its serial port: one thread owns the port, writes what is due, and reopens it when it is gone.

Rules: no caller waits for the belt, nor for a network that doesn't answer. What can't be sent now is never
sent later. A belt that is missing or lost is reported once, and once more when it is back. Closing turns its
motors off.
"""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable
from contextlib import suppress
from enum import Enum
from time import monotonic

from devices.belt.protocol import BAUD, OFF, PERIOD, BeltCheck, BeltDetector, BeltSender, encode_frame
from devices.notifier import Notifier
from devices.serial_ports.port import GONE, PortProblem, SerialPort

_LOG = logging.getLogger(__name__)

RETRY = 1.0
"""Seconds between two attempts to reopen a lost port."""

LONGEST_REST = 0.5
"""Seconds between two polls of a port on which nothing is due; so soon an unplugged belt is noticed."""

OPENING_TIMEOUT = 2.0
"""Seconds that the constructor waits for a device of this machine, which opens at once or never. It does not
wait for a network address."""

CLOSING_TIMEOUT = 1.0
"""Seconds that closing may take: the last pulse, and the frame that turns all motors off."""


class BeltNotice(Enum):
    """What is reported about the belt."""

    MISSING = "missing"
    """It couldn't be opened, and is not tried again."""
    FOUND = "found"
    """It was opened after the constructor had returned."""
    UNANSWERED = "unanswered"
    """The device accepts the bytes, and never answers as a belt does. It still gets them."""
    LOST = "lost"
    RESTORED = "restored"


def open_belt_port(address: str) -> SerialPort:
    """A belt's port, open at its speed. Raises ``PortProblem``."""
    return SerialPort(address, BAUD)


class SerialBelt:
    """A belt that any thread may show levels on; no call waits for it."""

    def __init__(
        self,
        address: str,
        on_notice: Callable[[BeltNotice, str], None],
        open_port: Callable[[str], SerialPort] = open_belt_port,
    ):
        """Opens the port. Raises ``PortProblem`` if the port is known at once to be unusable; what turns out
        later is a notice. ``on_notice`` is called in a thread of its own, with a reason or an empty
        string."""
        self._address = address
        self._notifier = Notifier(address, on_notice)
        self._open_port = open_port
        self._port: SerialPort | None = None
        self._sender = BeltSender()
        self._detector: BeltDetector | None = None
        """For the port that is open."""
        self._changed = threading.Condition()
        self._is_closing = False
        self._is_opening = self._is_awaited = True
        self._problem: Exception | None = None
        self._thread = threading.Thread(target=self._run, name="belt", daemon=True)
        self._thread.start()
        self._await_opening(0.0 if "://" in address else OPENING_TIMEOUT)

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
        """Turn the motors off, after the last pulse was felt, and close the port. A port that opens only
        later is turned off and closed then."""
        with self._changed:
            self._is_closing = True
            self._sender.show(OFF, monotonic())
            self._changed.notify()
            is_opening = self._is_opening
        if not is_opening:
            self._thread.join(CLOSING_TIMEOUT)

    # --- the belt's thread

    def _run(self) -> None:
        if not self._open_first():
            return
        while not self._is_done():
            try:
                self._poll()
            except GONE as error:
                self._lose(error)
        self._turn_off()

    def _open_first(self) -> bool:
        """Open the port for the first time. The result goes to the constructor, or to the listener."""
        port, problem = None, None
        try:
            port = self._open_port(self._address)
        except Exception as error:  # noqa: BLE001 -- the constructor raises it again
            problem = error
        with self._changed:
            self._port, self._problem, self._is_opening = port, problem, False
            is_late = not (self._is_awaited or self._is_closing)
            self._changed.notify_all()
        if is_late:
            _LOG.info("the belt's port: %s", problem or "opened")
            reason = problem.reason if isinstance(problem, PortProblem) else str(problem or "")
            self._notifier.notify(BeltNotice.MISSING if problem else BeltNotice.FOUND, reason)
        return port is not None

    def _is_done(self) -> bool:
        return self._is_closing and (self._port is None or self._sender.is_over(monotonic()))

    def _poll(self) -> None:
        port = self._port
        if port is None:
            self._reopen()
            return
        received = port.read()
        with self._changed:
            self._sender.receive(received)
        self._detect(received)
        if port.unsent:  # an earlier frame still waits in the system: leave this one out
            self._rest(PERIOD / 4)
            return
        with self._changed:
            due = self._sender.next(monotonic())
        if due:
            port.write(due)
        else:
            self._rest()

    def _detect(self, received: bytes) -> None:
        if self._detector is None:
            self._detector = BeltDetector(monotonic())
        self._detector.receive(received)
        match self._detector.next(monotonic()):
            case BeltCheck.ASK:
                with self._changed:
                    self._sender.start_over()
            case BeltCheck.REPORT_MISSING:
                self._notifier.notify(BeltNotice.UNANSWERED, "")
            case BeltCheck.NOTHING:
                pass

    def _rest(self, seconds: float | None = None) -> None:
        """Rest that long; or until something is due or shown, or the port must be polled again."""
        with self._changed:
            if self._is_done():
                return
            if seconds is None:
                seconds = self._sender.wait(monotonic())
            self._changed.wait(LONGEST_REST if seconds is None else seconds)

    def _lose(self, error: Exception) -> None:
        _LOG.info("the belt's port failed: %s", error)
        self._close_port()
        self._detector = None
        self._notifier.notify(BeltNotice.LOST, "")

    def _reopen(self) -> None:
        with self._changed:
            if self._is_closing:
                return
            self._changed.wait(RETRY)
            self._is_opening = True
        try:
            self._port = self._open_port(self._address)
        except (PortProblem, *GONE):
            return
        finally:
            with self._changed:
                self._is_opening = False
        with self._changed:
            self._sender.start_over()
        self._notifier.notify(BeltNotice.RESTORED, "")

    def _turn_off(self) -> None:
        """Whatever happened before, the last bytes written are a frame that turns everything off."""
        if self._port is not None:
            with suppress(*GONE):
                self._port.write(encode_frame(OFF))
        self._close_port()

    def _close_port(self) -> None:
        port, self._port = self._port, None
        if port is not None:
            with suppress(*GONE):
                port.close()
