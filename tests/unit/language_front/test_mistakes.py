"""Each kind of mistake of form, and its place. One mistake gives one diagnostic."""

import unicodedata

import pytest

from language.diagnostics import Diagnostic, MistakeKind
from language.parser import parse
from language.suggestions import nearest_pair
from language.syntax import DeclaredProcedure, Procedure


def mistakes_in(source: str) -> tuple[Diagnostic, ...]:
    parsed = parse(source)
    assert parsed.program is None
    return parsed.diagnostics


def the_mistake(source: str) -> Diagnostic:
    (only,) = mistakes_in(source)
    return only


PLACES = [
    # a word or sign in a wrong place
    ("FW 1 10", "syntax", 1, 6),
    ("FW 2,5", "syntax", 1, 5),
    ('FW "five"', "syntax", 1, 4),
    ("FW", "syntax", 1, 1),
    ("FW 1\nBW -- how far\n\n", "syntax", 2, 1),
    ("VAR a = 3 *", "syntax", 1, 12),
    ("VAR a = (1 + 2", "syntax", 1, 15),
    ("FW 1 ) FW 2", "syntax", 1, 6),
    ("VAR = 3", "syntax", 1, 5),
    ("VAR", "syntax", 1, 1),
    ("VAR\nFW 3", "syntax", 1, 1),
    ("VAR my-name = 3", "syntax", 1, 7),
    ("VAR v = SCAN + 1", "syntax", 1, 9),
    ("SPEAK STATE", "syntax", 1, 7),
    ('SPEAK "a" + 1', "syntax", 1, 11),
    ('SPEAK 1 + "a"', "syntax", 1, 11),
    ("SPEAK", "syntax", 1, 1),
    ("a = = 3", "syntax", 1, 5),
    ("a = 1 = 2", "syntax", 1, 7),
    ("P [1\nSPEAK 2", "syntax", 2, 1),
    ("P [1,]", "syntax", 1, 6),
    ("FW 1\nELSE\nFW 1", "syntax", 2, 1),
    ("THEN", "syntax", 1, 1),
    ("REPEAT 2 TIMES FW 1 ELSE FW 2 END REPEAT", "syntax", 1, 21),
    ("IF 1 == 1 THEN FW 1 ELSE FW 2 ELSE FW 3 END IF", "syntax", 1, 31),
    ("IF a THEN FW 1 END IF", "syntax", 1, 6),
    ("IF a = 1 THEN FW 1 END IF", "syntax", 1, 6),
    ("IF DISTANCE F = 1 THEN FW 1 END IF", "syntax", 1, 15),
    ("IF 1 => 2 THEN SPEAK 1 END IF", "syntax", 1, 6),
    ("IF 1 < 2 < 3 THEN FW 1 END IF", "syntax", 1, 10),
    ("IF a == 1 DO FW 1 END IF", "syntax", 1, 11),
    ("IF a == 1\nSPEAK a\nEND IF", "syntax", 2, 1),
    ("IF SCAN > 3 THEN FW 1 END IF", "syntax", 1, 4),
    ("WHILE 1 < 2\nb = 1\nEND WHILE", "syntax", 2, 1),
    ("REPEAT 2\nSPEAK 1\nEND REPEAT", "syntax", 2, 1),
    ("REPEAT TIMES FW 1 END REPEAT", "syntax", 1, 8),
    ("FOR VAR i = 0; i < 2 DO SPEAK i END FOR", "syntax", 1, 22),
    ("FOR VAR i = 0, i < 2, i = i + 1 DO SPEAK i END FOR", "syntax", 1, 14),
    ("FOR i < 3; i = i + 1 DO FW 1 END FOR", "syntax", 1, 7),
    ("FOR VAR i = 0; i < 3; i + 1 DO FW 1 END FOR", "syntax", 1, 25),
    ("FOR VAR i = 0 TO 3 DO FW 1 END FOR", "syntax", 1, 15),
    ("FOR VAR i = 0; i < 2; i = i + 1\nFW 1\nEND FOR", "syntax", 2, 1),
    ("PROCEDURE : a\nDO\nEND PROCEDURE", "syntax", 1, 11),
    ("PROCEDURE DO FW 1 END PROCEDURE", "syntax", 1, 11),
    ("PROCEDURE P: a b DO FW 1 END PROCEDURE", "syntax", 1, 16),
    ("PROCEDURE P a DO FW 1 END PROCEDURE", "syntax", 1, 13),
    ("PROCEDURE P: DO FW 1 END PROCEDURE", "syntax", 1, 14),
    ("PROCEDURE P: a\nSPEAK a\nEND PROCEDURE", "syntax", 2, 1),
    ("PROCEDURE P: i++ DO FW 1 END PROCEDURE", "syntax", 1, 15),
    ("PROCEDURE P: a, i += 2 DO FW 1 END PROCEDURE", "syntax", 1, 19),
    ("PROCEDURE i *= 2 DO FW 1 END PROCEDURE", "syntax", 1, 13),
    ("EXIT 5", "syntax", 1, 6),
    ("HELP FW 5", "syntax", 1, 9),
    # unknown words
    ("JUMP 3", "unknown-command", 1, 1),
    ("FORWRAD 5", "unknown-command", 1, 1),
    ("SPEAK hello world", "unknown-command", 1, 13),
    ("SPEAK hello big wide world", "unknown-command", 1, 13),
    ("a == 5", "syntax", 1, 3),
    ("P (1, 2)", "unknown-command", 1, 1),
    ("RIGHT 90", "unknown-command", 1, 1),
    ("LOOP 3 TIMES FW 1 END LOOP", "unknown-command", 1, 1),
    ("UNLESS a == 1 THEN FW 1 END UNLESS", "unknown-command", 1, 1),
    ("REPEET 3 TIMES FW 1 END REPEAT", "unknown-command", 1, 1),
    ("IFF a == 1 THEN FW 1 END IF", "unknown-command", 1, 1),
    ("IF 1 == 1 THEN FW 1 ENDIF", "unknown-command", 1, 21),
    ("PARA FRENT 5", "unknown-command", 1, 1),
    ("GIRAR DIRETA 90", "unknown-command", 1, 1),
    # characters
    ("IF 1 != 2 THEN SPEAK 1 END IF", "unknown-character", 1, 6),
    ("VAR a a != 3", "unknown-character", 1, 9),
    ("FW 2.5", "unknown-character", 1, 5),
    ("VAR #x = 2", "unknown-character", 1, 5),
    ("FW 1 $ FW 2", "unknown-character", 1, 6),
    ("SPEAK 'hello world'", "unknown-character", 1, 7),
    ("FW 1\x00", "unknown-character", 1, 5),
    ("IF 1 ≠ 2 THEN SPEAK 1 END IF", "unknown-character", 1, 6),
    ("IF 1 =\u0338 2 THEN SPEAK 1 END IF", "unknown-character", 1, 6),
    ("VAR a =\u0338 3", "unknown-character", 1, 7),
    ("FW (\u0301 2 )", "unknown-character", 1, 4),
    ("VAR a = 3 \ud800", "unknown-character", 1, 11),
    ("FW \u0663", "unknown-character", 1, 4),
    # strings
    ('SPEAK "hello', "unterminated-string", 1, 7),
    ('FW 1\nSPEAK "hello\nFW 2', "unterminated-string", 2, 7),
    ("SPEAK “hello", "unterminated-string", 1, 7),
    ('SPEAK "one\nSPEAK "two"', "unterminated-string", 1, 7),
    ('SPEAK "one"\nSPEAK "two\nSPEAK "three"\nSPEAK "four"', "unterminated-string", 2, 7),
    ('SPEAK "one\rSPEAK "two"', "unterminated-string", 1, 7),
    ('SPEAK "a\u2028b"\nSPEAK "x\nSPEAK "y"', "unterminated-string", 2, 7),
    ('SPEAK "one\ntwo"\nSPEAK "three', "unterminated-string", 3, 7),
    # names
    ("VAR 52abc", "invalid-name", 1, 5),
    ("VAR _x = 2", "invalid-name", 1, 5),
    ("52abc = 3", "invalid-name", 1, 1),
    ("FW 5x", "invalid-name", 1, 4),
    ("VAR times = 2", "reserved-word", 1, 5),
    ("VAR if = 2", "reserved-word", 1, 5),
    ("VAR end = 2", "reserved-word", 1, 5),
    ("VAR vezes", "reserved-word", 1, 5),
    ("VAR right = 2", "reserved-word", 1, 5),
    ("VAR end if = 2", "reserved-word", 1, 5),
    ("CREAR mirar = 1", "reserved-word", 1, 7),
    ("FW = 3", "syntax", 1, 4),
    ("times = 3", "reserved-word", 1, 1),
    ("SCAN = 3", "syntax", 1, 6),
    ("PROCEDURE fw: a DO FW a END PROCEDURE", "reserved-word", 1, 11),
    ("PROCEDURE P: if, b DO FW b END PROCEDURE", "reserved-word", 1, 14),
    ("FOR VAR do = 1; 1 < 2; a = 1 DO END FOR", "reserved-word", 1, 9),
    # arguments
    ("SPEAK DISTANCE Z", "bad-argument", 1, 16),
    ("DISTANCE Z", "bad-argument", 1, 10),
    ("IF DISTANCE Z > 3 THEN FW 1 END IF", "bad-argument", 1, 13),
    ("SPEAK DISTANCE 5", "bad-argument", 1, 16),
    ("SPEAK DISTANCE )", "syntax", 1, 16),
    ("IF POS b > 0 THEN FW 5 END IF", "bad-argument", 1, 8),
    ("POS b", "bad-argument", 1, 5),
    ("SPEAK POS", "bad-argument", 1, 7),
    ("SPEAK COLOR purple", "bad-argument", 1, 13),
    ("VAR c = COLOR", "bad-argument", 1, 9),
    ("SPEAK COLOR > 3", "bad-argument", 1, 7),
    ("VAR c = COLOR\nFW 1", "bad-argument", 1, 9),
    ("SOUND maybe", "bad-argument", 1, 7),
    ("SOUND", "bad-argument", 1, 1),
    ("SOUND FW 1", "bad-argument", 1, 1),
    ("BELT vermelho", "bad-argument", 1, 6),
    ("VIBRATE", "bad-argument", 1, 1),
    ("VIBRATE q", "bad-argument", 1, 9),
    # ends
    ("IF 1 == 1 THEN FW 1", "missing-end", 1, 1),
    ("FW 1\nFOR VAR i = 0; i < 2; i = i + 1 DO\nFW 1", "missing-end", 2, 1),
    ("IF 1 == 1 THEN\nREPEAT 2 TIMES\nFW 1\nEND REPEAT", "missing-end", 1, 1),
    ("IF 1 == 1 THEN FW 1 ELSE FW 2", "missing-end", 1, 1),
    ("IF 1 == 1 THEN\nFW 1\nEND FOR", "wrong-end", 3, 1),
    ("IF 1 == 1 THEN FW 1 END", "wrong-end", 1, 21),
    ("IF 1 == 1 THEN FW 1 END IFF", "wrong-end", 1, 21),
    ("REPITA 3 VEZES PF 1 FIM REPETIR", "wrong-end", 1, 21),
    ("IF 1 == 1 THEN REPEAT 2 TIMES FW 1 END FI", "wrong-end", 1, 36),
    ("REPEAT 2 TIMES\nIF 1 == 1 THEN\nFW 1\nEND REPET\nFW 3", "wrong-end", 4, 1),
    ("END IF", "wrong-end", 1, 1),
    ("REPEAT 2 TIMES FW 1 END REPEAT END REPEAT FW 2", "wrong-end", 1, 32),
    ("IF 1 == 1 THEN REPEAT 2 TIMES FW 1 END IF END REPEAT", "wrong-end", 1, 36),
    ("IF 1 == 1 THEN REPEAT 2 TIMES FW 1 END IF", "wrong-end", 1, 36),
    # places
    ("\tJUMP", "unknown-command", 1, 2),
    ("\ufeffJUMP", "unknown-command", 1, 1),
    ("e\u0301 = 3 JUMP", "unknown-command", 1, 7),
    ("a\u0303o\u0301 = 3 $", "unknown-character", 1, 8),
    ("FW\r\n1\r\nJUMP", "unknown-command", 3, 1),
    ("FW 1\rJUMP", "unknown-command", 2, 1),
    ('SPEAK "a\nb" JUMP', "unknown-command", 2, 4),
    # numbers
    ("FW " + "9" * 4301, "number-too-large", 1, 4),
]


