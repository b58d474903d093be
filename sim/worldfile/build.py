"""Entities become models: units, poses, shapes, and what is mounted on them, as Stage builds them.

Wheels, sensors and grippers are read from the settings; the defaults are Stage's."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping

from sim.colours import colour_of
from sim.geometry import Placement, Point, placed
from sim.scene import (
    Blobfinder,
    Bounds,
    Bumper,
    Camera,
    Drive,
    FiducialFinder,
    Gripper,
    Limits,
    Localization,
    Model,
    Note,
    NoteKind,
    OdometryError,
    Polygon,
    RangeNoise,
    RangeSensor,
    Wheels,
)
from sim.worldfile.entities import MODEL_TYPES, Entity, Setting
from sim.worldfile.floor_plans import NOTHING, Plan, rectangle
from sim.worldfile.mistakes import Code, WorldError
from sim.worldfile.values import ValueReader

Trace = Callable[[Setting, tuple[float, float, float]], Plan]
"""The dark pixels of the picture that a ``bitmap`` names, for a model of that size."""

_RED, _NAVY, _BLACK = colour_of("red", 1, 0, 0), colour_of("", 0, 0, 0.5), colour_of("black", 0, 0, 0)
_GREEN = colour_of("green", 0, 1, 0)
_SIZES = {
    "ranger": (0.15, 0.15, 0.2),
    "fiducial": (0.0, 0.0, 0.0),
    "gripper": (0.2, 0.3, 0.2),
    "camera": (0.1, 0.07, 0.05),
    "blinkenlight": (0.02, 0.02, 0.02),
}
_COLOURS = {"ranger": _NAVY, "camera": _BLACK, "blinkenlight": _GREEN}
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
        self._sees_any_height = reader.number(world, "ignore_zloc", True) != 0

    def build(self, entities: Iterable[Entity]) -> None:
        self._build(entities, Counter(model=1))  # Stage counts its invisible floor

    def _build(self, entities: Iterable[Entity], counts: Counter[str]) -> None:
        for entity in entities:
            if entity.type in MODEL_TYPES:
                self._model(entity, None, counts)
            elif entity.type == "window":
                self._reader.check(entity.settings, quiet=True)
                self._build(entity.children, counts)
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
                self._reader.check(child.settings, quiet=True)
                self._remark("lone-window", child, NoteKind.WARNING)

    def _bare(
        self, entity: Entity, parent: Model | None, blocks: tuple[Entity, ...], counts: Counter[str]
    ) -> Model:
        read, settings = self._reader, entity.settings
        index = len(self.models)
        default = f"{entity.type}:{counts[entity.type]}"
        counts[entity.type] += 1
        name = read.string(settings, "name", f"{parent.name}.{default}" if parent else default)
        scale = read.size(settings, _SIZES.get(entity.type, (0.4, 0.4, 1.0)))
        size = (abs(scale[0]), abs(scale[1]), scale[2])
        plan = self._trace(settings["bitmap"], size) if "bitmap" in settings else NOTHING
        origin = read.place(settings, "origin")
        walled = read.number(settings, "boundary", 0) != 0
        walls = boundary_walls(size, origin) if walled else ()
        gripper = read_gripper(read, settings) if entity.type == "gripper" else None
        if gripper is not None:
            drawn = gripper_blocks(gripper, float(gripper.closed), float(gripper.lifted))
        else:
            drawn = plan.polygons
        polygons = fitted(self._shape(entity, drawn, blocks, walled), scale, origin)
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
            fiducial_key=read.whole(settings, "fiducial_key", 0),
            gripper_return=read.number(settings, "gripper_return", 0),
            pushable=read.number(settings, "pushable", 0) != 0,
            mass=read.at_least_zero(settings, "mass", 0),
            ignore_zloc=read.number(settings, "ignore_zloc", self._sees_any_height) != 0,
            boundary=walled,
            bitmap=read.string(settings, "bitmap", ""),
            polygons=polygons,
            stage_blocks=len(polygons) - len(plan.polygons) + plan.outlines + (0 if blocks else len(walls)),
            walls=walls,
            sensors=tuple(self._sensors(entity)),
            blobfinder=read_blobfinder(read, settings) if entity.type == "blobfinder" else None,
            fiducial_finder=read_fiducial_finder(read, settings) if entity.type == "fiducial" else None,
            bumpers=tuple(read_bumpers(read, settings)) if entity.type == "bumper" else (),
            gripper=gripper,
            camera=read_camera(read, settings) if entity.type == "camera" else None,
            wheels=read_wheels(read, settings) if entity.type == "position" else None,
        )

    def _shape(
        self, entity: Entity, drawn: tuple[Polygon, ...], blocks: tuple[Entity, ...], walled: bool
    ) -> tuple[Polygon, ...]:
        """What is drawn already and the blocks of the file, or the default block; not scaled yet."""
        polygons = drawn + tuple(self._block(child) for child in blocks)
        if not polygons and has_default_block(entity, walled):
            polygons = (UNIT,)
        self._points += sum(len(polygon.points) for polygon in polygons)
        self._bound(entity, "points", self._points, MOST_POLYGON_POINTS)
        return polygons

    def _bound(self, entity: Entity, what: str, amount: int, limit: int) -> None:
        if amount > limit:
            place = (entity.file, entity.line, entity.column)
            raise WorldError(Code.TOO_MUCH, *place, what=what, limit=limit)

    def _block(self, entity: Entity) -> Polygon:
        self._reader.check(entity.settings)
        return read_block(self._reader, entity)

    def _sensors(self, entity: Entity) -> Iterable[RangeSensor]:
        for child in entity.children:
            if child.type == "sensor" and entity.type == "ranger":
                sensor = self._sensor(child)
                if not sensor.samples:
                    self._remark("no-samples", child, NoteKind.WARNING)
                    continue
                self._samples += sensor.samples
                self._bound(entity, "samples", self._samples, MOST_SAMPLES_OF_ALL)
                yield sensor

    def _sensor(self, entity: Entity) -> RangeSensor:
        """A thousand robots of one macro share their sensors."""
        key = tuple(id(setting.property) for setting in entity.settings.values())
        if key not in self._sensors_made:
            self._reader.check(entity.settings)
            self._sensors_made[key] = read_range_sensor(self._reader, entity.settings)
        return self._sensors_made[key]

    def _remark(self, code: str, entity: Entity, kind: NoteKind = NoteKind.IGNORED, **details: str) -> None:
        self._reader.remark(Note(kind, code, entity.file, entity.line, entity.column, details))


def _inside(parent: Model | None, pose: Placement) -> Placement:
    """A child stands on top of its parent."""
    return pose if parent is None else parent.pose.then(pose, parent.size[2])


def _ranger_around(sensor: Entity) -> Entity:
    """The manual puts a sensor straight into a robot; it becomes a ranger with that one sensor."""
    return Entity("ranger", sensor.kind, sensor.file, sensor.line, sensor.column, {}, (sensor,))


# --- shapes

MOST_POINTS = 2000
"""Points of one block."""
WALL = 0.01
"""Metres: the thickness of a boundary."""

UNIT = Polygon(((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)), 0.0, 1.0)


def read_block(reader: ValueReader, entity: Entity) -> Polygon:
    """One block as it is written, not scaled yet."""
    place = (entity.file, entity.line, entity.column)
    count = reader.whole(entity.settings, "points", 0)
    if not 2 <= count <= MOST_POINTS:
        raise WorldError(Code.TOO_FEW_POINTS, *place, ("2",), given=count, limit=MOST_POINTS)
    points = tuple(_point(reader, entity, i) for i in range(count))
    if count == 2:
        reader.remark(Note(NoteKind.WARNING, "line-block", *place))
        points = (*points, points[1])
    bottom, top = reader.pair(entity.settings["z"]) if "z" in entity.settings else (0.0, 1.0)
    return Polygon(points, min(bottom, top), max(bottom, top))


def _point(reader: ValueReader, entity: Entity, i: int) -> Point:
    """A corner; one that is missing is at 0 0, as in Stage."""
    name = f"point[{i}]"
    if name not in entity.settings:
        place = (entity.file, entity.line, entity.column)
        reader.remark(Note(NoteKind.WARNING, "missing-point", *place, {"name": name}))
        return 0.0, 0.0
    return reader.pair(entity.settings[name])


def gripper_blocks(it: Gripper, closed: float, lifted: float) -> tuple[Polygon, ...]:
    """The three blocks of Stage's gripper, as parts of its size: the base, the right and the left paddle.

    ``closed``: from 0, open, to 1, when the paddles meet. ``lifted``: from 0, at the floor, to 1.
    """
    base, width = 1.0 - it.paddle_length, it.paddle_width
    inwards = closed * (0.5 - width)
    bottom = lifted * (1.0 - it.paddle_height)
    paddles = (rectangle(base, y, it.paddle_length, width) for y in (inwards, 1.0 - width - inwards))
    risen = (Polygon(paddle.points, bottom, bottom + it.paddle_height) for paddle in paddles)
    return (rectangle(0.0, 0.0, base, 1.0), *risen)


def fitted(
    polygons: tuple[Polygon, ...], size: tuple[float, float, float], origin: Placement
) -> tuple[Polygon, ...]:
    """All blocks of a model together scaled and centred to its size, then shifted by its origin.

    A negative size mirrors them.
    """
    xs = [x for polygon in polygons for x, _ in polygon.points]
    ys = [y for polygon in polygons for _, y in polygon.points]
    if not xs:
        return ()
    scale_x, middle_x = _fit(xs, size[0])
    scale_y, middle_y = _fit(ys, size[1])
    top = max(polygon.top for polygon in polygons)
    scale_z = size[2] / top if top > 0 else 1.0

    def moved(points: Iterable[Point]) -> tuple[Point, ...]:
        flat = (((x - middle_x) * scale_x, (y - middle_y) * scale_y) for x, y in points)
        return placed(flat, origin.x, origin.y, origin.yaw)

    return tuple(Polygon(moved(p.points), p.bottom * scale_z, p.top * scale_z) for p in polygons)


def _fit(values: list[float], size: float) -> tuple[float, float]:
    low, high = min(values), max(values)
    return (size / (high - low) if high > low else 1.0), (low + high) / 2


def boundary_walls(size: tuple[float, float, float], origin: Placement) -> tuple[Polygon, ...]:
    """Four thin walls inside the bounding box."""
    width, depth, height = size
    across, along = min(WALL, width / 2), min(WALL, depth / 2)
    x, y = -width / 2, -depth / 2
    walls = (
        rectangle(x, y, width, along, height),
        rectangle(x, -y - along, width, along, height),
        rectangle(x, y, across, depth, height),
        rectangle(-x - across, y, across, depth, height),
    )
    return tuple(Polygon(placed(wall.points, origin.x, origin.y, origin.yaw), 0.0, height) for wall in walls)


def has_default_block(entity: Entity, walled: bool) -> bool:
    """Whether a model without blocks is a box.

    A sensor has no body, a model with a boundary is its walls, and one with a picture is its dark pixels.
    """
    return (
        entity.type not in ("ranger", "blobfinder", "fiducial")
        and not walled
        and "bitmap" not in entity.settings
    )


MOST_BUMPERS = 1000
MOST_SAMPLES = 10_000
"""Of one sensor."""
MOST_SAMPLES_OF_ALL = 2_000_000
_FASTEST = 1e6
"""Metres or degrees a second."""
_SHORTEST_PADDLE, _LONGEST_PADDLE = 0.01, 0.99

_Settings = Mapping[str, Setting]


def read_range_sensor(read: ValueReader, settings: _Settings) -> RangeSensor:
    usual = RangeSensor()
    minimum, maximum = read.span(settings, "range", (usual.minimum, usual.maximum))
    fov = _fov(read.angle(settings, "fov", usual.fov))
    samples = read.limited(settings, "samples", 1, MOST_SAMPLES)
    across, down, up = read.size(settings, usual.size)
    size = (abs(across), abs(down), up)
    noise = _noise(read, settings)
    return RangeSensor(read.place(settings, "pose"), minimum, maximum, fov, samples, noise, size)


def _noise(read: ValueReader, settings: _Settings) -> RangeNoise:
    """Stage's three numbers, or one tuple of them: in parts of the distance, in metres, in degrees."""
    proportional, constant, angle = 0.0, 0.0, 0.0
    if (setting := settings.get("noise")) is not None:
        proportional, constant, angle = read.numbers(setting, 3, 3)
        constant, angle = constant * read.metres, angle * read.degrees
    return RangeNoise(
        constant=abs(read.length(settings, "range_noise_const", constant)),
        proportional=min(1.0, abs(read.number(settings, "range_noise", proportional))),
        angle=min(360.0, abs(read.angle(settings, "angle_noise", angle))),
    )


