"""A world is furnished by words: what is understood, where there is room, and what is written to the file."""

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.world.loading import Site, SiteChange, choose_world
from donnie_tui.world.things import (
    Building,
    Description,
    description_of,
    model_line,
    name_in,
    name_in_words,
    near_word,
    thing_in_words,
    with_numbers,
    word_for,
    world_text,
)
from sim.picture import Thing, all_things
from sim.world import World

EN, PT = Words("en"), Words("pt")


# --- words


@pytest.mark.parametrize(
    ("text", "counts", "rest", "numbers"),
    [
        ("box 4 6", (2,), "box", (4, 6)),
        ("box 2 1 0", (2,), "box 2", (1, 0)),
        ("box 2 1 0", (4, 2), "box 2", (1, 0)),
        ("wall 1,2, -3 4", (4, 2), "wall", (1, 2, -3, 4)),
        ("box 4 6 AS room 7", (2,), "box AS room 7", (4, 6)),
        ("caixa 4 6 COMO sala 7 8", (2,), "caixa COMO sala 7 8", (4, 6)),
        ("box 4", (2,), "box 4", ()),
        ("box1 2", (2,), "box1 2", ()),
        ("box 1.5 2", (2,), "box 1.5 2", ()),
        ("box 1234567 3", (2,), "box", (1234567, 3)),
        ("box 12345678 3", (2,), "box 12345678 3", ()),
        ("box   red  4 6", (2,), "box red", (4, 6)),
    ],
)
def test_the_last_numbers_before_a_name_are_a_place(
    text: str, counts: tuple[int, ...], rest: str, numbers: tuple[int, ...]
) -> None:
    assert with_numbers(text, *counts) == (rest, numbers)


@pytest.mark.parametrize(
    ("typed", "name"),
    [(' the "old" box. ', "the old box"), ("a\\b\tc\x1b", "abc"), ("x" * 70, "x" * 60), ("..", "")],
)
def test_a_name_has_no_quotes_and_sixty_characters_at_most(typed: str, name: str) -> None:
    assert name_in(typed) == name


@pytest.mark.parametrize(
    ("text", "described"),
    [
        ("chair green AS throne", Description("chair", ("green",), {}, "throne")),
        ("green chair", Description("chair", ("green",))),
        ("orange", Description("orange")),
        ("orange box", Description("box", ("orange",))),
        ("red orange", Description("orange", ("red",))),
        ("flower: R red, B blue", Description("flower", ("red", "blue"), {"R": "red", "B": "blue"})),
        ("flower R red blue", Description("flower", ("red", "blue"))),
        ("flower red, blue …", Description("flower")),
        ("box red red", Description("box", ("red", "red"))),
        ("small  sofa", Description("small_sofa")),
        ("small_sofa", Description("small_sofa")),
        ("SOFÁ PEQUENO VERMELHO COMO x", Description("small_sofa", ("red",), {}, "x")),
        ("silla roja", Description("chair", ("red",))),
        ("parede", Description("wall")),
        ("box AS red chair", Description("box", (), {}, "red chair")),
    ],
)
def test_a_thing_is_described_in_words_of_every_language(text: str, described: Description) -> None:
    assert description_of(text, EN) == (described, {})


@pytest.mark.parametrize(
    ("text", "mistakes"),
    [
        ("chair table", {6: "table is one thing too many. Each line says one thing."}),
        ("chiar gren", {0: "chiar is neither a thing nor a color. Did you mean chair?",
                        6: "gren is neither a thing nor a color. Did you mean green?"}),
        ("R box", {0: "R is neither a thing nor a color."}),
        ("R red box", {0: "R is neither a thing nor a color."}),
        ("box R", {4: "R is neither a thing nor a color."}),
        ("box 7 red", {4: "7 is neither a thing nor a color."}),
        ("box Rx red", {4: "Rx is neither a thing nor a color."}),
        ("box AS 7", {4: "A name begins with a letter: AS treasure."}),
        ("box x AS", {4: "x is neither a thing nor a color.",
                      6: "A name begins with a letter: AS treasure."}),
        ("box " + "q" * 50, {4: "q" * 39 + "… is neither a thing nor a color."}),
    ],
)  # fmt: skip
def test_each_word_that_means_nothing_has_its_place(text: str, mistakes: Mapping[int, str]) -> None:
    assert description_of(text, EN) == (Description(""), mistakes)


