"""The code makes only the checks that its numbers need, and counts as fast as Python where it can."""

from __future__ import annotations

import pytest

from language.compiler import link
from language.numbers import LIMIT
from language.runtime import Memory
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
    ("VAR n = 3 FOR VAR i = 0; i < n; i = i + 1 DO n = 5 END FOR", ""),
    ("VAR n = 3 FOR VAR i = 0; i < n; i = i + 1 DO IF 1 < 2 THEN n = 5 END IF END FOR", ""),
    ("VAR n = 2 FOR VAR i = 0; i < 3; i = i + n DO END FOR", ""),
    ("VAR i FOR i = 0; i < 3; i = i + 1 DO END FOR", ""),
    ("VAR j FOR VAR i = 0; i < 3; j = j + 1 DO END FOR", ""),
    ("VAR j FOR VAR i = 0; j < 3; i = i + 1 DO END FOR", ""),
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
        ("PROCEDURE P: a DO SPEAK a * a END PROCEDURE P [2]", {"a": LIMIT - 1}, ""),
    ],
)
def test_the_numbers_of_an_earlier_batch_count(source: str, stored: dict[str, int], helpers: str) -> None:
    assert helpers_in(source, stored) == helpers


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
