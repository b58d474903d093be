"""Short exchanges with the device at a port: identify it, and stop a robot whose program is gone.

As a program, ``python -m devices.port_exchange PORT``, it is the guard of a robot. Its standard input ends
when the program that drives the robot has ended, however it ended. Then the guard stops the robot, unless it
read ``NOT_NEEDED`` before; if the port is gone, it waits a minute for the port to return.

An exchange is a state machine without I/O: bytes and times in, bytes out. The clock is a parameter, too, so a
test's port can have its own. ``factor`` makes the deadlines that many times as long, on a slow computer.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager, suppress
from enum import Enum, auto
from time import monotonic
from typing import Protocol

from msgspec import Struct

from devices.belt import BAUD as BELT_BAUD
from devices.belt import RESYNC, ComplaintFinder
from devices.serial_ports import GONE, PortFault, PortProblem, SerialPort, pause, reason_of
from devices.wire.frames import BAUD as ROBOT_BAUD
from devices.wire.frames import CONFIGURE, FILLER, STOP, ConfigWanted, Decoder, Encoders, Power, Report
from devices.wire.telemetry import unwrapped

READ_TIMEOUT = 0.02
"""Seconds that one read waits for bytes."""

Clock = Callable[[], float]


class Exchange(Protocol):
    """One exchange. ``now`` is in seconds and never runs backward."""

    def next(self, received: bytes, now: float) -> bytes:
        """The bytes to send after these were received; often none."""

    def is_over(self, now: float) -> bool: ...


def open_exchange_port(address: str, baud: int, *, exclusive: bool = True) -> SerialPort:
    """Raises ``PortProblem``."""
    return SerialPort(address, baud, timeout=READ_TIMEOUT, exclusive=exclusive)


@contextmanager
def _gone_is_a_problem(address: str) -> Iterator[None]:
    try:
        yield
    except GONE as error:
        raise PortProblem(address, PortFault.ABSENT, reason_of(error)) from None


def _never() -> bool:
    return False


def _run(
    exchange: Exchange, port: SerialPort, address: str, now: Clock, is_given_up: Callable[[], bool] = _never
) -> None:
    """Run it until it is over, or given up. Raises ``PortProblem`` if the port goes away meanwhile."""
    received = b""
    with _gone_is_a_problem(address):
        while not (exchange.is_over(now()) or is_given_up()):
            reply = exchange.next(received, now())
            if reply:
                port.write(reply)
            received = port.read()


# --- identify

FIRST_ANSWER = 6.0
"""Seconds within which a robot's board that was just restarted sends something."""

WATCHED = 0.3
"""Seconds for which the wheels of a board that was not restarted are watched."""
TURNING = 20
"""Counts by which a robot moves that drives, or is pushed."""

BATTERY = 2.0
"""Seconds more until it has reported its battery: it does so three times a second once it is configured."""

BELT_ANSWER = 0.5


class DeviceKind(Enum):
    """What is at a port."""

    ROBOT = auto()
    BELT = auto()
    NOTHING = auto()


class IdentifiedDevice(Struct, frozen=True):
    """What was found out about a port."""

    kind: DeviceKind
    millivolts: int | None = None
    """The robot's battery, if it reported that."""
    restarted: bool = False
    """Whether opening the port restarted the robot's board."""
    is_driving: bool = False
    """Whether its wheels turned meanwhile."""


class RobotIdentification:
    """Waits for a robot's frames and for its battery.

    A robot that waits for its configuration is given it, because it reports its battery only then. It does
    not move by that.
    """

    def __init__(self, factor: float = 1.0) -> None:
        self._factor = factor
        self._decoder = Decoder()
        self._until: float | None = None
        self.is_robot = False
        self.restarted = False
        self.millivolts: int | None = None
        self.is_driving = self._had_turned = False
        self._wheels: tuple[float, Encoders] | None = None
        """When the wheels were first reported, and where they were."""

    def next(self, received: bytes, now: float) -> bytes:
        if self._until is None:
            self._until = now + FIRST_ANSWER * self._factor
        reply = b""
        for report in self._decoder.feed(received):
            reply = self._take(report, now) or reply
        return reply

    def _take(self, report: Report, now: float) -> bytes:
        if not self.is_robot:
            self.is_robot = True
            self._until = now + BATTERY * self._factor
        if isinstance(report, Power):
            self.millivolts = report.millivolts
        elif isinstance(report, ConfigWanted):
            self.restarted = True
            return CONFIGURE
        elif isinstance(report, Encoders):
            self._watch(report, now)
        return b""

    def _watch(self, wheels: Encoders, now: float) -> None:
        """A single frame may be torn: two in a row must agree."""
        _, before = self._wheels = self._wheels or (now, wheels)
        moved = (unwrapped(wheels.right - before.right), unwrapped(wheels.left - before.left))
        has_turned = max(map(abs, moved)) > TURNING
        self.is_driving = self.is_driving or (has_turned and self._had_turned)
        self._had_turned = has_turned

    def is_over(self, now: float) -> bool:
        if self._until is not None and now >= self._until:
            return True
        is_watched = self.restarted or (self._wheels is not None and now - self._wheels[0] >= WATCHED)
        return self.millivolts is not None and is_watched


