"""One board's port under whatever name it has now, where no ``/dev/serial/by-id`` keeps a name for it.

Rule: what is opened again is the board that was there before, or nothing. One without a serial number is
known by its socket; of two that can't be told apart none is taken under a new name.
"""

from __future__ import annotations

import errno
import os
from collections.abc import Callable, Iterable
from typing import Generic, TypeAlias, TypeVar

from devices.port_listing import SystemPort, system_ports
from devices.serial_port import PortFault, PortProblem

Opened = TypeVar("Opened")

Mark: TypeAlias = tuple[int | None, int | None, str | None, str | None]
"""Vendor, product, and serial number or else socket."""


class SameBoard(Generic[Opened]):
    """Opens a port, and from the second time on the port at which the same board is then."""

    def __init__(
        self,
        open_port: Callable[[str], Opened],
        system: Callable[[], Iterable[SystemPort]] = system_ports,
    ) -> None:
        self._open_port = open_port
        self._system = system
        self._mark: Mark | None = None

    def __call__(self, port: str) -> Opened:
        """Raises ``PortProblem``, as for a port that is absent where another board has its name now."""
        if self._mark is not None:
            return self._open_port(self._name_now(port, self._mark))
        opened = self._open_port(port)
        self._mark = self._marks().get(os.path.realpath(port))
        return opened

    def _name_now(self, port: str, mark: Mark) -> str:
        marks = self._marks()
        same = [device for device, its_mark in marks.items() if its_mark == mark]
        if len(same) == 1:
            return same[0]
        if marks.get(os.path.realpath(port), mark) != mark:
            raise PortProblem(port, PortFault.ABSENT, os.strerror(errno.ENOENT))
        return port

    def _marks(self) -> dict[str, Mark]:
        """Of what hangs on USB, by the device."""
        try:
            found = tuple(self._system())
        except OSError:
            return {}
        return {os.path.realpath(each.device): _mark_of(each) for each in found if each.vid is not None}


def _mark_of(port: SystemPort) -> Mark:
    return port.vid, port.pid, port.serial_number, None if port.serial_number else port.location
