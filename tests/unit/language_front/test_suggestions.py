"""How near words are, and which of several near ones is suggested."""

import pytest

from language.suggestions import (
    Everyday,
    Suggestion,
    edit_distance,
    everyday,
    fillers_of,
    is_near,
    joining_word,
    nearest,
    nearest_keyword,
    nearest_pair,
    number_in_digits,
    pair_ending_with,
)
from language.tables import TERMINALS


@pytest.mark.parametrize(
    ("one", "other", "edits"),
    [
        ("", "", 0),
        ("", "abc", 3),
        ("abc", "", 3),
        ("abc", "abc", 0),
        ("a", "b", 1),
        ("ab", "ba", 1),
        ("abcd", "acbd", 1),
        ("abcd", "abdc", 1),
        ("abc", "cba", 2),
        ("ab", "bca", 3),
        ("kitten", "sitting", 3),
        ("saturday", "sunday", 3),
    ],
)
def test_a_distance_counts_letters_to_add_drop_change_or_exchange(one: str, other: str, edits: int) -> None:
    assert (edit_distance(one, other), edit_distance(other, one)) == (edits, edits)


@pytest.mark.parametrize(("letters", "edits"), [(1, 0), (2, 1), (6, 1), (7, 2), (8, 2), (9, 3), (30, 3)])
def test_a_longer_word_may_have_more_wrong_letters(letters: int, edits: int) -> None:
    word = "a" * letters

    assert is_near(word, word + "b" * edits)
    assert not is_near(word, word + "b" * (edits + 1))


@pytest.mark.parametrize(
    ("word", "candidates", "preferred", "found"),
    [
        # two letters only exchanged, and no wrong letter in a word of three
        ("wf", ["fw"], (), "fw"),
        ("fx", ["fw"], (), None),
        ("fwd", ["fw"], (), "fw"),
        ("acb", ["abc"], (), "abc"),
        ("abd", ["abc"], (), None),
        ("abc", ["abcd"], (), "abcd"),
        ("abcx", ["abcd"], (), "abcd"),
        ("abcx", ["abc"], (), "abc"),
        ("abx", ["abcd"], (), None),
        # the fewest edits, then a preferred one, then the same first letter, then the first
        ("horses", ["horse", "horsess"], (), "horse"),
        ("horse", ["morse", "horst"], (), "horst"),
        ("horse", ["horst", "morse"], ("morse",), "morse"),
        ("horse", ["horst", "horsy"], (), "horst"),
        ("horsefly", ["horsefyy", "horseflies"], ("horseflies",), "horsefyy"),
        ("HÓRSE", ["Horst"], (), "Horst"),
        ("a" * 40, ["a" * 41], (), "a" * 41),
        ("a" * 41, ["a" * 41], (), None),
        ("horse", [], (), None),
    ],
)
def test_the_nearest_of_several_words_is_suggested(
    word: str, candidates: list[str], preferred: tuple[str, ...], found: str | None
) -> None:
    assert nearest(word, candidates, preferred) == found


@pytest.mark.parametrize(
    ("line", "spoken", "found"),
    [
        ("walk 3", "", Everyday("FW", "en", 1)),
        ("walk", "", Everyday("FW", "en", 1)),
        ("turn around", "", Everyday("TR", "en", 2, "180")),
        ("turn left 30", "", Everyday("TL", "en", 2)),
        ("turn 30 left", "", Everyday("TL", "en", 3, "30")),
        ("turn thirty left", "", Everyday("TL", "en", 3, "30")),
        ("ande 3 passos para tras", "", Everyday("BW", "pt", 5, "3")),
        ("andar", "es", Everyday("FW", "es", 1)),
        ("andar", "pt", Everyday("FW", "pt", 1)),
        ("jump", "", None),
        ("3 walk", "", None),
        ("turn 30 40 left", "", Everyday("TR", "en", 1)),
        ("turn 30 left 40", "", Everyday("TR", "en", 1)),
        ("turn 30 left forty", "", Everyday("TL", "en", 3, "30")),
        ("", "", None),
        # the first eight words are compared
        ("turn the the the the the the left", "", Everyday("TL", "en", 8)),
        ("turn the the the the the the the left", "", Everyday("TR", "en", 1)),
    ],
)
def test_an_everyday_phrase_takes_its_words_and_one_number(
    line: str, spoken: str, found: Everyday | None
) -> None:
    assert everyday(line.split(), spoken.split()) == found


