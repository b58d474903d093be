"""Models of a world are put elsewhere or taken out in its text; all else stays as it was written."""

import re
from itertools import combinations
from math import hypot, pi
from pathlib import Path

import pytest

from sim.geometry import Placement
from sim.worldfile import load_text, put_elsewhere, taken_out, written_models
from sim.worldfile.edit import in_units, scattered, self_contained, units_of

PATH = Path("it.world")
TEXT = """\
# a comment ( with a bracket
define box model ( size [ 0.1 0.1 0.1 ] pose [ 9 9 0 0 ] )
define bob position ( ranger ( sensor ( pose [ 0.1 0 0 0 ] ) ) )

box( name "a" pose [ 1 2 0 0 ] color "red" ) box( name "b) pose [ 8 8 0 0 ]" )  # two on a line
model
(
  name "tower"
  # pose [ 5 5 0 0 ]
  model( pose [ 0.5 0 0 0 ] )
)
bob( name "bob" pose [
  0 0
  0 90 ] )
"""


def roots(text: str) -> dict[str, Placement]:
    scene = load_text(text, PATH)
    return {each.name: each.pose for each in scene.models if each.parent is None}


@pytest.mark.parametrize("number", range(4))
def test_a_model_is_put_elsewhere_and_no_other_one_moves(number: int) -> None:
    before = roots(TEXT)
    name = list(before)[number]

    text = put_elsewhere(TEXT, written_models(TEXT, PATH)[number], Placement(3, -4.25, 0, 45))

    after = roots(text)
    assert after.pop(name) == Placement(3, -4.25, before[name].z, 45)
    assert after == {each: pose for each, pose in before.items() if each != name}
    assert "# a comment ( with a bracket" in text
    assert "# two on a line" in text


@pytest.mark.parametrize("number", range(4))
def test_a_model_is_taken_out_and_the_others_stay(number: int) -> None:
    before = roots(TEXT)
    gone = list(before)[number]

    text = taken_out(TEXT, written_models(TEXT, PATH)[number])

    assert roots(text) == {each: pose for each, pose in before.items() if each != gone}


@pytest.mark.parametrize(
    ("text", "there"),
    [
        ('box( pose [ 9 9 0 0 ] name "a" )', 'box( pose [ 1.5 -2 0 90 ] name "a" )'),
        ("box( pose[9 9 9]mass 1 )", "box( pose[ 1.5 -2 0 90 ]mass 1 )"),
        ('box( name "a" )', 'box( name "a" pose [ 1.5 -2 0 90 ] )'),
        ('box( name "a")', 'box( name "a" pose [ 1.5 -2 0 90 ] )'),
        ("box()", "box( pose [ 1.5 -2 0 90 ] )"),
        ("# one\nbox(\n)", "# one\nbox(\npose [ 1.5 -2 0 90 ] )"),
    ],
)
def test_a_pose_is_written_where_it_was_or_at_the_end(text: str, there: str) -> None:
    definition = "define box model ( )\n"
    (model,) = written_models(definition + text, PATH)

    assert model is not None
    assert put_elsewhere(definition + text, model, Placement(1.5, -2, 0, 90)) == definition + there


def test_a_pose_is_written_in_the_units_of_its_file() -> None:
    text = 'unit_length "cm" unit_angle "radians"\nmodel( )\n'
    (model,) = written_models(text, PATH)
    units = units_of(load_text(text, PATH))

    assert model is not None
    assert put_elsewhere(text, model, Placement(1.25, -0.5, 2, 90), units).splitlines()[1] == (
        "model( pose [ 125 -50 200 1.5708 ] )"
    )
    assert units_of(load_text("model( )", PATH)) == (1, 1)
    assert units_of(load_text('unit_length "mile" unit_angle "gon" model( )', PATH)) == (1, 1)


@pytest.mark.parametrize(
    ("text", "without"),
    [
        ("a( )\nbox( )\na( )\n", "a( )\na( )\n"),
        ("a( )\n  box( )  \na( )", "a( )\na( )"),
        ("a( )\nbox( )", "a( )\n"),
        ("box( )\na( )", "a( )"),
        ("a( ) box( )\na( )", "a( ) \na( )"),
        ("a( )\nbox( ) a( )", "a( )\n a( )"),
        ("a( )\nbox( ) # red\n", "a( )\n # red\n"),
    ],
)
def test_the_line_of_a_model_goes_with_it_if_nothing_else_is_there(text: str, without: str) -> None:
    definitions = "define a model ( )\ndefine box model ( )\n"
    text = definitions + text
    model = next(each for each in written_models(text, PATH) if each and text[each.begin] == "b")

    assert taken_out(text, model) == definitions + without


