"""Runs a program on a terminal of its own and shows its screen to BRLTTY, as GNU Screen with its patch does.

BRLTTY's "sc" driver reads a piece of shared memory: columns, rows, cursor, then a byte a character and a
byte an attribute. Arguments: the folder whose name is the memory's key, then the program's.
"""

from __future__ import annotations

import contextlib
import ctypes
import fcntl
import os
import pty
import select
import signal
import struct
import sys
import termios
import tty
from pathlib import Path

import pyte

ROWS, COLUMNS = 24, 80
_IPC_CREAT, _IPC_RMID = 0o1000, 0
_SIZE = 4 + 66 * 132 * 2
_PLAIN = b"\x07"

_LIBC = ctypes.CDLL(None, use_errno=True)
_LIBC.shmat.restype = ctypes.c_void_p
_LIBC.shmat.argtypes = (ctypes.c_int, ctypes.c_void_p, ctypes.c_int)


def key_of(folder: str) -> int:
    """The key that ``ftok(folder, 'b')`` gives."""
    found = Path(folder).stat()
    return ctypes.c_int((ord("b") << 24) | ((found.st_dev & 0xFF) << 16) | (found.st_ino & 0xFFFF)).value


def main() -> None:
    folder, command = sys.argv[1], sys.argv[2:]
    memory = _LIBC.shmget(key_of(folder), _SIZE, _IPC_CREAT | 0o700)
    if memory < 0:
        raise SystemExit(os.strerror(ctypes.get_errno()))
    place = _LIBC.shmat(memory, None, 0)
    screen = pyte.Screen(COLUMNS, ROWS)
    publish(screen, place)
    child, terminal = pty.fork()
    if child == 0:
        os.execvp(command[0], command)
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", ROWS, COLUMNS, 0, 0))
    tty.setraw(0)
    Path(folder, "ready").touch()
    try:
        pass_on(terminal, screen, place)
    finally:
        _LIBC.shmctl(memory, _IPC_RMID, None)
        with contextlib.suppress(OSError):
            os.kill(child, signal.SIGHUP)


def pass_on(terminal: int, screen: pyte.Screen, place: int) -> None:
    """Passes keys to the program, and its output to the terminal and to the shared screen."""
    stream = pyte.ByteStream(screen)
    with contextlib.suppress(OSError):
        while True:
            ready, _, _ = select.select([0, terminal], [], [])
            for source, target in ((0, terminal), (terminal, 1)):
                if source in ready:
                    data = os.read(source, 65_536)
                    if not data:
                        return
                    os.write(target, data)
                    if source == terminal:
                        stream.feed(data)
                        publish(screen, place)


def publish(screen: pyte.Screen, place: int) -> None:
    text = "".join(screen.display).encode("latin-1", "replace")
    head = bytes([COLUMNS, ROWS, min(screen.cursor.x, COLUMNS - 1), min(screen.cursor.y, ROWS - 1)])
    data = head + text + _PLAIN * len(text) + b"\0\0"
    ctypes.memmove(place, data, len(data))


if __name__ == "__main__":
    main()
