"""What can be written behind ``donnie``: the names of commands and options, and what a line comes to."""

from __future__ import annotations

from types import SimpleNamespace

from devices.ports.hints import TYPE_CHECKING, TypeAlias
from devices.ports.values import Frozen

if TYPE_CHECKING:
    from argparse import Namespace

Arguments: TypeAlias = "SimpleNamespace | Namespace"
"""What was given, by name."""

COMMON = (
    "world",
    "robot",
    "lang",
    "speed",
    "seed",
    "speech",
    "sound",
    "verbosity",
    "record",
    "events",
    "belt",
)
"""The options that mean the same everywhere; their values are read in ``settings``."""

TO_COME = ("challenge",)
COMMANDS = (
    "run",
    "check",
    "format",
    "worlds",
    "world",
    "replay",
    "doctor",
    "devices",
    "stop",
    "calibrate",
    "serve",
    *TO_COME,
)


class WrongUsage(Exception):
    """The command line can't be understood: a code of the catalogue, and what it is about."""

    def __init__(self, code: str, what: str) -> None:
        super().__init__(code)
        self.code = code
        self.what = what


class Invocation(Frozen):
    """What was asked for."""

    command: str
    """Empty for the program itself."""
    options: dict[str, str]
    """The common ones that were given, by key."""
    arguments: Arguments
