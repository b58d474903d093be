"""Hears that the terminal was closed, also where it was started by one that forgets to close its own end.

YASR gives what it starts the other end of their terminal. As long as anybody holds that, nobody is told that
the terminal is gone, and a robot would go on behind a window that was closed. So our copy is closed; the
shell between has one too, which is why the end of whoever holds the terminal is waited for besides.
"""

from __future__ import annotations

import os
import sys

_PTMX = os.makedev(5, 2)
_TIOCGPTN = 0x80045430
"""Of Linux: the number of the terminal at the other end."""


def hear_hang_up() -> None:
    """Costs a look at the open files where all is well."""
    if sys.platform != "linux":
        return
    ours = _own_terminal()
    masters = [] if ours is None else masters_of(ours)
    for number in masters:
        os.close(number)
    if masters and (keeper := keeper_of(os.getpid())) is not None:
        _end_with(keeper)


def masters_of(terminal: str) -> list[int]:
    """The open files that are the other end of ``terminal``, such as ``/dev/pts/3``."""
    try:
        numbers = sorted(map(int, os.listdir("/proc/self/fd")))  # noqa: PTH208 -- pathlib is slow to load
    except OSError:  # a system without that folder
        return []
    return [each for each in numbers if _other_end(each) == terminal]


def _own_terminal() -> str | None:
    try:
        return os.ttyname(0)
    except OSError:
        return None


def _other_end(number: int) -> str | None:
    from fcntl import ioctl

    try:
        if os.fstat(number).st_rdev != _PTMX:
            return None
        found = ioctl(number, _TIOCGPTN, b"\0\0\0\0")
    except OSError:
        return None
    return f"/dev/pts/{int.from_bytes(found, sys.byteorder)}"


def keeper_of(pid: int) -> int | None:
    """The nearest process above that is on another terminal: it has the other end of ours.

    None where there is none, or one on the way may not be looked at.
    """
    try:
        _, ours = _parent_and_terminal(pid)
        terminal = ours
        while pid > 1 and terminal == ours:
            pid, _ = _parent_and_terminal(pid)
            _, terminal = _parent_and_terminal(pid) if pid > 1 else (0, "")
    except OSError:
        return None
    return pid if pid > 1 else None


def _parent_and_terminal(pid: int) -> tuple[int, str]:
    with open(f"/proc/{pid}/stat") as file:  # noqa: PTH123 -- as above
        fields = file.read().rpartition(")")[2].split()
    return int(fields[1]), fields[4]


def _end_with(keeper: int) -> None:
    import select
    import signal
    import threading

    def wait() -> None:
        try:
            select.select([os.pidfd_open(keeper)], [], [])
        except OSError:  # it ended just now; or this system can't tell
            if os.path.exists(f"/proc/{keeper}"):  # noqa: PTH110 -- as above
                return
        os.kill(os.getpid(), signal.SIGHUP)

    threading.Thread(target=wait, name="hang-up", daemon=True).start()
