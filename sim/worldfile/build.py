"""Entities become models: units, poses, shapes and sensors, as Stage builds them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping

from sim.colours import colour_of
from sim.geometry import Placement
from sim.scene import Model, Note, NoteKind, Polygon, RangeSensor
from sim.worldfile import equipment, shapes
from sim.worldfile.entities import MODEL_TYPES, Entity, Setting
from sim.worldfile.floor_plans import NOTHING, Plan
from sim.worldfile.mistakes import Code, WorldError
from sim.worldfile.values import ValueReader

Trace = Callable[[Setting], Plan]
"""The dark pixels of the picture that a ``bitmap`` names."""

_RED, _NAVY, _BLACK = colour_of("red", 1, 0, 0), colour_of("", 0, 0, 0.5), colour_of("black", 0, 0, 0)
_SIZES = {
    "ranger": (0.15, 0.15, 0.2),
    "fiducial": (0.0, 0.0, 0.0),
    "gripper": (0.2, 0.3, 0.2),
    "camera": (0.1, 0.07, 0.05),
}
_COLOURS = {"ranger": _NAVY, "camera": _BLACK}
_NOT_SIMULATED = frozenset(["camera", "actuator", "lightindicator", "blinkenlight"])
MOST_POLYGON_POINTS = 200_000


class Builder:
    """Builds the models of one world. Names are Stage's: ``parent.type:number`` where the file gives none."""

    def __init__(self, reader: ValueReader, trace: Trace, world: Mapping[str, Setting]) -> None:
        """``world``: the properties at the top level."""
        self.models: list[Model] = []
        self._reader = reader
        self._trace = trace
        self._points = 0
        self._samples = 0
        self._sensors_made: dict[tuple[int, ...], RangeSensor] = {}
        """By the properties of the file that made them."""
        self._sees_any_height = reader.number(world, "ignore_zloc", 1)

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
        plan = self._trace(settings["bitmap"]) if "bitmap" in settings else NOTHING
        default = f"{entity.type}:{counts[entity.type]}"
        counts[entity.type] += 1
        name = read.string(settings, "name", f"{parent.name}.{default}" if parent else default)
        size = read.size(settings, _SIZES.get(entity.type, (0.4, 0.4, 1.0)))
        origin = read.place(settings, "origin")
        walled = read.number(settings, "boundary", 0) != 0
        walls = shapes.boundary(size, origin) if walled else ()
        gripper = equipment.gripper(read, settings) if entity.type == "gripper" else None
        if gripper is not None:
            drawn = shapes.gripper(gripper, float(gripper.closed), float(gripper.lifted))
        else:
            drawn = plan.polygons
        polygons = shapes.fitted(self._shape(entity, drawn, blocks, walled), size, origin)
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
            fiducial_key=int(read.number(settings, "fiducial_key", 0)),
            gripper_return=read.number(settings, "gripper_return", 0),
            pushable=read.number(settings, "pushable", 0) != 0,
            mass=max(0.0, read.number(settings, "mass", 0)),
            ignore_zloc=read.number(settings, "ignore_zloc", self._sees_any_height) != 0,
            boundary=walled,
            bitmap=read.string(settings, "bitmap", ""),
            polygons=polygons,
            stage_blocks=len(polygons) - len(plan.polygons) + plan.outlines + (0 if blocks else len(walls)),
            walls=walls,
            sensors=tuple(self._sensors(entity)),
            blobfinder=equipment.blobfinder(read, settings) if entity.type == "blobfinder" else None,
            fiducial_finder=equipment.fiducial_finder(read, settings) if entity.type == "fiducial" else None,
            bumpers=tuple(equipment.bumpers(read, settings)) if entity.type == "bumper" else (),
            gripper=gripper,
            camera=equipment.camera(read, settings) if entity.type == "camera" else None,
            wheels=equipment.wheels(read, settings) if entity.type == "position" else None,
        )

    def _shape(
        self, entity: Entity, drawn: tuple[Polygon, ...], blocks: tuple[Entity, ...], walled: bool
    ) -> tuple[Polygon, ...]:
        """What is drawn already and the blocks of the file, or the default block; not scaled yet."""
        polygons = drawn + tuple(self._block(child) for child in blocks)
        if not polygons and shapes.has_default_block(entity.type, walled):
            polygons = (shapes.UNIT,)
        self._points += sum(len(polygon.points) for polygon in polygons)
        self._bound(entity, "points", self._points, MOST_POLYGON_POINTS)
        return polygons

    def _bound(self, entity: Entity, what: str, amount: int, limit: int) -> None:
        if amount > limit:
            place = (entity.file, entity.line, entity.column)
            raise WorldError(Code.TOO_MUCH, *place, what=what, limit=limit)

    def _block(self, entity: Entity) -> Polygon:
        self._reader.check(entity.settings)
        return shapes.block(self._reader, entity)

    def _sensors(self, entity: Entity) -> Iterable[RangeSensor]:
        for child in entity.children:
            if child.type == "sensor" and entity.type == "ranger":
                sensor = self._sensor(child)
                self._samples += sensor.samples
                self._bound(entity, "samples", self._samples, equipment.MOST_SAMPLES_OF_ALL)
                yield sensor

    def _sensor(self, entity: Entity) -> RangeSensor:
        """A thousand robots of one macro share their sensors."""
        key = tuple(id(setting.property) for setting in entity.settings.values())
        if key not in self._sensors_made:
            self._reader.check(entity.settings)
            self._sensors_made[key] = equipment.range_sensor(self._reader, entity.settings)
        return self._sensors_made[key]

    def _remark(self, code: str, entity: Entity, kind: NoteKind = NoteKind.IGNORED, **details: str) -> None:
        self._reader.remark(Note(kind, code, entity.file, entity.line, entity.column, details))


def _inside(parent: Model | None, pose: Placement) -> Placement:
    """A child stands on top of its parent."""
    return pose if parent is None else parent.pose.then(pose, parent.size[2])


def _ranger_around(sensor: Entity) -> Entity:
    """The manual puts a sensor straight into a robot; it becomes a ranger with that one sensor."""
    return Entity("ranger", sensor.kind, sensor.file, sensor.line, sensor.column, {}, (sensor,))
