"""The full screen to its first frame, measured against importing what it needs of Textual.

All are started as new processes, in turns; the ratio of the medians is what counts. The target of the
specification is 1.10. What the smallest program of Textual's takes to its first frame, one line of text, is
measured too: nothing can be faster. Then the most memory that the full screen had with the
living room, once its map was there; at most 90 MB are wanted.
Run: ``python benchmarks/startup_screen.py [ROUNDS]``
"""

from __future__ import annotations

import fcntl
import os
import pty
import select
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
DONNIE = ["-m", "donnie_tui", "--visual", "--speech", "off", "--sound", "off", "--world", "living_room"]
SMALLEST = f"""{IMPORTS}

class Smallest(App):
    def compose(self):
        yield Static({FIRST_FRAME.decode()!r})

Smallest().run()
"""
SECONDS_OF_SILENCE = 2.0
"""Nothing more is painted: what is loaded after the first frame is loaded."""


def seconds_to_import() -> float:
    began = time.perf_counter()
    subprocess.run([sys.executable, "-c", IMPORTS], check=True)
    return time.perf_counter() - began


def to_first_frame(home: str, command: list[str], *, and_on: bool = False) -> tuple[float, int]:
    """Seconds until the first frame of what Python is given; the most bytes that the process had.

    ``and_on``: until it is quiet.
    """
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
    environment = {
        **os.environ,
        "TERM": "xterm-256color",
        "HOME": home,
        "LANG": "C.UTF-8",
        "DONNIE_TOUR": "off",
    }
    began = time.perf_counter()
    process = subprocess.Popen(
        [sys.executable, *command], stdin=slave, stdout=slave, stderr=slave, cwd=ROOT, env=environment
    )
    seen = b""
    while FIRST_FRAME not in seen:
        seen += os.read(master, 65536)
    taken = time.perf_counter() - began
    while and_on and select.select([master], [], [], SECONDS_OF_SILENCE)[0]:
        os.read(master, 65536)
    process.kill()
    _, _, used = os.wait4(process.pid, 0)
    os.close(master)
    os.close(slave)
    return taken, used.ru_maxrss * (1 if sys.platform == "darwin" else 1024)


def main(rounds: int) -> None:
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)  # an installed program isn't compiled at each start
    with tempfile.TemporaryDirectory() as home:
        seconds_to_import()
        to_first_frame(home, DONNIE)
        taken = [
            (
                seconds_to_import(),
                to_first_frame(home, ["-c", SMALLEST])[0],
                to_first_frame(home, DONNIE)[0],
            )
            for _ in range(rounds)
        ]
        _, memory = to_first_frame(home, DONNIE, and_on=True)
    imports, smallest, frames = zip(*taken, strict=True)
    low, _, high = quantiles([frame / base for base, _, frame in taken], n=4)
    print(f"importing Textual       {median(imports) * 1000:6.0f} ms")
    print(f"its smallest program    {median(smallest) * 1000:6.0f} ms")
    print(f"to the first frame      {median(frames) * 1000:6.0f} ms")
    print(
        f"ratio                   {median(frames) / median(imports):6.2f}"
        f"   (quartiles {low:.2f} to {high:.2f}; target 1.10)"
    )
    print(f"of the smallest program {median(smallest) / median(imports):6.2f}")
    print(f"memory at most          {memory / 1e6:6.1f} MB   (target 90)")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 15)
