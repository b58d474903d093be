"""Messages of Player: a header of 40 bytes and a body in XDR, big-endian, in multiples of four bytes.

A table has the form of the body of each message of each interface: the letters of ``struct``, each of four
bytes (I, i, f) or eight (d), and three more. ``[…]`` is an array of such groups, ``b`` are bytes and ``t`` is
a text. These three have their count before them, twice.

Any chunking of a stream gives the same messages. A reader never holds more than one message, and no count is
believed before it was compared with the body.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from enum import IntEnum
from functools import lru_cache
from itertools import chain, islice
from string import digits
from typing import Any

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


DATA, COMMAND, REQUEST, ACK, SYNCH, NACK = MessageType


class Interface(IntEnum):
    """What is served, by the code that the header has. The name in a configuration file is the same."""

    PLAYER = 1
    POWER = 2
    GRIPPER = 3
    POSITION2D = 4
    BLOBFINDER = 7
    FIDUCIAL = 10
    SPEECH = 12
    BUMPER = 14
    DIO = 20
    SIMULATION = 31
    RANGER = 62
    SOUND = 66


class Access(IntEnum):
    """How a client opens a device."""

    OPEN = 1
    CLOSE = 2
    ERROR = 3


PULL = 2
"""The data mode in which data go out when the client asks for a round; else when they are there."""

CAN_YOU = 255
"""The subtype of a request, of any interface: is this type and subtype known?"""


Key = tuple[int, int]
"""The interface and the index of a device."""
Values = tuple[Any, ...]
"""What is in a body."""


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
        self.held = bytearray()
        """Of a message that isn't whole yet."""

    def feed(self, data: bytes) -> Iterator[PlayerMessage]:
        """The messages that are whole now. After ``TooLong`` the stream can't be read any further."""
        held = self.held
        held += data
        while len(held) >= HEADER_SIZE:
            host, robot, *kind, time, sequence, size = _HEADER.unpack_from(held)
            interface, index, type_, subtype = kind
            if size > self._longest:
                held.clear()
                raise TooLong(f"a body of {size} bytes; at most {self._longest} are read")
            if len(held) < HEADER_SIZE + size:
                return
            body = bytes(held[HEADER_SIZE : HEADER_SIZE + size])
            del held[: HEADER_SIZE + size]
            yield PlayerMessage(interface, index, type_, subtype, body, time, host, robot, sequence)


def encode(form: str, values: Sequence[object]) -> bytes:
    """A body with these values, in their order; a fixed group gives one value for each letter.

    An array is a sequence of numbers, or of sequences of numbers if its group has several.
    """
    parts, rest, body = _parts(form), iter(values), bytearray()
    if len(values) != (number := sum(1 if each.kind else each.width for each in parts)):
        raise BadBody(f"{len(values)} values, and {number} in its form")
    for part in parts:
        group, width = part.group, part.width
        if not part.kind:
            body += group.pack(*islice(rest, width))
            continue
        value: Any = next(rest)
        if part.kind == "[":
            data = b"".join(group.pack(*each) if width > 1 else group.pack(each) for each in value)
        else:
            data = value if isinstance(value, bytes) else _text(str(value))
        count = len(data) // group.size
        body += _COUNTS.pack(count, count) + data + bytes(-len(data) % 4)
    return bytes(body)


def decode(form: str, body: bytes) -> Values:
    """The values of a body, as ``encode`` takes them. Raises ``BadBody``."""
    values: list[object] = []
    at = 0
    for part in _parts(form):
        size = part.group.size
        if part.kind:
            if len(body) - at < _COUNTS.size:
                raise BadBody("it ends within a count")
            count, again = _COUNTS.unpack_from(body, at)
            if count != again:
                raise BadBody(f"{count} and {again} are counts of one array")
            size, at = size * count, at + _COUNTS.size
        if size + -size % 4 > len(body) - at:
            raise BadBody(f"{len(body)} bytes, and its form has more")
        data = body[at : at + size]
        at += size + -size % 4
        match part.kind:
            case "":
                values += part.group.unpack(data)
            case "b":
                values.append(data)
            case "t":
                values.append(data.partition(b"\0")[0].decode("utf-8", "replace"))
            case _:
                groups = tuple(part.group.iter_unpack(data))
                values.append(groups if part.width > 1 else tuple(chain.from_iterable(groups)))
    if at != len(body):
        raise BadBody(f"{len(body)} bytes, and {at} in its form")
    return tuple(values)


def _text(text: str) -> bytes:
    """The text as bytes with the NUL that is counted; an empty text has none."""
    return text.encode("utf-8", "replace") + b"\0" if text else b""


class _Part(Struct, frozen=True):
    kind: str
    """Empty for a fixed group, ``[`` for an array of groups; ``b`` and ``t``, whose group is a byte."""
    group: struct.Struct
    width: int
    """Values in a group."""


@lru_cache(maxsize=256)
def _parts(form: str) -> tuple[_Part, ...]:
    parts = []
    for group, counted, fixed in _PART.findall(form):
        letters = group or fixed or "s"
        width = len(letters.strip(digits))
        parts.append(_Part(counted or ("[" if group else ""), struct.Struct(f">{letters}"), width))
    return tuple(parts)


# --- the forms of bodies

ADDRESS = "IIII"
POSE2D, POSE3D = "ddd", "dddddd"
BOX2D, BOX3D = "dd", "ddd"

