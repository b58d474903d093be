"""A scan with the sonar on the head: where it looks, and which of its measurements are one thing.

A sonar tells that something is there, and neither its colour nor its name.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import inf

from devices.ports.robot import STEP, Sighting

AHEAD = 90
"""The servo's angle for straight ahead; 0 is full left, 180 full right."""
SAME_THING = 10.0
"""Centimetres by which two neighbouring measurements of one thing may differ."""

Met = tuple[int, float | None]
"""Degrees to the right, and the centimetres that were measured there."""


def angles(stride: int) -> range:
    """Degrees from the robot's front, positive to the right, from left to right."""
    return range(-AHEAD, AHEAD + 1, stride)


def sightings(met: Iterable[Met]) -> tuple[Sighting, ...]:
    """Neighbours that are equally far are one thing: in their middle, and as near as the nearest."""
    things: list[list[tuple[int, float]]] = []
    before: float = inf
    for degrees, told in met:
        far = inf if told is None else told
        if far < inf:
            if abs(far - before) <= SAME_THING:
                things[-1].append((degrees, far))
            else:
                things.append([(degrees, far)])
        before = far
    return tuple(_sighting(thing) for thing in things)


def _sighting(thing: Sequence[tuple[int, float]]) -> Sighting:
    middle = (thing[0][0] + thing[-1][0]) / 2
    return Sighting(middle, min(far for _, far in thing) / (STEP * 100), "", "")