@pytest.mark.parametrize(("source", "kind", "line", "column"), PLACES)
def test_the_kind_and_the_place_of_a_mistake(source: str, kind: str, line: int, column: int) -> None:
    only = the_mistake(source)
    assert (only.kind.value, only.span.line, only.span.column) == (kind, line, column)


SIGNS = "=<>+-*/()[],:;"


def test_no_sign_is_read_without_its_marks() -> None:
    """Unicode has 1.1 million characters; the ones that mean the same sign by its own rules are no other."""
    for number in range(0x80, 0x110000):
        character = chr(number)
        plain = unicodedata.normalize("NFKD", character)
        if set(plain) & set(SIGNS) and unicodedata.normalize("NFC", character) == character:
            only = the_mistake(f"VAR a {character} 3")
            assert only.kind is MistakeKind.UNKNOWN_CHARACTER, hex(number)
            assert only.span.column == 7


@pytest.mark.parametrize("sign", SIGNS)
@pytest.mark.parametrize("mark", ["\u0338", "\u0301", "\u0338\u0301", "\u20d2"])
def test_no_sign_is_read_without_a_loose_mark(sign: str, mark: str) -> None:
    assert "unknown-character" in [each.kind.value for each in mistakes_in(f"VAR a = 3 {sign}{mark} FW 1")]


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        *(("\u2260", "<>"), ("=\u0338", "<>"), ("\u226e", ">="), ("<\u0338", ">="), ("\u226f", "<=")),
        *(("\u2264", "<="), ("\u2265", ">="), ("\u2270", ">"), ("\u2271", "<"), ("\uff1d", "=")),
        *(("\u00d7", "*"), ("\u00f7", "/"), ("\uff1d\u0338", "<>"), ("<=\u0338", ">"), ("\uff0b", "+")),
        *(("\u2266", "<="), ("\u2a7d", "<="), ("\u2267", ">="), ("\u2a7e", ">="), ("\u2261", "==")),
        *(("\u2715", "*"), ("\u00b7", "*"), ("\u22c5", "*"), ("\u2044", "/"), ("\u2215", "/")),
        *(("==\u0338", "<>"), (">=\u0338", "<"), (">\u0338", "<=")),
        *(("!=", "<>"), ("!==", "<>"), ("!", ""), ("!<", "")),
        *(("$", ""), ("<\u0301", ""), ("\u2203", ""), ("\u2260\u2260", ""), ("\u00b2", "")),
    ],
)
def test_a_sign_of_mathematics_or_another_language_means_one_of_godonnie(typed: str, meant: str) -> None:
    only = the_mistake(f"IF 1 {typed} 2 THEN FW 1 END IF")

    assert only.kind is MistakeKind.UNKNOWN_CHARACTER
    assert only.meant == meant


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("IF 1 == 1\nFW 1 END IF", ("THEN",)),
        ("REPEAT 2 FW 1 END REPEAT", ("TIMES",)),
        ("WHILE 1 < 2 FW 1 END WHILE", ("DO",)),
        ("IF a THEN FW 1 END IF", ("comparison",)),
        ("FW 1 10", ("command",)),
        ("FW", ("expression",)),
        ("SPEAK", ("expression", "text")),
        ("VAR = 3", ("name",)),
        ("VAR a = (1 + 2", (")",)),
        ("P [1", ("]", ",")),
        ("FOR VAR i = 0 TO 3 DO FW 1 END FOR", (";",)),
        ("SPEAK POS b", ("axis",)),
        ("SPEAK COLOR", ("colour",)),
        ("VIBRATE", ("direction",)),
        ("SOUND", ("on-or-off",)),
        ("JUMP", ("command",)),
        ("REPEAT 2 TIMES FW 1", ("END REPEAT",)),
        ("REPEAT 2 TIMES FW 1 END IF", ("END REPEAT",)),
        ("REPEAT 2 TIMES FW 1 10 END REPEAT", ("command", "END REPEAT")),
        ("PROCEDURE P: a 3 DO END PROCEDURE", (",", "DO")),
        ("P [", ("expression", "]")),
        ("P [1 2]", ("]", ",")),
        ("FOR VAR i 0; i < 2; i = i + 1 DO END FOR", ("=", ";")),
        ("FOR VAR i = 0 i < 2; i = i + 1 DO END FOR", (";",)),
        ("TR == 3", ("expression",)),
        ("WAIT 1 +", ("expression",)),
        ("VAR a = RANDOM 5", ("expression",)),
        ("SPEAK DISTANSIA F", ("expression",)),
        ("VAR x =\nFW 3", ("expression",)),
        ("FW\nTR 90", ("expression",)),
        ("FW = 3", ("expression",)),
        ("IF 1 = 2 THEN FW 1 END IF", ("comparison",)),
        ("x == 3", ("=",)),
        ("i++", ("=",)),
        ("WALK 3", ("command",)),
        ("RIGHT 90", ("command",)),
        ("P (1)", ("command",)),
        ("END IF", ("command",)),
        ("ELSE", ("command",)),
        ("si 3 > 2 entonces\nsi no\nfin si", ("command",)),
        ("FW 3 steps", ()),
        ("SPEAK hello world", ()),
        ("VAR if = 2", ()),
        ("IF 1 < 2 THEN FW 1", ("END IF",)),
        ("DISTANCE Z", ("direction",)),
    ],
)
def test_expected_are_the_words_that_fit_the_place(source: str, expected: tuple[str, ...]) -> None:
    assert the_mistake(source).expected == expected


