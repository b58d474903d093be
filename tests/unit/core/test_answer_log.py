"""Answers can be repeated, searched, spelled and saved. Their memory is bounded."""

import pytest

from donnie_tui.core.answer_log import KEPT, LONGEST_ANSWER, MOST_FOUND, AnswerLog, spelled
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
    made = log(*((str(number),) for number in range(KEPT + 5)), tuple(map(str, range(LONGEST_ANSWER + 3))))

    assert len(made) == KEPT == 1000
    assert made.last()[0] == "3"


def test_a_search_ignores_case_and_accents_and_lists_the_newest_last() -> None:
    made = log(("O Robô andou.",), ("nada",), ("robo parado",))

    assert made.found("ROBÔ") == ("O Robô andou.", "robo parado")
    assert made.found("xyz") == ()
    assert len(log(*((f"wall {n}",) for n in range(99))).found("wall")) == MOST_FOUND


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


def test_a_repeated_answer_is_not_remembered_twice() -> None:
    made = log(("a", "b"), ("c",))
    for line in (*made.again(2), "d"):
        made.add_line(line)

    assert [made.last(), made.last(2), made.last(3)] == [("d",), ("c",), ("a", "b")]


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
    assert spelled(text, Words(language)) == (said,)


def test_a_long_word_is_spelled_in_lines_for_a_braille_display() -> None:
    lines = spelled("abcdefghij" * 5, Words())

    assert max(map(len, lines)) <= 40
    assert "".join(each for line in lines for each in line if each.isalpha()) == "abcdefghij" * 5
