"""Which motors of the belt stand for which direction of the robot.

Seven columns go round the body from the back over the left, the front (column 3) and the right to the
back again; both rows do the same.
"""

from __future__ import annotations

from devices.ports.robot import Bearing

COLUMNS = 7
OFF = (0,) * (2 * COLUMNS)
STRONG = 3

_COLUMNS_OF = {
    Bearing.BACK: (0, 6),
    Bearing.BACK_LEFT: (1,),
    Bearing.FRONT_LEFT: (2,),
    Bearing.FRONT: (3,),
    Bearing.FRONT_RIGHT: (4,),
    Bearing.BACK_RIGHT: (5,),
}


def pulse(bearing: Bearing) -> tuple[int, ...]:
    """14 levels: strong where that direction is felt, off elsewhere."""
    row = tuple(STRONG if column in _COLUMNS_OF[bearing] else 0 for column in range(COLUMNS))
    return row + row
