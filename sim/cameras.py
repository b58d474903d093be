"""Cameras: which coloured things are seen, where and how far, and fiducial markers.

A nearer thing hides what is behind it. A marker is a model with a ``fiducial_return``: it is seen with
direction and distance and, within a shorter range, with its number.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Container, Iterable, Iterator
from itertools import accumulate, pairwise
from math import dist, hypot

from msgspec import Struct

from devices.ports.robot import CENTIMETRES_A_STEP
from sim.colours import Colour
from sim.geometry import (
    HAIR,
    Spot,
    angle_of,
    at_radius,
    direction,
    edges,
    nearest_in_wedge,
    normal,
    seen_from,
)
from sim.parts import Part
from sim.rangers import Around, Height, at_height, first_hits
from sim.scene import FiducialFinder

HALF_CIRCLE = 90.0
"""Degrees to either side that a head with a camera turns."""
_SAME = 1e-9
"""Degrees between directions that count as one."""


class Seen(Struct, frozen=True):
    """A thing in view."""

    root: int
    degrees: float
    """Counter-clockwise from the robot's front."""
    centimetres: int
    colour: Colour

    @property
    def steps(self) -> float:
        return self.centimetres / CENTIMETRES_A_STEP


class Sight(Struct, frozen=True):
    """A thing as one camera sees it."""

    root: int
    low: float
    """Degrees of its right border, counter-clockwise from the middle of the view."""
    high: float
    metres: float
    """From the camera to its nearest point."""
    colour: Colour


class View(Struct, frozen=True):
    """The field of view of a camera, in the robot's frame."""

    x: float
    y: float
    yaw: float
    half_angle: float
    maximum: float
    offset: float
    """Metres from (x, y) from which distances and the range count: those to a head's sonar."""
    colours: tuple[Colour, ...]
    """Empty: all."""
    height: Height = None

    def distinguishes(self, part: Part) -> bool:
        return part.blob and (not self.colours or any(colour.same(part.colour) for colour in self.colours))

    def look(self, around: Around, spot: Spot) -> Iterator[Seen]:
        """Every visible thing once; what is hidden behind a nearer thing is not seen."""
        for sight in self.sights(around, spot):
            degrees = normal((sight.low + sight.high) / 2 + self.yaw)
            centimetres = int(max(0.0, sight.metres - self.offset) * 100 + 0.5)
            yield Seen(sight.root, degrees, centimetres, sight.colour)

    def sights(self, around: Around, spot: Spot) -> Iterator[Sight]:
        """As ``look``, with the borders of each thing."""
        place, reach = spot.mounted(self.x, self.y, self.yaw), self.maximum + self.offset
        box = around.within(place.x - reach, place.y - reach, place.x + reach, place.y + reach)
        parts = [part for part in box if at_height(part, self.height)]
        coloured = {part for part in parts if self.distinguishes(part)}
        if not coloured:
            return
        sectors = _sectors(parts, coloured, place, reach, self.half_angle)
        middles = (direction(place.yaw + (low + high) / 2) for low, high in sectors)
        ends = [(place.x + reach * dx, place.y + reach * dy) for dx, dy in middles]
        hits = first_hits(around, place.x, place.y, ends, self.height)
        glimpses: dict[int, list[_Glimpse]] = {}
        for (low, high), (part, _) in zip(sectors, hits, strict=True):
            if part in coloured:
                seen = glimpses.setdefault(part.root, [])
                if seen and seen[-1].is_followed_by(part, low, high):
                    low = seen.pop().low
                seen.append(_Glimpse(part, low, high))
        for root, seen in glimpses.items():
            yield self._thing(root, seen, place)

    def _thing(self, root: int, glimpses: list[_Glimpse], place: Spot) -> Sight:
        """The sighting of a thing; its widest unbroken stretch gives its place."""
        found = ((it.nearest(place), it.part.colour) for it in glimpses)
        metres, colour = min(found, key=lambda pair: pair[0])
        low, high = max(_stretches(glimpses), key=lambda stretch: stretch[1] - stretch[0])
        return Sight(root, low, high, metres, colour)


class _Glimpse(Struct, frozen=True):
    """A range of directions, in degrees from the middle of the view, in which one part is visible."""

    part: Part
    low: float
    high: float

    def is_followed_by(self, part: Part, low: float, high: float) -> bool:
        """Whether the next sector shows more of it, and both are narrow enough for one wedge."""
        return part is self.part and low == self.high and high - self.low <= HALF_CIRCLE

    def nearest(self, place: Spot) -> float:
        middle = place.yaw + (self.low + self.high) / 2
        outline = edges(seen_from(self.part.points, place.x, place.y, middle))
        return nearest_in_wedge(outline, (self.high - self.low) / 2)


