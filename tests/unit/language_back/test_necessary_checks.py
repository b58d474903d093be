"""The code makes only the checks that its numbers need, and counts as fast as Python where it can."""

from __future__ import annotations

import dis
import sys
from collections import Counter
from types import CodeType, FrameType

import pytest

from language.compiler import link, warm_up
from language.diagnostics import ActionRefused, MistakeKind
from language.numbers import (
    LARGEST_DIGITS,
    LIMIT,
    SAFE_BITS,
    NonNegatives,
    NumberSizes,
    assignments_of,
    checked,
    divide,
)
from language.runtime import Memory
from language.syntax import Scope, scopes_of
from tests.unit.language_back.recorder import BACK_ENDS, Make, read, run

SLOW = {"checked", "divide", "range"}
"""A result that may be too large, a quotient that may be negative, and a loop that only counts."""


def helpers_in(source: str, stored: dict[str, int] | None = None) -> str:
    """Those of them that the code of a program calls."""
    units = link(read(source), Memory(dict(stored or {}), {}), terminal=True, hooked=False)
    return " ".join(sorted({name for unit in units for name in unit.code.co_names} & SLOW))


NUMBERS = [
    # to reach the limit by steps of one takes 10**4300 of them
    ("VAR a = 1 a = a + 1", ""),
    ("VAR a = 9 a = a - 1", ""),
    ("VAR a = 1 a = 1 + a", ""),
    ("VAR a = 1 a = a + DISTANCE F * 3", ""),
    ("VAR a = 1 a = -a", ""),
    ("VAR a = 2 a = (a + 1) / 2", ""),
    ("VAR a = 9 a = a / 2", ""),
    ("VAR a = 1 VAR b = a + a", ""),
    ("VAR a = DISTANCE F VAR b = a * a * a", ""),
    ("FOR VAR i = 0; i < 3; i = i + 2 - 1 DO END FOR", ""),
    ("PROCEDURE P: n DO P [n + 1] END PROCEDURE P [1]", ""),
    # to double takes 14 285 of them
    ("VAR a = 1 a = a * 2", "checked"),
    ("VAR a = 1 a = 2 * a", "checked"),
    ("VAR a = 9 a = a + a", "checked"),
    ("VAR a = 9 a = a - -a", "checked"),
    ("VAR a = 9 a = a * 3 / 2", "checked"),
    ("VAR a VAR b a = b + 1 b = a + 1", "checked"),
    ("FOR VAR i = 1; i < 3; i = i * 2 DO END FOR", "checked"),
    ("PROCEDURE P: n DO P [n * 2] END PROCEDURE P [1]", "checked"),
    ("PROCEDURE P: n, m DO P [m + 1, n + 1] END PROCEDURE P [1, 2]", "checked"),
    # a quotient of two numbers that are never negative, or by a positive number, is that of Python
    ("VAR a = 7 VAR b = 2 SPEAK a / b", ""),
    ("VAR a = -7 SPEAK a / 2", ""),
    ("SPEAK DISTANCE F / 2", ""),
    ("VAR a = 7 VAR b = a + a * a / 2 SPEAK a / b", ""),
    ("PROCEDURE P: n, m DO SPEAK n / m END PROCEDURE P [1, 3]", ""),
    ("VAR a = -7 VAR b = 2 SPEAK a / b", "divide"),
    ("VAR a = 7 VAR b = -2 SPEAK a / b", "divide"),
    ("VAR a = -7 SPEAK a / -2", "divide"),
    ("VAR a = 7 SPEAK a / (a - 3)", "divide"),
    ("SPEAK 7 / DISTANCE F", "divide"),
    ("VAR a = 7 VAR b = a - 9 SPEAK a / b", "divide"),
    ("VAR a = 7 VAR c = -1 VAR b = c * 2 SPEAK a / b", "divide"),
    ("PROCEDURE P: n, m DO SPEAK n / m END PROCEDURE P [1, -1]", "divide"),
    # a loop that counts to a limit that stays
    ("FOR VAR i = 0; i < 3; i = i + 1 DO SPEAK i END FOR", "range"),
    ("FOR VAR i = 0; i <= 3; i = 1 + i DO END FOR", "range"),
    ("FOR VAR i = 9; i > 3; i = i - 2 DO END FOR", "range"),
    ("FOR VAR i = 9; i >= 3; i = i - 2 DO END FOR", "range"),
    ("VAR n = 3 FOR VAR i = 0; i < n; i = i + 1 DO END FOR n = 5", "range"),
    ("FOR VAR i = 0; i < 3; i = i - 1 DO END FOR", ""),
    ("FOR VAR i = 0; i > 3; i = i + 1 DO END FOR", ""),
    ("FOR VAR i = 0; i <> 3; i = i + 1 DO END FOR", ""),
    ("FOR VAR i = 0; 3 > i; i = i + 1 DO END FOR", ""),
    ("FOR VAR i = 0; i < 3; i = i + 0 DO END FOR", ""),
    ("FOR VAR i = 0; i < 3; i = 5 - i DO END FOR", ""),
    ("FOR VAR i = 0; i < i; i = i + 1 DO END FOR", ""),
    ("FOR VAR i = 0; i < 3 + 1; i = i + 1 DO END FOR", ""),
    ("FOR VAR i = 0; i < DISTANCE F; i = i + 1 DO END FOR", ""),
    ("FOR VAR i = 0; i < 3; i = i + 1 DO i = 2 END FOR", ""),
    ("FOR VAR i = 0; i < 3; i = i + 1 DO REPEAT 2 TIMES i = 2 END REPEAT END FOR", ""),
    ("FOR VAR i = 0; i < 3; i = i + 1 DO i = 2 REPEAT 2 TIMES END REPEAT END FOR", ""),
    ("FOR VAR i = 0; i < 3; i = i + 1 DO VAR k REPEAT 2 TIMES k = 2 END REPEAT END FOR", "range"),
    ("VAR n = 3 FOR VAR i = 0; i < n; i = i + 1 DO n = 5 END FOR", ""),
    ("VAR n = 3 FOR VAR i = 0; i < n; i = i + 1 DO IF 1 < 2 THEN n = 5 END IF END FOR", ""),
    ("VAR n = 2 FOR VAR i = 0; i < 3; i = i + n DO END FOR", ""),
    ("VAR i FOR i = 0; i < 3; i = i + 1 DO END FOR", ""),
    ("VAR j FOR VAR i = 0; i < 3; j = j + 1 DO END FOR", ""),
    ("VAR j FOR VAR i = 0; j < 3; i = i + 1 DO END FOR", ""),
    ("VAR j FOR VAR i = 0; j < 3; j = j + 1 DO END FOR", ""),
    ("FOR VAR i = 0; i > 3; i = i - 0 DO END FOR", ""),
]


