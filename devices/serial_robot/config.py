"""What a certain robot is like. The defaults are the original's documented ones (docs/wire-protocol.md)."""

from __future__ import annotations

from math import pi

from devices.ports.robot import STEP, Bearing
from devices.ports.values import Frozen

_CLOCKWISE_FROM_FRONT_RIGHT = (
    Bearing.FRONT_RIGHT,
    Bearing.FRONT,
    Bearing.FRONT_LEFT,
    Bearing.BACK_LEFT,
    Bearing.BACK,
    Bearing.BACK_RIGHT,
)


class RobotConfig(Frozen):
    """Lengths in metres, angles in degrees, times in seconds. A calibration writes down the first three."""

    wheel_radius: float = 0.021
    axle_length: float = 0.068
    """Between the two wheels."""
    counts_a_turn: int = 900
    """Encoder counts of one turn of a wheel."""
    sonars: tuple[Bearing | None, ...] = _CLOCKWISE_FROM_FRONT_RIGHT
    """Where the board's sonars 0 to 5 look; None where one is not fitted. The original's sources disagree
    about 3 and 5."""
    head_sonar: int | None = 6
    """Which of the board's sonars sits on the head; None without a head."""
    front_bumpers: frozenset[int] = frozenset({0, 1, 2})
    """Which of the board's six bumper bits are in front: NE, N, NW."""
    back_bumpers: frozenset[int] = frozenset({3, 4, 5})
    """SE, S, SW."""
    bumper_degrees: tuple[float, ...] = (45.0, 0.0, -45.0, 135.0, 180.0, -135.0)
    """Where each of them is: from the robot's front, positive to the right."""
    farthest: float = 2.0
    """Sonars tell more than that unreliably: from 2.56 on, what is far looks near."""
    walk_coast: int = 8
    """Counts that the wheels go on for after a stop was sent, walking."""
    turn_coast: int = 5
    """The same, turning."""
    stall: float = 0.5
    """A wheel that doesn't count for so long, although it is told to turn, is stuck."""
    settle: float = 1.0
    """How long to wait for the wheels to stand, at the most."""
    poll: float = 0.02
    """Between two looks at the wheels."""
    head_pause: float = 0.6
    """For the head to get where it is told to, and its sonar to have measured there."""
    head_stride: int = 15
    """Between two looks of a scan."""

    @property
    def counts_a_step(self) -> float:
        """341.04 with the defaults."""
        return self.counts_a_turn * STEP / (2 * pi * self.wheel_radius)

    @property
    def counts_a_degree(self) -> float:
        """Of each wheel, turning on the spot; 4.048 with the defaults."""
        metres = pi * self.axle_length / 360
        return self.counts_a_turn * metres / (2 * pi * self.wheel_radius)
