"""The scenarios match their descriptions: each number and each place of a description is measured."""

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

import worlds.words
from devices.ports.robot import STEP
from sim.picture import Picture, picture
from sim.scene import Model, Scene
from sim.worldfile import load_world

LANGUAGES = ("en", "pt", "es")
COLOURS = {"red", "green", "blue", "yellow", "orange", "pink", "gray"}


def test_the_order_of_the_worlds_names_worlds_that_there_are() -> None:
    assert set(worlds._ORDER) == set(worlds.names())


@cache
def scene(name: str) -> Scene:
    return load_world(Path(worlds.path(name)), allowed=(Path(worlds.SCENES),))


@cache
def seen(name: str) -> Picture:
    return picture(scene(name))


def inner(name: str) -> tuple[int, int]:
    """Steps of floor from west to east and from south to north, the outer walls apart."""
    it = seen(name)
    return it.width - 2, it.height - 2


def place(name: str, thing: str) -> tuple[float, float]:
    """Where a model stands, in steps to the east and to the north of the first robot."""
    it = scene(name)
    start = it.models[it.robots[0]].pose
    pose = next(model.pose for model in it.models if model.name == thing)
    return round((pose.x - start.x) / STEP, 3), round((pose.y - start.y) / STEP, 3)


def free(name: str, x: int, y: int, east: int, north: int) -> int:
    """Free cells from a place on, itself included."""
    it, count = seen(name), 0
    while (cell := it.at(x, y)) is not None and it.rows[cell[0]][cell[1]] == ".":
        x, y, count = x + east, y + north, count + 1
    return count


def across(name: str, x: int, y: int, east: int, north: int) -> int:
    """Free cells through a place, to both sides."""
    return free(name, x, y, east, north) + free(name, x, y, -east, -north) - 1


def things(name: str, kind: str, colour: str) -> list[tuple[float, float]]:
    return [(each.x, each.y) for each in seen(name).things if (each.kind, each.colour) == (kind, colour)]


def steps(model: Model) -> tuple[float, float]:
    return round(model.size[0] / STEP, 3), round(model.size[1] / STEP, 3)


def robot(name: str) -> Model:
    it = scene(name)
    return it.models[it.robots[0]]


def numbers(text: str) -> list[int]:
    return [int(each) for each in re.findall(r"\d+", text)]


def measured() -> Iterator[tuple[str, list[float]]]:
    """The numbers of each description in their order, as the world has them."""
    it = "first_room"
    yield it, [*inner(it), place(it, "ball")[0], -place(it, "chair")[0]]
    yield "open_floor", [0, 0]
    yield "living_room", [*inner("living_room"), place("living_room", "small sofa")[1]]
    yield (
        "corridor",
        [
            across("corridor", 0, 0, 1, 0),
            free("corridor", -2, 1, 0, 1),
            place("corridor", "post")[1],
            free("corridor", 6, 31, 1, 0),
        ],
    )
    it, rooms = "two_rooms", ((0, 0), (20, 0))
    ball, wall = place(it, "ball"), place(it, "wall south of the door")
    sides = {across(it, *at, *along) for at in rooms for along in ((1, 0), (0, 1))}
    assert sides == {21}
    yield it, [21, 21, wall[0], across(it, 11, 6, 0, 1), 6, ball[0], -ball[1]]
    it = "street"
    crossings = [place(it, f"{colour} box")[1] for colour in ("blue", "red")]
    widths = [across(it, -15, round(y), 0, 1) for y in crossings]
    yield it, [across(it, 0, 5, 1, 0), widths[0], *crossings]
    assert widths == [9, 9]
    it = "storehouse"
    boxes = [place(it, f"{colour} box")[1] for colour in ("red", "blue")]
    yield it, [*inner(it), boxes[0], -boxes[1], across(it, 11, 0, 0, 1), place(it, "post")[0]]
    it = "wild_garden"
    flowers = [len(things(it, "flower", colour)) for colour in ("red", "blue")]
    yield it, [*inner(it), *flowers, len(things(it, "stone", "gray"))]
    yield (
        "colour_garden",
        [
            *inner("colour_garden"),
            place("colour_garden", "blue flower 1")[1],
            *(
                len(things("colour_garden", "flower", colour))
                for colour in ("blue", "yellow", "red", "orange")
            ),
        ],
    )
    it = seen("object_field")
    yield (
        "object_field",
        [
            len(it.things),
            0,
            0,
            sum(thing.y >= -0.5 for thing in it.things),
            -place("object_field", "orange cone")[1],
        ],
    )
    yield (
        "two_robots",
        [*inner("two_robots"), place("two_robots", "bob")[1], place("two_robots", "blue box")[0]],
    )
    it = "store_room"
    yield it, [*inner(it), place(it, "red box")[0], -place(it, "blue box")[0]]
    block = next(model for model in scene("race_track").models if model.name == "wall in the middle")
    yield "race_track", [*inner("race_track"), *steps(block), across("race_track", 0, 0, 1, 0)]
    cave = seen("cave")
    yield (
        "cave",
        [
            cave.width,
            cave.height,
            across("cave", 0, 17, 1, 0),
            free("cave", -4, 1, 0, 1),
            across("cave", 20, 0, 0, 1),
        ],
    )
    yield "factory", list(factory())
    yield (
        "maze",
        [
            (inner("maze")[0] + 1) / 8,
            (inner("maze")[1] + 1) / 8,
            across("maze", 1, 0, 1, 0),
            across("maze", 0, -1, 1, 0),
            seen("maze").rows[-2][8:].index(".") - seen("maze").rows[-2][8:].index("#"),
            8,
            len(way_through_the_maze()),
        ],
    )


