"""The linear mode on a real terminal: first lines, editing, output and end."""

from __future__ import annotations

import os
import re
import signal
import termios
from pathlib import Path

import pytest

from tests.sessions.learner import (
    BACKSPACE,
    CTRL_Z,
    ESC,
    Learner,
    said,
    until,
)
from tests.sessions.shell import is_stopped

pytestmark = pytest.mark.slow


def test_the_linear_mode_begins_with_two_lines_and_a_prompt(learner: Learner) -> None:
    learner.sees_prompt()

    assert learner.raw == b"Linear mode, from the option.\r\nHELP lists the commands.\r\n> "


def test_a_rectangle_is_typed_with_enter_and_run_with_escape(learner: Learner) -> None:
    learner.enters("PROCEDURE RECT: a, b DO", "REPEAT 2 TIMES", "FW a TR 90", "FW b TR 90", "END REPEAT")
    learner.enters("END PROCEDURE")
    learner.sees_prompt()
    learner.types("RECT [4, 2]" + ESC)
    learner.sees_prompt()

    assert [line for line in learner.lines if line.endswith("REPEAT")] == ["2> END REPEAT"]
    walks = ["I walked 4 steps forward.", "I walked 2 steps forward."] * 2
    turn = "I turned 90 degrees to the right."
    assert said(learner)[2:] == [line for walk in walks for line in (walk, turn)]


def test_the_answer_and_the_prompt_are_written_in_one_piece(learner: Learner) -> None:
    learner.enters("FW 3", "RUN")
    learner.sees_prompt()

    assert learner.raw.endswith(b"> FW 3\r\n> RUN\r\nI walked 3 steps forward.\r\n> ")


def test_long_output_is_written_in_blocks_with_rests_between(learner: Learner) -> None:
    learner.enters("FOR VAR i = 1; i <= 40; i = i + 1 DO SPEAK i END FOR", "RUN")
    learner.sees("40\r\n> ")

    sentences = said(learner)[2:]
    assert [line.rstrip(".") for line in sentences] == [str(number) for number in range(1, 41)]


def test_letters_with_accents_and_wide_ones_are_edited_as_one(learner: Learner) -> None:
    learner.sees_prompt()
    learner.types('SPEAK "cafe\u0301é漢x' + BACKSPACE * 3 + '"' + ESC)
    learner.sees("cafe\u0301\r\n> ")


def test_keys_typed_ahead_are_not_lost(tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.types("FW 1\rFW 2\rRUN\rWHERE\r")
    learner.sees("Position 0, 3. Facing north.")

    walked = [line for line in learner.lines if line.startswith("I walked")]
    assert walked == ["I walked 1 step forward.", "I walked 2 steps forward."]


def test_the_terminal_is_left_as_it_was_found(learner: Learner) -> None:
    learner.sees_prompt()
    during = termios.tcgetattr(learner.child.fileno())
    learner.types("QUIT\r")
    learner.sees("Goodbye.")
    until(lambda: termios.tcgetattr(learner.child.fileno())[3] & termios.ECHO)
    after = termios.tcgetattr(learner.child.fileno())

    assert not during[3] & (termios.ECHO | termios.ICANON)
    assert after[3] & termios.ICANON


def test_control_z_restores_the_terminal_until_the_session_continues(tmp_path: Path) -> None:
    learner = Learner(tmp_path, is_job=True)
    learner.enters("WHERE")
    learner.sees("Facing north.\r\n> ")
    learner.types("FW 3")
    learner.sees("FW 3")
    learner.types(CTRL_Z)
    until(lambda: is_stopped(learner.pid))
    while_away = termios.tcgetattr(learner.child.fileno())[3]
    os.kill(learner.pid, signal.SIGCONT)
    learner.sees("> FW 3")
    learner.types(ESC)
    learner.sees("I walked 3 steps forward.")

    assert while_away & termios.ECHO


def test_control_z_without_a_shell_above_is_answered_and_what_is_typed_stays(learner: Learner) -> None:
    """As in ``ssh -t host donnie``, where the terminal has no other process."""
    learner.enters("WHERE")
    learner.sees("Facing north.\r\n> ")
    learner.types("FW 3")
    learner.sees("FW 3")
    learner.types(CTRL_Z)
    learner.sees("Ctrl+Z has no effect here.\r\n> FW 3")
    learner.types(ESC)
    learner.sees("I walked 3 steps forward.")


def test_control_z_without_a_shell_above_lets_a_program_run(tmp_path: Path) -> None:
    learner = Learner(tmp_path, speed="5")
    for each in ("FW 10", "SPEAK 55"):
        learner.enters(each)
    learner.types("RUN\r")
    learner.sees("RUN")
    learner.types(CTRL_Z)
    learner.sees("Ctrl+Z has no effect here.")
    learner.sees("I walked 10 steps forward.")
    learner.sees("55")


def test_nothing_but_text_is_printed_outside_of_editing(learner: Learner, tmp_path: Path) -> None:
    learner.enters(
        "HELP", "HELP KEYS", "HELP FW", "FW 3", "RUN", "LIST", "WHERE", "SPEED 7", "DETAIL full", "ERRORS"
    )
    learner.enters(
        'SPEAK "  \x1b[2J tab "', "RUN", "SAVE x", "OPEN nothing", "LAST", "FW", "RUN", "CHANGE 99", "QUIT"
    )
    assert learner.leaves() == 0
    text = learner.raw.replace(b"\r\n", b"\n").decode()

    assert not re.search(r"[\x00-\x09\x0b-\x1f\x7f]", text)
    assert not re.search(r"\n\n|\n |(?<!>) \n", text)


@pytest.mark.skipif(
    not Path("/proc/self/maps").exists(), reason="what a process has loaded is sentences there"
)
def test_the_robot_gets_ready_to_move_while_the_prompt_waits(learner: Learner) -> None:
    learner.sees_prompt()

    until(lambda: "_chipmunk" in Path(f"/proc/{learner.child.pid}/maps").read_text())

    learner.types("\x04")
    assert learner.leaves() == 0
