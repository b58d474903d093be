"""A world on paper: letters with one meaning each, braille pages of 40 by 25, and swell paper."""

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cache
from itertools import combinations, pairwise, product
from math import ceil, hypot
from pathlib import Path
from xml.etree import ElementTree

import pytest
from PIL import ImageFont

import worlds
from devices.ports.robot import STEP, Pose
from donnie_tui.core.chart import ASCII, Chart, ChartedRobot, braille, braille_pages, chart, dots, shrunk
from donnie_tui.core.paper import A4, LINE, PRINT, raised_picture
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
    assert it.legend[it.robots[-1].letter] == "24 more robots"


def test_a_block_of_letters_keeps_what_matters_most() -> None:
    rows = ("..##..^.", "..#c....", "....#...", "........")

    assert shrunk(rows, 2, 2, "^") == (".c.^", "..#.")
    assert shrunk(rows, 1, 1) == rows
    assert shrunk(rows, 3, 3, "^") == ("#c^", "...")


# --- braille


@pytest.mark.parametrize(
    ("language", "text", "cells"),
    [
        ("en", "Map, 12 by 3.", "MAP1 #AB BY #C4"),
        ("en", "North: 0", "NORTH3 #J"),
        ("pt", "câmara, parede, não é", "C*MARA1 PAREDE1 N>O ="),
        ("es", "niño, aquí está.", "NI]O1 AQU/ EST('"),
        ("en", "über 漢 \x1b", "UBER    "),
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
