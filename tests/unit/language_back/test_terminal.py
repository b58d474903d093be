"""One batch after the other with the same memory, as typed in the terminal."""

from __future__ import annotations

import pytest

from language.diagnostics import QuitRequested
from language.runtime import Memory
from tests.unit.language_back.recorder import BACK_ENDS, Make, Outcome, Recorder, run

back_ends = pytest.mark.parametrize("make", BACK_ENDS.values(), ids=BACK_ENDS.keys())


def type_in(make: Make, *batches: str) -> list[Outcome]:
    memory, outcomes = Memory(), []
    for number, batch in enumerate(batches):
        outcomes.append(
            run(batch, make, terminal=True, memory=memory, actions=Recorder(), first_line=1 + 10 * number)
        )
    return outcomes


@back_ends
def test_variables_remain_for_later_batches(make: Make) -> None:
    outcomes = type_in(make, "VAR a = 2 VAR b = 3", "a = a + 1 SPEAK a", "SPEAK a * b")

    assert [each.actions.said for each in outcomes] == [[], [3], [9]]
    assert outcomes[-1].variables == {"a": 3, "b": 3}


@back_ends
def test_a_name_that_is_declared_again_is_overwritten_and_reported(make: Make) -> None:
    outcomes = type_in(make, "VAR Total = 2", "SPEAK total VAR TOTAL = total + 5 SPEAK total VAR other")

    assert outcomes[1].actions.done == [("speak", 2), ("overwritten", "TOTAL"), ("speak", 7)]


@back_ends
def test_twice_in_one_batch_is_a_mistake(make: Make) -> None:
    outcomes = type_in(make, "VAR a", "VAR a = 1\nVAR a = 2")

    assert outcomes[1].place == ("already-declared", 12, 5)
    assert outcomes[1].actions.done == [("overwritten", "a")]
    assert outcomes[1].variables == {"a": 1}


@back_ends
def test_the_same_var_in_a_loop_is_reported_once(make: Make) -> None:
    outcomes = type_in(make, "VAR a", "REPEAT 3 TIMES VAR a = 1 END REPEAT")

    assert outcomes[1].actions.done == [("overwritten", "a")]


@back_ends
def test_a_for_takes_over_a_name_and_ends_it(make: Make) -> None:
    loop = "REPEAT 2 TIMES a = 8 FOR VAR a = 0; a < 2; a = a + 1 DO SPEAK a END FOR END REPEAT"
    outcomes = type_in(make, "VAR a", loop, "SPEAK a")

    assert outcomes[1].actions.done == [("overwritten", "a"), ("speak", 0), ("speak", 1)]
    assert outcomes[1].place == ("undeclared-variable", 11, 16)
    assert outcomes[2].place == ("undeclared-variable", 21, 7)


FAILING_LOOPS = {
    "the condition's left": "FOR VAR i = 0; k < 3; i = i + 1 DO END FOR",
    "the condition's right": "FOR VAR i = 0; i < k; i = i + 1 DO END FOR",
    "the condition divides by zero": "FOR VAR i = 0; i / i < 1; i = i + 1 DO END FOR",
    "a variable is the start": "VAR n = 0 FOR VAR i = n; k < 3; i = i + 1 DO END FOR",
    "the condition's left, which is set later": "VAR n FOR VAR i = n; k < 3; i = i + 1 DO END FOR k = 1",
    "nothing is the start": "FOR VAR i; k < 3; i = i + 1 DO END FOR",
    "the step": "FOR VAR i = 0; i < 3; i = k DO END FOR",
    "the name of the step": "FOR VAR i = 0; i < 3; k = 1 DO END FOR",
    "the body": "FOR VAR i = 0; i < 3; i = i + 1 DO SPEAK k END FOR",
    "a call": "PROCEDURE P DO SPEAK k END PROCEDURE FOR VAR i = 0; i < 3; i = i + 1 DO P [] END FOR",
    "a loop in it": "FOR VAR i = 0; i < 3; i = i + 1 DO FOR VAR j = 0; k < 3; j = j + 1 DO END FOR END FOR",
}


@back_ends
@pytest.mark.parametrize("loop", FAILING_LOOPS.values(), ids=FAILING_LOOPS.keys())
def test_the_variable_of_a_for_header_is_gone_after_a_mistake(make: Make, loop: str) -> None:
    outcomes = type_in(make, loop, "SPEAK i")

    assert outcomes[0].place is not None
    assert not {"i", "j"} & outcomes[0].variables.keys()
    assert outcomes[1].place == ("undeclared-variable", 11, 7)


