"""The map as letters: floor, trail, start and robot."""

from dataclasses import dataclass, field
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from devices.ports.robot import Pose
from donnie_tui.core import map_grid
from donnie_tui.core.events import Moved, Stamped
from donnie_tui.core.map_grid import (
    Bounds,
    Cell,
    Kind,
    MapGrid,
    arrow_of,
    cells_between,
    floor_size,
    path_in_words,
    place_in_words,
)
from donnie_tui.core.timeline import SAME_PLACE, DrivenPath, Trail
from donnie_tui.i18n.words import Words


@dataclass(frozen=True)
class Floor:
    """A floor as the simulator draws it."""

    rows: tuple[str, ...]
    left: int = -2
    bottom: int = -1
    cell: int = 1
    things: tuple = field(default=())

    @property
    def width(self) -> int:
        return len(self.rows[0])

    @property
    def height(self) -> int:
        return len(self.rows)


@dataclass(frozen=True)
class Table:
    name: str
    letter: str
    x: float
    y: float


ROOM = Floor(("#######", "#..t..#", "#.....#", "#.....#", "#######"), things=(Table("table", "t", 1, 2),))


def grid(x: float = 0.0, y: float = 0.0, heading: float = 0.0, floor: Floor = ROOM) -> MapGrid:
    return MapGrid(floor, Pose(x, y, heading))


def test_a_goal_has_all_free_cells_of_its_place_and_none_beyond_the_floor() -> None:
    """The first cell of the floor is 2 steps west and 1 south of the start."""
    marked = grid()
    marked.mark_goals([(1, 0.0, 1.0, 1.0, 2.0), (2, 2.0, 0.0, 9.0, 1.0)])

    assert marked.goals == {
        **dict.fromkeys((Cell(2, 2), Cell(3, 2), Cell(2, 3)), 1),
        **dict.fromkeys((Cell(4, 1), Cell(5, 1), Cell(4, 2), Cell(5, 2)), 2),
    }


def test_the_robot_stands_in_the_cell_with_its_place_in_the_middle():
    assert grid().rows() == ("#######", "#..t..#", "#.....#", "#.^...#", "#######")


def test_a_walk_leaves_a_trail_from_the_start():
    drawn = grid()
    drawn.move(Pose(0, 2, 0))
    drawn.move(Pose(0, 2, 90))
    drawn.move(Pose(2, 2, 90))

    assert drawn.rows() == ("#######", "#.oo>.#", "#.o...#", "#.A...#", "#######")


def test_a_move_returns_exactly_the_cells_that_look_different():
    drawn = grid()
    before = drawn.rows()
    changed = drawn.move(Pose(2, 0, 90))
    after = drawn.rows()

    differing = {Cell(x, 4 - row) for row in range(5) for x in range(7) if before[row][x] != after[row][x]}
    assert differing <= changed
    assert drawn.move(Pose(2.1, 0.2, 91)) == frozenset()


def test_a_new_run_forgets_the_trail():
    drawn = grid()
    drawn.move(Pose(2, 0, 90))
    drawn.begin(Pose(0, 0, 0))

    assert drawn.rows() == grid().rows()


@pytest.mark.parametrize(
    ("heading", "arrow"),
    [
        (0, "^"),
        (45, "/"),
        (90, ">"),
        (135, "\\"),
        (180, "v"),
        (225, "/"),
        (270, "<"),
        (315, "\\"),
        (359, "^"),
        (20, "^"),
    ],
)
def test_the_arrow_points_where_the_robot_looks(heading, arrow):
    assert arrow_of(heading) == arrow


def test_the_floor_beyond_the_picture_is_free_and_the_map_grows():
    drawn = grid()
    drawn.move(Pose(0, -3, 180))

    assert drawn.bounds.bottom == -2
    assert [row[2] for row in drawn.rows()] == ["#", ".", ".", "A", "o", "o", "v"]


