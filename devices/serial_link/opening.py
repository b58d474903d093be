"""Opens a port in a thread of its own: a network address may take seconds, and whoever waits may go before.

Rule: a port that opens when nobody waits any more is told to stop its robot, and is closed.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from contextlib import suppress

from devices.serial_link.port import OpenPort
from devices.serial_port import GONE
from devices.wire.commands import STOP

_LOOK = 0.01
"""Seconds between two looks whether it was given up."""


class Opening:
    """One attempt. It begins at once."""

    def __init__(self, port: str, open_port: Callable[[str], OpenPort]) -> None:
        self._lock = threading.Lock()
        self._done = threading.Event()
        self._is_abandoned = False
        self._port: OpenPort | None = None
        self._error: Exception | None = None
        thread = threading.Thread(
            target=self._open, args=(port, open_port), name=f"opening {port}", daemon=True
        )
        thread.start()

    def wait(self, is_given_up: Callable[[], bool]) -> OpenPort | None:
        """The port, or None if it was given up. Raises what opening it raised."""
        try:
            while not self._done.wait(_LOOK) and not is_given_up():
                pass
        except BaseException:
            self._abandon()
            raise
        if is_given_up():
            self._abandon()
            return None
        if self._error is not None:
            raise self._error
        return self._port

    def _open(self, port: str, open_port: Callable[[str], OpenPort]) -> None:
        try:
            self._port = open_port(port)
        except Exception as error:  # noqa: BLE001 -- raised again where it is waited for
            self._error = error
        with self._lock:
            self._done.set()
            if self._is_abandoned:
                self._let_go()

    def _abandon(self) -> None:
        with self._lock:
            self._is_abandoned = True
            if self._done.is_set():
                self._let_go()

    def _let_go(self) -> None:
        if self._port is not None:
            with suppress(*GONE):
                self._port.write(STOP)
            self._port.close()
