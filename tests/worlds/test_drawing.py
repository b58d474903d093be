"""A floor drawn in letters becomes a world; each mistake has its place; a printed map can be read back."""

import re
from pathlib import Path

import pytest

import worlds
from donnie_tui.cli.main import main
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.world.drawing import groups_in, world_of
from donnie_tui.world.loading import choose_world
from sim.picture import Picture, picture

ROOM = """\
###########
#.........#
#..c......#
#.........#
#.....^...#
#.........#
#.bb......#
#.bb......#
###########

c chair green AS throne
b box red
"""


def mistakes_of(drawing: str) -> list[str]:
    with pytest.raises(Unusable) as bad:
        world_of(drawing, "map.txt", Words("en"))
    return [*bad.value.sentences]


def built(drawing: str) -> str:
    return world_of(drawing, "map.txt", Words("en"))[0]


def written(drawing: str, folder: Path) -> Picture:
    file = folder / "drawn.world"
    file.write_text(built(drawing), encoding="utf-8")
    chosen = choose_world(str(file), Words("en"))
    assert chosen.scene.report.notes == ()
    return picture(chosen.scene)


def test_a_drawing_becomes_a_world_with_its_things_at_their_places(tmp_path: Path) -> None:
    seen = written(ROOM, tmp_path)

    throne, box = seen.things
    assert (throne.name, throne.kind, throne.colour) == ("throne", "chair", "green")
    assert (throne.x, throne.y, throne.width, throne.depth) == (-3, 2, 3, 3)  # its usual size
    assert (box.kind, box.colour) == ("box", "red")
    assert (box.x, box.y, box.width, box.depth) == (-3.5, -2.5, 2, 2)  # as it is drawn
    assert seen.rows == (
        "###########",
        "#.ccc.....#",
        "#.ccc.....#",
        "#.ccc.....#",
        "#.........#",
        "#.........#",
        "#.bb......#",
        "#.bb......#",
        "###########",
    )


@pytest.mark.parametrize(("arrow", "heading"), [("^", 0), (">", 90), ("v", 180), ("<", 270)])
def test_the_arrow_says_where_the_robot_looks(tmp_path: Path, arrow: str, heading: int) -> None:
    file = tmp_path / "drawn.world"
    file.write_text(built(ROOM.replace("^", arrow)), encoding="utf-8")

    start = choose_world(str(file), Words("en")).start()

    assert (start.x, start.y, start.heading) == (0, 0, heading)


@pytest.mark.parametrize(
    "legend", ["c cadeira verde COMO trono", "c = silla verde", "c: green chair", "c is chair, green."]
)
def test_the_legend_is_understood_in_every_language(tmp_path: Path, legend: str) -> None:
    thing = written(ROOM.replace("c chair green AS throne", legend), tmp_path).things[0]

    assert (thing.kind, thing.colour) == ("chair", "green")


@pytest.mark.parametrize("first", ["", "^ anna\n"])
def test_the_legend_may_begin_without_an_empty_line(tmp_path: Path, first: str) -> None:
    assert (
        written(ROOM.replace("\n\nc chair", f"\n{first}c chair"), tmp_path).rows
        == written(ROOM, tmp_path).rows
    )


@pytest.mark.parametrize("between", ["", "\n"])
def test_the_legend_may_come_first(tmp_path: Path, between: str) -> None:
    rows, legend = ROOM.split("\n\n")

    assert written(f"{legend}{between}{rows}\n", tmp_path) == written(ROOM, tmp_path)


def test_blanks_and_tabs_after_a_row_have_no_effect(tmp_path: Path) -> None:
    assert written(ROOM.replace("#\n", "#\t \n"), tmp_path) == written(ROOM, tmp_path)


def test_an_orange_box_is_a_box_and_an_orange_is_an_orange(tmp_path: Path) -> None:
    seen = written(ROOM.replace("chair green AS throne", "orange").replace("box red", "orange box"), tmp_path)

    assert [(each.kind, each.colour) for each in seen.things] == [("orange", "orange"), ("box", "orange")]


