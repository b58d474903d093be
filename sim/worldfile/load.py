"""Loads a world: ``load_world`` a file, ``load_text`` a text, ``load_configuration`` a configuration file.

A configuration file (``.cfg``) names the world, its robots under their device addresses, and the real robot.

A robot that starts inside something is reported as a slip; Stage lets it stand there, and so does Donnie. A
thing without a pose is at 0 0, where the robot usually is. What surrounds a robot without touching it is no
slip.

Every robot gets a unique name that can be typed and spoken. Stage numbers robots without a name and lets two
robots have the same one; here such a robot gets an alias, and ``Model.name`` stays what Stage has."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from difflib import get_close_matches
from pathlib import Path
from unicodedata import combining, normalize

from msgspec import Struct
from msgspec.structs import replace

from sim.geometry import overlapping, placed
from sim.parts import Body, Part, body_of, parts_of
from sim.scene import LoadReport, Model, Note, NoteKind, Scene
from sim.worldfile.build import Builder
from sim.worldfile.entities import Entity, Expander, FileReader, Placed, Setting, resolved
from sim.worldfile.floor_plans import USUAL_RESOLUTION, Plans
from sim.worldfile.mistakes import Code, WorldError
from sim.worldfile.values import ValueReader, mistake, named_file, plain

MOST = 50
"""Robots that are looked at."""


def standing_inside(scene: Scene) -> Iterator[Note]:
    """A remark for each robot and thing of which one begins inside the other."""
    if not scene.robots:
        return
    parts = tuple(part for part in parts_of(scene) if part.solid)
    reported = set[int]()
    for index in scene.robots[:MOST]:
        robot, body = scene.models[index], body_of(scene, index)
        others = (part for part in parts if part.root not in (index, *reported))
        for root in dict.fromkeys(part.root for part in others if _is_in(robot, body, part)):
            details = {"name": robot.spoken_name[:60], "thing": _called(scene.models[root])}
            yield Note(NoteKind.WARNING, "starts-inside", "", 0, 0, details)
        reported.add(index)


def _is_in(robot: Model, body: Body, part: Part) -> bool:
    here, (x, y), reach = robot.pose, part.middle, part.reach + body.radius
    if (x - here.x) ** 2 + (y - here.y) ** 2 > reach * reach:
        return False
    mine = (placed(points, here.x, here.y, here.yaw) for points in body.polygons)
    return any(overlapping(points, part.points) for points in mine)


def _called(model: Model) -> str:
    """A model in the words of the file: the word that made it, and its name if it has one."""
    name = model.called
    return (name if name and model.kind in (model.type, *name.split()) else f"{model.kind} {name}").strip()[
        :60
    ]


_UNSPEAKABLE = frozenset(':="\\')
"""Of Stage's numbering, of ``NAME=FILE``, of quoting."""


def with_names(
    models: tuple[Model, ...], robots: Iterable[int]
) -> tuple[tuple[Model, ...], tuple[Note, ...]]:
    """The models with aliases for the robots that need one (``robots`` first), and the notes on them."""
    indices = set(robots)
    wheeled = [model for model in models if model.type == "position" and model.parent is None]
    order = sorted(wheeled, key=lambda model: model.index not in indices)
    numbering = _Numbering({_folded(model.name) for model in order if _is_speakable(model.name)})
    kept, aliases, notes = set[str](), dict[int, str](), list[Note]()
    for model in order:
        speakable = _is_speakable(model.name)
        folded = _folded(model.name)
        if speakable and folded not in kept:
            kept.add(folded)
            continue
        alias = numbering.free(_stem(model), 2 if speakable else 1)
        aliases[model.index] = alias
        if model.index in indices:
            code = "robot-renamed" if speakable else "robot-without-name"
            notes.append(Note(NoteKind.REPAIRED, code, "", 0, 0, {"name": model.name[:60], "alias": alias}))
    named = tuple(
        replace(model, alias=aliases[model.index]) if model.index in aliases else model for model in models
    )
    return named, tuple(notes)


def _is_speakable(name: str) -> bool:
    return bool(name.strip()) and name == name.strip() and name.isprintable() and not _UNSPEAKABLE & set(name)


