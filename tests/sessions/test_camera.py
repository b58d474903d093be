"""COLOR and SCAN of the real robot's driver, from the command line, with pictures as its camera."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.sessions.command import QUIET, donnie
from tests.unit.devices.pictures import BLUE, RED, drawn, save

PROGRAM = 'SPEAK COLOR RED\nIF COLOR BLUE > 0 THEN\nSPEAK "blue"\nEND IF\nSCAN\nFW 1\n'


@pytest.fixture
def lesson(tmp_path: Path) -> Path:
    things = ((100, 200, 160, 260, RED), (290, 200, 350, 260, BLUE), (500, 200, 560, 260, RED))
    save(tmp_path / "pictures", {"a.png": drawn(*things)})
    (tmp_path / "program.gd").write_text(PROGRAM)
    return tmp_path


def printed(folder: Path, *options: str) -> tuple[int, list[str]]:
    done = donnie(folder, "run", "program.gd", "--robot", "double", *QUIET, *options)
    assert done.stderr == b""
    return done.returncode, done.stdout.decode().splitlines()


def test_a_program_sees_the_colours_of_a_folder_of_pictures(lesson: Path) -> None:
    code, lines = printed(lesson, "--camera", "pictures")

    assert code == 0
    assert lines[:2] == ["2", "blue"]
    assert [line.partition(" at ")[0] for line in lines[2:5]] == [
        "To the 20 degrees in the left: 1 object of color red",
        "Ahead: 1 object of color blue",
        "To the 20 degrees in the right: 1 object of color red",
    ]
    assert lines[5:] == ["I walked 1 step forward."]


def test_without_a_camera_the_program_continues_after_one_sentence(lesson: Path) -> None:
    code, lines = printed(lesson)

    assert code == 0
    assert lines[:2] == ["I have no camera: I see no colors.", "0"]
    assert lines.count("I have no camera: I see no colors.") == 1
    assert lines[-1] == "I walked 1 step forward."


NOT_NAMED = "can't be used in this session. Your teacher can allow it: --devices."


def test_a_confined_session_sees_only_its_own_pictures_and_named_cameras(lesson: Path) -> None:
    ana = lesson / "ana"
    ana.mkdir()
    (ana / "program.gd").write_text(PROGRAM)
    (ana / "inside.png").write_bytes((lesson / "pictures" / "a.png").read_bytes())
    (ana / "link").symlink_to(lesson / "pictures")

    def first(camera: str, *options: str) -> str:
        code, lines = printed(ana, "--confined", ".", "--camera", camera, *options)
        assert (code, lines[-1]) == (0, "I walked 1 step forward.")
        return lines[0]

    assert first("inside.png") == "2"
    for name in ("../pictures", "../pictures/a.png", "link", str(lesson / "pictures")):
        assert first(name) == f"{name} is not in your folder. Stay in it."
    assert first("/dev/null") == f"/dev/null {NOT_NAMED}"
    assert first("/dev/null", "--devices", "/dev/null") == "The camera /dev/null gives no picture."
    assert first("97") == f"/dev/video97 {NOT_NAMED}"


def test_sensors_name_the_camera(lesson: Path) -> None:
    done = donnie(lesson, "--linear", "--robot", "double", "--camera", "pictures", *QUIET, typed="SENSORS\n")

    assert "Bumpers and a color camera. No gripper." in done.stdout.decode().splitlines()
