"""Work in copies of this process: in order, one that dies, and the end of the one that began them.

Each test begins a process, because a copy must have one thread only.
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

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
WITHOUT_END = """\
def work(number):
    print(os.getpid(), flush=True)
    signal.pause()
[*in_processes(work, range(2), 2, None)]
"""


def begun(script: str) -> subprocess.Popen[str]:
    command = [sys.executable, "-c", START + script]
    return subprocess.Popen(command, stdout=subprocess.PIPE, text=True)


def test_outcomes_are_in_order_and_only_what_ends_its_process_lacks_one() -> None:
    out, _ = begun(TOGETHER).communicate()

    assert json.loads(out) == [0, 1, 4, "died", "died", 25, 36, 49]


def test_copies_end_with_the_process_that_began_them() -> None:
    process = begun(WITHOUT_END)
    assert process.stdout is not None
    copies = [int(process.stdout.readline()) for _ in range(2)]

    process.kill()

    assert process.stdout.read() == ""  # the copies have it open until they end
    assert not any(Path(f"/proc/{each}/cwd").exists() for each in copies)
    process.communicate()
