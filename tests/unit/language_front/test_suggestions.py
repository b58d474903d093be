"""How near words are, and which of several near ones is suggested."""

import pytest

from language.suggestions import Everyday, edit_distance, everyday, is_near, nearest


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
