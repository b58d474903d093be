"""Runs a program without end for many hours of robot time. ``python -m tests.tools.soak --mode linear``.

Not part of the check. A real session, whose program runs at unlimited speed, writes its events to a pipe,
which says how much robot time has passed. At each simulated hour the process's memory, threads and
open files are printed. All of them must be at the end what they were after half of the time; memory may
differ by as much as ``MOST_GROWTH``. Linux only (``/proc``).

``--before 40`` runs the program for 40 hours before the first one that counts. By then all that is bounded
is full: the log of the full screen, which keeps the most lines, after 36 hours of the lesson.
"""

from __future__ import annotations

import argparse
import fcntl
import os
import pty
import re
import struct
import subprocess
import tempfile
import termios
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from io import BufferedReader
from pathlib import Path

from tests.sessions.command import COMMAND, QUIET, environment

HOUR = 3600.0
MOST_GROWTH = 2.0
"""MB between the half and the end."""
MOST_MEMORY = 200.0
"""MB, at any time."""

PROGRAMS = {
    "turning": "WHILE 1 == 1 DO TR 1 END WHILE",
    "lesson": """VAR n = 0
PROCEDURE side: steps DO
FW steps TR 90
END PROCEDURE
WHILE 1 == 1 DO
n = n + 1
REPEAT 4 TIMES side [2] END REPEAT
FOR VAR i = 0; i < 3; i = i + 1 DO BW 1 FW 1 END FOR
SCAN
STATE
SPEAK "turn"
SPEAK n
SPEAK DISTANCE F
SPEAK POS X
IF DISTANCE F > 9 THEN FW 1 BW 1 ELSE TL 90 TR 90 END IF
WAIT 5
END WHILE
""",
}
TIME = re.compile(rb'"t":([0-9.]+)')


@dataclass(frozen=True)
class Sample:
    """What a process has at one moment."""

    hours: float
    memory: float
    threads: int
    files: int

    def __str__(self) -> str:
        return f"{self.hours:5.1f} h: {self.memory:.2f} MB, {self.threads} threads, {self.files} open files"


def sample(pid: int, hours: float) -> Sample:
    status = Path(f"/proc/{pid}/status").read_text(encoding="ascii")
    found = dict(re.findall(r"^(VmRSS|Threads):\s+(\d+)", status, re.MULTILINE))
    files = sum(1 for _ in Path(f"/proc/{pid}/fd").iterdir())
    return Sample(hours, int(found["VmRSS"]) / 1024, int(found["Threads"]), files)


def soaked(
    mode: str, program: str, hours: float, interval: float = 1.0, before: float = 0.0
) -> Iterator[Sample]:
    """A sample at each interval of robot time, in hours, until so many have passed after those ``before``."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        (folder / "a.gd").write_text(program, encoding="utf-8")
        process, events, close = _STARTS[mode](folder, ("--speed", "max", *QUIET))
        due = interval
        try:
            while due <= hours + 1e-9:
                data = events.read1(1 << 16)
                if not data:
                    raise AssertionError(f"the program ended after {before + due - interval:.1f} hours")
                if (times := TIME.findall(data)) and float(times[-1]) >= (before + due) * HOUR:
                    yield sample(process.pid, due)
                    due += interval
        finally:
            process.kill()
            process.wait()
            close()


Started = tuple["subprocess.Popen[bytes]", BufferedReader, Callable[[], None]]
"""The session, its events, and what ends them."""


def _run(folder: Path, options: tuple[str, ...]) -> Started:
    """``donnie run``, which waits until its events are read."""
    process = subprocess.Popen(
        [*COMMAND, "run", "a.gd", *options, "--events", "-"],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        cwd=folder,
        env=environment(folder),
    )
    assert isinstance(process.stdout, BufferedReader)
    return process, process.stdout, process.stdout.close


def _linear(folder: Path, options: tuple[str, ...]) -> Started:
    """Lines through a pipe, as a screen reader's add-on or a teacher's script has them."""
    process = subprocess.Popen(
        [*COMMAND, "--linear", *options, "--events", _pipe(folder)],
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        cwd=folder,
        env=environment(folder),
    )
    assert process.stdin is not None
    process.stdin.write(b"OPEN a\nRUN\n")
    process.stdin.flush()
    events = (folder / _EVENTS).open("rb")
    return process, events, events.close


def _visual(folder: Path, options: tuple[str, ...]) -> Started:
    """A terminal, where F5 is pressed once the screen is there."""
    terminal, line = pty.openpty()
    fcntl.ioctl(line, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
    process = subprocess.Popen(
        [*COMMAND, "--visual", *options, "--events", _pipe(folder), "a.gd"],
        stdin=line,
        stdout=line,
        stderr=line,
        cwd=folder,
        env=environment(folder),
        start_new_session=True,
    )
    os.close(line)
    threading.Thread(target=_press_once_and_read, args=(terminal,), daemon=True).start()
    events = (folder / _EVENTS).open("rb")
    return process, events, events.close


def _pipe(folder: Path) -> str:
    """A session gives up a named pipe that no one reads for long: this tool must not be starved."""
    os.mkfifo(folder / _EVENTS)
    return str(folder / _EVENTS)


_EVENTS = "events"


def _press_once_and_read(terminal: int) -> None:
    seen, is_pressed = b"", False
    try:
        while data := os.read(terminal, 1 << 16):
            if not is_pressed and b"Screen reader?" in (seen := seen + data):
                os.write(terminal, b"\x1b[15~")  # F5
                is_pressed = True
    except OSError:  # the session is gone
        os.close(terminal)


_STARTS = {"run": _run, "linear": _linear, "visual": _visual}


def growth(samples: list[Sample]) -> list[str]:
    """What is not as it was after half of the time."""
    first, last = samples[(len(samples) - 1) // 2], samples[-1]
    found = []
    if last.memory > first.memory + MOST_GROWTH:
        found.append(f"memory grew by {last.memory - first.memory:.2f} MB")
    if max(each.memory for each in samples) > MOST_MEMORY:
        found.append(f"more than {MOST_MEMORY:.0f} MB")
    if last.threads > first.threads:
        found.append(f"{last.threads - first.threads} threads more")
    if last.files > first.files:
        found.append(f"{last.files - first.files} open files more")
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--mode", choices=sorted(_STARTS), default="linear")
    parser.add_argument("--program", choices=sorted(PROGRAMS), default="turning")
    parser.add_argument("--hours", type=float, default=24.0, help="of robot time")
    parser.add_argument("--interval", type=float, default=1.0, metavar="HOURS", help="between two samples")
    parser.add_argument("--before", type=float, default=0.0, metavar="HOURS", help="that do not count")
    options = parser.parse_args()
    samples, program = [], PROGRAMS[options.program]
    for each in soaked(options.mode, program, options.hours, options.interval, options.before):
        print(each, flush=True)
        samples.append(each)
    found = growth(samples)
    print(f"{options.mode}, {options.program}: {', '.join(found) or 'nothing grew'}", flush=True)
    return 1 if found else 0


if __name__ == "__main__":
    raise SystemExit(main())
