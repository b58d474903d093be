"""CRC-8/MAXIM, as the firmware computes it over TYPE and DATA: polynomial 0x31 reflected, begun at 0."""

from __future__ import annotations

_REFLECTED = 0x8C


def _of_one(byte: int) -> int:
    for _ in range(8):
        byte = (byte >> 1) ^ _REFLECTED if byte & 1 else byte >> 1
    return byte


_TABLE = bytes(_of_one(byte) for byte in range(256))


def checksum(data: bytes) -> int:
    """0 to 255; 0xA1 for ``b"123456789"``."""
    crc = 0
    for byte in data:
        crc = _TABLE[crc ^ byte]
    return crc
