"""The map with everything on it: rays, robots, moved things, large squares, names, a finger."""

import msgspec
import pytest

from devices.ports.robot import Pose
from donnie_tui.core.events import (
    HowStarted,
    Moved,
    PlacedThing,
    Read,
    RunStarted,
    Scanned,
    SeenGroup,
    Stamped,
    ThingsMoved,
)
from donnie_tui.core.map_grid import Bounds, Cell, Kind
from donnie_tui.core.map_scene import (
    RAY,
    MapScale,
    MapScene,
    factor_for,
    floor_rows,
    labels,
    map_at,
    rows_of,
)
from donnie_tui.core.map_words import Pointer, content, legend
from donnie_tui.core.timeline import Timeline
from donnie_tui.i18n.words import Words
from sim.picture import Picture, Thing

CHAIR = Thing("chair3", "chair", "c", "red", 2, 6, 2, 1, index=3)
ROWS = (
    "##########",
    "#........#",
    "#........#",
    "#..cc....#",
    "#........#",
    "#........#",
    "#........#",
    "#........#",
    "#........#",
    "##########",
)


def scene() -> MapScene:
    """10 by 10 cells, the corner at -1, 0; the robot at 0, 1 facing north."""
    picture = Picture(-1, 0, 10, 10, 1, ROWS, (CHAIR,), has_walls=True)
    return MapScene(picture, Pose(0, 1, 0))


def shown(it: MapScene) -> list[str]:
    bounds = it.bounds
    return [
        "".join(it.letter(Cell(x, y)) for x in range(bounds.left, bounds.right + 1))
        for y in range(bounds.top, bounds.bottom - 1, -1)
    ]


def test_a_distance_is_a_ray_to_the_found_thing_until_the_robot_moves() -> None:
    it = scene()
    changed = it.look_along(Read("distance", "front", 4))

    assert [it.letter(Cell(1, y)) for y in range(2, 6)] == [RAY, RAY, RAY, "."]
    assert changed == {Cell(1, 1), Cell(1, 2), Cell(1, 3), Cell(1, 4)}
    assert it.move(Pose(0, 1, 0)) == frozenset(), "the end of a program says where the robot is"
    assert RAY in "".join(shown(it))
    assert {Cell(1, 2), Cell(1, 3)} <= it.move(Pose(0, 2, 0))
    assert RAY not in "".join(shown(it))


@pytest.mark.parametrize("hidden", [Kind.TRAIL, Kind.RAY, Kind.GOAL])
def test_what_is_hidden_is_free_floor_and_comes_back(hidden: Kind) -> None:
    it = scene()
    it.grid.mark_goals([(1, 2.0, 3.0, 2.0, 3.0)])
    it.move(Pose(0, 3, 0))
    it.look_along(Read("distance", "front", 3))
    cells = {Kind.TRAIL: Cell(1, 2), Kind.RAY: Cell(1, 4), Kind.GOAL: Cell(3, 3)}
    marks = {Kind.TRAIL: "o", Kind.RAY: "'", Kind.GOAL: "1"}

    assert cells[hidden] in it.hide({hidden})
    for kind, cell in cells.items():
        assert it.kind(cell) is (Kind.FREE if kind is hidden else kind)
        assert it.letter(cell) == ("." if kind is hidden else marks[kind])
    assert (cells[Kind.GOAL] in it.standing) is (hidden is not Kind.GOAL)

    it.hide(())
    assert [it.kind(cell) for cell in cells.values()] == [*cells]


def test_the_start_is_part_of_the_trail() -> None:
    it = scene()
    start = it.grid.start
    it.move(Pose(0, 3, 0))
    assert (it.letter(start), it.kind(start)) == ("A", Kind.START)

    assert start in it.hide({Kind.TRAIL})
    assert (it.letter(start), it.kind(start)) == (".", Kind.FREE)


@pytest.mark.parametrize(
    ("hidden", "signs"),
    [(Kind.TRAIL, ("A ", "o ")), (Kind.RAY, ("' ",)), (Kind.GOAL, ("A digit",))],
)
def test_the_legend_leaves_out_what_is_hidden(hidden: Kind, signs: tuple[str, ...]) -> None:
    it = scene()
    it.grid.mark_goals([(1, 2.0, 3.0, 2.0, 3.0)])
    whole = legend(it, Words("en"))
    it.hide({hidden})
    left_out = [line for line in whole if line not in legend(it, Words("en"))]

    assert all(any(line.startswith(sign) for line in left_out) for sign in signs), left_out
    assert len(left_out) == len(signs)


