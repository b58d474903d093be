"""Whether a suspended process still has a terminal and a shell that could resume it."""

import os
import signal
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace as Part
from typing import Any

import pytest

from donnie_tui.process import signals
from donnie_tui.process.signals import has_shell_above, has_unread, is_hung_up
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


class Processes:
    """Processes by their numbers: the parent, the group and the session of each; 0 means this one, 9."""

    def __init__(self, others: dict[int, tuple[int, int, int]]) -> None:
        self._all = others | {0: others[9]}

    def _of(self, number: int) -> tuple[int, int, int]:
        if number not in self._all:
            raise ProcessLookupError(number)
        return self._all[number]

    def getppid(self) -> int:
        return self._of(9)[0]

    def parent_of(self, number: int) -> int:
        return self._of(number)[0]

    def getpgrp(self) -> int:
        return self._of(9)[1]

    def getpgid(self, number: int) -> int:
        return self._of(number)[1]

    def getsid(self, number: int) -> int:
        return self._of(number)[2]


@pytest.mark.parametrize(
    ("processes", "has_shell"),
    [
        ({9: (5, 9, 2), 5: (2, 2, 2)}, True),  # a job of a shell
        ({9: (5, 4, 2), 5: (4, 4, 2), 4: (2, 4, 2), 2: (1, 2, 2)}, True),  # in a script of a shell
        ({9: (1, 9, 1), 1: (0, 1, 1)}, True),  # the shell is the first process of a container
        ({9: (5, 2, 2), 5: (2, 2, 2), 2: (1, 2, 2)}, False),  # the group of the leader of the session
        ({9: (1, 9, 2), 1: (0, 1, 1)}, False),  # its shell has ended
        ({9: (1, 4, 1), 1: (0, 4, 1)}, False),  # its own group up to the first process
        ({9: (0, 9, 2)}, False),  # the parent is in another container
        ({9: (5, 9, 2)}, False),  # the parent ended just now
    ],
)
def test_a_shell_is_in_another_group_of_the_session(
    processes: dict[int, tuple[int, int, int]], has_shell: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    fake = Processes(processes)
    for name in ("getppid", "getpgrp", "getpgid", "getsid"):
        monkeypatch.setattr(signals.os, name, getattr(fake, name))
    monkeypatch.setattr(signals, "parent_of", fake.parent_of)

    assert has_shell_above() is has_shell


@pytest.mark.parametrize(("raised", "has_shell"), [(FileNotFoundError, True), (PermissionError, False)])
def test_a_parent_that_no_file_names_may_have_a_shell(
    raised: type[OSError], has_shell: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    def parent_of(_: int) -> int:
        raise raised

    for name, answer in (("getppid", 5), ("getpgrp", 4), ("getpgid", 4), ("getsid", 2)):
        monkeypatch.setattr(signals.os, name, lambda *_, answer=answer: answer)
    monkeypatch.setattr(signals, "parent_of", parent_of)

    assert has_shell_above() is has_shell


@pytest.mark.parametrize(
    ("hung_up", "may_run", "has_shell", "can"),
    [
        (None, True, True, True),
        (0, True, True, False),
        (1, True, True, False),
        (2, True, True, False),
        (3, True, True, True),
        (None, False, True, False),
        (None, True, False, False),
    ],
)
def test_a_process_is_suspended_only_where_all_is_there_to_continue_it(
    hung_up: int | None, may_run: bool, has_shell: bool, can: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    sent = list[tuple[int, int]]()
    monkeypatch.setattr(signals, "is_hung_up", lambda number: number == hung_up)
    monkeypatch.setattr(signals, "may_run_programs", lambda: may_run)
    monkeypatch.setattr(signals, "has_shell_above", lambda: has_shell)
    monkeypatch.setattr(signals.os, "kill", lambda *given: sent.append(given))

    signals.suspend()

    assert sent == ([(os.getpid(), signal.SIGSTOP)] if can else [])


def test_a_look_at_the_input_never_waits(monkeypatch: pytest.MonkeyPatch) -> None:
    waited = list[Any]()
    poll = Part(register=lambda *_: None, poll=lambda *given: waited.append(given) or [])
    monkeypatch.setattr(signals.select, "select", lambda *given: waited.append(given[3:]) or ([7], [], []))
    monkeypatch.setattr(signals.select, "poll", lambda: poll)

    assert has_unread(7)
    assert waited == [(0,), (0,)]


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
