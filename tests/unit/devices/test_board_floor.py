"""The walls and things of a world, as a simulated board on the place of its first robot meets them."""

from __future__ import annotations

from math import pi, radians

import pytest

from devices.board_simulator.floor import AxlePose, BumperSwitch
from devices.ports.robot import Pose
from donnie_tui.robot.board_floor import SceneFloor, place_of
from tests.unit.sim.floors import scene

NE, NW, SE, SW = BumperSwitch.NE, BumperSwitch.NW, BumperSwitch.SE, BumperSwitch.SW
ROBOT = """
define sonar sensor ( range [ 0 3 ] fov 15 )
position ( size [ 0.2 0.2 0.2 ] ranger ( sonar( pose [ 0.1 0 0 0 ] ) sonar( pose [ -0.1 0 0 180 ] ) ) )
"""
"""It looks along the world's x axis, with a sonar in front and one at the back."""
WALL = "model ( size [ 0.1 4 1 ] pose [ 1.05 0 0 0 ] {more} )\n"
"""From 1 m on, across the x axis."""


def floor(more: str = "") -> SceneFloor:
    return SceneFloor(scene(ROBOT + WALL.format(more=more)))


@pytest.mark.parametrize(
    ("start", "place"),
    [
        (Pose(0.0, 0.0, 0.0), AxlePose(0.0, 0.0, pi / 2)),
        (Pose(20.0, -10.0, 90.0), AxlePose(1.0, -0.5, 0.0)),
        (Pose(0.0, 0.0, 180.0), AxlePose(0.0, 0.0, -pi / 2)),
    ],
)
def test_a_board_has_metres_and_counts_its_angle_from_east_to_the_left(start: Pose, place: AxlePose) -> None:
    assert place_of(start) == place


@pytest.mark.parametrize(("x", "is_free"), [(0.0, True), (0.89, True), (0.91, False), (1.05, False)])
def test_the_robot_fits_where_its_body_is_in_nothing_solid(x: float, is_free: bool) -> None:
    assert floor().is_free(AxlePose(x, 0.0, 0.0)) is is_free
    assert floor("obstacle_return 0").is_free(AxlePose(x, 0.0, 0.0))


@pytest.mark.parametrize(
    ("degrees", "pressed"),
    [(0, {NE, NW}), (90, {NE, SE}), (180, {SE, SW}), (-90, {NW, SW})],
)
def test_bumpers_on_the_side_of_the_wall_are_pressed(degrees: int, pressed: set[BumperSwitch]) -> None:
    assert floor().touched(AxlePose(0.899, 0.0, radians(degrees))) == pressed
    assert floor().touched(AxlePose(0.89, 0.0, radians(degrees))) == frozenset()


def test_a_sonar_measures_from_where_it_is_and_that_of_the_head_to_where_it_looks() -> None:
    """Of the original board 1 is the sonar in front, 4 the one at the back, 6 that on the head."""
    ahead, back = AxlePose(0.0, 0.0, 0.0), AxlePose(0.0, 0.0, pi)

    assert floor().centimetres(ahead, 1, 90) == pytest.approx(90)
    assert floor().centimetres(back, 1, 90) is None
    assert floor().centimetres(back, 4, 90) == pytest.approx(90)
    assert floor().centimetres(ahead, 6, 90) == pytest.approx(90)
    assert floor().centimetres(ahead, 6, 0) is None
