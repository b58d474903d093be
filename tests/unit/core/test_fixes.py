"""A fix replaces all words that were typed for the one that was meant."""

import pytest

from donnie_tui.core.program_text import fixed, mistakes
from donnie_tui.i18n.words import Words
from language.keywords import all_words, canonical
from language.parser import parse
from tests.unit.language_front.test_mistakes import (
    CALLS,
    EVERYDAY_LINES,
    OFFERS,
    PLACES,
    PROCEDURES,
    SENTENCES,
)

PAIRS = sorted(word for word in all_words() if " " in word)


def with_first_fix(text: str) -> str:
    """The text with the first fix that is known."""
    parsed = parse(text)
    known = [each for each in mistakes(parsed.diagnostics, Words()).values() if each.meant]
    return fixed(text, known[0]) if known else text


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("repita 2 vezes pf 1 fim repitta", "repita 2 vezes pf 1 FIM REPITA"),
        ("repetir 2 veces av 1 fin repetr", "repetir 2 veces av 1 FIN REPETIR"),
        ("REPEAT 2 TIMES FW 1 END REPET FW 2", "REPEAT 2 TIMES FW 1 END REPEAT FW 2"),
        ("REPEAT 2 TIMES FW 1 ENDREPEAT", "REPEAT 2 TIMES FW 1 END REPEAT"),
        ("gira direita 90", "GD 90"),
        ("girar diretta 90", "GIRAR DIREITA 90"),
        ("para frent 3", "PARA FRENTE 3"),
        ("PROCEDURE P: x DO FW x END PROCEDURE P: 2 FW 1", "PROCEDURE P: x DO FW x END PROCEDURE P [2] FW 1"),
        ("RIGHT 90", "TR 90"),
        ("RIGHT TRUN 90", "RIGHT TURN 90"),
        ("FALAR DISTANSIA F FALAR COLOR azul", "FALAR DISTÂNCIA F FALAR COLOR azul"),
        ("VAR x x == 3 FW x", "VAR x x = 3 FW x"),
        ('CREAR x = 3 HABLAR "total" x', 'CREAR x = 3 HABLAR "total" HABLAR x'),
        ("repita 2 vezes pf 1 fim se", "repita 2 vezes pf 1 FIM REPITA"),
        ("WALK 3 FW 1", "FW 3 FW 1"),
        ("WALK 3; FW 1", "FW 3; FW 1"),
        ("say hello\nFW 1", 'SPEAK "hello"\nFW 1'),
        ("WALK 3 steps FW 1", "FW 3 FW 1"),
        ("TURN AROUND FW 1", "TR 180 FW 1"),
        ("FW 3 steps please TR 90", "FW 3 TR 90"),
        ("FW 3 -- x\nFW 3 steps", "FW 3 -- x\nFW 3"),
        ("SPEAK hello big world\nFW 1", 'SPEAK "hello big world"\nFW 1'),
        ("SPEAK hello big world -- c", 'SPEAK "hello big world" -- c'),
        ("LOOP 3\nFW 1\nEND REPEAT", "REPEAT 3 TIMES\nFW 1\nEND REPEAT"),
        ("LOOP 3 TIMES\nFW 1\nEND REPEAT", "REPEAT 3 TIMES\nFW 1\nEND REPEAT"),
        ("i++ FW 1", "i = i + 1 FW 1"),
        ("VAR i i += 2 FW i", "VAR i i = i + 2 FW i"),
        ("TURN LEFT 30", "TL 30"),
        ("turn 30 left FW 1", "TL 30 FW 1"),
        ("WALK x + 1 FW 1", "FW x + 1 FW 1"),
        ("GO\nFW 1", "FW 2\nFW 1"),
        ("say hello -- loud", 'SPEAK "hello" -- loud'),
        ("PRINT x + 1", "SPEAK x + 1"),
        ("IF 1 = 2 THEN FW 1 END IF", "IF 1 == 2 THEN FW 1 END IF"),
        ("IF 1 => 2 THEN FW 1 END IF", "IF 1 >= 2 THEN FW 1 END IF"),
        ("FW\nTR 90", "FW 2\nTR 90"),
        ("SE 3 > 2 ENTÃO PF 1 SE NÃO PF 2 FIM SE", "SE 3 > 2 ENTÃO PF 1 SENÃO PF 2 FIM SE"),
        ("REPEAT 2 TIMES FW 1 END IF", "REPEAT 2 TIMES FW 1 END REPEAT"),
        ("REPEAT 2 TIMES FW 1 END FW 2", "REPEAT 2 TIMES FW 1 END REPEAT FW 2"),
        ("FW3 FW 1", "FW 3 FW 1"),
        ("FW 2FW 3", "FW 2 FW 3"),
    ],
)
def test_all_of_the_words_that_were_typed_are_replaced(typed: str, meant: str) -> None:
    assert with_first_fix(typed) == meant


