"""The connection to a Player server: it opens a robot's devices, keeps their newest data and drives it.

Its time is the server's, which all data carry, so a server may run at any pace. A command has the
number of the last halt that it knows; a command older than a halt is not sent. The server stops a
robot that its last client has left.
"""

from __future__ import annotations

import select
import socket
import threading
from collections.abc import Callable
from contextlib import suppress
from enum import Enum
from math import degrees, hypot, inf, isfinite, radians
from time import monotonic

from msgspec import Struct

from devices.player.codec import (
    BANNER_SIZE,
    COMMAND,
    DATA,
    LONGEST_REPLY,
    NACK,
    REQUEST,
    Access,
    Interface,
    Key,
    MessageReader,
    PlayerMessage,
    TooLong,
    Values,
    body_of,
    values_of,
)
from devices.ports.robot import LinkNotice, RobotProblem
from donnie_tui.process.signals import timeout_factor
from donnie_tui.settings.parsing import address_of
from sim.geometry import normal


class RobotPart(Enum):
    """A device of the robot: its interface, its index, and the requests that ask for its shape.

    It is opened if the server has it. The index counts from that of the robot, and only the first robot of a
    port has parts with another one.
    """

    WHEELS = (Interface.POSITION2D, 0)
    HEAD = (Interface.POSITION2D, 1)
    SONARS = (Interface.RANGER, 0, 1, 5)
    HEAD_SONAR = (Interface.RANGER, 1, 1, 5)
    BUMPERS = (Interface.BUMPER, 0, 1)
    CAMERA = (Interface.BLOBFINDER, 0)
    MARKS = (Interface.FIDUCIAL, 0, 2)
    GRIPPER = (Interface.GRIPPER, 0)
    SPEECH = (Interface.SPEECH, 0)
    BELT = (Interface.DIO, 0)
    SECOND_BELT = (Interface.DIO, 1)


SILENT = frozenset({RobotPart.MARKS, RobotPart.SPEECH, RobotPart.BELT, RobotPart.SECOND_BELT})
"""Devices whose data are not read."""

CONNECTING, ANSWERING, SETTLING = 2.0, 5.0, 1.0
"""Seconds that the server may take to accept a connection, to answer a request, and to send a first datum of
what was opened."""
SILENCE, LOST = 2.0, 5.0
"""Seconds without data after which the server is asked for a sign of life, and after which it is lost."""
AGAIN, POLL, LEASE = 1.0, 0.1, 0.5
"""Seconds between two tries to connect again, of one wait for data, and for which one command drives the
robot. A paused program sends no further one."""

SERVER = (Interface.PLAYER, 0)
LONGEST_STANDING = 2.2
"""Seconds that a stop may take."""
STANDING = 0.005
"""Metres or radians a second: a slower robot counts as standing."""


class WheelState(Struct, frozen=True):
    """One datum of the wheels: simulated seconds, metres and degrees counter-clockwise."""

    time: float
    x: float
    y: float
    yaw: float
    is_stalled: bool
    is_moving: bool


