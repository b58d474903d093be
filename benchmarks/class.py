"""A class types at once on one machine: how soon each key is echoed, and how much memory a session has.

Every session is a process on a terminal of its own, all of them at the same time, and each learner types four
keys a second at moments of their own. Three kinds, one after the other: the smallest program of Python that
echoes keys, which is what the rest is measured against; the linear mode; the full screen. From key to echo is
from the writing of the key to the reading of its letter; this process, which types for all, is part of that.
Memory is each process's share of what it has (PSS), summed up and divided by the sessions; Linux reports it.
The targets are for 60 sessions on two cores, 90 of 100 keys: 5 ms and 15 MB linear, 50 ms and 40 MB full
screen.
Run: ``python benchmarks/class.py [COUNT] [SECONDS]``
"""

from __future__ import annotations

import contextlib
import fcntl
import heapq
import os
import pty
import random
import selectors
import signal
import struct
import sys
import tempfile
import termios
import time
from dataclasses import dataclass, field
from pathlib import Path
from statistics import quantiles

COUNT, SECONDS = 60, 10.0
KEYS_A_SECOND = 4.0
PATIENCE = 300.0
"""Seconds that all sessions may take to start, and the last echoes to come."""
SILENCE = 3.0
"""Seconds without any output, after which what loads after the first prompt is loaded."""
LETTERS = "áéíóúñãõçü"
"""No terminal sequence contains them, so an echo can't be mistaken."""

_PYTHON = sys.executable
_ECHO = "import os, tty\ntty.setraw(0)\nos.write(1, b'> ')\nwhile key := os.read(0, 99): os.write(1, key)"
_QUIET = ("--speech", "off", "--sound", "off", "--world", "living_room")


@dataclass(frozen=True)
class Kind:
    """A kind of session."""

    command: tuple[str, ...]
    is_there: bytes
    """Printed once keys are taken."""
    longest_echo: float = 0.0
    """Milliseconds that are the target; 0 is none."""
    most_memory: float = 0.0
    """MB that are the target."""


KINDS = {
    "smallest echo": Kind((_PYTHON, "-c", _ECHO), b"> "),
    "linear": Kind((_PYTHON, "-m", "donnie_tui", "--linear", *_QUIET), b"> ", 5, 15),
    "full screen": Kind((_PYTHON, "-m", "donnie_tui", "--visual", *_QUIET), b"Screen reader?", 50, 40),
}


@dataclass
class Session:
    """One process, and what was typed there last."""

    pid: int
    terminal: int
    seen: bytes = b""
    letter: bytes = b""
    """Typed, and not echoed yet."""
    typed_at: float = 0.0
    typed: int = 0
    seconds: list[float] = field(default_factory=list)


class Class:
    """From construction to ``close``."""

    def __init__(self, kind: Kind, count: int, folder: Path) -> None:
        self._kind = kind
        self.sessions = [_started(kind.command, folder / str(number)) for number in range(count)]
        self._selector = selectors.DefaultSelector()
        for each in self.sessions:
            self._selector.register(each.terminal, selectors.EVENT_READ, each)

    def wait_until_ready(self) -> None:
        until = time.monotonic() + PATIENCE
        while any(self._kind.is_there not in each.seen for each in self.sessions):
            self._read(until - time.monotonic())
            if time.monotonic() > until:
                sys.exit("not all sessions have started")
        quiet_since = time.monotonic()
        while time.monotonic() < quiet_since + SILENCE and time.monotonic() < until:
            if self._read(SILENCE / 10):
                quiet_since = time.monotonic()

    def type(self, seconds: float) -> None:
        """Everybody, for so long; returns once all is echoed."""
        chance, now = random.Random(1), time.monotonic()
        ends = now + seconds
        due = [(now + chance.random() / KEYS_A_SECOND, number) for number in range(len(self.sessions))]
        heapq.heapify(due)
        while due:
            at, number = due[0]
            if at > time.monotonic():
                self._read(at - time.monotonic())
                continue
            heapq.heappop(due)
            session = self.sessions[number]
            if not session.letter:  # a learner types no other letter before this one appears
                _press(session)
            following = max(at, time.monotonic()) + chance.uniform(0.5, 1.5) / KEYS_A_SECOND
            if following < ends:
                heapq.heappush(due, (following, number))
        until = time.monotonic() + PATIENCE
        while any(each.letter for each in self.sessions) and time.monotonic() < until:
            self._read(1.0)

    def memory(self) -> float | None:
        """MB a session; None if the system doesn't report it."""
        shares = [_share(each.pid) for each in self.sessions]
        known = [each for each in shares if each is not None]
        return sum(known) / len(known) / 1e6 if len(known) == len(shares) else None

    def close(self) -> None:
        self._selector.close()
        for each in self.sessions:
            os.kill(each.pid, signal.SIGKILL)
            os.waitpid(each.pid, 0)
            os.close(each.terminal)

    def _read(self, seconds: float) -> bool:
        """What comes within so long. Whether anything came."""
        ready = self._selector.select(max(0.0, seconds))
        for key, _ in ready:
            session: Session = key.data
            try:
                data = os.read(session.terminal, 65536)
            except OSError:
                sys.exit(f"a session has ended: {session.seen[-500:]!r}")
            session.seen = (session.seen + data)[-65536:]
            if session.letter and session.letter in session.seen:
                session.seconds.append(time.perf_counter() - session.typed_at)
                session.letter, session.seen = b"", b""
        return bool(ready)


