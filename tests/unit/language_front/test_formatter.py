"""Examples of canonical text. The property tests have the rules for all programs."""

import pytest

from language.formatter import formatted
from tests.formatting import format_source

PAIRS = [
    ("fw 1;bw 2 ;; tr 3", "FW 1\nBW 2\nTR 3\n"),
    ("", ""),
    ("-- only", "-- only\n"),
    ("if a<3 then fw 1 else bw(1+2)*-3 end\nif", "IF a < 3 THEN\n  FW 1\nELSE\n  BW (1 + 2) * -3\nEND IF\n"),
    ("repeat 2 times do end repeat", "REPEAT 2 TIMES DO\nEND REPEAT\n"),
    (
        "for var i=0;i<2;i=i+1 do p[i,- -2]q[] end for",
        "FOR VAR i = 0; i < 2; i = i + 1 DO\n  p [i, - -2]\n  q []\nEND FOR\n",
    ),
    (
        "for var i=0;i<2;i=i+1 do fw 1;fw 2; end for;fw 3",
        "FOR VAR i = 0; i < 2; i = i + 1 DO\n  FW 1\n  FW 2\nEND FOR\nFW 3\n",
    ),
    ("procedure Quad:a,b do end procedure", "PROCEDURE Quad: a, b DO\nEND PROCEDURE\n"),
    ("speak distance-1 speak pos x", "SPEAK DISTANCE - 1\nSPEAK POS X\n"),
    ("sound on color RED", "SOUND ON\nCOLOR RED\n"),
    ("se 1==1 entao pf 1 senao pt 1 fim se", "SE 1 == 1 ENTÃO\n  PF 1\nSENÃO\n  PT 1\nFIM SE\n"),
    ("fw 1\n\n\n\nfw 2\n", "FW 1\n\nFW 2\n"),
    ("\n\nrepeat 2 times\n\nfw 1\n\nend repeat", "REPEAT 2 TIMES\n  FW 1\nEND REPEAT\n"),
    ("fw 1 --why\n--own\nfw 2", "FW 1 -- why\n-- own\nFW 2\n"),
    ("fw 1 —why", "FW 1 -- why\n"),
    ("if 1==1 -- why\nthen fw 1 end if", "IF 1 == 1 -- why\n  THEN\n  FW 1\nEND IF\n"),
    ("fw 1 + -- one\n-- two\n2", "FW 1 + -- one\n  -- two\n  2\n"),
    (
        "repeat 2 times -- in\n-- first\nfw 1\n-- last\nend repeat -- out",
        "REPEAT 2 TIMES -- in\n  -- first\n  FW 1\n  -- last\nEND REPEAT -- out\n",
    ),
    ("girar -- c\ndireita 90", "GIRAR DIREITA -- c\n  90\n"),
    (
        "repeat 2 times fw 1 end -- c\n\n– d\nrepeat\nfw 1",
        "REPEAT 2 TIMES\n  FW 1\nEND REPEAT -- c\n-- d\nFW 1\n",
    ),
    ("----- part -----\nfw 1", "----- part -----\nFW 1\n"),
    ('speak "a  -- b\nc" -- d', 'SPEAK "a  -- b\nc" -- d\n'),
    ('speak "a\r\nb\rc"', 'SPEAK "a\nb\nc"\n'),
    ("speak “olá”", "SPEAK “olá”\n"),
    ("help fim   se\nhelp\nfw 1", "HELP FIM SE\nHELP\nFW 1\n"),
    ("VAR Ação = 007", "VAR Ação = 007\n"),
    (";; fw 1;\n\nfw 2;", "FW 1\n\nFW 2\n"),
    (
        "if 1==1 then\nfw 1\n\n\nelse\n\nfw 2\n\nend if\n\nfw 3",
        "IF 1 == 1 THEN\n  FW 1\nELSE\n  FW 2\nEND IF\n\nFW 3\n",
    ),
    ("fw 1\n\n-- c\n\n\nfw 2", "FW 1\n\n-- c\n\nFW 2\n"),
    ("repeat 2 times\n\n-- c\nfw 1\nend repeat", "REPEAT 2 TIMES\n  -- c\n  FW 1\nEND REPEAT\n"),
    ('speak "a\n\nb"\nfw 1', 'SPEAK "a\n\nb"\nFW 1\n'),
    ('speak "a\n\nb"\n\nfw 1', 'SPEAK "a\n\nb"\n\nFW 1\n'),
    ("fw (-2) bw -(3)", "FW (-2)\nBW -(3)\n"),
    ("x=-a- -b*(c)-1", "x = -a - -b * (c) - 1\n"),
    ("speak distance f-1 speak pos a*-2", "SPEAK DISTANCE F - 1\nSPEAK POS A * -2\n"),
    (
        "for var i=0;-- c\ni<2;i=i+1 do end for;-- d",
        "FOR VAR i = 0; -- c\n  i < 2; i = i + 1 DO\nEND FOR -- d\n",
    ),
    (
        "repeat 2 times repeat 3 times fw 1 + -- c\n2 end repeat end repeat",
        "REPEAT 2 TIMES\n  REPEAT 3 TIMES\n    FW 1 + -- c\n      2\n  END REPEAT\nEND REPEAT\n",
    ),
    ("-- a\n–b―c -- d\n—", "-- a\n-- b―c -- d\n--\n"),
    ("--  a", "--  a\n"),
    ("--!a\n--é", "--!a\n-- é\n"),
    (" ; -- a\n;", "-- a\n"),
    ("fw 1 ; -- a\n; -- b\nfw 2", "FW 1 -- a\n-- b\nFW 2\n"),
    ("fw 1\n;\nfw 2", "FW 1\nFW 2\n"),
    ("help Foo\nhelp  girar   direita", "HELP Foo\nHELP GIRAR DIREITA\n"),
    ("x = -(-a)", "x = -(-a)\n"),
    ("p [-1, (-2), a -1]", "p [-1, (-2), a - 1]\n"),
    (
        "repeat 2 times\n-- a\n\n\n-- b\nfw 1 end repeat",
        "REPEAT 2 TIMES\n  -- a\n\n  -- b\n  FW 1\nEND REPEAT\n",
    ),
]


