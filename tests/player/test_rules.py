"""The rules of the wire that no other file of these tests has, message by message."""

import re
import struct
from collections.abc import Callable
from math import pi
from pathlib import Path
from random import Random

import pytest

from devices.player.codec import (
    FORMS,
    LOCAL_HOST,
    MessageType,
    PlayerMessage,
    TooLong,
    body_of,
    encode,
    values_of,
)
from devices.player.connection import ClientConnection
from devices.ports.drive import RangerReading
from donnie_tui.player.equipment import LONGEST_TEXT
from donnie_tui.player.server import ServerProblem, Stations
from tests.player.room import CONFIGURATION, WORLD, Notes, stations_of, write_room
from tests.player.test_devices import ACK, COMMAND, DATA, NACK, REQUEST, WHEELS, Client, rounds


@pytest.fixture
def stations(tmp_path: Path) -> Stations:
    return stations_of(write_room(tmp_path))


def bodies(client: Client, subtype: int, *values: object) -> tuple[int, bytes]:
    """Type and body of the one reply of the server itself."""
    client.send(1, 0, REQUEST, subtype, *values)
    [reply] = [each for each in client.take() if each.type != DATA]
    return reply.type, reply.body


# --- 3: the header


def test_headers_name_this_machine_the_port_and_the_simulated_time(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    stations.step()
    client.send(1, 0, REQUEST, 4)
    reply, datum, end = client.take()

    assert [(each.host, each.robot) for each in (reply, datum)] == [(LOCAL_HOST, 7665)] * 2
    assert [each.time for each in (reply, datum)] == [pytest.approx(0.1)] * 2
    assert (end.type, end.interface, end.index, end.subtype) == (MessageType.SYNCH, 1, 0, 1)
    assert (end.host, end.robot, end.body) == (0, 0, b"")
    assert [each.sequence for each in (reply, datum, end)] == [0, 0, 0]


def test_what_a_client_says_of_host_robot_and_time_is_ignored(stations: Stations) -> None:
    client = Client(stations)
    odd = PlayerMessage(4, 0, REQUEST, 1, time=-7.0, host=1, robot=9999, sequence=5)
    client.connection.receive(odd.encoded())

    [reply] = client.take()
    assert (reply.type, reply.robot) == (ACK, 7665)


@pytest.mark.parametrize("subtype", [247, 248, 253, 254])
def test_properties_of_devices_are_refused(stations: Stations, subtype: int) -> None:
    assert Client(stations).ask(4, 0, subtype) is None


@pytest.mark.parametrize("interface", [1, 3, 4, 7, 10, 12, 14, 31, 62])
def test_what_a_device_can_do_is_answered_with_no(stations: Stations, interface: int) -> None:
    """Also by the simulation: the real server dies of this question."""
    client = Client(stations)
    asked = PlayerMessage(interface, 0, REQUEST, 255, struct.pack(">II", REQUEST, 1))
    client.connection.receive(asked.encoded())

    [reply] = client.take()
    assert (reply.type, reply.subtype, reply.body) == (NACK, 255, b"")


# --- 4: the device player


def test_the_list_has_the_devices_of_the_port_alone_in_their_order(stations: Stations) -> None:
    [alice] = Client(stations).ask(1, 0, 1)
    [bob] = Client(stations, port=7666).ask(1, 0, 1)

    keys = [(31, 0), (4, 0), (62, 0), (62, 1), (14, 0), (7, 0), (10, 0), (12, 0), (4, 1), (3, 0)]
    assert alice == tuple((LOCAL_HOST, 7665, *key) for key in keys)
    assert bob == ((LOCAL_HOST, 7666, 4, 0), (LOCAL_HOST, 7666, 62, 0))


def test_a_driver_is_named_and_that_of_an_unknown_device_is_not(stations: Stations) -> None:
    client = Client(stations)

    assert client.ask(1, 0, 2, 0, 0, 4, 0, "") == (LOCAL_HOST, 7665, 4, 0, "stage")
    assert bodies(client, 2, 0, 0, 4, 9, "") == (NACK, b"")


def test_opening_what_is_not_there_is_refused_with_the_address_and_an_error(stations: Stations) -> None:
    type_, body = bodies(Client(stations), 3, 0, 0, 40, 0, 1, "")

    assert (type_, len(body)) == (NACK, 28)
    assert struct.unpack(">7I", body) == (LOCAL_HOST, 7665, 40, 0, 3, 0, 0)


def test_closing_grants_closed_and_a_wrong_access_an_error(stations: Stations) -> None:
    client = Client(stations, WHEELS)

    assert client.ask(1, 0, 3, 0, 0, *WHEELS, 2, "")[4] == 2
    assert client.ask(1, 0, 3, 0, 0, *WHEELS, 7, "")[4] == 3


def test_what_was_opened_twice_drives_until_it_is_closed_twice(stations: Stations) -> None:
    client, other = Client(stations, WHEELS, WHEELS), Client(stations, (62, 0))
    client.command(*WHEELS, 1, 0.1, 0.0, 0.0, 1)
    drive = stations._loop.drives["alice"]
    speeds = []
    for _ in range(2):
        other.round()
        speeds.append(drive.state().velocity.ahead)
        client.ask(1, 0, 3, 0, 0, *WHEELS, 2, "")
    other.round()

    assert speeds == [pytest.approx(0.1)] * 2
    assert drive.state().velocity.ahead == 0.0


def test_any_mode_is_acknowledged_and_nonsense_is_push(stations: Stations) -> None:
    client = Client(stations, WHEELS)

    assert bodies(client, 5, 77) == (ACK, b"")
    stations.step()
    assert [each.type for each in client.take()] == [DATA]


@pytest.mark.parametrize("subtype", [6, 7, 8, 9, 11, 200])
def test_authentication_names_and_unknown_requests_are_refused(stations: Stations, subtype: int) -> None:
    assert bodies(Client(stations), subtype) == (NACK, b"")


def test_a_new_connection_pushes(stations: Stations) -> None:
    station = stations.by_port[7665]
    connection = ClientConnection(station, "1")
    station.clients.add(connection)
    connection.receive(PlayerMessage(1, 0, REQUEST, 3, body_of(1, REQUEST, 3, 0, 0, 4, 0, 1, "")).encoded())
    connection.take()
    stations.step()

    assert len(connection.take()) == 40 + 52


def test_a_reply_carries_what_was_queued_before_it_out(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    stations.step()
    assert client.take() == []
    client.send(4, 0, REQUEST, 1)

    assert [each.type for each in client.take()] == [DATA, ACK]


def test_the_acknowledgement_of_a_round_precedes_what_is_queued(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    stations.step()
    client.send(1, 0, REQUEST, 4)

    assert [each.type for each in client.take()] == [ACK, DATA, MessageType.SYNCH]


def test_a_round_stays_open_until_there_are_data(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    client.send(1, 0, REQUEST, 4)
    assert [each.type for each in client.take()] == [ACK]
    assert client.take() == []
    stations.step()

    assert [each.type for each in client.take()] == [DATA, MessageType.SYNCH]
    stations.step()
    assert client.take() == []


def test_a_rule_for_one_subtype_ignores_that_alone(stations: Stations) -> None:
    client = Client(stations, (62, 0))
    client.ask(1, 0, 10, 62, 0, DATA, 3, 2)

    assert set(client.round()) == {(62, 0, 1)}


# --- 6: interfaces


def test_a_car_command_is_a_speed_and_a_rate(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    client.command(*WHEELS, 3, 0.2, 0.5)

    assert client.round()[4, 0, 1][3:6] == pytest.approx((0.2, 0.0, 0.5))


def test_wheels_that_are_no_omnidirectional_ones_ignore_a_speed_to_the_side(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    client.command(*WHEELS, 1, 0.0, 0.3, 0.0, 1)

    assert client.round()[4, 0, 1][:6] == pytest.approx((-2, 0, 0, 0, 0, 0))


def test_a_heading_command_has_no_effect(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    client.command(*WHEELS, 4, 0.3, 1.0)

    assert client.round()[4, 0, 1][3:6] == (0, 0, 0)


def test_the_requests_of_wheels(stations: Stations) -> None:
    client = Client(stations)

    assert client.ask(4, 0, 1)[6:] == pytest.approx((0.4, 0.4, 0.3))
    assert client.ask(4, 0, 2, 0) == ()
    assert client.ask(4, 0, 3, 1) is None
    assert client.ask(4, 0, 4, 1) == ()
    assert client.ask(4, 0, 7) is None


def test_true_poses_are_not_set_by_odometry_and_counted_ones_are(tmp_path: Path) -> None:
    odometric = WORLD.replace('name "bob"', 'name "bob" localization "odom"')
    stations = stations_of(write_room(tmp_path, world=odometric))
    alice, bob = Client(stations, WHEELS), Client(stations, WHEELS, port=7666)
    before = bob.round()[4, 0, 1][:3]
    for client in (alice, bob):
        assert client.ask(4, 0, 5, 5.0, 6.0, 0.0) == ()
    set_true, set_counted = alice.round()[4, 0, 1][:2], bob.round()[4, 0, 1][:2]
    bob.command(*WHEELS, 1, 1.0, 0.0, 0.0, 1)
    driven = bob.round()[4, 0, 1][:2]
    assert bob.ask(4, 0, 6) == ()
    bob.command(*WHEELS, 1, 0.0, 0.0, 0.0, 1)

    assert before == (0, 0, 0)
    assert set_true == pytest.approx((-2, 0))
    assert set_counted == pytest.approx((5, 6))
    assert driven == pytest.approx((5.1, 6))
    assert bob.round()[4, 0, 1][:3] == pytest.approx((0, 0, 0))


def test_a_robot_that_something_blocks_is_stalled(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    client.ask(31, 0, 2, "alice", 3.75, 2.0, 0.0)
    free = client.round()[4, 0, 1][6]
    client.command(*WHEELS, 1, 0.5, 0.0, 0.0, 1)

    assert (free, rounds(client, 3)[4, 0, 1][6]) == (0, 1)


def test_of_many_commands_in_a_step_the_last_one_counts_and_a_goal_is_reached_finely(
    stations: Stations,
) -> None:
    """As the original's client turns: its own place and the heading, every five milliseconds."""
    client = Client(stations, WHEELS)
    goal = 2.5
    for _ in range(40):
        x, y, yaw, *_ = client.round()[4, 0, 1]
        for _ in range(20):
            client.command(*WHEELS, 2, x, y, goal, 0.0, 0.0, 0.0, 1)
    client.command(*WHEELS, 1, 9.0, 0.0, 0.0, 1)
    client.command(*WHEELS, 1, 0.0, 0.0, 0.0, 1)

    assert abs(yaw - goal) < pi / 360
    assert client.round()[4, 0, 1][:2] == pytest.approx((-2, 0), abs=1e-6)


def test_intensities_follow_their_ranges(stations: Stations) -> None:
    client = Client(stations, (62, 0), (62, 1))
    client.send(1, 0, REQUEST, 4)
    stations.step()

    data = [(each.index, each.subtype) for each in client.take() if each.type == DATA]
    assert data == [(0, 1), (0, 3), (1, 1), (1, 3)]


def test_a_range_of_no_readings_is_not_sent(stations: Stations, monkeypatch: pytest.MonkeyPatch) -> None:
    empty = RangerReading("", ((),) * 4, ((),) * 4)
    monkeypatch.setattr(stations._loop.drives["alice"], "rangers", lambda _: (empty,))
    client = Client(stations, WHEELS, (62, 0))

    assert set(client.round()) == {(4, 0, 1)}


def test_a_ranger_without_sensors_is_none(tmp_path: Path) -> None:
    """A range of no readings ends libplayerc."""
    world = WORLD.replace('name "bob" pose [ -2 -2 0 0 ]', 'name "bob" pose [ -2 -2 0 0 ] ranger ( )')
    text = CONFIGURATION.replace('"7666:ranger:0"', '"7666:ranger:0" "7666:ranger:1"')

    with pytest.raises(ServerProblem) as refused:
        stations_of(write_room(tmp_path, text, world))
    assert refused.value.values == {"what": "ranger:1"}


def test_a_camera_on_a_thing_that_is_no_robot_is_not_offered(tmp_path: Path) -> None:
    world = WORLD.replace("pushable 1 )", "pushable 1 blobfinder ( ) )")
    text = f'{CONFIGURATION}driver ( name "stage" model "redbox" provides [ "7667:blobfinder:3" ] )'

    with pytest.raises(ServerProblem) as refused:
        stations_of(write_room(tmp_path, text, world))
    assert (refused.value.code, refused.value.values) == ("player-no-model", {"what": "blobfinder:3"})


def test_a_mark_beyond_where_it_can_be_read_is_0(tmp_path: Path) -> None:
    far = WORLD.replace("range_max_id 5", "range_max_id 1.5")
    client = Client(stations_of(write_room(tmp_path, world=far)), (10, 0))

    [[[number, *_]]] = client.round()[10, 0, 1]
    assert number == 0
    assert client.ask(10, 0, 2) is None
    assert len(client.ask(10, 0, 1)) == 11


def test_a_mark_is_where_the_middle_of_its_thing_is_and_looks_where_that_looks(stations: Stations) -> None:
    """Seen from -2 0, along x."""
    client = Client(stations, (10, 0))
    client.ask(31, 0, 2, "redbox", 0.0, 1.0, 0.5)

    [[[number, *pose]]] = client.round()[10, 0, 1]
    assert number == 7
    assert pose[:6] == pytest.approx((2.0, 1.0, 0.0, 0.0, 0.0, 0.5))
    assert pose[6:] == [0.0] * 6


def test_a_geometry_has_the_pose_on_the_robot_and_the_width_before_the_length(stations: Stations) -> None:
    client = Client(stations)
    gripper, finder = client.ask(3, 0, 1), client.ask(10, 0, 1)

    assert gripper[:6] == pytest.approx((0.3, 0, 0, 0, 0, 0))
    assert gripper[6:9] == pytest.approx((0.2, 0.1, 0.2))
    assert finder[:6] == pytest.approx((0, 0, 0, 0, 0, 0))
    [first, _] = client.ask(14, 0, 1)[0]
    assert first == pytest.approx((0.24, 0.1, 0, 0, 0, 0, 0.2, 0))
    assert client.ask(62, 0, 5) == pytest.approx((-pi / 36, pi / 36, pi / 18, 0, 5, 0.02, 10))


def test_a_blob_has_the_number_0_and_is_to_the_left_of_the_middle_if_its_thing_is(stations: Stations) -> None:
    client = Client(stations, (7, 0))
    client.ask(31, 0, 2, "redbox", 0.0, 0.5, 0.0)

    width, _, [blob] = client.round()[7, 0, 1]
    assert blob[0] == 0
    assert blob[5] < blob[6] < width / 2


def test_no_more_rules_and_openings_are_kept_than_are_allowed(stations: Stations) -> None:
    """All are acknowledged or refused, and those that were there first still count."""
    client = Client(stations, WHEELS)
    client.ask(1, 0, 10, 4, 0, DATA, 1, 1)
    for index in range(1, 128):
        assert client.ask(1, 0, 10, 62, index, DATA, 1, 2) == ()
    assert len(client.connection._rules) == 64
    opened = [client.ask(1, 0, 3, 0, 0, 62, 0, 1, "") is not None for _ in range(1029)]

    assert opened == [True] * 1023 + [False] * 6
    assert set(client.round()) == {(4, 0, 1), (62, 0, 1), (62, 0, 3)}


def test_seeing_nothing_is_a_picture_of_its_size_without_blobs(tmp_path: Path) -> None:
    gray = WORLD.replace('name "room"', 'name "room" color "gray"')
    client = Client(stations_of(write_room(tmp_path, world=gray)), (7, 0), (10, 0))
    client.ask(31, 0, 2, "alice", -2.0, 0.0, pi)

    data = client.round()
    assert data[7, 0, 1] == (80, 60, ())
    assert data[10, 0, 1] == ((),)


@pytest.mark.parametrize("subtype", [3, 4, 5])
def test_what_a_gripper_does_not_know_changes_nothing(stations: Stations, subtype: int) -> None:
    client = Client(stations, (3, 0))
    client.command(3, 0, subtype)

    assert client.round()[3, 0, 1][0] == 1


def test_a_thing_is_put_in_three_dimensions(stations: Stations) -> None:
    client = Client(stations)

    assert client.ask(31, 0, 4, "redbox", 1.0, 2.0, 0.0, 0.0, 0.0, 0.5, 0.0) == ()
    assert client.ask(31, 0, 1, "redbox", 0.0, 0.0, 0.0)[1:] == pytest.approx((1.0, 2.0, 0.5))
    assert client.ask(31, 0, 3, "redbox", *(0.0,) * 7)[1:7] == pytest.approx((1, 2, 0, 0, 0, 0.5))
    assert client.ask(31, 0, 3, "nothing", *(0.0,) * 7) is None
    assert client.ask(31, 0, 3, "alice.head", *(0.0,) * 7)[1:4] == pytest.approx((0, 0, 0))


def test_putting_a_robot_elsewhere_does_not_stop_it(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    client.command(*WHEELS, 1, 0.1, 0.0, 0.0, 1)
    client.round()
    client.ask(31, 0, 2, "alice", -1.0, 1.0, 0.0)

    assert client.round()[4, 0, 1][:4] == pytest.approx((-0.99, 1.0, 0.0, 0.1))


SERVICES = """
driver ( name "soxplayer" plugin "libsox" provides [ "7665:sound:0" ] )
driver ( name "gtts" plugin "elsewhere" requires [ "7665:sound:0" ] provides [ "7665:speech:3" ] )
driver ( name "vib_belt" provides [ "7665:speech:1" "7665:dio:1" ] alwayson 1 )
driver ( name "donnie" port "/dev/ttyACM0" provides [ "7665:power:0" ] )
interface ( name "unknown" )
"""


def test_services_are_known_by_their_names_and_the_rest_is_read_over(tmp_path: Path) -> None:
    notes = Notes()
    stations = stations_of(write_room(tmp_path, CONFIGURATION + SERVICES), notes)
    client = Client(stations, (66, 0), (12, 3), (12, 1), (20, 1), (2, 0))
    client.command(12, 3, 1, "bom dia")
    client.command(20, 1, 1, 11, ord("A"))
    client.command(66, 0, 1, b"bump.wav".ljust(64, b"\0"))

    assert notes.taken == [("alice", "bom dia"), ("alice", (11, "A")), ("alice", "bump")]
    data = client.round()
    assert data[20, 1, 1] == (11, ord("A"))
    assert data[2, 0, 1] == (8, 0.0, 100.0, 0.0, 0.0, 0)
    assert client.ask(1, 0, 2, 0, 0, 66, 0, "")[4] == "soxplayer"


@pytest.mark.parametrize("device", ["speech:5", "dio:5", "ranger:5", "position2d:5", "simulation:5"])
def test_what_a_driver_provides_that_is_not_known_is_left_out(tmp_path: Path, device: str) -> None:
    text = CONFIGURATION + f'driver ( name "festival" model "alice" provides [ "7665:{device}" ] )'
    stations = stations_of(write_room(tmp_path, text))

    assert stations.left_out == [device]


def test_services_take_what_they_know_and_no_more(tmp_path: Path) -> None:
    """Each letter is a strength of its own, a sound that Donnie hasn't is none, and a text has an end."""
    notes = Notes()
    stations = stations_of(write_room(tmp_path, CONFIGURATION + SERVICES), notes)
    client = Client(stations, (66, 0), (12, 0), (20, 1))
    client.command(20, 1, 1, 8, ord("B"))
    client.command(66, 0, 1, b"/etc/passwd".ljust(64, b"\0"))
    client.command(66, 0, 1, b"sounds\\Bump.wav".ljust(64, b"\0"))
    client.command(12, 0, 1, "a" * (2 * LONGEST_TEXT))

    assert notes.taken == [("alice", (8, "B")), ("alice", "bump"), ("alice", "a" * LONGEST_TEXT)]


@pytest.mark.parametrize("device", ["sonar:0", "aio:0", "camera:0", "laser:0", "power:0", "graphics2d:0"])
def test_what_a_simulated_robot_has_not_is_left_out_and_refused(tmp_path: Path, device: str) -> None:
    text = CONFIGURATION.replace('"7665:gripper:0"', f'"7665:{device}"')
    stations = stations_of(write_room(tmp_path, text))
    code = {"sonar": 5, "aio": 21, "camera": 40, "laser": 6, "power": 2, "graphics2d": 55}[device[:-2]]

    assert stations.left_out == [device]
    assert bodies(Client(stations), 3, 0, 0, code, 0, 1, "")[0] == NACK


def test_an_address_gets_the_first_model_of_its_kind_that_is_left(tmp_path: Path) -> None:
    """The ranger of the robot itself, then that of its head, in the order of the addresses."""
    text = CONFIGURATION.replace('"7665:ranger:0" "7665:ranger:1"', '"7665:ranger:5" "7665:ranger:2"')
    client = Client(stations_of(write_room(tmp_path, text)), (62, 5), (62, 2))

    data = client.round()
    assert [len(data[62, index, 1][0]) for index in (5, 2)] == [4, 181]


# --- 9: rubbish


@pytest.mark.parametrize("type_", [0, 1, 4, 5, 6])
def test_a_message_that_clients_do_not_send_is_dropped(stations: Stations, type_: int) -> None:
    client = Client(stations, WHEELS)
    client.connection.receive(PlayerMessage(4, 0, type_, 1, bytes(28)).encoded())
    client.connection.receive(PlayerMessage(1, 0, type_, 1).encoded())

    assert client.take() == []
    assert client.ask(4, 0, 1) is not None


WRONG_BODIES: list[Callable[[], PlayerMessage]] = [
    lambda: PlayerMessage(4, 0, REQUEST, 5, bytes(8)),
    lambda: PlayerMessage(31, 0, REQUEST, 1, struct.pack(">II", 5, 6) + bytes(40)),
    lambda: PlayerMessage(31, 0, REQUEST, 1, struct.pack(">II", 2**31, 2**31) + bytes(24)),
    lambda: PlayerMessage(1, 0, REQUEST, 3, bytes(4)),
    lambda: PlayerMessage(1, 0, REQUEST, 10, bytes(19)),
]


@pytest.mark.parametrize("made", WRONG_BODIES)
def test_a_request_with_a_wrong_body_is_refused_once_and_the_connection_lives(
    stations: Stations, made: Callable[[], PlayerMessage]
) -> None:
    client = Client(stations)
    client.connection.receive(made().encoded())

    [reply] = client.take()
    assert (reply.type, reply.body, reply.subtype) == (NACK, b"", made().subtype)
    assert client.ask(4, 0, 1) is not None


def test_a_body_of_more_than_64_kibibytes_is_not_waited_for(stations: Stations) -> None:
    longest, longer = (struct.pack(">IIIIIIdII", 0, 0, 12, 0, 2, 1, 0.0, 0, 65536 + more) for more in (0, 1))
    client = Client(stations)
    client.connection.receive(longest + bytes(65536))
    assert client.ask(4, 0, 1) is not None

    with pytest.raises(TooLong):
        client.connection.receive(longer)


def test_a_command_with_a_wrong_body_or_to_nothing_is_dropped(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    client.connection.receive(PlayerMessage(4, 0, COMMAND, 1, bytes(27)).encoded())
    client.connection.receive(PlayerMessage(12, 9, COMMAND, 1, body_of(12, COMMAND, 1, "x")).encoded())
    client.connection.receive(PlayerMessage(4, 0, COMMAND, 99).encoded())

    assert client.take() == []
    assert client.round()[4, 0, 1][3:6] == (0, 0, 0)


# --- 10: time


def test_data_come_every_tenth_of_a_second_and_show_a_speed_at_once(stations: Stations) -> None:
    client = Client(stations, WHEELS)
    times = []
    for _ in range(3):
        client.send(1, 0, REQUEST, 4)
        stations.step()
        times += [each.time for each in client.take() if each.type == DATA]
    client.command(*WHEELS, 1, 0.25, 0.0, 0.0, 1)

    assert times == pytest.approx([0.1, 0.2, 0.3])
    assert client.round()[4, 0, 1][3] == 0.25


def test_devices_that_no_client_has_open_are_not_computed(
    stations: Stations, monkeypatch: pytest.MonkeyPatch
) -> None:
    drive = stations._loop.drives["alice"]
    asked: list[int | None] = []
    measure = drive.rangers

    def rangers(part: int | None = None) -> tuple[RangerReading, ...]:
        asked.append(part)
        return measure(part)

    monkeypatch.setattr(drive, "rangers", rangers)
    client = Client(stations, WHEELS)
    client.round()
    assert asked == []
    client.ask(1, 0, 3, 0, 0, 62, 0, 1, "")
    client.round()

    assert len(asked) == 1


def test_every_reply_can_be_read_again(stations: Stations) -> None:
    client = Client(stations)
    for interface in (4, 62, 14, 10, 3):
        client.send(interface, 0, REQUEST, 1)
        [reply] = client.take()
        assert values_of(reply)


def _number(chance: Random, letter: str) -> float:
    if letter in "df":
        return chance.choice([0.0, 1.0, -1.0, chance.uniform(-9, 9), float("nan"), float("inf"), 1e38])
    return chance.choice([0, 1, 2, 7, 255, 2**31 - 1, chance.randrange(300)])


def _values(chance: Random, form: str) -> list[object]:
    found: list[object] = []
    for group, counted, fixed in re.findall(r"\[([Iifd]+)\]|([bt])|([Iifd]+|\d+s)", form.replace(" ", "")):
        if group:
            rows = [[_number(chance, each) for each in group] for _ in range(chance.randrange(3))]
            found.append([row[0] for row in rows] if len(group) == 1 else rows)
        elif counted == "t":
            found.append(
                chance.choice(["", "alice", "redbox", "alice.head", "color", "time", "\N{SNOWMAN}" * 99])
            )
        elif counted == "b" or fixed.endswith("s"):
            found.append(chance.randbytes(64 if fixed else chance.choice([0, 8, 16, 33])))
        else:
            found += [_number(chance, each) for each in fixed]
    return found


@pytest.mark.parametrize("seed", range(3))
def test_whatever_clients_send_every_request_has_one_reply_and_the_world_goes_on(
    tmp_path: Path, seed: int
) -> None:
    """Known messages with odd values, and rubbish in their place, from clients that have devices open."""
    chance = Random(seed)
    stations = stations_of(write_room(tmp_path, CONFIGURATION + SERVICES.replace("interface", "driver")))
    kinds = [(key, form) for key, form in sorted(FORMS.items()) if key[1] in (COMMAND, REQUEST)]
    for _ in range(40):
        opened = chance.sample(list(stations.by_port[7665].devices), 3)
        client = Client(stations, *opened)
        for _ in range(20):
            (interface, type_, subtype), form = chance.choice(kinds)
            is_rubbish = chance.random() < 0.2
            body = (
                chance.randbytes(chance.randrange(60)) if is_rubbish else encode(form, _values(chance, form))
            )
            message = PlayerMessage(interface, chance.choice([0, 0, 1, 65535]), type_, subtype, body)
            client.connection.receive(message.encoded())
            replies = [each.type for each in client.take() if each.type in (ACK, NACK)]
            assert len(replies) == (type_ == REQUEST), message
            stations.step()
        client.vanish()
    assert not any(device.users for port in stations.by_port.values() for device in port.devices.values())
