"""Messages of Player: a header of 40 bytes and a body in XDR, big-endian, in multiples of four bytes.

A form says what a body holds, in the letters of ``struct``, each of four bytes (I, i, f) or eight (d), and
three more: ``[…]`` is an array of such groups, ``b`` are bytes and ``t`` is a text. These three have their
count before them, twice.

Any chunking of a stream gives the same messages. A reader never holds more than one message, and no count is
believed before it was compared with the body.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Iterator, Sequence
from enum import IntEnum
from functools import lru_cache
from itertools import chain

from msgspec import Struct

HEADER_SIZE = 40
_HEADER = struct.Struct(">IIIIIIdII")
_PART = re.compile(r"\[([Iifd]+)\]|([bt])|([Iifd]+|\d+s)")
_COUNTS = struct.Struct(">II")

LONGEST_REQUEST = 64 * 1024
"""Bytes of a body that a client sends."""
LONGEST_REPLY = 8 * 1024 * 1024
"""The same of a server."""

BANNER_SIZE = 32
LOCAL_HOST = 0x0100007F
"""127.0.0.1 as a header has it."""


class MessageType(IntEnum):
    """What a message is for. Clients send the second and the third."""

    DATA = 1
    COMMAND = 2
    REQUEST = 3
    ACK = 4
    SYNCH = 5
    NACK = 6


class BadBody(ValueError):
    """A body is not of its form."""


class TooLong(ValueError):
    """A header says that more follows than any message has."""


class PlayerMessage(Struct, frozen=True):
    """A header and its body, not decoded yet."""

    interface: int
    index: int
    type: int
    """A ``MessageType``, or rubbish."""
    subtype: int
    body: bytes = b""
    time: float = 0.0
    """Seconds: of simulated time in what a server sends."""
    host: int = 0
    robot: int = 0
    """The port that distinguishes the robots."""
    sequence: int = 0

    def encoded(self) -> bytes:
        place = (self.host, self.robot, self.interface, self.index, self.type, self.subtype)
        return _HEADER.pack(*place, self.time, self.sequence, len(self.body)) + self.body


def banner(version: str) -> bytes:
    """The first bytes that a server sends."""
    return f"Player v.{version}".encode("ascii")[: BANNER_SIZE - 1].ljust(BANNER_SIZE, b"\0")


class MessageReader:
    """Finds the messages in a stream of bytes."""

    def __init__(self, longest: int = LONGEST_REQUEST) -> None:
        """``longest``: bytes of a body."""
        self._longest = longest
        self._held = bytearray()

    @property
    def held(self) -> int:
        """Bytes of a message that isn't whole yet."""
        return len(self._held)

    def feed(self, data: bytes) -> Iterator[PlayerMessage]:
        """The messages that are whole now. After ``TooLong`` the stream can't be read any further."""
        held, start = self._held, 0
        held += data
        try:
            while len(held) - start >= HEADER_SIZE:
                host, robot, *kind, time, sequence, size = _HEADER.unpack_from(held, start)
                interface, index, type_, subtype = kind
                if size > self._longest:
                    start = len(held)
                    raise TooLong(f"a body of {size} bytes; at most {self._longest} are read")
                end = start + HEADER_SIZE + size
                if len(held) < end:
                    return
                body = bytes(held[start + HEADER_SIZE : end])
                start = end
                yield PlayerMessage(interface, index, type_, subtype, body, time, host, robot, sequence)
        finally:
            del held[:start]


def encode(form: str, values: Sequence[object]) -> bytes:
    """A body with these values, in their order; a fixed group gives one value for each letter.

    An array is a sequence of numbers, or of sequences of numbers if its group has several.
    """
    body, at = bytearray(), 0
    for part in _parts(form):
        if isinstance(part, struct.Struct):
            count = len(part.unpack(bytes(part.size)))
            body += part.pack(*values[at : at + count])
            at += count
            continue
        value = values[at]
        at += 1
        if isinstance(part, str):
            data = value if isinstance(value, bytes) else _text(str(value))
            body += _COUNTS.pack(len(data), len(data)) + data + bytes(-len(data) % 4)
        else:
            items: list[object] = list(value)  # type: ignore[call-overload] # a sequence, as the form says
            numbers = chain.from_iterable(items) if part.width > 1 else items  # type: ignore[arg-type]
            body += _COUNTS.pack(len(items), len(items))
            body += struct.pack(f">{part.letters * len(items)}", *numbers)
    if at != len(values):
        raise BadBody(f"{len(values)} values, and {at} in its form")
    return bytes(body)


def decode(form: str, body: bytes) -> tuple[object, ...]:
    """The values of a body, as ``encode`` takes them. Raises ``BadBody``."""
    values: list[object] = []
    at = 0
    for part in _parts(form):
        if isinstance(part, struct.Struct):
            if len(body) - at < part.size:
                raise BadBody(f"{len(body)} bytes, and its form has more")
            values += part.unpack_from(body, at)
            at += part.size
            continue
        count, size = _counted(body, at, 1 if isinstance(part, str) else part.size)
        at += _COUNTS.size
        data = body[at : at + size]
        at += size + -size % 4
        if part == "t":
            values.append(data.partition(b"\0")[0].decode("utf-8", "replace"))
        elif isinstance(part, str):
            values.append(data)
        else:
            numbers = struct.unpack(f">{part.letters * count}", data)
            width = part.width
            groups = tuple(numbers[i : i + width] for i in range(0, len(numbers), width))
            values.append(numbers if width == 1 else groups)
    if at != len(body):
        raise BadBody(f"{len(body)} bytes, and {at} in its form")
    return tuple(values)


def _text(text: str) -> bytes:
    """With the NUL that is counted; an empty text has none."""
    return text.encode("utf-8", "replace") + b"\0" if text else b""


def _counted(body: bytes, at: int, size: int) -> tuple[int, int]:
    """How many things of that size follow, and their bytes. Raises ``BadBody``."""
    if len(body) - at < _COUNTS.size:
        raise BadBody("it ends within a count")
    count, again = _COUNTS.unpack_from(body, at)
    if count != again:
        raise BadBody(f"{count} and {again} are counts of one array")
    whole = count * size
    if whole + -whole % 4 > len(body) - at - _COUNTS.size:
        raise BadBody(f"an array of {count}, and {len(body)} bytes in all")
    return count, whole


class _Array(Struct, frozen=True):
    letters: str
    width: int
    """Numbers in a group."""
    size: int
    """Bytes of a group."""


@lru_cache(maxsize=256)
def _parts(form: str) -> tuple[struct.Struct | _Array | str, ...]:
    parts: list[struct.Struct | _Array | str] = []
    for group, counted, fixed in _PART.findall(form.replace(" ", "")):
        if group:
            parts.append(_Array(group, len(group), struct.calcsize(f">{group}")))
        else:
            parts.append(counted or struct.Struct(f">{fixed}"))
    return tuple(parts)
