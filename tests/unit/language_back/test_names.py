"""Which names exist at which place: variables, parameters, procedures, variables of FOR."""

from __future__ import annotations

import pytest

from tests.unit.language_back.recorder import BACK_ENDS, Make, run

back_ends = pytest.mark.parametrize("make", BACK_ENDS.values(), ids=BACK_ENDS.keys())


@back_ends
@pytest.mark.parametrize(
    ("source", "place"),
    [
        ("SPEAK 1\nSPEAK  none", ("undeclared-variable", 2, 8)),
        ("none = zilch", ("undeclared-variable", 1, 1)),
        ("VAR a = 1\nVAR b = a + none", ("undeclared-variable", 2, 13)),
        ("VAR a = a", ("undeclared-variable", 1, 9)),
        ("VAR a\nVAR a", ("already-declared", 2, 5)),
        ("VAR a\nVAR a = none", ("already-declared", 2, 5)),
        ("VAR a\nFOR VAR a = 0; a < 1; a = a + 1 DO END FOR", ("already-declared", 2, 9)),
        ("FOR VAR i = 0; i < 1; i = i + 1 DO VAR i END FOR", ("already-declared", 1, 40)),
        ("FOR VAR i = 0; i < 1; i = i + 1 DO\n END FOR SPEAK i", ("undeclared-variable", 2, 16)),
        ("FOR VAR i = 0; i < 1; i = i + 1 DO END FOR\ni = 3", ("undeclared-variable", 2, 1)),
        ("FOR VAR i = 0; i < 1; i = i + i DO\nj = 3 END FOR", ("undeclared-variable", 2, 1)),
        ("FOR VAR i = 0; i > 5; j = 1 DO END FOR\nj = 2", ("undeclared-variable", 2, 1)),
        ("WHILE 1 == 2 DO VAR a END WHILE\na = 2", ("undeclared-variable", 2, 1)),
        ("IF 1 == 2 THEN VAR a ELSE VAR b END IF\na = 1", ("undeclared-variable", 2, 1)),
        ("IF 1 == 1 THEN VAR a ELSE VAR b END IF\nb = 1", ("undeclared-variable", 2, 1)),
        ("FOR i = 0; i < 1; i = i + 1 DO END FOR", ("undeclared-variable", 1, 5)),
        ("FOR VAR i = 0; i < n; i = i + 1 DO END FOR", ("undeclared-variable", 1, 20)),
        ("FOR VAR i = 0; i < 1; j = i + 1 DO END FOR", ("undeclared-variable", 1, 23)),
        ("FOR VAR i = 0; i < 1; i = j + 1 DO END FOR", ("undeclared-variable", 1, 27)),
        ("WHILE 1 == w DO END WHILE", ("undeclared-variable", 1, 12)),
        ("REPEAT r TIMES END REPEAT", ("undeclared-variable", 1, 8)),
        ("IF 1 == 2 THEN VAR a END IF\nSPEAK a", ("undeclared-variable", 2, 7)),
        ("IF 1 == 2 THEN VAR a END IF\na = 1", ("undeclared-variable", 2, 1)),
        ("IF 1 == 1 THEN SPEAK 1 ELSE VAR a END IF\na = 1", ("undeclared-variable", 2, 1)),
        ("REPEAT 0 TIMES VAR a END REPEAT a = 1", ("undeclared-variable", 1, 33)),
        ("NOPE [1]", ("undeclared-procedure", 1, 1)),
        ("P [1]\nPROCEDURE P: a DO END PROCEDURE", ("undeclared-procedure", 1, 1)),
        ("IF 1 == 2 THEN PROCEDURE P DO END PROCEDURE END IF\n P []", ("undeclared-procedure", 2, 2)),
        ("PROCEDURE P: a DO END PROCEDURE\n  P []", ("wrong-argument-count", 2, 3)),
        ("PROCEDURE P: a, a DO END PROCEDURE", ("already-declared", 1, 17)),
        ("PROCEDURE P: a DO VAR a END PROCEDURE P [1]", ("already-declared", 1, 23)),
        ("PROCEDURE P DO END PROCEDURE\nPROCEDURE P DO END PROCEDURE", ("already-declared", 2, 11)),
        ("PROCEDURE P DO SPEAK g END PROCEDURE VAR g P []", ("undeclared-variable", 1, 22)),
        ("SPEAK 1 QUIT", ("terminal-only", 1, 9)),
        ("RUN", ("terminal-only", 1, 1)),
        ("VIBRATE F", ("belt-off", 1, 1)),
    ],
)
def test_a_mistake_has_its_kind_and_its_place(make: Make, source: str, place: tuple[str, int, int]) -> None:
    assert run(source, make).place == place


