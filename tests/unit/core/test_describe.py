"""A world in words: places are relative to the robot, in steps, the nearest thing first."""

import pytest

import worlds
from devices.ports.robot import Pose
from donnie_tui.core.describe import (
    MOST_THINGS,
    arrived,
    compass_place_of,
    describe,
    place_of,
    things_in_words,
    worlds_in_words,
)
from donnie_tui.core.wording import facing
from donnie_tui.i18n.words import Words
from sim.picture import Picture, Thing, picture
from tests.floor import floor
from worlds.words import About, Difficulty


@pytest.mark.parametrize(
    ("x", "y", "heading", "place"),
    [
        (0, 5, 0, "5 ahead"),
        (-2, 5, 0, "2 left, 5 ahead"),
        (3, -1, 0, "3 right, 1 behind"),
        (0, 5, 90, "5 left"),
        (5, 0, 90, "5 ahead"),
        (0, 5, 180, "5 behind"),
        (0, 5, 270, "5 right"),
        (4, 4, 45, "6 ahead"),
        (0.2, -0.3, 0, "here"),
    ],
)
def test_a_place_is_described_as_seen_from_the_robot(x: float, y: float, heading: float, place: str) -> None:
    assert place_of(x, y, Pose(0.0, 0.0, heading), Words()) == place


@pytest.mark.parametrize(
    ("x", "y", "place"),
    [(0, 5, "5 north"), (-2, 5, "2 west, 5 north"), (3, -1, "3 east, 1 south"), (0.2, -0.3, "here")],
)
@pytest.mark.parametrize("heading", [0, 45, 270])
def test_a_place_by_the_compass_does_not_depend_on_the_heading(
    x: float, y: float, place: str, heading: float
) -> None:
    assert compass_place_of(x + 7, y - 4, Pose(7.0, -4.0, heading), Words()) == place


def test_a_world_is_described_from_its_size_to_its_things() -> None:
    seen = picture(floor(("red", 0, 10), ("green", 3, 0)))

    assert describe(seen, Pose(0.0, 0.0, 90.0), Words(), robot="donnie") == (
        "An open floor without walls.",
        "The robot donnie starts at 0, 0, facing east.",
        "2 things, in steps from donnie, the nearest first.",
        "Thing2, green: 3 east.",
        "Thing1, red: 10 north.",
    )


def test_an_empty_floor_is_described_in_each_language() -> None:
    said = {describe(picture(floor()), Pose(0.0, 0.0, 0.0), Words(each))[-1] for each in ("en", "pt", "es")}

    assert said == {"There are no things.", "Não há objetos.", "No hay objetos."}


def test_the_text_of_the_author_stands_between_the_difficulty_and_the_task() -> None:
    about = About("A title", "One thing.\nAnother.", "Do it.", Difficulty.HARD)

    assert describe(picture(floor()), Pose(0.0, 0.0, 0.0), Words(), robot="bob", about=about) == (
        "Difficulty: hard.",
        "One thing.",
        "Another.",
        "The robot bob starts at 0, 0, facing north.",
        "There are no things.",
        "Task: Do it.",
    )


def test_a_world_without_a_robot_says_so() -> None:
    assert "There is no robot. Places are given from the middle." in describe(
        picture(floor()), Pose(0.0, 0.0, 0.0), Words()
    )


def large(thing_count: int, robot_count: int) -> Picture:
    things = tuple(
        Thing("", "box" if each % 3 else "ball", "b", "red", 10.0 + each, 0.0, 3.0, 3.0)
        for each in range(thing_count)
    )
    robots = tuple(
        Thing(f"r{each}", "donnie", "d", "red", 0.0, 5.0 + each, 3.0, 3.0, is_robot=True, heading=180.0)
        for each in range(robot_count)
    )
    return Picture(0, 0, 400, 400, 5, ("." * 400,) * 400, things + robots, has_walls=False)


def test_the_nearest_of_many_things_are_described_and_the_others_counted() -> None:
    sentences = describe(large(1000, 0), Pose(0.0, 0.0, 0.0), Words(), robot="donnie")

    assert sentences[2:4] == ("1000 things, in steps from donnie, the nearest first.", "Ball, red: 10 east.")
    assert sentences[-3:] == (
        "980 more things are farther away.",
        "653 of them: box, red.",
        "327 of them: ball, red.",
    )
    assert len(sentences) == 3 + MOST_THINGS + 3


def test_the_nearest_of_many_robots_are_named() -> None:
    sentences = describe(large(0, 999), Pose(0.0, 0.0, 0.0), Words(), robot="me")

    assert sentences[1] == "1000 robots: me, r0, r1, r2, r3, r4, r5, r6, r7, r8 and 990 more."
    assert sentences[3] == "Robot r0, from me: 5 north, facing south."
    assert len(sentences) == 13


