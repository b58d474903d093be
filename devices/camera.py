"""The camera of a real robot, and the coloured things in its pictures; also a camera made of picture files.

OpenCV is loaded when the first picture is searched: few start with a camera, and it is an extra. What a
picture shows is found as by the blob finder of the original robot: the pixels of a colour's range, without
specks, in areas that are large enough.
"""

from __future__ import annotations

import os
import re
import sys
import warnings
from collections.abc import Iterable, Mapping
from io import BytesIO
from math import atan, degrees, radians, tan
from types import ModuleType
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias

from msgspec import Struct

from devices.ports.robot import RobotProblem
from devices.serial_ports import is_named

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Picture: TypeAlias = NDArray[np.uint8]
    """Rows of pixels, each red, green and blue."""

ColourRange: TypeAlias = tuple[int, int, int, int, int, int]
"""The least and the most of hue (0 to 179), saturation and value (0 to 255), as OpenCV counts them. A least
hue above the most leads through 0, where red is."""

_MOST = 255
"""Of a saturation or a value."""
ORIGINAL_RANGES: Mapping[str, ColourRange] = {
    "red": (121, 11, 32, _MOST, 87, _MOST),
    "green": (56, 99, 169, _MOST, 17, _MOST),
    "blue": (90, 120, 32, _MOST, 48, _MOST),
}
"""From GenericBlobfinder.cc of github.com/lsa-pucrs/donnie-assistive-robot-sw (driver/genericblobfinder).

It has, with noise reduction, red 109-256 0-256 87-256, green 21-56 175-256 47-184, blue 0-30 32-256 48-256.
It takes the camera's blue for red, so its hue h is the hue 120 - h. Two limits differ, because they miss or
mistake common things: red needs the saturation of blue here (the original takes a wall in warm light for
red), and green has no most value (a thing in the sun is brighter than 184). Green is as wide as in its other
set, for pictures without noise reduction (21-64 169-256 17-169): pure green, 60, is not in the first one.
"""

VIEW = 60
"""Degrees from the left to the right border of a picture: those of the original robot's blob finder."""
FARTHEST_LOOK = 90
"""Degrees to either side that the head turns, and in which a thing counts."""

_WIDTH, _HEIGHT = 640, 480
"""Of the original's pictures."""
_SMALLEST = 500
"""Pixels of such a picture that a thing fills at least: ``min_blob_size`` of the original's settings."""
_SERVO = 3.0
"""Degrees by which the head may miss its angle."""
_STALE = 4
"""Pictures that a camera may have made before the head was turned."""

LARGEST_FILE = 20_000_000
MOST_PIXELS = 25_000_000
MOST_PICTURES = 1000
MOST_LAYERS = 100
"""Of a JPEG, which is decoded once for each of them: a camera makes some ten."""
_FORMATS = ("PNG", "JPEG", "PPM", "BMP", "GIF")
_SUFFIXES = (".png", ".jpg", ".jpeg", ".ppm", ".bmp", ".gif")
_SILENCE = {"OPENCV_LOG_LEVEL": "SILENT", "OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT": "3"}
"""Nothing but Donnie writes on the screen; and a camera that hangs is given up after three seconds."""


class Blob(Struct, frozen=True):
    """An area of one colour in a picture: its borders, in shares of the width and the height."""

    colour: str
    left: float
    right: float
    top: float = 0.0
    bottom: float = 1.0
    metres: float | None = None
    """To its nearest point, where the finder knows it."""

    @property
    def is_whole(self) -> bool:
        """Whether it ends within the picture on both sides."""
        return self.left > 0.0 and self.right < 1.0


class ColouredThing(Struct, frozen=True):
    """A thing that was seen, in degrees from the robot's front, positive to the right."""

    colour: str
    degrees: float
    low: float
    """The directions of its left and its right border."""
    high: float
    metres: float | None = None
    """As of its blobs."""


class FileAccess(Protocol):
    """Opens what a learner may name. Both raise ``OSError`` or ``ValueError``."""

    def names_in(self, folder: str) -> list[str]: ...

    def read(self, path: str, most: int) -> bytes: ...