def test_a_description_without_a_thing_names_all_but_walls() -> None:
    for text in ("", "red", "red AS treasure"):
        (place, sentence), *_ = description_of(text, EN)[1].items()
        assert place == 0
        assert sentence.startswith("The name of the thing is missing. Things are: chair, table, ")
        assert "wall" not in sentence


@pytest.mark.parametrize(
    ("word", "near"),
    [("sofa", "small sofa"), ("chiar", "chair"), ("gren", "green"), ("wal", "wall"), ("q", None)],
)
def test_a_word_is_near_to_a_kind_a_colour_or_a_part_of_them(word: str, near: str | None) -> None:
    assert near_word(word, EN) == near


def test_kinds_and_names_are_said_in_the_learners_language() -> None:
    def called(kind: str, name: str, colour: str = "red") -> Thing:
        return Thing(name, kind, "x", colour, 0, 0, 1, 1)

    assert [word_for(kind, PT) for kind in ("wall", "box", "gizmo")] == ["parede", "caixa", "gizmo"]
    assert [
        name_in_words(called(*each), PT)
        for each in (
            ("box", ""),
            ("box", "box 2"),
            ("box", "boxer"),
            ("small_sofa", "small sofa"),
            ("box", "ouro"),
        )
    ] == ["caixa", "caixa 2", "boxer", "sofá pequeno", "ouro"]
    assert thing_in_words(called("wall", "wall 2", "gray"), PT) == "parede 2"
    assert thing_in_words(called("box", ""), EN) == "box, red"


# --- the text of a world


@pytest.mark.parametrize(
    ("given", "line"),
    [
        (("box", (0.2, -0.3, 0)), "box( pose [ 0.2 -0.3 0 0 ] )"),
        (("donnie", (0, 0, 90), "ana"), 'donnie( name "ana" pose [ 0 0 0 90 ] )'),
        (
            ("wall", (1, 2, 45), "", (1.05, 0.05, 0.24), "red"),
            'wall( pose [ 1 2 0 45 ] size [ 1.05 0.05 0.24 ] color "red" )',
        ),
    ],
)
def test_a_line_of_a_world_has_what_is_given(
    given: tuple[str, tuple[float, float, float]], line: str
) -> None:
    assert model_line(*given) == line


def test_the_text_of_a_world_knows_all_kinds_and_leaves_out_what_is_empty() -> None:
    assert world_text(["a()", "b()"], [], ["c()"]) == (
        "# A step is 0.05 m.\n\n"
        'include "donnie.inc"\ninclude "furniture.inc"\ninclude "things.inc"\ninclude "juice.inc"\n\n'
        "resolution 0.02\n\na()\nb()\n\nc()\n"
    )


# --- a world that is furnished

HEAD = 'include "donnie.inc"\ninclude "things.inc"\n'
ANA = 'donnie( name "ana" pose [ 0 0 0 90 ] )\n'
ROOM = "".join(
    f"wall( pose [ {x} {y} 0 0 ] size [ {wide} {deep} 0.24 ] )\n"
    for x, y, wide, deep in (
        (0, 0.5, 1.05, 0.05),
        (0, -0.5, 1.05, 0.05),
        (0.5, 0, 0.05, 0.95),
        (-0.5, 0, 0.05, 0.95),
    )
)
"""Walls 10 steps from the middle."""


class Furnished:
    """A world that was loaded from a file, with its robots where they start."""

    def __init__(self, folder: Path, text: str, words: Words = EN) -> None:
        self.file = folder / "room.world"
        self.file.write_text(HEAD + text, encoding="utf-8")
        self.site = Site(choose_world(str(self.file), words))
        self.world = World(self.site.world.scene)
        for name in self.site.world.scene.robot_names:
            self.world.inhabitant(name)
        self.building = Building(self.site, self.world, (), words, "FW 1")

    def put(self, kind: str, *place: int, name: str = "", colour: str = "") -> str:
        described = Description(kind, (colour,) if colour else (), {}, name)
        return self._done(lambda: self.building.put(described, place))

    def move(self, name: str, *steps: float, **turn: int) -> str:
        return self._done(lambda: self.building.move(self.building.find(name), *steps, **turn))

    def remove(self, name: str) -> str:
        return self._done(lambda: self.building.remove(self.building.find(name)))

    def _done(self, change: Callable[[], tuple[str, Thing]]) -> str:
        before = self.site.text, self.site.world, list(self.site.past)
        try:
            return change()[0]
        except Unusable as problem:
            assert (self.site.text, self.site.world, self.site.past) == before
            return problem.sentences[0]

    @property
    def written(self) -> str:
        """What follows the text of the file."""
        return self.site.text.removeprefix(self.file.read_text(encoding="utf-8"))


