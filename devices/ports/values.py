"""How values are made: a subclass of ``Frozen`` is a ``dataclass(frozen=True, slots=True)``, made quickly.

``Mutable`` is for ``dataclass(slots=True)`` in the same way; ``field`` and ``replace`` are the standard
library's for such classes.

The standard library makes each such class twice, and writes and compiles six methods for it, as its module is
imported, and the house has hundreds, of most of which a session makes a few values or none: that was half of
the time to start. Here a class is made once, with its slots; it has a constructor of its own once that is
worth writing, its comparison with the first one, and the standard library's ``__dataclass_fields__`` when
they are asked for; ``dataclasses`` itself, and ``inspect`` with it, is not loaded before.

Rules: what a class defines or inherits before ``Frozen`` is kept; values don't inherit from values.
"""

from __future__ import annotations

from _thread import RLock
from collections.abc import Callable, Mapping
from operator import attrgetter
from reprlib import recursive_repr

from devices.ports.hints import TYPE_CHECKING, Any, NoReturn, dataclass_transform

if TYPE_CHECKING:
    from typing import TypeVar

    T = TypeVar("T")

FEW = 30
"""As many values as are made one field at a time in the time that it takes to write a constructor, or so."""

_defaults: dict[type, dict[str, Any]] = {}
"""Of each class with fields: what its fields were given where it was written."""
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
    names: tuple[str, ...] = _value_class(kind).__match_args__
    return names


def _value_class(kind: type) -> Any:
    """The class that is a value, of one that may inherit from it."""
    return next(each for each in kind.__mro__ if each in _defaults)


class _LateFields:
    """The fields are made when asked for; of a twin, so that the class stays as it was written."""

    def __get__(self, _: object, owner: type) -> Any:
        import dataclasses

        with _making:
            kind = _value_class(owner)
            if "__dataclass_fields__" not in vars(kind):
                given = {
                    name: dataclasses.field(**each.options) if isinstance(each, _Field) else each
                    for name, each in _defaults[kind].items()
                }
                hints = {name: kind.__annotations__[name] for name in kind.__match_args__}
                body = {"__annotations__": hints, "__module__": kind.__module__, **given}
                twin: type = dataclasses.dataclass(init=False, repr=False, eq=False)(
                    type(kind.__name__, (), body)
                )
                kind.__dataclass_fields__ = vars(twin)["__dataclass_fields__"]
        return vars(kind)["__dataclass_fields__"]


class _Value:
    """What both kinds of values have."""

    __slots__ = ()
    __dataclass_fields__ = _LateFields()

    def __init__(self, *arguments: Any, **values: Any) -> None:
        """In place of the constructor, until one is worth writing; also where what was given is wrong."""
        kind = _value_class(type(self))
        _made[kind] = _made.get(kind, 0) + 1
        contents = _contents(kind, arguments, values) if _made[kind] <= FEW else None
        if contents is None:
            with _making:
                if "__init__" not in vars(kind):
                    kind.__init__ = _constructor(kind)
            kind.__init__(self, *arguments, **values)
            return
        for name, content in zip(kind.__match_args__, contents, strict=True):
            object.__setattr__(self, name, content)
        if hasattr(kind, "__post_init__"):
            kind.__post_init__(self)

    @recursive_repr()
    def __repr__(self) -> str:
        kind = _value_class(type(self))
        defaults = _defaults[kind]
        shown = (name for name in kind.__match_args__ if _says(defaults.get(name), "repr"))
        return f"{type(self).__qualname__}({', '.join(f'{name}={getattr(self, name)!r}' for name in shown)})"

    def __eq__(self, other: object) -> bool:
        """The first time: then the class has its own."""
        same: bool = _compared(type(self)).__eq__(self, other)
        return same

    def __hash__(self) -> int:
        mark: int = _compared(type(self)).__hash__(self)
        return mark

    def __getstate__(self) -> tuple[object, ...]:
        return tuple(getattr(self, name) for name in field_names(type(self)))

    def __setstate__(self, state: tuple[object, ...]) -> None:
        for name, content in zip(field_names(type(self)), state, strict=True):
            object.__setattr__(self, name, content)


class _Changing(_Value):
    __slots__ = ()
    __hash__ = None  # type: ignore[assignment] # as the standard library has it for what can change


