"""The sentences about world files, with the place: why a file can't be used, and remarks."""

from pathlib import Path

import pytest

from donnie_tui.i18n.mistakes import world_mistake, world_note
from donnie_tui.i18n.words import Words
from language.locales import languages
from sim.scene import Note, NoteKind
from sim.worldfile import WorldError, load_text, load_world
from sim.worldfile.mistakes import Code


def sentence_of(text: str, language: str = "en") -> str:
    with pytest.raises(WorldError) as caught:
        load_text(text, Path("maze.world"))
    return world_mistake(caught.value, Words(language))


def test_a_mistake_has_its_file_line_and_column() -> None:
    assert sentence_of('model( size "big" )').startswith("Error, maze.world, line 1, column ")


def test_a_misspelt_model_gets_the_nearest_name() -> None:
    assert sentence_of("modle()").endswith("I do not know the model modle. Did you mean model?")


EXPECTED = {
    "ranger( sensor( range 5 ) )": "range takes values in brackets.",
    "model( pose [ 0 5cm 0 0 ] )": "5cm is not a number.",
    "model( )\n-- note": "A comment begins with #, not with --.",
    "position( laser() )": "I do not know the model laser. Did you mean ranger?",
    "model( block( points 1 ) )": "A block needs 2 to 2000 points, not 1.",
    "model( \x07 )": "I can't use a control character here.",
    "\x1b[2J": "I can't use a control character here.",
    '"\x00\x9b2J"': "I expected end of file, define, include or a name, not   2J.",
}


@pytest.mark.parametrize("text", EXPECTED)
def test_a_mistake_says_what_was_expected(text: str) -> None:
    assert sentence_of(text).split(": ", 1)[1] == EXPECTED[text]


def test_the_message_about_a_wrong_picture_lists_the_possible_kinds(tmp_path: Path) -> None:
    (tmp_path / "plan.png").write_text("no picture")
    with pytest.raises(WorldError) as caught:
        load_text('model ( bitmap "plan.png" )', tmp_path / "top.world")

    assert "PNG, JPEG, " in world_mistake(caught.value, Words("en"))


def test_a_mistake_has_a_sentence_in_each_language() -> None:
    sentences = {sentence_of("model(", language) for language in languages()}

    assert len(sentences) == len(languages())


def test_a_file_that_does_not_exist_has_no_place(tmp_path: Path) -> None:
    with pytest.raises(WorldError) as caught:
        load_world(tmp_path / "no.world")

    assert world_mistake(caught.value, Words("en")) == f"There is no file {tmp_path / 'no.world'}."


@pytest.mark.parametrize("code", Code, ids=lambda code: code.value)
@pytest.mark.parametrize("language", languages())
def test_a_mistake_without_details_has_a_sentence(code: Code, language: str) -> None:
    assert world_mistake(WorldError(code, "a.world"), Words(language))


NOTES = {
    "unknown-property": {"name": "colr", "nearest": "color"},
    "unused-property": {"name": "mass"},
    "not-simulated": {"name": "arm", "type": "gripper"},
    "second-define": {"name": "wall"},
    "starts-inside": {"name": "Ana", "thing": "box a"},
    "unknown-colour": {"name": "gren", "nearest": "green"},
    "random-colour": {},
    "lone-sensor": {"name": "sonar"},
    "walls-made-solid": {"name": "wall"},
    "not-utf8": {"path": "a.world"},
    "margin-cropped": {"path": "cave.png"},
    "no-robot": {},
}


@pytest.mark.parametrize("code", NOTES)
@pytest.mark.parametrize("language", languages())
def test_every_remark_of_a_load_report_has_a_sentence(code: str, language: str) -> None:
    note = Note(NoteKind.WARNING, code, "folder/a.world", 3, 1, NOTES[code])

    sentence = world_note(note, Words(language))

    assert "a.world" in sentence
    assert sentence.endswith(".") or sentence.endswith("?")


