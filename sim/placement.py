"""Where something stands and where it looks: metres, and degrees counter-clockwise from the x axis."""

from __future__ import annotations

from devices.ports.values import frozen
from sim.geometry import direction


@frozen
class Placement:
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
