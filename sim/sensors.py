"""What a robot senses: distances in cones, and coloured things in the half circle ahead. Computed when read.

Sensors tell centimetres, as the real sonars do; the caller cuts them to steps. Exact geometry, no sampling:
a cone sees the nearest point of every edge within it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise
from math import cos, hypot, inf, radians

from devices.ports.robot import FARTHEST, STEP, Bearing
from sim.colours import FAMILIES, Colour
from sim.geometry import (
    angle_of,
    at_radius,
    contains,
    direction,
    edges,
    nearest_in_wedge,
    normal,
    placed,
    seen_from,
)
from sim.physics import Part, Surroundings
from sim.scene import Scene

CENTIMETRES_A_STEP = round(STEP * 100)
WIDEST = 45.0
"""Degrees of a cone: a wide scanner serves each of the robot's bearings with a sector only."""


@dataclass(frozen=True, slots=True)
class Spot:
    """Where a robot is: metres, and degrees counter-clockwise from the x axis."""

    x: float
    y: float
    yaw: float

    def ahead(self, metres: float, angle: float) -> Spot:
        """The spot that lies that far in the direction ``angle`` (of the world), looking the same way."""
        dx, dy = direction(angle)
        return Spot(self.x + metres * dx, self.y + metres * dy, self.yaw)


@dataclass(frozen=True, slots=True)
class Cone:
    """A range sensor where it is mounted, in the robot's frame."""

    x: float
    y: float
    yaw: float
    half_angle: float
    minimum: float
    maximum: float

    @property
    def bearing(self) -> Bearing:
        """The direction that its mounting is nearest to; between two, the one further in front."""
        return min(Bearing, key=lambda b: (round(abs(normal(b.value + self.yaw)), 6), abs(normal(b.value))))

    def centimetres(self, around: Surroundings, spot: Spot) -> int | None:
        """To the nearest thing in the cone, or None."""
        ((x, y),) = placed(((self.x, self.y),), spot.x, spot.y, spot.yaw)
        yaw = spot.yaw + self.yaw
        nearest = inf
        for part in self._candidates(around, x, y, yaw):
            if contains(part.points, x, y):
                nearest = 0.0
                break
            outline = edges(seen_from(part.points, x, y, yaw))
            nearest = min(nearest, nearest_in_wedge(outline, self.half_angle))
        return None if nearest > self.maximum else int(max(nearest, self.minimum) * 100 + 0.5)

    def _candidates(self, around: Surroundings, x: float, y: float, yaw: float) -> Iterator[Part]:
        reach = self.maximum / cos(radians(self.half_angle))
        corners = [direction(yaw + turn) for turn in (-self.half_angle, 0.0, self.half_angle)]
        xs, ys = [x, *(x + reach * dx for dx, _ in corners)], [y, *(y + reach * dy for _, dy in corners)]
        return (part for part in around.within(min(xs), min(ys), max(xs), max(ys)) if part.seen)


@dataclass(frozen=True, slots=True)
class Seen:
    """A thing in view."""

    root: int
    degrees: float
    """Counter-clockwise from the robot's front."""
    centimetres: int
    colour: Colour


@dataclass(frozen=True, slots=True)
class Eyes:
    """The colour camera on the head, which turns about the robot's centre."""

    maximum: float
    offset: float
    """Metres from the centre to the head's sonar, from which distances count."""
    colours: tuple[Colour, ...]
    """Empty: all."""

    @property
    def families(self) -> frozenset[str]:
        """The words of the language for what the camera tells apart."""
        return frozenset(colour.family for colour in self.colours) or frozenset(FAMILIES)

    def tells(self, part: Part) -> bool:
        return part.blob and (not self.colours or any(colour.same(part.colour) for colour in self.colours))

    def look(self, around: Surroundings, spot: Spot) -> tuple[Seen, ...]:
        """Every visible thing once, from left to right; what is hidden behind a nearer thing is not seen."""
        reach = self.maximum + self.offset
        parts = around.near(spot.x, spot.y, reach)
        if not any(self.tells(part) for part in parts):
            return ()
        glimpses: dict[int, list[_Glimpse]] = {}
        for low, high in pairwise(_directions(parts, spot, reach)):
            glimpse = self._glimpse(around, spot, reach, low, high)
            if glimpse is not None:
                glimpses.setdefault(glimpse.part.root, []).append(glimpse)
        things = (self._thing(root, seen, spot) for root, seen in glimpses.items())
        return tuple(sorted(things, key=lambda thing: (-thing.degrees, thing.root)))

    def _glimpse(
        self, around: Surroundings, spot: Spot, reach: float, low: float, high: float
    ) -> _Glimpse | None:
        dx, dy = direction(spot.yaw + (low + high) / 2)
        ((part, _),) = around.first_hits(spot.x, spot.y, [(spot.x + reach * dx, spot.y + reach * dy)])
        return _Glimpse(part, low, high) if part is not None and self.tells(part) else None

    def _thing(self, root: int, glimpses: list[_Glimpse], spot: Spot) -> Seen:
        """What is seen of one thing: its widest unbroken stretch tells where it is."""
        nearest = min(((glimpse.nearest(spot), glimpse.part.colour) for glimpse in glimpses), key=_first)
        low, high = max(_stretches(glimpses), key=lambda stretch: stretch[1] - stretch[0])
        metres = max(0.0, nearest[0] - self.offset)
        return Seen(root, (low + high) / 2, int(metres * 100 + 0.5), nearest[1])


