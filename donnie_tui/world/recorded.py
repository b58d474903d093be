"""All files of a world in one value, and a world loaded from a recording alone.

File names are ``N/PATH``: 0 is the folder of the world, or the folder above with all files of its project;
the others are folders that it may include from.
``unpack`` writes nothing outside the folder that is given to it, and a loaded recording leaves no files.
"""

from __future__ import annotations

import base64
import os
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from math import isfinite
from pathlib import Path, PurePosixPath
from tempfile import TemporaryDirectory

from msgspec import Struct, ValidationError, convert
from msgspec.structs import replace

import worlds
from devices.ports.robot import Bearing
from donnie_tui.core.recording import Header
from donnie_tui.i18n.mistakes import world_mistake
from donnie_tui.i18n.words import Unusable, Words
from donnie_tui.process.confinement import confinement, make_folder, open_bytes, real_path
from donnie_tui.settings.settings import Settings
from donnie_tui.world.loading import ChosenWorld, scattered_by, with_robot

LARGEST = 32 * 1024 * 1024
"""Bytes of all files together; a world with two large pictures has a tenth of it."""

_PLACE = re.compile(r"\d{1,3}")


class BundleError(Exception):
    """Raised for a world that can't be packed or unpacked. ``code`` is a sentence of the catalogue."""

    def __init__(self, code: str, **values: object) -> None:
        super().__init__(code)
        self.code = code
        self.values = values


class WorldBundle(Struct, frozen=True):
    """A world with all its files."""

    name: str
    """Its name in events."""
    main: str
    """Which of the files is the world."""
    files: tuple[tuple[str, bytes], ...]
    robots: tuple[str, ...]
    """The robots that it offers, the learner's first."""
    moves: tuple[tuple[int, float, float, float, float], ...] = ()
    """The models that a challenge moved: index, and place in the file's units."""

    def as_record(self) -> dict[str, object]:
        """For JSON: texts as they are, everything else in base64."""
        return {
            "name": self.name,
            "main": self.main,
            "robots": list(self.robots),
            "files": [{"name": name, **_content(data)} for name, data in self.files],
            **({"moves": [list(each) for each in self.moves]} if self.moves else {}),
        }


def pack(
    name: str, main: Path, files: Sequence[str], folders: Sequence[Path], robots: Sequence[str]
) -> WorldBundle:
    """Read all ``files``. Raises ``BundleError``."""
    others = [Path(real_path(each)) for each in folders]
    found = (Path(real_path(each)) for each in files)
    project = [each for each in found if not any(each.is_relative_to(folder) for folder in others)]
    first = Path(os.path.commonpath([Path(real_path(main)).parent, *(each.parent for each in project)]))
    places = list(dict.fromkeys([first, *others]))
    packed: dict[str, bytes] = {}
    for file in dict.fromkeys((str(main), *files)):
        data = _read(Path(file), LARGEST - sum(map(len, packed.values())))
        packed |= dict.fromkeys(_names_of(Path(file), places), data)
    return WorldBundle(name, _names_of(main, places)[0], tuple(packed.items()), tuple(robots))


def unpack(bundle: WorldBundle, folder: Path) -> tuple[Path, tuple[Path, ...]]:
    """Write the files into ``folder``, which is empty; the world's file and the folders to include from.

    Raises ``BundleError`` and writes nothing if a name leads anywhere else.
    """
    names = [_checked(name) for name, _ in bundle.files]
    main = _checked(bundle.main)
    if main not in names:
        raise BundleError("bundle-incomplete", name=bundle.main[:80])
    try:
        for name, (_, data) in zip(names, bundle.files, strict=True):
            path = folder.joinpath(*name.parts)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
    except OSError as problem:
        raise BundleError("bundle-unwritable", reason=problem.strerror) from None
    places = sorted({int(name.parts[0]) for name in names}, key=lambda place: (place == 0, place))
    return folder.joinpath(*main.parts), tuple(folder / str(place) for place in places)


class _RecordedFile(Struct, frozen=True):
    """A file as JSON has it: a text as it is, everything else in base64."""

    name: str
    text: str | None = None
    base64: bytes | None = None

    @property
    def data(self) -> bytes:
        if self.text is not None:
            return self.text.encode("utf-8", "surrogatepass")
        if self.base64 is None:
            raise BundleError("bundle-damaged")
        return self.base64


class _RecordedBundle(Struct, frozen=True):
    name: str
    main: str
    robots: tuple[str, ...]
    files: tuple[_RecordedFile, ...]
    moves: tuple[tuple[int, float, float, float, float], ...] = ()


