"""An END that is missing, alone, misspelt or of another block: what is told, and what is offered for it."""

import pytest

from language.diagnostics import Kind
from language.parser import parse
from tests.unit.language_front.test_mistakes import the_mistake


@pytest.mark.parametrize(
    ("source", "meant", "replaced"),
    [
        ("REPEAT 2 TIMES\nFW 1\nEND", "END REPEAT", "END"),
        ("REPEAT 2 TIMES\nFW 1\nEND\nFW 2", "END REPEAT", "END"),
        ("REPITA 2 VEZES\nPF 1\nFIM LAÇO", "FIM REPITA", "FIM LAÇO"),
        ("PROCEDIMIENTO P HACER\nAV 1\nFIN APRENDIZAJE\nP []", "FIN PROCEDIMIENTO", "FIN APRENDIZAJE"),
        ("REPEAT 2 TIMES\nFW 1\nEND FW 2", "END REPEAT", "END"),
        ("REPEAT 2 TIMES\nFW 1\nENDD REPEAT\nFW 2", "END REPEAT", "ENDD REPEAT"),
        ("REPITA 2 VEZES\nPF 1\nFI REPITA", "FIM REPITA", "FI REPITA"),
        ("SI 1 == 1 ENTONCES\nAV 1\nFINN SI", "FIN SI", "FINN SI"),
    ],
)
def test_an_end_without_its_word_means_that_of_the_block_that_is_open(
    source: str, meant: str, replaced: str
) -> None:
    mistake = the_mistake(source)
    end = mistake.span.end if mistake.meant_end is None else mistake.meant_end

    assert (mistake.meant, source[mistake.span.start : end]) == (meant, replaced)


@pytest.mark.parametrize(
    ("source", "meant"),
    [
        ("REPEAT 2 TIMES\nFW 1\nEND\nREPEAT 3 TIMES\nFW 1\nEND REPEAT", "END REPEAT"),
        ("IF 1 < 2 THEN\nFW 1\nEND -- of it\n\n  IF DISTANCE F > 1 THEN FW 1 END IF", "END IF"),
        ("SE 1 < 2 ENTÃO\nPF 1\nFIM\nSE 1 < 2 ENTAO\nPF 1\nFIM SE", "FIM SE"),
        ("SI 1 < 2 ENTONCES\nAV 1\nFIN\nIF 1 < 2 THEN\nAV 1\nFIN SI", "FIN SI"),
    ],
)
def test_an_end_alone_is_not_the_end_of_the_block_that_begins_on_the_next_line(
    source: str, meant: str
) -> None:
    """The second word of an END may stand on the next line, but not with the head of a block behind it."""
    mistake = the_mistake(source)

    assert (mistake.kind, mistake.span.line, mistake.found) == (Kind.WRONG_END, 3, meant.split()[0])
    assert mistake.meant == meant


def test_what_cannot_be_read_behind_an_end_alone_is_told_where_it_is() -> None:
    mistakes = parse("REPEAT 2 TIMES\nEND\nREPEAT 3 TIMES\nFW $\nEND REPEAT\nFW 2\nJUMP").diagnostics

    assert [(each.kind, each.span.line) for each in mistakes] == [
        (Kind.WRONG_END, 2),
        (Kind.UNKNOWN_CHARACTER, 4),
        (Kind.UNKNOWN_COMMAND, 7),
    ]


def test_a_word_before_a_loop_that_begins_is_no_end() -> None:
    mistakes = parse("REPEAT 2 TIMES\nEN REPEAT 3 TIMES\nFW 1\nEND REPEAT\nEND REPEAT").diagnostics

    assert [(each.kind, each.found) for each in mistakes] == [(Kind.UNKNOWN_COMMAND, "EN")]


def test_a_missing_end_tells_which_block_and_which_line() -> None:
    mistake = the_mistake("FW 1\nrepita 2 vezes\nFW 1")
    assert dict(mistake.details) == {"opener": "REPEAT", "opener_line": 2}


def test_a_wrong_end_tells_what_is_open() -> None:
    mistake = the_mistake("IF 1 == 1 THEN\nREPEAT 2 TIMES\nFW 1\nEND IF")
    assert dict(mistake.details) == {"opener": "REPEAT", "opener_line": 2}
