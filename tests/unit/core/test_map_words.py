"""The map in words has all of the grid, names each thing once, and gives each letter one meaning."""

import re
from math import hypot
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

import worlds
from devices.ports.robot import Bearing, Pose
from donnie_tui.core.map_grid import FREE, MapGrid
from donnie_tui.core.map_words import (
    RANGE,
    Face,
    around_in_words,
    column_in_words,
    compass_point,
    compass_words,
    map_in_words,
    names_of_letters,
    picture_in_letters,
    row_in_words,
    square_in_words,
)
from donnie_tui.i18n.words import Words
from sim.picture import Picture, Thing, picture
from sim.world import World
from sim.worldfile import load_text, load_world
from tests.unit.sim.floors import Unpaced
from worlds.words import About, Difficulty

LANGUAGES = ("en", "pt", "es")
DETAILS = ("brief", "normal", "full")


def square(x: float, y: float) -> tuple[tuple[float, float], ...]:
    return ((x - 0.5, y - 0.5), (x + 0.5, y - 0.5), (x + 0.5, y + 0.5), (x - 0.5, y + 0.5))


def thing(letter: str, x: float, y: float, kind: str = "") -> Thing:
    kind = kind or {"c": "chair", "C": "chair", "t": "table"}[letter]
    return Thing("", kind, letter, "red", x, y, 1, 1, outlines=(square(x, y),))


BODY = ((-0.45, -0.45), (0.45, -0.45), (0.45, 0.45), (-0.45, 0.45))


def room(*rows: str, things: tuple[Thing, ...] = ()) -> Picture:
    """A floor of squares, and a robot that almost fills one."""
    walls = tuple(
        square(x, len(rows) - 1 - y)
        for y, row in enumerate(rows)
        for x, letter in enumerate(row)
        if letter == "#"
    )
    return Picture(0, 0, len(rows[0]), len(rows), 1, rows, things, bool(walls), walls, (BODY,))


@st.composite
def pictures(draw: st.DrawFn) -> Picture:
    width, height = draw(st.integers(1, 30)), draw(st.integers(1, 12))
    letters = st.sampled_from("..........###cCt")
    rows = tuple("".join(draw(letters) for _ in range(width)) for _ in range(height))
    left, bottom = draw(st.integers(-20, 20)), draw(st.integers(-20, 20))
    things = tuple(
        thing(letter, left + x, bottom + height - 1 - y)
        for y, row in enumerate(rows)
        for x, letter in enumerate(row)
        if letter in "cCt"
    )
    return Picture(left, bottom, width, height, 1, rows, things, "#" in "".join(rows))


def parsed(lines: tuple[str, ...], names: dict[str, str], robot: str) -> tuple[int, str]:
    """Where a row begins, and its letters, read back from the words."""
    letters = {name: letter for letter, name in names.items()} | {robot: "@"}
    letters |= dict.fromkeys(("livres", "libres"), letters[names["."]])
    said, begin = "", 0
    for line in lines:
        found = re.fullmatch(r"\w+ -?\d+, \w+ (-?\d+): (.*)\.", line)
        assert found is not None
        begin = int(found[1]) if not said else begin
        assert int(found[1]) == begin + len(said)
        for run in found[2].split(", "):
            count, _, name = run.partition(" ")
            said += int(count) * letters[name] if count.isdecimal() else letters[run]
    return begin, said


@given(pictures(), st.sampled_from(LANGUAGES), st.sampled_from(DETAILS), st.data())
def test_rows_and_columns_in_words_are_read_back_exactly(
    picture: Picture, language: str, detail: str, data: st.DataObject
) -> None:
    x = data.draw(st.integers(picture.left, picture.left + picture.width - 1))
    y = data.draw(st.integers(picture.bottom, picture.bottom + picture.height - 1))
    grid, words = MapGrid(picture, Pose(x, y, 0)), Words(language, detail)
    names = names_of_letters(picture, words)
    floor = [list(row) for row in picture.rows]
    floor[picture.height - 1 - (y - picture.bottom)][x - picture.left] = "@"
    for row in range(picture.height):
        said = row_in_words(grid, picture.bottom + row, words)
        assert parsed(said, names, words("cell-robot")) == (
            picture.left,
            "".join(floor[picture.height - 1 - row]),
        )
    for column in range(picture.width):
        said = column_in_words(grid, picture.left + column, words)
        letters = "".join(row[column] for row in reversed(floor))
        assert parsed(said, names, words("cell-robot")) == (picture.bottom, letters)


