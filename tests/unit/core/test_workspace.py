"""No typed line is lost: copies of every document are written in the background."""

from __future__ import annotations

import threading
from pathlib import Path

import pytest

from donnie_tui.core import recovery
from donnie_tui.core.document import Document
from donnie_tui.core.program_files import DocumentError, write_program
from donnie_tui.core.recovery import CopyFolder, read_copy
from donnie_tui.core.workspace import Workspace
from tests.timeouts import TIMEOUT
from tests.unit.core.text_editor import Editor


class Disk:
    """Writes only once it may continue; ``written`` is what it was given."""

    def __init__(self) -> None:
        self.begun, self.may_continue = threading.Event(), threading.Event()
        self.written: list[str] = []
        self.is_full = False

    def write(self, path: Path, text: str) -> None:
        self.begun.set()
        assert self.may_continue.wait(TIMEOUT)
        if self.is_full:
            raise DocumentError("file-unwritable", str(path), "No space left on device")
        self.written.append(text)
        write_program(path, text)


@pytest.fixture
def disk(monkeypatch: pytest.MonkeyPatch) -> Disk:
    made = Disk()
    monkeypatch.setattr(recovery, "write_program", made.write)
    return made


def workspace_in(folder: Path) -> Workspace:
    made = Workspace(str(folder), str(folder / "breakpoints"), str(folder / "recent"))
    made.begin_with("one")
    return made


def add_lines(workspace: Workspace, *lines: str) -> None:
    for line in lines:
        workspace.document.add(line)
    workspace.keep_copies()


def texts(folder: Path) -> list[str]:
    return sorted(each.read_text() for each in folder.glob("unsaved-*"))


def wait_for_copies() -> None:
    for thread in threading.enumerate():
        if thread.name == "copies":
            thread.join(TIMEOUT)


def recovered(workspace: Workspace) -> tuple[str, ...]:
    """The lines of the current document after RECOVER."""
    found = workspace.recoverable()
    assert found is not None
    workspace.recover(found, *workspace.read_recoverable(found))
    return workspace.document.lines


def offered(folder: Path) -> list[str]:
    return [read_copy(each).text for each in CopyFolder(str(folder)).offered()]


# --- copies


def test_typing_does_not_wait_for_the_disk_and_the_last_line_is_written(tmp_path: Path, disk: Disk) -> None:
    workspace = workspace_in(tmp_path)
    add_lines(workspace, "FW 1")
    assert disk.begun.wait(TIMEOUT)
    add_lines(workspace, "FW 2")
    add_lines(workspace, "FW 3")
    assert disk.written == []

    disk.may_continue.set()
    wait_for_copies()

    assert disk.written == ["FW 1\n", "FW 1\nFW 2\nFW 3\n"]
    assert texts(tmp_path) == ["FW 1\nFW 2\nFW 3\n"]