def test_a_scan_shows_each_angle() -> None:
    it = scene()
    it.look_along(Scanned((SeenGroup("right", 45, 3, ("red",)), SeenGroup("left", 0, 5, ("blue",)))))

    assert it.kind(Cell(2, 2)) is Kind.RAY
    assert it.kind(Cell(1, 5)) is Kind.RAY


def test_a_position_or_a_colour_is_no_ray() -> None:
    it = scene()

    assert it.look_along(Read("position", "x", 5)) == frozenset()


def test_a_pushed_thing_is_shown_at_its_current_place_and_the_old_one_is_free() -> None:
    it = scene()
    changed = it.place_things((PlacedThing("chair3", Pose(4, 3, 0), 3),))

    assert shown(it)[3] == "#........#"
    assert shown(it)[6].count("c") == 2
    assert Cell(3, 6) in changed
    assert it.thing(Cell(3, 6)) is None
    assert it.things[0].x == 4
    it.begin(Pose(0, 1, 0))
    assert shown(it)[3] == "#........#"
    it.place_things(())
    assert shown(it)[3] == "#..cc....#"


def test_a_new_run_returns_the_cells_that_look_different() -> None:
    it = scene()
    assert it.begin(Pose(0, 1, 0)) == {Cell(1, 1)}
    it.move(Pose(0, 4, 90))
    it.look_along(Read("distance", "front", 3))
    it.move_other("bob", Pose(5, 4, 90))
    it.place_things((PlacedThing("chair3", Pose(4, 3, 0), 3),))
    before = shown(it)
    changed = it.begin(Pose(2, 1, 0))
    after = shown(it)

    differing = {Cell(x, 9 - row) for row in range(10) for x in range(10) if before[row][x] != after[row][x]}
    assert len(differing) > 6
    assert differing <= changed


def test_another_robot_is_an_arrow_with_its_name() -> None:
    it = scene()
    it.move_other("bob", Pose(5, 4, 90))
    changed = it.move_other("bob", Pose(6, 4, 90))

    assert it.letter(Cell(7, 4)) == ">"
    assert it.kind(Cell(7, 4)) is Kind.OTHER
    assert it.robot_at(Cell(7, 4)) == "bob"
    assert changed == {Cell(6, 4), Cell(7, 4)}
    assert it.move_other("bob", Pose(6, 4, 90)) == frozenset()


def test_things_have_their_colour_and_nothing_else_has() -> None:
    it = scene()

    assert it.colour(Cell(3, 6)) == "red"
    assert it.colour(Cell(0, 0)) == it.colour(Cell(1, 1)) == ""


@pytest.mark.parametrize(
    ("columns", "rows", "factor"), [(10, 10, 1), (9, 10, 2), (5, 5, 2), (3, 9, 4), (1, 1, 10)]
)
def test_the_whole_floor_fits_with_the_smallest_square(columns: int, rows: int, factor: int) -> None:
    assert factor_for(Bounds(0, 0, 9, 9), columns, rows) == factor


def test_a_large_square_shows_what_matters_most_in_it() -> None:
    scale = MapScale(scene(), 5)

    assert [[scale.shown(Cell(x, y))[0] for x in (0, 1)] for y in (1, 0)] == [["c", "#"], ["^", "#"]]
    assert scale.robot == Cell(0, 0)
    assert scale.squares_of([Cell(4, 4), Cell(5, 5)]) == {Cell(0, 0), Cell(1, 1)}


def test_a_name_is_written_next_to_its_thing_on_free_floor_only() -> None:
    """To the east of the chair are four free cells, and then the wall."""
    assert labels(MapScale(scene()), 1, Words("en")) == {}
    assert labels(MapScale(scene()), 2, Words("en")) == {
        Cell(5, 6): " c",
        Cell(6, 6): "ha",
        Cell(7, 6): "ir",
        Cell(8, 6): "  ",
    }
    assert labels(MapScale(scene()), 2, Words("pt")) == {}
    assert labels(MapScale(scene()), 3, Words("pt")) == {
        Cell(5, 6): " ca",
        Cell(6, 6): "dei",
        Cell(7, 6): "ra ",
    }


