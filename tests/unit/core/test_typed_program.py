"""The program that is typed: what waits, what has run, what is saved, and the numbers of its lines."""

import pytest

from donnie_tui.core import typed_program
from donnie_tui.core.typed_program import (
    ANOTHER_PROGRAM,
    WORTH_SAVING,
    Batch,
    ProgramTooLong,
    TypedProgram,
)


def typed(*lines: str) -> TypedProgram:
    program = TypedProgram()
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


def test_a_last_line_of_a_batch_is_no_part_of_the_program() -> None:
    program = typed("FW 1")

    assert program.take_batch("QUIT").text == "FW 1\nQUIT"
    assert program.lines == ("FW 1",)


def test_after_a_mistake_one_line_is_forgotten_and_several_are_kept() -> None:
    one, several = typed("FWD 1"), typed("FW 1", "FWD 2")

    assert (one.batch_was_refused(), one.lines) == (False, ())
    assert (several.batch_was_refused(), several.waiting) == (True, 2)


def test_a_line_that_was_forgotten_is_known_until_another_one_is_there() -> None:
    program = typed("FWD 1")
    program.batch_was_refused()
    assert program.refused == "FWD 1"

    program.add("FW 1")
    assert program.refused is None


def test_the_innermost_open_block_is_told_with_its_line_in_the_program() -> None:
    program = typed("FW 1")
    program.batch_ran()
    for line in ("PROCEDURE P DO", "IF 1 == 1 THEN FW 1 END IF", "REPEAT 2 TIMES", "FW 1"):
        program.add(line)
    block = program.open_block

    assert program.depth == 2
    assert block is not None
    assert (block.kind, block.line) == ("REPEAT", 4)


def test_without_an_open_block_there_is_none() -> None:
    assert typed("REPEAT 2 TIMES FW 1 END REPEAT").open_block is None


def test_blank_lines_do_not_wait() -> None:
    assert not typed("", "  ").is_waiting


def test_what_has_not_run_is_forgotten() -> None:
    program = typed("FW 1")
    program.batch_ran()
    program.add("FW 2")

    assert (program.forget_waiting(), program.lines) == (1, ("FW 1",))


def test_a_change_of_what_ran_lets_the_whole_program_wait() -> None:
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
    was_saved = program.saved
    program.was_saved()
    program.add("FWD")
    is_saved = program.saved
    program.forget_waiting()
    program.add("FW 1")

    assert (was_saved, is_saved, program.saved) == (False, False, True)


def test_a_few_lines_are_not_worth_a_question_but_a_changed_file_is() -> None:
    few, many = typed("a"), typed(*["a"] * WORTH_SAVING)
    opened = TypedProgram()
    opened.replace("a\n", "a.gd")
    opened.add("b")

    assert [each.is_worth_saving for each in (few, many, opened, TypedProgram())] == [
        False,
        True,
        True,
        False,
    ]


