"""The frames of the robot's serial connection, both ways, their checksum, and the decoder that finds them.

A frame is ``AA BB LEN TYPE DATA CRC``: LEN counts TYPE and DATA, and the checksum covers both. The board
acknowledges no frame, and obeys none before it has received ``CONFIGURE``.

Any chunking of a stream from the board gives the same reports. Bytes outside of frames are text for the log.
After a wrong checksum the decoder drops one byte and searches again. It never holds more than one frame, and
no input makes it raise."""

from __future__ import annotations

import struct
from collections.abc import Callable
from enum import Enum
from typing import TypeAlias

from msgspec import Struct

BAUD = 115200

HEADER = b"\xaa\xbb"
LONGEST = 50
"""The largest LEN that the board accepts."""

FILLER = bytes(LONGEST + 2)
"""Completes whatever half frame the board may have received; on its own it has no effect."""


class CommandKind(Enum):
    """The types of frames from the host."""

    CONFIG = 0xC0
    PING = 0x41
    MOTOR = 0x28
    SERVO = 0x30
    OUTPUTS = 0x15
    BEEP = 0x17


class MotorDrive(Enum):
    """What the motors are commanded: direction and speed of the right wheel, then of the left one.

    A speed is only zero or not. Forward is 0F on the right and F0 on the left, because the motors are
    mirrored.
    """

    STOP = bytes((0x00, 0x00, 0x00, 0x00))
    FORWARD = bytes((0x0F, 0x7F, 0xF0, 0x7F))
    BACKWARD = bytes((0xF0, 0x7F, 0x0F, 0x7F))
    LEFT = bytes((0x0F, 0x66, 0x0F, 0x66))
    RIGHT = bytes((0xF0, 0x66, 0xF0, 0x66))


class Wiring(Struct, frozen=True):
    """The senses of a robot's wheels, right and left: 1 as the original is wired, -1 for the reverse."""

    motors: tuple[int, int] = (1, 1)
    encoders: tuple[int, int] = (1, 1)


AS_ORIGINAL = Wiring()

_OPPOSITE = {0x0F: 0xF0, 0xF0: 0x0F}
"""Of each direction byte; a stop has none."""

_REFLECTED_POLYNOMIAL = 0x8C


def _crc_of_byte(byte: int) -> int:
    for _ in range(8):
        byte = (byte >> 1) ^ _REFLECTED_POLYNOMIAL if byte & 1 else byte >> 1
    return byte


_CRC_TABLE = bytes(_crc_of_byte(byte) for byte in range(256))


def checksum(data: bytes) -> int:
    """CRC-8/MAXIM (polynomial 0x31 reflected, initial value 0): 0xA1 for ``b"123456789"``."""
    crc = 0
    for byte in data:
        crc = _CRC_TABLE[crc ^ byte]
    return crc


def encode_frame(kind: int, data: bytes) -> bytes:
    """A whole frame. ``ValueError`` if it is longer than the board accepts."""
    if len(data) >= LONGEST:
        raise ValueError("too long for a frame")
    body = bytes((kind,)) + data
    return HEADER + bytes((len(body),)) + body + bytes((checksum(body),))


def drive_frame(drive: MotorDrive, wiring: Wiring = AS_ORIGINAL) -> bytes:
    """The same frame each time. The wheels turn in the senses of ``drive``, however they are wired."""
    return _DRIVE_FRAMES[drive, wiring.motors]


def _drive_frame(drive: MotorDrive, right_sense: int, left_sense: int) -> bytes:
    right, right_speed, left, left_speed = drive.value
    right = right if right_sense == 1 else _OPPOSITE.get(right, right)
    left = left if left_sense == 1 else _OPPOSITE.get(left, left)
    return encode_frame(CommandKind.MOTOR.value, bytes((right, right_speed, left, left_speed)))


_DRIVE_FRAMES = {
    (drive, (right, left)): _drive_frame(drive, right, left)
    for drive in MotorDrive
    for right in (1, -1)
    for left in (1, -1)
}
STOP = drive_frame(MotorDrive.STOP)

CONFIGURE = encode_frame(CommandKind.CONFIG.value, struct.pack(">4f2b", 1.0, 0.0, 0.0, 5.0, 3, -3))
"""The original's own numbers. They don't change how the robot moves; the frame unlocks the board."""

PING = encode_frame(CommandKind.PING.value, b"\x2b")


def head_frame(angle: int) -> bytes:
    """Turns the head: 0 is full left, 90 ahead, 180 full right. ``ValueError`` outside of that."""
    if not 0 <= angle <= 180:
        raise ValueError("the head turns from 0 to 180")
    return encode_frame(CommandKind.SERVO.value, bytes((0x10, angle)))


SONARS = 7
BUMPERS = 6

LONGEST_TEXT = 200
"""Characters in one line of the board's debug text; longer lines are split."""

_NEWLINE = 0x0A
_OVERHEAD = 4
"""Bytes of a frame that LEN doesn't count."""


class ReportKind(Enum):
    """The types of frames from the board."""

    CONFIG_WANTED = 0xC7
    PING = 0x41
    ENCODERS = 0x81
    RANGES = 0x68
    BUMPERS = 0x42
    POWER = 0x66
    OUTPUTS = 0x15
    MESSAGE = 0x73


class ConfigWanted(Struct, frozen=True):
    """The board has just started and waits for its configuration."""


class Pinged(Struct, frozen=True):
    """The board asks whether a host is there, every two seconds."""


class Encoders(Struct, frozen=True):
    """Counts of the wheels, -32768 to 32767; they wrap. (The speeds in the frame are no speeds.)"""

    right: int
    left: int