@given(pictures(), st.sampled_from(DETAILS), st.booleans(), st.booleans(), st.floats(0, 359))
def test_everything_in_range_is_named_exactly_once(
    picture: Picture, detail: str, absolute: bool, clock: bool, heading: float
) -> None:
    pose = Pose(picture.left, picture.bottom, heading)
    words = Words("en", detail)
    said = around_in_words(MapGrid(picture, pose), pose, words, compass=0 if absolute else None, clock=clock)
    near = [
        each
        for each in picture.things
        if hypot(*(max(0, abs(a - b) - 0.5) for a, b in ((each.x, pose.x), (each.y, pose.y)))) < RANGE + 0.9
    ]

    assert sum(" chair" in line or " table" in line for line in said) == len(near)
    assert said[0].startswith(f"{len(near)} thing" if near else "There is nothing")
    assert all(len(line) <= (40 if detail == "brief" else 80) for line in said)


ROOM = room("#######", "#..c..#", "#.....#", "#.....#", "#######", things=(thing("c", 3, 3),))


def test_around_begins_ahead_and_goes_clockwise() -> None:
    pose = Pose(3, 1, 0)

    assert around_in_words(MapGrid(ROOM, pose), pose, Words()) == (
        "1 thing within 10 steps.",
        "Ahead: chair, red, 1 step.",
        "Ahead: wall, 2 steps.",
        "Right: wall, 2 steps.",
        "Behind: wall, 0 steps.",
        "Left: wall, 2 steps.",
    )


def test_around_by_the_compass_begins_in_the_north_whatever_the_heading() -> None:
    pose = Pose(3, 1, 90)
    said = around_in_words(MapGrid(ROOM, pose), pose, Words(), compass=0)

    assert said[1] == "North: chair, red, 1 step."


@pytest.mark.parametrize(
    ("typed", "point"), [("east", 2), ("LESTE", 2), ("Este", 2), ("sur", 4), ("up", None)]
)
def test_the_points_of_the_compass_are_understood_in_three_languages(typed: str, point: int | None) -> None:
    assert compass_point(typed) == point


def test_around_begins_with_the_point_that_is_named() -> None:
    pose = Pose(3, 1, 0)
    by_north, by_east = (around_in_words(MapGrid(ROOM, pose), pose, Words(), compass=at) for at in (0, 2))
    sides = list(dict.fromkeys(line.split(":")[0] for line in by_east[1:]))

    assert sides == ["East", "South", "West", "North"]
    assert sorted(by_east) == sorted(by_north)


def test_a_wide_thing_is_in_the_direction_where_the_robot_would_meet_it() -> None:
    sofa = Thing("", "sofa", "S", "blue", 9, 4, 13, 2, outlines=(((2.5, 3), (15.5, 3), (15.5, 5), (2.5, 5)),))
    pose = Pose(3, 0, 0)

    said = around_in_words(MapGrid(room(*("." * 16,) * 6, things=(sofa,)), pose), pose, Words())

    assert said[:3] == (
        "1 thing within 10 steps.",
        "Ahead: sofa, blue, 2 steps.",
        "Right: free, 10 steps.",
    )


def test_a_direction_is_free_up_to_the_next_described_thing() -> None:
    long = thing("t", 0, 0)
    long = replace(long, outlines=(((-2.5, 5), (0.2, 5), (0.2, 5.2), (-2, 5.2), (-2, -1), (-2.5, -1)),))
    pose = Pose(0, 0, 0)

    said = around_in_words(MapGrid(room(*("." * 16,) * 6, things=(long,)), pose), pose, Words())

    assert said[1] == "Ahead: free, 4 steps."
    assert said[-1] == "Left: table, red, 1 step."


