"""The connection to a Player server, message by message, at the other end of a real socket."""

from __future__ import annotations

import socket
import threading
from collections.abc import Iterator
from math import inf, nan, pi, radians
from typing import Any

import pytest

from devices.player.codec import (
    COMMAND,
    DATA,
    REQUEST,
    Access,
    MessageReader,
    MessageType,
    PlayerMessage,
    banner,
    body_of,
    values_of,
)
from devices.ports.robot import LinkNotice, RobotProblem
from donnie_tui.robot import server_link as module
from donnie_tui.robot.server_link import RobotPart, ServerLink, WheelState
from tests.timeouts import TIMEOUT

Sent = tuple[int, int, int, int, Any]
"""Interface, index, type, subtype and values of a message."""


class Linked:
    """A connected link, the server's end of its socket, and the time."""

    def __init__(self, name: str = "player://host:1") -> None:
        self.notices: list[tuple[LinkNotice, str]] = []
        self.link = ServerLink(name, lambda *notice: self.notices.append(notice))
        self.link._socket, self.server = socket.socketpair()
        self.link.shapes = {part: {} for part in RobotPart}
        self.link.is_there, self.link._factor = True, 1.0
        self.link._read_at = self.now = 100.0
        self._reader = MessageReader(10**6)

    def sent(self) -> list[Sent]:
        """What the link has sent since the last call."""
        self.server.setblocking(False)
        try:
            data = self.server.recv(1 << 16)
        except BlockingIOError:
            return []
        return [(e.interface, e.index, e.type, e.subtype, values_of(e)) for e in self._reader.feed(data)]

    def receives(self, *messages: PlayerMessage) -> None:
        self.server.sendall(b"".join(each.encoded() for each in messages))
        self.link._pump()

    def receives_wheels(self, time: float, *values: float, index: int = 0) -> None:
        body = body_of(4, DATA, 1, *values[:-1], int(values[-1]))
        self.receives(PlayerMessage(4, index, DATA, 1, body, time))


@pytest.fixture
def linked(monkeypatch: pytest.MonkeyPatch) -> Iterator[Linked]:
    made = Linked()
    monkeypatch.setattr(module, "monotonic", lambda: made.now)
    monkeypatch.setattr(module, "POLL", 0.0)
    yield made
    made.link._shut()
    made.server.close()


STOP = (4, 0, COMMAND, 1, (0.0, 0.0, 0.0, 1))


# --- data


def test_without_data_the_robot_stands_at_0(linked: Linked) -> None:
    assert linked.link.wheels() == WheelState(0.0, 0.0, 0.0, 0.0, False, False)
    assert linked.link.values(RobotPart.SONARS) == ()
    assert linked.link.time_of(RobotPart.SONARS) == -inf


@pytest.mark.parametrize(
    ("speeds", "is_moving"),
    [
        ((0.0, 0.0, 0.0), False),
        ((0.005, 0.0, 0.0), False),
        ((-0.0051, 0.0, 0.0), True),
        ((0.0, 0.0051, 0.0), True),
        ((0.004, 0.004, 0.0), True),
        ((0.0, 0.0, 0.005), False),
        ((0.0, 0.0, -0.0051), True),
    ],
)
@pytest.mark.parametrize("stall", [0, 1])
def test_a_datum_of_the_wheels_is_in_degrees_and_says_whether_they_move(
    linked: Linked, speeds: tuple[float, float, float], is_moving: bool, stall: int
) -> None:
    linked.receives_wheels(7.5, 1.0, -2.0, pi / 2, *speeds, stall)

    assert linked.link.wheels() == WheelState(7.5, 1.0, -2.0, 90.0, bool(stall), is_moving)
    assert linked.link.time_of(RobotPart.WHEELS) == 7.5
    assert linked.link.values(RobotPart.WHEELS) == (1.0, -2.0, pi / 2, *speeds, stall)


