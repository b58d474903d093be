"""Copies of what is not saved: each with the name of its file, the last one wanted is what is there."""

import contextlib
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from donnie_tui.core.copies import MOST_COPIES, Copies


def test_a_copy_knows_its_file_and_holds_the_text_to_the_letter(tmp_path: Path) -> None:
    text = "\n-- mine\nFW 1"
    Copies(str(tmp_path)).keep(text, tmp_path / "walk.gd")
    found = Copies(str(tmp_path)).read(next(tmp_path.glob("*.gd")))
    assert (found.text, found.path) == (text, tmp_path / "walk.gd")


def test_a_text_that_looks_like_a_copy_comes_back_whole(tmp_path: Path) -> None:
    text = "-- What was not saved of the file: /tmp/other.gd\nFW 1"
    Copies(str(tmp_path)).keep(text)
    found = Copies(str(tmp_path)).read(next(tmp_path.glob("*.gd")))
    assert (found.text, found.path) == (text, None)


def test_what_is_wanted_last_is_there_and_nothing_else(tmp_path: Path) -> None:
    copies = Copies(str(tmp_path))
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
    first = Copies(str(tmp_path))
    second = first.another()
    first.keep("FW 1")
    second.keep("FW 2")
    assert first.offered() is None
    assert second.offered() is None


@contextlib.contextmanager
def process(*words: str) -> Iterator[subprocess.Popen[bytes]]:
    """One with these words in its command line, which ends when its input does."""
    command = [sys.executable, "-c", "print(flush=True); input()", *words]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
    ) as made:
        assert made.stdout is not None
        made.stdout.readline()  # while it begins, its command line is empty
        yield made


def copy_of(process: subprocess.Popen[bytes], folder: Path) -> Path:
    copy = folder / f"unsaved-{process.pid}-abc.gd"
    copy.write_text("FW 1", encoding="utf-8")
    return copy


def test_a_copy_of_a_start_that_still_runs_is_not_offered(tmp_path: Path) -> None:
    with process("donnie") as running:
        copy = copy_of(running, tmp_path)
        assert Copies(str(tmp_path)).offered() is None

    assert Copies(str(tmp_path)).offered() == copy


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
def test_a_copy_of_a_start_whose_end_nobody_has_noticed_is_offered(tmp_path: Path) -> None:
    """Where the first process of all doesn't look after orphans, as in many containers."""
    with process("donnie") as ended:
        copy = copy_of(ended, tmp_path)
        ended.kill()
        os.waitid(os.P_PID, ended.pid, os.WEXITED | os.WNOWAIT)

        assert Copies(str(tmp_path)).offered() == copy


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
def test_a_copy_whose_number_another_program_has_now_is_offered(tmp_path: Path) -> None:
    """As after the power failed: numbers are given anew."""
    with process("another") as other:
        copy = copy_of(other, tmp_path)

        assert Copies(str(tmp_path)).offered() == copy


def texts_offered(folder: Path) -> list[str]:
    copies = Copies(str(folder))
    return [copies.read(each).text for each in copies.all_offered()]


def leave_one(folder: Path, text: str, path: Path | None = None) -> None:
    copies = Copies(str(folder))
    copies.keep(text, path)
    copies.leave()


def test_what_somebody_left_is_brought_back_for_whoever_asks_and_not_spoken_of(tmp_path: Path) -> None:
    leave_one(tmp_path, "FW 1", tmp_path / "walk.gd")
    copies = Copies(str(tmp_path))
    assert copies.rescued() == []

    copy = copies.offered()
    assert copy is not None
    found = copies.take(copy)
    assert (found.text, found.path) == ("FW 1", tmp_path / "walk.gd")
    assert copies.offered() is None


def test_what_a_crash_left_comes_before_what_somebody_left_since(tmp_path: Path) -> None:
    with process("donnie") as crashed:
        copy_of(crashed, tmp_path).write_text("crashed")
    leave_one(tmp_path, "older")
    leave_one(tmp_path, "newer")

    assert texts_offered(tmp_path) == ["crashed", "newer", "older"]
    assert len(Copies(str(tmp_path)).rescued()) == 1


def test_of_what_was_left_only_the_newest_is_kept_and_what_a_crash_left_stays(tmp_path: Path) -> None:
    with process("donnie") as crashed:
        copy_of(crashed, tmp_path)
    for number in range(MOST_COPIES + 5):
        leave_one(tmp_path, f"FW {number}")

    assert texts_offered(tmp_path) == [
        "FW 1",
        *(f"FW {MOST_COPIES + 4 - back}" for back in range(MOST_COPIES)),
    ]


def test_a_program_that_is_saved_leaves_no_copy(tmp_path: Path) -> None:
    copies = Copies(str(tmp_path))
    copies.keep("FW 1")
    copies.follow("FW 1", is_saved=True)
    copies.settle()
    copies.leave()

    assert list(tmp_path.iterdir()) == []
