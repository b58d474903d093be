"""The line to a robot on a real port: one thread owns the port, reads it, and writes what is due.

Everything that is decided is decided in ``devices.wire``; here are only the port, the clock and the lock. The
thread is a daemon that sleeps between its looks and is woken by whoever wants something sent.
"""

from __future__ import annotations

import atexit
import logging
import threading
import time
from collections.abc import Callable
from math import inf

from devices.ports.robot import LinkNews, RobotProblem
from devices.serial_link.opening import Opening
from devices.serial_link.port import OpenPort
from devices.serial_port import GONE, PortProblem, reason_of
from devices.telling import Telling
from devices.wire.commands import STOP, Drive
from devices.wire.connection import Connection, Need, Write
from devices.wire.link_config import LinkConfig
from devices.wire.link_state import LinkState
from devices.wire.stopping import LONGEST_STOP
from devices.wire.telemetry import Telemetry

LOOK = 0.01
"""Seconds between two looks at the port: some eight frames come in that time."""
SHORTEST = 0.001
PATIENCE = 1.0
"""Seconds beyond the board's own time limit that ``connect`` waits, for the thread to say that it failed."""

SLOW = 1.0
"""Seconds of connecting after which whoever waits is told that it goes on."""

_LOG = logging.getLogger(__name__)


def _pause(seconds: float) -> None:
    """A pulse is as long as it has to be, also if the link is closed meanwhile."""
    threading.Event().wait(seconds)


