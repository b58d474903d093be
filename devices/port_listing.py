"""The serial ports of this machine, and under which name each stays the same when it is plugged in again."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Protocol

from devices.ports.values import Frozen

_ARDUINO = 0x2341
_MEGAS = (0x0042, 0x0010)
"""What the boards of the original robot and belt tell the USB (Arduino Mega 2560, R3 and before)."""

_BY_ID = Path("/dev/serial/by-id")


class SystemPort(Protocol):
    """As much as is needed of what pyserial finds."""

    device: str
    vid: int | None
    pid: int | None
    serial_number: str | None
    location: str | None
    """The socket, also through hubs."""


def system_ports() -> Iterable[SystemPort]:
    """What pyserial finds, with or without udev."""
    from serial.tools.list_ports import comports

    return comports()


class FoundPort(Frozen):
    """A serial port that is plugged in."""

    device: str
    """Such as ``/dev/ttyACM0``; another one may have that name tomorrow."""
    stable: str
    """Its name by its make and serial number; the device where it has none."""
    is_board: bool
    """Whether it is an Arduino Mega, as robot and belt have."""


def list_ports(
    system: Callable[[], Iterable[SystemPort]] = system_ports, by_id: Path = _BY_ID
) -> tuple[FoundPort, ...]:
    """What is plugged in: boards first, then by name."""
    names = _stable_names(by_id)
    found = [
        FoundPort(each.device, names.get(os.path.realpath(each.device), each.device), _is_board(each))
        for each in system()
    ]
    return tuple(sorted(found, key=lambda port: (not port.is_board, port.device)))


def stable_name(port: str, by_id: Path = _BY_ID) -> str:
    """The name under which that port is found again when it is plugged in anew; its own where it has none."""
    if Path(port).parent == by_id:
        return port
    return _stable_names(by_id).get(os.path.realpath(port), port)


def _is_board(port: SystemPort) -> bool:
    return port.vid == _ARDUINO and port.pid in _MEGAS


def _stable_names(by_id: Path) -> dict[str, str]:
    """The links there, by what they lead to."""
    try:
        return {os.path.realpath(each): str(each) for each in sorted(by_id.iterdir())}
    except OSError:
        return {}