@pytest.mark.parametrize(
    ("source", "name"),
    [("FW = 3", "FW"), ("SPEAK = 3", "SPEAK"), ("REPEAT 2 TIMES\nTR = 90 END REPEAT", "TR")],
)
def test_a_keyword_is_no_variable_that_could_be_assigned(source: str, name: str) -> None:
    only = the_mistake(source)

    assert (only.code, only.details.get("name"), only.found) == ("assigned-keyword", name, "=")


@pytest.mark.parametrize(
    ("source", "found"),
    [
        ("JUMP 3", "JUMP"),
        ("FW", "FW"),
        ("IF 1 == 1 THEN END\n  FOR", "END FOR"),
        ("IF 1 == 1 THEN END -- of what\n  FOR", "END FOR"),
        ('SPEAK "hi', '"hi'),
        ("FW 1 $$", "$$"),
        ('SPEAK 1 "a -- b"', '"a -- b"'),
        ("FW 1 THEN -- why", "THEN"),
    ],
)
def test_the_found_text_is_quoted_as_it_was_typed(source: str, found: str) -> None:
    assert the_mistake(source).found == found


OFFERS = [
    ("SPEAK 'hello world'", '"hello world"'),
    ("FALAR \u2018ol\u00e1\u2019", '"ol\u00e1"'),
    ("HABLAR \u00abhola\u00bb", '"hola"'),
    ("SPEAK ''", '""'),
    ("FORWRAD 5", "FORWARD"),
    ("FWD 5", "FW"),
    ("WF 5", "FW"),
    ("FALR 5", "FALAR"),
    ("AVANSAR 5", "AVANZAR"),
    ("ESPIARR", "ESPIAR"),
    ("IF 1 == 1 THEN FW 1 ENDIF", "END IF"),
    ("IF 1 == 1 THEN FW 1 END FI", "END IF"),
    ("IF 1 == 1 THEN REPEAT 2 TIMES FW 1 END FI", "END IF"),
    ("REPEAT 3 TIMS FW 1 END REPEAT", "TIMES"),
    ("SE 1 == 1 ENTAOO PF 1 FIM SE", "ENTÃO"),
    ("SE 1 == 1 ENTÃO PF 1 SENO PF 2 FIM SE", "SENÃO"),
    ("SI 1 == 1 ENTONCES AV 1 SIN AV 2 FIN SI", "SINO"),
    ("FW3", "FW 3"),
    ("pf10", "PF 10"),
    ("SOUNDON", "SOUND ON"),
    ("POSX", "POS X"),
    ("RIGHTTURN 90", "RIGHT TURN"),
    ("RIGHT 90", "TR 90"),
    ("GIRAR DERECH 90", "GIRAR DERECHA"),
    ("FRENTE 3", "PF 3"),
    ("TRÁS 3", "PT 3"),
    ("PF 1 DIREITA 90", "GD 90"),
    ("IZQUIERDA 90", "GI 90"),
    ("GIRA DIREITA 90", "GD 90"),
    ("GIRRA DERECHA 90", "GIRAR DERECHA"),
    ("RIGHT TRUN", "RIGHT TURN 90"),
    ("GIRAR DIRETA", "GIRAR DIREITA 90"),
    ("PARA FRENT\nGD 90", "PARA FRENTE 2"),
    ("TURN 90", "TR 90"),
    ("SPEAK COLOR gren", "GREEN"),
    ("FALAR COR vermelo", "VERMELHO"),
    ("IF a = 1 THEN FW 1 END IF", "=="),
    ("IF a => 1 THEN FW 1 END IF", ">="),
    ("WHILE a =< 1 DO FW 1 END WHILE", "<="),
    ("FALAR COR roxo", ""),
    ("SPEAK COLOR roxo", ""),
    ("COR roxo", ""),
    ("HABLAR COLOR roxo", "ROJO"),
    ("MIRAR FALAR COR roxo", "ROJO"),
    ("JUMP 3", ""),
    ("FOO 3", ""),
    ("x 3", ""),
    ("SPEAK hello world", '"hello world"'),
    ('SPEAK "a" x', "SPEAK x"),
    ('SPEAK "a\nb" x', ""),
    ("LEFT TRUN", "LEFT TURN 90"),
    ("a" * 100_000, ""),
    ("SPEAK DISTANCE Z", ""),
    ("SOUND of", ""),
    ("FW hello world", ""),
    ("SPEAK 1 + a b", ""),
    ("i + + 2", ""),
    ("i +- 2", ""),
    ("i ** 2", ""),
]


