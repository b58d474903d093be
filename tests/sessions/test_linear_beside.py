"""A robot that runs beside the conversation and talks without end: whoever types comes through to it."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.sessions.learner import Learner

CTRL_C = "\x03"
TALKER = ("WHILE 1 == 1 DO", "SPEAK 7", "END WHILE", "START")
A_FEW_BLOCKS = 150
"""Lines: a block of them is printed before a key is looked for, and some come after the stop."""


@pytest.fixture
def talking(tmp_path: Path) -> Learner:
    """Far more is told than is printed."""
    learner = Learner(tmp_path, speed="1")
    learner.enters(*TALKER)
    learner.sees("Those were 17 numbers.\r\n7\r\n")
    return learner


def left_out(learner: Learner) -> int:
    found = re.findall(r"(\d+) lines were left out", learner.raw.decode())
    return sum(map(int, found))


@pytest.mark.parametrize(
    ("keys", "answer"),
    [("STOP ALL\r", "All stopped."), ("STOP\r", "Stopped at line "), (CTRL_C, "All stopped.")],
    ids=["all", "own", "interrupt"],
)
def test_a_word_or_one_ctrl_c_stops_it_soon(talking: Learner, keys: str, answer: str) -> None:
    talking.types(keys)
    before = len(talking.lines)
    talking.sees(answer)
    assert len(talking.lines) - before < A_FEW_BLOCKS

    talking.sees("> ")
    talking.types("ROBOTS\r")
    talking.sees("There is one robot, donnie.")


def test_what_it_tells_that_is_not_printed_yet_is_bounded(talking: Learner) -> None:
    for _ in range(5):
        talking.sees("Those were 17 numbers.")
    talking.types(CTRL_C)
    talking.sees("All stopped.")
    talking.sees("> ")

    assert 0 < left_out(talking) < 1000


def test_a_line_is_typed_and_answered_in_between(talking: Learner) -> None:
    talking.types("WHERE")
    talking.sees("> WHERE")
    talking.types("\r")
    before = len(talking.lines)
    talking.sees("Facing north.")

    assert len(talking.lines) - before < A_FEW_BLOCKS


def test_a_question_is_seen_before_it_is_to_be_answered(talking: Learner) -> None:
    talking.types("FW 1\rFW 2\rNEW\r")
    talking.sees("5 lines are not saved. Lose them, y or n? Enter means no.\r\n")


def test_whatever_answers_a_word_comes_before_what_is_told_beside(tmp_path: Path) -> None:
    learner = Learner(tmp_path, "--world", "two_robots", speed="1")
    learner.enters(*TALKER)
    for _ in range(60):
        learner.sees("alice: 7\r\n")
    learner.types("ROBOT bob\r")
    before = len(learner.lines)
    learner.sees("You talk to bob.")

    assert len(learner.lines) - before < A_FEW_BLOCKS


# --- a pause beside the conversation


def test_a_started_program_that_is_paused_goes_on_by_a_word(tmp_path: Path) -> None:
    learner = Learner(tmp_path, speed="0.1")
    learner.enters("FW 9", "START")
    learner.sees("donnie begins.\r\n> ")
    learner.types("PAUSE\r")
    learner.sees("Paused. CONTINUE goes on.\r\n> ")
    learner.types("STEP\r")
    learner.sees("STEP\r\ndonnie is busy.\r\n> ")
    learner.types("SPEED max\r")
    learner.sees("Speed max.\r\n> ")
    learner.types("CONTINUE\r")
    learner.sees("Going on.")
    learner.sees("I walked 9 steps forward.")


def test_a_robot_paused_among_those_that_run_together_goes_on_by_a_word(tmp_path: Path) -> None:
    learner = Learner(tmp_path, "--world", "two_robots", speed="0.1")
    learner.enters("FW 1", "ROBOT bob", "FW 9", "TOGETHER")
    learner.types("PAUSE\r")
    learner.sees("bob: Paused. CONTINUE goes on.")
    learner.types("SPEED max\r")
    learner.sees("Speed max.")
    learner.types("CONTINUE\r")
    learner.sees("bob: Going on.")
    learner.sees("bob: I walked 9 steps forward.")
