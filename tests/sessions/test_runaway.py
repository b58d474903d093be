"""A robot that drives on although Donnie did all to stop it, and one that was unplugged while it drove."""

from __future__ import annotations

import json
import signal
import sys
from pathlib import Path

import pexpect
import pytest

from tests.board_on_pty import PtyBoard
from tests.sessions.command import COMMAND, QUIET, donnie, environment, start
from tests.sessions.learner import Learner
from tests.sessions.real_robot import LONG_WALK, SOON, leave_driving, program, serial, until
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow

SENTENCE = "It does not stop. Switch it off."


def test_a_run_whose_robot_does_not_stop_says_so_and_fails(tmp_path: Path, robot: PtyBoard) -> None:
    events = tmp_path / "events.jsonl"
    file = program(tmp_path, LONG_WALK)
    process = start(tmp_path, "run", file, *serial(robot), *QUIET, "--events", str(events), changes=SOON)
    assert until(lambda: robot.board.is_driving)
    robot.board.is_deaf = True
    process.send_signal(signal.SIGINT)

    printed, _ = process.communicate(timeout=TIMEOUT)
    lines = printed.decode().splitlines()
    assert SENTENCE in lines
    assert any(line.endswith("I can't stop.") for line in lines)
    assert not any("I was stopped" in line for line in lines)
    assert process.returncode == 1
    assert robot.board.is_driving
    published = [json.loads(line) for line in events.read_text(encoding="utf-8").splitlines()]
    assert [each["state"] for each in published if each["event"] == "link"] == ["connected", "runaway"]


def test_a_robot_that_does_not_stop_is_reported_to_its_learner(tmp_path: Path, robot: PtyBoard) -> None:
    learner = Learner(tmp_path, *serial(robot), program(tmp_path, LONG_WALK), **SOON)
    learner.sees("Robot connected.")
    learner.sees_prompt()
    learner.types("RUN\r")
    assert until(lambda: robot.board.is_driving)
    robot.board.is_deaf = True
    learner.child.sendintr()
    learner.sees(SENTENCE)
    learner.sees("I can't stop.")
    learner.sees_prompt()
    learner.types("QUIT\r")

    assert learner.leaves() == 1


@pytest.mark.parametrize("mode", ["--linear", "--visual"])
def test_a_front_end_that_leaves_a_driving_robot_ends_with_1_and_the_sentence(
    tmp_path: Path, robot: PtyBoard, mode: str
) -> None:
    front_end = pexpect.spawn(
        sys.executable,
        [*COMMAND[1:], mode, *serial(robot), *QUIET, program(tmp_path, LONG_WALK)],
        env=environment(tmp_path, {"TERM": "xterm-256color", **SOON}),
        cwd=str(tmp_path),
        dimensions=(30, 100),
        encoding="utf-8",
        timeout=TIMEOUT,
    )
    front_end.expect("Robot connected")
    front_end.send("RUN\r" if mode == "--linear" else "\x1b[15~")
    assert until(lambda: robot.board.is_driving)
    robot.board.is_deaf = True
    front_end.kill(signal.SIGTERM)
    front_end.expect_exact(SENTENCE)
    front_end.expect(pexpect.EOF)
    front_end.close()

    assert front_end.exitstatus == 1


def test_a_deaf_robot_is_reported_to_drive_after_a_stop_from_outside(tmp_path: Path, robot: PtyBoard) -> None:
    leave_driving(robot)

    listed = donnie(tmp_path, "devices", robot.path)
    assert listed.stdout.decode().splitlines()[1:] == [
        f"{robot.path}: robot, original firmware. It moves.",
        f"Stop it: donnie stop {robot.path}",
    ]
    assert listed.returncode == 1
    robot.board.is_deaf = True
    deaf = donnie(tmp_path, "stop", robot.path)
    assert deaf.stdout.decode() == f"I said stop, but the robot at {robot.path} still moves. Switch it off.\n"
    assert deaf.returncode == 1
    robot.board.is_deaf = False
    assert donnie(tmp_path, "stop", robot.path).returncode == 0
    assert not robot.board.is_driving


# --- unplugged


def test_a_guard_stops_the_robot_that_is_plugged_in_again_after_its_run(
    tmp_path: Path, robot: PtyBoard
) -> None:
    """It has a battery, and drives on meanwhile."""
    robot.has_battery = True
    process = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: robot.board.is_driving)
    robot.unplug()
    process.communicate(timeout=TIMEOUT)
    assert process.returncode == 1
    assert robot.board.is_driving
    robot.plug()

    assert until(lambda: not robot.board.is_driving)


def test_a_stop_for_services_waits_for_a_robot_that_is_unplugged(tmp_path: Path, robot: PtyBoard) -> None:
    robot.has_battery = True
    leave_driving(robot)
    robot.unplug()
    waiting = start(tmp_path, "stop", "--wait", robot.path)
    assert waiting.stdout is not None
    assert waiting.stdout.readline().decode() == f"I will wait for {robot.path}, a minute at most.\n"
    robot.plug()

    assert waiting.communicate(timeout=TIMEOUT)[0].decode() == f"The robot has stopped. Port {robot.path}.\n"
    assert waiting.returncode == 0
    assert not robot.board.is_driving
