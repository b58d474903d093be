"""Range sensors: sonars (a whole cone), lasers (a fan of thin rays), bumpers and gripper beams.

Stage's height test applies where a world wants it: with it a sensor sees only things between whose bottom and
top it looks. Those rays are computed here, edge by edge; the fast way (``rays``) knows no heights.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Sequence
from math import ceil, inf
from typing import TYPE_CHECKING, Protocol

from msgspec import Struct

from sim.geometry import (
    Edge,
    Point,
    Spot,
    Wedge,
    along,
    contains,
    direction,
    edges_apart,
    normal,
)
from sim.parts import NOTHING, Part, Sighted
from sim.scene import Gripper, RangeNoise

if TYPE_CHECKING:
    from random import Random

    from sim.rays import Hit


Height = float | None
"""Metres above the floor at which a sensor looks, or None: it sees things of every height."""


class Around(Protocol):
    """The world without the robot itself."""

    def within(self, left: float, bottom: float, right: float, top: float) -> Iterable[Part]:
        """All parts that come into a box, and perhaps some more, in order."""

    def first_hits(self, x: float, y: float, ends: Sequence[Point], ranging: bool = False) -> list[Hit[Part]]:
        """The parts that rays from one place to each of ``ends`` hit first, and where on the way."""

    def nearest(self, wedge: Wedge, height: Height) -> Sighted:
        """The nearest thing that a ranger at that height sees in a wedge, and how far it is."""


def at_height(part: Part, height: Height) -> bool:
    return height is None or part.bottom <= height <= part.top


def first_hits(
    around: Around, x: float, y: float, ends: Sequence[Point], height: Height, ranging: bool = False
) -> list[Hit[Part]]:
    """``Around.first_hits`` among the parts of that height."""
    if height is None:
        return around.first_hits(x, y, ends, ranging)
    parts = (part for part in _height_between(around, x, y, ends, ranging) if at_height(part, height))
    outlines = [(part, part.outline) for part in parts]
    return [_first(outlines, (x, y, *end)) for end in ends]


def _height_between(
    around: Around, x: float, y: float, ends: Sequence[Point], ranging: bool
) -> Iterator[Part]:
    xs, ys = [x, *(end[0] for end in ends)], [y, *(end[1] for end in ends)]
    for part in around.within(min(xs), min(ys), max(xs), max(ys)):
        if part.seen or (part.solid and not ranging):
            yield part


def _first(
    outlines: Iterable[tuple[Part, Sequence[Edge]]], ray: tuple[float, float, float, float]
) -> Hit[Part]:
    first, nearest = None, inf
    for part, outline in outlines:
        for edge in outline:
            alpha = along(ray, edge)
            if alpha < nearest:
                first, nearest = part, alpha
    return (first, nearest) if first is not None else (None, 1.0)


NARROW = 45.0
"""Degrees to either side, up to which a cone is one ``Wedge``."""
NO_NOISE = RangeNoise()


class Cone(Struct, frozen=True):
    """A range sensor where it is mounted, in the robot's frame."""

    x: float
    y: float
    yaw: float
    half_angle: float
    minimum: float
    maximum: float
    height: Height = None
    noise: RangeNoise = NO_NOISE

    def metres(self, around: Around, spot: Spot, turned: float = 0.0) -> float:
        """To the nearest thing in the cone, or infinity; the sensor turned by that many degrees."""
        return self.nearest(around, spot, turned)[0]

    def hits(self, around: Around, spot: Spot) -> tuple[tuple[float, Part | None], ...]:
        """The one distance, or infinity, and what is there."""
        return (self.nearest(around, spot),)

    def nearest(self, around: Around, spot: Spot, turned: float = 0.0) -> Sighted:
        """The nearest thing in the cone, if there is any, and how far it is."""
        its_x, its_y, half, yaw = self.x, self.y, self.half_angle, spot.yaw
        c, s = direction(yaw)
        yaw += self.yaw + turned
        x, y = spot.x + c * its_x - s * its_y, spot.y + s * its_x + c * its_y  # as ``Spot.mounted`` does it
        if half > NARROW:
            return self._nearest_of_wide(around, Spot(x, y, yaw))
        yaw = yaw - half + half  # rounded as the middle of the wedges of a wide cone is
        return around.nearest(Wedge(x, y, yaw, direction(yaw), direction(half), self.maximum), self.height)

    def _nearest_of_wide(self, around: Around, place: Spot) -> Sighted:
        """The same, wedge by wedge, of at most a half circle each."""
        x, y, most, half = place.x, place.y, self.maximum, self.half_angle
        count = ceil(half / 90.0)
        part_of_it = half / count
        yaws = [place.yaw - half + (2 * i + 1) * part_of_it for i in range(count)]
        wedges = [Wedge(x, y, yaw, direction(yaw), direction(part_of_it), most) for yaw in yaws]
        nearest, found = NOTHING
        for part in around.within(x - most, y - most, x + most, y + most):
            if part.seen and at_height(part, self.height):
                for wedge in wedges:
                    metres = wedge.metres(part.points, part.middle, part.reach, nearest)
                    if metres < nearest:
                        nearest, found = metres, part
        return (nearest, found) if nearest <= most else NOTHING

    def centimetres(self, around: Around, spot: Spot) -> int | None:
        """To the nearest thing in the cone, or None. Without noise."""
        return _centimetres(self, self.nearest(around, spot)[0])

    def noisy(self, around: Around, spot: Spot, chance: Random) -> int | None:
        """A reading as the sensor gives it, with its noise."""
        return _centimetres(self, self.samples(around, spot, chance)[0])

    def samples(self, around: Around, spot: Spot, chance: Random | None) -> tuple[float, ...]:
        """The one reading in metres, or infinity; with noise if there is ``chance``."""
        if chance is None:
            return (self.metres(around, spot),)
        turned = chance.uniform(-1, 1) * self.noise.angle if self.noise.angle else 0.0
        return (_blurred(self, self.metres(around, spot, turned), chance),)


