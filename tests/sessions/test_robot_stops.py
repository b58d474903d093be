"""The board gets a stop, whatever ends the program that drives its robot."""

from __future__ import annotations

import os
import signal
import sys
import threading
from pathlib import Path

import pexpect
import pytest

from devices.wire.frames import CONFIGURE, STOP
from donnie_tui.core.events import CueSounded, Outcome, Stamped
from donnie_tui.core.session import RunOptions
from tests.board_on_pty import PtyBoard
from tests.sessions.command import COMMAND, QUIET, donnie, environment, start
from tests.sessions.learner import CTRL_C, CTRL_Z, Learner
from tests.sessions.real_robot import (
    LONG_WALK,
    assembled,
    half_a_frame,
    is_suspended,
    leave_driving,
    program,
    serial,
    until,
)
from tests.sessions.shell import is_stopped
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow

ENDING = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT]


@pytest.mark.parametrize("number", ENDING, ids=lambda each: each.name)
def test_a_signal_stops_the_robot(tmp_path: Path, robot: PtyBoard, number: signal.Signals) -> None:
    process = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: robot.board.is_driving)
    process.send_signal(number)

    assert until(lambda: not robot.board.is_driving)
    assert process.wait(TIMEOUT) == 130
    assert until(lambda: robot.received.endswith(STOP))


@pytest.mark.parametrize("number", ENDING, ids=lambda each: each.name)
def test_a_signal_while_connecting_ends_it_with_a_stop(
    tmp_path: Path, robot: PtyBoard, number: signal.Signals
) -> None:
    """The board asks for its configuration again and again, and never takes it."""
    robot.board.is_deaf = True
    process = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: CONFIGURE in robot.received and robot.received.endswith(STOP))
    greeted = len(robot.received)
    process.send_signal(number)

    assert process.communicate(timeout=TIMEOUT) == (b"", b"")
    assert process.returncode == 130
    assert until(lambda: robot.received[greeted:].endswith(STOP))


def test_control_z_stops_the_robot_before_the_run_is_suspended(tmp_path: Path, robot: PtyBoard) -> None:
    process = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: robot.board.is_driving)
    process.send_signal(signal.SIGTSTP)
    assert is_suspended(process.pid)
    assert until(lambda: not robot.board.is_driving)
    process.send_signal(signal.SIGCONT)

    _, said = process.communicate(timeout=TIMEOUT)
    assert process.returncode == 130
    assert "You left with Ctrl+Z, so I stopped the robot." in said.decode().splitlines()


def test_control_z_stops_the_robot_of_the_linear_mode(tmp_path: Path, robot: PtyBoard) -> None:
    learner = Learner(tmp_path, *serial(robot), program(tmp_path, LONG_WALK), is_job=True)
    learner.sees("Robot connected.")
    learner.sees_prompt()
    learner.types("RUN\r")
    assert until(lambda: robot.board.is_driving)
    learner.types(CTRL_Z)
    assert until(lambda: is_stopped(learner.pid))
    assert until(lambda: not robot.board.is_driving)
    os.kill(learner.pid, signal.SIGCONT)
    learner.sees("You left with Ctrl+Z, so I stopped the robot.")
    learner.sees("Stopped")


def test_control_z_without_a_shell_above_stops_no_robot(tmp_path: Path, robot: PtyBoard) -> None:
    """As the command of an ssh, where the kernel would suspend nothing."""
    learner = Learner(tmp_path, *serial(robot), program(tmp_path, LONG_WALK))
    learner.sees("Robot connected.")
    learner.sees_prompt()
    learner.types("RUN\r")
    assert until(lambda: robot.board.is_driving)
    learner.types(CTRL_Z)
    learner.sees("Ctrl+Z has no effect here.")
    assert robot.board.is_driving
    learner.types(CTRL_C)
    learner.sees("Stopped")
    assert until(lambda: not robot.board.is_driving)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=lambda each: each.name)
def test_a_run_stops_a_robot_after_half_a_frame(
    tmp_path: Path, robot: PtyBoard, number: signal.Signals
) -> None:
    """Also after a second signal."""
    process = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: robot.board.is_driving)
    half_a_frame(robot)
    process.send_signal(number)
    assert until(lambda: STOP + STOP in robot.received)
    process.send_signal(number)

    assert process.wait(TIMEOUT) == 130
    assert not robot.board.is_driving


def test_a_suspended_run_stops_a_robot_after_half_a_frame(tmp_path: Path, robot: PtyBoard) -> None:
    process = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: robot.board.is_driving)
    half_a_frame(robot)
    process.send_signal(signal.SIGTSTP)

    assert is_suspended(process.pid)
    assert until(lambda: not robot.board.is_driving)
    process.kill()
    process.communicate()


