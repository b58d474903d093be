"""What the devices of a robot that is driven by velocities read: in metres, device by device.

``sensors`` answers the learner's questions with the same sensors, in steps and by bearing.
"""

from __future__ import annotations

from math import inf
from typing import TYPE_CHECKING

from devices.ports.drive import BlobReading, BumperReading, ColourBlob, Mark, MarkReading, RangerReading
from sim.cameras import MarkFinder, Sight, View
from sim.colours import Colour
from sim.geometry import Placement, Spot, normal
from sim.motion import Surroundings
from sim.rangers import Bar, Ranger
from sim.scene import Model
from sim.sensors import bumpers_of, finders_of, fixed_view, rangers_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from random import Random

    from sim.parts import Part

    Hits = tuple[tuple[float, Part | None], ...]


class Instruments:
    """The devices that are mounted in one frame, in the order of the world file."""

    def __init__(self, models: Iterable[Model], frame: Placement) -> None:
        """``frame``: where the robot, or its head, is at the start."""
        self._rangers: list[tuple[str, tuple[Ranger, ...]]] = []
        self._bumpers: list[tuple[str, tuple[Bar, ...]]] = []
        self._views: list[tuple[str, View]] = []
        self._finders: list[tuple[str, MarkFinder]] = []
        for model in models:
            one = (model,)
            if model.sensors:
                self._rangers.append((model.name, tuple(rangers_of(one, frame))))
            if model.bumpers:
                self._bumpers.append((model.name, tuple(bumpers_of(one, frame))))
            if model.blobfinder is not None:
                self._views.append((model.name, fixed_view(model, frame)))
            self._finders.extend((model.name, finder) for finder in finders_of(one, frame))

    def rangers(self, around: Surroundings, spot: Spot, chance: Random | None) -> tuple[RangerReading, ...]:
        """``chance``: of their noise; None has none."""
        found = []
        for name, sensors in self._rangers:
            hits = [each.hits(around, spot) for each in sensors]
            samples = (
                _samples(each, hit, around, spot, chance) for each, hit in zip(sensors, hits, strict=True)
            )
            returns = tuple(
                tuple(part.model.ranger_return if part else 0.0 for _, part in hit) for hit in hits
            )
            found.append(RangerReading(name, tuple(samples), returns))
        return tuple(found)

    def bumpers(self, around: Surroundings, spot: Spot) -> tuple[BumperReading, ...]:
        return tuple(
            BumperReading(name, tuple(bar.is_pressed(around, spot) for bar in bars))
            for name, bars in self._bumpers
        )

    def blobs(self, around: Surroundings, spot: Spot) -> tuple[BlobReading, ...]:
        return tuple(
            BlobReading(name, tuple(map(_blob, sorted(view.sights(around, spot), key=_from_left))))
            for name, view in self._views
        )

    def marks(
        self, around: Surroundings, spot: Spot, yaw_of: Callable[[int], float]
    ) -> tuple[MarkReading, ...]:
        """``yaw_of``: where a model looks now, by its index."""
        return tuple(
            MarkReading(
                name,
                tuple(
                    Mark(
                        each.number,
                        normal(each.degrees - finder.yaw),
                        each.metres,
                        normal(yaw_of(each.model) - spot.yaw - finder.yaw),
                    )
                    for each in finder.look(around, spot)
                ),
            )
            for name, finder in self._finders
        )


def _samples(
    ranger: Ranger, hits: Hits, around: Surroundings, spot: Spot, chance: Random | None
) -> tuple[float, ...]:
    least, most = ranger.minimum, ranger.maximum
    metres = ranger.samples(around, spot, chance) if chance else [each for each, _ in hits]
    return tuple(most if each == inf else max(each, least) for each in metres)


def _from_left(sight: Sight) -> tuple[float, int]:
    return -sight.high, sight.root


def _blob(sight: Sight) -> ColourBlob:
    return ColourBlob(_rgb(sight.colour), sight.high, sight.low, sight.metres)


def _rgb(colour: Colour) -> tuple[int, int, int]:
    return round(colour.red * 255), round(colour.green * 255), round(colour.blue * 255)