class Fan(Struct, frozen=True):
    """Thin rays from one place, in the robot's frame: a laser, or the part of it that looks one way."""

    x: float
    y: float
    angles: tuple[float, ...]
    """Of the rays, counter-clockwise from the robot's front, in the order of the file."""
    minimum: float
    maximum: float
    height: Height = None
    noise: RangeNoise = NO_NOISE

    def rays(self, around: Around, spot: Spot, turned: float = 0.0) -> tuple[float, ...]:
        """Metres along each ray to what it meets first, or infinity."""
        return tuple(metres for metres, _ in self.hits(around, spot, turned))

    def hits(self, around: Around, spot: Spot, turned: float = 0.0) -> tuple[tuple[float, Part | None], ...]:
        """The same with what each ray meets."""
        place = spot.mounted(self.x, self.y, turned)
        inside = self._inside(around, place)
        if inside is not None:
            return ((0.0, inside),) * len(self.angles)
        hits = first_hits(around, place.x, place.y, self._ray_tips(place), self.height, ranging=True)
        return tuple((inf if part is None else self.maximum * alpha, part) for part, alpha in hits)

    def metres(self, around: Around, spot: Spot, turned: float = 0.0) -> float:
        """To the nearest thing that a ray meets, or infinity."""
        return min(self.rays(around, spot, turned))

    def centimetres(self, around: Around, spot: Spot) -> int | None:
        """To the nearest thing that a ray meets, or None. Without noise."""
        return _centimetres(self, self.metres(around, spot))

    def noisy(self, around: Around, spot: Spot, chance: Random) -> int | None:
        """The nearest reading as the sensor gives it, each ray with its noise."""
        return _centimetres(self, min(self.samples(around, spot, chance)))

    def samples(self, around: Around, spot: Spot, chance: Random | None) -> tuple[float, ...]:
        """The reading of each ray in metres, or infinity; with noise if there is ``chance``."""
        if chance is None:
            return self.rays(around, spot)
        turned = chance.uniform(-1, 1) * self.noise.angle if self.noise.angle else 0.0
        return tuple(_blurred(self, reading, chance) for reading in self.rays(around, spot, turned))

    def towards(self, bearing: float, half_angle: float) -> Fan | None:
        """The rays within ``half_angle`` of a direction, if there are any."""
        angles = tuple(a for a in self.angles if abs(normal(a - bearing)) <= half_angle + 1e-9)
        if not angles:
            return None
        return Fan(self.x, self.y, angles, self.minimum, self.maximum, self.height, self.noise)

    def _ray_tips(self, place: Spot) -> list[Point]:
        directions = (direction(place.yaw + angle) for angle in self.angles)
        return [(place.x + self.maximum * dx, place.y + self.maximum * dy) for dx, dy in directions]

    def _inside(self, around: Around, place: Spot) -> Part | None:
        """What the sensor itself is in."""
        parts = around.within(place.x, place.y, place.x, place.y)
        seen = (part for part in parts if part.seen and at_height(part, self.height))
        return next((part for part in seen if contains(part.points, place.x, place.y)), None)


