"""How long it takes to judge the programs of a thousand pupils by one challenge.

    python benchmarks/challenges.py

Nine of eleven end by themselves: right, a step short, bumping, misspelt, or with a loop. One is endless, and
one turns without end and looks for a colour. Printed are the seconds of the whole command, and those of the
processor. The aim is less than 60 seconds on two cores. Never fails.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COUNT = 1000
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
    "WHILE COLOR pink == 0 DO\nTR 1\nEND WHILE",
)


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        for number in range(COUNT):
            Path(folder, f"pupil {number:04}.gd").write_text(PROGRAMS[number % len(PROGRAMS)])
        command = [sys.executable, "-m", "donnie_tui", "challenge", "check", "first_walk", folder]
        start = time.perf_counter()
        done = subprocess.run(
            command, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=False, env={**os.environ, "LANG": "C"}
        )
        seconds = time.perf_counter() - start
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(done.stdout.splitlines()[-1])
    print(
        f"judged {COUNT} programs in {seconds:.1f} s, {used.ru_utime + used.ru_stime:.1f} s of the processor"
    )


if __name__ == "__main__":
    main()
