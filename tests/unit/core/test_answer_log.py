"""What was said can be said again, searched, spelled and saved; the memory of it is bounded."""

import pytest

from donnie_tui.core.answer_log import KEPT, LONGEST_ANSWER, MOST_FOUND, AnswerLog, spelled
from donnie_tui.i18n.catalogue.signs import SPELLED_OF
from donnie_tui.i18n.words import Words


def log(*answers: tuple[str, ...]) -> AnswerLog:
    made = AnswerLog()
    for answer in answers:
        made.add(answer)
    return made


def test_the_last_answer_is_number_one() -> None:
    made = log(("a",), ("b", "c"))

    assert [made.last(), made.last(2), made.last(3), made.last(0)] == [("b", "c"), ("a",), (), ()]


def test_an_empty_answer_is_none() -> None:
    assert len(log((), ("a",), ())) == 1


def test_of_very_many_and_very_long_answers_the_newest_lines_are_kept() -> None:
    made = log(*((str(number),) for number in range(KEPT + 5)), tuple(map(str, range(LONGEST_ANSWER + 3))))

    assert len(made) == KEPT == 1000
    assert made.last()[0] == "3"


def test_words_are_found_in_any_case_and_without_accents_the_newest_last() -> None:
    made = log(("O Robô andou.",), ("nada",), ("robo parado",))

    assert made.found("ROBÔ") == ("O Robô andou.", "robo parado")
    assert made.found("xyz") == ()
    assert len(log(*((f"wall {n}",) for n in range(99))).found("wall")) == MOST_FOUND


def test_lines_that_come_one_by_one_are_one_answer_until_it_ends() -> None:
    made = log(("before",))
    for line in ("a", "b"):
        made.add_line(line)
    made.end_answer()
    made.add_line("c")

    assert [made.last(), made.last(2), made.last(3)] == [("c",), ("a", "b"), ("before",)]


def test_what_is_told_again_is_not_remembered_twice() -> None:
    made = log(("a", "b"), ("c",))
    for line in (*made.again(2), "d"):
        made.add_line(line)

    assert [made.last(), made.last(2), made.last(3)] == [("d",), ("c",), ("a", "b")]


def test_all_of_it_as_text_is_a_line_each() -> None:
    assert log(("a", "b"), ("c",)).text() == "a\nb\nc\n"


@pytest.mark.parametrize(
    ("language", "text", "told"),
    [
        ("en", "Fw 3.", "capital F, w, blank, 3, full stop."),
        ("pt", "á b", "á, espaço, b."),
        ("es", "A", "mayúscula A."),
        ("pt", "[.", "abre colchetes, ponto."),
        ("es", "[_", "corchete que abre, guion bajo."),
    ],
)
def test_spelling_names_capitals_blanks_and_signs(language: str, text: str, told: str) -> None:
    assert spelled(text, SPELLED_OF, Words(language)) == (told,)


def test_a_long_word_is_spelled_in_lines_for_a_braille_display() -> None:
    lines = spelled("abcdefghij" * 5, SPELLED_OF, Words())

    assert max(map(len, lines)) <= 40
    assert "".join(each for line in lines for each in line if each.isalpha()) == "abcdefghij" * 5
