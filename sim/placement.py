"""Where something stands and where it looks: metres, and degrees counter-clockwise from the x axis.

``pose_of`` tells it in the port's steps and compass degrees.
"""

from __future__ import annotations

from devices.ports.robot import STEP, Pose
from devices.ports.values import Frozen
from sim.geometry import direction, placed


class Placement(Frozen):
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

    def within_a_turn(self) -> Placement:
        """The same, its heading told from 0 to below 360."""
        return Placement(self.x, self.y, self.z, self.yaw % 360.0)


class Spot(Frozen):
    """Where a robot, or something on it, is and where it looks."""

    x: float
    y: float
    yaw: float

    def ahead(self, metres: float, angle: float) -> Spot:
        """The spot that lies that far in the direction ``angle`` (of the world), looking the same way."""
        dx, dy = direction(angle)
        return Spot(self.x + metres * dx, self.y + metres * dy, self.yaw)

    def mounted(self, x: float, y: float, yaw: float) -> Spot:
        """The spot of something that is mounted there, in the frame of this one."""
        ((outer_x, outer_y),) = placed(((x, y),), self.x, self.y, self.yaw)
        return Spot(outer_x, outer_y, self.yaw + yaw)


def pose_of(spot: Spot | Placement) -> Pose:
    """Rounded far below what matters, so that three steps are not 2.9999; adding 0 makes -0 a plain 0."""
    heading = round((90.0 - spot.yaw) % 360.0, 9) % 360.0
    return Pose(round(spot.x / STEP, 9) + 0.0, round(spot.y / STEP, 9) + 0.0, heading)
