"""World files that can't be used: each mistake has a code, a line, a column and what was expected."""

import errno
import os
from pathlib import Path

import pytest

from sim.worldfile import Code, WorldError, load_text, load_world
from sim.worldfile.parser import WordCount

BROKEN = [
    # text, code, line, column, expected
    ("a (", Code.UNCLOSED, 1, 3, (")",)),
    ("model (\n  pose [ 0 0\n", Code.UNCLOSED, 2, 8, ("]",)),
    ("size [ [ 1 ]", Code.UNCLOSED, 1, 6, ("]",)),
    ("model ( )\n)", Code.UNEXPECTED, 2, 1, ("end of file", "define", "include", "name")),
    ("model ( pose [ 0 0 0 0 ) ]", Code.UNEXPECTED, 1, 24, ("tuple", "number", "string", "]")),
    ("model ( pose )", Code.UNEXPECTED, 1, 14, ("tuple", "number", "string", "(")),
    ("resolution", Code.UNEXPECTED, 1, 1, ("tuple", "number", "string", "(")),
    ("define a ( )", Code.UNEXPECTED, 1, 10, ("name",)),
    ("include model", Code.UNEXPECTED, 1, 9, ("string",)),
    ('name "open\n"', Code.UNTERMINATED_STRING, 1, 6, ('"',)),
    ("\n\n  model ? ( )", Code.UNKNOWN_CHARACTER, 3, 9, ()),
    ("model ( pose [ 0 0 0 9O ] )", Code.BAD_NUMBER, 1, 22, ("number",)),
    ("size [ 5cm 1 ]", Code.BAD_NUMBER, 1, 8, ("number",)),
    ("size [ 1.2.3x 1 ]", Code.BAD_NUMBER, 1, 8, ("number",)),
    ("speedup 1e400", Code.NUMBER_TOO_LARGE, 1, 9, ()),
    ("speedup 9999999999999999", Code.NUMBER_TOO_LARGE, 1, 9, ()),
    ("model ( " * 80, Code.NESTED_TOO_DEEP, 1, 519, ()),
    ('model ( include "x.inc" )', Code.FILE_NOT_FOUND, 1, 17, ()),
    ("model ( pose include )", Code.MISPLACED, 1, 14, ()),
    ("model ( define x model ( ) )", Code.MISPLACED, 1, 9, ()),
    ("block ( points 3 )", Code.MISPLACED, 1, 1, ()),
    ("sensor ( )", Code.MISPLACED, 1, 1, ()),
    ("\nmodle ( )", Code.UNKNOWN_TYPE, 2, 1, ("type",)),
    ("define chair modle ( )\nchair ( )", Code.UNKNOWN_TYPE, 1, 14, ("type",)),
    ("define a b ( )\ndefine b a ( )\na ( )", Code.DEFINE_CYCLE, 2, 10, ()),
    ("define a a ( )\na ( )", Code.DEFINE_CYCLE, 1, 10, ()),
    ("define a ranger ( a ( ) )\na ( )", Code.DEFINE_CYCLE, 1, 19, ()),
    ("define a model ( b ( ) )\ndefine b model ( a ( ) )\na ( )", Code.DEFINE_CYCLE, 2, 18, ()),
    (
        "define a model ( c ( ) )\ndefine c b ( )\ndefine b model ( a ( ) )\nc ( )",
        Code.DEFINE_CYCLE,
        2,
        10,
        (),
    ),
    ('model ( pose "here" )', Code.WRONG_TYPE, 1, 14, ("tuple",)),
    ("model ( name [ ] )", Code.WRONG_TYPE, 1, 14, ("string",)),
    ("model ( obstacle_return [ ] )", Code.WRONG_TYPE, 1, 25, ("number",)),
    ("model ( pose [ 0 [ 0 ] 0 0 ] )", Code.WRONG_TYPE, 1, 18, ("number",)),
    ("model ( pose [ 0 0 ] )", Code.WRONG_COUNT, 1, 14, ("3", "4")),
    ("model ( size [ 1 ] )", Code.WRONG_COUNT, 1, 14, ("2", "3")),
    ("position ( wheelbase [ ] )", Code.WRONG_TYPE, 1, 22, ("number",)),
    ("ranger ( sensor ( fov [ ] ) )", Code.WRONG_TYPE, 1, 23, ("number",)),
    ("ranger ( sensor ( samples [ ] ) )", Code.WRONG_TYPE, 1, 27, ("number",)),
    ("blobfinder ( image 5 )", Code.WRONG_TYPE, 1, 20, ("tuple",)),
    ("gripper ( paddle_size 5 )", Code.WRONG_TYPE, 1, 23, ("tuple",)),
    ("position ( odom_error 5 )", Code.WRONG_TYPE, 1, 23, ("tuple",)),
    ("position ( velocity_bounds 5 )", Code.WRONG_TYPE, 1, 28, ("tuple",)),
    ("ranger ( sensor ( noise 5 ) )", Code.WRONG_TYPE, 1, 25, ("tuple",)),
    ("camera ( pantilt 5 )", Code.WRONG_TYPE, 1, 18, ("tuple",)),
    ("scatter [ 1 ]", Code.WRONG_COUNT, 1, 9, ("4",)),
    ("scatter [ 1 2 3 [ 4 ] ]", Code.WRONG_TYPE, 1, 17, ("number",)),
    ("scatter 5", Code.WRONG_TYPE, 1, 9, ("tuple",)),
    ("model ( pose [ 1e7 0 0 0 ] )", Code.OUT_OF_RANGE, 1, 16, ()),
    ("ranger ( sensor ( range 5 ) )", Code.WRONG_TYPE, 1, 25, ("tuple",)),
    ("ranger ( sensor ( range [ 5 ] ) )", Code.WRONG_COUNT, 1, 25, ("2",)),
    ("model ( block ( ) )", Code.TOO_FEW_POINTS, 1, 9, ("2",)),
    ("model ( block ( points 1 ) )", Code.TOO_FEW_POINTS, 1, 9, ("2",)),
    ("model ( block ( points 1e9 ) )", Code.TOO_FEW_POINTS, 1, 9, ("2",)),
    ('include "nowhere.inc"', Code.FILE_NOT_FOUND, 1, 9, ()),
    ('model ( bitmap "nowhere.png" )', Code.BITMAP_NOT_FOUND, 1, 16, ()),
]


