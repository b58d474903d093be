"""The full screen to its first frame, measured against importing what it needs of Textual.

Both are started as new processes, in turns; the ratio of the medians is what counts. The target of the
specification is 1.10. Run: ``python benchmarks/startup_screen.py [ROUNDS]``
"""

from __future__ import annotations

import fcntl
import os
import pty
import struct
import subprocess
import sys
import tempfile
import termios
import time
from pathlib import Path
from statistics import median, quantiles

ROOT = Path(__file__).resolve().parents[1]
IMPORTS = "from textual.app import App; from textual.widgets import Input, Static, TextArea"
FIRST_FRAME = b"Screen reader?"
DONNIE = ["-m", "donnie_tui", "--speech", "off", "--sound", "off"]


def seconds_to_import() -> float:
    began = time.perf_counter()
    subprocess.run([sys.executable, "-c", IMPORTS], check=True)
    return time.perf_counter() - began


def seconds_to_first_frame(home: str) -> float:
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
    environment = {**os.environ, "TERM": "xterm-256color", "HOME": home, "LANG": "C.UTF-8"}
    began = time.perf_counter()
    process = subprocess.Popen(
        [sys.executable, *DONNIE], stdin=slave, stdout=slave, stderr=slave, cwd=ROOT, env=environment
    )
    seen = b""
    while FIRST_FRAME not in seen:
        seen += os.read(master, 65536)
    taken = time.perf_counter() - began
    process.kill()
    process.wait()
    os.close(master)
    os.close(slave)
    return taken


def main(rounds: int) -> None:
    with tempfile.TemporaryDirectory() as home:
        seconds_to_import()
        seconds_to_first_frame(home)
        pairs = [(seconds_to_import(), seconds_to_first_frame(home)) for _ in range(rounds)]
    imports, frames = zip(*pairs, strict=True)
    low, _, high = quantiles([frame / base for base, frame in pairs], n=4)
    print(f"importing Textual     {median(imports) * 1000:6.0f} ms")
    print(f"to the first frame    {median(frames) * 1000:6.0f} ms")
    print(
        f"ratio                 {median(frames) / median(imports):6.2f}"
        f"   (quartiles {low:.2f} to {high:.2f}; target 1.10)"
    )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 15)