class BeltIdentification:
    """Sends bytes that are no frame, and waits for the belt's complaint."""

    def __init__(self, factor: float = 1.0) -> None:
        self._factor = factor
        self._complaints = ComplaintFinder()
        self._until: float | None = None

    @property
    def is_belt(self) -> bool:
        return self._complaints.has_found

    def next(self, received: bytes, now: float) -> bytes:
        self._complaints.receive(received)
        if self._until is None:
            self._until = now + BELT_ANSWER * self._factor
            return RESYNC
        return b""

    def is_over(self, now: float) -> bool:
        return self.is_belt or (self._until is not None and now >= self._until)


def identify(
    address: str,
    open_port: Callable[[str, int], SerialPort] = open_exchange_port,
    *,
    is_given_up: Callable[[], bool] = _never,
    now: Clock = monotonic,
    factor: float = 1.0,
) -> IdentifiedDevice:
    """Find out what is at the port; some seven seconds at most, times ``factor``. Raises ``PortProblem``.

    Opening the port restarts a board on USB. Nothing moves. Any thread may give the exchange up; then the
    result means nothing.
    """
    with closing(open_port(address, ROBOT_BAUD)) as port:
        robot = RobotIdentification(factor)
        _run(robot, port, address, now, is_given_up)
        if robot.is_robot:
            return IdentifiedDevice(DeviceKind.ROBOT, robot.millivolts, robot.restarted, robot.is_driving)
        with _gone_is_a_problem(address):
            port.set_baud(BELT_BAUD)
        belt = BeltIdentification(factor)
        _run(belt, port, address, now, is_given_up)
        return IdentifiedDevice(DeviceKind.BELT if belt.is_belt else DeviceKind.NOTHING)


# --- stop a robot whose program is gone

FLUSH_PAUSE = 0.1
"""Seconds after the zeros: the board reads one byte in a pass of its loop."""

REPEAT = 0.05
TWICE = 2
SILENT = 1.5
"""Seconds after which a silent board gets a stop all the same; its boot loader takes one second."""

STANDS = 0.3
"""Seconds of fresh frames without a count, after which the wheels stand. A silent board proves nothing."""

FRESH = 1.0
"""Seconds after which a report of turning wheels says nothing about now; a busy machine may read it late."""

LONGEST = 4.0
"""A board that was restarted sends something within two seconds, a slow one within three."""


class HaltOutcome(Enum):
    """What is known of the robot."""

    STANDS = "stands"
    """Its wheels were seen to stand, or its board has just restarted."""
    DRIVES = "drives"
    """It was sent stops, and its wheels turn all the same."""
    UNCONFIRMED = "unconfirmed"
    """It was sent a stop, and nothing answered."""
    IN_USE = "in-use"
    """It was sent a stop, but another program has its port and may drive on."""


class EmergencyStop:
    """Stops a board that may be in the middle of a half frame.

    It listens first: a board in its boot loader stands already, and must not be disturbed. Then it sends
    zeros, which complete a half frame, waits until the board has read them, and sends stops until the wheels
    stand.
    """

    def __init__(self, factor: float = 1.0) -> None:
        self._longest = LONGEST * factor
        self._decoder = Decoder()
        self._began: float | None = None
        self._flushed_at: float | None = None
        self._sent_at = 0.0
        self._stops = 0
        self._is_streaming = False
        self._has_restarted = False
        self._wheels: Encoders | None = None
        self._still_since: float | None = None
        self._counted_at = 0.0
        """When the board last reported its wheels."""

    def next(self, received: bytes, now: float) -> bytes:
        began = self._began = now if self._began is None else self._began
        for report in self._decoder.feed(received):
            self._take(report, now)
        if self._flushed_at is None:
            return self._flush(now, began)
        if now - self._flushed_at < FLUSH_PAUSE or now - self._sent_at < REPEAT:
            return b""
        if self._stops >= TWICE and not self._is_streaming:
            return b""
        self._sent_at = now
        self._stops += 1
        return STOP

    def is_over(self, now: float) -> bool:
        return self._began is not None and (self._stands(now) or now - self._began >= self._longest)

    def outcome(self, now: float) -> HaltOutcome:
        if self._stands(now):
            return HaltOutcome.STANDS
        is_turning = self._still_since is not None and now - self._counted_at < FRESH
        return HaltOutcome.DRIVES if is_turning else HaltOutcome.UNCONFIRMED

    def _flush(self, now: float, began: float) -> bytes:
        """Zeros, once a board streams, or has been silent for longer than a start takes."""
        if not self._is_streaming and now - began < SILENT:
            return b""
        self._flushed_at = self._sent_at = now
        return FILLER

    def _stands(self, now: float) -> bool:
        return self._has_restarted or self._is_still(now)

    def _is_still(self, now: float) -> bool:
        """Whether the counts have not changed for a while, by fresh frames."""
        since, counted_at = self._still_since, self._counted_at
        return since is not None and counted_at - since >= STANDS and now - counted_at < STANDS

    def _take(self, report: Report, now: float) -> None:
        if isinstance(report, ConfigWanted):
            self._has_restarted = True
            return
        self._is_streaming = True
        if isinstance(report, Encoders) and self._stops >= TWICE:
            self._counted_at = now
            if report != self._wheels:
                self._wheels, self._still_since = report, now


