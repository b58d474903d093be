"""Events made again from the lines of a recording. Nothing in a line is trusted.

A line is parsed only if it is short enough and not deeply nested, since json recurses in C; every field must
have the type that the event has for it.
"""

from __future__ import annotations

import dataclasses
import json
import re
import types
import typing
from collections.abc import Mapping
from enum import Enum
from functools import cache
from math import isfinite

from donnie_tui.core.events import TRANSIENT, Event, RunStarted, Stamped, event_name

DEEPEST = 12
"""Brackets in brackets of a line; ours have five."""

_STRING = re.compile(r'"(?:[^"\\]|\\.)*"')
_BRACKETS = re.compile(r"[\[\]{}]")


class DamagedLineError(ValueError):
    """A line that is none of a recording."""


def parse_line(line: str) -> dict[str, object]:
    """The object that stands in a line. Raises ``DamagedLineError``."""
    if _is_deep(line):
        raise DamagedLineError("too deep")
    try:
        record = json.loads(line)
    except (ValueError, RecursionError):
        raise DamagedLineError("no JSON") from None
    if not isinstance(record, dict):
        raise DamagedLineError("no object")
    return record


def event_of(record: Mapping[str, object]) -> Stamped:
    """The event of a line. Raises ``DamagedLineError`` for a wrong name, a missing field, a wrong type."""
    kind = _kinds().get(str(record.get("event")))
    if kind is None:
        raise DamagedLineError("unknown event")
    event = typing.cast(Event, _made(kind, record))
    seq, t = _typed(int, record.get("seq")), _typed(float, record.get("t"))
    return Stamped(seq, t, event, _robot_of(event, record.get("robot")))


def _robot_of(event: Event, name: object) -> str | None:
    """A run always names its robot, also where the world has but one."""
    if isinstance(event, RunStarted) and not (event.how and event.how.named):
        return None
    return None if name is None else _typed(str, name)


@cache
def _kinds() -> Mapping[str, type]:
    """The events by the names that the stream has for them."""
    recorded = [kind for kind in typing.get_args(Event) if kind not in TRANSIENT]
    return {event_name(kind): kind for kind in recorded}


@cache
def _types_of(kind: type) -> Mapping[str, object]:
    hints = typing.get_type_hints(kind, localns={"ClassVar": typing.ClassVar})
    return {each.name: hints[each.name] for each in dataclasses.fields(kind)}


def _made(kind: type, record: object) -> object:
    """A dataclass from an object of JSON; a field that is left out has its default."""
    if not isinstance(record, dict):
        raise DamagedLineError(f"{kind.__name__} is no object")
    given = {name: _typed(type_, record[name]) for name, type_ in _types_of(kind).items() if name in record}
    try:
        return kind(**given)
    except TypeError:
        raise DamagedLineError(f"{kind.__name__} lacks a field") from None


def _typed(type_: typing.Any, value: object) -> typing.Any:  # the types and values of any field
    """The value, as the type has it. Raises ``DamagedLineError`` if it is of another one."""
    origin, inner = typing.get_origin(type_), typing.get_args(type_)
    if origin in (types.UnionType, typing.Union):  # an optional one
        return (
            None
            if value is None
            else _typed(next(each for each in inner if each is not types.NoneType), value)
        )
    if origin is tuple and isinstance(value, list):
        return tuple(_typed(inner[0], each) for each in value)
    if origin is Mapping and isinstance(value, dict):
        return {name: _typed(inner[1], each) for name, each in value.items()}
    if dataclasses.is_dataclass(type_):
        return _made(typing.cast(type, type_), value)
    if isinstance(type_, type) and issubclass(type_, Enum):
        return _member(type_, value)
    return _plain(type_, value)


def _member(type_: type[Enum], value: object) -> Enum:
    try:
        return type_(value)
    except ValueError:
        raise DamagedLineError(f"no {type_.__name__}") from None


def _plain(type_: object, value: object) -> object:
    if type_ is float and isinstance(value, int | float) and not isinstance(value, bool):
        number = _as_float(value)
        if isfinite(number):
            return number
    elif type_ in (int, str, bool) and type(value) is type_:
        return value
    raise DamagedLineError(f"a {type(value).__name__} is in the wrong place")


def _as_float(value: int | float) -> float:
    try:
        return float(value)
    except OverflowError:
        raise DamagedLineError("a number is too large") from None


def _is_deep(line: str) -> bool:
    depth = 0
    for bracket in _BRACKETS.findall(_STRING.sub("", line)):
        depth += 1 if bracket in "[{" else -1
        if depth > DEEPEST:
            return True
    return False
