"""Work in copies of this process: in order, one that dies, Ctrl+C, and the end of the first process.

Each test begins a process, because a copy must have one thread only.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

from tests.conftest import ROOT
from tests.timeouts import TIMEOUT

START = """\
import json, os, signal
from donnie_tui.process import in_processes
"""
TOGETHER = """\
def work(number):
    if number in (3, 4):
        os.kill(os.getpid(), signal.SIGKILL)
    return number * number
print(json.dumps([*in_processes(work, range(8), 2, "died")]))
"""
ONE_OF_MANY = """\
from pathlib import Path
import time
def mark(name):
    Path(name).touch(exist_ok=False)
def is_marked(name):
    return Path(name).exists()
def until_marked(name):
    while not is_marked(name):
        time.sleep(0.001)
def work(number):
    if number == 0 and not is_marked("begun"):
        mark("begun")
        signal.pause()
    if number == 1 and not is_marked("died twice"):
        until_marked("begun")
        mark("died twice" if is_marked("died") else "died")
        os.kill(os.getpid(), signal.SIGKILL)
    if number in (2, 3):
        Path(str(number)).touch()
        until_marked(str(5 - number))
    return number
print(json.dumps([*in_processes(work, range(4), 2, "died")]))
"""
"""A 0 that waits while 1 dies; 1 dies again later, and not when it is alone; 2 and 3 need each other."""
WITHOUT_END = """\
def work(number):
    print(os.getpid(), flush=True)
    signal.pause()
[*in_processes(work, range(2), 2, None)]
"""

INTERRUPTED = """\
def work(number):
    os.kill(os.getpid(), signal.SIGINT)
    return number
print(json.dumps([*in_processes(work, range(4), 2, "died")]))
"""
INTERRUPTED_TOGETHER = """\
reading, writing = os.pipe()
def work(number):
    print("began", flush=True)
    os.read(reading, 1)
    return number
try:
    [*in_processes(work, range(2), 2, None)]
except KeyboardInterrupt:
    print("ended")
"""
"""Ctrl+C reaches all of them while both copies work; a byte for each lets it end its work."""


def begun(script: str, folder: Path | None = None) -> subprocess.Popen[str]:
    command = [sys.executable, "-c", START + script]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    return subprocess.Popen(command, stdout=subprocess.PIPE, text=True, cwd=folder, env=environment)


def test_outcomes_are_in_order_and_only_what_ends_its_process_lacks_one() -> None:
    out, _ = begun(TOGETHER).communicate()

    assert json.loads(out) == [0, 1, 4, "died", "died", 25, 36, 49]


def test_only_the_first_without_an_outcome_is_alone_after_an_end(tmp_path: Path) -> None:
    out, _ = begun(ONE_OF_MANY, tmp_path).communicate(timeout=TIMEOUT)

    assert json.loads(out) == [0, 1, 2, 3]


def test_copies_end_with_the_process_that_began_them() -> None:
    process = begun(WITHOUT_END)
    assert process.stdout is not None
    copies = [int(process.stdout.readline()) for _ in range(2)]

    process.kill()

    assert process.stdout.read() == ""  # the copies have it open until they end
    assert not any(Path(f"/proc/{each}/cwd").exists() for each in copies)
    process.communicate()


def test_a_copy_ignores_ctrl_c_and_does_its_work() -> None:
    out, _ = begun(INTERRUPTED).communicate()

    assert json.loads(out) == [0, 1, 2, 3]


def test_ctrl_c_ends_the_first_process_when_its_copies_have_done_what_they_began() -> None:
    reading, writing = os.pipe()
    script = INTERRUPTED_TOGETHER.replace("os.pipe()", f"{reading}, {writing}")
    process = subprocess.Popen(
        [sys.executable, "-c", START + script],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        pass_fds=(reading, writing),
        start_new_session=True,
    )
    assert process.stdout is not None
    assert [process.stdout.readline() for _ in range(2)] == ["began\n"] * 2

    os.killpg(process.pid, signal.SIGINT)
    os.write(writing, b"12")

    assert process.communicate() == ("ended\n", "")
    for each in (reading, writing):
        os.close(each)
    assert process.returncode == 0
