"""What Stage loads although it is odd: Donnie reads it as Stage does, and a warning says what it read.

The expected values follow from Stage 4.3's source: a number is as many digits, points and signs as there
are, read by ``atof``; a property is text, read as a number where one is wanted, and the other way round.
"""

from pathlib import Path

import pytest

from devices.ports.robot import Bearing
from donnie_tui.i18n.mistakes import world_note
from donnie_tui.i18n.words import Words
from sim.scene import NoteKind, RangeSensor, Scene
from sim.worldfile import Code, WorldError, load_text
from tests.unit.sim.floors import IDEAL, robot


def load(text: str) -> Scene:
    return load_text(text, Path("odd.world"))


@pytest.mark.parametrize(
    ("written", "read"),
    [
        ("1.2.3", "1.2"),
        ("--5", "0"),
        ("+-5", "0"),
        ("1-2", "1"),
        ("1..2", "1"),
        ("5-", "5"),
        (".5.5", "0.5"),
        ("-", "0"),
        (".", "0"),
        ('"0.5"', "0.5"),
        ('" 7 m"', "7"),
        ('"far"', "0"),
        ('""', "0"),
    ],
)
def test_of_an_odd_number_the_part_counts_that_stage_reads(written: str, read: str) -> None:
    scene = load(f"model (\n  pose [ 1 {written} 0 0 ]\n)")
    (note,) = scene.report.notes[:1]

    assert scene.models[0].pose.y == float(read)
    assert (note.kind, note.code, note.line, note.column) == (NoteKind.WARNING, "read-as", 2, 12)
    assert note.details == {"name": "pose", "found": written, "used": read}


@pytest.mark.parametrize(
    ("text", "same", "column", "found", "used"),
    [
        ('model ( mass "heavy" )', "model ( mass 0 )", 14, '"heavy"', "0"),
        ('model ( pushable "1" )', "model ( pushable 1 )", 18, '"1"', "1"),
        ('ignore_zloc "no" model ( )', "ignore_zloc 0 model ( )", 13, '"no"', "0"),
        ("model ( obstacle_return [ 0 1 ] )", "model ( obstacle_return 0 )", 25, "[ 0 1 ]", "0"),
        ("model ( name 5.0 )", 'model ( name "5.0" )', 14, "5.0", '"5.0"'),
        ('model ( color [ "blue" ] )', 'model ( color "blue" )', 15, '[ "blue" ]', "blue"),
        ('bumper ( bcount "2" )', "bumper ( bcount 2 )", 17, '"2"', "2"),
        ("bumper ( bcount 2.9 )", "bumper ( bcount 2 )", 17, "2.9", "2"),
        (
            "ranger ( sensor ( range [ 5 1 ] ) )",
            "ranger ( sensor ( range [ 1 5 ] ) )",
            27,
            "5 1",
            "1 5",
        ),
        (
            'unit_length "cm" ranger ( sensor ( range [ -10 300 ] ) )',
            "ranger ( sensor ( range [ 0 3 ] ) )",
            44,
            "-10 300",
            "0 300",
        ),
        (
            "position ( velocity_bounds [ 2 -1 0 0 0 0 90 -90 ] )",
            "position ( velocity_bounds [ -1 2 0 0 0 0 -90 90 ] )",
            30,
            "2 -1",
            "-1 2",
        ),
        (
            "position ( velocity_bounds [ -1 9000000 0 0 0 0 0 0 ] )",
            "position ( velocity_bounds [ -1 1000000 0 0 0 0 0 0 ] )",
            30,
            "-1 9000000",
            "-1 1000000",
        ),
        ("model ( mass -3 )", "model ( mass 0 )", 14, "-3", "0"),
        ("model ( fiducial_key 1.5 )", "model ( fiducial_key 1 )", 22, "1.5", "1"),
        ("model ( size [ 1 -2 1 ] )", "model ( size [ 1 2 1 ] )", 18, "-2", "2"),
        ("model ( size [ 1 2 -1 ] )", "model ( size [ 1 2 1 ] )", 20, "-1", "1"),
    ],
)
def test_a_value_of_another_form_counts_as_in_stage(
    text: str, same: str, column: int, found: str, used: str
) -> None:
    scene = load(text)
    note = next(note for note in scene.report.notes if note.code == "read-as")

    assert outlines(scene) == outlines(load(same))
    assert [each.sensors for each in scene.models] == [each.sensors for each in load(same).models]
    assert note.kind is NoteKind.WARNING
    assert (note.column, note.details["found"], note.details["used"]) == (column, found, used)