@pytest.mark.parametrize(("source", "meant"), OFFERS)
def test_a_near_word_is_offered_and_a_far_one_is_not(source: str, meant: str) -> None:
    assert the_mistake(source).meant == meant


@pytest.mark.parametrize("source", ["SPEAK l'eau d'ici", "'a'b", "a'b'", "SPEAK ' \"a\" '"])
def test_apostrophes_within_words_are_no_quotation_marks(source: str) -> None:
    assert not [each for each in mistakes_in(source) if each.meant.startswith('"')]


def test_a_misspelt_pair_of_words_stands_in_one_line() -> None:
    """As a fix changes one line."""
    assert [each.span.line for each in mistakes_in("GIRRA DERECHA 90")] == [1]
    assert [each.span.line for each in mistakes_in("GIRRA\nDERECHA 90")] == [1, 2]


@pytest.mark.parametrize(
    ("source", "meant"),
    [
        ("PROCEDIMENTO P FAÇA PF 1 FIM APRENDER P []", "APRENDER"),
        ("FWD 1 ENQUANTO 1 < 2 FAÇA PF 1 FIM ENQUANTO", "PF"),
        ("FORWRAD 1 MIENTRAS 1 < 2 HACER AV 1 FIN MIENTRAS", "AVANZAR"),
        ("PFF 5", "PF"),
    ],
)
def test_a_word_that_is_near_in_another_language_is_offered_in_that_of_the_program(
    source: str, meant: str
) -> None:
    assert the_mistake(source).meant == meant


def test_of_equally_near_words_the_one_in_the_language_of_the_program_is_offered() -> None:
    assert (
        the_mistake("PF 1 ENQUANTO 1 < 2 FAÇA REPITAR 2 VEZES PF 1 FIM REPITA FIM ENQUANTO").meant == "REPITA"
    )
    assert (
        the_mistake("AV 1 MIENTRAS 1 < 2 HACER REPITIR 2 VECES AV 1 FIN REPETIR FIN MIENTRAS").meant
        == "REPETIR"
    )


