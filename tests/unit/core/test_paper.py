"""A world on paper: letters with one meaning each, braille pages of 40 by 25, and swell paper."""

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cache
from itertools import combinations, pairwise, product
from math import ceil, cos, hypot, radians, sin
from pathlib import Path
from string import ascii_lowercase, digits
from xml.etree import ElementTree

import pytest
from PIL import ImageFont

import worlds
from devices.ports.robot import STEP, Pose
from donnie_tui.core.chart import (
    ASCII,
    Chart,
    ChartedRobot,
    ColourMark,
    braille,
    braille_pages,
    chart,
    colour_marks,
    dots,
    shrunk,
    with_marks,
    wrapped,
)
from donnie_tui.core.paper import (
    A4,
    LINE,
    PRINT,
    Nearby,
    _extent,
    box_of,
    boxes_apart,
    from_segment,
    is_between,
    raised_picture,
)
from donnie_tui.i18n.words import Words
from sim.picture import Drawing, Picture, Thing, drawings, picture
from sim.scene import Scene
from sim.worldfile import load_world
from worlds.words import about

SVG = "{http://www.w3.org/2000/svg}"


@cache
def scene(name: str) -> Scene:
    return load_world(Path(worlds.path(name)), allowed=(Path(worlds.SCENES),))


@cache
def seen(name: str) -> Picture:
    return picture(scene(name))


def charted(name: str, language: str = "en") -> Chart:
    it = scene(name)
    if not it.robots:
        return chart(seen(name), Pose(0.0, 0.0, 0.0), None, Words(language))
    robot = it.models[it.robots[0]]
    pose = Pose(robot.pose.x / STEP, robot.pose.y / STEP, (90 - robot.pose.yaw) % 360)
    return chart(seen(name), pose, robot.name, Words(language))


def pages(name: str, language: str = "en") -> list[list[str]]:
    """Lines by page."""
    text = braille_pages(f"Map of {name}", charted(name, language), Words(language))
    assert text.endswith("\f")
    return [page.split("\r\n")[:-1] for page in text.split("\f")[:-1]]


def sheet(name: str, language: str = "en", paths: Sequence[Sequence[Pose]] = ()) -> ElementTree.Element:
    it, plan = scene(name), charted(name, language)
    text = raised_picture(f"Map of {name}", plan, seen(name), drawings(it), Words(language), paths)
    return ElementTree.fromstring(text)


# --- letters


def test_every_letter_of_a_chart_has_one_meaning_whatever_its_case() -> None:
    it = charted("living_room")

    assert set("".join(it.rows)) - {"."} == set(it.legend)
    assert it.legend == {
        "#": "wall",
        "d": "donnie, looks north",
        "s": "small sofa, blue",
        "l": "large sofa, blue",
        "t": "table, red",
        "c": "chair, green",
    }


def test_each_robot_has_a_letter_of_its_own() -> None:
    it = charted("two_robots")

    assert [(each.name, each.letter) for each in it.robots] == [("alice", "a"), ("bob", "o")]
    assert it.legend["o"] == "bob, looks south"
    assert it.legend["b"] == "box, r red, l blue"
    assert sum(row.count("o") for row in it.rows) == 9
    assert sum(row.count("a") for row in it.rows) == 1


def test_too_many_robots_share_a_letter() -> None:
    others = tuple(
        Thing(f"r{each}", "donnie", "d", "red", each, 0, 1, 1, is_robot=True) for each in range(1, 30)
    )
    it = chart(
        Picture(0, 0, 30, 1, 1, ("." + "d" * 29,), others, has_walls=False), Pose(0, 0, 0), "r0", Words()
    )

    assert len({each.letter for each in it.robots}) == 7
    assert it.robots[-1].letter == "z"
    assert it.legend[it.robots[-1].letter] == "24 more robots"


def test_the_shared_letter_is_the_last_one_that_no_thing_has() -> None:
    z = Thing("", "zebra", "Z", "red", 0, 0, 1, 1)
    seven = tuple(
        Thing(f"r{each}", "donnie", "d", "red", each, 0, 1, 1, is_robot=True) for each in range(1, 8)
    )
    floor = Picture(0, 0, 8, 1, 1, ("Z" + "d" * 7,), (z, *seven), has_walls=False)
    it = chart(floor, Pose(0, 0, 0), None, Words())

    assert it.robots[-1].letter == "y"
    assert set(it.legend) == {each.letter for each in it.robots} | {"z"}


def test_an_endless_floor_ends_on_paper_at_the_outer_edges_of_the_cells_of_its_map() -> None:
    """Five by three cells of four steps; the middle of the first is at -8, -4."""
    floor = Picture(-8, -4, 5, 3, 4, (".....",) * 3, (), has_walls=False)

    assert _extent(floor, ()) == (-10, -6, 10, 6)


def test_a_robot_outside_of_the_map_is_in_the_legend_only() -> None:
    it = chart(Picture(0, 0, 3, 1, 1, ("...",), (), has_walls=False), Pose(50, 0, 0), "me", Words())

    assert (it.rows, it.legend) == (("...",), {"m": "me, looks north"})


def test_every_square_of_a_robot_has_its_letter() -> None:
    body = Thing("other", "rover", "r", "red", 7, 2, 5, 3, is_robot=True)
    rows = ("." * 11, "." * 11, *[".....rrrrr."] * 3, "." * 11)
    it = chart(Picture(0, 0, 11, 6, 1, rows, (body,), has_walls=False), Pose(0, 0, 0), None, Words())

    assert it.rows == tuple(row.replace("r", "o") for row in rows)
    wide = Thing("other", "rover", "r", "red", 10, 9, 15, 13, is_robot=True)
    rows = tuple("".join("r" if 3 <= x <= 17 and 3 <= y <= 15 else "." for x in range(21)) for y in range(19))
    it = chart(Picture(0, 0, 21, 19, 1, rows, (wide,), has_walls=False), Pose(0, 0, 0), None, Words())

    assert it.rows == tuple(row.replace("r", "o") for row in rows)


def test_a_robot_without_a_name_is_called_by_its_kind() -> None:
    other = Thing("", "rover", "r", "red", 1, 0, 1, 1, is_robot=True)
    it = chart(Picture(0, 0, 3, 1, 1, (".r.",), (other,), has_walls=False), Pose(0, 0, 0), None, Words())

    assert (it.rows, it.legend) == ((".r.",), {"r": "rover, looks north"})


@pytest.mark.parametrize(
    ("rows", "row", "marked"),
    [
        (("f..f",), 0, None),  # a square each has no room; the last square of a row is not next to the first
        (("ff.f", "...f"), 0, ("fr.f", "...b")),
        (("f...", "f.ff"), 1, ("f...", "r.fb")),
        (("f..f", "f..."), 0, None),  # all are marked, or none
    ],
)
def test_the_initial_of_a_colour_is_the_second_letter_of_its_thing(
    rows: tuple[str, ...], row: int, marked: tuple[str, ...] | None
) -> None:
    def mark(column: int, initial: str) -> ColourMark:
        return ColourMark(row, column, Thing("", "flower", "f", initial, column, 0, 1, 1), initial)

    assert with_marks(rows, [mark(0, "r"), mark(3, "b")]) == (
        (rows, frozenset()) if marked is None else (marked, {"f"})
    )


def test_a_block_of_letters_keeps_what_matters_most() -> None:
    rows = ("..##..^.", "..#c....", "....#...", "........")

    assert shrunk(rows, 2, 2, "^") == (".c.^", "..#.")
    assert shrunk(rows, 1, 1) == rows
    assert shrunk(rows, 3, 3, "^") == ("#c^", "...")
    assert shrunk(("c^^c#c",), 2, 1, "^") == ("^^c",)
    assert shrunk(("c^^c",), 2, 1) == ("c^",)