@pytest.mark.parametrize("number", [nan, inf, -inf])
def test_a_datum_with_what_is_no_number_is_one_of_a_robot_that_stands_at_0(
    linked: Linked, number: float
) -> None:
    linked.receives_wheels(7.5, 1.0, 2.0, 0.0, 1.0, number, 0.0, 1)

    assert linked.link.wheels() == WheelState(7.5, 0.0, 0.0, 0.0, False, False)


def test_a_state_is_waited_for_until_it_is_newer_or_the_server_is_lost(linked: Linked) -> None:
    linked.receives_wheels(7.5, *(0.0,) * 6, 0)
    state = linked.link.wheels()
    assert linked.link.wait_for_data(7.4) == state
    assert linked.link.wait_for_data(7.5) is None
    linked.link.is_there = False
    assert linked.link.wait_for_data(7.5) is None
    assert linked.link.wait_for_data(7.4) == state


def test_a_shape_is_that_of_the_part_and_of_the_request(linked: Linked) -> None:
    linked.link.shapes = {RobotPart.SONARS: {1: ("places",), 5: ("settings",)}, RobotPart.CAMERA: {}}

    assert linked.link.shape(RobotPart.SONARS) == ("places",)
    assert linked.link.shape(RobotPart.SONARS, 5) == ("settings",)
    assert linked.link.shape(RobotPart.CAMERA) == ()
    assert linked.link.shape(RobotPart.HEAD, 5) == ()


def test_replies_are_kept_by_their_kind_and_a_refusal_is_none(linked: Linked) -> None:
    ack, nack = MessageType.ACK, MessageType.NACK
    linked.link._replies[4, 0, 9] = ("kept",)
    linked.receives(
        PlayerMessage(10, 0, ack, 7, body_of(10, ack, 7, 5)),
        PlayerMessage(10, 1, nack, 7),
        PlayerMessage(62, 0, DATA, 1, b"wrong"),
        PlayerMessage(62, 0, DATA, 3, body_of(62, DATA, 3, [1.0]), 3.0),
    )

    assert linked.link._replies == {(4, 0, 9): ("kept",), (10, 0, 7): (5,), (10, 1, 7): None}
    assert linked.link.values(RobotPart.SONARS) == ()


def test_the_end_of_the_server_ends_the_reading(linked: Linked) -> None:
    linked.link._pump(100.0)
    with pytest.raises(TimeoutError):
        linked.link._pump(99.9)
    linked.link._pump()
    linked.server.close()
    with pytest.raises(ConnectionResetError):
        linked.link._pump()
    linked.link._shut()
    with pytest.raises(ConnectionAbortedError):
        linked.link._pump()
    linked.link.give_up()
    with pytest.raises(ConnectionAbortedError):
        linked.link._pump()


def test_a_link_that_is_given_up_reads_no_more(linked: Linked) -> None:
    linked.link.give_up()

    with pytest.raises(ConnectionAbortedError):
        linked.link._pump()


# --- commands


def test_a_drive_is_a_velocity_and_a_turn_is_a_heading_at_the_place(linked: Linked) -> None:
    link = linked.link
    link.drive(0, 0.05)
    link.drive(0, -0.05, 0.25)
    link.turn_to(0, WheelState(1.0, 2.0, 3.0, 90.0, False, False), 270.0)

    assert linked.sent() == [
        (4, 0, COMMAND, 1, (0.05, 0.0, 0.0, 1)),
        (4, 0, COMMAND, 1, (-0.05, 0.0, 0.25, 1)),
        (4, 0, COMMAND, 2, (2.0, 3.0, radians(-90.0), 0.0, 0.0, 0.0, 1)),
    ]


def test_what_was_begun_before_a_stop_is_not_sent(linked: Linked) -> None:
    link = linked.link
    before = link.permit
    link.stop()
    assert (link.permit, linked.sent()) == (before + 1, [STOP])
    link.drive(before, 0.05)
    link.turn_to(before, link.wheels(), 10.0)
    assert linked.sent() == []
    link.drive(link.permit, 0.05)
    assert linked.sent() == [(4, 0, COMMAND, 1, (0.05, 0.0, 0.0, 1))]