def read_blobfinder(read: ValueReader, settings: _Settings) -> Blobfinder:
    maximum, fov = read.length(settings, "range", 12.0), _fov(read.angle(settings, "fov", 60.0))
    image = (80, 60)
    if (setting := settings.get("image")) is not None:
        across, down = (int(min(100_000, max(1, each))) for each in read.numbers(setting, 2, 2))
        image = (across, down)
    pan = read.angle(settings, "pan", 0.0) % 360.0
    return Blobfinder(max(0.0, maximum), fov, read.colours(settings), pan, image)


def read_fiducial_finder(read: ValueReader, settings: _Settings) -> FiducialFinder:
    usual = FiducialFinder()
    minimum = max(0.0, read.length(settings, "range_min", usual.minimum))
    maximum = max(minimum, read.length(settings, "range_max", usual.maximum))
    maximum_id = max(0.0, read.length(settings, "range_max_id", usual.maximum_id))
    return FiducialFinder(minimum, maximum, maximum_id, _fov(read.angle(settings, "fov", usual.fov)))


def read_bumpers(read: ValueReader, settings: _Settings) -> Iterable[Bumper]:
    """Reads the bumpers; without a ``bcount`` as many as there are poses."""
    given = sum(1 for name in settings if name.startswith("bpose["))
    common = max(0.0, read.length(settings, "blength", 0.1))
    for i in range(read.limited(settings, "bcount", given, MOST_BUMPERS)):
        length = max(0.0, read.length(settings, f"blength[{i}]", common))
        yield Bumper(read.place(settings, f"bpose[{i}]"), length)


