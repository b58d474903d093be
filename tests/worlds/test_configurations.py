"""Configuration files choose the world, the robots with their addresses, or a real robot."""

import os
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
        ("k:h:6670:ranger:3", Address("ranger", 3, 6670, "h", has_port=True)),
        ("65535:ranger:999999999", Address("ranger", 999_999_999, 65535, has_port=True)),
        ("65536:ranger:0", None),
        ("ranger:1000000000", None),
        ("2d:0", None),
        ("position 2d:0", None),
        ("a:b:c:6665:ranger:0", None),
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


def driver(model: str, *addresses: str, name: str = "stage", more: str = "") -> str:
    provided = " ".join(f'"{each}"' for each in addresses)
    return f'driver ( name "{name}" provides [ {provided} ] model "{model}" {more} )\n'


@pytest.mark.parametrize(
    ("addresses", "port", "drives"),
    [
        ((), 6665, False),
        (("7000:ranger:0",), 7000, False),
        (("7000:ranger:0", "6666:position2d:0"), 6666, True),
        (("7000:ranger:0", "6666:position:0", "6667:position2d:0"), 6666, True),
        (("7000:position3d:0",), 7000, True),
    ],
)
def test_the_port_of_an_offer_is_that_of_its_wheels(
    addresses: tuple[str, ...], port: int, drives: bool, tmp_path: Path
) -> None:
    (offer,) = load(tmp_path, STAGE + driver("ann", *addresses)).offers

    assert (offer.model, offer.port, offer.drives) == ("ann", port, drives)


def test_all_drivers_are_kept_in_their_order_and_the_first_world_counts(tmp_path: Path) -> None:
    (tmp_path / "other.world").write_text(WORLD)
    text = 'driver ( name "else" worldfile "other.world" )\n' + STAGE
    text += 'interface ( name "x" )\n' + driver("bea", "position2d:0")
    it = load(tmp_path, text + 'driver ( name "stage" worldfile "other.world" )')

    assert it.path == tmp_path / "w.cfg"
    assert it.world == tmp_path / "w.world"
    assert [(each.name, each.model, len(each.addresses)) for each in it.drivers] == [
        *(("else", "", 0), ("stage", "", 1), ("stage", "bea", 1), ("stage", "", 0)),
    ]
    assert it.scene is not None
    assert it.scene.report.files == (str(tmp_path / "w.cfg"), str(tmp_path / "w.world"))


def test_a_thing_or_a_part_is_offered_and_no_robot_and_of_equal_names_the_first_is_meant(
    tmp_path: Path,
) -> None:
    world = WORLD + 'bob ( name "ann" pose [ 8 0 0 0 ] )'
    it = load(tmp_path, STAGE + driver("box", "position2d:0"), world)
    assert robots(it) == ["ann", "bea", "cid", "ann"]

    again = load(
        tmp_path, STAGE + 2 * driver("ann", "position2d:0") + driver("ann.ranger:0", "ranger:0"), world
    )
    assert again.scene is not None
    assert again.scene.robots == (0,)
    assert again.scene.report.notes[-1].code == "robot-renamed"
    assert "unknown-model" not in {note.code for note in again.scene.report.notes}


def serial(address: str, port: str) -> str:
    return driver("", address, name="a", more=f'port "{port}"')


@pytest.mark.parametrize(
    ("text", "port", "unused"),
    [
        (serial("ranger:0", "COM1") + serial("ranger:0", "COM2"), "COM1", []),
        (serial("ranger:0", "COM1") + serial("position2d:0", "COM2"), "COM2", []),
        (STAGE + driver("", name="a", more='port "6665"'), None, ["a"]),
        (STAGE + driver("", name="a", more='port "x/dev/tty"'), None, ["a"]),
        (STAGE + driver("", name="n" * 70), None, ["n" * 60]),
        (STAGE + driver("ann", more='port "COM7"'), None, []),
    ],
)  # fmt: skip
def test_the_first_serial_port_asks_for_a_real_robot_and_other_drivers_are_reported(
    text: str, port: str | None, unused: list[str], tmp_path: Path
) -> None:
    it = load(tmp_path, text)

    assert it.physical_port == port
    notes = it.scene.report.notes if it.scene is not None else ()
    assert [(each.code, each.line, each.column, each.details["name"]) for each in notes] == [
        ("driver-not-used", 2, 1, name) for name in unused
    ]


def test_a_pipe_in_place_of_a_world_is_no_file(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(WorldError) as error:
        load(tmp_path, 'driver ( name "stage" worldfile "pipe" )')

    assert (error.value.code, error.value.details["path"]) == (Code.NO_FILE, "pipe")


def test_a_wrong_address_is_repeated_up_to_sixty_letters(tmp_path: Path) -> None:
    with pytest.raises(WorldError) as error:
        load(tmp_path, STAGE + driver("ann", "x" * 70))

    assert error.value.details == {"found": "x" * 60}