def test_a_device_that_is_not_open_gets_no_command_and_a_lost_server_none_at_all(linked: Linked) -> None:
    link = linked.link
    link.shapes.pop(RobotPart.SPEECH)
    link.command(RobotPart.SPEECH, 1, "hi")
    assert linked.sent() == []
    link.command(RobotPart.BELT, 1, 11, 65)
    link.command(RobotPart.SECOND_BELT, 1, 12, 66)
    assert linked.sent() == [(20, 0, COMMAND, 1, (11, 65)), (20, 1, COMMAND, 1, (12, 66))]
    link._shut()
    link.command(RobotPart.BELT, 1, 11, 65)
    link.stop()
    link.drive(link.permit, 1.0)


def test_the_index_of_a_robot_is_that_of_its_devices(linked: Linked) -> None:
    other = Linked("player://host:1/3")
    other.link.stop()
    assert other.sent() == [(4, 3, *STOP[2:])]
    other.receives_wheels(1.0, 5.0, *(0.0,) * 5, 0, index=0)
    assert other.link.wheels().x == 0.0
    other.receives_wheels(2.0, 6.0, *(0.0,) * 5, 0, index=3)
    assert other.link.wheels().x == 6.0
    other.link._shut()
    other.server.close()


def test_a_robot_that_gets_no_command_for_half_a_second_is_stopped_once(linked: Linked) -> None:
    link = linked.link
    link._look_after()
    link.drive(link.permit, 0.05)
    linked.sent()
    linked.now = 100.5
    link._look_after()
    assert linked.sent() == []
    linked.now = 100.51
    link._look_after()
    assert linked.sent() == [STOP]
    link._look_after()
    assert linked.sent() == []

    link.drive(link.permit, 0.05)
    link.stop()
    linked.sent()
    linked.now = 101.5
    link._look_after()
    assert linked.sent() == []
    link.drive(link.permit - 1, 0.05)  # it is not sent, and drives nothing
    linked.now = 102.0
    link._look_after()
    assert linked.sent() == []


def test_a_silent_server_is_asked_for_a_sign_after_two_seconds_and_is_lost_after_five(linked: Linked) -> None:
    for linked.now in (101.0, 102.0):
        linked.link._look_after()
    assert linked.sent() == []
    for linked.now in (102.1, 105.0):
        linked.link._look_after()
        assert linked.sent() == [(1, 0, REQUEST, 1, ())]
    linked.now = 105.1
    with pytest.raises(TimeoutError):
        linked.link._look_after()

    linked.now = 104.0
    linked.receives_wheels(1.0, *(0.0,) * 6, 0)  # it has sent something
    linked.now = 106.0
    linked.link._look_after()
    assert linked.sent() == []
    linked.link._factor = 2.0
    linked.now = 114.0
    linked.link._look_after()
    linked.now = 114.1
    with pytest.raises(TimeoutError):
        linked.link._look_after()


@pytest.mark.parametrize("is_moving", [True, False])
def test_a_robot_is_waited_for_until_it_stands_or_for_two_seconds_and_a_fifth(
    linked: Linked, monkeypatch: pytest.MonkeyPatch, is_moving: bool
) -> None:
    looks: list[float] = []

    def later() -> float:
        looks.append(linked.now)
        linked.now += 1.1
        return linked.now

    linked.now = 0.0
    monkeypatch.setattr(module, "monotonic", later)
    if is_moving:
        linked.link._data[4, 0, 1] = (1.0, (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0))
    linked.link.wait_until_standing()
    assert len(looks) == (3 if is_moving else 1)

    linked.link.is_there = False
    linked.link.wait_until_standing()
    assert len(looks) == (4 if is_moving else 2)


# --- losing and leaving


def test_a_lost_server_is_reported_once_and_its_socket_is_closed(linked: Linked) -> None:
    link = linked.link
    link._lose("Connection reset by peer")
    link._lose("again")

    assert linked.notices == [(LinkNotice.LOST, "Connection reset by peer")]
    assert (link.epoch, link.is_there, link._socket) == (2, False, None)
    assert linked.server.recv(1) == b""


