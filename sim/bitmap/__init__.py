"""Pictures as floor plans: a file's dark pixels as rectangles. Standard library only."""

from sim.bitmap.files import read_picture
from sim.bitmap.pixels import BadPicture, Picture
from sim.bitmap.rectangles import Rectangle, rectangles

__all__ = ["BadPicture", "Picture", "Rectangle", "read_picture", "rectangles"]
