"""Configuration files choose the world, the robots with their addresses, or a real robot."""

from pathlib import Path

import pytest

from sim.scene import NoteKind
from sim.worldfile import Address, Code, Configuration, Offer, WorldError, load_configuration
from sim.worldfile.load import address

WORLD = """
define bob position ( ranger ( sensor ( ) ) )
bob ( name "ann" ) bob ( name "bea" pose [ 2 0 0 0 ] ) bob ( name "cid" pose [ 4 0 0 0 ] )
model ( name "box" pose [ 6 0 0 0 ] )
"""
STAGE = 'driver ( name "stage" plugin "stageplugin" provides [ "simulation:0" ] worldfile "w.world" )\n'


def load(folder: Path, text: str, world: str = WORLD) -> Configuration:
    (folder / "w.world").write_text(world, encoding="utf-8")
    (folder / "w.cfg").write_text(text, encoding="utf-8")
    return load_configuration(folder / "w.cfg")


def robots(it: Configuration) -> list[str]:
    assert it.scene is not None
    return [it.scene.models[index].name for index in it.scene.robots]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("position2d:0", Address("position2d", 0)),
        ("6666:ranger:1", Address("ranger", 1, 6666, has_port=True)),
        ("localhost:6665:ranger:0", Address("ranger", 0, has_port=True)),
        ("robot.school:6670:ranger:3", Address("ranger", 3, 6670, "robot.school", has_port=True)),
        ("odometry:::position2d:0", Address("position2d", 0)),
        ("position2d", None),
        ("position2d:x", None),
        ("99999:ranger:0", None),
        ("1:2:3:4:5:6", None),
        (":0", None),
        ("", None),
    ],
)
def test_an_address_is_read_from_the_right_as_host_robot_interface_index(
    text: str, expected: Address | None
) -> None:
    assert address(text) == expected


def test_every_robot_can_be_programmed_where_the_file_offers_none(tmp_path: Path) -> None:
    it = load(tmp_path, STAGE)

    assert robots(it) == ["ann", "bea", "cid"]
    assert (it.world, it.offers, it.physical_port) == (tmp_path / "w.world", (), None)


def test_the_offered_robots_can_be_programmed_in_the_order_of_their_ports(tmp_path: Path) -> None:
    second = 'driver ( name "stage" provides [ "6666:position2d:0" "6666:ranger:0" ] model "ann" )'
    first = 'driver ( name "stage" provides [ "position2d:0" ] model "cid" )'
    it = load(tmp_path, STAGE + second + first)

    assert robots(it) == ["cid", "ann"]
    addresses = tuple(Address(each, 0, 6666, has_port=True) for each in ("position2d", "ranger"))
    assert it.offers[0] == Offer("ann", addresses)
    assert [(offer.model, offer.port) for offer in it.offers] == [("ann", 6666), ("cid", 6665)]


def test_an_offered_model_without_wheels_is_not_a_robot(tmp_path: Path) -> None:
    it = load(tmp_path, STAGE + 'driver ( name "stage" provides [ "ranger:0" ] model "bea" )')

    assert robots(it) == ["ann", "bea", "cid"]
    assert not it.offers[0].drives


def test_an_offered_model_without_sensors_is_a_robot(tmp_path: Path) -> None:
    world = WORLD + 'position ( name "blind" pose [ 8 0 0 0 ] )'
    it = load(tmp_path, STAGE + 'driver ( name "stage" provides [ "position2d:0" ] model "blind" )', world)

    assert robots(it) == ["blind"]


def test_an_offer_of_a_missing_model_is_reported_with_the_nearest_name(tmp_path: Path) -> None:
    it = load(tmp_path, STAGE + 'driver ( name "stage" provides [ "position2d:0" ] model "be" )')

    assert it.scene is not None
    (note,) = it.scene.report.notes
    assert (note.kind, note.code, note.line) == (NoteKind.WARNING, "unknown-model", 2)
    assert note.details == {"name": "be", "nearest": "bea"}
    assert robots(it) == ["ann", "bea", "cid"]


