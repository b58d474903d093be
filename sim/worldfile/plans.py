"""Pictures that a world names: found, read once each, and made into polygons."""

from __future__ import annotations

from pathlib import Path

from devices.ports.values import Frozen
from sim.bitmap import BadPicture, Picture, count_outlines, read_picture, rectangles
from sim.notes import NoteKind
from sim.scene import Polygon
from sim.worldfile.entities import Setting
from sim.worldfile.mistakes import Code
from sim.worldfile.reader import LARGEST_FILE, FileReader
from sim.worldfile.shapes import rectangle
from sim.worldfile.values import ValueReader, mistake


class Plan(Frozen):
    """The solid part of a picture, in pixels, y upwards; margins are left for the fitting to crop."""

    polygons: tuple[Polygon, ...]
    outlines: int
    """How many polygons Stage makes of it."""


NOTHING = Plan((), 0)
KINDS = ("PNG", "JPEG", "PGM", "PPM", "BMP", "GIF")
MOST_RECTANGLES = 25_000


class Plans:
    """The pictures of one world."""

    def __init__(self, reader: FileReader, values: ValueReader) -> None:
        self._reader = reader
        self._values = values
        self._traced: dict[Path, Plan] = {}

    def plan(self, setting: Setting) -> Plan:
        """The solid pixels of the picture that ``setting`` names."""
        name = self._values.string({"bitmap": setting}, "bitmap", "")
        path = self._path(setting, name)
        if path not in self._traced:
            self._reader.pictures.append(str(path))
            self._traced[path] = self._trace(setting, path, name)
        return self._traced[path]

    def _path(self, setting: Setting, name: str) -> Path:
        path = self._reader.find(name, Path(setting.file))
        if path is None:
            raise mistake(Code.BITMAP_NOT_FOUND, setting, path=name[:200])
        if not self._reader.is_allowed(path):
            raise mistake(Code.BITMAP_OUTSIDE, setting, path=name[:200])
        return path.resolve()

    def _trace(self, setting: Setting, path: Path, name: str) -> Plan:
        picture = self._picture(setting, path, name)
        solid = list(rectangles(picture))
        if len(solid) > MOST_RECTANGLES:
            raise mistake(Code.TOO_MUCH, setting, limit=MOST_RECTANGLES)
        height = picture.height
        polygons = tuple(
            rectangle(left, height - bottom, right - left, bottom - top) for left, top, right, bottom in solid
        )
        if solid and not _fills(picture):
            self._values.note(NoteKind.REPAIRED, "margin-cropped", setting, path=name)
        outlines = count_outlines(picture)
        return Plan(polygons, len(polygons) if outlines is None else outlines)

    def _picture(self, setting: Setting, path: Path, name: str) -> Picture:
        try:
            with path.open("rb") as stream:
                return read_picture(stream.read(LARGEST_FILE))
        except (OSError, BadPicture):
            raise mistake(Code.BITMAP_UNREADABLE, setting, KINDS, path=name[:200]) from None


def _fills(picture: Picture) -> bool:
    """Whether the solid pixels reach all four borders."""
    sides = (picture.rows[0], picture.rows[-1])
    ends = [(row[0], row[-1]) for row in picture.rows]
    return all(any(side) for side in (*sides, [end[0] for end in ends], [end[1] for end in ends]))
