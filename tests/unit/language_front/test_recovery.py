"""Independent mistakes are all told, in the order of the text; what follows from one is not."""

import pytest

from language.diagnostics import MOST_MISTAKES
from language.parser import parse


def told(source: str) -> list[tuple[str, int]]:
    return [(each.kind.value, each.span.line) for each in parse(source).diagnostics]


WRONG_LINES = {
    'FW "five"': "syntax",
    "JUMP 3": "unknown-command",
    "FW 2.5": "unknown-character",
    "VAR if = 2": "reserved-word",
    "VAR 9x = 2": "invalid-name",
    "SPEAK COLOR purple": "bad-argument",
    "SPEAK (1 + 2 FW 3": "syntax",
    "P [1, 2 FW 3": "syntax",
    "FW 1 10": "syntax",
    "IF a = 1 THEN FW 1 END IF": "syntax",
    "REPEAT 2 FW 1 END REPEAT": "syntax",
    "REPEET 2 TIMES FW 1 END REPEAT": "unknown-command",
    "LOOP 2 TIMES FW 1 END LOOP": "unknown-command",
    "FOR VAR i = 0, i < 2, i = i + 1 DO FW i END FOR": "syntax",
    "PROCEDURE P a DO FW a END PROCEDURE": "syntax",
    "WHILE 1 < 2 DO FW 1 END FOR": "wrong-end",
    "END IF": "wrong-end",
    "ELSE": "syntax",
    "SPEAK 'hello'": "unknown-character",
    "SOUND loud": "bad-argument",
    "VAR a = STATE": "syntax",
    "RIGHT 90": "unknown-command",
}


@pytest.mark.parametrize("first", WRONG_LINES)
def test_two_wrong_lines_are_two_mistakes(first: str) -> None:
    for second, kind in WRONG_LINES.items():
        source = f"FW 1\n{first}\nSPEAK 1\n{second}\nFW 2"
        assert told(source) == [(WRONG_LINES[first], 2), (kind, 4)], second


@pytest.mark.parametrize("line", WRONG_LINES)
def test_two_wrong_lines_one_behind_the_other_are_two_mistakes(line: str) -> None:
    assert told(f"{line}\nJUMP 3") == [(WRONG_LINES[line], 1), ("unknown-command", 2)]


@pytest.mark.parametrize("line", [line for line in WRONG_LINES if line not in ("END IF", "ELSE")])
@pytest.mark.parametrize(
    ("head", "end"),
    [
        ("REPEAT 2 TIMES", "END REPEAT"),
        ("IF 1 == 1 THEN FW 1 ELSE", "END IF"),
        ("PROCEDURE Q: a DO", "FIM APRENDER"),
        ("FOR VAR i = 0; i < 2; i = i + 1 DO REPEAT 2 TIMES", "END REPEAT END FOR"),
    ],
)
def test_a_wrong_line_in_a_block_leaves_the_block_whole(line: str, head: str, end: str) -> None:
    assert told(f"{head}\n{line}\n{end}\nFW 1") == [(WRONG_LINES[line], 2)]


@pytest.mark.parametrize(
    "head",
    [
        "IF a = 1 THEN",
        "IF a == THEN",
        "IF a == 1",
        "IF a == 1 DO",
        "IF a == 1 AND b == 2 THEN",
        "IF 1 != 2 THEN",
        "IF SPEAK > 2 THEN",
        "IF COLOR purple > 1 THEN",
        "IF (a == 1) THEN",
        "IFF a == 1 THEN",
        "IF a == 1 THN",
    ],
)
def test_a_mistake_in_a_head_still_opens_the_block(head: str) -> None:
    assert [line for _, line in told(f"{head}\nFW 1\nELSE\nFW 2\nEND IF\nFW 3")] in ([1], [2])


@pytest.mark.parametrize(
    "typed", ["END IF", "END FOR", "END", "END LOOP", "ENDREPEAT", "END REPEET", "FIM REPETIR"]
)
def test_a_wrong_end_still_closes_the_block(typed: str) -> None:
    source = f"REPEAT 2 TIMES\nFW 1\n{typed}\nFW 2\nJUMP"
    assert [line for _, line in told(source)] == [3, 5]


def test_a_missing_inner_end_is_told_once_at_the_end_that_does_not_fit() -> None:
    source = "REPEAT 2 TIMES\nIF 1 == 1 THEN\nFW 1\nEND REPEAT\nFW 2"
    assert told(source) == [("wrong-end", 4)]


def test_exchanged_ends_are_one_mistake() -> None:
    source = "REPEAT 2 TIMES\nIF 1 == 1 THEN\nWHILE 1 < 2 DO\nEND IF\nEND WHILE\nEND REPEAT"
    assert told(source) == [("wrong-end", 4)]


def test_a_block_without_end_before_else_is_told_at_else_only() -> None:
    source = "IF 1 == 1 THEN\nREPEAT 2 TIMES\nFW 1\nELSE\nFW 2\nEND IF"
    assert told(source) == [("syntax", 4)]


def test_every_open_block_is_told_outermost_first() -> None:
    source = "IF 1 == 1 THEN\nREPEAT 2 TIMES\nFW 1"
    assert told(source) == [("missing-end", 1), ("missing-end", 2)]


def test_an_unfinished_head_has_no_missing_end_besides() -> None:
    assert told("FW 1\nIF 1 ==") == [("syntax", 2)]


def test_what_cannot_be_read_is_told_once_whatever_it_stands_in() -> None:
    assert told("VAR a$b = 3 % 2\nIF a & b THEN\nFW 1\nEND IF") == [
        ("unknown-character", 1),
        ("unknown-character", 1),
        ("unknown-character", 2),
    ]


def test_not_more_mistakes_are_told_than_anybody_listens_to() -> None:
    assert len(told("JUMP\n" * 1000)) == MOST_MISTAKES


def test_colours_that_the_robot_cannot_see_are_told_among_the_others_in_order() -> None:
    parsed = parse("JUMP\nSPEAK COLOR pink\nFW 1 10", colours=frozenset({"red"}))
    assert [each.span.line for each in parsed.diagnostics] == [1, 2, 3]
