"""Bytes of a PNG, PGM, PPM, BMP or GIF in, solid pixels out."""

from __future__ import annotations

from collections.abc import Callable

from sim.bitmap import bmp, gif, png, pnm
from sim.bitmap.pixels import BadPicture, Picture


def read_picture(data: bytes) -> Picture:
    """The solid pixels of a picture file. BadPicture if it can't be read."""
    readers: tuple[tuple[bytes, Callable[[bytes], Picture]], ...] = (
        (b"\x89PNG\r\n\x1a\n", png.read),
        (b"BM", bmp.read),
        (b"GIF8", gif.read),
        (b"P", pnm.read),
    )
    for signature, read in readers:
        if data.startswith(signature):
            try:
                return read(data)
            except (IndexError, ValueError, EOFError):
                raise BadPicture("broken") from None
    raise BadPicture("kind")