class PictureSource(Protocol):
    """A camera on a head that turns."""

    def directions(self) -> tuple[int, ...]:
        """Where the head must turn to see all, from left to right. Raises ``RobotProblem``."""

    def picture(self, direction: int) -> Picture:
        """What is seen there now. Raises ``RobotProblem``."""

    def close(self) -> None: ...


class ColourCamera(Struct):
    """A camera, and the colours that are looked for in its pictures."""

    source: PictureSource
    ranges: Mapping[str, ColourRange]
    view: float

    @property
    def colours(self) -> frozenset[str]:
        return frozenset(self.ranges)

    def directions(self) -> tuple[int, ...]:
        """As of its source. Raises ``RobotProblem``, also without OpenCV."""
        _opencv()
        return self.source.directions()

    def look(self, direction: int) -> tuple[Blob, ...]:
        """Raises ``RobotProblem``."""
        return blobs_in(self.source.picture(direction), self.ranges)

    def close(self) -> None:
        self.source.close()


class CameraSweep:
    """The looks of one turn of the head. A fault is kept, and ends the looking, not the turn."""

    def __init__(self, camera: ColourCamera | None) -> None:
        self._camera = camera
        self._looks: list[tuple[int, tuple[Blob, ...]]] = []
        self.directions: tuple[int, ...] = ()
        """Where it must look, from left to right."""
        self.problem: RobotProblem | None = None
        try:
            self.directions = camera.directions() if camera is not None else ()
        except RobotProblem as problem:
            self.problem = problem

    @property
    def is_blind(self) -> bool:
        """Whether nothing is known of colours."""
        return self._camera is None or self.problem is not None

    def look(self, direction: int) -> None:
        """Does nothing if no picture is wanted, or after a fault."""
        if self._camera is None or self.problem is not None or direction not in self.directions:
            return
        try:
            self._looks.append((direction, self._camera.look(direction)))
        except RobotProblem as problem:
            self.problem = problem

    def things(self) -> tuple[ColouredThing, ...]:
        return () if self._camera is None else things_in(self._looks, self._camera.view)


def make_source(name: str, view: float, files: FileAccess) -> PictureSource:
    """``name``: the number of a camera, its device, or a picture or a folder of pictures."""
    if name.isdecimal() or name.startswith("/dev/"):
        return VideoCamera(name, view)
    return PictureFiles(name, files)


# --- in a picture


def _opencv() -> ModuleType:
    """Raises ``RobotProblem`` ``no-opencv`` without the extra."""
    for name, value in _SILENCE.items():
        os.environ.setdefault(name, value)
    try:
        import cv2
    except ImportError:
        raise RobotProblem("no-opencv") from None
    module: ModuleType = cv2
    return module


def _hsv(picture: Picture) -> Picture:
    cv2: Any = _opencv()
    height, width = picture.shape[:2]
    if width > _WIDTH:
        size = (_WIDTH, max(1, round(height * _WIDTH / width)))
        picture = cv2.resize(picture, size, interpolation=cv2.INTER_AREA)
    converted: Picture = cv2.cvtColor(picture, cv2.COLOR_RGB2HSV)
    return converted


def blobs_in(picture: Picture, ranges: Mapping[str, ColourRange]) -> tuple[Blob, ...]:
    """The areas of each colour, the colours in their order. Raises ``RobotProblem`` without OpenCV."""
    cv2: Any = _opencv()
    hsv = _hsv(picture)
    height, width = hsv.shape[:2]
    found: list[Blob] = []
    for colour, limits in ranges.items():
        # erased by 2 and widened by 3 pixels, as in the original
        mask = cv2.erode(_mask(hsv, limits), cv2.getStructuringElement(cv2.MORPH_RECT, (2, 2)))
        mask = cv2.dilate(mask, cv2.getStructuringElement(cv2.MORPH_RECT, (3, 3)))
        contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
        for contour in contours:
            if cv2.contourArea(contour) * _WIDTH * _HEIGHT >= _SMALLEST * width * height:
                x, y, w, h = cv2.boundingRect(contour)
                found.append(Blob(colour, x / width, (x + w) / width, y / height, (y + h) / height))
    return tuple(found)


