"""A world as it was loaded: models, shapes, sensors. Values only; nothing here moves or reads files.

Metres, and degrees counter-clockwise from the x axis, as Stage has them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from sim.colours import Colour
from sim.geometry import Point, direction, placed, signed_area
from sim.report import LoadReport


@dataclass(frozen=True, slots=True)
class Placement:
    """Where something stands and where it looks."""

    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    yaw: float = 0.0

    def then(self, inner: Placement, lift: float = 0.0) -> Placement:
        """Where ``inner``, given relative to this, is outside; ``lift`` is added to its height."""
        c, s = direction(self.yaw)
        return Placement(
            self.x + c * inner.x - s * inner.y,
            self.y + s * inner.x + c * inner.y,
            self.z + lift + inner.z,
            self.yaw + inner.yaw,
        )


@dataclass(frozen=True, slots=True)
class Polygon:
    """A block of a model, in the model's frame."""

    points: tuple[Point, ...]
    bottom: float
    top: float


@dataclass(frozen=True, slots=True)
class RangeSensor:
    """One sensor of a ranger, in the ranger's frame."""

    pose: Placement = field(default_factory=Placement)
    minimum: float = 0.0
    maximum: float = 5.0
    fov: float = 5.729577951308232
    """Degrees; the default is Stage's tenth of a radian."""
    samples: int = 1


@dataclass(frozen=True, slots=True)
class Blobfinder:
    """What a blobfinder tells apart."""

    maximum: float
    fov: float
    colours: tuple[Colour, ...]
    """Empty: every colour."""


@dataclass(frozen=True, slots=True)
class Model:
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
    gripper_return: float
    boundary: bool
    bitmap: str
    polygons: tuple[Polygon, ...]
    walls: tuple[Polygon, ...]
    """The four thin ones of ``boundary``."""
    sensors: tuple[RangeSensor, ...]
    blobfinder: Blobfinder | None

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
        if not self.bitmap:
            return area
        return abs(area - sum(abs(signed_area(wall.points)) for wall in self.walls))

    @property
    def solid(self) -> bool:
        """Whether a robot bumps into it. Walls are solid whatever the file says (that of Donnie says no)."""
        return self.obstacle_return != 0 or self.boundary or bool(self.bitmap)

    @property
    def seen(self) -> bool:
        """Whether rangers see it: a mark on the floor is not seen, whatever its ``ranger_return``."""
        return self.ranger_return >= 0 and (self.solid or self.size[2] > 0.02)


@dataclass(frozen=True, slots=True)
class Scene:
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

    def robot(self, name: str) -> Model:
        """The robot of that name. KeyError if there is none."""
        for index in self.robots:
            if self.models[index].name == name:
                return self.models[index]
        raise KeyError(name)