@pytest.mark.parametrize(("text", "code", "line", "column", "expected"), BROKEN)
def test_a_mistake_is_reported_at_its_place(
    text: str, code: Code, line: int, column: int, expected: tuple[str, ...]
) -> None:
    with pytest.raises(WorldError) as caught:
        load_text(text, Path("broken.world"))

    mistake = caught.value
    assert (mistake.code, mistake.file) == (code, "broken.world")
    assert (mistake.line, mistake.column, mistake.expected) == (line, column, expected)


def test_an_unknown_type_names_the_nearest() -> None:
    with pytest.raises(WorldError) as caught:
        load_text("define armchair model ( )\narmchiar ( )", Path("x.world"))

    assert caught.value.details == {"found": "armchiar", "nearest": "armchair"}


def test_a_thing_may_stand_on_one_of_its_kind() -> None:
    scene = load_text("define a model ( )\ndefine b a ( a ( a ( ) ) )\na ( b ( a ( ) ) )", Path("x.world"))

    assert len(scene.models) == 5


def test_a_mistake_in_an_included_file_names_that_file(tmp_path: Path) -> None:
    (tmp_path / "parts.inc").write_text("define chair model (\n  size 3\n)\n")
    (tmp_path / "top.world").write_text('include "parts.inc"\nchair ( )\n')

    with pytest.raises(WorldError) as caught:
        load_world(tmp_path / "top.world")

    assert Path(caught.value.file).name == "parts.inc"
    assert (caught.value.line, caught.value.column) == (2, 8)


def test_a_missing_world_is_reported() -> None:
    with pytest.raises(WorldError) as caught:
        load_world(Path("there/is/none.world"))

    assert caught.value.code is Code.FILE_NOT_FOUND


def test_a_folder_is_no_world(tmp_path: Path) -> None:
    with pytest.raises(WorldError) as caught:
        load_world(tmp_path)

    assert caught.value.code is Code.IS_FOLDER


def test_files_that_include_each_other_are_reported_at_the_second_include(tmp_path: Path) -> None:
    (tmp_path / "a.inc").write_text('include "b.inc"')
    (tmp_path / "b.inc").write_text('\n include "a.inc"')

    with pytest.raises(WorldError) as caught:
        load_text('include "a.inc"', tmp_path / "top.world")

    mistake = caught.value
    assert (mistake.code, Path(mistake.file).name) == (Code.INCLUDE_CYCLE, "b.inc")
    assert mistake.details == {"path": "a.inc"}
    assert (mistake.line, mistake.column) == (2, 10)