class SerialLink:
    """A line to one board on one port. See ``devices.serial_robot.line.RobotLine``."""

    def __init__(
        self,
        port: str,
        config: LinkConfig | None = None,
        on_event: Callable[[LinkNews, str], None] | None = None,
        *,
        open_port: Callable[[str], OpenPort] = OpenPort,
        on_slow: Callable[[], object] | None = None,
    ) -> None:
        """``port``: a path or a pyserial URL. ``on_event`` is told the news in order, in a thread of
        its own: it may wait for whatever it likes.

        ``on_slow`` is called once in the thread that connects, if that takes longer than a second.
        """
        self.name = port
        self._config = config or LinkConfig()
        self._telling = Telling(port, on_event)
        self._open_port = open_port
        self._on_slow = on_slow
        self._slow_at = inf
        self._connection = Connection(self._config, lambda text: _LOG.debug("%s: %s", port, text))
        self._lock = threading.RLock()  # a signal's handler may close the link in the midst of anything
        self._answered = threading.Condition(self._lock)
        self._wanted = threading.Event()
        self._closing = threading.Event()
        self._is_given_up = False
        self._port: OpenPort | None = None
        self._thread: threading.Thread | None = None

    # --- for everybody

    @property
    def state(self) -> LinkState:
        return self._connection.state

    @property
    def telemetry(self) -> Telemetry:
        return self._connection.telemetry

    @property
    def driving_since(self) -> float | None:
        return self._connection.driving_since

    def now(self) -> float:
        return time.monotonic()

    def permit(self) -> int:
        return self._connection.permit

    def drive(self, permit: int, drive: Drive, until: float) -> bool:
        with self._lock:
            is_new = self._connection.driving_since is None
            allowed = self._connection.drive(permit, drive, until, self.now())
        if is_new:
            self._wanted.set()
        return allowed

    def stop(self) -> None:
        with self._lock:
            self._connection.stop(self.now())
        self._wanted.set()

    def put(self, frame: bytes) -> None:
        with self._lock:
            self._connection.put(frame)
        self._wanted.set()

    def connect(self) -> None:
        """Open the port and wait for the board. RobotProblem says why not, and the port is closed again."""
        if self._thread is not None:
            return
        try:
            self._connect()
        finally:
            self._is_given_up = False

    def give_up(self) -> None:
        """Have ``connect`` end at once, with the problem ``given-up``; also before it is called. A signal's
        handler may do it."""
        self._is_given_up = True  # the link's thread notifies at every look

    def _connect(self) -> None:
        self._slow_at = self.now() + SLOW
        self._port = self._opened()
        with self._lock:
            self._connection.open(self.now())
            self._connection.opened(self.now())
        self._start()
        if not self._is_answered():
            is_given_up = self._is_given_up
            self.close()
            raise RobotProblem("given-up" if is_given_up else "no-answer", port=self.name)

    def _opened(self) -> OpenPort:
        try:
            port = Opening(self.name, self._open_port).wait(self._is_left)
        except PortProblem as problem:
            raise RobotProblem(problem.fault.value, port=problem.port, reason=problem.reason) from problem
        if port is None:
            raise RobotProblem("given-up", port=self.name)
        return port

    def _is_left(self) -> bool:
        self._tell_if_slow()
        return self._is_given_up

    def _tell_if_slow(self) -> None:
        if self.now() >= self._slow_at:
            self._slow_at = inf
            if self._on_slow is not None:
                self._on_slow()

    def wait_until_standing(self) -> None:
        """Until a stop is over: the wheels stand, or all that can be done was. Any thread, any time."""
        ends = self.now() + LONGEST_STOP
        while not self._is_standing() and self.now() < ends:
            _pause(LOOK)

    def _is_standing(self) -> bool:
        with self._lock:
            return self._connection.is_standing

    def wait_until_told(self) -> None:
        """Until the news were heard, half a second at most."""
        self._telling.wait()

    def close(self) -> None:
        """Stop the robot, wait until it stands, let go of the port. Any thread, any time; what is interrupted
        is done again at the end of the process."""
        thread = self._thread
        if thread is None:
            return
        self.stop()
        self.wait_until_standing()
        self._closing.set()
        self._wanted.set()
        thread.join(PATIENCE)
        self.wait_until_told()
        self._thread = None
        atexit.unregister(self.close)

    # --- the link's own thread

    def _start(self) -> None:
        atexit.register(self.close)
        self._closing.clear()
        self._thread = threading.Thread(target=self._live, name=f"line {self.name}", daemon=True)
        self._thread.start()

    def _is_answered(self) -> bool:
        ends = self.now() + self._config.first_answer + PATIENCE
        while not self._is_decided_by(min(ends, self._slow_at)) and self.now() < ends:
            self._tell_if_slow()
        return self.state is LinkState.STREAMING and not self._is_given_up

    def _is_decided_by(self, time: float) -> bool:
        with self._answered:
            return self._answered.wait_for(self._is_decided, time - self.now())

    def _is_decided(self) -> bool:
        return self._is_given_up or self.state in (LinkState.STREAMING, LinkState.LOST)

    def _live(self) -> None:
        try:
            while not self._closing.is_set():
                self._look_safely()
                self._tell()
                self._wait()
        finally:
            self._let_go()

    def _look_safely(self) -> None:
        """Whatever goes wrong: the line is lost and tried again, for its thread must not end."""
        try:
            self._look()
        except Exception as error:  # noqa: BLE001 -- a driver may raise anything
            _LOG.warning("%s failed", self.name, exc_info=True)
            self._lost(error)

    def _look(self) -> None:
        """Take in what came, and do what is due; a stop first, for what came may take long to read."""
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
            self._answered.notify_all()
        for action in actions:
            self._do(action)

    def _do(self, action: Write | Need) -> None:
        try:
            match action:
                case Write(data=data):
                    self._write(data)
                case Need.FORCE:
                    if self._port is not None:
                        self._port.pull_reset(_pause)
                case Need.REOPEN:
                    self._reopen()
        except GONE as error:
            self._lost(error)

    def _write(self, data: bytes) -> None:
        if self._port is not None:
            self._port.write(data)

    def _reopen(self) -> None:
        self._drop_port()
        with self._lock:
            self._connection.open(self.now())
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
            self._answered.notify_all()

    def _drop_port(self) -> None:
        port, self._port = self._port, None
        if port is not None:
            port.close()

    def _tell(self) -> None:
        with self._lock:
            news = self._connection.take_news()
        for kind, reason in news:
            self._telling.tell(kind, reason or self.name)

    def _wait(self) -> None:
        with self._lock:
            seconds = min(LOOK, self._connection.next_at(self.now()) - self.now())
        self._wanted.wait(max(SHORTEST, seconds))
        self._wanted.clear()

    def _let_go(self) -> None:
        """However the thread ends, the last thing that is written is a stop."""
        with self._lock:
            self._connection.close(self.now())
        if self._port is not None:
            self._part(self._port)
        self._drop_port()

    def _part(self, port: OpenPort) -> None:
        try:
            port.write(STOP)
        except GONE as error:
            _LOG.info("%s: gone before the last stop: %s", self.name, error)