def _stem(model: Model) -> str:
    if _is_speakable(model.name):
        return model.name
    return model.kind if model.kind != model.type else "robot"


class _Numbering:
    """Unused names. Each stem continues at its last number: a file may have many robots."""

    def __init__(self, taken: set[str]) -> None:
        """``taken`` are folded."""
        self._taken = taken
        self._next: dict[tuple[str, int], int] = {}

    def free(self, stem: str, first: int) -> str:
        """The stem with the lowest number from ``first`` on that is free, which is taken from now on."""
        folded = _folded(stem)
        number = self._next.get((folded, first), first)
        while f"{folded}{number}" in self._taken:
            number += 1
        self._taken.add(f"{folded}{number}")
        self._next[folded, first] = number + 1
        return f"{stem}{number}"


def _folded(name: str) -> str:
    """Equal for names that differ in case and accents only."""
    return "".join(each for each in normalize("NFKD", name.casefold()) if not combining(each))


_SENSES = frozenset({"ranger", "blobfinder"})
_LESSER_SENSES = frozenset({"bumper", "fiducial", "camera", "gripper"})


def load_world(path: Path, *, allowed: tuple[Path, ...] = ()) -> Scene:
    """The scene of the world at ``path``.

    Includes and bitmaps are searched in the folder of the file that names them, then in the world's folder,
    then in the folders ``allowed``; nothing else is read. Raises ``WorldError`` if the world can't be used.
    """
    reader = FileReader(path, allowed)
    return _scene(path.stem, reader, reader.read(path))


def load_text(text: str, path: Path, *, allowed: tuple[Path, ...] = ()) -> Scene:
    """The scene of a world that is not in a file; ``path`` names it in mistakes and is where it would lie."""
    reader = FileReader(path, allowed)
    return _scene(path.stem, reader, reader.statements(text, path, ()))


def _scene(name: str, reader: FileReader, statements: Iterable[Placed]) -> Scene:
    expander, values = Expander(folders=reader.folders), ValueReader()
    entities = expander.expand(statements)
    values.use_units(expander.settings)
    values.check(expander.settings, quiet=True)
    settings = _plain(expander.settings)
    if (area := expander.settings.get("scatter")) is not None:
        settings["scatter"] = values.numbers(area, 4, 4)
    resolution = values.length(expander.settings, "resolution", USUAL_RESOLUTION)
    builder = Builder(values, Plans(reader, values, resolution).plan, expander.settings)
    builder.build(entities)
    robots = _robots(tuple(builder.models))
    models, named = with_names(tuple(builder.models), robots)
    notes = (
        *reader.notes,
        *expander.notes,
        *values.notes,
        *_walls(models),
        *named,
        *_no_robot(reader, robots),
    )
    report = LoadReport(tuple(dict.fromkeys(reader.files)), _counts(models), notes, tuple(reader.pictures))
    scene = Scene(name, models, robots, settings, report)
    return replace(scene, report=replace(report, notes=(*notes, *standing_inside(scene))))


def _robots(models: tuple[Model, ...]) -> tuple[int, ...]:
    """Position models with range sensors or cameras, then those with bumpers; without any, all others."""
    robots: list[int] = []
    for senses in (_SENSES, _LESSER_SENSES):
        sensing = {model.root for model in models if model.type in senses}
        robots += [root for root in sorted(sensing) if models[root].type == "position"]
    bare = (model.index for model in models if model.type == "position" and model.parent is None)
    return tuple(dict.fromkeys(robots or bare))


def _walls(models: tuple[Model, ...]) -> Iterable[Note]:
    for model in models:
        if model.solid and model.obstacle_return == 0:
            yield Note(NoteKind.REPAIRED, "walls-made-solid", "", 0, 0, {"name": model.name})


def _no_robot(reader: FileReader, robots: tuple[int, ...]) -> Iterable[Note]:
    if not robots:
        yield Note(NoteKind.WARNING, "no-robot", next(iter(reader.files), ""), 1, 1)


def _counts(models: tuple[Model, ...]) -> tuple[tuple[str, int], ...]:
    return tuple(Counter(model.type for model in models).most_common())