@pytest.mark.parametrize(
    ("source", "code", "details"),
    [
        ('SPEAK "a" + 1', "text-plus", {}),
        ("IF a = 1 THEN FW 1 END IF", "single-equals", {}),
        ("END IF", "stray-end", {}),
        ("ELSE", "stray-else", {}),
        ("SOUND", "missing-argument", {"word": "SOUND"}),
        ("SPEAK POS b", "", {"word": "POS"}),
        ("PF\nGD 90", "missing-argument", {"word": "FW"}),
        ("PARA FRENTE\nGD 90", "missing-argument", {"word": "FORWARD"}),
        ("GIRAR DIREITA", "missing-argument", {"word": "RIGHT TURN"}),
        ("P (1)", "call-brackets", {}),
        ("P x", "", {}),
        ("x == 3", "two-equals", {}),
        ("WALK 3", "everyday", {}),
        ("FW 3 steps", "filler", {"written": "FW 3", "word": "steps"}),
        ("speak hello big world", "text-quotes", {"written": 'speak "hello big world"'}),
        ("VAR a = RANDOM 5", "value", {}),
        ("SPEAK DISTANSIA F", "sensor", {}),
        ("VAR x =\nFW 3", "missing-value", {}),
        ("VAR if = 2", "", {"name": "if"}),
        ("FW 2,5", "whole-numbers", {}),
        ("FW 2 , 5", "", {}),
        ("REPEAT 2 FW 1 END REPEAT", "head-end", {"opener": "REPEAT", "missing": "TIMES", "line": 1}),
        (
            "\nREPEAT 2\n\nFW 1 END REPEAT",
            "head-end-before",
            {"opener": "REPEAT", "missing": "TIMES", "line": 2},
        ),
        ("IF 1 < 2 DO FW 1 END IF", "", {"opener": "IF"}),
        ("REPEAT TIMES FW 1 END REPEAT", "missing-first", {"opener": "REPEAT", "word": "REPEAT"}),
        ("VAR = 5", "missing-first", {"word": "VAR"}),
        ("PROCEDURE p: DO FW 1 END PROCEDURE", "no-colon", {"opener": "PROCEDURE"}),
        ("FOR VAR i = 1: DO FW 1 END FOR", "", {"opener": "FOR"}),
        ("WHILE 1 < 2 AND 2 < 3 DO FW 1 END WHILE", "second-comparison", {"opener": "WHILE"}),
        ("IF 1 < 2 OR 2 < 3 THEN FW 1 END IF", "other-comparison", {"opener": "IF"}),
        ("P [1 AND 2]", "", {}),
        ("\nREPEAT 2 TIMES FW 1 END IF", "other-end", {"opener": "REPEAT", "opener_line": 2}),
        ("\nREPEAT 2 TIMES FW 1 END", "", {"opener": "REPEAT", "opener_line": 2}),
    ],
)
def test_some_mistakes_have_a_sentence_of_their_own(
    source: str, code: str, details: dict[str, str | int]
) -> None:
    only = the_mistake(source)

    assert (only.code, dict(only.details)) == (code, details)


@pytest.mark.parametrize(
    ("source", "typed", "meant"),
    [
        ('si 3 > 2 entonces hablar "a" si no hablar "b" fin si', "si no", "SINO"),
        ("se 3 > 2 então pf 1\nse não repita 2 vezes pf 1 fim repita\nfim se", "se não", "SENÃO"),
        ('si 3 > 2 entonces\nhablar "a"\nsi no\nhablar "b"\nfin si', "si no", "SINO"),
        ('se 3 > 2 então\nfalar "a"\nse não\nfalar "b"\nfim se', "se não", "SENÃO"),
        ("IF 3 > 2 THEN\nREPEAT 2 TIMES\nFW 1\nEND REPEAT\nIF NOT\nFW 2\nEND IF", "IF NOT", "ELSE"),
    ],
    ids=["one-line", "block", "es", "pt", "en"],
)
def test_an_else_in_two_words_is_one_mistake(source: str, typed: str, meant: str) -> None:
    mistake = the_mistake(source)
    assert (mistake.kind, mistake.found, mistake.meant) == (MistakeKind.UNKNOWN_COMMAND, typed, meant)


def test_a_variable_that_is_called_no_is_none() -> None:
    assert parse("var no = 3\nsi no > 2 entonces\nsi no == 3 entonces\nhablar no\nfin si\nfin si").program


PROCEDURES = (
    "PROCEDURE AB: x DO FW x END PROCEDURE PROCEDURE Cd DO FW 1 END PROCEDURE"
    " PROCEDURE EF: x, y DO FW x END PROCEDURE "
)


CALLS = [
    ("AB 2", "AB [2]", "AB [x]"),
    ("AB: 2", "AB [2]", "AB [x]"),
    ("AB (2) FW 1", "AB [2]", "AB [x]"),
    ("ab n", "ab [n]", "ab [x]"),
    ("CD", "CD []", "CD []"),
    ("AB", "", "AB [x]"),
    ("AB 2 + 1", "", "AB [x]"),
    ("CD 3", "", "CD []"),
    ("AB 2\nFW 3", "AB [2]", "AB [x]"),
    ("AB 2 FW 3", "AB [2]", "AB [x]"),
    ("AB 2; FW 3", "AB [2]", "AB [x]"),
    ("AB 2 VAR m", "AB [2]", "AB [x]"),
    ("AB 2 m = 3", "AB [2]", "AB [x]"),
    ("AB 2 AB [3]", "AB [2]", "AB [x]"),
    ("AB 2 m", "", "AB [x]"),
    ('AB 2 "a"', "", "AB [x]"),
    ("EF 1, 2", "EF [1, 2]", "EF [x, y]"),
    ("EF (n, 2) FW 3", "EF [n, 2]", "EF [x, y]"),
    ("EF 1 n", "EF [1, n]", "EF [x, y]"),
    ("EF 1", "", "EF [x, y]"),
    ("EF 1,", "", "EF [x, y]"),
    ("EF 1, 2, 3", "", "EF [x, y]"),
    ("AB:\n2", "", "AB [x]"),
    ("AB (n) EF [1, 2]", "AB [n]", "AB [x]"),
]


@pytest.mark.parametrize(("call", "meant", "called"), CALLS)
def test_a_call_without_brackets_shows_the_right_call(call: str, meant: str, called: str) -> None:
    mistake = the_mistake(PROCEDURES + call)

    assert (mistake.kind, mistake.code, mistake.meant) == (MistakeKind.UNKNOWN_COMMAND, "procedure", meant)
    assert (mistake.details["call"], mistake.expected) == (called, ("command",))


