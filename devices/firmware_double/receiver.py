"""How the firmware takes bytes in, one a pass, with all its quirks; and the debug text that it prints.

After AA it waits for BB for ever, and says so at each byte. A LEN above 50 is forgotten in silence, a LEN of
0 swallows a byte. A wrong checksum is told and never answered. Half a frame waits for its rest for ever.
"""

from __future__ import annotations

from enum import Enum, auto

from devices.ports.values import Frozen
from devices.wire.checksum import checksum
from devices.wire.commands import HEADER, LONGEST


class _State(Enum):
    IDLE = auto()
    FIRST = auto()
    LENGTH = auto()
    PAYLOAD = auto()
    CHECKSUM = auto()


class Taken(Frozen):
    """What one byte came to: text that is printed, and a good frame's TYPE and DATA if it was its last."""

    text: bytes = b""
    frame: bytes = b""


_NOTHING = Taken()


class Receiver:
    """The parser on the board."""

    def __init__(self) -> None:
        self._state = _State.IDLE
        self._length = 0
        self._payload = bytearray()

    def take(self, byte: int) -> Taken:
        match self._state:
            case _State.IDLE:
                return self._idle(byte)
            case _State.FIRST:
                if byte == HEADER[1]:
                    self._state = _State.LENGTH
                return Taken(b"\nFOUND S1")
            case _State.LENGTH:
                return self._begin(byte)
            case _State.PAYLOAD:
                return self._collect(byte)
            case _State.CHECKSUM:
                return self._finish(byte)

    def _idle(self, byte: int) -> Taken:
        if byte != HEADER[0]:
            return _NOTHING
        self._state = _State.FIRST
        return Taken(b"\nFOUND S0")

    def _begin(self, length: int) -> Taken:
        if length > LONGEST:
            self._state = _State.IDLE
            return _NOTHING
        self._length = length
        self._payload.clear()
        self._state = _State.PAYLOAD
        return Taken(b"\nFOUND SZ")

    def _collect(self, byte: int) -> Taken:
        if self._length == 0:
            self._state = _State.IDLE
            return Taken(b"\nPayload overloaded\n")
        self._payload.append(byte)
        if len(self._payload) < self._length:
            return _NOTHING
        self._state = _State.CHECKSUM
        return Taken(b"\nPayload reveived")

    def _finish(self, byte: int) -> Taken:
        self._state = _State.IDLE
        payload = bytes(self._payload)
        if byte != checksum(payload):
            return Taken(b"\nChecksum Error!")
        return Taken(b"\nChecksum success!", payload)