def test_a_name_is_written_over_what_a_sensor_looked_along() -> None:
    it = scene()
    it.show_fields([((4, 5), (8, 5))])

    assert it.kind(Cell(6, 6)) is Kind.RAY
    assert labels(MapScale(it), 2, Words("en")) == labels(MapScale(scene()), 2, Words("en"))


def test_a_name_without_room_to_the_east_is_written_to_the_west_and_hides_no_other() -> None:
    rows = ("............c.", "..............", "d...........cc")
    chairs = [Thing(f"c{x}{y}", "chair", "c", "red", x, y, 1, 1, index=x) for x, y in ((12, 2), (13, 0))]
    desk = Thing("desk", "desk", "d", "red", 0, 0, 1, 1, index=1)
    it = MapScene(Picture(0, 0, 14, 3, 1, rows, (*chairs, desk), has_walls=True), Pose(5, 1, 0))
    written = labels(MapScale(it), 1, Words())

    first = it.grid.cell_of(Pose(0, 0, 0))
    by_row = {
        y: "".join(written.get(Cell(first.x + x, first.y + y), rows[2 - y][x]) for x in range(14))
        for y in range(3)
    }
    # from the west end four cells are left for " desk ", which needs six
    assert by_row == {2: "..... chair c.", 1: "." * 14, 0: "d.... chair cc"}


def test_three_hundred_things_have_their_names() -> None:
    chairs = [Thing("", "chair", "c", "red", 0, y, 1, 1, index=y) for y in range(301)]
    floor = Picture(0, 0, 9, 301, 1, ("c........",) * 301, tuple(chairs), has_walls=False)

    assert len({cell.y for cell in labels(MapScale(MapScene(floor, Pose(8, 0, 0))), 1, Words())}) == 300


@pytest.mark.parametrize(("steps", "cells"), [(99, 99), (100, 100), (101, 100)])
def test_a_ray_has_a_hundred_cells_at_most(steps: int, cells: int) -> None:
    assert len(scene().look_along(Read("distance", "front", steps))) == cells


def test_the_names_of_other_robots_are_written_too() -> None:
    it = scene()
    it.move_other("bob", Pose(2, 3, 90))

    assert "".join(labels(MapScale(it), 2, Words())[Cell(x, 3)] for x in (4, 5, 6)) == " bob  "


@pytest.mark.parametrize(
    ("language", "words"),
    [
        ("en", "2, 6: chair, red. 2 right, 5 ahead."),
        ("pt", "2, 6: cadeira vermelha. 2 à direita, 5 à frente."),
    ],
)
def test_the_finger_describes_the_thing_and_its_place_from_the_robot(language: str, words: str) -> None:
    pointer = Pointer(scene())
    assert pointer.to_next_thing(True)

    assert pointer.words(Words(language)) == words


def test_the_finger_stays_on_the_floor_and_returns_to_the_robot() -> None:
    pointer = Pointer(scene())
    pointer.move(-50, 50)
    assert pointer.here == Cell(0, 9)
    pointer.to_robot()

    assert pointer.here == Cell(1, 1)


def test_the_way_between_two_squares_is_described_in_words() -> None:
    pointer = Pointer(scene())
    pointer.move(1, 0)
    pointer.mark()
    pointer.move(2, 3)

    assert pointer.way(Words("en")) == "From 1, 1 to 3, 4: 2 right, 3 ahead."


def test_things_of_one_letter_are_distinguished_by_their_colours_in_words() -> None:
    """The colour may have room where the whole name has none."""
    rows = (
        "######################",
        "#..cc................#",
        "#######cc......#######",
        "#....................#",
    )
    blue = msgspec.structs.replace(CHAIR, colour="blue", x=6, y=1, index=1)
    red = msgspec.structs.replace(CHAIR, y=2)
    picture = Picture(-1, 0, 22, 4, 1, rows, (red, blue), has_walls=True)
    it = MapScene(picture, Pose(0, 0, 0))
    written = labels(MapScale(it), 1, Words("en"))

    def label_of(row: int) -> str:
        return "".join(written[each] for each in sorted(written) if each.y == row).strip()

    assert (label_of(2), label_of(1)) == ("chair, red", "blue")
    assert legend(it, Words("en"))[-1] == "c is chair: R red, B blue."