@pytest.mark.parametrize(
    ("right", "ahead"), [(0, "small sofa, blue"), (11, "large sofa, blue"), (30, "chair, green")]
)
@pytest.mark.parametrize("steps", [2, 40])
def test_around_and_the_sensors_agree(right: int, ahead: str, steps: int) -> None:
    """From the edge of the robot to the edge of the thing, in whole steps."""
    scene = load_world(Path(worlds.path("living_room")))
    robot = World(scene).robot(pace=Unpaced())
    robot.turn(90)
    robot.forward(right)
    robot.turn(-90)
    robot.forward(steps)
    pose, distance = robot.pose(), robot.distance(Bearing.FRONT)

    said = around_in_words(MapGrid(picture(scene), pose), pose, Words())

    assert said[1] == ("Ahead: free, 10 steps." if distance > 10 else f"Ahead: {ahead}, {distance} step.")


def test_a_floor_that_is_drawn_as_a_box_is_no_wall_around_the_robot_on_it() -> None:
    floor = ((2.5, 0.2), (5.5, 0.2), (5.5, 3.2), (2.5, 3.2))
    pose, seen = Pose(3, 1, 0), replace(ROOM, walls=(*ROOM.walls, floor))

    assert around_in_words(MapGrid(seen, pose), pose, Words()) == around_in_words(
        MapGrid(ROOM, pose), pose, Words()
    )


def test_around_on_a_clock_face_names_the_hours() -> None:
    pose = Pose(3, 1, 90)
    said = around_in_words(MapGrid(ROOM, pose), pose, Words(), clock=True)

    assert said[1:3] == ("12 o'clock: wall, 2 steps.", "3 o'clock: wall, 0 steps.")
    assert "9 o'clock: chair, red, 1 step." in said
    in_portuguese = around_in_words(MapGrid(ROOM, pose), pose, Words("pt", "full"), clock=True)
    assert any(line.startswith("À 1 hora: ") for line in in_portuguese)


def test_a_free_direction_is_described_as_free() -> None:
    picture = Picture(-30, -30, 61, 61, 1, ("." * 61,) * 61, (), False)
    pose = Pose(0, 0, 0)

    assert around_in_words(MapGrid(picture, pose), pose, Words("pt")) == (
        "Nenhum objeto a 10 passos ou menos.",
        "À frente: livre, 10 passos.",
        "À direita: livre, 10 passos.",
        "Atrás: livre, 10 passos.",
        "À esquerda: livre, 10 passos.",
    )


def test_a_square_is_described_with_its_place_from_the_robot() -> None:
    pose = Pose(1, 1, 0)

    assert square_in_words(MapGrid(ROOM, pose), 3, 3, pose, Words()) == "3, 3: chair. 2 right, 2 ahead."
    assert square_in_words(MapGrid(ROOM, pose), 1, 1, pose, Words("es")) == "1, 1: Donnie. aquí."


def test_no_square_behind_the_walls_is_called_free() -> None:
    pose = Pose(1, 1, 0)
    endless = replace(ROOM, has_walls=False)

    assert (
        square_in_words(MapGrid(ROOM, pose), 900, 1, pose, Words("pt"))
        == "900, 1: fora do mundo. 899 à direita."
    )
    said = square_in_words(MapGrid(endless, pose), 900, 1, pose, Words())
    assert said == "900, 1: beyond the map. 899 right."
    assert square_in_words(MapGrid(endless, pose), 2, 1, pose, Words()) == "2, 1: free. 1 right."


def test_a_missing_row_is_reported_with_the_existing_rows() -> None:
    assert row_in_words(MapGrid(ROOM, Pose(1, 1, 0)), 9, Words()) == ("No row 9. Rows go from 0 to 4.",)
    assert column_in_words(MapGrid(ROOM, Pose(1, 1, 0)), -1, Words()) == (
        "No column -1. They go from 0 to 6.",
    )


