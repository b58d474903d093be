"""The conformance corpus, as far as form goes: what is wrong is told there, what is right is read."""

import re
from pathlib import Path

import pytest

from language.diagnostics import Kind
from language.formatter import format_source
from language.parser import parse

FORM = {
    each.value
    for each in (
        Kind.SYNTAX,
        Kind.UNKNOWN_COMMAND,
        Kind.UNKNOWN_CHARACTER,
        Kind.UNTERMINATED_STRING,
        Kind.INVALID_NAME,
        Kind.RESERVED_WORD,
        Kind.BAD_ARGUMENT,
        Kind.MISSING_END,
        Kind.WRONG_END,
    )
}
ERROR = re.compile(r"^error: (\S+)(?: line (\d+))?(?: column (\d+))?", re.M)
SEEN = frozenset({"red", "green", "blue"})


def expected_mistake(program: Path) -> tuple[str | None, ...] | None:
    found = ERROR.search(program.with_suffix(".expected").read_text(encoding="utf-8"))
    return found.groups() if found and found[1] in FORM else None


def test_every_program_has_the_mistake_of_form_that_it_must_have(shared: Path) -> None:
    programs = sorted((shared / "corpus").glob("*.gd"))
    assert len(programs) > 200
    for program in programs:
        parsed = parse(program.read_bytes().decode("utf-8"), colours=SEEN)
        told = [(each.kind.value, str(each.span.line), str(each.span.column)) for each in parsed.diagnostics]
        wanted = expected_mistake(program)
        if wanted is None:
            assert (parsed.program is not None, told) == (True, []), program.name
        else:
            assert len(told) == 1, program.name
            assert all(want in (None, got) for want, got in zip(wanted, told[0], strict=True)), program.name


@pytest.mark.parametrize("language", [None, "en", "pt", "es"])
def test_every_program_is_formatted_to_one_that_is_formatted_already(
    shared: Path, language: str | None
) -> None:
    for program in sorted((shared / "corpus").glob("*.gd")):
        source = program.read_bytes().decode("utf-8")
        if expected_mistake(program) is None:
            text = format_source(source, language)
            assert format_source(text, language) == text, program.name
