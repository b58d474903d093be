"""What a world file says, as it was written: nothing is looked up and nothing has a meaning yet."""

from __future__ import annotations

from typing import TypeAlias

from devices.ports.values import Frozen


class Number(Frozen):
    line: int
    column: int
    value: float


class String(Frozen):
    line: int
    column: int
    text: str


class Tuple(Frozen):
    line: int
    column: int
    items: tuple[Value, ...]


Value: TypeAlias = Number | String | Tuple


class Property(Frozen):
    """``name value``."""

    line: int
    column: int
    name: str
    value: Value


class Instance(Frozen):
    """``type ( ... )``."""

    line: int
    column: int
    type: str
    body: tuple[Item, ...]


class Define(Frozen):
    """``define name base ( ... )``."""

    line: int
    column: int
    name: str
    base: str
    body: tuple[Item, ...]
    base_line: int
    base_column: int


class Include(Frozen):
    """``include "path"``; the place is that of the path."""

    line: int
    column: int
    path: str


Item: TypeAlias = Property | Instance
Statement: TypeAlias = Property | Instance | Define | Include
