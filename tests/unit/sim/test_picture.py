"""The scene as a grid of letters and a list of things."""

from math import atan2, degrees, hypot, inf
from pathlib import Path

import pytest
from msgspec.structs import replace
from PIL import Image

from devices.ports.robot import Pose
from sim.picture import Picture, Room, Thing, all_things, drawings, is_wall, picture
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


@pytest.mark.parametrize(
    ("x", "y", "cell"),
    [
        *((-3, 2, (1, 0)), (-3.1, 2, None), (4.9, 2, (1, 3)), (5, 2, None)),
        *((0, 5.9, (0, 1)), (0, 6, None), (0, 2, (1, 1)), (0, 1.9, None), (0, 4, (0, 1))),
    ],
)
def test_a_place_is_in_a_cell_or_outside(x: float, y: float, cell: tuple[int, int] | None) -> None:
    """Cells of 2 steps: from -3 to 5 and from 2 to 6."""
    assert Picture(-2, 3, 4, 2, 2, ("....", "...."), (), has_walls=False).at(x, y) == cell


def test_an_open_floor_is_shown_thirty_steps_around_the_robot_and_as_far_as_its_things() -> None:
    it = picture(scene(ROBOT))
    assert (it.left, it.bottom, it.width, it.height, it.cell) == (-30, -30, 60, 60, 1)

    wide = picture(scene(ROBOT + "thing( pose [ 2 -1.8 0 0 ] )"))
    assert (wide.left, wide.bottom, wide.width, wide.height) == (-30, -36, 71, 66)


def box(left: float, bottom: float, right: float, top: float) -> tuple[tuple[float, float], ...]:
    return ((left, bottom), (right, bottom), (right, top), (left, top))


def standing(heading: float, *walls: tuple[tuple[float, float], ...]) -> Room:
    """A robot of 2 by 1 steps, at 1, 1."""
    floor = Picture(0, 0, 9, 9, 1, ("." * 9,) * 9, (), True, walls, (box(-1, -0.5, 1, 0.5),))
    return Room(floor, Pose(1, 1, heading))


@pytest.mark.parametrize(
    ("heading", "wall", "gap", "towards"),
    [
        (90, box(5, 0, 6, 2), 3, 90),
        (0, box(5, 0, 6, 2), 3.5, 90),
        (0, box(0, 5, 2, 6), 3, 0),
        (180, box(0, -6, 2, -5), 5, 180),
        (90, box(5, 4.5, 6, 6), 18**0.5, degrees(atan2(4, 3.5))),  # 3 east and 3 north of the body
    ],
)
def test_the_nearest_edge_of_a_thing_has_its_gap_and_its_heading(
    heading: float, wall: tuple[tuple[float, float], ...], gap: float, towards: float
) -> None:
    found = standing(heading).nearest([wall])

    assert found == (
        pytest.approx(4.2426 if towards == 48.814 else gap, abs=1e-3),
        pytest.approx(towards, abs=1e-3),
    )


def test_a_robot_can_be_moved_until_it_touches() -> None:
    there = standing(0, box(5, 0, 6, 2), box(0, 5, 2, 6), box(-9, -9, 9, 9))

    assert len(there.walls) == 2  # the third one is around its middle
    assert [there.ahead(there.walls, heading) for heading in (0, 90, 180)] == [3, 3.5, float("inf")]
    assert standing(90).ahead([box(5, 0, 6, 2)], 90) == 3
    assert (Room.whole(2.89), Room.whole(2.9), Room.whole(0.5)) == (2, 3, 0)


def test_kinds_without_a_free_letter_share_one() -> None:
    many = " ".join(f"define q{'q' * at} model( ) q{'q' * at}( pose [ {at} 9 0 0 ] )" for at in range(30))
    letters = [each.letter.lower() for each in picture(scene(ROBOT + many)).things]

    assert letters[0] == "q"
    assert letters[-1] == letters[-2] == "x"
    assert len(set(letters)) == 23  # without a, o and v


@pytest.mark.parametrize(("x", "cell", "width"), [(370, 1, 401), (371, 2, 202), (770, 2, 401), (771, 3, 268)])
def test_a_picture_has_four_hundred_cells_and_one_along_a_side_at_most(x: int, cell: int, width: int) -> None:
    """It begins 30 steps before the robot."""
    it = picture(scene(ROBOT + f"thing( pose [ {x * 0.05} 0 0 0 ] )"))

    assert (it.left, it.cell, it.width) == (-30, cell, width)


@pytest.mark.parametrize(
    ("kind", "end", "cells"),
    [("wall", 10.51, 1), ("wall", 10.53, 2), ("crate", 10.79, 1), ("crate", 10.81, 2), ("crate", 11.79, 2)],
)
def test_walls_mark_what_they_touch_and_things_what_they_fill_well(kind: str, end: float, cells: int) -> None:
    """It begins at the western edge of the cell 10."""
    width, middle = (end - 9.5) * 0.05, (end + 9.5) / 2 * 0.05
    text = f"define {kind} model( size [ {width} 0.05 1 ] ) {kind}( pose [ {middle} 0.25 0 0 ] )"
    it = picture(scene(ROBOT + text))
    row, column = it.at(10, 5) or (-1, -1)
    letter = "#" if kind == "wall" else "c"

    assert it.rows[row][column - 1 : column + 4].rstrip(".") == f".{letter * cells}"