@pytest.mark.parametrize("free", [FREE, "f"])
def test_the_picture_begins_with_its_legend_and_has_one_letter_per_square(free: str) -> None:
    said = picture_in_letters(MapGrid(ROOM, Pose(1, 1, 0)), Words(), free)

    assert said[:4] == ("Picture, 7 by 5. The robot is ^", "Wall: #", f"Free: {free}", "Chair: c")
    assert said[4:] == tuple(
        row.replace(".", free) for row in ("#######", "#..c..#", "#.....#", "#^....#", "#######")
    )


def test_a_picture_of_a_part_names_the_part() -> None:
    rows = ("." * 50,) * 30
    picture = Picture(0, 0, 50, 30, 1, rows, (), True)
    said = picture_in_letters(MapGrid(picture, Pose(10, 10, 0)), Words())

    assert said[1:3] == (
        "Only a part: x 0 to 39, y 1 to 18.",
        "The whole map: x 0 to 49, y 0 to 29. MAP ROW says the rest.",
    )


def test_two_letters_never_have_the_same_words() -> None:
    picture = Picture(0, 0, 2, 1, 1, ("cC",), (thing("c", 0, 0), thing("C", 1, 0)), False)

    assert names_of_letters(picture, Words())["C"] == "chair C"


def test_letters_of_the_picture_are_distinct_without_capitals() -> None:
    """In six dots a capital letter looks like a small one."""
    picture = Picture(0, 0, 3, 1, 1, ("cC.",), (thing("c", 0, 0), thing("C", 1, 0)), False)
    said = picture_in_letters(MapGrid(picture, Pose(2, 0, 0)), Words())

    assert said[1:] == ("Chair C: a", "Chair: c", "ca^")


def test_letters_of_the_picture_say_the_colours_that_alone_make_a_difference() -> None:
    """The middle of each thing; blue would be ``b``, which is a box."""
    things = tuple(
        Thing("", kind, kind[0], colour, x, 1, 3, 3)
        for kind, colour, x in (("flower", "red", 1), ("flower", "blue", 5), ("box", "red", 9))
    )
    picture = Picture(0, 0, 12, 3, 1, ("fff.fff.bbb.",) * 3, things, False)
    said = picture_in_letters(MapGrid(picture, Pose(11, 0, 0)), Words())

    assert said[1:] == (
        *("Free: .", "Box: b", "Flower: f", "Red: r", "Blue: l"),
        *("fff.fff.bbb.", "frf.flf.bbb.", "fff.fff.bbb^"),
    )


def test_a_robot_that_is_not_donnie_stands_on_the_map_by_its_name() -> None:
    pose = Pose(1, 1, 0)
    grid = MapGrid(ROOM, pose, "alice")

    assert square_in_words(grid, 1, 1, pose, Words()) == "1, 1: alice. here."
    assert "alice" in row_in_words(grid, 1, Words())[0]
    assert picture_in_letters(grid, Words())[0].endswith("alice is ^")


def test_around_a_thing_between_its_paddles_a_robot_does_not_count_them() -> None:
    scene = load_text(
        "position ( size [ 0.3 0.3 0.3 ] gripper ( pose [ 0.25 0 -0.3 0 ] ) )\n"
        'model ( name "can" size [ 0.1 0.1 0.2 ] pose [ 0.36 0 0 0 ] gripper_return 1 )',
        Path("gripper.world"),
    )
    east = Pose(0.0, 0.0, 90.0)

    lines = around_in_words(MapGrid(picture(scene), east), east, Words())

    base = 0.15 + (1 - 0.66) * 0.2  # metres to the front of the gripper without its paddles
    steps = int((0.36 - 0.05 - base) / 0.05)
    assert [line for line in lines if "can" in line] == [f"Ahead: can, red, {steps} step."]
    assert sum("free, 10 steps" in line for line in lines) == 3


# --- rows and columns line by line