def test_a_server_that_was_left_is_not_reported_as_lost(linked: Linked) -> None:
    linked.link.close()
    assert linked.sent() == [STOP]
    assert linked.server.recv(1) == b""
    linked.link.is_there = True
    linked.link._lose("")

    assert linked.notices == []


class Waits:
    """An event that is set at its third wait."""

    def __init__(self) -> None:
        self.waits: list[float] = []

    def is_set(self) -> bool:
        return len(self.waits) > 2

    def wait(self, seconds: float) -> bool:
        self.waits.append(seconds)
        return self.is_set()


def test_a_lost_server_is_connected_to_again_every_second(
    linked: Linked, monkeypatch: pytest.MonkeyPatch
) -> None:
    link, tries = linked.link, [False, True]
    waits = link._closed = Waits()  # type: ignore[assignment]

    did: list[str] = []

    def pump() -> None:
        did.append("read")
        if len(did) > 1:
            raise OSError(104, "Connection reset by peer")

    def open_again() -> None:
        did.append("open")
        if not tries.pop(0):
            raise RobotProblem("no-wheels")
        link.is_there = True

    monkeypatch.setattr(link, "_pump", pump)
    monkeypatch.setattr(link, "_open", open_again)
    monkeypatch.setattr(link, "_look_after", lambda: did.append("look after"))
    monkeypatch.setattr(link, "_shut", lambda: did.append("shut"))
    link._read()
    monkeypatch.undo()

    assert did == ["read", "look after", "read", "shut", "open", "shut", "open", "read", "shut"]
    assert waits.waits == [1.0, 1.0, 1.0]
    assert tries == []
    assert linked.notices == [
        (LinkNotice.LOST, "Connection reset by peer"), (LinkNotice.RESTORED, "player://host:1"),
        (LinkNotice.LOST, "Connection reset by peer"),
    ]  # fmt: skip
    assert link.epoch == 2


def test_data_are_waited_for_until_they_are_newer_or_the_server_is_lost(linked: Linked) -> None:
    link, waits = linked.link, list[tuple[bool, float]]()
    link._changed.wait_for = (  # type: ignore[method-assign]
        lambda is_over, seconds: waits.append((is_over(), seconds))
    )
    for time in (9.0, 9.5):
        linked.receives_wheels(time, *(0.0,) * 6, 0)
        link.wait_for_data(9.0)
    link.is_there = False
    link.wait_for_data(10.0)

    assert waits == [(False, module.POLL), (True, module.POLL), (True, module.POLL)]


@pytest.mark.parametrize("is_lost", [True, False])
def test_what_waits_for_data_is_woken_up_by_them_and_by_the_loss(
    linked: Linked, monkeypatch: pytest.MonkeyPatch, is_lost: bool
) -> None:
    link, begun, states = linked.link, threading.Event(), list[WheelState | None]()
    wheels = link.wheels

    def looked() -> WheelState:
        begun.set()  # under the lock, which the waiting thread leaves only to wait
        return wheels()

    monkeypatch.setattr(link, "wheels", looked)
    monkeypatch.setattr(module, "POLL", None)
    waiting = threading.Thread(target=lambda: states.append(link.wait_for_data(1.0)), daemon=True)
    waiting.start()
    assert begun.wait(TIMEOUT)
    if is_lost:
        link._lose("")
    else:
        linked.receives_wheels(2.0, 3.0, *(0.0,) * 5, 0)
    waiting.join(TIMEOUT)

    assert states == [None if is_lost else WheelState(2.0, 3.0, 0.0, 0.0, False, False)]


def test_data_are_waited_for_a_tenth_of_a_second_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    made, asked = Linked(), list[float]()
    monkeypatch.setattr(module.select, "select", lambda *sockets: asked.append(sockets[3]) or ([],))
    made.link._pump()
    made.link._changed.wait_for = lambda _, seconds: asked.append(seconds)  # type: ignore[method-assign]
    made.link.wait_for_data(0.0)
    made.link._shut()
    made.server.close()

    assert asked == [0.1, 0.1]


