"""Any text gives a program or mistakes, and never an exception."""

from __future__ import annotations

import random
import unicodedata
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from language.checker import check
from language.diagnostics import MOST_MISTAKES, Diagnostic
from language.formatter import formatted
from language.keywords import ARGUMENTS, all_words
from language.outline import block_depth, outline
from language.parser import Parsed, parse
from tests.effort import examples

BATCHES = 10
IN_A_BATCH = examples(10_000)

SIGNS = "= == <> < > <= >= != => + - * / ( ) [ ] , : ; . $ # ' \" “ ” -- – _ 1 2.5 9x _x 12"
BLANKS = ("\n", "\n", "\r\n", "\t", "é", "e\u0301", "\ufeff", "\u200b")
WORDS = (
    *all_words(),
    *(unicodedata.normalize("NFD", word) for word in all_words() if not word.isascii()),
    *(each for row in ARGUMENTS for words in row.spellings.values() for each in words),
    *SIGNS.split(" "),
    *BLANKS,
    *(
        "END",
        "FIM",
        "RIGHT",
        "girar",
        "ENDIF",
        "FW3",
        "FORWRAD",
        "x",
        "n",
        "hello",
        '"text"',
        "purple",
        "maybe",
    ),
)
HEADS = (
    "IF 1 == 2 THEN",
    "REPEAT 2 TIMES",
    "WHILE a < 3 DO",
    "FOR VAR i = 0; i < 2; i = i + 1 DO",
    "PROCEDURE P: a DO",
)
LINES = (
    "FW 1",
    "SPEAK x",
    "ELSE",
    "END IF",
    "END REPEAT",
    "END WHILE",
    "END FOR",
    "FIM APRENDER",
    "P [1, 2]",
    "VAR a = 3",
)


FEW_WORDS = "VAR PROCEDURE FOR IF REPEAT DO THEN TIMES ELSE END FW SPEAK POS P x 1 = == : , ; [ ] ("


def soup(chance: random.Random) -> str:
    return " ".join(chance.choices(WORDS, k=chance.randrange(9)))


def soup_of_few(chance: random.Random) -> str:
    """Of words that open blocks, take values or end heads: every order of three comes often."""
    return " ".join(chance.choices([*FEW_WORDS.split(" "), "\n"], k=chance.randrange(9)))


def broken_program(chance: random.Random) -> str:
    """A program that is cut, doubled or swapped somewhere."""
    lines = [chance.choice(HEADS + LINES) for _ in range(chance.randrange(1, 6))]
    text = "\n".join(lines)
    start, end = sorted(chance.randrange(len(text) + 1) for _ in range(2))
    return chance.choice((text[:end], text[start:], text[:start] + text[end:], text[:end] + text[start:]))


def any_bytes(chance: random.Random) -> str:
    return chance.randbytes(chance.randrange(24)).decode(
        chance.choice(("utf-8", "latin-1", "utf-16")), "replace"
    )


def hold(text: str, parsed: Parsed) -> None:
    """What is true of every result."""
    assert (parsed.program is None) == bool(parsed.diagnostics), text
    assert len(parsed.diagnostics) <= MOST_MISTAKES, text
    last = 0
    for each in parsed.diagnostics:
        assert last <= each.span.start <= each.span.end <= len(text), text
        assert each.span.line >= 1 and each.span.column >= 1, text
        last = each.span.start


@pytest.mark.hypothesis  # random, though seeded: the slow check tries more
@pytest.mark.parametrize("batch", range(BATCHES))
@pytest.mark.parametrize(
    ("make", "share"), [(soup, 0.2), (soup_of_few, 0.2), (broken_program, 0.4), (any_bytes, 0.2)]
)
def test_no_garbage_raises(make: Callable[[random.Random], str], share: float, batch: int) -> None:
    chance = random.Random(batch)
    for _ in range(int(IN_A_BATCH * share)):
        text = make(chance)
        hold(text, parse(text))


@settings(max_examples=examples(300))
@given(st.text(max_size=60) | st.lists(st.sampled_from(WORDS), max_size=15).map(" ".join))
def test_every_function_on_texts_accepts_any_text(text: str) -> None:
    parsed = parse(text, colours=frozenset({"red"}))

    hold(text, parsed)
    assert (formatted(text).text is None) == (parse(text).program is None)
    assert 0 <= block_depth(text) <= sum(not each.is_closed for each in outline(text))
    if parsed.program is not None:
        check(parsed.program)


@settings(max_examples=examples(200))
@given(*[st.lists(st.sampled_from(WORDS), max_size=12).map(" ".join)] * 2)
def test_reading_does_not_depend_on_what_was_read_before(text: str, other: str) -> None:
    first = parse(text)
    parse(other, colours=frozenset({"red"}))
    assert parse(text) == first


def test_every_beginning_of_every_program_of_the_corpus_can_be_read(shared: Path) -> None:
    """An editor parses such texts while a learner types."""
    for program in sorted((shared / "corpus").glob("*.gd"))[::7]:
        text = program.read_text(encoding="utf-8")
        for end in range(0, min(len(text), 300), 3):
            hold(text[:end], parse(text[:end]))
            assert block_depth(text[:end]) >= 0


def test_a_program_without_its_last_line_never_has_a_mistake_in_its_first(shared: Path) -> None:
    """An unfinished text has its mistake at the open block, or at its end."""
    for program in sorted((shared / "corpus").glob("3[0-6]*.gd")):
        lines = program.read_text(encoding="utf-8").splitlines()
        found: tuple[Diagnostic, ...] = parse("\n".join(lines[:-1])).diagnostics
        assert {each.kind.value for each in found} <= {"missing-end", "syntax"}, program.name
