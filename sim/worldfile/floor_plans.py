"""Pictures that a world names as floor plans: found, read once each, and made into polygons.

Stage's rule: a pixel is solid when its red channel is at most 127; alpha does not count. No other module of
``sim`` knows Pillow.

Stage counts the polygons that it makes of a picture: it follows the borders of the dark pixels until each is
closed. Where two dark pixels touch at a corner only, it follows the border that it sorts first, so that some
borders become one polygon and others two. ``count_outlines`` follows them in the same order.
"""

from __future__ import annotations

import re
import struct
import warnings
import zlib
from collections.abc import Iterable, Iterator
from io import BytesIO
from itertools import islice
from math import ceil
from pathlib import Path
from typing import NamedTuple

from msgspec import Struct
from PIL import Image

from donnie_tui.process.confinement import open_bytes
from sim.scene import NoteKind, Polygon
from sim.worldfile.entities import FileReader, Setting, resolved
from sim.worldfile.mistakes import Code
from sim.worldfile.values import ValueReader, mistake, named_file

_SET = re.compile(b"\1")

MOST_EDGES = 200_000
"""Beyond it (a picture full of dots) outlines are not counted."""


def count_outlines(picture: Bitmap) -> int | None:
    """The number of polygons, holes included; None if the borders are too long to follow."""
    leaving: dict[tuple[int, int], list[tuple[int, int]]] = {}
    for i, (start, end) in enumerate(_borders(picture)):
        if i == MOST_EDGES:
            return None
        leaving.setdefault(start, []).append(end)
    for ends in leaving.values():
        ends.sort(reverse=True)
    return sum(1 for start in sorted(leaving) for _ in _followed(leaving, start))


def _followed(
    leaving: dict[tuple[int, int], list[tuple[int, int]]], start: tuple[int, int]
) -> Iterator[None]:
    """One turn for each border that is followed from ``start`` until nothing leads on."""
    while start in leaving:
        at = start
        while (ends := leaving.get(at)) is not None:
            following = ends.pop()
            if not ends:
                del leaving[at]
            at = following
        yield


def _borders(picture: Bitmap) -> Iterator[tuple[tuple[int, int], tuple[int, int]]]:
    """The edges between dark and light pixels, clockwise round the dark, y downwards."""
    empty = bytes(picture.width)
    rows = (empty, *picture.rows, empty)
    for y in range(picture.height + 1):
        above, below = rows[y], rows[y + 1]
        if above != below:
            yield from _level(above, below, y)
        if y < picture.height and any(below):
            yield from _upright(below, y)


def _level(above: bytes, below: bytes, y: int) -> Iterator[tuple[tuple[int, int], tuple[int, int]]]:
    for x in _differences(above, below):
        yield ((x, y), (x + 1, y)) if below[x] else ((x + 1, y), (x, y))


def _upright(row: bytes, y: int) -> Iterator[tuple[tuple[int, int], tuple[int, int]]]:
    left, right = b"\0" + row, row + b"\0"
    for x in _differences(left, right):
        yield ((x, y), (x, y + 1)) if left[x] else ((x, y + 1), (x, y))


def _differences(one: bytes, other: bytes) -> Iterator[int]:
    """The places where two rows differ; found without a look at every pixel."""
    both = int.from_bytes(one) ^ int.from_bytes(other)
    return (match.start() for match in _SET.finditer(both.to_bytes(len(one))))


_RUN = re.compile(b"\x01+")


class Rectangle(NamedTuple):
    """A rectangle in pixels, y downwards; the right and bottom borders belong to the next pixel."""

    left: int
    top: int
    right: int
    bottom: int


def rectangles(rows: Iterable[bytes]) -> Iterator[Rectangle]:
    """The solid area of a picture, whose rows have 1 there, without gaps and overlaps."""
    growing: dict[tuple[int, int], int] = {}
    for y, row in enumerate((*rows, b"")):
        runs = {match.span() for match in _RUN.finditer(row)}
        for (left, right), top in [item for item in growing.items() if item[0] not in runs]:
            del growing[left, right]
            yield Rectangle(left, top, right, y)
        for run in sorted(runs):
            growing.setdefault(run, y)


class Plan(Struct, frozen=True):
    """The solid part of a picture, in pixels, y upwards; margins are left for the fitting to crop."""

    polygons: tuple[Polygon, ...]
    outlines: int
    """How many polygons Stage makes of it."""


NOTHING = Plan((), 0)
MOST_RECTANGLES = 50_000
USUAL_RESOLUTION = 0.02
"""Metres: a cell of Stage's grid."""


