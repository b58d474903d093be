"""A run as a picture: what is drawn, to scale, in the right places, and said in words."""

import re
from collections.abc import Iterator, Sequence
from io import BytesIO
from itertools import combinations, pairwise
from pathlib import Path
from random import Random
from xml.etree import ElementTree

import pytest
from msgspec.structs import replace
from PIL import Image, ImageFont

import worlds
from devices.ports.robot import Pose
from donnie_tui.core.events import (
    Driven,
    HowStarted,
    Moved,
    PlacedThing,
    Reset,
    RunStarted,
    Stamped,
    ThingsMoved,
    Turned,
)
from donnie_tui.core.reports import Plot, PlotText
from donnie_tui.core.timeline import DrivenPath
from donnie_tui.i18n.words import Words
from donnie_tui.world.loading import moved_to
from donnie_tui.world.run_picture import (
    LETTER,
    MovedThing,
    RunPicture,
    ShownGoal,
    arrow,
    as_gif,
    as_picture,
    as_png,
    as_svg,
    driven_to,
    goals_on,
    moved_outlines,
    moved_things,
    plot_as_png,
    run_picture,
    texts,
)
from sim.picture import Drawing, Thing, drawings
from sim.worldfile import load_text, load_world
from tests.unit.sim.test_picture import box
from worlds.challenges import GoalPlace

PATH = DrivenPath("", (Pose(0, 0, 0), Pose(0, 6, 0), Pose(18, 6, 90), Pose(18, -2, 180)))
SVG = "{http://www.w3.org/2000/svg}"


def drawn(
    name: str = "two_rooms",
    path: DrivenPath = PATH,
    language: str = "en",
    goals: Sequence[GoalPlace] = (),
) -> RunPicture:
    scene = load_world(Path(worlds.path(name)), allowed=(Path(worlds.SCENES),))
    return run_picture("Two & rooms", drawings(scene), (path,), Words(language), goals)


def test_the_path_is_to_scale_and_north_is_up() -> None:
    it = drawn()
    line = ElementTree.fromstring(as_svg(it)).find(f"{SVG}polyline")
    assert line is not None
    (x0, y0), (x1, y1), (x2, y2), (_x3, y3) = (
        tuple(map(float, each.split(","))) for each in line.attrib["points"].split()
    )

    assert (x1 - x0, y2 - y1) == (0, 0)
    assert (y0 - y1) / 6 == pytest.approx(it.scale, rel=0.01)
    assert (x2 - x1) / 18 == pytest.approx(it.scale, rel=0.01)
    assert (y3 - y2) / 8 == pytest.approx(it.scale, rel=0.01)


def test_a_dot_drives_the_path_at_an_even_pace_and_stops_at_its_end() -> None:
    svg = ElementTree.fromstring(as_svg(drawn()))
    moving = svg.findall(f".//{SVG}animateTransform")

    assert [each.attrib["type"] for each in moving] == ["translate", "rotate"]
    # 6, 18 and 8 of 32 steps, at ten steps a second
    assert moving[0].attrib["keyTimes"] == "0.0000;0.1875;0.7500;1.0000"
    assert {(each.attrib["dur"], each.attrib["fill"]) for each in moving} == {("3.2s", "freeze")}


WEST = DrivenPath("", (Pose(0, 0, 10), Pose(0, 0, 350), Pose(0, 9, 350), Pose(0, 9, 270), Pose(-9, 9, 270)))


def test_a_robot_that_drives_looks_where_it_goes_and_turns_the_short_way() -> None:
    svg = ElementTree.fromstring(as_svg(drawn(path=WEST)))
    slide, turn = svg.findall(f"{SVG}g/{SVG}animateTransform")
    (stroke,) = svg.findall(f"{SVG}g/{SVG}path")

    assert turn.attrib["additive"] == "sum"
    assert turn.attrib["values"] == "10;-10;-10;-90;-90"
    assert turn.attrib["keyTimes"] == slide.attrib["keyTimes"] == "0.0000;0.0000;0.5000;0.5000;1.0000"
    assert stroke.attrib["d"].startswith("M 0 0 V -")


def test_the_gif_shows_where_the_robot_looks() -> None:
    it = drawn(path=WEST)
    image = Image.open(BytesIO(as_gif(it)))
    image.seek(image.n_frames - 1)
    (x, y), heading = next(iter(driven_to(it, 99)))

    def is_dark(x: float, y: float) -> bool:
        return max(image.convert("RGB").getpixel((round(x), round(y)))) < 0x40  # type: ignore[type-var, arg-type]

    half = max(3.0, 1.3 * it.scale) / 2
    assert heading == -90 + 360
    assert [is_dark(x - half, y), is_dark(x + half, y)] == [True, False]


def test_the_description_says_the_path_and_every_thing() -> None:
    svg = ElementTree.fromstring(as_svg(drawn()))

    assert svg.findtext(f"{SVG}title") == "Two & rooms"
    said = svg.findtext(f"{SVG}desc") or ""
    for part in ("North: 6 steps, to 0, 6.", "32 steps in all.", "b: ball, yellow", "c: chair, green"):
        assert part in said
    assert "Norte: 6 pasos, hasta 0, 6." in " ".join(drawn(language="es").legend)


def test_the_png_shows_floor_walls_things_and_the_path_where_they_are() -> None:
    it = drawn()
    image = Image.open(BytesIO(as_png(it)))

    def at(x: float, y: float) -> tuple[int, ...]:
        px, py = it.at(x, y)
        return image.getpixel((round(px), round(py)))  # type: ignore[return-value]

    assert image.size == (it.width, it.height)
    assert at(5, -5) == (255, 255, 255)
    assert at(11, -8) == (0x44, 0x44, 0x44)  # the wall between the rooms
    assert at(11, 5) == (255, 255, 255)  # the door
    assert at(18.8, -6.8) == (0xFF, 0xE0, 0x66)  # the ball, as on the dark map
    assert at(10, 6) == (0x7B, 0x2C, 0xBF)  # the path


PLACES = ((1, -5.0, -5.0, 5.0, 5.0), (2, -8.0, 8.0, -8.0, 8.0), (3, -8.0, 8.0, -8.0, 8.0))


@pytest.mark.parametrize("goals", [(), PLACES])
@pytest.mark.parametrize("name", worlds.scenarios())
def test_no_text_touches_another_and_all_lies_on_the_picture(name: str, goals: Sequence[GoalPlace]) -> None:
    it = drawn(name, goals=goals)
    placed = boxes_of_texts(it)

    for one, other in combinations(placed, 2):
        apart = one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]
        assert apart, (one, other)
    assert all(each[0] >= 0 and each[2] <= it.width and each[3] <= it.height for each in placed)


