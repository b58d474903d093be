"""One open serial port with a robot's board: read without waiting, written whole, reset by its wire.

What a line that is gone raises is one of ``GONE``.
"""

from __future__ import annotations

import logging
from collections.abc import Callable
from contextlib import suppress

from devices.serial_port import GONE, open_port

BAUD = 115200
RESET_PULSE = 0.05
"""Seconds that the reset line is held at either level."""
MOST_AT_ONCE = 8192
"""Bytes that one read takes: more than the system keeps."""

_LOG = logging.getLogger(__name__)


class OpenPort:
    """A port that is ours alone. One of ``GONE`` from any method means that it is."""

    def __init__(self, url: str) -> None:
        """Open it. Raises ``PortProblem``. Opening resets a board on USB, and so stops it."""
        self._port = open_port(url, BAUD)

    def read(self) -> bytes:
        """What has come in; returns at once."""
        data: bytes = self._port.read(MOST_AT_ONCE)
        return data

    def write(self, data: bytes) -> None:
        """All of it. A port that takes no few bytes in a fifth of a second is gone as well: what it took of
        them may be half a frame, and only a new beginning ends that surely."""
        self._port.write(data)

    def pull_reset(self, pause: Callable[[float], object]) -> None:
        """Let DTR fall and rise: a board on USB restarts, its motors off. Other lines have no such wire."""
        for level in (False, True):
            try:
                self._port.dtr = level
            except (*GONE, NotImplementedError) as error:
                _LOG.info("no reset line: %s", error)
                return
            pause(RESET_PULSE)

    def close(self) -> None:
        with suppress(*GONE):
            self._port.close()
