"""What ``donnie world`` prints: the legend of the map, its scale, and the text of the JSON."""

from __future__ import annotations

from types import SimpleNamespace as Part
from typing import Any

import pytest

from donnie_tui.cli import world
from donnie_tui.cli.world import MOST_COLOURS, MOST_NAMES, _colours_by_letter, _legend, _named
from donnie_tui.i18n.words import Words


def thing(colour: str, place: tuple[int, int] | None, letter: str = "b", *, is_robot: bool = False) -> Any:
    """``place``: row and column of its square; None if it is outside of the picture."""
    return Part(colour=colour, letter=letter, is_robot=is_robot, x=place, y=0)


@pytest.mark.parametrize(
    ("shown", "across", "things", "colours"),
    [
        (["b.", "..", "b."], 1, [thing("red", (0, 0)), thing("blue", (2, 0))], {"b": ["red", "blue"]}),
        (["b.", "..", "b."], 2, [thing("red", (4, 0)), thing("blue", (0, 1))], {"b": ["blue", "red"]}),
        (["b.b"], 2, [thing("red", (0, 4)), thing("blue", (1, 0))], {"b": ["blue", "red"]}),
        (["bb", "bb"], 1, [thing("red", (0, 2)), thing("blue", (1, 1))], {"b": ["blue"]}),
        (["b.b"], 1, [thing("red", (0, 0)), thing("red", (0, 2))], {"b": ["red"]}),
        (["b.b"], 1, [thing("red", (0, 0)), thing("blue", None)], {"b": ["red"]}),
        (["b.c"], 1, [thing("red", (0, 1)), thing("blue", (0, 0), "c")], {"b": ["red"], "c": ["blue"]}),
        (["b"], 1, [thing("red", (0, 3)), thing("blue", (0, 0), is_robot=True)], {"b": ["red"]}),
        (["b.c"], 1, [thing("red", (0, 0))], {"b": ["red"]}),
    ],
)
def test_each_thing_on_the_map_has_the_colour_of_the_nearest_of_its_letter(
    shown: list[str],
    across: int,
    things: list[Any],
    colours: dict[str, list[str]],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(world, "shade", lambda each, _words: each.colour)
    seen: Any = Part(things=things, at=lambda x, _y: x)

    assert _colours_by_letter(seen, shown, across, Words()) == colours


NUMBERS = [str(number) for number in range(1, 50)]


@pytest.mark.parametrize(
    ("names", "colours", "text"),
    [
        (["ball"], [], "ball"),
        (["ball"], ["red", "blue"], "ball: red, blue"),
        (["ball", "box"], ["red", "blue"], "ball, box"),
        (["ball"], NUMBERS[:40], f"ball: {', '.join(NUMBERS[:40])}"),
        (["ball"], NUMBERS[:41], f"ball: {', '.join(NUMBERS[:40])}, …"),
        (NUMBERS[:4], [], "1, 2, 3, 4"),
        (NUMBERS[:5], [], "1, 2, 3, 4, …"),
    ],
)
def test_a_letter_has_up_to_four_names_and_one_name_up_to_forty_colours(
    names: list[str], colours: list[str], text: str
) -> None:
    assert (MOST_NAMES, MOST_COLOURS) == (4, 40)
    assert _named(names, colours) == text


def test_the_legend_names_what_the_map_shows_each_once_and_in_the_order_of_letters(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(world, "name_of", lambda each, _words: each.colour)
    things = [thing(name, None, "x") for name in ("box", "box", "crate", "1", "2", "3", "4")]
    seen: Any = Part(things=[*things, thing("ball", None, "b"), thing("hidden", None, "h")])
    room: Any = Part(scene=Part(robot_names=("ana", "rui")))

    assert _legend(room, seen, {"#", "b", "x"}, {"b": ["red"]}, Words()) == (
        "# is wall.",
        "^ > v < is ana, rui.",
        "b is ball: red.",
        "x is box, crate, 1, 2, ….",
    )
    room.scene.robot_names = ()
    assert _legend(room, seen, {"."}, {}, Words()) == (". is free floor.", "There is no robot.")


@pytest.mark.parametrize(("columns", "scale"), [(80, []), (81, ["Each letter is 2 by 2 steps."])])
def test_a_map_whose_letters_are_several_steps_says_so(
    columns: int, scale: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: Any = Part(rows=("." * columns,), things=[], width=columns, cell=1)
    room: Any = Part(scene=Part(robots=(), robot_names=()), start=lambda: None)
    monkeypatch.setattr("sim.picture.picture", lambda _scene: seen)

    assert world._map(room, Words())[1:] == ("", *scale, ". is free floor.", "There is no robot.")


def test_the_json_has_letters_as_they_are_and_escapes_for_what_a_terminal_obeys(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(world, "records", lambda _scene: [{"name": "é\x1b\x9b\n日"}])

    assert world._json(Part(scene=None)) == '[\n {\n  "name": "é\\u001b\\u009b\\n日"\n }\n]'  # type: ignore[arg-type]
