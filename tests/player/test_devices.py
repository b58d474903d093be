"""What clients get of each interface, by messages; expected values are those of the room and of geometry."""

import struct
from collections.abc import Callable
from math import pi, radians
from pathlib import Path
from typing import Any

import pytest

from devices.player.codec import (
    FORMS,
    Interface,
    MessageReader,
    MessageType,
    PlayerMessage,
    body_of,
    values_of,
)
from devices.player.connection import ClientConnection
from devices.ports.drive import BlobReading, ColourBlob, MetricPose
from devices.ports.robot import Grip
from donnie_tui.player.equipment import angle, service_of, towards
from donnie_tui.player.server import ServerProblem, Stations
from tests.player.room import CONFIGURATION, WORLD, Notes, stations_of, write_room

DATA, COMMAND, REQUEST, ACK, NACK = (
    MessageType.DATA,
    MessageType.COMMAND,
    MessageType.REQUEST,
    MessageType.ACK,
    MessageType.NACK,
)


class Client:
    """A client in PULL that has opened these devices."""

    def __init__(self, stations: Stations, *opened: tuple[int, int], port: int = 7665) -> None:
        self._stations, self._station = stations, stations.by_port[port]
        self.connection = ClientConnection(self._station, "1")
        self._station.clients.add(self.connection)
        self.connection.take()
        self._reader = MessageReader(10**6)
        self.ask(1, 0, 5, 2)
        for interface, index in opened:
            assert self.ask(1, 0, 3, 0, 0, interface, index, 1, "") is not None

    def send(self, interface: int, index: int, type_: int, subtype: int, *values: object) -> None:
        form = FORMS.get((interface, type_, subtype))
        body = body_of(interface, type_, subtype, *values) if form else b""
        self.connection.receive(PlayerMessage(interface, index, type_, subtype, body).encoded())

    def ask(self, interface: int, index: int, subtype: int, *values: object) -> Any:
        """What is in the reply; None for a refusal."""
        self.send(interface, index, REQUEST, subtype, *values)
        [reply] = [each for each in self.take() if each.type != DATA]
        assert (reply.interface, reply.index, reply.subtype) == (interface, index, subtype)
        return None if reply.type == NACK else values_of(reply)

    def command(self, interface: int, index: int, subtype: int, *values: object) -> None:
        self.send(interface, index, COMMAND, subtype, *values)

    def take(self) -> list[PlayerMessage]:
        return list(self._reader.feed(self.connection.take()))

    def round(self) -> dict[tuple[int, int, int], Any]:
        """The data of the next tick, by interface, index and subtype."""
        self.take()
        self.send(1, 0, REQUEST, 4)
        self._stations.step()
        messages = self.take()
        assert (messages[0].type, messages[-1].type) == (ACK, MessageType.SYNCH)
        return {(each.interface, each.index, each.subtype): values_of(each) for each in messages[1:-1]}

    def vanish(self) -> None:
        self._station.clients.discard(self.connection)
        self.connection.close()


@pytest.fixture
def notes() -> Notes:
    return Notes()


@pytest.fixture
def stations(tmp_path: Path, notes: Notes) -> Stations:
    return stations_of(write_room(tmp_path), notes)


WHEELS = (Interface.POSITION2D, 0)


