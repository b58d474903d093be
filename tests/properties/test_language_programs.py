"""Properties of every program that is right in form."""

from __future__ import annotations

import re
import unicodedata
from itertools import pairwise
from pathlib import Path
from random import Random
from typing import Any

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from language.formatter import formatted
from language.keywords import spelling
from language.lexer import lex
from language.locales import languages
from language.outline import block_depth, outline
from language.parser import parse
from language.source import fold_name
from language.syntax import Block, HelpCommand, Program, Span, Statement, TextLiteral, walk
from tests.effort import examples
from tests.formatting import format_source
from tests.properties.programs import programs
from tests.properties.random_programs import ProgramWriter, mixed

HELP = {fold_name(spelling("HELP", each)) for each in languages()}

MANY = settings(max_examples=examples(60))


def without_places(node: Any) -> Any:
    """A tree as tuples, without spans, and without the words of HELP, which a translation changes."""
    if isinstance(node, HelpCommand):
        return ("Help", node.topic is None)
    if isinstance(node, msgspec.Struct):
        parts = [getattr(node, name) for name in node.__struct_fields__ if name != "span"]
        return (type(node).__name__, *map(without_places, parts))
    return tuple(map(without_places, node)) if isinstance(node, tuple) else node


def read(source: str) -> Program:
    parsed = parse(source)
    assert parsed.diagnostics == ()
    assert parsed.program is not None
    return parsed.program


def spans_in(node: Any) -> list[Span]:
    if isinstance(node, Span):
        return [node]
    if isinstance(node, msgspec.Struct):
        return [span for name in node.__struct_fields__ for span in spans_in(getattr(node, name))]
    return [span for each in node for span in spans_in(each)] if isinstance(node, tuple) else []


@MANY
@given(programs())
def test_the_canonical_text_means_the_same(source: str) -> None:
    assert without_places(read(format_source(source)).body) == without_places(read(source).body)


@MANY
@given(programs(), st.sampled_from(languages()))
def test_a_translation_means_the_same(source: str, language: str) -> None:
    assert without_places(read(format_source(source, language)).body) == without_places(read(source).body)


@MANY
@given(programs(), st.sampled_from((None, *languages())))
def test_formatting_twice_changes_nothing_the_second_time(source: str, language: str | None) -> None:
    once = format_source(source, language)

    assert format_source(once, language) == once
    assert format_source(once) == once


@MANY
@given(st.integers(0, 2**32), st.sampled_from((None, *languages())))
def test_a_program_of_several_languages_is_formatted_once(seed: int, language: str | None) -> None:
    """Few words in each, so that no language has most of them, with and without their accents."""
    source = mixed(ProgramWriter(seed).program(), Random(seed))
    once = format_source(source, language)

    assert format_source(once, language) == once
    assert format_source(once) == once


def test_a_program_of_three_languages_is_formatted_once() -> None:
    """As many words of Portuguese as of Spanish: the accents that the formatter writes must not decide."""
    source = "CRIAR a = DISTANCIA F * DISTANCE F FW a AV a APRENDER p: a, b HACER end\tprocedure"
    once = format_source(source)

    assert format_source(once) == once


def test_every_program_of_the_corpus_is_formatted_once(shared: Path) -> None:
    for program in sorted((shared / "corpus").glob("*.gd")):
        for language in (None, *languages()):
            once = formatted(program.read_text(encoding="utf-8"), language).text
            assert once is None or formatted(once, language).text == once, program.name


@MANY
@given(programs(language="en"), st.sampled_from(("pt", "es")))
def test_a_translation_and_its_way_back_give_the_same_program(source: str, language: str) -> None:
    english = format_source(source, "en").replace("EXIT", "QUIT")

    assert format_source(format_source(english, language), "en") == english


