"""Opens serial ports, each for one process at a time, and classifies what can be wrong with one.

An address is a device, or ``socket://HOST:PORT`` or ``rfc2217://HOST:PORT``. Of pyserial's others, ``spy://``
writes a file. A process may be limited to the ports that a teacher named.
"""

from __future__ import annotations

import errno
import os
import re
import stat
import sys
from contextlib import suppress
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING

from devices.ports.robot import NETWORK_SCHEMES

if TYPE_CHECKING:
    from collections.abc import Iterable

if sys.platform == "win32":
    _TerminalError = OSError
else:
    import termios

    _TerminalError = termios.error

GONE = (OSError, ValueError, TypeError, _TerminalError)
"""What a call on an unplugged device raises; which one depends on where pyserial notices it. Errors of
pyserial are ``OSError``; errors of the terminal settings are not."""

WRITE_TIMEOUT = 0.2
"""Seconds; a device that takes no bytes for so long counts as gone."""

MOST_AT_ONCE = 8192
"""Bytes that one read returns at most: more than the system buffers."""

_GROUP_MAY_USE = stat.S_IRGRP | stat.S_IWGRP


class PortFault(Enum):
    """Why a port can't be used. The values are codes of ``RobotProblem``."""

    ABSENT = "no-port"
    FORBIDDEN = "no-permission"
    """Only members of a group may use it, on Linux usually ``dialout``."""
    BUSY = "port-busy"
    """Another program has it open."""
    UNUSABLE = "port-failed"
    NOT_NAMED = "port-not-named"
    """The session is limited to other ports."""


class PortProblem(Exception):
    """A port can't be opened or used. ``reason`` is the operating system's own text."""

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


OTHER_SCHEMES: tuple[str, ...] = ()
"""More kinds of addresses: a test may need one."""

_named: tuple[str, ...] | None = None


def allow_only(ports: Iterable[str] | None) -> None:
    """From now on this process opens no other ports; None: any."""
    global _named
    _named = None if ports is None else tuple(ports)


def named_ports() -> tuple[str, ...]:
    """The ports to which this process is limited; none also where it is not limited."""
    return _named or ()


def is_named(address: str) -> bool:
    """Whether this process may open it."""
    return _named is None or _name_of(address) is not None


def _name_of(address: str) -> str | None:
    """The name that was given to this port; the port itself where any may be opened."""
    if _named is None:
        return address
    return next((each for each in _named if is_same_port(each, address)), None)


class SerialPort:
    """An open serial port, 8N1. Every method but ``close`` raises one of ``GONE`` once the device is gone."""

    def __init__(self, address: str, baud: int, *, timeout: float = 0.0, exclusive: bool = True) -> None:
        """Open it. Raises ``PortProblem``. Opening restarts a board on USB.

        ``timeout``: seconds that ``read`` waits for bytes. ``exclusive``: refuse a port that another process
        holds.
        """
        named = _name_of(address)
        if named is None:
            raise PortProblem(address, PortFault.NOT_NAMED, os.strerror(errno.EACCES))
        import serial

        try:
            if not _is_usable(address):
                raise LookupError
            self._port = serial.serial_for_url(
                named,
                baudrate=baud,
                timeout=timeout,
                write_timeout=WRITE_TIMEOUT,
                exclusive=exclusive or None,
            )
        except GONE as error:
            raise _problem(address, error) from None
        except (LookupError, re.error):  # pyserial's own address handlers let these through
            raise PortProblem(address, PortFault.UNUSABLE, os.strerror(errno.EINVAL)) from None

    def read(self) -> bytes:
        """The bytes that have arrived, after at most ``timeout`` seconds."""
        data: bytes = self._port.read(MOST_AT_ONCE)
        return data

    def write(self, data: bytes) -> None:
        """Write all of it. A write that times out raises, too: half a frame may have been taken, and only
        reopening the port ends that reliably."""
        self._port.write(data)

    @property
    def unsent(self) -> int:
        """Bytes that were written and still wait in the system; 0 where that is unknown."""
        waiting: int = getattr(self._port, "out_waiting", 0)
        return waiting

    def set_baud(self, baud: int) -> None:
        self._port.baudrate = baud

    def set_dtr(self, level: bool) -> None:
        """Raises ``NotImplementedError`` or ``AttributeError`` where the port has no such wire."""
        self._port.dtr = level

    def close(self) -> None:
        with suppress(*GONE):
            self._port.close()


def _is_usable(address: str) -> bool:
    """Whether it is a device, or an address of the network with a port number."""
    scheme, is_address, _ = address.partition("://")
    if not is_address:
        return True
    from urllib.parse import urlsplit  # slow to load, and few robots are on a network

    if scheme.lower() not in NETWORK_SCHEMES:
        return scheme.lower() in OTHER_SCHEMES
    return urlsplit(address).port is not None


def _problem(address: str, error: Exception) -> PortProblem:
    number = _error_number(error)
    return PortProblem(address, _FAULT_OF.get(number or 0, PortFault.UNUSABLE), reason_of(error))


def reason_of(error: Exception) -> str:
    """The operating system's text for an error."""
    number = _error_number(error)
    return str(error) if number is None else os.strerror(number)


def _error_number(error: Exception) -> int | None:
    """The operating system's number; a terminal error has it in another place.

    pyserial makes an error without a number of some: it is in the one before.
    """
    number = getattr(error, "errno", None)
    if number is None and isinstance(error, _TerminalError):
        number = next(iter(error.args), None)
    before = error.__context__
    if number is None and isinstance(error, OSError) and isinstance(before, OSError | _TerminalError):
        return _error_number(before)
    return number if isinstance(number, int) else None


def group_of(port: str) -> str | None:
    """The group whose members may use the port; ``dialout`` where that can't be found out.

    None where joining the group would not help or is never advisable: root's own group, or one that may not
    both read and write.
    """
    try:
        status = Path(port).stat()
        if status.st_gid == 0 or status.st_mode & _GROUP_MAY_USE != _GROUP_MAY_USE:
            return None
        return Path(port).group()
    except (OSError, KeyError, NotImplementedError, ValueError):
        return "dialout"


def is_same_port(one: str, other: str) -> bool:
    """Whether two addresses are the same device, also under two of its names."""
    return one == other or os.path.realpath(one) == os.path.realpath(other)
