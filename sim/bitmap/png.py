"""PNG: every colour type and depth, interlaced or not."""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from struct import unpack

from sim.bitmap.pixels import BadPicture, Picture, checked_size, flags

_CHANNELS = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}
_PASSES = ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2))


def read(data: bytes) -> Picture:
    chunks = list(_chunks(data))
    if not chunks or chunks[0][0] != b"IHDR" or len(chunks[0][1]) != 13:
        raise BadPicture("png")
    width, height, depth, kind, _, _, interlaced = unpack(">IIBBBBB", chunks[0][1])
    checked_size(width, height)
    if kind not in _CHANNELS or depth not in (1, 2, 4, 8, 16):
        raise BadPicture("png")
    palette = next((body for name, body in chunks if name == b"PLTE"), b"")
    packed = b"".join(body for name, body in chunks if name == b"IDAT")
    raw = _inflated(packed, (width * _CHANNELS[kind] * depth // 8 + 16) * (height + 16) * 2)
    to_flags = _Flags(kind, depth, palette)
    if interlaced:
        return _interlaced(raw, width, height, to_flags)
    rows = tuple(to_flags.of(row, width) for row in _rows(raw, width, height, to_flags))
    return Picture(width, height, rows)


def _chunks(data: bytes) -> Iterator[tuple[bytes, bytes]]:
    position = 8
    while position + 8 <= len(data):
        length, name = unpack(">I4s", data[position : position + 8])
        yield name, data[position + 8 : position + 8 + length]
        position += length + 12


def _inflated(packed: bytes, limit: int) -> bytes:
    try:
        return zlib.decompressobj().decompress(packed, limit)
    except zlib.error:
        raise BadPicture("png") from None


class _Flags:
    """Turns the bytes of a row into solid flags."""

    def __init__(self, kind: int, depth: int, palette: bytes) -> None:
        self.bits = _CHANNELS[kind] * depth
        self._step = max(1, self.bits // 8)
        self._depth = depth
        self._levels = _levels(kind, depth, palette)

    def of(self, row: bytes, width: int) -> bytes:
        samples = row[:: self._step] if self.bits >= 8 else self._unpacked(row)
        return flags(samples[:width].translate(self._levels))

    def _unpacked(self, row: bytes) -> bytes:
        depth, mask = self._depth, (1 << self._depth) - 1
        shifts = range(8 - depth, -1, -depth)
        return bytes(byte >> shift & mask for byte in row for shift in shifts)


def _levels(kind: int, depth: int, palette: bytes) -> bytes:
    """The red level for every sample."""
    if kind == 3:
        reds = palette[::3]
        return reds + bytes(256 - len(reds))
    largest = (1 << min(depth, 8)) - 1
    return bytes(min(255, sample * 255 // largest) for sample in range(256))


def _interlaced(raw: bytes, width: int, height: int, to_flags: _Flags) -> Picture:
    rows = [bytearray(width) for _ in range(height)]
    position = 0
    for left, top, across, down in _PASSES:
        columns, lines = -(-(width - left) // across), -(-(height - top) // down)
        if columns < 1 or lines < 1:
            continue
        for i, row in enumerate(_rows(raw[position:], columns, lines, to_flags)):
            rows[top + i * down][left::across] = to_flags.of(row, columns)
        position += lines * (1 + (columns * to_flags.bits + 7) // 8)
    return Picture(width, height, tuple(bytes(row) for row in rows))


def _rows(raw: bytes, width: int, height: int, to_flags: _Flags) -> Iterator[bytes]:
    """The rows with their filters undone."""
    length, step = (width * to_flags.bits + 7) // 8, max(1, to_flags.bits // 8)
    before = bytes(length)
    for y in range(height):
        start = y * (length + 1)
        row = bytearray(raw[start + 1 : start + 1 + length])
        if len(row) != length:
            raise BadPicture("png")
        _unfilter(raw[start], row, before, step)
        before = bytes(row)
        yield before


def _unfilter(kind: int, row: bytearray, above: bytes, step: int) -> None:
    if kind == 1:
        for i in range(step, len(row)):
            row[i] = (row[i] + row[i - step]) & 255
    elif kind == 2:
        row[:] = bytes((a + b) & 255 for a, b in zip(row, above, strict=True))
    elif kind == 3:
        for i in range(len(row)):
            left = row[i - step] if i >= step else 0
            row[i] = (row[i] + (left + above[i]) // 2) & 255
    elif kind == 4:
        _unpaeth(row, above, step)
    elif kind != 0:
        raise BadPicture("png")


def _unpaeth(row: bytearray, above: bytes, step: int) -> None:
    for i in range(len(row)):
        a, c = (row[i - step], above[i - step]) if i >= step else (0, 0)
        b = above[i]
        to_a, to_b, to_c = abs(b - c), abs(a - c), abs(a + b - c - c)
        guess = a if to_a <= to_b and to_a <= to_c else b if to_b <= to_c else c
        row[i] = (row[i] + guess) & 255