@pytest.mark.parametrize(("source", "expected"), PAIRS)
def test_canonical_text(source: str, expected: str) -> None:
    assert format_source(source) == expected


@pytest.mark.parametrize(
    ("source", "language", "expected"),
    [
        ("FW 1 FORWARD 1", "pt", "PF 1\nPARA FRENTE 1\n"),
        ("PF 1 PARA FRENTE 1", "es", "AV 1\nAVANZAR 1\n"),
        ("SOUND ON SPEAK COLOR red", "pt", "SOM LIGADO\nFALAR COR VERMELHO\n"),
        ("SPEAK DISTANCE fr VIBRATE bl", "pt", "FALAR DISTÂNCIA FD\nVIBRAR TE\n"),
        ("FALAR DISTÂNCIA te", "es", "HABLAR DISTANCIA TI\n"),
        ("HELP end if", "es", "AYUDA FIN SI\n"),
        ("VAR vermelho = 1 SPEAK red", "es", "CREAR vermelho = 1\nHABLAR red\n"),
        (
            "FOR frente = 0; frente < 2; frente = 1 DO END FOR",
            "pt",
            "PARA frente = 0; frente < 2; frente = 1 FAÇA\nFIM PARA\n",
        ),
        ('SPEAK "FW 1" -- FW 1', "pt", 'FALAR "FW 1" -- FW 1\n'),
        ("SPEAK GREY", "en", "SPEAK GREY\n"),
        ("SPEAK COLOR GREY", "en", "SPEAK COLOR GRAY\n"),
    ],
)
def test_translation(source: str, language: str, expected: str) -> None:
    assert format_source(source, language) == expected


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("falar distancia f", "FALAR DISTÂNCIA F\n"),
        ("hablar distancia f", "HABLAR DISTANCIA F\n"),
        ("DISTANCIA F", "DISTANCIA F\n"),
        ("DISTÂNCIA F", "DISTÂNCIA F\n"),
    ],
)
def test_a_word_of_two_languages_is_written_as_in_the_language_around_it(source: str, expected: str) -> None:
    assert format_source(source) == expected


def test_a_program_with_mistakes_is_left_alone() -> None:
    result = formatted("FW 1\nJUMP")

    assert result.text is None
    assert [each.kind.value for each in result.diagnostics] == ["unknown-command"]


def test_an_unknown_language_raises_an_error() -> None:
    with pytest.raises(KeyError):
        formatted("FW 1", "de")


def test_a_word_of_the_gripper_is_translated_as_a_command_and_kept_as_a_name() -> None:
    source = "var Grip = 1 grip grip = Grip + 1 release [grip] soltar"

    assert formatted(source, "es").text == (
        "CREAR Grip = 1\nTOMAR\ngrip = Grip + 1\nrelease [grip]\nSOLTAR\n"
    )
