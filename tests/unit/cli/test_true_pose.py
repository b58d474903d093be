"""The events of a run with odometry errors have both poses: the believed one and the true one."""

import json
from pathlib import Path

import pytest

from donnie_tui.cli.main import main

WORLD = 'position ( localization "odom" odom_error [ 0.3 0.3 0 0.3 ] ranger ( sensor ( samples 1 ) ) )'


def events(folder: Path, capsys: pytest.CaptureFixture[str], seed: str) -> dict[str, dict[str, object]]:
    """The last event of each name."""
    (folder / "odd.world").write_text(WORLD)
    (folder / "walk.gd").write_text("FW 5\nTR 90\n")
    options = ["--world", str(folder / "odd.world"), "--seed", seed, "--events", "-"]
    assert main(["run", str(folder / "walk.gd"), *options]) == 0
    return {each["event"]: each for each in map(json.loads, capsys.readouterr().out.splitlines())}


def test_a_robot_with_odometry_errors_has_a_true_pose(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = events(tmp_path, capsys, "3")

    assert found["moved"]["true_pose"] == {"x": 5.0, "y": 0.0, "heading": 90.0}
    assert found["moved"]["pose"] != found["moved"]["true_pose"]
    assert found["turned"]["true_pose"] == {"x": 5.0, "y": 0.0, "heading": 180.0}
    assert found["run_ended"]["true_pose"] == found["turned"]["true_pose"]
    assert found["run_ended"]["pose"] == found["turned"]["pose"]


def test_a_robot_that_knows_where_it_is_has_one_pose(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = events(tmp_path, capsys, "0")

    assert found["run_ended"]["pose"] == {"x": 5.0, "y": 0.0, "heading": 180.0}
    assert not any("true_pose" in each for each in found.values())
