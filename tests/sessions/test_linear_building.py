"""A world that was furnished by words is not lost: Donnie asks before it ends, or keeps the world."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import pytest

from tests.sessions.command import QUIET, donnie
from tests.sessions.learner import Learner

pytestmark = pytest.mark.slow

CTRL_D = "\x04"
QUESTION = "You changed this world. Save it, y or n? Enter means no.\r\n> "


@pytest.fixture
def builder(tmp_path: Path) -> Learner:
    """The learner has put a box."""
    learner = Learner(tmp_path)
    learner.enters("PUT box red 4 6 AS treasure")
    learner.sees("Treasure, box, red: at 4, 6. From the robot: 4 right, 6 ahead.\r\n> ")
    return learner


def test_quit_asks_and_saves(builder: Learner, tmp_path: Path) -> None:
    builder.types("QUIT\r")
    builder.sees(QUESTION)
    builder.types("y\r")
    builder.sees("Name of the world's file:")
    builder.types("mine\r")
    builder.sees("World saved as mine.world.")

    assert builder.leaves() == 0
    assert 'box( name "treasure"' in next(tmp_path.rglob("mine.world")).read_text()


def test_quit_asks_and_leaves_without_saving(builder: Learner, tmp_path: Path) -> None:
    builder.types("QUIT\r")
    builder.sees(QUESTION)
    builder.types("n\r")

    assert builder.leaves() == 0
    assert not list(tmp_path.rglob("*.world"))


def test_the_end_of_the_input_keeps_the_world(builder: Learner, tmp_path: Path) -> None:
    builder.types(CTRL_D)
    builder.sees(QUESTION)
    builder.types(CTRL_D)
    builder.sees("Your world is kept as ")

    assert builder.leaves() == 0
    assert 'box( name "treasure"' in next(tmp_path.rglob("unsaved.world")).read_text()


def test_a_hangup_keeps_the_world(builder: Learner, tmp_path: Path) -> None:
    os.kill(builder.pid, signal.SIGHUP)

    builder.leaves()
    assert 'box( name "treasure"' in next(tmp_path.rglob("unsaved.world")).read_text()


@pytest.mark.parametrize("end", ["", "QUIT\n", "WORLD maze\n", "CHALLENGE 1\n"])
def test_a_script_that_builds_and_does_not_save_keeps_the_world(tmp_path: Path, end: str) -> None:
    done = donnie(tmp_path, "--linear", *QUIET, typed=f"PUT box red 4 6 AS treasure\n{end}")

    kept = next(tmp_path.rglob("unsaved.world"))
    assert f"Your world is kept as {kept}." in done.stdout.decode().splitlines()
    assert 'box( name "treasure"' in kept.read_text()


@pytest.mark.parametrize("end", ["SAVE WORLD mine\n", "UNDO\n"])
def test_a_script_that_saves_or_takes_back_what_it_built_keeps_no_copy(tmp_path: Path, end: str) -> None:
    donnie(tmp_path, "--linear", *QUIET, typed=f"PUT box red 4 6 AS treasure\n{end}")

    assert not list(tmp_path.rglob("unsaved.world"))