def test_several_colours_are_for_the_things_in_reading_order(tmp_path: Path) -> None:
    drawing = "......\n.f...f\n......\n......\n....^.\n......\n.f....\n\nf flower red, blue, yellow\n"

    things = written(drawing, tmp_path).things

    assert [(each.colour, each.x, each.y) for each in things] == [
        ("red", -3, 3),
        ("blue", 1, 3),
        ("yellow", -3, -2),
    ]


GARDEN = """.......
.fB..f.
.....R.
.......
..^....

f flower: R red, B blue
"""


def test_a_letter_in_the_midst_of_a_thing_is_the_initial_of_its_colour(tmp_path: Path) -> None:
    """Also where the same colour comes twice, and in any order."""
    drawing = GARDEN.replace("..^....", "..^....\n.......\n.......\n.fRf...")

    things = written(drawing, tmp_path).things

    assert [(each.colour, each.x, each.y, each.width, each.depth) for each in things] == [
        ("blue", -0.5, 3, 2, 1),
        ("red", 3, 2.5, 1, 2),
        ("red", 0, -3, 3, 1),
    ]


def test_a_thing_without_the_initial_of_a_colour_is_a_mistake() -> None:
    (mistake,) = (each for each in mistakes_of(GARDEN.replace("R.\n", "f.\n")) if "line 7" in each)

    assert mistake.startswith("Error, map.txt, line 7, column 3: ")
    assert "2" in mistake
    assert "1" in mistake


