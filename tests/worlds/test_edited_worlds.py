"""Models of a world are put elsewhere or taken out in its text; all else stays as it was written."""

from pathlib import Path

import pytest

from sim.geometry import Placement
from sim.worldfile import load_text, put_elsewhere, taken_out, written_models

PATH = Path("it.world")
TEXT = """\
# a comment ( with a bracket
define box model ( size [ 0.1 0.1 0.1 ] pose [ 9 9 0 0 ] )
define bob position ( ranger ( sensor ( pose [ 0.1 0 0 0 ] ) ) )

box( name "a" pose [ 1 2 0 0 ] color "red" ) box( name "b) pose [ 8 8 0 0 ]" )  # two on a line
model
(
  name "tower"
  # pose [ 5 5 0 0 ]
  model( pose [ 0.5 0 0 0 ] )
)
bob( name "bob" pose [
  0 0
  0 90 ] )
"""


def roots(text: str) -> dict[str, Placement]:
    scene = load_text(text, PATH)
    return {each.name: each.pose for each in scene.models if each.parent is None}


@pytest.mark.parametrize("number", range(4))
def test_a_model_is_put_elsewhere_and_no_other_one_moves(number: int) -> None:
    before = roots(TEXT)
    name = list(before)[number]

    text = put_elsewhere(TEXT, written_models(TEXT, PATH)[number], Placement(3, -4.25, 0, 45))

    after = roots(text)
    assert after.pop(name) == Placement(3, -4.25, before[name].z, 45)
    assert after == {each: pose for each, pose in before.items() if each != name}
    assert "# a comment ( with a bracket" in text
    assert "# two on a line" in text


@pytest.mark.parametrize("number", range(4))
def test_a_model_is_taken_out_and_the_others_stay(number: int) -> None:
    before = roots(TEXT)
    gone = list(before)[number]

    text = taken_out(TEXT, written_models(TEXT, PATH)[number])

    assert roots(text) == {each: pose for each, pose in before.items() if each != gone}


def test_a_model_of_an_included_file_is_not_written_here(tmp_path: Path) -> None:
    (tmp_path / "more.inc").write_text('model( name "there" )', encoding="utf-8")
    text = 'include "more.inc"\nmodel( name "here" )\n'

    there, here = written_models(text, tmp_path / "it.world")

    assert there is None
    assert here is not None
    assert text[here.begin : here.end] == 'model( name "here" )'