def test_a_procedure_of_an_earlier_batch_shows_the_right_call() -> None:
    earlier = parse("PROCEDURE Go: A, b DO FW a END PROCEDURE").program
    assert earlier is not None
    procedure = earlier.body[0]
    assert isinstance(procedure, Procedure)

    (mistake,) = parse("go 1 2", declared={"go": DeclaredProcedure(procedure, earlier)}).diagnostics

    assert (mistake.code, mistake.meant) == ("procedure", "go [1, 2]")
    assert mistake.details == {"call": "go [A, b]"}


@pytest.mark.parametrize(
    ("head", "call"),
    [
        ("P: a, b", "P [a, b]"),
        ("P: A -- first\n, b", "P [A, b]"),
        ("P: a, b c", "P [a, b]"),
        ("P: a, 3", "P [a]"),
        ("P: a b", "P [a]"),
        ("P: 3", "P []"),
        ("P:", "P []"),
        ("P", "P []"),
    ],
)
def test_the_right_call_has_the_parameters_of_the_procedure(head: str, call: str) -> None:
    *_, mistake = mistakes_in(f"PROCEDURE {head} DO END PROCEDURE\nP 1")

    assert mistake.details["call"] == call


NEEDS_MORE = (
    "FW",
    "BW",
    "TR",
    "TL",
    "WAIT",
    "SPEAK",
    "VAR",
    "FORWARD",
    "PF",
    "GIRAR DIREITA",
    "ESPERAR",
    "AV",
)
NEXT = ("TR 90", "SCAN", 'SPEAK "a"', "VAR n = 2", "REPEAT 2 TIMES FW 1 END REPEAT", "SOUND ON", "; FW 1")


@pytest.mark.parametrize("command", NEEDS_MORE)
@pytest.mark.parametrize(
    ("source", "line"),
    [
        *((f"FW 1\n%s\n{following}", 2) for following in NEXT),
        ("FW 1\n%s", 2),
        ("FW 1\n%s\n\n-- nothing else\n", 2),
        ("REPEAT 2 TIMES\n%s\nEND REPEAT", 2),
        ("REPEAT 2 TIMES %s END REPEAT", 1),
        ("IF 1 == 1 THEN\n%s\nELSE\n  FW 1\nEND IF\nFW 2", 2),
        ("%s; FW 1", 1),
        ("%s TR 90", 1),
    ],
)
def test_a_missing_argument_is_the_one_mistake_of_its_command(source: str, line: int, command: str) -> None:
    only = the_mistake(source % command)

    assert (only.kind, only.code, only.found) == (MistakeKind.SYNTAX, "missing-argument", command)
    assert only.span.line == line


@pytest.mark.parametrize("following", ["x = 3", "P [1]"])
def test_the_assignment_on_the_next_line_is_not_the_number_of_the_command(following: str) -> None:
    only = the_mistake(f"VAR x PROCEDURE P: a DO FW a END PROCEDURE\nFW\n{following}\nFW x")

    assert (only.code, only.found, only.span.line) == ("missing-argument", "FW", 2)


@pytest.mark.parametrize(
    ("source", "found"),
    [
        ("IF\nFW 3\nEND IF", "IF"),
        ("WHILE\nFW 3\nEND WHILE", "WHILE"),
        ("REPEAT\nFW 3\nEND REPEAT", "REPEAT"),
        ("FOR\nFW 3\nEND FOR", "FOR"),
        ("APRENDER\nPF 3\nFIM APRENDER", "APRENDER"),
        ("REPETIR", "REPETIR"),
    ],
)
def test_a_head_without_anything_in_it_is_one_mistake(source: str, found: str) -> None:
    only = the_mistake(source)

    assert (only.code, only.found, only.span.line) == ("missing-argument", found, 1)


@pytest.mark.parametrize(
    ("source", "column"), [("VAR x =\nFW 3", 7), ("FW 3 +\nTR 90", 6), ("FW -\nVAR x = 3", 4)]
)
def test_a_missing_value_is_the_fault_of_the_sign_before_it(source: str, column: int) -> None:
    only = the_mistake(source)

    assert (only.code, only.span.line, only.span.column) == ("missing-value", 1, column)


@pytest.mark.parametrize(
    ("source", "meant"), [("FW\nTR 90", "FW 2"), ("GIRAR DIREITA\nPF 1", "GIRAR DIREITA 90"), ("SPEAK", "")]
)
def test_a_number_is_offered_where_one_is_missing(source: str, meant: str) -> None:
    assert the_mistake(source).meant == meant


EVERYDAY_LINES = [
    ("WALK 3", "FW 3"),
    ("walk 3 steps", "FW 3"),
    ("GO", "FW 2"),
    ("GO three", "FW 3"),
    ("MOVE FORWARD 3", "FW 3"),
    ("GO BACK 3", "BW 3"),
    ("BACK 3", "BW 3"),
    ("WALK n + 1", "FW"),
    ("TURN LEFT", "TL 90"),
    ("TURN RIGHT 30", "TR 30"),
    ("TURN TO THE LEFT", "TL 90"),
    ("LEFT", "TL 90"),
    ("RIGHT", "TR 90"),
    ('SAY "hello"', 'SPEAK "hello"'),
    ("PRINT n + 1", "SPEAK"),
    ("ANDAR 3", "PF 3"),
    ("ANDE 3 passos", "PF 3"),
    ("VIRAR ESQUERDA", "GE 90"),
    ("VIRAR À DIREITA 45", "GD 45"),
    ('DIZER "oi"', 'FALAR "oi"'),
    ("VOLTAR 2", "PT 2"),
    ("CAMINAR 3", "AV 3"),
    ("CAMINAR tres pasos", "AV 3"),
    ("DOBLAR A LA IZQUIERDA", "GI 90"),
    ('DECIR "hola"', 'HABLAR "hola"'),
    ("GIRAR A LA IZQUIERDA", "GI 90"),
    ("GIRAR À ESQUERDA 45", "GE 45"),
    ("GIRAR PARA A DIREITA", "GD 90"),
    ("AV 1 ANDAR 3", "AV 3"),
    ("ANDAR 3 GIRAR DERECHA 90", "AV 3"),
    ("WALK 3; FW 1", "FW 3"),
    ("WALK 3 VAR n = 1", "FW 3"),
    ("WALK 3 FW 1", "FW 3"),
    ("WALK (3)", "FW"),
    ("WALK -3", "FW"),
    ("TURN AROUND; FW 1", "TR 180"),
    ("TURN AROUND VAR n = 1", "TR 180"),
    ("TURN AROUND FW 1", "TR 180"),
    ("TURN AROUND n = 1", "TR 180"),
]


