"""All independent mistakes are reported, in the order of the text, and none of their consequences."""

import pytest

from language.diagnostics import Diagnostic, MistakeKind
from language.parser import parse
from tests.unit.language_front.test_mistakes import the_mistake


def mistakes_in(source: str) -> list[tuple[str, int]]:
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
    "TURN LEFT": "unknown-command",
    "WALK 3": "unknown-command",
    "FW 3 steps": "unknown-command",
    "PARA FRENT 5": "unknown-command",
    "SPEAK hello world": "unknown-command",
    'SPEAK "a" x': "unknown-command",
    "SPEAK DISTANSIA F": "unknown-command",
    "VAR a = RANDOM 5": "unknown-command",
    "P (1, 2)": "unknown-command",
    "FW = 3": "syntax",
    "x == 3": "syntax",
    "i++": "syntax",
    "i += 2": "syntax",
    "REPEAT TIMES FW 1 END REPEAT": "syntax",
    "IF 1 < 2 AND 2 < 3 THEN FW 1 END IF": "syntax",
    "IF 1 => 2 THEN FW 1 END IF": "syntax",
}
ONE_OF_EACH_KIND = {kind: line for line, kind in WRONG_LINES.items()}
NEXT_WRONG_LINES = {
    "JUMP 3": "unknown-command",
    "RIGHT 90": "unknown-command",
    "j = DISTANCE Z": "bad-argument",
    "DISTANCE Z": "bad-argument",
    "P [1 2]": "syntax",
    "VAR if = 2": "reserved-word",
    "REPEAT 2 FW 1 END REPEAT": "syntax",
    "; JUMP": "unknown-command",
    "x == 3": "syntax",
    "i++": "syntax",
    "FW = 3": "syntax",
    "WALK 3": "unknown-command",
    "P (1)": "unknown-command",
    "ELSE": "syntax",
    "END IF": "wrong-end",
}
"""They begin in all ways in which a command or an end can."""


@pytest.mark.parametrize("first", WRONG_LINES)
def test_two_wrong_lines_are_two_mistakes(first: str) -> None:
    for kind, second in ONE_OF_EACH_KIND.items():
        source = f"FW 1\n{first}\nSPEAK 1\n{second}\nFW 2"
        assert mistakes_in(source) == [(WRONG_LINES[first], 2), (kind, 4)], second


@pytest.mark.parametrize("line", WRONG_LINES)
def test_two_wrong_lines_one_after_the_other_are_two_mistakes(line: str) -> None:
    for following, kind in NEXT_WRONG_LINES.items():
        assert mistakes_in(f"{line}\n{following}") == [(WRONG_LINES[line], 1), (kind, 2)], following


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
    assert mistakes_in(f"{head}\n{line}\n{end}\nFW 1") == [(WRONG_LINES[line], 2)]


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
    assert [line for _, line in mistakes_in(f"{head}\nFW 1\nELSE\nFW 2\nEND IF\nFW 3")] in ([1], [2])


@pytest.mark.parametrize(
    "typed", ["END IF", "END FOR", "END", "END LOOP", "ENDREPEAT", "END REPEET", "FIM REPETIR"]
)
def test_a_wrong_end_still_closes_the_block(typed: str) -> None:
    source = f"REPEAT 2 TIMES\nFW 1\n{typed}\nFW 2\nJUMP"
    assert [line for _, line in mistakes_in(source)] == [3, 5]


def test_a_command_in_the_place_of_a_value_is_read() -> None:
    assert mistakes_in("FW TR DISTANCE Z") == [("syntax", 1), ("bad-argument", 1)]


def test_a_loop_over_a_name_that_is_like_a_command_is_none_of_the_mistakes() -> None:
    """PARA begins FOR, and PARA FRENTE walks."""
    source = "JUMP\nPARA frent = 0; frent < 2; frent = frent + 1 FAÇA\nPF 1\nFIM PARA"
    assert mistakes_in(source) == [("unknown-command", 1)]


def test_a_missing_inner_end_is_reported_once_at_the_end_that_does_not_fit() -> None:
    source = "REPEAT 2 TIMES\nIF 1 == 1 THEN\nFW 1\nEND REPEAT\nFW 2"
    assert mistakes_in(source) == [("wrong-end", 4)]


