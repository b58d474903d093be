"""The frames from the host to the board, and the checksum of both directions.

A frame is ``AA BB LEN TYPE DATA CRC``: LEN counts TYPE and DATA, and the checksum covers both. The board
acknowledges no frame, and obeys none before it has received ``CONFIGURE``.
"""

from __future__ import annotations

import struct
from enum import Enum

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
    right = right if right_sense > 0 else _OPPOSITE.get(right, right)
    left = left if left_sense > 0 else _OPPOSITE.get(left, left)
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


def outputs_frame(*, buzzer: bool = False, vibrate_left: bool = False, vibrate_right: bool = False) -> bytes:
    """Switches the digital outputs. The board controls its two lamps itself."""
    return encode_frame(
        CommandKind.OUTPUTS.value, bytes((buzzer << 2 | vibrate_left << 3 | vibrate_right << 4,))
    )


def beep_frame(hertz: int, milliseconds: int) -> bytes:
    """``ValueError`` if a number doesn't fit into its 16 or 32 bits."""
    if not (0 <= hertz < 1 << 16 and 0 <= milliseconds < 1 << 32):
        raise ValueError("no such beep")
    return encode_frame(CommandKind.BEEP.value, struct.pack(">HI", hertz, milliseconds))
