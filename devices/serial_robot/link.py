"""The link to a robot's board on a real port: one thread owns the port, reads it, and writes what is due.

``devices.wire`` makes every decision. This module adds the port, the clock and the lock. The thread is a
daemon; it sleeps between two polls of the port, and wakes when something is to be sent.
"""

from __future__ import annotations

import atexit
import logging
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from math import inf
from typing import Protocol

from devices.board_reset import AUTOMATIC, BoardReset, reset_of
from devices.ports.robot import LinkNotice, RobotProblem
from devices.serial_ports import GONE, Notifier, PortProblem, SerialPort, pause, reason_of
from devices.wire.connection import BoardConnection, PortAction, Write
from devices.wire.frames import BAUD, STOP, MotorDrive, Wiring
from devices.wire.link_state import LinkConfig, LinkState
from devices.wire.telemetry import Telemetry

POLL = 0.01
"""Seconds between two polls of the port: some eight frames arrive in that time."""
SHORTEST = 0.001
TIMEOUT = 1.0
"""Seconds beyond the board's own time limit that ``connect`` waits for the thread to report a failure."""

SLOW = 1.0
"""Seconds of connecting after which ``on_slow`` is called."""

_LOG = logging.getLogger(__name__)


class RobotLink(Protocol):
    """A link to a board. Any thread may call every method. All but ``connect``, ``close`` and the two
    ``wait_until`` methods return at once."""

    @property
    def name(self) -> str:
        """The port, as it is named to a person."""

    @property
    def state(self) -> LinkState: ...

    @property
    def telemetry(self) -> Telemetry: ...

    @property
    def driving_since(self) -> float | None:
        """When the wheels were commanded to turn; None while they are to stand."""

    def now(self) -> float:
        """Seconds on the link's own clock, which never runs backward."""

    def permit(self) -> int:
        """What each ``drive`` must name; it becomes void when the robot is stopped or the link is lost."""

    def drive(self, permit: int, drive: MotorDrive, until: float) -> bool:
        """See ``BoardConnection.drive``. False if the permit is void."""

    def stop(self) -> None:
        """Turn the wheels off, at once. Never raises."""

    def put(self, frame: bytes) -> None:
        """Queue a frame to be sent when there is time."""

    def connect(self) -> None:
        """Open the port and wait for the board, some six seconds at most. Raises ``RobotProblem``."""

    def give_up(self) -> None:
        """End ``connect`` at once, with the problem ``given-up``. Signal handlers may call it, too."""

    @property
    def may_drive_on(self) -> bool:
        """Whether the link was lost while the robot drove, and it was not stopped since."""

    @property
    def has_run_away(self) -> bool:
        """Whether the wheels turn although all was done to stop them."""

    def rewire(self, wiring: Wiring) -> None:
        """See ``BoardConnection.rewire``."""

    def await_stop(self) -> bool:
        """Wait until the robot stands after a stop, some 2.2 seconds at most. False if its wheels are seen
        to turn after all was done that can be. Only for the program's thread."""

    def wait_until_standing(self) -> None:
        """The same for any thread. Returns at once if the robot stands, and on a link whose time passes only
        while it is driven.
        """

    def wait_until_notified(self) -> None:
        """Wait until the listener has received all notices, half a second at most."""

    def close(self) -> None:
        """Stop the robot, wait until it stands, close the port. Never raises."""


def open_board_port(address: str) -> SerialPort:
    """A robot's port, open at its speed. Raises ``PortProblem``."""
    return SerialPort(address, BAUD)


class ConnectionState:
    """What a ``RobotLink`` knows from its ``BoardConnection``."""

    def __init__(self, connection: BoardConnection) -> None:
        self._connection = connection

    @property
    def state(self) -> LinkState:
        return self._connection.state

    @property
    def telemetry(self) -> Telemetry:
        return self._connection.telemetry

    @property
    def driving_since(self) -> float | None:
        return self._connection.driving_since

    @property
    def may_drive_on(self) -> bool:
        return self._connection.may_drive_on

    @property
    def has_run_away(self) -> bool:
        return self._connection.has_run_away

    def permit(self) -> int:
        return self._connection.permit