@pytest.mark.parametrize(
    "number", [signal.SIGHUP, signal.SIGTERM, signal.SIGTSTP], ids=lambda each: each.name
)
def test_the_linear_mode_stops_a_robot_after_half_a_frame(
    tmp_path: Path, robot: PtyBoard, number: signal.Signals
) -> None:
    learner = Learner(tmp_path, *serial(robot), program(tmp_path, LONG_WALK), is_job=True)
    learner.sees("Robot connected.")
    learner.sees_prompt()
    learner.types("RUN\r")
    assert until(lambda: robot.board.is_driving)
    half_a_frame(robot)
    os.kill(learner.pid, number)

    if number is signal.SIGTSTP:
        assert until(lambda: is_stopped(learner.pid))
        assert until(lambda: not robot.board.is_driving)
        os.kill(learner.pid, signal.SIGKILL)
    else:
        learner.leaves()
        assert not robot.board.is_driving


@pytest.mark.parametrize(
    "number", [signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT], ids=lambda each: each.name
)
@pytest.mark.parametrize("mode", ["--linear", "--visual"])
def test_a_signal_to_a_front_end_stops_the_robot(
    tmp_path: Path, robot: PtyBoard, mode: str, number: signal.Signals
) -> None:
    front_end = pexpect.spawn(
        sys.executable,
        [*COMMAND[1:], mode, *serial(robot), *QUIET, program(tmp_path, LONG_WALK)],
        env=environment(tmp_path, {"TERM": "xterm-256color"}),
        cwd=str(tmp_path),
        dimensions=(24, 80),
        timeout=TIMEOUT,
    )
    drained = threading.Thread(target=front_end.expect, args=(pexpect.EOF,), daemon=True)
    assert until(lambda: CONFIGURE in robot.received)
    front_end.expect("onnected")
    front_end.send("\x1b[15~" if mode == "--visual" else "RUN\r")
    drained.start()
    assert until(lambda: robot.board.is_driving)
    front_end.kill(number)

    assert until(lambda: not robot.board.is_driving)
    drained.join(TIMEOUT)
    assert until(lambda: robot.received.endswith(STOP))


def test_the_robot_of_a_killed_program_is_stopped(tmp_path: Path, robot: PtyBoard) -> None:
    process = start(tmp_path, "run", program(tmp_path, LONG_WALK), *serial(robot), *QUIET)
    assert until(lambda: robot.board.is_driving)
    process.kill()

    assert until(lambda: not robot.board.is_driving)
    assert process.wait(TIMEOUT) == -signal.SIGKILL


@pytest.mark.parametrize("mode", ["--linear", "--visual"])
def test_the_robot_of_a_killed_front_end_is_stopped(tmp_path: Path, robot: PtyBoard, mode: str) -> None:
    front_end = pexpect.spawn(
        sys.executable,
        [*COMMAND[1:], mode, *serial(robot), *QUIET, program(tmp_path, LONG_WALK)],
        env=environment(tmp_path, {"TERM": "xterm-256color"}),
        cwd=str(tmp_path),
        dimensions=(30, 100),
        encoding="utf-8",
        timeout=TIMEOUT,
    )
    front_end.expect("Robot connected")
    front_end.send("RUN\r" if mode == "--linear" else "\x1b[15~")
    assert until(lambda: robot.board.is_driving)
    front_end.kill(signal.SIGKILL)

    assert until(lambda: not robot.board.is_driving)
    front_end.close()


def test_a_robot_that_drives_without_a_program_is_halted_by_donnie_stop(
    tmp_path: Path, robot: PtyBoard
) -> None:
    leave_driving(robot)

    done = donnie(tmp_path, "stop", robot.path)
    assert done.stdout.decode() == f"The robot has stopped. Port {robot.path}.\n"
    assert done.returncode == 0
    assert not robot.board.is_driving


def test_a_listener_that_fails_in_the_middle_of_a_walk_stops_the_robot(robot: PtyBoard) -> None:
    donnie = assembled(robot)

    def fail(stamped: Stamped) -> None:
        if isinstance(stamped.event, CueSounded) and stamped.event.name == "step-forward":
            raise ZeroDivisionError("an internal fault")

    try:
        donnie.session.hub.subscribe(fail)
        run = donnie.session.start("FW 100", "test.gd", RunOptions(hooked=False))
        assert until(lambda: robot.board.is_driving)
        assert run.wait(TIMEOUT)

        assert run.outcome is Outcome.FAILED
        assert until(lambda: not robot.board.is_driving)
    finally:
        donnie.close()


def test_closing_a_session_stops_its_run(robot: PtyBoard) -> None:
    donnie = assembled(robot)
    donnie.session.start("FW 100", "test.gd", RunOptions(hooked=False))
    assert until(lambda: robot.board.is_driving)
    donnie.close()

    assert until(lambda: not robot.board.is_driving)
    assert until(lambda: robot.received.endswith(STOP))
