"""The scene as a grid of letters and a list of things."""

from math import hypot
from pathlib import Path

import pytest

from sim.picture import Thing, drawings, picture
from sim.worldfile import load_text
from tests.unit.sim.floors import IDEAL, scene

ROBOT = IDEAL + 'ideal( name "donnie" pose [ 0 0 0 90 ] )'
HALL = 'model( name "hall" boundary 1 size [ 1.5 1 1 ] pose [ 0.25 0.1 0 0 ] )'


def test_a_thing_is_listed_with_its_place_and_size_in_steps() -> None:
    it = picture(
        scene(ROBOT + 'define crate model( color "red3" ) crate( name "old crate" pose [ 1 0.5 0 0 ] )')
    )

    assert it.things == (Thing("old crate", "crate", "C", "red", 20, 10, 8, 8),)


def test_a_thing_without_a_name_has_none() -> None:
    (thing,) = picture(scene(ROBOT + "model( pose [ 1 0 0 0 ] )")).things

    assert (thing.name, thing.kind) == ("", "model")


def test_a_thing_is_drawn_where_it_stands() -> None:
    it = picture(scene(ROBOT + "define crate model( size [ 0.15 0.05 1 ] ) crate( pose [ 0.5 0.25 0 0 ] )"))
    row, column = it.at(10, 5) or (-1, -1)

    assert it.rows[row][column - 2 : column + 3] == ".ccc."
    assert sum(line.count("c") for line in it.rows) == 3


def test_the_smallest_thing_has_a_cell() -> None:
    it = picture(scene(ROBOT + "thing( pose [ 0.524 0.26 0 0 ] )"))
    row, column = it.at(10.48, 5.2) or (-1, -1)

    assert it.rows[row][column] == "t"


def test_walls_are_drawn_around_a_room_and_cut_the_picture() -> None:
    it = picture(scene(ROBOT + HALL))

    assert (it.left, it.bottom, it.width, it.height, it.has_walls) == (-10, -8, 31, 21, True)
    assert it.rows[0] == it.rows[-1] == "#" * 31
    assert it.rows[9] == "#" + "." * 29 + "#"
    assert it.things == ()


@pytest.mark.parametrize(
    ("thing", "is_drawn_as_wall"),
    [
        ("define wall model( ) wall( pose [ 1 0 0 0 ] )", True),
        ('model( name "wall 3" pose [ 1 0 0 0 ] )', True),
        ("model( boundary 1 pose [ 1 0 0 0 ] )", True),
        ("model( size [ 1 1 1 ] pose [ 0.1 0.1 0 0 ] )", True),  # the robot is in its midst
        ("model( size [ 1 1 1 ] pose [ 0.1 2 0 0 ] )", False),  # the robot is south of it
        ("model( size [ 1 1 1 ] pose [ 2 0.1 0 0 ] )", False),
        ('define drywall model( ) drywall( name "a wall" pose [ 1 0 0 0 ] )', False),
        ('define opponent position( ) opponent( name "wall" pose [ 1 0 0 0 ] )', False),
    ],
)
def test_walls_are_what_is_named_so_and_what_has_the_robot_in_its_midst(
    thing: str, is_drawn_as_wall: bool
) -> None:
    it = picture(scene(ROBOT + thing))

    assert it.has_walls is is_drawn_as_wall
    assert len(it.things) == (not is_drawn_as_wall)


def test_each_kind_has_its_letter_and_none_has_that_of_trail_start_or_robot() -> None:
    kinds = ("apple", "armchair", "orange", "vase", "pot", "pan", "1")
    defined = "".join(f"define {kind} model( size [ 0.1 0.1 1 ] ) " for kind in kinds[:-1])
    stood = " ".join(f"{kind}( pose [ {i} 1 0 0 ] )" for i, kind in enumerate(kinds[:-1]))
    letters = [thing.letter for thing in picture(scene(ROBOT + defined + stood)).things]

    assert letters == ["p", "r", "n", "s", "t", "b"]


def test_large_things_have_capitals() -> None:
    text = ROBOT + "define bed model( size [ 0.4 0.1 1 ] ) define pot model( size [ 0.35 0.1 1 ] )"
    letters = [
        t.letter for t in picture(scene(text + "bed( pose [ 1 0 0 0 ] ) pot( pose [ -1 0 0 0 ] )")).things
    ]

    assert letters == ["B", "p"]


def test_other_robots_are_things_and_the_robot_itself_is_not() -> None:
    text = ROBOT + 'ideal( name "marvin" pose [ 1 1 0 0 ] color "green" )'

    assert [thing.name for thing in picture(scene(text)).things] == ["marvin"]
    assert [thing.name for thing in picture(scene(text), "marvin").things] == ["donnie"]


def test_marks_that_no_robot_can_touch_are_not_drawn() -> None:
    assert (
        picture(scene(ROBOT + "model( size [ 4 4 0.01 ] obstacle_return 0 pose [ 3 0 0 0 ] )")).things == ()
    )


@pytest.mark.parametrize("away", [10, 100, 5000])
def test_a_large_world_has_larger_cells(away: int) -> None:
    it = picture(scene(ROBOT + f"define crate model() crate( pose [ {away} {away / 2} 0 0 ] )"))
    row, column = it.at(away / 0.05, away / 0.1) or (-1, -1)

    assert max(it.width, it.height) <= 402
    assert len(it.rows) == it.height
    assert {len(line) for line in it.rows} == {it.width}
    assert it.rows[row][column] == "C"
    assert it.cell >= hypot(away, 0) / 0.05 / 402


def test_a_world_without_a_robot_and_without_anything_has_a_picture() -> None:
    it = picture(scene(""))

    assert (it.width, it.height) == (60, 60)


def test_a_thing_is_marked_as_a_robot_only_if_its_position_model_has_sensors() -> None:
    it = load_text(
        """
        define seeing position ( size [ 0.1 0.1 0.1 ] ranger( sensor( ) ) )
        seeing( name "me" )
        seeing( name "other" pose [ 1 0 0 -45 ] )
        position( name "sofa" pose [ 0 1 0 0 ] )
        """,
        Path("room.world"),
    )

    assert [(each.name, each.is_robot, each.heading) for each in picture(it).things] == [
        ("other", True, 135.0),
        ("sofa", False, 0.0),
    ]


def test_a_drawing_has_the_outlines_of_walls_things_and_all_robots() -> None:
    it = load_text(
        """
        define seeing position ( size [ 0.1 0.1 0.1 ] ranger( sensor( ) ) )
        define wall model ( size [ 1 0.05 0.2 ] )
        seeing( name "me" )
        wall( pose [ 0 1 0 0 ] )
        model( name "crate" size [ 0.1 0.2 0.2 ] pose [ 1 1 0 0 ] )
        """,
        Path("room.world"),
    )

    me, wall, crate = drawings(it)
    assert me.thing is not None
    assert (me.thing.name, me.thing.is_robot) == ("me", True)
    assert wall.thing is None
    assert crate.thing is not None
    assert crate.thing == picture(it).things[0]
    assert {(round(x, 6), round(y, 6)) for x, y in crate.outlines[0]} == {
        (19, 18),
        (21, 18),
        (21, 22),
        (19, 22),
    }
