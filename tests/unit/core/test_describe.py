"""A world in words: places are relative to the robot, in steps, the nearest thing first."""

from pathlib import Path

import pytest

import worlds
from devices.ports.robot import Pose
from donnie_tui.core.describe import (
    MOST_THINGS,
    arrived,
    compass_place_of,
    describe,
    goals_in_words,
    has_way_out,
    place_of,
    shortfall_in_words,
    target_in_words,
    task_in_words,
    things_in_words,
    verdict_in_words,
    world_columns,
    world_introduction,
    world_meant,
    world_row,
    world_sentences,
    worlds_in_words,
)
from donnie_tui.core.goals import Inventory, Judgment, Shortfall, Track
from donnie_tui.core.wording import facing
from donnie_tui.i18n.words import Words
from sim.picture import Picture, Thing, picture
from tests.floor import floor
from worlds.challenges import Challenge, ChallengeText, Limit, Rules
from worlds.words import About, Difficulty, about


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


# --- the ways out of a floor


@pytest.mark.parametrize(
    ("rows", "column", "row", "is_open"),
    [
        (("###", "#.#", "###"), 1, 1, False),
        (("###", "#.#", "#.#"), 1, 1, True),
        (("#.#", "#.#", "###"), 1, 1, True),
        (("###", "#..", "###"), 1, 1, True),
        (("###", "..#", "###"), 1, 1, True),
        (("####", "#.##", "##.#", "##.#"), 1, 1, False),  # no way across a corner
        (("#####", "#.#.#", "#...#", "##.##", "##.##"), 1, 1, True),
        (("#####", "#.#.#", "#.#.#", "#.#.#", "##..#", "#####"), 1, 2, False),
        (("######", "#....#", "####.#", "#....#", "#.####", "#.####"), 1, 1, True),
        (("######", "#....#", "####.#", "#.#..#", "#.####", "#.####"), 1, 1, False),
        (("#######", "#.#.#.#", "#.....#", "#.#.#.#", "#####.#"), 1, 1, True),
        (("#######", "#.#.#.#", "#.....#", "#.#.#.#", "#.#####"), 5, 1, True),
        (("###", "#.#", "###"), 7, 1, True),  # outside of the map
    ],
)
def test_a_floor_is_open_if_free_squares_lead_over_its_edge(
    rows: tuple[str, ...], column: int, row: int, is_open: bool
) -> None:
    floor_ = Picture(0, 0, len(rows[0]), len(rows), 1, rows, (), has_walls=True)

    assert has_way_out(floor_, Pose(column, len(rows) - 1 - row, 0.0)) is is_open


# --- worlds and their things


def of_things(*things: Thing, cell: int = 1) -> Picture:
    return Picture(0, 0, 9, 8, cell, ("." * 9,) * 8, things, has_walls=True)


def test_the_size_of_a_floor_is_given_in_steps() -> None:
    said = arrived("hall", None, of_things(cell=5), Words())

    assert said == ("This is the world hall.", "45 by 40 steps, walls included.", "There are no things.")


def test_a_robot_starts_at_whole_steps_and_robots_are_no_things() -> None:
    other = Thing("bob", "donnie", "d", "red", 4.6, -1.2, 1.0, 1.0, is_robot=True, heading=90.0)
    box = Thing("", "box", "b", "red", 3.0, 1.5, 1.0, 1.0)
    said = describe(of_things(other, box), Pose(1.9, -2.9, 0.0), Words(), robot="al")

    assert said[-5:] == (
        "2 robots: al, bob.",
        "The robot al starts at 1, -2, facing north.",
        "Robot bob, from al: 3 east, 2 north, facing east.",
        "1 thing, in steps from al, the nearest first.",
        "Box, red: 1 east, 4 north.",
    )


def test_without_a_robot_things_are_counted_from_the_middle() -> None:
    box = Thing("", "box", "b", "red", 3.0, 0.0, 1.0, 1.0)

    assert describe(of_things(box), Pose(0.0, 0.0, 90.0), Words())[-2:] == (
        "1 thing, in steps.",
        "Box, red: 3 east.",
    )