def read_gripper(read: ValueReader, settings: _Settings) -> Gripper:
    sizes = [0.66, 0.1, 0.4]
    if (setting := settings.get("paddle_size")) is not None:
        sizes = [min(_LONGEST_PADDLE, max(_SHORTEST_PADDLE, each)) for each in read.numbers(setting, 3, 3)]
    closed, lifted = _paddle_state(read, settings)
    snatches = read.number(settings, "autosnatch", 0) != 0
    return Gripper(sizes[0], min(0.49, sizes[1]), sizes[2], closed, lifted, snatches)


def _paddle_state(read: ValueReader, settings: _Settings) -> tuple[bool, bool]:
    setting = settings.get("paddle_state")
    if setting is None:
        return False, False
    states = read.words(setting, ("open", "closed", "up", "down"), usual="open down")
    return "closed" in states, "up" in states


def read_camera(read: ValueReader, settings: _Settings) -> Camera:
    usual = Camera()
    minimum, maximum = read.span(settings, "range", (usual.minimum, usual.maximum))
    fov, pan, tilt = usual.fov, usual.pan, usual.tilt
    if (setting := settings.get("fov")) is not None:
        across, *up = read.numbers(setting, 1, 2)  # degrees, whatever the file's unit (manual, 3.2.1.1)
        fov = (_fov(across), _fov(up[0]) if up else usual.fov[1])
    if (setting := settings.get("pantilt")) is not None:
        pan, tilt = read.numbers(setting, 2, 2)
    return Camera(minimum, maximum, fov, pan % 360.0, tilt % 360.0)