def test_a_lost_server_needs_no_listener() -> None:
    link = ServerLink("player://host:1")
    assert not link.is_there
    link.is_there = True
    link._lose("")

    assert (link.epoch, link.is_there) == (1, False)


def test_a_connected_link_reads_in_a_thread_that_keeps_no_program_alive(
    linked: Linked, monkeypatch: pytest.MonkeyPatch
) -> None:
    reading, threads = threading.Event(), list[threading.Thread]()
    monkeypatch.setattr(linked.link, "_open", lambda: None)
    monkeypatch.setattr(
        linked.link, "_read", lambda: (threads.append(threading.current_thread()), reading.set())
    )
    linked.link.connect()

    assert reading.wait(TIMEOUT)
    assert [(each.name, each.daemon) for each in threads] == [("server", True)]


def test_the_reading_thread_ends_with_the_link(linked: Linked) -> None:
    linked.link.give_up()
    linked.link._read()

    assert (linked.link.epoch, linked.notices) == (0, [])


@pytest.mark.parametrize(
    ("problem", "reason"),
    [
        (ConnectionRefusedError(111, "Connection refused"), "Connection refused"),
        (TimeoutError(), ""),
        (ConnectionError("no Player server"), ""),
    ],
)
def test_only_a_reason_of_the_system_is_named(
    linked: Linked, monkeypatch: pytest.MonkeyPatch, problem: OSError, reason: str
) -> None:
    def fail() -> None:
        raise problem

    monkeypatch.setattr(linked.link, "_open", fail)
    with pytest.raises(RobotProblem) as caught:
        linked.link.connect()
    assert (caught.value.code, caught.value.values) == (
        "no-server" if reason else "no-answer",
        {"port": "player://host:1", "reason": reason},
    )
    assert linked.link._socket is None

    linked.link.give_up()
    with pytest.raises(RobotProblem) as caught:
        linked.link.connect()
    assert caught.value.code == "given-up"


# --- connecting