class ServerLink:
    """The connection to a server and its newest data. A thread reads, any thread may write."""

    def __init__(self, robot: str, on_notice: Callable[[LinkNotice, str], None] | None = None) -> None:
        """``robot``: ``player://HOST:PORT/INDEX``. ``on_notice`` is called in the thread that reads."""
        self.name = robot
        self._host, self._port, self._index = address_of(robot)
        self._report = on_notice or (lambda *_: None)
        self._changed = threading.Condition(threading.RLock())
        self._socket: socket.socket | None = None
        self._reader = MessageReader(LONGEST_REPLY)
        self._data: dict[tuple[int, int, int], tuple[float, Values]] = {}
        self._replies: dict[tuple[int, int, int], Values | None] = {}
        self._closed = threading.Event()
        self._factor = timeout_factor()
        self._driven_until = inf
        self._read_at: float
        """When something was read last, since the first reply."""
        self.permit = 0
        """The number of the last halt. Commands that began before it are not sent."""
        self.epoch = 0
        """How often the server was lost."""
        self.is_there = False
        self.shapes: dict[RobotPart, dict[int, Values]] = {}
        """Of opened devices: the content of each reply about their shape, empty if it was refused."""

    def connect(self) -> None:
        """Raises ``RobotProblem``."""
        try:
            self._open()
        except (OSError, TooLong) as problem:
            self._shut()
            reason = _reason(problem)
            code = "given-up" if self._closed.is_set() else "no-server" if reason else "no-answer"
            raise RobotProblem(code, port=self.name, reason=reason) from None
        threading.Thread(target=self._read, name="server", daemon=True).start()

    def give_up(self) -> None:
        self._closed.set()

    def close(self) -> None:
        self.stop()
        self._closed.set()
        self._shut()

    # --- data

    def values(self, part: RobotPart) -> Values:
        """The values of its newest datum; empty if there is none."""
        return self._data.get((*self._key(part), 1), (-inf, ()))[1]

    def time_of(self, part: RobotPart) -> float:
        """The time of its newest datum; minus infinity if there is none."""
        return self._data.get((*self._key(part), 1), (-inf, ()))[0]

    def shape(self, part: RobotPart, subtype: int = 1) -> Values:
        """Empty if nothing is known."""
        return self.shapes.get(part, {}).get(subtype, ())

    def wheels(self) -> WheelState:
        at, numbers = max(0.0, self.time_of(RobotPart.WHEELS)), self.values(RobotPart.WHEELS) or (inf,)
        x, y, yaw, ahead, left, turn, stall = numbers if all(map(isfinite, numbers)) else (0.0,) * 7
        is_moving = hypot(ahead, left) > STANDING or abs(turn) > STANDING
        return WheelState(at, x, y, degrees(yaw), bool(stall), is_moving)

    def wait_for_data(self, after: float) -> WheelState | None:
        """Waits for a newer state; None if none comes within a tenth of a second."""
        with self._changed:
            self._changed.wait_for(lambda: self.wheels().time > after or not self.is_there, POLL)
        state = self.wheels()
        return state if state.time > after else None

    # --- commands

    def drive(self, permit: int, ahead: float, turn: float = 0.0) -> None:
        self._steer(permit, 1, ahead, 0.0, turn, 1)

    def turn_to(self, permit: int, state: WheelState, yaw: float) -> None:
        """Turns the robot to this heading, at its place."""
        self._steer(permit, 2, state.x, state.y, radians(normal(yaw)), 0.0, 0.0, 0.0, 1)

    def stop(self) -> None:
        """Stop the robot. Any thread; never raises."""
        with self._changed:
            self.permit += 1
            self._driven_until = inf
            self.command(RobotPart.WHEELS, 1, 0.0, 0.0, 0.0, 1)

    def wait_until_standing(self) -> None:
        ends, pause = monotonic() + LONGEST_STANDING, threading.Event()
        while self.is_there and self.wheels().is_moving and monotonic() < ends:
            pause.wait(0.02)

    def command(self, part: RobotPart, subtype: int, *values: object) -> None:
        """Send a command. Has no effect without a connection, or for a device that isn't open."""
        if part in self.shapes:
            with suppress(OSError):
                self._send(self._key(part), COMMAND, subtype, *values)

    def _steer(self, permit: int, subtype: int, *values: object) -> None:
        with self._changed:
            if permit == self.permit:
                self.command(RobotPart.WHEELS, subtype, *values)
                self._driven_until = monotonic() + LEASE

    # --- inside

    def _open(self) -> None:
        """Connects, and opens the devices that the server has."""
        self._socket = socket.create_connection((self._host, self._port), CONNECTING)
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        banner = b""
        while len(banner) < BANNER_SIZE and (received := self._socket.recv(BANNER_SIZE - len(banner))):
            banner += received
        if not banner.startswith(b"Player"):
            raise ConnectionError("no Player server")
        self._reader = MessageReader(LONGEST_REPLY)
        self._data.clear()
        self.shapes.clear()
        self._ask(SERVER, 10, -1, -1, DATA, -1, 1)  # the newest is enough
        offered = self._ask(SERVER, 1)
        there = {tuple(each[2:]) for each in offered[0]} if offered else set()
        for part in RobotPart:
            key, is_foreign = self._key(part), bool(self._index and part.value[1])
            if key in there and not is_foreign and self._ask(SERVER, 3, 0, 0, *key, Access.OPEN, ""):
                self.shapes[part] = {each: self._ask(key, each) or () for each in part.value[2:]}
        if RobotPart.WHEELS not in self.shapes:
            self._shut()
            raise RobotProblem("no-wheels", port=self.name)
        limit = monotonic() + ANSWERING * self._factor
        while not self.values(RobotPart.WHEELS):
            self._pump(limit)
        settled = monotonic() + SETTLING * self._factor
        while monotonic() < settled and not all(map(self.values, self.shapes.keys() - SILENT)):
            self._pump()
        self.is_there = True

    def _key(self, part: RobotPart) -> Key:
        return part.value[0], self._index + part.value[1]

    def _ask(self, key: Key, subtype: int, *values: object) -> Values | None:
        """Sends a request and returns the content of the reply; None for a refusal."""
        self._replies.pop((*key, subtype), None)
        self._send(key, REQUEST, subtype, *values)
        limit = monotonic() + ANSWERING * self._factor
        while (*key, subtype) not in self._replies:
            self._pump(limit)
        return self._replies[*key, subtype]

    def _send(self, key: Key, type_: int, subtype: int, *values: object) -> None:
        message = PlayerMessage(*key, type_, subtype, body_of(key[0], type_, subtype, *values))
        with self._changed:
            if self._socket is None:
                raise ConnectionResetError
            self._socket.sendall(message.encoded())

    def _pump(self, limit: float = inf) -> None:
        """Reads what has arrived; waits a tenth of a second at most. Raises ``OSError``."""
        connected = self._socket
        if self._closed.is_set() or connected is None:
            raise ConnectionAbortedError
        if select.select([connected], [], [], POLL)[0]:
            data = connected.recv(1 << 16)
            if not data:
                raise ConnectionResetError
            self._read_at = monotonic()
            with self._changed:
                for message in self._reader.feed(data):
                    kind, values = (message.interface, message.index, message.subtype), values_of(message)
                    if message.type != DATA:
                        self._replies[kind] = None if message.type == NACK else values
                    elif values is not None:
                        self._data[kind] = (message.time, values)
                self._changed.notify_all()
        elif monotonic() > limit:
            raise TimeoutError

    def _read(self) -> None:
        """The reading thread: runs until ``close``, and connects again whenever the server is lost."""
        while not self._closed.is_set():
            try:
                while True:
                    self._pump()
                    self._look_after()
            except (OSError, TooLong) as problem:
                self._lose(_reason(problem))
            while not self._closed.wait(AGAIN):
                try:
                    self._open()
                except (OSError, TooLong, RobotProblem):
                    self._shut()
                    continue
                self._report(LinkNotice.RESTORED, self.name)
                break

    def _look_after(self) -> None:
        """Stop a robot whose program gives no more commands; ask for a sign of life."""
        now = monotonic()
        with self._changed:
            if now > self._driven_until:
                self._driven_until = inf
                self.command(RobotPart.WHEELS, 1, 0.0, 0.0, 0.0, 1)
        if now - self._read_at > LOST * self._factor:
            raise TimeoutError
        if now - self._read_at > SILENCE:
            self._send(SERVER, REQUEST, 1)

    def _lose(self, reason: str) -> None:
        with self._changed:
            was_there, self.is_there = self.is_there, False
            self.epoch += 1
            self._changed.notify_all()
        self._shut()
        if was_there and not self._closed.is_set():
            self._report(LinkNotice.LOST, reason)

    def _shut(self) -> None:
        with self._changed:
            connected, self._socket = self._socket, None
            self.is_there = False
        if connected is not None:
            with suppress(OSError):
                connected.shutdown(socket.SHUT_RDWR)
            connected.close()


def _reason(problem: Exception) -> str:
    """The system's reason; empty if the server sent something wrong or nothing."""
    return getattr(problem, "strerror", None) or ""
