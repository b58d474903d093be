"""One open serial port: what pyserial raises, in words of ours.

pyserial is loaded when a port is opened and not before. Everything that it raises for a line that is gone is
an ``OSError``: its own ``SerialException`` is one, and some calls raise the bare one.
"""

from __future__ import annotations

import errno
import logging
from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import serial

BAUD = 115200
WRITE_LIMIT = 0.1
"""Seconds that one write may take. A whole frame takes two thousandths."""
RESET_PULSE = 0.05
"""Seconds that the reset line is held at either level."""
MOST_AT_ONCE = 8192
"""Bytes that one read takes: more than the system keeps."""

_LOG = logging.getLogger(__name__)


class PortProblem(Exception):
    """A port can't be opened. ``code`` names the sentence: ``no-port``, ``port-busy``, ``no-permission``,
    ``port-failed``."""

    def __init__(self, code: str, port: str, reason: str) -> None:
        super().__init__(reason)
        self.code = code
        self.port = port
        self.reason = reason


class OpenPort:
    """A port that is ours alone. ``OSError`` from any method means that it is gone."""

    def __init__(self, url: str) -> None:
        """Open it. Raises PortProblem. Opening resets a board on USB, and so stops it."""
        import serial

        self._timed_out = serial.SerialTimeoutException
        try:
            self._port = _open(url)
        except ValueError as error:
            raise PortProblem("no-port", url, str(error)) from error
        except OSError as error:
            raise PortProblem(_code_of(error), url, str(error)) from error

    def read(self) -> bytes:
        """What has come in; returns at once."""
        data: bytes = self._port.read(MOST_AT_ONCE)
        return data

    def write(self, data: bytes) -> bool:
        """False if there was no room for all of it: a part may have been written."""
        try:
            self._port.write(data)
        except self._timed_out:
            return False
        return True

    def pull_reset(self, pause: Callable[[float], object]) -> None:
        """Let DTR fall and rise: a board on USB restarts, its motors off. Other lines have no such wire."""
        for level in (False, True):
            try:
                self._port.dtr = level
            except (OSError, ValueError, NotImplementedError) as error:
                _LOG.info("no reset line: %s", error)
                return
            pause(RESET_PULSE)

    def close(self) -> None:
        with suppress(OSError):
            self._port.close()


def _open(url: str) -> serial.SerialBase:
    import serial

    return serial.serial_for_url(url, baudrate=BAUD, timeout=0, write_timeout=WRITE_LIMIT, exclusive=True)


def _code_of(error: OSError) -> str:
    if error.errno == errno.ENOENT:
        return "no-port"
    if error.errno == errno.EACCES:
        return "no-permission"
    if error.errno in (errno.EBUSY, errno.EAGAIN):
        return "port-busy"
    return "port-busy" if "exclusively lock" in str(error) else "port-failed"
