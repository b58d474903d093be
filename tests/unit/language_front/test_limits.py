"""A program beyond a limit has a mistake, and long texts have a result."""

import sys
import tracemalloc
from types import FrameType
from typing import Any

import pytest

from language.checker import check
from language.diagnostics import MistakeKind
from language.outline import block_depth, outline
from language.parser import MOST_BLOCKS, MOST_PARENTHESES, parse
from language.syntax import walk
from language.tree_builder import MOST_LEVELS
from tests.formatting import format_source
from tests.tools import fuzz
from tests.tools.fuzz import Kind

REPEAT, END = "REPEAT 2 TIMES ", " END REPEAT"


def nested(count: int) -> str:
    return REPEAT * count + END * count


def in_parentheses(count: int) -> str:
    return "SPEAK " + "(" * count + "1" + ")" * count


@pytest.mark.parametrize(
    "source",
    [
        nested(MOST_BLOCKS),
        in_parentheses(MOST_PARENTHESES),
        "SPEAK 1" + " + 1" * (MOST_LEVELS - 1),
        "SPEAK " + "- " * (MOST_LEVELS - 1) + "1",
        "SPEAK " + "(1 + " * (MOST_LEVELS - 1) + "1" + ")" * (MOST_LEVELS - 1),
        (nested(60) + "\n") * 20,
        (in_parentheses(60) + "\n") * 20,
        "SPEAK 1" + (" " * 500 + "+ 1") * 100,
    ],
)
def test_up_to_the_limit_everything_works(source: str) -> None:
    program = parse(source).program
    assert program is not None

    assert list(walk(program.body))
    check(program)
    assert format_source(source)


@pytest.mark.parametrize(
    ("source", "code", "column"),
    [
        (nested(MOST_BLOCKS + 1), "blocks", MOST_BLOCKS * len(REPEAT) + 1),
        (REPEAT * 50_000, "blocks", MOST_BLOCKS * len(REPEAT) + 1),
        (in_parentheses(MOST_PARENTHESES + 1), "parentheses", MOST_PARENTHESES + 7),
        ("SPEAK " + "(" * 50_000, "parentheses", MOST_PARENTHESES + 7),
        ("SPEAK 1" + " + 1" * MOST_LEVELS, "expression", 7),
        ("SPEAK 1" + "+1" * 50_000, "expression", 7),
        ("SPEAK " + "1+(" * 150 + "1" + "+1" * 60 + ")" * 150, "expression", None),
    ],
)
def test_too_deep_nesting_is_one_mistake_with_its_limit(source: str, code: str, column: int | None) -> None:
    parsed = parse(source)

    assert parsed.program is None
    assert [(each.kind, each.code) for each in parsed.diagnostics] == [(MistakeKind.TOO_DEEP, code)]
    assert parsed.diagnostics[0].details["limit"] == 200
    assert column is None or parsed.diagnostics[0].span.column == column


def test_an_expression_that_is_too_deep_is_found_in_a_wrong_text_unless_another_mistake_is() -> None:
    deep = "SPEAK " + "- " * 4100 + "1"
    after_sign, after_mistake = parse(f"$\nJUMP\n{deep}").diagnostics, parse(f"FW )\n{deep}").diagnostics

    assert [each.kind for each in after_sign] == [MistakeKind.UNKNOWN_CHARACTER, MistakeKind.TOO_DEEP]
    assert (after_sign[1].code, after_sign[1].span.line) == ("expression", 3)
    assert after_sign[1].details == {"limit": MOST_LEVELS}
    assert [each.kind for each in after_mistake] == [MistakeKind.SYNTAX]


@pytest.mark.parametrize(
    "source",
    [
        "REPEAT 2 TIMES END " * (MOST_BLOCKS + 1),
        "REPEAT 2 TIMES END REPEAT " * (MOST_BLOCKS + 1) + ")",
        "FW ( " * (MOST_PARENTHESES + 1),
        "x = ( " * (MOST_PARENTHESES + 1),
        "FW (1) " * (MOST_PARENTHESES + 1) + ")",
        "P [(1), (2), " + "(3), " * MOST_PARENTHESES + "]",
    ],
    ids=lambda source: f"{source[:20]!r}",
)
def test_what_stands_one_after_the_other_is_not_too_deep(source: str) -> None:
    found = {each.kind for each in parse(source).diagnostics}

    assert found
    assert MistakeKind.TOO_DEEP not in found