@pytest.mark.parametrize(("language", "marks"), [("en", "BBBYYOYYRR"), ("pt", "AAAMMLMMVV")])
def test_a_printed_map_has_the_initials_of_colours_that_alone_make_a_difference(
    language: str, marks: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    main(["world", "colour_garden", "--map", "--lang", language])
    printed = capsys.readouterr().out

    rows = printed.partition("\n\n")[0]
    assert re.sub(r"[^A-Z]", "", rows) == marks
    again = written(printed, tmp_path)
    assert sorted(each.colour for each in again.things) == sorted(
        ["blue"] * 3 + ["yellow"] * 4 + ["orange"] + ["red"] * 2 + ["gray"]
    )


def test_a_letter_can_mean_wall(tmp_path: Path) -> None:
    drawing = ROOM.replace("#", "w") + "w wall\n"

    assert written(drawing, tmp_path).rows == written(ROOM, tmp_path).rows


def test_two_robots_are_named_under_the_drawing(tmp_path: Path) -> None:
    file = tmp_path / "drawn.world"
    file.write_text(built("......\n.^..>.\n......\n\n^ alice, bob\n"), encoding="utf-8")

    assert choose_world(str(file), Words("en")).scene.robot_names == ("alice", "bob")


@pytest.mark.parametrize(
    ("drawing", "sentences"),
    [
        ("", ["Error, map.txt: There is no drawing. # is wall, . is free floor, ^ is a robot."]),
        ("\n\n", ["Error, map.txt: There is no drawing. # is wall, . is free floor, ^ is a robot."]),
        ("....\n", ["Error, map.txt: There is no robot. Put ^, >, v or < where it is."]),
        (
            "......\n.^..>.\n......\n",
            ["Error, map.txt, line 2, column 5: 2 robots, 0 names. Write under the drawing: ^ alice, bob."],
        ),
        (
            "......\n.^..>.\n......\n\n^ alice\n",
            ["Error, map.txt, line 5, column 1: 2 robots, 1 name. Write under the drawing: ^ alice, bob."],
        ),
        (
            "......\n.^..>.\n......\n\n^ alice, Alice\n",
            ["Error, map.txt, line 5, column 1: 2 robots, 1 name. Write under the drawing: ^ alice, bob."],
        ),
        (
            ".....\n..^..\n....\n......\n",
            [
                "Error, map.txt, line 3, column 5: This line has 4 letters, the first has 5.",
                "Error, map.txt, line 4, column 6: This line has 6 letters, the first has 5.",
            ],
        ),
        (
            ".....\n.\t^..\n.....\n",
            ["Error, map.txt, line 2, column 2: There is a blank or a tab here. Free floor is a dot."],
        ),
        (
            ".....\n. ^..\n.....\n",
            ["Error, map.txt, line 2, column 2: There is a blank or a tab here. Free floor is a dot."],
        ),
        (
            ".....\n..^.*\n.....\n",
            ["Error, map.txt, line 2, column 5: The sign * means nothing here. A thing is a letter."],
        ),
        (
            "C....\n..^..\n....d\n\nc chair\n",
            [
                "Error, map.txt, line 1, column 1: Nothing says what C is. Did you mean c?",
                "Error, map.txt, line 3, column 5: Nothing says what d is. "
                "Write under the drawing: d chair green.",
            ],
        ),
        (
            ROOM.replace("chair green", "chiar gren").replace("box", "sofa"),
            [
                "Error, map.txt, line 11, column 3: chiar is neither a thing nor a color. "
                "Did you mean chair?",
                "Error, map.txt, line 11, column 9: gren is neither a thing nor a color. Did you mean green?",
                "Error, map.txt, line 12, column 3: sofa is neither a thing nor a color. "
                "Did you mean small sofa?",
            ],
        ),
        (
            ROOM.replace("chair green", "chair gren"),
            [
                "Error, map.txt, line 11, column 9: gren is neither a thing nor a color. Did you mean green?",
            ],
        ),
        (
            ROOM + "c box\nthe box\nb\n",
            [
                "Error, map.txt, line 13, column 1: c has a line already. Use another letter.",
                "Error, map.txt, line 14, column 1: the is not one letter. "
                "A line here says what a letter is: c chair green.",
                "Error, map.txt, line 15, column 1: b has a line already. Use another letter.",
            ],
        ),
        (
            ROOM.replace("chair green AS throne", "chair green small sofa"),
            [
                "Error, map.txt, line 11, column 15: small sofa is one thing too many. "
                "Each line says one thing.",
            ],
        ),
        (
            ROOM.replace("chair green AS throne", "green"),
            [
                "Error, map.txt, line 11, column 3: The name of the thing is missing. Things are: chair, "
                "table, small sofa, large sofa, box, ball, cone, post, flower, stone, crystal, orange, "
                "juice carton, conveyor belt."
            ],
        ),
        (
            ROOM.replace("chair green AS throne", 'chiar AS ""'),
            [
                "Error, map.txt, line 11, column 3: chiar is neither a thing nor a color. "
                "Did you mean chair?",
                "Error, map.txt, line 11, column 9: A name begins with a letter: AS treasure.",
            ],
        ),
        (
            ROOM.replace("box red", "box red blue"),
            ["Error, map.txt, line 12, column 3: 1 thing, but 2 colors. Give one color, or one for each."],
        ),
        (
            "##^##\n#...#\n#...#\n#####\n",
            [
                "Error, map.txt, line 1, column 3: The robot touches something: wall. "
                "It needs free floor on every side."
            ],
        ),
        (
            "#####\n#.^.#\n#...#\n#####\n",
            [
                "Error, map.txt, line 2, column 3: The robot touches something: wall. "
                "It needs free floor on every side."
            ],
        ),
        (
            "#####\n#.^.#\n#...#\n#####\n\n^ a:b\n",
            [
                "Error, map.txt, line 2, column 3: The robot touches something: wall. "
                "It needs free floor on every side."
            ],
        ),
        (
            ROOM.replace("#..c......#", "#c........#"),
            ["Error, map.txt, line 3, column 2: Too little room: chair, 3 by 3 steps, is over wall."],
        ),
        (
            ".....\n..^..\n.....\n\n##...\n",
            ["Error, map.txt, line 4, column 1: This line has 0 letters, the first has 5."],
        ),
        (
            "#####\n#...#\n\n#.^.#\n#####\n\nc chair\n",
            [
                "Error, map.txt, line 3, column 1: This line has 0 letters, the first has 5.",
                "Error, map.txt, line 4, column 3: The robot touches something: wall. "
                "It needs free floor on every side.",
            ],
        ),
        (
            ("." * 500 + "\n") * 500,
            [
                "Error, map.txt, line 1, column 401: "
                "The drawing is too large: 400 lines of 400 letters at most."
            ],
        ),
        (
            "." * 401 + "\n",
            [
                "Error, map.txt, line 1, column 401: "
                "The drawing is too large: 400 lines of 400 letters at most."
            ],
        ),
        (
            "^\n" + ".\n" * 400,
            [
                "Error, map.txt, line 401, column 1: "
                "The drawing is too large: 400 lines of 400 letters at most."
            ],
        ),
    ],
    ids=map(str, range(1, 29)),
)
def test_every_mistake_in_a_drawing_has_its_place(drawing: str, sentences: list[str]) -> None:
    count = len(sentences)
    total = f"{count} mistake{'s' if count > 1 else ''}. I wrote nothing."

    assert mistakes_of(drawing) == [*sentences, total]


def test_mistakes_in_the_legend_hide_none_in_the_drawing() -> None:
    """Also where a row is too short, and where a thing has no room."""
    drawing = ROOM.replace("box red", "box rde").replace("#..c......#", "#c........#")
    drawing = drawing.replace("#.....^...#", "#......Q..#").replace("#.........#\n#.bb", "#........#\n#.bb")
    drawing = drawing.replace("#.........#", "#.......^.#", 1)

    assert mistakes_of(drawing) == [
        "Error, map.txt, line 2, column 9: The robot touches something: wall. "
        "It needs free floor on every side.",
        "Error, map.txt, line 3, column 2: Too little room: chair, 3 by 3 steps, is over wall.",
        "Error, map.txt, line 5, column 8: Nothing says what Q is. Write under the drawing: Q chair green.",
        "Error, map.txt, line 6, column 11: This line has 10 letters, the first has 11.",
        "Error, map.txt, line 12, column 7: rde is neither a thing nor a color. Did you mean red?",
        "5 mistakes. I wrote nothing.",
    ]


@pytest.mark.parametrize(
    ("count", "language", "last"),
    [
        (20, "en", ["20 mistakes. I wrote nothing."]),
        (21, "en", ["And 1 more.", "21 mistakes. I wrote nothing."]),
        (25, "en", ["And 5 more.", "25 mistakes. I wrote nothing."]),
        (25, "pt", ["E mais 5.", "25 erros. Não escrevi nada."]),
        (25, "es", ["Y 5 más.", "25 errores. No escribí nada."]),
    ],
)
def test_of_many_mistakes_the_first_20_are_listed(count: int, language: str, last: list[str]) -> None:
    letters = "abcdefghijklmnopqrstuwxyz"[:count]  # v is a robot
    row = "." * count
    with pytest.raises(Unusable) as bad:
        world_of(f"{letters}\n{row}\n...^{row[4:]}\n{row}\n", "map.txt", Words(language))

    assert [*bad.value.sentences[20:]] == last


def test_a_drawing_with_too_many_walls_is_refused() -> None:
    rows = [("#." * 100), (".#" * 100)] * 50

    (sentence, _) = mistakes_of("\n".join([*rows, "." * 200, "." * 50 + "^" + "." * 149, "." * 200]))

    assert sentence == "Error, map.txt: Too many walls and things: 10000. At most 2000."


# --- what is one thing, and what is written


NEIGHBOURS = [(down, right) for down in (-1, 0, 1) for right in (-1, 0, 1) if down or right]


@pytest.mark.parametrize(("down", "right"), NEIGHBOURS)
def test_equal_letters_that_touch_also_at_corners_are_one_thing(down: int, right: int) -> None:
    def groups(distance: int) -> list[tuple[tuple[int, int], ...]]:
        places = sorted([(2, 2), (2 + distance * down, 2 + distance * right)])
        rows = ["".join("b" if (row, column) in places else "." for column in range(5)) for row in range(5)]
        return [each.squares for each in groups_in(rows)]

    near, far = (sorted([(2, 2), (2 + at * down, 2 + at * right)]) for at in (1, 2))
    assert groups(1) == [tuple(near)]
    assert groups(2) == [(each,) for each in far]


def test_things_come_in_reading_order_and_other_letters_part_them() -> None:
    rows = ["b.bc#", ".b.cb", "^v<>b"]

    assert [(each.letter, each.squares, each.colour) for each in groups_in(rows)] == [
        ("b", ((0, 0), (0, 2), (1, 1)), ""),
        ("c", ((0, 3), (1, 3)), ""),
        ("b", ((1, 4), (2, 4)), ""),
    ]


def test_the_first_mark_in_a_thing_is_its_colour_and_a_letter_with_a_thing_of_its_own_is_no_mark() -> None:
    marks = {"f": {"R": "red", "B": "blue", "c": "green"}, "c": {"B": "black"}}
    rows = ["fBRf.R", "......", "fc..Rf", "......", "c.B.cB"]

    assert [
        (each.letter, each.squares[0], len(each.squares), each.colour) for each in groups_in(rows, marks)
    ] == [
        ("f", (0, 0), 4, "blue"),
        ("f", (2, 0), 1, ""),
        ("c", (2, 1), 1, ""),
        ("f", (2, 4), 2, "red"),
        ("c", (4, 0), 1, ""),
        ("c", (4, 4), 2, "black"),
        ("R", (0, 5), 1, ""),
        ("B", (4, 2), 1, ""),
    ]


def test_the_world_of_a_drawing_has_its_walls_then_its_things_then_its_robots() -> None:
    """In metres from the first robot, which looks north; a letter is a step of 5 cm."""
    rows = "####......\n..........\n#.......bb\n#.........\n..........\n.....^....\n..........\n"
    rows += "b........f\n..........\n..........\n..........\n.>........\n..........\n"
    text, counts = world_of(f"{rows}\nb box red AS treasure\nf flower\n^ ana, bob\n", "map.txt", Words("en"))

    assert text.partition("resolution 0.02\n\n")[2] == (
        "wall( pose [ -0.175 0.25 0 0 ] size [ 0.2 0.05 0.24 ] )\n"
        "wall( pose [ -0.25 0.125 0 0 ] size [ 0.05 0.1 0.24 ] )\n\n"
        'box( name "treasure" pose [ 0.175 0.15 0 0 ] size [ 0.1 0.05 0.15 ] color "red" )\n'
        'box( name "treasure 2" pose [ -0.25 -0.1 0 0 ] color "red" )\n'
        'flower( name "flower" pose [ 0.2 -0.1 0 0 ] )\n\n'
        'donnie( name "ana" pose [ 0 0 0 90 ] )\n'
        'donnie( name "bob" pose [ -0.2 -0.3 0 0 ] )\n'
    )
    assert counts == {"width": 10, "depth": 13, "robots": 2, "things": 3}


SCALE, ESCALA = "Each letter is 2 by 2 steps.", "Cada letra vale 2 por 2 pasos."


@pytest.mark.parametrize(
    ("rows", "legend", "line"),
    [
        # a table is 10 by 5 steps: drawn so, or a step larger, it is as large as it is, also turned
        (["t" * 10] * 5, "t table", 'table( name "table" pose [ -0.275 0.4 0 0 ] )'),
        (["t" * 11] * 6, "t table", 'table( name "table" pose [ -0.25 0.375 0 0 ] )'),
        (["t" * 5] * 10, "t table", 'table( name "table" pose [ -0.4 0.275 0 90 ] )'),
        (["t" * 10] * 4, "t table", 'table( name "table" pose [ -0.275 0.425 0 0 ] size [ 0.5 0.2 0.15 ] )'),
        (["t" * 12] * 5, "t table", 'table( name "table" pose [ -0.225 0.4 0 0 ] size [ 0.6 0.25 0.15 ] )'),
        (["t" * 9] * 5, "t table", 'table( name "table" pose [ -0.3 0.4 0 0 ] size [ 0.45 0.25 0.15 ] )'),
        (["t" * 5] * 3, "t table", 'table( name "table" pose [ -0.4 0.45 0 0 ] size [ 0.25 0.15 0.15 ] )'),
        (["t" * 10] * 7, "t table", 'table( name "table" pose [ -0.275 0.35 0 0 ] size [ 0.5 0.35 0.15 ] )'),
        (["c" * 4] * 3, "c chair", 'chair( name "chair" pose [ -0.425 0.45 0 0 ] )'),
        (["c"], "c chair blue AS it", 'chair( name "it" pose [ -0.5 0.5 0 0 ] color "blue" )'),
        (["t" * 5] * 3, f"{SCALE}\nt table", 'table( name "table" pose [ -0.8 0.9 0 0 ] )'),
        (["t" * 5] * 3, f"{ESCALA}\nt table", 'table( name "table" pose [ -0.8 0.9 0 0 ] )'),
    ],
)  # fmt: skip
def test_a_thing_of_several_letters_is_as_large_as_these_unless_that_is_its_usual_size(
    rows: list[str], legend: str, line: str
) -> None:
    """Without a robot the middle of the floor is 0 0: the first letter is 10 to the left and 10 above."""
    drawn = [f"{'.' * 10}{each}".ljust(40, ".") for each in ["." * 30] * 10 + rows]
    drawn += ["." * 40] * (40 - len(drawn))
    text, counts = world_of("\n".join([*drawn, "", "There is no robot.", legend]), "map.txt", Words("en"))

    side = 80 if "2 por 2" in legend or SCALE in legend else 40
    assert text.endswith(f"\n\n{line}\n")
    assert counts == {"width": side, "depth": side, "robots": 0, "things": 1}


FREE = "." * 13 + "\n"


def test_a_line_about_walls_or_free_floor_has_no_effect() -> None:
    assert built(f"{ROOM}# is wall.\n. is free floor.\n") == built(ROOM)


ALONE = ".....\n.....\n..{}..\n.....\n.....\n"


@pytest.mark.parametrize(
    ("drawing", "names"),
    [
        ("^ ana", ["ana"]),
        ("^ ana, …", ["ana"]),
        ("", ["donnie"]),
        ("^ …", ["donnie"]),
    ],
)
def test_a_robot_alone_has_the_name_under_the_drawing(drawing: str, names: list[str]) -> None:
    text = built(f"{ALONE.format('^')}\n{drawing}\n")

    assert re.findall(r'donnie\( name "(.*)" pose', text) == names


def test_robots_beyond_the_names_of_a_long_list_are_numbered() -> None:
    row = ".....\n..^..\n.....\n"
    text = built(f"{row * 4}\n^ ana, ana3, …\n")

    assert re.findall(r'donnie\( name "(.*)" pose', text) == ["ana", "ana3", "ana2", "ana4"]


def test_a_robot_with_letters_around_it_comes_after_the_one_without() -> None:
    """A map shows the bodies of the other robots."""
    rows = ".......\n.rrr...\n.r>r...\n.rrr...\n.......\n.......\n....^..\n.......\n"

    assert built(f"{rows}\n^ ana, bob\nr is bob.\n").endswith(
        'donnie( name "ana" pose [ 0 0 0 90 ] )\ndonnie( name "bob" pose [ -0.1 0.2 0 0 ] )\n'
    )


@pytest.mark.parametrize(
    ("drawing", "sentences"),
    [
        (f"{ALONE.format('^')}\n^ ana, bob\n",
         ["Error, map.txt, line 7, column 1: 1 robot, 2 names. Write under the drawing: ^ alice, bob."]),
        (FREE * 2 + "^....^....^..\n" + FREE * 2,
         ["Error, map.txt, line 3, column 6: 3 robots, 0 names. Write under the drawing: ^ alice, bob."]),
        (ALONE.format("7"), ["Error, map.txt: There is no robot. Put ^, >, v or < where it is.",
                             "Error, map.txt, line 3, column 3: Nothing says what 7 is. "
                             "Write under the drawing: 7 chair green."]),
        (f"b.....\n......\n......\n{ALONE.format('.^').replace('.....', '......')}\nb box red, blue\n",
         ["Error, map.txt, line 10, column 3: 1 thing, but 2 colors. Give one color, or one for each."]),
        ("b...b...b...b\n" + FREE * 3 + FREE.replace(".", "^", 1) + FREE * 2 + "\nb box red, blue\n",
         ["Error, map.txt, line 9, column 3: 4 things, but 2 colors. Give one color, or one for each."]),
    ],
)  # fmt: skip
def test_names_and_colours_that_are_too_many_or_too_few_are_mistakes(
    drawing: str, sentences: list[str]
) -> None:
    assert mistakes_of(drawing)[:-1] == sentences


def test_a_letter_that_is_said_to_be_nothing_is_a_mistake() -> None:
    floor = (
        FREE * 3 + FREE.replace("...", "b..", 1) + FREE * 3 + FREE.replace("......", ".....^", 1) + FREE * 3
    )

    for line in ("b", "b ="):
        (mistake, _) = mistakes_of(f"{floor}\n{line}\n")
        assert "The name of the thing is missing." in mistake


def test_one_colour_is_for_all_things_and_several_are_used_in_turn() -> None:
    rows = "b....b\n......\n......\nb....b\n......\n......\n......\n......\n..^...\n......\n"

    def found(legend: str) -> list[str]:
        return re.findall(r'box.*color "(.*)"', built(f"{rows}\n{legend}\n"))

    assert found("b box red") == ["red"] * 4
    assert found("b box red, blue, red, green") == ["red", "blue", "red", "green"]


def test_a_thing_of_one_letter_may_touch_another_and_not_overlap_it() -> None:
    floor = (
        ["." * 30] * 6
        + ["..b{}..........................."]
        + ["." * 30] * 6
        + [f"{'.' * 20}^{'.' * 9}"]
        + ["." * 30] * 3
    )

    def drawing(between: int) -> str:
        rows = [each.format(f"{'.' * between}b")[:30].ljust(30, ".") for each in floor]
        return "\n".join([*rows, "", "b box"])

    assert len(re.findall("^box", built(drawing(2)), re.MULTILINE)) == 2
    assert mistakes_of(drawing(1))[0] == (
        "Error, map.txt, line 7, column 3: Too little room: box, 3 by 3 steps, is over box."
    )


def test_a_drawing_may_have_four_hundred_lines_of_four_hundred_letters() -> None:
    for rows in (["." * 400] * 2 + ["^" + "." * 399] + ["." * 400], ["."] * 399 + ["^"]):
        text, counts = world_of("\n".join(rows), "map.txt", Words("en"))
        assert (counts["width"], counts["depth"]) == (len(rows[0]), len(rows))
        assert text.endswith('donnie( name "donnie" pose [ 0 0 0 90 ] )\n')


def test_a_drawing_may_not_have_one_piece_more_than_two_thousand() -> None:
    rows = ["#." * 200, "." * 400] * 10
    rows += ["#" + "." * 399, "." * 400, "." * 400, "^" + "." * 399, "." * 400]

    (sentence, _) = mistakes_of("\n".join(rows))
    assert sentence == "Error, map.txt: Too many walls and things: 2001. At most 2000."


# --- the command


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "map.txt").write_text(ROOM, encoding="utf-8")
    return tmp_path


