"""A robot at a Player server, driven as the original's client drives it: by velocities, and turns to a pose.

Its time is the server's, which all data carry, so a server may run at any pace. A movement that loses the
server ends with ``StoppedBy.LINK``, and the next command raises ``link-lost``, even if the server is back by
then. The server stops a robot that its last client has left.
"""

from __future__ import annotations

import select
import socket
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from math import cos, degrees, hypot, inf, isfinite, radians, sin
from time import monotonic
from typing import Any, TypeAlias

from msgspec import Struct

from devices.belt import LETTERS, MOTOR_PLACES
from devices.player.codec import (
    BANNER_SIZE,
    LONGEST_REPLY,
    BadBody,
    MessageReader,
    MessageType,
    PlayerMessage,
    TooLong,
)
from devices.player.interfaces import Access, Interface, body_of, values_of
from devices.ports.robot import (
    STEP,
    Bearing,
    LinkNotice,
    Met,
    Motion,
    Pace,
    Pose,
    RobotProblem,
    Sighting,
    StoppedBy,
    TurnResult,
    WalkResult,
    Watcher,
)
from devices.serial_robot.senses import scan_angles, sightings, to_steps
from donnie_tui.process.signals import timeout_factor
from sim.colours import FAMILIES, colour_of
from sim.geometry import normal
from sim.sensors import Device, Mounted

WHEELS, HEAD = (Interface.POSITION2D, 0), (Interface.POSITION2D, 1)
SONARS, HEAD_SONAR = (Interface.RANGER, 0), (Interface.RANGER, 1)
BUMPERS, CAMERA = (Interface.BUMPER, 0), (Interface.BLOBFINDER, 0)
SPEECH = (Interface.SPEECH, 0)
WANTED = (WHEELS, HEAD, SONARS, HEAD_SONAR, BUMPERS, CAMERA, SPEECH, (Interface.DIO, 0), (Interface.DIO, 1))
"""The devices that are opened if the server has them."""

CONNECTING, ANSWERING = 2.0, 5.0
"""Seconds that the server may take to accept a connection, and to answer a request."""
SILENCE, LOST = 2.0, 5.0
"""Seconds without data after which the server is asked for a sign of life, and after which it is lost."""
AGAIN = 1.0
"""Seconds between two tries to connect again."""
POLL = 0.1
LEASE = 0.5
"""Seconds for which one command drives the robot. A paused program sends no further one."""

Key = tuple[int, int]
"""The interface and the index of a device."""


class WheelState(Struct, frozen=True):
    """One datum of the wheels: simulated seconds, metres and degrees counter-clockwise."""

    time: float
    x: float
    y: float
    yaw: float
    is_stalled: bool
    is_moving: bool


Advance: TypeAlias = Callable[[WheelState], StoppedBy | bool]
"""Takes a datum; True once it is over, or why it can't go on."""


