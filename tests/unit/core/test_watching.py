"""Watched variables: each change is told once."""

from donnie_tui.core.watching import Watching, toggle_watch
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
