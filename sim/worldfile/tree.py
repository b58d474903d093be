"""What a world file says, as it was written: nothing is looked up and nothing has a meaning yet."""

from __future__ import annotations

from typing import TypeAlias

from devices.ports.values import frozen


@frozen
class Number:
    line: int
    column: int
    value: float


@frozen
class String:
    line: int
    column: int
    text: str


@frozen
class Tuple:
    line: int
    column: int
    items: tuple[Value, ...]


Value: TypeAlias = Number | String | Tuple


@frozen
class Property:
    """``name value``."""

    line: int
    column: int
    name: str
    value: Value


@frozen
class Instance:
    """``type ( ... )``."""

    line: int
    column: int
    type: str
    body: tuple[Item, ...]


@frozen
class Define:
    """``define name base ( ... )``."""

    line: int
    column: int
    name: str
    base: str
    body: tuple[Item, ...]
    base_line: int
    base_column: int


@frozen
class Include:
    """``include "path"``; the place is that of the path."""

    line: int
    column: int
    path: str


Item: TypeAlias = Property | Instance
Statement: TypeAlias = Property | Instance | Define | Include
