"""A world as it was loaded: models, shapes, sensors. Values only; nothing here moves or reads files.

Metres, and degrees counter-clockwise from the x axis, as Stage has them.

What was ignored, repaired, or looks like a slip comes with it as codes (``LoadReport``); ``moved`` is the
same scene with things elsewhere than its file has them: pushed, carried, or driven there.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from devices.ports.hints import TYPE_CHECKING
from devices.ports.values import Frozen, replace
from sim.colours import Colour
from sim.fittings import Blobfinder, Bumper, Camera, FiducialFinder, Gripper, RangeSensor, Wheels
from sim.geometry import Point, direction, placed, signed_area
from sim.placement import Placement

if TYPE_CHECKING:
    from sim.notes import Note


class LoadReport(Frozen):
    """What became of a world file: models by type, and everything that is worth telling."""

    files: tuple[str, ...]
    loaded: tuple[tuple[str, int], ...]
    """Built-in type and how many models of it, most frequent first."""
    notes: tuple[Note, ...]
    pictures: tuple[str, ...] = ()
    """The pictures that became walls and floors."""


class Polygon(Frozen):
    """A block of a model, in the model's frame."""

    points: tuple[Point, ...]
    bottom: float
    top: float


class Model(Frozen):
    """One thing, or a part of one."""

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
    """Kilograms; 0 where the file gives none."""
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
        """What a robot is called by those who program it."""
        return self.alias or self.name

    def outlines(self) -> Iterator[tuple[Point, ...]]:
        """Its polygons and walls as they lie in the world."""
        for shape in (*self.polygons, *self.walls):
            yield placed(shape.points, self.pose.x, self.pose.y, self.pose.yaw)

    @property
    def stage_area(self) -> float:
        """Square metres of its blocks as Stage adds them up.

        Stage traces a picture clockwise and draws the walls of a boundary the other way round, beside a
        picture only, so that their areas count against each other.
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


class Scene(Frozen):
    """A whole world. A model's ``index``, ``parent`` and ``root`` count into ``models``."""

    name: str
    models: tuple[Model, ...]
    """In Stage's order: a parent before its children."""
    robots: tuple[int, ...]
    """Indices of the models that GoDonnie can program; the first one is the learner's."""
    settings: Mapping[str, object]
    """The world's own properties, such as ``resolution``; tuples are Python tuples."""
    report: LoadReport

    def tree(self, root: int) -> tuple[Model, ...]:
        """A top-level model and everything attached to it."""
        return tuple(model for model in self.models if model.root == root)

    @property
    def robot_names(self) -> tuple[str, ...]:
        """What the robots are called, in their order; no two are called the same."""
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
    c, s = direction(-before.yaw)
    dx, dy = model.pose.x - before.x, model.pose.y - before.y
    inner = Placement(c * dx - s * dy, s * dx + c * dy, model.pose.z - now.z, model.pose.yaw - before.yaw)
    return replace(model, pose=now.then(inner))