def halt(
    address: str,
    open_port: Callable[..., SerialPort] = open_exchange_port,
    *,
    by_force: Callable[[], bool] = _never,
    now: Clock = monotonic,
    factor: float = 1.0,
) -> HaltOutcome:
    """Stop the robot at the port; four seconds at most, or twice that, times ``factor``.

    Raises ``PortProblem``.

    Opening the port restarts a board on USB; any other board is sent stops. ``by_force`` restarts the board
    where that is possible without opening the port, and returns whether it did. It is called if the stops
    don't help. Where another program has the port, the stops are sent all the same, without reading.
    """
    try:
        port = open_port(address, ROBOT_BAUD)
    except PortProblem as problem:
        if problem.fault is not PortFault.BUSY:
            raise
        _stop_shared_port(address, open_port)
        return HaltOutcome.IN_USE
    with closing(port):
        outcome = _stop(port, address, now, factor)
        if outcome in (HaltOutcome.UNCONFIRMED, HaltOutcome.DRIVES) and by_force():
            outcome = _stop(port, address, now, factor)
        return outcome


RETURNS = 60.0
"""Seconds within which an unplugged robot is waited for."""
TRIES = 0.5
"""Seconds between two attempts to open its port."""
FREED, FREED_TRIES = 2.0, 0.05
"""Seconds within which the system closes the port of a program that was killed, and between two attempts."""


_MAY_COME = (PortFault.ABSENT, PortFault.FORBIDDEN)
"""A port that has just been plugged in belongs to the system for a moment."""


def halt_when_back(
    stop: Callable[[], HaltOutcome],
    *,
    now: Clock = monotonic,
    pause: Callable[[float], object] = pause,
    on_absent: Callable[[], object] = _never,
) -> HaltOutcome:
    """What ``stop`` says once the port is there, within a minute. Raises its last ``PortProblem``.

    ``on_absent`` is called once, if the port is not there at first. A port that is busy for two seconds has
    another program.
    """
    began, is_reported = now(), False
    while True:
        try:
            return stop()
        except PortProblem as problem:
            is_busy = problem.fault is PortFault.BUSY
            if not (is_busy or problem.fault in _MAY_COME) or now() >= began + (
                FREED if is_busy else RETURNS
            ):
                raise
        if is_busy:
            pause(FREED_TRIES)
            continue
        if not is_reported:
            is_reported = True
            on_absent()
        pause(TRIES)


def guard(address: str, open_port: Callable[..., SerialPort] = open_exchange_port) -> None:
    """Stop the robot when its port returns. A program that has the port by then stops it itself."""
    with suppress(PortProblem):
        halt_when_back(lambda: _halt_alone(address, open_port))


def _halt_alone(address: str, open_port: Callable[..., SerialPort]) -> HaltOutcome:
    with closing(open_port(address, ROBOT_BAUD)) as port:
        return _stop(port, address, monotonic)


def _stop(port: SerialPort, address: str, now: Clock, factor: float = 1.0) -> HaltOutcome:
    exchange = EmergencyStop(factor)
    _run(exchange, port, address, now)
    return exchange.outcome(now())


def _stop_shared_port(address: str, open_port: Callable[..., SerialPort]) -> None:
    """The other program's bytes come between our frames at most, not into them."""
    with closing(open_port(address, ROBOT_BAUD, exclusive=False)) as port:
        try:
            port.write(STOP)
            port.write(STOP)
        except GONE as error:
            raise PortProblem(address, PortFault.BUSY, reason_of(error)) from None


NOT_NEEDED = b"not needed"
"""What a guard reads when its robot needs none any more."""


if __name__ == "__main__":
    if sys.stdin.buffer.read() != NOT_NEEDED:
        guard(sys.argv[1])
