"""A client of our own, as another process's would be: on a socket, through every interface that is served."""

import socket
import struct
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from devices.player.codec import (
    BANNER_SIZE,
    FORMS,
    MessageReader,
    MessageType,
    PlayerMessage,
    body_of,
    values_of,
)
from devices.ports.robot import Grip
from tests.player.room import CONFIGURATION, HOST, WORLD, ServedRoom
from tests.timeouts import TIMEOUT

MORE = """
driver ( name "soxplayer" provides [ "7665:sound:0" ] )
driver ( name "vib_belt" provides [ "7665:speech:1" "7665:dio:1" ] )
driver ( name "board" port "/dev/ttyACM0" provides [ "7665:power:0" ] )
"""
CAN = """
model ( name "can" size [ 0.1 0.1 0.3 ] pose [ -1.7 0 0 0 ] color "gray"
        gripper_return 1 obstacle_return 0 ranger_return -1 )
"""


class LibraryClient:
    """Works as libplayerc: PULL, one request at a time, data kept until they are read."""

    def __init__(self, port: int) -> None:
        self._socket = socket.create_connection((HOST, port), TIMEOUT)
        self.banner = self._socket.recv(65536)
        self._reader = MessageReader(1 << 20)
        self._waiting: list[PlayerMessage] = []
        self.data: dict[tuple[int, int, int], Any] = {}
        assert self.request(1, 0, 5, 2) == ()

    def request(self, interface: int, index: int, subtype: int, *values: object) -> Any:
        """What is in the reply; None for a refusal."""
        self._send(interface, index, MessageType.REQUEST, subtype, *values)
        while True:
            reply = self._next()
            if reply.type in (MessageType.ACK, MessageType.NACK):
                assert (reply.interface, reply.index, reply.subtype) == (interface, index, subtype)
                return None if reply.type == MessageType.NACK else values_of(reply)
            self._keep(reply)

    def open(self, interface: int, index: int = 0) -> str | None:
        """The name of its driver."""
        granted = self.request(1, 0, 3, 0, 0, interface, index, 1, "")
        return None if granted is None else granted[5]

    def command(self, interface: int, index: int, subtype: int, *values: object) -> None:
        self._send(interface, index, MessageType.COMMAND, subtype, *values)

    def read(self) -> None:
        """A round."""
        assert self.request(1, 0, 4) == ()
        while (message := self._next()).type != MessageType.SYNCH:
            self._keep(message)

    def read_until(self, condition: Any) -> None:
        for _ in range(400):
            if condition():
                return
            self.read()
        raise AssertionError("it never came to that")

    def close(self) -> None:
        self._socket.close()

    def _keep(self, message: PlayerMessage) -> None:
        assert message.type == MessageType.DATA
        self.data[message.interface, message.index, message.subtype] = values_of(message)

    def _send(self, interface: int, index: int, type_: int, subtype: int, *values: object) -> None:
        body = body_of(interface, type_, subtype, *values) if FORMS.get((interface, type_, subtype)) else b""
        self._socket.sendall(PlayerMessage(interface, index, type_, subtype, body).encoded())

    def _next(self) -> PlayerMessage:
        while not self._waiting:
            received = self._socket.recv(65536)
            assert received, "the server has closed"
            self._waiting.extend(self._reader.feed(received))
        return self._waiting.pop(0)


@pytest.fixture
def room(tmp_path: Path) -> Iterator[ServedRoom]:
    alone = CONFIGURATION.partition('driver ( name "stage" model "bob"')[0]
    world = WORLD.replace(
        "gripper ( pose [ 0.3 0 0 0 ] size [ 0.1", "gripper ( pose [ 0.3 0 0 0 ] size [ 0.2"
    )
    with closing(ServedRoom(tmp_path, alone + MORE, world + CAN)) as made:
        yield made


def test_a_client_passes_through_every_interface(room: ServedRoom) -> None:
    with closing(LibraryClient(room.port)) as client:
        assert len(client.banner) == BANNER_SIZE
        offered = {(each[2], each[3]) for each in client.request(1, 0, 1)[0]}
        kinds = {interface for interface, _ in offered}
        assert kinds == {31, 4, 62, 14, 7, 10, 12, 3, 66, 20, 2}
        drivers = {key: client.request(1, 0, 2, 0, 0, *key, "")[4] for key in offered}
        opened = {key: client.open(*key) for key in offered}
        assert opened == drivers
        assert client.open(40) is None

        # geometries and configurations
        assert len(client.request(4, 0, 1)) == 9
        assert len(client.request(62, 0, 1)[9]) == 4
        assert client.request(62, 1, 5)[4:] == pytest.approx((8.0, 0.02, 10.0))
        assert len(client.request(14, 0, 1)[0]) == 2
        assert len(client.request(10, 0, 1)) == 11
        assert client.request(3, 0, 1)[12:] == (2, 0)

        # what is measured
        client.read()
        client.read()
        assert len(client.data[62, 1, 1][0]) == len(client.data[62, 1, 3][0]) == 181
        assert client.data[14, 0, 1] == (b"\0\0",)
        assert client.data[7, 0, 1][2][0][1] == 0xFF0000
        assert client.data[10, 0, 1][0][0][0] == 7
        assert client.data[2, 0, 1] == (8, 0.0, 100.0, 0.0, 0.0, 0)

        # what is done: grip the can, drive back with it, turn, and turn the head
        client.command(3, 0, 2)
        client.read_until(lambda: client.data[3, 0, 1][0] == 2)
        client.command(4, 0, 1, -0.5, 0.0, 0.0, 1)
        client.read_until(lambda: client.data[4, 0, 1][0] < -2.4)
        client.command(4, 0, 1, 0.0, 0.0, 0.0, 1)
        client.command(4, 0, 2, -2.5, 0.0, 1.0, 0.0, 0.0, 0.0, 1)
        client.command(4, 1, 2, 0.0, 0.0, -0.5, 0.0, 0.0, 0.0, 1)
        client.read_until(lambda: client.data[4, 0, 1][2] == pytest.approx(1.0, abs=0.01))
        client.read_until(lambda: client.data[4, 1, 1][2] == pytest.approx(-0.5, abs=0.01))
        assert client.request(31, 0, 1, "can", 0.0, 0.0, 0.0)[1] < -2.1
        client.command(20, 1, 1, 11, ord("A"))
        client.command(12, 0, 1, "pronto")
        client.command(12, 1, 1, "P" * 8 + "B")
        client.command(66, 0, 1, b"bump.wav".ljust(64, b"\0"))
        client.read_until(lambda: client.data[20, 1, 1] == (11, ord("A")))

        # the simulation
        assert client.request(31, 0, 2, "redbox", 2.0, 1.0, 0.5) == ()
        assert client.request(31, 0, 3, "redbox", *(0.0,) * 7)[1:3] == pytest.approx((2.0, 1.0))
        red = struct.pack("<ffff", 1, 0, 0, 1)
        assert client.request(31, 0, 5, "redbox", "color", 0, bytes(16))[3] == red
        assert client.request(31, 0, 6, "redbox", "color", 0, struct.pack("<ffff", 0, 1, 0, 1)) == ()

        # and all is closed again
        for key in offered:
            assert client.request(1, 0, 3, 0, 0, *key, 2, "")[4] == 2

    taken = room.notes.taken
    for expected in (("alice", Grip.GRIPPED), ("alice", "pronto"), ("alice", (11, "A")), ("alice", (8, "B"))):
        assert expected in taken
    assert ("alice", "bump") in taken
    assert taken[-1] == ("alice", "left")