class ServerLink:
    """The connection to a server and its newest data. A thread reads, any thread may write."""

    def __init__(
        self, host: str, port: int, on_notice: Callable[[LinkNotice, str], None] | None = None
    ) -> None:
        """``on_notice`` is called in the thread that reads."""
        self.name = f"player://{host}:{port}"
        self._address = (host, port)
        self._report = on_notice or (lambda *_: None)
        self._changed = threading.Condition(threading.RLock())
        self._socket: socket.socket | None = None
        self._reader = MessageReader(LONGEST_REPLY)
        self._data: dict[tuple[int, int, int], PlayerMessage] = {}
        self._replies: dict[tuple[int, int, int], PlayerMessage] = {}
        self._closed = threading.Event()
        self._factor = timeout_factor()
        self._driven_until = inf
        self._read_at = 0.0
        self.permit = 0
        """The number of the last halt. Commands that began before it are not sent."""
        self.epoch = 0
        """How often the server was lost."""
        self.is_there = False
        self.devices: dict[Key, tuple[Any, ...]] = {}
        """Those that were opened, with the geometry of each that has one."""
        self.configurations: dict[Key, tuple[Any, ...]] = {}

    def connect(self) -> None:
        """Raises ``RobotProblem``."""
        try:
            self._open()
        except (OSError, TooLong, BadBody) as problem:
            self._shut()
            reason = _reason(problem)
            code = "given-up" if self._closed.is_set() else "no-server" if reason else "no-answer"
            raise RobotProblem(code, port=self.name, reason=reason) from None
        threading.Thread(target=self._read, name="server", daemon=True).start()

    def give_up(self) -> None:
        self._closed.set()

    def close(self) -> None:
        self.halt()
        self._closed.set()
        self._shut()

    # --- data

    def values(self, key: Key, subtype: int = 1) -> tuple[float, tuple[Any, ...]] | None:
        """The time and the content of its newest datum."""
        message = self._data.get((*key, subtype))
        with suppress(BadBody):
            return None if message is None else (message.time, values_of(message))
        return None

    def wheels(self) -> WheelState:
        at, numbers = self.values(WHEELS) or (0.0, (0.0,) * 7)
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

    def halt(self) -> None:
        """Any thread; never raises."""
        with self._changed:
            self.permit += 1
            self._driven_until = inf
            self.command(WHEELS, 1, 0.0, 0.0, 0.0, 1)

    def command(self, key: Key, subtype: int, *values: object) -> None:
        """Has no effect without a connection, or for a device that isn't open."""
        if key in self.devices:
            with suppress(OSError):
                self._send(key, MessageType.COMMAND, subtype, *values)

    def _steer(self, permit: int, subtype: int, *values: object) -> None:
        with self._changed:
            if permit == self.permit:
                self.command(WHEELS, subtype, *values)
                self._driven_until = monotonic() + LEASE

    # --- inside

    def _open(self) -> None:
        """Connects, and opens the devices of ``WANTED`` that the server has."""
        self._socket = socket.create_connection(self._address, CONNECTING)
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        banner = b""
        while len(banner) < BANNER_SIZE and (part := self._socket.recv(BANNER_SIZE - len(banner))):
            banner += part
        if not banner.startswith(b"Player"):
            raise BadBody("no Player server")
        self._reader = MessageReader(LONGEST_REPLY)
        self._data.clear()
        self.devices.clear()
        self._ask((Interface.PLAYER, 0), 10, -1, -1, MessageType.DATA, -1, 1)  # the newest is enough
        offered = self._ask((Interface.PLAYER, 0), 1)
        there = {tuple(each[2:]) for each in offered[0]} if offered else set()
        for key in WANTED:
            if key in there and self._ask((Interface.PLAYER, 0), 3, 0, 0, *key, Access.OPEN, "") is not None:
                has_shape = key[0] in (Interface.RANGER, Interface.BUMPER)
                self.devices[key] = (self._ask(key, 1) if has_shape else None) or ()
                if key[0] == Interface.RANGER:
                    self.configurations[key] = self._ask(key, 5) or ()
        if WHEELS not in self.devices:
            self._shut()
            raise RobotProblem("no-wheels", port=self.name)
        limit = monotonic() + ANSWERING * self._factor
        while self.values(WHEELS) is None:
            self._pump(limit)
        self.is_there = True

    def _ask(self, key: Key, subtype: int, *values: object) -> tuple[Any, ...] | None:
        """What is in the reply; None for a refusal."""
        self._replies.pop((*key, subtype), None)
        self._send(key, MessageType.REQUEST, subtype, *values)
        limit = monotonic() + ANSWERING * self._factor
        while (reply := self._replies.get((*key, subtype))) is None:
            self._pump(limit)
        return None if reply.type == MessageType.NACK else values_of(reply)

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
                    kind = (message.interface, message.index, message.subtype)
                    (self._data if message.type == MessageType.DATA else self._replies)[kind] = message
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
                except (OSError, TooLong, BadBody, RobotProblem):
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
                self.command(WHEELS, 1, 0.0, 0.0, 0.0, 1)
        if now - self._read_at > LOST * self._factor:
            raise TimeoutError
        if now - self._read_at > SILENCE:
            self._send((Interface.PLAYER, 0), MessageType.REQUEST, 1)

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


def _met(end: StoppedBy | None, way: float) -> Met | None:
    """Stands for an obstacle: a robot at a server can't know what it met."""
    return Met("something", "", way) if end in (StoppedBy.OBSTACLE, StoppedBy.COLLISION) else None


def _reason(problem: Exception) -> str:
    """The system's reason; empty if the server sent something wrong or nothing."""
    return getattr(problem, "strerror", None) or ""