@pytest.mark.parametrize(
    ("text", "converted"),
    [
        ("size [ 1 0.5 2 ]", "size [ 100 50 200 ]"),
        ("pose [ -1 2 0 90 ]", "pose [ -100 200 0 1.57079633 ]"),
        ("bpose[0] [ 0.1 0 0 180 ]", "bpose[0] [ 10 0 0 3.14159265 ]"),
        (
            "velocity_bounds [ -1 1 0 0 0 0 -90 90 ]",
            "velocity_bounds [ -100 100 0 0 0 0 -1.57079633 1.57079633 ]",
        ),
        ("range [ 0 3 ] fov 60 samples 5", "range [ 0 300 ] fov 1.04719755 samples 5"),
        ("range 5 blength 0.1 blength[2] 0.2", "range 500 blength 10 blength[2] 20"),
        ("color_rgba [ 1 0 0 1 ] obstacle_return 1", "color_rgba [ 1 0 0 1 ] obstacle_return 1"),
    ],
)
def test_lengths_and_angles_are_written_in_other_units(text: str, converted: str) -> None:
    """Centimetres and radians: a radian has 180 / pi degrees."""
    assert in_units(text, 0.01, 180 / pi) == converted
    assert in_units(text, 1, 1) == text


def test_a_model_of_an_included_file_is_not_written_here(tmp_path: Path) -> None:
    (tmp_path / "more.inc").write_text('model( name "there" )', encoding="utf-8")
    text = 'include "more.inc"\nmodel( name "here" )\n'

    there, here = written_models(text, tmp_path / "it.world")

    assert there is None
    assert here is not None
    assert text[here.begin : here.end] == 'model( name "here" )'


def test_only_what_is_included_or_drawn_is_written_into_a_world_elsewhere(tmp_path: Path) -> None:
    here, there = tmp_path / "here", tmp_path / "there"
    here.mkdir()
    there.mkdir()
    for name, text in (("part.inc", "model( )"), ("plan.png", "")):
        (here / name).write_text(text, encoding="utf-8")
    text = 'include "part.inc"\nmodel( bitmap "plan.png" name "part.inc" color "plan.png" )'

    found = self_contained(text, here / "it.world", there / "it.world", (), lambda path: f"new-{path.name}")

    expected = '\nmodel( )\n\nmodel( bitmap "new-plan.png" name "part.inc" color "plan.png" )'
    assert found == expected


@pytest.mark.parametrize(
    ("after", "kept"),
    [
        (" ; no word\nmodel( )", "\nmodel( )"),
        (";model( )", ""),
        (' model( name "x" )', ' model( name "x" )'),
        ("", ""),
    ],
)
def test_what_follows_an_include_in_its_line_is_written_if_it_begins_a_word(
    after: str, kept: str, tmp_path: Path
) -> None:
    (tmp_path / "part.inc").write_text("model( )", encoding="utf-8")
    text = f'include "part.inc"{after}'
    there = tmp_path / "there" / "it.world"

    found = self_contained(text, tmp_path / "it.world", there, (), lambda path: path.name)

    assert found == f"\nmodel( )\n{kept}"


def test_a_file_that_is_gone_is_named_as_before(tmp_path: Path) -> None:
    text = 'include "gone.inc"\nmodel( bitmap "gone.png" )'
    there = tmp_path / "there" / "it.world"

    assert self_contained(text, tmp_path / "it.world", there, (), lambda path: path.name) == text


# --- things that a seed scatters

ROOM = """define bob position ( size [ 0.2 0.1 0.1 ] ranger ( sensor ( ) ) )
bob ( name "bob" )
define wall model ( )
"""
BOX = 'model ( name "{}" size [ {} {} 0.1 ] pose [ {} {} 0.3 30 ] )\n'


def scattered_roots(
    things: str, seed: int, area: str = "-1 -1 1 1", room: str = ROOM
) -> dict[str, Placement]:
    text = f"scatter [ {area} ]\n{room}{things}"
    return roots(scattered(text, load_text(text, PATH), PATH, (), seed))


@pytest.mark.parametrize(
    ("thing", "moves"),
    [
        (BOX.format("it", 0.1, 0.1, 0.97, 0.97), True),
        (BOX.format("it", 0.1, 0.1, 1, -1), True),
        (BOX.format("it", 0.1, 0.1, -1, 1), True),
        (BOX.format("it", 0.1, 0.1, 1.01, 0), False),
        (BOX.format("it", 0.1, 0.1, -1.01, 0), False),
        (BOX.format("it", 0.1, 0.1, 0, 1.01), False),
        (BOX.format("it", 0.1, 0.1, 0, -1.01), False),
        (BOX.format("it", 0.1, 0.1, 0.97, 0.97).replace("model", "wall"), False),
        (BOX.format("it", 1.9, 1.9, 0.97, 0.97), False),  # it has no place there
    ],
)
@pytest.mark.parametrize("area", ["-1 -1 1 1", "1 1 -1 -1"])
def test_the_things_in_the_rectangle_are_scattered_and_nothing_else(
    thing: str, moves: bool, area: str
) -> None:
    (text,) = (re.findall(r"pose \[ (\S+) (\S+)", thing),)
    here = tuple(map(float, text[0]))
    places = [scattered_roots(thing, seed, area) for seed in (1, 2, 3)]

    assert [(each["it"].x, each["it"].y) != here for each in places] == [moves] * 3
    assert {(each["it"].z, each["it"].yaw) for each in places} == {(0.3, 30)}
    assert {(each["bob"].x, each["bob"].y) for each in places} == {(0, 0)}