def test_only_things_with_a_known_colour_on_the_map_are_marked_from_north_to_south() -> None:
    things = (
        Thing("", "box", "b", "red", 2, 0, 1, 1, index=1),
        Thing("", "box", "b", "blue", 0, 1, 1, 1, index=2),
        Thing("", "box", "b", "blue", 1, 0, 1, 1, index=3),
        Thing("", "box", "b", "blue", 9, 0, 1, 1, index=4),
        Thing("", "box", "b", "", 0, 0, 1, 1, index=5),
        Thing("", "donnie", "b", "red", 2, 1, 1, 1, is_robot=True, index=6),
        Thing("", "cup", "c", "red", 1, 1, 1, 1, index=7),
    )
    marks = colour_marks(
        Picture(0, 0, 3, 2, 1, ("bcb", "bbb"), things, has_walls=False), {"red": "R", "blue": "B"}
    )

    assert [(each.row, each.column, each.thing.index, each.initial) for each in marks] == [
        (0, 0, 2, "B"),
        (1, 1, 3, "B"),
        (1, 2, 1, "R"),
    ]


@pytest.mark.parametrize(
    ("rows", "row", "column", "marked"),
    [
        (("..ff",), 0, 3, ("..fR",)),
        (("ff..",), 0, 0, ("fR..",)),
        (("fff.",), 0, 1, ("fRf.",)),
        (("f", "f", "."), 0, 0, ("f", "R", ".")),
        ((".", "f", "f"), 2, 0, (".", "f", "R")),
        (("f.", "fF"), 1, 0, ("f.", "fR")),
        (("f.", ".f"), 0, 0, None),
        (("f", ".", "f"), 0, 0, None),
    ],
)
def test_the_second_letter_is_after_the_first_or_under_it(
    rows: tuple[str, ...], row: int, column: int, marked: tuple[str, ...] | None
) -> None:
    thing = Thing("", "flower", "F", "red", 0, 0, 1, 1)
    found = with_marks(rows, [ColourMark(row, column, thing, "R")])

    assert found == ((rows, frozenset()) if marked is None else (marked, {"F"}))


def test_the_place_of_a_mark_is_shrunk_as_the_rows_are() -> None:
    thing = Thing("", "flower", "f", "red", 0, 0, 1, 1)
    mark = ColourMark(5, 5, thing, "R")

    assert with_marks(("....", ".ff.", "...."), [mark], 2, 3)[0] == ("....", ".fR.", "....")
    assert with_marks(("....", "....", ".ff."), [mark], 4, 2)[0] == ("....", "....", ".fR.")


@pytest.mark.parametrize(("count", "letters", "last"), [(6, "abcdef", "f"), (8, "abcdefzz", "z")])
def test_six_robots_have_letters_of_their_own(count: int, letters: str, last: str) -> None:
    robots = tuple(
        Thing(letter, "donnie", "d", "red", at, 0, 1, 1, is_robot=True, heading=90.0)
        for at, letter in enumerate(ascii_lowercase[:count])
    )
    floor = Picture(0, 0, 8, 1, 1, ("d" * count + "." * (8 - count),), robots, has_walls=False)
    it = chart(floor, Pose(0, 0, 0), None, Words())

    assert "".join(each.letter for each in it.robots) == letters
    assert it.rows == (letters + "." * (8 - count),)
    assert it.legend["f"] == "f, looks east"
    assert it.legend[last] == ("f, looks east" if count == 6 else "2 more robots")
    assert len(it.legend) == len({*letters})


def test_the_initial_of_a_colour_is_no_letter_of_a_robot_or_a_thing() -> None:
    """Neither of red is left: r is the robot's, e a thing's."""
    things = tuple(
        Thing("", kind, kind[0].upper(), colour, x, 0, 3, 1, index=x)
        for kind, colour, x in (("flower", "red", 1), ("flower", "blue", 5), ("elk", "gray", 8))
    )
    floor = Picture(0, 0, 10, 1, 1, ("FFF.FFF.E.",), things, has_walls=False)
    it = chart(floor, Pose(9, 0, 0), "r", Words())

    assert it.rows == ("fff.fff.er",)
    assert it.legend == {"r": "r, looks north", "e": "elk, gray", "f": "flower, d red, b blue"}


def test_a_robot_whose_box_leaves_the_map_has_its_middle_alone() -> None:
    robot = Thing("bob", "donnie", "d", "red", 1, 0, 5, 1, is_robot=True)
    floor = Picture(0, 0, 3, 1, 1, ("ddd",), (robot,), has_walls=True)
    it = chart(floor, Pose(0, 0, 0), None, Words())

    assert it.rows == ("dbd",)
    assert it.legend == {"#": "wall", "b": "bob, looks north"}


# --- braille


@pytest.mark.parametrize(
    ("language", "text", "cells"),
    [
        ("en", "Map, 12 by 3.", "MAP1 #AB BY #C4"),
        ("en", "North: 0", "NORTH3 #J"),
        ("pt", "câmara, parede, não é", "C*MARA1 PAREDE1 N>O ="),
        ("es", "niño, aquí está.", "NI]O1 AQU/ EST('"),
        ("en", "über 漢 \x1b", "UBER    "),
        ("en", "a;b-c'd_e/f", "A2B-C'D-E-F"),
        ("en", "1234567890", "#ABCDEFGHIJ"),
        ("en", "10 20a3", "#AJ #BJA#C"),
        ("en", "az AZ", "AZ AZ"),
    ],
)
def test_text_becomes_ascii_braille(language: str, text: str, cells: str) -> None:
    assert braille(text, language) == cells


def test_there_are_sixty_four_cells_each_with_its_dots() -> None:
    assert len(set(ASCII)) == len(ASCII) == 64
    assert [dots(each) for each in " ACL=#'"] == [
        (),
        (1,),
        (1, 4),
        (1, 2, 3),
        (1, 2, 3, 4, 5, 6),
        (3, 4, 5, 6),
        (3,),
    ]


@pytest.mark.parametrize(
    ("line", "parts"),
    [
        ("f  flower, b blue, y yellow", ["f  flower, b blue,", "   y yellow"]),
        ("F  FLOWER1 B BLUE1 Y YELLOW", ["F  FLOWER1 B BLUE1", "   Y YELLOW"]),
        ("f  flower, blue and a yellow", ["f  flower, blue and a", "   yellow"]),
    ],
)
def test_the_initial_of_a_colour_stays_with_its_colour(line: str, parts: list[str]) -> None:
    assert wrapped(line, 21) == parts


def test_a_letter_that_several_kinds_share_names_three_of_them_and_all_their_colours() -> None:
    kinds = ("box", "bed", "ball", "bin", "box")
    colours = ("red", "red", "blue", "green", "yellow")
    things = tuple(
        Thing("", kind, "B" if at else "b", colour, at, 0, 1, 1, index=at)
        for at, (kind, colour) in enumerate(zip(kinds, colours, strict=True))
    )
    it = chart(Picture(0, 0, 5, 1, 1, ("bBBBB",), things, has_walls=False), Pose(9, 9, 0), None, Words())

    assert it.legend["b"].startswith("box, bed, ball, ")
    assert it.rows == ("bbbbb",)
    assert "bin" not in it.legend["b"]
    assert all(colour in it.legend["b"] for colour in colours)


def test_a_robot_has_a_letter_that_no_thing_has() -> None:
    """Of its name, else of the alphabet; others stay as they are."""
    thing = Thing("", "box", "b", "red", 0, 0, 1, 1)
    robots = [
        Thing(name, "donnie", "d", "red", at, 0, 1, 1, is_robot=True) for at, name in ((1, "Bb1"), (2, "é"))
    ]
    floor = Picture(0, 0, 4, 1, 1, ("bdd.",), (thing, *robots), has_walls=False)
    it = chart(floor, Pose(3, 0, 0), "Bob", Words())

    assert [(each.name, each.letter) for each in it.robots] == [("Bob", "o"), ("Bb1", "a"), ("é", "c")]
    assert it.rows == ("baco",)


# --- braille pages line by line

LEGEND = ascii_lowercase + digits


def plan_of(width: int, height: int, legend: int = 0, cell: int = 1) -> Chart:
    """A floor with a wall in its last cell, and so many lines in the legend."""
    rows = ("." * width,) * (height - 1) + ("." * (width - 1) + "#",)
    return Chart(rows, cell, (), dict.fromkeys(LEGEND[:legend], "thing"))


