"""Numbers are exact and limited, division truncates, and every mistake is found at its place."""

from __future__ import annotations

import pytest

from language.numbers import LARGEST_DIGITS, LIMIT
from tests.unit.language_back.recorder import BACK_ENDS, Make, run

NINES = "9" * LARGEST_DIGITS
back_ends = pytest.mark.parametrize("make", BACK_ENDS.values(), ids=BACK_ENDS.keys())


@back_ends
@pytest.mark.parametrize(
    ("expression", "value"),
    [
        ("7 / 2", 3),
        ("-7 / 2", -3),
        ("7 / -2", -3),
        ("-7 / -2", 3),
        ("(a - 8) / b", -3),
        ("(a - 8) / (b - 4)", 3),
        ("a / (b - 4)", 0),
        ("a / (b * b - 1)", 0),
        ("100 / a / b / (b + b)", 12),
        ("(a - 20) / ((b - 30) / (a - 4))", -2),
        ("2 - 3 - 4", -5),
        ("2 + 3 * 4 - 6 / 4", 13),
        ("- - a", 1),
        ("-(a + b)", -3),
        ("0 * -5", 0),
        (f"{NINES} - {NINES}", 0),
        (f"{NINES} / {NINES}", 1),
    ],
)
def test_expressions_have_the_value_of_arithmetic(make: Make, expression: str, value: int) -> None:
    outcome = run(f"VAR a = 1 VAR b = 2 SPEAK {expression}", make)

    assert outcome.actions.said == [value]


@back_ends
@pytest.mark.parametrize("dividend", ["0", "5", "a", "(a - 1)", "(a - 9)"])
@pytest.mark.parametrize("divisor", ["0", "b", "(b * 1)", "-b", "(b - b)"])
def test_nothing_is_divided_by_zero(make: Make, dividend: str, divisor: str) -> None:
    outcome = run(f"VAR a = 1 VAR b\nSPEAK 1\nSPEAK {dividend} / {divisor}", make)

    assert outcome.place[:2] == ("division-by-zero", 3)
    assert outcome.actions.said == [1]


@back_ends
def test_the_largest_number_has_4300_digits(make: Make) -> None:
    outcome = run(f"VAR a = {NINES} SPEAK a SPEAK 0 - a", make)

    assert outcome.actions.said == [LIMIT - 1, 1 - LIMIT]


@back_ends
@pytest.mark.parametrize(
    "beyond", ["a + 1", "1 + a", "0 - a - 1", "a + a", "a * 2", "a * a", "(0 - a) * a", "a - -1", "a + 1 - 1"]
)
def test_a_larger_number_is_a_mistake_at_its_line_and_is_not_kept(make: Make, beyond: str) -> None:
    outcome = run(f"VAR a = {NINES}\nVAR b = 7\nb = {beyond}", make)

    assert outcome.place[:2] == ("number-too-large", 3)
    assert outcome.diagnostic.details == {"limit": LARGEST_DIGITS}
    assert outcome.variables["b"] == 7


@back_ends
@pytest.mark.parametrize(
    "growing",
    [
        "a = a * a",
        "a = a + a",
        "a = a * 10",
        "b = a a = b * 3",
        "a = a + a / 2",
        "a = a - -a",
        f"a = a + 1{'0' * 4298}",
    ],
)
def test_a_number_that_grows_without_end_is_found(make: Make, growing: str) -> None:
    outcome = run(f"VAR a = 2 VAR b\nWHILE 1 == 1 DO {growing} END WHILE", make)

    assert outcome.place[:2] == ("number-too-large", 2)


@back_ends
def test_a_number_that_grows_in_a_recursion_is_found(make: Make) -> None:
    outcome = run("PROCEDURE P: n DO P [n + n] END PROCEDURE\nP [1]", make)

    assert outcome.place == ("number-too-large", 1, 22)


@back_ends
@pytest.mark.parametrize("head", [f"{NINES} - 2; i < {NINES}; i = i + 1", "0; i >= 0; i = i * 2 + 1"])
def test_a_counter_at_the_limit_is_checked(make: Make, head: str) -> None:
    outcome = run(f"FOR VAR i = {head} DO SPEAK 1 END FOR", make)

    if "* 2" in head:
        assert outcome.place[0] == "number-too-large"
    else:
        assert outcome.actions.said == [1, 1]
        assert outcome.error is None


@back_ends
def test_a_counter_that_would_pass_the_limit_is_a_mistake(make: Make) -> None:
    outcome = run(f"FOR VAR i = {NINES} - 2; i < {NINES}; i = i + 5 DO SPEAK 1 END FOR", make)

    assert outcome.place[0] == "number-too-large"
    assert outcome.actions.said == [1]


@back_ends
def test_a_count_larger_than_any_machine_number_is_counted(make: Make) -> None:
    outcome = run(f"VAR n REPEAT {NINES} TIMES n = n + 1 IF n == 3 THEN SPEAK 1 / 0 END IF END REPEAT", make)

    assert outcome.variables == {"n": 3}


@back_ends
@pytest.mark.parametrize("times", ["0", "-1", f"-{NINES}"])
def test_fewer_than_one_iteration_is_none(make: Make, times: str) -> None:
    assert run(f"REPEAT {times} TIMES SPEAK 1 END REPEAT", make).actions.said == []


@back_ends
def test_a_long_expression_is_calculated_from_left_to_right(make: Make) -> None:
    terms = " ".join(f"+ (a * {number} - a / (b + {number}))" for number in range(150))

    assert run(f"VAR a = 1 VAR b = 1 SPEAK 0 {terms}", make).actions.said == [sum(range(150)) - 1]


@back_ends
def test_a_mistake_in_a_long_expression_is_found_at_its_name(make: Make) -> None:
    terms = "+ (1 * a)" * 100
    outcome = run(f"VAR a = 1\nSPEAK 0 {terms}\n+ nothing + zilch", make)

    assert outcome.place == ("undeclared-variable", 3, 3)


@back_ends
def test_operands_before_a_long_expression_are_read_before_it(make: Make) -> None:
    chain = "+ 1 * (2 - a) " * 90
    outcome = run(f"VAR a = 2 SPEAK DISTANCE F * a - (COLOR red {chain}) + POS x - (POS y {chain})", make)

    assert [what[0] for what in outcome.actions.done] == [
        "distance",
        "colour",
        "position",
        "position",
        "speak",
    ]
    assert outcome.actions.said == [24 - 3 + 3 + 4]


@back_ends
def test_arguments_are_calculated_in_their_order(make: Make) -> None:
    chain = "+ 1 * (2 - a) " * 90
    arguments = f"DISTANCE F, COLOR red {chain}, POS x + 0, POS y {chain}"
    outcome = run(
        f"VAR a = 2 PROCEDURE P: a, b, c, d DO SPEAK a - b * c / d END PROCEDURE P [{arguments}]", make
    )

    assert [what[0] for what in outcome.actions.done] == [
        "distance",
        "colour",
        "position",
        "position",
        "speak",
    ]
    assert outcome.actions.said == [14]


@back_ends
def test_sensors_are_read_from_left_to_right(make: Make) -> None:
    outcome = run("IF DISTANCE F + POS x < COLOR red * POS a THEN SPEAK DISTANCE B - DISTANCE F END IF", make)

    assert [what[0] for what in outcome.actions.done] == [
        "distance",
        "position",
        "colour",
        "position",
        "distance",
        "distance",
        "speak",
    ]
    assert outcome.actions.said == [48]
