"""Pictures as floor plans: a file's dark pixels as rectangles."""

from sim.bitmap.outlines import count_outlines
from sim.bitmap.pixels import BadPicture, Picture
from sim.bitmap.rectangles import Rectangle, rectangles

__all__ = ["BadPicture", "Picture", "Rectangle", "count_outlines", "read_picture", "rectangles"]


def read_picture(data: bytes) -> Picture:
    """The solid pixels of a picture file. BadPicture if it can't be read."""
    from sim.bitmap import decoder  # Pillow is loaded for worlds that have a picture only

    return decoder.read_picture(data)
