"""The manual's chapter on world files, step by step: each step loads and is what the manual says."""

from functools import cache
from pathlib import Path

import pytest

import worlds
from devices.ports.robot import STEP, Bearing, Pose
from donnie_tui.cli.main import main
from sim.picture import Picture, picture
from sim.robot import SimulatedRobot
from sim.scene import Model, Scene
from sim.world import World
from sim.worldfile import load_world
from tests.unit.sim.floors import Unpaced

STEPS = [name for name in worlds.names() if name not in worlds.scenarios()]
CAVE = ("bigbob4", "bigbob5", "bigbob6", "bigbob_oranges", "bigbob7")


@cache
def scene(name: str) -> Scene:
    return load_world(Path(worlds.path(name)))


@cache
def seen(name: str) -> Picture:
    return picture(scene(name))


def bob(name: str) -> Model:
    return next(model for model in scene(name).models if model.name == "bob1")


def extent(model: Model) -> tuple[float, float, float, float]:
    """West, south, east and north end in steps."""
    points = [point for outline in model.outlines() for point in outline]
    xs, ys = [x / STEP for x, _ in points], [y / STEP for _, y in points]
    return tuple(round(each, 2) for each in (min(xs), min(ys), max(xs), max(ys)))  # type: ignore[return-value]


def driven(name: str) -> SimulatedRobot:
    return World(scene(name)).robot(pace=Unpaced())


@pytest.mark.parametrize("name", STEPS)
def test_every_step_of_the_chapter_loads_with_remarks_where_stage_fails(name: str) -> None:
    remarks = [note.code for note in scene(name).report.notes]

    if name in ("empty", "helloworld"):
        assert remarks == ["no-robot"]
    elif name in ("bigbob6", "bigbob7", "bigbob_oranges"):
        assert remarks == ["lone-sensor"]
    else:
        assert remarks == []


FILES = sorted(each.name for each in Path(worlds.MANUAL).iterdir() if each.suffix in (".world", ".cfg"))


@pytest.mark.parametrize("file", FILES)
def test_every_file_of_the_chapter_starts_a_session_with_a_robot_that_walks(
    file: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "walk.gd").write_text("FW 1", encoding="utf-8")
    options = ("--speed", "max", "--speech", "off", "--sound", "off", "--lang", "en")
    code = main(["run", str(tmp_path / "walk.gd"), "--world", str(Path(worlds.MANUAL, file)), *options])
    printed = capsys.readouterr()

    assert code == 0
    assert printed.out.endswith("I walked 1 step forward.\n")  # in a world of four robots after its name
    if file in ("empty.cfg", "empty.world", "helloworld.world"):
        assert "has no robot, so I put Donnie in, at " in printed.err
    else:
        assert printed.err == ""


def test_the_empty_world_is_a_cave_with_four_chambers_and_rock_in_the_middle() -> None:
    it = seen("empty")

    assert (it.left, it.bottom, it.width, it.height) == (-150, -150, 301, 301)
    assert letter("empty", 0, 0) == "#"
    assert {letter("empty", x, y) for x in (-75, 75) for y in (-75, 75)} == {"."}
    assert {letter("empty", x, y) for x, y in ((-75, 0), (75, 0), (0, 75), (0, -75))} == {"."}


def letter(name: str, x: int, y: int) -> str:
    cell = seen(name).at(x, y)
    assert cell is not None
    return seen(name).rows[cell[0]][cell[1]]


def test_the_two_words_are_walls_in_the_north_west_and_the_south_east() -> None:
    assert (seen("helloworld").width, seen("helloworld").height) == (241, 101)
    assert {letter("helloworld", x, 30) for x in range(-115, 0)} == {"#", "."}
    assert {letter("helloworld", x, 30) for x in range(80, 115)} == {"."}
    assert {letter("helloworld", x, -30) for x in range(-115, -80)} == {"."}


def test_the_body_without_a_size_is_as_small_as_stage_makes_it() -> None:
    assert extent(bob("bigbob1")) == (-4, -4, 4, 4)
    assert len(bob("bigbob1").polygons[0].points) == 6


def test_the_body_with_teeth_is_centred_on_its_box() -> None:
    assert extent(bob("bigbob2")) == (-12.5, -10, 12.5, 10)
    assert len(bob("bigbob2").polygons) == 3


@pytest.mark.parametrize("name", ["bigbob3", "bigbob_drive"])
def test_an_origin_of_three_numbers_moves_the_body_over_the_wheels(name: str) -> None:
    assert extent(bob(name)) == (-10, -10, 15, 10)


def test_poses_of_three_numbers_turn_the_four_robots() -> None:
    poses = [model.pose for model in scene("bigbob_yaws").models]

    assert [(p.x / STEP, p.y / STEP, p.z, p.yaw) for p in poses] == [
        (40, 40, 0, 0),
        (-40, 40, 0, 90),
        (-40, -40, 0, -45),
        (40, -40, 0, 200),
    ]


@pytest.mark.parametrize("name", ["bigbob1", "bigbob2", "bigbob3", "bigbob_drive"])
def test_a_body_without_sensors_can_be_driven(name: str) -> None:
    it = driven(name)
    it.forward(4)

    assert it.pose() == Pose(4, 0, 90)


@pytest.mark.parametrize("name", CAVE)
def test_bigbob_stands_free_in_the_cave_looks_north_east_and_sees_the_walls(name: str) -> None:
    """In Stage its sonars, a metre above the floor, look over the walls of half a metre."""
    it = driven(name)

    assert (it.pose(), it.stands_in) == (Pose(-100, -120, 45), ())
    it.turn(180)
    it.forward(4)
    assert 0 < it.distance(Bearing.FRONT) < 40


def test_bigbob_has_the_sensors_of_each_step_of_the_manual() -> None:
    sensors = {
        name: [(s.maximum, s.samples) for model in scene(name).models for s in model.sensors] for name in CAVE
    }

    assert sensors["bigbob4"] == sensors["bigbob5"] == [(2.0, 1)] * 4
    assert sensors["bigbob6"] == sensors["bigbob7"] == [(2.0, 1)] * 4 + [(0.25, 180)]
    assert driven("bigbob4").colours == set()
    assert driven("bigbob5").colours == driven("bigbob7").colours == {"orange", "blue"}


def test_oranges_and_cartons_lie_where_the_manual_puts_them() -> None:
    few = {each.name: (each.x, each.y, each.colour) for each in seen("bigbob_oranges").things}
    many = {each.name: (each.x, each.y) for each in seen("bigbob7").things}

    assert few == {"orange1": (-40, -100, "orange"), "carton1": (-60, -100, "blue")}
    assert [many[f"orange{i}"] for i in range(1, 5)] == [(-20, -100), (-40, -100), (-60, -100), (-80, -100)]
    assert [many[f"carton{i}"] for i in range(1, 5)] == [(-40, -80), (-40, -60), (-40, -40), (-40, -20)]
    assert {letter("bigbob7", round(x), round(y)) for x, y in many.values()} == {"r", "c"}
