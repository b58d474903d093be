"""Device addresses as a configuration file writes them: ``host:robot:interface:index``."""

from __future__ import annotations

import re

from devices.ports.values import Frozen

DEFAULT_PORT = 6665
"""Player's."""
LOCAL = "localhost"

_INDEX = re.compile(r"[0-9]{1,9}")


class Address(Frozen):
    """Under which a device is offered. ``port`` tells robots of one host apart."""

    interface: str
    index: int
    port: int = DEFAULT_PORT
    host: str = LOCAL


def address(text: str) -> Address | None:
    """``position2d:0``, ``6666:position2d:0``, ``host:6666:position2d:0`` (or a key before it); else None."""
    fields = text.split(":")
    if not 2 <= len(fields) <= 5:
        return None
    *place, interface, index = fields
    _, host, port = ["", "", "", *place][-3:]
    number = _whole(port or str(DEFAULT_PORT), 65535)
    at = _whole(index, 10**9)
    if number is None or at is None or not re.fullmatch(r"[A-Za-z]\w*", interface):
        return None
    return Address(interface, at, number, host or LOCAL)


def _whole(text: str, most: int) -> int | None:
    return int(text) if _INDEX.fullmatch(text) and int(text) <= most else None