def test_the_legend_explains_every_letter_of_the_floor() -> None:
    lines = legend(scene(), Words("en"))

    assert lines[-1] == "c is chair, red."
    assert any(line.startswith("# ") for line in lines)


# --- several robots and things

COURT = ("##########", "#........#", "#..cc..b.#", "#......bb#", "#.t......#", "##########")


def court() -> MapScene:
    """10 by 6 cells, the corner at 0, 0: a chair, a table, Bob facing east; alice at 1, 1 faces north."""
    things = (
        Thing("", "chair", "c", "red", 3.5, 3, 2, 1, index=1),
        Thing("tea", "table", "t", "blue", 2, 1, 1, 1, index=2),
        Thing("Bob", "donnie", "b", "green", 7, 3, 1, 1, is_robot=True, heading=90.0, index=3),
    )
    return MapScene(Picture(0, 0, 10, 6, 1, COURT, things, has_walls=True), Pose(1, 1, 0), "alice")


def test_a_robot_that_has_not_moved_is_an_arrow_where_it_stands_and_nothing_after_it_has_left() -> None:
    it = court()
    stands, beside = Cell(7, 3), Cell(7, 2)
    assert (it.letter(stands), it.letter(beside), it.name_of_robot(stands)) == (">", "b", "Bob")
    assert (it.name_of_robot(it.robot), it.name_of_robot(Cell(5, 1))) == ("alice", "")
    assert scene().name_of_robot(scene().robot) == ""
    assert [each.letter for each in it.things] == ["c", "t", "b"]

    changed = it.move_other("Bob", Pose(5, 1, 180))
    assert {stands, beside, Cell(5, 1)} <= changed
    assert [it.letter(each) for each in (stands, beside, Cell(5, 1))] == [".", ".", "v"]
    assert (it.name_of_robot(Cell(5, 1)), it.name_of_robot(stands), it.thing(stands)) == ("Bob", "", None)
    assert [each.letter for each in it.things] == ["c", "t"]

    it.place_things((PlacedThing("tea", Pose(7, 1, 0), 2),))
    assert (it.letter(stands), it.kind(Cell(7, 1)), it.thing(Cell(7, 1)).name) == (".", Kind.THING, "tea")
    it.begin(Pose(1, 1, 0))
    it.place_things(())
    assert (it.letter(stands), it.letter(Cell(7, 1)), it.letter(Cell(2, 1))) == (">", ".", "t")


def test_a_square_is_painted_as_what_it_shows() -> None:
    it = court()
    it.look_along(Read("distance", "front", 1))
    scale = MapScale(it)

    cells = (Cell(0, 0), Cell(1, 1), Cell(1, 2), Cell(2, 1), Cell(3, 3), Cell(7, 3), Cell(8, 1))
    assert [scale.shown(each) for each in cells] == [
        *(("#", "wall"), ("^", "robot"), (".", "free"), ("t", "thing-blue"), ("c", "thing-red")),
        *((">", "other-green"), (".", "free")),
    ]
    it.move_other("Bob", Pose(8, 1, 0))
    it.move_other("stranger", Pose(5, 1, 0))
    assert [scale.shown(each) for each in (Cell(8, 1), Cell(5, 1))] == [("^", "other-green"), ("^", "other-")]


def test_the_whole_floor_in_letters_has_two_columns_a_square() -> None:
    assert floor_rows(court(), 20, 6) == (
        "#" * 20,
        "##. . . . . . . . ##",
        "##. . cccc. . > . ##",
        "##. . . . . . bbbb##",
        "##^ tt. . . . . . ##",
        "#" * 20,
    )
    assert len(floor_rows(court(), 10, 6)) == 3


def test_the_finger_goes_from_thing_to_thing_by_their_distance_and_round() -> None:
    pointer = Pointer(court())
    places = []
    for forward in (True, True, True, True, False, False):
        assert pointer.to_next_thing(forward)
        places.append(pointer.here)

    table, chair, bob = Cell(2, 1), Cell(4, 3), Cell(7, 3)
    assert places == [table, chair, bob, table, bob, chair]
    pointer.to_robot()
    assert pointer.to_next_thing(False)
    assert pointer.here == bob
    pointer.go(Cell(40, -3))
    assert pointer.here == Cell(9, 0)
    empty = Picture(0, 0, 3, 1, 1, ("...",), (), has_walls=False)
    assert not Pointer(MapScene(empty, Pose(0, 0, 0))).to_next_thing(True)


