"""A calibration at a real connection finds the wheels and the axle. Its end always stops the robot."""

from __future__ import annotations

import io
import re
import signal
import subprocess
import sys
from argparse import Namespace
from pathlib import Path
from typing import Any

import pytest

from devices.board_simulator.board import SimulatedBoard
from devices.board_simulator.robot import SimulatedSerialRobot
from devices.ports.robot import Pace
from donnie_tui.cli.calibrate import calibrate
from donnie_tui.cli.options import Invocation, Order
from donnie_tui.cli.streams import Output
from donnie_tui.i18n.words import Words
from donnie_tui.robot.connection import robot_config
from donnie_tui.settings.settings import Settings
from tests.board_on_pty import PtyBoard
from tests.sessions.command import COMMAND, donnie, environment
from tests.sessions.real_robot import is_suspended, serial, until
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow

WRONG = {"DONNIE_WHEEL_RADIUS": "0.024", "DONNIE_AXLE_LENGTH": "0.080"}
"""The board's wheels have a radius of 21 mm, its axle 68 mm; the settings believe something else."""
CENTIMETRES, TURNED = 100 * 21 / 24, 720 * (21 / 24) * (80 / 68)
"""What a tape measure shows: 20 steps of 5 cm, by wheels that are smaller than believed."""
MEASURES = f"\n{CENTIMETRES:.2f}\n\n{TURNED:.1f}\n"


def sizes(said: str) -> tuple[float, float]:
    """Millimetres of the wheels' radius and the axle."""
    radius, axle = re.search(r"Wheel radius ([\d.]+) .*\nAxle ([\d.]+) ", said).groups()  # type: ignore[union-attr]
    return float(radius), float(axle)