def test_includes_and_bitmaps_from_outside_are_refused(tmp_path: Path) -> None:
    (tmp_path / "secret.inc").write_text("model ( )")
    inner = tmp_path / "worlds"
    inner.mkdir()
    (inner / "link.inc").symlink_to(tmp_path / "secret.inc")
    refused = {
        'include "../secret.inc"': Code.INCLUDE_OUTSIDE,
        f'include "{tmp_path}/secret.inc"': Code.INCLUDE_OUTSIDE,
        'include "link.inc"': Code.INCLUDE_OUTSIDE,
        'model ( bitmap "../secret.inc" )': Code.BITMAP_OUTSIDE,
    }

    for text, code in refused.items():
        with pytest.raises(WorldError) as caught:
            load_text(text, inner / "top.world")
        named = {"path": text.split('"')[1], "folder": str(tmp_path)}
        assert (caught.value.code, caught.value.details) == (code, named)

    allowed = load_text('include "../secret.inc"', inner / "top.world", allowed=(tmp_path,))
    assert len(allowed.models) == 1


def test_a_chain_of_macros_that_explodes_is_refused_soon() -> None:
    bomb = "define m0 model ( )\n" + "".join(
        f"define m{i} model ( {f'm{i - 1}( ) ' * 10})\n" for i in range(1, 12)
    )

    with pytest.raises(WorldError) as caught:
        load_text(bomb + "m11( )", Path("bomb.world"))

    assert caught.value.code is Code.TOO_MUCH


def test_an_include_bomb_is_refused_soon(tmp_path: Path) -> None:
    for i in range(12):
        (tmp_path / f"{i}.inc").write_text(f'include "{i + 1}.inc"\n' * 10)
    (tmp_path / "12.inc").write_text("model ( )")

    with pytest.raises(WorldError) as caught:
        load_text('include "0.inc"', tmp_path / "top.world")

    assert caught.value.code is Code.TOO_MANY_FILES


def test_includes_lead_sixteen_files_deep_at_most(tmp_path: Path) -> None:
    for i in range(1, 18):
        (tmp_path / f"{i}.inc").write_text(f'\n include "{i - 1}.inc"')
    (tmp_path / "0.inc").write_text("model ( )")

    assert len(load_text('include "15.inc"', tmp_path / "top.world").models) == 1
    with pytest.raises(WorldError) as caught:
        load_text('include "16.inc"', tmp_path / "top.world")

    error = caught.value
    assert (error.code, error.details) == (Code.INCLUDE_TOO_DEEP, {"limit": 16})
    assert (Path(error.file).name, error.line, error.column) == ("1.inc", 2, 10)


def test_a_world_has_two_hundred_files_at_most(tmp_path: Path) -> None:
    (tmp_path / "a.inc").write_text("# nothing")
    include = 'include "a.inc"\n'

    assert len(load_text(include * 199, tmp_path / "top.world").report.files) == 2
    with pytest.raises(WorldError) as caught:
        load_text(include * 200, tmp_path / "top.world")

    error = caught.value
    assert (error.code, error.line, error.details) == (Code.TOO_MANY_FILES, 200, {"limit": 200})


def test_the_files_of_a_world_have_sixty_thousand_words_at_most() -> None:
    words = WordCount()
    words.take("define " * 30_000, "a.world")
    words.take("( # and not these words\n" * 30_000, "a.inc")

    with pytest.raises(WorldError) as caught:
        words.take("\n  one", "b.inc")
    error = caught.value
    assert (error.code, error.details) == (Code.TOO_MUCH, {"what": "words", "limit": 60_000})
    assert (error.file, error.line, error.column) == ("b.inc", 2, 3)

    with pytest.raises(WorldError) as caught:
        load_text("x " * 60_001, Path("x.world"))
    assert caught.value.code is Code.TOO_MUCH


def test_the_shapes_of_a_world_have_two_hundred_thousand_corners_at_most() -> None:
    """Those of the first model have as many."""
    text = f"define it block ( points 2000 )\nmodel ( {'it ( ) ' * 100} )\nmodel ( block ( points 2 ) )"

    with pytest.raises(WorldError) as caught:
        load_text(text, Path("x.world"))

    error = caught.value
    assert (error.code, error.line, error.details) == (Code.TOO_MUCH, 3, {"what": "points", "limit": 200_000})


def test_a_file_has_eight_million_bytes_at_most(tmp_path: Path) -> None:
    file = tmp_path / "large.world"
    file.write_bytes(b"#" * 8_000_000)
    assert load_world(file).models == ()

    file.write_bytes(b"#" * 8_000_001)
    with pytest.raises(WorldError) as caught:
        load_world(file)
    error = caught.value
    assert (error.code, error.details) == (Code.FILE_TOO_LARGE, {"path": str(file), "limit": 8_000_000})


