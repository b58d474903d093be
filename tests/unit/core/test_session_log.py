"""Answers can be repeated, searched, spelled and saved. Their memory is bounded."""

import pytest

from donnie_tui.core.session_log import AnswerLog, found_in_words, letter_by_letter, none_so_far
from donnie_tui.i18n.words import Words


def log(*answers: tuple[str, ...]) -> AnswerLog:
    made = AnswerLog()
    for answer in answers:
        made.add(answer)
    return made


def test_the_last_answer_is_number_one() -> None:
    made = log(("a",), ("b", "c"))

    assert [made.last(), made.last(2), made.last(3), made.last(0)] == [("b", "c"), ("a",), (), ()]


def test_an_empty_answer_is_not_remembered() -> None:
    assert len(log((), ("a",), ())) == 1


def test_the_newest_lines_are_kept_of_many_and_long_answers() -> None:
    made = log(*((str(number),) for number in range(1005)), tuple(map(str, range(203))))

    assert len(made) == 1000
    assert made.last() == tuple(map(str, range(3, 203)))
    made = log(*((str(number),) for number in range(999)))
    made.end_answer()
    for number in range(201):
        made.add_line(str(number))
    assert (len(made), made.last(1000), made.last()[0]) == (1000, ("0",), "1")


def test_a_search_ignores_case_and_accents_and_lists_the_newest_last() -> None:
    made = log(("O Robô andou.",), ("nada",), ("robo parado",))

    assert made.found("ROBÔ") == ("O Robô andou.", "robo parado")
    assert made.found("xyz") == ()
    assert log(*((f"wall {n}",) for n in range(99))).found("wall")[::19] == ("wall 79", "wall 98")


def test_lines_that_arrive_one_by_one_are_one_answer_until_it_ends() -> None:
    made = log(("before",))
    for line in ("a", "b"):
        made.add_line(line)
    made.end_answer()
    made.add_line("c")

    assert [made.last(), made.last(2), made.last(3)] == [("c",), ("a", "b"), ("before",)]


def test_an_answer_that_is_printed_in_pieces_is_one_answer() -> None:
    made = log()
    for piece in (["a"], [], ["b", "c"]):
        made.add_lines(piece)
    made.end_answer()

    assert [made.last(), made.last(2)] == [("a", "b", "c"), ()]


def test_an_answer_has_begun_from_its_first_line_to_its_end() -> None:
    made = log(("before",))
    begun = [made.has_begun]
    made.add_line("a")
    begun.append(made.has_begun)
    made.end_answer()

    assert [*begun, made.has_begun] == [False, True, False]


@pytest.mark.parametrize(
    ("answers", "said"),
    [
        ((), "Nothing has been said yet."),
        ((("a",),), "1 answer so far."),
        ((("a",), ("b", "c")), "2 answers so far."),
    ],
)
def test_that_there_is_no_such_answer_is_said_with_how_many_there_are(
    answers: tuple[tuple[str, ...], ...], said: str
) -> None:
    assert none_so_far(log(*answers), Words()) == said


def test_the_whole_log_as_text_has_one_line_per_entry() -> None:
    assert log(("a", "b"), ("c",)).text() == "a\nb\nc\n"


@pytest.mark.parametrize(
    ("language", "text", "said"),
    [
        ("en", "Fw 3.", "capital F, w, blank, 3, full stop."),
        ("pt", "á b", "á, espaço, b."),
        ("es", "A", "mayúscula A."),
        ("pt", "[.", "abre colchetes, ponto."),
        ("es", "[_", "corchete que abre, guion bajo."),
    ],
)
def test_spelling_names_capitals_blanks_and_signs(language: str, text: str, said: str) -> None:
    assert letter_by_letter(text, Words(language)) == (said,)


SIGNS = {
    **{"=": "equals sign", "<": "less-than sign", ">": "greater-than sign", "+": "plus sign"},
    **{"-": "minus sign", "*": "star", "/": "slash", "\\": "backslash", "_": "underscore", "^": "caret"},
    **{"(": "opening parenthesis", ")": "closing parenthesis", "[": "opening bracket"},
    **{"]": "closing bracket", "{": "opening brace", "}": "closing brace", ",": "comma", ":": "colon"},
    **{";": "semicolon", ".": "full stop", "!": "exclamation mark", "?": "question mark"},
    **{"#": "hash sign", "$": "dollar sign", "%": "percent sign", "&": "ampersand", "@": "at sign"},
    **{"'": "apostrophe", "\u2019": "apostrophe", "\u2018": "apostrophe", "`": "grave accent"},
    **{'"': "quotation mark", "\u201c": "quotation mark", "\u201d": "quotation mark"},
    **{"|": "vertical bar", "~": "tilde"},
}


@pytest.mark.parametrize("sign", SIGNS)
def test_each_sign_is_spelled_by_its_name(sign: str) -> None:
    assert letter_by_letter(sign, Words()) == (f"{SIGNS[sign]}.",)


def test_a_long_word_is_spelled_in_lines_for_a_braille_display() -> None:
    lines = letter_by_letter("abcdefghij" * 5, Words())

    assert max(map(len, lines)) <= 40
    assert "".join(each for line in lines for each in line if each.isalpha()) == "abcdefghij" * 5


@pytest.mark.parametrize(("text", "lines"), [("/abcdefghijk", 1), ("#abcdefghij", 2), ("abcdefghijklm", 1)])
def test_a_line_of_spelling_has_38_characters_at_most(text: str, lines: int) -> None:
    """And a full stop: "slash" and eleven letters are 38 with commas and blanks, "hash sign" and ten 39."""
    assert len(letter_by_letter(text, Words())) == lines


def test_of_a_long_text_the_first_two_hundred_characters_are_spelled() -> None:
    assert sum(line.count("a") for line in letter_by_letter("a" * 201, Words())) == 200
    assert letter_by_letter("a\u0301", Words("pt")) == ("\u00e1.",)


def test_nothing_has_no_letters() -> None:
    assert letter_by_letter("", Words()) == ("Nothing has been said yet.",)


@pytest.mark.parametrize(
    ("answers", "said", "word"),
    [
        ((), "", ""),
        ((("a b",),), "a b", "b"),
        ((("a", "The sum is 7."),), "The sum is 7.", "7"),
        ((("a box",),), "a box", "box"),
    ],
)
def test_the_last_word_is_that_of_the_last_line(
    answers: tuple[tuple[str, ...], ...], said: str, word: str
) -> None:
    assert (log(*answers).last_line(), log(*answers).last_word()) == (said, word)


def test_what_was_not_said_is_quoted_up_to_forty_characters() -> None:
    found = found_in_words(log(("a word",)), "w" * 41, Words())

    assert found == (f"I have not said {'w' * 39}….",)
    assert found_in_words(log(("a word",), ("word",)), "WORD", Words())[1:] == ("a word", "word")
