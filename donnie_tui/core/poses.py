"""Poses as GoDonnie tells them: whole numbers, cut towards zero, headings from 0 to 359, eight directions."""

from __future__ import annotations

from devices.ports.robot import Pose

_SAME = 6
"""Decimals beyond which two places are the same: 2.9999999 steps are 3."""


def whole(value: float) -> int:
    """The integer part."""
    return int(round(value, _SAME))


def heading(pose: Pose) -> int:
    """Whole compass degrees, 0 to 359."""
    return whole(pose.heading) % 360


COMPASS = ("north", "northeast", "east", "southeast", "south", "southwest", "west", "northwest")
SIDES = ("front", "front-right", "right", "back-right", "back", "back-left", "left", "front-left")
"""As the robot stands."""