def test_what_is_put_is_written_in_metres_at_the_end(tmp_path: Path) -> None:
    it = Furnished(tmp_path, ANA)

    assert it.put("wall", -5, 8, 5, 9) == "built-put"
    assert it.put("box", 4, 6, colour="red") == it.put("box", 8, 6) == "built-put"
    assert it.put("chair", -4, -6, name="throne") == it.put("table", 20, 20) == "built-put"
    assert it.put("wall", 9, -9) == it.put("wall", 11, -9) == "built-put"
    assert it.written.splitlines() == [
        'wall( name "wall" pose [ 0 0.425 0 0 ] size [ 0.55 0.1 0.24 ] )',
        'box( name "box" pose [ 0.2 0.3 0 0 ] color "red" )',
        'box( name "box 2" pose [ 0.4 0.3 0 0 ] )',
        'include "furniture.inc"',
        'chair( name "throne" pose [ -0.2 -0.3 0 0 ] )',
        'table( name "table" pose [ 1 1 0 0 ] )',
        'wall( name "wall 2" pose [ 0.45 -0.45 0 0 ] size [ 0.05 0.05 0.24 ] )',
        'wall( name "wall 3" pose [ 0.55 -0.45 0 0 ] size [ 0.05 0.05 0.24 ] )',
    ]


def test_a_kind_that_the_file_defines_itself_needs_no_other_file(tmp_path: Path) -> None:
    it = Furnished(tmp_path, "define chair model( size [ 0.1 0.1 0.1 ] )\n" + ANA)

    it.put("chair", 4, 6)
    assert "include" not in it.written


def test_what_is_put_follows_the_last_line_and_no_empty_one(tmp_path: Path) -> None:
    it = Furnished(tmp_path, ANA + "\n\n")
    it.put("post", 4, 6)

    assert it.site.text == f'{HEAD}{ANA}post( name "post" pose [ 0.2 0.3 0 0 ] )\n'


def test_the_text_for_another_folder_is_that_of_the_world_where_a_file_of_it_is_gone(tmp_path: Path) -> None:
    (tmp_path / "more.inc").write_text("define it model ( )\n", encoding="utf-8")
    it = Furnished(tmp_path, 'include "more.inc"\n' + ANA)
    (tmp_path / "sub").mkdir()

    assert "define it model" in it.building.text_at(tmp_path / "sub/x.world")
    assert it.building.text_at(tmp_path / "x.world") == it.site.text
    (tmp_path / "more.inc").unlink()
    assert it.building.text_at(tmp_path / "sub/x.world") == it.site.text
    with pytest.raises(Unusable):
        it.building.save(tmp_path / "sub/x.world")
    assert list((tmp_path / "sub").iterdir()) == []


def test_each_change_can_be_undone_and_a_new_one_forgets_those_that_were(tmp_path: Path) -> None:
    it = Furnished(tmp_path, ANA)
    first = it.site.text
    it.put("box", 4, 6)
    assert it.site.past == [SiteChange(first, 1, "FW 1")]
    assert it.site.world.is_rebuilt

    second = it.site.text
    Building(it.site, it.world, (), EN)
    assert it.site.text == second
    assert it.building.step(it.site.past, it.site.undone)[0] == "built-removed"
    assert (it.site.past, it.site.undone) == ([], [SiteChange(second, 1, "FW 1")])
    assert (it.site.text, it.site.world.is_rebuilt) == (first, False)
    it.put("ball", 4, 6)
    assert it.site.undone == []


