"""Typed lines are restored at the next start, however the conversation ended."""

from __future__ import annotations

import signal
from pathlib import Path

import pytest

from tests.sessions.learner import Learner, until

pytestmark = pytest.mark.slow


def copied(folder: Path) -> list[str]:
    return [each.read_text() for each in (folder / "state").rglob("unsaved-*.gd")]


def test_a_program_of_thousands_of_lines_is_restored_after_donnie_was_killed(tmp_path: Path) -> None:
    many = "FW 1\n" * 6000
    (tmp_path / "long.gd").write_text(many)
    learner = Learner(tmp_path)
    learner.enters(f"OPEN {tmp_path / 'long.gd'}", "FW 2")
    learner.sees_prompt()
    until(lambda: [each.endswith(f"{many}FW 2\n") for each in copied(tmp_path)] == [True])
    learner.child.kill(signal.SIGKILL)
    learner.leaves()

    again = Learner(tmp_path)
    again.enters("RECOVER")
    again.sees("long.gd is back, 6001 lines.")


def test_a_rescued_program_is_announced_once_before_the_first_prompt(tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.enters("FW 1")
    learner.sees_prompt()
    until(lambda: copied(tmp_path) == ["FW 1\n"])
    learner.child.kill(signal.SIGKILL)
    learner.leaves()

    again = Learner(tmp_path)
    again.sees("A program was kept. RECOVER opens it.\r\n> ")
    again.types("WHERE\r")
    again.sees_prompt()
    again.types("RECOVER\r")
    again.sees("Your program is back, 1 line.")
    assert sum("was kept" in line for line in again.lines) == 1


def test_a_file_changed_by_another_program_is_not_replaced_without_a_question(tmp_path: Path) -> None:
    file = tmp_path / "a.gd"
    file.write_text("FW 1\n")
    learner = Learner(tmp_path)
    learner.enters("OPEN a.gd", "FW 2")
    learner.sees_prompt()
    until(lambda: [each.endswith("FW 1\nFW 2\n") for each in copied(tmp_path)] == [True])
    learner.child.kill(signal.SIGKILL)
    learner.leaves()

    again = Learner(tmp_path)
    again.enters("RECOVER")
    again.sees("a.gd is back, 2 lines.")
    file.write_text("FW 9\n")
    again.sees_prompt()
    again.types("SAVE\r")
    again.sees("a.gd was changed elsewhere. Replace it, y or n?")
    assert file.read_text() == "FW 9\n"


def test_a_programs_own_file_is_saved_by_any_of_its_names_without_a_question(
    learner: Learner, tmp_path: Path
) -> None:
    (tmp_path / "a.gd").write_text("FW 1\n")
    learner.enters("OPEN a.gd", "FW 2", f"SAVE {tmp_path / 'a.gd'}")
    learner.sees("Saved a.gd, 2 lines.")


def test_recovering_one_program_mentions_a_second_one(tmp_path: Path) -> None:
    folder = tmp_path / "state" / "donnie" / "unsaved"
    folder.mkdir(parents=True)
    for number in (1, 2):
        (folder / f"unsaved-9999999{number}-a.gd").write_text(f"FW {number}\n")

    learner = Learner(tmp_path)
    learner.enters("RECOVER")
    learner.sees("Your program is back, 1 line.\r\nThere is one more. RECOVER opens it.\r\n")
    learner.enters("RECOVER")
    learner.sees("Your program is back, 1 line.\r\n> ")
