"""Hears that nothing arrives any more at the machine from which somebody came by SSH.

A cable that is pulled, or a Wi-Fi that is left, closes nothing: the kernel sends what is not acknowledged
again and again, for a quarter of an hour, and meanwhile a robot would drive out of anybody's reach. Linux
counts these attempts for everybody to read, in ``/proc/net/tcp``. Rule: where nothing is sent, there is
nothing to count; that is left to the keep-alive of sshd.
"""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

TABLES = (Path("/proc/net/tcp"), Path("/proc/net/tcp6"))
LOOK = 1.0
"""Seconds between two looks."""
MANY = 4
"""Attempts without an answer; after some four seconds on a fast network, some six on a slow one."""

_LOCAL, _REMOTE, _ATTEMPTS = 1, 2, 6
"""Columns of the tables."""
_MAPPED = "0000000000000000" + ("FFFF0000" if sys.byteorder == "little" else "0000FFFF")
"""What stands before an address of version 4 in the table of version 6."""


class NetworkWatch:
    """From its making to ``close``.

    Does nothing where nobody came by SSH, or in a tmux or screen, which go on without the network.
    """

    def __init__(self, on_lost: Callable[[], object], environment: Mapping[str, str]) -> None:
        """``on_lost`` is called in a thread of its own, again and again while nothing arrives."""
        self._on_lost = on_lost
        self._ended = threading.Event()
        self._thread: threading.Thread | None = None
        self._ends = () if environment.get("TMUX") or environment.get("STY") else ends_of(environment)
        if self._ends and any(each.exists() for each in TABLES):
            self._thread = threading.Thread(target=self._watch, name="network", daemon=True)
            self._thread.start()

    @property
    def is_looking(self) -> bool:
        return self._thread is not None

    def close(self) -> None:
        self._ended.set()
        if self._thread is not None:
            self._thread.join()

    def _watch(self) -> None:
        while not self._ended.wait(LOOK):
            if attempts(_rows(), self._ends) >= MANY:
                self._on_lost()


def ends_of(environment: Mapping[str, str]) -> tuple[tuple[str, str], ...]:
    """Our end and the other one of the SSH connection, as the tables of both versions write them."""
    words = environment.get("SSH_CONNECTION", "").split()
    try:
        there, there_port, here, here_port = words
        ours, theirs = _written(here, here_port), _written(there, there_port)
        return tuple(zip(ours, theirs, strict=True))
    except (ValueError, OSError):  # nobody came by SSH, or by no network
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
            with table.open(encoding="ascii") as rows:
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
    """In words of 32 bits, each as a number of this machine."""
    words = (address[start : start + 4] for start in range(0, len(address), 4))
    return "".join(f"{int.from_bytes(each, sys.byteorder):08X}" for each in words)