def test_a_thing_is_drawn_over_a_wall() -> None:
    crate = "define crate model( size [ 0.1 0.1 1 ] ) crate( pose [ 0.5 0 0 0 ] )"
    text = crate + 'model( name "wall" size [ 0.1 2 1 ] pose [ 0.5 0 0 0 ] )'
    it = picture(scene(ROBOT + text))
    row, column = it.at(10, 0) or (-1, -1)

    assert (it.rows[row][column], it.rows[row - 5][column]) == ("c", "#")


def test_the_body_of_a_robot_is_in_steps_around_its_middle_without_the_paddles_of_its_gripper() -> None:
    gripper = "gripper( size [ 0.2 0.2 0.1 ] pose [ 0.2 0 0 0 ] paddle_size [ 0.5 0.1 1 ] )"
    it = picture(scene(f"position( size [ 0.2 0.1 0.1 ] pose [ 5 5 0 90 ] ranger( sensor( ) ) {gripper} )"))
    boxes = [
        tuple(round(side, 6) for axis in zip(*each, strict=True) for side in (min(axis), max(axis)))
        for each in it.body
    ]

    assert sorted(boxes) == [(-2, 2, -1, 1), (2, 4, -2, 2)]
    assert picture(scene("model( )")).body == ()


def test_a_picture_knows_walls_outlines_and_what_is_from_a_bitmap(tmp_path: Path) -> None:
    Image.new("1", (2, 2)).save(tmp_path / "plan.png")
    text = (
        ROBOT
        + 'model( name "plan" bitmap "plan.png" size [ 1 1 1 ] pose [ 3 0 0 0 ] ) box( pose [ 1 0 0 0 ] )'
    )
    it = load_text(text, tmp_path / "t.world")

    assert [(each.from_bitmap, each.thing and each.thing.name) for each in drawings(it)] == [
        *((False, "donnie"), (True, "plan"), (False, "")),
    ]
    assert picture(it).walls == ()
    (wall,) = picture(scene(ROBOT + 'model( name "wall" size [ 0.1 0.2 1 ] pose [ 1 2 0 0 ] )')).walls
    assert {(round(x, 6), round(y, 6)) for x, y in wall} == {(19, 38), (21, 38), (21, 42), (19, 42)}


def test_a_robot_among_things_is_where_it_turns_and_has_the_letter_of_its_kind() -> None:
    """Its shape is 4 steps ahead of that place."""
    text = "define bot position( size [ 0.1 0.1 0.1 ] origin [ 0.2 0 0 0 ] ranger( sensor( ) ) )"
    bots = 'bot( name "a" pose [ 0 0 0 30 ] ) bot( name "b" pose [ 1 2 0 0 ] )'
    it = scene(f"{text} {bots} model( pose [ 3 0 0 0 ] )")
    a, b, other = all_things(it)

    assert [(each.letter, each.is_robot, each.heading) for each in (a, b, other)] == [
        *(("b", True, 60), ("b", True, 90), ("M", False, 0)),
    ]
    assert (b.x, b.y, b.width, b.depth, b.index) == (20, 40, 2, 2, it.robots[1])
    assert a != b
    assert b == replace(b, index=99, outlines=())
    assert hash(b) == hash(replace(b, index=99))
    (alone,) = all_things(scene(ROBOT))
    assert alone.letter == "x"


@pytest.mark.parametrize(
    ("name", "is_drawn_as_wall"),
    [
        ("wall", True),
        ("Walls", True),
        ("floorplan", True),
        ("roomy", True),
        ("mapX", True),
        ("amap", False),
        ("floor", False),
    ],
)
def test_a_kind_that_begins_with_a_word_for_walls_is_one(name: str, is_drawn_as_wall: bool) -> None:
    text = f"define {name} model( size [ 0.1 0.1 1 ] ) {name}( pose [ 1 0 0 0 ] )"

    assert picture(scene(ROBOT + text)).has_walls is is_drawn_as_wall


@pytest.mark.parametrize(
    ("x", "y", "is_drawn_as_wall"),
    [(0.49, 0, True), (0.5, 0, False), (-0.5, 0, False), (0, 0.49, True), (0, 0.5, False), (0, -0.5, False)],
)
def test_what_is_around_the_robot_is_a_wall_and_what_it_stands_at_the_edge_of_is_none(
    x: float, y: float, is_drawn_as_wall: bool
) -> None:
    it = scene(ROBOT + f"model( size [ 1 1 1 ] pose [ {x} {y} 0 0 ] )")
    me, other = it.models[it.robots[0]], it.models[-1]

    assert picture(it).has_walls is is_drawn_as_wall
    assert is_wall(other, me) is is_drawn_as_wall
    assert not is_wall(other, None)


def test_a_room_without_a_body_or_things_has_no_nearest_edge() -> None:
    floor = Picture(0, 0, 9, 9, 1, ("." * 9,) * 9, (), True)
    room = Room(floor, Pose(1, 1, 0))

    assert room.nearest([]) == (inf, 90.0)
    assert room.nearest([box(5, 0, 6, 2)]) == (pytest.approx(4), pytest.approx(90))
    assert room.ahead([box(5, 0, 6, 2)], 90) == pytest.approx(4)