def factory() -> Iterator[float]:
    it = scene("factory")
    walls = {model.name: model for model in it.models if model.kind == "wall"}
    width = (walls["east wall"].pose.x - walls["west wall"].pose.x - walls["east wall"].size[0]) / STEP
    depth = (walls["north wall"].pose.y - walls["south wall"].pose.y - walls["north wall"].size[1]) / STEP
    yield from (round(width, 3), round(depth, 3), round(width * STEP, 3), round(depth * STEP, 3))
    yield from steps(robot("factory"))
    yield steps(next(model for model in it.models if model.kind == "belt"))[0]
    yield from (place("factory", "belt 1")[1], place("factory", "belt 2")[1])
    yield from (len(things("factory", "orange", "orange")), len(things("factory", "carton", "blue")))


def way_through_the_maze() -> tuple[tuple[int, int], ...]:
    """The fields from the start to the goal. The test below shows that there is only one way."""
    ways: dict[tuple[int, int], tuple[tuple[int, int], ...]] = {(0, 0): ((0, 0),)}
    reached = [(0, 0)]
    for field in reached:
        for neighbour in neighbours(field):
            if neighbour not in ways:
                ways[neighbour] = (*ways[field], neighbour)
                reached.append(neighbour)
    return ways[5, 4]


def neighbours(field: tuple[int, int]) -> Iterator[tuple[int, int]]:
    it, (x, y) = seen("maze"), field
    for east, north in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        cell = it.at(8 * x + 4 * east, 8 * y + 4 * north)
        if cell is not None and it.rows[cell[0]][cell[1]] != "#":
            yield x + east, y + north


MEASURED = dict(measured())


@pytest.mark.parametrize("name", worlds.scenarios())
@pytest.mark.parametrize("language", LANGUAGES)
def test_every_number_of_a_description_is_measured(name: str, language: str) -> None:
    assert name in MEASURED, f"add to measured() the numbers of the description of {name}"
    assert numbers(worlds.words.about(name, language).description) == MEASURED[name]


@pytest.mark.parametrize("name", worlds.names())
def test_descriptions_are_short_whole_sentences_the_same_in_each_language(name: str) -> None:
    said = [worlds.words.about(name, language) for language in LANGUAGES]

    assert len({len(about.sentences) for about in said}) == 1
    for about in said:
        for sentence in (*about.sentences, about.task):
            assert sentence.endswith(".")
            assert sentence == sentence.strip()
            assert ". " not in sentence.replace("SCAN, ", "") or sentence == about.task
            assert len(sentence) <= 80
    assert len({tuple(numbers(about.task)) for about in said}) == 1


@pytest.mark.parametrize("name", worlds.scenarios())
def test_the_map_of_a_scenario_fits_eighty_columns_step_by_step(name: str) -> None:
    it = seen(name)

    if name != "factory":
        assert it.cell == 1
        assert it.width <= 80


@pytest.mark.parametrize("name", worlds.scenarios())
def test_every_colour_of_a_thing_is_in_the_description(name: str) -> None:
    said = set(re.findall(r"[a-z]+", worlds.words.about(name, "en").description)) & COLOURS
    there = {each.colour for each in seen(name).things if each.kind != "donnie"}

    assert there <= said