class Server:
    """Answers requests at once, at the other end of a socket that stands in for a connection."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, offered: list[tuple[int, int]] | None) -> None:
        self.got: list[Sent] = []
        self.asked: list[tuple[Any, float]] = []
        self.refused: set[tuple[int, int]] = set()
        self.data = [PlayerMessage(4, 0, DATA, 1, body_of(4, DATA, 1, 1.0, *(0.0,) * 5, 0), 2.0)]
        self.banner = banner("3")
        self._offered, self._reader = offered, MessageReader(10**6)
        monkeypatch.setattr(module.socket, "create_connection", self._connect)
        monkeypatch.setattr(ServerLink, "_pump", self._pumped(ServerLink._pump))

    def _connect(self, address: Any, timeout: float) -> socket.socket:
        self.asked.append((address, timeout))
        self._end, other = socket.socketpair()
        made = _Plain(other)
        self._end.sendall(self.banner)
        return made

    def _pumped(self, pump: Any) -> Any:
        def pumped(link: ServerLink, limit: float = inf) -> None:
            self._answer()
            pump(link, limit)

        return pumped

    def _answer(self) -> None:
        self._end.setblocking(False)
        try:
            data = self._end.recv(1 << 16)
        except BlockingIOError:
            return
        for message in self._reader.feed(data):
            self.got.append((*_kind(message), values_of(message)))
            self._end.sendall(b"".join(each.encoded() for each in self._replies(message)))

    def _replies(self, message: PlayerMessage) -> Iterator[PlayerMessage]:
        interface, index, _, subtype = _kind(message)
        ack, values = MessageType.ACK, values_of(message) or ()
        if (interface, subtype) == (1, 1) and self._offered is not None:
            yield PlayerMessage(1, 0, ack, 1, body_of(1, ack, 1, [(0, 0, *each) for each in self._offered]))
        elif (interface, subtype) == (1, 3) and values[2:4] not in self.refused:
            yield PlayerMessage(1, 0, ack, 3, body_of(1, ack, 3, 0, 0, *values[2:4], 1, "x"))
            yield from (each for each in self.data if (each.interface, each.index) == values[2:4])
        elif (interface, index, subtype) == (10, 0, 2):
            yield PlayerMessage(10, 0, ack, 2, body_of(10, ack, 2, 0.0, 4.0, 1.0))
        elif (interface, subtype) == (1, 10):
            yield PlayerMessage(1, 0, ack, 10)
        else:
            yield PlayerMessage(interface, index, MessageType.NACK, subtype)


class _Plain:
    """A socket of a pair, which has no options of TCP."""

    def __init__(self, made: socket.socket) -> None:
        self._made = made
        self.options: list[tuple[int, int, int]] = []

    def setsockopt(self, *option: int) -> None:
        self.options.append(option)  # type: ignore[arg-type]

    def __getattr__(self, name: str) -> Any:
        return getattr(self._made, name)


def _kind(message: PlayerMessage) -> tuple[int, int, int, int]:
    return message.interface, message.index, message.type, message.subtype


def opened(link: ServerLink, monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.setattr(module, "SETTLING", 0.0)
    link._open()
    return link._socket


PARTS = {
    (4, 0): (), (4, 1): (), (62, 0): (1, 5), (62, 1): (1, 5), (14, 0): (1,), (7, 0): (), (10, 0): (2,),
    (3, 0): (), (12, 0): (), (20, 0): (), (20, 1): (),
}  # fmt: skip
"""The devices that a robot has, and the requests for their shapes, in the order in which they are opened."""


def test_a_link_asks_for_the_newest_data_opens_what_it_knows_and_asks_for_shapes(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    server = Server(monkeypatch, [(20, 2), *reversed(PARTS), (99, 0)])
    server.refused = {(12, 0)}
    link = ServerLink("player://host:1234")
    link._data[3, 0, 1] = (1.0, (2, 0, 0))  # of before
    link._reader.feed(banner("3"))  # half a message of before
    connected = opened(link, monkeypatch)

    assert server.asked == [(("host", 1234), 2.0)]
    assert connected.options == [(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)]
    assert server.got[:2] == [(1, 0, REQUEST, 10, (-1, -1, DATA, -1, 1)), (1, 0, REQUEST, 1, ())]
    assert server.got[2:] == [
        message
        for key, shapes in PARTS.items()
        for message in (
            (1, 0, REQUEST, 3, (0, 0, *key, Access.OPEN, "")),
            *((*key, REQUEST, each, ()) for each in shapes),
        )
    ]
    assert link.shapes.keys() == {*RobotPart} - {RobotPart.SPEECH}
    assert link.shapes[RobotPart.SONARS] == {1: (), 5: ()}
    assert link.shapes[RobotPart.MARKS] == {2: (0.0, 4.0, 1.0)}
    assert (link.is_there, link.wheels().x, link.wheels().time) == (True, 1.0, 2.0)
    assert link.values(RobotPart.GRIPPER) == ()
    link._shut()

    server._offered = [(4, 0)]
    opened(link, monkeypatch)
    assert link.shapes == {RobotPart.WHEELS: {}}
    link._shut()


def test_another_robot_of_a_port_has_only_the_parts_that_have_its_index(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The device 4:2 is no head of the robot 1, and the ranger 62:2 no sonar on it."""
    server = Server(monkeypatch, [(4, 0), (4, 1), (4, 2), (62, 0), (62, 1), (62, 2)])
    server.data = [PlayerMessage(4, 1, DATA, 1, body_of(4, DATA, 1, 3.0, *(0.0,) * 5, 0), 2.0)]
    link = ServerLink("player://host:1234/1")
    opened(link, monkeypatch)

    assert set(link.shapes) == {RobotPart.WHEELS, RobotPart.SONARS}
    assert link.wheels().x == 3.0
    link._shut()