def braille_of(plan: Chart, title: str = "floor") -> list[list[str]]:
    text = braille_pages(title, plan, Words())
    assert text.endswith("\r\n\f")
    return [page.split("\r\n")[:-1] for page in text.split("\f")[:-1]]


@pytest.mark.parametrize(
    ("width", "height", "cell", "scale", "rows"),
    [
        (40, 2, 1, "A CELL IS #A BY #B STEPS", 1),
        (41, 2, 1, "A CELL IS #B BY #C STEPS", 1),
        (80, 3, 1, "A CELL IS #B BY #C STEPS", 1),
        (81, 5, 1, "A CELL IS #C BY #E STEPS", 1),
        (121, 7, 1, "A CELL IS #D BY #G STEPS", 1),
        (10, 44, 1, "A CELL IS #A BY #B STEPS", 22),
        (10, 46, 1, "A CELL IS #A BY #B STEPS", 23),
        (10, 47, 1, "A CELL IS #B BY #C STEPS", 16),
        (10, 4, 5, "A CELL IS #E BY #AJ STEPS", 2),
    ],
)
def test_a_braille_map_has_the_smallest_scale_that_fits(
    width: int, height: int, cell: int, scale: str, rows: int
) -> None:
    """A cell is 5 / 3 as high as wide; two of 25 lines are the title and the scale."""
    page, *_ = braille_of(plan_of(width, height, cell=cell))
    drawn = page[2 : 2 + rows]

    assert page[1] == scale
    assert drawn[-1].endswith("=")
    assert set("".join(drawn)) <= {" ", "="}
    assert all(each == "" for each in drawn[:-1])


@pytest.mark.parametrize(
    ("legend", "pages"), [(0, [8]), (16, [24]), (17, [25]), (18, [7, 19]), (22, [7, 23]), (30, [7, 25, 6])]
)
def test_the_legend_is_below_the_map_if_it_fits_there_without_making_it_smaller(
    legend: int, pages: list[int]
) -> None:
    """A map of five lines, two of the heading, one that says where north is, and a line for each letter."""
    found = braille_of(plan_of(4, 10, legend))

    assert [len(page) for page in found] == pages
    assert [line for page in found for line in page][7] == "NORTH IS AT THE TOP"
    last = f"{LEGEND[legend - 1].upper()}  THING" if legend else "NORTH IS AT THE TOP"
    assert found[-1][-1] == last


def test_a_title_that_is_longer_than_a_line_is_cut() -> None:
    ((title, *_),) = braille_of(plan_of(4, 2), "x" * 41)

    assert title == "X" * 40


@pytest.mark.parametrize("name", worlds.names())
@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_braille_pages_are_forty_cells_by_twenty_five_lines_of_ascii_braille(
    name: str, language: str
) -> None:
    for page in pages(name, language):
        assert 0 < len(page) <= 25
        for line in page:
            assert len(line) <= 40
            assert set(line) <= set(ASCII)


def test_the_page_of_the_living_room_has_the_map_and_the_legend_on_one_page() -> None:
    (page,) = pages("living_room")

    assert page[:5] == [
        "MAP OF LIVING-ROOM",
        "A CELL IS #B BY #C STEPS",
        "=======LLLLLL========",
        "=      LLLLLL       =",
        "SSS               TTT",
    ]
    assert page[16:] == [
        "NORTH IS AT THE TOP",
        "=  WALL",
        "D  DONNIE1 LOOKS NORTH",
        "C  CHAIR1 GREEN",
        "L  LARGE SOFA1 BLUE",
        "S  SMALL SOFA1 BLUE",
        "T  TABLE1 RED",
    ]


def test_in_braille_a_second_letter_says_the_colour_where_that_alone_makes_a_difference() -> None:
    (page,) = pages("colour_garden")

    assert page[3:7] == [
        "=      FF FF FF      =",
        "=      FB FB FB      =",
        "=                FF  =",
        "=                FY  =",
    ]
    assert page[20:22] == ["F  FLOWER1 B BLUE1 Y YELLOW1 R RED1", "   O ORANGE"]


def test_a_legend_that_would_make_the_map_smaller_has_its_own_page() -> None:
    first, second = pages("two_robots")

    assert first[1] == "A CELL IS #A BY #B STEPS"
    assert len(first) == 24
    assert second[0] == "NORTH IS AT THE TOP"


@pytest.mark.parametrize("name", [each for each in worlds.names() if each != "open_floor"])
def test_everything_in_the_legend_is_on_the_map(name: str) -> None:
    cells = {"#": "="}
    text = "".join("".join(page) for page in pages(name)[:1])

    for letter in charted(name).legend:
        assert cells.get(letter, letter.upper()) in text


def test_a_maze_on_a_braille_page_still_has_its_way() -> None:
    (page,) = pages("maze")
    rows = page[2:16]
    reached = {next((x, y) for y, row in enumerate(rows) for x, cell in enumerate(row) if cell == "D")}
    border = list(reached)
    for x, y in border:
        for there in ((x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)):
            if there not in reached and rows[there[1]].ljust(40)[there[0]] != "=":
                reached.add(there)
                border.append(there)

    assert any(rows[y].ljust(40)[x] == "B" for x, y in reached)


# --- swell paper


@pytest.mark.parametrize("name", worlds.names())
@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_a_picture_is_a_sheet_of_a4_and_everything_black_is_on_it(name: str, language: str) -> None:
    root = sheet(name, language)
    width, height = (float(each) for each in (root.get("viewBox") or "").split()[2:])

    assert (width, height) in (A4, A4[::-1])
    for tile in root.findall(f"{SVG}pattern"):
        root.remove(tile)
    for circle in root.iter(f"{SVG}circle"):
        assert 0 < float(circle.get("cx") or 0) < width
        assert 0 < float(circle.get("cy") or 0) < height
    for path in root.iter(f"{SVG}path"):
        for x, y in re.findall(r"[ML](-?[\d.]+) (-?[\d.]+)", path.get("d") or ""):
            assert 0 < float(x) < width
            assert 0 < float(y) < height


GRAY = "#b4b4b4"


@pytest.mark.parametrize("name", worlds.names())
def test_every_line_is_thick_enough_to_swell_and_only_walls_and_dots_are_black(name: str) -> None:
    root = sheet(name)

    widths = {float(each.get("stroke-width") or LINE) for each in root.iter()}
    assert min(widths) >= 1
    assert {each.get("fill") for each in root.iter(f"{SVG}text")} == {GRAY}
    black = [each for each in root.iter(f"{SVG}path") if each.get("fill") == "black"]
    if name in (known := {"living_room": 1, "cave": 0, "factory": 4, "two_robots": 4}):
        assert len(black) == known[name]


Dots = list[tuple[float, float]]


def dots_of(group: ElementTree.Element) -> Dots:
    return [(float(c.get("cx") or 0), float(c.get("cy") or 0)) for c in group.iter(f"{SVG}circle")]


def labels_of(root: ElementTree.Element) -> list[Dots]:
    return [dots_of(each) for each in root.iter(f"{SVG}g") if each.get("class") == "label"]