@pytest.mark.parametrize(
    "text",
    [ANA + ANA.replace("ana", "bob").replace("0 0 0", "9 9 0"), ANA + "box( pose [ 1 1 0 0 ] )\n" * 2, ""],
)
def test_a_change_of_more_than_one_thing_is_impossible(text: str, tmp_path: Path) -> None:
    it = Furnished(tmp_path, ANA)
    for number in (0, 1):
        changes = [SiteChange(HEAD + text, number, "")]
        with pytest.raises(Unusable):
            it.building.step(changes, it.site.undone)
        assert (len(changes), it.site.undone) == (1, [])


def test_an_unchanged_world_has_no_thing_beyond_its_last(tmp_path: Path) -> None:
    it = Furnished(tmp_path, ANA)
    with pytest.raises(Unusable):
        it.building.step([SiteChange(it.site.text, 1, "")], [])


# --- finding


TWO = f"""{ANA}box( name "b1" pose [ 0.3 0.3 0 0 ] color "red" )
box( name "b2" pose [ -0.3 0.3 0 0 ] color "blue" )
"""


@pytest.mark.parametrize(
    ("typed", "names"),
    [("b1", "b1"), ("B2", "b2"), ("red box", "b1"), ("box 6 6", "b1"), ("box 7 5", "b1"), ("box -5 7", "b2"),
     ("caixa azul", "b2"), ("crate", "c"), ("crate 0 20", "c")],
)  # fmt: skip
def test_a_thing_is_found_by_its_name_its_kind_its_colour_or_its_square(
    typed: str, names: str, tmp_path: Path
) -> None:
    more = 'define crate model( size [ 0.5 0.2 0.1 ] )\ncrate( name "c" pose [ 0 1 0 0 ] )\n'

    assert Furnished(tmp_path, TWO + more).building.find(typed).name == names


@pytest.mark.parametrize(
    ("typed", "sentence"),
    [
        ("box", "There are 2: b1: 6, 6; b2: -6, 6. Type the name of one."),
        ("box 8 6", "There is no box 8 6 here."),
        ("box 6 8", "There is no box 6 8 here."),
        ("green box", "There is no green box here."),
        ("donnie", "There is no donnie here."),
        ("chiar", "There is no chiar here. Did you mean chair?"),
        ("ANA", "ANA is a robot. It moves by its program."),
        ("q" * 50, f"There is no {'q' * 39}… here."),
    ],
)
def test_what_is_not_one_thing_is_said(typed: str, sentence: str, tmp_path: Path) -> None:
    with pytest.raises(Unusable) as refused:
        Furnished(tmp_path, TWO).building.find(typed)

    assert refused.value.sentences[0].startswith(sentence)


def test_a_name_counts_before_a_kind_and_a_name_that_is_near_is_offered(tmp_path: Path) -> None:
    it = Furnished(tmp_path, TWO.replace("b1", "box").replace("b2", "treasure")).building

    assert it.find("box").name == "box"
    with pytest.raises(Unusable) as refused:
        it.find("tresure")
    assert refused.value.sentences[0].startswith("There is no tresure here. Did you mean treasure?")


def test_of_many_things_eight_are_listed(tmp_path: Path) -> None:
    boxes = "".join(f'box( name "b{at}" pose [ {at / 4} 1 0 0 ] )\n' for at in range(1, 10))
    with pytest.raises(Unusable) as refused:
        Furnished(tmp_path, ANA + boxes).building.find("box")

    assert "There are 9: b1: 5, 20; " in refused.value.sentences[0]
    assert "; b8: 40, 20. " in refused.value.sentences[0]


# --- room


@pytest.mark.parametrize(
    ("east", "answer"),
    [
        # from box to box 4 steps; each is 3 wide, and the moved one 3 % smaller: 2.955 between their middles
        *(
            (-1, "built-moved"),
            (-1.04, "built-moved"),
            (-1.05, "B1, the red box is in the way."),
            (-4, "B1, the red box"),
        ),
        (0, "built-moved"),
    ],
)
def test_things_may_touch_and_not_overlap(east: float, answer: str, tmp_path: Path) -> None:
    boxes = 'box( name "b1" pose [ 1 1 0 0 ] )\nbox( name "b2" pose [ 1.2 1 0 0 ] )\n'

    assert Furnished(tmp_path, ANA + boxes).move("b2", east).startswith(answer)