def test_the_same_seed_puts_things_to_the_same_places_and_another_elsewhere() -> None:
    one, again, other = (scattered_roots(BOX.format("it", 0.1, 0.1, 0.9, 0.9), seed) for seed in (1, 1, 2))

    assert one == again != other


def test_a_part_of_a_thing_stays_with_it_and_an_included_thing_where_it_is(tmp_path: Path) -> None:
    (tmp_path / "more.inc").write_text(BOX.format("theirs", 0.1, 0.1, 0.5, 0.5), encoding="utf-8")
    part = BOX.format("it", 0.1, 0.1, 0.9, 0.9)[:-2] + 'model ( name "lid" pose [ 0 0 0 0 ] ) )\n'
    text = f'scatter [ -1 -1 1 1 ]\n{ROOM}include "more.inc"\n{part}'
    path = tmp_path / "it.world"
    there = load_text(scattered(text, load_text(text, path), path, (), 1), path)
    found = {each.name: (each.pose.x, each.pose.y) for each in there.models}

    assert found["theirs"] == (0.5, 0.5)
    assert found["it"] == found["lid"] != (0.9, 0.9)


@pytest.mark.parametrize("seed", range(1, 13))
@pytest.mark.parametrize("bob", [(0, 0), (1.5, -1)])
def test_scattered_things_leave_room_for_the_robot_and_a_straight_way_to_each(
    seed: int, bob: tuple[float, float]
) -> None:
    """15 cm between things, and 30 more around the robot, whose half is 10 cm and which is in a corner."""
    halves = {"a": 0.05, "b": 0.05, "c": 0.1, "d": 0.15}
    east, north = bob
    room = ROOM.replace('"bob" )', f'"bob" pose [ {east} {north} 0 0 ] )')
    boxes = "".join(
        BOX.format(name, 2 * half, half, east + 0.5, north + 0.5) for name, half in halves.items()
    )
    area = f"{east - 0.3} {north - 0.3} {east + 1.6} {north + 1.6}"
    found = scattered_roots(boxes, seed, area, room)
    places = {name: (found[name].x - east, found[name].y - north) for name in halves}

    for name, (x, y) in places.items():
        half = halves[name]
        assert -0.3 + half - 0.026 <= min(x, y) <= max(x, y) <= 1.6 - half + 0.026
        assert (x / 0.05, y / 0.05) == pytest.approx((round(x / 0.05), round(y / 0.05)), abs=1e-3)
        assert hypot(x, y) >= 0.1 + half + 0.3 + 0.15 - 1e-6
    for one, other in combinations(places, 2):
        (near, (ax, ay)), (_, (bx, by)) = sorted(
            ((name, places[name]) for name in (one, other)), key=lambda each: hypot(*each[1])
        )
        away = hypot(bx, by)
        assert hypot(ax - bx, ay - by) >= halves[one] + halves[other] + 0.15 - 1e-6
        ahead, aside = (ax * bx + ay * by) / away, abs(ax * by - ay * bx) / away
        assert ahead <= 0 or aside >= halves[near] + 0.1 + 0.15 - 1e-6


def test_in_a_line_of_floor_only_one_thing_has_a_straight_way() -> None:
    """The others would be in its way, or it in theirs, and stay where they are."""
    boxes = "".join(BOX.format(name, 0.1, 0.1, 2, 0) for name in "ab")
    found = scattered_roots(boxes, 1, "0 -0.1 3 0.1")
    behind = scattered_roots(boxes, 1, "-3 -0.1 3 0.1")

    assert [found[name].x == 2 for name in "ab"] == [False, True]
    assert sorted(behind[name].x > 0 for name in "ab") == [False, True]  # one on each side of the robot


def test_without_a_robot_things_need_only_be_apart() -> None:
    text = "scatter [ 0 -0.1 3 0.1 ]\n" + "".join(BOX.format(name, 0.1, 0.1, 2, 0) for name in "ab")
    found = roots(scattered(text, load_text(text, PATH), PATH, (), 1))

    assert 2 not in (found["a"].x, found["b"].x)
    assert abs(found["a"].x - found["b"].x) >= 0.25 - 1e-6
