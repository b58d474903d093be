"""From metres and degrees counter-clockwise to the port's steps and compass degrees."""

from __future__ import annotations

from devices.ports.robot import STEP, Pose
from sim.sensors import Spot


def pose_of(spot: Spot) -> Pose:
    """Rounded far below what matters, so that three steps are not 2.9999; adding 0 makes -0 a plain 0."""
    heading = round((90.0 - spot.yaw) % 360.0, 9) % 360.0
    return Pose(round(spot.x / STEP, 9) + 0.0, round(spot.y / STEP, 9) + 0.0, heading)