def test_a_file_that_is_no_picture_is_reported(tmp_path: Path) -> None:
    (tmp_path / "plan.png").write_bytes(b"\x89PNG\r\n\x1a\n but not really")

    with pytest.raises(WorldError) as caught:
        load_text('model ( bitmap "plan.png" )', tmp_path / "top.world")

    assert caught.value.code is Code.BITMAP_UNREADABLE
    assert "PNG" in caught.value.expected


@pytest.mark.parametrize(
    ("text", "code", "details"),
    [
        ("a (", Code.UNCLOSED, {"found": "("}),
        ("size [ [ 1 ]", Code.UNCLOSED, {"found": "["}),
        (")", Code.UNEXPECTED, {"found": ")"}),
        ("model ( pose " + "a" * 70 + " )", Code.UNEXPECTED, {"found": "a" * 60}),
        ("model ? ( )", Code.UNKNOWN_CHARACTER, {"found": "?"}),
        ("size [ -x ]", Code.UNKNOWN_CHARACTER, {"found": "-"}),
        ("size [ +5x ]", Code.BAD_NUMBER, {"found": "+5x"}),
        ("size [ .5x ]", Code.BAD_NUMBER, {"found": ".5x"}),
        ("size [ 5" + "x" * 50 + " ]", Code.BAD_NUMBER, {"found": "5" + "x" * 39}),
        ("size [ 5x-1.y+2 ]", Code.BAD_NUMBER, {"found": "5x-1.y+2"}),
        ("// a", Code.COMMENT_SIGN, {"found": "//"}),
        ("/* a", Code.COMMENT_SIGN, {"found": "/*"}),
        (";; a", Code.COMMENT_SIGN, {"found": ";;"}),
        ("-- a", Code.COMMENT_SIGN, {"found": "--"}),
        ("; a", Code.UNKNOWN_CHARACTER, {"found": ";"}),
        ("speedup 1e13", Code.NUMBER_TOO_LARGE, {"found": "1e13", "limit": 1e12}),
        ("speedup 9" + "9" * 50, Code.NUMBER_TOO_LARGE, {"found": "9" * 40, "limit": 1e12}),
        ("speedup -2e12", Code.NUMBER_TOO_LARGE, {"found": "-2e12", "limit": 1e12}),
        ("model ( " * 65, Code.NESTED_TOO_DEEP, {"limit": 64}),
        ("model ( pose include )", Code.MISPLACED, {"found": "include"}),
        ("model ( define x model ( ) )", Code.MISPLACED, {"found": "define"}),
        ("define a a ( )\na ( )", Code.DEFINE_CYCLE, {"found": "a"}),
        ("qwerty ( )", Code.UNKNOWN_TYPE, {"found": "qwerty", "nearest": ""}),
        ("laser ( )", Code.UNKNOWN_TYPE, {"found": "laser", "nearest": "ranger"}),
        ("q" * 70 + " ( )", Code.UNKNOWN_TYPE, {"found": "q" * 60, "nearest": ""}),
        ('include "qwerty.inc"', Code.FILE_NOT_FOUND, {"path": "qwerty.inc", "nearest": ""}),
        (f'include "{"q" * 250}.inc"', Code.FILE_NOT_FOUND, {"path": "q" * 200, "nearest": ""}),
        ('model ( bitmap "qwerty.png" )', Code.BITMAP_NOT_FOUND, {"path": "qwerty.png"}),
        (f'model ( bitmap "{"q" * 250}" )', Code.BITMAP_NOT_FOUND, {"path": "q" * 200}),
        ('model ( pose "here" )', Code.WRONG_TYPE, {"name": "pose"}),
        ("model ( point[0] 5 )", Code.WRONG_TYPE, {"name": "point"}),
        ("model ( name [ ] )", Code.WRONG_TYPE, {"name": "name"}),
        ("model ( name [ [ 1 ] ] )", Code.WRONG_TYPE, {"name": "name"}),
        ("model ( pose [ 0 [ 0 ] 0 0 ] )", Code.WRONG_TYPE, {"name": "pose"}),
        ("model ( pose [ 0 0 ] )", Code.WRONG_COUNT, {"name": "pose", "given": 2}),
        ("model ( pose [ 1e7 0 0 0 ] )", Code.OUT_OF_RANGE, {"name": "pose", "limit": 1e5}),
        ("bumper ( bcount -1 )", Code.OUT_OF_RANGE, {"name": "bcount", "limit": 1000}),
    ],
)
def test_a_mistake_says_what_it_found_and_what_may_be(
    text: str, code: Code, details: dict[str, object]
) -> None:
    with pytest.raises(WorldError) as caught:
        load_text(text, Path("broken.world"))

    assert (caught.value.code, dict(caught.value.details)) == (code, details)
    assert str(caught.value).startswith("broken.world:1:" if "\n" not in text else "broken.world:")