@pytest.mark.parametrize(
    ("detail", "row", "bottom", "lines"),
    [
        ("normal", "c.c.c.c", 0, 1),  # "Row 0, from 0: " and 44 characters with commas, and the full stop
        ("normal", "c.c.c.c", -1, 2),
        ("brief", "c.c.", 0, 1),
        ("brief", "c.c.", -1, 2),
        ("full", "c.c.c.c.c.", -1, 1),
        ("full", "c.c.c.c.c.", -10, 2),
    ],
)
def test_a_line_of_squares_is_as_long_as_its_detail_allows(
    detail: str, row: str, bottom: int, lines: int
) -> None:
    limit = {"brief": 40, "normal": 60, "full": 80}[detail]
    width = len(row)
    things = tuple(thing("c", x, bottom) for x, letter in enumerate(row) if letter == "c")
    floor = Picture(0, bottom, width, 2, 1, ("." * width, row), things, False)
    first, *rest = row_in_words(MapGrid(floor, Pose(0, bottom + 1, 0)), bottom, Words("en", detail))

    assert len(rest) == lines - 1
    assert len(first) == limit if lines == 1 else limit - 8 < len(first) <= limit
    for line in rest:
        assert line == f"Row {bottom}, from {width - 1}: {'chair' if row[-1] == 'c' else 'free'}."


COARSE = Picture(-10, -5, 3, 4, 5, ("#.#", "...", "...", "###"), (), True)
"""Three cells by four, of 5 steps each: their middles are at -10, -5 and 0, and at -5, 0, 5 and 10."""


@pytest.mark.parametrize(
    ("y", "said"),
    [
        (-8, "No row -8. Rows go from -5 to 10."),
        (-7, "Row -7, from -10: 3 wall."),
        (2, "Row 2, from -10: 2 free, Donnie."),
        (12, "Row 12, from -10: wall, free, wall."),
        (13, "No row 13. Rows go from -5 to 10."),
    ],
)
def test_each_step_of_a_coarse_cell_is_its_row(y: int, said: str) -> None:
    assert row_in_words(MapGrid(COARSE, Pose(1, 1, 0)), y, Words()) == (said,)


@pytest.mark.parametrize(
    ("x", "said"),
    [
        (-13, "No column -13. They go from -10 to 0."),
        (-12, "Column -12, from -5: wall, 2 free, wall."),
        (2, "Column 2, from -5: wall, Donnie, free, wall."),
        (3, "No column 3. They go from -10 to 0."),
    ],
)
def test_each_step_of_a_coarse_cell_is_its_column(x: int, said: str) -> None:
    assert column_in_words(MapGrid(COARSE, Pose(1, 1, 0)), x, Words()) == (said,)


def test_the_map_in_words_is_the_floor_and_its_things_and_the_walls_if_no_author_described_them() -> None:
    pose, about = Pose(3, 1, 0), About("Hall", "A hall.", "Go.", Difficulty.EASY)
    seen = replace(ROOM, rows=("#######", "#..c..#", ".......", "#.....#", "#######"))
    things = ("1 thing.", "Chair, red: 2 ahead.")

    size, walls, *said = map_in_words(seen, pose, Words())
    assert walls.startswith("Walls from the robot, in steps: ")
    assert tuple(said) == things
    assert map_in_words(seen, pose, Words(), about) == (size, *things)
    bare = replace(ROOM, things=(), has_walls=False)
    assert map_in_words(bare, pose, Words()) == ("An open floor without walls.", "There are no things.")


# --- squares


def driven(*places: tuple[float, float]) -> MapGrid:
    grid = MapGrid(ROOM, Pose(1, 1, 0))
    for x, y in places:
        grid.move(Pose(x, y, 0))
    return grid


@pytest.mark.parametrize(
    ("x", "y", "what"),
    [
        (0, 0, "wall"),
        (6, 4, "wall"),
        (-1, 0, "outside the world"),
        (7, 4, "outside the world"),
        (0, -1, "outside the world"),
        (6, 5, "outside the world"),
        (1, 1, "the start"),
        (2, 1, "trail"),
        (3, 1, "Donnie"),
        (4, 1, "free"),
        (4, 2, "goal 2"),
        (3, 3, "chair"),
    ],
)
def test_a_square_is_what_is_shown_there(x: int, y: int, what: str) -> None:
    grid = driven((3, 1))
    grid.mark_goals([(2, 4, 2, 4, 2)])

    assert square_in_words(grid, x, y, Pose(x, y, 0), Words()) == f"{x}, {y}: {what}. here."