def test_a_walk_of_a_thousand_million_steps_costs_a_bounded_trail():
    drawn = grid()
    drawn.move(Pose(0, 1e9, 0))

    assert sum(drawn.kind(Cell(2, y)) is Kind.TRAIL for y in range(10**9 - 20_000, 10**9)) == 10_000
    assert drawn.letter(Cell(2, 10**9)) in "^."


def test_the_oldest_trail_is_forgotten_first_and_its_cells_are_returned():
    drawn = grid()
    drawn.move(Pose(0, 10_000, 0))
    changed = drawn.move(Pose(10, 10_000, 90))

    assert drawn.kind(Cell(2, 2)) is Kind.FREE
    assert Cell(2, 2) in changed


def test_a_cell_describes_what_it_shows():
    drawn = grid()
    drawn.move(Pose(1, 0, 90))

    assert drawn.kind(Cell(2, 1)) is Kind.START
    assert drawn.kind(Cell(3, 1)) is Kind.ROBOT
    assert drawn.kind(Cell(0, 0)) is Kind.WALL
    assert drawn.kind(Cell(3, 3)) is Kind.THING
    assert drawn.thing(Cell(3, 3)).name == "table"
    assert drawn.thing(Cell(1, 1)) is None
    assert drawn.place(Cell(2, 1)) == (0, 0)


def test_the_size_of_a_floor_is_described_without_its_walls():
    assert floor_size(ROOM) == (5, 3)
    assert floor_size(Floor(("...", "..."))) == (3, 2)


def test_in_a_very_large_world_a_cell_is_several_steps():
    drawn = grid(floor=Floor(("...", "...", "..."), left=0, bottom=0, cell=10), x=12, y=9)

    assert drawn.rows() == ("...", ".^.", "...")
    assert drawn.place(drawn.robot) == (10, 10)


_STEPS = st.integers(-50, 50)


@given(st.tuples(_STEPS, _STEPS), st.tuples(_STEPS, _STEPS))
def test_the_way_between_two_cells_has_no_gap(start, end):
    way = (*cells_between(Cell(*start), Cell(*end), 1000), Cell(*end))

    assert way[0] == start
    assert all(max(abs(a.x - b.x), abs(a.y - b.y)) <= 1 for a, b in pairwise(way))


@given(st.lists(st.tuples(st.floats(-4, 6), st.floats(-3, 5), st.integers(0, 359)), max_size=12))
def test_the_map_is_a_full_rectangle_with_one_robot(places):
    drawn = grid()
    for x, y, heading in places:
        drawn.move(Pose(x, y, float(heading)))
    rows = drawn.rows()

    assert len(rows) == drawn.bounds.height
    assert {len(row) for row in rows} == {drawn.bounds.width}
    assert sum(letter in "^/>\\v<" for row in rows for letter in row) == 1


# --- squares one by one


def test_exactly_the_squares_that_look_different_are_returned() -> None:
    drawn = grid()

    assert drawn.move(Pose(2, 0, 90)) == {Cell(2, 1), Cell(3, 1), Cell(4, 1)}
    assert drawn.move(Pose(2, 0, 180)) == {Cell(4, 1)}
    assert drawn.move(Pose(2.4, -0.4, 180)) == frozenset()
    assert drawn.begin(Pose(1, 1, 0)) == {Cell(2, 1), Cell(3, 1), Cell(4, 1), Cell(3, 2)}
    assert drawn.begin(Pose(1, 1, 90)) == {Cell(3, 2)}
    assert drawn.rows() == ("#######", "#..t..#", "#..>..#", "#.....#", "#######")


@pytest.mark.parametrize(
    ("x", "y", "cell"),
    [
        (0.5, -0.5, (3, 1)),
        (0.49, -0.51, (2, 0)),
        (-0.5, 1.4999999, (2, 3)),
        (1e12, -1e12, (10**9, -(10**9))),
    ],
)
def test_a_place_between_two_squares_is_in_the_eastern_and_the_northern_one(
    x: float, y: float, cell: tuple[int, int]
) -> None:
    assert grid().cell_at(x, y) == cell


