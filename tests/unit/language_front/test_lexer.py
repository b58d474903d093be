"""Text to tokens."""

import pytest

from language.lexer import language_of, languages_in, lex, without_comments
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
        ("FIM PARA = 1", "END_FOR ASSIGN NUMBER"),
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
        ("COLOR red = 3", "COLOR COLOUR ASSIGN NUMBER"),
        ("SOUND on [1]", "SOUND SWITCH LSQB NUMBER RSQB"),
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
        ("a <\u0301 b \u226e c", "NAME NAME NAME"),
        ("'a' $$ x'", "STRING NAME"),
        ("\u2018a\u2019 x", "STRING NAME"),
        ("5x _y 7", "NAME NAME NUMBER"),
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


def test_the_words_of_the_gripper_have_their_places() -> None:
    tokens = lex("x\n  GRIP = 1 Solt\u0301ar").tokens

    assert [(token[1], token[2], token[3], token[4]) for token in tokens] == [
        (0, 1, 1, 1), (4, 8, 2, 3), (9, 10, 2, 8), (11, 12, 2, 10), (13, 20, 2, 12),
    ]  # fmt: skip


def test_comments_know_the_next_token() -> None:
    comments = lex("-- a\nFW -- b\n1 -- c").comments

    assert [(each.line, each.before) for each in comments] == [(1, 0), (2, 1), (3, 2)]


def test_leading_zeros_do_not_count_for_the_limit_of_digits() -> None:
    lexed = lex("0" * 5000 + "7" * 4300)
    assert lexed.mistakes == []
    assert lex("7" * 4301).mistakes[0].kind.value == "number-too-large"


def test_adjacent_unreadable_characters_are_one_mistake() -> None:
    assert [each.found for each in lex("$$ @ %").mistakes] == ["$$", "@", "%"]


@pytest.mark.parametrize(
    ("source", "comments"),
    [
        ("-- a\n–b―c\n—", [(0, 4, 3, 0), (5, 9, 4, 0), (10, 11, 5, 0)]),
        ("SOUND -- x\non -- y", [(6, 10, 3, 1), (14, 18, 4, 2)]),
        ("FIM -- x\n SE y -- z", [(4, 8, 3, 1), (15, 19, 4, 2)]),
        ("― only", [(0, 6, 3, 0)]),
    ],
)
def test_comments_have_their_places(source: str, comments: list[tuple[int, int, int, int]]) -> None:
    found = lex(source, 3).comments

    assert [(each.start, each.end, each.line, each.before) for each in found] == comments


@pytest.mark.parametrize(
    ("source", "mistakes", "flaws"),
    [
        ("FW 1 $ 2", [("$", 3, 6)], [2]),
        ("FW $$ 2\n# c $ d\nFW 1", [("$$", 3, 4), ("#", 4, 1)], [1]),
        ("FW 2 // x", [("//", 3, 6)], []),
        ("//\n//x\n /", [("//", 3, 1), ("//", 4, 1)], []),
        ("a#b", [("#", 3, 2)], [1]),
        ("# $", [("#", 3, 1)], []),
        ("$#", [("$#", 3, 1)], [0]),
        ("FW 2//x", [], []),
        ("FW 2 //x", [], []),
        ("FW '$' $", [("'$'", 3, 4), ("$", 3, 8)], [1, 2]),
        ("5x 3", [("5x", 3, 1)], [0]),
        ("5x$", [("5x", 3, 1), ("$", 3, 3)], [0, 1]),
        ("$5x", [("$", 3, 1), ("5x", 3, 2)], [0, 0]),
        ('$"a', [("$", 3, 1), ('"a', 3, 2)], [0, 0]),
        ("VAR _a", [("_a", 3, 5)], [1]),
        ('SPEAK "a\rFW $', [('"a', 3, 7), ("$", 4, 4)], [1, 3]),
        ("é$ ​$", [("$", 3, 2), ("$", 3, 4)], [1, 1]),
    ],
)
def test_a_flaw_is_at_the_token_that_it_spoils(
    source: str, mistakes: list[tuple[str, int, int]], flaws: list[int]
) -> None:
    """The comment of another language spoils none."""
    lexed = lex(source, 3)

    assert [(each.found, each.span.line, each.span.column) for each in lexed.mistakes] == mistakes
    assert lexed.flaws == flaws