def test_a_program_takes_no_more_than_a_file_may_hold(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(typed_program, "LARGEST", 10)
    program = typed("12345")

    with pytest.raises(ProgramTooLong):
        program.add("12345")
    assert program.lines == ("12345",)


def test_lines_are_moved_before_another_line_or_behind_the_last() -> None:
    program = typed("A", "B", "C", "D")

    assert program.move(3, 4, 1) == 1
    assert program.lines == ("C", "D", "A", "B")
    assert program.move(1, 1, 5) == 4
    assert program.lines == ("D", "A", "B", "C")
    with pytest.raises(IndexError):
        program.move(1, 2, 2)


def test_every_change_can_be_taken_back_in_turn() -> None:
    program = typed("A", "B", "C")
    program.change(2, "X")
    program.delete(1, 1)
    program.insert(3, "Y")
    program.move(1, 1, 3)
    found = [program.undo() for _ in range(4)]

    assert program.lines == ("A", "B", "C")
    assert found == [1, 3, 1, 2]


def test_a_typed_line_is_taken_back_and_what_ran_before_it_does_not_wait_again() -> None:
    program = typed("A", "B")
    program.batch_ran()
    program.add("SETTTINGS")

    assert (program.undo(), program.lines, program.waiting) == (3, ("A", "B"), 0)
    assert (program.undo(), program.undo(), program.undo(), program.lines) == (2, 1, None, ())


def test_a_program_that_is_written_anew_waits_from_its_first_line_that_is_another_one() -> None:
    """FIX in what waits let the robot do again what it had done."""
    program = typed("FW 30")
    program.batch_ran()
    program.add("TRR 90")

    program.rewrite("FW 30\nTR 90\n")
    assert program.take_batch() == Batch("TR 90", 2, 1)

    program.rewrite("FW 3\nTR 90\n")
    assert program.waiting == 2


def test_taking_back_a_change_loses_no_line_typed_after_it() -> None:
    program = typed("A", "B")
    program.change(1, "X")
    program.add("C")
    program.undo()

    assert (program.lines, program.undo(), program.lines) == (("X", "B"), 1, ("A", "B"))


def test_a_line_that_was_forgotten_after_a_mistake_is_not_taken_back_once_more() -> None:
    program = typed("A")
    program.batch_ran()
    for line in ("", "FWD 1"):
        program.add(line)
    program.batch_was_refused()

    assert (program.lines, program.undo(), program.lines) == (("A",), 1, ())


def test_taking_back_a_change_to_what_has_run_lets_all_wait_again() -> None:
    program = typed("A", "B")
    program.batch_ran()
    program.change(2, "X")
    program.batch_ran()

    assert program.undo() == 2
    assert program.waiting == 2


def test_what_had_run_before_a_change_does_not_wait_again_once_the_change_is_taken_back() -> None:
    program = typed("A", "B")
    program.batch_ran()
    program.change(1, "X")
    program.add("C")
    assert program.waiting == 3

    program.undo()
    program.undo()
    assert (program.lines, program.waiting) == (("A", "B"), 0)


def test_every_change_that_was_taken_back_can_be_made_again() -> None:
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


def test_a_new_change_ends_what_can_be_made_again() -> None:
    program = typed("A")
    program.change(1, "X")
    program.undo()
    program.add("B")

    assert (program.redo(), program.lines) == (None, ("A", "B"))


def test_a_line_made_again_that_had_run_does_not_wait() -> None:
    program = typed("A")
    program.batch_ran()
    program.undo()

    assert (program.redo(), program.lines, program.waiting) == (1, ("A",), 0)


def test_what_ran_in_between_counts_more_than_what_had_run_before_a_change() -> None:
    program = typed("A", "B")
    program.batch_ran()
    program.change(1, "X")
    program.batch_ran()

    program.undo()
    assert program.waiting == 2


def test_another_program_in_its_place_is_taken_back_with_its_file_and_what_was_saved() -> None:
    program = TypedProgram()
    program.replace("A\nB\n", "mine.gd")
    program.breakpoints = frozenset({2})
    program.batch_ran()
    program.add("C")
    program.clear()
    program.add("X")

    assert (program.undo(), program.undo(), program.lines) == (1, ANOTHER_PROGRAM, ("A", "B", "C"))
    assert (program.name, program.saved, program.waiting) == ("mine.gd", False, 1)
    assert program.breakpoints == {2}
    assert (program.undo(), program.lines, program.saved) == (3, ("A", "B"), True)


def test_another_program_that_was_taken_back_is_there_again_by_redo() -> None:
    program = typed("A")
    program.replace("X\n", "other.gd")
    program.undo()
    assert (program.lines, program.name, program.saved) == (("A",), None, False)

    assert program.redo() == ANOTHER_PROGRAM
    assert (program.lines, program.name, program.saved) == (("X",), "other.gd", True)
    assert (program.undo(), program.lines) == (ANOTHER_PROGRAM, ("A",))


def test_an_empty_program_is_nothing_to_come_back_to() -> None:
    program = TypedProgram()
    program.replace("A\n", "mine.gd")

    assert program.undo() is None


def test_what_another_program_took_the_place_of_is_known_while_no_file_has_it() -> None:
    program = typed("A")
    program.replace("X\n", "other.gd")
    program.add("Y")
    program.clear()
    assert program.replaced == (("A\n", None), ("X\nY\n", "other.gd"))

    program.undo()
    assert program.replaced == (("A\n", None),)


def test_no_line_holds_what_a_terminal_would_obey_whichever_word_brought_it() -> None:
    """A pipe may bring anything, and the file and the full screen get the lines as they are."""
    harmful = "SPEAK \x1b[2J\x0c"
    program = typed(harmful, "b")
    program.change(2, harmful)
    program.insert(3, harmful)

    assert set(program.lines) == {"SPEAK  [2J "}
