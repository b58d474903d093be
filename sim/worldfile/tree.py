"""What a world file says, as it was written: nothing is looked up and nothing has a meaning yet."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias


@dataclass(frozen=True, slots=True)
class Number:
    line: int
    column: int
    value: float


@dataclass(frozen=True, slots=True)
class String:
    line: int
    column: int
    text: str


@dataclass(frozen=True, slots=True)
class Tuple:
    line: int
    column: int
    items: tuple[Value, ...]


Value: TypeAlias = Number | String | Tuple


@dataclass(frozen=True, slots=True)
class Property:
    """``name value``."""

    line: int
    column: int
    name: str
    value: Value


@dataclass(frozen=True, slots=True)
class Instance:
    """``type ( ... )``."""

    line: int
    column: int
    type: str
    body: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class Define:
    """``define name base ( ... )``."""

    line: int
    column: int
    name: str
    base: str
    body: tuple[Item, ...]
    base_line: int
    base_column: int


@dataclass(frozen=True, slots=True)
class Include:
    """``include "path"``; the place is that of the path."""

    line: int
    column: int
    path: str


Item: TypeAlias = Property | Instance
Statement: TypeAlias = Property | Instance | Define | Include