def lines_on(root: ElementTree.Element) -> Iterator[tuple[float, float, float]]:
    """Points every half millimetre on all lines of the map, with half the width of the line."""
    (plan,) = (each for each in root.iter(f"{SVG}g") if each.get("id") == "map")
    for path in plan.iter(f"{SVG}path"):
        if path.get("stroke") == "none":
            continue
        for piece in (path.get("d") or "").split("M")[1:]:
            points = [(float(x), float(y)) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", piece)]
            points += points[:1] if piece.endswith("Z") else []
            for (ax, ay), (bx, by) in pairwise(points):
                count = ceil(hypot(bx - ax, by - ay) / 0.5) or 1
                for step in range(count + 1):
                    yield ax + (bx - ax) * step / count, ay + (by - ay) * step / count, 0.6
    for ring in plan.iter(f"{SVG}circle"):
        yield float(ring.get("cx") or 0), float(ring.get("cy") or 0), float(ring.get("r") or 0) + 0.6


PATH = [Pose(0, 0, 0), Pose(0, 8, 0), Pose(5, 8, 90)]


@pytest.mark.parametrize("paths", [(), (PATH,)])
@pytest.mark.parametrize("name", worlds.names())
def test_three_millimetres_are_between_a_label_and_everything_else(
    name: str, paths: Sequence[Sequence[Pose]]
) -> None:
    """As BANA's guidelines for tactile graphics ask; a dot's edge is 0.8 mm from its middle."""
    root = sheet(name, paths=paths)
    labels, lines = labels_of(root), list(lines_on(root))

    for label in labels:
        left, right = min(x for x, _ in label) - 15, max(x for x, _ in label) + 15
        near = [each for each in lines if left < each[0] < right]
        for x, y in label:
            assert all(hypot(x - lx, y - ly) >= 3 + 0.8 + half - 0.01 for lx, ly, half in near)
    for mine, theirs in combinations(labels, 2):
        assert all(hypot(ax - bx, ay - by) >= 6 + 1.6 - 0.01 for ax, ay in mine for bx, by in theirs)


def test_no_driven_path_is_between_a_label_and_its_thing() -> None:
    """The path goes round the third blue flower, and leaves it room for a letter on its other side only."""
    path = [Pose(0, 0, 0), Pose(0, 11, 0), Pose(10, 11, 90), Pose(10, 18, 0), Pose(18, 18, 90)]
    root = sheet("colour_garden", "pt", (path,))
    labels = [(min(x for x, _ in each), min(y for _, y in each)) for each in labels_of(root)]
    without = [
        (min(x for x, _ in each), min(y for _, y in each)) for each in labels_of(sheet("colour_garden", "pt"))
    ]
    (dashed,) = [each for each in root.iter(f"{SVG}g") if each.get("stroke-dasharray")]
    drawn = dashed.find(f"{SVG}path")
    assert drawn is not None
    points = [(float(x), float(y)) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", drawn.get("d") or "")]
    (_, east_leg), (corner, _) = points[1], points[2]

    below = [each for each in labels if east_leg < each[1] < east_leg + 12 and each[0] < corner]
    assert below == []
    assert len(without) - len(labels) in (1, 2)


@pytest.mark.parametrize("name", worlds.names())
def test_every_thing_and_robot_has_its_label(name: str) -> None:
    """Between the belts of the factory is no room for the letters of the two cartons in the middle."""
    things = sum(each.thing is not None for each in drawings(scene(name)))

    assert len(labels_of(sheet(name))) == things - 2 * (name == "factory")


def test_a_colour_garden_can_be_felt() -> None:
    """Each colour has a texture, with a sample and its word in the key, and its initial in the label."""
    root = sheet("colour_garden")
    patterns = {each.get("id") for each in root.iter(f"{SVG}pattern")}
    filled = [each.get("fill") for each in root.iter(f"{SVG}path") if "url" in (each.get("fill") or "")]
    key = [each.get("fill") for each in root.iter(f"{SVG}rect") if "url" in (each.get("fill") or "")]
    printed = [each.text or "" for each in root.iter(f"{SVG}text")]

    assert patterns == {"red", "blue", "yellow", "orange"}
    assert Counter(filled) == {"url(#blue)": 3, "url(#yellow)": 4, "url(#red)": 2, "url(#orange)": 1}
    assert set(key) == {f"url(#{each})" for each in patterns}
    assert {"wall", "red", "blue", "yellow", "orange", "gray", "FB", "FY", "FR", "FO", "S", "N"} <= {*printed}


def test_the_key_has_what_is_on_the_sheet_and_no_more() -> None:
    """The rock of a cave is a texture, not a black line; its crystals are too small for one."""
    assert [each.get("id") for each in sheet("cave").iter(f"{SVG}pattern")] == ["rock"]
    assert list(sheet("factory").iter(f"{SVG}pattern")) == []


def test_a_sheet_has_its_title_north_and_a_scale_in_steps_and_centimetres() -> None:
    root = sheet("living_room")
    printed = [each.text for each in root.iter(f"{SVG}text")]
    (bar,) = (each for each in root.iter(f"{SVG}path") if each.get("id") == "scale")
    (arrow,) = (each for each in root.iter(f"{SVG}path") if each.get("id") == "north")

    assert printed[:2] == ["Map of living_room", "N"]
    assert "line: 50 steps, 250 cm" in printed
    tail, tip = re.findall(r"(-?[\d.]+) (-?[\d.]+)", arrow.get("d") or "")[:2]
    assert tail[0] == tip[0]
    assert float(tail[1]) > float(tip[1])  # up
    length = float(re.findall(r"h([\d.]+)", bar.get("d") or "")[0])
    walls = [x for x, _, _ in lines_on(root)]
    assert length / 50 == pytest.approx((max(walls) - min(walls)) / 42, abs=0.05)


@pytest.mark.parametrize("name", worlds.names())
@pytest.mark.parametrize("language", ["en", "pt", "es"])
def test_no_printed_word_touches_another_a_dot_or_a_line(name: str, language: str) -> None:
    root = sheet(name, language, (PATH,))
    font = ImageFont.load_default(PRINT * 20)
    printed = []
    for each in root.iter(f"{SVG}text"):
        x, y = float(each.get("x") or 0), float(each.get("y") or 0)
        left, top, right, bottom = (edge / 20 for edge in font.getbbox(each.text or "", anchor="ls"))
        printed.append((x + left, y + top, x + right, y + bottom))
    width, height = (float(each) for each in (root.get("viewBox") or "").split()[2:])
    things = [(x - half, y - half, x + half, y + half) for x, y, half in lines_on(root)]
    for tile in root.findall(f"{SVG}pattern"):
        root.remove(tile)
    for group in root.iter(f"{SVG}g"):
        if group.get("id") != "map":
            things += [(x - 0.8, y - 0.8, x + 0.8, y + 0.8) for x, y in dots_of(group)]
    (bar,) = (each for each in root.iter(f"{SVG}path") if each.get("id") == "scale")
    (at, low), length = re.findall(r"M([\d.]+) ([\d.]+)", bar.get("d") or "")[0], bar_length(bar)
    things.append((float(at) - 0.6, float(low) - 4, float(at) + length + 0.6, float(low)))

    for mine in printed:
        assert 0 < mine[0] < mine[2] < width
        assert 0 < mine[1] < mine[3] < height
    for one, other in (*combinations(printed, 2), *product(printed, things)):
        apart = one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]
        assert apart, (one, other)


@pytest.mark.parametrize("name", worlds.names())
def test_print_keeps_its_distance_from_the_dots_where_that_costs_the_map_nothing(name: str) -> None:
    """A millimetre at a map that is as wide as the sheet, else at least a tenth; 0.6 mm at a label."""
    root = sheet(name)
    font = ImageFont.load_default(PRINT * 20)
    width, height = (float(each) for each in (root.get("viewBox") or "").split()[2:])
    labels = {id(each) for each in root.iter(f"{SVG}g") if each.get("class") == "label"}
    blocks = [each for each in root if each.tag == f"{SVG}g" and each.get("id") != "map"]
    gaps = list[float]()
    for each in root.iter(f"{SVG}text"):
        left, top, right, bottom = (edge / 20 for edge in font.getbbox(each.text or "", anchor="ls"))
        x, y = float(each.get("x") or 0), float(each.get("y") or 0)
        dots = [dot for block in blocks if id(block) not in labels for dot in dots_of(block)]
        column = [at for across, at in dots if x + left - 0.8 < across < x + right + 0.8]
        gaps += [y + top - at - 0.8 for at in column if at < y and y - at < 12]
        gaps += [at - 0.8 - y - bottom for at in column if at > y and at - y < 12]

    xs = [x for x, _, _ in lines_on(root)]
    is_wide = xs and max(xs) - min(xs) > width - 25
    assert min(gaps) > (0.5 if is_wide and height > width else 0.1)


def bar_length(bar: ElementTree.Element) -> float:
    return float(re.findall(r"h([\d.]+)", bar.get("d") or "")[0])


@pytest.mark.parametrize(("name", "language"), [("street", "en"), ("storehouse", "es"), ("bigbob6", "pt")])
def test_the_whole_title_is_in_braille(name: str, language: str) -> None:
    """In one line of 25 cells, or in two."""
    title = Words(language)("paper-title", name=about(name, language).title)
    it, plan = scene(name), charted(name, language)
    root = ElementTree.fromstring(raised_picture(title, plan, seen(name), drawings(it), Words(language)))
    groups = [dots_of(each) for each in root.iter(f"{SVG}g") if each.get("fill") == "black"]
    (arrow,) = (at for at, each in enumerate(root) if each.get("id") == "north")
    before = [dots_of(each) for each in list(root)[:arrow] if each.get("fill") == "black"]

    cells = braille(title, language).replace(" ", "")
    assert sum(map(len, before)) == sum(len(dots(each)) for each in cells)
    assert groups[: len(before)] == before


def test_a_driven_path_is_a_dashed_line_with_its_place_in_the_key() -> None:
    dashed = [each for each in sheet("open_floor", paths=(PATH,)).iter() if each.get("stroke-dasharray")]

    path = dashed[0].find(f"{SVG}path")
    assert path is not None
    points = [(float(x), float(y)) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", path.get("d") or "")]
    (ax, ay), (bx, by), (cx, cy) = points
    assert ax == bx
    assert by == cy
    assert (ay - by) / (cx - bx) == pytest.approx(8 / 5, abs=0.01)
    assert len(dashed) == 2  # the path, and its sample


def test_a_picture_describes_itself_in_text() -> None:
    root = sheet("living_room", "pt")

    assert root.findtext(f"{SVG}title") == "Map of living_room"
    assert "c: cadeira, verde" in (root.findtext(f"{SVG}desc") or "")


def test_names_with_characters_that_xml_forbids_are_safe() -> None:
    bad = Thing("<\x1b&>", "<\x00>", "b", "red", 0, 0, 3, 3)
    floor = Picture(-5, -5, 10, 10, 1, ("." * 10,) * 10, (bad,), has_walls=False)
    square = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))
    plan = chart(floor, Pose(3, 3, 0), "\x07<", Words())

    root = ElementTree.fromstring(
        raised_picture(f"Map of <&\x00{'x' * 99}", plan, floor, [Drawing((square,), bad, False)], Words())
    )

    assert root.findtext(f"{SVG}title") == f"Map of <& {'x' * 99}"
    assert max(float(each.get("cx") or 0) for each in root.iter(f"{SVG}circle")) < A4[1]
    assert isinstance(plan.robots[0], ChartedRobot)


