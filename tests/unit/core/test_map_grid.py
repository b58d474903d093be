"""The map as letters: floor, trail, start and robot."""

from dataclasses import dataclass, field
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from devices.ports.robot import Pose
from donnie_tui.core.map_grid import LONGEST_TRAIL, Cell, Kind, MapGrid, arrow_of, cells_between, floor_size


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

    assert (
        sum(drawn.kind(Cell(2, y)) is Kind.TRAIL for y in range(10**9 - 2 * LONGEST_TRAIL, 10**9))
        <= LONGEST_TRAIL
    )
    assert drawn.letter(Cell(2, 10**9)) in "^."


def test_the_oldest_trail_is_forgotten_first_and_its_cells_are_returned():
    drawn = grid()
    drawn.move(Pose(0, LONGEST_TRAIL, 0))
    changed = drawn.move(Pose(10, LONGEST_TRAIL, 90))

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
