"""Copies of unsaved programs: each names its file, and the latest text is on disk."""

import contextlib
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from donnie_tui.core.program_files import DocumentError
from donnie_tui.core.recovery import MOST_COPIES, CopyFolder, UnsavedCopy, read_copy


def write_copy(folder: Path, text: str, path: Path | None = None) -> UnsavedCopy:
    copy = UnsavedCopy(CopyFolder(str(folder)))
    copy.want(text, path)
    copy.write()
    return copy


def test_a_copy_knows_its_file_and_has_the_exact_text(tmp_path: Path) -> None:
    text = "\n-- mine\nFW 1"
    write_copy(tmp_path, text, tmp_path / "walk.gd")
    found = read_copy(next(tmp_path.glob("*.gd")))
    assert (found.text, found.path) == (text, tmp_path / "walk.gd")


def test_a_text_that_looks_like_a_copy_comes_back_whole(tmp_path: Path) -> None:
    text = "-- What was not saved of the file: /tmp/other.gd\nFW 1"
    write_copy(tmp_path, text)
    found = read_copy(next(tmp_path.glob("*.gd")))
    assert (found.text, found.path) == (text, None)


def test_only_the_latest_copy_is_on_disk(tmp_path: Path) -> None:
    copy = UnsavedCopy(CopyFolder(str(tmp_path)))
    copy.want("FW 1")
    copy.want("FW 2")
    assert not list(tmp_path.iterdir())
    copy.write()
    assert [each.read_text() for each in tmp_path.iterdir()] == ["FW 2"]
    copy.want("FW 3")
    copy.want_none()
    copy.write()
    assert not list(tmp_path.iterdir())


def test_the_copy_of_another_program_of_the_same_start_is_not_offered(tmp_path: Path) -> None:
    folder = CopyFolder(str(tmp_path))
    for text in ("FW 1", "FW 2"):
        copy = UnsavedCopy(folder)
        copy.want(text)
        copy.write()

    assert folder.offered() == []


@contextlib.contextmanager
def process(*words: str) -> Iterator[subprocess.Popen[bytes]]:
    """A process with these words in its command line, which ends when its input ends."""
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
        assert CopyFolder(str(tmp_path)).offered() == []

    assert CopyFolder(str(tmp_path)).offered() == [copy]


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
def test_a_copy_of_a_start_that_ended_and_was_not_collected_is_offered(tmp_path: Path) -> None:
    """In many containers the first process does not collect orphans."""
    with process("donnie") as ended:
        copy = copy_of(ended, tmp_path)
        ended.kill()
        os.waitid(os.P_PID, ended.pid, os.WEXITED | os.WNOWAIT)

        assert CopyFolder(str(tmp_path)).offered() == [copy]


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
def test_a_copy_with_the_number_of_another_program_is_offered(tmp_path: Path) -> None:
    """As after a power failure: the system assigns process numbers again."""
    with process("another") as other:
        copy = copy_of(other, tmp_path)

        assert CopyFolder(str(tmp_path)).offered() == [copy]


def texts_offered(folder: Path) -> list[str]:
    return [read_copy(each).text for each in CopyFolder(str(folder)).offered()]


def leave_one(folder: Path, text: str, path: Path | None = None) -> None:
    copy = write_copy(folder, text, path)
    copy.leave()
    copy.write()


def test_a_copy_that_was_never_written_is_not_offered(tmp_path: Path) -> None:
    """Its start was killed between the making of the file and the writing of the text."""
    folder = CopyFolder(str(tmp_path))
    written, empty = tmp_path / "unsaved-0-0.gd", tmp_path / "unsaved-0-1.gd"
    written.write_text("FW 1\n")
    empty.touch()

    assert folder.rescued() == [written]


def test_a_discarded_program_is_offered_and_not_counted_as_rescued(tmp_path: Path) -> None:
    leave_one(tmp_path, "FW 1", tmp_path / "walk.gd")
    folder = CopyFolder(str(tmp_path))
    assert folder.rescued() == []

    left = folder.offered()[0]
    found = read_copy(left)
    assert (found.text, found.path) == ("FW 1", tmp_path / "walk.gd")
    copy = UnsavedCopy(folder)
    copy.want(found.text, found.path, instead_of=left)
    copy.write()
    assert folder.offered() == []


def test_a_copy_of_a_crash_is_offered_before_a_later_discarded_program(tmp_path: Path) -> None:
    with process("donnie") as crashed:
        copy_of(crashed, tmp_path).write_text("crashed")
    leave_one(tmp_path, "older")
    leave_one(tmp_path, "newer")

    assert texts_offered(tmp_path) == ["crashed", "newer", "older"]
    assert len(CopyFolder(str(tmp_path)).rescued()) == 1


def test_only_the_newest_discarded_program_is_kept_and_copies_of_crashes_stay(tmp_path: Path) -> None:
    with process("donnie") as crashed:
        copy_of(crashed, tmp_path)
    for number in range(MOST_COPIES + 5):
        leave_one(tmp_path, f"FW {number}")

    assert texts_offered(tmp_path) == [
        "FW 1",
        *(f"FW {MOST_COPIES + 4 - back}" for back in range(MOST_COPIES)),
    ]


def test_a_program_that_is_saved_leaves_no_copy(tmp_path: Path) -> None:
    copy = write_copy(tmp_path, "FW 1")
    copy.follow("FW 1", is_saved=True)
    copy.leave()
    copy.write()

    assert list(tmp_path.iterdir()) == []


def test_copies_do_not_pile_up(tmp_path: Path) -> None:
    for number in range(MOST_COPIES + 5):
        write_copy(tmp_path / "deep" / "folder", f"FW {number}")

    assert len(list((tmp_path / "deep" / "folder").iterdir())) == MOST_COPIES


def test_a_folder_that_cannot_be_made_is_a_document_error(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")

    with pytest.raises(DocumentError):
        write_copy(tmp_path / "file" / "folder", "FW 1")
