"""A value behaves as a frozen, slotted dataclass does, whichever of its methods is asked for first."""

import copy
import dataclasses
import inspect
import pickle
import threading
from collections.abc import Callable
from dataclasses import FrozenInstanceError, dataclass, fields, is_dataclass
from enum import Enum
from typing import Any, ClassVar

import pytest

from devices.ports.values import FEW, Frozen, Mutable, field, field_names, replace


class Shape:
    KIND: ClassVar[str] = "shape"
    x: int
    y: float = 2.5
    names: tuple[str, ...] = ()
    seen: dict[str, int] = field(default_factory=dict, compare=False, repr=False)

    @property
    def double(self) -> int:
        return 2 * self.x


class Plain:
    x: int
    y: float = 2.5


THEIR_FIELDS = {Shape: {"seen": dataclasses.field(default_factory=dict, compare=False, repr=False)}}
"""As the standard library wants them."""


def twins_of(written: type, base: type) -> tuple[type, type]:
    """The class as a value of ours, and the same for the standard library."""
    body = {name: each for name, each in vars(written).items() if name not in ("__dict__", "__weakref__")}
    return type(base)(written.__name__, (base,), {**body}), type(
        written.__name__, (), body | THEIR_FIELDS.get(written, {})
    )


def made_of(written: type) -> tuple[Any, Any]:
    """The same class as a value, and as the standard library makes it; nothing was asked of either yet."""
    ours, for_them = twins_of(written, Frozen)
    return ours, dataclass(frozen=True, slots=True)(for_them)


class Kept(Frozen):
    """At the top of a module, so that pickle finds it."""

    x: int
    names: tuple[str, ...] = ("a",)


QUESTIONS: dict[str, Callable[[Any], object]] = {
    "repr": lambda kind: repr(kind(1)),
    "equal": lambda kind: (kind(1) == kind(1), kind(1) == kind(2), kind(1) == (1, 2.5), kind(1) != kind(1)),
    "hash": lambda kind: (hash(kind(1)) == hash(kind(1)), len({kind(1), kind(1), kind(3)})),
    "by name": lambda kind: (kind(x=4).x, kind(4, y=1.0).y, kind(1).y),
    "fields": lambda kind: [(each.name, each.type, each.default) for each in fields(kind)],
    "is a dataclass": lambda kind: (is_dataclass(kind), is_dataclass(kind(1))),
    "replace": lambda kind: (replace(kind(1), y=0.0).x, replace(kind(1), y=0.0).y),
    "their replace": lambda kind: dataclasses.replace(kind(1), y=0.0).y,
    "as a dict": lambda kind: dataclasses.asdict(kind(1)),
    "match": lambda kind: kind.__match_args__,
    "slots": lambda kind: (kind.__slots__, hasattr(kind(1), "__dict__")),
    "copy": lambda kind: (copy.copy(kind(1)) == kind(1), copy.deepcopy(kind(1)) == kind(1)),
    "notes": lambda kind: (kind.__name__, kind.__module__, list(kind.__annotations__)),
}


@pytest.mark.parametrize("question", QUESTIONS)
@pytest.mark.parametrize("written", [Shape, Plain])
def test_a_value_answers_as_the_standard_library_would(written: type, question: str) -> None:
    ours, theirs = made_of(written)

    assert QUESTIONS[question](ours) == QUESTIONS[question](theirs)


@pytest.mark.parametrize("question", sorted(QUESTIONS.keys() - {"hash"}))
@pytest.mark.parametrize("written", [Shape, Plain])
def test_what_can_change_answers_as_the_standard_library_would(written: type, question: str) -> None:
    ours, for_them = twins_of(written, Mutable)

    assert QUESTIONS[question](ours) == QUESTIONS[question](dataclass(slots=True)(for_them))


def test_what_can_change_changes_and_has_no_hash() -> None:
    class Count(Mutable):
        x: int = 0

    one = Count()
    one.x += 1

    assert (one, one.x) == (Count(1), 1)
    with pytest.raises(TypeError):
        hash(one)
    with pytest.raises(AttributeError):
        one.z = 1  # type: ignore[attr-defined] # that is the point


def test_a_value_does_not_change() -> None:
    kept = Kept(1)

    for change in (lambda: setattr(kept, "x", 2), lambda: delattr(kept, "x"), lambda: setattr(kept, "z", 2)):
        with pytest.raises(FrozenInstanceError):
            change()
    assert kept == Kept(1)


@pytest.mark.parametrize("made_before", [0, FEW])
@pytest.mark.parametrize(
    ("arguments", "names"),
    [((), {}), ((), {"y": 1.0}), ((1, 2.0, 3), {}), ((1,), {"z": 3}), ((1,), {"x": 1})],
)
def test_too_few_too_many_and_unknown_arguments_are_a_type_error(
    arguments: tuple[object, ...], names: dict[str, object], made_before: int
) -> None:
    ours, _ = made_of(Plain)
    for _ in range(made_before):
        ours(1)

    with pytest.raises(TypeError):
        ours(*arguments, **names)


