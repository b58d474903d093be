"""The eight directions, clockwise, as the catalogue's codes have them. Each is 45 degrees from the next."""

from __future__ import annotations

COMPASS = ("north", "northeast", "east", "southeast", "south", "southwest", "west", "northwest")
SIDES = ("front", "front-right", "right", "back-right", "back", "back-left", "left", "front-left")
"""As the robot stands."""