@pytest.mark.parametrize(
    ("width", "depth", "said"),
    [
        (7.5, 1.0, "Table, red, 8 by 1: 20 ahead."),
        (1.0, 7.6, "Table, red, 1 by 8: 20 ahead."),
        (7.4, 7.4, "Table, red: 20 ahead."),
    ],
)
def test_a_thing_is_large_from_eight_whole_steps_on_either_side(
    width: float, depth: float, said: str
) -> None:
    table = Thing("", "table", "t", "red", 0.0, 20.0, width, depth)

    assert things_in_words(of_things(table), Pose(0.0, 0.0, 0.0), Words()) == (said,)


def test_the_nearest_thing_is_the_nearest_to_the_robot() -> None:
    """At 10, 20: the box is 5 steps away, the ball 6, the table 7."""
    things = [
        Thing("", kind, kind[0], "red", x, y, 1.0, 1.0)
        for kind, x, y in (("table", 10, 13), ("ball", 4, 20), ("box", 13, 24))
    ]

    assert things_in_words(of_things(*things), Pose(10.0, 20.0, 0.0), Words()) == (
        *("Box, red: 3 right, 4 ahead.", "Ball, red: 6 left.", "Table, red: 7 behind."),
    )


def test_at_brief_a_thing_has_no_colour() -> None:
    table = Thing("", "table", "t", "red", 0.0, 20.0, 9.0, 1.0)

    assert things_in_words(of_things(table), Pose(0.0, 0.0, 0.0), Words("en", "brief")) == (
        "Table: 20 ahead.",
    )


@pytest.mark.parametrize(("count", "more"), [(20, ()), (21, ("1 more thing is farther away.",))])
def test_up_to_twenty_things_are_described_one_by_one(count: int, more: tuple[str, ...]) -> None:
    said = things_in_words(large(count, 0), Pose(0.0, 0.0, 0.0), Words())

    assert said[20:21] == more
    assert len(said) == min(count, 20) + 2 * len(more)


def test_a_world_is_introduced_by_its_author_or_by_its_things_alone() -> None:
    text = About("A title", "One.\nTwo.", "Do it.", Difficulty.UNSTATED)

    assert world_introduction("hall", text, ["A box."], Words()) == (
        *("hall: A title.", "One.", "Two.", "A box.", "Task: Do it."),
    )
    assert world_introduction("hall", None, ["A box."], Words()) == ("A box.",)
    said = describe(picture(floor()), Pose(0.0, 0.0, 0.0), Words(), robot="bob", about=text)
    assert said[:2] == ("One.", "Two.")


@pytest.mark.parametrize(
    ("typed", "name"),
    [
        ("maze", "maze"),
        ("MAZE", "maze"),
        ("Labirinto", "maze"),
        ("two_rooms", "two_rooms"),
        ("two rooms", "two_rooms"),
        ("tworooms", "two_rooms"),
        ("Dos  cuartos", "two_rooms"),
        ("maz", None),
        ("", None),
    ],
)
def test_a_world_is_found_by_its_name_or_its_title_in_any_language(typed: str, name: str | None) -> None:
    assert world_meant(typed) == name


@pytest.mark.parametrize(("language", "hard"), [("en", "hard"), ("pt", "difícil")])
def test_a_row_about_a_world_has_its_title_its_difficulty_its_content_and_its_task(
    language: str, hard: str
) -> None:
    text, words = about("maze", language), Words(language)
    content, task = world_sentences("maze", words)
    row = world_row("maze", words)

    assert world_columns("maze", words) == (text.title, hard)
    assert content == text.description.replace("\n", " ")
    assert task.endswith(f": {text.task}")
    assert row.startswith(f"maze: {text.title}, {hard}. {content} ")
    assert row.endswith(text.task)


def test_a_world_with_a_title_is_arrived_at_by_both() -> None:
    text = About("The hall", "One.", "Do it.", Difficulty.EASY)
    box = Thing("", "box", "b", "red", 3.0, 0.0, 1.0, 1.0)

    said = arrived("hall", text, of_things(box, box), Words())
    assert (said[0], said[2]) == ("This is the world hall: The hall.", "2 things. WORLD says more.")


# --- challenges

ROOM = Inventory(
    (
        Thing("", "box", "b", "red", 0, 0, 1, 1, index=1),
        Thing("", "box", "b", "blue", 5, 0, 1, 1, index=2),
        Thing("", "ball", "l", "green", 9, 0, 1, 1, index=3),
        Thing("", "ball", "l", "green", 9, 5, 1, 1, index=4),
    ),
    radius=1.0,
    robots={"me": Pose(0.0, 0.0, 0.0)},
)