def test_goals_are_the_first_ones_of_a_square_and_are_shown_below_the_robot_alone() -> None:
    drawn = grid()
    drawn.mark_goals([(9, 0, 0, 1, 0), (10, 1, 0, 2, 0), (11, 3, 0, 3, 0), (12, 0, 2, 2, 2)])

    assert drawn.rows()[1:4] == ("#.*t*.#", "#.....#", "#.^9**#")
    drawn.move(Pose(2, 0, 90))
    assert drawn.rows()[3] == "#.99>*#"
    assert [drawn.kind(Cell(x, 1)) for x in (2, 3, 4)] == [Kind.GOAL, Kind.GOAL, Kind.ROBOT]
    assert drawn.marked == {*(Cell(x, 1) for x in (2, 3, 4, 5)), Cell(2, 3), Cell(4, 3)}
    drawn.hidden = frozenset({Kind.GOAL})
    assert (drawn.rows()[3], drawn.goals) == ("#.Ao>.#", {})
    assert [drawn.kind(Cell(x, 1)) for x in (1, 2, 3)] == [Kind.FREE, Kind.START, Kind.TRAIL]
    drawn.hidden = frozenset({Kind.TRAIL})
    drawn.mark_goals([])
    assert drawn.rows()[3] == "#...>.#"
    assert {drawn.kind(Cell(x, 1)) for x in (1, 2, 3)} == {Kind.FREE}
    assert drawn.marked == {Cell(2, 1), Cell(3, 1)}


def test_a_goal_at_the_edges_of_a_floor_without_walls_is_on_it() -> None:
    open_floor = Floor(("...", "...", "..."), left=0, bottom=0)
    drawn = grid(1, 1, floor=open_floor)
    drawn.mark_goals([(1, -5, -5, 9, 9)])

    assert drawn.rows() == ("111", "1^1", "111")
    assert drawn.goals == {Cell(x, y): 1 for x in range(3) for y in range(3)}
    assert [drawn.floor_letter(Cell(*each)) for each in ((0, 0), (2, 2), (3, 0), (0, 3), (-1, 0))] == [
        "."
    ] * 5
    assert [
        grid().floor_letter(Cell(*each)) for each in ((0, 0), (6, 4), (7, 4), (6, 5), (-1, 0), (0, -1))
    ] == [*"##...."]


def test_of_things_of_a_letter_the_nearest_one_is_there() -> None:
    for x, y in ((2.5, 2), (1, 3.5)):
        tables = (Table("far", "t", -1, 2), Table("far", "t", 1, -2), Table("near", "t", x, y))
        tables += (Table("other", "u", 1, 2),)

        assert grid(floor=Floor(ROOM.rows, things=tables)).thing(Cell(3, 3)).name == "near"


@pytest.mark.parametrize(
    ("width", "depth", "cell", "is_wide"),
    [(1.5, 0, 1, True), (1.4, 1.4, 1, False), (0, 1.5, 1, True), (2.9, 2.9, 2, False), (3, 1, 2, True)],
)
def test_a_thing_is_wide_from_one_and_a_half_squares_on(
    width: float, depth: float, cell: int, is_wide: bool
) -> None:
    @dataclass(frozen=True)
    class Box:
        width: float
        depth: float

    assert grid(floor=Floor(("...",), cell=cell)).is_wide(Box(width, depth)) is is_wide


@pytest.mark.parametrize(
    ("rows", "size"),
    [
        (("###", "#.#", "###"), (1, 1)),
        (("..#", "..#", "..#"), (2, 3)),
        (("...", "...", "###"), (3, 2)),
        (("##", "##"), (2, 2)),
        (("#.#", "..#"), (2, 2)),
        (("###",), (1, 1)),
    ],
)
def test_a_floor_is_without_the_rows_and_columns_at_its_ends_that_are_only_wall(
    rows: tuple[str, ...], size: tuple[int, int]
) -> None:
    assert floor_size(Floor(rows)) == size
    assert floor_size(Floor(rows, cell=5)) == (5 * size[0], 5 * size[1])


