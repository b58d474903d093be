"""Any world file loads or is a mistake with a place in the text."""

from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st

import worlds
from sim.worldfile import WorldError, load_text
from tests.effort import examples

TEXT = """
model position ranger sensor blobfinder block window define include pose size origin color bitmap boundary
points point[0] point[1] point[2] z range fov samples name unit_length unit_angle colors colors_count
( ) [ ] 0 1 -1 3 4 1e9 1e-9 .5 1e400 90 "red" "cm" "x" "" " # chair a b gripper camera
"""
WORDS = [*TEXT.split(), "\n"]
DONNIE = (Path(worlds.SCENES) / "donnie.inc").read_text(encoding="utf-8") + '\ndonnie( name "donnie" )\n'


def loads_or_is_a_mistake(text: str) -> None:
    try:
        scene = load_text(text, Path("any.world"))
    except WorldError as mistake:
        lines = text.split("\n")
        assert mistake.file == "any.world"
        assert 1 <= mistake.line <= len(lines)
        assert 1 <= mistake.column <= len(lines[mistake.line - 1]) + 1
    else:
        assert all(model.root <= model.index for model in scene.models)


@settings(max_examples=examples(1000))
@given(st.text(alphabet=st.characters(codec="utf-8", exclude_characters="\r"), max_size=200))
def test_any_text_loads_or_is_a_mistake(text: str) -> None:
    loads_or_is_a_mistake(text)


@settings(max_examples=examples(1500))
@given(st.lists(st.sampled_from(WORDS), max_size=60))
def test_any_words_of_the_language_load_or_are_a_mistake(words: list[str]) -> None:
    loads_or_is_a_mistake(" ".join(words))


@settings(max_examples=examples(500))
@given(st.integers(0, len(DONNIE)), st.integers(0, 40), st.sampled_from(["", *WORDS, "\0", "é", "[[[["]))
def test_a_file_with_a_replaced_piece_loads_or_is_a_mistake(start: int, length: int, piece: str) -> None:
    loads_or_is_a_mistake(DONNIE[:start] + piece + DONNIE[start + length :])
