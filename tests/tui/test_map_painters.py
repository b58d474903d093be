"""The squares of the map, one by one, as letters or as blocks: what is in them and in which colours."""

from __future__ import annotations

from types import SimpleNamespace as Part
from typing import Any

import pytest
from rich.color import Color
from rich.style import Style
from textual.geometry import Size

from donnie_tui.core.map_grid import Cell
from donnie_tui.tui.widgets.map_painters import Blocks, Extent, Letters

HERE, BELOW = Cell(3, 5), Cell(3, 4)
COLOURS = {"thing-red": "red", "thing-blue": "blue", "other-blue": "blue", "wall": "white"}


def look(kind: str) -> Style:
    return Style(color=COLOURS.get(kind), bold=kind != "free")


def scale(here: tuple[str, str], below: tuple[str, str] = ("?", "odd"), **others: Any) -> Any:
    """A scale with these two squares, the lower one on the floor."""
    scene = Part(has_room_for_colour=lambda _cell: True, name_of_robot=lambda cell: f"bob {cell}")
    given = {"factor": 1, "scene": scene, "bounds": Part(bottom=4), "cell_of": lambda square: square}
    return Part(shown={HERE: here, BELOW: below}.__getitem__, **(given | others))


def painted(painter: Any, scale: Any, extent: Extent, row: int = 0) -> tuple[str, str | None, str | None]:
    segment = painter.paint(scale, HERE, extent, row, look)
    colours = [each and each.name for each in (segment.style.color, segment.style.bgcolor)]
    return segment.text, *colours


# --- letters

ONE, TWO, FOUR, SIX = Extent(1, 1), Extent(2, 1), Extent(4, 2), Extent(6, 3)
NO_ROOM = {"scene": Part(has_room_for_colour=lambda _cell: False, name_of_robot=lambda _cell: "")}


@pytest.mark.parametrize(
    ("square", "extent", "row", "others", "text"),
    [
        (("#", "wall"), ONE, 0, {}, "#"),
        (("#", "wall"), FOUR, 1, {}, "####"),
        (("c", "thing-red"), TWO, 0, {}, "cc"),
        (("b", "thing-red"), TWO, 0, {}, "bR"),
        (("b", "thing-red"), FOUR, 1, {}, "bRbR"),
        (("b", "thing-red"), SIX, 2, {}, "bRbRbR"),
        (("b", "thing-mauve"), TWO, 0, {}, "bb"),
        (("b", "thing-red"), ONE, 0, {}, "R"),
        (("b", "thing-red"), ONE, 0, {"factor": 2}, "b"),
        (("b", "thing-red"), ONE, 0, NO_ROOM, "b"),
        (("b", "wall"), TWO, 0, {}, "bb"),
        (("^", "robot"), ONE, 0, {}, "^"),
        (("^", "robot"), TWO, 0, {}, "^b"),
        (("^", "robot"), TWO, 0, NO_ROOM, "^ "),
        ((">", "other-blue"), FOUR, 0, {}, ">b  "),
        ((">", "other-blue"), FOUR, 1, {}, "    "),
        ((".", "free"), ONE, 0, {}, "."),
        ((".", "free"), FOUR, 0, {}, ".   "),
        ((".", "free"), FOUR, 1, {}, "    "),
        (("b", "trail"), TWO, 0, {}, "b "),
    ],
)
def test_walls_and_things_fill_a_square_and_have_initials_where_colours_differ(
    square: tuple[str, str], extent: Extent, row: int, others: dict[str, Any], text: str
) -> None:
    letters = Letters()
    letters.initials, letters.mixed = {"red": "R", "blue": "B"}, frozenset("b")
    assert painted(letters, scale(square, **others), extent, row) == (text, COLOURS.get(square[1]), None)


@pytest.mark.parametrize(
    ("floor", "room", "of_letters", "of_blocks"),
    [((10, 5), (20, 5), 1, 1), ((10, 5), (19, 5), 0, 0), ((10, 5), (20, 4), 1, 0), ((10, 5), (21, 6), 1, 1)],
)
def test_squares_are_two_columns_wide_where_the_floor_fits_so(
    floor: tuple[int, int], room: tuple[int, int], of_letters: int, of_blocks: int
) -> None:
    fitting = [each.fitting(Size(*floor), Size(*room)) for each in (Letters(), Blocks())]
    assert fitting == [of_letters, of_blocks]