class Plans:
    """The pictures of one world."""

    def __init__(self, reader: FileReader, values: ValueReader, resolution: float) -> None:
        """``resolution``: metres, what the world calls so: a cell of Stage's grid."""
        self._reader = reader
        self._values = values
        self._resolution = resolution
        self._traced: dict[Path, Plan] = {}
        self._pixels = 0

    def plan(self, setting: Setting, size: tuple[float, float, float]) -> Plan:
        """The solid pixels of the picture that ``setting`` names, for a model of ``size``.

        None, and a warning, where it is ``""``, as in Stage, whose manual gives that as the default.
        """
        name = self._values.string({"bitmap": setting}, "bitmap", "")
        if not name:
            self._values.note(NoteKind.WARNING, "empty-bitmap", setting)
            return NOTHING
        path = resolved(named_file(self._reader, setting, name, Code.BITMAP_NOT_FOUND, Code.BITMAP_OUTSIDE))
        if path not in self._traced:
            self._reader.pictures.append(str(path))
            self._traced[path] = self._trace(setting, path, name, min(size[:2]))
        return self._traced[path]

    def _trace(self, setting: Setting, path: Path, name: str, side: float) -> Plan:
        picture, solid = self._simplified(self._picture(setting, path, name), setting, name, side)
        height = picture.height
        polygons = tuple(
            rectangle(left, height - bottom, right - left, bottom - top) for left, top, right, bottom in solid
        )
        if solid and not _fills(picture):
            self._values.note(NoteKind.REPAIRED, "margin-cropped", setting, path=name)
        outlines = count_outlines(picture)
        return Plan(polygons, len(polygons) if outlines is None else outlines)

    def _simplified(
        self, fine: Bitmap, setting: Setting, name: str, side: float
    ) -> tuple[Bitmap, list[Rectangle]]:
        """A plan of too many rectangles in the cells of Stage's grid, else in large enough squares."""
        pixels = min(fine.width, fine.height)
        grid = int(self._resolution / side * pixels) if side > 0 else 1
        picture, cell = fine, 1
        while len(solid := list(islice(rectangles(picture.rows), MOST_RECTANGLES + 1))) > MOST_RECTANGLES:
            cell = max(2 * cell, grid) if cell == 1 else 2 * cell
            picture = scaled_down(fine, cell)
        if 1 < cell <= grid:
            self._values.note(NoteKind.REPAIRED, "plan-scaled", setting, path=name)
        elif cell > 1:
            centimetres = str(ceil(100 * side * cell / pixels))
            self._values.note(NoteKind.WARNING, "plan-coarse", setting, path=name, centimetres=centimetres)
        return picture, solid

    def _picture(self, setting: Setting, path: Path, name: str) -> Bitmap:
        try:
            with open_bytes(path) as stream:
                data = stream.read(LARGEST_PICTURE + 1)
            if len(data) > LARGEST_PICTURE:
                raise mistake(Code.FILE_TOO_LARGE, setting, path=name[:200], limit=LARGEST_PICTURE)
            picture = read_bitmap(data, room=MOST_PIXELS_OF_ALL - self._pixels)
        except OSError as problem:
            reason = problem.strerror or str(problem)
            raise mistake(Code.FILE_UNREADABLE, setting, path=name[:200], reason=reason) from None
        except OversizedBitmapError as large:
            raise mistake(large.code, setting, given=large.given, limit=large.limit) from None
        except DamagedBitmapError:
            raise mistake(Code.BITMAP_DAMAGED, setting, path=name[:200]) from None
        except UnreadableBitmapError:
            raise mistake(Code.BITMAP_UNREADABLE, setting, PICTURE_FORMATS, path=name[:200]) from None
        self._pixels += picture.width * picture.height
        return picture


def _fills(picture: Bitmap) -> bool:
    """Whether the solid pixels reach all four borders."""
    sides = (picture.rows[0], picture.rows[-1])
    ends = [(row[0], row[-1]) for row in picture.rows]
    return all(any(side) for side in (*sides, [end[0] for end in ends], [end[1] for end in ends]))


# --- pictures

LARGEST_PICTURE = 100_100_000
"""Bytes: a PGM has one for each pixel."""
MOST_PIXELS = 100_000_000
"""The memory for them is some 700 MB for a moment if they are coloured, 300 MB if not."""
MOST_PIXELS_OF_ALL = 120_000_000
"""Of the pictures of one world."""
MOST_LAYERS = 100
"""Of a JPEG, which is decoded once for each of them: a camera makes some ten."""
DARK = 127