def test_the_data_of_what_was_opened_are_waited_for_but_not_those_of_silent_devices(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The fiducial finder, the speech and the belt are not read."""
    server = Server(monkeypatch, [(4, 0), (62, 0), (10, 0), (12, 0), (20, 0), (20, 1)])
    server.data.append(PlayerMessage(62, 0, DATA, 1, body_of(62, DATA, 1, [1.0]), 2.0))
    link, now = ServerLink("player://host:1"), [100.0]
    monkeypatch.setattr(module, "monotonic", lambda: now[0])
    link._open()
    assert link.values(RobotPart.SONARS) == ((1.0,),)
    assert now == [100.0]
    link._shut()

    server.data.pop()
    pumped = ServerLink._pump

    def later(link: ServerLink, limit: float = inf) -> None:
        now[0] += 0.25
        pumped(link, limit)

    monkeypatch.setattr(ServerLink, "_pump", later)
    monkeypatch.setattr(module, "POLL", 0.0)
    link._factor = 2.0
    took = []
    for has_come in (True, False):
        if has_come:
            server.data.append(PlayerMessage(62, 0, DATA, 1, body_of(62, DATA, 1, [1.0]), 2.0))
        began = now[0]
        link._open()
        took.append(now[0] - began)
        assert (link.is_there, bool(link.values(RobotPart.SONARS))) == (True, has_come)
        link._shut()
        server.data = server.data[:1]
    assert took[1] - took[0] == 2.0  # a second, where timeouts are twice as long


def test_the_first_place_of_the_wheels_is_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    """Five seconds at most; a server that lists nothing has no wheels."""
    server = Server(monkeypatch, [(4, 0)])
    (late,), server.data = server.data, []
    pumps, pumped = list[float](), ServerLink._pump

    def pump(link: ServerLink, limit: float = inf) -> None:
        if link.shapes:
            pumps.append(limit)
        if len(pumps) == 3:
            server._end.sendall(late.encoded())
        pumped(link, limit)

    monkeypatch.setattr(ServerLink, "_pump", pump)
    monkeypatch.setattr(module, "monotonic", lambda: 100.0)
    monkeypatch.setattr(module, "POLL", 0.0)
    monkeypatch.setattr(module, "SETTLING", 0.0)
    link = ServerLink("player://host:1")
    link._factor = 2.0
    link._open()
    assert pumps == [110.0] * 3
    assert link.wheels().x == 1.0
    link._shut()


@pytest.mark.parametrize("offered", [[(4, 1), (62, 0)], [], None])
def test_a_port_without_wheels_is_left(
    monkeypatch: pytest.MonkeyPatch, offered: list[tuple[int, int]] | None
) -> None:
    """None: it refuses to say what it has."""
    Server(monkeypatch, offered)
    link = ServerLink("player://host:1")
    with pytest.raises(RobotProblem) as caught:
        link._open()

    assert (caught.value.code, caught.value.values) == ("no-wheels", {"port": "player://host:1"})
    assert (link._socket, link.is_there) == (None, False)


@pytest.mark.parametrize("said", [b"Flayer v.3".ljust(32, b"\0"), b" Player".ljust(32, b"\0")])
def test_only_what_says_that_it_is_player_is_a_server(monkeypatch: pytest.MonkeyPatch, said: bytes) -> None:
    Server(monkeypatch, [(4, 0)]).banner = said
    with pytest.raises(ConnectionError, match="no Player server"):
        ServerLink("player://host:1")._open()


def test_an_answer_may_take_five_seconds(monkeypatch: pytest.MonkeyPatch) -> None:
    """Twice as long with twice the timeouts."""
    for factor, seconds in ((1.0, 5.0), (2.0, 10.0)):
        made = Linked()
        now, waited = [100.0], [0.0]

        def later(limit: float, now: list[float] = now, waited: list[float] = waited) -> None:
            waited[0] = limit - now[0]
            raise TimeoutError

        monkeypatch.setattr(module, "monotonic", lambda now=now: now[0])
        monkeypatch.setattr(made.link, "_pump", later)
        made.link._factor = factor
        made.link._replies[4, 0, 1] = ("of before",)
        with pytest.raises(TimeoutError):
            made.link._ask((4, 0), 1)
        assert waited == [seconds]
        made.link._shut()
        made.server.close()