@pytest.mark.parametrize(
    ("others", "said"),
    [
        (9, "10 robots: me, r0, r1, r2, r3, r4, r5, r6, r7, r8."),
        (10, "11 robots: me, r0, r1, r2, r3, r4, r5, r6, r7, r8 and 1 more."),
    ],
)
def test_up_to_ten_robots_are_all_named(others: int, said: str) -> None:
    sentences = describe(large(0, others), Pose(0.0, 0.0, 0.0), Words(), robot="me")

    assert sentences[1] == said
    assert sentences[-2].startswith("Robot r8, ")


def test_of_the_things_farther_away_the_five_commonest_kinds_are_counted() -> None:
    kinds = ["a"] * 20 + [kind for count, kind in enumerate("bcdefgh", start=1) for _ in range(count)]
    things = tuple(Thing("", kind, kind, "red", 0.0, float(at), 1.0, 1.0) for at, kind in enumerate(kinds))
    seen = Picture(0, 0, 9, 9, 1, ("." * 9,) * 9, things, has_walls=False)

    said = things_in_words(seen, Pose(0.0, 0.0, 0.0), Words())

    assert said[19] == "A, red: 19 ahead."
    assert said[20] == "28 more things are farther away."
    assert [each[:1] for each in said[21:]] == ["7", "6", "5", "4", "3"]


def test_two_robots_are_described_by_name() -> None:
    sentences = describe(large(0, 1), Pose(0.0, 0.0, 0.0), Words("pt"), robot="me")

    assert sentences[1:4] == (
        "2 robôs: me, r0.",
        "O robô me começa em 0, 0, virado para o norte.",
        "Robô r0, a partir de me: 5 ao norte, virado para o sul.",
    )


def test_a_large_thing_is_described_with_its_size() -> None:
    wide = Thing("", "table", "t", "red", 0.0, 20.0, 5.0, 8.0)
    seen = Picture(0, 0, 9, 9, 1, ("." * 9,) * 9, (wide,), has_walls=True)

    assert describe(seen, Pose(0.0, 0.0, 0.0), Words(), robot="me")[-1] == "Table, red, 5 by 8: 20 north."
    assert things_in_words(seen, Pose(0.0, 0.0, 180.0), Words()) == ("Table, red, 5 by 8: 20 behind.",)


def test_the_size_of_a_thing_below_eight_steps_is_not_given() -> None:
    small = Thing("", "table", "t", "red", 0.0, 20.0, 7.4, 7.0)
    seen = Picture(0, 0, 9, 9, 1, ("." * 9,) * 9, (small,), has_walls=True)

    assert things_in_words(seen, Pose(0.0, 0.0, 0.0), Words()) == ("Table, red: 20 ahead.",)


def test_the_list_of_worlds_begins_with_their_number_and_marks_the_one_that_is_open() -> None:
    count, *rows = worlds_in_words("maze", Words())

    assert count == f"{len(worlds.names())} worlds. WORLD with a name goes there."
    assert [row.partition(":")[0] for row in rows] == list(worlds.names())
    assert [row for row in rows if row.endswith(" You are here.")] == ["maze: Maze, hard. You are here."]


@pytest.mark.parametrize(
    ("about", "things", "said"),
    [
        (None, (), ("This is the world hall.", "There are no things.")),
        (About("The hall", "One.", "Do it.", Difficulty.EASY), (("red", 0, 10),), ("The hall", "thing")),
    ],
)
def test_after_a_world_was_opened_its_name_and_its_things_are_said(
    about: About | None, things: tuple[tuple[str, float, float], ...], said: tuple[str, str]
) -> None:
    title, size, has = arrived("hall", about, picture(floor(*things)), Words())

    assert said[0] in title
    assert size == "An open floor without walls."
    assert said[1] in has
    assert ("1" in has) is bool(things)


@pytest.mark.parametrize(
    ("heading", "said"),
    [
        (0, "north"),
        (45, "northeast"),
        (90, "east"),
        (135, "southeast"),
        (180, "south"),
        (225, "southwest"),
        (270, "west"),
        (315, "northwest"),
        (360, "north"),
        (359.9999999, "north"),
        (44.9999999, "northeast"),
        (359.7, "359 degrees, near north"),
        (22, "22 degrees, near north"),
        (23, "23 degrees, near northeast"),
        (40.9, "40 degrees, near northeast"),
        (337, "337 degrees, near northwest"),
        (338, "338 degrees, near north"),
    ],
)
def test_a_heading_is_one_of_eight_points_or_near_one(heading: float, said: str) -> None:
    assert facing(Pose(0, 0, heading), Words()) == said