@pytest.mark.parametrize(("source", "helpers"), NUMBERS)
def test_the_code_calls_a_helper_only_where_the_numbers_need_it(source: str, helpers: str) -> None:
    assert helpers_in(source) == helpers


@pytest.mark.parametrize(
    ("source", "stored", "helpers"),
    [
        ("SPEAK a / b", {"a": 1, "b": 2}, ""),
        ("SPEAK a / b", {"a": 0, "b": 0}, ""),
        ("SPEAK a / b", {"a": 1, "b": -1}, "divide"),
        ("SPEAK a / b", {"a": -1, "b": 1}, "divide"),
        ("SPEAK a + 1", {"a": LIMIT - 1}, "checked"),
        ("a = a + 1", {"a": 10**4200}, ""),
        ("SPEAK a * a", {"a": 10**2100}, ""),
        ("SPEAK a * a", {"a": 10**2200}, "checked"),
        ("SPEAK a + a", {"a": 10**2200}, ""),
        ("SPEAK a - -a / 3", {"a": 10**2200}, ""),
        ("SPEAK a / 3 + a", {"a": LIMIT - 1}, "checked"),
        ("SPEAK a * a / a + 1", {"a": 10**2200}, "checked"),
        ("PROCEDURE P: a DO SPEAK a * a END PROCEDURE P [2]", {"a": LIMIT - 1}, ""),
    ],
)
def test_the_numbers_of_an_earlier_batch_count(source: str, stored: dict[str, int], helpers: str) -> None:
    assert helpers_in(source, stored) == helpers


def comparisons_in(source: str, stored: dict[str, int]) -> int:
    program, *_ = link(read(source), Memory(stored, {}), terminal=True, hooked=False)
    return program.code.co_code[::2].count(dis.opmap["COMPARE_OP"])


MOST = LIMIT - 1


