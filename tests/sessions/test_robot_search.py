"""The search for a robot that does not answer can be cancelled."""

from __future__ import annotations

import os
import signal
import sys
import tty
from collections.abc import Iterator
from pathlib import Path

import pexpect
import pytest

from tests.sessions.command import COMMAND, QUIET, end, environment
from tests.sessions.learner import Learner
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow


@pytest.fixture
def mute_port(tmp_path: Path) -> Iterator[str]:
    """A port without an answer: the search for a robot takes seconds there.

    A link, which is gone before the terminal: a Donnie that still searches must not open the terminal of
    another test, which may get the number.
    """
    ours, theirs = os.openpty()
    tty.setraw(theirs)
    port = tmp_path / "port"
    port.symlink_to(os.ttyname(theirs))
    yield str(port)
    port.unlink()
    os.close(ours)
    os.close(theirs)


def at_terminal(folder: Path, *arguments: str) -> pexpect.spawn:
    return pexpect.spawn(
        sys.executable,
        [*COMMAND[1:], *arguments],
        env=environment(folder, {"TERM": "xterm-256color"}),
        cwd=str(folder),
        dimensions=(24, 80),
        timeout=TIMEOUT,
    )


@pytest.mark.parametrize(
    ("command", "announced"),
    [("devices {}", "I ask 1 port"), ("calibrate --robot serial:{}", "I will connect")],
    ids=["devices", "calibrate"],
)
def test_control_c_ends_a_command_that_looks_for_a_robot(
    tmp_path: Path, mute_port: str, command: str, announced: str
) -> None:
    front_end = at_terminal(tmp_path, *command.format(mute_port).split())
    front_end.expect(announced)
    front_end.sendintr()
    front_end.expect(pexpect.EOF)

    assert "answers" not in front_end.before.decode()
    front_end.wait()
    front_end.close()
    assert front_end.exitstatus == 130


@pytest.mark.parametrize("keys", ["\x03", "\x1b[19~"], ids=["ctrl-c", "f8"])
def test_a_stop_key_cancels_the_search_of_the_full_screen(tmp_path: Path, mute_port: str, keys: str) -> None:
    front_end = at_terminal(tmp_path, "--visual", *QUIET, "--robot", f"serial:{mute_port}")
    front_end.expect("I am looking for the robot")
    front_end.expect("Waiting for the robot. Ctrl\\+C gives up.")
    front_end.send("SPEAK 12")
    front_end.send(keys)
    front_end.expect("I have stopped looking for the robot")
    front_end.expect("I will use the simulator")
    front_end.send("\x11")
    front_end.expect("is not saved")  # what was typed meanwhile is there
    end(front_end)


@pytest.mark.parametrize("moment", ["at the start", "by a word"])
def test_control_c_cancels_the_search_of_the_linear_mode(tmp_path: Path, mute_port: str, moment: str) -> None:
    learner = Learner(tmp_path, "--robot", f"serial:{mute_port}")
    for _ in range(1 if moment == "at the start" else 2):
        learner.sees("I am looking for the robot. Please wait.")
        learner.sees("Waiting for the robot. Ctrl+C gives up.")
        learner.child.sendintr()
        learner.sees("I have stopped looking for the robot.")
        learner.sees("I will use the simulator. CONNECT tries again.")
        learner.sees_prompt()
        learner.types("WHERE\r")
        learner.sees("north")
        learner.sees_prompt()
        learner.types("CONNECT 2\r")
    end(learner.child)


def test_a_signal_ends_a_front_end_that_looks_for_a_robot(tmp_path: Path, mute_port: str) -> None:
    for mode, announced in (("--linear", "Waiting for the robot"), ("--visual", "tarting")):
        front_end = at_terminal(tmp_path, mode, *QUIET, "--robot", f"serial:{mute_port}")
        front_end.expect(announced)
        front_end.kill(signal.SIGTERM)
        front_end.expect(pexpect.EOF)
        front_end.wait()
        front_end.close()

        assert "No robot answers" not in front_end.before.decode()
        assert "Traceback" not in front_end.before.decode()
        assert front_end.exitstatus == 128 + signal.SIGTERM
