"""Nothing that was typed is lost: it is written down beside whoever types, of any length, for every robot."""

from __future__ import annotations

import threading
from pathlib import Path

import pytest

from donnie_tui.core import copies as copying
from donnie_tui.core.breakpoints import KeptBreakpoints
from donnie_tui.core.copies import Copies
from donnie_tui.core.documents import DocumentError, write_program
from donnie_tui.core.typed_program import TypedProgram
from donnie_tui.linear.programs import Programs
from tests.patience import PATIENCE
from tests.unit.linear.test_safekeeping import Typing


class Disk:
    """Writes only once it is let; ``written`` is what it was given."""

    def __init__(self) -> None:
        self.begun, self.may_go_on = threading.Event(), threading.Event()
        self.written: list[str] = []
        self.is_full = False

    def write(self, path: Path, text: str) -> None:
        self.begun.set()
        assert self.may_go_on.wait(PATIENCE)
        if self.is_full:
            raise DocumentError("file-unwritable", str(path), "No space left on device")
        self.written.append(text)
        write_program(path, text)


@pytest.fixture
def disk(monkeypatch: pytest.MonkeyPatch) -> Disk:
    made = Disk()
    monkeypatch.setattr(copying, "write_program", made.write)
    return made


class Talk:
    """Programs of a conversation with two robots."""

    def __init__(self, folder: Path) -> None:
        self.robot = "one"
        self.not_kept: list[str] = []
        self.console = Typing()
        self.programs = Programs(
            lambda: self.robot,
            str(folder),
            KeptBreakpoints(str(folder / "breakpoints")),
            self.console,
            lambda error: self.not_kept.append(error.reason),
        )

    def types(self, *lines: str) -> None:
        for line in lines:
            self.programs.current.add(line)
        self.programs.keep_copy()

    def talk_to(self, robot: str) -> None:
        before, self.robot = self.robot, robot
        self.programs.change_robot(before)


def texts(folder: Path) -> list[str]:
    return sorted(each.read_text() for each in folder.glob("unsaved-*"))


def no_copy_is_written() -> None:
    for thread in threading.enumerate():
        if thread.name == "copies":
            thread.join(PATIENCE)


def test_whoever_types_waits_for_no_disk_and_the_last_line_is_written_all_the_same(
    tmp_path: Path, disk: Disk
) -> None:
    talk = Talk(tmp_path)
    talk.types("FW 1")
    assert disk.begun.wait(PATIENCE)
    talk.types("FW 2")
    talk.types("FW 3")
    assert disk.written == []

    disk.may_go_on.set()
    no_copy_is_written()

    assert disk.written == ["FW 1\n", "FW 1\nFW 2\nFW 3\n"]
    assert texts(tmp_path) == ["FW 1\nFW 2\nFW 3\n"]


def test_a_program_of_any_length_is_written_down_at_the_prompt(tmp_path: Path) -> None:
    talk = Talk(tmp_path)
    talk.types(*["FW 1"] * 20_000)
    no_copy_is_written()

    assert texts(tmp_path) == ["FW 1\n" * 20_000]


def test_what_was_saved_meanwhile_leaves_no_copy(tmp_path: Path, disk: Disk) -> None:
    talk = Talk(tmp_path)
    talk.types("FW 1")
    assert disk.begun.wait(PATIENCE)
    talk.programs.current.was_saved()
    talk.programs.keep_copy()
    disk.may_go_on.set()
    no_copy_is_written()

    assert texts(tmp_path) == []


def test_it_is_told_once_that_nothing_can_be_written_down(tmp_path: Path, disk: Disk) -> None:
    disk.is_full = True
    disk.may_go_on.set()
    talk = Talk(tmp_path)
    for line in ("FW 1", "FW 2"):
        talk.types(line)
        no_copy_is_written()

    assert talk.not_kept == ["No space left on device"]


def save_in_vain(programs: Programs, program: TypedProgram) -> None:
    with programs.as_current(program):
        assert programs.current is program
        raise InterruptedError


def test_where_another_robots_program_could_not_be_saved_each_is_kept(tmp_path: Path) -> None:
    talk = Talk(tmp_path)
    talk.types("FW 1")
    talk.talk_to("two")
    talk.types("FW 2")
    other = talk.programs.all()[1]
    with pytest.raises(InterruptedError):
        save_in_vain(talk.programs, other)
    talk.programs.keep_for_later()

    assert texts(tmp_path) == ["FW 1\n", "FW 2\n"]


def test_the_full_screen_takes_the_current_program_along_and_the_others_are_rescued(tmp_path: Path) -> None:
    talk = Talk(tmp_path)
    talk.types("FW 1")
    talk.talk_to("two")
    talk.types("FW 2")
    no_copy_is_written()
    talk.programs.hand_over()

    assert texts(tmp_path) == ["FW 1\n"]


def test_what_new_took_the_place_of_can_be_asked_for_after_what_was_there_at_the_end(tmp_path: Path) -> None:
    talk = Talk(tmp_path)
    talk.types("FW 1")
    talk.programs.current.clear()
    talk.types("FW 2")
    no_copy_is_written()
    talk.programs.leave_copies(of_all=True)

    later = Copies(str(tmp_path))
    assert [later.read(each).text for each in later.all_offered()] == ["FW 2", "FW 1"]
    assert later.rescued() == []


def test_what_another_program_took_the_place_of_is_there_after_a_crash_whichever_is_back(
    tmp_path: Path,
) -> None:
    talk = Talk(tmp_path)
    talk.types("FW 1")
    talk.programs.current.replace("FW 9\n", None, in_file="")  # what RECOVER does
    talk.programs.keep_copy()
    no_copy_is_written()
    assert texts(tmp_path) == ["FW 1\n", "FW 9\n"]
    talk.programs.current.undo()
    talk.programs.keep_copy()
    no_copy_is_written()

    assert texts(tmp_path) == ["FW 1\n", "FW 9\n"]


def test_programs_that_came_one_after_the_other_are_not_kept_without_end(tmp_path: Path) -> None:
    talk = Talk(tmp_path)
    for number in range(9):
        talk.types(f"FW {number}")
        talk.programs.current.clear()
    talk.programs.keep_copy()
    no_copy_is_written()

    assert texts(tmp_path) == [f"FW {number}\n" for number in range(4, 9)]