@pytest.mark.parametrize(
    ("cell", "said"),
    [
        (Cell(0, 0), "wall"),
        (Cell(5, 1), "goal 2"),
        (Cell(8, 4), "free"),
        (Cell(1, 1), "alice"),
        (Cell(2, 1), "tea, table, blue"),
        (Cell(3, 3), "chair, red"),
        (Cell(6, 1), "carol"),
    ],
)
def test_a_square_is_named_by_what_is_there(cell: Cell, said: str) -> None:
    it = court()
    it.grid.mark_goals([(2, 5.0, 1.0, 5.0, 1.0)])
    it.move_other("carol", Pose(6, 1, 0))

    assert content(it, cell, Words()) == said
    assert content(scene(), Cell(1, 1), Words()) == "Donnie"
    it.move_other("", Pose(7, 4, 0))
    assert content(it, Cell(7, 4), Words()) == "another robot"
    nameless = MapScene(Picture(0, 0, 2, 1, 1, (".k",), (), has_walls=False), Pose(0, 0, 0))
    assert content(nameless, Cell(1, 0), Words()) == "k"


def test_the_nearest_of_things_and_robots_is_pointed_at_first_from_where_the_robot_is() -> None:
    it = court()
    it.move_other("carol", Pose(8, 1, 0))
    it.move(Pose(8, 4, 0))
    pointer, order = Pointer(it), []
    for _ in range(4):
        pointer.to_next_thing(True)
        order.append(pointer.here)

    bob, carol, chair, table = Cell(7, 3), Cell(8, 1), Cell(4, 3), Cell(2, 1)
    assert order == [bob, carol, chair, table]


def test_a_way_begins_at_the_marked_square_or_where_the_robot_is() -> None:
    """As the robot looks: it faces east at 0, 1."""
    it = scene()
    it.move(Pose(0, 1, 90))
    pointer = Pointer(it)
    pointer.go(Cell(4, 3))
    assert pointer.words(Words()) == "3, 3: free. 2 left, 3 ahead."
    assert pointer.way(Words()) == "From 0, 1 to 3, 3: 2 left, 3 ahead."

    pointer.mark()
    pointer.move(-2, 4)
    assert pointer.way(Words()) == "From 3, 3 to 1, 7: 4 left, 2 behind."


def test_the_legend_has_the_names_that_are_true_of_all_things_of_a_letter() -> None:
    two = tuple(msgspec.structs.replace(CHAIR, name=f"c{at}", x=at, y=6, index=at) for at in (2, 4))
    it = MapScene(Picture(-1, 0, 10, 10, 1, ROWS, two, has_walls=True), Pose(0, 1, 0))

    assert legend(it, Words())[-1] == "c is chair, red."
    assert legend(it, Words())[0].startswith("^ > v < is Donnie, looking north")
    assert legend(court(), Words())[-1] == "t is tea, table, blue."
    assert legend(court(), Words())[0].startswith("^ > v < is alice, looking north")
    assert [line[0] for line in legend(court(), Words())[-3:]] == ["b", "c", "t"]


# --- rays, names and squares one by one


def open_floor(*things: Thing, heading: float = 0.0, rows: tuple[str, ...] = ("." * 21,) * 21) -> MapScene:
    """21 by 21 cells without walls; the robot in the middle, at 10, 10."""
    picture = Picture(-10, -10, len(rows[0]), len(rows), 1, rows, things, has_walls=False)
    return MapScene(picture, Pose(0, 0, heading))


@pytest.mark.parametrize(
    ("event", "cells"),
    [
        (Read("distance", "front", 3), [(10, 10), (11, 10), (12, 10)]),
        (Read("distance", "front left", 3), [(10, 10), (11, 11)]),
        (Read("distance", "back", 3), [(10, 10), (9, 10), (8, 10)]),
        (Scanned((SeenGroup("ahead", 0, 2, ("red",)),)), [(10, 10), (11, 10)]),
        (Scanned((SeenGroup("left", 90, 2, ("red",)),)), [(10, 10), (10, 11)]),
        (Scanned((SeenGroup("right", 90, 2, ("red",)),)), [(10, 10), (10, 9)]),
        (Scanned((SeenGroup("right", 45, 3, ("red",)),)), [(10, 10), (11, 9)]),
        (Read("distance", "front", 1), [(10, 10)]),
        (Read("distance", "front", 0), []),
        (Read("distance", "front", -1), []),
        (Read("distance", "left eye", 3), []),
        (Read("position", "front", 3), []),
    ],
)
def test_a_robot_that_faces_east_looks_along_these_squares(
    event: Read | Scanned, cells: list[tuple[int, int]]
) -> None:
    it = open_floor(heading=90.0)

    assert it.look_along(event) == {Cell(*each) for each in cells}
    assert it.look_along(event) == frozenset()