STANDING = 0.005
"""Metres or radians a second: a slower robot counts as standing."""
FASTEST = STEP
"""Metres a second: a step a second, as the original."""
GAIN, SLOWEST = 4.0, 0.006
"""The speed near the end, a second, of what is left; and the least of it, in metres a second."""
NEAR_WAY, NEAR_TURN, NEAR_HEAD = 0.001, 0.5, 0.7
"""Metres and degrees: a robot that is so near to its goal has reached it."""
LARGEST_TURN = 170.0
"""Degrees of a turn to a pose: what is more could go either way round."""
DEGREES_A_REPORT = 10
NEXT_STEP, WATCHED = 1.8, 0.75
"""Steps that must be free to begin one, and beyond the one that is walked."""
STUCK = 3.0
"""Seconds without progress after which a movement ends."""
GAP = 1.0
"""Seconds between two data from which on the program was held meanwhile, and the robot stood."""
FRAME = 1 / 20
"""Seconds between two poses for a moving picture."""
VIEW, REACH = 60.0, 5.0
"""Degrees and metres: no request asks for a blobfinder's view; this is that of the original's."""
LONGEST_STANDING = 2.2
"""Seconds that a stop may take."""


class PlayerRobot:
    """One robot of a server. Only the program's thread may call its methods, except ``halt``, ``pose``,
    ``time``, ``speed`` and ``known_distances``."""

    name = "donnie"
    may_drive_on = has_run_away = False
    """The server stops a robot when its last client leaves."""

    def __init__(
        self, link: ServerLink, *, pace: Pace, watcher: Watcher | None = None, start: Pose | None = None
    ) -> None:
        """``start``: where a robot is that counts from 0 0 0."""
        self._link, self._pace, self._watcher = link, pace, watcher
        self._start = start or Pose(0.0, 0.0, 0.0)
        self._turned_by = 0.0
        """Degrees between its own counting and the world."""
        self._began = 0.0
        self._owed_way = self._owed_turn = 0.0
        """Metres ahead and degrees to the right by which the last movement was too short."""
        self._is_lost = False
        self._passing_at = 0.0
        self.leave: tuple[Callable[[], object], ...] = ()
        """Called when the robot is closed."""

    @property
    def port(self) -> str:
        return self._link.name

    @property
    def colours(self) -> frozenset[str]:
        return frozenset(FAMILIES) if CAMERA in self._link.devices else frozenset()

    @property
    def speed(self) -> float | None:
        """Always 1: the server alone sets its pace."""
        return 1.0

    @speed.setter
    def speed(self, speed: float | None) -> None:
        """Does nothing: only the server can change its speed."""

    def connect(self) -> None:
        """Some seconds at most. Raises ``RobotProblem``."""
        self._link.connect()
        first = self._link.wheels()
        if first.x == first.y == first.yaw == 0.0:
            self._turned_by = 90.0 - self._start.heading
        else:
            self._start = Pose(0.0, 0.0, 90.0)
        self.reset()

    def give_up(self) -> None:
        self._link.give_up()

    def close(self) -> None:
        for leave in self.leave:
            leave()
        self._link.close()

    def wait_until_standing(self) -> None:
        ends, pause = monotonic() + LONGEST_STANDING, threading.Event()
        while self._link.is_there and self._link.wheels().is_moving and monotonic() < ends:
            pause.wait(0.02)

    def reset(self) -> None:
        """Sets the time to 0. The robot stays at its place."""
        self._began = self._link.wheels().time
        self._owed_way = self._owed_turn = 0.0
        self._is_lost = False

    def halt(self) -> None:
        self._is_lost = False
        self._link.halt()

    @property
    def mounted(self) -> tuple[Mounted, ...]:
        """What the server says that it has."""
        found = []
        for key in (SONARS, HEAD_SONAR):
            config = self._link.configurations.get(key) or (0.0,) * 5
            for each in self._link.devices.get(key, ((),) * 2)[-2]:
                width = degrees(config[1] - config[0])
                found.append(Mounted(Device.RANGER, 0.0 - normal(degrees(each[5])), width, config[4]))
        if CAMERA in self._link.devices:
            found.append(Mounted(Device.EYES, 0.0, VIEW, REACH))
        bars = self._link.devices.get(BUMPERS, ((),))[0]
        return (*found, *(Mounted(Device.BUMPER, 0.0 - normal(degrees(each[5]))) for each in bars))

    # --- moving

    def forward(self, steps: int) -> WalkResult:
        """ValueError if ``steps`` is negative; RobotProblem ``link-lost``."""
        return self._walk(Motion.FORWARD, steps, 1)

    def backward(self, steps: int) -> WalkResult:
        """ValueError if ``steps`` is negative; RobotProblem ``link-lost``."""
        return self._walk(Motion.BACKWARD, steps, -1)

    def _walk(self, motion: Motion, steps: int, sense: int) -> WalkResult:
        if steps < 0:
            raise ValueError("a walk has no negative steps")
        self._require_link()
        if steps == 0:
            return WalkResult(0, 0, None, self.pose())
        side = Bearing.FRONT if sense > 0 else Bearing.BACK
        first, permit = self._link.wheels(), self._link.permit
        east, north = cos(radians(first.yaw)) * sense, sin(radians(first.yaw)) * sense
        extra, self._owed_way = self._owed_way * sense, 0.0
        length, begun, done, left = steps * STEP + extra, 0, 0, 0.0
        reason: StoppedBy | None = None

        def advance(now: WheelState) -> StoppedBy | bool:
            nonlocal length, begun, done, left, reason
            gone = (now.x - first.x) * east + (now.y - first.y) * north - extra
            while done < steps and gone >= (done + 1) * STEP - 2 * NEAR_WAY:
                done += 1
                self._progress(motion)
            left = length - extra - gone
            if self._touches(in_front=sense > 0) or (now.is_stalled and now.time > first.time):
                return StoppedBy.COLLISION
            known = self._nearest(side)
            free = inf if known is None else known
            if begun < steps and reason is None and gone >= begun * STEP - FASTEST * POLL:
                if free + gone - begun * STEP < NEXT_STEP * STEP:
                    length, reason = begun * STEP + extra, StoppedBy.OBSTACLE
                    left = length - extra - gone
                else:
                    begun += 1
            if reason is None and free < begun * STEP - gone + WATCHED * STEP:
                return StoppedBy.OBSTACLE
            if abs(left) < NEAR_WAY or (reason and left < NEAR_WAY):
                return reason or True
            speed = min(FASTEST, max(SLOWEST, GAIN * abs(left)))
            self._link.drive(permit, speed * sense * (1 if left > 0 else -1))
            return False

        end = self._move(advance, permit)
        self._owed_way = left * sense if end in (None, StoppedBy.OBSTACLE) and abs(left) < STEP / 2 else 0.0
        met = _met(end, 0.0 if sense > 0 else 180.0)
        return WalkResult(steps, steps if end is None else done, end, self.pose(), met)

    def turn(self, degrees: int) -> TurnResult:
        """RobotProblem ``link-lost``."""
        self._require_link()
        sense = 1 if degrees >= 0 else -1
        if degrees == 0:
            return TurnResult(0, 0, None, self.pose())
        motion = Motion.RIGHT if sense > 0 else Motion.LEFT
        permit, asked = self._link.permit, abs(degrees)
        first, done, reported = self._link.wheels(), 0.0, 0
        last = first.yaw
        left = asked + self._owed_turn * sense
        self._owed_turn = 0.0
        pressed = self._pressed()

        def advance(now: WheelState) -> StoppedBy | bool:
            nonlocal last, done, left, reported
            gone = -normal(now.yaw - last) * sense
            before, last, done, left = left, now.yaw, done + gone, left - gone
            while reported < asked and done >= min(asked, reported + DEGREES_A_REPORT) - NEAR_TURN:
                reported = min(asked, reported + DEGREES_A_REPORT)
                self._progress(motion)
            if (now.is_stalled and now.time > first.time) or self._pressed() > pressed:
                return StoppedBy.COLLISION
            if abs(left) < NEAR_TURN and abs(left) >= abs(before) - 0.01:  # it comes no nearer
                return True
            self._link.turn_to(permit, now, now.yaw - sense * min(left, LARGEST_TURN))
            return False

        end = self._move(advance, permit)
        self._owed_turn = left * sense if end is None else 0.0
        whole = asked if end is None else max(0, min(asked, int(done)))
        return TurnResult(degrees, sense * whole, end, self.pose(), _met(end, sense * 90.0))

    def _move(self, advance: Advance, permit: int) -> StoppedBy | None:
        """Calls ``advance`` with each datum until it ends the movement, then stops the robot."""
        try:
            return self._follow(advance, permit)
        finally:
            self._link.drive(permit, 0.0)

    def _follow(self, advance: Advance, permit: int, *, is_waiting: bool = False) -> StoppedBy | None:
        """Call ``advance`` with each datum, the last one first. ``is_waiting``: it may stand as long as it
        likes."""
        epoch, at, last, moved_at = self._link.epoch, -1.0, None, inf
        while True:
            if not self._pace.sleep(0.0) or permit != self._link.permit:
                return StoppedBy.USER
            now = self._link.wait_for_data(at)
            if epoch != self._link.epoch or not self._link.is_there:
                self._is_lost = True
                return StoppedBy.LINK
            if now is None:
                continue
            place = (now.x, now.y, now.yaw)
            if place != last or now.time - at > GAP:
                moved_at = now.time
            at, last = now.time, place
            self._report_passing()
            end = advance(now)
            if end is not False:
                return None if end is True else end
            if now.time - moved_at > STUCK and not is_waiting:
                return StoppedBy.STALL

    def _require_link(self) -> None:
        if self._is_lost or not self._link.is_there:
            self._is_lost = False
            raise RobotProblem("link-lost", port=self._link.name)

    def _progress(self, motion: Motion) -> None:
        if self._watcher is not None:
            self._watcher.progressed(motion, self.pose())

    def _report_passing(self) -> None:
        if self._watcher is not None and monotonic() - self._passing_at >= FRAME:
            self._passing_at = monotonic()
            self._watcher.passing(self.pose())

    # --- waiting and sensing

    def wait(self, seconds: float) -> bool:
        """RobotProblem ``link-lost`` without a server, or if it is lost meanwhile."""
        self._require_link()
        ends = self._link.wheels().time + max(0.0, seconds)
        return self._wait(lambda now: now.time >= ends - 1e-9)

    def _wait(self, is_over: Callable[[WheelState], bool]) -> bool:
        """False if it was cut short. RobotProblem ``link-lost``."""
        end = self._follow(is_over, self._link.permit, is_waiting=True)
        if end is StoppedBy.LINK:
            self._require_link()
        return end is None

    def time(self) -> float:
        return self._link.wheels().time - self._began

    def pose(self) -> Pose:
        """Where the last movement should have ended: the next movement corrects the difference."""
        now, turned, start = self._link.wheels(), radians(self._turned_by), self._start
        yaw = now.yaw - self._owed_turn
        x, y = now.x + self._owed_way * cos(radians(yaw)), now.y + self._owed_way * sin(radians(yaw))
        x, y = x * cos(turned) - y * sin(turned), x * sin(turned) + y * cos(turned)
        heading = (90.0 - yaw - self._turned_by) % 360.0
        return Pose(start.x + x / STEP, start.y + y / STEP, heading)

    def true_pose(self) -> Pose | None:
        """Unknown."""
        return None

    def distance(self, bearing: Bearing) -> int:
        """RobotProblem ``no-sensor`` where no sensor looks there, ``link-lost`` without a server."""
        self._require_link()
        known = self.known_distances()
        if bearing not in known:
            raise RobotProblem("no-sensor", bearing=bearing.words)
        return known[bearing]

    def known_distances(self) -> Mapping[Bearing, int]:
        known = {bearing: self._nearest(bearing) for bearing in Bearing}
        return {
            bearing: to_steps(metres if metres == inf else round(metres * 100))
            for bearing, metres in known.items()
            if metres is not None
        }

    def _nearest(self, side: Bearing) -> float | None:
        """Metres; None where no sensor looks."""
        readings = self._readings(SONARS)
        return min((m for yaw, m, width in readings if abs(normal(-yaw - side.value)) <= width), default=None)

    def _readings(self, key: Key) -> Iterator[tuple[float, float, float]]:
        """Of each sample of a ranger: its direction, its metres, and how far from a bearing it may be."""
        newest, geometry = self._link.values(key), self._link.devices.get(key)
        [ranges] = newest[1] if newest else ((),)
        config = self._link.configurations.get(key, ())
        farthest = config[4] - 0.005 if config else inf
        poses = geometry[-2] if geometry else ()
        yaws = [degrees(each[5]) for each in poses]
        many = len(yaws) == 1 < len(ranges) and config
        if many:
            yaws = [yaws[0] + degrees(config[0] + (i + 0.5) * config[2]) for i in range(len(ranges))]
        elif not yaws:
            yaws = list(ORIGINAL_SONARS)
        for yaw, metres in zip(yaws, ranges, strict=False):
            yield yaw, (metres if metres < farthest else inf), NARROW if many else WIDE

    def _pressed(self) -> frozenset[int]:
        newest = self._link.values(BUMPERS)
        bars = newest[1][0] if newest else b""
        return frozenset(i for i, each in enumerate(bars) if each)

    def _touches(self, *, in_front: bool) -> bool:
        """Whether a bar on that side is pressed; where bars are unknown, the first two are in front."""
        geometry = self._link.devices.get(BUMPERS)
        places = [each[0] for each in geometry[0]] if geometry else [1.0, 1.0, -1.0, -1.0]
        return any((places[each] >= 0.0) is in_front for each in self._pressed() if each < len(places))

    # --- looking round

    def scan(self) -> tuple[Sighting, ...]:
        """Turns the head, if it has one. RobotProblem ``no-eyes`` without a camera or a sonar on the head."""
        self._require_link()
        has_head, has_camera = HEAD in self._link.devices, CAMERA in self._link.devices
        if not has_camera and not (has_head and HEAD_SONAR in self._link.devices):
            raise RobotProblem("no-eyes")
        directions = (-VIEW, 0.0, VIEW) if has_camera else tuple(map(float, scan_angles(15)))
        seen: list[Stretch] = []
        measured: list[tuple[int, float | None]] = []
        for direction in directions if has_head else (0.0,):
            if has_head and not self._look(direction):
                break
            if has_camera:
                seen += self._stretches(direction)
            else:
                echo = min((metres for _, metres, _ in self._readings(HEAD_SONAR)), default=inf)
                measured.append((int(direction), echo * 100))
        if has_head:
            self._look(0.0)
        return things_of(seen) if has_camera else sightings(measured)

    def _look(self, direction: float) -> bool:
        """Turn the head ``direction`` degrees to the right, and wait for what its devices find there."""
        base = self._link.wheels()
        goal, there = radians(normal(base.yaw - direction)), inf

        def is_over(now: WheelState) -> bool:
            nonlocal there
            head = self._link.values(HEAD)
            yaw = degrees(head[1][2]) if head else degrees(goal)
            if there == inf and abs(normal(yaw - degrees(goal))) < NEAR_HEAD:
                there = now.time
            self._link.command(HEAD, 2, base.x, base.y, goal, 0.0, 0.0, 0.0, 1)
            eye = self._link.values(CAMERA) or self._link.values(HEAD_SONAR)
            return (eye is not None and eye[0] > there) or now.time > base.time + LONGEST_LOOK

        return self._wait(is_over)

    def _stretches(self, direction: float) -> Iterator[Stretch]:
        """As far as the head's sonar would measure it, which is not in the middle."""
        _, (width, _, blobs) = self._link.values(CAMERA) or (0.0, (1, 1, ()))
        sonar = self._link.devices.get(HEAD_SONAR)
        ahead = sonar[-2][0][0] if sonar and sonar[-2] else 0.0
        for _, rgb, _, _, _, left, right, _, _, metres in blobs:
            parts = (rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255)
            family = colour_of("", *(each / 255 for each in parts)).family
            first, last = (direction + (each / width - 0.5) * VIEW for each in (left, right + 1))
            yield Stretch(first, last, max(0.0, metres - ahead), family)

    # --- what is shown and said there

    def say(self, text: str) -> None:
        self._link.command(SPEECH, 1, text)

    def show_belt(self, levels: tuple[int, ...]) -> None:
        """14 levels."""
        for place, level in zip(MOTOR_PLACES, levels, strict=False):
            for index in (0, 1):
                self._link.command((Interface.DIO, index), 1, place, LETTERS[level])