def test_the_colours_are_the_words_after_color() -> None:
    lexed = lex("POS x SOUND on red COLOR red FALAR COR azul COLOR purple COLOR -- c\ngreen", 2)

    assert [(token[5], token[3]) for token in lexed.colours] == [("red", 2), ("azul", 2), ("green", 3)]


@pytest.mark.parametrize(
    ("blamed", "strings", "open_quote"),
    [
        (None, ['"a"', '"b\nfw 1 "'], None),
        (6, ['"a" "b', '"c'], 18),
        (10, ['"a"', '"b', '"c'], 18),
    ],
)
def test_a_blamed_quotation_mark_begins_a_string_that_ends_with_its_line(
    blamed: int | None, strings: list[str], open_quote: int | None
) -> None:
    lexed = lex('SPEAK "a" "b\nFW 1 "c', 1, blamed)

    assert [token[5] for token in lexed.tokens if TERMINALS[token[0]] == "STRING"] == strings
    assert lexed.open_quote == open_quote


def test_what_stands_for_no_character_is_blank_and_has_no_width() -> None:
    for unseen in "﻿​‌‍‎‏⁠":
        assert [token[3:] for token in lex(f"{unseen}FW{unseen}1").tokens] == [(1, 1, "fw"), (1, 3, "1")]


@pytest.mark.parametrize("sign", ["‐", "‑", "−"])
def test_a_hyphen_or_a_minus_sign_is_a_sign(sign: str) -> None:
    assert [token[5] for token in lex(f"5{sign}3").tokens] == ["5", "-", "3"]


@pytest.mark.parametrize(
    ("source", "most", "any_of"),
    [
        ("", "en", "en"),
        ("x = 1", "en", "en"),
        ("FW 1", "en", "en"),
        ("PF 1 AV 1 AV 2", "es", "es pt"),
        ("AV 1 PF 1", "pt", "es pt"),
        ("AV 1 PF 1 DISTANCIA F", "es", "es pt"),
        ("DISTANCIA F", "es", "es"),
        ("DISTÂNCIA F", "pt", "pt"),
        ("COLOR azul", "es", "es"),
        ("COLOR blue", "en", "en"),
        ("AV 1 DISTÂNCIA F", "es", "es"),
        ("AV 1 AV 1 FW 1 FW 1 FW 1 PF 1", "en", "en es pt"),
        ('SPEAK "pf"', "en", "en"),
        ("pf pf = 1 fw 1 bw 2", "en", "en pt"),
        ("FIM", "en", "en"),
        ("GIRAR DIREITA 90", "pt", "pt"),
        ("GIRAR -- c\nIZQUIERDA 90", "es", "es"),
        ("FW -- pf\nAV 1", "en", "en es"),
    ],
)
def test_the_language_of_a_text_is_that_of_most_keywords(source: str, most: str, any_of: str) -> None:
    """Accents decide between languages with as many."""
    tokens = lex(source).tokens

    assert language_of(tokens, source) == most
    assert sorted(languages_in(tokens, source)) == any_of.split()


def test_without_the_text_the_first_of_equal_languages_is_taken() -> None:
    assert language_of(lex("DISTANCIA F").tokens) == "pt"


def test_a_comment_is_left_out_up_to_the_end_of_its_line() -> None:
    assert without_comments("end -- x\nif —y") == "end \nif "


def test_only_a_number_that_is_too_large_has_a_limit() -> None:
    mistakes = lex(f'$ 5x {"9" * 4301} "a').mistakes

    assert [(each.kind.value, dict(each.details)) for each in mistakes] == [
        ("unknown-character", {}),
        ("invalid-name", {}),
        ("number-too-large", {"limit": 4300}),
        ("unterminated-string", {}),
    ]