def test_world_new_writes_a_file_and_says_what_is_in_it(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["world", "new", "room", "--from", "map.txt"]) == 0

    assert capsys.readouterr().out == (
        "room.world: a floor of 11 by 9 steps, 1 robot, 2 things. Go there: donnie --world room.world\n"
    )
    assert main(["world", "room.world"]) == 0


def test_world_new_without_a_drawing_is_an_empty_room(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["world", "new", "room.world"]) == 0

    assert "33 by 33 steps, 1 robot, 0 things" in capsys.readouterr().out


def test_a_folder_is_no_new_world(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["world", "new", "."]) == 2
    assert capsys.readouterr().err == ". is a folder.\n"
    assert [each.name for each in folder.iterdir()] == ["map.txt"]


def test_a_file_that_is_there_is_never_overwritten(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "room.world").write_text("mine", encoding="utf-8")

    assert main(["world", "new", "room.world", "--from", "map.txt"]) == 2
    assert (folder / "room.world").read_text(encoding="utf-8") == "mine"
    assert capsys.readouterr().err == "room.world is there already. Give another name.\n"


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (b"", "Error, map.txt: There is no drawing. # is wall, . is free floor, ^ is a robot."),
        (b"\0\1\2", "map.txt is no text in UTF-8."),
        (
            b"#" * 1_000_000,
            "Error, map.txt, line 1, column 401: The drawing is too large: 400 lines of 400 letters at most.",
        ),
        (
            b"####\n" * 200_000,
            "Error, map.txt, line 401, column 1: The drawing is too large: 400 lines of 400 letters at most.",
        ),
    ],
    ids=["empty", "binary", "one long line", "many lines"],
)
def test_a_file_that_is_no_drawing_writes_nothing(
    folder: Path, capsys: pytest.CaptureFixture[str], content: bytes, sentence: str
) -> None:
    (folder / "map.txt").write_bytes(content)

    assert main(["world", "new", "room.world", "--from", "map.txt"]) == 2
    assert capsys.readouterr().err.splitlines()[0] == sentence
    assert not (folder / "room.world").exists()