ORIGINAL_SONARS = (-45.0, 0.0, 45.0, 135.0, 180.0, -135.0)
"""Where the sonars of a server look that doesn't say it."""
WIDE, NARROW = 22.5, 7.5
"""Degrees from a bearing: of one of several sensors, and of a sample of one."""
LONGEST_LOOK = 6.0
"""Seconds of the robot's that the head may take."""


class Stretch(Struct, frozen=True):
    """A stretch of one colour: degrees to the right of the front, metres, and the word of the language."""

    left: float
    right: float
    metres: float
    colour: str


def things_of(stretches: list[Stretch]) -> tuple[Sighting, ...]:
    """From left to right. What crosses the border of two pictures is one thing."""
    things: list[Stretch] = []
    for each in sorted(stretches, key=lambda it: it.left):
        for at, thing in enumerate(things):
            if thing.colour == each.colour and abs(thing.right - each.left) < TOUCHING:
                nearest = min(thing.metres, each.metres)
                things[at] = Stretch(thing.left, each.right, nearest, each.colour)
                break
        else:
            things.append(each)
    found = [
        Sighting(max(-90.0, min(90.0, (it.left + it.right) / 2)), it.metres / STEP, it.colour, "")
        for it in things
    ]
    return tuple(sorted(found, key=lambda it: it.degrees))


TOUCHING = 1.0
"""Degrees between two parts of one thing."""