FIX_IS_A_BEGINNING = (
    *(
        "IF 1 == 1 THEN REPEAT 2 TIMES FW 1 END FI",
        "LOOP 3 TIMES FW 1 END LOOP",
        "VAR #x = 2",
        "VAR a =\u0338 3",
        "VAR a a != 3",
    ),
    *("END REPET\nFW 3", "say Good morning"),
)
"""What follows is wrong in another way, and has its own mistake then."""


@pytest.mark.parametrize(
    "sources",
    [
        [source for source, *_ in PLACES],
        [source for source, _ in OFFERS],
        [line for line, _ in (*EVERYDAY_LINES, *SENTENCES)],
        [f"{line}\nFW 1" for line, _ in EVERYDAY_LINES],
        [f"REPEAT 2 TIMES\n{line}\nEND REPEAT" for line, _ in SENTENCES],
        [f"{PROCEDURES}{call}" for call, *_ in CALLS],
    ],
    ids=["places", "offers", "lines", "lines before others", "lines in a block", "calls"],
)
def test_a_fix_leaves_fewer_mistakes(sources: list[str]) -> None:
    for source in sources:
        if any(each in source for each in FIX_IS_A_BEGINNING):
            continue
        if (changed := with_first_fix(source)) != source:
            assert len(parse(changed).diagnostics) < len(parse(source).diagnostics), (source, changed)


HEADS = {
    "END IF": "IF 1 == 1 THEN",
    "END FOR": "FOR VAR i = 1; i < 3; i = i + 1 DO",
    "END REPEAT": "REPEAT 2 TIMES",
    "END WHILE": "WHILE 1 == 1 DO",
    "END PROCEDURE": "PROCEDURE P DO",
}


@pytest.mark.parametrize("pair", PAIRS)
def test_a_second_word_with_a_letter_too_many_is_not_left_behind(pair: str) -> None:
    head, value = HEADS.get(canonical(pair) or "", ""), "" if canonical(pair) in HEADS else " 1"
    typed = f"{head} {pair}{pair[-1]}{value}"

    assert with_first_fix(typed) == f"{head} {pair}{value}"


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("SE 3 > 2\nPF 1\nFIM SE", "SE 3 > 2 ENTÃO\nPF 1\nFIM SE"),
        ("SE 3 > 2 PF 1 FIM SE", "SE 3 > 2 ENTÃO PF 1 FIM SE"),
        ("REPITA 3 -- voltas\nPF 1\nFIM REPITA", "REPITA 3 VEZES -- voltas\nPF 1\nFIM REPITA"),
        ("APRENDER c: n\nc [n]\nFIM APRENDER", "APRENDER c: n FAÇA\nc [n]\nFIM APRENDER"),
        ("ENQUANTO 1 < 2 ENTÃO PF 1 FIM ENQUANTO", "ENQUANTO 1 < 2 FAÇA PF 1 FIM ENQUANTO"),
    ],
    ids=["if", "one-line", "comment", "procedure", "another"],
)
def test_the_word_that_ends_a_head_is_put_at_its_end(typed: str, meant: str) -> None:
    assert with_first_fix(typed) == meant


def test_the_hint_for_a_missing_word_names_the_line_where_it_belongs() -> None:
    found = parse("PF 1\nREPITA 3\nPF 2\nFIM REPITA").diagnostics[0]

    assert Words("pt").hint(found) == "VEZES vai no fim da linha 2."
