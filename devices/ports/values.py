"""How values are made: ``@frozen`` is ``@dataclass(frozen=True, slots=True)``, its methods made when needed.

``@mutable`` is ``@dataclass(slots=True)`` in the same way; ``field`` and ``replace`` are the standard
library's for such classes.

The standard library writes and compiles six methods for each frozen dataclass as its module is imported, and
the house has hundreds, of most of which a session makes a few values or none: that was half of the time to
start. So a class has its slots at once, a constructor of its own once it is worth writing, its comparison
with the first one, and the standard library's ``__dataclass_fields__`` when they are asked for;
``dataclasses`` itself, and ``inspect`` with it, is not loaded before.

Rules: what the class defines or inherits itself is kept; values don't inherit from values.
"""

from __future__ import annotations

from _thread import RLock
from collections.abc import Callable, Mapping
from operator import attrgetter
from reprlib import recursive_repr
from typing import TYPE_CHECKING, Any, TypeVar, dataclass_transform

T = TypeVar("T")

FEW = 30
"""As many values as are made one field at a time in the time that it takes to write a constructor, or so."""

_as_written: dict[type, type] = {}
"""The class with slots, and the one it was made from, which keeps the defaults."""
_made: dict[type, int] = {}
"""How many values were made of a class that has no constructor of its own yet."""
_making = RLock()
_MISSING = object()


class _Field:
    """What ``field`` was told."""

    __slots__ = ("has_default", "options")

    def __init__(self, options: Mapping[str, Any]) -> None:
        self.options = options
        self.has_default = "default" in options or "default_factory" in options

    def made(self) -> Any:
        """The content of a field that wasn't given one, or nothing but a mark that it must be."""
        make = self.options.get("default_factory")
        return make() if make else self.options.get("default", _MISSING)


if TYPE_CHECKING:
    from dataclasses import field as field
    from dataclasses import replace as replace
else:

    def field(**options: Any) -> Any:
        """As ``dataclasses.field``, for what differs in a field's content, comparison or repr only."""
        if unknown := options.keys() - {"default", "default_factory", "compare", "repr", "metadata"}:
            raise TypeError(f"a value's field has no {', '.join(sorted(unknown))}")
        return _Field(options)

    def replace(value: T, /, **changes: Any) -> T:
        """Another value of the same class, some of its fields changed. Only for values that are made here."""
        kept = {name: getattr(value, name) for name in value.__match_args__ if name not in changes}
        return type(value)(**kept, **changes)


def field_names(kind: type) -> tuple[str, ...]:
    """Of a class that is made here, in the order of its constructor."""
    names: tuple[str, ...] = _value_class(kind).__slots__
    return names


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
    for name in names:
        if type(body.pop(name, None)).__module__ == "dataclasses":
            raise TypeError(f"{written.__name__}.{name} must be a field of this module")
    for name in ("__dict__", "__weakref__"):
        body.pop(name, None)
    late = {
        name: each
        for name, each in late.items()
        if vars(written).get(name) is None and getattr(written, name) in (None, getattr(object, name))
    }
    body |= {**late, **at_once, "__slots__": names, "__match_args__": names}
    slotted = type(written.__name__, written.__bases__, body)
    slotted.__qualname__ = written.__qualname__
    _as_written[slotted] = written
    return slotted


def _value_class(kind: type) -> Any:
    """The class that is a value, of one that may inherit from it."""
    return next(each for each in kind.__mro__ if each in _as_written)


def _first_values(self: Any, *arguments: Any, **values: Any) -> None:
    """In place of the constructor, until one is worth writing; also where what was given is wrong."""
    kind = _value_class(type(self))
    _made[kind] = _made.get(kind, 0) + 1
    contents = _contents(kind, arguments, values) if _made[kind] <= FEW else None
    if contents is None:
        with _making:
            if kind.__init__ is _first_values:
                kind.__init__ = _constructor(kind)
        kind.__init__(self, *arguments, **values)
        return
    for name, content in zip(kind.__slots__, contents, strict=True):
        object.__setattr__(self, name, content)
    if hasattr(kind, "__post_init__"):
        self.__post_init__()