@pytest.mark.parametrize(
    ("source", "stored", "comparisons"),
    [
        # a quotient: none, with zero, or both numbers with zero
        ("SPEAK a / 2", {"a": 7}, 0),
        ("SPEAK (a + 0) / 2", {"a": 7}, 0),
        ("SPEAK a * a / 2", {"a": 7}, 0),
        ("SPEAK a / a", {"a": 7}, 0),
        ("SPEAK a / 2 / 2", {"a": 7}, 0),
        ("SPEAK a / 2", {"a": -7}, 1),
        ("SPEAK -a / 2", {"a": 7}, 1),
        ("SPEAK (a - 1) / 2", {"a": 7}, 1),
        ("SPEAK (a + b) / 2", {"a": 7, "b": -1}, 1),
        ("SPEAK (b + a) / 2", {"a": 7, "b": -1}, 1),
        ("SPEAK a / 2 / 2", {"a": -7}, 2),
        ("SPEAK DISTANCE F / 2", {}, 1),
        ("SPEAK a / b", {"a": -7, "b": 1}, 2),
        ("SPEAK a / b", {"a": 7, "b": -1}, 2),
        ("SPEAK a / -2", {"a": 7}, 2),
        ("SPEAK DISTANCE F / DISTANCE B", {}, 2),
        # a result: none, or with a small number and with the limit, on one side or on both
        ("SPEAK a + 1", {"a": 7}, 0),
        ("SPEAK a + 1", {"a": MOST}, 2),
        ("SPEAK a - 1", {"a": MOST}, 0),
        ("SPEAK a + 1", {"a": -MOST}, 2),
        ("SPEAK a - 1", {"a": -MOST}, 2),
        ("SPEAK a + -1", {"a": -MOST}, 2),
        ("SPEAK a - -1", {"a": -MOST}, 2),
        ("SPEAK a + 0", {"a": -MOST}, 2),
        ("SPEAK 1 + a", {"a": -MOST}, 4),
        ("SPEAK a + a", {"a": MOST}, 2),
        ("SPEAK a * a", {"a": MOST}, 2),
        ("SPEAK a * 2", {"a": -MOST}, 4),
        ("SPEAK a + b", {"a": MOST, "b": -1}, 4),
        ("SPEAK a - b", {"a": MOST, "b": -1}, 4),
        ("SPEAK a + 1 + 1", {"a": MOST}, 4),
        ("SPEAK a / 3 + 1", {"a": MOST}, 2),
    ],
)
def test_a_result_is_compared_only_with_the_numbers_that_it_may_pass(
    source: str, stored: dict[str, int], comparisons: int
) -> None:
    assert comparisons_in(source, dict(stored)) == comparisons


@pytest.mark.parametrize("make", BACK_ENDS.values(), ids=BACK_ENDS.keys())
@pytest.mark.parametrize(
    ("head", "said"),
    [
        ("i = 0; i < 3; i = i + 1", [0, 1, 2]),
        ("i = 0; i <= 3; i = 1 + i", [0, 1, 2, 3]),
        ("i = 0; i <= 4; i = i + 2", [0, 2, 4]),
        ("i = 0; i < 4; i = i + 2", [0, 2]),
        ("i = 3; i > 0; i = i - 1", [3, 2, 1]),
        ("i = 4; i >= 0; i = i - 2", [4, 2, 0]),
        ("i = 4; i > 0; i = i - 2", [4, 2]),
        ("i = 3; i < 3; i = i + 1", []),
        ("i = 3; i <= 3; i = i + 1", [3]),
        ("i = 0; i < 5; i = 5 - i", [0]),
        ("i = 0; i < n; i = i + 1", [0, 1]),
        ("i = 0; i <= n; i = i + n", [0, 2]),
        ("i = n; i >= -n; i = i - 3", [2, -1]),
    ],
)
def test_a_loop_counts_from_its_start_to_its_limit(make: Make, head: str, said: list[int]) -> None:
    assert run(f"VAR n = 2 FOR VAR {head} DO SPEAK i END FOR", make).actions.said == said


