"""Both front ends visit and explain the mistakes of a run in the same way."""

import pytest
from msgspec import structs

from donnie_tui.core.events import INTERNAL, Error, RunStarted, Spoke, Stamped
from donnie_tui.core.run_state import RunErrors, line_of
from donnie_tui.i18n.words import Words

SAY = Words("en")
MISTAKES = tuple(Error("unknown-command", line, 1, f"m{line}", None, f"FWD {line}") for line in (1, 2, 3))


def way(errors: RunErrors, *moves: int) -> list[int | None]:
    """The lines that it leads to, None if it stays."""
    return [error and error.line for by in moves for error, _ in (errors.go(by, SAY),)]


def test_the_first_mistake_is_current_until_the_next_one_is_requested() -> None:
    assert RunErrors(MISTAKES).now == MISTAKES[0]
    assert way(RunErrors(MISTAKES), 0, 1, 0, 1, 1, -1) == [1, 2, 2, 3, None, 2]
    assert way(RunErrors(MISTAKES), -1, 0) == [None, 1]


def test_a_move_beyond_the_first_or_last_mistake_names_the_current_one() -> None:
    assert RunErrors(MISTAKES).go(3, SAY)[1] == ("No more errors. That is 1 of 3.",)


@pytest.mark.parametrize("by", [-1, 0, 1])
def test_a_run_without_mistakes_is_reported(by: int) -> None:
    assert RunErrors().go(by, SAY) == (None, ("There are no errors.",))
    assert RunErrors().in_words(SAY) == RunErrors().explained(None, SAY) == ("There are no errors.",)


def test_a_mistake_is_explained_with_its_cause_and_its_line() -> None:
    errors = RunErrors(MISTAKES)
    errors.go(1, SAY)

    said = errors.explained("bob", SAY)
    assert said == ("bob: Donnie does not know this word.", "Check its letters: FW 3.")
    assert line_of(MISTAKES[1], SAY) == ("Line 2: FWD 2",)
    assert line_of(structs.replace(MISTAKES[1], hint="FW?"), SAY) == ("Line 2: FWD 2",)


def test_an_internal_fault_is_explained_and_has_no_line() -> None:
    fault = Error(INTERNAL, 1, 1, "m", None)

    assert RunErrors([fault]).explained(None, SAY)[0] == "The fault is Donnie's, not yours."
    assert line_of(fault, SAY) == ()


def test_the_newest_mistakes_are_remembered() -> None:
    errors = RunErrors()
    for line in range(205):
        errors.add(Error("robot", line, 1, "m", None))

    assert [each.line for each in errors.all] == list(range(5, 205))


def test_a_run_of_the_own_robot_begins_without_mistakes_and_another_changes_nothing() -> None:
    errors = RunErrors(of=lambda: "bob")
    started = RunStarted("p", "w", "donnie", 0, "0")
    for robot, event in (
        ("bob", MISTAKES[0]),
        ("alice", MISTAKES[1]),
        ("alice", started),
        ("bob", MISTAKES[2]),
    ):
        errors.on_event(Stamped(1, 0.0, event, robot))

    assert errors.all == (MISTAKES[0], MISTAKES[2])
    errors.go(1, SAY)
    errors.on_event(Stamped(1, 0.0, started, "bob"))
    assert (errors.all, errors.now, errors.had_any) == ((), None, True)
    errors.on_event(Stamped(1, 0.0, Spoke("1"), "bob"))
    errors.on_event(Stamped(1, 0.0, MISTAKES[1], "bob"))
    assert (errors.now, errors.all) == (MISTAKES[1], (MISTAKES[1],))


def test_a_mistake_of_another_robot_is_one_since_the_start() -> None:
    errors = RunErrors(of=lambda: "bob")
    assert not errors.had_any
    errors.on_event(Stamped(1, 0.0, RunStarted("p", "w", "donnie", 0, "0"), "bob"))
    assert not errors.had_any
    errors.on_event(Stamped(1, 0.0, MISTAKES[0], "alice"))
    assert errors.had_any
    assert errors.all == ()


def test_the_first_new_mistake_is_gone_to_and_a_missing_end_comes_last() -> None:
    end = Error("missing-end", 1, 1, "no end", None)
    errors = RunErrors([MISTAKES[0], end, *MISTAKES[1:]])
    errors.known = frozenset(MISTAKES[:2])

    assert errors.is_known(MISTAKES[0])
    assert not errors.is_known(end)
    assert errors.go_to_new() == errors.now == MISTAKES[2]
    errors.known = frozenset(MISTAKES)
    assert errors.go_to_new() == end
    errors.known = frozenset((*MISTAKES, end))
    assert errors.go_to_new() is None
    assert errors.now == end