def test_a_remark_offers_another_name_only_where_there_is_one() -> None:
    note = Note(NoteKind.WARNING, "unknown-colour", "a.world", 3, 1, {"name": "xyzzy"})
    near = Note(NoteKind.WARNING, "unknown-colour", "a.world", 3, 1, NOTES["unknown-colour"])

    assert "Did you mean" not in world_note(note, Words("en"))
    assert "Did you mean green?" in world_note(near, Words("en"))


@pytest.mark.parametrize(
    ("code", "expected", "details", "sentence"),
    [
        (Code.WRONG_COUNT, (), {"name": "pose", "given": 9}, "pose has too many values, 9."),
        (Code.WRONG_COUNT, ("2",), {"name": "pose", "given": 9}, "pose takes 2 values, not 9."),
        (Code.UNEXPECTED, (), {"found": "x"}, "I did not expect x here."),
        (Code.UNEXPECTED, ("a", "b", "c", "d"), {"found": "x"}, "I expected a, b, c or d, not x."),
        (Code.UNEXPECTED, ("a", "b", "c", "d", "e"), {"found": "x"}, "I did not expect x here."),
        (
            Code.UNEXPECTED,
            (")", "name"),
            {"found": "("},
            "I expected a closing parenthesis or a name, not an opening parenthesis.",
        ),
        (Code.UNEXPECTED, ("a",), {}, "I need a at the end."),
        (Code.TOO_MUCH, (), {"limit": 7}, "The world is too large, at most 7 parts."),
        (
            Code.TOO_MUCH,
            (),
            {"what": "words", "limit": 70_000},
            "The files of the world have more than 70 000 words.",
        ),
    ],
)
def test_the_sentence_depends_on_what_is_known(
    code: Code, expected: tuple[str, ...], details: dict[str, str | int | float], sentence: str
) -> None:
    said = world_mistake(WorldError(code, "a.world", 3, 4, expected, **details), Words())

    assert said == f"Error, a.world, line 3, column 4: {sentence}"


@pytest.mark.parametrize("code", [Code.INCLUDE_OUTSIDE, Code.BITMAP_OUTSIDE])
def test_a_file_outside_is_named_with_the_folder_that_would_be_allowed_if_there_is_one(code: Code) -> None:
    named, confined = (
        world_mistake(WorldError(code, "a.world", path="b.inc", **details), Words())
        for details in ({"folder": "/lab"}, {"folder": ""})
    )

    assert named.endswith(Words()(f"world-{code.value}", path="b.inc", folder="/lab"))
    assert confined.endswith(Words()(f"world-{code.value}-confined", path="b.inc"))


@pytest.mark.parametrize(
    ("code", "path", "has_place"),
    [
        (Code.FILE_NOT_FOUND, "a.world", False),
        (Code.FILE_NOT_FOUND, "b.inc", True),
        (Code.IS_FOLDER, "a.world", False),
        (Code.NO_FILE, "a.world", False),
        (Code.FILE_UNREADABLE, "a.world", False),
        (Code.FILE_TOO_LARGE, "a.world", False),
        (Code.BITMAP_NOT_FOUND, "a.world", True),
    ],
)
def test_a_mistake_about_the_whole_world_has_no_place(code: Code, path: str, has_place: bool) -> None:
    said = world_mistake(WorldError(code, "a.world", path=path, limit=1, reason="odd"), Words())

    assert said.startswith("Error, a.world, line 1, column 1: ") is has_place


def test_a_remark_has_its_place_if_it_has_a_line() -> None:
    words, details = Words(), {"name": "vermelho"}
    red = Note(NoteKind.WARNING, "unknown-colour", "folder/a.world", 3, 2, details)
    nowhere = Note(NoteKind.WARNING, "no-robot", "a.world", 0, 0, {})

    assert world_note(red, words).startswith("Line 3, column 2, of a.world: ")
    assert "Did you mean red?" in world_note(red, words)  # as world files are English
    assert world_note(nowhere, words) == words("note-no-robot")


def test_only_a_colour_is_offered_in_english() -> None:
    colr = Note(
        NoteKind.WARNING, "unknown-property", "a.world", 3, 2, {"name": "vermelho", "nearest": "color"}
    )

    assert "Did you mean color?" in world_note(colr, Words())
