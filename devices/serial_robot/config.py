"""The measures of a robot, and how a calibration derives them from counts of the wheels.

The defaults are the original's documented ones (docs/wire-protocol.md).
"""

from __future__ import annotations

from math import pi, radians

from msgspec import Struct
from msgspec.structs import replace

from devices.ports.robot import STEP, Bearing
from devices.wire.frames import AS_ORIGINAL, Wiring

_COUNTERCLOCKWISE_FROM_FRONT_RIGHT = (
    Bearing.FRONT_RIGHT,
    Bearing.FRONT,
    Bearing.FRONT_LEFT,
    Bearing.BACK_LEFT,
    Bearing.BACK,
    Bearing.BACK_RIGHT,
)


class RobotConfig(Struct, frozen=True):
    """Lengths in metres, angles in degrees, times in seconds. A calibration writes the first two."""

    wheel_radius: float = 0.021
    axle_length: float = 0.068
    """Between the two wheels."""
    counts_a_turn: int = 900
    """Encoder counts of one turn of a wheel."""
    sonars: tuple[Bearing | None, ...] = _COUNTERCLOCKWISE_FROM_FRONT_RIGHT
    """Directions of the board's sonars 0 to 5; None for one that is not fitted. The original's sources
    disagree about 3 and 5."""
    head_sonar: int | None = 6
    """The board's sonar that sits on the head; None without a head."""
    front_bumpers: frozenset[int] = frozenset({0, 1, 2})
    """Of the board's six bumper bits, those in front: NE, N, NW."""
    back_bumpers: frozenset[int] = frozenset({3, 4, 5})
    """SE, S, SW."""
    bumper_degrees: tuple[float, ...] = (45.0, 0.0, -45.0, 135.0, 180.0, -135.0)
    """Directions of the bumpers: from the robot's front, positive to the right."""
    farthest: float = 2.0
    """Sonars are unreliable beyond: from 2.56 on, what is far looks near."""
    diagonal_limit: float = 0.05
    """A walk forward ends where one of the two sonars at 45 degrees measures less, as in the original."""
    wiring: Wiring = AS_ORIGINAL
    finds_profile: bool = True
    """Whether the first movement may find out that the encoders count as with the firmware of 2018."""
    head_is_mirrored: bool = False
    """Whether the head's angle 0 is full right instead of full left."""
    walk_coast: int = 8
    """Counts that the wheels roll on after a stop was sent, walking."""
    turn_coast: int = 5
    """The same, turning."""
    stall: float = 0.5
    """A driven wheel that doesn't count for so long is stuck."""
    wrong_way: int = 60
    """Counts that a driven wheel may go back before its movement ends."""
    stop_timeout: float = 1.0
    """How long to wait for the wheels to stand, at most."""
    poll: float = 0.02
    """Between two checks of the wheels."""
    head_pause: float = 0.6
    """For the head to reach its angle, and its sonar to measure there."""
    head_stride: int = 15
    """Between two measurements of a scan."""

    def slower(self, factor: float) -> RobotConfig:
        """The same with longer timeouts, for a computer that lets this program wait for its turn."""
        return replace(self, stall=factor * self.stall, stop_timeout=factor * self.stop_timeout)

    def as_of_2018(self) -> RobotConfig:
        """The same robot with the newer firmware: its encoders count the other way, it walks at half the
        speed and turns at twice the speed, and the host's angles of the head are mirrored."""
        return replace(
            self,
            wiring=replace(self.wiring, encoders=(-1, -1)),
            finds_profile=False,
            head_is_mirrored=True,
            walk_coast=5,
            turn_coast=8,
        )

    @property
    def counts_a_step(self) -> float:
        """341.04 with the defaults."""
        return self.counts_a_turn * STEP / (2 * pi * self.wheel_radius)

    @property
    def counts_a_degree(self) -> float:
        """Of each wheel, turning on the spot; 4.048 with the defaults."""
        metres = pi * self.axle_length / 360
        return self.counts_a_turn * metres / (2 * pi * self.wheel_radius)


def wheel_radius(counts: float, counts_a_turn: int, metres: float) -> float:
    """Of a robot that walked ``metres`` while its wheels counted ``counts`` on average."""
    return metres * counts_a_turn / (2 * pi * counts)


def axle_length(counts: float, counts_a_turn: int, radius: float, degrees: float) -> float:
    """Of a robot that turned ``degrees`` on the spot while each of its wheels counted ``counts``."""
    rolled = 2 * pi * radius * counts / counts_a_turn
    return 2 * rolled / radians(degrees)