def _plain(settings: Mapping[str, Setting]) -> dict[str, float | str | tuple[object, ...]]:
    return {name: plain(setting.property.value) for name, setting in settings.items()}


DEFAULT_PORT = 6665
"""Player's."""
LOCAL = "localhost"

_INDEX = re.compile(r"[0-9]{1,9}")


class Address(Struct, frozen=True):
    """The address of a device. ``port`` distinguishes the robots of one host."""

    interface: str
    index: int
    port: int = DEFAULT_PORT
    host: str = LOCAL
    has_port: bool = False
    """Whether the file gives it."""


def address(text: str) -> Address | None:
    """``position2d:0``, ``6666:position2d:0``, ``host:6666:position2d:0`` (or a key before it); else None."""
    fields = text.split(":")
    if not 2 <= len(fields) <= 5:
        return None
    *place, interface, index = fields
    _, host, port = ["", "", "", *place][-3:]
    number = _whole(port or str(DEFAULT_PORT), 65535)
    at = _whole(index, 10**9)
    if number is None or at is None or not re.fullmatch(r"[A-Za-z]\w*", interface):
        return None
    return Address(interface, at, number, host or LOCAL, bool(port))


def _whole(text: str, most: int) -> int | None:
    return int(text) if _INDEX.fullmatch(text) and int(text) <= most else None


_TYPES = frozenset({"driver", "interface"})
"""The second is skipped."""
_STAGE = "stage"
_ON_WHEELS = frozenset({"position2d", "position", "position3d"})
_SERIAL = re.compile(r"(?i)/dev/\S+|COM[0-9]+|\\\\\.\\COM[0-9]+")


class Offer(Struct, frozen=True):
    """A model of the world that programs may use, and the addresses of what it has."""

    model: str
    addresses: tuple[Address, ...]

    @property
    def drives(self) -> bool:
        """Whether it is offered as a robot, not as a thing with a sensor."""
        return any(each.interface in _ON_WHEELS for each in self.addresses)

    @property
    def port(self) -> int:
        """The address of its wheels; it distinguishes robots."""
        return next((each.port for each in (*self._wheels(), *self.addresses)), DEFAULT_PORT)

    def _wheels(self) -> Iterator[Address]:
        return (each for each in self.addresses if each.interface in _ON_WHEELS)


class Driver(Struct, frozen=True):
    """One ``driver`` block: its name, the model that it offers or "", and what it provides."""

    name: str
    model: str
    addresses: tuple[Address, ...]


class Configuration(Struct, frozen=True):
    """What a configuration file chose."""

    path: Path
    world: Path | None
    scene: Scene | None
    """None: it names no world, only a real robot."""
    offers: tuple[Offer, ...]
    physical_port: str | None
    """The serial port of the real robot that it asks for."""
    drivers: tuple[Driver, ...] = ()
    """All that provide something, in their order."""


def load_configuration(path: Path, *, allowed: tuple[Path, ...] = ()) -> Configuration:
    """What the configuration file at ``path`` chose. WorldError if it, or its world, can't be used.

    The scene's robots are those that are offered as such, the lowest port first; all, if none is.
    """
    reader, expander = FileReader(path, allowed), Expander(_TYPES)
    drivers = tuple(each for each in expander.expand(reader.read(path)) if each.type == "driver")
    read = _Drivers(ValueReader())
    world = read.world(drivers, reader)
    port = read.physical_port(drivers)
    if world is None and port is None:
        raise WorldError(Code.NO_WORLD_FILE, str(path))
    placed = tuple(read.offers(drivers))
    offers = tuple(offer for offer, _ in placed)
    if world is None:
        return Configuration(path, None, None, offers, port)
    scene = load_world(world, allowed=(resolved(path).parent, *allowed))
    notes = (*reader.notes, *expander.notes, *read.notes, *_unknown(placed, scene))
    report = _with(scene.report, tuple(reader.files), notes)
    scene = replace(scene, robots=_offered(scene, offers), report=report)
    return Configuration(path, world, scene, offers, port, tuple(read.all(drivers)))


