"""AGAIN, STOP, UNTIL, BREAK, WATCH, SPEED, and GoDonnie that is typed between them."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from donnie_tui.commands.context import FAILED
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
        before = len(script.printed)
        script.type(typed)
        assert "A program is running. STOP stops it." in script.printed[before:], typed

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


# --- what waits after a mistake, and what runs while nothing can

REFUSED = ["Error, line 2, column 1: I do not know FWD.", "Line 2: FWD 1", "Did you mean FW?"]
STILL_WRONG = "Line 2 is still wrong. 2 lines wait. ERROR says why."
DROPS = "DELETE without a number forgets the 2 lines that did not run."
OPEN_BLOCK = [
    *("Error, line 2, column 1: REPEAT has no END REPEAT.", "Line 2: REPEAT 2 TIMES"),
    "Write END REPEAT where it ends.",
]
BATCHES: dict[str, tuple[tuple[str, ...], tuple[tuple[str, list[str]], ...], tuple[str, ...], int]] = {
    "several lines wait until they are deleted": (
        ("FWD 1", "FW 2"),
        (
            ("RUN", [*REFUSED, "Nothing ran, 2 lines wait. FIX corrects line 2."]),
            ("RUN", [STILL_WRONG, DROPS]),
            ("RUN", [STILL_WRONG]),
            ("RUN", [STILL_WRONG]),
            ("DELETE", ["Lines 2 to 3 are deleted."]),
            ("RUN", ["There is nothing to run."]),
        ),
        *(("FW 1",), 1),
    ),
    "a single line is dropped": (
        ("FWD 1",),
        (("RUN", [*REFUSED, "Nothing ran, line 2 was dropped."]), ("RUN", ["There is nothing to run."])),
        *(("FW 1",), 1),
    ),
    "an open block waits for its end": (
        ("REPEAT 2 TIMES", "FW 1"),
        (
            ("RUN", [*OPEN_BLOCK, "Nothing ran, 2 lines wait."]),
            ("RUN", [STILL_WRONG, DROPS]),
        ),
        *(("FW 1", "REPEAT 2 TIMES", "FW 1"), 1),
    ),
    "only new mistakes are said": (
        ("zzzz qqqq", "FW 1", "FWD 3"),
        (
            (
                "RUN",
                [
                    *("Error, line 2, column 1: I do not know zzzz.", "Line 2: zzzz qqqq"),
                    *("Error, line 4, column 1: I do not know FWD.", "Line 4: FWD 3", "Did you mean FW?"),
                    "Nothing ran, 3 lines wait. Type line 2 again, or DELETE 2.",
                ],
            ),
            ("CHANGE 4 FWD 4", ["Line 4: FWD 4"]),
            (
                "RUN",
                [
                    *("Error, line 2, column 1: I do not know zzzz.", "Line 2: zzzz qqqq"),
                    *("Error, line 4, column 1: I do not know FWD.", "Line 4: FWD 4", "Did you mean FW?"),
                    "Nothing ran, 3 lines wait. FIX corrects line 4.",
                ],
            ),
        ),
        *(("FW 1", "zzzz qqqq", "FW 1", "FWD 4"), 1),
    ),
    "a failure ends a batch": (
        ("FW 2", "SPEAK 1 / 0", "FW 2"),
        (
            (
                "RUN",
                [
                    *("I walked 2 steps forward.", "Error, line 3, column 7: I can't divide by zero."),
                    *("Line 3: SPEAK 1 / 0", "1 line ran, line 3 failed, 1 line did not run."),
                ],
            ),
            ("RUN", ["There is nothing to run."]),
        ),
        *(("FW 1", "FW 2", "SPEAK 1 / 0", "FW 2"), 4),
    ),
}  # fmt: skip


@pytest.mark.parametrize("subject", BATCHES)
def test_of_waiting_lines_it_is_said_what_ran_and_what_waits(open_script: OpenScript, subject: str) -> None:
    added, conversation, lines, ran = BATCHES[subject]
    script = open_script("FW 1")
    script.interaction.until_over = script.rest
    assert script.answers_to("RUN") == ["I walked 1 step forward."]
    for line in added:
        script.ctx.program.add(line)

    for typed, answers in conversation:
        assert (typed, script.answers_to(typed)) == (typed, answers)
    assert (script.ctx.program.lines, script.ctx.program.ran) == (lines, ran)


def test_while_a_program_runs_only_what_needs_no_other_is_possible(open_script: OpenScript) -> None:
    script = open_script(*WAITING, speed=1.0)
    script.type("AGAIN")
    begun = len(script.printed)
    busy = ("STEP", "OVER", "STEP BACK", "UNTIL 1", "RUN", "START", "TOGETHER")
    for typed in (*busy, "SPEED 2", "FASTER", "STOP"):
        script.type(typed)
    script.rest()

    *answers, stopped = [each for each in script.printed[begun:] if not each.startswith("Waiting")]
    assert answers == [*["A program is running. STOP stops it."] * len(busy), "Speed 2.", "Speed 5."]
    assert stopped.startswith("Stopped")  # before its first line, or at one


@pytest.mark.parametrize("typed", ["START", "RUN", "AGAIN", "STEP", "TOGETHER"])
def test_no_program_begins_while_a_client_drives_another_robot(open_script: OpenScript, typed: str) -> None:
    script = open_script("FW 1", world="two_robots")
    script.donnie.session.is_taken = lambda: True

    assert script.answers_to(typed) == ["Another program drives a robot here."]
    assert script.ctx.program.waiting == 1
    assert script.ctx.script_code == FAILED


def test_a_program_is_run_to_the_next_line_with_a_command(open_script: OpenScript) -> None:
    script = open_script("FW 1", "", "FW 2", "REPEAT 2 TIMES", "FW 1", "END REPEAT")
    nowhere = "No command begins on line {}, so I can't stop there."

    assert script.answers_to("UNTIL 1") == ["Line 1: FW 1"]
    assert script.answers_to("UNTIL 2") == [
        *(nowhere.format(2), "I walked 1 step forward.", "Line 3: FW 2"),
    ]
    assert script.answers_to("UNTIL 6") == [nowhere.format(6)]
    assert script.answers_to("STOP") == ["Stopped at line 3."]


def test_a_step_begins_again_once_the_program_is_over(open_script: OpenScript) -> None:
    script = open_script("FW 1", "FW 2")
    script.interaction.until_over = script.rest

    assert script.answers_to("RUN") == ["I walked 1 step forward.", "I walked 2 steps forward."]
    assert script.answers_to("STEP", "STEP", "OVER", "UNTIL 2", "STOP") == [
        *("From the start again.", "Line 1: FW 1"),
        *("I walked 1 step forward.", "Line 2: FW 2"),
        *("I walked 2 steps forward.", "Done."),
        *("From the start again.", "I walked 1 step forward.", "Line 2: FW 2"),
        "Stopped at line 2.",
    ]


def test_variables_are_those_of_the_moment_that_is_looked_at(open_script: OpenScript) -> None:
    script = open_script("VAR a = 1", "WHILE 1 == 1 DO", "a = 2", "END WHILE")
    script.answers_to("STEP", "STEP")
    assert script.answers_to("SHOW VARIABLES") == ["a is 1."]
    script.answers_to("STEP", "STEP")
    assert script.answers_to("SHOW VARIABLES") == ["a is 2."]
    script.answers_to("STEP BACK")
    assert script.answers_to("SHOW VARIABLES") == ["a is 1."]
    assert script.answers_to("STOP", "SHOW VARIABLES") == ["Stopped at line 2.", "a is 2."]


def test_open_calls_are_said_before_the_variables_of_the_innermost(open_script: OpenScript) -> None:
    script = open_script(
        *("PROCEDURE P: a DO", "SPEAK a", "END PROCEDURE"),
        *("PROCEDURE Q DO", "VAR b = 3", "P [4]", "END PROCEDURE", "Q []"),
    )
    script.answers_to("BREAK 2", "AGAIN")

    assert script.answers_to("SHOW VARIABLES") == ["In P, line 2.", "In Q, line 6.", "a is 4."]
    assert script.answers_to("STOP") == ["Stopped at line 2."]


@pytest.mark.parametrize(("last", "ran"), [("SPEAK 7", 2), ("FWD 7", 0)])
def test_a_program_in_the_background_has_run_unless_it_was_refused(
    open_script: OpenScript, last: str, ran: int
) -> None:
    script = open_script("FW 1", last)
    script.interaction.is_attended = False
    said = script.answers_to("START")

    assert (script.ctx.program.ran, script.ctx.program.waiting) == (ran, 2 - ran)
    assert said[0].startswith("Error, line 2") if not ran else said[-1] == "7"


def test_each_program_of_those_that_ran_together_has_run(open_script: OpenScript) -> None:
    script = open_script("FW 1", world="two_robots")
    script.interaction.until_over = script.rest
    alice, bob = "alice: I walked 1 step forward.", "bob: I walked 2 steps forward."

    assert script.answers_to("TOGETHER") == [alice]
    assert script.answers_to("ROBOT bob", "INSERT 1 FW 2") == ["Now you talk to bob.", "Line 1: FW 2"]
    assert sorted(script.answers_to("TOGETHER")) == [alice, bob]
    assert [each.ran for each in script.ctx.workspace.by_robot().values()] == [1, 1]


def test_a_program_that_was_refused_has_not_run_with_the_others(open_script: OpenScript) -> None:
    script = open_script("FW 1", world="two_robots")
    script.interaction.until_over = script.rest
    script.answers_to("ROBOT bob", "INSERT 1 FWD 2", "TOGETHER")

    assert {name: each.ran for name, each in script.ctx.workspace.by_robot().items()}["bob"] == 0


def test_a_stop_of_nothing_says_which_lines_wait(open_script: OpenScript) -> None:
    script = open_script("FW 1", "FW 2")
    script.interaction.until_over = script.rest

    assert script.answers_to("STOP") == ["Nothing is running.", "2 lines wait. DELETE drops them."]
    script.answers_to("RUN")
    assert script.answers_to("STOP") == ["Nothing is running."]


def test_watched_variables_are_listed(open_script: OpenScript) -> None:
    assert open_script().answers_to("WATCH a", "WATCH b", "WATCH", "WATCH a", "WATCH")[2:] == [
        *("I will say when a changes.", "I will say when b changes."),
        *("I will no longer say when a changes.", "I will say when b changes."),
    ]


def test_the_robot_that_is_reset_is_named_where_there_are_several(open_script: OpenScript) -> None:
    assert open_script(world="two_robots").answers_to("RESET") == ["alice: I am back at the start."]