def test_a_calibration_finds_the_wheels_and_the_axle_that_the_robot_really_has(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The driver of the real robot; only its line is a simulated one."""
    monkeypatch.setattr(sys, "stdin", io.StringIO(MEASURES))
    settings = Settings(robot="serial:/dev/robot", wheel_radius=0.024, axle_length=0.080)
    home = {"XDG_CONFIG_HOME": str(tmp_path)}
    order = Order(Invocation("calibrate", {}, Namespace()), settings, Words("en"), Output(), home)

    def made(settings: Settings, _words: Words, pace: Pace, _told: object) -> SimulatedSerialRobot:
        return SimulatedSerialRobot(config=robot_config(settings), pace=pace, speed=None)

    assert calibrate(order, made) == 0
    said = capsys.readouterr().out
    assert said.splitlines()[-1] == "I saved it in the settings."
    assert sizes(said) == (pytest.approx(21, rel=0.01), pytest.approx(68, rel=0.01))
    kept = dict(line.split(" = ") for line in next(tmp_path.rglob("*.toml")).read_text().splitlines())
    assert [float(kept[each]) * 1000 for each in ("wheel_radius", "axle_length")] == [
        pytest.approx(each, abs=0.006) for each in sizes(said)
    ]


class DeafOnceItDrives(SimulatedBoard):
    def advance(self, seconds: float) -> bytes:
        sent = super().advance(seconds)
        self.is_deaf = self.is_deaf or self.is_driving
        return sent


@pytest.mark.parametrize(
    ("is_deaf", "said"),
    [
        (
            False,
            [
                "My wheels count the wrong way.",
                "See encoders, motors and profile in the settings.",
                "Something stopped the robot. I do not count this walk or turn.",
            ],
        ),
        (True, ["It does not stop. Switch it off.", "I have stopped here. Nothing has changed."]),
    ],
    ids=["swapped", "deaf"],
)
def test_a_robot_that_counts_wrong_or_does_not_stop_is_not_measured(
    is_deaf: bool,
    said: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(sys, "stdin", io.StringIO("\n"))
    home = {"XDG_CONFIG_HOME": str(tmp_path)}
    settings = Settings(robot="serial:/dev/robot", profile="2016")
    order = Order(Invocation("calibrate", {}, Namespace()), settings, Words("en"), Output(), home)

    def made(settings: Settings, _words: Words, pace: Pace, report: Any) -> SimulatedSerialRobot:
        board = DeafOnceItDrives(boot_loader=0.0) if is_deaf else SimulatedBoard(boot_loader=0.0)
        board.wheels.encoders = (1, 1) if is_deaf else (-1, -1)
        robot = SimulatedSerialRobot(board, robot_config(settings), pace=pace, speed=None, on_notice=report)
        robot.link.has_reset_wire = False
        return robot

    assert calibrate(order, made) == 1
    assert capsys.readouterr().out.splitlines()[2 : 2 + len(said)] == said


def test_a_calibration_of_the_simulated_board_is_not_saved(tmp_path: Path) -> None:
    done = donnie(tmp_path, "calibrate", "--robot", "double", typed=MEASURES, changes=WRONG)

    said = done.stdout.decode()
    assert (done.returncode, done.stderr) == (0, b"")
    assert sizes(said) == (pytest.approx(21, rel=0.01), pytest.approx(68, rel=0.01))
    assert said.splitlines()[-1] == "That was a simulated board. Nothing is saved."
    assert not list((tmp_path / "config").rglob("*.toml"))


def test_the_simulator_has_no_wheels(tmp_path: Path) -> None:
    done = donnie(tmp_path, "calibrate", "--robot", "sim")

    assert done.returncode == 2
    assert done.stderr.decode().startswith("The simulator has no wheels to measure.")


def test_a_far_off_measure_is_asked_again_and_taken_if_confirmed(tmp_path: Path) -> None:
    typed = "\n720\n100\n\n360\n1440\n1440\n"

    said = donnie(tmp_path, "calibrate", "--robot", "double", typed=typed).stdout.decode()

    far = [line.partition(".")[0] for line in said.splitlines() if "is far from" in line]
    assert far == ["720 is far from 100", "360 is far from 720", "1440 is far from 720"]
    assert sizes(said) == (pytest.approx(21, rel=0.01), pytest.approx(34, rel=0.01))


def test_a_number_before_the_walk_moves_nothing_and_is_reported_as_too_early(tmp_path: Path) -> None:
    said = donnie(tmp_path, "calibrate", "--robot", "double", typed="98\n\n98\n\n\n").stdout.decode()

    lines = said.splitlines()
    assert lines[1:4] == [
        "Mark where the robot is. Press Enter, and it walks 20 steps.",
        "Press Enter alone, please. I will ask for the number after that.",
        "How many centimetres did it walk? Enter alone skips this.",
    ]
    assert any(line.startswith("Wheel radius 20.") for line in lines)


@pytest.mark.parametrize("typed", ["", "\n\n\n\n", "\nfar\n\n", "\n-3\n0\n\n\n\n"])
def test_a_calibration_without_a_measure_changes_nothing(tmp_path: Path, typed: str) -> None:
    done = donnie(tmp_path, "calibrate", "--robot", "double", typed=typed)

    assert done.returncode == 1
    assert done.stdout.decode().splitlines()[-1] == "Nothing was measured. Nothing has changed."
    assert not list((tmp_path / "config").rglob("*.toml"))


def calibration(tmp_path: Path, robot: PtyBoard) -> subprocess.Popen[bytes]:
    """In the middle of the walk."""
    process = subprocess.Popen(
        [*COMMAND, "calibrate", *serial(robot)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        cwd=tmp_path,
        env=environment(tmp_path),
        process_group=0,  # as a shell would: Ctrl+Z leads back to it
    )
    assert process.stdin is not None
    process.stdin.write(b"\n")
    process.stdin.flush()
    assert until(lambda: robot.board.is_driving)
    return process


def test_control_z_in_the_middle_of_a_calibration_stops_the_robot(tmp_path: Path, robot: PtyBoard) -> None:
    process = calibration(tmp_path, robot)
    process.send_signal(signal.SIGTSTP)
    assert is_suspended(process.pid)
    assert until(lambda: not robot.board.is_driving)
    process.send_signal(signal.SIGCONT)

    said, _ = process.communicate(b"", timeout=TIMEOUT)
    assert "Something stopped the robot. I do not count this walk or turn." in said.decode().splitlines()


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGQUIT], ids=lambda each: each.name)
def test_a_signal_in_the_middle_of_a_calibration_stops_the_robot(
    tmp_path: Path, robot: PtyBoard, number: signal.Signals
) -> None:
    process = calibration(tmp_path, robot)
    process.send_signal(number)

    assert until(lambda: not robot.board.is_driving)
    assert process.wait(TIMEOUT) == 130


def test_a_cable_pulled_during_the_walk_is_reported_at_once_and_ends_the_calibration(
    tmp_path: Path, robot: PtyBoard
) -> None:
    process = calibration(tmp_path, robot)
    robot.unplug()

    assert process.wait(TIMEOUT) == 2  # nothing more is typed, and the input has not ended
    assert process.stdout is not None
    assert process.stdout.read().decode().splitlines()[2:] == [
        "Robot lost. If it moves, switch it off.",
        "I have stopped here. Nothing has changed.",
    ]


def test_a_guard_stops_the_robot_that_is_plugged_in_again_after_its_calibration(
    tmp_path: Path, robot: PtyBoard
) -> None:
    robot.has_battery = True
    process = calibration(tmp_path, robot)
    robot.unplug()
    assert process.wait(TIMEOUT) == 2
    assert robot.board.is_driving
    robot.plug()

    assert until(lambda: not robot.board.is_driving)


def test_control_c_in_the_walk_halts_the_robot_and_says_so(tmp_path: Path, robot: PtyBoard) -> None:
    process = calibration(tmp_path, robot)
    process.send_signal(signal.SIGINT)

    assert process.wait(TIMEOUT) == 130
    assert not robot.board.is_driving
    assert process.stdout is not None
    assert process.stdout.read().decode().splitlines()[2:] == ["I have stopped here. Nothing has changed."]