Ranger = Cone | Fan


def fan_angles(yaw: float, fov: float, samples: int) -> tuple[float, ...]:
    """The directions of a laser's rays: from one border of its view to the other, as in Stage."""
    apart = fov / max(samples - 1, 1)
    return tuple(yaw - fov / 2 + i * apart for i in range(samples))


def _blurred(sensor: Ranger, metres: float, chance: Random) -> float:
    """A true distance with the sensor's noise; nothing in range stays nothing."""
    noise = sensor.noise
    if metres == inf or not (noise.constant or noise.proportional):
        return metres
    off = chance.uniform(-1, 1) * noise.constant + chance.uniform(-1, 1) * noise.proportional * metres
    blurred = max(0.0, metres + off)
    return blurred if blurred <= sensor.maximum else inf


def _centimetres(sensor: Ranger, metres: float) -> int | None:
    return None if metres == inf else int(max(metres, sensor.minimum) * 100 + 0.5)


TOUCH = 0.01
"""Metres: what is nearer to a bumper presses it."""


class Bar(Struct, frozen=True):
    """A bumper where it is mounted, in the robot's frame: a bar across the direction in which it looks."""

    x: float
    y: float
    yaw: float
    length: float

    def is_pressed(self, around: Around, spot: Spot, noticed: Container[int] = ()) -> bool:
        """Whether something solid touches it, or one of the ``noticed`` roots."""
        bar = self._bar(spot)
        found = (part for part in _near(around, bar) if part.solid or part.root in noticed)
        return any(_apart(bar, part) <= TOUCH for part in found)

    def _bar(self, spot: Spot) -> Edge:
        place = spot.mounted(self.x, self.y, self.yaw)
        left, right = (
            place.ahead(self.length / 2, place.yaw + 90),
            place.ahead(self.length / 2, place.yaw - 90),
        )
        return left.x, left.y, right.x, right.y


def _near(around: Around, bar: Edge) -> Iterable[Part]:
    ax, ay, bx, by = bar
    return around.within(min(ax, bx) - TOUCH, min(ay, by) - TOUCH, max(ax, bx) + TOUCH, max(ay, by) + TOUCH)


def _apart(bar: Edge, part: Part) -> float:
    if contains(part.points, bar[0], bar[1]):
        return 0.0
    return min((edges_apart(bar, edge) for edge in part.outline), default=inf)


class Beams(Struct, frozen=True):
    """The two light beams of a gripper where it is mounted, in the robot's frame."""

    x: float
    y: float
    yaw: float
    length: float
    """Metres of the gripper, along the direction in which it looks."""
    width: float
    gripper: Gripper
