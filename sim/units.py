"""From metres and degrees counter-clockwise to the port's steps and compass degrees."""

from __future__ import annotations

from math import copysign

from devices.ports.robot import STEP, Pose
from sim.sensors import Spot


def pose_of(spot: Spot) -> Pose:
    """Rounded far below what matters, so that three steps are not 2.9999."""
    heading = round((90.0 - spot.yaw) % 360.0, 9) % 360.0
    return Pose(_steps(spot.x), _steps(spot.y), heading)


def _steps(metres: float) -> float:
    steps = round(metres / STEP, 9)
    return copysign(steps, 1.0) if steps == 0 else steps
