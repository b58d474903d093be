"""The mistakes of a run are gone through and explained, the same in both front ends."""

import pytest

from donnie_tui.core.events import INTERNAL, Error
from donnie_tui.core.told_errors import MOST_KEPT, ToldErrors, line_of
from donnie_tui.i18n.words import Words

SAY = Words("en")
MISTAKES = tuple(Error("unknown-command", line, 1, f"m{line}", None, f"FWD {line}") for line in (1, 2, 3))


def way(errors: ToldErrors, *moves: int) -> list[int | None]:
    """The lines that it leads to, None where it stays."""
    return [error and error.line for by in moves for error, _ in (errors.go(by, SAY),)]


def test_the_first_one_is_meant_until_somebody_goes_on() -> None:
    assert ToldErrors(MISTAKES).now == MISTAKES[0]
    assert way(ToldErrors(MISTAKES), 0, 1, 0, 1, 1, -1) == [1, 2, 2, 3, None, 2]
    assert way(ToldErrors(MISTAKES), -1, 0) == [None, 1]


def test_past_the_ends_it_is_told_which_one_it_is() -> None:
    assert ToldErrors(MISTAKES).go(3, SAY)[1] == ("No more errors. That is 1 of 3.",)


@pytest.mark.parametrize("by", [-1, 0, 1])
def test_where_there_are_none_that_is_told(by: int) -> None:
    assert ToldErrors().go(by, SAY) == (None, ("No errors.",))
    assert ToldErrors().in_words(SAY) == ToldErrors().explained(None, SAY) == ("No errors.",)


def test_a_mistake_is_explained_with_whose_it_is_and_with_its_line() -> None:
    errors = ToldErrors(MISTAKES)
    errors.go(1, SAY)

    told = errors.explained("bob", SAY)
    assert told == ("bob: Donnie does not know this word.", "Check its letters: FW 3.")
    assert line_of(MISTAKES[1], SAY) == ("Line 2: FWD 2",)


def test_a_fault_of_ours_is_explained_and_has_no_line() -> None:
    fault = Error(INTERNAL, 1, 1, "m", None)

    assert ToldErrors([fault]).explained(None, SAY)[0] == "The fault is Donnie's, not yours."
    assert line_of(fault, SAY) == ()


def test_the_newest_ones_are_remembered() -> None:
    errors = ToldErrors()
    for line in range(MOST_KEPT + 5):
        errors.add(Error("robot", line, 1, "m", None))

    assert [each.line for each in errors.all] == list(range(5, MOST_KEPT + 5))
