"""Lists this machine's serial ports, and finds the same board again after it was plugged in anew.

Rule: what is reopened is the board that was there before, or nothing. Where no ``/dev/serial/by-id`` gives a
stable name, a board is recognised by its serial number, or by its USB socket if it has none. Of two boards
that look alike, neither is taken under a new name.
"""

from __future__ import annotations

import errno
import os
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Generic, Protocol, TypeAlias, TypeVar

from msgspec import Struct

from devices.serial_ports.port import PortFault, PortProblem, is_named

_ARDUINO = 0x2341
_MEGAS = (0x0042, 0x0010)
"""USB product numbers of the boards in the original robot and belt (Arduino Mega 2560, R3 and older)."""

_BY_ID = Path("/dev/serial/by-id")


class SystemPort(Protocol):
    """The part of pyserial's ``ListPortInfo`` that is needed."""

    device: str
    vid: int | None
    pid: int | None
    serial_number: str | None
    location: str | None
    """The USB socket, also through hubs."""


def system_ports() -> Iterable[SystemPort]:
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
    system: Callable[[], Iterable[SystemPort]] = system_ports, by_id: Path = _BY_ID
) -> tuple[FoundPort, ...]:
    """The ports that are plugged in and may be opened: boards first, then by name."""
    names = _stable_names(by_id)
    found = [
        FoundPort(each.device, names.get(os.path.realpath(each.device), each.device), _is_board(each))
        for each in system()
        if is_named(each.device)
    ]
    return tuple(sorted(found, key=lambda port: (not port.is_board, port.device)))


def stable_name(port: str, by_id: Path = _BY_ID) -> str:
    """The name that the port keeps when it is plugged in again; its own name where it has no such."""
    if Path(port).parent == by_id:
        return port
    return _stable_names(by_id).get(os.path.realpath(port), port)


def _is_board(port: SystemPort) -> bool:
    return port.vid == _ARDUINO and port.pid in _MEGAS


def _stable_names(by_id: Path) -> dict[str, str]:
    """The links in that folder, by their targets."""
    try:
        return {os.path.realpath(each): str(each) for each in sorted(by_id.iterdir())}
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
        system: Callable[[], Iterable[SystemPort]] = system_ports,
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


def _identity_of(port: SystemPort) -> _Identity:
    return port.vid, port.pid, port.serial_number, None if port.serial_number else port.location