def test_the_dots_of_the_legend_can_be_read() -> None:
    """A page of braille is made of dots 2.5 mm apart: the title's first cell is an M, dots 1, 3, 4."""
    title = next(each for each in sheet("maze").iter(f"{SVG}g") if each.get("fill") == "black")

    assert dots_of(title)[:3] == [(12, 12), (12, 17), (14.5, 12)]


def small_sheet(*more: Drawing, has_walls: bool = False) -> ElementTree.Element:
    """A floor of 10 by 10 steps with a red crate of 4 by 4, and a robot that drove 4 steps to the north.

    The map is 186 of 210 mm wide, so a step is 18.6 mm; its top left corner is at 12, 32, in the world at
    -5.5, 4.5.
    """
    crate = Thing("crate", "crate", "c", "red", 1, 1, 4, 4)
    floor = Picture(-5, -5, 10, 10, 1, ("." * 10,) * 10, (crate,), has_walls=has_walls)
    square = ((-1.0, -1.0), (3.0, -1.0), (3.0, 3.0), (-1.0, 3.0))
    plan = chart(floor, Pose(-3, -3, 90), "donnie", Words())
    way = [Pose(-3, -3, 0), Pose(-3, 1, 0)]
    return ElementTree.fromstring(
        raised_picture("Map", plan, floor, [Drawing((square,), crate, False), *more], Words(), [way])
    )


def test_a_sheet_is_drawn_to_scale() -> None:
    root = small_sheet()
    (plan,) = (each for each in root.iter(f"{SVG}g") if each.get("id") == "map")

    square = "M95.70 134.30L170.10 134.30L170.10 59.90L95.70 59.90Z"
    assert [(each.get("d"), each.get("fill")) for each in plan.iter(f"{SVG}path")] == [
        (square, None),
        (square, "url(#red)"),
        ("M58.50 171.50L66.50 171.50", None),  # the robot's nose: 8 mm to the east
        ("M58.50 171.50L58.50 97.10", None),
        ("M58.50 97.10L61.00 101.43", None),  # the head of the arrow: 5 mm, 30 degrees to each side
        ("M58.50 97.10L56.00 101.43", None),
    ]
    (pattern,) = root.iter(f"{SVG}pattern")
    assert (pattern.get("id"), pattern.get("width"), pattern.get("height")) == ("red", "3.4", "3.4")


def test_a_label_is_next_to_its_thing_with_its_letter_in_print_above() -> None:
    root = small_sheet()

    # 3.7 mm and half a line to the right of 170.1, in the middle of its height; a C is dots 1 and 4
    assert labels_of(root) == [[(174.6, 94.6), (177.1, 94.6)]]
    (printed,) = (each for each in root.iter(f"{SVG}text") if each.text == "C")
    assert (printed.get("x"), printed.get("y")) == ("173.80", "93.20")


def test_no_label_leaves_the_sheet_or_is_in_a_wall() -> None:
    """To the right of the cup is the edge of the sheet, to the right of the crate a thick wall."""
    corners = ((2.5, -5.0), (4.5, -5.0), (4.5, -3.0), (2.5, -3.0))
    cup = Drawing((corners,), Thing("cup", "cup", "u", "red", 3.5, -4, 2, 2, index=1), False)
    wall = Drawing((((3.0, -1.0), (4.5, -1.0), (4.5, 3.0), (3.0, 3.0)),), None, False)

    crate, left = labels_of(small_sheet(cup))
    # 3.7 mm, and a letter of 4.1 mm, to the left of 160.8; a U is dots 1, 3 and 6
    assert crate == [(174.6, 94.6), (177.1, 94.6)]
    assert left == pytest.approx([(153.8, 187.6), (153.8, 192.6), (156.3, 192.6)])

    (label,) = labels_of(small_sheet(wall))
    # two rows of the key leave 17.7 mm for a step: the crate begins at 96.15
    assert [x for x, _ in label] == pytest.approx([89.15, 91.65])


def test_the_foot_of_a_sheet_has_the_legend_the_key_and_the_scale() -> None:
    """The map leaves 4 of 190 mm, so that each of four lines has one more."""
    root = small_sheet()
    printed = {each.text: (each.get("x"), each.get("y")) for each in root.iter(f"{SVG}text")}
    groups = [dots_of(each) for each in root.iter(f"{SVG}g") if each.get("fill") == "black"]
    first = {each[0] for each in groups}
    (bar,) = (each for each in root.iter(f"{SVG}path") if each.get("id") == "scale")
    (arrow,) = (each for each in root.iter(f"{SVG}path") if each.get("id") == "north")
    (box, _) = (each for each in root.iter(f"{SVG}rect") if each.get("x"))
    sample = [each.get("d") for each in root.iter(f"{SVG}path") if each.get("stroke-dasharray")]

    assert printed["Map"] == ("11.20", "21.36")
    assert printed["N"] == ("183.20", "27.36")
    assert printed["d  donnie, looks east"] == ("11.20", "236.86")
    assert printed["c  crate, red"] == ("11.20", "247.86")
    assert printed["red"] == ("27.60", "259.36")
    assert printed["line: 10 steps, 50 cm"] == ("11.20", "271.86")
    assert {(12.0, 12.0), (184.0, 18.0), (28.4, 250.0)} <= first  # M, N and R have dot 1
    assert bar.get("d") == "M12.0 279.00v-4m0 2h186.00m0 -2v4"
    assert arrow.get("d") == "M195.0 26.0L195.0 12.0M192.0 16.0L195.0 12.0L198.0 16.0"
    assert (box.get("x"), box.get("y"), box.get("width"), box.get("height")) == (
        "12.00",
        "249.00",
        "12.0",
        "9.0",
    )
    assert sample == ["M56.2 253.50H68.2"]


