"""From what the wheels counted and a person measured to the robot's real sizes. Pure; metres, degrees."""

from __future__ import annotations

from math import pi, radians


def wheel_radius(counts: float, counts_a_turn: int, metres: float) -> float:
    """Of a robot that walked so far while its wheels counted so much, on the average of both."""
    return metres * counts_a_turn / (2 * pi * counts)


def axle_length(counts: float, counts_a_turn: int, radius: float, degrees: float) -> float:
    """Of a robot that turned so far on the spot while each of its wheels counted so much."""
    rolled = 2 * pi * radius * counts / counts_a_turn
    return 2 * rolled / radians(degrees)
