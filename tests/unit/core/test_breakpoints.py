"""Breakpoints go with the lines of their program, and are there again at the next start."""

from pathlib import Path

import pytest

from donnie_tui.core.breakpoints import LARGEST, MOST_PROGRAMS, KeptBreakpoints, followed
from donnie_tui.core.typed_program import TypedProgram


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "state" / "breakpoints.txt"


def test_each_program_has_its_own_from_one_start_to_the_next(file: Path, tmp_path: Path) -> None:
    KeptBreakpoints(str(file)).keep(tmp_path / "a.gd", {3, 1})
    KeptBreakpoints(str(file)).keep(tmp_path / "b.gd", {2})

    assert KeptBreakpoints(str(file)).of(tmp_path / "a.gd", 9) == {1, 3}
    assert KeptBreakpoints(str(file)).of(tmp_path / "x" / ".." / "b.gd", 9) == {2}
    assert KeptBreakpoints(str(file)).of(tmp_path / "c.gd", 9) == frozenset()
    assert KeptBreakpoints(str(file)).of(None, 9) == frozenset()


def test_those_behind_the_end_of_a_shorter_text_are_forgotten(file: Path, tmp_path: Path) -> None:
    KeptBreakpoints(str(file)).keep(tmp_path / "a.gd", {1, 5})

    assert KeptBreakpoints(str(file)).of(tmp_path / "a.gd", 4) == {1}


def test_a_program_without_any_leaves_no_trace(file: Path, tmp_path: Path) -> None:
    kept = KeptBreakpoints(str(file))
    kept.keep(tmp_path / "a.gd", {1})
    kept.keep(tmp_path / "a.gd", ())

    assert file.read_text() == ""


@pytest.mark.parametrize("damage", [b"\xff\x00", b"x\ty\n", b"\t\n3 -4\t/a\n", b"1" * (LARGEST + 1)])
def test_a_damaged_file_is_as_good_as_none(file: Path, tmp_path: Path, damage: bytes) -> None:
    file.parent.mkdir()
    file.write_bytes(damage)
    kept = KeptBreakpoints(str(file))

    assert kept.of(tmp_path / "a.gd", 9) == frozenset()
    kept.keep(tmp_path / "a.gd", {1})
    assert kept.of(tmp_path / "a.gd", 9) == {1}


def test_a_place_that_cannot_be_written_is_nobody_s_trouble(tmp_path: Path) -> None:
    (tmp_path / "state").write_text("a file")

    KeptBreakpoints(str(tmp_path / "state" / "breakpoints.txt")).keep(tmp_path / "a.gd", {1})


def test_the_file_stays_small(file: Path, tmp_path: Path) -> None:
    kept = KeptBreakpoints(str(file))
    for number in range(MOST_PROGRAMS + 5):
        kept.keep(tmp_path / f"{number}.gd", range(1, 1000))

    assert len(file.read_text().splitlines()) == MOST_PROGRAMS
    assert file.stat().st_size < LARGEST


def test_what_differs_between_two_texts_says_where_they_are_now() -> None:
    assert followed({1, 3}, ["a", "b", "c"], ["a", "x", "b", "c"]) == {1, 4}
    assert followed({2, 3}, ["a", "b", "c"], ["a", "c"]) == {2}


def test_in_a_typed_program_they_go_with_their_lines() -> None:
    program = TypedProgram()
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