@pytest.mark.parametrize(("line", "meant"), EVERYDAY_LINES)
def test_an_everyday_word_is_answered_with_the_line_that_was_meant(line: str, meant: str) -> None:
    for source in (line, f"{line}\nSCAN", f"REPEAT 2 TIMES\n{line}\nEND REPEAT"):
        assert the_mistake(source).meant == meant


SENTENCES = [
    ("please walk 3", "FW 3"),
    ("Donnie go forward 2 steps", "FW 2"),
    ("walk 3 steps forward", "FW 3"),
    ("go back three steps", "BW 3"),
    ("turn 90 degrees to the left", "TL 90"),
    ("turn", "TR 90"),
    ("turn around", "TR 180"),
    ("spin", "TR 360"),
    ("rt 45", "TR 45"),
    ("look", "SCAN"),
    ("grab", "GRIP"),
    ("sleep 2", "WAIT 2"),
    ("say hello", 'SPEAK "hello"'),
    ("say Good morning, Donnie", "SPEAK"),
    ("print hello big world", 'SPEAK "hello big world"'),
    ("andar 3 passos para frente", "PF 3"),
    ("ande três passos para trás", "PT 3"),
    ("vá para frente", "PF 2"),
    ("vá à direita", "GD 90"),
    ("gire 90 graus para a direita", "GD 90"),
    ("vira à esquerda", "GE 90"),
    ("gire noventa graus", "GD 90"),
    ("pd 90", "GD 90"),
    ("dar meia volta", "GD 180"),
    ("olhe", "ESPIAR"),
    ("diga oi", 'FALAR "oi"'),
    ("por favor ande 2", "PF 2"),
    ("camina 3 pasos hacia adelante", "AV 3"),
    ("camina dos pasos hacia atrás", "RE 2"),
    ("gira 90 grados a la izquierda", "GI 90"),
    ("da media vuelta", "GD 180"),
    ("di hola", 'HABLAR "hola"'),
]


@pytest.mark.parametrize(("line", "meant"), SENTENCES)
def test_a_whole_sentence_of_a_child_is_answered_with_one_line(line: str, meant: str) -> None:
    for source in (line, f"{line}\nSCAN"):
        assert the_mistake(source).meant == meant


@pytest.mark.parametrize(
    ("line", "learner", "meant"),
    [
        ("ANDAR 3", "pt", "PF 3"),
        ("ANDAR 3", "es", "AV 3"),
        ("IR", "es", "AV 2"),
        ("GIRAR", "es", "GD 90"),
        ('IMPRIMIR "hola"', "es", 'HABLAR "hola"'),
        ('IMPRIMIR "oi"', "pt", 'FALAR "oi"'),
        ("REPITE 3", "es", "REPETIR 3 VECES"),
        ("WALK 3", "pt", "FW 3"),
    ],
)
def test_a_word_of_two_languages_is_read_in_the_learners(line: str, learner: str, meant: str) -> None:
    (only,) = parse(line, learner=learner).diagnostics

    assert only.meant == meant


def test_the_language_of_the_program_comes_before_the_learners() -> None:
    (only,) = parse("PF 1\nANDAR 3", learner="es").diagnostics

    assert only.meant == "PF 3"


def test_a_variable_is_said_without_quotation_marks() -> None:
    (of_text,) = parse("VAR n\nPRINT n").diagnostics
    (of_earlier,) = parse("PRINT n", variables=["n"]).diagnostics

    assert [of_text.meant, of_earlier.meant] == ["SPEAK n"] * 2


@pytest.mark.parametrize(
    ("line", "written"),
    [
        ("FW 3 steps", "FW 3"),
        ("PF 3 passos", "PF 3"),
        ("AV 3 pasos por favor", "AV 3"),
        ("TR 90 degrees", "TR 90"),
        ("FW 2 and TR 90", "FW 2"),
        ("WAIT 2 seconds FW 1", "WAIT 2"),
    ],
)
def test_a_word_that_is_not_needed_is_named_with_the_command_alone(line: str, written: str) -> None:
    first = mistakes_in(line)[0]

    assert (first.code, first.details["written"]) == ("filler", written)
    assert len(mistakes_in(line)) == 1


@pytest.mark.parametrize(
    ("source", "meant"),
    [
        ("LOOP 3\nFW 1\nEND LOOP", "REPEAT 3 TIMES"),
        ("LOOP 3 TIMES\nFW 1\nEND LOOP", "REPEAT"),
        ("WHEN 3 > 2 THEN\nFW 1\nEND IF", "IF"),
        ("QUANDO 3 > 2 ENTÃO\nPF 1\nFIM SE", "SE"),
        ("LOOP 3", "REPEAT 3 TIMES"),
    ],
)
def test_an_everyday_word_for_a_block_is_one_mistake(source: str, meant: str) -> None:
    assert the_mistake(source).meant == meant


def test_a_misspelt_for_is_one_mistake() -> None:
    assert the_mistake("FR VAR i = 0; i < 3; i = i + 1 DO\nFW i\nEND FOR").found == "FR"


def test_an_everyday_word_may_be_a_name() -> None:
    assert parse("VAR walk = 2 PROCEDURE go: loop DO FW loop END PROCEDURE walk = 3 go [walk]").program


@pytest.mark.parametrize("sign", ["#", "//"])
def test_the_comment_of_another_language_is_one_mistake(sign: str) -> None:
    only = the_mistake(f'{sign} say "hi and walk 3\nFW 2')

    assert (only.kind, only.found, only.meant) == (MistakeKind.UNKNOWN_CHARACTER, sign, "--")


def test_a_mistake_after_the_comment_of_another_language_is_found() -> None:
    assert [each.span.line for each in mistakes_in("# go\nFW\nTR 90 # on\nFW 2 // x\nJUMP")] == [
        1,
        2,
        3,
        4,
        5,
    ]