def test_a_long_wall_is_taken_half_a_centimetre_smaller(tmp_path: Path) -> None:
    """Of 41 steps: its half is 20.5, and 20.4 is what needs room. The box begins 1.5 before its middle."""
    wall = 'wall( name "long" pose [ 0 1 0 0 ] size [ 2.05 0.05 0.24 ] )\n'
    box = 'box( name "end" pose [ 2 1 0 0 ] )\n'
    it = Furnished(tmp_path, ANA + wall + box)

    assert [it.move("long", 18.08), it.move("long", 0.05)] == [
        "built-moved",
        "End, the red box is in the way. Nothing changed.",
    ]


def test_walls_may_cross_and_have_no_room_with_things(tmp_path: Path) -> None:
    it = Furnished(tmp_path, ANA + 'wall( name "w" pose [ 0 1 0 0 ] size [ 1 0.05 0.24 ] )\n')

    assert it.put("wall", 0, 15, 0, 25) == "built-put"
    assert it.put("box", 5, 20) == "There is a wall at that place. Nothing changed."
    assert it.put("wall", -9, 0, 9, 0) == "The robot ana is at that place. Nothing changed."


def test_what_a_robot_stands_on_is_not_in_the_way(tmp_path: Path) -> None:
    carpet = 'model( name "carpet" size [ 2 2 0.01 ] pose [ {} 0 0 0 ] )\n'
    under, elsewhere = (Furnished(tmp_path, ANA + carpet.format(x)) for x in (0, 5))

    assert under.put("box", 6, 6) == "built-put"
    assert elsewhere.put("box", 100, 6) == "Carpet of color red is in the way. Nothing changed."


def test_what_no_robot_touches_is_not_in_the_way(tmp_path: Path) -> None:
    it = Furnished(
        tmp_path, ANA + 'model( name "mark" size [ 0.2 0.2 0.01 ] obstacle_return 0 pose [ 1 1 0 0 ] )\n'
    )

    assert it.put("box", 20, 20) == "built-put"


def test_the_places_of_robots_now_and_at_their_start_stay_free(tmp_path: Path) -> None:
    bob = 'donnie( name "bob" pose [ 1 1 0 90 ] )\n'
    it = Furnished(tmp_path, ANA + bob)
    it.world.inhabitant("bob").forward(10)

    assert [it.put("box", 20, y) for y in (20, 30, 25)] == [
        "The robot bob starts at that place. Nothing changed.",
        "The robot bob is at that place. Nothing changed.",
        "built-put",
    ]


@pytest.mark.parametrize(
    ("kind", "place", "answer"),
    [
        # a floor without end: as far as 1000 steps, and half a step more
        *(("box", (999, 0), "put"), ("box", (1000, 0), "outside"), ("post", (1000, 0), "put")),
        *(("post", (1001, 0), "outside"), ("post", (0, -1000), "put"), ("post", (0, 1001), "outside")),
        *(("post", (-1001, 0), "outside"), ("post", (0, -1001), "outside"), ("wall", (1000, 1000), "put")),
        ("wall", (900, 0, 1001, 0), "outside"),
    ],
)
def test_things_stand_a_thousand_steps_away_at_most(
    kind: str, place: tuple[int, ...], answer: str, tmp_path: Path
) -> None:
    found = Furnished(tmp_path, ANA).put(kind, *place)

    sentence = "That is outside. The floor goes from -1000 to 1000 east and from -1000 to 1000 north."
    assert found.removesuffix(" Nothing changed.") == {"put": "built-put", "outside": sentence}[answer]


OUTSIDE = "That is outside. The floor goes from -10 to 10 east and from -10 to 10 north. Nothing changed."
IN_WALL = "There is a wall at that place. Nothing changed."


@pytest.mark.parametrize(
    ("place", "answer"),
    [
        *(((9, 0), "built-put"), ((-9, 9), "built-put"), ((0, -9), "built-put"), ((10, 0), IN_WALL)),
        *(((11, 0), OUTSIDE), ((-11, 0), OUTSIDE), ((0, 11), OUTSIDE), ((0, -11), OUTSIDE)),
    ],
)
def test_in_a_closed_room_things_stand_within_its_walls(
    place: tuple[int, int], answer: str, tmp_path: Path
) -> None:
    assert Furnished(tmp_path, ROOM + ANA).put("post", *place) == answer


