"""Watched variables: each change is told once."""

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from donnie_tui.core.watching import Watch, Watching, toggle_watch
from donnie_tui.i18n.words import Words


def test_what_has_changed_is_told_and_what_is_the_same_is_not() -> None:
    watching = Watching(["x", "y"], Words("en"))
    watching.begin([("x", 1)])
    told = [watching.look(each) for each in ([("x", 1)], [("X", 2), ("y", 5)], [("x", 2), ("z", 9)])]

    assert told == [(), ("x is 2.", "y is 5."), ()]


def test_a_variable_that_is_not_seen_in_a_procedure_is_no_change() -> None:
    watching = Watching(["x"], Words("en"))
    watching.begin([("x", 1)])

    assert [watching.look(each) for each in ([("n", 3)], [("x", 1)])] == [(), ()]


def test_names_may_be_added_meanwhile() -> None:
    names: list[str] = []
    watching = Watching(names, Words("en"))
    watching.begin([("x", 1)])
    before = watching.look([("x", 2)])
    names.append("x")

    assert (before, watching.look([("x", 3)])) == ((), ("x is 3.",))


def test_a_name_is_told_as_it_was_typed_and_found_without_its_accents() -> None:
    watched: list[str] = []
    watching = Watching(watched, Words("pt"))
    told = [toggle_watch(watched, "ação", Words("pt")), toggle_watch(watched, "", Words("pt"))]
    changed = watching.look([("AÇÃO", 3)])

    assert told == [("Vigiando ação.",), ("Vigiando ação.",)]
    assert changed == ("ação é 3.",)
    assert toggle_watch(watched, "ACAO", Words("pt")) == ("Não vigio mais ACAO.",)
    assert watched == []


class Program:
    """A session whose program has got as far as its variables say."""

    def __init__(self) -> None:
        self.told: list[str] = []
        self.looks: list[Callable[[], None] | None] = []
        self.hub = SimpleNamespace(publish=lambda event: self.told.append(event.text))
        self.variables: dict[str, int] = {}
        self.run: Any = None

    def begin(self) -> None:
        self.run = SimpleNamespace(control=SimpleNamespace(look_before_each=self.looks.append))

    @property
    def frames(self) -> tuple[Any, ...]:
        return (SimpleNamespace(variables=tuple(self.variables.items())),)


def test_a_run_without_anything_watched_is_asked_nothing_until_something_is() -> None:
    program: Any = Program()
    watch = Watch(Words("en"))
    assert watch.begin(program, fresh=True) is None
    program.begin()
    program.variables = {"n": 1}
    watch.toggle("n")
    (look,) = program.looks
    look()
    look()

    assert program.told == ["n is 1."]


def test_what_a_program_goes_on_with_is_known_and_what_it_leaves_is_told() -> None:
    program: Any = Program()
    program.variables = {"n": 1}
    watch = Watch(Words("en"))
    watch.toggle("n")
    look = watch.begin(program, fresh=False)
    assert look is not None
    look()
    watch.look(program, [("n", 2)])

    assert program.told == ["n is 2."]