@pytest.mark.parametrize("word", ["EN 3", "FOO 3", "EN IF"])
def test_a_word_like_end_is_none_before_anything_but_the_word_of_its_block(word: str) -> None:
    first, *_ = parse(f"REPEAT 2 TIMES\n{word}\nEND REPEAT").diagnostics
    assert (first.kind, first.found) == (MistakeKind.UNKNOWN_COMMAND, word.split()[0])


def test_a_word_that_is_not_like_end_is_none() -> None:
    found = parse("REPEAT 2 TIMES\nFOO REPEAT\nEND REPEAT").diagnostics
    assert (MistakeKind.UNKNOWN_COMMAND, "FOO") in [(each.kind, each.found) for each in found]


def test_an_else_does_not_belong_to_a_block_whose_end_was_exchanged() -> None:
    source = "IF 1 == 1 THEN\nREPEAT 2 TIMES\nEND IF\nELSE\nEND REPEAT"
    assert mistakes_in(source) == [("wrong-end", 3), ("syntax", 4)]


def test_the_line_after_an_end_alone_is_read() -> None:
    assert mistakes_in("REPEAT 2 TIMES\nFW 1\nEND\n) FW 2") == [("wrong-end", 3), ("syntax", 4)]


def test_a_wrong_end_before_the_right_one_closes_nothing() -> None:
    source = "REPEAT 2 TIMES\nEND IF\nFW 1\nEND REPEAT\nJUMP"
    assert mistakes_in(source) == [("wrong-end", 2), ("unknown-command", 5)]


def test_a_second_else_in_a_block_of_the_first_is_one_mistake() -> None:
    source = "IF 1 == 1 THEN\nFW 1\nELSE\nREPEAT 2 TIMES\nFW 1\nELSE\nFW 2\nEND IF\nJUMP"
    assert mistakes_in(source) == [("syntax", 6), ("unknown-command", 9)]


def test_a_block_of_an_unknown_word_has_no_missing_end_as_well() -> None:
    assert mistakes_in("LOOP 3 TIMES\nFW 1\nREPEAT 2 TIMES") == [("unknown-command", 1), ("missing-end", 3)]


def test_texts_over_several_lines_are_no_forgotten_quotation_marks() -> None:
    source = 'SPEAK "a\nb"\nJUMP\nJUMP\nJUMP\nJUMP\nSPEAK "c\nd"'
    assert mistakes_in(source) == [("unknown-command", line) for line in (3, 4, 5, 6)]


def test_a_mistake_after_a_forgotten_curved_quotation_mark_is_found() -> None:
    assert mistakes_in("SPEAK “hello\nJUMP") == [("unterminated-string", 1), ("unknown-command", 2)]


def test_exchanged_ends_are_one_mistake() -> None:
    source = "REPEAT 2 TIMES\nIF 1 == 1 THEN\nWHILE 1 < 2 DO\nEND IF\nEND WHILE\nEND REPEAT"
    assert mistakes_in(source) == [("wrong-end", 4)]


def test_a_block_without_end_before_else_is_reported_at_else_only() -> None:
    source = "IF 1 == 1 THEN\nREPEAT 2 TIMES\nFW 1\nELSE\nFW 2\nEND IF"
    assert mistakes_in(source) == [("syntax", 4)]


def test_an_else_in_a_block_with_its_end_closes_nothing() -> None:
    source = "IF 1 == 1 THEN\nREPEAT 2 TIMES\nELSE\nFW 1\nEND REPEAT\nEND IF\nJUMP"
    assert mistakes_in(source) == [("syntax", 3), ("unknown-command", 7)]


def test_every_open_block_is_reported_outermost_first() -> None:
    source = "IF 1 == 1 THEN\nREPEAT 2 TIMES\nFW 1"
    assert mistakes_in(source) == [("missing-end", 1), ("missing-end", 2)]


def test_an_unfinished_head_has_no_missing_end_as_well() -> None:
    assert mistakes_in("FW 1\nIF 1 ==") == [("syntax", 2)]


def test_an_unreadable_character_is_reported_once_in_any_command() -> None:
    assert mistakes_in("VAR a$b = 3 % 2\nIF a & b THEN\nFW 1\nEND IF") == [
        ("unknown-character", 1),
        ("unknown-character", 1),
        ("unknown-character", 2),
    ]


