"""Every recorded session again: the same replies of the same sizes in the same order, with our own data."""

from collections import defaultdict
from collections.abc import Iterable
from pathlib import Path

import pytest

from devices.player.codec import (
    LONGEST_REPLY,
    Interface,
    MessageReader,
    MessageType,
    PlayerMessage,
    TooLong,
    values_of,
)
from devices.player.connection import ClientConnection
from donnie_tui.player.server import PortStation, Stations
from tests.player.recordings import NAMES, Side, sides
from tests.player.room import DONNIE_CONFIGURATION, DONNIE_WORLD, stations_of, write_room
from worlds import PLAYER

Reply = tuple[int, int, int, int, int]
"""Interface, index, type, subtype, and the size of the body."""

VARYING = {Interface.BLOBFINDER: (16, 40), Interface.FIDUCIAL: (8, 100)}
"""Bytes of a datum without anything seen, and of each thing seen."""
UNANSWERED = {
    ("garbage", Interface.POSITION2D, 1): "the real server is silent: no client has opened the device",
    ("garbage", Interface.RANGER, 1): "the same",
}
"""Requests that get no reply in the recording, and a refusal or an answer here."""
MOST_TICKS = 20


class Replayed:
    """A client of which only the bytes are left."""

    def __init__(self, stations: Stations, station: PortStation) -> None:
        self._stations = stations
        self._connection = ClientConnection(station, "3.1.1")
        station.clients.add(self._connection)
        self._reader = MessageReader(LONGEST_REPLY)
        banner = self._connection.take()
        assert len(banner) == 32
        self.got: list[PlayerMessage] = []

    def send(self, message: PlayerMessage) -> None:
        self._stations.step()  # in PULL its data come with the reply
        self._connection.receive(message.encoded())
        self._take()
        if (message.interface, message.type, message.subtype) == (Interface.PLAYER, MessageType.REQUEST, 4):
            for _ in range(MOST_TICKS):
                if self.got[-1].type == MessageType.SYNCH:
                    return
                self.tick()
            raise AssertionError("the round has no end")

    def tick(self) -> None:
        self._stations.step()
        self._take()

    def _take(self) -> None:
        self.got.extend(self._reader.feed(self._connection.take()))


def replies(messages: Iterable[PlayerMessage]) -> list[Reply]:
    return [
        (each.interface, each.index, each.type, each.subtype, len(each.body))
        for each in messages
        if each.type != MessageType.DATA
    ]


def data_sizes(messages: Iterable[PlayerMessage]) -> dict[tuple[int, int, int], set[int]]:
    sizes: dict[tuple[int, int, int], set[int]] = defaultdict(set)
    for each in messages:
        if each.type == MessageType.DATA:
            empty, one = VARYING.get(Interface(each.interface), (len(each.body), 0))
            assert (len(each.body) - empty) % one == 0 if one else True
            sizes[each.interface, each.index, each.subtype].add(empty)
    return sizes


def made_for(name: str, shared: Path, folder: Path) -> tuple[Stations, int]:
    """The devices of a session, and its port."""
    if name == "stage-simple":
        stations = stations_of(shared / "stage" / "worlds" / "simple.cfg")
        return stations, 6665
    if name == "godonnie":
        return stations_of(write_room(folder, DONNIE_CONFIGURATION, DONNIE_WORLD)), 6691
    return stations_of(write_room(folder)), 7666 if name == "two-ports" else 7665


def replayed(sent: Side, stations: Stations, station: PortStation) -> Replayed:
    client = Replayed(stations, station)
    for message in sent.messages():
        client.send(message)
    client.tick()
    return client


@pytest.mark.parametrize("name", NAMES)
def test_a_recorded_client_gets_the_replies_that_it_got(name: str, shared: Path, tmp_path: Path) -> None:
    stations, port = made_for(name, shared, tmp_path)
    recorded = {(each.connection, each.sender): each for each in sides(shared, name)}
    connections = sorted({number for number, _ in recorded})
    compared = 0
    for number in connections:
        sent, received = recorded[number, "client"], recorded[number, "server"].messages()
        client = replayed(sent, stations, stations.by_port[port])
        ours = [each for each in replies(client.got) if (name, each[0], each[3]) not in UNANSWERED]
        theirs = replies(received)
        assert ours[: len(theirs)] == theirs
        # the last round may have been asked for when the client left
        assert {each[2:4] for each in ours[len(theirs) :]} <= {(4, 4), (5, 1)}
        compared += len(theirs)
        real = data_sizes(received)
        assert {key: sizes for key, sizes in data_sizes(client.got).items() if key in real} == real
    assert compared


def test_every_byte_of_rubbish_that_was_recorded_leaves_other_clients_alone(
    shared: Path, tmp_path: Path
) -> None:
    stations, port = made_for("garbage", shared, tmp_path)
    other = Replayed(stations, stations.by_port[port])
    other.send(PlayerMessage(1, 0, 3, 3, bytes.fromhex("00" * 11 + "04" + "00" * 7 + "01" + "00" * 8)))
    before = len(other.got)
    for side in sides(shared, "garbage"):
        if side.sender == "client":
            connection = ClientConnection(stations.by_port[port], "3.1.1")
            try:
                connection.receive(side.data)
            except TooLong:
                connection.close()
    other.tick()

    assert [each.interface for each in other.got[before:]] == [Interface.POSITION2D]


def test_donnie_player_has_all_that_the_original_client_opens_and_the_reading_that_it_looks_for(
    shared: Path,
) -> None:
    """The recorded client found no belt; here it does. It reads ranger:0[6], which no world has."""
    stations = stations_of(Path(PLAYER))
    client = Replayed(stations, stations.by_port[6665])
    for side in sides(shared, "godonnie"):
        if side.sender == "client":
            for message in side.messages():
                client.send(message)
    opened = [each.type for each in client.got if (each.interface, each.subtype, each.type) == (1, 3, 4)]
    ranges = [each for each in client.got if (each.interface, each.index, each.subtype) == (62, 0, 1)]

    assert len(opened) >= 6
    assert not any(each.type == MessageType.NACK for each in client.got if each.subtype == 3)
    assert {len(values_of(each)[0]) for each in ranges if each.type == MessageType.DATA} == {7}


def test_the_sensors_of_a_ranger_have_the_poses_and_sizes_of_the_real_server(shared: Path) -> None:
    """Of Stage's own example, as its recorded server sent them: 16 sonars, and a laser."""
    stations = stations_of(shared / "stage" / "worlds" / "simple.cfg")
    client = Replayed(stations, stations.by_port[6665])
    for index in (0, 1):
        client.send(PlayerMessage(62, index, MessageType.REQUEST, 1))
    ours = [values_of(each) for each in client.got if each.type == MessageType.ACK]
    recorded = [
        values_of(each)
        for side in sides(shared, "stage-simple")
        if side.sender == "server"
        for each in side.messages()
        if (each.interface, each.type, each.subtype) == (62, MessageType.ACK, 1)
    ]

    assert len(ours) == len(recorded) == 2
    for mine, theirs in zip(ours, recorded, strict=True):
        for one, other in zip(mine[9], theirs[9], strict=True):
            assert one == pytest.approx(other)
        assert list(mine[10]) == [pytest.approx(each) for each in theirs[10]]