def test_a_robot_that_only_turned_has_a_place_and_no_moving_dot() -> None:
    svg = as_svg(drawn(path=DrivenPath("", (Pose(0, 0, 90),))))

    assert not re.search("<animate", svg)
    assert "<polygon" in svg


# --- robots, goals, colours, GIF


def test_a_robot_that_stood_still_is_drawn_and_one_that_drove_is_the_arrow_of_its_path() -> None:
    paths = DrivenPath("alice", (Pose(0, 0, 0), Pose(0, 6, 0)))

    letters = [text for _, _, text in texts_on(drawn("two_robots", paths)) if len(text) <= 2]

    assert len(letters) == 3  # bob and two boxes
    assert "alice" in [text for _, _, text in texts_on(drawn("two_robots", paths))]
    assert "alice: The path starts at 0, 0. North: 6 steps, to 0, 6. 6 steps in all." in " ".join(
        drawn("two_robots", paths).legend
    )
    assert any(line.endswith(": bob, blue") for line in drawn("two_robots", paths).legend)


def test_goals_are_dashed_boxes_with_their_numbers_and_a_place_has_all_of_them() -> None:
    it = drawn(goals=PLACES)
    svg = ElementTree.fromstring(as_svg(it))
    boxes = [
        tuple(float(each.attrib[name]) for name in ("x", "y", "width", "height"))
        for each in svg.iter(f"{SVG}rect")
        if each.get("class") == "goal"
    ]

    (x, y, width, height), small = boxes
    assert (x, y) == pytest.approx(it.at(-5, 5), abs=0.2)
    assert (width, height) == pytest.approx((10 * it.scale, 10 * it.scale), abs=0.2)
    assert (small[0] + small[2] / 2, small[1] + small[3] / 2) == pytest.approx(it.at(-8, 8), abs=0.2)
    assert [text for _, _, text in texts_on(it) if text in ("1", "2", "3", "2, 3")] == ["1", "2, 3"]
    assert [each for each in it.legend if each.startswith("goal")] == ["goal 1", "goal 2", "goal 3"]


def test_things_that_differ_in_colour_only_have_the_initial_of_the_colour() -> None:
    it = drawn("colour_garden")

    assert sorted(text for _, _, text in texts_on(it) if len(text) == 2) == [
        *("fB", "fB", "fB", "fO", "fR", "fR", "fY", "fY", "fY", "fY"),
    ]
    assert {"fB: flower, blue", "fY: flower, yellow", "s: stone, gray"} < {*it.legend}


def test_a_gif_moves_a_dot_from_the_start_to_the_end_in_the_time_of_the_svg() -> None:
    it = drawn()
    image = Image.open(BytesIO(as_gif(it)))
    durations = []
    for frame in range(image.n_frames):
        image.seek(frame)
        durations.append(image.info["duration"])

    assert image.size == (it.width, it.height)
    assert sum(durations[:-1]) == pytest.approx(3200, abs=200)  # 32 steps, ten a second
    assert [*driven_to(it, 0)] == [(it.at(0, 0), 0)]
    assert [*driven_to(it, 1.5)] == [(it.at(9, 6), 45)]  # half of an arc
    assert [*driven_to(it, 99)] == [(it.at(18, -2), 180)]


def test_a_long_run_has_no_more_frames_than_one_of_six_seconds() -> None:
    long = DrivenPath("", (Pose(0, 0, 0), *(Pose(5 * (at % 2), 0, 90) for at in range(1, 200))))

    assert Image.open(BytesIO(as_gif(drawn(path=long)))).n_frames == 60


def test_a_walk_of_half_a_million_steps_has_a_gif() -> None:
    far = DrivenPath("", (Pose(0, 0, 0), Pose(0, 500_000, 0)))

    assert Image.open(BytesIO(as_gif(drawn(path=far)))).n_frames == 60


# --- things that were pushed or carried


def leg(robot_at: Pose, *places: PlacedThing) -> Iterator[Stamped]:
    """A walk to a place, after which things stand elsewhere."""
    moved = Moved("FW", 9, 9, None, robot_at, True)
    yield from (Stamped(1, 0.0, moved), Stamped(2, 0.0, ThingsMoved(places)))


def carried() -> tuple[RunPicture, MovedThing]:
    """A box is pushed 4 of 10 steps to the north, then carried 5 to the east, and turned there."""
    scene = load_text(
        "position( size [ .1 .1 .1 ] pose [ 0 0 0 90 ] )\n"
        'model( size [ 0.1 0.2 0.1 ] color "red" pushable 1 pose [ 0 0.4 0 0 ] )\n'
        'model( size [ 2 0.05 0.1 ] color "blue" pose [ 0 1 0 0 ] )',
        Path("box.world"),
    )
    events = (
        *leg(Pose(0, 10, 0), PlacedThing("box", Pose(0, 12, 90), 1)),
        *leg(Pose(5, 10, 90), PlacedThing("box", Pose(5, 12, 180), 1)),
    )
    starts = RunStarted("p", "", "", 0, "", HowStarted("", 1, True, False, False, Pose(0, 0, 0)))
    (box,) = moved_things((Stamped(0, 0.0, starts), *events), scene)
    path = DrivenPath("", (Pose(0, 0, 0), Pose(0, 10, 0), Pose(5, 10, 90)))
    at_the_end = moved_to(scene, (PlacedThing("box", Pose(5, 12, 180), 1),))
    return run_picture("Box", drawings(at_the_end), (path,), Words("en"), moved=(box,)), box


def test_a_thing_moves_in_the_last_part_of_a_walk_that_pushes_it_and_all_along_where_it_is_carried() -> None:
    """Ten steps a second."""
    _, box = carried()

    assert [(round(at, 6), pose) for at, pose in box.moments] == [
        *((0.0, Pose(0, 8, 90)), (0.6, Pose(0, 8, 90)), (1.0, Pose(0, 12, 90))),
        *((1.0, Pose(0, 12, 90)), (1.5, Pose(5, 12, 180))),
    ]


def test_a_thing_that_is_back_at_its_start_did_not_move() -> None:
    scene = load_text("model( size [ 1 1 1 ] pose [ 1 0 0 0 ] )\nposition()", Path("box.world"))
    away = leg(Pose(0, 9, 0), PlacedThing("box", Pose(20, 9, 90), 0))

    assert (
        moved_things((*away, Stamped(3, 0.0, Reset(Pose(0, 0, 0))), Stamped(4, 0.0, ThingsMoved(()))), scene)
        == ()
    )