class _Drivers:
    """Reads the ``driver`` blocks of one file."""

    def __init__(self, values: ValueReader) -> None:
        self.notes: list[Note] = []
        self._values = values

    def world(self, drivers: tuple[Entity, ...], reader: FileReader) -> Path | None:
        """The file that the first of Stage's drivers with a ``worldfile`` names."""
        for driver in drivers:
            if self._is_stage(driver) and (setting := driver.settings.get("worldfile")) is not None:
                return self._found(setting, reader)
        return None

    def physical_port(self, drivers: tuple[Entity, ...]) -> str | None:
        """The serial port of the first driver that has one, of wheels rather than of something else."""
        ports: list[tuple[bool, str]] = []
        for driver in drivers:
            if self._is_stage(driver):
                continue
            port = self._values.string(driver.settings, "port", "")
            if _SERIAL.fullmatch(port):
                drives = any(each.interface in _ON_WHEELS for each in self._addresses(driver.settings))
                ports.append((not drives, port))
            else:
                details = {"name": self._values.string(driver.settings, "name", "")[:60]}
                place = (driver.file, driver.line, driver.column)
                self.notes.append(Note(NoteKind.IGNORED, "driver-not-used", *place, details))
        return min(ports, key=_first)[1] if ports else None

    def offers(self, drivers: tuple[Entity, ...]) -> Iterator[tuple[Offer, Setting]]:
        """Each with the place where its model is named."""
        for driver in drivers:
            if self._is_stage(driver) and (setting := driver.settings.get("model")) is not None:
                name = self._values.string(driver.settings, "model", "")
                yield Offer(name, self._addresses(driver.settings)), setting

    def all(self, drivers: tuple[Entity, ...]) -> Iterator[Driver]:
        for driver in drivers:
            name, model = (self._values.string(driver.settings, each, "") for each in ("name", "model"))
            yield Driver(name, model, self._addresses(driver.settings))

    def _is_stage(self, driver: Entity) -> bool:
        return self._values.string(driver.settings, "name", "") == _STAGE

    def _found(self, setting: Setting, reader: FileReader) -> Path:
        name = self._values.string({"worldfile": setting}, "worldfile", "")
        return named_file(reader, setting, name, Code.FILE_NOT_FOUND, Code.INCLUDE_OUTSIDE)

    def _addresses(self, settings: Mapping[str, Setting]) -> tuple[Address, ...]:
        setting = settings.get("provides")
        if setting is None:
            return ()
        found: list[Address] = []
        for text in self._values.strings(setting, 1000):
            each = address(text)
            if each is None:
                raise mistake(Code.BAD_ADDRESS, setting, found=text[:60])
            found.append(each)
        return tuple(found)


def _offered(scene: Scene, offers: tuple[Offer, ...]) -> tuple[int, ...]:
    models = {model.name: model.index for model in reversed(scene.models) if model.parent is None}
    robots = sorted((offer for offer in offers if offer.drives), key=_port)
    found = dict.fromkeys(models[offer.model] for offer in robots if _fits(scene, models.get(offer.model)))
    return tuple(found) or scene.robots


def _fits(scene: Scene, model: int | None) -> bool:
    return model is not None and scene.models[model].type == "position"


def _unknown(placed: tuple[tuple[Offer, Setting], ...], scene: Scene) -> Iterator[Note]:
    """Offers of models that the world does not have. Stage does not start then; here the others are there."""
    names = {model.name for model in scene.models}
    for offer, setting in placed:
        if offer.model not in names:
            near = next(iter(get_close_matches(offer.model[:60], sorted(names), 1, 0.6)), "")
            details = {"name": offer.model[:60], "nearest": near}
            place = (setting.file, setting.property.line, setting.property.column)
            yield Note(NoteKind.WARNING, "unknown-model", *place, details)


def _with(report: LoadReport, files: tuple[str, ...], notes: tuple[Note, ...]) -> LoadReport:
    return replace(report, files=tuple(dict.fromkeys((*files, *report.files))), notes=(*notes, *report.notes))


def _first(pair: tuple[bool, str]) -> bool:
    return pair[0]


def _port(offer: Offer) -> int:
    return offer.port
