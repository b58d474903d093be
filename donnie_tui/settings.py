"""What can be chosen, and where a choice came from: command line, environment, settings file, default."""

from __future__ import annotations

from dataclasses import dataclass

FRONT_END_SPEED = 5.0
"""Times the real robot's pace in the front ends; ``donnie run`` is unlimited unless told otherwise."""


@dataclass(frozen=True, slots=True)
class Settings:
    """The choices of one start. ``speed`` None is as fast as possible; ``events`` a file or ``-``."""

    world: str = "open_floor"
    robot: str = "sim"
    language: str = "en"
    speed: float | None = FRONT_END_SPEED
    seed: int = 0
    speech: str = "auto"
    sound: bool = True
    verbosity: str = "normal"
    events: str | None = None
