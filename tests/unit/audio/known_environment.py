"""A speech environment with given facts."""

from __future__ import annotations

from msgspec import Struct


class KnownEnvironment(Struct, frozen=True):
    """The facts of a ``DetectedEnvironment``."""

    stdout_is_terminal: bool
    over_ssh: bool
    screen_reader: str | None
    has_voice: bool
    has_sound_device: bool
    has_ssip: bool = False
    is_linear: bool = True
    has_real_robot: bool = False
