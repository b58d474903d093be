"""The form of the conformance corpus: wrong programs have their mistake, right ones a tree."""

import re
from pathlib import Path

import pytest

from language.diagnostics import MistakeKind
from language.parser import parse
from tests.formatting import format_source

FORM = {
    each.value
    for each in (
        MistakeKind.SYNTAX,
        MistakeKind.UNKNOWN_COMMAND,
        MistakeKind.UNKNOWN_CHARACTER,
        MistakeKind.UNTERMINATED_STRING,
        MistakeKind.INVALID_NAME,
        MistakeKind.RESERVED_WORD,
        MistakeKind.BAD_ARGUMENT,
        MistakeKind.MISSING_END,
        MistakeKind.WRONG_END,
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
        found = [(each.kind.value, str(each.span.line), str(each.span.column)) for each in parsed.diagnostics]
        wanted = expected_mistake(program)
        if wanted is None:
            assert (parsed.program is not None, found) == (True, []), program.name
        else:
            assert len(found) == 1, program.name
            assert all(want in (None, got) for want, got in zip(wanted, found[0], strict=True)), program.name


@pytest.mark.parametrize("language", [None, "en", "pt", "es"])
def test_a_formatted_program_does_not_change_when_it_is_formatted_again(
    shared: Path, language: str | None
) -> None:
    for program in sorted((shared / "corpus").glob("*.gd")):
        source = program.read_bytes().decode("utf-8")
        if expected_mistake(program) is None:
            text = format_source(source, language)
            assert format_source(text, language) == text, program.name
