"""Where the things of a simulated world are now, in steps and compass degrees; published when it changes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from devices.ports.robot import STEP, Pose
from donnie_tui.core.events import PlacedThing

if TYPE_CHECKING:
    from sim.geometry import Placement
    from sim.world import World


class ThingWatch:
    """One for all robots of a world. The robot that has the turn asks it."""

    def __init__(self, world: World) -> None:
        self._world = world
        self._told: tuple[PlacedThing, ...] = ()

    def __call__(self) -> tuple[PlacedThing, ...] | None:
        """All that are not at their start; None if nothing has changed since the last answer."""
        moved = self._world.moved_things()
        if not moved and not self._told:
            return None
        models = self._world.scene.models
        places = tuple(PlacedThing(models[index].name, _pose(moved[index]), index) for index in sorted(moved))
        if places == self._told:
            return None
        self._told = places
        return places


def _pose(placement: Placement) -> Pose:
    heading = round((90.0 - placement.yaw) % 360.0, 6) % 360.0
    return Pose(round(placement.x / STEP, 6) + 0.0, round(placement.y / STEP, 6) + 0.0, heading)
