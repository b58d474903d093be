"""How long it takes to judge the programs of a thousand pupils by one challenge.

    python benchmarks/challenges.py

Of the first thousand nine of eleven end by themselves: right, a step short, bumping, misspelt, or with a
loop. One is endless, and one turns without end and looks for a colour. Of the second thousand all do that.
No two programs are equal, as equal ones are judged once: in the third thousand all are.
Printed are the seconds of the whole command, and those of the processor. The aim is less than 60 seconds on
two cores. Never fails.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COUNT = 1000
LOOKING = "WHILE COLOR pink == 0 DO\nTR 1\nEND WHILE"
PROGRAMS = (
    "FW 5",
    "FW 4",
    "FW 40",
    "FWW 5",
    "REPEAT 5 TIMES\nFW 1\nEND REPEAT",
    'FW 2\nTR 90\nTL 90\nFW 3\nSPEAK "here"',
    "FW DISTANCE F",
    "SCAN\nFW 5\nTR 360",
    "VAR n = 0\nFOR VAR i = 0; i < 50; i = i + 1 DO\nn = n + i\nEND FOR\nFW 5",
    "VAR n = 0\nWHILE 1 == 1 DO\nn = n + 1\nEND WHILE",
    LOOKING,
)


def main() -> None:
    print("of all kinds:", judged(PROGRAMS))
    print("turning and looking without end:", judged((LOOKING,)))
    print("the same, all equal:", judged((LOOKING,), are_equal=True))


def judged(programs: Sequence[str], *, are_equal: bool = False) -> str:
    with tempfile.TemporaryDirectory() as folder:
        for number in range(COUNT):
            text = programs[number % len(programs)] + ("" if are_equal else f"\nVAR pupil = {number}")
            Path(folder, f"pupil {number:04}.gd").write_text(text)
        command = [sys.executable, "-m", "donnie_tui", "challenge", "check", "first_walk", folder]
        start, before = time.perf_counter(), resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(
            command, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=False, env={**os.environ, "LANG": "C"}
        )
        seconds, now = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    used = now.ru_utime + now.ru_stime - before.ru_utime - before.ru_stime
    return f"{done.stdout.splitlines()[-1]} {seconds:.1f} s, {used:.1f} s of the processor"


if __name__ == "__main__":
    main()
