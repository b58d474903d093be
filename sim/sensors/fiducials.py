"""Marks: models with a ``fiducial_return``, told by direction, distance and, when near enough, number."""

from __future__ import annotations

from math import hypot

from devices.ports.values import frozen
from sim.fittings import FiducialFinder
from sim.geometry import angle_of, seen_from
from sim.parts import Part
from sim.sensors.sight import Around, Height, at_height, first_hits
from sim.sensors.spot import Spot


@frozen
class Found:
    """A mark in view."""

    model: int
    """The index of the model that carries it."""
    degrees: float
    """Counter-clockwise from the robot's front."""
    metres: float
    """From the finder to the model's place."""
    number: int
    """Its ``fiducial_return``; 0 where it is too far off to be told."""


@frozen
class MarkFinder:
    """A fiducial finder where it is mounted, in the robot's frame."""

    x: float
    y: float
    yaw: float
    finder: FiducialFinder
    key: int
    height: Height = None

    def look(self, around: Around, spot: Spot) -> tuple[Found, ...]:
        """Every mark of its key that is in view and that nothing hides, from left to right."""
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
