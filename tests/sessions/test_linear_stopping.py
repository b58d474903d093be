"""Ctrl+C and typed words stop any running program of the linear mode."""

from __future__ import annotations

import fcntl
import signal
import struct
import termios
from pathlib import Path

import pytest

from tests.sessions.learner import (
    CTRL_C,
    Learner,
    until,
)

pytestmark = pytest.mark.slow


def test_control_c_stops_in_the_middle_of_a_movement(tmp_path: Path) -> None:
    learner = Learner(tmp_path, "--events", "events.jsonl", speed="1")
    events = tmp_path / "events.jsonl"
    learner.enters("FW 1", "FW 50", "RUN")
    until(lambda: '"moved"' in events.read_text() and events.read_text().count("step-forward") >= 2)
    learner.types(CTRL_C + CTRL_C)
    learner.sees("I was stopped.\r\nStopped at line 2.\r\n> ")
    learner.types("WHERE\r")
    learner.sees("Facing north.")


@pytest.mark.parametrize("after", [0.1, 0.2, 0.4, 0.8])
def test_control_c_counts_while_the_session_still_loads(after: float, tmp_path: Path) -> None:
    """Both as a key and as a signal, which drops unread keys."""
    learner = Learner(tmp_path, speed="5")
    learner.sees_prompt()
    learner.types("WAIT 1000\r\r")
    learner.child.delaybeforesend = after
    learner.types(CTRL_C)
    learner.child.expect(rb"(Stopped|Nothing is running|Line cleared)[^\n]*\n> ")
    learner.types("WHERE\r")
    learner.sees("Facing north.")  # long before the wait would be over


def test_control_c_typed_right_after_the_program_stops_it(tmp_path: Path) -> None:
    """Before signals are handled it is a key after the others. Later the terminal drops unread keys."""
    learner = Learner(tmp_path, speed="5")
    learner.sees_prompt()
    learner.types("WAIT 1000\r\r" + CTRL_C)
    learner.sees_one_of("Stopped", "Nothing is running")
    learner.types("WHERE\r")
    learner.sees("Facing north.")  # long before the wait would be over


def test_an_endless_program_that_talks_is_stopped(learner: Learner) -> None:
    learner.enters("WHILE 1 == 1 DO", 'SPEAK "on and on"', "END WHILE", "RUN")
    learner.sees("on and on\r\non and on")
    learner.types(CTRL_C)
    learner.sees("Stopped at line ")
    learner.enters('SPEAK "well"', "RUN")
    learner.sees("well\r\n> ")


def test_control_c_at_a_stuck_terminal_still_reports_where_the_robot_stopped(tmp_path: Path) -> None:
    """Ctrl+C arrives in the middle of a write. Waiting lines are left out, except for their end."""
    (tmp_path / "flood.gd").write_text(f'WHILE 1 == 1 DO\nSPEAK "{"long " * 1000}"\nEND WHILE\n')
    learner = Learner(tmp_path, "flood.gd")
    learner.enters("RUN")
    until(lambda: _unread(learner) > 4000)
    learner.types(CTRL_C)
    learner.sees("Stopped at line ")


@pytest.mark.parametrize(
    ("word", "answer"),
    [
        ("SLOWER", "Speed "),
        ("FASTER", "Speed "),
        ("SPEED 3", "Speed 3."),
        ("ROBOTS", "There is one robot"),
        ("QUIET", "Quiet."),
        ("PAUSE", "Paused at line "),
        ("STOP ALL", "Stopped at line "),
    ],
)
def test_a_word_counts_at_once_while_a_program_talks_without_end(
    word: str, answer: str, learner: Learner
) -> None:
    """The program may have published hundreds of lines. Only a few blocks are printed first."""
    learner.enters("WHILE 1 == 1 DO", 'SPEAK "on and on"', "END WHILE", "RUN")
    learner.sees("on and on\r\non and on")
    learner.types(f"{word}\r")
    learner.sees(answer)
    before = learner.raw.count(b"on and on")
    learner.types(CTRL_C)
    learner.sees_prompt()

    assert before < 300


def _unread(learner: Learner) -> int:
    """Unread bytes in the terminal."""
    (count,) = struct.unpack("i", fcntl.ioctl(learner.child.fileno(), termios.FIONREAD, b"\0" * 4))
    return int(count)


def test_stop_reaches_a_program_past_other_lines_that_wait(learner: Learner) -> None:
    learner.enters("WHILE 1 == 1 DO", "WAIT 1", "END WHILE", "RUN")
    learner.sees("Waiting 1 second.")
    learner.types("FW 2\rSPEAK 77\rSTOP\r")
    learner.sees("Stopped at line ")
    learner.types("RUN\r")
    learner.sees("I walked 2 steps forward.\r\n77\r\n")


@pytest.mark.parametrize(
    ("word", "answer"),
    [("FASTER", "Speed "), ("SLOWER", "Speed "), ("SPEED 3", "Speed 3."), ("ROBOTS", "There is")],
)
def test_a_word_counts_at_once_past_other_lines_that_wait(word: str, answer: str, learner: Learner) -> None:
    learner.enters("WHILE 1 == 1 DO", "WAIT 100000", "END WHILE", "RUN")
    learner.sees("Waiting ")
    learner.types(f"FW 2\rSPEAK 77\r{word}\r")
    learner.sees(answer)
    learner.types("STOP\rSPEED max\rRUN\r")  # at a pace the walk may be summed up, after the words
    learner.sees("I walked 2 steps forward.\r\n77\r\n")


def test_control_c_at_the_prompt_clears_the_line_and_never_leaves(learner: Learner) -> None:
    learner.sees_prompt()
    learner.types("FW 3")
    learner.sees("FW 3")
    learner.types(CTRL_C)
    learner.sees("Line cleared.\r\n> ")
    learner.types(CTRL_C)
    learner.sees("Nothing is running. QUIT leaves.\r\n> ")


def test_a_signal_to_leave_stops_the_running_program(tmp_path: Path) -> None:
    learner = Learner(tmp_path, "--events", "events.jsonl", speed="1")
    events = tmp_path / "events.jsonl"
    learner.enters("FW 500", "RUN")
    until(lambda: events.exists() and "step-forward" in events.read_text())
    learner.child.kill(signal.SIGTERM)

    assert learner.leaves() == 128 + signal.SIGTERM
    assert '"outcome":"stopped"' in events.read_text()