def test_the_svg_moves_the_thing_with_its_letter_in_the_time_of_the_dot() -> None:
    it, _ = carried()
    svg = ElementTree.fromstring(as_svg(it))
    _, group = svg.findall(f"{SVG}g")
    slide = group.find(f"{SVG}animateTransform")
    turn = group.find(f"{SVG}path/{SVG}animateTransform")

    assert slide is not None
    assert turn is not None
    assert (slide.attrib["type"], slide.attrib["dur"], slide.attrib["fill"]) == (
        "translate",
        "1.5s",
        "freeze",
    )
    assert slide.attrib["keyTimes"] == "0.0000;0.4000;0.6667;0.6667;1.0000"
    places = [tuple(map(float, each.split())) for each in slide.attrib["values"].split(";")]
    steps = [(round(x / it.scale, 2), round(y / it.scale, 2)) for x, y in places]
    assert steps == [(-5, 4), (-5, 4), (-5, 0), (-5, 0), (0, 0)]
    assert [each.split()[0] for each in turn.attrib["values"].split(";")] == ["-90", "-90", "-90", "-90", "0"]
    assert [each.text for each in group.iter(f"{SVG}text")] == ["m"]
    assert "m" not in [each.text for each in svg.findall(f"{SVG}text")]


def test_the_gif_shows_the_thing_where_it_is_at_each_moment() -> None:
    it, _ = carried()
    image = Image.open(BytesIO(as_gif(it)))

    def is_red(x: float, y: float) -> bool:
        red, green, blue = image.convert("RGB").getpixel(tuple(map(round, it.at(x, y))))  # type: ignore[misc, arg-type]
        return bool(red > green + 60 and red > blue + 60)

    assert [is_red(0.8, 8.6), is_red(4.4, 12)] == [True, False]
    image.seek(image.n_frames - 1)
    assert [is_red(0.8, 8.6), is_red(4.4, 12)] == [False, True]


@pytest.mark.parametrize("is_carried", [True, False])
def test_nothing_stands_between_the_elements_of_the_svg(is_carried: bool) -> None:
    it = carried()[0] if is_carried else drawn(goals=PLACES)
    svg = ElementTree.fromstring(as_svg(it))
    with_text = {f"{SVG}{name}" for name in ("title", "desc", "text")}
    between = [each.tail or "" for each in svg.iter()]
    between += [each.text or "" for each in svg.iter() if each.tag not in with_text]

    assert "".join(between).strip() == ""
    moves = [
        (each.attrib["attributeName"], each.attrib["type"]) for each in svg.iter(f"{SVG}animateTransform")
    ]
    assert {*moves} == {("transform", "translate"), ("transform", "rotate")}


# --- what is drawn, alone

ALONE = DrivenPath("", (Pose(0, 0, 0), Pose(0, 10, 0), Pose(0, 10, 90)))


def alone(path: DrivenPath = ALONE) -> RunPicture:
    return run_picture("T", (), (path,), Words())


def test_a_short_run_is_drawn_with_24_pixels_a_step() -> None:
    it = alone()
    (x0, y0), (x1, y1) = it.at(0, 0), it.at(1, 10)

    assert (x1 - x0, y0 - y1) == pytest.approx((24, 240))
    assert it.width == 320 + 2 * 24


def test_the_arrow_of_a_path_has_its_tip_where_the_robot_looks() -> None:
    """1.3 steps from the middle to each corner: ahead, and 140 degrees to either side."""
    it, size = alone(), 1.3 * 24
    x, y = it.at(0, 10)

    assert arrow(it, ALONE) == [
        pytest.approx((x + size * right, y + size * down), abs=0.06)
        for right, down in ((1, 0), (-0.766, 0.643), (-0.766, -0.643))
    ]


@pytest.mark.parametrize(
    ("seconds", "y", "heading"),
    [(0, 0, 0), (0.25, 2.5, 0), (0.5, 5, 0), (1.0, 10, 0), (1.1, 10, 90), (9, 10, 90)],
)
def test_the_dot_is_ten_times_as_fast_as_the_robot(seconds: float, y: float, heading: float) -> None:
    it = alone()

    assert list(driven_to(it, seconds)) == [(pytest.approx(it.at(0, y)), heading)]


def test_a_plot_is_drawn_as_it_is_laid_out() -> None:
    plot = Plot(
        "t",
        "What is said.",
        100,
        80,
        axes=(((10, 10), (10, 70), (90, 70)),),
        curves=(((20, 60), (80, 20)),),
        dots=((30, 20),),
        texts=(PlotText(50, 78, "M", "middle"),),
    )
    image = Image.open(BytesIO(plot_as_png(plot)))
    black, white = (0, 0, 0), (255, 255, 255)

    assert (image.size, image.info["Description"]) == ((100, 80), "What is said.")
    for place in ((10, 10), (10, 40), (50, 70), (90, 70), (50, 40), (30, 20), (33, 20), (30, 17), (27, 20)):
        assert image.getpixel(place) == black, place
    for place in ((5, 40), (50, 65), (12, 12), (35, 20), (30, 25), (60, 40), (95, 70)):
        assert image.getpixel(place) == white, place
    letters = [x for x in range(100) for y in range(72, 80) if image.getpixel((x, y)) != white]
    assert (min(letters) + max(letters)) / 2 == pytest.approx(50, abs=1.5)