@pytest.mark.parametrize(
    ("source", "meant"),
    [
        ("VAR i i++ FW 1", "i = i + 1"),
        ("VAR i\ni += 2\nFW i", "i = i + 2"),
        ("i -= n", "i = i - n"),
        ("i *= (3 + 1) - 2\nFW i", ""),
        ("i += 2 * 3", ""),
        ("i -= n + 1", ""),
        ("i++ ++", "i = i + 1"),
        ("VAR i\ni := 2\nFW i", "i = 2"),
        ("i++ i = 3\nFW i", "i = i + 1"),
        ("FOR VAR i = 0; i < 3; i++ DO\nFW i\nEND FOR", "i = i + 1"),
        ("FOR VAR i = 0; i < 3; i += 2 DO\nFW i\nEND FOR", "i = i + 2"),
    ],
)
def test_the_short_change_of_another_language_is_one_mistake(source: str, meant: str) -> None:
    only = the_mistake(source)

    assert (only.code, only.found, only.meant) == ("short-change", "i", meant)
    assert only.meant_at is None
    assert (only.meant_end is None) is (not meant)
    assert only.details["written"] == (meant or f"i = i {source[2]} 1")


@pytest.mark.parametrize(
    ("source", "written", "corrected"),
    [
        ("VAR i i := i + 1\nFW i", "i = i + 1", "VAR i i = i + 1\nFW i"),
        ("VAR i i :=  2  *  3", "i = 2 * 3", "VAR i i =  2  *  3"),
        ("VAR i i :=", "i = 1", "VAR i i ="),
    ],
)
def test_a_colon_before_an_equals_sign_is_left_out(source: str, written: str, corrected: str) -> None:
    only = the_mistake(source)

    assert only.details["written"] == written
    assert source[: only.span.start] + only.meant + source[only.meant_end :] == corrected


@pytest.mark.parametrize(
    ("source", "found", "column"),
    [
        ("VAR a = RANDOM 5\nFW a", "RANDOM 5", 9),
        ("SPEAK RANDOM(1, 5)\nFW 1", "RANDOM(1, 5)", 7),
        ("SPEAK RANDOM(1, 5\nFW 1", "RANDOM(1, 5", 7),
        ("SPEAK RANDOM(1, 5", "RANDOM(1, 5", 7),
        ("FW random (5) TR 90", "random (5)", 4),
        ("SPEAK RANDOM 5 + 1\nFW 1", "RANDOM 5", 7),
        ("SPEAK RANDOM((5) + 1)\nFW 1", "RANDOM((5)", 7),
    ],
)
def test_a_value_after_an_unknown_name_is_the_fault_of_the_name(source: str, found: str, column: int) -> None:
    only = the_mistake(source)

    assert (only.kind, only.found, only.span.column) == (MistakeKind.UNKNOWN_COMMAND, found, column)


def test_a_value_after_a_variable_is_the_fault_of_the_value() -> None:
    assert the_mistake("VAR n = 2\nFW n 3").found == "3"


@pytest.mark.parametrize("head", ["1 < 2 AND 2 < 3", "1 < 2 E 2 < 3", "1 < 2 Y 2 < 3", "1 < 2 or 2 < 3"])
def test_a_second_comparison_is_one_mistake(head: str) -> None:
    for source in (f"IF {head} THEN\nFW 1\nEND IF", f"WHILE {head} DO\nFW 1\nEND WHILE"):
        assert the_mistake(source).code in ("second-comparison", "other-comparison")


@pytest.mark.parametrize(
    "head",
    [
        "FOR VAR i = 0, i < 3, i = i + 1 DO",
        "FOR VAR i = 0; i = 3; i = i + 1 DO",
        "FOR VAR i = 0; i < 3; i + 1 DO",
        "FOR VAR i = 0; i < 3 DO",
        "FOR i = 0 TO 3 DO",
        "FOR VAR i = 0; i < 3; i = i + 1",
        "FOR VAR i = 0 i < 3; i = i + 1 DO",
        "FOR (VAR i = 0; i < 3; i++) DO",
        "FOR VAR i = 0; i < 3; i = i % 2 DO",
        "FOR 3 TIMES",
        "FOR i IN 3 DO",
    ],
)
def test_one_slip_in_a_for_line_is_one_mistake(head: str) -> None:
    the_mistake(f"{head}\nFW 1\nEND FOR\nTR 90")


def test_an_else_if_without_its_own_end_says_so() -> None:
    only = the_mistake("IF 1 < 2 THEN\nFW 1\nELSE IF 2 < 3 THEN\nFW 2\nELSE IF 3 < 3 THEN\nEND IF\nEND IF")

    assert (only.kind, only.code) == (MistakeKind.MISSING_END, "else-if")


@pytest.mark.parametrize(
    ("before", "after"),
    [("", "\nIF 1 < 2 THEN\nFW 1"), ("REPEAT 2 TIMES\n", ""), ("IF 1 < 2 THEN\n", "")],
    ids=["an IF after it", "a loop around it", "an IF around it"],
)
def test_another_block_without_its_end_does_not_say_so(before: str, after: str) -> None:
    chain = "IF 1 < 2 THEN\nELSE IF 2 < 3 THEN\nEND IF\nEND IF"

    assert the_mistake(f"{before}{chain}{after}").code == ("else-if" if before.startswith("IF") else "")


@pytest.mark.parametrize("source", ["GRIP + 1", "VAR SOLTAR = 1\nSOLTAR + 1"])
def test_a_word_of_the_gripper_is_not_proposed_in_place_of_itself(source: str) -> None:
    assert the_mistake(source).meant == ""


@pytest.mark.parametrize(
    ("first", "meant"),
    [("GIRA", "GIRAR DIREITA"), ("SPEAK", None), ("GIRA" * 11, None), ("PULAR", None)],
)
def test_the_keyword_of_a_second_word_is_meant_where_the_first_is_near(first: str, meant: str | None) -> None:
    found = nearest_pair(first, "DIREITA", frozenset({"TR"}))

    assert (found.text if found else None) == meant


@pytest.mark.parametrize(
    ("source", "meant"),
    [
        ("FW 1FW 2", "1 FW"),
        ("GD 90PF 2", "90 PF"),
        ("REPEAT 4TIMES FW 1 END REPEAT", "4 TIMES"),
        ("FW 5x", ""),
        ("FW 5xFW 2", ""),
        ("VAR _fw = 2", ""),
    ],
)
def test_a_command_that_touches_a_number_was_meant_after_a_blank(source: str, meant: str) -> None:
    assert parse(source).diagnostics[0].kind is MistakeKind.INVALID_NAME
    assert parse(source).diagnostics[0].meant == meant
