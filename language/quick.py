"""Frozen values made as fast as open ones.

A frozen dataclass takes three times as long to make as an open one, and a program consists of them.
``quick`` answers an open twin with the same slots that turns what it makes into the frozen class. Turning
is a detail of CPython's layout of slots; where it is refused, the frozen class itself is the answer.
"""

from __future__ import annotations

from devices.ports.hints import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from typing import TypeVar

    T = TypeVar("T")


def quick(frozen: type[T]) -> type[T]:
    """A faster way to call the constructor of a frozen dataclass with slots, with all its fields by place."""
    names: tuple[str, ...] = frozen.__slots__  # type: ignore[attr-defined] # asking for fields takes longer
    lines = [f"def __init__(self, {', '.join(names)}):"]
    lines += [f"    self.{name} = {name}" for name in names]
    lines += ["    self.__class__ = frozen"]
    made: dict[str, Any] = {}  # Any: a function that exists at run time only
    exec("\n".join(lines), {"frozen": frozen}, made)
    open_ = {"__slots__": names, "__init__": made["__init__"], "__setattr__": object.__setattr__}
    twin: type[T] = type(frozen.__name__, frozen.__bases__, open_)
    return twin if _turns(twin, frozen, len(names)) else frozen


def _turns(twin: type[Any], frozen: type[Any], count: int) -> bool:
    try:
        return type(twin(*range(count))) is frozen
    except TypeError:
        return False