def test_a_wall_is_a_black_line_where_it_is_thin_and_an_outline_where_it_is_thick() -> None:
    """Two rows of the key leave 17.7 mm for a step: 0.3 are 5.3 mm, 0.4 are 7.1; lines are thinner than 6."""
    thin = ((-5.0, 2.0), (-5.0, 4.0), (-4.7, 4.0), (-4.7, 2.0))
    thick = ((-4.0, 2.0), (-4.0, 4.0), (-3.6, 4.0), (-3.6, 2.0))
    (plan,) = (
        each
        for each in small_sheet(Drawing((thin, thick), None, False)).iter(f"{SVG}g")
        if each.get("id") == "map"
    )
    fills = {(each.get("d") or "").partition("L")[0]: each.get("fill") for each in plan.iter(f"{SVG}path")}

    assert fills["M25.35 76.25"] == "black"
    assert fills["M43.05 76.25"] == "url(#rock)"


def test_what_is_small_on_paper_is_a_ring_and_has_no_texture_below_eight_millimetres() -> None:
    def drawing(x: float, size: float) -> Drawing:
        thing = Thing("cup", "cup", "u", "red", x, -4, size, size)
        half = size / 2
        corners = ((x - half, -4 - half), (x + half, -4 - half), (x + half, -4 + half), (x - half, -4 + half))
        return Drawing((corners,), thing, False)

    root = small_sheet(drawing(0, 0.26), drawing(1.5, 0.28), drawing(3, 0.42), drawing(4, 0.44))
    (plan,) = (each for each in root.iter(f"{SVG}g") if each.get("id") == "map")
    (ring,) = plan.iter(f"{SVG}circle")
    filled = [each for each in plan.iter(f"{SVG}path") if each.get("fill") == "url(#red)"]

    assert (ring.get("cx"), ring.get("cy"), ring.get("r")) == ("114.30", "190.10", "1.90")
    assert len(filled) == 2  # the crate, and the cup of 0.44 steps, which is 8.2 mm wide


def test_the_extent_of_a_world_with_walls_is_what_stands_there() -> None:
    """The crate alone is 4 by 4 steps: upright it is 186 mm wide, 46.5 mm a step."""
    root = small_sheet(has_walls=True)
    (bar,) = (each for each in root.iter(f"{SVG}path") if each.get("id") == "scale")

    assert bar_length(bar) == pytest.approx(2 * 46.5)


# --- boxes and lines

BOX = (10.0, 20.0, 30.0, 40.0)


@pytest.mark.parametrize(
    ("other", "apart"),
    [
        ((33.0, 44.0, 50.0, 50.0), 5.0),
        ((0.0, 0.0, 7.0, 16.0), 5.0),
        ((35.0, 25.0, 40.0, 30.0), 5.0),
        ((12.0, 5.0, 14.0, 18.0), 2.0),
        ((12.0, 41.0, 14.0, 50.0), 1.0),
        ((0.0, 0.0, 10.0, 20.0), 0.0),
        ((12.0, 22.0, 14.0, 24.0), 0.0),
    ],
)
def test_boxes_are_apart_as_their_nearest_points_are(other: tuple[float, ...], apart: float) -> None:
    west, north, east, south = other

    assert boxes_apart(BOX, (west, north, east, south)) == apart
    assert boxes_apart((west, north, east, south), BOX) == apart


@pytest.mark.parametrize(
    ("line", "apart"),
    [
        (((33.0, 44.0), (50.0, 44.0)), 5.0),
        (((0.0, 30.0), (50.0, 30.0)), 0.0),
        (((15.0, 25.0), (16.0, 26.0)), 0.0),
        (((5.0, 0.0), (5.0, 99.0)), 5.0),
        (((0.0, 18.0), (99.0, 18.0)), 2.0),
        (((31.0, 0.0), (31.0, 99.0)), 1.0),
        (((0.0, 44.0), (99.0, 44.0)), 4.0),
    ],
)
def test_a_line_is_from_a_box_as_its_nearest_point_is(
    line: tuple[tuple[float, float], ...], apart: float
) -> None:
    assert from_segment(BOX, line) == pytest.approx(apart)


@pytest.mark.parametrize(
    ("label", "way", "line", "is_crossed"),
    [
        ((40.0, 28.0, 44.0, 32.0), "right", ((35.0, 29.0), (35.0, 31.0)), True),
        ((40.0, 28.0, 44.0, 32.0), "right", ((41.0, 29.0), (41.0, 31.0)), True),
        ((40.0, 28.0, 44.0, 32.0), "right", ((43.0, 0.0), (43.0, 99.0)), False),
        ((40.0, 28.0, 44.0, 32.0), "right", ((29.5, 0.0), (29.5, 99.0)), False),
        ((40.0, 28.0, 44.0, 32.0), "right", ((35.0, 30.5), (35.0, 99.0)), False),
        ((0.0, 28.0, 4.0, 32.0), "left", ((6.0, 29.0), (6.0, 31.0)), True),
        ((0.0, 28.0, 4.0, 32.0), "left", ((1.0, 0.0), (1.0, 99.0)), False),
        ((0.0, 28.0, 4.0, 32.0), "left", ((10.5, 0.0), (10.5, 99.0)), False),
        ((18.0, 50.0, 22.0, 54.0), "below", ((19.0, 45.0), (21.0, 45.0)), True),
        ((18.0, 50.0, 22.0, 54.0), "below", ((0.0, 53.0), (99.0, 53.0)), False),
        ((18.0, 50.0, 22.0, 54.0), "below", ((0.0, 39.5), (99.0, 39.5)), False),
        ((18.0, 6.0, 22.0, 10.0), "above", ((19.0, 15.0), (21.0, 15.0)), True),
        ((18.0, 6.0, 22.0, 10.0), "above", ((0.0, 7.0), (99.0, 7.0)), False),
        ((18.0, 6.0, 22.0, 10.0), "above", ((0.0, 20.5), (99.0, 20.5)), False),
        ((40.0, 50.0, 44.0, 54.0), "at a corner", ((35.0, 46.0), (37.0, 46.0)), True),
        ((40.0, 50.0, 44.0, 54.0), "at a corner", ((37.0, 46.0), (99.0, 46.0)), False),
    ],
)
def test_a_line_is_between_a_label_and_a_box_if_it_crosses_the_shortest_way(
    label: tuple[float, float, float, float],
    way: str,
    line: tuple[tuple[float, float], tuple[float, float]],
    is_crossed: bool,
) -> None:
    """From the middle of the label: at the corner of 30, 40 from 42, 52, so at a height of 46 at 36."""
    assert is_between(line, label, BOX) == is_crossed, way


def test_what_is_near_a_box_is_found_and_what_is_far_is_not() -> None:
    """It looks into squares of 8 mm."""
    near, across, far = [(17.0, 1.0), (17.0, 2.0)], [(-30.0, 9.0), (60.0, 9.0)], [(50.0, 50.0), (51.0, 51.0)]
    lines = Nearby([near, across, far])

    assert box_of(near) == (17.0, 1.0, 17.0, 2.0)
    assert list(lines.of((1.0, 1.0, 7.0, 7.0))) == []
    assert list(lines.of((1.0, 1.0, 7.0, 7.0), 9.5)).count(near) == 1
    assert {id(each) for each in lines.of((1.0, 1.0, 16.5, 8.5))} == {id(near), id(across)}
    assert list(lines.of((-20.0, 8.0, -20.0, 8.0))) == [across]
    assert list(lines.of((50.0, 50.0, 50.5, 50.5))) == [far]


# --- a sheet part by part


