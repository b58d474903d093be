"""Random keys for the full screen on a real terminal, for ``tests.tools.fuzz``."""

from __future__ import annotations

import contextlib
import fcntl
import os
import pkgutil
import pty
import random
import select
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import time
import traceback
from collections.abc import Callable
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Protocol

import donnie_tui
from donnie_tui.__main__ import main as program
from donnie_tui.settings.settings import Settings
from donnie_tui.tui.environment import prepare
from donnie_tui.tui.shutdown import FAULT
from tests.sessions.command import COMMAND, QUIET, environment
from tests.timeouts import TIMEOUT

_IS_THERE, _IS_LOADED = b"Screen reader?", b"READY"
"""Shown once keys are taken, and once they are answered."""
_QUIET_FOR = 0.3
"""Seconds without output after which the screen has answered all that was typed; nothing depends on it."""
_BUSY_FOR = 10.0
"""Seconds after which a screen that paints on and on, as a running program does, is ended too."""
_PIECE = 200
"""Bytes that are typed at once."""

_CTRL_Q = 17
_KEYS = (
    *(f"\x1b[{number}~" for number in (15, 17, 18, 19, 20, 21, 23, 24, 2, 3, 5, 6)),  # F5 to F12, Insert ...
    *(f"\x1bO{letter}" for letter in "PQRS"),  # F1 to F4
    *(f"\x1b[{letter}" for letter in "ABCDHFZ"),
    *(f"\x1b[1;{number}{letter}" for number in (2, 3, 5, 6) for letter in "ABCD"),
    *(chr(number) for number in range(32) if number != _CTRL_Q),
    *(f"\x0b{letter}" for letter in "abcdefghijklmnopqrstuvwxyz0123456789"),  # after Ctrl+K
    *("\t", "\r", "\r", "\r", "\x1b", "\x1b", "\x7f", "y", "n", "1"),
    *("\x1b[<0;10;5M\x1b[<0;10;5m", "\x1b[<64;40;10M", "\x1b[<0;79;24M", "\x1b[<2;1;1M", "\x1b[<35;20;3M"),
    *(
        "\x1b[I",
        "\x1b[O",
        "\x1b[200~FW 1\nTR 90\x1b[201~",
        "\x1b[200~\x1b[2J",
        "\x1b[97;5u",
        "\x1b[?2026;1$y",
    ),
)


def make_keys(chance: random.Random, line: Callable[[random.Random], str], count: int) -> bytes:
    """So many lines and keys, in any order."""
    pieces = []
    for _ in range(count):
        kind = chance.randrange(10)
        typed = (
            f"{line(chance)[:400]}\r"
            if kind < 4
            else "".join(chance.choices(_KEYS, k=chance.randrange(1, 4)))
        )
        pieces.append(typed.encode("utf-8", "replace") if kind < 9 else chance.randbytes(5))
    return b"".join(pieces)


def check_keys(data: str | bytes) -> None:
    """No traceback; it ends by itself or in time after SIGTERM, and leaves the terminal as it was."""
    assert isinstance(data, bytes)
    with tempfile.TemporaryDirectory() as place:
        work = Path(place, "work")
        work.mkdir()
        screen = ForkedScreen(work)
        try:
            screen.type_all(data)
            code = screen.end()
        finally:
            screen.close()
        for fault in work.rglob(FAULT):
            raise AssertionError(fault.read_text(encoding="utf-8"))
    shown = screen.shown[-3000:].decode("utf-8", "replace")
    assert b"Traceback" not in screen.shown, shown
    assert code in (0, 1, 128 + signal.SIGTERM), f"exit code {code}: {shown}"
    assert screen.is_as_before, "the terminal is left as the screen had it"


class Process(Protocol):
    """As much of one of ``subprocess`` as a screen needs."""

    @property
    def returncode(self) -> int: ...
    def poll(self) -> int | None: ...
    def wait(self) -> int: ...
    def kill(self) -> None: ...
    def send_signal(self, number: int, /) -> None: ...


