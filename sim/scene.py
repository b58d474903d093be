"""A loaded world: models, shapes, equipment. Values only; nothing moves or reads files.

Metres, kilograms, seconds, and degrees counter-clockwise from the x axis, as Stage has them; equipment
(wheels, sensors, grippers) is in the frame of its model. ``LoadReport`` says by code what was ignored,
repaired or looks like a slip. ``moved`` is the same scene with things at other places than in its file.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from enum import Enum

from msgspec import Struct, field
from msgspec.structs import replace

from sim.colours import Colour
from sim.geometry import Placement, Point, placed, relative, signed_area


class NoteKind(Enum):
    IGNORED = "ignored"
    REPAIRED = "repaired"
    WARNING = "warning"


class Note(Struct, frozen=True):
    """One remark. Codes: ``unknown-property`` (name, nearest), ``unused-property`` (name), ``not-simulated``
    (type, name), ``second-define`` (name), ``unknown-colour`` (name, nearest), ``random-colour``,
    ``read-as`` (name, found, used), ``line-block``, ``no-samples``, ``lone-window``, ``include-rest``
    (found), ``broken-define`` (name), ``lone-sensor`` (name), ``walls-made-solid`` (name), ``not-utf8``
    (path), ``margin-cropped`` (path), ``no-robot``, ``robot-without-name`` and ``robot-renamed`` (name,
    alias), ``starts-inside`` (name, thing); of a configuration file ``driver-not-used`` (name),
    ``unknown-model`` (name, nearest)."""

    kind: NoteKind
    code: str
    file: str
    line: int
    column: int
    details: Mapping[str, str | int | float] = field(default_factory=dict)


class RangeNoise(Struct, frozen=True):
    """How far off a range sensor may be; without a seed it is never off.

    Readings are drawn evenly from plus or minus these amounts. Names and meaning are Stage's.
    """

    constant: float = 0.0
    """Metres."""
    proportional: float = 0.0
    """Of the distance."""
    angle: float = 0.0
    """Degrees."""


class RangeSensor(Struct, frozen=True):
    """One sensor of a ranger, in the ranger's frame."""

    pose: Placement = field(default_factory=Placement)
    minimum: float = 0.0
    maximum: float = 5.0
    fov: float = 5.729577951308232
    """Degrees; the default is Stage's tenth of a radian."""
    samples: int = 1
    """1: a cone, covered whole. More: that many thin rays, spread evenly over the field of view."""
    noise: RangeNoise = field(default_factory=RangeNoise)
    size: tuple[float, float, float] = (0.02, 0.02, 0.02)
    """Metres ahead, across and up; it looks from the middle of its height."""


class Blobfinder(Struct, frozen=True):
    """The colours that a blobfinder distinguishes, and where it looks."""

    maximum: float
    fov: float
    colours: tuple[Colour, ...]
    """Empty: every colour."""
    pan: float
    image: tuple[int, int]
    """Pixels, across and down."""


class FiducialFinder(Struct, frozen=True):
    """Finds the models that have a ``fiducial_return`` and the same key."""

    minimum: float = 0.0
    maximum: float = 8.0
    maximum_id: float = 5.0
    """Metres up to which it also reads the marker's number."""
    fov: float = 180.0


class Bumper(Struct, frozen=True):
    """One bumper: a bar of that length across the direction in which its pose looks, touched or not."""

    pose: Placement
    length: float


class Camera(Struct, frozen=True):
    """Kept so that its field of view can be drawn; no picture is made."""

    minimum: float = 0.2
    maximum: float = 8.0
    fov: tuple[float, float] = (70.0, 40.0)
    """Degrees, across and up."""
    pan: float = 0.0
    tilt: float = 0.0


class Gripper(Struct, frozen=True):
    """Two paddles that close round a thing, and a lift. Proportions of the model's size, as in Stage."""

    paddle_length: float
    paddle_width: float
    paddle_height: float
    closed: bool
    lifted: bool
    autosnatch: bool
    """Whether it closes by itself round what breaks a beam."""


class Drive(Enum):
    DIFF = "diff"
    OMNI = "omni"
    CAR = "car"


class Localization(Enum):
    GPS = "gps"
    """It knows exactly where it is."""
    ODOM = "odom"
    """It counts its wheels' turns, with errors."""


Bounds = tuple[float, float]
"""The least and the most."""


class Limits(Struct, frozen=True):
    """Bounds of a velocity (or, a second more, of an acceleration): metres and degrees a second."""

    x: Bounds = (-1.0, 1.0)
    y: Bounds = (-1.0, 1.0)
    yaw: Bounds = (-90.0, 90.0)


class OdometryError(Struct, frozen=True):
    """The most that odometry is off, as a part of what is driven or turned.

    Of a value E a part between -E/2 and E/2 is drawn once at the start, as in Stage.
    """

    x: float = 0.03
    y: float = 0.03
    yaw: float = 0.05


class Wheels(Struct, frozen=True):
    """The drive of a position model, and its localization."""

    drive: Drive = Drive.DIFF
    localization: Localization = Localization.GPS
    localization_origin: Placement | None = None
    """None: the file gives none."""
    odom_error: OdometryError = field(default_factory=OdometryError)
    velocity_bounds: Limits | None = None
    """None: the file sets none; Stage's own are those of ``Limits``."""
    acceleration_bounds: Limits | None = None
    wheelbase: float = 1.0
    """Metres between the axles of a car."""


