"""Bytes of a picture file in, solid pixels out. The only module that knows Pillow."""

from __future__ import annotations

import struct
import warnings
import zlib
from io import BytesIO

from PIL import Image

from sim.bitmap.pixels import MOST_PIXELS, BadPicture, Picture, flags

KINDS = ("PNG", "JPEG", "BMP", "PPM", "GIF")
"""Pillow's names; PPM is its name for PGM too."""

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


def read_picture(data: bytes) -> Picture:
    """The solid pixels of a picture file. BadPicture if it can't be read."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", Image.DecompressionBombWarning)
            return _picture(data)
    except _DAMAGED:
        raise BadPicture from None


def _picture(data: bytes) -> Picture:
    with Image.open(BytesIO(data), formats=KINDS) as image:
        width, height = image.size
        if width * height > MOST_PIXELS:
            raise BadPicture
        reds = _red_channel(image).tobytes()
    return Picture(width, height, tuple(flags(reds[y * width : (y + 1) * width]) for y in range(height)))


def _red_channel(image: Image.Image) -> Image.Image:
    if image.mode.startswith("I"):  # 16 bits a pixel, grey
        return image.convert("I").point(lambda level: level / 256).convert("L")
    return image.convert("RGB").getchannel("R")