_JPEG = b"\xff\xd8"
_JPEG_LAYER = b"\xff\xda"
"""The marker of a scan; it does not occur in the data of one."""
_FLAGS = bytes(1 if level <= DARK else 0 for level in range(256))


class UnreadableBitmapError(Exception):
    """Bytes that are no picture of a kind that is read here, or one that is broken or too large."""


class DamagedBitmapError(UnreadableBitmapError):
    """A picture of a known kind that ends too early, or has bytes that can't be."""


class OversizedBitmapError(UnreadableBitmapError):
    """A picture beyond a limit. ``given``: what it has of it."""

    def __init__(self, code: Code, given: int, limit: int) -> None:
        super().__init__(code.value)
        self.code = code
        self.given = given
        self.limit = limit


class Bitmap(Struct, frozen=True):
    """Which pixels of a picture are solid."""

    width: int
    height: int
    rows: tuple[bytes, ...]
    """From the top; a byte a pixel, 1 where it is solid."""


def scaled_down(picture: Bitmap, cell: int) -> Bitmap:
    """One pixel in place of ``cell`` times ``cell``, solid where one of them is, as a cell of the grid."""
    width, height = -(-picture.width // cell), -(-picture.height // cell)
    padding = bytes(width * cell - picture.width)

    def row(y: int) -> bytes:
        joined = 0
        for each in set(picture.rows[y * cell : (y + 1) * cell]):
            joined |= int.from_bytes(each + padding)
        wide = joined.to_bytes(width * cell)
        narrow = 0
        for x in range(cell):
            narrow |= int.from_bytes(wide[x::cell])
        return narrow.to_bytes(width)

    return Bitmap(width, height, tuple(map(row, range(height))))


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
)
"""What Pillow raises at bytes that are no picture, or a damaged one."""


def read_bitmap(data: bytes, room: int = MOST_PIXELS_OF_ALL) -> Bitmap:
    """The solid pixels of a picture file.

    UnreadableBitmapError if it can't be read, OversizedBitmapError if it is too large or has more than
    ``room`` pixels. Nothing is decoded before its size is known.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            return _picture(data, room)
    except Image.DecompressionBombError as bomb:
        raise OversizedBitmapError(Code.BITMAP_TOO_LARGE, _pixels_in(bomb), MOST_PIXELS) from None
    except _DAMAGED:
        raise UnreadableBitmapError from None


def _pixels_in(bomb: Image.DecompressionBombError) -> int:
    """Pillow refuses huge pictures before it says their size anywhere else."""
    found = re.search(r"\d+", str(bomb))
    return int(found[0]) if found else MOST_PIXELS + 1


def _picture(data: bytes, room: int) -> Bitmap:
    with Image.open(BytesIO(data), formats=[each for each in PICTURE_FORMATS if each != "PGM"]) as image:
        width, height = image.size
        if width * height > MOST_PIXELS:
            raise OversizedBitmapError(Code.BITMAP_TOO_LARGE, width * height, MOST_PIXELS)
        if width * height > room:
            given = MOST_PIXELS_OF_ALL - room + width * height
            raise OversizedBitmapError(Code.BITMAPS_TOO_LARGE, given, MOST_PIXELS_OF_ALL)
        layers = data.count(_JPEG_LAYER) if data.startswith(_JPEG) else 1
        if layers > MOST_LAYERS:
            raise OversizedBitmapError(Code.BITMAP_TOO_MANY_LAYERS, layers, MOST_LAYERS)
        try:
            reds = memoryview(_red_channel(image).tobytes())
        except _DAMAGED:
            raise DamagedBitmapError from None
    rows: dict[bytes, bytes] = {}
    """Of rows that are alike, and most of a plan are, one is kept."""
    found = (flags(bytes(reds[y * width : (y + 1) * width])) for y in range(height))
    return Bitmap(width, height, tuple(rows.setdefault(row, row) for row in found))


def _red_channel(image: Image.Image) -> Image.Image:
    if image.mode.startswith("I"):  # 16 bits a pixel, grey
        return image.convert("I").point(lambda level: level / 256).convert("L")
    if image.mode in ("1", "L"):
        return image.convert("L")
    return (image if image.mode in ("RGB", "RGBA") else image.convert("RGB")).getchannel("R")


def rectangle(x: float, y: float, width: float, depth: float, top: float = 1.0) -> Polygon:
    """A block between (x, y) and the corner opposite."""
    return Polygon(((x, y), (x + width, y), (x + width, y + depth), (x, y + depth)), 0.0, top)
