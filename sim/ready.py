"""Scenes of the worlds that ship, made beforehand: to read one needs neither the parser nor pictures.

Beside ``maze.world`` lies ``maze.scene``. It is used only as long as every file that it was made from is what
it was then; whoever edits a world sees the edited one.

A scene is kept as rows, each the plain contents of one value, of which the last is the scene. A row names the
values inside of its own by their numbers, and equal ones are kept once. What the classes were called and had
is kept as well: a scene of other ones than ours are now is none, and neither is one that is damaged.
"""

from __future__ import annotations

import marshal
import os
from collections.abc import Callable, Iterable, Sequence
from enum import Enum

from devices.ports.hints import Any
from devices.ports.values import replace
from sim.colours import Colour
from sim.fittings import (
    Blobfinder,
    Bumper,
    Camera,
    Drive,
    FiducialFinder,
    Gripper,
    Limits,
    Localization,
    OdometryError,
    RangeNoise,
    RangeSensor,
    Wheels,
)
from sim.placement import Placement
from sim.scene import LoadReport, Model, Polygon, Scene

SUFFIX = ".scene"

_KINDS: dict[str, Any] = {
    kind.__name__: kind
    for kind in (
        *(Scene, LoadReport, Model, Polygon, Placement, Colour, Wheels, Drive, Localization),
        *(
            Limits,
            OdometryError,
            RangeSensor,
            RangeNoise,
            Blobfinder,
            FiducialFinder,
            Bumper,
            Camera,
            Gripper,
        ),
    )
}
"""All that a scene is made of, but for notes."""
_NOTES = ("Note", "NoteKind")
_FORM = 2
"""Of marshal: one that every Python reads, and that is the same bytes for the same contents."""
_SUM = 4
"""Bytes in front that tell whether the rest is whole."""
_PRIME = (1 << 30) - 35

_Inner = tuple[int, int | Sequence[int]]
"""Where in a row a value stands, or several as a tuple, and which ones."""
_Row = tuple[int, list[Any], Sequence[_Inner]]
"""Of which class, and its contents, plain or still to be put there."""


def read(world: str) -> Scene | None:
    """The scene that was made of our world file; None if there is none, or none that fits any more."""
    folder = _folder_of(world)
    try:
        kept = _bytes_of(beside(world))
        if int.from_bytes(kept[:_SUM]) != _sum(kept[_SUM:]):
            return None
        sources, kinds, rows = marshal.loads(kept[_SUM:])
        is_fresh = all(_sum(_bytes_of(f"{folder}/{name}")) == sum_ for name, sum_ in sources)
        if not is_fresh or any(names != _names(_kind(kind)) for kind, names in kinds):
            return None
        scene = _put_together(rows, [_kind(kind) for kind, _ in kinds])
    except (OSError, EOFError, ValueError, TypeError, LookupError):
        return None
    return _placed(scene, lambda name: os.path.normpath(f"{folder}/{name}"))


def made(world: str, scene: Scene) -> bytes:
    """What ``maze.scene`` must hold for the world that was read from ``maze.world``."""
    folder = _folder_of(world)
    relative = _placed(scene, lambda file: os.path.relpath(file, folder).replace(os.sep, "/"))
    report = relative.report
    sources = tuple(
        (name, _sum(_bytes_of(f"{folder}/{name}"))) for name in _sources(report.files, report.pictures)
    )
    apart = _Apart()
    apart.add(relative)
    kept = marshal.dumps((sources, tuple(apart.kinds.items()), apart.rows), _FORM)
    return _sum(kept).to_bytes(_SUM) + kept


def _sum(content: bytes) -> int:
    """The content as one number, modulo a prime: as sure as a CRC that it is another after any change."""
    return int.from_bytes(b"\1" + content) % _PRIME


def _kind(name: str) -> Any:
    """LookupError if nothing in a scene is called so."""
    if name in _NOTES:
        from sim import notes  # few worlds that ship have any

        return getattr(notes, name)
    return _KINDS[name]


def _is_known(content: Any) -> bool:
    name = type(content).__name__
    return name in _KINDS or name in _NOTES


def _names(kind: Any) -> tuple[str, ...]:
    """What its values are made of, in the order in which they are given."""
    return getattr(kind, "__match_args__", ())


def _put_together(rows: Iterable[_Row], kinds: Sequence[Any]) -> Any:
    """The value of the last row."""
    values: list[Any] = []
    for kind, contents, inner in rows:
        for at, which in inner:
            contents[at] = values[which] if isinstance(which, int) else tuple([values[i] for i in which])
        values.append(_value(kinds[kind], contents))
    return values[-1]


def _value(kind: Any, contents: Sequence[Any]) -> Any:
    """Its constructor looks for what wasn't given; here all is there."""
    if issubclass(kind, Enum):
        return kind(*contents)
    value = object.__new__(kind)
    value.__setstate__(contents)
    return value


class _Apart:
    """Values as rows."""

    def __init__(self) -> None:
        self.kinds: dict[str, tuple[str, ...]] = {}
        """The classes, in the order of their numbers."""
        self.rows: list[_Row] = []
        self._numbers: dict[bytes, int] = {}

    def add(self, value: Any) -> int:
        """The number of its row; of the same one for the same contents."""
        name = type(value).__name__
        self.kinds.setdefault(name, _names(_kind(name)))
        contents = (
            [value.value] if isinstance(value, Enum) else [getattr(value, each) for each in _names(value)]
        )
        inner: list[_Inner] = []
        for at, content in enumerate(contents):
            which = self._inside(content)
            if which is not None:
                contents[at] = None
                inner.append((at, which))
        row: Any = ([*self.kinds].index(name), contents, tuple(inner))
        number = self._numbers.setdefault(marshal.dumps(row, _FORM), len(self.rows))
        if number == len(self.rows):
            self.rows.append(row)
        return number

    def _inside(self, content: Any) -> int | tuple[int, ...] | None:
        """Which values the content is; None if it is plain."""
        if _is_known(content):
            return self.add(content)
        if isinstance(content, tuple) and content and _is_known(content[0]):
            return tuple(map(self.add, content))
        return None


def _sources(files: Iterable[str], pictures: Iterable[str]) -> tuple[str, ...]:
    return tuple(dict.fromkeys((*files, *pictures)))


def beside(world: str) -> str:
    """The file of its scene."""
    return world.removesuffix(".world") + SUFFIX


def _folder_of(world: str) -> str:
    return os.path.split(world)[0]


def _bytes_of(path: str) -> bytes:
    with open(path, "rb") as file:  # noqa: PTH123 -- pathlib is slow to load
        return file.read()


def _placed(scene: Scene, place: Callable[[str], str]) -> Scene:
    """The scene, its files called by other paths."""
    report = scene.report
    return replace(
        scene,
        report=replace(
            report,
            files=tuple(map(place, report.files)),
            pictures=tuple(map(place, report.pictures)),
            notes=tuple(replace(each, file=each.file and place(each.file)) for each in report.notes),
        ),
    )
