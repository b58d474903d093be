"""Copies of unsaved programs: each names its file, and the latest text is on disk."""

import contextlib
import errno
import os
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from donnie_tui.core.program_files import DocumentError
from donnie_tui.core.recovery import CopyFolder, CopyWriter, UnsavedCopy, read_copy
from tests.timeouts import TIMEOUT


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
    for number in range(25):
        leave_one(tmp_path, f"FW {number}")

    assert texts_offered(tmp_path) == ["FW 1", *(f"FW {number}" for number in range(24, 4, -1))]


def test_a_program_that_is_saved_leaves_no_copy(tmp_path: Path) -> None:
    copy = write_copy(tmp_path, "FW 1")
    copy.follow("FW 1", is_saved=True)
    copy.leave()
    copy.write()

    assert list(tmp_path.iterdir()) == []


def test_copies_do_not_pile_up(tmp_path: Path) -> None:
    for number in range(25):
        write_copy(tmp_path / "deep" / "folder", f"FW {number}")

    assert len(list((tmp_path / "deep" / "folder").iterdir())) == 20


def test_a_folder_that_cannot_be_made_is_a_document_error(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")

    with pytest.raises(DocumentError):
        write_copy(tmp_path / "file" / "folder", "FW 1")


@pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")
def test_a_running_donnie_is_known_by_its_arguments_and_not_by_its_python(tmp_path: Path) -> None:
    """``python .../bin/donnie`` is one; another program of an environment that is called donnie is none."""
    script = tmp_path / "donnie"
    script.write_text("print(flush=True); input()")
    of_donnie = tmp_path / "donnie-python"
    of_donnie.symlink_to(sys.executable)
    for command, offered in (([sys.executable, script], 0), ([of_donnie, "-c", script.read_text()], 1)):
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as running:
            assert running.stdout is not None
            running.stdout.readline()
            copy = copy_of(running, tmp_path)
            assert len(CopyFolder(str(tmp_path)).offered()) == offered
            running.communicate(b"\n")
        copy.unlink()


@pytest.mark.parametrize("name", ["unsaved-0-abc.gd", "unsaved-x-abc.gd", "unsaved-{own}-abc.gd"])
def test_a_copy_without_the_number_of_another_process_is_offered(tmp_path: Path, name: str) -> None:
    copy = tmp_path / name.format(own=os.getpid())
    copy.write_text("FW 1")

    assert CopyFolder(str(tmp_path)).rescued() == [copy]


@pytest.mark.skipif(os.name != "posix", reason="processes have signals")
def test_elsewhere_a_copy_of_any_running_process_is_in_use(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with process("another") as other:
        copy = copy_of(other, tmp_path)
        monkeypatch.setattr(sys, "platform", "darwin")
        assert CopyFolder(str(tmp_path)).offered() == []

    (tmp_path / f"unsaved-{10**30}-abc.gd").write_text("FW 2")  # more than the system counts
    copy.touch()
    assert copy in CopyFolder(str(tmp_path)).offered()
    assert len(CopyFolder(str(tmp_path)).offered()) == 2


def test_only_files_that_are_called_as_copies_are_offered(tmp_path: Path) -> None:
    for name in ("unsaved-0-a.txt", "other-0-a.gd", "unsaved-0-b.gd"):
        (tmp_path / name).write_text("FW 1")

    assert [each.name for each in CopyFolder(str(tmp_path)).offered()] == ["unsaved-0-b.gd"]
    assert CopyFolder(str(tmp_path / "nowhere")).offered() == []


def test_a_copy_that_is_removed_while_the_folder_is_read_hides_no_other(tmp_path: Path) -> None:
    (tmp_path / "unsaved-0-a.gd").symlink_to(tmp_path / "gone")  # listed, and not there when it is looked at
    (tmp_path / "unsaved-0-b.gd").write_text("FW 1")

    assert [each.name for each in CopyFolder(str(tmp_path)).offered()] == ["unsaved-0-b.gd"]


def test_a_copy_that_was_kept_without_a_question_is_offered_once(tmp_path: Path) -> None:
    for text in ("FW 1", "FW 2"):
        copy = write_copy(tmp_path, text)
        copy.leave(is_offered=True)
        copy.write()
    folder = CopyFolder(str(tmp_path))
    assert [read_copy(each).text for each in folder.rescued()] == ["FW 2", "FW 1"]

    opened = folder.rescued()[1]
    folder.withdraw_offers([opened])
    assert folder.rescued() == [opened]
    assert [read_copy(each).text for each in folder.left()] == ["FW 2"]


def test_offers_that_are_withdrawn_keep_their_order(tmp_path: Path) -> None:
    for text in ("FW 1", "FW 2", "FW 3"):
        copy = write_copy(tmp_path, text)
        copy.leave(is_offered=True)
        copy.write()
    folder = CopyFolder(str(tmp_path))
    folder.withdraw_offers([])

    assert folder.rescued() == []
    assert [read_copy(each).text for each in folder.left()] == ["FW 3", "FW 2", "FW 1"]


def test_a_blank_program_has_no_copy(tmp_path: Path) -> None:
    copy = write_copy(tmp_path, "FW 1")
    assert not copy.is_removal
    copy.follow(" \n", is_saved=False)
    assert copy.is_removal
    copy.write()
    assert list(tmp_path.iterdir()) == []

    copy.follow("FW 2", tmp_path / "walk.gd", is_saved=False)
    copy.write()
    (only,) = tmp_path.iterdir()
    assert read_copy(only).text == "FW 2"
    assert read_copy(only).path == tmp_path / "walk.gd"


def test_a_path_that_is_no_line_of_text_is_left_out(tmp_path: Path) -> None:
    write_copy(tmp_path, "FW 1", tmp_path / "two\nlines.gd")
    (only,) = tmp_path.iterdir()

    assert only.read_text() == "FW 1"


def test_the_writer_reports_one_failure_and_goes_on(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    reported = []
    written = threading.Event()

    class LastCopy(UnsavedCopy):
        def write(self) -> None:
            super().write()
            written.set()

    writer = CopyWriter(reported.append)
    bad = [UnsavedCopy(CopyFolder(str(tmp_path / "file" / "folder"))) for _ in range(2)]
    good, unchanged = LastCopy(CopyFolder(str(tmp_path / "good"))), LastCopy(CopyFolder(str(tmp_path)))
    for each in (*bad, good):
        each.want("FW 1")
    writer.write([*bad, unchanged])
    writer.write([good])

    assert written.wait(TIMEOUT)
    assert [each.code for each in reported] == ["file-unwritable"]
    assert len(list((tmp_path / "good").iterdir())) == 1


def test_what_cannot_be_written_at_an_end_is_not_reported(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    copy = UnsavedCopy(CopyFolder(str(tmp_path / "file" / "folder")))
    copy.want("FW 1")

    copy.write_quietly()


# --- what is on disk


def test_a_new_copy_is_the_owners_alone_and_has_the_number_of_its_process(tmp_path: Path) -> None:
    folder = CopyFolder(str(tmp_path / "state" / "unsaved"))
    copy = folder.new_copy()

    assert copy.name.startswith(f"unsaved-{os.getpid()}-")
    assert (copy.suffix, copy.stat().st_mode & 0o777, copy.read_text()) == (".gd", 0o600, "")
    assert folder.in_use == {copy}
    assert folder.rescued() == []  # it is empty, and of this start
    copy.write_text("FW 1")
    assert folder.rescued() == []
    assert CopyFolder(folder.name).rescued() == [copy]


def test_a_copy_that_can_not_be_made_names_its_folder_and_the_reason(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    copy = UnsavedCopy(CopyFolder(str(tmp_path / "file" / "folder")))
    copy.want("FW 1")
    with pytest.raises(DocumentError) as failed:
        copy.write()

    assert (failed.value.code, failed.value.path) == ("file-unwritable", str(tmp_path / "file" / "folder"))
    assert failed.value.reason in (os.strerror(errno.ENOTDIR), os.strerror(errno.EEXIST))


def test_a_failure_without_a_number_is_said_in_its_own_words(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail() -> Path:
        raise OSError("it is odd")

    folder = CopyFolder(str(tmp_path))
    monkeypatch.setattr(folder, "new_copy", fail)
    copy = UnsavedCopy(folder)
    copy.want("FW 1")
    with pytest.raises(DocumentError) as failed:
        copy.write()

    assert failed.value.reason == "it is odd"


@pytest.mark.parametrize("is_offered", [True, False])
def test_a_copy_that_is_left_is_the_newest_one_and_not_written_again(
    tmp_path: Path, is_offered: bool
) -> None:
    folder, prefix = CopyFolder(str(tmp_path)), "kept-" if is_offered else "left-"
    later = 2 * 10**18
    (tmp_path / f"{prefix}0-0.gd").write_text("FW 0")
    os.utime(tmp_path / f"{prefix}0-0.gd", ns=(later, later))
    copy = UnsavedCopy(folder)
    copy.want("FW 1")
    copy.write()
    (name,) = [each.name for each in folder.in_use]
    copy.leave(is_offered=is_offered)
    assert copy.is_outdated
    copy.write()
    assert (copy.is_outdated, folder.in_use) == (False, set())
    left = tmp_path / name.replace("unsaved-", prefix)
    assert folder.newest_first(prefix) == [left, tmp_path / f"{prefix}0-0.gd"]
    assert left.stat().st_mtime_ns == later + 1
    assert (folder.rescued() if is_offered else folder.left())[0] == left
    assert folder.offered()[0] == left
    copy.write()
    assert len([*tmp_path.iterdir()]) == 2


def test_a_copy_without_a_text_is_left_as_nothing(tmp_path: Path) -> None:
    copy = UnsavedCopy(CopyFolder(str(tmp_path)))
    copy.leave()
    copy.write()
    copy.want_none()
    copy.write()

    assert [*tmp_path.iterdir()] == []


def test_the_copy_that_another_one_takes_the_place_of_is_removed_once_it_is_written(tmp_path: Path) -> None:
    folder, old = CopyFolder(str(tmp_path)), tmp_path / "left-0-0.gd"
    old.write_text("FW 1")
    copy = UnsavedCopy(folder)
    copy.want("FW 1", instead_of=old)
    assert old.exists()
    copy.write()
    assert not old.exists()
    (only,) = tmp_path.iterdir()
    assert folder.in_use == {only}
    copy.want_none()
    assert copy.is_removal
    copy.write()
    assert (folder.in_use, [*tmp_path.iterdir()]) == (set(), [])
    copy.want("FW 2")
    copy.write()
    assert [each.read_text() for each in tmp_path.iterdir()] == ["FW 2"]


@pytest.mark.parametrize(
    ("text", "is_saved", "is_kept"), [("FW 1", False, True), ("FW 1", True, False), (" \n", False, False)]
)
def test_only_what_is_not_saved_is_followed(tmp_path: Path, text: str, is_saved: bool, is_kept: bool) -> None:
    copy = UnsavedCopy(CopyFolder(str(tmp_path)))
    copy.follow(text, is_saved=is_saved)

    assert (copy.is_outdated, copy.is_removal) == (True, not is_kept)
    copy.write()
    assert len([*tmp_path.iterdir()]) == is_kept


def test_texts_are_written_before_others_are_removed(tmp_path: Path) -> None:
    """A text that came back from one program to another is on disk at every moment."""
    order, done = list[str](), threading.Event()

    class Watched(UnsavedCopy):
        def __init__(self, name: str) -> None:
            super().__init__(CopyFolder(str(tmp_path)))
            self.name = name

        def write(self) -> None:
            super().write()
            order.append(self.name)
            if len(order) == 3:
                done.set()

    removed, text, unchanged, last = map(Watched, ("removed", "text", "unchanged", "last"))
    removed.want_none()
    text.want("FW 1")
    last.want("FW 2")
    CopyWriter(lambda _: None).write([removed, text, unchanged, last])

    assert done.wait(TIMEOUT)
    assert order == ["text", "last", "removed"]


def test_copies_are_written_by_one_thread(tmp_path: Path) -> None:
    begun, may_go_on = threading.Event(), threading.Event()

    class Slow(UnsavedCopy):
        def write(self) -> None:
            begun.set()
            assert may_go_on.wait(TIMEOUT)
            super().write()

    writer, before = CopyWriter(lambda _: None), {*threading.enumerate()}
    for _ in range(2):
        each = Slow(CopyFolder(str(tmp_path)))
        each.want("FW 1")
        writer.write([each])
        assert begun.wait(TIMEOUT)
    threads = [thread for thread in {*threading.enumerate()} - before if thread.name == "copies"]
    may_go_on.set()
    for thread in threads:
        thread.join(TIMEOUT)

    assert len(threads) == 1
    assert len([*tmp_path.iterdir()]) == 2


def test_a_writer_begins_again_after_it_has_written_everything(tmp_path: Path) -> None:
    writer, copy = CopyWriter(lambda _: None), UnsavedCopy(CopyFolder(str(tmp_path)))
    for text in ("FW 1", "FW 2"):
        copy.want(text)
        writer.write([copy])
        for thread in threading.enumerate():
            if thread.name == "copies":
                thread.join(TIMEOUT)
        assert [each.read_text() for each in tmp_path.iterdir()] == [text]


@pytest.mark.parametrize(
    ("kept", "text", "name"),
    [
        ("FW 1\r\nFW 2\n", "FW 1\nFW 2", None),
        ("-- What was not saved of the file: /a/b.gd\nFW 1", "FW 1", "/a/b.gd"),
        ("-- What was not saved of the file: \nFW 1", "FW 1", None),
        ("-- What was not saved of the file: /a/b.gd", "", "/a/b.gd"),
        ("\n-- What was not saved of the file: /a\n", "\n-- What was not saved of the file: /a", None),
    ],
)
def test_the_first_line_of_a_copy_may_name_its_file(
    tmp_path: Path, kept: str, text: str, name: str | None
) -> None:
    (tmp_path / "copy.gd").write_text(kept, newline="")
    found = read_copy(tmp_path / "copy.gd")

    assert (found.text, found.path) == (text, None if name is None else Path(name))


def test_the_file_of_a_copy_is_named_from_the_root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    write_copy(tmp_path / "copies", "FW 1", Path("walk.gd"))

    (only,) = (tmp_path / "copies").iterdir()
    assert only.read_text() == f"-- What was not saved of the file: {tmp_path}/walk.gd\nFW 1"


@pytest.mark.skipif(os.name != "posix", reason="processes have signals")
def test_elsewhere_the_copy_of_a_process_of_another_account_is_in_use(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    copy = tmp_path / "unsaved-1-abc.gd"
    copy.write_text("FW 1")
    monkeypatch.setattr(sys, "platform", "darwin")

    def refuse(number: int, signal: int) -> None:
        assert (number, signal) == (1, 0)
        raise PermissionError

    monkeypatch.setattr(os, "kill", refuse)
    assert CopyFolder(str(tmp_path)).rescued() == []