@pytest.mark.parametrize("make", BACK_ENDS.values(), ids=BACK_ENDS.keys())
@pytest.mark.parametrize(
    ("expression", "value"),
    [
        ("(a * n) / 2", -3),
        ("(n * a) / 2", -3),
        ("(a * a) / 2", 24),
        ("(a + n * 9) / 4", 0),
        ("(n * 9 + a) / 4", 0),
        ("(a - 9) / 4", 0),
        ("n * a / 2 / 2", -1),
        ("n * a * 3 / 2 / 2", -5),
        ("-a / 2", -3),
        ("-(a / 2)", -3),
        ("- -a / 2", 3),
        ("a / -2", -3),
        ("a / n / 2", -3),
        ("(n / a + 7) / 2", 3),
        ("(a / 2 - 9) / (a / 4 + 3)", -1),
        ("(a / (n - 1)) / (a / (n - 2))", 1),
        ("(n - a) / (a - 3)", -2),
        ("(n * -9) / 4", 2),
        ('DISTANCE "left  eye" / (n - 2)', -2),
        ("POS y / 3", -1),
        ("(POS y - 1) / (POS x - 5)", 2),
    ],
)
def test_every_quotient_is_cut_towards_zero(make: Make, expression: str, value: int) -> None:
    assert run(f"VAR a = 7 VAR n = -1 SPEAK {expression}", make).actions.said == [value]


def test_a_number_with_no_more_than_the_safe_bits_is_below_the_limit() -> None:
    assert 2**SAFE_BITS - 1 < LIMIT < 2 ** (SAFE_BITS + 1) - 1
    assert len(str(LIMIT - 1)) == LARGEST_DIGITS


@pytest.mark.parametrize("value", [0, 1, -1, LIMIT - 1, 1 - LIMIT])
def test_a_number_within_the_limit_passes(value: int) -> None:
    assert checked(value) == value


@pytest.mark.parametrize("beyond", [0, 1, 10**4000])
@pytest.mark.parametrize("sign", [1, -1])
def test_a_number_at_the_limit_is_refused(sign: int, beyond: int) -> None:
    with pytest.raises(ActionRefused) as refused:
        checked(sign * (LIMIT + beyond))

    assert refused.value.kind is MistakeKind.NUMBER_TOO_LARGE
    assert refused.value.details == {"limit": 4300}


@pytest.mark.parametrize(
    ("dividend", "divisor", "quotient"),
    [(7, 2, 3), (-7, 2, -3), (7, -2, -3), (-7, -2, 3), (6, 3, 2), (-6, 3, -2), (-1, 2, 0), (0, -5, 0)],
)
def test_a_quotient_has_no_fraction(dividend: int, divisor: int, quotient: int) -> None:
    assert divide(dividend, divisor) == quotient


def test_a_division_by_zero_is_refused() -> None:
    with pytest.raises(ActionRefused) as refused:
        divide(-5, 0)

    assert refused.value.kind is MistakeKind.DIVISION_BY_ZERO


def scopes_in(source: str) -> tuple[Scope, ...]:
    return tuple(scopes_of(Scope(read(source), None)))


def test_the_values_of_a_variable_are_those_of_its_assignments_and_of_the_calls() -> None:
    source = (
        "VAR a VAR b = 1 a = b + 2 FOR VAR i = 3; i < 4; i = i + 5 DO END FOR FOR a = 6; 1 < 2; b = 7 DO "
        "END FOR PROCEDURE P: n, m DO VAR k = n P [k] END PROCEDURE P [a, 8] P [9] "
        "PROCEDURE P: n DO END PROCEDURE"
    )
    scopes = scopes_in(source)
    names = [f"P{len(each.parameters)}" if each.procedure else "program" for each in scopes]
    found = {
        f"{variable} of {names[number]}": sorted(
            f"{scopes[scope].program.typed(value.span)} of {names[scope]}" for scope, value in values
        )
        for (number, variable), values in assignments_of(scopes).items()
    }

    assert found == {
        "a of program": ["6 of program", "b + 2 of program"],
        "b of program": ["1 of program", "7 of program"],
        "i of program": ["3 of program", "i + 5 of program"],
        "n of P2": ["a of program"],
        "m of P2": ["8 of program"],
        "k of P2": ["n of P2"],
        "n of P1": ["9 of program", "k of P2"],
    }


