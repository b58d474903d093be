"""Detects that the learner is gone: a closed terminal, a lost network, a closed pipe.

Each of them acts like SIGHUP.

Terminal: YASR gives its child the other end of their terminal. While any process has that end open, the
kernel sends no hang-up, and a robot would drive on behind a closed window. So our copy is closed; the shell
in between has one too, so the end of the process that owns the terminal is watched as well.

Network: a pulled cable or a lost Wi-Fi closes nothing. For a quarter of an hour the kernel repeats what is
not acknowledged. Linux counts the repetitions in ``/proc/net/tcp``, where any user may read them. Where
nothing is sent, nothing is counted; that case is left to the keep-alive of sshd.

Pipe: ``ssh robot donnie run`` has no terminal. If the connection is lost, no signal arrives; only the next
printed line would fail, and a robot may walk for minutes without one.
"""

from __future__ import annotations

import os
import select
import signal
import sys
import threading
from collections.abc import Callable, Iterable, Mapping
from stat import S_ISFIFO, S_ISSOCK

_PTMX = os.makedev(5, 2)
_TIOCGPTN = 0x80045430
"""Of Linux: the number of the terminal at the other end."""


def watch_for_hang_up() -> None:
    """Watch for the end of the terminal's owner. Costs little if all is well."""
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
    """The nearest ancestor on another terminal: it has the other end of this one.

    None if there is none, or an ancestor may not be inspected.
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


def parent_of(pid: int) -> int:
    """Raises ``OSError``."""
    return _parent_and_terminal(pid)[0]


def _parent_and_terminal(pid: int) -> tuple[int, str]:
    with open(f"/proc/{pid}/stat") as file:  # noqa: PTH123 -- as above
        fields = file.read().rpartition(")")[2].split()
    return int(fields[1]), fields[4]


def _end_with(keeper: int) -> None:
    def wait() -> None:
        try:
            select.select([os.pidfd_open(keeper)], [], [])
        except OSError:  # it ended just now, or this system can't say
            if os.path.exists(f"/proc/{keeper}"):  # noqa: PTH110 -- as above
                return
        is_ignored = signal.getsignal(signal.SIGHUP) is signal.SIG_IGN  # as by nohup, until Donnie begins
        os.kill(os.getpid(), signal.SIGTERM if is_ignored else signal.SIGHUP)

    threading.Thread(target=wait, name="hang-up", daemon=True).start()


TABLES = ("/proc/net/tcp", "/proc/net/tcp6")
LOOK = 1.0
"""Seconds between two checks."""
MANY = 4
"""Attempts without an answer; after some four seconds on a fast network, some six on a slow one."""

_LOCAL, _REMOTE, _ATTEMPTS = 1, 2, 6
"""Columns of the tables."""
_MAPPED = "0000000000000000" + ("FFFF0000" if sys.byteorder == "little" else "0000FFFF")
"""The prefix of an address of version 4 in the table of version 6."""


class NetworkWatch:
    """Watches from construction to ``close``.

    Does nothing without SSH, or in tmux or screen, which survive the loss of the network.
    """

    def __init__(self, on_lost: Callable[[], object], environment: Mapping[str, str]) -> None:
        """``on_lost`` is called in a thread of its own, again and again while nothing arrives."""
        self._on_lost = on_lost
        self._ended = threading.Event()
        self._thread: threading.Thread | None = None
        self._connections = (
            () if environment.get("TMUX") or environment.get("STY") else ssh_connections_of(environment)
        )
        if self._connections and any(map(os.path.exists, TABLES)):
            self._thread = threading.Thread(target=self._watch, name="network", daemon=True)
            self._thread.start()

    def close(self) -> None:
        self._ended.set()
        if self._thread is not None:
            self._thread.join()

    def _watch(self) -> None:
        while not self._ended.wait(LOOK):
            if attempts(_rows(), self._connections) >= MANY:
                self._on_lost()


def ssh_connections_of(environment: Mapping[str, str]) -> tuple[tuple[str, str], ...]:
    """Both ends of the SSH connection, as the tables of both versions of the protocol write them."""
    words = environment.get("SSH_CONNECTION", "").split()
    try:
        there, there_port, here, here_port = words
        ours, theirs = _written(here, here_port), _written(there, there_port)
        return tuple(zip(ours, theirs, strict=True))
    except (ValueError, OSError):  # no SSH, or no network
        return ()


def attempts(rows: Iterable[str], ends: tuple[tuple[str, str], ...]) -> int:
    """How often what was sent last was sent again without an answer."""
    for row in rows:
        columns = row.split()
        if len(columns) > _ATTEMPTS and (columns[_LOCAL], columns[_REMOTE]) in ends:
            return int(columns[_ATTEMPTS], 16)
    return 0


def _rows() -> Iterable[str]:
    for table in TABLES:
        try:
            with open(table, encoding="ascii") as rows:  # noqa: PTH123 -- as above
                yield from rows
        except OSError:  # a kernel without that version
            continue


def _written(address: str, port: str) -> tuple[str, ...]:
    import socket

    number = f"{int(port):04X}"
    if ":" not in address:
        packed = _words(socket.inet_pton(socket.AF_INET, address))
        return f"{packed}:{number}", f"{_MAPPED}{packed}:{number}"
    return (f"{_words(socket.inet_pton(socket.AF_INET6, address.partition('%')[0]))}:{number}",)


def _words(address: bytes) -> str:
    """The bytes as words of 32 bits, each as a number of this machine."""
    words = (address[start : start + 4] for start in range(0, len(address), 4))
    return "".join(f"{int.from_bytes(each, sys.byteorder):08X}" for each in words)


_OUTPUTS = (1, 2)


class ReaderWatch:
    """Watches until ``close`` whether the output has a reader. SIGHUP must be handled before it is made.

    Costs nothing at a terminal."""

    def __init__(self) -> None:
        self._thread: threading.Thread | None = None
        outputs = [each for each in _OUTPUTS if _has_reader(each)]
        if outputs and hasattr(select, "poll"):
            self._reading, self._writing = os.pipe()
            self._thread = threading.Thread(target=self._watch, args=(outputs,), name="readers", daemon=True)
            self._thread.start()

    def close(self) -> None:
        """End the watch; no signal comes any more."""
        if self._thread is not None:
            os.close(self._writing)
            self._thread.join()
            os.close(self._reading)
            self._thread = None

    def _watch(self, outputs: list[int]) -> None:
        poll = select.poll()
        for number in (self._reading, *outputs):
            poll.register(number, 0)  # a closed end is always reported
        ready = {number for number, _ in poll.poll()}
        if self._reading not in ready:
            os.kill(os.getpid(), signal.SIGHUP)


def _has_reader(number: int) -> bool:
    """Whether it is a pipe or a socket."""
    try:
        mode = os.fstat(number).st_mode
    except OSError:
        return False
    return S_ISFIFO(mode) or S_ISSOCK(mode)
