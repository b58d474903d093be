"""The typed program: pending lines, lines that have run, saved lines, and line numbers."""

from collections.abc import Callable
from pathlib import Path

import pytest

from donnie_tui.core import document
from donnie_tui.core.document import (
    ANOTHER_PROGRAM,
    WORTH_SAVING,
    Batch,
    Document,
    ProgramTooLong,
)
from donnie_tui.core.editing import UnsavedText
from donnie_tui.core.program_files import save_question
from language.parser import parse
from tests.unit.core.text_editor import Editor


def typed(*lines: str) -> Document:
    program = Document()
    for line in lines:
        program.add(line)
    return program


def test_a_batch_is_what_was_typed_since_the_last_one() -> None:
    program = typed("FW 1", "FW 2")
    first = program.take_batch()
    program.batch_ran()
    program.add("FW 3")

    assert first == Batch("FW 1\nFW 2", 1, 2)
    assert program.take_batch() == Batch("FW 3", 3, 1)


def test_lines_that_are_added_during_a_run_wait_and_a_change_lets_all_wait() -> None:
    added, changed = typed("FW 1"), typed("FW 1")
    for program in (added, changed):
        program.take_batch()
        program.add("FW 2")
    changed.change(1, "FW 3")
    added.batch_ran()
    changed.batch_ran()

    assert (added.waiting, changed.waiting) == (1, 2)


def test_after_a_mistake_one_line_is_forgotten_and_several_are_kept() -> None:
    one, several = typed("FWD 1"), typed("FW 1", "FWD 2")

    assert (one.batch_was_refused(), one.lines) == (False, ())
    assert (several.batch_was_refused(), several.waiting) == (True, 2)


def test_lines_that_were_refused_and_changed_have_run_with_the_whole_program() -> None:
    program = typed("FWD 1", "FW 2")
    program.take_batch()
    assert program.batch_was_refused()
    program.change(1, "FW 1")
    program.batch_ran()

    assert (program.waiting, program.is_waiting) == (0, False)


def test_a_line_that_was_forgotten_is_known_until_another_one_is_there() -> None:
    program = typed("FWD 1")
    program.batch_was_refused()
    assert program.rejected == "FWD 1"

    program.add("FW 1")
    assert program.rejected is None


def test_the_innermost_open_block_has_its_line_in_the_program() -> None:
    program = typed("FW 1")
    program.batch_ran()
    for line in ("PROCEDURE P DO", "IF 1 == 1 THEN FW 1 END IF", "REPEAT 2 TIMES", "FW 1"):
        program.add(line)
    block = program.open_block

    assert program.depth == 2
    assert block is not None
    assert (block.kind, block.line) == ("REPEAT", 4)


def test_a_program_without_an_open_block_has_no_innermost_block() -> None:
    assert typed("REPEAT 2 TIMES FW 1 END REPEAT").open_block is None


def test_blank_lines_are_not_pending() -> None:
    assert not typed("", "  ").is_waiting


def test_lines_that_have_not_run_are_forgotten() -> None:
    program = typed("FW 1")
    program.batch_ran()
    program.add("FW 2")

    assert (program.delete_waiting(), program.lines) == (1, ("FW 1",))


def test_a_change_of_lines_that_ran_makes_the_whole_program_pending() -> None:
    program = typed("FW 1", "FW 2")
    program.batch_ran()
    program.change(1, "FW 5")

    assert program.waiting == 2
    assert program.take_batch().text == "FW 5\nFW 2"


def test_lines_are_inserted_and_deleted() -> None:
    program = typed("a", "d")
    program.insert(2, "c")
    program.insert(2, "b")
    program.delete(1, 1)

    assert program.lines == ("b", "c", "d")


@pytest.mark.parametrize("number", [0, -1, 3])
def test_a_line_that_is_not_there_is_an_index_error(number: int) -> None:
    program = typed("a", "b")

    with pytest.raises(IndexError):
        program.change(number, "x")
    with pytest.raises(IndexError):
        program.delete(1, number)
    with pytest.raises(IndexError):
        program.insert(number + 1 if number > 0 else number, "x")


