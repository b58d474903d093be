"""Text to tokens."""

import pytest

from language.lexer import lex
from language.tables import TERMINALS


def kinds(source: str) -> str:
    return " ".join(TERMINALS[token[0]] for token in lex(source).tokens)


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("END\n\tIF", "END_IF"),
        ("fim  se", "END_IF"),
        ("END -- of\n-- what\nIF", "END_IF"),
        ("GIRAR — para onde\rDIREITA 90", "TR NUMBER"),
        ("END $ -- no\nIF", "END IF"),
        ("PARA -- i\nfrente = 0", "FOR NAME ASSIGN NUMBER"),
        ("PARA FRENTE 2", "FW NUMBER"),
        ("PARA f = 0", "FOR NAME ASSIGN NUMBER"),
        ("PARA frente = 0", "FOR NAME ASSIGN NUMBER"),
        ("PARA frente -- i\n= 0", "FOR NAME ASSIGN NUMBER"),
        ("PARA frente == 0", "FW COMPARATOR NUMBER"),
        ("FIM PARA FRENTE", "END_FOR NAME"),
        ("GIRAR\nDIREITA 90", "TR NUMBER"),
        ("RIGHT 90", "FRAGMENT NUMBER"),
        ("END\u200bIF", "END_IF"),
        ("PARA TRA\u0301S 2", "BW NUMBER"),
    ],
)
def test_words_of_two_parts_are_split_by_any_blank_and_by_comments(source: str, expected: str) -> None:
    assert kinds(source) == expected


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("GRIP RELEASE", "GRIP RELEASE"),
        ("pegar soltar", "GRIP RELEASE"),
        ("TOMAR; Soltar;", "GRIP SEMICOLON RELEASE SEMICOLON"),
        ("FW 1 GRIP BW 1", "FW NUMBER GRIP BW NUMBER"),
        ("x = a GRIP", "NAME ASSIGN NAME GRIP"),
        ("DISTANCE GRIP", "DISTANCE GRIP"),
        ("POS -- where\nGRIP", "POS GRIP"),
        ("REPEAT 2 TIMES GRIP END REPEAT", "REPEAT NUMBER TIMES GRIP END_REPEAT"),
        ("HELP GRIP", "HELP TOPIC"),
        ("HELP\nGRIP", "HELP GRIP"),
        ("GRIP -- = 3", "GRIP"),
        ("VAR grip = 3", "VAR NAME ASSIGN NUMBER"),
        ("VAR release grip = 3", "VAR NAME NAME ASSIGN NUMBER"),
        ("grip -- the hand\n= grip - release", "NAME ASSIGN NAME SIGN NAME"),
        ("FW grip GRIP", "FW NAME GRIP"),
        ("WHILE soltar < 3 DO SOLTAR END WHILE", "WHILE NAME COMPARATOR NUMBER DO RELEASE END_WHILE"),
        (
            "FOR grip = 0; grip < 2; grip = 1 DO",
            "FOR NAME ASSIGN NUMBER SEMICOLON NAME COMPARATOR NUMBER SEMICOLON NAME ASSIGN NUMBER DO",
        ),
        ("PROCEDURE GRIP: release, tomar DO", "PROCEDURE NAME COLON NAME COMMA NAME DO"),
        ("GRIP [1] PEGAR []", "NAME LSQB NUMBER RSQB NAME LSQB RSQB"),
    ],
)
def test_the_words_of_the_gripper_are_names_where_no_command_can_begin(source: str, expected: str) -> None:
    assert kinds(source) == expected


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("POS x x", "POS AXIS NAME"),
        ("POS\nx = 3", "POS NAME ASSIGN NUMBER"),
        ("DISTANCE f f", "DISTANCE DIRECTION NAME"),
        ("DISTANCE\nf = 1", "DISTANCE NAME ASSIGN NUMBER"),
        ("DISTANCE f == 1", "DISTANCE DIRECTION COMPARATOR NUMBER"),
        ("DISTANCE T [1]", "DISTANCE NAME LSQB NUMBER RSQB"),
        ("COLOR red red", "COLOR COLOUR NAME"),
        ("COR vermelho", "COLOR COLOUR"),
        ("COLOR purple", "COLOR NAME"),
        ("SOUND on on", "SOUND SWITCH NAME"),
        ("BELT ligado", "BELT SWITCH"),
        ("VIBRATE td", "VIBRATE DIRECTION"),
        ("x y a f b t d red on", "NAME NAME NAME NAME NAME NAME NAME NAME NAME"),
    ],
)
def test_letters_and_colours_are_words_only_after_their_keyword(source: str, expected: str) -> None:
    assert kinds(source) == expected


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("HELP", "HELP"),
        ("HELP FW", "HELP TOPIC"),
        ("HELP end if", "HELP TOPIC"),
        ("HELP\nFW 3", "HELP FW NUMBER"),
        ("HELP end\nIF", "HELP TOPIC IF"),
        ("HELP x = 3", "HELP NAME ASSIGN NUMBER"),
        ("HELP; FW 3", "HELP SEMICOLON FW NUMBER"),
    ],
)
def test_help_takes_a_word_of_its_own_line(source: str, expected: str) -> None:
    assert kinds(source) == expected


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("5--3", "NUMBER"),
        ("5 - -3", "NUMBER SIGN SIGN NUMBER"),
        ("5 \u2212 3", "NUMBER SIGN NUMBER"),
        ("1 — one\n2 – two\n3 -- three", "NUMBER NUMBER NUMBER"),
        ("<>=<=>====<", "COMPARATOR ASSIGN COMPARATOR COMPARATOR COMPARATOR ASSIGN COMPARATOR"),
        ('"a -- b" "" “c"d” "e“f"', "STRING STRING STRING STRING"),
        ('"a\n\nb" x', "STRING NAME"),
        ("\ufeffFW\u00a01", "FW NUMBER"),
        ("posic\u0327a\u0303o X", "POS AXIS"),
        ("VAR ação = 1", "VAR NAME ASSIGN NUMBER"),
        ("VAR 9x = 2", "VAR NAME ASSIGN NUMBER"),
        (f"FW {'7' * 4301} TR", "FW NUMBER TR"),
        (f"FW {'0' * 5000}7 TR", "FW NUMBER TR"),
    ],
)
def test_signs_strings_comments_and_blanks(source: str, expected: str) -> None:
    assert kinds(source) == expected


def test_names_are_folded_and_places_are_those_of_the_text() -> None:
    tokens = lex("\tA\u0303c\u0327A\u0303O  =\r\n Ñ").tokens

    assert [(token[5], token[3], token[4]) for token in tokens] == [("acao", 1, 2), ("=", 1, 8), ("n", 2, 2)]


def test_a_string_over_lines_moves_the_lines_after_it() -> None:
    assert [token[3:5] for token in lex('"a\r\nb\rc" x').tokens] == [(1, 1), (3, 4)]


def test_comments_know_the_next_token() -> None:
    comments = lex("-- a\nFW -- b\n1 -- c").comments

    assert [(each.line, each.before) for each in comments] == [(1, 0), (2, 1), (3, 2)]


def test_leading_zeros_do_not_count_for_the_limit_of_digits() -> None:
    lexed = lex("0" * 5000 + "7" * 4300)
    assert lexed.mistakes == []
    assert lex("7" * 4301).mistakes[0].kind.value == "number-too-large"


def test_adjacent_unreadable_characters_are_one_mistake() -> None:
    assert [each.found for each in lex("$$ @ %").mistakes] == ["$$", "@", "%"]
