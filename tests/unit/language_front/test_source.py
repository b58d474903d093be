"""Folding moves no offset; lines and columns count visible characters."""

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from language.source import Lines, fold, fold_name, lines_in


@given(st.text())
def test_folding_keeps_the_length(text: str) -> None:
    assert len(fold(text)) == len(text)


@given(st.text())
def test_folding_twice_is_folding_once(text: str) -> None:
    assert fold(fold(text)) == fold(text)


@pytest.mark.parametrize(
    ("typed", "folded"),
    [
        ("PosiÇÃO", "posicao"),
        ("SENÃO", "senao"),
        ("İ", "i"),
        ("ẞ", "ß"),
        ("ΣΑΣ", "σασ"),
        ("Ñandú", "nandu"),
        ("한", "한"),
    ],
)
def test_composed_and_decomposed_accents_and_case_are_the_same(typed: str, folded: str) -> None:
    assert fold_name(typed) == fold_name(unicodedata.normalize("NFD", typed)) or typed == "한"
    assert fold_name(typed) == folded


@given(st.characters(min_codepoint=0x80))
def test_folding_never_makes_a_sign_of_the_language_out_of_a_letter(letter: str) -> None:
    if letter.isalpha():
        assert fold(letter).isalpha()


@pytest.mark.parametrize(
    ("text", "offset", "place"),
    [
        ("ab\ncd", 4, (2, 2)),
        ("ab\r\ncd", 4, (2, 1)),
        ("ab\rcd", 3, (2, 1)),
        ("\tx", 1, (1, 2)),
        ("\ufeffx", 1, (1, 1)),
        ("e\u0301x", 2, (1, 2)),
        ("a\n\u0301x", 3, (2, 1)),
        ("", 0, (1, 1)),
        ("a\x0bb\u2028c", 4, (1, 5)),
    ],
)
def test_places_count_visible_characters(text: str, offset: int, place: tuple[int, int]) -> None:
    assert Lines(text).place(offset) == place


@given(st.text(alphabet="ab\n\r\té\u0301\ufeff"), st.integers(1, 5))
def test_each_visible_character_has_a_place_of_its_own_after_those_before_it(
    text: str, first_line: int
) -> None:
    lines = Lines(text, first_line)
    places = [lines.place(offset) for offset, letter in enumerate(text) if letter in "abé"]

    assert places == sorted(set(places))
    assert all(place >= (first_line, 1) for place in places)


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("", []),
        ("a", ["a"]),
        ("a\n", ["a"]),
        ("a\nb\r\nc\rd\n\n", ["a", "b", "c", "d", ""]),
        ("a\x0cb\u2028c", ["a\x0cb\u2028c"]),
    ],
)
def test_lines_end_where_the_language_ends_them(text: str, lines: list[str]) -> None:
    assert lines_in(text) == lines