def test_a_robot_drives_at_the_velocity_that_it_was_given(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    client.command(*WHEELS, 1, 0.5, 0.0, 0.0, 1)

    first = client.round()[4, 0, 1]

    assert first == pytest.approx((-1.95, 0, 0, 0.5, 0, 0, 0))


def test_a_robot_goes_to_a_pose_and_turns_to_its_heading(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    client.command(*WHEELS, 2, -2.5, 0.5, -1.0, 0.0, 0.0, 0.0, 1)
    speeds = []
    for _ in range(150):
        state = client.round()[4, 0, 1]
        speeds.append((state[3], abs(state[5])))

    assert state[:2] == pytest.approx((-2.5, 0.5), abs=0.03)
    assert state[2] == pytest.approx(-1.0, abs=1e-6)
    assert max(each[0] for each in speeds) <= 0.4 + 1e-9
    assert max(each[1] for each in speeds) <= 1.0 + 1e-9


def test_the_last_client_that_leaves_stops_its_robot(stations: Stations) -> None:
    one, other = Client(stations, WHEELS), Client(stations, WHEELS)
    one.command(*WHEELS, 1, 0.2, 0.0, 0.0, 1)
    one.round()
    one.vanish()
    driving = other.round()[4, 0, 1]
    other.vanish()
    third = Client(stations, WHEELS)
    standing = third.round()[4, 0, 1]

    assert driving[3] == pytest.approx(0.2)
    assert standing[3] == 0.0
    assert standing[0] == pytest.approx(driving[0])


def test_a_robot_is_opened_by_its_first_client_and_left_by_its_last(stations: Stations, notes: Notes) -> None:
    one, other = Client(stations, WHEELS, (4, 1)), Client(stations, WHEELS)
    one.vanish()
    assert notes.taken == [("alice", "opened")]
    other.vanish()
    assert notes.taken == [("alice", "opened"), ("alice", "left")]
    notes.may_open = False
    assert Client(stations).ask(1, 0, 3, 0, 0, *WHEELS, 1, "") is None
    notes.may_open = True
    Client(stations, WHEELS)

    assert notes.taken[2:] == [("alice", "opened")] * 2


@pytest.mark.parametrize("index", [0, 1], ids=["wheels", "head"])
def test_a_velocity_takes_the_place_of_a_goal(stations: Stations, index: int) -> None:
    client = Client(stations, WHEELS, (4, index))
    client.command(4, index, 2, -3.0, 0.0, -3.0, 0.0, 0.0, 0.0, 1)
    client.round()
    client.command(4, index, 1, 0.0, 0.0, 0.2, 1)

    assert rounds(client, 3)[4, index, 1][5] == pytest.approx(0.2)


def test_a_goal_is_forgotten_when_the_last_client_leaves(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    client.command(*WHEELS, 2, -2.5, 0.5, -1.0, 0.0, 0.0, 0.0, 1)
    turning = client.round()[4, 0, 1]
    client.vanish()
    standing = rounds(Client(stations, WHEELS), 3)[4, 0, 1]

    assert turning[5] != 0.0
    assert standing[5] == 0.0
    assert standing[:3] == pytest.approx(turning[:3])


def test_a_command_to_a_robot_that_no_client_has_opened_has_no_effect(stations: Stations) -> None:
    client = Client(stations)
    client.command(*WHEELS, 1, 0.2, 0.0, 0.0, 1)
    opened = Client(stations, WHEELS)

    assert opened.round()[4, 0, 1][3] == 0.0


@pytest.mark.parametrize("number", [float("nan"), float("inf"), 1e308])
def test_numbers_that_no_robot_can_have_move_nothing(stations: Stations, number: float) -> None:
    client = Client(stations, WHEELS, (31, 0))
    client.command(*WHEELS, 1, number, 0.0, 0.0, 1)
    client.command(*WHEELS, 1, 0.0, 0.0, number, 1)
    client.command(*WHEELS, 2, number, 0.0, 0.0, 0.0, 0.0, 0.0, 1)

    assert client.ask(31, 0, 2, "alice", number, 0.0, 0.0) is None
    assert client.round()[4, 0, 1][:2] == pytest.approx((-2.0, 0.0))


def test_robots_of_two_ports_drive_at_once(stations: Stations) -> None:
    alice, bob = Client(stations, WHEELS), Client(stations, WHEELS, port=7666)
    alice.command(*WHEELS, 1, 0.1, 0.0, 0.0, 1)
    bob.command(*WHEELS, 1, 0.2, 0.0, 0.0, 1)

    assert alice.round()[4, 0, 1][0] == pytest.approx(-1.99)
    assert bob.round()[4, 0, 1][0] == pytest.approx(-2 + 0.2 * 0.2)


def test_a_ranger_measures_in_the_order_of_its_sensors(stations: Stations) -> None:
    """The red box is from -0.2 to 0.2, Bob from y = -1.8, the walls of the room at x = -4 and y = 3."""
    client = Client(stations, (62, 0), (62, 1))
    data = client.round()

    assert data[62, 0, 1] == (pytest.approx((1.6, 2.8, 1.6, 1.8), abs=0.03),)
    assert data[62, 0, 3] == ((1.0,) * 4,)
    [laser] = data[62, 1, 1]
    assert len(laser) == 181
    assert laser[90] == pytest.approx(1.8, abs=0.03)
    assert laser[0] == pytest.approx(1.8, abs=0.03)
    assert client.ask(62, 1, 5)[:3] == pytest.approx((-pi / 2, pi / 2, pi / 181))
    assert client.ask(62, 0, 1)[9][1] == pytest.approx((0, 0.2, 0, 0, 0, pi / 2))
    assert client.ask(62, 0, 1)[10] == ((0.02, 0.02, 0.02),) * 4
    assert client.ask(62, 0, 2, 1) is None


def test_a_blobfinder_and_a_mark_finder_see_the_red_box_ahead(stations: Stations) -> None:
    client = Client(stations, (7, 0), (10, 0))
    data = client.round()

    width, height, [blob] = data[7, 0, 1]
    assert (width, height) == (80, 60)
    assert blob[1] == 0xFF0000
    assert blob[5] < 40 < blob[6]
    assert blob[9] == pytest.approx(1.8, abs=0.05)
    [[[number, x, y, *_]]] = data[10, 0, 1]
    assert (number, x, y) == (7, pytest.approx(2.0), pytest.approx(0.0))


@pytest.mark.parametrize(
    "recorded",
    [
        (306, 79, 60, 71, 88, 51, 69, 3.802220344543457),
        (378, 17, 60, 7, 28, 51, 69, 3.6524899005889893),
        (986, 150, 60, 142, 159, 31, 89, 1.127371072769165),
        (6300, 70, 60, 39, 102, 10, 110, 0.6432724595069885),
    ],
)
def test_a_blob_is_as_high_and_as_large_as_the_real_server_has_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, recorded: tuple[float, ...]
) -> None:
    """Area, middle, columns and rows of a picture of 160 by 120 pixels and 60 degrees, and metres."""
    world = WORLD.replace("image [ 80 60 ]", "image [ 160 120 ]")
    stations = stations_of(write_room(tmp_path, world=world))
    left, right, metres = recorded[3], recorded[4], recorded[7]
    degrees_of = [(0.5 - (column + 0.5) / 160) * 60 for column in (left, right)]
    seen = BlobReading("", (ColourBlob((255, 0, 0), degrees_of[0], degrees_of[1], metres),))
    monkeypatch.setattr(stations._loop.drives["alice"], "blobs", lambda _: (seen,))

    _, _, [blob] = Client(stations, (7, 0)).round()[7, 0, 1]

    assert blob[2:] == pytest.approx(recorded)


def test_bumpers_say_where_the_robot_touches_the_box(stations: Stations) -> None:
    client = Client(stations, WHEELS, (14, 0))
    assert client.round()[14, 0, 1] == (b"\0\0",)
    client.ask(31, 0, 2, "alice", -0.43, 0.0, 0.0)

    assert client.round()[14, 0, 1] == (b"\1\1",)
    assert [each[6] for each in client.ask(14, 0, 1)[0]] == pytest.approx([0.2, 0.2])


def test_a_gripper_moves_and_is_closed(stations: Stations) -> None:
    client = Client(stations, (3, 0))
    client.command(3, 0, 2)
    states = [client.round()[3, 0, 1][0] for _ in range(15)]

    assert (states[0], states[-1]) == (3, 2)


def test_a_text_is_said_in_the_robots_name(stations: Stations, notes: Notes) -> None:
    client = Client(stations, (12, 0))
    client.command(12, 0, 1, "Olá,\x1b[2J aí")
    client.command(12, 0, 1, "")
    client.command(12, 0, 1, "a" * 1001)
    client.command(12, 0, 2)  # there is no such command

    assert notes.taken == [("alice", "Olá, [2J aí"), ("alice", "a" * 1000)]


def test_the_simulation_puts_things_elsewhere_and_knows_the_time(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    client.round()

    assert client.ask(31, 0, 2, "redbox", 2.0, 1.0, 0.5) == ()
    assert client.ask(31, 0, 1, "redbox", 0.0, 0.0, 0.0) == ("redbox", 2.0, 1.0, pytest.approx(0.5))
    assert client.ask(31, 0, 1, "alice.head", 0.0, 0.0, 0.0)[1:] == pytest.approx((0, 0, 0))
    assert client.ask(31, 0, 1, "missing", 0.0, 0.0, 0.0) is None
    assert client.ask(31, 0, 2, "room", 0.0, 0.0, 0.0) is None
    assert client.ask(31, 0, 5, "redbox", "color", 0, bytes(16))[3] == struct.pack("<ffff", 1, 0, 0, 1)
    assert client.ask(31, 0, 5, "redbox", "time", 0, bytes(8))[3] == struct.pack("<Q", 100_000)
    assert client.ask(31, 0, 5, "redbox", "time", 0, bytes(4)) is None
    assert client.ask(31, 0, 3, "alice", *(0.0,) * 7)[7] == pytest.approx(1e5)


def test_a_head_turns_to_a_heading_of_the_world(stations: Stations) -> None:
    client = Client(stations, (4, 1))
    client.command(4, 1, 2, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 1)
    for _ in range(8):
        state = client.round()[4, 1, 1]

    assert state[2] == pytest.approx(0.5)


def test_only_what_a_client_has_opened_is_sent_and_computed(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    Client(stations, (62, 0))

    assert set(client.round()) == {(4, 0, 1)}


@pytest.mark.parametrize(
    ("interface", "subtype"), [(4, 3), (4, 77), (7, 1), (14, 9), (99, 1), (40, 1), (12, 1)]
)
def test_what_is_not_known_is_refused_at_once(stations: Stations, interface: int, subtype: int) -> None:
    client = Client(stations)
    client.send(interface, 0, REQUEST, subtype, *((0,) if interface == 4 and subtype == 3 else ()))

    [reply] = client.take()
    assert (reply.type, reply.body) == (NACK, b"")


def test_the_newest_datum_takes_the_place_of_one_that_waits(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    for _ in range(5):
        stations.step()
    client.send(1, 0, REQUEST, 4)

    data = [each for each in client.take() if each.type == DATA]
    assert [each.time for each in data] == [pytest.approx(0.5)]


def test_a_client_that_wants_all_data_gets_no_more_than_are_kept(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    client.ask(1, 0, 10, -1, -1, -1, -1, 0)
    for _ in range(1024 + 100):
        stations.step()
    client.send(1, 0, REQUEST, 4)

    data = [each for each in client.take() if each.type == DATA]
    assert 1024 <= len(data) <= 1024 + 1


def test_rules_are_looked_at_in_their_order_and_an_equal_one_is_changed(stations: Stations) -> None:
    client = Client(stations, WHEELS, (62, 0))
    client.ask(1, 0, 10, 62, -1, 1, -1, 2)
    client.ask(1, 0, 10, -1, -1, -1, -1, 1)
    ignored = set(client.round())
    client.ask(1, 0, 10, 62, -1, 1, -1, 1)

    assert ignored == {(4, 0, 1)}
    assert set(client.round()) == {(4, 0, 1), (62, 0, 1), (62, 0, 3)}


def test_a_client_that_only_asks_is_read_no_further(stations: Stations) -> None:
    client = Client(stations)
    for _ in range(256):
        assert not client.connection.is_behind
        client.send(1, 0, REQUEST, 1)

    assert client.connection.is_behind
    assert len(client.take()) == 256
    assert not client.connection.is_behind


@pytest.mark.parametrize(
    ("change", "code", "values"),
    [
        (
            lambda text: text.replace("ranger:1", "ranger:0"),
            "player-address-twice",
            {"what": "7665:ranger:0"},
        ),
        (
            lambda text: text.replace('model "bob"', 'model "joe"'),
            "player-unknown-model",
            {"name": "joe", "what": "position2d:0", "names": "alice, bob"},
        ),
    ],
)
def test_a_configuration_that_does_not_fit_its_world_is_refused(
    tmp_path: Path, change: Callable[[str], str], code: str, values: dict[str, str]
) -> None:
    with pytest.raises(ServerProblem) as refused:
        stations_of(write_room(tmp_path, change(CONFIGURATION)))
    assert (refused.value.code, refused.value.values) == (code, values)


def test_the_default_port_is_that_of_addresses_without_one(tmp_path: Path) -> None:
    text = """
    driver ( name "stage" plugin "stageplugin" provides [ "simulation:0" ] worldfile "room.world" )
    driver ( name "stage" model "alice" provides [ "base:::position2d:0" "6665:ranger:0" "::bumper:0" ] )
    """
    stations = stations_of(write_room(tmp_path, text), port=7000)

    assert {port: list(each.devices) for port, each in stations.by_port.items()} == {
        7000: [(31, 0), (4, 0), (14, 0)],
        6665: [(62, 0)],
    }


def test_devices_that_are_not_offered_are_left_out(tmp_path: Path) -> None:
    more = CONFIGURATION + 'driver ( name "rangertolaser" provides [ "7665:laser:0" ] )'
    stations = stations_of(write_room(tmp_path, more.replace('"7665:gripper:0"', '"7665:camera:0"')))

    assert stations.left_out == ["camera:0", "laser:0"]


def test_angles_are_above_minus_pi_and_up_to_pi() -> None:
    assert [angle(each) for each in (0, 180, -180, 190, 540)] == pytest.approx([0, pi, pi, pi / 18 - pi, pi])


def test_a_robot_within_two_centimetres_only_turns() -> None:
    assert towards(MetricPose(0.01, 0.01, 90), MetricPose()).ahead == 0.0


@pytest.mark.parametrize(
    ("x", "y", "yaw", "ahead", "turn"),
    [
        *(
            (1, 0, 0, 0.4, 0),
            (0.03, 0, 0, 0.3, 0),
            (0.02, 0.02, 3, 0, -30),
            (-0.02, -0.02, -134, 0, 180 / pi),
        ),
        *((1, 0, 4.9, 0.4, -49), (1, 0, -4.9, 0.4, 49), (1, 0, 5.1, 0, -51), (1, 0, -90, 0, 180 / pi)),
        *((0, 1, 0, 0, 180 / pi), (0, -1, 0, 0, -180 / pi), (0.01, 0.01, 170, 0, -180 / pi)),
    ],
)
def test_a_robot_turns_to_its_goal_and_then_drives(
    x: float, y: float, yaw: float, ahead: float, turn: float
) -> None:
    """In a tenth of a second; at most 0.4 metres and one radian a second."""
    found = towards(MetricPose(x, y, 0), MetricPose(0, 0, yaw))

    assert (found.ahead, found.left, found.turn) == pytest.approx((ahead, 0, turn))


HEADED = """
define sonar sensor ( range [ 0 6 ] fov 1 )
model ( name "wall" size [ 0.2 8 1 ] pose [ 3.1 0 0 0 ] )
model ( name "left" size [ 8 0.2 1 ] pose [ 0 2.1 0 0 ] ranger_return 0.5 color "blue" )
model ( name "can" size [ 0.15 0.1 0.3 ] pose [ 0.3 0 0 0 ]
        gripper_return 1 obstacle_return 0 ranger_return -1 )
position
(
  name "alice" size [ 0.3 0.3 0.3 ] fiducial_return 3
  ranger ( sonar( pose [ 0 0 0 0 ] ) sonar( pose [ 0 0 0 -45 ] ) sonar( pose [ 0 0 0 45 ] )
           sonar( pose [ 0 0 0 180 ] ) sonar( pose [ 0 0 0 -135 ] ) sonar( pose [ 0 0 0 135 ] ) )
  position ( name "head" size [ 0.1 0.1 0.1 ] ranger ( sonar() )
             blobfinder ( range 5 fov 60 image [ 80 60 ] colors_count 1 colors [ "green" ] ) )
  fiducial ( range_max 8 range_max_id 5 fov 180 )
  gripper ( pose [ 0.3 0 0 0 ] size [ 0.2 0.2 0.2 ] )
)
"""
HEADED_CONFIGURATION = """
driver ( name "stage" plugin "stageplugin" provides [ "7665:simulation:0" ] worldfile "room.world" )
driver ( name "stage" model "alice" provides [ "7665:position2d:0" "7665:ranger:0" "7665:position2d:1"
  "7665:ranger:1" "7665:gripper:0" "7665:blobfinder:0" "7665:fiducial:0" ] )
"""


@pytest.fixture
def headed(tmp_path: Path) -> Stations:
    return stations_of(write_room(tmp_path, HEADED_CONFIGURATION, HEADED))


def rounds(client: Client, count: int) -> dict[tuple[int, int, int], Any]:
    return [client.round() for _ in range(count)][-1]


def test_what_is_mounted_on_a_head_turns_with_it(headed: Stations) -> None:
    """The wall is 3 m ahead, another one 2 m to the left."""
    client = Client(headed, (4, 1), (62, 1), (62, 0))
    before = client.round()
    client.command(4, 1, 2, 0.0, 0.0, pi / 2, 0.0, 0.0, 0.0, 1)
    after = rounds(client, 20)

    assert (before[62, 1, 1][0], after[62, 1, 1][0]) == (
        pytest.approx([3.0], abs=0.01),
        pytest.approx([2.0], abs=0.01),
    )
    assert before[62, 0, 1][0][:6] == pytest.approx(after[62, 0, 1][0][:6])


def test_the_sonars_of_donnie_come_in_the_originals_order_with_the_heads_as_the_seventh(
    headed: Stations,
) -> None:
    """Right ahead, ahead, left ahead, left behind, behind, right behind; 6 m is as far as they reach."""
    [ranges] = Client(headed, (62, 0)).round()[62, 0, 1]

    assert ranges == pytest.approx([3 * 2**0.5, 3, 2 * 2**0.5, 2 * 2**0.5, 6, 6, 3], abs=0.05)
    poses = Client(headed).ask(62, 0, 1)[9]
    assert [each[5] for each in poses] == pytest.approx([-pi / 4, 0, pi / 4, 3 * pi / 4, pi, -3 * pi / 4])


def test_intensities_are_what_the_world_gives(headed: Stations) -> None:
    [seen] = Client(headed, (62, 0)).round()[62, 0, 3]

    assert seen == (1.0, 1.0, 0.5, 0.5, 0.0, 0.0, 1.0)


def test_a_gripper_carries_what_it_has_closed_on(headed: Stations) -> None:
    client = Client(headed, WHEELS, (3, 0))
    assert client.round()[3, 0, 1] == (1, 1 << 3, 0)
    client.command(3, 0, 2)
    assert rounds(client, 12)[3, 0, 1] == (2, 1 << 2 | 1 << 3, 0)
    client.command(*WHEELS, 1, -0.5, 0.0, 0.0, 1)
    rounds(client, 10)
    carried = client.ask(31, 0, 1, "can", 0.0, 0.0, 0.0)[1:3]
    client.command(3, 0, 1)
    left = rounds(client, 12)[3, 0, 1]

    assert carried == pytest.approx((-0.2, 0.0))
    assert client.ask(31, 0, 1, "can", 0.0, 0.0, 0.0)[1:3] == pytest.approx((-0.2, 0.0))
    assert left == (1, 0, 0)


def test_a_finder_sets_the_mark_that_its_own_robot_shows(stations: Stations) -> None:
    client = Client(stations)

    assert client.ask(10, 0, 8, 42) == (42,)
    assert client.ask(10, 0, 7) == (42,)


def test_a_colour_that_was_set_is_seen(headed: Stations) -> None:
    client = Client(headed, (7, 0))
    before = client.round()[7, 0, 1]
    assert client.ask(31, 0, 6, "wall", "color", 0, struct.pack("<ffff", 0, 1, 0, 1)) == ()

    [blob] = client.round()[7, 0, 1][2]
    assert before == (80, 60, ())
    assert blob[1] == 0x00FF00
    assert client.ask(31, 0, 5, "wall", "color", 0, bytes(16))[3] == struct.pack("<ffff", 0, 1, 0, 1)


@pytest.mark.parametrize(
    ("name", "what", "value"),
    [
        ("missing", "color", bytes(16)),
        ("wall", "color", bytes(12)),
        ("wall", "color", struct.pack("<ffff", 2, 0, 0, 1)),
        ("wall", "colour", bytes(16)),
        ("wall", "time", bytes(8)),
    ],
)
def test_a_property_that_cannot_be_set_is_refused(
    headed: Stations, name: str, what: str, value: bytes
) -> None:
    assert Client(headed).ask(31, 0, 6, name, what, 0, value) is None


def test_the_simulation_is_paused_and_resumed(headed: Stations) -> None:
    client = Client(headed, WHEELS, (31, 0))
    client.command(*WHEELS, 1, 0.5, 0.0, 0.0, 1)
    client.command(31, 0, 1)
    paused = rounds(client, 5)[4, 0, 1][0]
    client.command(31, 0, 1)

    assert paused == 0.0
    assert rounds(client, 5)[4, 0, 1][0] == pytest.approx(0.25)


def test_the_simulation_is_reset(stations: Stations) -> None:
    client = Client(stations, WHEELS, (31, 0))
    client.ask(31, 0, 2, "redbox", 2.0, 1.0, 0.5)
    client.ask(31, 0, 2, "alice", 1.0, 1.0, 0.0)
    client.command(31, 0, 3)  # saving has no effect
    assert client.round()[4, 0, 1][:2] == pytest.approx((1, 1))
    client.command(31, 0, 2)

    assert client.round()[4, 0, 1][:2] == pytest.approx((-2, 0))
    assert client.ask(31, 0, 1, "redbox", 0.0, 0.0, 0.0)[1:] == pytest.approx((0, 0, 0))


# --- geometries and limits


@pytest.mark.parametrize(
    ("device", "place"),
    [
        ((4, 0), (0, 0, 0, 0, 0, 0, 0.4, 0.4, 0.3)),
        ((4, 1), (0.1, -0.05, 0.2, 0, 0, pi / 6, 0.2, 0.1, 0.3)),
        ((3, 0), (0.3, 0, 0, 0, 0, 0, 0.2, 0.1, 0.25, 0.2, 0.1, 0.25, 2, 0)),
        ((10, 0), (0, 0, 0, 0, 0, 0, 0, 0, 0, 0.1, 0.1)),
        ((62, 0), (0, 0, 0, 0, 0, 0, 0.15, 0.15, 0.2)),
    ],
)
def test_a_device_says_where_it_is_on_its_robot_and_how_wide_long_and_high(
    tmp_path: Path, device: tuple[int, int], place: tuple[float, ...]
) -> None:
    """The robot is 0.3 m high, and its head 0.2 m above it. Stage's rangers have a size, its finders none."""
    world = WORLD.replace(
        'name "head" size [ 0.1 0.1 0.1 ] pose [ 0 0 0 0 ]',
        'name "head" size [ 0.1 0.2 0.3 ] pose [ 0.1 -0.05 0.2 30 ]',
    ).replace("size [ 0.1 0.2 0.2 ]", "size [ 0.1 0.2 0.25 ]")
    client = Client(stations_of(write_room(tmp_path, world=world)))

    assert client.ask(*device, 1)[: len(place)] == pytest.approx(place)


BY_ODOMETRY = WORLD.replace(
    'name "alice"', 'name "alice" localization "odom" localization_origin [ 0 0 0 0 ]'
)


@pytest.mark.parametrize(("metres", "reply"), [(1e6, ()), (-1e6, ()), (1e6 + 1, None), (-1e6 - 1, None)])
def test_the_odometry_is_set_within_a_thousand_kilometres(
    tmp_path: Path, metres: float, reply: tuple[()] | None
) -> None:
    client = Client(stations_of(write_room(tmp_path, world=BY_ODOMETRY)), WHEELS)
    assert client.ask(*WHEELS, 5, metres, 0.0, 0.5) == reply
    x, _, yaw = client.round()[4, 0, 1][:3]
    assert (x, yaw) == pytest.approx((0.0, 0.0) if reply is None else (metres, 0.5))

    assert client.ask(*WHEELS, 6) == ()
    assert client.round()[4, 0, 1][:3] == (0.0, 0.0, 0.0)


def test_a_robot_as_a_car_drives_and_turns(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    client.command(*WHEELS, 3, 0.2, -0.5)

    assert rounds(client, 2)[4, 0, 1][3:6] == pytest.approx((0.2, 0.0, -0.5))


@pytest.mark.parametrize("index", [0, 1], ids=["wheels", "head"])
def test_modes_and_motor_power_are_granted_and_change_nothing(stations: Stations, index: int) -> None:
    client = Client(stations, WHEELS, (4, index))
    client.command(4, index, 1, 0.0, 0.0, 0.2, 1)
    client.command(4, index, 4, 0.3, 0.3)  # to a heading, which Stage doesn't know

    assert [client.ask(4, index, each, 1) for each in (2, 3, 4)] == [(), None, ()]
    assert [client.ask(4, index, 5, 0.0, 0.0, 0.0), client.ask(4, index, 6)] == [(), ()]
    assert client.round()[4, index, 1][3:6] == pytest.approx((0.0, 0.0, 0.2))


def test_a_gripper_takes_a_second_and_reports_what_it_has_done(tmp_path: Path, notes: Notes) -> None:
    stations = stations_of(write_room(tmp_path, HEADED_CONFIGURATION, HEADED), notes)
    client = Client(stations, (3, 0), (31, 0))
    client.command(3, 0, 1)  # it is open
    client.command(3, 0, 3)
    assert client.round()[3, 0, 1][0] == 1
    client.command(3, 0, 2)
    client.command(31, 0, 1)
    assert client.round()[3, 0, 1][0] == 3
    client.command(31, 0, 1)
    assert client.round()[3, 0, 1][0] == 3
    assert notes.taken == []
    assert [client.round()[3, 0, 1][0] for _ in range(10)] == [3] * 8 + [2] * 2
    assert notes.taken == [("alice", Grip.GRIPPED)]
    for subtype in (2, 1):
        client.command(3, 0, subtype)
    assert [client.round()[3, 0, 1][0] for _ in range(11)] == [3] * 9 + [1] * 2
    assert notes.taken == [("alice", Grip.GRIPPED), ("alice", Grip.RELEASED)]


def test_a_gripper_that_has_closed_on_nothing_reports_nothing(stations: Stations, notes: Notes) -> None:
    client = Client(stations, (3, 0))
    for subtype in (2, 1):
        client.command(3, 0, subtype)
        rounds(client, 11)

    assert notes.taken == []


@pytest.mark.parametrize(("rate", "turned"), [(0.5, 0.5), (3.0, 1.0), (-3.0, -1.0)])
def test_a_head_turns_by_one_radian_a_second_at_most_until_the_last_client_leaves(
    stations: Stations, rate: float, turned: float
) -> None:
    client, other = Client(stations, (4, 1)), Client(stations, (4, 1))
    client.command(4, 1, 1, 0.0, 0.0, rate, 1)
    assert rounds(client, 10)[4, 1, 1][2:6] == pytest.approx((turned, 0.0, 0.0, turned))
    client.vanish()
    assert other.round()[4, 1, 1][2] == pytest.approx(1.1 * turned)
    other.vanish()

    assert rounds(Client(stations, (4, 1)), 3)[4, 1, 1][2:6] == pytest.approx((1.1 * turned, 0.0, 0.0, 0.0))


def test_a_head_stands_until_it_is_turned_and_while_its_robot_is_held(stations: Stations) -> None:
    client = Client(stations, (4, 1), (31, 0))
    assert client.round()[4, 1, 1] == (-2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0)
    client.command(4, 1, 1, 0.0, 0.0, 0.5, 1)
    client.command(31, 0, 1)
    assert client.round()[4, 1, 1][2] == 0.0
    client.command(31, 0, 1)
    stations._loop.drives["alice"].is_held = True
    assert client.round()[4, 1, 1][2] == 0.0
    stations._loop.drives["alice"].is_held = False
    assert client.round()[4, 1, 1] == pytest.approx((-2.0, 0.0, 0.05, 0.0, 0.0, 0.5, 0))


def test_a_gripper_whose_paddles_are_closed_in_its_world_begins_closed(tmp_path: Path) -> None:
    world = WORLD.replace("gripper ( pose", 'gripper ( paddle_state [ "closed" "up" ] pose')

    assert Client(stations_of(write_room(tmp_path, world=world)), (3, 0)).round()[3, 0, 1][0] == 2


def test_of_several_sensors_each_gives_its_middle_sample(tmp_path: Path) -> None:
    """The world's resolution is that of its rangers."""
    world = "resolution 0.05\n" + WORLD.replace("range [ 0 5 ] fov 10 )", "range [ 0 5 ] fov 10 samples 5 )")
    client = Client(stations_of(write_room(tmp_path, world=world)), (62, 0))

    assert client.round()[62, 0, 1] == (pytest.approx((1.6, 2.8, 1.6, 1.8), abs=0.1),)
    assert client.ask(62, 0, 5) == pytest.approx(
        (-radians(5), radians(5), radians(10) / 5, 0.0, 5.0, 0.05, 10.0)
    )


def test_a_head_is_where_its_robot_is(tmp_path: Path) -> None:
    client = Client(stations_of(write_room(tmp_path, world=BY_ODOMETRY)), WHEELS, (4, 1))
    client.ask(*WHEELS, 5, 3.0, 4.0, pi / 2)
    client.command(4, 1, 1, 0.0, 0.0, 0.5, 1)

    assert client.round()[4, 1, 1][:3] == pytest.approx((3.0, 4.0, pi / 2 + 0.05))


@pytest.mark.parametrize(
    ("letters", "cells"), [("AB", [(0, "A"), (1, "B")]), ("P" * 37, [(each, "P") for each in range(36)])]
)
def test_a_frame_of_the_belt_has_at_most_thirty_six_cells(
    tmp_path: Path, notes: Notes, letters: str, cells: list[tuple[int, str]]
) -> None:
    more = CONFIGURATION + 'driver ( name "vib_belt" provides [ "7665:speech:1" "7665:dio:1" ] )'
    stations = stations_of(write_room(tmp_path, more), notes)
    client = Client(stations, (12, 1), (20, 1))
    client.command(12, 1, 1, letters)
    client.command(20, 1, 1, 11, 0x80 + ord("A"))

    assert [cell for _, cell in notes.taken] == [*cells, (11, "A")]
    assert client.round()[20, 1, 1] == (11, 0x80 + ord("A"))


@pytest.mark.parametrize(
    ("file", "cue"),
    [
        *((b"bump.wav", "bump"), (b"/a.b/BUMP.ogg\0xyz", "bump"), (b"c:\\sounds\\done.x.wav", "done")),
        *((b"done", "done"), (b"trumpet.wav", None), (b"", None)),
    ],
)
def test_a_sound_is_known_by_the_name_of_its_file(
    tmp_path: Path, notes: Notes, file: bytes, cue: str | None
) -> None:
    more = CONFIGURATION + 'driver ( name "soxplayer" provides [ "7665:sound:0" ] )'
    client = Client(stations_of(write_room(tmp_path, more), notes), (66, 0))
    client.command(66, 0, 1, file.ljust(64, b"\0"))

    assert [name for _, name in notes.taken] == ([] if cue is None else [cue])


@pytest.mark.parametrize(
    ("interface", "driver", "device"),
    [
        *(("power", "stage", None), ("power", "vib_belt", "Battery"), ("simulation", "gtts", None)),
        *(("simulation", "stage", "SimulationDevice"), ("speech", "vib_belt", "BeltFrames")),
        *(("speech", "gtts", "SpeechDevice"), ("speech", "stage", "SpeechDevice")),
        *(("sound", "soxplayer", "SoundDevice"), ("dio", "vib_belt", "DigitalOutputs")),
        *(("dio", "other", None), ("laser", "stage", None)),
    ],
)
def test_a_driver_offers_the_devices_that_the_original_has(
    interface: str, driver: str, device: str | None
) -> None:
    found = service_of(interface, driver)

    assert (found and found.__name__) == device