@pytest.mark.parametrize(
    "text", ["speedup 1e12", "speedup -1e12", "model ( " * 64 + ") " * 64, "x " + "[ " * 64 + "] " * 64]
)
def test_the_largest_number_and_the_deepest_brackets_are_read(text: str) -> None:
    load_text(text, Path("large.world"))


def test_a_mistake_within_a_file_that_a_body_includes_names_that_file(tmp_path: Path) -> None:
    (tmp_path / "a.inc").write_text("\n define x model ( )")
    (tmp_path / "b.inc").write_text('color "red" include "a.inc"')
    for text in ('model ( include "a.inc" )', 'model ( model ( include "b.inc" ) )'):
        with pytest.raises(WorldError) as caught:
            load_text(text, tmp_path / "top.world")

        error = caught.value
        assert (error.code, Path(error.file).name, error.line, error.column) == (
            Code.MISPLACED,
            "a.inc",
            2,
            2,
        )
        assert error.details == {"found": "define"}


def test_the_entities_of_a_world_have_a_limit() -> None:
    with pytest.raises(WorldError) as caught:
        load_text(
            f"define m0 model ( )\ndefine m1 model ( {'m0 ( ) ' * 200})\n" + "m1 ( ) " * 200, Path("x.world")
        )

    assert (caught.value.code, caught.value.details) == (Code.TOO_MUCH, {"what": "entities", "limit": 40_000})


def test_a_world_that_is_not_there_is_reported_with_a_near_one(tmp_path: Path) -> None:
    (tmp_path / "garden.world").write_text("")
    (tmp_path / "office.world").write_text("")
    found = []
    for path in (tmp_path / "gardn.world", tmp_path / "qwerty.world", tmp_path):
        with pytest.raises(WorldError) as caught:
            load_world(path)
        assert (caught.value.file, caught.value.details["path"]) == (str(path), str(path))
        found.append(caught.value.details["nearest"])

    garden = str(tmp_path / "garden.world")
    assert found == [garden, "", garden]


def test_a_link_to_itself_is_reported_where_it_is_named(tmp_path: Path) -> None:
    for name in ("loop.inc", "loop.world"):
        (tmp_path / name).symlink_to(name)
    (tmp_path / "top.world").write_text('\n include "loop.inc"')
    found = []
    for path in (tmp_path / "top.world", tmp_path / "loop.world"):
        with pytest.raises(WorldError) as caught:
            load_world(path)
        error = caught.value
        assert (error.code, error.details["reason"]) == (Code.FILE_UNREADABLE, os.strerror(errno.ELOOP))
        found.append((Path(error.file).name, error.line, error.column, Path(str(error.details["path"])).name))

    assert found == [("top.world", 2, 10, "loop.inc"), ("loop.world", 1, 1, "loop.world")]


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_lines_may_end_as_on_any_system(end: str, tmp_path: Path) -> None:
    (tmp_path / "top.world").write_bytes(f"model ( )  # a comment{end}{end}  model ( x ? )".encode())
    with pytest.raises(WorldError) as caught:
        load_world(tmp_path / "top.world")

    assert (caught.value.line, caught.value.column) == (3, 13)


def test_macros_nest_models_sixty_four_deep_at_most() -> None:
    def nested(depth: int) -> str:
        defined = "".join(f"define m{at} model ( m{at - 1}( ) )\n" for at in range(1, depth + 1))
        return f"define m0 model ( )\n{defined}m{depth} ( )"

    assert len(load_text(nested(64), Path("x.world")).models) == 65
    with pytest.raises(WorldError) as caught:
        load_text(nested(65), Path("x.world"))
    assert (caught.value.code, caught.value.line, caught.value.details) == (
        Code.NESTED_TOO_DEEP,
        2,
        {"limit": 64},
    )


def test_only_what_follows_an_include_on_its_line_is_remarked(tmp_path: Path) -> None:
    (tmp_path / "a.inc").write_text("# nothing")
    text = f'include "a.inc"\ninclude "a.inc" ; {"x" * 70}\n'
    notes = load_text(text, tmp_path / "top.world").report.notes

    assert [(each.line, each.column, each.details) for each in notes if each.code == "include-rest"] == [
        (2, 9, {"found": "; " + "x" * 58}),
    ]