class Screen:
    """The full screen on a terminal, as a job that no shell is above."""

    def __init__(self, folder: Path, *options: str, speed: str = "max") -> None:
        self._terminal, self._line = pty.openpty()
        fcntl.ioctl(self._line, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
        self._before = termios.tcgetattr(self._line)
        self.shown = b""
        arguments = ["--visual", *QUIET, "--speed", speed, "--robot", "sim", *options]
        self._process = self._start(arguments, folder)

    def _start(self, arguments: list[str], folder: Path) -> Process:
        return subprocess.Popen(
            [*COMMAND, *arguments],
            stdin=self._line,
            stdout=self._line,
            stderr=self._line,
            cwd=folder,
            env=environment(folder),
            start_new_session=True,
        )

    def type_all(self, data: bytes) -> None:
        """Some before the session is loaded."""
        self._read_until(lambda: _IS_THERE in self.shown, TIMEOUT)
        at = os.write(self._terminal, data[: len(data) % _PIECE])
        self._read_until(lambda: _IS_LOADED in self.shown or self._process.poll() is not None, TIMEOUT)
        while at < len(data) and self._process.poll() is None:
            os.write(self._terminal, data[at : at + _PIECE])
            at += _PIECE
            self._read_until(self._has_taken_all, TIMEOUT)
        self.read_until_quiet()

    def wait_until_loaded(self) -> None:
        self._read_until(lambda: _IS_LOADED in self.shown, TIMEOUT)

    def press(self, keys: str) -> None:
        """Returns once the screen has read them."""
        os.write(self._terminal, keys.encode())
        self._read_until(self._has_taken_all, TIMEOUT)

    def read_until_quiet(self) -> None:
        began = time.monotonic()
        while self._process.poll() is None and time.monotonic() < began + _BUSY_FOR:
            if not self._read(_QUIET_FOR):
                break

    def kill(self) -> None:
        self._process.kill()
        self._process.wait()

    def end(self) -> int:
        if self._process.poll() is None:
            self._process.send_signal(signal.SIGTERM)
        self._read_until(lambda: self._process.poll() is not None, TIMEOUT)
        while self._read(0.0):
            pass
        return self._process.returncode

    @property
    def has_ended(self) -> bool:
        return self._process.poll() is not None

    @property
    def is_as_before(self) -> bool:
        return self._after == self._before

    def close(self) -> None:
        if self._process.poll() is None:
            self._process.kill()
        self._process.wait()
        self._after = termios.tcgetattr(self._line)
        os.close(self._terminal)
        os.close(self._line)

    def _has_taken_all(self) -> bool:
        waiting = fcntl.ioctl(self._line, termios.FIONREAD, bytes(4))
        return not int.from_bytes(waiting, "little") or self._process.poll() is not None

    def read_while(self, condition: Callable[[], bool]) -> None:
        """Read what is painted."""
        self._read_until(lambda: not condition(), TIMEOUT)

    def _read_until(self, condition: Callable[[], bool], seconds: float) -> None:
        until = time.monotonic() + seconds
        while not condition():
            assert time.monotonic() < until, f"it hangs: {self.shown[-2000:]!r}"
            self._read(0.05)

    def _read(self, seconds: float) -> bool:
        if not select.select([self._terminal], [], [], seconds)[0]:
            return False
        with contextlib.suppress(OSError):
            self.shown += os.read(self._terminal, 1 << 16)
        return True


class ForkedScreen(Screen):
    """In a child of this process, which has loaded all modules: most of a short session is a start."""

    def _start(self, arguments: list[str], folder: Path) -> Process:
        _load_all()
        number = os.fork()
        if not number:
            code = 1
            try:
                code = self._be_the_program(arguments, folder)
            except BaseException:  # noqa: BLE001 -- it must not return to what the parent does
                os.write(2, traceback.format_exc().encode())
            finally:
                os._exit(code)
        return _Child(number)

    def _be_the_program(self, arguments: list[str], folder: Path) -> int:
        os.setsid()
        for each in range(3):
            os.dup2(self._line, each)
        os.closerange(3, max(self._terminal, self._line) + 1)
        os.chdir(folder)
        settings = environment(folder)
        os.environ.clear()
        os.environ.update(settings)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
        sys.stdin, sys.stdout, sys.stderr = (os.fdopen(each, mode) for each, mode in enumerate("rww"))
        sys.__stdin__, sys.__stdout__, sys.__stderr__ = sys.stdin, sys.stdout, sys.stderr
        sys.argv = ["donnie", *arguments]
        code = program()
        sys.stdout.flush()
        sys.stderr.flush()
        return code


class _Child:
    def __init__(self, number: int) -> None:
        self._number = number
        self._code: int | None = None

    @property
    def returncode(self) -> int:
        assert self._code is not None
        return self._code

    def poll(self) -> int | None:
        return self._ended(os.WNOHANG)

    def wait(self) -> int:
        self._ended(0)
        return self.returncode

    def _ended(self, flags: int) -> int | None:
        if self._code is None:
            number, status = os.waitpid(self._number, flags)
            if number:
                self._code = os.waitstatus_to_exitcode(status)
        return self._code

    def kill(self) -> None:
        self.send_signal(signal.SIGKILL)

    def send_signal(self, number: int, /) -> None:
        os.kill(self._number, number)


@cache
def _load_all() -> None:
    prepare(Settings())
    for each in pkgutil.walk_packages(donnie_tui.__path__, "donnie_tui."):
        if not each.name.endswith("__main__"):
            import_module(each.name)
