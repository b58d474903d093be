"""The real program on a real terminal (a pty), read by a terminal emulator."""

import fcntl
import os
import pty
import re
import select
import struct
import subprocess
import sys
import termios
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import pyte

from tests.timeouts import TIMEOUT

ROOT = Path(__file__).resolve().parents[2]


_KITTY = re.compile(rb"\x1b\[[<>=][0-9;]*u")
"""Keyboard protocols that the emulator takes for text."""


BACKSPACE, F5, F8, F12, CTRL_Q, CTRL_S, CTRL_Z, CTRL_SPACE, TAB, SHIFT_TAB, ENTER = (
    "\x7f",
    "\x1b[15~",
    "\x1b[19~",
    "\x1b[24~",
    "\x11",
    "\x13",
    "\x1a",
    "\0",
    "\t",
    "\x1b[Z",
    "\r",
)


class Terminal:
    """A program on a pty, and what its screen shows."""

    def __init__(
        self,
        arguments: list[str],
        state: Path,
        columns: int = 80,
        rows: int = 24,
        more: dict[str, str] | None = None,
        controls: bool = False,
        is_job: bool = False,
        has_size: bool = True,
    ) -> None:
        """``has_size``: whether it says its size, as a serial one doesn't.

        ``controls``: the line belongs to the program's session, which notices its loss.

        ``is_job``: this process is the shell above, to which Ctrl+Z leads back.
        """
        self.screen = pyte.Screen(columns, rows)
        self._stream = pyte.ByteStream(self.screen)
        self.raw = b""
        self._master, slave = pty.openpty()
        fcntl.ioctl(
            self._master, termios.TIOCSWINSZ, struct.pack("HHHH", rows * has_size, columns * has_size, 0, 0)
        )
        self.attributes = termios.tcgetattr(slave)
        self._slave = slave
        self._open = [slave, self._master]
        environment = os.environ | {"HOME": str(state), "DONNIE_TOUR": "off"} | (more or {})
        self.process = subprocess.Popen(
            [sys.executable, "-m", "donnie_tui", *arguments, "--speech", "off", "--sound", "off"],
            stdin=slave,
            stdout=slave,
            stderr=slave,
            cwd=ROOT,
            env=environment,
            start_new_session=not is_job,
            process_group=0 if is_job else None,
            preexec_fn=(lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0)) if controls else None,
        )

    def type(self, text: str) -> None:
        self.types_bytes(text.encode())

    def types_bytes(self, data: bytes) -> None:
        os.write(self._master, data)

    def read(self, seconds: float) -> bytes:
        """What comes within that time at most, given to the emulator too."""
        ready, _, _ = select.select([self._master], [], [], seconds)
        if not ready:
            return b""
        with suppress(OSError):
            data = os.read(self._master, 65536)
            self.raw += data
            self._stream.feed(_KITTY.sub(b"", data))
            return data
        return b""

    def until(self, condition: Callable[[], object], what: str) -> None:
        end = time.monotonic() + TIMEOUT
        while not condition():
            assert time.monotonic() < end, f"never seen: {what}\n" + "\n".join(self.screen.display)
            self.read(0.2)

    def shows(self, text: str) -> None:
        self.until(lambda: text in "\n".join(self.screen.display), text)

    def ended(self) -> int:
        """Its exit code; what it still writes is read, so that it is not held up."""
        self.until(lambda: self.process.poll() is not None, "the end")
        while self.read(0.05):
            pass
        return self.process.returncode

    def attributes_now(self) -> list:
        return termios.tcgetattr(self._slave)

    def close(self) -> None:
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.hang_up()

    def hang_up(self) -> None:
        """The connection is lost: the output is not read any more, and no key arrives."""
        while self._open:
            os.close(self._open.pop())


def left_as_found(terminal: Terminal) -> bool:
    """The modes that were switched on were switched off again, and the line discipline is as before."""
    switched = {}
    for mode, switch in re.findall(rb"\x1b\[\?(\d+)([hl])", terminal.raw):
        switched[mode] = switch
    on = {mode for mode, switch in switched.items() if switch == b"h"} - {b"25", b"7"}
    has_keys = terminal.raw.count(b"\x1b[>25u") > terminal.raw.count(b"\x1b[<u")
    return (
        not on
        and not has_keys
        and switched.get(b"25") == b"h"
        and terminal.attributes_now() == terminal.attributes
    )


def falls_silent(donnie: Terminal, seconds: float) -> bool:
    """Wait until nothing was written for so long. False if the program keeps writing."""
    end = time.monotonic() + TIMEOUT
    while donnie.read(seconds):
        if time.monotonic() > end:
            return False
    return True


def under_the_cursor(donnie: Terminal) -> tuple[str, str]:
    """What stands before the cursor in its row, and at it."""
    row = donnie.screen.display[donnie.screen.cursor.y]
    return row[: donnie.screen.cursor.x], row[donnie.screen.cursor.x]