def test_the_living_room_has_its_things_where_the_description_says() -> None:
    it = {each.name: each for each in seen("living_room").things}

    assert it["small sofa"].x - it["small sofa"].width / 2 == pytest.approx(-3.5, abs=0.1)
    assert it["large sofa"].y + it["large sofa"].depth / 2 == pytest.approx(36.5, abs=0.1)
    assert it["large sofa"].x == pytest.approx(16, abs=1)
    assert it["table"].x + it["table"].width / 2 == pytest.approx(36.5, abs=0.1)
    assert it["chair 1"].x < it["table"].x
    assert it["chair 2"].y < it["table"].y


def test_the_corridor_turns_to_the_east_and_ends_behind_the_red_box() -> None:
    assert free("corridor", 0, 0, 0, -1) == 4  # the south end
    assert free("corridor", 6, 31, 0, 1) == 10  # the arm is as wide, but for its first row
    assert across("corridor", 20, 31, 0, 1) == 11
    assert things("corridor", "box", "red") == [(37, 35)]
    assert things("corridor", "post", "green") == [(0, 38)]


def test_the_garden_has_a_colour_on_each_side() -> None:
    assert {y for _, y in things("colour_garden", "flower", "blue")} == {15}
    assert {x for x, _ in things("colour_garden", "flower", "yellow")} == {15}
    assert {y for _, y in things("colour_garden", "flower", "red")} == {-15}
    assert things("colour_garden", "flower", "orange") == [(-15, 0)]
    assert things("colour_garden", "stone", "gray") == [(-15, -15)]
    assert free("colour_garden", -10, 0, 0, 1) == free("colour_garden", -10, 0, 0, -1) == 21


def test_the_things_of_the_field_lie_round_donnie_and_can_be_pushed() -> None:
    assert things("object_field", "ball", "red") == [(-10, 0)]
    assert things("object_field", "box", "blue") == [(-10, 10)]
    assert things("object_field", "cone", "green") == [(0, 12)]
    assert things("object_field", "ball", "yellow") == [(9, 9)]
    assert things("object_field", "box", "pink") == [(12, 0)]
    assert all(
        m.pushable and m.gripper_return == 1 for m in scene("object_field").models if m.type == "model"
    )


def test_the_two_robots_look_at_each_other_and_nothing_is_between_them() -> None:
    it = scene("two_robots")
    robots = [it.models[index] for index in it.robots]

    assert [(each.name, each.pose.yaw, each.colour.family) for each in robots] == [
        ("alice", 90, "orange"),
        ("bob", -90, "blue"),
    ]
    assert free("two_robots", 0, 1, 0, 1) == 28  # up to bob's body
    assert (things("two_robots", "box", "red"), things("two_robots", "box", "blue")) == (
        [(-10, 15)],
        [(10, 15)],
    )


def test_the_lanes_of_the_track_are_equally_wide_and_a_post_marks_each_corner() -> None:
    widths = {
        across("race_track", 0, 3, 1, 0),
        across("race_track", 30, 15, 0, 1),
        across("race_track", 60, 0, 1, 0),
        across("race_track", 30, -15, 0, 1),
    }
    corners = [things("race_track", "post", colour)[0] for colour in ("red", "blue", "yellow", "green")]

    assert widths == {15}
    assert corners == [(-5, 20), (65, 20), (65, -20), (-5, -20)]


def test_the_cave_has_a_niche_a_passage_and_a_larger_chamber() -> None:
    assert things("cave", "crystal", "yellow") == [(0, 21)]
    assert across("cave", 42, 2, 0, 1) > across("cave", -6, 0, 0, 1)
    (crystal,), (stone,) = things("cave", "crystal", "pink"), things("cave", "stone", "gray")
    assert crystal[0] > 30 < stone[0]
    assert crystal[1] > 0 > stone[1]


def test_the_belts_of_the_factory_lie_north_of_the_oranges_and_round_the_cartons() -> None:
    oranges, cartons = things("factory", "orange", "orange"), things("factory", "carton", "blue")

    assert {y for _, y in oranges} == {20}
    assert {y for _, y in cartons} == {75}
    assert scene("factory").models[scene("factory").robots[0]].kind == "bigbob"


def test_there_is_only_one_way_through_the_maze() -> None:
    fields = [(x, y) for x in range(6) for y in range(5)]
    passages = sum(len(list(neighbours(field))) for field in fields) / 2

    assert passages == len(fields) - 1  # a tree: every field is reached, and in one way
    assert list(neighbours((0, 0))) == [(0, 1)]
    assert things("maze", "box", "green") == [(40, 32)]