REQUESTS: Mapping[tuple[int, int], tuple[str, str]] = {
    (Interface.PLAYER, 1): ("", f"[{ADDRESS}]"),  # device list
    (Interface.PLAYER, 2): (f"{ADDRESS} t", f"{ADDRESS} t"),  # driver
    (Interface.PLAYER, 3): (f"{ADDRESS} I t", f"{ADDRESS} I t"),  # open, close
    (Interface.PLAYER, 4): ("", ""),  # a round of data
    (Interface.PLAYER, 5): ("I", ""),  # data mode
    (Interface.PLAYER, 10): ("iiiii", ""),  # replace rule
    (Interface.GRIPPER, 1): ("", f"{POSE3D} {BOX3D} {BOX3D} I I"),  # geometry
    (Interface.POSITION2D, 1): ("", f"{POSE3D} {BOX3D}"),  # geometry
    # motor power, velocity mode, position mode
    **{(Interface.POSITION2D, each): ("I", "") for each in (2, 3, 4)},
    (Interface.POSITION2D, 5): (POSE2D, ""),  # set odometry
    (Interface.POSITION2D, 6): ("", ""),  # reset odometry
    (Interface.FIDUCIAL, 1): ("", f"{POSE3D} {BOX3D} {BOX2D}"),  # geometry
    (Interface.FIDUCIAL, 2): ("", "fff"),  # field of view: from and to metres, radians
    (Interface.FIDUCIAL, 7): ("", "I"),  # get the mark of its own model
    (Interface.FIDUCIAL, 8): ("I", "I"),  # set it
    (Interface.BUMPER, 1): ("", f"[{POSE3D}ff]"),  # geometry
    (Interface.SIMULATION, 1): (f"t {POSE2D}", f"t {POSE2D}"),  # get a pose
    (Interface.SIMULATION, 2): (f"t {POSE2D}", ""),  # set it
    (Interface.SIMULATION, 3): (f"t {POSE3D} d", f"t {POSE3D} d"),  # get a pose
    (Interface.SIMULATION, 4): (f"t {POSE3D} d", ""),  # set it
    (Interface.SIMULATION, 5): ("t t I b", "t t I b"),  # get a property
    (Interface.SIMULATION, 6): ("t t I b", ""),  # set it
    (Interface.RANGER, 1): ("", f"{POSE3D} {BOX3D} [{POSE3D}] [{BOX3D}]"),  # geometry
    (Interface.RANGER, 5): ("", "ddddddd"),  # configuration
}
"""By interface and subtype: the forms of the request and of the reply."""

FORMS: Mapping[tuple[int, int, int], str] = {
    **{(key[0], REQUEST, key[1]): forms[0] for key, forms in REQUESTS.items()},
    **{(key[0], ACK, key[1]): forms[1] for key, forms in REQUESTS.items()},
    (Interface.PLAYER, NACK, 3): f"{ADDRESS} I t",
    (Interface.PLAYER, SYNCH, 1): "",
    (Interface.PLAYER, SYNCH, 2): "I",
    (Interface.POWER, DATA, 1): "I ffff i",
    (Interface.GRIPPER, DATA, 1): "I I I",
    # open, close, stop, store, retrieve
    **dict.fromkeys(((Interface.GRIPPER, COMMAND, each) for each in range(1, 6)), ""),
    (Interface.POSITION2D, DATA, 1): f"{POSE2D} {POSE2D} I",
    (Interface.POSITION2D, COMMAND, 1): f"{POSE2D} I",  # velocity
    (Interface.POSITION2D, COMMAND, 2): f"{POSE2D} {POSE2D} I",  # position
    (Interface.POSITION2D, COMMAND, 3): "dd",  # velocity and angle, as a car
    (Interface.POSITION2D, COMMAND, 4): "dd",  # velocity and heading
    (Interface.BLOBFINDER, DATA, 1): "I I [IIIIIIIIIf]",
    (Interface.FIDUCIAL, DATA, 1): f"[i{POSE3D}{POSE3D}]",
    (Interface.SPEECH, COMMAND, 1): "t",
    (Interface.BUMPER, DATA, 1): "b",
    (Interface.DIO, DATA, 1): "I I",
    (Interface.DIO, COMMAND, 1): "I I",
    # pause or resume, reset, save
    **dict.fromkeys(((Interface.SIMULATION, COMMAND, each) for each in range(1, 4)), ""),
    (Interface.RANGER, DATA, 1): "[d]",
    (Interface.RANGER, DATA, 3): "[d]",  # intensities
    (Interface.SOUND, COMMAND, 1): "64s",
}
"""By interface, type and subtype, of what is served. A reply that isn't here has no body."""


def form_of(message: PlayerMessage) -> str | None:
    """The form of its body; None if nothing is known of such a message."""
    form = FORMS.get((message.interface, message.type, message.subtype))
    if form is not None:
        return form
    if message.type in (ACK, NACK):
        return ""
    return "II" if message.type == REQUEST and message.subtype == CAN_YOU else None


def values_of(message: PlayerMessage) -> Values | None:
    """The values in the body of a message; None if its form is wrong or unknown."""
    form = form_of(message)
    with suppress(BadBody):
        return None if form is None else decode(form, message.body)
    return None


def body_of(interface: int, type_: int, subtype: int, *values: object) -> bytes:
    """The body of such a message; empty if it has no form."""
    form = FORMS.get((interface, type_, subtype))
    return encode(form, values) if form else b""
