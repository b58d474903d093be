"""Copies of what is not saved: each with the name of its file, the last one wanted is what is there."""

from pathlib import Path

from donnie_tui.core.copies import Copies


def test_a_copy_knows_its_file_and_holds_the_text_to_the_letter(tmp_path: Path) -> None:
    text = "\n-- mine\nFW 1"
    Copies(tmp_path).keep(text, tmp_path / "walk.gd")
    found = Copies(tmp_path).read(next(tmp_path.glob("*.gd")))
    assert (found.text, found.path) == (text, tmp_path / "walk.gd")


def test_a_text_that_looks_like_a_copy_comes_back_whole(tmp_path: Path) -> None:
    text = "-- What was not saved of the file: /tmp/other.gd\nFW 1"
    Copies(tmp_path).keep(text)
    found = Copies(tmp_path).read(next(tmp_path.glob("*.gd")))
    assert (found.text, found.path) == (text, None)


def test_what_is_wanted_last_is_there_and_nothing_else(tmp_path: Path) -> None:
    copies = Copies(tmp_path)
    copies.want("FW 1")
    copies.want("FW 2")
    assert not list(tmp_path.iterdir())
    copies.settle()
    assert [each.read_text() for each in tmp_path.iterdir()] == ["FW 2"]
    copies.want("FW 3")
    copies.want_none()
    copies.settle()
    assert not list(tmp_path.iterdir())


def test_the_copy_of_another_program_of_the_same_start_is_not_offered(tmp_path: Path) -> None:
    first = Copies(tmp_path)
    second = first.another()
    first.keep("FW 1")
    second.keep("FW 2")
    assert first.offered() is None
    assert second.offered() is None