def test_a_square_is_twice_as_many_columns_wide_as_it_has_rows() -> None:
    """As a letter is about twice as high as wide. One letter a square is the farthest zoom of letters."""
    farthest, *nearer = Letters.extents
    assert farthest == ONE
    for each in (*nearer, *Blocks.extents):
        assert each.columns * each.stacked == 2 * each.rows


# --- blocks

STACKED = Extent(1, 1, 2)
WALL, RED, BLUE, FREE = ("#", "wall"), ("b", "thing-red"), ("b", "thing-blue"), (".", "free")
TRAIL, GOAL, ROBOT, OTHER = ("o", "trail"), ("x", "goal"), ("^", "robot"), (">", "other-blue")


@pytest.mark.parametrize(
    ("upper", "lower", "text", "colour", "behind"),
    [
        (FREE, FREE, " ", None, None),
        (TRAIL, FREE, "o", None, None),
        (FREE, TRAIL, "o", None, None),
        (TRAIL, GOAL, "o", None, None),
        (RED, FREE, "▀", "red", None),
        (FREE, RED, "▄", "red", None),
        (TRAIL, BLUE, "▄", "blue", None),
        (BLUE, GOAL, "▀", "blue", None),
        (RED, RED, "█", "red", None),
        (WALL, WALL, "█", "white", None),
        (RED, BLUE, "▀", "red", "blue"),
        (RED, WALL, "▀", "red", "white"),
        (WALL, RED, "▄", "red", "white"),
        (ROBOT, RED, "^", None, None),
        (RED, ROBOT, "^", None, None),
        (FREE, OTHER, ">", "blue", None),
        (OTHER, ROBOT, ">", "blue", None),
    ],
)
def test_two_squares_in_a_row_are_half_blocks_and_a_robot_or_a_mark_a_letter(
    upper: tuple[str, str], lower: tuple[str, str], text: str, colour: str | None, behind: str | None
) -> None:
    assert painted(Blocks(), scale(upper, lower), STACKED) == (text, colour, behind)


@pytest.mark.parametrize("own", [None, "default"])
def test_a_wall_in_the_colour_of_texts_is_never_behind_another_block(
    monkeypatch: pytest.MonkeyPatch, own: str | None
) -> None:
    """No background can have the colour that the terminal has for texts."""
    monkeypatch.setitem(COLOURS, "wall", own)
    blocks = Blocks()
    assert painted(blocks, scale(RED, WALL), STACKED) == ("▄", own, "red")
    assert painted(blocks, scale(WALL, RED), STACKED) == ("▀", own, "red")
    assert painted(blocks, scale(WALL, WALL), STACKED) == ("█", own, None)
    assert Color.parse("default").is_default


@pytest.mark.parametrize(
    ("square", "extent", "row", "text"),
    [
        (WALL, TWO, 0, "██"),
        (RED, FOUR, 1, "████"),
        (TRAIL, FOUR, 0, "o   "),
        (TRAIL, FOUR, 1, "    "),
        (FREE, TWO, 0, "  "),
        (ROBOT, SIX, 0, "^     "),
        (ROBOT, SIX, 2, "      "),
    ],
)
def test_a_square_of_its_own_is_a_block_or_a_letter_on_a_blank_floor(
    square: tuple[str, str], extent: Extent, row: int, text: str
) -> None:
    assert painted(Blocks(), scale(square, WALL), extent, row) == (text, COLOURS.get(square[1]), None)


@pytest.mark.parametrize(
    ("square", "text"), [(WALL, "▀"), (RED, "▀"), (FREE, " "), (TRAIL, "o"), (ROBOT, "^")]
)
def test_the_last_row_of_an_odd_number_has_its_upper_half_alone(square: tuple[str, str], text: str) -> None:
    below_all = scale(square, WALL, bounds=Part(bottom=5))
    assert painted(Blocks(), below_all, STACKED) == (text, COLOURS.get(square[1]), None)