@pytest.mark.parametrize(
    ("source", "code"),
    [
        ("END IF END; " + nested(MOST_BLOCKS + 1), "blocks"),
        ("REPEAT 2 TIMES END REPEAT " + nested(MOST_BLOCKS + 1), "blocks"),
        ("FW ) ) " + "SPEAK " + "(" * (MOST_PARENTHESES + 1), "parentheses"),
        ("FW (1) + " + "(" * (MOST_PARENTHESES + 1), "parentheses"),
        ("FW ( ( SPEAK " + "(" * (MOST_PARENTHESES + 1), "parentheses"),
        (REPEAT * MOST_BLOCKS + END + " " + REPEAT * 2 + END * 201, "blocks"),
        ("SPEAK " + "(" * MOST_PARENTHESES + "1) + ((", "parentheses"),
    ],
    ids=lambda source: f"{source[:20]!r}",
)
def test_what_ended_before_does_not_count(source: str, code: str) -> None:
    """The mistake is at the last opening word or sign of the text, as it is the first one too many."""
    (too_deep,) = [each for each in parse(source).diagnostics if each.kind is MistakeKind.TOO_DEEP]

    assert too_deep.code == code
    assert too_deep.span.start == source.rindex("(" if code == "parentheses" else REPEAT)


@pytest.mark.parametrize(
    "source",
    [
        "FW 1\n" * 20_000,
        "x = 1 + 2 * 3 " * 10_000,
        "JUMP\n" * 20_000,
        "$ " * 50_000,
        "END IF " * 20_000,
        '"' * 50_001,
        "VAR VAR " * 20_000,
        "IF " * 20_000,
        "x [ " * 20_000,
        "SPEAK " + "- " * 50_000 + "1 1",
        "IF 1 == 1 THEN\n" * 190 + "END FOR\n" * 20_000,
        "a" * 300_000,
        "“" * 50_001,
        "-- " * 100_000,
        "PARA FRENT " * 10_000,
        "REPEET 2 TIMES\n" * 10_000,
    ],
    ids=lambda source: f"{source[:8]!r}",
)
@pytest.mark.slow
def test_a_long_text_needs_memory_linear_in_its_length(source: str) -> None:
    tracemalloc.start()
    parsed = parse(source)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()

    assert (parsed.program is None) == bool(parsed.diagnostics)
    assert most < 2_000 * len(source)


@pytest.mark.parametrize(
    "source",
    [
        "SPEAK DISTANCE F " + "-- " * 1000 + "\nFW 1",
        "SPEAK POS x -" + "-" * 3000 + "\n",
        "HELP FW " + "\n-- a -- b" * 500 + "\nFW 1",
        "\u2018" * 50_000,
    ],
    ids=("comment of comments", "line of hyphens", "many comments", "opening quotation marks"),
)
def test_no_text_takes_many_times_as_long_as_another(source: str) -> None:
    """A hundredth of a second each; for the first ones all of them were tried in 2^1000 ways."""
    assert fuzz.failure_of(Kind(lambda _: source, lambda text: check_form(str(text)), 20.0), source) is None


def check_form(text: str) -> None:
    parsed = parse(text)
    assert (parsed.program is None) == bool(parsed.diagnostics)


def test_prompts_and_outlines_have_no_limit() -> None:
    assert block_depth(REPEAT * 5_000) == 5_000
    assert len(outline(nested(5_000))) == 5_000


def lines_run(text: str) -> int:
    """How many lines of Python reading a program takes."""
    count = 0

    def trace(frame: FrameType, event: str, argument: object) -> Any:
        nonlocal count
        count += event == "line"
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        parse(text)
    finally:
        sys.settrace(before)
    return count


def test_a_row_of_wrong_blocks_on_one_line_takes_as_much_as_it_is_long() -> None:
    piece = "#ENTÃOFOR VAR i = 0; i < 2; i = i + 1 DO"
    parse(piece)

    once, four_times = (lines_run(f"PARA TRÁS{piece * count}") for count in (50, 200))

    assert four_times < 6 * once