def _mask(hsv: Picture, limits: ColourRange) -> Picture:
    cv2: Any = _opencv()
    low, high, *rest = limits
    parts = [(low, high)] if low <= high else [(low, 179), (0, high)]
    masks = [cv2.inRange(hsv, (first, rest[0], rest[2]), (last, rest[1], rest[3])) for first, last in parts]
    mask: Picture = masks[0] if len(masks) == 1 else cv2.bitwise_or(*masks)
    return mask


# --- from pictures to things


class _Glimpse(Struct, frozen=True):
    """A blob as one look shows it: its borders in degrees from the robot's front, and how well."""

    blob: Blob
    low: float
    high: float
    off_middle: float
    """Degrees from the middle of the picture."""

    def overlap(self, other: _Glimpse) -> float:
        """Degrees that both cover, 0 or less where they can't be one thing."""
        if self.blob.colour != other.blob.colour:
            return 0.0
        if self.blob.top >= other.blob.bottom or other.blob.top >= self.blob.bottom:
            return 0.0
        return min(self.high, other.high) - max(self.low, other.low) + _SERVO


def things_in(
    looks: Iterable[tuple[float, tuple[Blob, ...]]], view: float, *, is_even: bool = False
) -> tuple[ColouredThing, ...]:
    """Each thing once, from left to right.

    Two blobs of one picture are two things; those of neighbouring pictures are one where they overlap.
    ``is_even``: all columns are equally wide, as of a finder that turns, and not as of a lens.
    """
    angle = _even_angle if is_even else _angle
    found: list[list[_Glimpse]] = []
    for direction, blobs in looks:
        glimpses = [
            _glimpse(each, direction, (angle(each.left, view), angle(each.right, view))) for each in blobs
        ]
        pairs = [
            (overlap, index, glimpse)
            for index, thing in enumerate(found)
            for glimpse in glimpses
            if (overlap := max(each.overlap(glimpse) for each in thing)) > 0
        ]
        taken: set[int] = set()
        for _, index, glimpse in sorted(pairs, key=lambda pair: -pair[0]):
            if index not in taken and glimpse in glimpses:
                taken.add(index)
                glimpses.remove(glimpse)
                found[index].append(glimpse)
        found += [[each] for each in glimpses]
    things = sorted(map(_thing, found), key=lambda thing: thing.degrees)
    return tuple(each for each in things if abs(each.degrees) <= FARTHEST_LOOK + _SERVO)


def _glimpse(blob: Blob, direction: float, borders: tuple[float, float]) -> _Glimpse:
    low, high = borders
    return _Glimpse(blob, direction + low, direction + high, abs(low + high) / 2)


def _angle(share: float, view: float) -> float:
    """Degrees from the middle of the picture to a share of its width."""
    return degrees(atan((2 * share - 1) * tan(radians(view / 2))))


def _even_angle(share: float, view: float) -> float:
    return (share - 0.5) * view


def _thing(glimpses: list[_Glimpse]) -> ColouredThing:
    """As the picture shows it that has it whole and nearest to its middle, or else as all together."""
    whole = [each for each in glimpses if each.blob.is_whole]
    best = [min(whole, key=lambda each: each.off_middle)] if whole else glimpses
    low, high = min(each.low for each in best), max(each.high for each in best)
    metres = min((each.blob.metres for each in glimpses if each.blob.metres is not None), default=None)
    return ColouredThing(glimpses[0].blob.colour, (low + high) / 2, low, high, metres)


# --- measuring a colour

_COLOURFUL, _BRIGHT = 40, 40
"""Saturation and value of a pixel that has a hue."""
_WIDEST_HUE = 20.0
"""Hues to either side of the mean that one colour can have in one light."""
_MARGINS = (6, 40, 50)
"""By which the range is wider than what was measured: hue, saturation, value."""


