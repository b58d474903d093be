"""Hints are never guesses."""

import pytest

from language.checker import check
from language.diagnostics import Severity
from language.parser import parse


def hints(source: str, *, whole: bool = True) -> list[tuple[str, int, int]]:
    program = parse(source).program
    assert program is not None
    found = check(program, whole=whole)
    assert all(each.severity is Severity.HINT for each in found)
    return [(each.kind.value, each.span.line, each.span.column) for each in found]


@pytest.mark.parametrize(
    ("source", "meant"),
    [
        ("DISTANCE", "SPEAK DISTANCE F"),
        ("distance br", "SPEAK DISTANCE BR"),
        ("PF 1 DISTÂNCIA T", "FALAR DISTÂNCIA T"),
        ("REPEAT 2 TIMES COLOR red END REPEAT", "SPEAK COLOR RED"),
        ("AV 1 POS X", "HABLAR POS X"),
        ("PF -2", "PT 2"),
        ("TR -90 BW - 5", "FW 5"),
        ('DISTANCE "left"', 'SPEAK DISTANCE "left"'),
    ],
)
def test_a_command_that_does_nothing_has_a_hint_with_a_suggestion(source: str, meant: str) -> None:
    program = parse(source).program
    assert program is not None

    (hint,) = check(program, whole=False)

    assert (hint.kind.value, hint.meant) == ("unused-value", meant)


@pytest.mark.parametrize(
    ("source", "word", "speak", "value"),
    [
        ('DISTANCIA "izquierda" AV 1', "DISTANCE", "HABLAR", 'DISTANCIA "izquierda"'),
        ("DISTANCE f", "DISTANCE", "SPEAK", "DISTANCE F"),
        ("PF 1 POS y", "POS", "FALAR", "POS Y"),
        ("PF 1 COR verde", "COLOR", "FALAR", "COR VERDE"),
        ("DISTANCIA F", "DISTANCE", "HABLAR", "DISTANCIA F"),
        ("COLOR azul", "COLOR", "HABLAR", "COLOR AZUL"),
    ],
)
def test_the_hint_about_a_value_names_its_sensor(source: str, word: str, speak: str, value: str) -> None:
    program = parse(source).program
    assert program is not None

    (hint,) = check(program, whole=False)

    assert (hint.code, hint.details) == ("", {"word": word, "speak": speak, "value": value})


def test_a_walk_of_no_steps_has_no_hint_and_one_backwards_says_what_it_is() -> None:
    assert hints("FW 0 BW -0 FW 2") == []
    program = parse("FW 1\nFW -2").program
    assert program is not None

    (hint,) = check(program)

    assert (hint.code, hint.found, hint.span.line) == ("steps", "FW -2", 2)


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("SPEAK total", [("undeclared-variable", 1, 7)]),
        ("FW 1\ntotal = 3", [("undeclared-variable", 2, 1)]),
        ("IF a < b THEN END IF", [("undeclared-variable", 1, 4), ("undeclared-variable", 1, 8)]),
        ("VAR g PROCEDURE P DO SPEAK g END PROCEDURE", [("undeclared-variable", 1, 28)]),
        ("FOR i = 0; i < 2; j = 1 DO END FOR", [("undeclared-variable", 1, c) for c in (5, 19)]),
        ("NOPE [1]", [("undeclared-procedure", 1, 1)]),
        ("NOPE [1] nope [2] SPEAK q Q = q", [("undeclared-procedure", 1, 1), ("undeclared-variable", 1, 25)]),
        ("PROCEDURE P: a DO END PROCEDURE P [1, 2]", [("wrong-argument-count", 1, 33)]),
        ("VAR a = q VAR b", [("undeclared-variable", 1, 9)]),
        ("PROCEDURE P DO VAR a = q END PROCEDURE", [("undeclared-variable", 1, 24)]),
        ("FW 1\nQUIT", [("terminal-only", 2, 1)]),
        ("RUN", [("terminal-only", 1, 1)]),
    ],
)
def test_names_that_are_surely_missing(source: str, expected: list[tuple[str, int, int]]) -> None:
    assert hints(source) == expected
    assert hints(source, whole=False) == []


@pytest.mark.parametrize(
    "source",
    [
        "VAR a SPEAK a",
        "SPEAK a VAR a",
        "IF 1 == 2 THEN VAR k END IF SPEAK k",
        "FOR VAR i = 0; i < 2; i = i + 1 DO SPEAK i END FOR SPEAK i",
        "PROCEDURE P: a DO VAR b = a SPEAK b P [b] END PROCEDURE",
        "P [1] PROCEDURE P: a DO END PROCEDURE PROCEDURE P DO END PROCEDURE P [] P [1, 2]",
        "VAR é SPEAK E\u0301",
    ],
)
def test_what_may_work_has_no_hint(source: str) -> None:
    assert hints(source) == []


def test_a_hint_about_a_program_variable_in_a_procedure_says_so() -> None:
    program = parse("VAR g\nPROCEDURE Pê DO SPEAK g END PROCEDURE").program
    assert program is not None

    (hint,) = check(program)

    assert hint.details["in_procedure"] == "Pê"