@pytest.mark.parametrize(
    "arguments",
    [
        *(["new"], ["new", "--from", "map.txt"], ["first_room", "--from", "map.txt"], ["a", "b"]),
    ],
)
def test_a_wrong_use_says_how_it_is_typed(
    folder: Path, capsys: pytest.CaptureFixture[str], arguments: list[str]
) -> None:
    assert main(["world", *arguments]) == 2
    assert capsys.readouterr().err == (
        "Type donnie world new FILE --from DRAWING, or without --from for an empty room.\n"
    )


# --- reading a printed map back


def _squares(printed: str) -> dict[str, set[tuple[int, int]]]:
    """Walls, things and robots with their places from the first robot, or from the first row and column."""
    lines = printed.splitlines()
    rows, legend = lines[: lines.index("")], lines[lines.index("") + 1 :]
    names = next((set(each[:-1].split()[5:]) for each in legend if each[0] in "^>v<"), set())
    names = {each.strip(",") for each in names}
    bodies = {each[0] for each in legend if {word.strip(",.") for word in each.split()[2:]} <= names}
    found: dict[str, set[tuple[int, int]]] = {"wall": set(), "thing": set(), "robot": set()}
    for row, line in enumerate(rows):
        for column, letter in enumerate(line):
            if letter not in {".", *bodies}:
                kind = "wall" if letter == "#" else "robot" if letter in "^>v<" else "thing"
                found[kind].add((row, column))
    down, right = min(found["robot"], default=(0, 0))
    return {kind: {(row - down, column - right) for row, column in each} for kind, each in found.items()}