def luminance(colour: str) -> float:
    """Relative, as in WCAG 2."""
    parts = [int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)]
    red, green, blue = (
        each / 12.92 if each <= 0.04045 else ((each + 0.055) / 1.055) ** 2.4 for each in parts
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def test_four_paths_have_dark_colours_of_their_own() -> None:
    paths = [DrivenPath(f"r{at}", (Pose(at, 0, 0), Pose(at, 5, 0))) for at in range(5)]
    svg = ElementTree.fromstring(as_svg(run_picture("T", (), paths, Words())))
    colours = [each.attrib["stroke"] for each in svg.iter(f"{SVG}polyline")]

    assert len(set(colours[:4])) == 4
    assert colours[4] == colours[0]
    assert all(1.05 / (luminance(each) + 0.05) >= 4.5 for each in colours)


def test_a_path_begins_at_a_ring_with_the_name_of_its_robot() -> None:
    it = alone(DrivenPath("bob", (Pose(0, 0, 0), Pose(0, 10, 0))))
    x, y = it.at(0, 0)
    image = Image.open(BytesIO(as_png(it))).convert("RGB")

    def pixel(right: int, down: int) -> object:
        return image.getpixel((round(x) + right, round(y) + down))

    ring = pixel(4, 0)
    assert ring not in ((255, 255, 255), (0, 0, 0))
    assert [pixel(*each) for each in ((-4, 0), (0, 4), (0, -4), (0, -60))] == [ring] * 4
    assert pixel(0, 0) == pixel(6, 0) == pixel(0, 6) == (255, 255, 255)
    assert [each for each in texts_on(it) if each[2] == "bob"] == [(x + 8, round(y + LETTER / 3, 1), "bob")]
    assert not [each for each in texts_on(alone()) if not each[2]]


# --- where everything has its place


def test_a_picture_has_two_steps_around_its_path_a_margin_and_its_texts_above_and_below() -> None:
    it = alone()
    title, *legend = texts_on(it)

    assert it.top == 48
    assert it.at(0, 10) == (24 + 48, 48 + 48)
    assert it.height == 48 + 14 * 24 + 24 + 20 * len(it.legend)
    assert title == (24, 24, "T")
    assert legend == [(24, it.height - 20 * (len(it.legend) - at), line) for at, line in enumerate(it.legend)]
    assert it.legend[0] == "north is at the top"


def test_a_title_of_several_lines_moves_the_map_down() -> None:
    one, two = alone(), run_picture("Long words " * 9, (), (ALONE,), Words())
    more = len(two.title_lines) - 1

    assert more > 0
    assert (two.top, two.height) == (one.top + 20 * more, one.height + 20 * more)
    assert [text[:2] for text in texts_on(two)][: more + 1] == [(24, 24 + 20 * at) for at in range(more + 1)]


@pytest.mark.parametrize(
    ("goals", "moments", "edges"),
    [
        ((), (), (-2, 2)),
        (((1, -7.0, -5.0, 9.0, 3.0),), (), (-9, 5)),
        ((), ((0.0, Pose(-7, -5, 0)), (1.0, Pose(9, 3, 0))), (-9, 5)),
    ],
)
def test_a_picture_without_a_path_begins_two_steps_from_its_goals_and_moved_things(
    goals: Sequence[GoalPlace], moments: tuple[tuple[float, Pose], ...], edges: tuple[float, float]
) -> None:
    it = run_picture("T", (), (), Words(), goals, [MovedThing(0, moments)] if moments else ())

    assert (it.west, it.north) == edges
    assert it.at(*edges) == (24, 48)


@pytest.mark.parametrize("far", [Pose(96, 0, 0), Pose(0, 96, 0)])
def test_a_long_path_is_nine_hundred_pixels_long_or_high(far: Pose) -> None:
    it = alone(DrivenPath("", (Pose(0, 0, 0), far)))

    assert it.scale == 9
    assert it.width == (948 if far.x else 368)


def thing(side: float, colour: str = "red", letter: str = "b", index: int = 0, **more: bool) -> Drawing:
    half = side / 2
    shape = (box(-half, -half, half, half),)
    return Drawing(
        shape, Thing("", "box", letter, colour, 0, 0, side, side, index=index, outlines=shape, **more), False
    )


def specks(*places: tuple[float, float]) -> Iterator[Drawing]:
    """Walls of a fifth of a pixel, so many pixels to the right and down from the middle."""
    for right, down in places:
        x, y = right / 24, -down / 24
        yield Drawing((box(x, y, x + 0.2 / 24, y + 0.2 / 24),), None, False)


def test_the_letter_of_a_large_thing_is_in_its_middle() -> None:
    it = run_picture("T", (thing(2),), (), Words())
    (x, y), wide = it.labels[0], ImageFont.load_default(LETTER).getlength("b")

    assert (it.at(0, 0), it.letters) == (pytest.approx((x + wide / 2, y - 14 / 3), abs=0.11), {0: "b"})


@pytest.mark.parametrize(
    ("wide", "high", "is_inside"),
    [(0.7, 0.9, True), (0.6, 0.9, False), (0.7, 0.85, False), (0.3, 4, False), (4, 0.3, False), (4, 4, True)],
)
def test_a_letter_is_in_a_thing_that_is_three_pixels_wider_on_each_side_and_half_as_high_again(
    wide: float, high: float, is_inside: bool
) -> None:
    """The letter is 14 high and, as it may be in other programs, 10 wide; a step is 24 pixels."""
    shape = (box(-wide / 2, -high / 2, wide / 2, high / 2),)
    there = Thing("", "box", "b", "red", 0, 0, wide, high, outlines=shape)
    it = run_picture("T", (Drawing(shape, there, False),), (), Words())
    (left, _), (middle, _) = it.labels[0], it.at(0, 0)

    assert (left < middle) is is_inside


AROUND = ("right", "left", "above", "below", "right, above", "right, below", "left, above", "left, below")


@pytest.mark.parametrize("taken", range(len(AROUND)))
def test_the_letter_of_a_small_thing_is_next_to_it_where_room_is(taken: int) -> None:
    """Of 12 pixels. 4 pixels are between a thing and its letter, which is 0.8 and 0.25 of its height 14."""
    near = 10.1
    places = [(near, 0), (-near, 0), (0, -near), (0, near), (near, -near), (near, near), (-near, -near)]
    it = run_picture("T", (thing(0.5), *specks(*places[:taken])), (), Words())
    x, y = it.at(0, 0)
    length = ImageFont.load_default(LETTER).getlength("b")
    columns = {"right": x + 10, "left": x - 10 - 1.15 * length}
    lines = {"above": y - 10 - 3.5, "below": y + 10 + 11.2}
    side, _, line = AROUND[taken].partition(", ")
    expected = columns.get(side, x - length / 2), lines.get(line or side, y + 14 / 3)

    assert it.labels[0] == pytest.approx(expected, abs=0.11)


@pytest.mark.parametrize(("rings", "further"), [((10.1,), 5), ((10.1, 16.1), 11)])
def test_a_letter_is_further_away_where_the_nearer_places_are_taken(
    rings: tuple[float, ...], further: float
) -> None:
    sides = [(right, down) for right in (-1, 0, 1) for down in (-1, 0, 1) if right or down]
    ring = [(reach * right, reach * down) for reach in rings for right, down in sides]
    it = run_picture("T", (thing(0.5), *specks(*ring)), (), Words())

    assert it.labels[0][0] == pytest.approx(it.at(0, 0)[0] + 10 + further, abs=0.11)


@pytest.mark.parametrize(
    ("lines", "right", "down", "place"),
    [
        ("goal", -36, 0, "left"),  # its eastern side, 12 pixels to the right
        ("goal", 60, 0, "left"),
        ("goal", 0, 48, "above"),
        ("goal", 0, -48, "above"),
        ("wall", 63, 0, "left"),
        ("wall", 0, 56, "above"),
        ("wall", 0, -53, "below"),
        ("arrow", 24, 4, "left"),
        ("arrow", 0, -24, "below"),
    ],
)
def test_a_letter_is_on_no_side_of_a_goal_a_wall_or_an_arrow(
    lines: str, right: int, down: int, place: str
) -> None:
    """Whose middle is so many pixels away from a thing of 6 pixels. Boxes are 96 wide and high.

    The left side of the arrow leads from 20 pixels to the left and 24 down to 31 up; its base is 24 down.
    """
    x, y = right / 24, -down / 24
    sides = x - 2, y - 2, x + 2, y + 2
    walls = (Drawing((box(*sides),), None, False),) if lines == "wall" else ()
    goals = ((1, *sides),) if lines == "goal" else ()
    south = -20 if right else 20
    paths = (DrivenPath("", (Pose(x, y + south, 0), Pose(x, y, 0))),) if lines == "arrow" else ()
    it = run_picture("T", (thing(0.25), *walls), paths, Words(), goals)
    x, y = it.at(0, 0)
    length = ImageFont.load_default(LETTER).getlength("b")
    expected = {
        "left": (x - 7 - 1.15 * length, y + 14 / 3),
        "above": (x - length / 2, y - 7 - 3.5),
        "below": (x - length / 2, y + 7 + 11.2),
    }

    assert it.labels[0] == pytest.approx(expected[place], abs=0.11)


def test_a_thing_in_a_wall_has_no_letter_and_one_on_a_carpet_has() -> None:
    on_wall = run_picture("T", (thing(0.5), Drawing((box(-9, -9, 9, 9),), None, False)), (), Words())
    carpet = thing(6, "blue", "c", 1)
    on_carpet = run_picture("T", (thing(0.5), carpet), (), Words())

    assert on_wall.labels == {}
    assert "1 thing without room for a letter." in on_wall.legend
    assert on_carpet.labels[0][0] > on_carpet.at(0, 0)[0]
    assert not [line for line in on_carpet.legend if "without" in line]


NAMES = ((8, 0), (-8, 0), (8, -14), (-8, -14), (8, 14), (-8, 14), (8, -28), (-8, -28), (0, -28))


@pytest.mark.parametrize("taken", range(len(NAMES)))
def test_the_name_of_a_robot_is_next_to_its_start_where_room_is(taken: int) -> None:
    """To the right or left of the ring, else a line or two above or below it."""
    walls = specks(*((right * 3, down) for right, down in NAMES[:taken]))
    path = DrivenPath("bob", (Pose(0, 0, 180), Pose(0, -20, 180)))
    it = run_picture("T", tuple(walls), (path,), Words())
    x, y = it.at(0, 0)
    length, (right, down) = 1.15 * ImageFont.load_default(LETTER).getlength("bob"), NAMES[taken]
    left = x - length / 2 if not right else x + right if right > 0 else x + right - length

    assert it.marks == ((pytest.approx(left, abs=0.11), pytest.approx(y + 14 / 3 + down, abs=0.11), "bob"),)


@pytest.mark.parametrize("east", [20, -20])
def test_no_name_leaves_the_picture_on_a_side(east: int) -> None:
    """The line is on one side of the start, and the name is longer than the 72 pixels on the other."""
    name = "a robot with a name"
    it = run_picture("T", (), (DrivenPath(name, (Pose(0, 0, 90), Pose(east, 0, 90))),), Words())
    (x, y), length = it.at(0, 0), 1.15 * ImageFont.load_default(LETTER).getlength(name)
    left = x + 8 if east > 0 else x - 8 - length

    assert it.marks == ((pytest.approx(left, abs=0.11), pytest.approx(y + 14 / 3 - 14, abs=0.11), name),)


@pytest.mark.parametrize("is_taken", [False, True])
def test_no_number_of_a_goal_leaves_the_picture_above_or_below(is_taken: bool) -> None:
    """900 pixels for 204 steps: each goal is 8.8 from an edge of the map, and its number needs 29.7."""
    wall = (Drawing((box(-40, -195.5, 40, -195.4),), None, False),) if is_taken else ()
    goals = ((1, 0.0, 0.0, 0.0, 0.0), (2, 0.0, -200.0, 0.0, -200.0))
    it = run_picture("T", wall, (), Words(), goals)
    below, above = it.at(0, 0)[1] + 10 + 5 + 11.2, it.at(0, -200)[1] - 10 - 5 - 3.5

    assert [(text, base) for _, base, text in it.marks] == [
        ("1", pytest.approx(below, abs=0.11)),
        *([] if is_taken else [("2", pytest.approx(above, abs=0.11))]),
    ]


CORNERS = ("left, above", "right, above", "before, above", "after, above")
CORNERS += tuple(each.replace("above", "below") for each in CORNERS)


@pytest.mark.parametrize("taken", range(len(CORNERS)))
def test_the_numbers_of_a_goal_are_at_a_corner_of_its_box_where_room_is(taken: int) -> None:
    """Above it or below it, as far to the left or right as the box, or beyond its sides."""
    columns = {"left": -40, "right": 40, "before": -70, "after": 70}
    walls = specks(
        *(
            (columns[x], -65 if y == "above" else 65)
            for x, y in (each.split(", ") for each in CORNERS[:taken])
        )
    )
    it = run_picture("T", tuple(walls), (), Words(), ((12, -2.0, -2.0, 2.0, 2.0), (13, -2.0, -2.0, 2.0, 2.0)))
    x, y = it.at(0, 0)
    length, (across, line) = (
        1.15 * ImageFont.load_default(LETTER).getlength("12, 13"),
        CORNERS[taken].split(", "),
    )
    left = {"left": x - 48, "right": x + 48 - length, "before": x - 53 - length, "after": x + 53}[across]
    base = y - 48 - 5 - 3.5 if line == "above" else y + 48 + 5 + 11.2

    assert it.marks == ((pytest.approx(left, abs=0.11), pytest.approx(base, abs=0.11), "12, 13"),)


def test_a_small_place_of_a_goal_is_a_box_of_twenty_pixels() -> None:
    (goal,) = goals_on(run_picture("T", (), (), Words(), ((1, 0.0, 0.0, 0.0, 0.0),)))

    assert goal == ShownGoal("1", 24 + 48, 48 + 48, 10, 10)


@pytest.mark.parametrize(
    ("seconds", "pose"),
    [
        (0, Pose(0, 0, 350)),
        (1, Pose(0, 0, 350)),
        (2, Pose(1, 2, 360)),
        (3, Pose(2, 4, 370)),
        (4, Pose(2, 4, 10)),
        (5, Pose(4, 4, 95)),
        (6, Pose(6, 4, 180)),
        (9, Pose(6, 4, 180)),
    ],
)
def test_a_moved_thing_is_between_its_places_and_turns_the_short_way(seconds: float, pose: Pose) -> None:
    poses = Pose(0, 0, 350), Pose(0, 0, 350), Pose(2, 4, 10), Pose(2, 4, 10), Pose(6, 4, 180)
    it = MovedThing(0, tuple(zip((0.0, 1.0, 3.0, 4.0, 6.0), poses, strict=True)))
    found = it.at(seconds)

    assert (found.x, found.y, found.heading % 360) == (pose.x, pose.y, pose.heading % 360)
    assert (it.end, it.seconds) == (Pose(6, 4, 180), 6)
    assert MovedThing(0, it.moments[:1]).seconds == 0.1


@pytest.mark.parametrize(
    ("turned", "corner"), [(0, (4, 4)), (90, (3, -1)), (180, (-2, 0)), (270, (-1, 5)), (-90, (-1, 5))]
)
def test_the_outline_of_a_moved_thing_is_turned_around_its_place(
    turned: float, corner: tuple[float, float]
) -> None:
    """Its corner is 3 to the east and 2 to the north of its place, which was 1, 2 then."""
    it = Drawing((((13.0, 22.0), (10.0, 20.0)),), None, False)
    ((there, place),) = moved_outlines(it, Pose(10, 20, 30), Pose(1, 2, 30 + turned))

    assert (there, place) == (pytest.approx(corner), pytest.approx((1, 2)))


def test_the_times_of_moved_things_are_those_of_the_robot_that_moved_them() -> None:
    """Of a walk, of a turn, of one after RESET, and of a robot whose place is not known yet."""
    scene = load_text("position() " + "model( size [ .1 .1 .1 ] ) " * 3, Path("boxes.world"))
    start = Pose(0, 0, 90)

    def things(robot: str, *places: tuple[int, float]) -> Stamped:
        return Stamped(
            1, 0.0, ThingsMoved(tuple(PlacedThing("", Pose(x, 0, 90), at) for at, x in places)), robot
        )

    how = HowStarted("", 1, True, False, False, Pose(0, -8, 0))
    events = (
        Stamped(1, 0.0, RunStarted("p", "", "", 0, "", how), "ana"),
        Stamped(1, 0.0, Driven("forward", Pose(0, 12, 0)), "ana"),
        Stamped(1, 0.0, Driven("forward", Pose(50, 0, 0)), "bob"),
        things("ana", (1, 5), (9, 5), (-1, 5)),
        Stamped(1, 0.0, Turned("TR", 90, 90, None, Pose(50, 0, 90), True), "bob"),
        things("bob", (1, 5), (2, 30)),
        Stamped(1, 0.0, Moved("FW", 30, 30, None, Pose(80, 0, 90), True), "bob"),
        things("bob", (1, 5), (2, 40)),
        Stamped(1, 0.0, RunStarted("p", "", "", 0, "", replace(how, fresh=False)), "ana"),
        Stamped(1, 0.0, Driven("forward", Pose(5, 12, 0)), "ana"),
        things("ana", (1, 9), (2, 40)),
        Stamped(1, 0.0, Reset(Pose(0, 0, 0)), "ana"),
        Stamped(1, 0.0, Driven("forward", Pose(0, 70, 0)), "ana"),
        things("ana", (1, 10), (2, 40), (3, 1)),
    )

    assert [(each.index, each.moments) for each in moved_things(events, scene)] == [
        # 20 steps driven, pushed in the last 5; then 25 driven, pushed 4; then 70, pushed 1
        (
            1,
            (
                *((0, start), (1.5, start), (2.0, Pose(5, 0, 90))),
                *((2.1, Pose(5, 0, 90)), (2.5, Pose(9, 0, 90))),
                *((6.9, Pose(9, 0, 90)), (7.0, Pose(10, 0, 90))),
            ),
        ),
        # turned on the spot; then pushed 10 of 30 steps
        (2, ((0, start), (0, start), (0, Pose(30, 0, 90)), (2.0, Pose(30, 0, 90)), (3.0, Pose(40, 0, 90)))),
        (3, ((0, start), (6.9, start), (7.0, Pose(1, 0, 90)))),
    ]


def test_a_run_that_continues_begins_where_its_robot_is() -> None:
    scene = load_text("position() model( size [ .1 .1 .1 ] )", Path("boxes.world"))
    how = HowStarted("", 1, False, False, False, Pose(0, -8, 0))
    begun = (
        Stamped(1, 0.0, RunStarted("p", "", "", 0, "")),
        Stamped(1, 0.0, RunStarted("p", "", "", 0, "", how)),
    )
    (box,) = moved_things((*begun, *leg(Pose(0, 12, 0), PlacedThing("", Pose(5, 0, 90), 1))), scene)

    start = Pose(0, 0, 90)
    assert box.moments == ((0, start), (1.5, start), (2.0, Pose(5, 0, 90)))


def test_what_is_put_back_has_not_moved_and_the_rest_has() -> None:
    scene = load_text("position() " + "model( size [ .1 .1 .1 ] ) " * 2, Path("boxes.world"))
    both = (PlacedThing("", Pose(5, 0, 90), 1), PlacedThing("", Pose(5, 0, 90), 2))

    moved = moved_things((*leg(Pose(0, 9, 0), *both), *leg(Pose(0, 12, 0), both[1])), scene)

    assert [each.index for each in moved] == [2]
    assert moved_things(leg(Pose(0, 9, 0), PlacedThing("", Pose(0, 0, 90), 1)), scene) == ()


def test_robots_that_drove_differ_from_those_that_stood_by_their_names() -> None:
    def shown(*robots: str) -> int:
        named = [
            replace(thing(1, index=at, is_robot=True).thing, name=name)
            for at, name in enumerate(("ana", "bob"))
        ]
        drawn = [Drawing(each.outlines, each, False) for each in named]
        paths = [DrivenPath(robot, (Pose(0, 0, 0), Pose(9, 9, 0))) for robot in robots]
        return len(run_picture("T", (*drawn, thing(1, index=2)), paths, Words()).drawings)

    assert [shown(), shown("ana"), shown("ana", "bob"), shown("")] == [3, 2, 1, 1]


def test_a_thing_has_a_second_letter_only_where_its_own_stands_for_several_colours() -> None:
    things = (
        *(thing(1, letter="c"), thing(1, "blue", "c", 1)),
        *(thing(1, "green", "p", 2), thing(1, "", "c", 3)),
    )
    it = run_picture("T", things, (), Words())

    assert it.letters == {0: "cR", 1: "cB", 2: "p", 3: "c"}
    assert [line for line in it.legend if line[1:2] in (":", "R", "B")] == [
        *("c: box, unknown", "cB: box, blue", "cR: box, red", "p: box, green"),
    ]


def test_the_svg_has_the_colours_and_lines_of_walls_things_goals_and_paths() -> None:
    wall = Drawing((box(-3, -3, -2, 2), box(2, -3, 3, 2)), None, True)
    path = DrivenPath("", (Pose(0, 0, 0), Pose(0, 6, 0)))
    it = run_picture("<T>", (wall, thing(1), thing(1, "", "n", 1)), (path,), Words(), PLACES[:1])
    svg = ElementTree.fromstring(as_svg(it))
    shapes = svg.findall(f"{SVG}path")
    (x, y), (goal,) = it.at(0, 0), (each for each in svg.iter(f"{SVG}rect") if each.get("class") == "goal")
    ring, line, point = (svg.find(f"{SVG}{name}") for name in ("circle", "polyline", "polygon"))

    assert svg.attrib["viewBox"] == f"0 0 {it.width:g} {it.height:g}"
    assert (svg.attrib["width"], svg.attrib["height"]) == (f"{it.width:g}", f"{it.height:g}")
    assert [each.attrib["fill"] for each in shapes] == ["#444444", "#ff9e94", "#bbbbbb"]
    assert {(each.attrib["stroke"], each.attrib["stroke-width"]) for each in shapes} == {("#000000", "1")}
    half = it.scale / 2
    corners = [(x - half, y + half), (x + half, y + half), (x + half, y - half), (x - half, y - half)]
    numbers = [float(each) for each in re.findall(r"[\d.]+", shapes[1].attrib["d"])]
    assert numbers == pytest.approx([side for corner in corners for side in corner], abs=0.11)
    assert re.sub(r"[\d. ]+", " ", shapes[0].attrib["d"]) == "M L L L Z M L L L Z"
    assert (goal.attrib["fill"], goal.attrib["stroke"]) == ("none", "#000000")
    assert "stroke-dasharray" in goal.attrib
    assert ring is not None and line is not None and point is not None
    assert (ring.attrib["cx"], ring.attrib["cy"], ring.attrib["r"]) == (f"{x:g}", f"{y:g}", "4")
    assert ring.attrib["stroke"] == line.attrib["stroke"] == point.attrib["fill"] == "#7b2cbf"
    assert (ring.attrib["fill"], line.attrib["fill"]) == ("white", "none")
    assert {each.attrib["fill"] for each in svg.iter(f"{SVG}text")} == {"#000000"}
    assert svg.find(f"{SVG}text").text == "<T>"  # type: ignore[union-attr]


@pytest.mark.parametrize(("suffix", "begin"), [(".svg", b"<svg "), (".png", b"\x89PNG"), (".gif", b"GIF89a")])
def test_a_picture_is_of_the_kind_of_its_file(suffix: str, begin: bytes) -> None:
    assert as_picture(alone(), suffix).startswith(begin)


def frames_of(it: RunPicture) -> list[tuple[Image.Image, int]]:
    """Each with the milliseconds that it is shown."""
    image = Image.open(BytesIO(as_gif(it)))
    found = []
    for number in range(image.n_frames):
        image.seek(number)
        found.append((image.convert("RGB"), image.info["duration"]))
    return found


@pytest.mark.parametrize(
    ("steps", "count", "pause"), [(10, 11, 100), (5, 6, 100), (0.2, 2, 100), (590, 60, 1000)]
)
def test_a_gif_has_ten_frames_a_second_and_sixty_at_most(steps: float, count: int, pause: int) -> None:
    frames = frames_of(alone(DrivenPath("", (Pose(0, 0, 0), Pose(0, steps, 0)))))

    assert (len(frames), {duration for _, duration in frames}) == (count, {pause})


def test_a_frame_of_a_gif_has_the_thing_and_its_letter_where_they_are_at_that_moment() -> None:
    """The box of 2 by 4 steps is pushed from 8 to 12 between 0.6 and 1 seconds, and then turned."""
    it, _ = carried()
    (frame, _), (last, _) = frames_of(it)[8], frames_of(it)[-1]

    def pixels(image: Image.Image, x: float, y: float, reach: int = 0) -> list[tuple[int, int, int]]:
        px, py = map(round, it.at(x, y))
        sides = range(-reach, reach + 1)
        return [image.getpixel((px + right, py + down)) for right in sides for down in sides]  # type: ignore[misc]

    def is_red(image: Image.Image, x: float, y: float) -> bool:
        ((red, green, _),) = pixels(image, x, y)
        return red > green + 60

    assert [is_red(frame, 0.7, y) for y in (7.7, 8.4, 11.6, 12.3)] == [False, True, True, False]
    assert [is_red(last, x, 12.7) for x in (2.7, 3.4, 6.6, 7.3)] == [False, True, True, False]
    assert min(map(max, pixels(frame, 0, 10, 6))) < 0x40  # the letter
    assert min(map(max, pixels(last, 5, 12, 6))) < 0x40
    ((red, green, blue),) = pixels(last, 0, 4)
    assert min(red, blue) > green + 30  # the path, violet
    assert min(*pixels(last, -4, 4)[0]) > 0xF0


@pytest.mark.parametrize(("steps", "scale", "radius", "tip"), [(10, 24, 31.2, 31.2), (896, 1, 3, 6)])
def test_the_robot_of_a_large_picture_is_small_but_can_be_seen(
    steps: int, scale: float, radius: float, tip: float
) -> None:
    path = DrivenPath("", (Pose(0, 0, 0), Pose(0, steps, 0)))
    it = alone(path)
    dot = ElementTree.fromstring(as_svg(it)).find(f"{SVG}g/{SVG}circle")
    x, y = it.at(0, steps)

    assert it.scale == scale
    assert dot is not None
    assert dot.attrib["r"] == f"{radius:g}"
    assert arrow(it, path)[0] == pytest.approx((x, y - tip))


def test_of_a_path_with_a_gap_the_known_pieces_are_drawn() -> None:
    path = DrivenPath("", (Pose(0, 0, 0), Pose(0, 6, 0), Pose(6, 6, 90)), has_gap=True)
    it = alone(path)
    lines = ElementTree.fromstring(as_svg(it)).findall(f"{SVG}polyline")
    image = Image.open(BytesIO(as_png(it)))

    assert [each.attrib["points"] for each in lines] == [
        " ".join(f"{x:g},{y:g}" for x, y in (it.at(0, 6), it.at(6, 6))),
    ]
    violet, white = (0x7B, 0x2C, 0xBF), (255, 255, 255)
    (px, py), (qx, qy) = it.at(3, 6), it.at(0, 3)
    assert image.getpixel((round(px), round(py))) == violet
    assert image.getpixel((round(qx), round(qy))) == white


def test_the_png_has_goals_as_boxes_and_says_what_the_legend_says() -> None:
    it = run_picture("T", (thing(1),), (ALONE,), Words(), ((1, -3.0, -3.0, 3.0, 3.0),))
    image = Image.open(BytesIO(as_png(it)))
    x, y = map(round, it.at(0, 0))

    def at(right: int, down: int) -> object:
        return image.getpixel((x + right, y + down))

    assert image.info["Description"] == " ".join(it.legend)
    assert [at(*each) for each in ((-72, 9), (72, 9), (9, -72), (9, 72))] == [(0, 0, 0)] * 4
    assert [at(*each) for each in ((-68, 9), (68, 9), (9, -68), (9, 68), (-76, 9))] == [(255, 255, 255)] * 5
    assert at(-9, -9) == (0xFF, 0x9E, 0x94)  # the thing is red
    assert at(12, 9) == at(-12, 9) == (0, 0, 0)  # and has an edge


def test_the_png_of_a_path_has_its_arrow_its_ring_its_texts_and_the_name_of_the_program() -> None:
    it = alone(DrivenPath("", (Pose(0, 0, 90), Pose(9, 0, 90))))
    image = Image.open(BytesIO(as_png(it))).convert("RGB")
    violet, white = (0x7B, 0x2C, 0xBF), (255, 255, 255)
    (x, y), (end, _) = it.at(0, 0), it.at(9, 0)
    row = [image.getpixel((round(x) + right, round(y))) for right in range(-6, 8)]

    assert Image.open(BytesIO(as_png(it))).info["Software"] == "donnie"
    # the ring is 8 pixels wide with a border of 2, and the line begins beyond it
    assert row == [white] * 2 + [violet] * 2 + [white] * 5 + [violet] * 5
    assert [image.getpixel((round(end) + right, round(y) + 3)) for right in (-30, -12, 12, 32)] == [
        *(white, violet, violet, white),  # within the arrow
    ]
    for left, base, text in texts_on(it):
        ink = image.crop((round(left), round(base) - 12, round(left) + 8 * len(text), round(base) + 3))
        assert min(ink.convert("L").tobytes()) < 0x40


@pytest.mark.parametrize(
    ("seconds", "place", "heading"),
    [
        (0.0, (0, 0), 0),
        (0.2, (0, 2), 0),
        (0.4, (0, 4), 0),
        (0.5, (1, 4), 22.5),
        (0.8, (4, 4), 90),
        (0.9, (4, 4), 90),
    ],
)
def test_a_dot_turns_evenly_on_its_way_and_stops_at_the_end(
    seconds: float, place: tuple[float, float], heading: float
) -> None:
    it = alone(DrivenPath("", (Pose(0, 0, 0), Pose(0, 4, 0), Pose(4, 4, 90), Pose(4, 4, 90))))

    assert [*driven_to(it, seconds)] == [(pytest.approx(it.at(*place), abs=0.11), pytest.approx(heading))]


def test_a_title_of_one_long_word_is_parted_and_stays_whole() -> None:
    it = run_picture("W" * 60, (), (ALONE,), Words())
    font = ImageFont.load_default(LETTER)

    assert "".join(it.title_lines) == "W" * 60
    assert len(it.title_lines) > 1
    assert all(1.15 * font.getlength(each) <= 320 for each in it.title_lines)
    assert len({len(each) for each in it.title_lines[:-1]}) == 1
    assert 1.15 * font.getlength("W" * (len(it.title_lines[0]) + 2)) > 320  # no shorter than needed


# --- crowds

LONG_TITLE = "The world in which everything stands so close that the letters would touch each other " * 3
TITLES = (LONG_TITLE[:200], "W" * 200, "A short one")
COLOURS_OF_THINGS = ("red", "green", "blue", "yellow", "gray")


def crowd(seed: int) -> RunPicture:
    """Some hundred things of many sizes, walls between them, goals, and two robots that drove among them."""
    chance = Random(seed)
    kinds = ("box", "ball", "chair", "plant")
    world = [
        "define box model ( )",
        "define ball model ( )",
        "define chair model ( )",
        "define plant model ( )",
    ]
    world.append('position( name "alice" pose [ 0 0 0 90 ] ) position( name "bob" pose [ 0.2 0 0 90 ] )')
    for _ in range(chance.choice((60, 120, 250))):
        size, x, y = chance.choice((0.05, 0.1, 0.3)), chance.uniform(-2, 2), chance.uniform(-2, 2)
        world.append(
            f"{chance.choice(kinds)}( size [ {size} {size} .1 ] pose [ {x:.2f} {y:.2f} 0 0 ]"
            f' color "{chance.choice(COLOURS_OF_THINGS)}" )'
        )
    for _ in range(4):
        x, y = chance.uniform(-2, 2), chance.uniform(-2, 2)
        world.append(f'model( name "wall" size [ 1 .05 .5 ] pose [ {x:.2f} {y:.2f} 0 30 ] color "gray" )')
    paths = [
        DrivenPath(name, tuple(Pose(chance.uniform(-40, 40), chance.uniform(-40, 40), 0) for _ in range(9)))
        for name in ("alice", "bob")
    ]
    goals: list[GoalPlace] = []
    for number in range(1, 4):
        x, y, half = chance.uniform(-30, 30), chance.uniform(-30, 30), chance.choice((0, 4))
        goals.append((number, x - half, y - half, x + half, y + half))
    scene = load_text("\n".join(world), Path("crowd.world"))
    return run_picture(TITLES[seed % 3], drawings(scene), paths, Words(), goals)


def texts_on(it: RunPicture) -> list[tuple[float, float, str]]:
    return list(texts(it, it.drawings))


def boxes_of_texts(it: RunPicture) -> list[tuple[float, float, float, float]]:
    font = ImageFont.load_default(LETTER)
    boxes = [(font.getbbox(text, anchor="ls"), x, y) for x, y, text in texts_on(it)]
    return [(x + box[0], y + box[1], x + box[2], y + box[3]) for box, x, y in boxes]


@pytest.mark.parametrize("seed", range(9))
def test_no_text_of_a_crowd_touches_another_or_a_path(seed: int) -> None:
    it = crowd(seed)
    placed = boxes_of_texts(it)
    points = [
        (x + (there[0] - x) * part / 200, y + (there[1] - y) * part / 200)
        for path in it.paths
        for (x, y), there in pairwise([it.at(pose.x, pose.y) for pose in path.poses])
        for part in range(201)
    ]

    for one, other in combinations(placed, 2):
        apart = one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]
        assert apart, (one, other)
    for left, top, right, bottom in placed:
        assert 0 <= left < right <= it.width
        assert 0 <= top < bottom <= it.height
        touched = [(x, y) for x, y in points if left - 1.5 < x < right + 1.5 and top - 1.5 < y < bottom + 1.5]
        assert touched == []
    things = [each for each in it.drawings if each.thing is not None]
    without = len(things) - len(it.labels)
    said = f"{without} thing{'s' * (without > 1)} without room for a letter."
    assert (said in " ".join(it.legend)) == (without > 0)
    assert len(it.labels) >= len(things) * 0.4


@pytest.mark.parametrize("title", TITLES)
def test_a_long_title_is_wrapped_and_whole(title: str) -> None:
    it = run_picture(title, drawings(load_text("position()", Path("a.world"))), (ALONE,), Words())
    lines = [text for x, y, text in texts_on(it) if y < it.top]

    assert "".join(lines).replace(" ", "") == title.replace(" ", "")
    assert (len(lines) > 1) == (len(title) > 100)
    assert all(right <= it.width for _, _, right, _ in boxes_of_texts(it))
    svg = ElementTree.fromstring(as_svg(it))
    assert [each.text for each in svg.findall(f"{SVG}text")][: len(lines)] == lines