class SerialLink(ConnectionState):
    """A ``RobotLink`` to one board on one port."""

    def __init__(
        self,
        port: str,
        config: LinkConfig | None = None,
        on_notice: Callable[[LinkNotice, str], None] | None = None,
        *,
        open_port: Callable[[str], SerialPort] = open_board_port,
        reset: BoardReset | None = None,
        on_slow: Callable[[], object] | None = None,
    ) -> None:
        """``port``: a path or a pyserial URL. ``reset``: how the board is restarted by force; by default as
        fits the port.

        ``on_notice`` is called in order, in a thread of its own, so it may block. ``on_slow`` is called once,
        in the thread that connects, if connecting takes longer than a second.
        """
        self._config = config or LinkConfig()
        super().__init__(BoardConnection(self._config, lambda text: _LOG.debug("%s: %s", port, text)))
        self.name = port
        self._notifier = Notifier(port, on_notice)
        self._open_port = open_port
        self._reset = reset or reset_of(AUTOMATIC, port)
        self._on_slow = on_slow
        self._slow_at = inf
        self._lock = threading.RLock()  # a signal handler may close the link in the middle of anything
        self._polled = threading.Condition(self._lock)
        self._must_wake = threading.Event()
        self._is_closing = threading.Event()
        self._is_given_up = False
        self._port: SerialPort | None = None
        self._thread: threading.Thread | None = None

    # --- for every thread

    def now(self) -> float:
        return time.monotonic()

    def drive(self, permit: int, drive: MotorDrive, until: float) -> bool:
        with self._lock:
            is_new = self._connection.driving_since is None
            is_permitted = self._connection.drive(permit, drive, until, self.now())
        if is_new:
            self._must_wake.set()
        return is_permitted

    def stop(self) -> None:
        with self._lock:
            self._connection.stop(self.now())
        self._must_wake.set()

    def put(self, frame: bytes) -> None:
        with self._lock:
            self._connection.put(frame)
        self._must_wake.set()

    def rewire(self, wiring: Wiring) -> None:
        with self._lock:
            self._connection.rewire(wiring, self.now())

    def connect(self) -> None:
        """Open the port and wait for the board. On a ``RobotProblem`` the port is closed again."""
        if self._thread is not None:
            return
        try:
            self._connect()
        finally:
            self._is_given_up = False

    def give_up(self) -> None:
        """End ``connect`` at once, with the problem ``given-up``; also if it is called before ``connect``."""
        self._is_given_up = True  # the link's thread notifies at every poll

    def await_stop(self) -> bool:
        self.wait_until_standing()
        if self.has_run_away:
            self.wait_until_notified()
        return not self.has_run_away

    def wait_until_standing(self) -> None:
        """Wait until a stop is over: the wheels stand, or all was done that can be."""
        began = self.now()
        while self.now() < began + self._connection.longest_stop:
            with self._lock:
                if self._connection.is_stop_over:
                    return
            pause(POLL)

    def wait_until_notified(self) -> None:
        self._notifier.wait()

    def close(self) -> None:
        """Stop the robot, wait until it stands, close the port. If it is interrupted, it runs again at the
        end of the process."""
        thread = self._thread
        if thread is None:
            return
        self.stop()
        self.wait_until_standing()
        self._is_closing.set()
        self._must_wake.set()
        if thread.is_alive():
            thread.join(TIMEOUT)
        elif thread.ident is None:  # `connect` was interrupted before it began
            self._finish()
        self.wait_until_notified()
        self._thread = None
        atexit.unregister(self.close)

    def _connect(self) -> None:
        self._slow_at = self.now() + SLOW
        self._port = self._opened()
        with self._lock:
            self._connection.open()
            self._connection.opened(self.now())
        atexit.register(self.close)
        self._is_closing.clear()
        self._thread = threading.Thread(target=self._run, name=f"link {self.name}", daemon=True)
        self._thread.start()
        if not self._is_answered():
            is_given_up = self._is_given_up
            self.close()
            raise RobotProblem("given-up" if is_given_up else "no-answer", port=self.name)

    def _opened(self) -> SerialPort:
        try:
            port = _PortOpening(self.name, self._open_port).wait(self._must_stop_waiting)
        except PortProblem as problem:
            raise RobotProblem(problem.fault.value, port=problem.port, reason=problem.reason) from problem
        if port is None:
            raise RobotProblem("given-up", port=self.name)
        return port

    def _must_stop_waiting(self) -> bool:
        self._report_if_slow()
        return self._is_given_up

    def _report_if_slow(self) -> None:
        if self.now() >= self._slow_at:
            self._slow_at = inf
            if self._on_slow is not None:
                self._on_slow()

    def _is_answered(self) -> bool:
        ends = self.now() + self._config.first_answer + TIMEOUT
        while not self._is_decided_by(min(ends, self._slow_at)) and self.now() < ends:
            self._report_if_slow()
        return self.state is LinkState.STREAMING and not self._is_given_up

    def _is_decided_by(self, deadline: float) -> bool:
        with self._polled:
            return self._polled.wait_for(self._is_decided, deadline - self.now())

    def _is_decided(self) -> bool:
        return self._is_given_up or self.state in (LinkState.STREAMING, LinkState.LOST)

    # --- the link's own thread

    def _run(self) -> None:
        try:
            while not self._is_closing.is_set():
                try:
                    self._poll()
                except Exception as error:  # noqa: BLE001 -- a driver may raise anything; the thread must not end
                    _LOG.warning("%s failed", self.name, exc_info=True)
                    self._lost(error)
                self._notify()
                self._wait()
        finally:
            self._finish()

    def _poll(self) -> None:
        """Take in what arrived and do what is due. A stop comes first: reading may take long."""
        with self._lock:
            urgent = self._connection.urgent(self.now())
        for action in urgent:
            self._do(action)
        try:
            data = self._port.read() if self._port is not None else b""
        except GONE as error:
            self._lost(error)
            return
        with self._lock:
            if data:
                self._connection.received(data, self.now())
            actions = self._connection.actions(self.now())
            self._polled.notify_all()
        for action in actions:
            self._do(action)

    def _do(self, action: Write | PortAction) -> None:
        try:
            match action:
                case Write(data=data):
                    if self._port is not None:
                        self._port.write(data)
                case PortAction.RESET:
                    if self._port is not None:
                        self._reset.pull(self._port, pause)
                    with self._lock:
                        self._connection.forced(self.now())
                case PortAction.REOPEN:
                    self._reopen()
        except GONE as error:
            self._lost(error)

    def _reopen(self) -> None:
        self._drop_port()
        with self._lock:
            self._connection.open()
        try:
            self._port = self._open_port(self.name)
        except PortProblem as problem:
            self._lost(OSError(problem.reason))
            return
        with self._lock:
            self._connection.opened(self.now())

    def _lost(self, error: Exception) -> None:
        self._drop_port()
        with self._lock:
            self._connection.failed(self.now(), reason_of(error))
            self._polled.notify_all()

    def _drop_port(self) -> None:
        port, self._port = self._port, None
        if port is not None:
            port.close()

    def _notify(self) -> None:
        with self._lock:
            for notice, reason in self._connection.take_notices():
                self._notifier.notify(notice, reason or self.name)

    def _wait(self) -> None:
        with self._lock:
            seconds = min(POLL, self._connection.next_at(self.now()) - self.now())
        self._must_wake.wait(max(SHORTEST, seconds))
        self._must_wake.clear()

    def _finish(self) -> None:
        """However the thread ends, the last thing that it writes is a stop."""
        with self._lock:
            self._connection.close(self.now())
        if self._port is not None:
            try:
                self._port.write(STOP)
            except GONE as error:
                _LOG.info("%s: gone before the last stop: %s", self.name, error)
        self._drop_port()


