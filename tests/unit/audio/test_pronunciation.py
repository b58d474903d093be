"""Signs in words, in each language."""

import pytest

from devices.audio.pronunciation import sign_words, speakable_text
from donnie_tui.outlets.audible import spoken_languages


def spoken(text: str, language: str, punctuation: str = "some") -> str:
    return speakable_text(text, sign_words(language, spoken_languages()), punctuation)


@pytest.mark.parametrize(
    ("printed", "english", "portuguese", "spanish"),
    [
        ("x=-3", "x equals minus 3", "x igual a menos 3", "x igual a menos 3"),
        ("-3", "minus 3", "menos 3", "menos 3"),
        ("At -4, 1.", "At minus 4, 1.", "At menos 4, 1.", "At menos 4, 1."),
        ("(-2)", "( minus 2)", "( menos 2)", "( menos 2)"),
        ("5-3", "5 minus 3", "5 menos 3", "5 menos 3"),
        ("x-3", "x minus 3", "x menos 3", "x menos 3"),
        ("x - 3", "x minus 3", "x menos 3", "x menos 3"),
        ("-x", "minus x", "menos x", "menos x"),
        ("\u22123", "minus 3", "menos 3", "menos 3"),
        ("90°", "90 degrees", "90 graus", "90 grados"),
        ("1°", "1 degree", "1 grau", "1 grado"),
        ("-90 °", "minus 90 degrees", "menos 90 graus", "menos 90 grados"),
        ("3.5", "3 point 5", "3 vírgula 5", "3 coma 5"),
        ("3.14.", "3 point 1 4.", "3 vírgula 14.", "3 coma 14."),
        ("1.05", "1 point 0 5", "1 vírgula 0 5", "1 coma 0 5"),
        ("a<=b", "a less than or equal to b", "a menor ou igual a b", "a menor o igual que b"),
        ("a <> b", "a different from b", "a diferente de b", "a diferente de b"),
        ("2*3", "2 times 3", "2 vezes 3", "2 por 3"),
        ("2 + 3", "2 plus 3", "2 mais 3", "2 más 3"),
        ("6/3", "6 divided by 3", "6 dividido por 3", "6 dividido por 3"),
    ],
)
def test_signs_are_said_in_words(printed: str, english: str, portuguese: str, spanish: str) -> None:
    said = tuple(spoken(printed, language) for language in ("en", "pt", "es"))

    assert said == (english, portuguese, spanish)


@pytest.mark.parametrize(
    "text",
    [
        "Facing north.",
        "I walked only 3 steps forward. I found an obstacle.",
        "Red box: 2 left, 5 ahead.",
        "well-known",
        "and/or",
        "version 1.2.3",
        "- item",
        "C++",
        "10 %",
        "1º lugar",
        "",
    ],
)
@pytest.mark.parametrize("language", ["en", "pt", "es", "pt-BR"])
def test_plain_words_are_said_as_they_are_printed(text: str, language: str) -> None:
    assert spoken(text, language) == text


def test_a_region_changes_nothing() -> None:
    assert spoken("x=-3", "pt-BR") == spoken("x=-3", "pt_BR") == spoken("x=-3", "pt")


def test_signs_in_an_unknown_language_are_not_spelled_out() -> None:
    assert spoken("x=-3, 90°", "fr") == "x=-3, 90°"


def test_control_characters_and_broken_surrogates_never_reach_a_voice() -> None:
    assert spoken("a\x00b\x1b[2Jc\ud800d\u200be", "en").encode("utf-8") == b"a b [2Jc d e"


def test_marks_of_direction_never_reach_a_voice() -> None:
    assert spoken("a\u2066b\u2069c\u202ed", "en") == "a b c d"


def test_a_long_number_is_looked_through_once() -> None:
    """When each digit was tried as the first one before a degree sign, this took minutes."""
    assert spoken("1" * 100_000, "en") == "1" * 100_000


def test_the_punctuation_setting_decides_which_signs_are_spelled_out() -> None:
    line = 'IF x <= 3, "y"'
    assert spoken(line, "en", "none") == 'IF x <= 3, "y"'
    assert spoken(line, "en", "some") == 'IF x less than or equal to 3, "y"'
    assert spoken(line, "en", "all") == "IF x less than or equal to 3 comma quote y quote"
    assert spoken("(1)", "pt", "all") == "abre parêntese 1 fecha parêntese"