class LoadReport(Struct, frozen=True):
    """The result of loading a world file: models by type, and notes."""

    files: tuple[str, ...]
    loaded: tuple[tuple[str, int], ...]
    """Built-in type and how many models of it, most frequent first."""
    notes: tuple[Note, ...]
    pictures: tuple[str, ...] = ()
    """The pictures that became walls and floors."""


class Polygon(Struct, frozen=True):
    """A block of a model, in the model's frame."""

    points: tuple[Point, ...]
    bottom: float
    top: float


class Model(Struct, frozen=True):
    """A thing, or a part of one."""

    index: int
    type: str
    """One of Stage's types."""
    kind: str
    """The word that made it: the type, or a macro such as ``chair``."""
    name: str
    parent: int | None
    root: int
    pose: Placement
    """In the world, not in the parent."""
    origin: Placement
    size: tuple[float, float, float]
    colour: Colour
    obstacle_return: float
    ranger_return: float
    blob_return: float
    fiducial_return: float
    fiducial_key: int
    """A finder notices only what has its own key."""
    gripper_return: float
    pushable: bool
    """Whether a robot that drives against it moves it."""
    mass: float
    """Kilograms; 0 if the file gives none."""
    ignore_zloc: bool
    """Whether its sensors see things whatever their height."""
    boundary: bool
    bitmap: str
    polygons: tuple[Polygon, ...]
    stage_blocks: int
    """How many blocks Stage makes of it; it keeps a picture as outlines, we as rectangles."""
    walls: tuple[Polygon, ...]
    """The four thin ones of ``boundary``."""
    sensors: tuple[RangeSensor, ...]
    blobfinder: Blobfinder | None
    fiducial_finder: FiducialFinder | None
    bumpers: tuple[Bumper, ...]
    gripper: Gripper | None
    camera: Camera | None
    wheels: Wheels | None
    """Of position models only."""
    alias: str = ""
    """A robot's name here where its own is missing, is another robot's too, or can't be typed."""

    @property
    def spoken_name(self) -> str:
        """The robot's name in programs and sentences."""
        return self.alias or self.name

    @property
    def called(self) -> str:
        """That name; empty if the world gives the model only a number."""
        return "" if ":" in self.spoken_name else self.spoken_name

    def outlines(self) -> Iterator[tuple[Point, ...]]:
        """Its polygons and walls as they lie in the world."""
        for shape in (*self.polygons, *self.walls):
            yield placed(shape.points, self.pose.x, self.pose.y, self.pose.yaw)

    @property
    def stage_area(self) -> float:
        """Square metres of its blocks as Stage adds them up.

        Stage traces a picture clockwise and, if there is a picture, draws the walls of a boundary the other
        way round, so that their areas count against each other.
        """
        area = sum(abs(signed_area(shape.points)) for shape in self.polygons)
        if self.polygons and not self.bitmap:
            return area
        return abs(area - sum(abs(signed_area(wall.points)) for wall in self.walls))

    @property
    def solid(self) -> bool:
        """Whether a robot bumps into it. Walls are solid whatever the file says (that of Donnie says no)."""
        return self.obstacle_return != 0 or self.boundary or bool(self.bitmap)

    @property
    def grippable(self) -> bool:
        """Whether a gripper can take it."""
        return self.gripper_return != 0

    def heights(self) -> Iterator[tuple[float, float]]:
        """Bottom and top of each of its outlines above the floor, in the same order."""
        for shape in (*self.polygons, *self.walls):
            yield self.pose.z + shape.bottom, self.pose.z + shape.top

    @property
    def seen(self) -> bool:
        """Whether rangers see it: a mark on the floor is not seen, whatever its ``ranger_return``."""
        return self.ranger_return >= 0 and (self.solid or self.size[2] > 0.02)


class Scene(Struct, frozen=True):
    """A whole world. A model's ``index``, ``parent`` and ``root`` count into ``models``."""

    name: str
    models: tuple[Model, ...]
    """In Stage's order: a parent before its children."""
    robots: tuple[int, ...]
    """Indices of the models that GoDonnie can program; the first one is the learner's."""
    settings: Mapping[str, float | str | tuple[object, ...]]
    """The world's own properties, such as ``resolution``; tuples are Python tuples."""
    report: LoadReport

    def tree(self, root: int) -> tuple[Model, ...]:
        """A top-level model and everything attached to it."""
        return tuple(model for model in self.models if model.root == root)

    @property
    def robot_names(self) -> tuple[str, ...]:
        """The robots' names, in their order; no two are equal."""
        return tuple(self.models[index].spoken_name for index in self.robots)

    def robot(self, name: str) -> Model:
        """The robot of that name. KeyError if there is none."""
        for index in self.robots:
            if self.models[index].spoken_name == name:
                return self.models[index]
        raise KeyError(name)


def moved(scene: Scene, places: Mapping[int, Placement]) -> Scene:
    """The scene with these top-level models, by index, and all that is attached to them, at other places."""
    if not places:
        return scene
    models = tuple(
        _carried(model, scene.models[model.root].pose, places[model.root]) if model.root in places else model
        for model in scene.models
    )
    return replace(scene, models=models)


def _carried(model: Model, before: Placement, now: Placement) -> Model:
    """It keeps its height."""
    there = now.then(relative(model.pose, before))
    return replace(model, pose=replace(there, z=model.pose.z))
