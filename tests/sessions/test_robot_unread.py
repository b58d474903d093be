"""A robot is stopped although its output is not read."""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import termios
from collections.abc import Callable, Iterator
from itertools import cycle
from pathlib import Path

import pexpect
import pytest

from devices.wire.frames import CONFIGURE, STOP
from tests.board_on_pty import PtyBoard
from tests.sessions.command import COMMAND, QUIET, environment
from tests.sessions.learner import Learner
from tests.sessions.real_robot import SOON, half_a_frame, program, serial, until
from tests.sessions.shell import is_stopped
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow


@contextlib.contextmanager
def terminal_that_takes_nothing(child: pexpect.spawn) -> Iterator[None]:
    """As after Ctrl+S or over a hanging network."""
    terminal = os.open(Path(f"/proc/{child.pid}/fd/1").readlink(), os.O_RDWR | os.O_NOCTTY)
    termios.tcflow(terminal, termios.TCOOFF)
    try:
        yield
    finally:
        termios.tcflow(terminal, termios.TCOON)
        os.close(terminal)


def is_stuck(process: int) -> Callable[[], bool]:
    """Whether a thread of it waits for the terminal."""
    waits = ("tty", "wait_woken", "n_tty_write")
    threads = Path(f"/proc/{process}/task")
    return lambda: any(_place(each) in waits for each in threads.iterdir())


def _place(thread: Path) -> str:
    """Where in the kernel a thread waits; nowhere once it has ended."""
    try:
        return (thread / "wchan").read_text()
    except OSError:
        return ""


def driving_run(folder: Path, robot: PtyBoard, text: str, **changes: str) -> pexpect.spawn:
    """``donnie run`` with that program, its robot driving."""
    run = pexpect.spawn(
        sys.executable,
        [*COMMAND[1:], "run", program(folder, text), *serial(robot), *QUIET],
        env=environment(folder, changes),
        cwd=str(folder),
        timeout=TIMEOUT,
    )
    assert until(lambda: robot.board.is_driving)
    return run


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=lambda each: each.name)
def test_a_run_with_unread_output_stops_its_robot_and_ends(
    tmp_path: Path, robot: PtyBoard, number: signal.Signals
) -> None:
    """The printing thread and the run hang, and the board waits for the rest of a frame."""
    run = driving_run(tmp_path, robot, "FW 300\n")
    with terminal_that_takes_nothing(run):
        robot.board.millivolts = 6000
        assert until(is_stuck(run.pid))
        half_a_frame(robot)
        run.kill(number)

        assert until(lambda: not run.isalive())
        assert not robot.board.is_driving
    assert run.exitstatus == 130


def test_a_run_that_has_ended_with_unread_output_can_be_stopped(tmp_path: Path, robot: PtyBoard) -> None:
    """Another thread prints than the one of the program, which ends by itself."""
    run = driving_run(tmp_path, robot, "FW 1\nWAIT 10\n")
    with terminal_that_takes_nothing(run):
        robot.board.millivolts = 6000
        assert until(is_stuck(run.pid))
        threads = Path(f"/proc/{run.pid}/task")
        before = len([*threads.iterdir()])
        assert until(lambda: len([*threads.iterdir()]) < before)
        run.kill(signal.SIGINT)

        assert until(lambda: not run.isalive())
    assert run.exitstatus == 130


def test_a_run_with_unread_output_whose_robot_does_not_stop_fails(tmp_path: Path, robot: PtyBoard) -> None:
    run = driving_run(tmp_path, robot, "FW 300\n", **SOON)
    with terminal_that_takes_nothing(run):
        robot.board.millivolts = 6000
        assert until(is_stuck(run.pid))
        robot.board.is_deaf = True
        run.kill(signal.SIGINT)

        assert until(lambda: not run.isalive())
    assert robot.board.is_driving
    assert run.exitstatus == 1


def test_control_z_stops_the_robot_of_the_linear_mode_at_a_stuck_terminal(
    tmp_path: Path, robot: PtyBoard
) -> None:
    learner = Learner(tmp_path, *serial(robot), program(tmp_path, "FW 300\n"), is_job=True)
    learner.sees("Robot connected.")
    learner.sees_prompt()
    learner.types("RUN\r")
    assert until(lambda: robot.board.is_driving)
    with terminal_that_takes_nothing(learner.child):
        robot.board.millivolts = 6000
        assert until(is_stuck(learner.pid))
        os.kill(learner.pid, signal.SIGTSTP)

        assert until(lambda: not robot.board.is_driving)
    assert until(lambda: is_stopped(learner.pid))
    os.kill(learner.pid, signal.SIGCONT)
    learner.sees("You left with Ctrl+Z, so I stopped the robot.")


PAINT_ANEW = "\x0b\x1b[15~"
"""The keys for it: all of the screen is more than a terminal keeps; a robot that walks changes few cells."""


def is_full(screen: pexpect.spawn) -> Callable[[], bool]:
    """Whether a thread of it waits for the terminal in most looks, but for what a signal wakes it."""
    is_waiting, looks = is_stuck(screen.pid), list[bool]()

    def look() -> bool:
        if len(looks) % 50 == 0:
            screen.send(PAINT_ANEW)
        looks.append(is_waiting())
        return len(looks) > 50 and sum(looks[-50:]) > 40

    return look


def unread_screen(folder: Path, robot: PtyBoard) -> pexpect.spawn:
    """The full screen, its robot driving, at a terminal with unread output from then on."""
    screen = pexpect.spawn(
        sys.executable,
        [*COMMAND[1:], "--visual", *serial(robot), *QUIET, program(folder, "FW 1000\n")],
        env=environment(folder, {"TERM": "xterm-256color"}),
        cwd=str(folder),
        dimensions=(60, 200),
        timeout=TIMEOUT,
    )
    assert until(lambda: CONFIGURE in robot.received)
    screen.expect("onnected")
    screen.send("\x1b[15~")
    assert until(lambda: (read(screen), robot.board.is_driving)[1])
    assert until(is_full(screen))
    return screen


def read(screen: pexpect.spawn) -> bytes:
    """The unread output."""
    try:
        return screen.read_nonblocking(65536, timeout=0)
    except pexpect.TIMEOUT:
        return b""


def test_a_stuck_screen_stops_the_robot_by_itself(tmp_path: Path, robot: PtyBoard) -> None:
    """Although signals keep arriving."""
    screen = unread_screen(tmp_path, robot)
    widths = cycle((200, 199))

    assert until(lambda: (screen.setwinsize(60, next(widths)), not robot.board.is_driving)[1])
    assert screen.isalive()
    screen.kill(signal.SIGKILL)


@pytest.mark.parametrize(
    "number", [signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT], ids=lambda each: each.name
)
def test_a_signal_ends_a_stuck_screen(tmp_path: Path, robot: PtyBoard, number: signal.Signals) -> None:
    screen = unread_screen(tmp_path, robot)
    screen.kill(number)

    assert until(lambda: not robot.board.is_driving)
    assert until(lambda: not screen.isalive())
    assert until(lambda: robot.received.endswith(STOP))


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGQUIT], ids=lambda each: each.name)
def test_a_stuck_screen_ends_although_its_terminal_is_closed_meanwhile(
    tmp_path: Path, robot: PtyBoard, number: signal.Signals
) -> None:
    screen = unread_screen(tmp_path, robot)
    screen.kill(number)
    assert until(lambda: not robot.board.is_driving)
    screen.ptyproc.fileobj.close()

    assert until(lambda: not screen.isalive())
    assert robot.received.endswith(STOP)