@pytest.mark.parametrize(("where", "answer"), [(10, IN_WALL), (10.02, OUTSIDE), (-10.02, OUTSIDE)])
def test_a_thing_is_outside_of_a_room_half_a_step_beyond_its_last_square(
    where: float, answer: str, tmp_path: Path
) -> None:
    it = Furnished(tmp_path, ROOM + ANA + 'post( name "p" pose [ 0.1 0.2 0 0 ] )\n')

    assert [it.move("p", where - 2), it.move("p", 0, where - 4)] == [answer, answer]
    assert it.put("wall", 20, 20) == "built-put"  # another room can be built next to it


@pytest.mark.parametrize(("degrees", "yaw"), [(0, 30), (90, 300), (-90, 120), (30, 0), (31, 359), (720, 30)])
def test_a_thing_is_turned_to_the_right_and_moved_from_where_it_is(
    degrees: int, yaw: int, tmp_path: Path
) -> None:
    it = Furnished(tmp_path, ANA + 'box( name "b" pose [ 1 1 0.5 30 ] )\n')

    assert it.move("b", 2, -3, degrees=degrees) == "built-moved"
    assert f'box( name "b" pose [ 1.1 0.85 0.5 {yaw} ] )' in it.site.text


@pytest.mark.parametrize(
    ("steps", "turn", "pose"),
    [((2, -3), {}, "1.1 0.85 0.5 30"), ((2,), {}, "1.1 1 0.5 30"), ((), {"degrees": 40}, "1 1 0.5 350")],
)
def test_a_thing_is_only_moved_or_only_turned(
    steps: tuple[int, ...], turn: dict[str, int], pose: str, tmp_path: Path
) -> None:
    it = Furnished(tmp_path, ANA + 'box( name "b" pose [ 1 1 0.5 30 ] )\n')

    assert it.move("b", *steps, **turn) == "built-moved"
    assert f'box( name "b" pose [ {pose} ] )' in it.site.text


def test_a_thing_of_an_included_file_can_not_be_changed(tmp_path: Path) -> None:
    (tmp_path / "more.inc").write_text('box( name "theirs" pose [ 1 1 0 0 ] )\n', encoding="utf-8")
    it = Furnished(tmp_path, 'include "more.inc"\n' + ANA + 'box( name "mine" pose [ 2 1 0 0 ] )\n')

    refused = it.remove("theirs")
    assert refused == it.move("theirs", 1)
    assert refused == "Theirs, box, red is written in another file, so it stays. Nothing changed."
    assert it.remove("mine") == "built-removed"
    assert 'name "mine"' not in it.site.text


def test_a_saved_world_is_that_of_its_file_from_then_on(tmp_path: Path) -> None:
    it = Furnished(tmp_path, ANA)
    it.put("box", 4, 6)
    assert not it.site.is_saved

    it.building.save(tmp_path / "other.world")
    assert it.site.is_saved
    assert it.site.path == tmp_path / "other.world"
    assert (tmp_path / "other.world").read_text(encoding="utf-8") == it.site.text


def test_a_name_is_taken_by_what_stands_alone_and_in_any_case(tmp_path: Path) -> None:
    it = Furnished(tmp_path, ANA + 'box( name "Box" pose [ 1 1 0 0 ] model( name "lid" ) )\n')

    assert [it.put("ball", 20, 40, name=name) for name in ("BOX", "lid")] == [
        "BOX is there already. Choose another name.",
        "built-put",
    ]
    it.put("box", 40, 40)
    assert 'name "box 2"' in it.written


def test_all_that_stands_but_robots_and_what_looks_like_a_wall_is_found(tmp_path: Path) -> None:
    """A room that an author draws as one model is no thing."""
    it = Furnished(
        tmp_path,
        ANA + 'model( name "hall" boundary 1 size [ 4 4 1 ] )\n' + 'wall( name "w" pose [ 1 1 0 0 ] )\n',
    )

    assert it.building.find("w").name == "w"
    with pytest.raises(Unusable):
        it.building.find("hall")
    assert [each.name for each in all_things(it.world.scene_now())] == ["ana", "hall", "w"]
