"""AGAIN, STOP, UNTIL, BREAK, WATCH, SPEED, and GoDonnie that is typed between them."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from donnie_tui.core.run_state import RunState
from tests.unit.commands.scripted import Script

WAITING = ("WHILE 1 == 1 DO", "WAIT 1000", "END WHILE")

OpenScript = Callable[..., Script]


# --- running


def test_a_program_begins_at_the_start_with_nothing_remembered(open_script: OpenScript) -> None:
    script = open_script("VAR a = 2", "FW a")

    assert script.answers_to("AGAIN", "AGAIN", "WHERE") == [
        "I walked 2 steps forward.",
        "I walked 2 steps forward.",
        "Position 0, 2. Facing north.",
    ]


def test_typed_godonnie_continues_where_the_robot_stands_with_the_variables(open_script: OpenScript) -> None:
    assert open_script().answers_to("VAR a = 3 FW 2", "FW a", "WHERE")[1:] == [
        "I walked 3 steps forward.",
        "Position 0, 5. Facing north.",
    ]


def test_only_godonnie_without_output_is_answered_with_done(open_script: OpenScript) -> None:
    script = open_script()

    assert script.answers_to("VAR a = 3") == ["Done."]
    for typed in ("SPEAK a", "FWD 1", "WATCH a", "a = 4"):
        answers = script.answers_to(typed)
        assert answers and "Done." not in answers, typed


def test_an_unused_sensor_value_is_a_hint_for_a_program_and_a_typed_command(open_script: OpenScript) -> None:
    script, hint = open_script("DISTANCE F"), "DISTANCE alone does nothing."

    assert script.answers_to("AGAIN")[0] == hint
    assert script.answers_to("DISTANCE F")[0] == hint
    assert hint not in script.answers_to("GRIP")


WITHIN = "The program ran up to the mistake in line 2, 1 line did not run."


@pytest.mark.parametrize(
    ("lines", "answer"),
    [
        (["SPEAK 1 / 0"], "Nothing ran, line 1 failed."),
        (["FW 1", "SPEAK 1 / 0"], "1 line ran, line 2 failed."),
        (["SPEAK 1 / 0", "", "FW 1"], "Line 1 failed, 1 line did not run."),
        (
            ["FW 1", "", "TR 90", "SPEAK 1 / 0", "", "FW 1", "FW 2"],
            "2 lines ran, line 4 failed, 2 lines did not run.",
        ),
        (["SPEAK 1 SPEAK 1 / 0"], "The program ran up to the mistake in line 1."),
        (["REPEAT 2 TIMES", "SPEAK 1 / 0", "END REPEAT"], "The program ran up to the mistake in line 2."),
        (
            ["FW 1", "REPEAT 2 TIMES", "FW 1", "SPEAK 1 / 0", "END REPEAT", "FW 2"],
            "The program ran up to the mistake in line 4, 1 line did not run.",
        ),
        (
            ["SPEAK 1 SPEAK 1 / 0", "FW 1", "FW 2"],
            "The program ran up to the mistake in line 1, 2 lines did not run.",
        ),
        (["REPEAT 2 TIMES", "SPEAK 1 / 0", "END REPEAT", "", "FW 1"], WITHIN),
        (
            ["PROCEDURE P DO", "SPEAK 1 / 0", "END PROCEDURE", "P []", "FW 1"],
            "3 lines ran, line 4 failed, 1 line did not run.",
        ),
        (["PROCEDURE P DO", "SPEAK 1 / 0", "END PROCEDURE", "P []"], "3 lines ran, line 4 failed."),
        (
            ["PROCEDURE P DO SPEAK 1 / 0 END PROCEDURE", "PROCEDURE Q DO P [] END PROCEDURE", "Q []"],
            "2 lines ran, line 3 failed.",
        ),
    ],
)
def test_after_a_failure_it_is_said_what_ran_and_what_did_not(
    open_script: OpenScript, lines: list[str], answer: str
) -> None:
    script = open_script(*lines)
    script.interaction.until_over = script.rest

    assert script.answers_to("AGAIN")[-1] == answer


def test_a_program_that_is_stopped_or_ends_says_nothing_about_lines(open_script: OpenScript) -> None:
    script = open_script("FW 1", "TR 90")
    script.interaction.until_over = script.rest

    assert script.answers_to("AGAIN") == ["I walked 1 step forward.", "I turned 90 degrees to the right."]


@pytest.mark.parametrize(
    ("typed", "answer"), [("STOP", "Nothing is running."), ("AGAIN", "There is nothing to run.")]
)
def test_stopping_or_running_nothing_is_answered(open_script: OpenScript, typed: str, answer: str) -> None:
    assert open_script().answers_to(typed) == [answer]


def test_while_a_program_runs_others_and_files_wait_until_it_is_stopped(open_script: OpenScript) -> None:
    script = open_script(*WAITING, speed=1.0)
    script.type("AGAIN")
    for typed in ("AGAIN", "OPEN walk.gd", "RESET"):
        script.type(typed)
        assert script.printed[-1] == "A program is running. STOP stops it.", typed

    script.type("STOP")
    script.rest()
    assert script.printed[-1].startswith("Stopped")
    assert script.ctx.runs.state is RunState.READY


def test_the_speed_can_be_changed_and_is_reported(open_script: OpenScript) -> None:
    script = open_script(speed=5.0)

    assert script.answers_to("FASTER", "SLOWER", "SLOWER", "speed max", "SPEED fast") == [
        "Speed 10.",
        "Speed 5.",
        "Speed 2.",
        "Speed max.",
        "A speed is a number from 0.1 to 1000, or max.",
    ]
    assert script.donnie.session.speed is None


# --- holding


def test_until_takes_a_line_and_refuses_one_that_is_not_there(open_script: OpenScript) -> None:
    assert open_script("FW 1", "FW 2").answers_to("UNTIL 9", "UNTIL 2") == [
        "There is no line 9. The last is 2.",
        "I walked 1 step forward.",
        "Line 2: FW 2",
    ]


def test_a_breakpoint_set_while_the_program_is_held_counts(open_script: OpenScript) -> None:
    script = open_script("FW 1", "SPEAK 2", "FW 1", "SPEAK 4")

    assert script.answers_to("BREAK 2", "AGAIN", "BREAK 4", "CONTINUE") == [
        "Breakpoint at line 2.",
        "I walked 1 step forward.",
        "Line 2: SPEAK 2",
        "Breakpoint at line 4.",
        "Continuing.",
        "2",
        "I walked 1 step forward.",
        "Line 4: SPEAK 4",
    ]
    assert script.answers_to("CONTINUE") == ["Continuing.", "4"]


# --- watching


def test_a_watched_variable_is_printed_at_each_change_and_no_other(open_script: OpenScript) -> None:
    script = open_script("VAR a = 3", "VAR b = 1", "a = a + 1", "FW 1", "a = 7")

    assert script.answers_to("WATCH a", "AGAIN") == [
        "I will say when a changes.",
        "a is 3.",
        "a is 4.",
        "I walked 1 step forward.",
        "a is 7.",
    ]
    assert script.answers_to("WATCH a", "AGAIN") == [
        "I will no longer say when a changes.",
        "I walked 1 step forward.",
    ]


# --- stepping, and looking back


def test_a_held_program_is_stepped_and_looked_back_at(open_script: OpenScript) -> None:
    script = open_script("FW 1", "SPEAK 2", "TR 90", "SPEAK 3")
    for typed, answers in (
        ("BREAK 2", ["Breakpoint at line 2."]),
        ("BREAK 2", ["Line 2 has no breakpoint now."]),
        ("BREAK 3", ["Breakpoint at line 3."]),
        ("BREAK", ["Breakpoints: 3."]),
        ("AGAIN", ["I walked 1 step forward.", "2", "Line 3: TR 90"]),
        ("SHOW VARIABLES", ["There are no variables."]),
        ("WHERE", ["Position 0, 1. Facing north."]),
        ("AGAIN", ["A program is running. STOP stops it."]),
        ("STEP", ["I turned 90 degrees to the right.", "Line 4: SPEAK 3"]),
        ("OVER", ["3", "Done."]),
        (
            "STEP BACK",
            [
                "Looking back. The robot stays where it is.",
                "Back: end of the program. Position 0, 1.",
                *("Back: 3.", "Line 4: SPEAK 3"),
            ],
        ),
        ("STEP BACK", ["Before TR 90: facing north.", "Line 3: TR 90"]),
        ("STEP", ["I turned 90 degrees to the right.", "Line 4: SPEAK 3"]),
        ("CONTINUE", ["Nothing is running."]),
    ):
        assert (typed, script.answers_to(typed)) == (typed, answers)


@pytest.mark.parametrize(
    ("said", "back", "again"),
    [
        (5, ["Back: 5.", "Back: 4.", "Back: 3.", "Back: 2.", "Back: 1."], ["1", "2", "3", "4", "5"]),
        (
            7,
            ["Back: 7.", "Back: 6.", "Back: 5.", "Back: 4.", "Back: 3.", "Back: 2 more."],
            ["1", "2", "3", "4", "5", "2 more."],
        ),
    ],
)
def test_of_a_step_that_did_much_the_first_five_are_undone_and_redone_in_words(
    open_script: OpenScript, said: int, back: list[str], again: list[str]
) -> None:
    speak = " ".join(f"SPEAK {each}" for each in range(1, said + 1))
    script = open_script("PROCEDURE P DO", speak, "END PROCEDURE", "P []", "SPEAK 8")
    for typed in ("BREAK 4", "AGAIN", "OVER"):
        script.answers_to(typed)

    assert script.answers_to("STEP BACK") == [
        "Looking back. The robot stays where it is.",
        *back,
        "Line 4: P []",
    ]
    assert script.answers_to("STEP") == [*again, "Line 5: SPEAK 8", "You are back in the present."]


def test_run_continues_what_is_held_and_a_stop_says_where(open_script: OpenScript) -> None:
    script = open_script("FW 1", "SPEAK 2", "SPEAK 3")
    script.answers_to("STEP", "STEP")

    assert script.answers_to("RUN") == ["2", "3"]
    script.answers_to("STEP", "STEP")
    assert script.answers_to("STOP") == ["Stopped at line 2."]
    assert script.answers_to("RESET", "WHERE") == ["I am back at the start.", "Position 0, 0. Facing north."]


@pytest.mark.parametrize(("typed", "speed"), [("0.1", 0.1), ("1000", 1000.0), ("2.5", 2.5)])
def test_a_speed_may_be_from_a_tenth_to_a_thousand(open_script: OpenScript, typed: str, speed: float) -> None:
    script = open_script()

    assert script.answers_to(f"SPEED {typed}", "SPEED") == [f"Speed {typed}."] * 2
    assert script.donnie.session.speed == speed
    for wrong in ("0.09", "1000.1", "0", "-1"):
        assert script.answers_to(f"SPEED {wrong}") == ["A speed is a number from 0.1 to 1000, or max."]
    assert script.donnie.session.speed == speed
