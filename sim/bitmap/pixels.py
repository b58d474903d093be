"""A picture as a floor plan has it: which pixels are dark.

Stage's rule: a pixel is solid when its red channel is at most 127; alpha does not count.
"""

from __future__ import annotations

from devices.ports.values import Frozen

MOST_PIXELS = 4_000_000
DARK = 127

_FLAGS = bytes(1 if level <= DARK else 0 for level in range(256))


class BadPicture(Exception):
    """Bytes that are no picture of a kind that is read here, or one that is broken or too large."""


class Picture(Frozen):
    width: int
    height: int
    rows: tuple[bytes, ...]
    """From the top; a byte a pixel, 1 where it is solid."""


def flags(reds: bytes) -> bytes:
    """Red levels, a byte each, as solid flags."""
    return reds.translate(_FLAGS)