def colours(world: str) -> list[tuple[str, str]]:
    seen = picture(choose_world(world, Words("en")).scene)
    return sorted((each.kind, each.colour) for each in seen.things if not each.is_robot)


def _near(place: tuple[int, int], others: set[tuple[int, int]]) -> bool:
    return any((place[0] + down, place[1] + right) in others for down in (-1, 0, 1) for right in (-1, 0, 1))


LEGENDS = ("living_room", "two_robots", "factory", "empty")
"""Worlds whose legends have every form; the other languages differ in nothing else."""


@pytest.mark.parametrize(
    ("name", "language"),
    [
        *((name, "en") for name in worlds.names()),
        *((name, language) for name in LEGENDS for language in ("pt", "es")),
    ],
)
def test_a_printed_map_is_read_back_within_one_square(
    folder: Path, capsys: pytest.CaptureFixture[str], name: str, language: str
) -> None:
    assert main(["world", name, "--map", "--lang", language]) == 0
    printed = capsys.readouterr().out
    (folder / "map.txt").write_text(printed, encoding="utf-8")

    code = main(["world", "new", "back.world", "--from", "map.txt"])
    assert (code, capsys.readouterr().err) == (0, "")
    main(["world", "back.world", "--map", "--lang", language])
    before, after = _squares(printed), _squares(capsys.readouterr().out)

    assert len(before["robot"]) == len(after["robot"])
    assert before["wall"] or before["thing"] or before["robot"]
    if name != "bigbob_oranges":  # two oranges share a letter of 4 steps
        assert colours(name) == colours("back.world")
    for kind in before:
        assert [each for each in before[kind] if not _near(each, after[kind])] == []
        assert [each for each in after[kind] if not _near(each, before[kind])] == []
