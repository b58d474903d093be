"""Where speech-dispatcher listens: ``SPEECHD_ADDRESS``, or the socket of this user.

``SPEECHD_ADDRESS`` is ``unix_socket:/path`` or ``inet_socket:host:port``, as speech-dispatcher's own
clients read it. With ``ssh -R`` either brings the voice to the learner's machine.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from contextlib import closing
from typing import TYPE_CHECKING

from devices.ports.values import Frozen

if TYPE_CHECKING:
    import socket

_DEFAULT_PORT = 6560
_PATIENCE = 0.25
"""Seconds: a socket that does not take us by then is no voice to wait for."""


class Address(Frozen):
    """A socket: ``path`` of a Unix one, or ``host`` and ``port``."""

    path: str = ""
    host: str = ""
    port: int = 0

    def connect(self, seconds: float) -> socket.socket:
        """A connected socket with that time-out. Raises ``OSError``."""
        import socket  # slow to load, and most have no such voice

        if not self.path:
            return socket.create_connection((self.host, self.port), timeout=seconds)
        line = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            line.settimeout(seconds)
            line.connect(self.path)
        except BaseException:
            line.close()
            raise
        return line


def find_address(variables: Mapping[str, str]) -> Address | None:
    """Where to look, or None: no address is given and there is no socket of this user."""
    given = variables.get("SPEECHD_ADDRESS", "")
    if given:
        return parse_address(given)
    runtime = variables.get("XDG_RUNTIME_DIR")
    path = os.path.join(runtime, "speech-dispatcher", "speechd.sock") if runtime else ""  # noqa: PTH118
    is_there = os.path.exists(path)  # noqa: PTH110 -- pathlib's raises where one may not look
    return Address(path=path) if is_there and _has_unix_sockets() else None


def parse_address(given: str) -> Address | None:
    """The address that ``SPEECHD_ADDRESS`` means; None where it can't be understood."""
    method, _, place = given.partition(":")
    if method == "unix_socket" and place and _has_unix_sockets():
        return Address(path=place)
    if method != "inet_socket":
        return None
    host, _, port = place.rpartition(":") if ":" in place else (place, "", str(_DEFAULT_PORT))
    is_port = port.isdecimal() and 0 < int(port) < 65_536
    return Address(host=host or "127.0.0.1", port=int(port)) if is_port else None


def _has_unix_sockets() -> bool:
    import socket

    return hasattr(socket, "AF_UNIX")


def is_reachable(address: Address | None) -> bool:
    """Whether something takes our connection there, within a quarter of a second."""
    if address is None:
        return False
    try:
        with closing(address.connect(_PATIENCE)):
            return True
    except OSError:
        return False