def floor_sheet(
    width: int, height: int, *things: Drawing, title: str = "Map", has_walls: bool = False
) -> ElementTree.Element:
    """A floor of that many steps whose south-west corner is at 0, 0."""
    named = tuple(each.thing for each in things if each.thing is not None)
    rows = ("." * width,) * height
    floor = Picture(0, 0, width, height, 1, rows, named, has_walls=has_walls)
    plan = chart(floor, Pose(0, 0, 0), None, Words())
    return ElementTree.fromstring(raised_picture(title, plan, floor, things, Words()))


def printed_on(root: ElementTree.Element) -> list[str]:
    return [each.text or "" for each in root.iter(f"{SVG}text")]


def square_of(thing: Thing) -> Drawing:
    half, x, y = thing.width / 2, thing.x, thing.y
    corners = ((x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half))
    return Drawing((corners,), thing, False)


@pytest.mark.parametrize(
    ("width", "steps", "bar"),
    [(3, 2, 182), (7, 5, 195), (12, 10, 227.5), (49, 20, 111.43), (99, 50, 137.88)],
)
def test_the_line_of_the_scale_has_a_round_number_of_steps(width: int, steps: int, bar: float) -> None:
    """A low floor lies across the sheet, 273 of 297 mm wide, if its height has room."""
    root = floor_sheet(width, 1)
    (line,) = (each for each in root.iter(f"{SVG}path") if each.get("id") == "scale")

    assert root.get("viewBox") == "0 0 297 210"
    assert f"line: {steps} steps, {5 * steps} cm" in printed_on(root)
    assert bar_length(line) == pytest.approx(bar, abs=0.01)


@pytest.mark.parametrize(
    ("language", "scale", "robots"),
    [
        ("en", "line: 1 step, 5 cm", "1 more robot"),
        ("pt", "linha: 1 passo, 5 cm", "mais 1 robô"),
        ("es", "línea: 1 paso, 5 cm", "1 robot más"),
    ],
)
def test_one_step_and_one_robot_are_no_more_than_one(language: str, scale: str, robots: str) -> None:
    words = Words(language)
    others = tuple(Thing("r", "donnie", "d", "red", 0, 0, 1, 1, is_robot=True) for _ in range(7))
    floor = Picture(0, 0, 1, 1, 1, ("d",), others, has_walls=False)
    plan = chart(floor, Pose(0, 0, 0), None, words)
    root = ElementTree.fromstring(raised_picture("Map", plan, floor, [], words))

    assert scale in printed_on(root)
    assert robots in plan.legend.values()


def test_a_cell_of_a_coarse_floor_is_as_many_steps_on_the_sheet() -> None:
    floor = Picture(0, 0, 6, 1, 2, ("." * 6,), (), has_walls=False)
    plan = chart(floor, Pose(0, 0, 0), None, Words())
    root = ElementTree.fromstring(raised_picture("Map", plan, floor, [], Words()))
    (line,) = (each for each in root.iter(f"{SVG}path") if each.get("id") == "scale")

    assert bar_length(line) == pytest.approx(227.5)  # 10 of 12 steps on 273 mm


def test_a_sheet_has_no_text_but_its_title_its_description_and_its_print() -> None:
    root = small_sheet()
    spoken = {f"{SVG}title", f"{SVG}desc", f"{SVG}text"}

    assert [each.text for each in root.iter() if each.tag not in spoken and (each.text or "").strip()] == []
    assert [each.tail for each in root.iter() if (each.tail or "").strip()] == []
    dashes = [each.get("stroke-dasharray") for each in root.iter() if each.get("stroke-dasharray")]
    assert len(dashes) == 2
    for line, gap in (map(float, (each or "").split()) for each in dashes):
        assert line > gap >= 2 * LINE  # its ends swell, too


def test_a_label_keeps_its_distance_from_the_ring_of_a_small_thing() -> None:
    """The ring has 2.5 mm to each side; a U is dots 1, 3 and 6."""
    corners = ((-0.05, -4.05), (0.05, -4.05), (0.05, -3.95), (-0.05, -3.95))
    cup = Drawing((corners,), Thing("cup", "cup", "u", "red", 0, -4, 0.1, 0.1, index=1), False)

    assert labels_of(small_sheet(cup))[1] == pytest.approx([(121.3, 187.6), (121.3, 192.6), (123.8, 192.6)])


def test_a_sheet_is_upright_for_a_high_floor() -> None:
    assert floor_sheet(5, 20).get("viewBox") == "0 0 210 297"
    assert floor_sheet(20, 5).get("viewBox") == "0 0 297 210"
    root = floor_sheet(5, 20)
    assert (root.get("width"), root.get("height")) == ("210mm", "297mm")


def test_a_long_title_has_two_lines_and_no_third() -> None:
    """25 cells of an upright sheet, one less for a number's sign."""
    root = floor_sheet(5, 20, title="a" * 24 + " " + "b" * 24 + " " + "c" * 24)

    assert [each for each in printed_on(root) if set(each) <= set("abc")] == ["a" * 24, "b" * 24]
    lines = {each.text: each.get("y") for each in root.iter(f"{SVG}text")}
    assert (lines["a" * 24], lines["b" * 24]) == ("20.36", "30.36")
    assert printed_on(floor_sheet(5, 20, title="a" * 25))[:2] == ["a" * 24, "a"]


@pytest.mark.parametrize(("count", "lines"), [(9, 9), (10, 10), (11, 10)])
def test_the_legend_of_a_sheet_has_ten_lines_at_most(count: int, lines: int) -> None:
    things = [
        square_of(Thing("", f"kind {letter}", letter, "red", 2.0 * at, 5, 1, 1, index=at))
        for at, letter in enumerate(ascii_lowercase[:count])
    ]
    said = [each for each in printed_on(floor_sheet(30, 10, *things)) if "kind" in each.lower()]

    assert len(said) == lines
    assert said[0] == "a  kind a, red"


@pytest.mark.parametrize(("length", "rest"), [(33, [" red"]), (34, ["", "   red"])])
def test_a_line_of_the_legend_has_three_cells_less_than_the_sheet(length: int, rest: list[str]) -> None:
    """44 cells of 6.2 mm on 273; "k  " and ", red" are eight."""
    thing = square_of(Thing("", "k" * length, "k", "red", 3, 3, 1, 1))
    first, *others = rest

    assert printed_on(floor_sheet(20, 5, thing))[3:-2] == [f"k  {'k' * length},{first}", *others]


