"""The syntax tree of a world file, as it was written: nothing is looked up yet."""

from __future__ import annotations

from typing import TypeAlias

from msgspec import Struct


class Number(Struct, frozen=True):
    line: int
    column: int
    value: float


class String(Struct, frozen=True):
    line: int
    column: int
    text: str


class Tuple(Struct, frozen=True):
    line: int
    column: int
    items: tuple[Value, ...]


Value: TypeAlias = Number | String | Tuple


class Property(Struct, frozen=True):
    """``name value``."""

    line: int
    column: int
    name: str
    value: Value


class Instance(Struct, frozen=True):
    """``type ( ... )``."""

    line: int
    column: int
    type: str
    body: tuple[Item, ...]


class Define(Struct, frozen=True):
    """``define name base ( ... )``."""

    line: int
    column: int
    name: str
    base: str
    body: tuple[Item, ...]
    base_line: int
    base_column: int


class Include(Struct, frozen=True):
    """``include "path"``; the place is that of the path."""

    line: int
    column: int
    path: str


Item: TypeAlias = Property | Instance
Statement: TypeAlias = Property | Instance | Define | Include