def read_wheels(read: ValueReader, settings: _Settings) -> Wheels:
    drive = read.one_of(settings, "drive", "diff", tuple(each.value for each in Drive))
    localization = read.one_of(settings, "localization", "gps", tuple(each.value for each in Localization))
    origin = read.place(settings, "localization_origin") if "localization_origin" in settings else None
    return Wheels(
        Drive(drive),
        Localization(localization),
        origin,
        _odometry_error(read, settings),
        _limits(read, settings, "velocity_bounds"),
        _limits(read, settings, "acceleration_bounds"),
        max(1e-3, read.length(settings, "wheelbase", 1.0)),
    )


def _odometry_error(read: ValueReader, settings: _Settings) -> OdometryError:
    """``[x y z angle]``, or the manual's ``[x y angle]``. Parts, not lengths; Stage reads four."""
    if (setting := settings.get("odom_error")) is None:
        return OdometryError()
    x, y, *_, yaw = (min(2.0, abs(each)) for each in read.numbers(setting, 3, 4))
    return OdometryError(x, y, yaw)


def _limits(read: ValueReader, settings: _Settings, name: str) -> Limits | None:
    """``[xmin xmax ymin ymax zmin zmax amin amax]``."""
    if (setting := settings.get(name)) is None:
        return None
    values = read.numbers(setting, 8, 8)

    def bounds(first: int, unit: float) -> Bounds:
        low, high = sorted(min(_FASTEST, max(-_FASTEST, each * unit)) for each in values[first : first + 2])
        return read.bounds(setting, first, (low, high), unit)

    return Limits(bounds(0, read.metres), bounds(2, read.metres), bounds(6, read.degrees))


def _fov(degrees: float) -> float:
    return min(360.0, max(0.0, degrees))