def test_a_field_of_view_turns_with_the_robot() -> None:
    """At 30 degrees 6 steps to the right are 5.2 to the east and 3 to the south, 6 ahead 3 and 5.2."""
    it = open_floor(heading=30.0)
    changed = it.show_fields([((6, 0), (6, 0)), ((0, 6), (0, 6))])

    assert changed == {Cell(15, 7), Cell(13, 15)}
    assert it.show_fields([((6, 0), (6, 0))]) == frozenset()


def test_a_new_run_looks_from_its_start() -> None:
    it = open_floor()
    it.begin(Pose(2, 0, 90))

    assert it.pose == Pose(2, 0, 90)
    assert it.look_along(Read("distance", "front", 2)) == {Cell(12, 10), Cell(13, 10)}


def test_a_thing_that_is_called_as_a_robot_is_none() -> None:
    rows = ("........", "t..b..r.", "........")
    things = (
        Thing("Bob", "table", "t", "blue", 0, 1, 1, 1, index=1),
        Thing("Bob", "donnie", "b", "green", 3, 1, 1, 1, is_robot=True, heading=90.0, index=2),
        Thing("carol", "donnie", "r", "red", 6, 1, 1, 1, is_robot=True, index=3),
    )
    it = MapScene(Picture(0, 0, 8, 3, 1, rows, things, has_walls=False), Pose(0, 0, 0), "alice")
    it.move_other("Bob", Pose(3, 2, 0))

    def seen() -> list[str]:
        return [it.letter(Cell(x, 1)) for x in (0, 3, 6)]

    assert seen() == ["t", ".", "^"]
    assert it.place_things(()) == {Cell(3, 1)}
    assert seen() == ["t", ".", "^"]
    assert [each.letter for each in it.things] == ["t", "r"]
    assert [it.colour_of_robot(each) for each in (Cell(3, 2), Cell(6, 1))] == ["green", "red"]


def test_a_robot_is_named_as_soon_as_there_is_another_one() -> None:
    it = MapScene(Picture(-1, 0, 10, 10, 1, ROWS, (CHAIR,), has_walls=True), Pose(0, 1, 0), "donnie")
    assert it.name_of_robot(it.robot) == ""

    it.move_other("bob", Pose(5, 4, 90))
    assert it.name_of_robot(it.robot) == "donnie"


@pytest.mark.parametrize("order", [1, -1])
def test_of_two_things_of_a_letter_a_square_belongs_to_the_one_whose_middle_is_nearer(order: int) -> None:
    """Four boxes of 2 by 2 squares, side by side."""
    boxes = [
        Thing(f"{x}{y}", "box", "b", "red", x + 0.5, y + 0.5, 2, 2, index=x + y + 1)
        for x in (0, 2)
        for y in (0, 2)
    ][::order]
    rows = ("bbbb.",) * 4
    it = MapScene(Picture(0, 0, 5, 4, 1, rows, tuple(boxes), has_walls=False), Pose(4, 0, 0))

    names = {(x, y): it.thing(Cell(x, y)) for x in range(4) for y in range(4)}
    assert {place: each and each.name for place, each in names.items()} == {
        (x, y): f"{x // 2 * 2}{y // 2 * 2}" for x in range(4) for y in range(4)
    }
    assert it.thing(Cell(4, 1)) is None


