"""SIGTERM and SIGHUP end Donnie in time, whatever hangs: the robot is stopped, and the typed text is kept."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import threading
from pathlib import Path

import pexpect
import pytest

from donnie_tui.process import signals
from donnie_tui.tui import shutdown
from tests.board_on_pty import PtyBoard
from tests.free_ports import free_port
from tests.sessions.command import QUIET, donnie, environment
from tests.sessions.hanging import HANG, HANGING
from tests.sessions.real_robot import LONG_WALK, program, serial, until
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow

AT_MOST = 5.0
SOON = {"DONNIE_ROBOT_TIMEOUTS": "2"}
"""The end is waited for twice as long as by default."""
FAULTY = (sys.executable, "-m", "tests.sessions.hanging")
ROOT = Path(__file__).parents[2]
FAULTS = pytest.mark.parametrize("fault", ["loop", "call"])


def test_a_signal_ends_donnie_within_five_seconds() -> None:
    assert signals.LEAVE + signals.LAST < AT_MOST
    assert shutdown.LEAVE + signals.LAST < AT_MOST


def around(folder: Path) -> dict[str, str]:
    return environment(folder, {"TERM": "xterm-256color", "PYTHONPATH": str(ROOT), **SOON})


def copied(folder: Path) -> list[str]:
    return [each.read_text() for each in (folder / "state").rglob("unsaved-*.gd")]


def hang(folder: Path) -> None:
    (folder / HANG).touch()


def hangs(folder: Path) -> bool:
    return (folder / HANGING).exists()


def front_end(folder: Path, mode: str, fault: str, *arguments: str, place: str = "") -> pexpect.spawn:
    return pexpect.spawn(
        FAULTY[0],
        [*FAULTY[1:], place or mode.removeprefix("--"), fault, mode, *QUIET, *arguments],
        env=around(folder),
        cwd=str(folder),
        dimensions=(30, 100),
        timeout=TIMEOUT,
    )


def command(folder: Path, place: str, fault: str, *arguments: str) -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        [*FAULTY, place, fault, *arguments],
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        cwd=folder,
        env=around(folder),
    )


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP], ids=lambda each: each.name)
@FAULTS
def test_a_linear_mode_that_hangs_ends_and_keeps_the_text(
    tmp_path: Path, fault: str, number: signal.Signals
) -> None:
    linear = front_end(tmp_path, "--linear", fault)
    for line in ("FW 1", "FW 2"):
        linear.expect_exact("> ")
        linear.send(f"{line}\r")
    linear.expect_exact("2\r\n")
    hang(tmp_path)
    linear.send("x")
    assert until(lambda: hangs(tmp_path))
    linear.kill(number)

    linear.expect(pexpect.EOF)
    linear.close()
    assert linear.exitstatus == 128 + number
    assert copied(tmp_path) == ["FW 1\nFW 2\n"]


@pytest.mark.slow
@pytest.mark.parametrize("mode", ["--linear", "--visual"])
@FAULTS
def test_a_front_end_that_hangs_stops_the_robot_and_keeps_the_text(
    tmp_path: Path, robot: PtyBoard, mode: str, fault: str
) -> None:
    front = front_end(tmp_path, mode, fault, *serial(robot), program(tmp_path, LONG_WALK))
    front.expect("Robot connected")
    front.send("RUN\r" if mode == "--linear" else "\x1b[15~")
    assert until(lambda: robot.board.is_driving)
    drained = threading.Thread(target=front.expect, args=(pexpect.EOF,), daemon=True)
    drained.start()
    hang(tmp_path)
    if mode == "--linear":
        front.send("x")
        assert until(lambda: hangs(tmp_path))
        assert robot.board.is_driving
    os.kill(front.pid, signal.SIGTERM)

    drained.join(TIMEOUT)
    assert until(lambda: not robot.board.is_driving)
    front.close()
    assert hangs(tmp_path)
    assert front.exitstatus == 128 + signal.SIGTERM


@pytest.mark.slow
@FAULTS
def test_a_session_that_hangs_after_the_full_screen_is_gone_ends(tmp_path: Path, fault: str) -> None:
    spoken = program(tmp_path, "SPEAK 4000 + 711")
    front = front_end(tmp_path, "--visual", fault, spoken, place="close")
    front.expect_exact("4000")
    front.send("\x1b[15~")
    front.expect_exact("4711")
    drained = threading.Thread(target=front.expect, args=(pexpect.EOF,), daemon=True)
    drained.start()
    hang(tmp_path)
    os.kill(front.pid, signal.SIGTERM)

    drained.join(TIMEOUT)
    front.close()
    assert hangs(tmp_path)
    assert front.exitstatus == 128 + signal.SIGTERM


@pytest.mark.slow
@pytest.mark.parametrize("place", ["run", "calibrate"])
@FAULTS
def test_a_command_that_hangs_stops_the_robot(
    tmp_path: Path, robot: PtyBoard, place: str, fault: str
) -> None:
    what = [program(tmp_path, LONG_WALK), *QUIET] if place == "run" else []
    process = command(tmp_path, place, fault, place, *what, *serial(robot))
    assert process.stdin is not None
    process.stdin.write(b"\n")
    process.stdin.flush()
    if place == "run":
        hang(tmp_path)
    assert until(lambda: robot.board.is_driving)
    hang(tmp_path)
    assert until(lambda: hangs(tmp_path))
    assert robot.board.is_driving
    process.send_signal(signal.SIGTERM)

    assert process.wait(TIMEOUT) == 130
    assert not robot.board.is_driving


@pytest.mark.slow
@pytest.mark.parametrize("options", [(), ("--check",), ("--step",)], ids=["replay", "check", "step"])
@FAULTS
def test_a_replay_that_hangs_ends(tmp_path: Path, options: tuple[str, ...], fault: str) -> None:
    donnie(tmp_path, "run", "-", *QUIET, "--record", "a.rec", typed="FW 2")
    place = "check" if "--check" in options else "replay"
    hang(tmp_path)
    process = command(tmp_path, place, fault, "replay", "a.rec", *QUIET, *options)
    assert process.stdin is not None
    process.stdin.write(b"go\n")
    process.stdin.flush()
    assert until(lambda: hangs(tmp_path))
    process.send_signal(signal.SIGHUP)

    assert process.wait(TIMEOUT) == 130


def answers(port: int) -> bool:
    try:
        socket.create_connection(("localhost", port)).close()
    except ConnectionRefusedError:
        return False
    return True


@pytest.mark.slow
@FAULTS
def test_a_server_of_pages_that_hangs_ends(tmp_path: Path, fault: str) -> None:
    port = free_port()
    process = command(tmp_path, "serve", fault, "serve", "--port", str(port), *QUIET)
    hang(tmp_path)
    assert until(lambda: answers(port))
    with socket.create_connection(("localhost", port)) as page:
        page.sendall(b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n")
        assert until(lambda: hangs(tmp_path))
        process.send_signal(signal.SIGTERM)

        assert process.wait(TIMEOUT) == 130