@back_ends
@pytest.mark.parametrize(
    ("source", "said"),
    [
        ("REPEAT 2 TIMES VAR a a = a + 1 SPEAK a END REPEAT", [1, 1]),
        ("IF 1 == 1 THEN VAR a = 4 ELSE VAR a = 5 END IF SPEAK a", [4]),
        ("REPEAT 2 TIMES FOR VAR i = 0; i < 1; i = i + 1 DO SPEAK i END FOR END REPEAT", [0, 0]),
        ("FOR VAR i = 0; i < 1; i = i + 1 DO SPEAK i END FOR VAR i = 7 SPEAK i", [0, 7]),
        ("VAR i FOR i = 3; i < 5; i = i + 1 DO SPEAK i END FOR SPEAK i", [3, 4, 5]),
        ("FOR VAR i = 9; i > 5; i = i - 2 DO SPEAK i END FOR", [9, 7]),
        ("VAR n = 3 FOR VAR i = 1; i <= n; i = i + 1 DO n = n - 1 SPEAK i END FOR", [1, 2]),
        ("FOR VAR i = 0; i < 9; i = i + 1 DO i = i * 3 SPEAK i END FOR", [0, 3, 12]),
        ("FOR VAR d = 0; d > 5; d = d + 1 DO SPEAK d END FOR", []),
        ("VAR n = 2 REPEAT n TIMES n = 5 SPEAK n END REPEAT", [5, 5]),
        ("PROCEDURE P: a DO a = a + 1 SPEAK a END PROCEDURE VAR a = 1 P [a] SPEAK a", [2, 1]),
        ("REPEAT 2 TIMES PROCEDURE P DO SPEAK 1 END PROCEDURE END REPEAT P []", [1]),
        ("PROCEDURE P DO PROCEDURE Q DO SPEAK 2 END PROCEDURE END PROCEDURE P [] Q []", [2]),
        ("PROCEDURE P DO Q [] END PROCEDURE PROCEDURE Q DO SPEAK 3 END PROCEDURE P []", [3]),
        ("VAR p = 3 PROCEDURE P: p DO SPEAK p END PROCEDURE P [p + 1] SPEAK p", [4, 3]),
        ("DISTANCE F POS x COLOR red SPEAK 1", [1]),
        ("IF 1 == 2 THEN VAR a ELSE VAR a = 2 END IF a = a + 1 SPEAK a", [3]),
        ("VAR a IF 1 == 1 THEN a = 2 ELSE a = 3 END IF SPEAK a", [2]),
        ("VAR j FOR VAR i = 0; i < 4; i = i + 2 DO j = j + i END FOR SPEAK j", [2]),
    ],
)
def test_names_exist_as_long_as_the_rules_say(make: Make, source: str, said: list[int]) -> None:
    outcome = run(source, make)

    assert outcome.error is None
    assert outcome.actions.said == said


@back_ends
def test_a_sensor_on_its_own_line_is_not_read(make: Make) -> None:
    assert run("DISTANCE F", make).actions.done == []


@back_ends
def test_the_variables_are_kept_at_the_end_and_after_a_mistake(make: Make) -> None:
    assert run("VAR a = 2 VAR b = a", make).variables == {"a": 2, "b": 2}
    assert run("VAR a = 2 VAR b = a / 0", make).variables == {"a": 2}
    assert run("VAR a = 2 PROCEDURE P: b DO VAR c b = d END PROCEDURE P [1]", make).variables == {"a": 2}


