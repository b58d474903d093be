"""Slips of beginners in world files: the message offers what was probably meant."""

import os
from pathlib import Path

import pytest

from donnie_tui.i18n.mistakes import world_note
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.world.loading import choose_world
from sim.worldfile.mistakes import defining, near_file, near_name

DONNIE = 'include "donnie.inc"\ndonnie( )\n'
REPORTS = {
    'include "donie.inc"': "There is no file donie.inc. Did you mean donnie.inc?",
    'include "pupils.inc"': "There is no file pupils.inc. Did you mean pupil.inc?",
    'include "qwerty.inc"': "There is no file qwerty.inc.",
    "donnie( )": 'I do not know the model donnie. It is in donnie.inc: write include "donnie.inc" above.',
    "desk( )": 'I do not know the model desk. It is in pupil.inc: write include "pupil.inc" above.',
    DONNIE + 'include "furniture.inc" sofa( )': "I do not know the model sofa. Did you mean large_sofa?",
    DONNIE + "modle( )": "I do not know the model modle. Did you mean model?",
    DONNIE + "qwerty( )": "I do not know the model qwerty.",
    DONNIE + "// the room": "A comment begins with #, not with //.",
    "/* the room */": "A comment begins with #, not with /*.",
    "model( / )": "I can't use a slash here.",
}


def report(path: Path) -> str:
    with pytest.raises(Unusable) as caught:
        choose_world(str(path), Words())
    return caught.value.sentence


@pytest.mark.parametrize("text", REPORTS, ids=range(len(REPORTS)))
def test_a_slip_is_reported_with_what_was_meant(tmp_path: Path, text: str) -> None:
    (tmp_path / "pupil.inc").write_text("define desk model ( )")
    (tmp_path / "folder.inc").mkdir()
    world = tmp_path / "my.world"
    world.write_text(text)

    assert report(world).split(": ", 1)[1] == REPORTS[text]


@pytest.mark.parametrize(
    ("name", "known", "nearest"),
    [
        ("chiar", ("chair", "table"), "chair"),
        ("sofa", ("large_sofa", "small_sofa"), "large_sofa"),
        ("sofa", ("large_sofa", "sofas"), "sofas"),
        ("abcdefgxyz", ("abcdefguvw",), "abcdefguvw"),  # 7 of 10 letters
        ("abcdefgxyz1", ("abcdefguvw2",), ""),
        ("a" * 59, ("a" * 58,), "a" * 58),
        ("a" * 60, ("a" * 59,), ""),
        ("", ("", "_"), ""),
        ("x", (), ""),
    ],
)
def test_a_name_is_near_if_it_is_alike_or_has_it_as_a_part(
    name: str, known: tuple[str, ...], nearest: str
) -> None:
    assert near_name(name, known) == nearest


def test_the_file_that_defines_a_model_is_the_first_of_the_first_folder(tmp_path: Path) -> None:
    first, second = tmp_path / "first", tmp_path / "second"
    first.mkdir()
    second.mkdir()
    (first / "b.inc").write_text("\n \tdefine desk model ( )")
    (first / "c.inc").write_text("define desk model ( )")
    (first / "a.inc").write_text(
        "# define desk model ( )\ndefine desks model ( )\ndefine a desk ( )\ndefine axb model ( )"
    )
    (first / "a.world").write_text("define desk model ( ) define lamp model ( )")
    (second / "a.inc").write_text("define desk model ( )\ndefine  lamp model ( )")
    (second / "z.inc").write_text("#" * 199_985 + "\ndefine a.b model ( )\ndefine cab model ( )")

    names = ("desk", "lamp", "a.b", "chair", "cab")
    assert [defining(each, (first, second)) for each in names] == ["b.inc", "a.inc", "z.inc", "", ""]
    assert near_file("some/where/zz.inc", (first, second)) == ""
    assert near_file("some/where/bb.inc", (first, second)) == ""
    assert defining("desk", (tmp_path / "none", second, first)) == "a.inc"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
def test_a_named_pipe_is_neither_read_nor_offered_as_what_was_meant(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "fifo.inc")
    os.mkfifo(tmp_path / "fifo.world")
    world = tmp_path / "my.world"

    for included, message in (
        ("fifo.inc", "fifo.inc is not an ordinary file."),
        ("fifos.inc", "There is no file fifos.inc."),
    ):
        world.write_text(f'include "{included}"')
        assert report(world).split(": ", 1)[1] == message
    world.write_text('model( bitmap "fifo.inc" )')
    assert report(world).split(": ", 1)[1] == "fifo.inc is not an ordinary file."
    assert report(tmp_path / "fifo.world") == f"{tmp_path / 'fifo.world'} is not an ordinary file."
    assert report(tmp_path / "fifos.world") == f"There is no file {tmp_path / 'fifos.world'}."


def test_a_folder_is_not_a_world_but_may_contain_one(tmp_path: Path) -> None:
    assert report(tmp_path) == f"{tmp_path} is a folder, not a world file."
    (tmp_path / "b.world").write_text(DONNIE)
    (tmp_path / "a.world").write_text(DONNIE)

    assert (
        report(tmp_path) == f"{tmp_path} is a folder, not a world file. Did you mean {tmp_path / 'a.world'}?"
    )


def test_a_misspelt_file_name_is_reported_with_the_nearest_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "sala.world").write_text(DONNIE)
    monkeypatch.chdir(tmp_path)

    assert report(Path("sala")) == "There is no world sala. Did you mean sala.world?"
    assert report(Path("salla.world")) == "There is no file salla.world. Did you mean sala.world?"
    assert report(tmp_path / "Sala.wrld").endswith(f"Did you mean {tmp_path / 'sala.world'}?")


def test_a_colour_in_another_language_is_reported_with_the_word_to_write(tmp_path: Path) -> None:
    world = tmp_path / "my.world"
    world.write_text(DONNIE + 'include "things.inc"\nbox( pose [ 1 1 0 0 ] color "amarelo" )\n')
    notes = choose_world(str(world), Words()).scene.report.notes

    assert any("Did you mean yellow?" in world_note(each, Words()) for each in notes)