@MANY
@given(programs())
def test_comments_stay_between_the_same_words(source: str) -> None:
    def comments(text: str) -> list[tuple[str, int]]:
        lexed = lex(text)
        words = [re.sub(r"^(--|[–—])\s*", "", text[each.start : each.end]).strip() for each in lexed.comments]
        kinds = [[token[0] for token in lexed.tokens[: each.before]] for each in lexed.comments]
        semicolon = lex(";").tokens[0][0]
        return list(zip(words, [len(each) - each.count(semicolon) for each in kinds], strict=True))

    before, after = comments(source), comments(format_source(source))
    assert [words for words, _ in after] == [words for words, _ in before]
    assert [index for _, index in after] == [index for _, index in before]


@MANY
@given(programs())
def test_canonical_lines_have_no_blank_at_their_end_and_no_two_are_empty_in_a_row(source: str) -> None:
    text = format_source(re.sub(r'"two\nlines"', '"two lines"', source))

    assert re.search(r"[ \t]$", text, re.MULTILINE) is None
    assert "\n\n\n" not in text
    assert not text.startswith("\n")


@MANY
@given(programs())
def test_every_span_lies_in_the_text_at_its_line_and_column(source: str) -> None:
    for span in spans_in(read(source).body):
        lines = re.split(r"\r\n|\r|\n", source[: span.start])
        seen = [each for each in lines[-1] if not unicodedata.combining(each)]
        assert 0 <= span.start < span.end <= len(source)
        assert (span.line, span.column) == (len(lines), len(seen) + 1)


@MANY
@given(programs())
def test_statements_stand_in_the_order_of_their_spans_and_inside_their_blocks(source: str) -> None:
    def holds(statements: tuple[Statement, ...], start: int, end: int) -> None:
        for statement in statements:
            assert start <= statement.span.start < statement.span.end <= end
            start = statement.span.end

    program = read(source)

    holds(program.body, 0, len(source))
    for statement in walk(program.body):
        for body in (getattr(statement, name, None) for name in ("body", "then", "otherwise")):
            holds(body or (), statement.span.start, statement.span.end)


@MANY
@given(programs())
def test_a_finished_program_has_no_open_block_and_an_outline_of_all_its_blocks(source: str) -> None:
    blocks = [each for each in walk(read(source).body) if isinstance(each, Block)]
    items = outline(source)

    assert block_depth(source) == 0
    assert [item.line for item in items] == [block.span.line for block in blocks]
    assert all(item.is_closed for item in items)


@MANY
@given(programs(), st.integers(1, 1000))
def test_the_first_line_shifts_every_line_and_nothing_else(source: str, first: int) -> None:
    shifted = parse(source, first_line=first).program
    assert shifted is not None

    expected = [
        msgspec.structs.replace(each, line=each.line + first - 1) for each in spans_in(read(source).body)
    ]
    assert spans_in(shifted.body) == expected


@MANY
@given(programs(), st.data())
def test_a_program_without_one_end_has_an_error_about_a_block(source: str, data: st.DataObject) -> None:
    tokens = lex(source).tokens
    ends = [
        token
        for before, token in pairwise(tokens)
        if token[5].startswith(("end ", "fim ", "fin ")) and before[5] not in HELP  # HELP END IF ends nothing
    ]
    ends = [token for token in ends if parse(source[: token[1]] + source[token[2] :]).program is None]
    if not ends:
        return
    token = data.draw(st.sampled_from(ends))

    kinds = [each.kind.value for each in parse(source[: token[1]] + " " + source[token[2] :]).diagnostics]

    assert {"missing-end", "wrong-end", "syntax"} >= set(kinds) > set()


@pytest.mark.parametrize("text", ['"a\r\nb"', '"a\rb"', '"a\nb"'])
def test_line_ends_in_a_string_are_the_same(text: str) -> None:
    said = read(f"SPEAK {text}").body[0]

    assert isinstance(said.what, TextLiteral)  # type: ignore[union-attr]
    assert said.what.text == "a\nb"  # type: ignore[union-attr]
