"""Serial ports: opens one for one process at a time, says what is wrong with one, and lists this machine's.

An address is a device, or ``socket://HOST:PORT`` or ``rfc2217://HOST:PORT``. Of pyserial's others, ``spy://``
writes a file. A process may be limited to the ports that a teacher named.

Rule: what is reopened is the board that was there before, or nothing. Where no ``/dev/serial/by-id`` gives a
stable name, a board is recognised by its serial number, or by its USB socket if it has none. Of two boards
that look alike, neither is taken under a new name.

``Notifier`` reports what happens to the device at a port, to its listener and in the background, one notice
after the other. Rule: the device never waits for its listener. A listener that hangs, for example on a
terminal that takes no output, holds up only the notices that follow."""

from __future__ import annotations

import errno
import os
import re
import select
import stat
import sys
import threading
from collections import deque
from collections.abc import Callable, Iterable
from contextlib import suppress
from enum import Enum
from typing import TYPE_CHECKING, Generic, ParamSpec, TypeAlias, TypeVar

from msgspec import Struct

from devices.ports.robot import NETWORK_SCHEMES

if TYPE_CHECKING:
    import logging
    from collections.abc import Iterable
    from pathlib import Path

    from serial.tools.list_ports_common import ListPortInfo


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
    NO_PORT = "not-a-port"
    """It is no address of a port."""
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
    return _name_of(address) is not None


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

        self._is_address = "://" in named
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
            raise PortProblem(address, PortFault.NO_PORT, os.strerror(errno.EINVAL)) from None

    def read(self) -> bytes:
        """The bytes that have arrived, after at most ``timeout`` seconds."""
        data: bytes = self._port.read(MOST_AT_ONCE)
        return data

    def write(self, data: bytes) -> None:
        """Write all of it. A write that times out raises, too: half a frame may have been taken, and only
        reopening the port ends that reliably.

        pyserial's own ``write`` also counts the time in which this thread waited for its turn.
        """
        if self._is_address or sys.platform == "win32":
            self._port.write(data)
            return
        port = self._port.fileno()
        while data:
            with suppress(BlockingIOError):
                data = data[os.write(port, data) :]
            if data and not select.select((), (port,), (), WRITE_TIMEOUT)[1]:
                raise TimeoutError("Write timeout")

    @property
    def unsent(self) -> int:
        """Bytes that were written and still wait in the system; 0 if that is unknown."""
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


def pause(seconds: float) -> None:
    """Wait so long; nothing shortens it, as a reset pulse needs its full length."""
    threading.Event().wait(seconds)


def _is_usable(address: str) -> bool:
    """Whether it is a device, or an address of the network with a port number.

    The option ``logging`` of pyserial prints on the learner's terminal.
    """
    scheme, is_address, _ = address.partition("://")
    if not is_address:
        return True
    from urllib.parse import urlsplit  # slow to load, and few robots are on a network

    if scheme.lower() not in NETWORK_SCHEMES:
        return scheme.lower() in OTHER_SCHEMES
    parts = urlsplit(address)
    return parts.port is not None and "logging" not in parts.query.lower()


def _problem(address: str, error: Exception) -> PortProblem:
    number = _error_number(error)
    return PortProblem(address, _FAULT_OF.get(number or 0, PortFault.UNUSABLE), reason_of(error))


def reason_of(error: Exception) -> str:
    """The operating system's text for an error, without what a library adds to it."""
    from socket import gaierror  # slow to load, and few robots are on a network

    for each in (error, error.__context__):
        if isinstance(each, gaierror):  # its numbers are others
            return each.strerror or str(each)
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
    from pathlib import Path

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


_ARDUINO = 0x2341
_MEGAS = (0x0042, 0x0010)
"""USB product numbers of the boards in the original robot and belt (Arduino Mega 2560, R3 and older)."""

_BY_ID = "/dev/serial/by-id"


def system_ports() -> Iterable[ListPortInfo]:
    """What pyserial finds, with or without udev."""
    from serial.tools.list_ports import comports

    return comports()


class FoundPort(Struct, frozen=True):
    """A serial port that is plugged in."""

    device: str
    """Such as ``/dev/ttyACM0``; another port may have that name tomorrow."""
    stable: str
    """Its name by make and serial number; the device where it has none."""
    is_board: bool
    """Whether it is an Arduino Mega, as in the robot and the belt."""


def list_ports(
    system: Callable[[], Iterable[ListPortInfo]] = system_ports, by_id: str | Path = _BY_ID
) -> tuple[FoundPort, ...]:
    """The ports that are plugged in and may be opened: boards first, then by name."""
    names = _stable_names(by_id)
    found = [
        FoundPort(each.device, names.get(os.path.realpath(each.device), each.device), _is_board(each))
        for each in system()
        if is_named(each.device)
    ]
    return tuple(sorted(found, key=lambda port: (not port.is_board, port.device)))


