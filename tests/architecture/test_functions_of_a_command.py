"""``FW 3`` at the prompt runs through few functions, so that a reader can follow it."""

import json
import os
import sys
from pathlib import Path

import pexpect

from tests.timeouts import TIMEOUT

ROOT = Path(__file__).parents[2]
MOST = 450
"""Distinct functions and methods from Enter to "I walked 3 steps forward."; comprehensions don't count.

Those of the main and the program's thread, which a reader follows.
"""

PROFILED = """
# The number must not depend on how busy the machine is: the program runs to its end while the main thread
# waits, and no time passes meanwhile, so that nothing is reported of a walk that takes long.
import json, os, select, sys, threading, time

root, report = sys.argv[1:3]
packages = tuple(f"{root}/{each}/" for each in ("donnie_tui", "language", "devices", "sim", "worlds"))
called, is_on, is_idle, main_waits = set(), False, False, threading.Event()

def program():
    return next((each for each in threading.enumerate() if each.name.startswith("program")), None)

def profile(frame, event, argument):
    code = frame.f_code
    thread = threading.current_thread()
    if not is_on or thread not in (threading.main_thread(), program()):
        return
    if event == "call" and code.co_filename.startswith(packages) and code.co_name[0] != "<":
        if thread is not threading.main_thread():
            main_waits.wait()
        called.add(f"{code.co_filename[len(root) + 1:]} {code.co_qualname}")

def waited(*arguments):
    # All that is loaded while the learner does not type is there now.
    global is_idle
    if arguments[3] is None and not is_idle:
        is_idle = True
        os.write(1, b"(idle)")
    if is_on and threading.current_thread() is threading.main_thread() and (running := program()):
        main_waits.set()
        running.join()
    return select_before(*arguments)

def read(file, size):
    global is_on
    data = read_before(file, size)
    if b"FW 3" in data:
        is_on, now = True, time.monotonic()
        time.monotonic = lambda: now
    return data

def write(file, data):
    global is_on
    if is_on and b"3 steps forward" in bytes(data):
        is_on = False
        with open(report, "w") as out:
            json.dump(sorted(called), out)
    return write_before(file, data)

select_before, select.select = select.select, waited
read_before, os.read, write_before, os.write = os.read, read, os.write, write
threading.setprofile(profile)
sys.setprofile(profile)
sys.argv = ["donnie", "--linear", "--speech", "off", "--sound", "off", "--lang", "en"]
from donnie_tui.__main__ import main
main()
"""


def test_a_walk_typed_at_the_prompt_runs_through_few_functions(tmp_path: Path) -> None:
    report = tmp_path / "called"
    environment = {**os.environ, "HOME": str(tmp_path), "XDG_STATE_HOME": str(tmp_path), "TERM": "xterm"}
    child = pexpect.spawn(
        sys.executable,
        ["-c", PROFILED, str(ROOT), str(report)],
        env=environment,  # type: ignore[arg-type] # pexpect's stubs want os._Environ
        cwd=str(ROOT),
        timeout=TIMEOUT,
    )
    child.expect_exact("(idle)")
    child.send("FW 3\x1b")
    child.expect_exact("3 steps forward")
    child.sendcontrol("d")
    child.expect(pexpect.EOF)
    child.close()

    called = json.loads(report.read_text())
    print(len(called), *called, sep="\n")
    assert len(called) <= MOST
