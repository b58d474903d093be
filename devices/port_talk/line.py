"""Holds a talk on an open port. Time comes from the line, so that a test's line has its own."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic
from typing import Protocol

from devices.serial_port import GONE, PortFault, PortProblem, open_port, reason_of

GLANCE = 0.02
"""Seconds that one read waits for bytes."""

_MOST_AT_ONCE = 4096


class Talk(Protocol):
    """One conversation. ``now`` is in seconds and never goes back."""

    def next(self, received: bytes, now: float) -> bytes:
        """What to say to this, often nothing."""

    def is_over(self, now: float) -> bool: ...


class Line(Protocol):
    """An open port."""

    def read(self) -> bytes:
        """What has come, after a short wait for it. ``OSError`` if the port is gone."""

    def write(self, data: bytes) -> None: ...

    def now(self) -> float: ...

    def set_speed(self, baud: int) -> None: ...

    def close(self) -> None: ...


class PortLine:
    """A real port."""

    def __init__(self, port: str, baud: int, *, exclusive: bool = True) -> None:
        """Raises ``PortProblem``."""
        self._port = open_port(port, baud, timeout=GLANCE, exclusive=exclusive)

    def read(self) -> bytes:
        data: bytes = self._port.read(_MOST_AT_ONCE)
        return data

    def write(self, data: bytes) -> None:
        self._port.write(data)

    def now(self) -> float:
        return monotonic()

    def set_speed(self, baud: int) -> None:
        self._port.baudrate = baud

    def close(self) -> None:
        self._port.close()


@contextmanager
def telling_what_is_gone(port: str) -> Iterator[None]:
    """A port that goes away in here is a ``PortProblem``."""
    try:
        yield
    except GONE as problem:
        raise PortProblem(port, PortFault.ABSENT, reason_of(problem)) from None


def hold(line: Line, talk: Talk, port: str, is_given_up: Callable[[], bool] = lambda: False) -> None:
    """Until it is over, or given up. Raises ``PortProblem`` if the port goes away meanwhile."""
    received = b""
    with telling_what_is_gone(port):
        while not (talk.is_over(line.now()) or is_given_up()):
            said = talk.next(received, line.now())
            if said:
                line.write(said)
            received = line.read()
