"""What the host may tell the board, each as a whole frame.

A frame is ``AA BB LEN TYPE DATA CRC``: LEN counts TYPE and DATA, the checksum covers both. The board answers
none of them, and heeds them only once it has been sent ``CONFIGURE``.
"""

from __future__ import annotations

import struct
from enum import Enum

from devices.wire.checksum import checksum

HEADER = b"\xaa\xbb"
LONGEST = 50
"""The largest LEN that the board takes."""

FILLER = bytes(LONGEST + 2)
"""Ends whatever half frame the board may be in the middle of; on its own it does nothing."""


class Command(Enum):
    """The types of frames from the host."""

    CONFIG = 0xC0
    PING = 0x41
    MOTOR = 0x28
    SERVO = 0x30
    OUTPUTS = 0x15
    BEEP = 0x17


class Drive(Enum):
    """What the wheels are told: direction and speed of the right one, then of the left one.

    The speed is only zero or not; forward is 0F on the right and F0 on the left, for they are mirrored.
    """

    STOP = bytes((0x00, 0x00, 0x00, 0x00))
    FORWARD = bytes((0x0F, 0x7F, 0xF0, 0x7F))
    BACKWARD = bytes((0xF0, 0x7F, 0x0F, 0x7F))
    LEFT = bytes((0x0F, 0x66, 0x0F, 0x66))
    RIGHT = bytes((0xF0, 0x66, 0xF0, 0x66))


def frame(kind: int, data: bytes) -> bytes:
    """A whole frame. ValueError if it is longer than the board can take."""
    if len(data) >= LONGEST:
        raise ValueError("too long for a frame")
    body = bytes((kind,)) + data
    return HEADER + bytes((len(body),)) + body + bytes((checksum(body),))


def motors(drive: Drive) -> bytes:
    return _MOTORS[drive]


_MOTORS = {drive: frame(Command.MOTOR.value, drive.value) for drive in Drive}
STOP = _MOTORS[Drive.STOP]

CONFIGURE = frame(Command.CONFIG.value, struct.pack(">4f2b", 1.0, 0.0, 0.0, 5.0, 3, -3))
"""The original's own numbers, which change nothing about how the robot moves; it unlocks the board."""

PING = frame(Command.PING.value, b"\x2b")


def head(angle: int) -> bytes:
    """Turn the head: 0 is full left, 90 ahead, 180 full right. ValueError outside of that."""
    if not 0 <= angle <= 180:
        raise ValueError("the head turns from 0 to 180")
    return frame(Command.SERVO.value, bytes((0x10, angle)))


def outputs(*, buzzer: bool = False, vibrate_left: bool = False, vibrate_right: bool = False) -> bytes:
    """Switch the digital outputs. The two lamps are the board's own and can't be switched."""
    return frame(Command.OUTPUTS.value, bytes((buzzer << 2 | vibrate_left << 3 | vibrate_right << 4,)))


def beep(hertz: int, milliseconds: int) -> bytes:
    """ValueError if a number doesn't fit into its 16 or 32 bits."""
    if not (0 <= hertz < 1 << 16 and 0 <= milliseconds < 1 << 32):
        raise ValueError("no such beep")
    return frame(Command.BEEP.value, struct.pack(">HI", hertz, milliseconds))
