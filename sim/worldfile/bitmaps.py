"""Bytes of a picture file in, solid pixels out. The only module that knows Pillow.

Stage's rule: a pixel is solid when its red channel is at most 127; alpha does not count.
"""

from __future__ import annotations

import struct
import warnings
import zlib
from io import BytesIO

from msgspec import Struct
from PIL import Image

MOST_PIXELS = 4_000_000
DARK = 127

_FLAGS = bytes(1 if level <= DARK else 0 for level in range(256))


class UnreadableBitmapError(Exception):
    """Bytes that are no picture of a kind that is read here, or one that is broken or too large."""


class Bitmap(Struct, frozen=True):
    """Which pixels of a picture are solid."""

    width: int
    height: int
    rows: tuple[bytes, ...]
    """From the top; a byte a pixel, 1 where it is solid."""


def flags(reds: bytes) -> bytes:
    """Red levels, a byte each, as solid flags."""
    return reds.translate(_FLAGS)


PICTURE_FORMATS = ("PNG", "JPEG", "PGM", "PPM", "BMP", "GIF")
"""Pillow reads PGM as PPM, and does not know the name PGM."""

_DAMAGED = (
    OSError,
    SyntaxError,
    ValueError,
    TypeError,
    EOFError,
    IndexError,
    OverflowError,
    MemoryError,
    struct.error,
    zlib.error,
    Image.DecompressionBombError,
    Image.DecompressionBombWarning,
)
"""What Pillow raises at bytes that are no picture, or a damaged one."""


def read_bitmap(data: bytes) -> Bitmap:
    """The solid pixels of a picture file. UnreadableBitmapError if it can't be read."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", Image.DecompressionBombWarning)
            return _picture(data)
    except _DAMAGED:
        raise UnreadableBitmapError from None


def _picture(data: bytes) -> Bitmap:
    with Image.open(BytesIO(data), formats=[each for each in PICTURE_FORMATS if each != "PGM"]) as image:
        width, height = image.size
        if width * height > MOST_PIXELS:
            raise UnreadableBitmapError
        reds = _red_channel(image).tobytes()
    return Bitmap(width, height, tuple(flags(reds[y * width : (y + 1) * width]) for y in range(height)))


def _red_channel(image: Image.Image) -> Image.Image:
    if image.mode.startswith("I"):  # 16 bits a pixel, grey
        return image.convert("I").point(lambda level: level / 256).convert("L")
    return image.convert("RGB").getchannel("R")