@pytest.mark.parametrize(
    ("word", "found"),
    [
        ("fw3", Suggestion("FW 3", "FW", complete=True)),
        ("PF10", Suggestion("PF 10", "FW", complete=True)),
        ("repeat3", Suggestion("REPEAT 3", "REPEAT", complete=True)),
        ("posx", Suggestion("POS X", "POS", complete=True)),
        ("colorred", Suggestion("COLOR RED", "COLOR", complete=True)),
        ("distancef", Suggestion("DISTANCE F", "DISTANCE", complete=True)),
        ("soundon", Suggestion("SOUND ON", "SOUND", complete=True)),
        ("endif", Suggestion("END IF", "END_IF")),
        ("ParaTr\u00e1s", Suggestion("PARA TR\u00c1S", "BW")),
        ("righturn", Suggestion("RIGHT TURN", "TR")),
        ("distanceq", Suggestion("DISTANCE", "DISTANCE")),
        ("fw", None),
        ("DISTANCIA", None),
        ("fw3x", None),
        ("x3", None),
        ("poz", None),
        ("", None),
        ("distance" + "f" * 33, None),
    ],
)
def test_a_keyword_is_found_without_its_blank_too(word: str, found: Suggestion | None) -> None:
    assert nearest_keyword(word, frozenset(TERMINALS), "en") == found


@pytest.mark.parametrize("word", ["fw3", "posx", "soundon", "endif", "repet", "colorred"])
def test_only_a_keyword_that_fits_is_suggested(word: str) -> None:
    assert nearest_keyword(word, frozenset({"BW", "WHILE"}), "en") is None


@pytest.mark.parametrize(
    ("word", "language", "text"),
    [
        ("repitar", "pt", "REPITA"),
        ("repitar", "es", "REPETIR"),
        ("repitir", "es", "REPETIR"),
        ("procedimento", "pt", "APRENDER"),
        ("procedimento", "es", "PROCEDIMIENTO"),
        ("procedimento", "en", "PROCEDIMIENTO"),
        ("procedur", "pt", "APRENDER"),
        ("procedur", "en", "PROCEDURE"),
    ],
)
def test_a_keyword_is_suggested_in_the_language_of_the_program(word: str, language: str, text: str) -> None:
    found = nearest_keyword(word, frozenset({"REPEAT", "PROCEDURE"}), language)

    assert found is not None
    assert found.text == text


@pytest.mark.parametrize(
    ("second", "terminals", "text"),
    [
        ("direita", "TR TL", "GIRAR DIREITA"),
        ("TR\u00c1S", "BW", "PARA TR\u00c1S"),
        ("direita", "TL", None),
        ("turn", "TR TL", None),
        ("if", "END_IF", None),
        ("jump", "TR", None),
    ],
)
def test_a_second_word_alone_means_its_only_keyword(second: str, terminals: str, text: str | None) -> None:
    found = pair_ending_with(second, frozenset(terminals.split()))

    assert (found.text if found else None) == text


@pytest.mark.parametrize(
    ("first", "second", "text"),
    [
        ("gira", "direita", "GIRAR DIREITA"),
        ("GIRRA", "IZQUIERDA", "GIRAR IZQUIERDA"),
        ("jump", "direita", None),
        ("gira", "jump", None),
        ("g" * 41, "direita", None),
    ],
)
def test_a_pair_is_meant_by_its_second_word_and_a_first_one_that_is_near(
    first: str, second: str, text: str | None
) -> None:
    found = nearest_pair(first, second, frozenset({"TR", "TL"}))

    assert (found.text if found else None) == text


@pytest.mark.parametrize(
    ("word", "digits"),
    [
        ("two", "2"),
        ("DOIS", "2"),
        ("tr\u00eas", "3"),
        ("diez", "10"),
        ("noventa", "90"),
        ("x", ""),
        ("2", ""),
    ],
)
def test_a_number_in_letters_has_its_digits(word: str, digits: str) -> None:
    assert number_in_digits(word) == digits


@pytest.mark.parametrize(
    ("word", "code"),
    [
        ("and", "second-comparison"),
        ("y", "second-comparison"),
        ("or", "other-comparison"),
        ("ou", "other-comparison"),
        ("not", ""),
        ("AND", ""),
    ],
)
def test_a_folded_word_joins_two_comparisons(word: str, code: str) -> None:
    assert joining_word(word) == code


def test_fillers_are_folded_words_of_one_language() -> None:
    assert {"the", "steps"} <= fillers_of("en")
    assert "pasos" in fillers_of("es")
    assert not {"walk", "pasos"} & fillers_of("en")