@back_ends
def test_the_variable_of_a_for_header_ends_with_the_loop_however_it_ends(make: Make) -> None:
    inside = "VAR n VAR i2 FOR VAR i = 0; i < 3; i = i + 1 DO n = n / i END FOR"
    nested = "FOR VAR i = 0; i < 3; i = i + 1 DO FOR VAR j = 0; j < 3; j = 1 / j DO END FOR END FOR"
    header = "VAR i = 9 FOR VAR i = 0; i < 2; i = i + 1 DO END FOR"

    assert run(inside, make).variables == {"n": 0, "i2": 0}
    assert run(nested, make).variables == {}
    assert run(header, make).variables == {"i": 9}


@back_ends
def test_a_variable_of_the_program_is_named_as_such_in_a_procedure(make: Make) -> None:
    outcome = run("VAR total PROCEDURE Sum DO\nSPEAK total END PROCEDURE Sum []", make)

    assert outcome.diagnostic.details == {"name": "total", "in_procedure": "Sum"}
    assert outcome.diagnostic.meant == ""


@back_ends
def test_a_near_name_is_offered_as_it_was_typed(make: Make) -> None:
    assert run("VAR Direção = 1 SPEAK direcoa", make).diagnostic.meant == "Direção"
    assert run("PROCEDURE Square DO END PROCEDURE Squre []", make).diagnostic.meant == "Square"
    assert run("VAR total SPEAK 1 + something", make).diagnostic.meant == ""
    assert run("PROCEDURE P: length DO SPEAK lenght END PROCEDURE P [1]", make).diagnostic.meant == "length"


@back_ends
def test_a_clash_has_the_kind_and_the_first_line_of_the_other_name(make: Make) -> None:
    variable = run("\nVAR a\nVAR A", make).diagnostic.details
    procedure = run("PROCEDURE P DO END PROCEDURE\n\nPROCEDURE p DO END PROCEDURE", make).diagnostic.details
    parameter = run("PROCEDURE P: a DO VAR a END PROCEDURE P [1]", make).diagnostic.details

    assert variable == {"name": "A", "what": "variable", "first_line": 2}
    assert procedure == {"name": "p", "what": "procedure", "first_line": 1}
    assert parameter == {"name": "a", "what": "parameter"}


@back_ends
def test_a_wrong_count_has_both_counts(make: Make) -> None:
    outcome = run("PROCEDURE Square: a DO END PROCEDURE square [1, 2, 3]", make)

    assert outcome.diagnostic.details == {"name": "Square", "wanted": 1, "given": 3}


@back_ends
def test_a_mistake_carries_the_open_calls_innermost_first(make: Make) -> None:
    source = (
        "PROCEDURE Outer: n DO\nREPEAT 1 TIMES\nInner [n]\nEND REPEAT\nEND PROCEDURE\n"
        "PROCEDURE Inner: n DO\nSPEAK 1 / n\nEND PROCEDURE\n\nOuter [0]"
    )
    outcome = run(source, make)

    assert outcome.place[:2] == ("division-by-zero", 7)
    assert outcome.calls == [("Inner", 3), ("Outer", 10)]


@back_ends
def test_a_mistake_after_many_iterations_is_still_found_at_its_name(make: Make) -> None:
    """CPython then runs frequent instructions in pairs and reports the place of the first."""
    source = (
        "VAR a = 1 VAR b\nREPEAT 100 TIMES\nFOR VAR c = 0; c < 1; c = c + 1 DO\nb = a + c\nEND FOR\n"
        "IF b > 50 THEN\n FOR VAR d = 0; d < 1; d = d + 1 DO END FOR\nEND IF\n"
        "IF a > 99 THEN VAR c = 1 END IF\n"
        "a = a + 1\nIF a > 60 THEN b = a + c END IF\nEND REPEAT"
    )

    assert run(source, make).place == ("undeclared-variable", 11, 24)


@back_ends
def test_the_words_of_the_gripper_are_still_names_of_variables_and_procedures(make: Make) -> None:
    source = """
PROCEDURE RELEASE: tomar DO
  VAR soltar = tomar + 1
  SPEAK soltar
END PROCEDURE
VAR grip = 1
VAR pegar
FOR pegar = 0; pegar < 2; pegar = pegar + 1 DO
  GRIP
  grip = grip * 2
END FOR
RELEASE [grip]
RELEASE
"""

    done = run(source, make).actions.done

    assert done == [("grip",), ("grip",), ("speak", 5), ("release",)]