class _Unchanging(_Value):
    __slots__ = ()

    def __setattr__(self, name: str, content: object) -> None:
        _refuse(self, name)

    def __delattr__(self, name: str) -> None:
        _refuse(self, name)


_METHODS: dict[str, type] = {"Frozen": _Unchanging, "Mutable": _Changing}


class _Making(type):
    """Of ``Frozen`` and ``Mutable`` alone: what is written below them gets their methods in their place.

    It is a plain class itself, for ``isinstance`` and ``match`` take several times as long with any other.
    """

    def __new__(mcs, name: str, bases: tuple[type, ...], body: dict[str, Any]) -> Any:
        """TypeError if it inherits from a value, or has a field of the standard library's."""
        if name in _METHODS:
            return type.__new__(mcs, name, bases, body)
        if any(hasattr(base, "__match_args__") for base in bases):
            raise TypeError(f"{name} must not inherit from a value")
        hints = body.get("__annotations__", {})
        names = tuple(each for each, hint in hints.items() if "ClassVar" not in str(hint))
        given = {each: body.pop(each) for each in names if each in body}
        for each, default in given.items():
            if type(default).__module__ == "dataclasses":
                raise TypeError(f"{name}.{each} must be a field of this module")
        bases = tuple(_METHODS.get(base.__name__, base) for base in bases)
        made = type(name, bases, {**body, "__slots__": names, "__match_args__": names})
        _defaults[made] = given
        return made


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
class Frozen(metaclass=_Making):
    """A class written below this is a frozen, slotted dataclass."""


@dataclass_transform(field_specifiers=(field,))
class Mutable(metaclass=_Making):
    """A class written below this is a slotted dataclass that can change."""


def _refuse(value: object, name: str) -> NoReturn:
    from dataclasses import FrozenInstanceError

    raise FrozenInstanceError(f"{type(value).__name__} is a value: {name!r} can't change")


def _contents(kind: Any, arguments: tuple[Any, ...], values: Mapping[str, Any]) -> list[Any] | None:
    """Of all fields, in their order; None if too few, too many or unknown ones were given."""
    names, defaults = kind.__match_args__, _defaults[kind]
    left = names[len(arguments) :]
    if len(arguments) + len(left) > len(names) or not values.keys() <= set(left):
        return None
    contents = [*arguments]
    for name in left:
        content = values.get(name, defaults.get(name, _MISSING))
        if isinstance(content, _Field):
            content = content.made()
        if content is _MISSING:
            return None
        contents.append(content)
    return contents


def _constructor(kind: Any) -> Any:
    """The function that the standard library would write, in a tenth of the time."""
    names, defaults = kind.__match_args__, _defaults[kind]
    fields = {name: each for name, each in defaults.items() if isinstance(each, _Field)}
    lines = [f"def __init__(self, {', '.join(names)}):"]
    for name in names:
        content = f"fields[{name!r}].made() if {name} is MISSING else {name}" if name in fields else name
        lines.append(f" put(self, {name!r}, {content})")
    lines.append(" self.__post_init__()" if hasattr(kind, "__post_init__") else " return")
    made: dict[str, Any] = {}
    exec("\n".join(lines), {"put": object.__setattr__, "fields": fields, "MISSING": _MISSING}, made)
    made["__init__"].__defaults__ = tuple(
        _MISSING if name in fields else defaults[name]
        for name in names
        if name in defaults and (name not in fields or fields[name].has_default)
    )
    return made["__init__"]


def _compared(owner: type) -> Any:
    """The class that is a value, with ``==`` and ``hash`` of the fields that are compared."""
    kind = _value_class(owner)
    defaults = _defaults[kind]
    names = [name for name in kind.__match_args__ if _says(defaults.get(name), "compare")]
    contents: Callable[[Any], Any] = attrgetter("__class__", *names)  # two names at least make a tuple

    def equal(self: Any, other: object) -> Any:
        if other.__class__ is not self.__class__:
            return NotImplemented
        return contents(self) == contents(other)

    for name, method in (("__eq__", equal), ("__hash__", lambda self: hash(contents(self)))):
        if getattr(kind, name) is getattr(_Value, name):
            setattr(kind, name, method)
    return kind


def _says(given: object, option: str) -> bool:
    """Whether a field takes part in what the ``option`` names, as it does unless it says otherwise."""
    return not isinstance(given, _Field) or given.options.get(option, True)