@pytest.mark.parametrize(
    ("source", "negative"),
    [
        ("VAR a VAR b = 1 VAR c = a + b * 2 / 3", ""),
        ("VAR a = -1 VAR b = a + 1 VAR c = 2 * b VAR d = c / 2 VAR e = 3", "a b c d"),
        ("VAR a = 1 VAR b = a - 1", "b"),
        ("VAR a = DISTANCE F VAR b = POS x VAR c = COLOR red", "a b c"),
        ("VAR a = 0 VAR b = 0 a = b b = a VAR c = 1 c = a", ""),
        ("VAR a = 0 VAR b = 0 a = b b = a VAR c = -1 a = c", "a b c"),
        ("VAR a = 1 PROCEDURE P: b DO a = b END PROCEDURE P [-1]", ""),
    ],
)
def test_a_variable_may_be_negative_if_one_of_its_values_may_be(source: str, negative: str) -> None:
    given = assignments_of(scopes_in(source))
    naturals = NonNegatives(given, {})

    assert [name for name in "abcde" if not naturals.has(0, name)] == negative.split()


def test_a_negative_number_of_an_earlier_batch_counts() -> None:
    naturals = NonNegatives(assignments_of(scopes_in("VAR c = a VAR d = b")), {"a": -1, "b": 0})

    assert [name for name in "abcd" if not naturals.has(0, name)] == ["a", "c"]


@pytest.mark.parametrize(
    ("source", "variable", "value"),
    [
        ("VAR a", "a", 0),
        ("VAR a = 1000", "a", 1000),
        ("VAR a = 1000 VAR b = a * a * a", "b", 10**9),
        ("VAR a = 1000 VAR b = a + a + a + a + a", "b", 5000),
        ("VAR a = 1000 VAR b = (a + a + a) * (a - -a)", "b", 6 * 10**6),
        ("VAR a = 1000 VAR b = a * a / 3", "b", 333_333),
        ("VAR a = 1000 VAR b = (a * a / 3) * a", "b", 333_333_000),
        ("VAR a = 1000 a = 5 VAR b = a", "b", 1000),
        ("VAR a = DISTANCE F * DISTANCE B", "a", 2**63 * 2**63),
        ("VAR a = 1 a = a + 1000", "a", 2**63 * 1000),
        ("VAR a = 1 a = a - DISTANCE F - DISTANCE B", "a", 2**63 * 2 * 2**63),
    ],
)
def test_no_value_of_a_variable_has_more_bits_than_are_known_for_it(
    source: str, variable: str, value: int
) -> None:
    """A counter may change 2**63 times, a sensor say 2**63. The bound is no more than a few bits above."""
    bits = NumberSizes(assignments_of(scopes_in(source)), {}).bits(0, variable)

    assert value.bit_length() <= bits <= value.bit_length() + 20


@pytest.mark.parametrize(
    "source",
    [
        "VAR a = 1 a = a * 2",
        "VAR a = 1 a = a + a",
        "VAR a = 1 VAR b a = b b = a",
        "VAR a = 1 VAR b = a * a a = b",
    ],
)
def test_a_number_that_depends_on_itself_has_no_known_bits(source: str) -> None:
    sizes = NumberSizes(assignments_of(scopes_in(source)), {})

    assert sizes.bits(0, "a") == float("inf")
    assert sizes.bits(0, "a") == float("inf")


def test_the_bits_of_a_number_of_an_earlier_batch_count_in_the_program_only() -> None:
    given = assignments_of(scopes_in("VAR b = a PROCEDURE P: a DO END PROCEDURE P [1]"))
    sizes = NumberSizes(given, {"a": 2**100})

    assert 101 <= sizes.bits(0, "b") < 111
    assert 101 <= sizes.bits(0, "a") < 111
    assert sizes.bits(1, "a") < 10


@pytest.mark.parametrize("is_hooked", [True, False])
def test_each_unit_is_entered_eight_times_and_does_nothing(is_hooked: bool) -> None:
    """As often as CPython 3.11 needs before it specializes the code."""
    source = "PROCEDURE P: a, b, c DO WHILE a < b DO P [a, b, c] END WHILE END PROCEDURE\nPROCEDURE Q DO\n"
    source += "SPEAK 1 END PROCEDURE\nVAR n = 3 P [1, 2, n] Q []"
    units = link(read(source), Memory({}, {}), terminal=True, hooked=is_hooked)
    entered = Counter[CodeType]()

    def note(frame: FrameType, event: str, _: object) -> None:
        entered[frame.f_code] += event == "call"

    before = sys.getprofile()
    sys.setprofile(note)
    try:
        warm_up(units)
    finally:
        sys.setprofile(before)

    assert {unit.name: entered[unit.code] for unit in units} == {"": 8, "p": 8, "q": 8}
