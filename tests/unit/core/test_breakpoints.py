"""Breakpoints move with the lines of their program and return at the next start."""

from pathlib import Path

import pytest

from donnie_tui.core.document import Document
from donnie_tui.core.editing import followed
from donnie_tui.core.program_files import BreakpointFile


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "state" / "breakpoints.txt"


def test_each_program_keeps_its_breakpoints_from_one_start_to_the_next(file: Path, tmp_path: Path) -> None:
    BreakpointFile(str(file)).write(tmp_path / "a.gd", {3, 1})
    BreakpointFile(str(file)).write(tmp_path / "b.gd", {2})

    assert BreakpointFile(str(file)).read(tmp_path / "a.gd", 9) == {1, 3}
    assert BreakpointFile(str(file)).read(tmp_path / "x" / ".." / "b.gd", 9) == {2}
    assert BreakpointFile(str(file)).read(tmp_path / "c.gd", 9) == frozenset()
    assert BreakpointFile(str(file)).read(None, 9) == frozenset()


def test_breakpoints_after_the_end_of_a_shorter_text_are_dropped(file: Path, tmp_path: Path) -> None:
    BreakpointFile(str(file)).write(tmp_path / "a.gd", {1, 5})

    assert BreakpointFile(str(file)).read(tmp_path / "a.gd", 4) == {1}


def test_a_program_without_breakpoints_leaves_no_trace(file: Path, tmp_path: Path) -> None:
    kept = BreakpointFile(str(file))
    kept.write(tmp_path / "a.gd", {1})
    kept.write(tmp_path / "a.gd", ())

    assert file.read_text() == ""


@pytest.mark.parametrize("damage", [b"\xff\x00", b"x\ty\n", b"\t\n3 -4\t/a\n", b"1" * 500_000])
def test_a_damaged_file_is_treated_as_no_file(file: Path, tmp_path: Path, damage: bytes) -> None:
    file.parent.mkdir()
    file.write_bytes(damage)
    kept = BreakpointFile(str(file))

    assert kept.read(tmp_path / "a.gd", 9) == frozenset()
    kept.write(tmp_path / "a.gd", {1})
    assert kept.read(tmp_path / "a.gd", 9) == {1}


def test_a_file_that_cannot_be_written_is_ignored(tmp_path: Path) -> None:
    (tmp_path / "state").write_text("a file")

    BreakpointFile(str(tmp_path / "state" / "breakpoints.txt")).write(tmp_path / "a.gd", {1})


def test_the_file_stays_small(file: Path, tmp_path: Path) -> None:
    kept = BreakpointFile(str(file))
    for number in range(205):
        kept.write(tmp_path / f"{number}.gd", range(1, 1000))

    assert len(file.read_text().splitlines()) == 200
    assert file.stat().st_size < BreakpointFile.LARGEST


def test_the_difference_of_two_texts_moves_the_breakpoints() -> None:
    assert followed({1, 3}, ["a", "b", "c"], ["a", "x", "b", "c"]) == {1, 4}
    assert followed({2, 3}, ["a", "b", "c"], ["a", "c"]) == {2}


def test_breakpoints_of_a_typed_program_move_with_their_lines() -> None:
    program = Document()
    program.replace("a\nb\nc\nd\n", None)
    program.breakpoints = frozenset({1, 3})

    program.insert(1, "x")
    assert program.breakpoints == {2, 4}
    program.delete(1, 2)
    assert program.breakpoints == {2}
    program.undo()
    assert program.breakpoints == {4}
    program.replace("new\n", None)
    assert program.breakpoints == frozenset()
