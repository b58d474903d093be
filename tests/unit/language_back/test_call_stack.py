"""Calls go 20 000 deep in any thread, and no deeper; variables are read from running frames."""

from __future__ import annotations

import threading

import pytest

from language.call_stack import DEEPEST_CALL, first_link, variables_in
from tests.unit.language_back.recorder import BACK_ENDS, Make, Outcome, fast, hooked, run

back_ends = pytest.mark.parametrize("make", BACK_ENDS.values(), ids=BACK_ENDS.keys())

DOWN = "PROCEDURE DOWN: n DO IF n > 1 THEN DOWN [n - 1] ELSE SPEAK n END IF END PROCEDURE\n"
ENDLESS = "PROCEDURE P DO\nSPEAK 1\nP []\nEND PROCEDURE\nP []"


@back_ends
def test_as_many_calls_as_the_limit_are_open_at_once(make: Make) -> None:
    assert run(f"{DOWN} DOWN [{DEEPEST_CALL}]", make).actions.said == [1]


@pytest.mark.parametrize("make", [fast, hooked])
def test_a_program_without_calls_makes_no_links(make: Make) -> None:
    """To make them takes as long as to load ten modules."""
    first_link.cache_clear()

    assert run("PROCEDURE P DO SPEAK 2 END PROCEDURE SPEAK 1", make).actions.said == [1]
    assert first_link.cache_info().currsize == 0


@back_ends
def test_one_call_more_is_a_mistake_at_that_call(make: Make) -> None:
    outcome = run(f"{DOWN} DOWN [{DEEPEST_CALL + 1}]", make)

    assert outcome.place == ("recursion-limit", 1, 36)
    assert outcome.diagnostic.details == {"limit": DEEPEST_CALL}
    assert len(outcome.calls) == DEEPEST_CALL


@back_ends
def test_what_an_endless_recursion_did_stays_done(make: Make) -> None:
    outcome = run(f"VAR a = 7 {ENDLESS}", make)

    assert outcome.place == ("recursion-limit", 3, 1)
    assert len(outcome.actions.said) == DEEPEST_CALL
    assert outcome.variables == {"a": 7}
    assert outcome.calls[0] == ("P", 3)
    assert outcome.calls[-1] == ("P", 5)


def test_two_procedures_that_call_each_other_share_the_limit() -> None:
    source = "PROCEDURE A: n DO B [n + 1] END PROCEDURE PROCEDURE B: n DO A [n + 1] END PROCEDURE A [1]"

    assert run(source).place[0] == "recursion-limit"


@pytest.mark.parametrize("make", [fast, hooked])
def test_deep_calls_need_only_a_thread_with_a_small_stack(make: Make) -> None:
    outcomes: list[Outcome] = []
    size = threading.stack_size(256 * 1024)
    try:
        thread = threading.Thread(target=lambda: outcomes.append(run(f"{DOWN} DOWN [{DEEPEST_CALL}]", make)))
        thread.start()
    finally:
        threading.stack_size(size)
    thread.join()

    assert outcomes[0].actions.said == [1]


@back_ends
def test_a_call_out_of_many_loops_counts_once(make: Make) -> None:
    loops, ends = "REPEAT 1 TIMES " * 45, " END REPEAT" * 45
    source = f"PROCEDURE P: n DO IF n > 0 THEN {loops} P [n - 1] {ends} END IF END PROCEDURE P [300] SPEAK 1"

    assert run(source, make).actions.said == [1]


@pytest.mark.parametrize("deep", [1, 17, 18, 19, 36, 37, 60])
@back_ends
def test_loops_nest_deeper_than_python_allows(make: Make, deep: int) -> None:
    loops = "".join(
        f"FOR VAR i{n} = 0; i{n} < 1; i{n} = i{n} + 1 DO VAR v{n} = n + i{n} n = v{n} + 1 "
        for n in range(deep)
    )
    outcome = run(f"VAR n = 0 {loops} SPEAK n {'END FOR ' * deep} SPEAK n / (n - n)", make)

    assert outcome.actions.said == [deep]
    assert outcome.place[0] == "division-by-zero"
    assert outcome.variables == {"n": deep, **{f"v{n}": n for n in range(deep)}}


@back_ends
def test_a_mistake_in_deep_loops_has_its_place_and_leaves_no_variable_of_a_header(make: Make) -> None:
    loops = "".join(f"FOR VAR i{n} = 0; i{n} < 1; i{n} = i{n} + 1 DO\n" for n in range(40))
    outcome = run(f"VAR n = 3\n{loops}n = n + none\n{'END FOR ' * 40}", make)

    assert outcome.place == ("undeclared-variable", 42, 9)
    assert outcome.variables == {"n": 3}


@back_ends
def test_blocks_nest_as_deep_as_the_parser_allows(make: Make) -> None:
    source = "VAR n\n" + "WHILE n < 1 DO IF n < 1 THEN " * 100 + "n = 1" + " END IF END WHILE" * 100

    assert run(source, make).variables == {"n": 1}


class NameFiller:
    """No number; a check of its type adds a name, as another thread may do at that moment."""

    def __init__(self, names: dict[str, object]) -> None:
        self.names = names

    @property
    def __class__(self) -> type:
        self.names["v_new"] = 1
        return object


def test_variables_may_appear_while_another_thread_reads_them() -> None:
    names: dict[str, object] = {}
    names |= {"v_filler": NameFiller(names), "v_a": 5}

    assert variables_in(names) == {"a": 5}