def outlines(scene: Scene) -> list[object]:
    """All of the models but the order in which the corners of a shape follow one another."""
    return [
        [
            *(each.name, each.size, each.mass, each.colour, each.pushable, each.obstacle_return),
            *(each.ignore_zloc, each.bumpers, each.wheels),
            *(frozenset(shape.points) for shape in each.polygons),
        ]
        for each in scene.models
    ]


def test_a_number_of_digits_in_order_has_no_warning() -> None:
    for number in ("5", "+5", "-5", "5.", ".5", "-.5", "05", "5e-1", "0"):
        notes = load(f'position ( name "a" pose [ {number} 0 0 0 ] ranger ( ) )').report.notes
        assert notes == ()


def test_a_negative_size_mirrors_a_shape() -> None:
    """Stage scales every corner by the size over that of the blocks."""
    corner = "block ( points 3 point[0] [ 0 0 ] point[1] [ 2 0 ] point[2] [ 0 2 ] )"
    (model,) = load(f"model ( size [ -2 2 1 ] {corner} )").models

    assert model.size == (2, 2, 1)
    assert set(model.polygons[0].points) == {(1, -1), (-1, -1), (1, 1)}


def test_a_block_of_two_points_is_a_wall_without_thickness() -> None:
    line = "block ( points 2 point[0] [ 0 0 ] point[1] [ 1 0 ] )"
    world = f"model ( pose [ 0 1 0 0 ] size [ 1 0 1 ] {line} )"
    scene = load(world)
    donnie = robot(f"{IDEAL} {world} ideal( pose [ 0 0 0 90 ] )")

    assert [(note.kind, note.code, note.line, note.column) for note in scene.report.notes[:1]] == [
        (NoteKind.WARNING, "line-block", 1, 41)
    ]
    assert donnie.distance(Bearing.FRONT) == 20
    assert donnie.forward(30).walked == 19


def test_a_sensor_with_0_samples_measures_nothing() -> None:
    scene = load("position ( ranger ( sensor ( samples 0 ) sensor ( ) ) )")

    assert scene.models[1].sensors == (RangeSensor(),)
    assert [(note.code, note.column) for note in scene.report.notes[:1]] == [("no-samples", 21)]


def test_a_window_in_a_model_has_no_effect_and_a_model_in_a_window_stands_on_the_floor() -> None:
    inside, around = load("model ( window ( ) )"), load("window ( model ( ) ) model ( )")

    assert [each.name for each in inside.models] == ["model:1"]
    assert [note.code for note in inside.report.notes[:1]] == ["lone-window"]
    assert [(each.name, each.parent) for each in around.models] == [("model:1", None), ("model:2", None)]


@pytest.mark.parametrize("rest", [";", " ;", ", # and so on", " // the map", '; ( "open'])
def test_the_rest_of_the_line_of_an_include_has_no_effect(rest: str, tmp_path: Path) -> None:
    (tmp_path / "part.inc").write_text("define box model ( )", encoding="utf-8")
    scene = load_text(f'include "part.inc"{rest}\nbox ( )', tmp_path / "odd.world")
    note = scene.report.notes[0]

    assert [each.kind for each in scene.models] == ["box"]
    assert (note.kind, note.code, note.line) == (NoteKind.WARNING, "include-rest", 1)
    assert note.details["found"] == rest.strip()


def test_what_follows_an_include_and_can_be_read_counts(tmp_path: Path) -> None:
    (tmp_path / "part.inc").write_text('color "blue"', encoding="utf-8")
    scene = load_text('model ( include "part.inc" ) model ( )', tmp_path / "odd.world")

    assert [each.colour.name for each in scene.models] == ["blue", "red"]