class _PortOpening:
    """One attempt to open a port, in a thread of its own: a network address may take seconds.

    Rule: a port that opens after the attempt was abandoned gets a stop for its robot, and is closed.
    """

    def __init__(self, address: str, open_port: Callable[[str], SerialPort]) -> None:
        """Begins at once."""
        self._lock = threading.Lock()
        self._is_done = threading.Event()
        self._is_abandoned = False
        self._port: SerialPort | None = None
        self._error: Exception | None = None
        threading.Thread(
            target=self._open, args=(address, open_port), name=f"opening {address}", daemon=True
        ).start()

    def wait(self, is_given_up: Callable[[], bool]) -> SerialPort | None:
        """The port, or None if it was given up. Raises what opening it raised."""
        try:
            while not self._is_done.wait(POLL) and not is_given_up():
                pass
        except BaseException:
            self._abandon()
            raise
        if is_given_up():
            self._abandon()
            return None
        if self._error is not None:
            raise self._error
        return self._port

    def _open(self, address: str, open_port: Callable[[str], SerialPort]) -> None:
        try:
            self._port = open_port(address)
        except Exception as error:  # noqa: BLE001 -- ``wait`` raises it again
            self._error = error
        with self._lock:
            self._is_done.set()
            if self._is_abandoned:
                self._stop_and_close()

    def _abandon(self) -> None:
        with self._lock:
            self._is_abandoned = True
            if self._is_done.is_set():
                self._stop_and_close()

    def _stop_and_close(self) -> None:
        if self._port is not None:
            with suppress(*GONE):
                self._port.write(STOP)
            self._port.close()