def test_a_moved_thing_fills_as_many_squares_as_it_is_large() -> None:
    """Squares of 2 steps, the middle of the first one at -4, -2; a crumb fills one, too."""
    things = (
        Thing("", "chair", "c", "red", -1, 0, 4, 2, index=1),
        Thing("", "crumb", "u", "red", 2, -2, 0.2, 0.2, index=2),
    )
    it = MapScene(Picture(-4, -2, 4, 2, 2, (".cc.", "...u"), things, has_walls=False), Pose(2, 0, 0))

    def filled() -> dict[str, set[tuple[int, int]]]:
        cells = {(x, y): it.thing(Cell(x, y)) for x in range(-1, 6) for y in range(-1, 4)}
        return {
            letter: {place for place, each in cells.items() if each is not None and each.letter == letter}
            for letter in "cu"
        }

    assert filled() == {"c": {(1, 1), (2, 1)}, "u": {(3, 0)}}
    first = it.place_things(
        (
            PlacedThing("", Pose(-3, -2, 0), 1),
            PlacedThing("", Pose(-4, 0, 0), 2),
            PlacedThing("", Pose(0, 0, 0), 9),
        )
    )
    assert filled() == {"c": {(0, 0), (1, 0)}, "u": {(0, 1)}}
    assert {Cell(*each) for each in ((1, 1), (2, 1), (3, 0), (0, 0), (1, 0), (0, 1))} == first
    then = it.place_things((PlacedThing("", Pose(-3, -2, 0), 1),))
    assert {Cell(0, 1), Cell(3, 0)} <= then


def test_the_own_robot_is_shown_above_all_else() -> None:
    it = scene()
    it.move_other("bob", Pose(2, 6, 90))
    it.move(Pose(2, 6, 0))
    here = it.robot

    assert (it.letter(here), it.kind(here), it.colour(here)) == ("^", Kind.ROBOT, "")
    it.place_things((PlacedThing("chair3", Pose(2, 6, 0), 3),))
    assert (it.letter(here), it.kind(here), it.colour(here)) == ("^", Kind.ROBOT, "")


def test_a_trail_goes_over_the_place_that_a_thing_has_left() -> None:
    it = scene()
    it.place_things((PlacedThing("chair3", Pose(5, 3, 0), 3),))
    for pose in (Pose(2, 1, 90), Pose(2, 8, 0)):
        it.move(pose)

    assert [(it.letter(each), it.kind(each)) for each in (Cell(3, 6), Cell(4, 6))] == [
        ("o", Kind.TRAIL),
        (".", Kind.FREE),
    ]


def test_large_squares_reach_as_far_as_the_cells_of_the_floor() -> None:
    it = open_floor()
    it.move(Pose(-14, -13, 0))

    assert it.bounds == Bounds(-4, -3, 20, 20)
    assert MapScale(it, 3).bounds == Bounds(-2, -1, 6, 6)
    assert MapScale(it, 4).bounds == Bounds(-1, -1, 5, 5)


@pytest.mark.parametrize(("columns", "rows", "factor"), [(10, 5, 2), (10, 10**6, 64), (1, 1, 64)])
def test_no_square_is_larger_than_64_cells(columns: int, rows: int, factor: int) -> None:
    bounds = Bounds(0, 0, 9, 9) if factor == 2 else Bounds(0, 0, 10**6, 9)

    assert factor_for(bounds, columns, rows) == factor


@pytest.mark.parametrize(
    ("row", "written"),
    [
        ("c.......", "c chair "),
        (".......c", " chair c"),
        ("c......", "c......"),
        ("......c", "......c"),
    ],
)
def test_a_name_needs_room_up_to_the_edge_of_the_floor(row: str, written: str) -> None:
    chair = Thing("", "chair", "c", "red", row.index("c"), 1, 1, 1, index=1)
    floor = Picture(0, 0, len(row), 2, 1, (row, "." * len(row)), (chair,), has_walls=False)
    found = labels(MapScale(MapScene(floor, Pose(3, 0, 0))), 1, Words())

    assert "".join(found.get(Cell(x, 1), row[x]) for x in range(len(row))) == written


def test_a_thing_has_one_of_its_names() -> None:
    rows = ("c" + "." * 29, "c" + "." * 29, "." * 30)
    red, blue = (
        Thing("", "chair", "c", each, 0, at, 1, 1, index=at) for each, at in (("red", 2), ("blue", 1))
    )
    it = MapScene(Picture(0, 0, 30, 3, 1, rows, (red, blue), has_walls=False), Pose(3, 0, 0))
    found = labels(MapScale(it), 1, Words())

    assert {"".join(found.get(Cell(x, y), ".") for x in range(30)).strip(".") for y in (1, 2)} == {
        " chair, red ",
        " chair, blue ",
    }


# --- a map at a moment of the past


