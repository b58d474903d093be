"""What the board tells, each frame as a value; and which LEN and count each type must have.

``read`` is total: what does not fit its type is None and never an exception.
"""

from __future__ import annotations

import struct
from enum import Enum
from typing import TypeAlias

from devices.ports.values import Frozen


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


SONARS = 7
BUMPERS = 6


class ConfigWanted(Frozen):
    """The board has just started and waits."""


class Pinged(Frozen):
    """The board asks whether somebody is there, every two seconds."""


class Encoders(Frozen):
    """Counts of the wheels, -32768 to 32767, which go round. (The frame's speeds are no speeds.)"""

    right: int
    left: int


class Ranges(Frozen):
    """Seven sonars in the board's order, whole centimetres, 0 for unknown; from 256 on they wrap."""

    centimetres: tuple[int, ...]


class Bumpers(Frozen):
    """Six places in the board's order: NE, N, NW, SE, S, SW."""

    pressed: tuple[bool, ...]


class Power(Frozen):
    """The battery, in steps of 100 mV; the firmware can tell less than nothing."""

    millivolts: int


class Outputs(Frozen):
    """Five bits: lamp of the battery, lamp of the connection, vibration right, left, buzzer."""

    bits: int


class Message(Frozen):
    """Text of the firmware, sent as a frame (after a beep only)."""

    text: bytes


Report: TypeAlias = ConfigWanted | Pinged | Encoders | Ranges | Bumpers | Power | Outputs | Message

_ENCODERS = struct.Struct(">hhhh")
_POWER = struct.Struct("<h")


def read(kind: int, data: bytes) -> Report | None:
    """The value of a frame whose checksum was right, or None if its type or its data are none."""
    if kind == ReportKind.ENCODERS.value:  # 97 of a hundred frames
        return Encoders(*_ENCODERS.unpack(data)[:2]) if len(data) == _ENCODERS.size else None
    if kind == ReportKind.RANGES.value:
        return Ranges(tuple(data[1:])) if _is_counted(data, SONARS) else None
    if kind == ReportKind.BUMPERS.value:
        return _bumpers(data)
    return _rare(kind, data)


def _rare(kind: int, data: bytes) -> Report | None:
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


def _bumpers(data: bytes) -> Bumpers | None:
    if not _is_counted(data, BUMPERS) or max(data[1:]) > 1:
        return None
    return Bumpers(tuple(each == 1 for each in data[1:]))


def _is_counted(data: bytes, count: int) -> bool:
    return len(data) == count + 1 and data[0] == count
