"""Folding moves no offset; lines and columns count visible characters."""

import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from language.source import Lines, cleaned, fold, fold_name, lines_in, printable, with_newlines


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


@pytest.mark.parametrize(
    ("typed", "folded"),
    [
        ("ABC é", "abc e"),
        ("e\u0301\u0308", "e\u0300\u0300"),
        ("\u2260", "\u2260"),
        ("=\u0338", "=\u0300"),
        ("\u00bd", "\u00bd"),
        ("\u212b", "a"),
        ("\u01c5", "\u01c6"),
        ("\u0390", "\u03b9"),
        ("\ufeff\u200b\u200c\u200d\u200e\u200f\u2060", "\u200b" * 7),
        ("\u2010\u2011\u2212", "---"),
        ("\u2013\u2014\u2015", "\u2013\u2014\u2014"),
    ],
)
def test_only_letters_lose_their_marks(typed: str, folded: str) -> None:
    assert fold(typed) == folded


@pytest.mark.parametrize(
    ("text", "line", "lines"),
    [
        ("abc é", "abc é", "abc é"),
        ("a\tb\r\nc", "a b  c", "a\tb\r\nc"),
        ("a\x00b\x1b[1m\x7f\x9f", "a b [1m  ", "a b [1m  "),
        ("\u2028\u2029\u202a\u202e\u2066\u2069\ud800\udfff", " " * 8, " " * 8),
        ("a\u00a0\u2003b\x1f\x20\x80\xa1", "a\u00a0\u2003b   \xa1", "a\u00a0\u2003b   \xa1"),
        ("", "", ""),
    ],
)
def test_what_could_control_a_terminal_is_a_blank(text: str, line: str, lines: str) -> None:
    assert printable(text) == line
    assert cleaned(text) == lines


def test_the_line_breaks_of_a_text_become_one_kind() -> None:
    assert with_newlines("a\r\nb\rc\nd\n\re") == "a\nb\nc\nd\n\ne"


def test_places_count_from_the_first_line_given() -> None:
    lines = Lines("ab\ncd", 7)

    assert [lines.place(offset) for offset in range(5)] == [(7, 1), (7, 2), (7, 3), (8, 1), (8, 2)]
