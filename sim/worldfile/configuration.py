"""Configuration files (``.cfg``): the world, its robots under their device addresses, and the real robot."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from difflib import get_close_matches
from pathlib import Path

from msgspec import Struct
from msgspec.structs import replace

from sim.scene import LoadReport, Note, NoteKind, Scene
from sim.worldfile.entities import Entity, Expander, FileReader, Setting
from sim.worldfile.load import load_world
from sim.worldfile.mistakes import Code, WorldError
from sim.worldfile.values import ValueReader, mistake

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
"""The second is read over."""
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
    scene = load_world(world, allowed=(path.resolve().parent, *allowed))
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
        path = reader.find(name, Path(setting.file))
        if path is None:
            raise mistake(Code.FILE_NOT_FOUND, setting, path=name[:200])
        if not reader.is_allowed(path):
            folder = reader.folder_outside(path)
            raise mistake(Code.INCLUDE_OUTSIDE, setting, path=name[:200], folder=folder)
        return path

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
