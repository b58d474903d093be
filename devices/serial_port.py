"""Opens serial ports, for one process at a time, and says what is wrong with one in a word of ours.

Any address that pyserial knows: a device, ``socket://``, ``loop://``, ``spy://``, ``hwgrep://``.
"""

from __future__ import annotations

import errno
import os
import re
import stat
import sys
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import serial

if sys.platform == "win32":
    _TerminalError = OSError
else:
    import termios

    _TerminalError = termios.error

GONE = (OSError, ValueError, TypeError, _TerminalError)
"""What is raised when a device is unplugged, depending on where pyserial notices; its own are ``OSError``,
but what the terminal's settings raise, where there are such, is none."""

_GROUP_MAY_USE = stat.S_IRGRP | stat.S_IWGRP

WRITE_TIMEOUT = 0.2
"""Seconds; a line that takes no bytes for so long is no line."""


class PortFault(Enum):
    """Why a port can't be used, by the codes that a ``RobotProblem`` has for it."""

    ABSENT = "no-port"
    FORBIDDEN = "no-permission"
    """Another group may use it, on Linux usually ``dialout``."""
    BUSY = "port-busy"
    """Another program has it."""
    UNUSABLE = "port-failed"


class PortProblem(Exception):
    """A port can't be opened. ``reason`` is the system's own word for it."""

    def __init__(self, port: str, fault: PortFault, reason: str) -> None:
        super().__init__(f"{port}: {reason}")
        self.port = port
        self.fault = fault
        self.reason = reason


_FAULT_OF = {
    errno.ENOENT: PortFault.ABSENT,
    errno.ENODEV: PortFault.ABSENT,
    errno.ENXIO: PortFault.ABSENT,
    errno.EACCES: PortFault.FORBIDDEN,
    errno.EPERM: PortFault.FORBIDDEN,
    errno.EAGAIN: PortFault.BUSY,
    errno.EBUSY: PortFault.BUSY,
}


def open_port(port: str, baud: int, *, timeout: float = 0.0, exclusive: bool = True) -> serial.SerialBase:
    """The port, open, 8N1. Opening resets a board that hangs on USB. Raises ``PortProblem``.

    ``exclusive``: refuse a port that another process holds.
    """
    import serial

    try:
        if _lacks_its_number(port):
            raise LookupError
        return serial.serial_for_url(
            port, baudrate=baud, timeout=timeout, write_timeout=WRITE_TIMEOUT, exclusive=exclusive or None
        )
    except GONE as problem:
        raise problem_of(port, problem) from None
    except (LookupError, re.error):  # pyserial lets out what its handlers of addresses stumble over
        raise PortProblem(port, PortFault.UNUSABLE, os.strerror(errno.EINVAL)) from None


def _lacks_its_number(port: str) -> bool:
    """Whether it is an address of a network without the number of a port."""
    if not port.startswith(("socket://", "rfc2217://")):
        return False
    from urllib.parse import urlsplit  # slow to load, and few come by a network

    return urlsplit(port).port is None


def problem_of(port: str, problem: Exception) -> PortProblem:
    """What pyserial raised, as a problem of ours."""
    number = _number_of(problem)
    return PortProblem(port, _FAULT_OF.get(number or 0, PortFault.UNUSABLE), reason_of(problem))


def reason_of(problem: Exception) -> str:
    """The system's own word for what was raised."""
    number = _number_of(problem)
    return str(problem) if number is None else os.strerror(number)


def _number_of(problem: Exception) -> int | None:
    """The system's number of it; a terminal's error has it in another place."""
    number = getattr(problem, "errno", None)
    if number is None and isinstance(problem, _TerminalError):
        number = next(iter(problem.args), None)
    return number if isinstance(number, int) else None


def group_of(port: str) -> str | None:
    """The group whose members may use the port, ``dialout`` where that can't be found out.

    None where to join one would not help, or never should be advised: root's own, or one that may not both
    read and write.
    """
    try:
        status = Path(port).stat()
        if status.st_gid == 0 or status.st_mode & _GROUP_MAY_USE != _GROUP_MAY_USE:
            return None
        return Path(port).group()
    except (OSError, KeyError, NotImplementedError, ValueError):
        return "dialout"


def is_same_port(one: str, other: str) -> bool:
    """Whether two addresses are the same device, also by two of its names."""
    return one == other or os.path.realpath(one) == os.path.realpath(other)
