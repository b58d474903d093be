"""A calibration at a real line: it finds the wheels and the axle, and whatever ends it stops the robot."""

from __future__ import annotations

import signal
import subprocess
from pathlib import Path

import pytest

from devices.firmware_double.on_pty import DoubleOnPty
from tests.patience import PATIENCE
from tests.sessions.command import COMMAND, donnie, environment
from tests.sessions.real_robot import is_suspended, serial, until


def test_a_calibration_finds_the_wheels_and_the_axle_that_the_robot_really_has(tmp_path: Path) -> None:
    """The board's wheels have a radius of 21 mm, its axle 68 mm; the settings believe something else."""
    config = tmp_path / "config" / "donnie"
    config.mkdir(parents=True)
    wrong = {"DONNIE_WHEEL_RADIUS": "0.024", "DONNIE_AXLE_LENGTH": "0.080"}
    # What a tape measure shows: 20 steps of 5 cm, by wheels that are smaller than believed.
    centimetres, degrees = 100 * 21 / 24, 720 * (21 / 24) * (80 / 68)

    typed = f"\n{centimetres:.2f}\n\n{degrees:.1f}\n"
    done = donnie(tmp_path, "calibrate", "--robot", "double", typed=typed, changes=wrong)
    assert done.returncode == 0
    settings = next((tmp_path / "config").rglob("*.toml")).read_text()
    found = dict(line.split(" = ") for line in settings.splitlines())
    assert float(found["wheel_radius"]) == pytest.approx(0.021, rel=0.01)
    assert float(found["axle_length"]) == pytest.approx(0.068, rel=0.01)


@pytest.mark.parametrize("typed", ["", "\n\n\n\n", "\nfar\n\n", "\n-3\n0\n\n\n\n"])
def test_where_nothing_is_measured_nothing_changes(tmp_path: Path, typed: str) -> None:
    done = donnie(tmp_path, "calibrate", "--robot", "double", typed=typed)

    assert done.returncode == 1
    assert done.stdout.decode().splitlines()[-1] == "Nothing was measured. Nothing has changed."
    assert not list((tmp_path / "config").rglob("*.toml"))


def calibration(tmp_path: Path, robot: DoubleOnPty) -> subprocess.Popen[bytes]:
    """In the middle of the walk."""
    process = subprocess.Popen(
        [*COMMAND, "calibrate", *serial(robot)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        cwd=tmp_path,
        env=environment(tmp_path),
    )
    assert process.stdin is not None
    process.stdin.write(b"\n")
    process.stdin.flush()
    assert until(lambda: robot.board.is_driving)
    return process


def test_control_z_in_the_middle_of_a_calibration_stops_the_robot(tmp_path: Path, robot: DoubleOnPty) -> None:
    process = calibration(tmp_path, robot)
    process.send_signal(signal.SIGTSTP)
    assert is_suspended(process.pid)
    assert until(lambda: not robot.board.is_driving)
    process.send_signal(signal.SIGCONT)

    said, _ = process.communicate(b"", timeout=PATIENCE)
    assert "Something stopped it. I leave this out." in said.decode().splitlines()


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGQUIT], ids=lambda each: each.name)
def test_a_signal_in_the_middle_of_a_calibration_stops_the_robot(
    tmp_path: Path, robot: DoubleOnPty, number: signal.Signals
) -> None:
    process = calibration(tmp_path, robot)
    process.send_signal(number)

    assert until(lambda: not robot.board.is_driving)
    assert process.wait(PATIENCE) == 130
