"""Where a robot is: metres, and degrees counter-clockwise from the x axis."""

from __future__ import annotations

from devices.ports.values import frozen
from sim.geometry import direction, placed


@frozen
class Spot:
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