def test_a_near_name_is_offered() -> None:
    program = parse("VAR total SPEAK totla").program
    assert program is not None

    assert check(program)[0].meant == "total"


@pytest.mark.parametrize(
    ("source", "name", "meant"),
    [
        ("Pê [1]", "Pê", ""),
        ("SPEAK Época", "Época", '"Época"'),
        ("SPEAK Época + 1", "Época", ""),
        ("SPEAK q", "q", ""),
        ("VAR Ação SPEAK acaos", "acaos", "Ação"),
        ("PROCEDURE Dança DO END PROCEDURE Danca [1]", "Danca", ""),
        ("PROCEDURE Dança DO END PROCEDURE Dancas []", "Dancas", "Dança"),
    ],
)
def test_a_name_is_quoted_as_it_was_typed(source: str, name: str, meant: str) -> None:
    program = parse(source).program
    assert program is not None

    (hint,) = check(program)

    assert (hint.details["name"], hint.meant) == (name, meant)


@pytest.mark.parametrize(
    ("source", "meant"),
    [
        ("FALAR DISTANSIA", "DISTÂNCIA"),
        ("SPEAK COLOUR", "COLOR"),
        ("colour = 3", ""),
        ("VAR color1 SPEAK colr1", "color1"),
    ],
)
def test_a_name_without_a_variable_may_be_a_misspelt_sensor_where_its_value_is_asked_for(
    source: str, meant: str
) -> None:
    program = parse(source).program

    assert program is not None
    assert [each.meant for each in check(program)] == [meant]


@pytest.mark.parametrize(
    ("source", "written", "meant"),
    [
        ("FW two", "FW 2", "2"),
        ("PF três", "PF 3", "3"),
        ("AV diez", "AV 10", "10"),
        ("REPEAT four TIMES FW 1 END REPEAT", "REPEAT 4", "4"),
        ("FW 1 + two", "2", "2"),
    ],
)
def test_a_number_in_letters_is_offered_in_digits(source: str, written: str, meant: str) -> None:
    (hint,) = check(parse(source).program)

    assert (hint.code, hint.details["written"], hint.meant) == ("number-word", written, meant)


def test_a_variable_may_be_called_like_a_number() -> None:
    assert check(parse("VAR two = 2 FW two").program) == ()


@pytest.mark.parametrize(
    ("source", "name", "code", "meant", "written"),
    [
        ("SPEAK hello", "hello", "spoken", '"hello"', 'SPEAK "hello"'),
        ("SPEAK\thello", "hello", "spoken", '"hello"', 'SPEAK "hello"'),
        ("SPEAK hello -- c", "hello", "spoken", '"hello"', 'SPEAK "hello"'),
        ("SPEAK hello\rFW 1", "hello", "spoken", '"hello"', 'SPEAK "hello"'),
        ("speak Hello ; ; -- x", "Hello", "spoken", '"Hello"', 'speak "Hello"'),
        ("FALAR oi", "oi", "spoken", '"oi"', 'FALAR "oi"'),
        ("SPEAK ( +hello)", "hello", "spoken", '"hello"', 'SPEAK "hello"'),
        ("SPEAK h", "h", "", "", None),
        ("FW hello", "hello", "", "", None),
        ("SPEAK hello FW 1", "hello", "", "", None),
        ("SPEAK hello; FW 1", "hello", "", "", None),
        ("SPEAK\nhello", "hello", "", "", None),
        ("SPEAK hello + 1", "hello", "", "", None),
        ("FW  two", "two", "number-word", "2", "FW 2"),
        ("FW\ntwo", "two", "number-word", "2", "2"),
        ("FW -two", "two", "number-word", "2", "2"),
        ("FW (two)", "two", "number-word", "2", "FW 2"),
        ("SPEAK two", "two", "number-word", "2", "SPEAK 2"),
        ("VAR sevens FW seven", "seven", "", "sevens", None),
        ("VAR hellos SPEAK hello", "hello", "", "hellos", None),
        ("VAR hello PROCEDURE P DO SPEAK helo END PROCEDURE", "helo", "", "", None),
        ("PROCEDURE P: hello DO SPEAK helo END PROCEDURE", "helo", "", "hello", None),
        ("FOR VAR Index = 0; indx < 2; index = 1 DO END FOR", "indx", "", "Index", None),
        ("FOR VAR i = 0; i < 2; i = 1 DO FW (nix) END FOR", "nix", "", "", None),
    ],
)
def test_a_name_that_is_missing_says_what_may_be_meant(
    source: str, name: str, code: str, meant: str, written: str | None
) -> None:
    (hint,) = check(parse(source).program)

    assert (hint.details["name"], hint.code, hint.meant) == (name, code, meant)
    assert hint.details.get("written") == written


def test_a_wrong_count_names_both_counts() -> None:
    (hint,) = check(parse("PROCEDURE Pê: a DO END PROCEDURE pe [1, 2]").program)

    assert hint.details == {"name": "pe", "wanted": 1, "given": 2}


def test_the_hints_are_in_the_order_of_the_text() -> None:
    source = "SPEAK q DISTANCE f NOPE [] FW -2 QUIT POS x"

    assert [column for _, _, column in hints(source)] == [7, 9, 20, 28, 34, 39]
