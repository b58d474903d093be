"""Typed lines are restored after a signal or a power failure. A saved program leaves no copy."""

from __future__ import annotations

import signal
from pathlib import Path
from shutil import rmtree

import pytest

from tests.sessions.learner import (
    UP,
    Learner,
    until,
)

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_a_signal_to_leave_rescues_the_program(number: int, tmp_path: Path) -> None:
    learner = Learner(tmp_path)
    learner.enters("FW 1", "FW 2")
    learner.sees_prompt()
    learner.child.kill(number)

    assert learner.leaves() == 128 + number
    again = Learner(tmp_path)
    again.sees("A program was kept. RECOVER opens it.\r\n")
    again.enters("RECOVER")
    again.sees("Your program is back, 2 lines.")
    again.enters("LIST")
    again.sees("1: FW 1\r\n2: FW 2\r\n> ")


def test_a_signal_rescues_what_could_not_be_written_before(tmp_path: Path) -> None:
    """As when the disk was full, and has room again."""
    state = tmp_path / "state" / "donnie"
    state.mkdir(parents=True)
    in_the_way = state / "unsaved"
    in_the_way.touch()
    learner = Learner(tmp_path)
    learner.enters("FW 1")
    learner.sees("What you type can't be kept safe: a file has this name.\r\n> ")
    in_the_way.unlink()
    learner.child.kill(signal.SIGTERM)

    assert learner.leaves() == 128 + signal.SIGTERM
    assert [each.read_text() for each in copies(tmp_path)] == ["FW 1\n"]


def test_a_rescued_program_has_its_file_again(tmp_path: Path) -> None:
    (tmp_path / "walk.gd").write_text("FW 1\n")
    learner = Learner(tmp_path)
    learner.enters(f"OPEN {tmp_path / 'walk.gd'}", "FW 2")
    learner.sees_prompt()
    learner.child.kill(signal.SIGTERM)
    learner.leaves()
    again = Learner(tmp_path)
    again.enters("RECOVER")
    again.sees("walk.gd is back, 2 lines. SAVE saves it.")
    again.enters("SAVE")
    again.sees("Saved walk.gd, 2 lines.")
    assert (tmp_path / "walk.gd").read_text() == "FW 1\nFW 2\n"


def copies(folder: Path) -> list[Path]:
    return list((folder / "state").rglob("unsaved-*.gd"))


def test_typed_lines_are_restored_after_donnie_was_killed_in_mid_line(tmp_path: Path) -> None:
    learner = Learner(tmp_path, language="es")
    learner.types("AV 1\rGD 90\rHABL")
    learner.sees("> HABL")
    until(lambda: [each.read_text() for each in copies(tmp_path)] == ["AV 1\nGD 90\n"])
    learner.child.kill(signal.SIGKILL)
    learner.leaves()

    again = Learner(tmp_path, language="es")
    again.enters("RECUPERAR", "LISTAR")
    again.sees("1: AV 1\r\n2: GD 90\r\n> ")
    again.types(UP + UP + "\r")
    again.sees("RECUPERAR")
    again.sees("> ")
    again.types("SALIR\r")
    again.enters("n")

    assert again.leaves() == 0
    assert list((tmp_path / "state").rglob("unsaved-*")) == []


def test_a_program_that_was_saved_leaves_no_copy(learner: Learner, tmp_path: Path) -> None:
    learner.enters("FW 1")
    learner.sees_prompt()
    until(lambda: list((tmp_path / "state").rglob("unsaved-*")) != [])
    learner.types("SAVE mine\r")
    learner.sees_prompt()
    until(lambda: list((tmp_path / "state").rglob("unsaved-*")) == [])


def test_a_working_folder_that_was_removed_ends_no_session_and_loses_nothing(tmp_path: Path) -> None:
    folder = tmp_path / "work"
    folder.mkdir()
    (folder / "walk.gd").write_text("FW 1\n")
    places = {f"XDG_{kind.upper()}_HOME": str(tmp_path / kind) for kind in ("config", "state")}
    learner = Learner(folder, "walk.gd", **places)
    learner.sees_prompt()
    rmtree(folder)
    learner.types("FW 2\r")
    learner.enters("SAVE", "SAVE other", "WORLD wall.world", "REPORT MAP map.html")
    learner.sees("I can't write map.html: there is no such folder.")
    learner.sees_prompt()
    said = [each for each in learner.lines if each.startswith(("I can", "There is no"))]
    print(learner.lines)
    learner.child.kill(signal.SIGTERM)

    assert learner.leaves() == 128 + signal.SIGTERM
    assert said[:3] == [
        "I can't write walk.gd: there is no such folder.",
        "I can't write other.gd: there is no such folder.",
        "There is no file wall.world.",
    ]
    (copy,) = copies(tmp_path)
    assert copy.read_text().splitlines()[-2:] == ["FW 1", "FW 2"]
