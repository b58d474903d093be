"""The linear mode for a learner who pauses, steps, reads page by page and completes words."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.sessions.command import QUIET, donnie
from tests.sessions.learner import Learner

pytestmark = pytest.mark.slow

TAB, SHIFT_TAB = "\t", "\x1b[Z"
SQUARE = ("REPEAT 2 TIMES", "FW 2", "TR 90", "END REPEAT")


def enter_and_wait(learner: Learner, *lines: str) -> None:
    """Enter the lines, then wait for the prompt."""
    learner.enters(*lines)
    learner.sees_prompt()


# --- while a program runs


def test_typed_words_pause_resume_and_stop_a_running_program(tmp_path: Path) -> None:
    learner = Learner(tmp_path, speed="1")
    learner.enters("FW 100", "")
    learner.types("PAUSE\r")
    learner.sees("Paused at line 1.")
    learner.types("WHERE\r")
    learner.sees("Facing north.\r\n> ")
    learner.types("CONTINUE\r")
    learner.types("STOP\r")
    learner.sees("Stopped at line 1.\r\n> ")


def test_the_speed_of_a_running_program_changes_at_once(tmp_path: Path) -> None:
    learner = Learner(tmp_path, speed="0.1")
    learner.enters("FW 9", "")
    learner.types("FASTER\r")
    learner.sees("Speed 1.")
    learner.types("SPEED max\r")
    learner.sees("Speed max.")
    learner.sees("I walked 9 steps forward.\r\n> ")


def test_a_line_that_is_no_word_for_a_running_program_waits_for_its_end(tmp_path: Path) -> None:
    learner = Learner(tmp_path, speed="20")
    learner.enters("FW 20", "")
    learner.types("WHERE\r")
    learner.sees("I walked 20 steps forward.\r\n> WHERE\r\nPosition 0, 20. Facing north.\r\n> ")


# --- stepping


def test_steps_print_levels_rounds_and_changes(learner: Learner) -> None:
    learner.enters("VAR x = 1", *SQUARE[:2], "x = x + 1", "END REPEAT", "WATCH x", "STEP")
    learner.sees("Line 1: VAR x = 1\r\n> ")
    learner.types("\r")
    learner.sees("x is 1.\r\nLine 2: REPEAT 2 TIMES\r\n> ")
    learner.types("\r")
    learner.sees("Round 1 of 2.\r\nLine 3, level 1: FW 2\r\n> ")
    learner.types("\r")
    learner.sees("I walked 2 steps forward.\r\nLine 4: x = x + 1\r\n> ")
    learner.types("STEP BACK\r")
    learner.sees("Before FW 2: position 0, 0.\r\nRound 1 of 2.\r\nLine 3, level 1: FW 2\r\n> ")
    learner.types("UNTIL 4\r")
    learner.sees("x is 2.\r\nI walked 2 steps forward.\r\nLine 4: x = x + 1\r\n> ")
    learner.types("RUN\r")
    learner.sees("x is 3.\r\n> ")
    learner.types("SHOW VARIABLES\r")
    learner.sees("x is 3.\r\n> ")


def test_a_program_holds_at_its_breakpoints_and_procedures_are_stepped_over(learner: Learner) -> None:
    learner.enters("PROCEDURE P DO", "FW 1", "END PROCEDURE", "P []", "TR 90")
    enter_and_wait(learner, "BREAK 4")
    learner.types("AGAIN\r")
    learner.sees("Line 4: P []\r\n> ")
    learner.types("OVER\r")
    learner.sees("I walked 1 step forward.\r\nLine 5: TR 90\r\n> ")
    learner.types("STOP\r")
    learner.sees("Stopped at line 5.\r\n> ")


def test_a_condition_is_printed_with_the_compared_values(learner: Learner) -> None:
    learner.enters("VAR x = 3", "IF x > 2 THEN", "FW 1", "END IF", "STEP")
    learner.sees("Line 1: VAR x = 3\r\n> ")
    learner.types("\r")
    learner.sees("Line 2: IF x > 2 THEN\r\n> ")
    learner.types("\r")
    learner.sees("3 is greater than 2: true.\r\nLine 3, level 1: FW 1\r\n> ")


def test_the_last_step_names_the_reason_and_the_end_of_the_program(learner: Learner) -> None:
    """Otherwise Enter, pressed for the next step, would get no answer."""
    learner.enters("FOR VAR i = 1; i <= 1; i = i + 1 DO", "FW i", "END FOR", "STEP")
    learner.enters("", "")
    learner.sees("Line 1, level 0: FOR VAR i = 1; i <= 1; i = i + 1 DO\r\n> ")
    learner.types("\r")
    learner.sees("2 is at most 1: false.\r\nDone.\r\n> ")
    learner.types("STEP BACK\r")
    learner.sees("Back: end of the program. Position 0, 1.\r\nLine 1")


# --- typing


def test_tab_completes_a_word_silently_and_lists_the_others(learner: Learner) -> None:
    learner.sees_prompt()
    learner.types("whe")
    learner.sees("whe")
    learner.types(TAB)
    learner.sees("re ")
    learner.types("\r")
    learner.sees("Position 0, 0. Facing north.\r\n> ")
    learner.types("EXP" + TAB[:0])
    learner.types(TAB)
    learner.sees("LAIN ")
    learner.types("\r")
    learner.sees("There are no errors.\r\n> ")
    learner.types("MAP")
    learner.sees("MAP")
    learner.types(TAB)
    learner.sees("4 words.\r\nMAP\r\nMAP COLUMN\r\nMAP PICTURE\r\nMAP ROW\r\n> MAP")
    learner.types(" 1 1\r")
    learner.sees("1, 1: free. 1 right, 1 ahead.\r\n> ")


def test_tab_inside_a_pasted_line_is_a_blank(learner: Learner) -> None:
    learner.sees_prompt()
    learner.types("FW\t3\r\r")
    learner.sees("I walked 3 steps forward.\r\n> ")


def test_the_number_of_an_earlier_line_repeats_it(learner: Learner) -> None:
    learner.enters("FW 3", "", "WHERE", "TYPED 2")
    learner.sees("1: FW 3\r\n2: WHERE\r\nType a number to choose.\r\n> ")
    learner.types("2\r")
    learner.sees("2: WHERE\r\nPosition 0, 3. Facing north.\r\n> ")


def test_enter_runs_each_complete_line_where_that_is_set(learner: Learner) -> None:
    enter_and_wait(learner, "SET enter runs")
    learner.types("FW 3\r")
    learner.sees("I walked 3 steps forward.\r\n> ")
    learner.types("REPEAT 2 TIMES\r")
    learner.sees("1> ")
    learner.types("TR 45\r")
    learner.sees("1> ")
    learner.types("END REPEAT\r")
    learner.sees("I turned 45 degrees to the right.\r\nI turned 45 degrees to the right.\r\n> ")


# --- what is printed


def test_the_last_line_of_an_answer_is_the_prompt_where_that_is_set(learner: Learner) -> None:
    """The cursor of a braille display stays on it."""
    learner.enters("SET prompt answer")
    learner.sees("Start of the line, prompt: answer. ")
    learner.types("FW 3\r")
    learner.sees("\r\n> ")
    learner.types("\r")
    learner.sees("I walked 3 steps forward. ")
    learner.types("WHERE\r")
    learner.sees("WHERE\r\nPosition 0, 3. Facing north. ")


@pytest.mark.parametrize(("prompt", "shown"), [("none", "\r\n"), ("word", "Donnie> ")])
def test_the_prompt_can_be_changed_or_removed(tmp_path: Path, prompt: str, shown: str) -> None:
    learner = Learner(tmp_path)
    learner.enters(f"SET prompt {prompt}")
    learner.sees(f"prompt: {prompt}.\r\n{shown.strip()}")
    learner.types("WHERE\r")
    learner.sees("Position 0, 0. Facing north.\r\n")


def test_each_line_waits_for_enter_where_that_is_set(learner: Learner) -> None:
    """For a braille display: one line at a time."""
    enter_and_wait(learner, "SET hold on")
    learner.types("AROUND\r")
    learner.sees("There is nothing within 10 steps. ")
    learner.types("\r")
    learner.sees("Ahead: free, 10 steps. ")
    learner.types("WHERE\r")
    learner.sees("Position 0, 0. Facing north.\r\n> ")


def test_a_long_answer_is_printed_page_by_page_where_that_is_set(learner: Learner) -> None:
    enter_and_wait(learner, "SET page ask")
    learner.types("HELP ALL\r")
    learner.sees("Enter continues, Q stops. ")
    assert len([line for line in learner.lines if ": " in line]) > 15
    learner.types("\r")
    learner.sees("Enter continues, Q stops. ")
    learner.types("q\r")
    learner.sees("\r\n> ")


def test_a_line_typed_between_two_pages_is_refused_and_asked_again(learner: Learner) -> None:
    enter_and_wait(learner, "SET page ask")
    learner.types("HELP ALL\r")
    learner.sees("Enter continues, Q stops. ")
    learner.types("FW 1\r")
    learner.sees("Not FW 1: Enter continues, Q stops.\r\nMore, ")
    learner.types("q\r")
    learner.sees_prompt()
    learner.types("LIST\r")
    learner.sees("There are no lines yet.")


def test_ctrl_c_between_two_pages_stops_the_program_and_asks_no_question(learner: Learner) -> None:
    enter_and_wait(learner, "SET page ask")
    learner.types("REPEAT 100000 TIMES SPEAK 1 END REPEAT\r\r")
    learner.sees("Enter continues, Q stops. ")
    learner.types("\x03")
    learner.sees("were left out.\r\nStopped at line 1.\r\n> ")


def test_settings_are_kept_for_the_next_session(tmp_path: Path) -> None:
    first = Learner(tmp_path)
    first.enters("SET prompt word")
    first.sees("Donnie> ")
    first.types("QUIT\r")
    assert first.leaves() == 0

    second = Learner(tmp_path)
    second.sees("HELP lists the commands.\r\nDonnie> ")


def test_language_and_detail_are_kept_for_the_next_session(tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.enters("DETAIL brief", "LANGUAGE pt", "SAIR")
    assert learner.leaves() == 0

    kept = next((tmp_path / "config").rglob("*.toml")).read_text()
    assert sorted(kept.splitlines()) == ['lang = "pt"', 'verbosity = "brief"']


def test_language_and_detail_in_a_file_of_lines_count_only_for_it(tmp_path: Path) -> None:
    donnie(tmp_path, "--linear", *QUIET, typed="DETAIL brief\nLANGUAGE pt\n")

    assert not list((tmp_path / "config").rglob("*.toml"))


def test_the_terminal_edits_the_line_where_the_plain_editor_is_set(learner: Learner) -> None:
    enter_and_wait(learner, "SET editor plain")
    learner.types("WHERE\n")
    learner.sees("WHERE\r\nPosition 0, 0. Facing north.\r\n> ")


# --- the other mode


def test_a_command_typed_at_a_question_is_carried_out_instead(learner: Learner) -> None:
    enter_and_wait(learner, "FW 1", "FW 2", "FW 3", "FW 4", "FW 5")
    learner.types("NEW\r")
    learner.sees("Save first, y or n? Enter means no.\r\n> ")
    learner.types("maybe\r")
    learner.sees("Type y or n.\r\n> ")
    learner.types("LIST 5\r")
    learner.sees("5: FW 5\r\n> ")


def test_a_switch_of_the_mode_keeps_the_robot_the_variables_and_the_program(tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    enter_and_wait(learner, "VAR x = 5", "FW x", "SPEED 20", "RUN")
    learner.types("VISUAL\r")
    learner.sees("Always begin in the full screen, y or n? Enter means no.")
    learner.types("\r")
    learner.sees("Donnie at 0, 5")
    learner.types(SHIFT_TAB)
    learner.sees("Command line.")
    learner.types("LINEAR\r")
    learner.sees("Linear mode, from the word LINEAR.")
    learner.sees("Always begin in linear mode, y or n? Enter means no.")
    learner.types("y\r")
    learner.sees("I will remember it.")
    learner.types("WHERE\r")
    learner.sees("Position 0, 5. Facing north.\r\n> ")
    learner.types("SHOW VARIABLES\r")
    learner.sees("x is 5.\r\n> ")
    learner.types("SPEED\r")
    learner.sees("Speed 20.\r\n> ")
    learner.types("LIST\r")
    learner.sees("1: VAR x = 5\r\n2: FW x\r\n> ")
    learner.types("VISUAL\r")
    learner.sees("Donnie at 0, 5")
    learner.types(SHIFT_TAB)
    learner.sees("Command line.")
    learner.types("LINEAR\r")
    learner.sees("Linear mode, from the word LINEAR.\r\nYour program has 2 lines.\r\n> ")
    learner.types("QUIT\r")
    learner.enters("n")
    assert learner.leaves() == 0
    assert "linear = true" in (tmp_path / "config/donnie/settings.toml").read_text()


def test_too_fast_movements_are_summed_up_and_last_lists_them_all(tmp_path: Path) -> None:
    """LAST lists the movements that a sum left out."""
    learner = Learner(tmp_path, speed="50")
    learner.enters("REPEAT 40 TIMES TR 1 END REPEAT", "RUN")
    learner.sees("more turns.")
    learner.sees_prompt()
    printed = learner.raw.decode()
    single = printed.count("I turned 1 degree")
    summed = sum(map(int, re.findall(r"(\d+) more turns", printed)))

    assert single + summed == 40
    assert single < 40
    learner.types("FIND turned\r")
    learner.sees("20 lines, the newest last.")
    learner.sees_prompt()
    assert learner.raw.decode().count("I turned 1 degree") == single + 20


def test_a_watched_variable_is_printed_during_a_run_and_at_its_end(learner: Learner) -> None:
    """Each change is printed once."""
    learner.enters("WATCH n", "VAR n = 1", "REPEAT 2 TIMES", "TR 90", "n = n + 1", "END REPEAT", "")
    learner.sees("n is 1.\r\nI turned 90 degrees to the right.\r\nn is 2.\r\n")
    learner.sees("I turned 90 degrees to the right.\r\nn is 3.\r\n> ")
    learner.types("FW 1\r\r")
    learner.sees("I walked 1 step forward.\r\n> ")
    learner.types("n = 3 n = 7\r\r")
    learner.sees("n = 3 n = 7\r\n> \r\nn is 7.\r\n> ")


def test_a_variable_that_is_watched_after_a_pause_is_printed_from_there_on(learner: Learner) -> None:
    """Each change is printed once."""
    learner.enters("VAR n = 1", "WHILE 1 == 1 DO", "WAIT 1", "n = n + 1", "END WHILE", "RUN")
    learner.sees("Waiting 1 second.")
    learner.types("PAUSE\r")
    learner.sees("Paused at line ")
    learner.sees_prompt()
    learner.types("WATCH n\rRUN\r")
    learner.sees("\nn is ")
    learner.sees("Waiting 1 second.\r\nn is ")
    learner.types("STOP\r")
    learner.sees("Stopped at line ")


def test_words_of_the_full_screen_are_answered_with_their_linear_words(learner: Learner) -> None:
    """The answer names the word of the linear mode."""
    enter_and_wait(learner, "GO TO 3", "theme dark", "SET mouse off", "SET speed", "REGISTRO")
    answers = [line for line in learner.lines if line and not line.startswith("> ")]

    assert answers[2:] == [
        "In linear mode, type READ 3.",
        "Only in the full screen: type VISUAL.",
        "Only in the full screen: type VISUAL.",
        "Speed: max.",
        "In linear mode, type SHOW LOG.",
    ]


def test_lines_of_a_robot_in_the_background_are_printed_at_once(tmp_path: Path) -> None:
    """As long as the line is empty. Otherwise it waits for the end of the line."""
    learner = Learner(tmp_path, speed="2")
    learner.enters("FW 1", "TR 90", "START")
    learner.sees("I walked 1 step forward.\r\n> ")
    learner.sees("I turned 90 degrees to the right.\r\n> ")
    learner.types("WHERE\r")
    learner.sees("Facing east.")
