"""A world in words: places are told from the robot, in steps, the nearest thing first."""

import pytest

from devices.ports.robot import Pose
from donnie_tui.core.describe import describe, place_of
from donnie_tui.i18n.words import Words
from sim.picture import picture
from tests.floor import floor


@pytest.mark.parametrize(
    ("x", "y", "heading", "place"),
    [
        (0, 5, 0, "5 ahead"),
        (-2, 5, 0, "2 left, 5 ahead"),
        (3, -1, 0, "3 right, 1 behind"),
        (0, 5, 90, "5 left"),
        (5, 0, 90, "5 ahead"),
        (0, 5, 180, "5 behind"),
        (0, 5, 270, "5 right"),
        (4, 4, 45, "6 ahead"),
        (0.2, -0.3, 0, "here"),
    ],
)
def test_a_place_is_told_as_it_is_seen_from_the_robot(x: float, y: float, heading: float, place: str) -> None:
    assert place_of(x, y, Pose(0.0, 0.0, heading), Words()) == place


def test_a_world_is_described_from_its_size_to_its_things() -> None:
    seen = picture(floor(("red", 0, 10), ("green", 3, 0)))

    assert describe(seen, Pose(0.0, 0.0, 90.0), Words()) == (
        "An open floor without walls.",
        "The robot starts at 0, 0, facing east.",
        "2 things, the nearest first.",
        "Thing2, green: 3 ahead.",
        "Thing1, red: 10 left.",
    )


def test_an_empty_floor_is_described_in_each_language() -> None:
    said = {describe(picture(floor()), Pose(0.0, 0.0, 0.0), Words(each))[-1] for each in ("en", "pt", "es")}

    assert said == {"There are no things.", "Não há objetos.", "No hay objetos."}
