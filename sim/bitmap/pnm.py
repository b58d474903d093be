"""PGM and PPM, as text or as bytes, with up to 255 levels."""

from __future__ import annotations

import re

from sim.bitmap.pixels import BadPicture, Picture, checked_size, flags

_HEADER = re.compile(rb"P([2356])" + rb"(?:\s+(?:#[^\n]*\n\s*)*([0-9]{1,9}))" * 3 + rb"\s")


def read(data: bytes) -> Picture:
    header = _HEADER.match(data)
    if header is None:
        raise BadPicture("pnm")
    kind, width, height, largest = (int(group) for group in header.groups())
    checked_size(width, height)
    if not 1 <= largest <= 255:
        raise BadPicture("pnm")
    channels = 3 if kind in (3, 6) else 1
    count = width * height * channels
    body = data[header.end() :]
    samples = body[:count] if kind in (5, 6) else _numbers(body, count)
    if len(samples) < count:
        raise BadPicture("pnm")
    reds = samples[::channels].translate(bytes(min(255, i * 255 // largest) for i in range(256)))
    rows = (reds[y * width : (y + 1) * width] for y in range(height))
    return Picture(width, height, tuple(flags(row) for row in rows))


def _numbers(body: bytes, count: int) -> bytes:
    words = re.sub(rb"#[^\n]*", b"", body).split(None, count)[:count]
    return bytes(int(word) for word in words)