def test_other_drivers_are_reported_and_ignored(tmp_path: Path) -> None:
    it = load(tmp_path, STAGE + 'driver ( name "rangertolaser" provides ["laser:0"] requires ["ranger:1"] )')

    assert it.scene is not None
    assert [(note.code, note.details) for note in it.scene.report.notes] == [
        ("driver-not-used", {"name": "rangertolaser"})
    ]


@pytest.mark.parametrize("port", ["/dev/ttyUSB0", "COM3", "com12", "/dev/serial/by-id/usb-1"])
def test_a_driver_with_a_serial_port_asks_for_the_real_robot(tmp_path: Path, port: str) -> None:
    it = load(tmp_path, f'driver ( name "donnie" provides [ "position2d:0" ] port "{port}" )')

    assert (it.physical_port, it.scene, it.world) == (port, None, None)


def test_the_serial_port_of_the_wheels_wins(tmp_path: Path) -> None:
    laser = 'driver ( name "sicklms200" provides [ "ranger:0" ] port "/dev/ttyS1" )'
    it = load(
        tmp_path, STAGE + laser + 'driver ( name "p2os" provides [ "position2d:0" ] port "/dev/ttyS0" )'
    )

    assert it.physical_port == "/dev/ttyS0"
    assert it.scene is not None


@pytest.mark.parametrize(
    ("text", "code", "line", "column"),
    [
        ("", Code.NO_WORLD_FILE, 1, 1),
        ('driver ( name "stage" )', Code.NO_WORLD_FILE, 1, 1),
        ('driver ( name "stage" worldfile "no.world" )', Code.FILE_NOT_FOUND, 1, 33),
        ('driver ( name "stage" worldfile [ ] )', Code.WRONG_TYPE, 1, 33),
        (STAGE + 'driver ( name "stage" model [ ] )', Code.WRONG_TYPE, 2, 29),
        (STAGE + 'driver ( name "stage" model "ann" provides [ "x" ] )', Code.BAD_ADDRESS, 2, 44),
        (STAGE + 'driver ( name "stage" model "ann" provides "position2d:0" )', Code.WRONG_TYPE, 2, 44),
        ('drivr ( name "stage" )', Code.UNKNOWN_TYPE, 1, 1),
        ("driver ( name )", Code.UNEXPECTED, 1, 15),
        ("driver (", Code.UNCLOSED, 1, 8),
        ('include "w.cfg"', Code.INCLUDE_CYCLE, 1, 9),
    ],
)
def test_a_mistake_has_a_place(tmp_path: Path, text: str, code: Code, line: int, column: int) -> None:
    with pytest.raises(WorldError) as error:
        load(tmp_path, text)

    assert (error.value.code, error.value.line, error.value.column) == (code, line, column)
    assert error.value.file == str(tmp_path / "w.cfg")


def test_a_world_outside_the_allowed_folders_is_refused(tmp_path: Path) -> None:
    inner = tmp_path / "inner"
    inner.mkdir()
    (tmp_path / "out.world").write_text(WORLD, encoding="utf-8")
    (inner / "w.cfg").write_text('driver ( name "stage" worldfile "../out.world" )', encoding="utf-8")

    with pytest.raises(WorldError) as error:
        load_configuration(inner / "w.cfg")
    assert error.value.code is Code.INCLUDE_OUTSIDE
    assert load_configuration(inner / "w.cfg", allowed=(tmp_path,)).scene is not None


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("everything.cfg", ["robot1", "p1", "p2", "p3", "p4", "p5", "p6"]),
        ("simple.cfg", ["r0"]),
        ("roomba.cfg", ["r0"]),  # it offers a model that its world does not have
    ],
)
def test_the_configurations_of_stage_load(shared: Path, name: str, expected: list[str]) -> None:
    it = load_configuration(shared / "stage" / "worlds" / name)

    assert robots(it) == expected
