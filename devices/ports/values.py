"""How values are made: ``@frozen`` is ``@dataclass(frozen=True, slots=True)``, its methods made when needed.

``@mutable`` is ``@dataclass(slots=True)`` in the same way.

The standard library writes and compiles six methods for each frozen dataclass as its module is imported, and
the house has hundreds, most of which a session never makes one of: that was half of the time to start. So a
class has its slots at once, its constructor with its first value, its comparison with the first one, and the
rest, the standard library's own, when it is asked for.

Rules: what the class defines or inherits itself is kept; values don't inherit from values.
"""

from __future__ import annotations

from _thread import RLock
from collections.abc import Callable, Mapping
from dataclasses import MISSING, Field, FrozenInstanceError, dataclass, field, fields
from typing import Any, TypeVar, dataclass_transform

T = TypeVar("T")

_unfinished: dict[type, type] = {}
"""The class with slots, and the one it was made from, which keeps the defaults."""
_finishing = RLock()


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def frozen(written: type[T]) -> type[T]:
    """The class as a frozen, slotted dataclass. TypeError if it inherits from another one."""
    return _slotted(written, _LATE, _AT_ONCE | _UNCHANGING)


@dataclass_transform(field_specifiers=(field,))
def mutable(written: type[T]) -> type[T]:
    """The class as a slotted dataclass that can change. TypeError if it inherits from another one."""
    return _slotted(written, _LATE | {"__hash__": None}, _AT_ONCE)


def _slotted(written: type[T], late: Mapping[str, Any], at_once: Mapping[str, Any]) -> type[T]:
    if any("__dataclass_fields__" in vars(base) for base in written.__mro__):
        raise TypeError(f"{written.__name__} must not inherit from a value")
    names = tuple(name for name, type_ in written.__annotations__.items() if "ClassVar" not in str(type_))
    body = dict(vars(written))
    for name in (*names, "__dict__", "__weakref__"):
        body.pop(name, None)
    late = {
        name: each for name, each in late.items() if getattr(written, name) in (None, getattr(object, name))
    }
    body |= {**late, **at_once, "__slots__": names, "__match_args__": names}
    slotted = type(written.__name__, written.__bases__, body)
    _unfinished[slotted] = written
    return slotted


def _first_value(self: Any, *arguments: Any, **values: Any) -> None:
    """In place of the constructor, which is made when the first value is."""
    with _finishing:
        for slotted in type(self).__mro__:
            if slotted in _unfinished:
                slotted.__init__ = _constructor(slotted, vars(_unfinished[slotted]))  # type: ignore[misc]
    self.__init__(*arguments, **values)


def _constructor(slotted: Any, written: Mapping[str, Any]) -> Any:
    """The function that the standard library would write, in a tenth of the time."""
    names, given = slotted.__slots__, {name: written[name] for name in slotted.__slots__ if name in written}
    if any(isinstance(each, Field) and (not each.init or each.kw_only is True) for each in given.values()):
        _finish(slotted)
        return vars(slotted)["__init__"]
    lines = [f"def __init__(self, {', '.join(names)}):"]
    for name in names:
        made_anew = isinstance(given.get(name), Field) and given[name].default_factory is not MISSING
        content = f"given[{name!r}].default_factory() if {name} is MISSING else {name}" if made_anew else name
        lines.append(f" put(self, {name!r}, {content})")
    lines.append(" self.__post_init__()" if hasattr(slotted, "__post_init__") else " return")
    made: dict[str, Any] = {}
    exec("\n".join(lines), {"put": object.__setattr__, "given": given, "MISSING": MISSING}, made)
    defaults = (each.default if isinstance(each, Field) else each for each in given.values())
    made["__init__"].__defaults__ = tuple(defaults)
    return made["__init__"]


def _late(name: str, make: Callable[[type], None]) -> Any:
    """A method that first has the real ones made, and then is the real one of that name."""

    def method(self: Any, *arguments: Any) -> Any:
        make(type(self))
        return getattr(self, name)(*arguments)

    return method


def _make_comparable(kind: type) -> None:
    """What the standard library would write for ``==`` and ``hash``, in a tenth of the time."""
    with _finishing:
        for slotted in kind.__mro__:
            if slotted not in _unfinished:
                continue
            given = vars(_unfinished[slotted])
            if any(_is_compared_its_own_way(given.get(name)) for name in slotted.__slots__):  # type: ignore[attr-defined]
                _finish(slotted)
                return
            for name, method in _comparison(slotted.__slots__).items():  # type: ignore[attr-defined]
                if vars(slotted).get(name) is _LATE[name]:
                    setattr(slotted, name, method)


def _is_compared_its_own_way(given: object) -> bool:
    return isinstance(given, Field) and not (given.compare and given.hash is None)


def _comparison(names: tuple[str, ...]) -> dict[str, Any]:
    contents = {who: "".join(f"{who}.{name}, " for name in names) for who in ("self", "other")}
    lines = (
        "def __eq__(self, other):",
        " if other.__class__ is not self.__class__: return NotImplemented",
        f" return ({contents['self']}) == ({contents['other']})",
        f"def __hash__(self): return hash(({contents['self']}))",
    )
    made: dict[str, Any] = {}
    exec("\n".join(lines), {}, made)
    return made


class _LateFields:
    """The fields are made when asked for; of a twin, so that the class stays as it was written."""

    def __get__(self, _: object, owner: type) -> Any:
        with _finishing:
            for slotted in owner.__mro__:
                if slotted in _unfinished:
                    body = {**vars(_unfinished[slotted])}
                    twin: type = dataclass(init=False, repr=False, eq=False)(type(slotted.__name__, (), body))
                    slotted.__dataclass_fields__ = vars(twin)["__dataclass_fields__"]  # type: ignore[attr-defined]
        return owner.__dataclass_fields__  # type: ignore[attr-defined] # no longer this one


def _finish(kind: type) -> None:
    with _finishing:
        for slotted in kind.__mro__:
            if slotted in _unfinished:
                is_frozen = slotted.__setattr__ is _refuse
                made = vars(dataclass(frozen=is_frozen, slots=True)(_unfinished[slotted]))
                for name in (*_LATE, "__dataclass_fields__"):
                    if name in vars(slotted):
                        setattr(slotted, name, made[name])
                del _unfinished[slotted]


def _refuse(self: object, name: str, *_: object) -> None:
    raise FrozenInstanceError(f"{type(self).__name__} is a value: {name!r} can't change")


def _state(self: Any) -> tuple[object, ...]:
    return tuple(getattr(self, each.name) for each in fields(self))


def _restore(self: Any, state: tuple[object, ...]) -> None:
    for each, content in zip(fields(self), state, strict=True):
        object.__setattr__(self, each.name, content)


_LATE = {
    "__init__": _first_value,
    "__repr__": _late("__repr__", _finish),
    "__eq__": _late("__eq__", _make_comparable),
    "__hash__": _late("__hash__", _make_comparable),
}
_AT_ONCE = {"__dataclass_fields__": _LateFields(), "__getstate__": _state, "__setstate__": _restore}
_UNCHANGING = {"__setattr__": _refuse, "__delattr__": _refuse}