def stable_name(port: str, by_id: str | Path = _BY_ID) -> str:
    """The name that the port keeps when it is plugged in again; its own name where it has no such."""
    from pathlib import Path  # slow to load, and few sessions have a port

    if Path(port).parent == Path(by_id):
        return port
    return _stable_names(by_id).get(os.path.realpath(port), port)


def _is_board(port: ListPortInfo) -> bool:
    return port.vid == _ARDUINO and port.pid in _MEGAS


def _stable_names(by_id: str | Path) -> dict[str, str]:
    """The links in that folder, by their targets."""
    from pathlib import Path

    try:
        return {os.path.realpath(each): str(each) for each in sorted(Path(by_id).iterdir())}
    except OSError:
        return {}


OpenedPort = TypeVar("OpenedPort")

_Identity: TypeAlias = tuple[int | None, int | None, str | None, str | None]
"""Vendor, product, and either the serial number or the socket."""


class SameBoard(Generic[OpenedPort]):
    """Opens a port; from the second time on, the port at which the same board is then."""

    def __init__(
        self,
        open_port: Callable[[str], OpenedPort],
        system: Callable[[], Iterable[ListPortInfo]] = system_ports,
    ) -> None:
        self._open_port = open_port
        self._system = system
        self._identity: _Identity | None = None

    def __call__(self, port: str) -> OpenedPort:
        """Raises ``PortProblem``; where another board has the name now, as for an absent port."""
        if self._identity is not None:
            return self._open_port(self._current_name(port, self._identity))
        opened = self._open_port(port)
        self._identity = self._identities().get(os.path.realpath(port))
        return opened

    def _current_name(self, port: str, identity: _Identity) -> str:
        identities = self._identities()
        same = [device for device, other in identities.items() if other == identity]
        if len(same) == 1:
            return same[0]
        if identities.get(os.path.realpath(port), identity) != identity:
            raise PortProblem(port, PortFault.ABSENT, os.strerror(errno.ENOENT))
        return port

    def _identities(self) -> dict[str, _Identity]:
        """Of the USB devices, by their paths."""
        try:
            found = tuple(self._system())
        except OSError:
            return {}
        return {os.path.realpath(each.device): _identity_of(each) for each in found if each.vid is not None}


def _identity_of(port: ListPortInfo) -> _Identity:
    return port.vid, port.pid, port.serial_number, None if port.serial_number else port.location


MOST_PENDING = 256
"""Notices that wait for a listener that hangs; later ones are dropped and logged."""
DELIVERY_TIMEOUT = 0.5
"""Seconds that a caller of ``wait`` waits by default."""


def _log() -> logging.Logger:
    import logging  # few sessions have something to log

    return logging.getLogger(__name__)


_P = ParamSpec("_P")


class Notifier(Generic[_P]):
    """The notices of one device. Any thread may send some. Its own thread lives while notices are pending."""

    def __init__(self, name: str, listener: Callable[_P, None] | None) -> None:
        """``listener`` is called with the arguments of ``notify``; what it raises is logged."""
        self._name = name
        self._listener = listener
        self._pending: deque[Callable[[], None]] = deque()
        self._changed = threading.Condition(threading.RLock())
        self._thread: threading.Thread | None = None

    def notify(self, *values: _P.args, **named: _P.kwargs) -> None:
        """Queue a notice and return at once."""
        listener = self._listener
        if listener is None:
            return
        with self._changed:
            if len(self._pending) >= MOST_PENDING:
                _log().warning("%s: its listener hangs; dropped: %s", self._name, values)
                return
            self._pending.append(lambda: listener(*values, **named))
            if self._thread is None:
                self._thread = threading.Thread(target=self._deliver, name=f"news {self._name}", daemon=True)
                self._thread.start()

    def wait(self, seconds: float = DELIVERY_TIMEOUT) -> None:
        """Wait until all notices are delivered, or that long. Called by the listener, it returns at once."""
        if self._thread is threading.current_thread():
            return
        with self._changed:
            self._changed.wait_for(lambda: self._thread is None, seconds)

    def _deliver(self) -> None:
        while True:
            with self._changed:
                if not self._pending:
                    self._thread = None
                    self._changed.notify_all()
                    return
                deliver_next = self._pending.popleft()
            try:
                deliver_next()
            except Exception:  # noqa: BLE001 -- the listener gets the following notices all the same
                _log().exception("a listener failed")
