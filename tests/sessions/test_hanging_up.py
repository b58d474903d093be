"""A closed terminal ends Donnie, also under a reader that passes its end of it on, as YASR does."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import pytest

from donnie_tui.process.disconnection import keeper_of, masters_of
from tests.conftest import ROOT
from tests.sessions.command import COMMAND, QUIET, environment
from tests.sessions.learner import until
from tests.timeouts import TIMEOUT

pytestmark = [pytest.mark.slow, pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")]

LEAKING = """
import fcntl, os, pty, sys, termios
master, slave = os.openpty()
os.set_inheritable(master, True)
child = os.fork()
if child == 0:
    os.setsid()
    fcntl.ioctl(slave, termios.TIOCSCTTY, 0)
    for number in range(3):
        os.dup2(slave, number)
    os.closerange(slave, slave + 1)
    os.execvp(sys.argv[1], sys.argv[1:])
os.close(slave)
os.write(1, f"{child}\\n".encode())
while data := os.read(master, 4096):
    os.write(1, data)
"""
"""A reader: it starts what it reads on a terminal, whose other end it gives away."""


@pytest.mark.parametrize("shell", [(), ("/bin/sh", "-c", '"$@"; :', "-")], ids=["alone", "in_a_shell"])
def test_donnie_ends_with_a_reader_that_passed_its_end_on(shell: tuple[str, ...], tmp_path: Path) -> None:
    donnie = (sys.executable, "-m", "donnie_tui", "--linear", "--speech", "off", "--sound", "off")
    environment = {
        **os.environ,
        "PYTHONPATH": str(ROOT),
        "XDG_STATE_HOME": str(tmp_path),
        "XDG_CONFIG_HOME": str(tmp_path),
        "DONNIE_TOUR": "off",
        "DONNIE_MARK": str(tmp_path),
    }
    reader = subprocess.Popen(
        [sys.executable, "-c", LEAKING, *shell, *donnie],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        env=environment,
    )
    assert reader.stdout is not None
    child = int(reader.stdout.readline())
    try:
        seen = b""
        while b"> " not in seen:
            seen += os.read(reader.stdout.fileno(), 4_096)
        until(lambda: any(map(watches_a_process, donnies(tmp_path))))  # which it begins after its prompt
        reader.kill()
        reader.wait()
        until(lambda: not donnies(tmp_path))
    finally:
        reader.kill()
        for pid in (child, *donnies(tmp_path)):
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)


def watches_a_process(pid: int) -> bool:
    """Whether it has asked the kernel to report the end of another process."""
    with suppress(OSError):
        return any("pidfd" in str(each.readlink()) for each in Path(f"/proc/{pid}/fd").iterdir())
    return False


def donnies(mark: Path) -> list[int]:
    """The Donnies of this test. An ended process has no command line."""
    found = []
    for each in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):
            words = (each / "cmdline").read_bytes().split(b"\0")
            is_ours = f"DONNIE_MARK={mark}".encode() in (each / "environ").read_bytes()
            if is_ours and words[1:3] == [b"-m", b"donnie_tui"]:
                found.append(int(each.name))
    return found


def test_the_end_of_another_terminal_does_not_end_donnie() -> None:
    ours, terminal = os.openpty()
    other, another = os.openpty()
    try:
        assert masters_of(os.ttyname(terminal)) == [ours]
    finally:
        for number in (ours, terminal, other, another):
            os.close(number)


@pytest.mark.parametrize(
    "options", [(), ("--speed", "max"), ("--robot", "serial:/dev/nothing")], ids=["alone", "speed", "robot"]
)
def test_the_linear_mode_ends_without_a_fault_when_its_output_is_closed(
    tmp_path: Path, options: tuple[str, ...]
) -> None:
    reading, writing = os.pipe()
    os.close(reading)
    done = subprocess.run(
        [*COMMAND, "--linear", *QUIET, *options],
        stdin=subprocess.DEVNULL,
        stdout=writing,
        stderr=subprocess.PIPE,
        cwd=tmp_path,
        env=environment(tmp_path),
        timeout=TIMEOUT,
    )
    os.close(writing)

    assert (done.returncode, done.stderr) == (128 + signal.SIGHUP, b"")


def test_an_unreadable_process_keeps_no_terminal() -> None:
    """It has just ended, or it is a hidden process of another user."""
    ended = subprocess.Popen([sys.executable, "-c", ""])
    ended.wait(TIMEOUT)

    assert keeper_of(ended.pid) is None