@back_ends
def test_procedures_remain_and_call_later_ones(make: Make) -> None:
    outcomes = type_in(
        make,
        "PROCEDURE P: n DO SPEAK n Q [n] END PROCEDURE",
        "P [1]",
        "PROCEDURE Q: n DO SPEAK n * 2 END PROCEDURE P [2]",
        "P [3]",
    )

    assert [each.actions.said for each in outcomes] == [[], [1], [2, 4], [3, 6]]
    assert outcomes[1].place == ("undeclared-procedure", 1, 27)
    assert outcomes[1].calls == [("P", 11)]


@back_ends
def test_a_procedure_that_is_declared_again_is_new_for_all(make: Make) -> None:
    outcomes = type_in(
        make,
        "PROCEDURE Q DO SPEAK 1 END PROCEDURE PROCEDURE P DO Q [] END PROCEDURE",
        "P [] PROCEDURE q: a DO SPEAK a END PROCEDURE Q [2] P []",
        "PROCEDURE q DO SPEAK 3 END PROCEDURE P [] PROCEDURE q DO END PROCEDURE",
    )

    assert outcomes[1].actions.done == [("speak", 1), ("overwritten", "q"), ("speak", 2)]
    assert outcomes[1].place == ("wrong-argument-count", 1, 53)
    assert outcomes[2].actions.done == [("overwritten", "q"), ("speak", 3)]
    assert outcomes[2].place[0] == "already-declared"


@back_ends
def test_a_procedure_of_an_earlier_batch_can_declare_another(make: Make) -> None:
    inner = "PROCEDURE P DO PROCEDURE Q DO SPEAK 5 END PROCEDURE END PROCEDURE"

    assert type_in(make, inner, "P []", "Q []")[2].actions.said == [5]


@back_ends
def test_a_procedure_does_not_see_variables_of_earlier_batches(make: Make) -> None:
    outcomes = type_in(make, "VAR a = 1 PROCEDURE P DO SPEAK a END PROCEDURE", "P []")

    assert outcomes[1].diagnostic.details == {"name": "a", "in_procedure": "P"}


@back_ends
def test_a_procedure_has_other_variables_than_earlier_batches(make: Make) -> None:
    outcomes = type_in(
        make,
        "VAR a = 1",
        "PROCEDURE P DO VAR a = 3 SPEAK a END PROCEDURE P [] SPEAK a",
        "PROCEDURE Q DO a = 4 END PROCEDURE Q []",
        "PROCEDURE R DO FOR VAR a = 5; a < 6; a = a + 1 DO SPEAK a END FOR END PROCEDURE R [] SPEAK a",
    )

    assert outcomes[1].actions.done == [("speak", 3), ("speak", 1)]
    assert outcomes[2].place == ("undeclared-variable", 21, 16)
    assert outcomes[3].actions.done == [("speak", 5), ("speak", 1)]


@back_ends
def test_an_earlier_procedure_is_called_until_the_new_one_is_declared(make: Make) -> None:
    outcomes = type_in(
        make,
        "PROCEDURE P DO SPEAK 1 END PROCEDURE",
        "P [] IF 1 == 2 THEN PROCEDURE P DO SPEAK 2 END PROCEDURE END IF P []",
        "P [] PROCEDURE P DO SPEAK 3 END PROCEDURE P []",
    )

    assert outcomes[1].actions.said == [1, 1]
    assert outcomes[2].actions.done == [("speak", 1), ("overwritten", "P"), ("speak", 3)]


@back_ends
def test_a_number_of_an_earlier_batch_is_still_checked(make: Make) -> None:
    nines = "9" * 4300
    outcomes = type_in(
        make, f"VAR a = {nines} PROCEDURE P: n DO SPEAK n + 1 END PROCEDURE", "P [1]", "P [a]", "a = a + 1"
    )

    assert outcomes[1].actions.said == [2]
    assert outcomes[2].place[0] == outcomes[3].place[0] == "number-too-large"


@back_ends
def test_quit_ends_the_batch_and_run_does_nothing(make: Make) -> None:
    outcome = type_in(make, "VAR a = 1 RUN SPEAK a QUIT SPEAK 2")[0]

    assert isinstance(outcome.error, QuitRequested)
    assert outcome.actions.said == [1]
    assert outcome.variables == {"a": 1}


@back_ends
def test_the_effects_of_a_failed_batch_stay(make: Make) -> None:
    outcomes = type_in(make, "VAR a = 1 PROCEDURE P DO SPEAK 4 END PROCEDURE SPEAK 1 / 0", "SPEAK a P []")

    assert outcomes[1].actions.said == [1, 4]


@back_ends
def test_a_file_begins_with_an_empty_memory(make: Make) -> None:
    memory = Memory(variables={"a": 1})
    outcome = run("VAR b SPEAK a", make, memory=memory)

    assert outcome.place[0] == "undeclared-variable"
    assert outcome.variables == {"b": 0}
