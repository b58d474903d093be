"""The words that may stand at the cursor."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from donnie_tui.core.program_text import completion


def words(text: str, language: str = "en", colours: tuple[str, ...] | None = None) -> tuple[str, ...]:
    """The words for the place of the bar in the text, or for its end."""
    at = text.find("|")
    return completion(text.replace("|", ""), at if at >= 0 else len(text), language, colours).words


@pytest.mark.parametrize(
    ("text", "language", "first"),
    [
        ("REP", "en", "REPEAT"),
        ("rep", "en", "repeat"),
        ("VAR distance_left = 3\ndistance_l", "en", "distance_left"),
        ("REPI", "pt", "REPITA"),
        ("HABL", "es", "HABLAR"),
        ("COLOR r", "en", "RED"),
        ("PROCEDURE Square: n DO END PROCEDURE\nSq", "en", "Square"),
        ("IF 1 == 1 DO REPEAT 3 TIMES\nFW 1\nEND", "en", "END REPEAT"),
        ("IF 1 == 1 DO REPEAT 3 TIMES\nEND REPEAT\nEND", "en", "END IF"),
        ("REPITA 3 VEZES\nFI", "pt", "FIM REPITA"),
    ],
)
def test_the_likely_word_comes_first(text: str, language: str, first: str) -> None:
    assert words(text, language)[0] == first


def test_only_possible_arguments_are_offered_after_a_keyword() -> None:
    assert set(words("BELT ")) == {"ON", "OFF"}
    assert "FW" not in words("SPEAK DISTANCE ")


def test_colours_that_the_robot_can_t_see_are_not_offered() -> None:
    assert words("COLOR ", colours=("red", "green")) == ("RED", "GREEN")


@pytest.mark.parametrize("text", ['SPEAK "re', "-- re", "FW 1 -- re"])
def test_nothing_is_offered_inside_texts_and_comments(text: str) -> None:
    assert words(text) == ()


def test_the_word_at_the_cursor_is_not_offered() -> None:
    assert "FW" not in words("FW")


@given(st.text(alphabet='FW rep"\n-[]:=é1', max_size=60), st.integers(0, 60))
def test_completion_accepts_any_text(text: str, at: int) -> None:
    found = completion(text, min(at, len(text)), "en")

    assert all(isinstance(each, str) and each for each in found.words)
