"""The worlds that come with Donnie load, are described in three languages, and Stage can read them."""

import re
from pathlib import Path

import pytest

import worlds.words
from devices.ports.robot import Bearing, Pose, StoppedBy
from donnie_tui.settings.settings import Settings
from sim.picture import picture
from sim.robot import SimulatedRobot
from sim.scene import Scene
from sim.world import World
from sim.worldfile import load_world
from tests.unit.sim.floors import Unpaced


def scene(name: str) -> Scene:
    return load_world(Path(worlds.path(name)), allowed=(Path(worlds.SCENES),))


def donnie(name: str) -> SimulatedRobot:
    return World(scene(name)).robot(pace=Unpaced())


def test_the_room_of_the_first_lesson_is_offered_first_and_is_where_a_start_begins() -> None:
    assert worlds.names()[:3] == ("first_room", "open_floor", "living_room")
    assert Settings().world == "first_room"


def test_something_is_within_five_steps_of_the_start_of_the_first_room() -> None:
    assert min(round(each.steps) for each in donnie("first_room").scan()) <= 5


def test_an_unknown_world_is_a_key_error() -> None:
    with pytest.raises(KeyError):
        worlds.path("moon")
    with pytest.raises(KeyError):
        worlds.path("../scenes/open_floor")
    with pytest.raises(KeyError):
        worlds.words.about("moon", "en")


@pytest.mark.parametrize("name", worlds.names())
@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_every_world_is_described_in_every_language(name: str, language: str) -> None:
    about = worlds.words.about(name, language)

    assert all(len(words) > 3 for words in (about.title, about.description, about.task))


@pytest.mark.parametrize("name", worlds.names())
def test_no_language_repeats_another(name: str) -> None:
    descriptions = {worlds.words.about(name, language).description for language in ("en", "pt", "es")}

    assert len(descriptions) == 3


@pytest.mark.parametrize("name", worlds.scenarios())
def test_every_scenario_loads_without_a_remark_and_starts_at_the_origin_facing_north(name: str) -> None:
    it = scene(name)

    assert it.report.notes == ()
    robot = World(it).robot(pace=Unpaced())
    assert (robot.pose(), robot.stands_in) == (Pose(0, 0, 0), ())
    assert robot.name == {"two_robots": "alice", "factory": "bob"}.get(name, "donnie")


def test_donnie_distinguishes_seven_colours() -> None:
    assert donnie("open_floor").colours == {"red", "green", "blue", "yellow", "orange", "pink", "gray"}


STAGE_LINE = re.compile(
    r"""\s*(?:[A-Za-z][\w.\-\[\]]*(?=\s*[("\[\d.+\-]|\s+[A-Za-z]|\s*$)|"[^"]*"|[+-]?\d*\.?\d+(?=[\s\])]|$)
    |(?<=\s)\[|\]|\(|\))""",
    re.VERBOSE,
)


@pytest.mark.parametrize(
    "file", sorted(Path(worlds.SCENES).glob("*.world")) + sorted(Path(worlds.SCENES).glob("*.inc"))
)
def test_every_file_uses_only_what_stage_can_read(file: Path) -> None:
    """A blank before ``[``, tuples on one line without comments, no exponents, no three-number poses."""
    for line in file.read_text(encoding="utf-8").splitlines():
        code = line.split("#")[0].rstrip()
        bare = re.sub(r'"[^"]*"', '""', code)
        assert bare.count("[") == bare.count("]")
        assert not re.search(r"\d[eE][+-]?\d", bare)
        assert not re.search(r"[^\s\w]\[|[a-z]\[(?!\d+\])", bare)
        for numbers in re.findall(r"\b(?:pose|origin|bpose\[\d\])\s+\[([^]]*)\]", bare):
            assert len(numbers.split()) == 4
        for numbers in re.findall(r"\bsize\s+\[([^]]*)\]", bare):
            assert len(numbers.split()) == 3
        position = 0
        while position < len(code):
            match = STAGE_LINE.match(code, position)
            assert match, (line, position)
            position = match.end()


def test_the_colour_list_is_as_long_as_it_says() -> None:
    text = (Path(worlds.SCENES) / "donnie.inc").read_text(encoding="utf-8")
    (count,) = re.findall(r"colors_count (\d+)", text)
    (names,) = re.findall(r"colors \[([^]]*)\]", text)

    assert len(names.split()) == int(count)


def test_donnie_is_built_as_specified() -> None:
    it = scene("open_floor")
    body = it.models[it.robots[0]]

    assert body.size == (0.128, 0.128, 0.12)
    assert len(body.polygons[0].points) == 8
    sonars = [sensor for model in it.tree(body.index) for sensor in model.sensors]
    assert {(s.minimum, s.maximum, s.fov) for s in sonars} == {(0.02, 3.0, 15.0)}
    assert [s.pose.yaw for s in sonars] == [0, -45, 45, 180, -135, 135, 0]


def test_on_the_open_floor_nothing_is_in_the_way() -> None:
    it = donnie("open_floor")

    assert it.backward(30).walked == 30
    assert it.forward(60).pose == Pose(0, 30, 0)
    assert [it.distance(bearing) for bearing in Bearing] == [60] * 6
    assert it.scan() == ()


def test_in_the_living_room_donnie_meets_walls_and_sees_furniture() -> None:
    it = donnie("living_room")

    assert it.forward(1).walked == 1
    assert {(s.name, s.colour) for s in it.scan()} == {
        ("small sofa", "blue"),
        ("large sofa", "blue"),
        ("table", "red"),
        ("chair 1", "green"),
        ("chair 2", "green"),
    }
    assert it.backward(40).stopped_by is StoppedBy.OBSTACLE
    assert it.forward(60).stopped_by is StoppedBy.OBSTACLE
    it.turn(90)
    assert it.forward(60).stopped_by is not None


def test_the_living_room_is_forty_by_forty_steps() -> None:
    it = picture(scene("living_room"))

    assert (it.left, it.bottom, it.width, it.height, it.cell) == (-4, -4, 42, 42, 1)
    assert it.rows[0] == it.rows[-1] == "#" * 42
    assert {row[0] + row[-1] for row in it.rows} == {"##"}
    assert {(t.name, t.letter, t.colour, t.width, t.depth) for t in it.things} == {
        ("small sofa", "s", "blue", 5, 5),
        ("large sofa", "L", "blue", 10, 5),
        ("table", "T", "red", 5, 10),
        ("chair 1", "c", "green", 3, 3),
        ("chair 2", "c", "green", 3, 3),
    }
    assert sum(row.count("T") for row in it.rows) == 50
    assert sum(row.count("c") for row in it.rows) == 18
    assert it.at(0, 0) == (37, 4)
    assert it.at(-10, 0) is None


def test_the_picture_of_an_open_floor_is_a_window_around_the_robot() -> None:
    it = picture(scene("open_floor"))

    assert (it.left, it.bottom, it.width, it.height, it.has_walls, it.things) == (-30, -30, 60, 60, False, ())
    assert set("".join(it.rows)) == {"."}