def from_record(record: object) -> WorldBundle:
    """The bundle of a JSON object. Raises ``BundleError`` for what is none."""
    try:
        read = convert(record, _RecordedBundle)
    except ValidationError:
        raise BundleError("bundle-damaged") from None
    files = tuple((each.name, each.data) for each in read.files)
    if not all(isfinite(number) for each in read.moves for number in each):
        raise BundleError("bundle-damaged")
    if sum(len(data) for _, data in files) > LARGEST:
        raise BundleError("bundle-too-large", limit=LARGEST // 1024**2)
    return WorldBundle(read.name, read.main, files, read.robots, read.moves)


def _content(data: bytes) -> dict[str, str]:
    try:
        return {"text": data.decode("utf-8")}
    except UnicodeDecodeError:
        return {"base64": base64.b64encode(data).decode("ascii")}


def _names_of(file: Path, places: Sequence[Path]) -> tuple[str, ...]:
    """The names of a file in the bundle, one for each folder that contains it."""
    paths = (Path(os.path.normpath(file.absolute())), Path(real_path(file)))
    found = (
        f"{number}/{path.relative_to(place).as_posix()}"
        for number, place in enumerate(places)
        for path in paths
        if path.is_relative_to(place)
    )
    return tuple(dict.fromkeys(found))


def _read(file: Path, room: int) -> bytes:
    try:
        with open_bytes(file) as stream:
            data = stream.read(room + 1)
    except OSError as problem:
        raise BundleError("file-unreadable", path=str(file), reason=problem.strerror) from None
    if len(data) > room:
        raise BundleError("bundle-too-large", limit=LARGEST // 1024**2)
    return data


def _checked(name: str) -> PurePosixPath:
    path = PurePosixPath(name)
    parts = path.parts
    is_inside = len(parts) > 1 and _PLACE.fullmatch(parts[0]) and ".." not in parts
    if not is_inside or any(each in name for each in "\\:\0") or len(name) > 1000:
        raise BundleError("bundle-damaged")
    return path


@contextmanager
def unpacked(header: Header, words: Words) -> Iterator[ChosenWorld]:
    """The recorded world, in a temporary folder. Raises ``Unusable``."""
    with TemporaryDirectory(prefix="donnie-", dir=_place_for_unpacking()) as folder:
        try:
            bundle = from_record(header.world)
            main, folders = unpack(bundle, Path(folder))
        except BundleError as error:
            raise Unusable(words(error.code, **error.values)) from None
        yield _loaded(bundle, main, folders, words, header.seed)


def _place_for_unpacking() -> str | None:
    """The place for the temporary folder: in a confined session inside its folder."""
    limits = confinement()
    if limits is None:
        return None
    make_folder(limits.own_folder)
    return limits.own_folder


def _loaded(
    bundle: WorldBundle, main: Path, folders: tuple[Path, ...], words: Words, seed: int
) -> ChosenWorld:
    from sim.geometry import Placement
    from sim.scene import moved
    from sim.worldfile import WorldError, load_world

    try:
        scene = load_world(main, allowed=folders)
    except WorldError as error:
        raise Unusable(world_mistake(error, words)) from None
    world = scattered_by(seed, ChosenWorld(bundle.name, str(main), scene, _ships(bundle)), words, folders)
    scene = (world := with_robot(world, words, folders)).scene
    scene = moved(scene, {index: Placement(*place) for index, *place in bundle.moves})
    offered = tuple(index for index in scene.robots if scene.models[index].spoken_name in bundle.robots)
    if not offered:
        raise Unusable(words("world-without-robot", name=bundle.name))
    return replace(world, scene=replace(scene, robots=offered))


def _ships(bundle: WorldBundle) -> bool:
    """Whether it is a built-in world, which has words about it."""
    return bundle.name in worlds.names()


class _Belt(Struct):
    """As a recording has it: the degrees of each direction are text."""

    steps: tuple[int, int, int]
    columns: dict[str, tuple[int, ...]]


def settings_of(header: Header, settings: Settings, words: Words) -> Settings:
    """The settings with those of the recording that matter. Raises ``Unusable``."""
    try:
        belt = convert(header.belt, _Belt)
        columns = {Bearing(int(bearing)): those for bearing, those in belt.columns.items()}
    except (ValidationError, ValueError):
        raise Unusable(words("bundle-damaged")) from None
    return replace(
        settings,
        seed=header.seed,
        speed=None,
        belt_steps=belt.steps,
        belt_columns=columns,
    )