def _contents(kind: Any, arguments: tuple[Any, ...], values: Mapping[str, Any]) -> list[Any] | None:
    """Of all fields, in their order; None if too few, too many or unknown ones were given."""
    left = kind.__slots__[len(arguments) :]
    if len(arguments) + len(left) > len(kind.__slots__) or not values.keys() <= set(left):
        return None
    written = vars(_as_written[kind])
    contents = [*arguments]
    for name in left:
        content = values.get(name, written.get(name, _MISSING))
        if isinstance(content, _Field):
            content = content.made()
        if content is _MISSING:
            return None
        contents.append(content)
    return contents


def _constructor(kind: Any) -> Any:
    """The function that the standard library would write, in a tenth of the time."""
    names, written = kind.__slots__, vars(_as_written[kind])
    fields = {name: written[name] for name in names if isinstance(written.get(name), _Field)}
    lines = [f"def __init__(self, {', '.join(names)}):"]
    for name in names:
        content = f"fields[{name!r}].made() if {name} is MISSING else {name}" if name in fields else name
        lines.append(f" put(self, {name!r}, {content})")
    lines.append(" self.__post_init__()" if hasattr(kind, "__post_init__") else " return")
    made: dict[str, Any] = {}
    exec("\n".join(lines), {"put": object.__setattr__, "fields": fields, "MISSING": _MISSING}, made)
    made["__init__"].__defaults__ = tuple(
        _MISSING if name in fields else written[name]
        for name in names
        if name in written and (name not in fields or fields[name].has_default)
    )
    return made["__init__"]


def _late(name: str) -> Any:
    """A method of a comparison, which first has both made, and then is the real one of that name."""

    def method(self: Any, *arguments: Any) -> Any:
        kind = _value_class(type(self))
        for each, made in _comparison(kind).items():
            if vars(kind).get(each) is _LATE[each]:
                setattr(kind, each, made)
        return getattr(self, name)(*arguments)

    return method


def _comparison(kind: Any) -> Mapping[str, Any]:
    """``==`` and ``hash`` of the fields that are compared."""
    written = vars(_as_written[kind])
    names = [name for name in kind.__slots__ if _says(written.get(name), "compare")]
    contents: Callable[[Any], Any] = attrgetter("__class__", *names)  # two names at least make a tuple

    def equal(self: Any, other: object) -> Any:
        if other.__class__ is not self.__class__:
            return NotImplemented
        return contents(self) == contents(other)

    return {"__eq__": equal, "__hash__": lambda self: hash(contents(self))}


@recursive_repr()
def _repr(self: Any) -> str:
    kind = _value_class(type(self))
    written = vars(_as_written[kind])
    shown = (name for name in kind.__slots__ if _says(written.get(name), "repr"))
    return f"{type(self).__qualname__}({', '.join(f'{name}={getattr(self, name)!r}' for name in shown)})"


def _says(given: object, option: str) -> bool:
    """Whether a field takes part in what the ``option`` names, as it does unless it says otherwise."""
    return not isinstance(given, _Field) or given.options.get(option, True)


class _LateFields:
    """The fields are made when asked for; of a twin, so that the class stays as it was written."""

    def __get__(self, _: object, owner: type) -> Any:
        import dataclasses

        with _making:
            kind = _value_class(owner)
            if vars(kind)["__dataclass_fields__"] is self:
                body = {**vars(_as_written[kind])}
                given = {name: each for name, each in body.items() if isinstance(each, _Field)}
                body |= {name: dataclasses.field(**each.options) for name, each in given.items()}
                twin: type = dataclasses.dataclass(init=False, repr=False, eq=False)(
                    type(kind.__name__, (), body)
                )
                kind.__dataclass_fields__ = vars(twin)["__dataclass_fields__"]
        return kind.__dataclass_fields__


def _refuse(self: object, name: str, *_: object) -> None:
    from dataclasses import FrozenInstanceError

    raise FrozenInstanceError(f"{type(self).__name__} is a value: {name!r} can't change")


def _state(self: Any) -> tuple[object, ...]:
    return tuple(getattr(self, name) for name in self.__match_args__)


def _restore(self: Any, state: tuple[object, ...]) -> None:
    for name, content in zip(self.__match_args__, state, strict=True):
        object.__setattr__(self, name, content)


_LATE = {
    "__init__": _first_values,
    "__repr__": _repr,
    "__eq__": _late("__eq__"),
    "__hash__": _late("__hash__"),
}
_AT_ONCE = {"__dataclass_fields__": _LateFields(), "__getstate__": _state, "__setstate__": _restore}
_UNCHANGING = {"__setattr__": _refuse, "__delattr__": _refuse}
