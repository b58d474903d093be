"""LIST, CHANGE, INSERT, DELETE, MOVE, UNDO: the lines of the program, and wrong arguments of commands."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from donnie_tui.core.run_state import RunState
from tests.unit.commands.scripted import Script

PROGRAM = ("FW 1", "FW 2", "FW 3", "FW 4")

OpenScript = Callable[..., Script]


@pytest.mark.parametrize(
    ("typed", "answers", "lines"),
    [
        ("CHANGE 2 BK 2", ["Line 2: BK 2"], ("FW 1", "BK 2", "FW 3", "FW 4")),
        ("INSERT 1 TR 90", ["Line 1: TR 90"], ("TR 90", *PROGRAM)),
        ("INSERT 5 TR 90", ["Line 5: TR 90"], (*PROGRAM, "TR 90")),
        ("DELETE 2 3", ["Lines 2 to 3 are deleted.", "Line 2: FW 4"], ("FW 1", "FW 4")),
        ("DELETE 4", ["Line 4 is deleted."], PROGRAM[:3]),
        ("DELETE 1 4", ["Lines 1 to 4 are deleted."], ()),
        ("MOVE 4 1", ["Line 1: FW 4"], ("FW 4", *PROGRAM[:3])),
        ("MOVE 1 2 5", ["Line 3: FW 1", "Line 4: FW 2"], ("FW 3", "FW 4", "FW 1", "FW 2")),
    ],
)
def test_a_command_changes_the_lines_and_undo_restores_them(
    open_script: OpenScript, typed: str, answers: list[str], lines: tuple[str, ...]
) -> None:
    script = open_script(*PROGRAM)
    assert script.answers_to(typed) == answers
    assert script.ctx.program.lines == lines

    script.type("UNDO")
    assert script.ctx.program.lines == PROGRAM


@pytest.mark.parametrize(
    ("typed", "answers"),
    [
        (("CHANGE 2 BK 2", "UNDO"), ["Line 2: BK 2", "Line 2: FW 2"]),
        (("INSERT 5 TR 90", "UNDO"), ["Line 5: TR 90", "Your program has 4 lines."]),
        (("REDO", "UNDO"), ["Nothing was changed.", "Nothing was changed."]),
    ],
)
def test_undo_prints_the_first_changed_line(
    open_script: OpenScript, typed: tuple[str, ...], answers: list[str]
) -> None:
    assert open_script(*PROGRAM).answers_to(*typed) == answers


@pytest.mark.parametrize(
    ("typed", "answer", "lines"),
    [
        ((), "Line 1 has run. CHANGE 1 changes it.", ("FW -3",)),
        (("x = 3",), "I don't know what was meant.", ("FW -3", "x = 3")),
        (("FWD 2",), "Line 2: FW 2", ("FW -3", "FW 2")),
        (("FW", "TR 90"), "Line 2: FW 2", ("FW -3", "FW 2", "TR 90")),
    ],
)
def test_fix_changes_no_line_that_ran(
    open_script: OpenScript, typed: tuple[str, ...], answer: str, lines: tuple[str, ...]
) -> None:
    script = open_script("FW -3")
    script.ctx.program.batch_ran()
    for line in typed:
        script.ctx.program.add(line)

    assert script.answers_to("FIX") == [answer]
    assert (script.ctx.program.lines, script.ctx.program.ran) == (lines, 1)


def test_a_line_without_its_text_is_offered_for_editing(open_script: OpenScript) -> None:
    script = open_script(*PROGRAM, answers=["FW 9"])

    assert script.answers_to("CHANGE 3") == ["Line 3: FW 9"]
    assert script.interaction.asked == ["Edit line 3, then Enter. FW 3"]
    assert script.ctx.program.lines == ("FW 1", "FW 2", "FW 9", "FW 4")


@pytest.mark.parametrize(
    ("typed", "number"),
    [
        ("CHANGE 9 FW 1", 9),
        ("DELETE 0", 0),
        ("MOVE 7 1", 7),
        *((f"{word} 99", 99) for word in ("LIST", "READ", "BREAK", "UNTIL")),
    ],
)
def test_a_missing_line_is_reported_with_the_last_one(
    open_script: OpenScript, typed: str, number: int
) -> None:
    script = open_script(*PROGRAM)

    assert script.answers_to(typed) == [f"There is no line {number}. The last is 4."]
    assert script.ctx.program.lines == PROGRAM


NUMBERED = (
    *("BREAK", "UNTIL", "READ", "LIST", "CHANGE", "INSERT", "DELETE", "MOVE", "MAP", "MAP ROW"),
    *("MAP COLUMN", "TRAIL", "LAST", "SPELL", "TYPED"),
)


def test_a_wrong_argument_is_reported_and_changes_nothing(open_script: OpenScript) -> None:
    """Otherwise DELETE would delete another line."""
    script = open_script(*PROGRAM)
    for word in (*NUMBERED, "AROUND", "WATCH"):
        (answer,) = script.answers_to(f"{word} --3")
        assert answer.startswith(f"I did not understand. Type {word}"), word
    assert script.answers_to("DELETE abc", "FIND") == [
        "I did not understand. Type DELETE 2 5.",
        "I did not understand. Type FIND wall.",
    ]

    assert script.ctx.program.lines == PROGRAM
    assert not script.ctx.program.breakpoints


@pytest.mark.parametrize(
    ("typed", "answer"),
    [
        ("listt 2", "I do not know listt. Did you mean LIST?"),
        ("ZOM IN", "I do not know ZOM IN. Did you mean ZOOM IN?"),
    ],
)
def test_a_slip_in_a_word_is_answered_with_that_word_and_runs_nothing(
    open_script: OpenScript, typed: str, answer: str
) -> None:
    script = open_script(*PROGRAM)

    assert script.answers_to(typed) == [answer]
    assert script.ctx.runs.state is RunState.READY


@pytest.mark.parametrize("typed", ["FWW 2", "LISTT"])
def test_a_slip_in_godonnie_or_a_name_of_the_program_is_left_to_the_language(
    open_script: OpenScript, typed: str
) -> None:
    script = open_script("PROCEDURE LISTT DO", "FW 1", "END PROCEDURE", "LISTT")

    assert not script.type(typed)
    assert script.printed == []


# --- copies and comments


@pytest.mark.parametrize(
    ("typed", "lines", "said"),
    [
        ("COPY 1", ["FW 1", "FW 1", "TR 90", "BW 2"], ["Line 2: FW 1"]),
        ("COPY 3 1", ["BW 2", "FW 1", "TR 90", "BW 2"], ["Line 1: BW 2"]),
        ("COPY 1 2 4", ["FW 1", "TR 90", "BW 2", "FW 1", "TR 90"], ["Line 4: FW 1", "Line 5: TR 90"]),
        ("COMMENT 2", ["FW 1", "-- TR 90", "BW 2"], ["Line 2: -- TR 90"]),
        ("COMMENT 1 2", ["-- FW 1", "-- TR 90", "BW 2"], ["Line 1: -- FW 1", "Line 2: -- TR 90"]),
        ("COPY 9", ["FW 1", "TR 90", "BW 2"], None),
        ("COMMENT 2 9", ["FW 1", "TR 90", "BW 2"], None),
        ("COPY 1 9", ["FW 1", "TR 90", "BW 2"], None),
    ],
)
def test_lines_are_copied_and_become_comments(open_script, typed, lines, said) -> None:
    script = open_script("FW 1", "TR 90", "BW 2")

    answers = script.answers_to(typed)

    assert list(script.ctx.program.lines) == lines
    assert answers == said if said else answers[0].startswith("There is no line 9")
    if said:
        script.type("UNDO")
        assert list(script.ctx.program.lines) == ["FW 1", "TR 90", "BW 2"]


def test_a_comment_becomes_a_line_again_and_keeps_its_indentation(open_script) -> None:
    script = open_script("REPEAT 2 TIMES", "  FW 1", "END REPEAT")

    script.type("COMMENT 2")
    assert script.ctx.program.lines[1] == "  -- FW 1"
    script.type("COMMENT 2")
    assert script.ctx.program.lines[1] == "  FW 1"
