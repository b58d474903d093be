"""A robot that talks without end in the background: typed lines still reach it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from donnie_tui.linear.output import CAPACITY
from tests.sessions.learner import Learner

pytestmark = pytest.mark.slow

CTRL_C = "\x03"
TALKER = ("WHILE 1 == 1 DO", "SPEAK 7", "END WHILE", "START")
A_FEW_BLOCKS = 150
"""Lines: a block of them is printed before a key is looked for, and some come after the stop."""


@pytest.fixture
def talking(tmp_path: Path) -> Learner:
    """The program publishes far more lines than are printed."""
    learner = Learner(tmp_path, speed="1")
    learner.enters(*TALKER)
    learner.sees("7\r\n7.\r\n7\r\n")
    return learner


def left_out(learner: Learner) -> int:
    found = re.findall(r"(\d+) lines were left out", learner.raw.decode())
    return sum(map(int, found))


@pytest.mark.parametrize(
    ("keys", "answer"),
    [("STOP ALL\r", "Stopped at line "), ("STOP\r", "Stopped at line "), (CTRL_C, "Stopped at line ")],
    ids=["all", "own", "interrupt"],
)
def test_a_word_or_one_ctrl_c_stops_the_program_soon(talking: Learner, keys: str, answer: str) -> None:
    talking.types(keys)
    before = len(talking.lines)
    talking.sees(answer)
    assert len(talking.lines) - before < A_FEW_BLOCKS

    talking.sees("> ")
    talking.types("ROBOTS\r")
    talking.sees("There is one robot, donnie.")


def test_the_number_of_unprinted_lines_is_bounded(talking: Learner) -> None:
    for _ in range(5):
        talking.sees("\n7.\r\n")
    talking.types(CTRL_C)
    talking.sees("Stopped at line ")
    talking.sees("> ")

    # On a busy machine the queue fills again before the program notices the stop. Without a limit some
    # 80 000 lines would be left out.
    assert 0 < left_out(talking) < 10 * CAPACITY


def test_a_line_is_typed_and_answered_in_between(talking: Learner) -> None:
    talking.types("WHERE")
    talking.sees("> WHERE")
    talking.types("\r")
    before = len(talking.lines)
    talking.sees("Facing north.")

    assert len(talking.lines) - before < A_FEW_BLOCKS


def test_a_question_is_printed_before_its_answer_is_read(talking: Learner) -> None:
    talking.types("FW 1\rFW 2\rQUIT\r")
    talking.sees("5 lines are not saved. Save first, y or n? Enter means no.\r\n")


def test_the_answer_to_a_word_comes_before_lines_of_the_background(tmp_path: Path) -> None:
    learner = Learner(tmp_path, "--world", "two_robots", speed="1")
    learner.enters(*TALKER)
    for _ in range(60):
        learner.sees("alice: 7\r\n")
    learner.types("ROBOT bob\r")
    before = len(learner.lines)
    learner.sees("Now you talk to bob.")

    assert len(learner.lines) - before < A_FEW_BLOCKS


# --- a pause in the background


def test_a_word_resumes_a_paused_background_program(tmp_path: Path) -> None:
    learner = Learner(tmp_path, speed="0.1")
    learner.enters("FW 9", "START")
    learner.sees("donnie begins.\r\n> ")
    learner.types("PAUSE\r")
    learner.sees("Paused at line 1.\r\n> ")
    learner.types("STEP\r")
    learner.sees("STEP\r\nA program is running. STOP stops it.\r\n> ")
    learner.types("SPEED max\r")
    learner.sees("Speed max.\r\n> ")
    learner.types("CONTINUE\r")
    learner.sees("Continuing.")
    learner.sees("I walked 9 steps forward.")


def test_a_word_resumes_a_paused_robot_among_running_ones(tmp_path: Path) -> None:
    learner = Learner(tmp_path, "--world", "two_robots", speed="0.1")
    learner.enters("FW 1", "ROBOT bob", "FW 9", "TOGETHER")
    learner.types("PAUSE\r")
    learner.sees("bob: Paused at line 1.")
    learner.types("SPEED max\r")
    learner.sees("Speed max.")
    learner.types("CONTINUE\r")
    learner.sees("bob: Continuing.")
    learner.sees("bob: I walked 9 steps forward.")


# --- the verdict of a challenge


def test_the_verdict_comes_when_the_background_program_ends(tmp_path: Path) -> None:
    learner = Learner(tmp_path, "--world", "challenge:first_walk", speed="5")
    learner.enters("FW 5", "START")
    learner.sees("Solved, in 1 command.\r\nNEXT CHALLENGE is: To the ball.\r\n> ")


def test_a_line_that_is_being_typed_is_kept_under_the_verdict(tmp_path: Path) -> None:
    learner = Learner(tmp_path, "--world", "challenge:first_walk", speed="1")
    learner.enters("FW 4", "START")
    learner.types("WHE")
    learner.sees("0 of 1 goal. You stopped 1 step south of 0, 5.\r\n> WHE")
    learner.types("RE\r")
    learner.sees("Position 0, 4.")