def test_saved_means_that_the_lines_are_the_same_as_in_the_file() -> None:
    program = typed("FW 1")
    was_saved = program.is_saved
    program.mark_saved()
    program.add("FWD")
    is_saved = program.is_saved
    program.delete_waiting()
    program.add("FW 1")

    assert (was_saved, is_saved, program.is_saved) == (False, False, True)


def test_a_few_lines_are_not_worth_a_question_but_a_changed_file_is() -> None:
    few, many = typed("a"), typed(*["a"] * WORTH_SAVING)
    opened = Document()
    opened.replace("a\n", Path("a.gd"))
    opened.add("b")

    assert [each.is_worth_saving for each in (few, many, opened, Document())] == [
        False,
        True,
        True,
        False,
    ]


def test_a_program_takes_no_more_than_a_file_may_hold(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(document, "LARGEST", 10)
    program = typed("12345")

    with pytest.raises(ProgramTooLong):
        program.add("12345")
    assert program.lines == ("12345",)


def of_nine_characters() -> Document:
    program = Document()
    program.replace("12345\nab\n", None)
    return program


@pytest.mark.parametrize(
    "change",
    [
        lambda it: it.change(1, "1234567"),
        lambda it: it.insert(1, "x"),
        lambda it: it.rewrite("1234567890\n"),
        lambda it: it.replace_range(0, 1, "xyz"),
        lambda it: it.add("x"),
    ],
)
def test_a_change_that_makes_a_program_too_long_changes_nothing(
    monkeypatch: pytest.MonkeyPatch, change: Callable[[Document], object]
) -> None:
    monkeypatch.setattr(document, "LARGEST", 10)
    program = of_nine_characters()

    with pytest.raises(ProgramTooLong):
        change(program)
    assert program.text.split() == ["12345", "ab"]


def test_only_the_text_that_is_there_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(document, "LARGEST", 10)
    program = of_nine_characters()
    for _ in range(9):
        program.change(1, "1234")
        program.change(1, "12345")
        program.rewrite("12345\nab\n")
    program.delete(2, 2)
    program.add("abc")
    program.undo()
    program.add("abc")

    assert program.lines == ("12345", "abc")


def test_a_line_that_was_dropped_takes_no_room(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(document, "LARGEST", 10)
    program = Document()
    for _ in range(3):
        program.add("wrong")
        program.batch_was_refused()
    program.add("12345678")

    assert program.lines == ("12345678",)


def test_a_file_that_is_too_long_can_be_made_shorter(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(document, "LARGEST", 8)
    program = of_nine_characters()
    program.change(1, "1234")

    assert program.lines == ("1234", "ab")


def test_lines_are_moved_before_another_line_or_behind_the_last() -> None:
    program = typed("A", "B", "C", "D")

    assert program.move(3, 4, 1) == 1
    assert program.lines == ("C", "D", "A", "B")
    assert program.move(1, 1, 5) == 4
    assert program.lines == ("D", "A", "B", "C")
    with pytest.raises(IndexError):
        program.move(1, 2, 2)


def test_every_change_can_be_undone_in_turn() -> None:
    program = typed("A", "B", "C")
    program.change(2, "X")
    program.delete(1, 1)
    program.insert(3, "Y")
    program.move(1, 1, 3)
    found = [program.undo() for _ in range(4)]

    assert program.lines == ("A", "B", "C")
    assert found == [1, 3, 1, 2]


def test_undoing_a_typed_line_leaves_earlier_lines_run() -> None:
    program = typed("A", "B")
    program.batch_ran()
    program.add("SETTTINGS")

    assert (program.undo(), program.lines, program.waiting) == (3, ("A", "B"), 0)
    assert (program.undo(), program.undo(), program.undo(), program.lines) == (2, 1, None, ())


def test_a_rewritten_program_is_pending_from_its_first_changed_line() -> None:
    """Otherwise FIX in a pending line would repeat what the robot has done."""
    program = typed("FW 30")
    program.batch_ran()
    program.add("TRR 90")

    program.rewrite("FW 30\nTR 90\n")
    assert program.take_batch() == Batch("TR 90", 2, 1)

    program.rewrite("FW 3\nTR 90\n")
    assert program.waiting == 2


def test_undoing_a_change_loses_no_line_typed_after_it() -> None:
    program = typed("A", "B")
    program.change(1, "X")
    program.add("C")
    program.undo()

    assert (program.lines, program.undo(), program.lines) == (("X", "B"), 1, ("A", "B"))


def test_a_line_forgotten_after_a_mistake_is_not_undone_again() -> None:
    program = typed("A")
    program.batch_ran()
    for line in ("", "FWD 1"):
        program.add(line)
    program.batch_was_refused()

    assert (program.lines, program.undo(), program.lines) == (("A",), 1, ())


def test_undoing_a_change_to_lines_that_ran_makes_all_pending_again() -> None:
    program = typed("A", "B")
    program.batch_ran()
    program.change(2, "X")
    program.batch_ran()

    assert program.undo() == 2
    assert program.waiting == 2


def test_lines_that_ran_before_a_change_are_not_pending_after_its_undo() -> None:
    program = typed("A", "B")
    program.batch_ran()
    program.change(1, "X")
    program.add("C")
    assert program.waiting == 3

    program.undo()
    program.undo()
    assert (program.lines, program.waiting) == (("A", "B"), 0)


def test_every_undone_change_can_be_redone() -> None:
    program = typed("A", "B")
    program.change(2, "X")
    program.delete(1, 1)
    for _ in range(4):
        program.undo()
    assert program.lines == ()

    assert [program.redo() for _ in range(5)] == [1, 2, 2, 1, None]
    assert program.lines == ("X",)
    assert program.undo() == 1
    assert program.lines == ("A", "X")


def test_a_new_change_clears_the_redo_history() -> None:
    program = typed("A")
    program.change(1, "X")
    program.undo()
    program.add("B")

    assert (program.redo(), program.lines) == (None, ("A", "B"))


def test_what_is_typed_or_opened_after_an_undone_program_leaves_nothing_to_redo() -> None:
    empty = Document()
    empty.replace("C\n", None, keeps_empty=True)
    empty.undo()
    empty.replace("E\n", None)
    in_editor, editor = shown("A", "B")
    in_editor.replace("C\n", None)
    in_editor.undo()
    editor.type("D")

    assert (empty.redo(), empty.lines) == (None, ("E",))
    assert (in_editor.lines, in_editor.redo(), in_editor.lines) == (("D",), None, ("D",))


def test_a_redone_line_that_had_run_is_not_pending() -> None:
    program = typed("A")
    program.batch_ran()
    program.undo()

    assert (program.redo(), program.lines, program.waiting) == (1, ("A",), 0)


def test_a_run_in_between_counts_more_than_a_run_before_the_change() -> None:
    program = typed("A", "B")
    program.batch_ran()
    program.change(1, "X")
    program.batch_ran()

    program.undo()
    assert program.waiting == 2


def test_undoing_a_replaced_program_restores_its_file_and_its_saved_lines() -> None:
    program = Document()
    program.replace("A\nB\n", Path("mine.gd"))
    program.breakpoints = frozenset({2})
    program.batch_ran()
    program.add("C")
    program.replace("", None)
    program.add("X")

    assert (program.undo(), program.undo(), program.lines) == (1, ANOTHER_PROGRAM, ("A", "B", "C"))
    assert (program.path, program.is_saved, program.waiting) == (Path("mine.gd"), False, 1)
    assert program.breakpoints == {2}
    assert (program.undo(), program.lines, program.is_saved) == (3, ("A", "B"), True)


def test_redo_restores_the_replacing_program() -> None:
    program = typed("A")
    program.replace("X\n", Path("other.gd"))
    program.undo()
    assert (program.lines, program.path, program.is_saved) == (("A",), None, False)

    assert program.redo() == ANOTHER_PROGRAM
    assert (program.lines, program.path, program.is_saved) == (("X",), Path("other.gd"), True)
    assert (program.undo(), program.lines) == (ANOTHER_PROGRAM, ("A",))


def test_an_empty_program_can_not_be_restored_by_undo() -> None:
    program = Document()
    program.replace("A\n", Path("mine.gd"))

    assert program.undo() is None


def test_a_replaced_program_is_known_while_no_file_contains_it() -> None:
    program = typed("A")
    program.replace("X\n", Path("other.gd"))
    program.add("Y")
    program.replace("", None)
    assert program.versions.replaced == (UnsavedText("A\n", None), UnsavedText("X\nY\n", Path("other.gd")))

    program.undo()
    assert program.versions.replaced == (UnsavedText("A\n", None),)


def test_no_command_adds_a_line_with_control_characters() -> None:
    """A pipe may contain anything, and the file and the full screen get the lines unchanged."""
    harmful = "SPEAK \x1b[2J\x0c"
    program = typed(harmful, "b")
    program.change(2, harmful)
    program.insert(3, harmful)

    assert set(program.lines) == {"SPEAK  [2J "}


def test_a_question_comes_before_another_text_is_lost(tmp_path: Path) -> None:
    program, own, other = typed("FW 1"), tmp_path / "own.gd", tmp_path / "other.gd"
    own.write_text("FW 1\n")
    other.write_text("")
    program.mark_saved(own)

    assert [
        save_question(each, program.path, program.saved_text) for each in (own, other, tmp_path / "new.gd")
    ] == [
        "",
        "ask-replace",
        "",
    ]
    own.write_text("FW 2\n")
    assert save_question(own, program.path, program.saved_text) == "ask-replace-changed"


def test_a_word_is_searched_from_the_line_that_was_read_last_and_once_round() -> None:
    program = typed("FW 1", "BW 2", "FW 3")

    assert [program.find_next("fw") for _ in range(3)] == [1, 3, 1]
    assert program.place == 1
    assert program.find_next("TR") is None


def test_a_part_of_the_text_is_replaced_as_one_change() -> None:
    program = typed("FW 1", "TRR 90")
    program.replace_range(5, 8, "TR")

    assert program.lines == ("FW 1", "TR 90")
    program.undo()
    assert program.lines == ("FW 1", "TRR 90")


def test_the_structure_follows_the_lines() -> None:
    program = typed("REPEAT 2 TIMES")
    program.add("FW 1")

    assert program.structure.line(2).level == 1
    program.delete(1, 1)
    assert program.structure.line(1).level == 0


def test_undo_restores_a_line_that_was_typed_again() -> None:
    program = typed("FW", "TR 90")
    program.batch_was_refused({1: "FW 2"})

    assert program.add("FW 3") == 1
    program.undo()
    assert (program.lines, program.is_still_refused) == (("FW", "TR 90"), True)


def test_only_the_next_line_continues_a_program_that_failed() -> None:
    program = typed("VAR x = 0", "SPEAK 1 / x", "FW 2")
    program.take_batch()
    program.batch_ran()
    program.batch_failed(2)

    assert program.add("x = 4") is None
    assert program.add("SPEAK 1 / x") is None


def test_a_breakpoint_is_set_where_a_run_can_pause_and_cleared_again() -> None:
    program = typed("FW 1", "-- a remark", "REPEAT 2 TIMES", "FW 2", "END REPEAT")

    assert [program.toggle_breakpoint(line, parse) for line in (1, 2, 4, 5)] == [1, 3, 4, None]
    assert program.breakpoints == {1, 3, 4}
    assert program.toggle_breakpoint(3, parse) == 3
    assert program.breakpoints == {1, 4}


def test_in_a_program_with_mistakes_a_breakpoint_may_be_in_each_line() -> None:
    assert typed("FWD 1", "-- a remark").pausing_line(2, parse) == 2


@pytest.mark.parametrize(
    ("failed", "found"), [(2, 2), (4, None), (3, None), (6, None), (0, None)], ids=lambda value: str(value)
)
def test_only_a_statement_outside_of_blocks_that_failed_can_be_corrected(
    failed: int, found: int | None
) -> None:
    program = typed("VAR x = 0", "FW 1 / x", "REPEAT 2 TIMES", "FW 1 / x", "END REPEAT")
    program.batch_ran()
    program.batch_failed(failed)

    assert program.failed_line == found


def test_a_line_that_failed_is_known_until_it_is_changed() -> None:
    program = typed("FW 1 / 0")
    program.batch_ran()
    program.batch_failed(1)
    assert program.failed_line == 1

    program.change(1, "FW 1")
    assert program.failed_line is None


@pytest.mark.parametrize(
    ("first", "last", "to"), [(1, 2, 0), (1, 1, 5), (2, 3, 2), (2, 3, 3), (2, 3, 4), (0, 1, 3), (2, 4, 1)]
)
def test_lines_are_not_moved_into_themselves_or_out_of_the_program(first: int, last: int, to: int) -> None:
    program = typed("A", "B", "C")

    with pytest.raises(IndexError):
        program.move(first, last, to)
    assert program.lines == ("A", "B", "C")


def test_moving_lines_that_ran_makes_the_whole_program_pending() -> None:
    program = typed("A", "B", "C")
    program.batch_ran()
    program.move(1, 1, 4)

    assert (program.lines, program.waiting) == (("B", "C", "A"), 3)


# --- in an editor


def shown(*lines: str) -> tuple[Document, Editor]:
    program, editor = Document(), Editor()
    program.replace("".join(f"{line}\n" for line in lines), Path("mine.gd"))
    program.breakpoints = frozenset({2})
    program.place = 2
    program.attach(editor)
    return program, editor


def test_a_document_is_shown_with_its_breakpoints_at_the_line_that_was_read_last() -> None:
    program, editor = shown("A", "B", "")

    assert (editor.text, editor.breakpoints, editor.line) == ("A\nB\n\n", {2}, 2)
    assert (program.lines, program.is_in_editor) == (("A", "B", ""), True)


def test_a_document_that_leaves_its_editor_keeps_what_was_done_there() -> None:
    program, editor = shown("A", "B")
    editor.type("A\nB\nC")
    editor.breakpoints, editor.line = frozenset({3}), 3
    program.detach()
    editor.text, editor.breakpoints, editor.line = "another", frozenset(), 1

    assert (program.lines, program.breakpoints, program.place) == (("A", "B", "C"), {3}, 3)
    assert not program.is_in_editor
    program.detach()
    assert program.lines == ("A", "B", "C")


def test_what_commands_change_is_changed_in_the_editor() -> None:
    program, editor = shown("A", "B")
    program.add("C")
    program.change(1, "X")
    program.insert(2, "Y")
    program.delete(3, 3)
    assert editor.text == "X\nY\nC"

    program.replace_range(0, 1, "Z\x07")
    program.breakpoints |= {3}
    program.place = 3
    assert (editor.text, editor.breakpoints, editor.line) == ("Z \nY\nC", {2, 3}, 3)
    assert (program.breakpoints, program.place) == ({2, 3}, 3)
    program.place = 0
    assert editor.line == 3


def test_a_word_that_is_found_is_selected_and_the_next_search_goes_on_after_it() -> None:
    program, editor = shown("FW 1 FW 2", "BW 2")
    program.place = 1

    found = [(program.find_next("fw"), editor.selected) for _ in range(2)]
    assert found == [(1, (0, 0, 2)), (1, (0, 5, 7))]
    assert (program.find_next("2"), editor.selected) == (1, (0, 8, 9))
    assert program.find_next("TR") is None


def test_undo_takes_the_steps_of_the_editor_first() -> None:
    program, editor = shown("A", "B")
    editor.type("A\nX")
    editor.type("Y\nX")

    assert (program.undo(), editor.text) == (1, "A\nX")
    assert (program.redo(), editor.text) == (1, "Y\nX")
    assert (program.undo(), program.undo(), program.lines) == (1, 2, ("A", "B"))
    assert program.undo() is None
    program.replace("C\n", None)
    assert (program.undo(), editor.text, program.path) == (ANOTHER_PROGRAM, "A\nB", Path("mine.gd"))
    editor.type("D")
    assert program.lines == ("D",)
    editor.undo()
    assert (program.lines, program.redo()) == (("A", "B"), 1)


def test_a_first_line_in_an_editor_is_worth_saving_there_and_afterwards() -> None:
    program, editor = Document(), Editor()
    editor.line = 5
    program.attach(editor)
    assert (editor.text, editor.line, program.is_worth_saving) == ("", 1, False)

    editor.type("FW 1")
    assert not program.is_saved
    assert program.is_worth_saving
    program.detach()
    assert program.is_worth_saving


def test_lines_that_ran_wait_again_in_an_editor() -> None:
    program = typed("A", "B")
    program.batch_ran()
    program.attach(Editor())

    assert (program.ran, program.waiting, program.is_waiting) == (0, 2, True)


def test_the_place_in_an_editor_is_that_of_the_cursor() -> None:
    program, editor = shown("A", "B", "C")
    editor.line = 3

    assert program.place == 3
    program.detach()
    editor.line = 1
    assert program.place == 3


def test_what_an_editor_takes_over_counts_for_the_longest_program(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(document, "LARGEST", 10)
    program, editor = Document(), Editor()
    program.attach(editor)
    editor.type("1234567")
    program.detach()

    with pytest.raises(ProgramTooLong):
        program.add("xy")
    program.add("x")
    assert program.lines == ("1234567", "x")


def test_a_part_of_the_text_in_an_editor_may_be_as_long_as_the_program_leaves_room(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(document, "LARGEST", 10)
    program, editor = Document(), Editor()
    program.attach(editor)
    editor.type("12345678")

    with pytest.raises(ProgramTooLong):
        program.replace_range(2, 4, "abcde")
    program.replace_range(2, 4, "abcd")
    assert editor.text == "12abcd5678"
    editor.type("too long for a file")
    program.replace_range(0, 3, "two")
    assert editor.text == "two long for a file"
    with pytest.raises(ProgramTooLong):
        program.replace_range(0, 3, "more")


def test_a_change_in_an_editor_leaves_no_program_to_redo() -> None:
    for change in (lambda it: it.replace_range(0, 1, "X"), lambda it: it.change(1, "X")):
        program, editor = shown("A", "B")
        program.replace("C\n", None)
        program.undo()
        change(program)
        editor.redo()

        assert (program.redo(), editor.text) == (None, "X\nB")


def test_a_line_that_is_typed_in_an_editor_corrects_none() -> None:
    program = typed("FW", "TR 90")
    program.batch_was_refused({1: "FW 2"})
    editor = Editor()
    program.attach(editor)

    assert program.add("FW 3") is None
    assert (program.lines, editor.text) == (("FW", "TR 90", "FW 3"), "FW\nTR 90\nFW 3")


# --- the file, and what is worth a question


def test_a_document_knows_whether_its_lines_came_from_a_file_and_never_ran() -> None:
    def after(*changes: Callable[[Document], object]) -> bool:
        program = Document()
        program.replace("A\n", Path("a.gd"))
        for change in changes:
            change(program)
        return program.was_opened

    assert not Document().was_opened
    assert after()
    assert after(lambda it: it.replace("", None), lambda it: it.undo())
    assert not after(lambda it: it.replace("", None))
    assert not after(lambda it: it.batch_ran())
    assert not after(lambda it: it.delete_waiting())


def test_a_saved_file_has_a_name_and_a_text() -> None:
    program = typed("A")
    program.mark_saved(Path("a.gd"), "B\nC")
    assert (program.path, program.saved_text, program.is_saved) == (Path("a.gd"), "B\nC\n", False)

    program.mark_saved()
    assert (program.path, program.saved_text, program.is_saved) == (Path("a.gd"), "A\n", True)
    program.mark_saved(Path("b.gd"))
    assert program.path == Path("b.gd")


def test_another_program_begins_without_what_belonged_to_the_old_one() -> None:
    program = typed("FWD", "TR 90")
    program.batch_ran()
    program.breakpoints, program.place = frozenset({2}), 2
    program.add("FWD")
    program.batch_was_refused()
    for line in ("FWD", "B"):
        program.add(line)
    program.batch_was_refused({3: "FW"})
    program.replace("X\n", Path("x.gd"), in_file="Y\n")

    assert (program.lines, program.path, program.saved_text) == (("X",), Path("x.gd"), "Y\n")
    assert (program.breakpoints, program.place, program.ran) == (frozenset(), 0, 0)
    assert (program.rejected, program.refusals, program.is_still_refused) == (None, 0, False)


def test_another_program_leaves_no_dropped_line() -> None:
    program = typed("FWD")
    program.batch_was_refused()
    program.replace("", None)

    assert program.rejected is None


@pytest.mark.parametrize(
    ("lines", "runs", "is_worth_saving", "is_kept_unasked"),
    [
        (["A"] * 4, True, False, True),
        (["A"] * 4, False, False, False),
        (["A"] * 5, True, True, False),
        ([" "] * 5, True, False, False),
        ([], True, False, False),
    ],
)
def test_a_few_lines_that_ran_are_kept_without_a_question(
    lines: list[str], runs: bool, is_worth_saving: bool, is_kept_unasked: bool
) -> None:
    program = typed(*lines)
    if runs:
        program.batch_ran()

    assert (program.is_worth_saving, program.is_kept_unasked) == (is_worth_saving, is_kept_unasked)
    program.mark_saved()
    assert (program.is_worth_saving, program.is_kept_unasked) == (False, False)


def test_a_file_that_was_emptied_is_not_worth_a_question() -> None:
    program = Document()
    program.replace("A\n", Path("a.gd"))
    program.delete(1, 1)

    assert (program.is_saved, program.is_worth_saving) == (False, False)


# --- refused and failed lines


def test_lines_of_which_one_is_wrong_are_refused_until_they_run_or_are_changed() -> None:
    program = typed("FWD 1", "FW 2")
    for _ in range(2):
        program.take_batch()
        assert program.batch_was_refused()
    assert (program.refusals, program.is_still_refused, program.failed_line) == (2, True, None)

    program.change(1, "FW 1")
    assert (program.refusals, program.is_still_refused) == (2, False)
    program.batch_ran()
    assert program.refusals == 0
    program.change(1, "FWD 1")
    assert not program.is_still_refused


def test_lines_that_are_deleted_after_a_mistake_are_no_longer_refused() -> None:
    program = typed("FWD 1", "FW 2")
    program.batch_was_refused({1: "FW 1"})
    program.delete_waiting()
    assert (program.refusals, program.lines, program.delete_waiting()) == (0, (), 0)

    for line in ("FWD 1", "FW 2"):
        assert program.add(line) is None
    assert not program.is_still_refused
    assert (program.undo(), program.undo(), program.undo(), program.lines) == (2, 1, 1, ("FWD 1", "FW 2"))


def test_an_unfinished_line_is_kept_and_a_single_wrong_one_is_dropped() -> None:
    program = typed("REPEAT 2 TIMES")
    assert program.batch_was_refused(is_unfinished=True)
    assert (program.lines, program.refusals, program.rejected) == (("REPEAT 2 TIMES",), 1, None)

    for line in ("", "FWD"):
        program.add(line)
    program.delete(1, 1)
    assert not program.batch_was_refused()
    assert (program.lines, program.refusals, program.rejected) == ((), 0, "FWD")


def test_a_mistake_outside_of_the_program_is_no_line_to_correct() -> None:
    program = typed("FW", "TRR 90")
    program.batch_was_refused({0: "TR 90", 3: "FW 1"})

    assert program.add("TR 90") is None
    assert program.lines == ("FW", "TRR 90", "TR 90")


def test_a_statement_that_failed_waits_with_the_lines_after_it_once_it_is_corrected() -> None:
    program = typed("VAR x = 0", "SPEAK 1 / x", "FW 2")
    program.batch_ran()
    program.batch_failed(2)
    assert program.failed_line == 2

    assert program.add("SPEAK 1 / 1") == 2
    assert (program.lines, program.ran) == (("VAR x = 0", "SPEAK 1 / 1", "FW 2"), 1)
    assert program.failed_line is None
    program.wait_from(1)
    assert program.ran == 0


def test_all_lines_have_run_where_no_batch_was_taken() -> None:
    program = typed("A")
    program.take_batch()
    program.batch_ran()
    program.add("B")
    program.batch_ran()

    assert program.ran == 2


# --- changes, breakpoints and what waits


@pytest.mark.parametrize(
    ("change", "breakpoints"),
    [
        (lambda it: it.change(2, "X"), {1, 2, 4}),
        (lambda it: it.insert(2, "X"), {1, 3, 5}),
        (lambda it: it.insert(5, "X"), {1, 2, 4}),
        (lambda it: it.delete(1, 1), {1, 3}),
        (lambda it: it.delete(2, 3), {1, 2}),
        (lambda it: it.rewrite("A\nX\nB\nC\nD\n"), {1, 3, 5}),
        (lambda it: it.move(3, 3, 1), {1, 2, 4}),
        (lambda it: it.delete_waiting(), {1, 2, 4}),
    ],
)
def test_breakpoints_stay_at_their_lines(change: Callable[[Document], object], breakpoints: set[int]) -> None:
    program = typed("A", "B", "C", "D")
    program.breakpoints = frozenset({1, 2, 4})
    change(program)

    assert program.breakpoints == breakpoints


@pytest.mark.parametrize(
    ("change", "ran"),
    [
        (lambda it: it.change(2, "X"), 0),
        (lambda it: it.change(3, "X"), 2),
        (lambda it: it.insert(2, "X"), 0),
        (lambda it: it.insert(3, "X"), 2),
        (lambda it: it.delete(2, 3), 0),
        (lambda it: it.delete(3, 4), 2),
        (lambda it: it.move(4, 4, 2), 0),
        (lambda it: it.move(2, 2, 5), 0),
        (lambda it: it.move(4, 4, 3), 2),
        (lambda it: it.move(3, 3, 5), 2),
        (lambda it: it.rewrite("A\nX\nC\nD"), 0),
        (lambda it: it.rewrite("A\nB\nX\nD"), 2),
        (lambda it: it.delete_waiting(), 2),
    ],
)
def test_a_change_of_a_line_that_ran_lets_all_lines_wait_and_undo_takes_that_back(
    change: Callable[[Document], object], ran: int
) -> None:
    program = typed("A", "B")
    program.batch_ran()
    for line in "CD":
        program.add(line)
    change(program)
    assert program.ran == ran

    program.undo()
    assert (program.lines, program.ran) == (("A", "B", "C", "D"), 2)


@pytest.mark.parametrize(("changed", "ran"), [(1, 0), (2, 0), (3, 2)])
def test_undo_after_a_run_lets_only_a_changed_line_that_ran_wait(changed: int, ran: int) -> None:
    program = typed("A", "B", "C")
    program.change(changed, "X")
    program.batch_ran()
    program.wait_from(3)
    program.undo()

    assert program.ran == ran


def test_undo_of_a_line_that_was_added_leaves_the_lines_before_it_run() -> None:
    program = typed("A", "B")
    program.batch_ran()

    assert (program.undo(), program.ran, program.waiting) == (2, 1, 0)


def test_undo_restores_the_room_that_a_program_takes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(document, "LARGEST", 10)
    program = typed("12345678")
    program.replace("", None)
    program.undo()

    with pytest.raises(ProgramTooLong):
        program.add("x")


@pytest.mark.parametrize(("characters", "paused_at"), [(100_000, None), (100_001, 2)])
def test_a_program_of_more_than_100_000_characters_pauses_at_each_line(
    characters: int, paused_at: int | None
) -> None:
    program = typed("FW 1", "--".ljust(characters - len("FW 1\n\n")))

    assert len(program.text) == characters
    assert program.pausing_line(2, parse) == paused_at