def _started(command: tuple[str, ...], folder: Path) -> Session:
    folder.mkdir()
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)  # an installed program isn't compiled at each start
    own = {"XDG_STATE_HOME": str(folder), "XDG_CONFIG_HOME": str(folder), "HOME": str(folder)}
    more = {"TERM": "xterm-256color", "LANG": "C.UTF-8", "DONNIE_TOUR": "off", "DONNIE_READER": "off"}
    pid, terminal = pty.fork()
    if pid == 0:
        os.execve(command[0], command, {**os.environ, **own, **more})
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
    return Session(pid, terminal)


def _press(session: Session) -> None:
    letter = LETTERS[session.typed % len(LETTERS)].encode()
    session.typed += 1
    session.letter, session.seen, session.typed_at = letter, b"", time.perf_counter()
    os.write(session.terminal, letter)


def _share(pid: int) -> float | None:
    """Bytes."""
    with contextlib.suppress(OSError):
        for line in Path(f"/proc/{pid}/smaps_rollup").read_text().splitlines():
            if line.startswith("Pss:"):
                return float(line.split()[1]) * 1024
    return None


def measured(kind: Kind, count: int, seconds: float) -> tuple[list[float], int, float | None]:
    """Milliseconds of each echo; how many never came; and MB a session."""
    with tempfile.TemporaryDirectory() as folder:
        everybody = Class(kind, count, Path(folder))
        try:
            everybody.wait_until_ready()
            everybody.type(seconds)
            memory = everybody.memory()
        finally:
            everybody.close()
    lost = sum(bool(each.letter) for each in everybody.sessions)
    return [1000 * one for each in everybody.sessions for one in each.seconds], lost, memory


def main(count: int, seconds: float) -> None:
    print(f"{count} sessions, {os.cpu_count()} cores, {seconds:.0f} seconds of typing each")
    smallest = 0.0
    for name, kind in KINDS.items():
        echoes, lost, memory = measured(kind, count, seconds)
        if len(echoes) < 2:
            sys.exit(f"{name}: too few keys were echoed")
        parts = quantiles(echoes, n=10)
        smallest = smallest or parts[-1]
        target = f", target <= {kind.longest_echo:.0f}" if kind.longest_echo else ""
        print(
            f"{name}: {len(echoes)} keys; key to echo {parts[4]:.1f} ms median, "
            f"{parts[-1]:.1f} for 90 of 100{target}; {parts[-1] / smallest:.1f} times the smallest echo"
        )
        if lost:
            print(f"{name}: {lost} keys were never echoed")
        if memory is not None:
            target = f", target <= {kind.most_memory:.0f}" if kind.most_memory else ""
            print(f"{name}: {memory:.1f} MB a session{target}")


if __name__ == "__main__":
    main(
        int(sys.argv[1]) if len(sys.argv) > 1 else COUNT,
        float(sys.argv[2]) if len(sys.argv) > 2 else SECONDS,
    )