def test_the_number_of_reported_mistakes_is_limited() -> None:
    assert mistakes_in("JUMP\n" * 101) == [("unknown-command", line) for line in range(1, 101)]


def test_colours_that_the_robot_cannot_see_are_reported_in_order() -> None:
    parsed = parse("JUMP\nSPEAK COLOR pink\nFW 1 10", colours=frozenset({"red"}))
    assert [each.span.line for each in parsed.diagnostics] == [1, 2, 3]


@pytest.mark.parametrize(
    ("source", "meant", "replaced"),
    [
        ("REPEAT 2 TIMES\nFW 1\nEND", "END REPEAT", "END"),
        ("REPEAT 2 TIMES\nFW 1\nEND\nFW 2", "END REPEAT", "END"),
        ("REPITA 2 VEZES\nPF 1\nFIM LAÇO", "FIM REPITA", "FIM LAÇO"),
        ("PROCEDIMIENTO P HACER\nAV 1\nFIN APRENDIZAJE\nP []", "FIN PROCEDIMIENTO", "FIN APRENDIZAJE"),
        ("REPEAT 2 TIMES\nFW 1\nEND FW 2", "END REPEAT", "END"),
        ("REPEAT 2 TIMES\nFW 1\nEND x = 3", "END REPEAT", "END"),
        ("REPEAT 2 TIMES\nFW 1\nEND x y", "END REPEAT", "END"),
        ("REPEAT 2 TIMES\nFW 1\nEND 5", "END REPEAT", "END"),
        ("REPEAT 2 TIMES\nFW 1\nEND\nP [1]", "END REPEAT", "END"),
        ("REPEAT 2 TIMES\nFW 1\nENDD REPEAT\nFW 2", "END REPEAT", "ENDD REPEAT"),
        ("REPITA 2 VEZES\nPF 1\nFI REPITA", "FIM REPITA", "FI REPITA"),
        ("SI 1 == 1 ENTONCES\nAV 1\nFINN SI", "FIN SI", "FINN SI"),
    ],
)
def test_an_end_without_its_word_means_the_end_of_the_open_block(
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
    """The second word of an END may be on the next line, unless the head of a block follows it."""
    mistake = the_mistake(source)

    assert (mistake.kind, mistake.span.line, mistake.found) == (MistakeKind.WRONG_END, 3, meant.split()[0])
    assert mistake.meant == meant


def test_an_unreadable_character_after_an_end_alone_has_its_own_place() -> None:
    mistakes = parse("REPEAT 2 TIMES\nEND\nREPEAT 3 TIMES\nFW $\nEND REPEAT\nFW 2\nJUMP").diagnostics

    assert [(each.kind, each.span.line) for each in mistakes] == [
        (MistakeKind.WRONG_END, 2),
        (MistakeKind.UNKNOWN_CHARACTER, 4),
        (MistakeKind.UNKNOWN_COMMAND, 7),
    ]


def test_a_word_before_the_head_of_a_loop_is_no_end() -> None:
    mistakes = parse("REPEAT 2 TIMES\nEN REPEAT 3 TIMES\nFW 1\nEND REPEAT\nEND REPEAT").diagnostics

    assert [(each.kind, each.found) for each in mistakes] == [(MistakeKind.UNKNOWN_COMMAND, "EN")]


def test_a_missing_end_names_the_block_and_its_line() -> None:
    mistake = the_mistake("FW 1\nrepita 2 vezes\nFW 1")
    assert dict(mistake.details) == {"opener": "REPEAT", "opener_line": 2}


def test_a_wrong_end_names_the_open_block() -> None:
    mistake = the_mistake("IF 1 == 1 THEN\nREPEAT 2 TIMES\nFW 1\nEND IF")
    assert dict(mistake.details) == {"opener": "REPEAT", "opener_line": 2}


TEXTS = [
    ("END", ["1:1 wrong-end stray-end"]),
    ("END FOO\nFW 1", ["1:1 wrong-end stray-end"]),
    ("IF1 == 1 END FOR", ["1:5 syntax two-equals -> =", "1:10 wrong-end stray-end"]),
    (
        "IF 1 < 2 THEN\nFW 1\nELSE IF 2 < 3 THEN\nFW 2\nELSE\nFW 3",
        ["1:1 missing-end else-if", "3:6 missing-end"],
    ),
    ("REPEAT 2 $ FW 1 ELSE FW 2 END REPEAT", ["1:10 unknown-character", "1:17 syntax stray-else"]),
    (
        "IF 1 == 1 THEN\nREPEAT 2 TIMES\nFW 1\nELSE\nFW 2\nELSE\nFW 3\nEND IF",
        ["4:1 syntax stray-else", "6:1 syntax stray-else"],
    ),
    ("IF 1 == 1 THEN\nREPEAT 2 TIMES\nELSE\nFW 1\nEND REPEAT", ["1:1 missing-end", "3:1 syntax stray-else"]),
    (
        "REPEAT 2 TIMES\nIF 1 == 1 THEN\nREPEAT 2 TIMES\nFW 1\nELSE\nFW 2\nEND IF\nEND REPEAT",
        ["5:1 syntax stray-else"],
    ),
    ("REPEET 2 TIMES FW 1\nIF 1 < 2 THEN FW 1 END IF", ["1:1 unknown-command -> REPEAT"]),
    ("REPEET 2 TIMES FW 1\nIF 1 < 2 THEN FW 1 END IF END REPEAT", ["1:1 unknown-command -> REPEAT"]),
    ("AB > 2", ["1:1 unknown-command"]),
    ("x <> 3", ["1:1 unknown-command"]),
    ("JUMP (3)", ["1:1 unknown-command call-brackets"]),
    ("FWD (3)", ["1:1 unknown-command -> FW"]),
    ("REPEET 2 TIMES\nREPEAT 2 TIMES\nFW 1\nEND REPEAT", ["1:1 unknown-command -> REPEAT"]),
    ("FW1\nTURN", ["1:1 unknown-command -> FW 1", "2:1 unknown-command everyday -> TR 90"]),
    ("IFF a == 1 THEN", ["1:1 unknown-command -> IF"]),
    ("FW SCAN 1 10", ["1:4 syntax"]),
    ("FW TR 1 2", ["1:1 syntax missing-argument -> FW 2", "1:9 syntax"]),
    ('FW 3 +\nTR "a"', ["1:6 syntax missing-value", "2:4 syntax"]),
    ("x = 1 * FW 2 3", ["1:9 syntax"]),
    ("FW 1 ) THEN 2", ["1:6 syntax"]),
    ("FW 1\nUNLESS VAR x = 1 THEN\nFW 1\nEND IF", ["2:1 unknown-command"]),
    ("x IF 1 < 2 THEN FW 1", ["1:1 unknown-command", "1:3 missing-end"]),
    ("UNLESS x\ny = 1\nz = 2 THEN", ["1:1 unknown-command", "3:7 syntax"]),
    ("FW $ 1 JUMP", ["1:4 unknown-character", "1:8 unknown-command"]),
    ("FW $ 1\nJUMP", ["1:4 unknown-character", "2:1 unknown-command"]),
    ('SPEAK "a\nb" x', ["2:4 unknown-command"]),
    ('SPEAK "a" x', ["1:11 unknown-command -> SPEAK x"]),
    ("a == (", ["1:3 syntax two-equals -> ="]),
    ("a == 3 JUMP", ["1:3 syntax two-equals -> =", "1:8 unknown-command"]),
    ("FW 1\nGIRRA DERECHA 90", ["2:1 unknown-command -> GIRAR DERECHA"]),
    ("REPEET 2", ["1:1 unknown-command -> REPEAT"]),
    ("FOR", ["1:1 syntax missing-argument"]),
    ("FOR x", ["1:6 syntax"]),
    ("PARA frente", ["1:1 syntax missing-argument -> PARA frente 2"]),
    ("DISTANCE RIGHT", ["1:10 bad-argument"]),
    ("POS RIGHT 3", ["1:5 bad-argument", "1:11 syntax"]),
    ("DISTANCE RIGHT = 3", ["1:10 bad-argument", "1:16 syntax"]),
    ('"hello', ["1:1 unterminated-string"]),
    ("P [1,]", ["1:6 syntax"]),
    ("FW 2 ,5", ["1:6 syntax"]),
    ("FW 2, 5", ["1:5 syntax"]),
    ("FW 2,x", ["1:5 syntax"]),
    ("FW x,5", ["1:5 syntax"]),
    ("PROCEDURE Q: a", ["1:15 syntax"]),
    ("PROCEDURE P: a, b c DO END PROCEDURE\nP 1", ["1:19 syntax", "2:1 unknown-command procedure"]),
    ("PROCEDURE P: a, 3 DO END PROCEDURE\nP 1", ["1:17 syntax", "2:1 unknown-command procedure -> P [1]"]),
    ("PROCEDURE P:\nDO END PROCEDURE\nP 1", ["2:1 syntax no-colon", "3:1 unknown-command procedure"]),
    ('SPEAK 1 "a -- b"', ["1:9 syntax"]),
    ("SCAN = 3", ["1:6 syntax assigned-keyword"]),
    ("<> = 3", ["1:1 syntax"]),
    ("- 3", ["1:1 syntax"]),
    ('SPEAK "a" )', ["1:11 syntax"]),
    ("FW FOR 3", ["1:1 syntax missing-argument -> FW 2", "1:4 missing-end", "1:8 syntax"]),
    ("FOR 3 DO FW 1 END FOR", ["1:5 syntax"]),
    ("WHILE 1 < 2 FW 1 END WHILE DO", ["1:13 syntax head-end -> DO", "1:28 syntax"]),
    ("IF 1 2 THEN FW 1 END IF", ["1:6 syntax"]),
    ("PARA\nFRENT 5", ["1:1 missing-end", "2:1 unknown-command value"]),
    ("GIRAR\nDIRETA 90", ["1:1 unknown-command everyday -> GD 90", "2:1 unknown-command"]),
    ("GIRAR 3 90", ["1:1 unknown-command everyday -> GD"]),
    (
        "REPEAT 2 TIMES\nEND\nREPEET END IF",
        [
            "2:1 wrong-end -> END REPEAT",
            "3:1 unknown-command -> REPEAT",
            "3:8 wrong-end other-end -> END REPEAT",
        ],
    ),
    ("IF 1 < 2 THEN\nFW 1\nELSE\nIF 2 < 3 THEN\nFW 2\nEND IF", ["1:1 missing-end"]),
    ("IF 1 < 2 THEN\nSPEAK 1 IF 2 < 3 THEN\nEND IF", ["1:1 missing-end"]),
    ("IF 1 < 2 THEN\nELSE REPEAT 2 TIMES\nEND REPEAT", ["1:1 missing-end"]),
    ("se 3 > 2 então\nsenão repita 2 vezes", ["1:1 missing-end", "2:7 missing-end"]),
    ("IF 1 < 2 THEN FW 1 ELSE IF 2 < 3 THEN FW 2 END IF", ["1:1 missing-end else-if"]),
    ("IF 1 2", ["1:1 missing-end", "1:6 syntax"]),
    ("IF 1 < 2 3 4", ["1:1 missing-end", "1:10 syntax"]),
    ("REPEAT 2 3 4", ["1:1 missing-end", "1:10 syntax"]),
    ("WHILE 1 < 2\n3 4 x", ["1:1 missing-end", "2:1 syntax"]),
    ("IF 1 < 2 3 4\nEND IF", ["1:10 syntax"]),
    (
        "GIRRA DERECHA 90\nFW $ 1 2\nJUMP",
        ["1:1 unknown-command -> GIRAR DERECHA", "2:4 unknown-character", "3:1 unknown-command"],
    ),
    ("FW 3 FW $ 1 2 GIRRA DERECHA 90\nJUMP", ["1:9 unknown-character", "2:1 unknown-command"]),
    ("TURN\nFW $ 1 2", ["1:1 unknown-command everyday -> TR 90", "2:4 unknown-character"]),
    ("red", ["1:1 unknown-command -> RE"]),
    ("FWD", ["1:1 unknown-command -> FW"]),
    ("FWD -- c\nTR 90", ["1:1 unknown-command -> FW"]),
    ("a == 3 WALK 2", ["1:3 syntax two-equals -> =", "1:8 unknown-command everyday -> FW 2"]),
    ("PF 2\nBACK 3", ["2:1 unknown-command everyday -> PT 3"]),
    ("PF 2\nWALK 3 3", ["2:1 unknown-command everyday -> PF"]),
    ("rt SCAN", ["1:1 unknown-command everyday -> TR"]),
    ("SPIN 90", ["1:1 unknown-command everyday -> TR 90"]),
    ("SPIN 90 90", ["1:1 unknown-command everyday -> TR"]),
    ("turn )", ["1:1 unknown-command everyday -> TR"]),
    ("turn -", ["1:1 unknown-command everyday -> TR"]),
    ("GO x FW 1", ["1:1 unknown-command everyday -> FW x"]),
    ("VAR x PRINT", ["1:7 unknown-command everyday -> SPEAK"]),
    ("PRINT\nFW 1", ["1:1 unknown-command everyday -> SPEAK"]),
    ("PRINT ; FW 1", ["1:1 unknown-command everyday -> SPEAK"]),
    ("FWD 2\nFW $ 1 2\nJUMP", ["1:1 unknown-command -> FW", "2:4 unknown-character", "3:1 unknown-command"]),
    ("IF a = 1 THEN", ["1:1 missing-end", "1:6 syntax single-equals -> =="]),
    ("LOOP 3 TIMES FW 1", ["1:1 unknown-command everyday -> REPEAT"]),
    ("LOOP 3 FW 1 END REPEAT", ["1:1 unknown-command everyday -> REPEAT 3 TIMES"]),
    ("LOOP", ["1:1 unknown-command everyday -> REPEAT"]),
    ("say hello FW", ["1:1 unknown-command everyday -> SPEAK hello", "1:11 syntax missing-argument -> FW 2"]),
    ("say 3", ["1:1 unknown-command everyday -> SPEAK 3"]),
    ("say hello 3", ["1:1 unknown-command everyday -> SPEAK"]),
    ("VAR hello say hello", ["1:11 unknown-command everyday -> SPEAK hello"]),
    ("SPEAK hello\nworld", ["2:1 unknown-command"]),
    ("FW 1\nsteps", ["2:1 unknown-command"]),
    ("\nFW 3 steps", ["2:6 unknown-command filler -> 3"]),
    ("\n\n\n\nFW 3 steps", ["5:6 unknown-command filler -> 3"]),
    ("$", ["1:1 unknown-character"]),
    ("FW 1 steps\nBW 2 steps", ["1:6 unknown-command filler -> 1", "2:6 unknown-command filler -> 2"]),
    ("SCAN steps", ["1:6 unknown-command"]),
    ("IF 1 < 2 THEN\nFW 1\nEND\nIF 2 < 3\nFW 1", ["4:4 syntax"]),
    ("IF 1 < 2 THEN\nFW 1\nEND\nIF 3\n4 THEN", ["4:4 syntax"]),
    ("IF 1 < 2 THEN\nFW 1\nEND\nIF 3 REPEAT 2 TIMES FW 1 END REPEAT", ["4:4 syntax"]),
    ("REPEAT 2 TIMES\nFW $ END\nREPEAT 3 TIMES\nFW 1\nEND REPEAT", ["2:4 unknown-character"]),
    (
        "REPEAT 2 TIMES\nFW 1\nEND\nREPEAT 3 TIMES\nFW $ 2 3\nEND REPEAT",
        ["3:1 wrong-end -> END REPEAT", "5:4 unknown-character"],
    ),
    ("VAR steps FW 3 steps", ["1:16 unknown-command"]),
    ("VAR steps = 1\nFW 3 steps", ["2:6 unknown-command"]),
    ("FW steps", []),
    ("SPEAK POS FW 1", ["1:7 bad-argument missing-argument"]),
    ("HELP fim se\nPOS\nFW 1", []),
    ("COLOR 3 3", ["1:7 bad-argument", "1:9 syntax"]),
    ("COLOR FW 1", ["1:1 bad-argument missing-argument"]),
    ("FW COLOR\nFW 1", ["1:4 bad-argument missing-argument"]),
    ("IF DISTANSIA F > 3 THEN FW 1 END IF", ["1:4 unknown-command sensor -> DISTÂNCIA"]),
    ("x = DISTANSIA F + 1", ["1:5 unknown-command sensor -> DISTÂNCIA"]),
    ("WHILE 1 < DISTANSIA F DO FW 1 END WHILE", ["1:11 unknown-command sensor -> DISTÂNCIA"]),
    ("IF RANDOM 5 > 2 THEN FW 1 END IF", ["1:4 unknown-command value"]),
    ("WHILE 1 < RANDOM(1, 2) DO FW 1 END WHILE", ["1:11 unknown-command value"]),
    ("REPEAT RANDOM 5 TIMES FW 1 END REPEAT\nJUMP", ["1:8 unknown-command value", "2:1 unknown-command"]),
    ("IF RANDOM 5 > 2\nFW 1\nEND IF", ["1:4 unknown-command value"]),
    ("IF 1 = > 2 THEN FW 1 END IF", ["1:6 syntax single-equals -> =="]),
    ("IF a =-1 THEN FW 1 END IF", ["1:6 syntax single-equals -> =="]),
    ("IF a = 1", ["1:6 syntax single-equals -> =="]),
    ("IF a =>FW 1 THEN FW 1 END IF", ["1:6 syntax -> >="]),
    ("IF a => 1 2 THEN FW 1 END IF", ["1:6 syntax -> >="]),
    ("IF a =< (1 THEN FW 1 END IF", ["1:6 syntax -> <="]),
    ("IF a = 1 2 THEN\nFW 1\nEND IF\nJUMP", ["1:6 syntax single-equals -> ==", "4:1 unknown-command"]),
    ("REPEAT 2 AND 3 TIMES FW 1 END REPEAT", ["1:10 syntax second-comparison"]),
    ("FW 1 AND 2", ["1:6 unknown-command filler -> 1"]),
    ('IF 1 < 2 "and" THEN FW 1 END IF', ["1:10 syntax"]),
    ("FW 3 steps 2", ["1:6 unknown-command filler -> 3"]),
    ("FW 3 steps\n2", ["1:6 unknown-command filler -> 3", "2:1 syntax"]),
    ("x = RANDOM\n5", ["2:1 syntax"]),
    ("FW random 5 ) TR", ["1:4 unknown-command value", "1:15 syntax missing-argument -> TR 90"]),
    ("IF RANDOM\n5 > 3 THEN FW 1 END IF", ["2:1 syntax"]),
    ("FW x = 1", ["1:6 syntax"]),
    ("FW P [1] 2", ["1:6 syntax"]),
    ("SPEAK\nhello FWD", ['2:7 unknown-command text-quotes -> "hello FWD"']),
    ("SPEAK\nhello\nworld", ["3:1 unknown-command"]),
    ("JUMP\nFOR\nx = 0; x < 1; x = 2 DO FW 1 END FOR", ["1:1 unknown-command"]),
    ("JUMP\nFW\nx", ["1:1 unknown-command"]),
    ("JUMP\nFW\nx = 3", ["1:1 unknown-command", "2:1 syntax missing-argument -> FW 2"]),
    ("JUMP\nVAR\nx = 3", ["1:1 unknown-command"]),
    ("FW 3 +\n, 90", ["2:1 syntax"]),
    ("EXIT 5", ["1:6 syntax"]),
    ("TR == 3", ["1:4 syntax"]),
    ("REPEAT 2 TIMES\n= 3\nEND REPEAT", ["2:1 syntax"]),
    ("VAR = 3", ["1:5 syntax missing-first"]),
    ("PROCEDURE PROCEDURE DO FW 1 END PROCEDURE", ["1:11 reserved-word"]),
    ("VAR VAR = 3", ["1:5 reserved-word"]),
    ("VAR VAR VAR", ["1:5 reserved-word", "1:9 syntax missing-argument"]),
    ("PROCEDURE P: VAR DO FW 1 END PROCEDURE", ["1:14 reserved-word"]),
    ("PROCEDURE P: FOR, FOR DO END PROCEDURE", ["1:14 reserved-word", "1:19 reserved-word"]),
    ("FOR VAR FOR = 1; 1 < 2; FOR = 2 DO END FOR", ["1:9 reserved-word", "1:25 reserved-word"]),
    ("FOR x = 0; REPEAT < 2; x = 1 DO FW 1 END FOR", ["1:12 syntax"]),
    ("VAR\nif = 2", ["2:1 reserved-word"]),
    ("PROCEDURE\nif DO END PROCEDURE", ["1:1 syntax missing-argument"]),
    ("PROCEDURE if DO END PROCEDURE", ["1:11 reserved-word"]),
    ("JUMP\nSPEAK DISTANSIA\nF 1", ["1:1 unknown-command", "3:1 unknown-command"]),
    ("SPEAK DISTANSIA 5", ["1:7 unknown-command value"]),
    ("SPEAK DISTANSIA )", ["1:17 syntax"]),
    ("SPEAK ) F", ["1:7 syntax"]),
    ("SPEAK SOUNDON", []),
    ("JUMP\nDISTANCE\nZ", ["1:1 unknown-command", "3:1 unknown-command"]),
    ("DISTANCE Z\nPOS Z", ["1:10 bad-argument", "2:5 bad-argument"]),
    ("SOUND FW 1", ["1:1 bad-argument missing-argument"]),
    ('SPEAK "one\nx "two"', ["1:7 unterminated-string", "2:1 unknown-command"]),
    ('SPEAK "one\nSPEAK END REPEAT "two"', ["2:19 unknown-command", "2:22 unterminated-string"]),
    ('SPEAK "a"\nSPEAK "b\nJUMP\nSPEAK "c"', ["2:7 unterminated-string", "3:1 unknown-command"]),
    ('SPEAK "a\nb"\nSPEAK "c', ["3:7 unterminated-string"]),
    ('JUMP\nSPEAK "c', ["1:1 unknown-command", "2:7 unterminated-string"]),
    ('SPEAK "a\nFW 1\nSPEAK "b', ["3:8 unknown-command"]),
    ("FW 1\nFW SCAN 1 10", ["2:4 syntax"]),
    ("REPEAT 2 TIMES\nLOOP 3\nEND REPEAT", ["2:1 unknown-command everyday -> REPEAT 3 TIMES"]),
    ("REPEAT 2 TIMES\nLOOP 3\nFW 1\nEND\nEND REPEAT", ["2:1 unknown-command everyday -> REPEAT 3 TIMES"]),
    ("FW 1 ) ) = 3", ["1:6 syntax"]),
    ("WHILE 1 < 2 b = 3\nFW 1\nEND WHILE", ["1:13 syntax"]),
    ("IF 1 < 2 P [1] END IF", ["1:10 syntax"]),
    ("REPEAT 2 GIRAR END REPEAT", ["1:10 syntax"]),
    ("REPEAT 2 FWD FW 1 END REPEAT", ["1:10 syntax"]),
    ("IF 1 == 1 THEN END ENDFOR", ["1:16 wrong-end -> END IF"]),
    ("FWD 2\nFW $ ) 1", ["1:1 unknown-command -> FW", "2:4 unknown-character"]),
    ("GIRRA DERECHA 90\nFW $ ) 1", ["1:1 unknown-command -> GIRAR DERECHA", "2:4 unknown-character"]),
    ("REPEAT 2 TIMES\nEND\n  REPEAT 3 TIMES\nFW 1", ["2:1 wrong-end -> END REPEAT", "3:3 missing-end"]),
    ("REPEAT 2 TIMES\nEND -- x\n\n REPEAT 3 TIMES\nFW 1", ["2:1 wrong-end -> END REPEAT", "4:2 missing-end"]),
    (
        "REPEAT 2 TIMES\nEND\nREPEAT 3 TIMES\n$ FW 1 2\nEND REPEAT",
        ["2:1 wrong-end -> END REPEAT", "4:1 unknown-character"],
    ),
    (
        "REPEAT 2 TIMES\n$ FW 1 2\nEND\nREPEAT 3 TIMES\nEND REPEAT",
        ["2:1 unknown-character", "3:1 wrong-end -> END REPEAT"],
    ),
    ("IF 2,5 > 1 THEN FW 1 END IF", ["1:5 syntax whole-numbers"]),
    ("WHILE 1 < 2,5 DO FW 1 END WHILE", ["1:12 syntax whole-numbers"]),
    ("REPEAT 2 , 5 TIMES FW 1 END REPEAT", ["1:10 syntax"]),
    ("REPEAT 3 TIMS x 1\nEND REPEAT", ["1:10 syntax -> TIMES", "1:15 unknown-command"]),
    ("IF 1 < 2 THN x 1\nEND IF", ["1:10 syntax -> THEN", "1:14 unknown-command"]),
]


@pytest.mark.parametrize(("source", "found"), TEXTS)
def test_each_mistake_has_its_place_and_no_consequence(source: str, found: list[str]) -> None:
    assert [shown(each) for each in parse(source).diagnostics] == found


def shown(mistake: Diagnostic) -> str:
    """Its place, kind and code, and what was meant."""
    place = f"{mistake.span.line}:{mistake.span.column} {mistake.kind.value} {mistake.code}".strip()
    return f"{place} -> {mistake.meant}" if mistake.meant else place