def test_a_trail_outside_of_the_walls_is_no_place_outside_of_the_world() -> None:
    grid = driven((1, -3), (1, 1))

    assert square_in_words(grid, 1, -2, Pose(1, 1, 0), Words()) == "1, -2: trail. 3 behind."


def test_a_trail_over_a_thing_is_a_trail_and_the_edge_of_an_open_floor_is_free() -> None:
    grid = driven((3, 1), (3, 3), (3, 2))
    floor = MapGrid(Picture(0, 0, 3, 3, 1, ("...",) * 3, (), False), Pose(1, 1, 0))

    assert square_in_words(grid, 3, 3, Pose(3, 3, 0), Words()) == "3, 3: trail. here."
    for x, y in ((0, 0), (2, 2), (0, 2), (2, 0)):
        assert square_in_words(floor, x, y, Pose(x, y, 0), Words()) == f"{x}, {y}: free. here."


def test_several_free_squares_have_their_plural_and_a_long_name_its_line() -> None:
    grid = MapGrid(ROOM, Pose(1, 1, 0))
    assert row_in_words(grid, 1, Words("pt")) == ("Linha 1, de 0: parede, Donnie, 4 livres, parede.",)

    name = "a very long name of a kind of thing which no other thing has"
    long = Thing("", name, "v", "red", 0, 0, 1, 1)
    floor = MapGrid(Picture(0, 0, 3, 2, 1, ("...", "v.."), (long,), False), Pose(2, 1, 0))
    assert row_in_words(floor, 0, Words()) == (f"Row 0, from 0: {name}.", "Row 0, from 1: 2 free.")


@pytest.mark.parametrize(
    ("first", "sectors", "headings", "before", "after"),
    [
        (0.0, 4, [0, 90, 180, 270], 314.9, 315.1),
        (45.0, 8, [45, 90, 135, 180, 225, 270, 315, 360], 22.4, 22.6),
        (10.0, 12, [10 + 30 * hour for hour in range(12)], 354.9, 355.1),
    ],
)
def test_a_direction_reaches_half_way_to_the_next_one(
    first: float, sectors: int, headings: list[float], before: float, after: float
) -> None:
    face = Face(first, ("around-hour",) * sectors)

    assert [face.heading(each) for each in range(sectors)] == headings
    assert [face.sector(each) for each in headings] == list(range(sectors))
    assert (face.sector(before), face.sector(after)) == (sectors - 1, 0)


def test_a_letter_without_a_thing_is_shown_as_it_is() -> None:
    grid = MapGrid(Picture(0, 0, 2, 1, 1, (".k",), (), False), Pose(0, 0, 0))

    assert square_in_words(grid, 1, 0, Pose(0, 0, 0), Words()) == "1, 0: k. 1 right."
    assert row_in_words(grid, 0, Words()) == ("Row 0, from 0: Donnie, ?.",)


# --- the picture


def test_the_picture_explains_the_start_the_trail_and_the_goals_that_it_shows() -> None:
    """A start has no letter, as things have letters."""
    grid = driven((3, 1))
    grid.mark_goals([(2, 5, 3, 5, 3), (1, 4, 2, 5, 2)])

    assert picture_in_letters(grid, Words())[1:] == (
        *("The start: *", "Trail: o", "Wall: #", "Free: .", "Chair: c", "Goal 1: 1", "Goal 2: 2"),
        *("#######", "#..c.2#", "#...11#", "#*o^..#", "#######"),
    )


