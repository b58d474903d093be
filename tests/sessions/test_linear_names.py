"""A name that no file can have gets an answer, and the conversation continues."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.sessions.command import QUIET, donnie
from tests.sessions.learner import Learner

LONG = "x" * 300


@pytest.mark.parametrize("word", ["SAVE", "REPORT map", "SAVE LOG", "OPEN"])
def test_a_too_long_file_name_is_refused_and_the_conversation_continues(tmp_path: Path, word: str) -> None:
    learner = Learner(tmp_path)
    learner.enters("FW 1", "WHERE", f"{word} {LONG}.html")
    learner.sees("the name is too long.\r\n> ")
    learner.types("LIST\r")
    learner.sees("1: FW 1\r\n> ")


def test_a_port_with_a_too_long_name_is_listed_as_missing(tmp_path: Path) -> None:
    robot = f"serial:/dev/{LONG}"
    done = donnie(tmp_path, "--linear", *QUIET, "--robot", robot, typed="CONNECT\nWHERE\n")

    assert done.returncode == 0
    assert "Facing north.\n" in done.stdout.decode()


def test_a_world_with_a_too_long_name_is_unknown(tmp_path: Path) -> None:
    done = donnie(tmp_path, "--linear", *QUIET, "--world", LONG)

    assert done.returncode == 2
    assert "Traceback" not in done.stderr.decode()