@pytest.mark.parametrize(
    ("heading", "arrow"), [(22, "^"), (23, "/"), (67, "/"), (68, ">"), (338, "^"), (337, "\\")]
)
def test_an_arrow_is_the_nearest_of_eight(heading: float, arrow: str) -> None:
    assert arrow_of(heading) == arrow


@pytest.mark.parametrize(
    ("start", "end", "most", "cells"),
    [
        ((0, 0), (3, 1), 9, [(0, 0), (1, 0), (2, 1)]),
        ((0, 0), (-3, -1), 9, [(0, 0), (-1, 0), (-2, -1)]),
        ((1, 1), (2, 5), 9, [(1, 1), (1, 2), (2, 3), (2, 4)]),
        ((0, 0), (3, 1), 2, [(1, 0), (2, 1)]),
        ((0, 0), (2, 2), 2, [(0, 0), (1, 1)]),
        ((4, 4), (4, 4), 9, []),
    ],
)
def test_the_way_between_two_cells_is_the_nearest_to_the_straight_one(
    start: tuple[int, int], end: tuple[int, int], most: int, cells: list[tuple[int, int]]
) -> None:
    assert list(cells_between(Cell(*start), Cell(*end), most)) == cells


def test_bounds_are_widened_to_each_side_alone() -> None:
    bounds = Bounds(0, 0, 4, 2)

    assert (bounds.width, bounds.height) == (5, 3)
    assert bounds.around(Cell(2, 1)) == bounds
    assert bounds.around(Cell(-1, 1)) == Bounds(-1, 0, 4, 2)
    assert bounds.around(Cell(5, 3)) == Bounds(0, 0, 5, 3)
    assert bounds.around(Cell(2, -2)) == Bounds(0, -2, 4, 2)
    assert bounds.part(Cell(2, 1), 3, 9) == Bounds(1, 0, 3, 2)
    assert bounds.part(Cell(0, 2), 3, 2) == Bounds(0, 1, 2, 2)
    assert bounds.part(Cell(4, 0), 4, 1) == Bounds(1, 0, 4, 0)