def _stretches(glimpses: list[_Glimpse]) -> list[tuple[float, float]]:
    """Neighbouring glimpses joined, also across the direction straight behind."""
    stretches = [(glimpses[0].low, glimpses[0].high)]
    for glimpse in glimpses[1:]:
        low, high = stretches[-1]
        if glimpse.low > high:
            stretches.append((glimpse.low, glimpse.high))
        else:
            stretches[-1] = (low, glimpse.high)
    if len(stretches) > 1 and stretches[0][0] == -180.0 and stretches[-1][1] == 180.0:
        (_, high), (low, _) = stretches[0], stretches[-1]
        stretches = [*stretches[1:-1], (low, high + 360.0)]
    return stretches


def _sectors(
    parts: Iterable[Part], coloured: Container[Part], place: Spot, reach: float, half_angle: float
) -> list[tuple[float, float]]:
    """Directions between which the view can't change; to a degree if things cross each other.

    Covers only coloured things, since the camera distinguishes nothing else.
    """
    whole = int(half_angle)
    angles = {-half_angle, half_angle, *map(float, range(-whole, whole + 1))}
    wanted = list[tuple[float, float]]()
    for part in parts:
        outline = edges(seen_from(part.points, place.x, place.y, place.yaw))
        ends = [angle_of(x, y) for _, _, x, y in outline]
        angles.update(ends)
        if dist(part.middle, (place.x, place.y)) + part.reach > reach - HAIR:
            angles.update(angle_of(x, y) for edge in outline for x, y in at_radius(reach, edge))
        if part in coloured:
            wanted += map(_ordered, ends, [*ends[-1:], *ends])
    inside = sorted(angle for angle in angles if -half_angle <= angle <= half_angle)
    borders = [angle for i, angle in enumerate(inside) if i == 0 or angle - inside[i - 1] > _SAME]
    begun = [0] * len(borders)
    """By border, how many more edges of coloured parts begin than end there."""
    last = len(borders) - 1
    for low, high in wanted:
        is_behind = high - low > 180.0  # straight behind it, where 180 is -180
        for first, end in ((-180.0, low), (high, 180.0)) if is_behind else ((low, high),):
            begun[min(bisect_left(borders, first - _SAME), last)] += 1
            begun[max(bisect_right(borders, end + _SAME) - 1, 0)] -= 1
    return [sector for sector, count in zip(pairwise(borders), accumulate(begun), strict=False) if count]


def _ordered(one: float, other: float) -> tuple[float, float]:
    return (one, other) if one < other else (other, one)


class Found(Struct, frozen=True):
    """A mark in view."""

    model: int
    """The index of the model that carries it."""
    degrees: float
    """Counter-clockwise from the robot's front."""
    metres: float
    """From the finder to the model's place."""
    number: int
    """Its ``fiducial_return``; 0 if it is too far away to be read."""

    @property
    def steps(self) -> float:
        return int(self.metres * 100 + 0.5) / CENTIMETRES_A_STEP


class MarkFinder(Struct, frozen=True):
    """A fiducial finder at its place in the robot's frame."""

    x: float
    y: float
    yaw: float
    finder: FiducialFinder
    key: int
    height: Height = None

    def look(self, around: Around, spot: Spot) -> tuple[Found, ...]:
        """Every visible mark with its key, from left to right."""
        place, reach = spot.mounted(self.x, self.y, self.yaw), self.finder.maximum
        parts = around.within(place.x - reach, place.y - reach, place.x + reach, place.y + reach)
        marks = {part.model.index: part for part in parts if self._is_mark(part)}
        found = (self._found(around, place, part) for part in marks.values())
        return tuple(sorted((each for each in found if each), key=lambda it: (-it.degrees, it.model)))

    def _is_mark(self, part: Part) -> bool:
        model = part.model
        return model.fiducial_return != 0 and model.fiducial_key == self.key and at_height(part, self.height)

    def _found(self, around: Around, place: Spot, mark: Part) -> Found | None:
        ((x, y),) = seen_from((mark.place,), place.x, place.y, place.yaw)
        metres, degrees = hypot(x, y), angle_of(x, y)
        if metres > self.finder.maximum or abs(degrees) > self.finder.fov / 2:
            return None
        ((first, _),) = first_hits(around, place.x, place.y, (mark.place,), self.height)
        if first is not None and first.root != mark.root:
            return None
        number = int(mark.model.fiducial_return) if metres < self.finder.maximum_id else 0
        turned = (degrees + self.yaw + 180.0) % 360.0 - 180.0
        return Found(mark.model.index, turned, max(metres, self.finder.minimum), number)