def test_a_mistake_in_a_define_that_nothing_uses_is_a_warning() -> None:
    """Stage reads the body of a define where it is used, and before only counts its parentheses."""
    scene = load("define a model ( 5 )\ndefine b model ( ( ) )\nbox ( )\ndefine box model ( size [ 2 2 2 ] )")

    assert [(each.kind, each.size) for each in scene.models] == [("box", (2, 2, 2))]
    assert [(note.code, note.line, note.column) for note in scene.report.notes[:2]] == [
        ("broken-define", 1, 18),
        ("broken-define", 2, 18),
    ]


def test_twenty_broken_defines_of_a_file_are_warnings_and_one_more_is_a_mistake() -> None:
    broken = [f"define a{i} model ( 5 )\n" for i in range(21)]
    notes = load("".join(broken[:20]) + "model ( )").report.notes

    assert [note.line for note in notes if note.code == "broken-define"] == [*range(1, 21)]
    with pytest.raises(WorldError) as caught:
        load("".join(broken))
    assert (caught.value.code, caught.value.line) == (Code.UNEXPECTED, 21)


@pytest.mark.parametrize(
    ("body", "column"), [("size [ 1 2 3", 31), ("pose [ 1 2 ( )", 29), ("size [ [ 1", 29), ("size 1 ]", 25)]
)
def test_an_open_bracket_in_a_define_that_nothing_uses_is_a_warning(body: str, column: int) -> None:
    """Stage counts the parentheses of such a body, not its brackets."""
    scene = load(f"define a model ( {body} )\nmodel ( pose [ 1 2 0 0 ] )")

    assert [each.pose.x for each in scene.models] == [1]
    note = scene.report.notes[0]
    assert (note.code, note.line, note.column) == ("broken-define", 1, column)


@pytest.mark.parametrize(
    ("text", "column"),
    [("define a model ( size [ 1 2 3 ]\nmodel ( )", 16), ("define a model ( b ( )\nmodel ( )", 16)],
)
def test_an_open_parenthesis_in_a_define_is_a_mistake_as_in_stage(text: str, column: int) -> None:
    with pytest.raises(WorldError) as caught:
        load(text)

    assert (caught.value.code, caught.value.line, caught.value.column) == (Code.UNCLOSED, 1, column)


@pytest.mark.parametrize(
    ("text", "line", "column"),
    [
        ("define a model ( 5 )\nmodel ( a ( ) )", 1, 18),
        ("define a model ( 5 )\ndefine b a ( )\nb ( )", 1, 18),
        ("define a model ( )\nmodel ( 5 )", 2, 9),
        ("define a model ( )\na ( 5 )\ndefine b model ( 7 )", 2, 5),
        ("define a ( 5 )", 1, 10),
    ],
)
def test_a_mistake_in_what_is_used_is_still_one(text: str, line: int, column: int) -> None:
    with pytest.raises(WorldError) as caught:
        load(text)

    assert (caught.value.code, caught.value.line, caught.value.column) == (Code.UNEXPECTED, line, column)


def test_words_after_the_sign_of_another_languages_comment_are_still_a_mistake() -> None:
    with pytest.raises(WorldError) as caught:
        load("model ( )\n-- a table\nmodel ( )")

    assert (caught.value.code, caught.value.line, caught.value.column) == (Code.COMMENT_SIGN, 2, 1)


@pytest.mark.parametrize(
    ("text", "language", "sentence"),
    [
        ("size [ 1 --5 1 ]", "en", "Line 2, column 13, of odd.world: size: --5 is read as 0."),
        ("size [ 1 --5 1 ]", "pt", "Linha 2, coluna 13, de odd.world: size: --5 é lido como 0."),
        ("size [ 1 --5 1 ]", "es", "Línea 2, columna 13, de odd.world: size: --5 se lee como 0."),
        (
            "block ( points 2 )",
            "es",
            "Línea 2, columna 4, de odd.world: un bloque de 2 puntos es una línea.",
        ),
        (
            "ranger ( sensor ( samples 0 ) )",
            "pt",
            "Linha 2, coluna 13, de odd.world: um sensor com samples 0 não mede nada.",
        ),
    ],
)
def test_a_warning_says_where_and_what_was_read(text: str, language: str, sentence: str) -> None:
    notes = load(f"model (\n   {text}\n)").report.notes

    assert sentence in [world_note(note, Words(language)) for note in notes]
