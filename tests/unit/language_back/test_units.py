"""A compiled scope leads from its sites to the places of the text."""

from __future__ import annotations

import sys
from typing import Any

import pytest

from language.call_stack import DEEPEST_CALL, Activation, first_link
from language.python_code import ForHeader, Sites, Unit, hook_depth_at, procedure_taking
from language.runtime import Frame
from language.syntax import Procedure, Program, Span
from tests.unit.language_back.recorder import read

CODE = (lambda: None).__code__


def unit(program: Program, procedure: Procedure | None = None, *headers: ForHeader) -> Unit:
    """One with two sites: the statements of the program."""
    return Unit(program, procedure, CODE, program.body, headers, frozenset(), frozenset())


PROGRAM = read("FW 1\n  BW 2")
FIRST, SECOND = (each.span for each in PROGRAM.body)


@pytest.mark.parametrize(
    ("site", "span"),
    [(1, FIRST), (2, SECOND), (3, FIRST), (0, FIRST), (None, FIRST)],
)
def test_code_without_a_site_is_at_the_first_statement(site: int | None, span: Span) -> None:
    assert unit(PROGRAM).span(site) == span


def test_the_code_of_an_empty_program_is_at_its_beginning() -> None:
    assert unit(read("")).span(1) == Span(0, 0, 1, 1)


def test_code_of_a_procedure_without_a_site_is_at_the_procedure() -> None:
    program = read("FW 1\nPROCEDURE Go DO END PROCEDURE")
    procedure = program.body[1]
    assert isinstance(procedure, Procedure)
    found = unit(program, procedure)

    assert found.span(None) == procedure.span
    assert (found.typed_name, found.name) == ("Go", "go")
    assert (found.declared.procedure, found.declared.program) == (procedure, program)
    assert (unit(program).typed_name, unit(program).name) == ("", "")


@pytest.mark.parametrize(("site", "number"), [(1, 0), (2, 1)])
def test_a_site_is_a_node_counted_from_one(site: int, number: int) -> None:
    assert unit(PROGRAM).node(site) is PROGRAM.body[number]


@pytest.mark.parametrize("site", [None, 0, 3])
def test_no_other_site_has_a_node(site: int | None) -> None:
    assert unit(PROGRAM).node(site) is None


@pytest.mark.parametrize(
    ("site", "names"), [(1, ""), (2, "i"), (3, "i j"), (4, "i j"), (5, "j"), (6, "j"), (7, "")]
)
def test_the_variable_of_a_header_exists_from_its_first_to_its_last_site(site: int, names: str) -> None:
    headers = (ForHeader("i", 2, 4), ForHeader("j", 3, 6))

    assert unit(PROGRAM, None, *headers).headers_at(site) == frozenset(names.split())


def test_sites_are_numbered_from_one() -> None:
    sites = Sites()

    assert sites.next == 1
    assert [sites.new(each) for each in PROGRAM.body] == [1, 2]
    assert sites.next == 3
    assert sites.nodes == [*PROGRAM.body]


def test_the_names_of_python_are_of_one_line_or_one_procedure() -> None:
    assert (
        len({hook_depth_at(1), hook_depth_at(11), procedure_taking("p", 1), procedure_taking("p", 11)}) == 4
    )


def test_a_link_has_the_number_of_open_calls_and_the_next_link() -> None:
    link, depths = first_link(3), []
    while True:
        depths.append(link[0])
        if len(link) == 1:
            break
        link = link[1]

    assert depths == [0, 1, 2, 3]
    assert DEEPEST_CALL == 20_000


def test_the_next_site_is_that_of_the_instruction_after_the_one_that_failed() -> None:
    """As a site is a line of Python for the code of a unit."""
    names: dict[str, Any] = {}
    text = "def add():\n if False:\n  missing = 1\n return (missing\n  + 1)"
    exec(compile(text, "<GoDonnie>", "exec"), names)

    with pytest.raises(UnboundLocalError) as raised:
        names["add"]()
    frame = raised.traceback[-1].frame.raw

    assert frame.f_lineno == 4
    assert Activation(unit(PROGRAM), frame, None, frame).next_site() == 5


def test_an_activation_has_the_line_of_its_site_and_the_variables_of_its_frame() -> None:
    frame = sys._getframe()
    v_a, v_b, o_a = 5, "text", 6
    activation = Activation(unit(PROGRAM), frame, 2, frame)

    assert activation.line == 2
    assert activation.variables() == {"a": 5}
    assert activation.snapshot() == Frame("", 2, (("a", 5),))
    assert (v_a, v_b, o_a) == (5, "text", 6)
