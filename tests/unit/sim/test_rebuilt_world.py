"""A world whose file was changed: the robots stay where they are, and so do the things they moved."""

import pytest

from devices.ports.robot import Bearing, Grip
from sim.geometry import Placement
from sim.world import World
from tests.unit.sim.floors import BOX_ROBOT, IDEAL, Unpaced, scene

GRIPPER = "gripper( size [ 0.05 0.1 0.1 ] pose [ 0.12 0 0 0 ] )"
HEAD = BOX_ROBOT + 'blind( name "alice" )\nblind( name "bob" pose [ 0 -2 0 0 ] )\n'
BOX = 'model( name "{}" size [ 0.1 0.1 0.2 ] pose [ {} {} 0 0 ] pushable 1 )\n'
CAN = 'model( name "can" size [ 0.04 0.04 0.1 ] pose [ 0.17 0 0 0 ] gripper_return 1 )\n'


def places(world: World) -> dict[str, tuple[float, float]]:
    """Of the things that were moved, in centimetres."""
    names = {index: world.scene.models[index].name for index in world.moved_things()}
    return {
        names[index]: (round(it.x * 100), round(it.y * 100)) for index, it in world.moved_things().items()
    }


def index_of(world: World, name: str) -> int:
    return next(model.index for model in world.scene.models if model.name == name)


def test_what_was_pushed_stays_there_and_can_be_pushed_on() -> None:
    """The robot reaches 10 cm ahead, and the box 5 cm around its place."""
    world = World(scene(HEAD + BOX.format("gone", 0, 3) + BOX.format("box", 0.3, 0)))
    alice = world.robot("alice", pace=Unpaced())
    alice.forward(8)
    alice.turn(0)
    assert places(world) == {"box": (55, 0)}
    new = scene(HEAD + BOX.format("new", 0, 4) + BOX.format("new2", 0, 5) + BOX.format("box", 0.3, 0))
    old, kept = index_of(world, "box"), next(each.index for each in new.models if each.name == "box")

    world.rebuild(new, {0: 0, index_of(world, "bob"): index_of(world, "bob"), old: kept})

    assert world.scene is new
    assert places(world) == {"box": (55, 0)}
    assert world.poses() == {"alice": Placement(pytest.approx(0.4), 0, 0, 0)}  # type: ignore[arg-type]
    alice.forward(2)
    assert places(world) == {"box": (65, 0)}
    world.reset()
    assert (places(world), alice.pose().x) == ({}, 0)


def test_a_pushed_thing_that_the_file_has_elsewhere_now_is_there() -> None:
    world = World(scene(HEAD + BOX.format("box", 0.3, 0)))
    world.robot("alice", pace=Unpaced()).forward(8)
    same = {index: index for index in range(len(world.scene.models))}

    world.rebuild(scene(HEAD + BOX.format("box", 0.3, 1)), same)

    assert places(world) == {}
    assert world.ground.place(index_of(world, "box")) == Placement(0.3, 1)


def test_a_thing_that_is_gone_is_nowhere() -> None:
    world = World(scene(HEAD + BOX.format("box", 0.3, 0)))
    alice = world.robot("alice", pace=Unpaced())
    alice.forward(8)

    world.rebuild(scene(HEAD), {index: index for index in range(len(scene(HEAD).models))})

    assert places(world) == {}
    assert alice.forward(30).walked == 30


def test_a_changed_property_of_a_thing_leaves_it_where_it_is() -> None:
    world = World(scene(HEAD + BOX.format("box", 0.3, 0)))
    world.robot("alice", pace=Unpaced()).forward(8)

    world.change(index_of(world, "box"), fiducial_return=7)

    assert [each.fiducial_return for each in world.scene.models if each.name in ("box", "bob")] == [0, 7]
    assert places(world) == {"box": (55, 0)}


def test_the_world_knows_what_is_held() -> None:
    world = World(scene(HEAD.replace('name "alice"', f'name "alice" {GRIPPER}') + CAN))
    assert (world.held_by(None), world.held_by("bob"), world.is_holding) == (None, None, False)
    alice, bob = (world.robot(name, pace=Unpaced()) for name in ("alice", "bob"))
    assert (world.held_by("alice"), world.is_holding) == (None, False)

    assert alice.grip().outcome is Grip.GRIPPED

    can = index_of(world, "can")
    assert [world.held_by(name) for name in (None, "alice", "bob")] == [can, can, None]
    assert (world.is_holding, alice.holds, bob.holds) == (True, can, None)
    alice.release()
    assert (world.held_by(None), world.is_holding) == (None, False)


def test_a_world_without_robots_has_none_by_any_name() -> None:
    world = World(scene(BOX.format("box", 0, 0)))

    assert world.held_by(None) is None
    for name in (None, "alice"):
        with pytest.raises(KeyError):
            world.robot(name, pace=Unpaced())


def test_an_inhabitant_is_the_robot_that_was_made_last() -> None:
    world = World(scene(HEAD))
    first = world.inhabitant("alice")
    assert world.inhabitant("alice") is first
    assert (first.name, first.speed, first.wait(100)) == ("alice", None, True)

    second = world.robot("alice", pace=Unpaced())
    assert world.inhabitant("alice") is second
    assert world.inhabitant("bob").name == "bob"


@pytest.mark.parametrize("speed", [0, -1.0, float("nan")])
def test_a_speed_is_above_0(speed: float) -> None:
    robot = World(scene(HEAD)).robot(pace=Unpaced(), speed=2.0)

    with pytest.raises(ValueError, match="above 0"):
        robot.speed = speed
    assert robot.speed == 2.0
    robot.speed = None
    assert robot.speed is None


def test_what_a_robot_saw_before_a_change_is_not_what_it_sees_after_it() -> None:
    """It stands at the same place."""
    box = 'model( name "box" size [ 0.1 0.1 0.2 ] pose [ {} 0 0 0 ] color "red" )'
    world = World(scene(IDEAL + "ideal( pose [ 0 0 0 0 ] )" + box.format(0.55)))
    robot = world.robot(pace=Unpaced())
    assert (robot.scan()[0].steps, robot.known_distances()[Bearing.FRONT]) == (10, 10)
    assert robot.forward(20).walked == 9

    robot.reset()
    world.rebuild(scene(IDEAL + "ideal( pose [ 0 0 0 0 ] )" + box.format(1.05)), {0: 0})

    assert (robot.scan()[0].steps, robot.known_distances()[Bearing.FRONT]) == (20, 20)
    assert robot.forward(20).walked == 19
