"""One open serial port with a robot's board: read without waiting, written whole, reset by its wire.

What a line that is gone raises is one of ``GONE``.
"""

from __future__ import annotations

from contextlib import suppress

from devices.reset_line import AUTOMATIC, Pause, Reset, reset_of
from devices.serial_port import GONE, open_port

BAUD = 115200
MOST_AT_ONCE = 8192
"""Bytes that one read takes: more than the system keeps."""


class OpenPort:
    """A port that is ours alone. One of ``GONE`` from any method means that it is."""

    def __init__(self, url: str, reset: Reset | None = None) -> None:
        """Open it. Raises ``PortProblem``. Opening resets a board on USB, and so stops it.

        ``reset``: how the board is restarted by force; by default as fits the port.
        """
        self._port = open_port(url, BAUD)
        self._reset = reset or reset_of(AUTOMATIC, url)

    def read(self) -> bytes:
        """What has come in; returns at once."""
        data: bytes = self._port.read(MOST_AT_ONCE)
        return data

    def write(self, data: bytes) -> None:
        """All of it. A port that takes no few bytes in a fifth of a second is gone as well: what it took of
        them may be half a frame, and only a new beginning ends that surely."""
        self._port.write(data)

    def pull_reset(self, pause: Pause) -> None:
        """Restart the board by force, its motors off, where there is a way to."""
        self._reset.pull(self._port, pause)

    def close(self) -> None:
        with suppress(*GONE):
            self._port.close()