@pytest.mark.parametrize(("count", "labels"), [(60, 60), (61, 0)])
def test_of_more_than_sixty_things_none_has_a_letter(count: int, labels: int) -> None:
    things = [
        square_of(Thing("", "pin", "p", "red", 1 + 2.0 * (at % 8), 1 + 2.0 * (at // 8), 0.1, 0.1, index=at))
        for at in range(count)
    ]

    assert len(labels_of(floor_sheet(17, 17, *things))) == labels


COLOURS = ("red", "green", "blue", "yellow", "orange", "pink")


def textured_sheet() -> ElementTree.Element:
    """Six crates of 4 by 4 steps in a row, a gray one, and a rock."""
    things = [
        square_of(Thing("", "crate", "c", colour, 3 + 5.0 * at, 3, 4, 4, index=at))
        for at, colour in enumerate((*COLOURS, "gray"))
    ]
    rock = Drawing((((1.0, 6.0), (5.0, 6.0), (5.0, 10.0), (1.0, 10.0)),), None, from_bitmap=True)
    return floor_sheet(36, 12, *things, rock)


def test_the_lines_of_a_texture_go_on_at_the_edge_of_its_tile() -> None:
    """But for the bricks of pink: 3 mm long, each row half a tile further."""
    open_ends = {}
    for tile in textured_sheet().iter(f"{SVG}pattern"):
        side = float(tile.get("width") or 0)
        assert tile.get("height") == tile.get("width")
        assert tile.get("patternUnits") == "userSpaceOnUse"
        path = tile.find(f"{SVG}path")
        if path is None:
            (dot,) = tile.iter(f"{SVG}circle")
            assert side - 2 * float(dot.get("r") or 0) == pytest.approx(2)  # mm between two dots
            assert [dot.get("cx"), dot.get("cy")] == [f"{side / 2}"] * 2
            continue
        assert (path.get("fill"), path.get("stroke")) == ("none", "black")
        ends = Counter[tuple[float, float]]()
        data = path.get("d") or ""
        assert re.fullmatch(r"(M-?[\d.]+ -?[\d.]+([LVH]-?[\d.]+( -?[\d.]+)?))+", data)
        for x, y, way, to, last in re.findall(
            r"M(-?[\d.]+) (-?[\d.]+)([LVH])(-?[\d.]+)(?: (-?[\d.]+))?", data
        ):
            end = {"L": (to, last or y), "V": (x, to), "H": (to, y)}[way]
            for at in ((x, y), end):
                ends[round(float(at[0]) % side, 6) % side, round(float(at[1]) % side, 6) % side] += 1
        open_ends[tile.get("id")] = {each for each, count in ends.items() if count % 2}

    assert open_ends.pop("pink") == {(0.0, 1.0), (3.0, 1.0), (2.5, 3.5), (0.5, 3.5)}
    assert {*open_ends} == {"red", "green", "yellow", "orange", "rock"}
    assert not any(open_ends.values())


def test_the_key_has_its_samples_in_order_and_in_as_many_rows_as_they_need() -> None:
    """From a sample's left end: 12 mm, half a line, 3 mm and half a dot to its word, and 3 mm behind it."""
    root = textured_sheet()
    boxes = [
        (each.get("x"), each.get("y"))
        for each in root.iter(f"{SVG}rect")
        if each.get("width") == "12.0" and each.get("fill") == "none"
    ]
    named = ["wall", *COLOURS, "gray"]
    left, row, expected = 12.0, 0, []
    for word in named:
        wide = 16.4 + 6.2 * (len(word) + 1)
        if left + wide > 297 - 12:
            left, row = 12.0, row + 1
        expected.append((f"{left:.2f}", row))
        left += wide + 3
    (first,) = {y for (_, y), (_, number) in zip(boxes, expected, strict=True) if number == 0}

    assert [each for each in printed_on(root) if each in named] == named
    assert [x for x, _ in boxes] == [x for x, _ in expected]
    assert [float(y or 0) for _, y in boxes] == [float(first or 0) + 13 * number for _, number in expected]
    assert {number for _, number in expected} == {0, 1}


@pytest.mark.parametrize(("colours", "key"), [(["gray"], []), (["gray", "red"], ["red", "gray"])])
def test_gray_is_in_the_key_only_if_a_colour_is(colours: list[str], key: list[str]) -> None:
    """Alone it needs none: an empty outline is no texture."""
    things = [
        square_of(Thing("", "crate", "c", colour, 3 + 5.0 * at, 3, 4, 4, index=at))
        for at, colour in enumerate(colours)
    ]

    assert [each for each in printed_on(floor_sheet(12, 6, *things)) if each in colours] == key


def test_a_robot_and_its_path_look_where_they_go() -> None:
    """The nose has 8 mm, each side of the arrow's head 5 mm, 150 degrees from its direction."""
    floor = Picture(-5, -5, 10, 10, 1, ("." * 10,) * 10, (), has_walls=False)
    plan = chart(floor, Pose(1, 1, 30), "donnie", Words())
    way = [Pose(-3, -3, 0), Pose(-1, 1, 200)]
    root = ElementTree.fromstring(raised_picture("Map", plan, floor, [], Words(), [way]))
    (group,) = (each for each in root.iter(f"{SVG}g") if each.get("id") == "map")
    nose, _, *head = (
        [(float(x), float(y)) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", each.get("d") or "")]
        for each in group.iter(f"{SVG}path")
    )

    def ahead(degrees: float, length: float) -> tuple[float, float]:
        return length * sin(radians(degrees)), -length * cos(radians(degrees))

    def way_of(line: list[tuple[float, float]]) -> tuple[float, float]:
        return line[1][0] - line[0][0], line[1][1] - line[0][1]

    assert way_of(nose) == pytest.approx(ahead(30, 8), abs=0.011)
    assert way_of(head[0]) == pytest.approx(ahead(350, 5), abs=0.011)
    assert way_of(head[1]) == pytest.approx(ahead(50, 5), abs=0.011)


def test_the_pieces_of_a_thing_have_one_outline_and_a_robot_has_no_texture() -> None:
    """What lies inside of another piece is wiped out by white, with the inner half of a line of 2.4 mm."""
    crate = Thing("", "crate", "c", "red", 3, 3, 4, 4)
    robot = Thing("bob", "rover", "b", "red", 9, 3, 4, 4, is_robot=True)
    pieces = (((1.0, 1.0), (5.0, 1.0), (5.0, 5.0), (1.0, 5.0)), ((3.0, 3.0), (6.0, 3.0), (6.0, 6.0)))
    root = floor_sheet(20, 10, Drawing(pieces, crate, False), square_of(robot))
    (group,) = (each for each in root.iter(f"{SVG}g") if each.get("id") == "map")
    first, white, filled, body, *nose = group.iter(f"{SVG}path")

    assert (first.get("stroke-width"), first.get("fill")) == ("2.4", None)
    assert (white.get("fill"), white.get("stroke")) == ("white", "none")
    assert (filled.get("fill"), filled.get("stroke")) == ("url(#red)", "none")
    assert first.get("d") == white.get("d") == filled.get("d")
    assert (first.get("d") or "").count("Z") == 2
    assert (body.get("fill"), body.get("stroke-width")) == (None, None)
    assert len(nose) == 1
    assert labels_of(root)[1][0] is not None


def test_a_thin_rock_of_a_bitmap_is_an_outline_and_a_tiny_wall_is_no_ring() -> None:
    thin = ((1.0, 1.0), (9.0, 1.0), (9.0, 1.1), (1.0, 1.1))
    rock, wall = (Drawing((thin,), None, from_bitmap=each) for each in (True, False))
    tiny = Drawing((((1.0, 3.0), (1.05, 3.0), (1.05, 3.05), (1.0, 3.05)),), None, False)

    def drawn(each: Drawing) -> list[tuple[str, str | None]]:
        root = floor_sheet(20, 10, each)
        (group,) = (each for each in root.iter(f"{SVG}g") if each.get("id") == "map")
        return [(part.tag.removeprefix(SVG), part.get("fill")) for part in group]

    assert drawn(rock) == [("path", None), ("path", "url(#rock)")]
    assert drawn(wall) == [("path", "black")]
    assert drawn(tiny) == [("path", "black")]


def standing(west: float, south: float, east: float, north: float) -> tuple[tuple[float, float], ...]:
    return ((west, south), (east, south), (east, north), (west, north))


RIGHT, LEFT = standing(3.3, 0.5, 3.5, 1.5), standing(-1.4, 0.5, -1.2, 1.5)
BELOW, ABOVE = standing(0.5, -1.5, 1.5, -1.3), standing(0.5, 3.4, 1.5, 3.6)


@pytest.mark.parametrize(
    ("walls", "place"),
    [
        ((LEFT, BELOW, ABOVE), (171.45, 91.45)),
        ((RIGHT, BELOW, ABOVE), (89.15, 91.45)),
        ((RIGHT, LEFT, ABOVE), (130.3, 133.85)),
        ((RIGHT, LEFT, BELOW), (130.3, 49.05)),
        ((RIGHT, LEFT, BELOW, ABOVE), (171.45, 49.05)),
    ],
)
def test_a_label_is_at_the_first_side_with_room(
    walls: tuple[tuple[tuple[float, float], ...], ...], place: tuple[float, float]
) -> None:
    """Right, left, below, above, then the corners.

    The crate is from 96.15 to 166.95 and from 58.55 to 129.35; a label of 4.1 by 6.6 mm is 3.7 mm from it.
    """
    (label,) = labels_of(small_sheet(Drawing(walls, None, False)))

    assert label[0] == pytest.approx(place)
