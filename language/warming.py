"""Makes translated code fast from its first turn on.

CPython 3.11 specializes code only after it was entered eight times or went round in a ``for`` eight times.
A program is entered once, and its WHILE loops would stay slow for ever. So each unit is entered before it
runs, and left at its first checkpoint, before anything happened. Later versions do not need it and are not
harmed by it.
"""

from __future__ import annotations

from contextlib import suppress
from types import FunctionType
from typing import Any, NoReturn

from language.stack import DEEPEST_CALL, first_link
from language.translated_names import wanted_at
from language.units import Unit

_ENTRIES = 8


class _Left(Exception):
    """The unit was entered and left again."""


def warm_up(units: tuple[Unit, ...]) -> None:
    """Enter each unit often enough. Each begins with a checkpoint, or with a hook if it does anything."""
    attention: dict[str, Any] = {"flag": True, "check": _leave, "hook": _leave}
    for unit in units:
        attention |= {wanted_at(line): DEEPEST_CALL for line in unit.lines}
        function = FunctionType(unit.code, attention)
        for _ in range(_ENTRIES):
            with suppress(_Left):
                function(first_link(), *[0] * (unit.code.co_argcount - 1))


def _leave(*_place: int) -> NoReturn:
    raise _Left