def test_a_square_that_is_visited_again_is_forgotten_later(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(map_grid, "LONGEST_TRAIL", 4)
    drawn = grid()
    for x, y in ((2, 0), (0, 0)):
        drawn.move(Pose(x, y, 0))
    changed = drawn.move(Pose(0, 3, 0))

    assert [drawn.kind(Cell(x, 1)) for x in (2, 3, 4)] == [Kind.START, Kind.TRAIL, Kind.FREE]
    assert changed == {Cell(4, 1), *(Cell(2, y) for y in (1, 2, 3, 4))}


# --- paths in words


def said(*places: tuple[float, float], most: int | None = None, **of_path: object) -> list[str]:
    path = DrivenPath("", tuple(Pose(*each, 0.0) for each in places), **of_path)
    return list(path_in_words(path, Words(), most))


@pytest.mark.parametrize(
    ("end", "leg"),
    [
        ((3.0, 3.0), "Northeast: 4 steps, to 3, 3."),
        ((-0.6, 0.0), "West: 1 step, to 0, 0."),
        ((1.9, -1.9), "Southeast: 3 steps, to 1, -1."),
        ((10.0, 0.05), "East: 10 steps, to 10, 0."),
        ((-0.001, 10.0), "North: 10 steps, to 0, 10."),
        ((4.0, 3.0), "53 degrees, near northeast: 5 steps, to 4, 3."),
    ],
)
def test_a_leg_has_its_direction_its_length_and_its_end(end: tuple[float, float], leg: str) -> None:
    assert said((0, 0), end)[1] == leg


def test_a_leg_towards_one_of_eight_points_has_its_name_alone() -> None:
    way = DrivenPath("", (Pose(0, 0, 0), Pose(3, 3, 0), Pose(3, -1, 0)))

    assert path_in_words(way, Words("pt"))[1:3] == (
        ("Nordeste: 4 passos, até 3, 3.", "Sul: 4 passos, até 3, -1.")
    )


def test_a_bend_of_less_than_a_degree_is_straight_on_and_a_turn_on_the_spot_is_no_leg() -> None:
    assert len(said((0, 0), (100, 0), (200, 1.6), (200, 1.6), (300, 1.6))) == 3
    assert len(said((0, 0), (100, 0), (200, 1.9))) == 4
    assert len(said((0, 0), (0, 100), (-1.5, 200))) == 3
    assert said((0, 0), (0, 0.01), (0, 0)) == ["I have not moved yet."]
    assert said((0, 0), (0.005, 0), (5, 0))[1:] == ["East: 5 steps, to 5, 0.", "5 steps in all."]
    assert said((1.9, 0), (1.9, 2))[0] == "The path starts at 1, 0."
    assert said((0, 0), (0, 3), (0, 7))[1:] == ["North: 7 steps, to 0, 7.", "7 steps in all."]
    assert said((0, 0), (SAME_PLACE, 0)) == ["I have not moved yet."]


def test_a_leg_ends_after_the_smallest_moves_that_follow_it() -> None:
    assert said((0, 0), (5, 0.995), (5, 1.003))[1:] == [
        *("79 degrees, near east: 5 steps, to 5, 1.", "5 steps in all.")
    ]


def test_of_more_legs_than_wanted_those_in_the_middle_are_left_out() -> None:
    stairs = [(at // 2, (at + 1) // 2) for at in range(8)]

    assert said(*stairs, most=7) == said(*stairs, most=20) == said(*stairs)
    assert len(said(*stairs)) == 9
    assert said(*stairs, most=4) == [
        "The path starts at 0, 0.",
        "North: 1 step, to 0, 1.",
        "East: 1 step, to 1, 1.",
        "I leave out 3 legs, to 2, 3.",
        "East: 1 step, to 3, 3.",
        "North: 1 step, to 3, 4.",
        "7 steps in all.",
    ]
    assert said(*stairs, most=6)[4] == "I leave out 1 leg, to 2, 2."


def test_rounds_and_a_gap_that_are_left_out_have_their_steps() -> None:
    assert said((0, 0), (0, 5), driven=(0.0, 6.0))[1:] == [
        "North: 5 steps, to 0, 5.",
        "I leave out 1 step of repeated rounds.",
        "6 steps in all.",
    ]
    assert said((0, 0), (0, 5), driven=(0.0, 5.9))[1:] == ["North: 5 steps, to 0, 5.", "6 steps in all."]
    assert said((0, 0), (0, 5), (0, 9), driven=(0.0, 7.4, 14.4), has_gap=True) == [
        "The path starts at 0, 0.",
        "7 steps that I forgot, to 0, 5.",
        "North: 4 steps, to 0, 9.",
        "I leave out 3 steps of repeated rounds.",
        "14 steps in all.",
    ]
    assert said((0, 0), (0, 5), driven=(0.0, 7.4), has_gap=True)[1:] == [
        *("7 steps that I forgot, to 0, 5.", "7 steps in all.")
    ]


def test_the_answer_to_where_has_the_last_move_at_full() -> None:
    place, *more = place_in_words(Pose(1, 2, 90), Trail(), Words(), is_full=True)

    assert place_in_words(Pose(1, 2, 90), Trail(), Words(), is_full=False) == (place,)
    assert more == ["I have not moved yet."]
    driven = Trail()
    for number, steps in enumerate((3, 5), 1):
        moved = Moved(f"FW {steps}", steps, steps, None, Pose(0, steps, 0), True)
        driven.on_event(Stamped(number, 0.0, moved))
    assert place_in_words(Pose(1, 2, 90), driven, Words(), is_full=True) == (
        (place, "FW 5: 5 steps, to 0, 5.")
    )