class Ranges(Struct, frozen=True):
    """Seven sonars in the board's order, in whole centimetres. 0 is unknown; from 256 on they wrap."""

    centimetres: tuple[int, ...]


class Bumpers(Struct, frozen=True):
    """Six places in the board's order: NE, N, NW, SE, S, SW."""

    pressed: tuple[bool, ...]


class Power(Struct, frozen=True):
    """The battery, in steps of 100 mV; the firmware may report a negative value."""

    millivolts: int


class Outputs(Struct, frozen=True):
    """Five bits: lamp of the battery, lamp of the connection, vibration right, left, buzzer."""

    bits: int


class Message(Struct, frozen=True):
    """Text of the firmware, sent as a frame (only after a beep)."""

    text: bytes


Report: TypeAlias = ConfigWanted | Pinged | Encoders | Ranges | Bumpers | Power | Outputs | Message

_ENCODERS = struct.Struct(">hhhh")
_POWER = struct.Struct("<h")


def decode_report(kind: int, data: bytes) -> Report | None:
    """The report in a frame with a correct checksum; None if its type is unknown or its data don't fit it."""
    if kind == ReportKind.ENCODERS.value:  # 97 of a hundred frames
        return Encoders(*_ENCODERS.unpack(data)[:2]) if len(data) == _ENCODERS.size else None
    if kind == ReportKind.RANGES.value:
        return Ranges(tuple(data[1:])) if _is_counted(data, SONARS) else None
    if kind == ReportKind.BUMPERS.value:
        return _decode_bumpers(data)
    return _decode_rare_report(kind, data)


def _decode_rare_report(kind: int, data: bytes) -> Report | None:
    if kind == ReportKind.POWER.value:
        return Power(_POWER.unpack(data)[0]) if len(data) == _POWER.size else None
    if kind == ReportKind.OUTPUTS.value:
        return Outputs(data[1]) if len(data) == 2 and data[0] == 5 else None
    if kind == ReportKind.MESSAGE.value:
        return Message(data)
    if kind == ReportKind.PING.value:
        return Pinged() if len(data) == 1 else None
    if kind == ReportKind.CONFIG_WANTED.value:
        return ConfigWanted() if len(data) == 1 else None
    return None


def _decode_bumpers(data: bytes) -> Bumpers | None:
    if not _is_counted(data, BUMPERS) or max(data[1:]) > 1:
        return None
    return Bumpers(tuple(each == 1 for each in data[1:]))


def _is_counted(data: bytes, count: int) -> bool:
    """Whether the first byte gives the number of the others."""
    return len(data) == count + 1 and data[0] == count


class Decoder:
    """Decodes the stream of bytes from the board."""

    def __init__(self, on_text: Callable[[str], None] | None = None) -> None:
        """``on_text`` receives the board's debug text, line by line, 200 characters at most."""
        self.bad_frames = 0
        """Frames with a wrong LEN or checksum, or with data that don't fit their type."""
        self._on_text = on_text
        self._held = b""
        self._text = bytearray()
        self._last_frame = b""
        self._last_report: Report | None = None

    @property
    def held(self) -> int:
        """Bytes that wait for the rest of their frame or line; never more than a few hundred."""
        return len(self._held) + len(self._text)

    def feed(self, data: bytes) -> list[Report]:
        """The reports that ``data`` completes, in order."""
        held = self._held + data
        reports: list[Report] = []
        at = 0
        while True:
            begins = held.find(HEADER, at)
            if begins < 0:
                self._held = self._rest_without_frame(held, at)
                return reports
            self._take_text(held[at:begins])
            ends = self._end_of_frame(held, begins)
            if ends > len(held):
                self._held = held[begins:]
                return reports
            at = self._take_frame(held, begins, ends, reports)

    def _rest_without_frame(self, held: bytes, at: int) -> bytes:
        """Takes the rest as text, except for a last byte that may begin a frame."""
        keeps = 1 if held[at:].endswith(HEADER[:1]) else 0
        self._take_text(held[at : len(held) - keeps])
        return held[len(held) - keeps :]

    def _end_of_frame(self, held: bytes, begins: int) -> int:
        """Where the frame that begins there ends; ``begins`` if its LEN is not valid."""
        if len(held) < begins + 3:
            return len(held) + 1
        length = held[begins + 2]
        return begins + length + _OVERHEAD if 1 <= length <= LONGEST else begins

    def _take_frame(self, held: bytes, begins: int, ends: int, reports: list[Report]) -> int:
        """Decode a frame. Returns the position to continue at."""
        whole = held[begins:ends]
        if whole and whole == self._last_frame and self._last_report is not None:
            self._end_line()
            reports.append(self._last_report)
            return ends
        if not whole or checksum(whole[3:-1]) != whole[-1]:
            self.bad_frames += 1
            self._take_text(held[begins : begins + 1])
            return begins + 1
        self._end_line()
        report = decode_report(whole[3], whole[4:-1])
        if report is None:
            self.bad_frames += 1
        else:
            reports.append(report)
            self._last_frame, self._last_report = whole, report
        return ends

    def _take_text(self, data: bytes) -> None:
        if self._on_text is None:
            return
        for byte in data:
            if byte == _NEWLINE:
                self._end_line()
            else:
                self._text.append(byte)
                if len(self._text) >= LONGEST_TEXT:
                    self._end_line()

    def _end_line(self) -> None:
        """A frame ends a line, too: the board sends its newlines before the text, not after it."""
        if self._text and self._on_text is not None:
            self._on_text(self._text.decode("ascii", "backslashreplace"))
            self._text.clear()