def test_a_map_of_a_large_floor_is_the_part_around_the_robot_that_a_terminal_shows() -> None:
    rows = rows_of(open_floor(rows=("." * 200,) * 100), Words())

    assert {len(each) for each in rows} == {78}
    assert len(rows) == 22
    assert rows[21 - 10][10] == "^"


def test_a_map_has_the_initials_of_colours_where_these_alone_differ_and_have_room() -> None:
    rows = (".fff.fff.", "..f..ttt.", ".........")
    flowers = (
        Thing("", "flower", "f", "red", 2, 2, 3, 1, index=1),
        Thing("", "flower", "f", "blue", 6, 2, 3, 1, index=2),
        Thing("", "flower", "f", "green", 2, 1, 1, 1, index=3),
        Thing("", "table", "t", "red", 6, 1, 3, 1, index=4),
    )
    it = MapScene(Picture(0, 0, 9, 3, 1, rows, flowers, has_walls=False), Pose(0, 0, 0))

    assert rows_of(it, Words()) == (".fRf.fBf.", "..f..ttt.", "^........")


def test_a_map_of_the_past_has_the_trail_the_other_robots_and_moved_things_of_that_moment() -> None:
    def started(robot: str, pose: Pose) -> Stamped:
        how = HowStarted("", 1, fresh=True, terminal=True, trace=False, pose=pose, named=True)
        return Stamped(1, 0.0, RunStarted("a.gd", "court", robot, 0, "1", how), robot)

    def moved(robot: str, pose: Pose) -> Stamped:
        return Stamped(1, 0.0, Moved("FW 2", 2, 2, None, pose, True), robot)

    events = [
        started("alice", Pose(1, 1, 0)),
        started("Bob", Pose(7, 3, 90)),
        moved("alice", Pose(1, 4, 0)),
        Stamped(1, 0.0, ThingsMoved((PlacedThing("tea", Pose(4, 1, 0), 2),)), "alice"),
        moved("Bob", Pose(5, 3, 270)),
    ]
    picture, timeline = court().picture, Timeline(events)
    assert map_at(timeline, picture, "alice") is None
    seen = []
    for _ in events:
        timeline.forward()
        it = map_at(timeline, picture, "alice")
        assert it is not None
        seen.append((rows_of(it, Words())[1:5], it.others))

    start = "#........#", "#..cc..b.#", "#......bb#", "#^t......#"
    assert seen[0] == ((*start[:1], "#..cc..>.#", *start[2:]), {})
    gone = "#........#", "#..cc..>.#", "#........#", "#^t......#"
    assert seen[1] == (gone, {"Bob": Cell(7, 3)})
    assert seen[2][0] == ("#^.......#", "#o.cc..>.#", "#o.......#", "#At......#")
    assert seen[3][0][3] == "#A..t....#"
    assert seen[4] == (
        ("#^.......#", "#o.cc<...#", "#o.......#", "#A..t....#"),
        {"Bob": Cell(5, 3)},
    )


def test_of_a_coarse_picture_a_cell_is_several_steps() -> None:
    """Cells of 2 steps, the middle of the first one at -4, -2."""
    it = MapScene(Picture(-4, -2, 4, 2, 2, (".cc.", "...."), (), has_walls=False), Pose(0, 0, 0))

    assert (it.robot, it.place(Cell(3, 1)), it.cell_at(0.9, -0.9)) == (Cell(2, 1), (2, 0), Cell(2, 1))
    assert it.cell_at(1.1, -1.1) == Cell(3, 0)
    assert (it.bounds.width, it.bounds.height) == (4, 2)
    it.move(Pose(9, 0, 90))
    assert it.bounds == Bounds(0, 0, 7, 1)


@pytest.mark.parametrize(
    ("cell", "widest", "part"),
    [
        (Cell(0, 0), 4, Bounds(0, 0, 3, 3)),
        (Cell(5, 5), 4, Bounds(3, 3, 6, 6)),
        (Cell(9, 9), 4, Bounds(6, 6, 9, 9)),
        (Cell(5, 5), 10, Bounds(0, 0, 9, 9)),
        (Cell(5, 5), 99, Bounds(0, 0, 9, 9)),
    ],
)
def test_a_part_of_a_floor_has_the_robot_in_its_middle_unless_an_edge_is_near(
    cell: Cell, widest: int, part: Bounds
) -> None:
    assert Bounds(0, 0, 9, 9).part(cell, widest, widest) == part