@dataclass(frozen=True, slots=True)
class _Glimpse:
    """A range of directions, in degrees from the front, in which one part is what is seen."""

    part: Part
    low: float
    high: float

    def nearest(self, spot: Spot) -> float:
        middle = spot.yaw + (self.low + self.high) / 2
        outline = edges(seen_from(self.part.points, spot.x, spot.y, middle))
        return nearest_in_wedge(outline, (self.high - self.low) / 2)


def _first(pair: tuple[float, Colour]) -> float:
    return pair[0]


def _stretches(glimpses: list[_Glimpse]) -> Iterator[tuple[float, float]]:
    """Neighbouring glimpses joined."""
    low, high = glimpses[0].low, glimpses[0].high
    for glimpse in glimpses[1:]:
        if glimpse.low > high:
            yield low, high
            low = glimpse.low
        high = glimpse.high
    yield low, high


def _directions(parts: Iterable[Part], spot: Spot, reach: float) -> list[float]:
    """Directions ahead between which the view can't change; where things cross each other, to a degree."""
    angles = {float(degrees) for degrees in range(-90, 91)}
    for part in parts:
        for ax, ay, bx, by in edges(seen_from(part.points, spot.x, spot.y, spot.yaw)):
            angles.add(angle_of(ax, ay))
            angles.update(angle_of(x, y) for x, y in at_radius(reach, (ax, ay, bx, by)))
    ahead = sorted(angle for angle in angles if -90.0 <= angle <= 90.0)
    return [angle for i, angle in enumerate(ahead) if i == 0 or angle - ahead[i - 1] > 1e-9]


@dataclass(frozen=True, slots=True)
class Senses:
    """All the sensors of one robot."""

    cones: tuple[Cone, ...]
    eyes: Eyes | None
    by_bearing: Mapping[Bearing, tuple[Cone, ...]]

    def at(self, bearing: Bearing) -> tuple[Cone, ...]:
        return self.by_bearing[bearing]

    def steps(self, around: Surroundings, spot: Spot, bearing: Bearing) -> int:
        """Whole steps to the nearest thing there, or as far as the sensors reach; no sensor sees nothing."""
        cones = self.at(bearing)
        if not cones:
            return FARTHEST
        readings = [cone.centimetres(around, spot) for cone in cones]
        near = [reading for reading in readings if reading is not None]
        farthest = max(int(cone.maximum * 100 + 0.5) for cone in cones)
        return min(near, default=farthest) // CENTIMETRES_A_STEP


def senses_of(scene: Scene, robot: int) -> Senses:
    """The sensors of a robot and of everything attached to it."""
    cones = tuple(_cones(scene, robot))
    by_bearing = {bearing: tuple(c for c in cones if c.bearing is bearing) for bearing in Bearing}
    return Senses(cones, _eyes(scene, robot, cones), by_bearing)


def _cones(scene: Scene, robot: int) -> Iterator[Cone]:
    frame = scene.models[robot].pose
    for model in scene.tree(robot):
        for sensor in model.sensors:
            place = model.pose.then(sensor.pose)
            ((x, y),) = seen_from(((place.x, place.y),), frame.x, frame.y, frame.yaw)
            half_angle = min(sensor.fov, WIDEST) / 2
            yaw = normal(place.yaw - frame.yaw)
            yield Cone(round(x, 9), round(y, 9), yaw, half_angle, sensor.minimum, sensor.maximum)


def _eyes(scene: Scene, robot: int, cones: tuple[Cone, ...]) -> Eyes | None:
    finders = [model.blobfinder for model in scene.tree(robot) if model.blobfinder is not None]
    if not finders:
        return None
    ahead = [hypot(cone.x, cone.y) for cone in cones if cone.bearing is Bearing.FRONT]
    colours = tuple(dict.fromkeys(colour for finder in finders for colour in finder.colours))
    if any(not finder.colours for finder in finders):
        colours = ()
    return Eyes(max(finder.maximum for finder in finders), max(ahead, default=0.0), colours)