def test_a_program_of_any_length_is_written_down(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    add_lines(workspace, *["FW 1"] * 20_000)
    wait_for_copies()

    assert texts(tmp_path) == ["FW 1\n" * 20_000]


def test_a_program_that_is_saved_during_the_write_leaves_no_copy(tmp_path: Path, disk: Disk) -> None:
    workspace = workspace_in(tmp_path)
    add_lines(workspace, "FW 1")
    assert disk.begun.wait(TIMEOUT)
    workspace.document.mark_saved()
    workspace.keep_copies()
    disk.may_continue.set()
    wait_for_copies()

    assert texts(tmp_path) == []


def test_a_failure_to_write_is_reported_once(tmp_path: Path, disk: Disk) -> None:
    disk.is_full = True
    disk.may_continue.set()
    workspace, reasons = workspace_in(tmp_path), list[str]()
    workspace.report_failure = lambda error: reasons.append(error.reason)
    for line in ("FW 1", "FW 2"):
        add_lines(workspace, line)
        wait_for_copies()

    assert reasons == ["No space left on device"]


def test_an_unchanged_copy_is_not_written_again(tmp_path: Path, disk: Disk) -> None:
    disk.may_continue.set()
    workspace = workspace_in(tmp_path)
    add_lines(workspace, "FW 1")
    wait_for_copies()

    assert not workspace.keep_copies()
    assert disk.written == ["FW 1\n"]


def save_in_vain(workspace: Workspace, document: Document) -> None:
    with workspace.as_current(document):
        assert workspace.document is document
        raise InterruptedError


def test_each_program_is_kept_where_that_of_another_robot_could_not_be_saved(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    add_lines(workspace, "FW 1")
    workspace.choose_robot("two")
    add_lines(workspace, "FW 2")
    with pytest.raises(InterruptedError):
        save_in_vain(workspace, workspace.current_first[1])
    workspace.write_copies()

    assert texts(tmp_path) == ["FW 1\n", "FW 2\n"]


def test_the_other_front_end_gets_the_current_program_and_the_others_are_rescued(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    add_lines(workspace, "FW 1")
    workspace.choose_robot("two")
    add_lines(workspace, "FW 2")
    wait_for_copies()
    workspace.hand_over()

    assert texts(tmp_path) == ["FW 1\n"]


def test_a_program_that_new_replaced_is_offered_after_the_one_at_the_end(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    add_lines(workspace, "FW 1")
    workspace.replace("", None)
    add_lines(workspace, "FW 2")
    wait_for_copies()
    workspace.leave_copies()
    workspace.write_copies()

    assert offered(tmp_path) == ["FW 2", "FW 1"]
    assert CopyFolder(str(tmp_path)).rescued() == []


def test_a_script_leaves_no_copy_but_of_what_it_recovered(tmp_path: Path) -> None:
    (tmp_path / "unsaved-99999999-1.gd").write_text("FW 9\n")
    workspace = workspace_in(tmp_path)
    workspace.choose_robot("two")
    workspace.document.add("FW 2")
    workspace.choose_robot("one")
    recovered(workspace)
    wait_for_copies()
    workspace.leave_copies(everything=False)
    workspace.write_copies()

    assert "FW 9" in offered(tmp_path)


def test_a_script_leaves_nothing_of_the_programs_in_its_lines(tmp_path: Path) -> None:
    (tmp_path / "kept-1.gd").write_text("FW 9\n")
    workspace = workspace_in(tmp_path)
    workspace.document.add("FW 1")
    workspace.replace("", None)
    workspace.document.add("FW 2")
    workspace.leave_copies(everything=False)
    workspace.write_copies()

    assert offered(tmp_path) == ["FW 9"]
    assert [each.name for each in tmp_path.glob("*.gd")] == ["kept-1.gd"]  # the next start offers it again


def test_a_copy_that_the_learner_did_not_open_is_offered_no_more_but_recovered(tmp_path: Path) -> None:
    for name in ("kept-1.gd", "kept-2.gd"):
        (tmp_path / name).write_text(f"{name}\n")
    workspace = workspace_in(tmp_path)
    opened, left = recovered(workspace), {"kept-1.gd", "kept-2.gd"}
    workspace.document.mark_saved()
    workspace.leave_copies()
    workspace.write_copies()

    assert workspace_in(tmp_path).rescued() == []
    assert offered(tmp_path) == [*(left - {*opened})]


def test_nothing_is_written_after_the_end(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    workspace.leave_copies()
    workspace.write_copies()
    workspace.document.add("FW 1")

    assert not workspace.keep_copies()
    workspace.write_copies()
    assert texts(tmp_path) == []


def test_programs_replaced_between_two_copies_are_offered_with_the_newest_first(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    workspace.document.add("FW 1")
    workspace.replace("", None)
    workspace.document.add("FW 2")
    workspace.put_away()
    workspace.leave_copies()
    workspace.write_copies()

    assert offered(tmp_path) == ["FW 2", "FW 1"]


def test_a_replaced_program_is_rescued_after_a_crash_whichever_is_the_current_one(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    add_lines(workspace, "FW 1")
    workspace.replace("FW 9\n", None, in_file="")  # as RECOVER does
    workspace.keep_copies()
    wait_for_copies()
    assert texts(tmp_path) == ["FW 1\n", "FW 9\n"]
    workspace.document.undo()
    workspace.keep_copies()
    wait_for_copies()

    assert texts(tmp_path) == ["FW 1\n", "FW 9\n"]


def test_only_the_last_of_many_replaced_programs_are_kept(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    for number in range(9):
        add_lines(workspace, f"FW {number}")
        workspace.replace("", None)
    workspace.keep_copies()
    wait_for_copies()

    assert texts(tmp_path) == [f"FW {number}\n" for number in range(4, 9)]


def test_no_program_that_was_put_away_is_lost_by_many_changes_after_it(tmp_path: Path) -> None:
    """UNDO knows the last fifty changes; twenty programs are kept without it."""
    workspace = workspace_in(tmp_path)
    for number in range(21):
        add_lines(workspace, f"FW {number}", *["TR 90"] * 60)
        assert workspace.put_away() == 61
    add_lines(workspace, *["TR 90"] * 60)

    found = [recovered(workspace)[0] for _ in range(22)]
    assert found[:21] == ["FW 20", "TR 90", *(f"FW {number}" for number in range(19, 0, -1))]
    assert found[21] != "FW 0"


def test_undo_restores_what_was_put_away_with_its_file(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    workspace.replace("FW 1\nFW 2\n", tmp_path / "walk.gd")
    assert workspace.put_away() == 2
    assert (workspace.document.lines, workspace.document.path) == ((), None)
    workspace.document.undo()

    assert workspace.document.lines == ("FW 1", "FW 2")
    assert workspace.document.path == tmp_path / "walk.gd"
    assert workspace.put_away() == 2
    assert workspace.recoverable() is None  # it is saved


def test_the_programs_of_all_robots_are_put_away(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    add_lines(workspace, "FW 1")
    workspace.choose_robot("two")
    add_lines(workspace, "FW 2")
    workspace.put_away()
    workspace.choose_robot("one")

    assert workspace.document.lines == ()
    assert {recovered(workspace), recovered(workspace)} == {("FW 1",), ("FW 2",)}


def test_what_was_put_away_and_is_saved_since_is_not_recovered_again(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    for line in ("FW 1", "FW 2"):
        add_lines(workspace, line)
        workspace.put_away()
    assert recovered(workspace) == ("FW 2",)
    for _ in range(60):  # more changes than UNDO knows
        workspace.document.add("TR 90")
    workspace.save(workspace.document, tmp_path / "walk.gd", workspace.document.text)
    workspace.replace("", None)
    workspace.keep_copies()
    wait_for_copies()

    assert texts(tmp_path) == ["FW 1\n"]


def test_a_program_that_undo_restored_has_one_copy(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    add_lines(workspace, "FW 1")
    workspace.put_away()
    workspace.document.undo()
    workspace.keep_copies()
    wait_for_copies()

    assert texts(tmp_path) == ["FW 1\n"]


# --- recovering


def test_a_copy_of_a_crash_is_recovered_before_a_program_replaced_since(tmp_path: Path) -> None:
    (tmp_path / "unsaved-99999999-1.gd").write_text("FW 9\n")
    workspace = workspace_in(tmp_path)
    add_lines(workspace, "FW 1")

    assert recovered(workspace) == ("FW 9",)
    assert workspace.rescued() == []
    assert recovered(workspace) == ("FW 1",)
    assert recovered(workspace) == ("FW 9",)
    wait_for_copies()
    assert texts(tmp_path) == ["FW 1\n", "FW 9\n"]


def test_a_recovered_program_is_saved_if_its_file_has_the_same_text(tmp_path: Path) -> None:
    (tmp_path / "walk.gd").write_text("FW 1\n")
    for text in ("FW 1\n", "FW 2\n"):
        workspace = workspace_in(tmp_path)
        workspace.replace(text, tmp_path / "walk.gd", in_file="other")
        workspace.leave_copies()
        workspace.write_copies()

        later = workspace_in(tmp_path)
        recovered(later)
        assert (later.document.path, later.document.is_saved) == (tmp_path / "walk.gd", text == "FW 1\n")
        later.hand_over()


def test_recover_without_a_copy_says_so(tmp_path: Path) -> None:
    assert workspace_in(tmp_path).recoverable() is None


# --- robots and files


def test_each_robot_has_a_document_of_its_own(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    workspace.document.add("FW 1")
    workspace.choose_robot("two")
    workspace.document.add("FW 2")
    workspace.choose_robot("one")

    assert {name: each.lines for name, each in workspace.by_robot().items()} == {
        "one": ("FW 1",),
        "two": ("FW 2",),
    }


def test_in_another_world_the_current_document_stays_and_others_wait_for_their_robots(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    workspace.document.add("FW 1")
    workspace.choose_robot("two")
    workspace.document.add("FW 2")
    workspace.begin_with("one")

    assert workspace.document.lines == ("FW 2",)
    assert {name: each.lines for name, each in workspace.by_robot().items()} == {
        "one": ("FW 2",),
        "one 2": ("FW 1",),
    }


def test_breakpoints_come_back_with_their_file_and_the_file_is_a_recent_one(tmp_path: Path) -> None:
    workspace, path = workspace_in(tmp_path), tmp_path / "walk.gd"
    workspace.document.add("FW 1")
    workspace.document.breakpoints = frozenset({1})
    workspace.save(workspace.document, path, workspace.document.text)
    workspace.replace("", None)
    assert workspace.document.breakpoints == frozenset()

    workspace.open(path, path.read_text())
    assert (workspace.document.breakpoints, workspace.document.is_saved) == ({1}, True)
    assert workspace.recent.paths() == (path,)


def test_a_line_typed_during_a_save_is_not_saved(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    workspace.document.add("FW 1")
    text = workspace.document.text
    workspace.document.add("FW 2")
    workspace.document.breakpoints = frozenset({1})
    workspace.save(workspace.document, tmp_path / "walk.gd", text)

    assert not workspace.document.is_saved
    assert workspace.document.saved_text == "FW 1\n"
    workspace.open(tmp_path / "walk.gd", text)
    assert workspace.document.breakpoints == frozenset()  # those are of other lines


# --- several documents


def test_the_editor_shows_the_document_that_is_current(tmp_path: Path) -> None:
    workspace, editor = workspace_in(tmp_path), Editor()
    first, second = workspace.document, workspace.add_document()
    second.add("TR 90")
    assert workspace.current_first == (first, second)

    workspace.attach(editor)
    editor.type("FW 1")
    workspace.turn_to(second)
    assert (first.lines, first.is_in_editor, editor.text) == (("FW 1",), False, "TR 90")
    assert workspace.current_first == (second, first)

    workspace.detach()
    editor.type("BW 5")
    assert (second.lines, second.is_in_editor) == (("TR 90",), False)
    workspace.turn_to(first)
    assert (editor.text, first.is_in_editor) == ("BW 5", False)


def test_each_robot_has_its_own_document(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    workspace.document.add("FW 1")
    one = workspace.document
    workspace.choose_robot("two")
    two = workspace.document

    assert (two.lines, workspace.by_robot()) == ((), {"one": one, "two": two})
    workspace.choose_robot("one")
    assert (workspace.document, len(workspace.documents)) == (one, 2)

    workspace.begin_with("two")
    assert workspace.by_robot() == {"two": one, "two 2": two}
    workspace.choose_robot("two 2")
    assert workspace.document is two


def test_breakpoints_come_back_with_their_program(tmp_path: Path) -> None:
    workspace, program = workspace_in(tmp_path), tmp_path / "a.gd"
    workspace.document.add("FW 1")
    workspace.document.breakpoints = frozenset({1})
    workspace.save(workspace.document, program, "FW 1\n")
    assert (program.read_text(), workspace.document.path, workspace.document.is_saved) == (
        "FW 1\n",
        program,
        True,
    )
    assert workspace.recent.paths()[:1] == (program,)

    again = workspace_in(tmp_path)
    again.open(program, "FW 1\n")
    assert again.document.breakpoints == {1}
    again.document.breakpoints = frozenset()
    again.keep_breakpoints()
    again.open(program, "FW 1\n")
    assert again.document.breakpoints == frozenset()


def test_what_a_challenge_puts_away_can_be_undone_for_each_robot(tmp_path: Path) -> None:
    workspace = workspace_in(tmp_path)
    workspace.document.add("FW 1")
    workspace.choose_robot("two")
    for line in ("TR 90", "TL 90"):
        workspace.document.add(line)

    assert workspace.put_away() == 2
    assert [each.lines for each in workspace.documents] == [(), ()]
    for each in workspace.documents:
        each.undo()
    assert [each.lines for each in workspace.documents] == [("FW 1",), ("TR 90", "TL 90")]
