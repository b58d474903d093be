"""Whether a suspended process still has a terminal and a shell that could resume it."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from donnie_tui.process.signals import has_unread, is_hung_up
from tests.conftest import ROOT
from tests.timeouts import TIMEOUT


def test_a_terminal_that_was_closed_is_gone() -> None:
    ours, terminal = os.openpty()
    try:
        assert not is_hung_up(terminal)
        os.close(ours)
        assert is_hung_up(terminal)
    finally:
        os.close(terminal)


def test_a_pipe_with_a_closed_writer_is_no_terminal() -> None:
    reading, writing = os.pipe()
    os.close(writing)
    try:
        assert not is_hung_up(reading)
    finally:
        os.close(reading)


def test_input_is_unread_until_it_is_read_and_a_closed_terminal_has_none() -> None:
    reading, writing = os.pipe()
    ours, terminal = os.openpty()
    assert not has_unread(reading)
    os.write(writing, b"x")
    assert has_unread(reading)
    os.read(reading, 1)
    assert not has_unread(reading)
    os.close(ours)
    assert not has_unread(terminal)
    for each in (reading, writing, terminal):
        os.close(each)
        assert not has_unread(each)


ASK = "from donnie_tui.process.signals import can_suspend; print(can_suspend())"


def answer(command: list[str], **how: object) -> str:
    """What a process that asks prints, below this one."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=TIMEOUT, **how)  # type: ignore[call-overload]
    return done.stdout.strip() + done.stderr


def test_the_job_of_a_shell_can_be_suspended() -> None:
    assert answer([sys.executable, "-c", ASK], process_group=0) == "True"


def test_a_program_that_a_script_started_can_be_suspended_with_it() -> None:
    assert answer(["sh", "-c", f'"{sys.executable}" -c "{ASK}"; true'], process_group=0) == "True"


@pytest.mark.parametrize(
    "script", ['exec "{0}" -c "{1}"', '"{0}" -c "{1}"; true', 'sh -c \'"{0}" -c "{1}"\'; true']
)
def test_the_command_of_an_ssh_can_not_be_suspended(script: str) -> None:
    """Nor that of a new terminal: it is in the group of the session's leader, whose parent is outside."""
    assert answer(["sh", "-c", script.format(sys.executable, ASK)], start_new_session=True) == "False"


def test_a_job_whose_shell_has_ended_can_not_be_suspended() -> None:
    """The shell starts it in a group of its own, and ends before it asks."""
    shell = (
        "import os, subprocess, sys; r, w = os.pipe(); os.set_inheritable(r, True);"
        f"code = 'import os; os.read(' + str(r) + ', 1);' + {ASK!r};"
        "subprocess.Popen([sys.executable, '-c', code], process_group=0, pass_fds=(r,))"
    )
    assert answer([sys.executable, "-c", shell], start_new_session=True) == "False"


def test_a_confined_session_can_not_be_suspended(tmp_path: Path) -> None:
    confined = f"from donnie_tui.process.confinement import *; confine(Confinement({str(tmp_path)!r})); {ASK}"
    assert answer([sys.executable, "-c", confined], process_group=0) == "False"