def judged(*lacking: Shortfall | None, more: tuple[Shortfall, ...] = ()) -> Judgment:
    missing = tuple(each for each in lacking if each is not None)
    return Judgment(Track([], [ROOM]), lacking, missing + more)


def test_a_verdict_is_about_the_first_start_that_fails() -> None:
    no_run, said = Shortfall("goal-no-run", {}), Shortfall("goal-said", {"text": "x", "before": ""})
    solved = judged(None, None)

    assert verdict_in_words([solved, solved], Words()) == "Solved, in 0 commands."
    assert verdict_in_words([judged(None, said)], Words()) == "1 of 2 goals. Missing: say x."
    assert verdict_in_words([solved, judged(no_run, said), judged(said)], Words()) == (
        "0 of 2 goals. From start 2: The program did not run. Missing: say x."
    )


def test_a_verdict_has_four_sentences_and_none_twice() -> None:
    said = [Shortfall("goal-said", {"text": each, "before": ""}) for each in "xxyz"]

    assert verdict_in_words([judged(*said)], Words()) == (
        "0 of 4 goals. Missing: say x. Missing: say y. Missing: say z."
    )
    assert verdict_in_words([judged(None), judged(*said)], Words()) == (
        "0 of 4 goals. From start 2: Missing: say x. Missing: say y."
    )


def test_each_goal_is_met_missing_or_asked_about() -> None:
    verdict = judged(None, Shortfall("goal-asked", {"number": 2}), Shortfall("goal-no-run", {}))

    assert goals_in_words(verdict, Words()) == (
        *("Goal 1: met.", "Goal 2: I ask you later.", "Goal 3: The program did not run."),
    )


AREA = ((0.0, 1.5), (2.25, 3.0))


@pytest.mark.parametrize(
    ("shortfall", "said"),
    [
        (
            Shortfall("goal-at-place", {"steps": 3, "direction": 90.0, "target": (4.0, 0.5)}),
            "You stopped 3 steps east of 4, 0.5.",
        ),
        (
            Shortfall("goal-area", {"steps": 1, "direction": 180.0, "area": AREA}),
            "You stopped 1 step south of the area from 0, 1.5 to 2.25, 3.",
        ),
        (Shortfall("word-missing", {"word": "REPEAT"}), "Missing: the word REPEAT."),
        (Shortfall("goal-visited", {"target": "blue box"}), "You did not get to blue box."),
        (Shortfall("goal-visited", {"target": "ball"}), "You did not get to ball."),
        (Shortfall("goal-no-run", {}, robot="bob"), "bob: The program did not run."),
    ],
)
def test_what_is_missing_is_said_with_its_place_its_thing_and_its_word(
    shortfall: Shortfall, said: str
) -> None:
    assert shortfall_in_words(shortfall, ROOM, Words()) == said


def test_a_word_that_is_missing_is_in_the_learners_language() -> None:
    shortfall = Shortfall("word-missing", {"word": "REPEAT"})

    assert shortfall_in_words(shortfall, ROOM, Words("pt")).endswith(" REPITA.")
    assert target_in_words((1.0, -2.5), ROOM, Words()) == "1, -2.5"


def test_a_task_has_its_title_its_sentences_its_limits_and_its_words() -> None:
    rules = Rules(
        *(1, "first_room"), words=("REPITA", "FW"), limit=Limit(commands=1, seconds=2.6, steps=0, turns=4)
    )
    text = ChallengeText("A title", "One.\nTwo.\n")
    it = Challenge("it", Path("it.toml"), rules, {"en": text})

    assert task_in_words(it, Words()) == (
        "Challenge: A title.",
        *("One.", "Two."),
        *("At most 1 command.", "At most 3 seconds.", "At most 0 steps.", "At most 4 turns."),
        "Use only REPEAT, FW.",
    )
    bare = Challenge("it", Path("it.toml"), Rules(1, "first_room"), {"en": text})
    assert task_in_words(bare, Words(), "The hall") == (
        *("Challenge: A title. World: The hall.", "One.", "Two."),
    )
