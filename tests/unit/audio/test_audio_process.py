"""The audio worker ends with its parent, writes to no terminal, and is always the installed one."""

from __future__ import annotations

import ctypes
import errno
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from devices.audio.process import die_with_parent
from tests.conftest import ROOT
from tests.timeouts import TIMEOUT
from tests.unit.audio.test_audio_worker import audio, eventually, group_of, warm

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="looks into /proc")


PARENT = """
import sys
from devices.audio.service import AudioService, AudioSettings
audio = AudioService(AudioSettings(device={device!r}), lambda notice: None)
audio.warm_up()
audio.wait_until_ready({timeout})
{then}
"""


PRINT_AND_WAIT = "print(audio.worker_pid, flush=True); sys.stdin.read()"


@contextmanager
def parent_process(then: str) -> Iterator[tuple[subprocess.Popen[bytes], int]]:
    """Another Python that has a worker, and that worker's process id."""
    command = (sys.executable, "-c", PARENT.format(device="null", timeout=TIMEOUT, then=then))
    with subprocess.Popen(command, cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as parent:
        assert parent.stdout is not None
        try:
            yield parent, int(parent.stdout.readline())
        finally:
            parent.kill()


@pytest.mark.parametrize("freeze", [False, True], ids=["busy", "frozen"])
def test_a_worker_dies_with_a_parent_that_is_killed(freeze: bool) -> None:
    with parent_process(PRINT_AND_WAIT) as (parent, pid):
        if freeze:
            os.kill(pid, signal.SIGSTOP)
        assert group_of(pid)
        parent.kill()
        parent.wait()

        assert eventually(lambda: not group_of(pid))


def test_a_parent_that_ends_without_closing_leaves_nothing() -> None:
    with parent_process("print(audio.worker_pid, flush=True)") as (parent, pid):
        assert parent.wait(TIMEOUT) == 0

        assert eventually(lambda: not group_of(pid))


def output_on_a_terminal(code: str) -> bytes:
    """All bytes that a Python with ``code`` and what it starts write to their terminal."""
    ours, theirs = os.openpty()
    command = (sys.executable, "-c", code)
    with subprocess.Popen(
        command, cwd=ROOT, stdin=theirs, stdout=theirs, stderr=theirs, start_new_session=True
    ):
        os.close(theirs)
        output = b"".join(iter(lambda: read_terminal(ours), b""))
    os.close(ours)
    return output


def read_terminal(descriptor: int) -> bytes:
    try:
        return os.read(descriptor, 4096)
    except OSError as reason:
        if reason.errno == errno.EIO:  # the other end was closed
            return b""
        raise


@pytest.mark.parametrize("device", ["auto", "null"])
def test_not_one_byte_reaches_the_terminal(device: str) -> None:
    say_and_close = """
from devices.ports.audio import Cue, Urgency, Utterance
audio.set_cue_volumes({"bump": 0.0001})
audio.play(Cue("bump"))
audio.say(Utterance("", Urgency.PROGRAM, "en"))
audio.wait_until_quiet(5)
audio.close()
"""

    assert output_on_a_terminal(PARENT.format(device=device, timeout=TIMEOUT, then=say_and_close)) == b""


def test_a_folder_called_devices_in_the_working_directory_is_not_imported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    package = tmp_path / "devices" / "audio"
    package.mkdir(parents=True)
    for file in (package.parent / "__init__.py", package / "__init__.py", package / "worker.py"):
        file.write_text("raise SystemExit(1)\n")
    monkeypatch.chdir(tmp_path)
    with audio() as (service, notices):
        warm(service)

        assert notices == []


def test_messages_of_the_libraries_go_to_the_log(tmp_path: Path) -> None:
    log = tmp_path / "audio.log"
    with audio(log=log) as (service, _):
        warm(service)

        assert log.exists()


def test_the_system_kills_a_process_that_wants_to_die_with_its_parent() -> None:
    wish = ctypes.c_int(0)
    prctl = ctypes.CDLL(None).prctl
    try:
        die_with_parent()
        prctl(2, ctypes.byref(wish))  # PR_GET_PDEATHSIG
    finally:
        prctl(1, 0, 0, 0, 0)  # PR_SET_PDEATHSIG: no longer

    assert wish.value == signal.SIGKILL