def measured_range(picture: Picture) -> ColourRange | None:
    """The range of the colour in the middle third of a picture; None if there is not one colour.

    Raises ``RobotProblem`` without OpenCV.
    """
    import numpy as np

    hsv = _hsv(picture)
    height, width = hsv.shape[:2]
    middle = hsv[height // 3 : height - height // 3, width // 3 : width - width // 3].reshape(-1, 3)
    colourful = middle[(middle[:, 1] >= _COLOURFUL) & (middle[:, 2] >= _BRIGHT)].astype(np.float64)
    if len(colourful) < 0.6 * len(middle):
        return None
    turns = np.exp(2j * np.pi * colourful[:, 0] / 180)
    mean = float(np.angle(turns.mean())) * 90 / np.pi
    off = (colourful[:, 0] - mean + 90) % 180 - 90
    first, last = (float(each) for each in np.percentile(off, (10, 90)))
    if last - first > 2 * _WIDEST_HUE:
        return None
    saturation, value = (float(np.percentile(colourful[:, each], 10)) for each in (1, 2))
    hue_margin, saturation_margin, value_margin = _MARGINS
    return (
        round(mean + first - hue_margin) % 180,
        round(mean + last + hue_margin) % 180,
        max(_COLOURFUL, round(saturation) - saturation_margin),
        _MOST,
        max(_BRIGHT, round(value) - value_margin),
        _MOST,
    )


def do_overlap(one: ColourRange, other: ColourRange) -> bool:
    """Whether some hue is in both ranges."""
    return bool(_hues(one) & _hues(other))


def _hues(limits: ColourRange) -> set[int]:
    low, high = limits[:2]
    return {hue % 180 for hue in range(low, high + (1 if low <= high else 181))}


# --- cameras


class VideoCamera:
    """A camera of this computer. It is opened for the first picture, and again after it was lost."""

    def __init__(self, name: str, view: float) -> None:
        self._name = f"/dev/video{int(name)}" if name.isdecimal() else name
        self._view = view
        self._capture: Any = None

    def directions(self) -> tuple[int, ...]:
        """Every 30 degrees, as in the original; every 15 where pictures are too narrow for that."""
        if not is_named(self._name):
            raise RobotProblem("port-not-named", port=self._name)
        if sys.platform.startswith("linux") and not os.path.exists(self._name):  # noqa: PTH110 -- a device
            self.close()
            raise RobotProblem("no-port", port=self._name)
        stride = 30 if self._view >= 45 else 15
        return tuple(range(-FARTHEST_LOOK, FARTHEST_LOOK + 1, stride))

    def picture(self, direction: int) -> Picture:  # noqa: ARG002 -- it looks where the head looks
        cv2: Any = _opencv()
        capture = self._opened(cv2)
        frame: Any = None
        try:
            for _ in range(1 + _STALE):
                is_there, frame = capture.read()
                if not is_there:
                    raise self._failed()
            converted: Picture = cv2.cvtColor(frame, cv2.COLOR_BGR2RGB)
        except cv2.error:
            raise self._failed() from None
        return converted

    def _failed(self) -> RobotProblem:
        """The next look opens it again."""
        self.close()
        return RobotProblem("camera-failed", camera=self._name)

    def _opened(self, cv2: Any) -> Any:
        if self._capture is None:
            self.directions()
            if not os.access(self._name, os.R_OK | os.W_OK) and sys.platform.startswith("linux"):
                raise RobotProblem("no-permission", port=self._name)
            number = re.fullmatch(r"/dev/video(\d+)", self._name)
            linux = cv2.CAP_V4L2 if sys.platform.startswith("linux") else cv2.CAP_ANY
            capture = cv2.VideoCapture(int(number[1]) if number else self._name, linux)
            capture.set(cv2.CAP_PROP_FRAME_WIDTH, _WIDTH)
            capture.set(cv2.CAP_PROP_FRAME_HEIGHT, _HEIGHT)
            self._capture = capture
        return self._capture

    def close(self) -> None:
        capture, self._capture = self._capture, None
        if capture is not None:
            capture.release()


class PictureFiles:
    """A camera made of a picture, or of a folder of pictures.

    A picture whose name is a number with a sign, ``-90.png`` to ``+90.png``, is what is seen when the head
    looks there. Of the others, one after the other is what is seen straight ahead, a look each; then again.
    """

    def __init__(self, path: str, files: FileAccess) -> None:
        self._path = path
        self._files = files
        self._looks = 0
        self._ahead: list[str] = []
        self._aside: dict[int, str] = {}

    def directions(self) -> tuple[int, ...]:
        names = self._names()
        self._aside = {direction: each for each in names if (direction := _direction(each)) is not None}
        self._ahead = [each for each in names if _direction(each) is None]
        if not names:
            raise RobotProblem("no-pictures", path=self._path)
        return tuple(sorted({*self._aside, *([0] if self._ahead else [])}))

    def picture(self, direction: int) -> Picture:
        path = self._aside.get(direction)
        if path is None and not self._ahead:
            raise RobotProblem("no-pictures", path=self._path)
        if path is None:
            path = self._ahead[self._looks % len(self._ahead)]
            self._looks += 1
        return read_picture(path, self._files)

    def close(self) -> None:
        """Nothing is open."""

    def _names(self) -> list[str]:
        """The paths of the pictures in their order; the path itself where it is no folder."""
        try:
            names = self._files.names_in(self._path)
        except NotADirectoryError:
            return [self._path]
        except (OSError, ValueError) as problem:
            raise _unreadable(self._path, problem) from None
        pictures = [each for each in names if each.lower().endswith(_SUFFIXES) and not each.startswith(".")]
        if len(pictures) > MOST_PICTURES:
            raise RobotProblem("too-many-pictures", path=self._path, limit=MOST_PICTURES)
        return [os.path.join(self._path, each) for each in sorted(pictures, key=_in_order)]  # noqa: PTH118


def _in_order(name: str) -> list[int | str]:
    """2.png comes before 10.png. A text comes first, so equal places have equal types."""
    return [int(each) if each.isdecimal() else each for each in re.split(r"(\d+)", name.lower())]


def _direction(path: str) -> int | None:
    stem = os.path.splitext(os.path.basename(path))[0]  # noqa: PTH119, PTH122
    if re.fullmatch(r"[+-][0-9]{1,2}", stem) is None:
        return None
    return int(stem) if abs(int(stem)) <= FARTHEST_LOOK else None


def read_picture(path: str, files: FileAccess) -> Picture:
    """Raises ``RobotProblem``: it can't be read, is no picture, or too large. Decoded once that is known."""
    import numpy as np
    from PIL import Image, ImageOps

    too_large = RobotProblem("picture-too-large", path=path, limit=MOST_PIXELS // 1_000_000)
    try:
        data = files.read(path, LARGEST_FILE + 1)
    except (OSError, ValueError) as problem:
        raise _unreadable(path, problem) from None
    if len(data) > LARGEST_FILE:
        raise too_large
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with Image.open(BytesIO(data), formats=_FORMATS) as image:
                if image.width * image.height > MOST_PIXELS:
                    raise too_large
                if image.format == "JPEG" and data.count(b"\xff\xda") > MOST_LAYERS:
                    raise too_large
                image.draft(None, (_WIDTH, _HEIGHT))
                upright = ImageOps.exif_transpose(image)  # as a phone was held
                return np.asarray(upright.convert("RGB"), dtype=np.uint8)
    except Image.DecompressionBombError:
        raise too_large from None
    except RobotProblem:
        raise
    except Exception:  # noqa: BLE001 -- Pillow raises nearly anything at damaged bytes
        raise RobotProblem("no-picture", path=path) from None


def _unreadable(path: str, problem: Exception) -> RobotProblem:
    if isinstance(problem, FileNotFoundError):
        return RobotProblem("picture-missing", path=path)
    reason = getattr(problem, "strerror", None) or str(problem)
    is_refused = hasattr(problem, "code")  # the confinement's own
    return RobotProblem("picture-outside" if is_refused else "picture-unreadable", path=path, reason=reason)