def test_the_picture_explains_no_goal_and_no_colour_outside_of_its_part() -> None:
    """It shows 40 of 50 squares."""
    row = "fff.fff." + "." * 42
    things = tuple(Thing("", "flower", "f", colour, x, 0, 3, 3) for colour, x in (("red", 1), ("blue", 5)))
    floor = Picture(0, 0, 50, 1, 1, (row,), things, False)
    far, near = (MapGrid(floor, Pose(x, 0, 0)) for x in (49, 22))
    for grid in (far, near):
        grid.mark_goals([(1, 3, 0, 3, 0), (2, 11, 0, 11, 0)])

    assert picture_in_letters(far, Words())[3:-1] == ("Free: .", "Goal 2: 2")
    assert picture_in_letters(far, Words())[-1] == "." + "2" + "." * 37 + "^"
    assert picture_in_letters(near, Words())[3:-1] == (
        ("Free: .", "Flower: f", "Blue: b", "Goal 1: 1", "Goal 2: 2")
    )
    assert picture_in_letters(near, Words())[-1][:10] == "f1fbf....2"


@pytest.mark.parametrize(
    ("colours", "size", "robot", "row"),
    [
        (("red", "blue"), 2, 9, "frf.fbf..^"),
        (("red", "blue"), 1, 9, "fff.fff..^"),
        (("red", "red"), 2, 9, "fff.fff..^"),
        (("red", "golden"), 2, 9, "frf.fff..^"),
        (("red", "blue"), 2, 1, "f^f.fbf..."),
    ],
)
def test_the_initial_of_a_colour_needs_a_known_colour_and_room_and_no_robot_on_it(
    colours: tuple[str, str], size: int, robot: int, row: str
) -> None:
    things = tuple(
        Thing("", "flower", "f", colour, x, 0, size, 1) for colour, x in zip(colours, (1, 5), strict=True)
    )
    floor = Picture(0, 0, 10, 1, 1, ("fff.fff...",), things, False)

    assert picture_in_letters(MapGrid(floor, Pose(robot, 0, 0)), Words())[-1] == row


def test_a_capital_letter_is_shown_as_an_unused_small_one_and_stays_without_its_small_one() -> None:
    kinds = {"e": "elk", "E": "egg", "T": "table"}
    things = tuple(thing(letter, x, 0, kind) for x, (letter, kind) in enumerate(kinds.items()))
    floor = Picture(0, 0, 4, 1, 1, ("eET.",), things, False)
    said = picture_in_letters(MapGrid(floor, Pose(3, 0, 0)), Words())

    assert said[1:] == ("Egg: a", "Table: T", "Elk: e", "eaT^")


def test_no_capital_letter_is_shown_as_the_trail_or_the_arrow_down() -> None:
    letters = "abcdefghijklmnpqrstuwxyzBC"
    things = tuple(thing(letter, x, 0, f"kind {letter}") for x, letter in enumerate(letters))
    floor = Picture(0, 0, 27, 1, 1, (letters + ".",), things, False)

    assert picture_in_letters(MapGrid(floor, Pose(26, 0, 0)), Words())[-1] == letters + "^"


# --- around

OPEN = ("." * 41,) * 41


def at_steps(*things: Thing) -> Picture:
    """A floor without walls, whose middle is 0, 0, with a robot that is 0.9 wide."""
    return Picture(-20, -20, 41, 41, 1, OPEN, things, False, (), (BODY,))


@pytest.mark.parametrize(
    ("distance", "said"),
    [
        (11.8, ("1 thing within 10 steps.", "Ahead: chair, red, 10 steps.")),
        (11.9, ("There is nothing within 10 steps.", "Ahead: free, 10 steps.")),
        (2, ("1 thing within 10 steps.", "Ahead: chair, red, 1 step.")),
    ],
)
def test_around_reaches_ten_steps_from_the_edge_of_the_robot(distance: float, said: tuple[str, str]) -> None:
    """A robot of 0.9 and a chair of 1 step: 0.95 less than their middles. Half a centimetre is 0.1."""
    pose = Pose(0, 0, 0)
    grid = MapGrid(at_steps(thing("c", 0, distance)), pose)

    assert around_in_words(grid, pose, Words())[:2] == said


