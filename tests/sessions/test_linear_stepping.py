"""Typed lines that step through a program in the linear mode, forwards, backwards and with breakpoints."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.sessions.typed_lines import answers_to, printed_by

pytestmark = pytest.mark.slow


def test_a_step_over_a_call_counts_the_round(tmp_path: Path) -> None:
    """The number of the round stays right."""
    program = ("PROCEDURE song: a DO", "TR a", "END PROCEDURE", "REPEAT 3 TIMES", "song [10]", "END REPEAT")
    lines = answers_to(tmp_path, *program, "STEP", "", "", "OVER", "", "OVER", "", "OVER")

    assert [line for line in lines if line.startswith("Round")] == [f"Round {n} of 3." for n in (1, 2, 3)]


def test_a_pause_in_a_loop_is_printed_without_a_wrong_round(tmp_path: Path) -> None:
    """A breakpoint in the loop acts like a pause: earlier rounds were not counted."""
    program = ("FOR VAR k = 0; k < 9; k = k + 1 DO", "FW 1", "SPEAK k", "END FOR")
    lines = answers_to(tmp_path, *program, "BREAK 2", "RUN", "BREAK 2", "STEP", "", "", "", "STOP")

    assert "Next round." not in lines
    assert [line for line in lines if line.startswith("Round")] == []


def test_a_program_that_has_run_is_stepped_through_from_the_start(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "FW 1", "FW 2", "RUN", "STEP", "", "STOP", "RESET", "UNTIL 2", "STOP")[
        2:8
    ] == [
        "From the start again.",
        "Line 1: FW 1",
        "I walked 1 step forward.",
        "Line 2: FW 2",
        "Stopped at line 2.",
        "I am back at the start.",
    ]


def test_steps_have_the_same_lines_backwards_as_forwards(tmp_path: Path) -> None:
    """Lines, conditions, rounds and earlier variables. Parts that were not stepped, event by event."""
    program = ("VAR x = 1", "WHILE x < 3 DO", "x = x + 1", "FW x", "END WHILE")
    lines = answers_to(
        tmp_path, *program, "STEP", "", "", "", "", *["STEP BACK"] * 6, "CONTINUE", *["STEP BACK"] * 3
    )

    assert lines[8:23] == [
        "Looking back. The robot stays where it is.",
        "Before FW x: position 0, 0.",
        "Line 4: FW x",
        "Back.",
        "x is 1.",
        "1 is less than 3: true.",
        "Round 1.",
        "Line 3, level 1: x = x + 1",
        "Back.",
        "Line 2: WHILE x < 3 DO",
        "Back.",
        "x has no value yet.",
        "Line 1: VAR x = 1",
        "Back: start of the program.",
        "This is the start.",
    ]
    assert lines[26:29] == [
        "Back: end of the program. Position 0, 5.",
        "Before FW x: position 0, 2.",
        "x is 2.",
    ]


def test_a_procedure_that_was_stepped_over_is_undone_as_one_step(tmp_path: Path) -> None:
    program = (
        "PROCEDURE song: a DO",
        "REPEAT 9 TIMES",
        "TR a",
        "END REPEAT",
        "END PROCEDURE",
        "song [10]",
        "FW 1",
    )
    lines = answers_to(tmp_path, *program, "STEP", "", "OVER", "STEP BACK")

    back = lines[lines.index("Line 7: FW 1") + 1 :]
    assert [line.split(":")[0] for line in back[1:7]] == [*["Before TR a"] * 5, "Back"]
    assert back[6:8] == ["Back: 4 more.", "Line 6: song [10]"]


def test_all_answers_are_about_the_moment_to_which_step_back_leads(tmp_path: Path) -> None:
    """The robot stays; the next Enters lead to the present, which is said, and only then it walks."""
    program = ("VAR x = 1", "FW 1", "x = 5", "FW x")
    typed = (
        "STEP",
        "",
        "",
        "",
        *["STEP BACK"] * 3,
        "WHERE",
        "SHOW VARIABLES",
        "",
        "WHERE",
        "",
        "",
        "",
        "WHERE",
    )
    lines = answers_to(tmp_path, *program, *typed)

    at = lines.index("Before FW 1: position 0, 0.")
    assert lines[at:] == [
        "Before FW 1: position 0, 0.",
        "Line 2: FW 1",
        "Back.",
        "x has no value yet.",
        "Line 1: VAR x = 1",
        "Position 0, 0. Facing north.",
        "There are no variables.",
        "Line 2: FW 1",
        "Position 0, 0. Facing north.",
        "I walked 1 step forward.",
        "Line 3: x = 5",
        "Line 4: FW x",
        "You are back in the present.",
        "I walked 5 steps forward.",
        "Done.",
        "Position 0, 6. Facing north.",
    ]


def test_looking_around_ends_the_way_back(tmp_path: Path) -> None:
    lines = answers_to(tmp_path, "FW 1", "FW 2", "STEP", "", "STEP BACK", "AROUND", "WHERE", "STOP")

    at = lines.index("You are back in the present.")
    assert lines[at + 1].endswith("within 10 steps.") and "Position 0, 1. Facing north." in lines[at:]


def test_a_breakpoint_without_a_command_moves_to_the_next_one(tmp_path: Path) -> None:
    lines = answers_to(
        tmp_path, "BREAK 1", "REPEAT 2 TIMES", "FW 1", "END REPEAT", "FW 2", "BREAK 3", "RUN", "STOP"
    )

    assert lines[:3] == [
        "There are no lines yet.",
        "No command begins on line 3, so I can't stop there.",
        "Breakpoint at line 4.",
    ]
    assert lines[5:7] == ["Line 4: FW 2", "Stopped at line 4."]
    assert (
        answers_to(tmp_path, "FW 1", "-- end", "BREAK 2")[0]
        == "No command begins on line 2, so I can't stop there."
    )


def test_a_line_that_is_refused_while_held_is_reported(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "FW 1", "FW 2", "STEP", "FW 9", "STOP")[1:3] == [
        "I can't do this now: FW 9",
        "Enter continues. RUN runs the rest. STOP ends.",
    ]


def test_breakpoints_stay_with_their_program_and_are_announced_when_it_opens(tmp_path: Path) -> None:
    (tmp_path / "walk.gd").write_text("FW 1\nFW 2\n")
    (tmp_path / "other.gd").write_text("TR 90\nTR 90\nTR 90\n")
    first = answers_to(
        tmp_path, "OPEN walk.gd", "BREAK 2", "INSERT 1 TR 90", "BREAK", "SAVE", "OPEN other.gd", "BREAK"
    )
    again = answers_to(tmp_path, "OPEN walk.gd", "BREAK")

    assert "Breakpoints: 3." in first
    assert first[-1] == "There are no breakpoints."
    assert again == ["Opened walk.gd, 3 lines.", "Breakpoints: 3.", "Breakpoints: 3."]


def test_a_step_back_to_the_start_of_a_typed_program_names_no_file(tmp_path: Path) -> None:
    typed = ["PF 2", "EXECUTAR", "PASSO ATRÁS", "PASSO ATRÁS", "PASSO ATRÁS", "NOVO"]

    assert "De volta: começo do programa." in printed_by(tmp_path, "pt", typed)


def test_only_what_can_be_a_variable_is_watched(tmp_path: Path) -> None:
    assert answers_to(tmp_path, "WATCH 3", "WATCH x y", "WATCH lado", "WATCH") == [
        "I did not understand. Type WATCH x.",
        "I did not understand. Type WATCH x.",
        "I will say when lado changes.",
        "I will say when lado changes.",
    ]


def test_the_tour_leads_to_a_challenge_that_one_command_solves(tmp_path: Path) -> None:
    lines = answers_to(tmp_path, "TOUR", *[""] * 9, "FW 5", "")

    at = lines.index("Enter begins it. One command solves it.")
    assert lines[at + 1 : at + 3] == [
        "Challenge: The first walk. World: First room.",
        "Walk 5 steps to the north.",
    ]
    assert lines[-2:] == ["Solved, in 1 command.", "NEXT CHALLENGE is: To the ball."]


def test_enter_turns_the_page_of_the_tour_after_step_and_save_is_possible_there(tmp_path: Path) -> None:
    pages = [""] * 7
    lines = answers_to(tmp_path, "FW 1", "FW 2", "RUN", "TOUR", *pages, "STEP", "", "SAVE kept")

    assert lines[lines.index("From the start again.") :] == [
        "From the start again.",
        "Line 1: FW 1",
        "Stopped at line 1.",
        "Type SAVE first: your program is kept.",
        "OPEN first brings it back.",
        "HELP has all words, QUIT leaves.",
        "That was the tour. Now a first task:",
        "Enter begins it. One command solves it.",
        "Saved kept.gd, 2 lines.",
    ]
