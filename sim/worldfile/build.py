"""Entities become models: units, poses, shapes and sensors, as Stage builds them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping

from sim.colours import Colour
from sim.report import Note, NoteKind
from sim.scene import Blobfinder, Model, Placement, Polygon, RangeSensor
from sim.worldfile import shapes
from sim.worldfile.entities import MODEL_TYPES, Entity, Setting
from sim.worldfile.mistakes import Code, WorldError
from sim.worldfile.values import Size, ValueReader

Trace = Callable[[Setting], tuple[Polygon, ...]]
"""The dark pixels of the picture that a ``bitmap`` names, as polygons."""

_RED, _NAVY, _BLACK = Colour("red", 1, 0, 0), Colour("", 0, 0, 0.5), Colour("black", 0, 0, 0)
_SIZES = {
    "ranger": (0.15, 0.15, 0.2),
    "fiducial": (0.0, 0.0, 0.0),
    "gripper": (0.2, 0.3, 0.2),
    "camera": (0.1, 0.07, 0.05),
}
_COLOURS = {"ranger": _NAVY, "camera": _BLACK}
_NOT_SIMULATED = frozenset(["fiducial", "gripper", "camera", "actuator", "lightindicator", "blinkenlight"])
MOST_POLYGON_POINTS = 200_000


class Builder:
    """Builds the models of one world. Names are Stage's: ``parent.type:number`` where the file gives none."""

    def __init__(self, reader: ValueReader, trace: Trace) -> None:
        self.models: list[Model] = []
        self._reader = reader
        self._trace = trace
        self._points = 0

    def build(self, entities: Iterable[Entity]) -> None:
        counts: Counter[str] = Counter(model=1)  # Stage counts its invisible floor
        for entity in entities:
            if entity.type in MODEL_TYPES:
                self._model(entity, None, counts)
            elif entity.type == "window":
                self._reader.check(entity.settings, quiet=True)
            else:
                place = (entity.file, entity.line, entity.column)
                raise WorldError(Code.MISPLACED, *place, found=entity.type)

    def _model(self, entity: Entity, parent: Model | None, counts: Counter[str]) -> None:
        self._reader.check(entity.settings)
        blocks = tuple(child for child in entity.children if child.type == "block")
        model = self._bare(entity, parent, blocks, counts)
        self.models.append(model)
        if entity.type in _NOT_SIMULATED:
            self._remark("not-simulated", entity, type=entity.type, name=model.name)
        inner: Counter[str] = Counter()
        for child in entity.children:
            if child.type in MODEL_TYPES:
                self._model(child, model, inner)
            elif child.type == "sensor" and entity.type != "ranger":
                self._remark("lone-sensor", child, NoteKind.REPAIRED, name=model.name)
                self._model(_ranger_around(child), model, inner)
            elif child.type == "window":
                raise WorldError(Code.MISPLACED, child.file, child.line, child.column, found="window")

    def _bare(
        self, entity: Entity, parent: Model | None, blocks: tuple[Entity, ...], counts: Counter[str]
    ) -> Model:
        read, settings = self._reader, entity.settings
        index = len(self.models)
        default = f"{entity.type}:{counts[entity.type]}"
        counts[entity.type] += 1
        name = read.string(settings, "name", f"{parent.name}.{default}" if parent else default)
        size = read.size(settings, _SIZES.get(entity.type, (0.4, 0.4, 1.0)))
        origin = read.place(settings, "origin")
        walled = read.number(settings, "boundary", 0) != 0
        return Model(
            index=index,
            type=entity.type,
            kind=entity.kind,
            name=name,
            parent=parent.index if parent else None,
            root=parent.root if parent else index,
            pose=_inside(parent, read.place(settings, "pose")),
            origin=origin,
            size=size,
            colour=read.colour(settings, _COLOURS.get(entity.type, _RED)),
            obstacle_return=read.number(settings, "obstacle_return", 1),
            ranger_return=read.number(settings, "ranger_return", 1),
            blob_return=read.number(settings, "blob_return", 1),
            fiducial_return=read.number(settings, "fiducial_return", 0),
            gripper_return=read.number(settings, "gripper_return", 0),
            boundary=walled,
            bitmap=read.string(settings, "bitmap", ""),
            polygons=self._shape(entity, blocks, size, origin, walled),
            walls=shapes.boundary(size, origin) if walled else (),
            sensors=tuple(self._sensors(entity)),
            blobfinder=self._blobfinder(settings) if entity.type == "blobfinder" else None,
        )

    def _shape(
        self, entity: Entity, blocks: tuple[Entity, ...], size: Size, origin: Placement, walled: bool
    ) -> tuple[Polygon, ...]:
        polygons: tuple[Polygon, ...] = ()
        if entity.type == "gripper":
            polygons = shapes.gripper()
        elif "bitmap" in entity.settings:
            polygons = self._trace(entity.settings["bitmap"])
        polygons += tuple(self._block(child) for child in blocks)
        if not polygons and shapes.has_default_block(entity.type, walled):
            polygons = (shapes.UNIT,)
        self._points += sum(len(polygon.points) for polygon in polygons)
        if self._points > MOST_POLYGON_POINTS:
            place = (entity.file, entity.line, entity.column)
            raise WorldError(Code.TOO_MUCH, *place, limit=MOST_POLYGON_POINTS)
        return shapes.fitted(polygons, size, origin)

    def _block(self, entity: Entity) -> Polygon:
        self._reader.check(entity.settings)
        return shapes.block(self._reader, entity)

    def _sensors(self, entity: Entity) -> Iterable[RangeSensor]:
        for child in entity.children:
            if child.type == "sensor" and entity.type == "ranger":
                self._reader.check(child.settings)
                yield self._sensor(child.settings)

    def _sensor(self, settings: Mapping[str, Setting]) -> RangeSensor:
        read, usual = self._reader, RangeSensor()
        minimum, maximum = read.span(settings, "range", (usual.minimum, usual.maximum))
        fov = min(360.0, max(0.0, read.angle(settings, "fov", usual.fov)))
        samples = int(min(100_000, max(1, read.number(settings, "samples", 1))))
        return RangeSensor(read.place(settings, "pose"), minimum, maximum, fov, samples)

    def _blobfinder(self, settings: Mapping[str, Setting]) -> Blobfinder:
        read = self._reader
        maximum, fov = read.length(settings, "range", 12.0), read.angle(settings, "fov", 60.0)
        return Blobfinder(max(0.0, maximum), fov, read.colours(settings))

    def _remark(self, code: str, entity: Entity, kind: NoteKind = NoteKind.IGNORED, **details: str) -> None:
        self._reader.remark(Note(kind, code, entity.file, entity.line, entity.column, details))


def _inside(parent: Model | None, pose: Placement) -> Placement:
    """A child stands on top of its parent."""
    return pose if parent is None else parent.pose.then(pose, parent.size[2])


def _ranger_around(sensor: Entity) -> Entity:
    """The manual puts a sensor straight into a robot; it becomes a ranger with that one sensor."""
    return Entity("ranger", sensor.kind, sensor.file, sensor.line, sensor.column, {}, (sensor,))
