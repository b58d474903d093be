"""The walls of a world without an author's text: all around, or on which sides."""

from pathlib import Path

import pytest

from devices.ports.robot import Pose
from donnie_tui.core.describe import _runs, describe, walls_in_words
from donnie_tui.core.map_words import map_in_words
from donnie_tui.i18n.words import Words
from sim.picture import Picture, picture
from sim.worldfile import load_text

DONNIE = "position( size [ 0.1 0.1 0.1 ] pose [ 0 0 0 90 ] ranger( sensor( ) ) )\n"
WALL = "define wall model( size [ 2 0.05 0.24 ] )\n"
NORTH, EAST = "wall( pose [ 0 1 0 0 ] )\n", "wall( pose [ 1 0 0 90 ] )\n"
SOUTH, WEST = "wall( pose [ 0 -1 0 0 ] )\n", "wall( pose [ -1 0 0 90 ] )\n"
TOLD = {
    "": (),
    NORTH: ("Walls from the robot, in steps: 18 north.",),
    NORTH + WEST: ("Walls from the robot, in steps: 18 north, 18 west.",),
    NORTH + EAST + SOUTH: ("Walls from the robot, in steps: 18 north, 18 east, 18 south.",),
    NORTH + EAST + SOUTH + WEST: ("Walls are all around.",),
    "model( size [ 2 2 1 ] boundary 1 )": ("Walls are all around.",),
    "wall( pose [ 2 2 0 0 ] )": ("No wall is straight north, east, south or west.",),
}


@pytest.mark.parametrize("walls", TOLD, ids=range(len(TOLD)))
def test_walls_are_described_by_their_sides_or_as_all_around(walls: str) -> None:
    seen = picture(load_text(WALL + DONNIE + walls, Path("my.world")))

    assert walls_in_words(seen, Pose(0, 0, 0), Words()) == TOLD[walls]
    assert map_in_words(seen, Pose(0, 0, 0), Words())[1:-1] == TOLD[walls]
    said = describe(seen, Pose(0, 0, 0), Words(), robot="donnie")
    assert said[1 : 1 + len(TOLD[walls])] == TOLD[walls]


@pytest.mark.parametrize("heading", [0, 90, 215])
def test_the_sides_are_those_of_the_compass_at_any_heading(heading: int) -> None:
    seen = picture(load_text(WALL + DONNIE + NORTH, Path("my.world")))

    (said,) = walls_in_words(seen, Pose(0, 0, heading), Words("es"))

    assert said.endswith(": 18 al norte.")


def test_a_wall_is_seen_straight_on_alone() -> None:
    """Posts of a step far away, which a robot would pass that drives one degree off."""
    posts = tuple(
        ((x - 0.5, y - 0.5), (x + 0.5, y - 0.5), (x + 0.5, y + 0.5), (x - 0.5, y + 0.5))
        for x, y in ((0, 90), (91, 0), (0, -92), (-93, 0))
    )
    body = ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))
    floor = Picture(-1, -1, 3, 3, 1, ("...",) * 3, (), True, posts, (body,))

    assert walls_in_words(floor, Pose(0, 0, 0), Words()) == (
        ("Walls from the robot, in steps: 89 north, 90 east, 91 south, 92 west.",)
    )


@pytest.mark.parametrize(
    ("row", "left", "right", "runs"),
    [
        ("..#..", 0, 5, [0, 3]),
        ("..#..", 1, 5, [1, 3]),
        (".##.#", 2, 4, [3]),
        (".....", 2, 5, [2]),
        ("##", 0, 2, []),
    ],
)
def test_a_run_of_free_squares_has_its_first_square(row: str, left: int, right: int, runs: list[int]) -> None:
    assert list(_runs(row, left, right)) == runs


def test_a_winding_way_out_is_found_and_a_closed_room_has_none() -> None:
    rows = ("#######", "#...#..", "#.#.#.#", "#.#...#", "#.#####", "#.#...#", "#######")
    closed = (*rows[:1], "#...#.#", *rows[2:])
    for floor, pose, said in (
        (rows, Pose(1, 1, 0), "No wall is straight"),
        (closed, Pose(1, 1, 0), "Walls are all around."),
        (rows, Pose(4, 1, 0), "Walls are all around."),
    ):
        square = ((-0.5, 6.5), (0.5, 6.5), (0.5, 7.5), (-0.5, 7.5))
        (line,) = walls_in_words(Picture(0, 0, 7, 7, 1, floor, (), True, (square,)), pose, Words())
        assert line.startswith(said)
