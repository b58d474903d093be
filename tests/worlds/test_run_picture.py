"""A run as a picture: what is drawn, to scale, in the right places, and said in words."""

import re
from collections.abc import Iterator, Sequence
from io import BytesIO
from itertools import combinations, pairwise
from pathlib import Path
from random import Random
from xml.etree import ElementTree

import pytest
from PIL import Image, ImageFont

import worlds
from devices.ports.robot import Pose
from donnie_tui.core.events import (
    HowStarted,
    Moved,
    PlacedThing,
    Reset,
    RunStarted,
    Stamped,
    ThingsMoved,
)
from donnie_tui.core.reports import Plot, PlotText
from donnie_tui.core.timeline import DrivenPath
from donnie_tui.i18n.words import Words
from donnie_tui.world.loading import moved_to
from donnie_tui.world.run_picture import (
    LETTER,
    MovedThing,
    RunPicture,
    arrow,
    as_gif,
    as_png,
    as_svg,
    driven_to,
    moved_things,
    plot_as_png,
    run_picture,
    texts,
)
from sim.picture import drawings
from sim.worldfile import load_text, load_world
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

    letters = [text for _, _, text in texts(drawn("two_robots", paths)) if len(text) <= 2]

    assert len(letters) == 3  # bob and two boxes
    assert "alice" in [text for _, _, text in texts(drawn("two_robots", paths))]
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
    assert [text for _, _, text in texts(it) if text in ("1", "2", "3", "2, 3")] == ["1", "2, 3"]
    assert [each for each in it.legend if each.startswith("goal")] == ["goal 1", "goal 2", "goal 3"]


def test_things_that_differ_in_colour_only_have_the_initial_of_the_colour() -> None:
    it = drawn("colour_garden")

    assert sorted(text for _, _, text in texts(it) if len(text) == 2) == [
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
    assert [each for each in texts(it) if each[2] == "bob"] == [(x + 8, round(y + LETTER / 3, 1), "bob")]
    assert not [each for each in texts(alone()) if not each[2]]


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


def boxes_of_texts(it: RunPicture) -> list[tuple[float, float, float, float]]:
    font = ImageFont.load_default(LETTER)
    boxes = [(font.getbbox(text, anchor="ls"), x, y) for x, y, text in texts(it)]
    return [(x + box[0], y + box[1], x + box[2], y + box[3]) for box, x, y in boxes]


@pytest.mark.parametrize("seed", range(30))
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
    lines = [text for x, y, text in texts(it) if y < it.top]

    assert "".join(lines).replace(" ", "") == title.replace(" ", "")
    assert (len(lines) > 1) == (len(title) > 100)
    assert all(right <= it.width for _, _, right, _ in boxes_of_texts(it))
    svg = ElementTree.fromstring(as_svg(it))
    assert [each.text for each in svg.findall(f"{SVG}text")][: len(lines)] == lines