def test_around_at_full_has_eight_directions_and_at_less_four() -> None:
    pose, grid = Pose(0, 0, 45), MapGrid(at_steps(), Pose(0, 0, 45))

    def sides(detail: str, **how: int | bool) -> list[str]:
        said = around_in_words(grid, pose, Words("en", detail), **how)
        return [each.partition(":")[0] for each in said[1:]]

    eight = ["Ahead", "Ahead right", "Right", "Behind right", "Behind", "Behind left", "Left", "Ahead left"]
    assert len(sides("full")) == 8
    assert sides("full")[::2] == eight[::2] == sides("normal") == sides("brief")
    points = ["Northeast", "Southeast", "Southwest", "Northwest"]
    assert sides("full", compass=1)[::2] == points == sides("normal", compass=1)
    assert sides("full", compass=7)[:3] == ["Northwest", "North", "Northeast"]
    assert sides("full", clock=True) == [f"{hour} o'clock" for hour in (12, *range(1, 12))]
    assert sides("normal", clock=True) == [f"{hour} o'clock" for hour in (12, 3, 6, 9)]


def test_a_thing_is_in_the_direction_of_its_nearest_edge_and_the_nearest_comes_first() -> None:
    pose = Pose(0, 0, 90)
    near, far, behind = (
        replace(thing("c", *place), name=name)
        for name, place in (("near", (3, 0)), ("far", (6, 1)), ("behind", (-4, 0)))
    )
    twins = [replace(thing("t", 0, 5), name=name) for name in ("twin b", "twin a")]
    seen = at_steps(far, behind, *twins, near)

    said = around_in_words(MapGrid(seen, pose), pose, Words("en", "brief"))
    assert said == (
        "5 things within 10 steps.",
        "Ahead: near, 2.",
        "Ahead: far, 5.",
        "Right: free.",
        "Behind: behind, 3.",
        "Left: twin a, 4.",
        "Left: twin b, 4.",
    )


def test_a_thing_ahead_is_as_far_as_the_robot_could_go_until_it_touches() -> None:
    """Its nearest corner is 1.87 steps from that of the robot; straight on it is 2.6 steps away."""
    slanted = replace(thing("t", 0, 6), outlines=(((1.5, 2.0), (5.0, 8.5), (-5.0, 8.5)),))
    pose = Pose(0, 0, 0)

    assert (
        around_in_words(MapGrid(at_steps(slanted), pose), pose, Words())[1] == "Ahead: table, red, 2 steps."
    )


def test_what_is_nearer_comes_first_also_if_it_is_a_wall() -> None:
    pose, seen = Pose(2, 0, 0), room("..c..", "#####", ".....", things=(thing("c", 2, 2),))

    assert around_in_words(MapGrid(seen, pose), pose, Words())[1:3] == (
        ("Ahead: wall, 0 steps.", "Ahead: chair, red, 1 step.")
    )


def test_an_hour_between_the_quarters_is_named_for_a_thing_and_then_has_its_wall() -> None:
    """From 2, 1 the nearest corner of the chair is at 18 degrees."""
    pose = Pose(2, 1, 0)
    said = around_in_words(MapGrid(ROOM, pose), pose, Words(), clock=True)
    hours = [each.partition(",")[0] for each in said[1:]]

    assert hours == [
        *("12 o'clock: wall", "1 o'clock: chair", "1 o'clock: wall"),
        *(f"{hour} o'clock: wall" for hour in (3, 6, 9)),
    ]


def test_a_held_thing_is_not_around_the_robot() -> None:
    pose = Pose(0, 0, 0)
    held, other = replace(thing("c", 0, 1), index=7), replace(thing("t", 0, 3), index=8)
    grid = MapGrid(at_steps(held, other), pose)

    assert around_in_words(grid, pose, Words(), held=7)[:3] == (
        ("1 thing within 10 steps.", "In my gripper: chair, red.", "Ahead: table, red, 2 steps.")
    )
    assert around_in_words(grid, pose, Words())[:2] == (
        ("2 things within 10 steps.", "Ahead: chair, red, 0 steps.")
    )


def test_the_points_of_the_compass_are_typed_clockwise_from_north() -> None:
    assert compass_words("en")[::2] == ("north", "east", "south", "west")
    assert compass_words("es")[::2] == ("norte", "este", "sur", "oeste")
    assert [compass_point(each) for each in compass_words("pt")] == list(range(8))