def test_the_values_that_a_written_constructor_makes_are_those_of_before() -> None:
    ours, theirs = made_of(Shape)
    ways = (lambda kind: kind(1), lambda kind: kind(1, 3.0, seen={"a": 1}), lambda kind: kind(y=2.0, x=5))
    for way in ways:
        first = way(ours)
        rest = [way(ours) for _ in range(FEW)]
        assert rest == [first] * FEW
        assert {repr(each) for each in rest} == {repr(way(theirs))}


def test_fields_that_are_given_by_name_only_or_not_at_all_are_refused() -> None:
    with pytest.raises(TypeError, match="no kw_only"):
        field(default=1, kw_only=True)
    with pytest.raises(TypeError, match="no init"):
        field(default=2, init=False)


def test_a_field_of_the_standard_library_is_refused_and_does_not_become_the_content() -> None:
    with pytest.raises(TypeError, match=r"Wrong\.x"):

        class Wrong(Frozen):
            x: int = dataclasses.field(default=1)


def test_a_value_that_was_asked_for_its_fields_first_is_equal_to_one_that_was_not() -> None:
    for written in (Shape, Plain):
        ours, _ = made_of(written)
        one = ours(1)
        assert [each.name for each in fields(ours)] == list(ours.__match_args__)
        assert replace(one, x=2) == ours(2)
        assert (one == ours(1), repr(one) == repr(ours(1))) == (True, True)


def test_every_value_has_a_container_of_its_own() -> None:
    ours, _ = made_of(Shape)
    made = [ours(1).seen for _ in range(2 * FEW)]

    assert len({id(each) for each in made}) == len(made)


def test_what_the_class_says_itself_is_kept() -> None:
    class Loud(Frozen):
        x: int

        def __repr__(self) -> str:
            return "loud"

        def __eq__(self, other: object) -> bool:
            return True

        def __hash__(self) -> int:
            return 7

    assert (repr(Loud(1)), Loud(1) == 5, hash(Loud(1)), fields(Loud)[0].name) == ("loud", True, 7, "x")
    assert (repr(Loud(1)), Loud(1) == 5, hash(Loud(1))) == ("loud", True, 7)


def test_what_a_class_inherits_is_kept() -> None:
    class Base:
        __slots__ = ()

        def __eq__(self, other: object) -> bool:
            return True

        def __hash__(self) -> int:
            return 7

    class Child(Base, Frozen):
        x: int

    assert (fields(Child)[0].name, field_names(Child)) == ("x", ("x",))
    assert (Child(1) == Child(2), hash(Child(1))) == (True, 7)


def test_values_do_not_inherit_from_values() -> None:
    with pytest.raises(TypeError, match="Child must not inherit"):

        class Child(Kept, Frozen):
            y: int


def test_a_value_checks_itself_once_it_is_made() -> None:
    class Even(Frozen):
        x: int

        def __post_init__(self) -> None:
            if self.x % 2:
                raise ValueError

    for _ in range(2 * FEW):
        assert Even(2).x == 2
        with pytest.raises(ValueError):
            Even(3)


@pytest.mark.parametrize("protocol", range(2, pickle.HIGHEST_PROTOCOL + 1))
def test_a_value_can_be_sent_and_kept(protocol: int) -> None:
    assert pickle.loads(pickle.dumps(Kept(3, ("b",)), protocol)) == Kept(3, ("b",))


def test_a_value_of_another_shape_is_noticed_as_it_is_read() -> None:
    with pytest.raises(ValueError):
        Kept.__new__(Kept).__setstate__((1,))  # type: ignore[attr-defined] # made by the decorator


def test_threads_may_make_the_first_values_of_a_class_at_once() -> None:
    for _ in range(50):
        ours, _ = made_of(Shape)
        made: list[Any] = []
        threads = [threading.Thread(target=lambda to=made, of=ours: to.append(of(1))) for _ in range(4)]
        for each in threads:
            each.start()
        for each in threads:
            each.join()
        assert made == [ours(1)] * 4


def test_a_class_of_which_many_values_were_made_knows_its_signature() -> None:
    ours, theirs = made_of(Plain)
    for _ in range(FEW + 1):
        ours(1)

    assert list(inspect.signature(ours).parameters) == list(inspect.signature(theirs).parameters)


def test_values_may_be_equal_to_nothing_but_themselves() -> None:
    class Thing(Frozen):
        x: int
        __eq__ = object.__eq__
        __hash__ = object.__hash__

    one = Thing(1)

    assert (one == Thing(1), one == one, len({one, Thing(1)})) == (False, True, 2)


def test_members_of_enums_are_defaults_as_they_are() -> None:
    class Side(Enum):
        LEFT = 1

    class Turned(Frozen):
        side: Side = Side.LEFT

    assert Turned().side is Side.LEFT
