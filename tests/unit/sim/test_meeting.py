"""What a movement ended at, and on which side."""

from math import hypot

import pytest

from devices.ports.robot import Met, StoppedBy
from sim.world import World
from tests.unit.sim.floors import BOX_ROBOT, IDEAL, Unpaced, ideal, robot, scene

DEFINED = "define chair model ( size [ 0.1 0.1 0.5 ] )\n"


def test_a_complete_movement_met_nothing() -> None:
    it = ideal([("red", 9, 9)])

    assert (it.forward(3).met, it.turn(90).met) == (None, None)


def test_an_obstacle_is_reported_with_its_name_and_its_place() -> None:
    assert ideal([("red", 0, 5)]).forward(9).met == Met("thing", "thing1", 0.0)


def test_a_thing_behind_is_met_when_walking_backward() -> None:
    met = ideal([("red", 0, -4)]).backward(5).met

    assert met is not None
    assert met.name == "thing1"
    assert abs(met.degrees) == pytest.approx(180)


def test_the_obstacle_is_the_nearest_thing_ahead_and_not_one_at_the_side() -> None:
    met = ideal([("red", 0, 5), ("green", 1.5, 3.4), ("blue", 0, 7)]).forward(9).met

    assert met is not None
    assert met.name == "thing1"


@pytest.mark.parametrize(("beyond", "met"), [(0.14, Met("wall", "", 0.0)), (0.16, None)])
def test_what_stopped_a_sonar_far_to_the_side_is_taken_for_nothing_that_is_three_steps_off(
    beyond: float, met: Met | None
) -> None:
    """The post before the sonar is more than 60 degrees off the way; the wall bars it farther on."""
    wide = "define wide position ( size [ 0.02 0.6 0.1 ] ranger ( sonar( pose [ 0 0.29 0 0 ] ) ) )\n"
    post = "model ( size [ 0.02 0.02 1 ] pose [ 0.06 0.29 0 0 ] )\n"
    radius = hypot(0.01, 0.3)
    wall = f'model ( name "wall" size [ 0.02 0.2 1 ] pose [ {radius + beyond + 0.01} 0 0 0 ] )\n'

    moved = robot(BOX_ROBOT + wide + post + wall + "wide( pose [ 0 0 0 0 ] )").forward(9)

    assert (moved.walked, moved.stopped_by, moved.met) == (0, StoppedBy.OBSTACLE, met)


@pytest.mark.parametrize(("east", "degrees"), [(0.06, 29), (-0.06, -29)])
def test_a_thing_that_is_hit_at_an_angle_is_on_that_side(east: float, degrees: int) -> None:
    """The robot is a decimetre wide and twenty long; it looks to the north."""
    thing = f'chair( name "c1" pose [ {east} 0.5 0 0 ] size [ 0.02 0.02 1 ] )'
    it = robot(BOX_ROBOT + DEFINED + f"blind( pose [ 0 0 0 90 ] ) {thing}")

    moved = it.forward(20)

    assert moved.stopped_by is StoppedBy.COLLISION
    assert moved.met is not None
    assert (moved.met.kind, moved.met.name) == ("chair", "c1")
    assert moved.met.degrees == pytest.approx(degrees, abs=5)


def test_a_thing_at_the_side_ends_a_turn() -> None:
    it = robot(BOX_ROBOT + "blind( pose [ 0 0 0 0 ] ) model( size [ 1 0.1 1 ] pose [ 0 0.14 0 0 ] )")

    met = it.turn(-90).met

    assert met is not None
    assert -90 < met.degrees < 0


@pytest.mark.parametrize(
    "wall",
    [
        'model( name "wall3" size [ 2 0.1 1 ] pose [ 0 1 0 0 ] )',
        'model( name "room" boundary 1 size [ 2 2 1 ] )',
    ],
    ids=["by its name", "a boundary"],
)
def test_a_wall_is_reported_as_a_wall_whatever_its_name(wall: str) -> None:
    assert robot(IDEAL + wall + "ideal( pose [ 0 0 0 90 ] )").forward(50).met == Met("wall", "", 0.0)


def test_another_robot_is_reported_with_its_name() -> None:
    it = robot(BOX_ROBOT + 'blind( pose [ 0 0 0 0 ] ) blind( name "bob" pose [ 1 0 0 0 ] obstacle_return 0 )')

    assert it.forward(30).met == Met("robot", "bob", 0.0)


def test_the_nearest_of_the_things_pushed_into_a_wall_is_reported() -> None:
    it = robot(
        BOX_ROBOT
        + "blind( pose [ 0 0 0 0 ] )"
        + 'model( name "box1" size [ 0.1 0.1 1 ] pose [ 0.3 0 0 0 ] pushable 1 )'
        + 'model( name "wall" size [ 0.1 2 1 ] pose [ 1 0 0 0 ] )'
    )

    assert it.forward(50).met == Met("model", "box1", 0.0)


TWO_BLIND = BOX_ROBOT + 'blind( name "a" pose [ 0 0 0 0 ] ) blind( name "b" pose [ 0.1501 0 0 90 ] )'
"""The one stands against the side of the other."""


def test_a_robot_that_could_not_walk_walks_when_the_other_is_away() -> None:
    world = World(scene(TWO_BLIND))
    a, b = (world.robot(name, pace=Unpaced()) for name in "ab")

    refused = [a.forward(2) for _ in range(3)]
    b.forward(9)

    assert [(each.walked, each.stopped_by) for each in refused] == [(0, StoppedBy.COLLISION)] * 3
    assert a.forward(2).walked == 2
