"""What a world and its robots know: whose turn it is, where everything is, and what is the same as before."""

import pytest

from devices.ports.robot import Bearing, Grip, Met, StoppedBy
from sim.geometry import Placement
from sim.world import World
from tests.unit.sim.floors import BOX_ROBOT, IDEAL, Unpaced, scene

TWO = BOX_ROBOT + 'blind( name "alice" pose [ 0 0 0.5 0 ] )\nblind( name "bob" pose [ 0 -2 0 0 ] )\n'
CRATE = 'model( name "box" size [ 0.1 0.1 0.2 ] pose [ 0.3 0 0 0 ] pushable 1 )\n'
GRIPPER = "gripper( size [ 0.05 0.1 0.1 ] pose [ 0.12 0 0 0 ] )"
CAN = 'model( name "can" size [ 0.04 0.04 0.1 ] pose [ 0.17 0 0 0 ] gripper_return 1 )\n'


def test_a_world_knows_whose_turn_it_is_while_another_robot_waits() -> None:
    world = World(scene(TWO))
    alice, bob = (world.robot(name, pace=Unpaced()) for name in ("alice", "bob"))
    assert world.turn() is None

    world.expect(["bob"])
    assert world.turn() is None
    world.expect(["alice"])
    assert world.turn() == ("bob", 0.0)
    bob.leave()
    assert world.turn() is None
    alice.join()
    alice.forward(3)
    world.expect(["bob"])
    assert world.turn() == ("alice", pytest.approx(3.0))
    alice.leave()
    bob.leave()


def test_a_world_knows_where_its_robots_and_things_are() -> None:
    world = World(scene(TWO + CRATE))
    assert (world.poses(), world.moved_things()) == ({}, {})
    alice = world.robot("alice", pace=Unpaced())
    assert world.poses() == {"alice": Placement(0, 0, 0.5, 0)}
    assert alice.placement == Placement(0, 0, 0.5, 0)

    alice.forward(8)

    crate = world.scene.models[-1].index
    assert world.poses() == {"alice": Placement(pytest.approx(0.4), 0, 0.5, 0)}  # type: ignore[arg-type]
    assert [*world.moved_things()] == [crate]
    now = world.scene_now()
    assert [now.models[each].pose for each in (0, crate)] == [
        world.poses()["alice"],
        world.ground.place(crate),
    ]
    assert world.scene.models[0].pose == Placement(0, 0, 0.5, 0)


def test_a_reset_in_company_leaves_the_things_where_they_are() -> None:
    world = World(scene(TWO + CRATE))
    alice, bob = (world.robot(name, pace=Unpaced()) for name in ("alice", "bob"))
    alice.forward(8)
    bob.join()

    alice.reset()
    assert (len(world.moved_things()), alice.placement.x, alice.time()) == (1, 0, 0)
    bob.reset()
    assert world.moved_things() == {}
    alice.forward(8)
    bob.leave()
    alice.reset()
    assert world.moved_things() == {}


@pytest.mark.parametrize(
    ("more", "is_open"),
    [
        ("", True),
        ("model( )", False),
        ("model( ranger_return 0.5 )", False),
        ("model( ranger_return 0 )", True),
        ("model( ranger_return -1 )", True),
        ("model( boundary 1 size [ 9 9 1 ] )", False),
        ('blind( name "bob" model( size [ 0.1 0.1 0.1 ] ) )', True),
    ],
)
def test_a_robot_is_in_the_open_where_its_sensors_could_find_nothing(more: str, is_open: bool) -> None:
    it = World(scene(f'{BOX_ROBOT}blind( name "alice" pose [ 0 0 0 0 ] ) {more}')).robot(pace=Unpaced())

    assert it.is_in_the_open is is_open


def test_a_situation_is_the_same_again_when_all_are_where_they_were() -> None:
    world = World(scene(TWO.replace('name "alice"', f'name "alice" {GRIPPER}') + CAN))
    alice, bob = (world.robot(name, pace=Unpaced()) for name in ("alice", "bob"))
    assert alice.situation == ()
    alice.forward(0)
    start = alice.situation
    assert start != ()

    alice.backward(2)
    assert alice.situation != start
    again = alice.situation
    alice.turn(90)
    assert alice.situation != again
    alice.turn(-90)
    assert alice.situation == again
    alice.forward(2)
    again = alice.situation
    assert alice.grip().outcome is Grip.GRIPPED
    assert alice.situation != again
    before = alice.situation
    bob.forward(1)
    assert alice.situation != before
    assert World(scene(TWO), seed=1).robot(pace=Unpaced()).situation is None


def test_only_a_robot_with_errors_has_another_true_pose() -> None:
    odom = 'localization "odom" odom_error [ 0.3 0.3 0.5 ]'
    text = BOX_ROBOT + f'blind( name "alice" pose [ 0 0 0 0 ] {odom} )'
    exact, it = (World(scene(text), seed=seed).robot(pace=Unpaced()) for seed in (0, 7))
    assert (exact.true_pose(), it.true_pose()) == (None, None)
    for each in (exact, it):
        each.forward(20)

    true = it.true_pose()
    assert exact.true_pose() is None
    assert true is not None
    assert (true.x, true.y, true.heading) == (20, 0, 90)
    assert it.pose().x != pytest.approx(20)


def test_errors_stay_the_same_in_a_rebuilt_world() -> None:
    odom = 'localization "odom" odom_error [ 0.3 0.3 0.5 ]'
    text = BOX_ROBOT + f'blind( name "alice" pose [ 0 0 0 0 ] {odom} )'
    world, plain = (World(scene(text), seed=7) for _ in range(2))
    robot, other = (each.robot(pace=Unpaced()) for each in (world, plain))
    for each in (robot, other):
        each.forward(5)

    world.rebuild(scene(text), {0: 0})

    assert robot.forward(5) == other.forward(5)
    assert (robot.true_pose(), robot.time()) == (other.true_pose(), other.time())


def test_a_named_sensor_reads_and_another_name_is_no_sensor() -> None:
    sonars = 'ranger( name "eye" sensor( pose [ 0 0 0 0 ] range [ 0 3 ] fov 1 ) )'
    wall = "model( size [ 0.2 4 1 ] pose [ 1.1 0 0 0 ] )"
    it = World(scene(f"position( size [ 0.2 0.1 0.1 ] {sonars} ) {wall}")).robot(pace=Unpaced())

    (name,) = it.ranger_names
    assert "eye" in name
    assert it.named_distance(name) == it.distance(Bearing.FRONT) == 20
    with pytest.raises(KeyError):
        it.named_distance("ear")


def test_a_command_that_was_refused_is_refused_again_and_another_one_is_not() -> None:
    """Nothing that may move is near."""
    wall = 'model( name "wall" size [ 0.2 4 1 ] pose [ 0.2001 0 0 0 ] )'
    it = World(scene(BOX_ROBOT + f"blind( pose [ 0 0 0 0 ] ) {wall}")).robot(pace=Unpaced())

    refused = [it.forward(2), it.forward(2), it.forward(3), it.forward(2)]

    assert [(each.asked, each.walked, each.stopped_by) for each in refused] == [
        (steps, 0, StoppedBy.COLLISION) for steps in (2, 2, 3, 2)
    ]
    assert [each.met for each in refused] == [Met("wall", "", 0.0)] * 4
    assert it.backward(2).walked == 2
    assert it.forward(2).walked == 2
    assert it.forward(2).walked == 0
    it.reset()
    assert it.backward(1).walked == 1
    assert it.turn(90).turned == 90


def test_what_is_seen_to_the_left_has_a_negative_bearing() -> None:
    """At 3, 4 and 5 steps: a triangle with a right angle."""
    text = IDEAL + 'ideal( pose [ 0 0 0 90 ] ) thing( name "{}" pose [ {} 0.5 0 0 ] color "red" )'
    for x, sign in ((-0.25, -1), (0.25, 1)):
        (seen,) = World(scene(text.format("ball", x))).robot(pace=Unpaced()).scan()
        assert seen.degrees == pytest.approx(sign * 26.565, abs=0.3)
        assert (seen.name, seen.colour) == ("ball", "red")


def test_a_robot_stands_in_what_is_around_its_start() -> None:
    floor = 'model( name "floor" size [ 2 2 1 ] )'
    text = BOX_ROBOT + f'blind( name "a" pose [ 0 0 0 0 ] ) blind( name "b" pose [ 3 0 0 0 ] ) {floor}'
    world = World(scene(text))

    stand_in = [world.robot(name, pace=Unpaced()).stands_in for name in ("a", "b")]

    assert stand_in == [("floor",), ()]


def test_distances_that_a_caller_changes_are_not_those_of_the_robot() -> None:
    it = World(scene(IDEAL + "ideal( pose [ 0 0 0 90 ] ) thing( pose [ 0 0.5 0 0 ] )")).robot(pace=Unpaced())

    it.known_distances().clear()

    assert it.known_distances()[Bearing.FRONT] == it.distance(Bearing.FRONT) == 10


def test_a_robot_does_not_see_what_it_has_just_taken_nor_measure_it() -> None:
    eyes = "blobfinder( range 3 fov 60 ) ranger( sensor( pose [ 0.1 0 0 0 ] range [ 0 3 ] fov 1 ) )"
    ball = CAN.replace("can", "ball").replace(" )\n", ' color "blue" )\n')
    text = f"position( size [ 0.2 0.1 0.1 ] {eyes} {GRIPPER} ) {ball}"
    it = World(scene(text)).robot(pace=Unpaced())
    (seen,) = it.scan()
    assert (seen.name, seen.colour, seen.degrees) == ("ball", "blue", 0)
    near = it.distance(Bearing.FRONT)

    taken = it.grip()
    assert (taken.outcome, taken.name, taken.kind, taken.colour) == (Grip.GRIPPED, "ball", "model", "blue")
    assert (it.scan(), it.distance(Bearing.FRONT)) == ((), 60)
    again = it.grip()
    assert (again.outcome, again.name) == (Grip.HOLDS_ALREADY, "ball")
    released = it.release()
    assert (released.outcome, released.name, released.colour) == (Grip.RELEASED, "ball", "blue")
    assert (it.scan(), it.distance(Bearing.FRONT)) == ((seen,), near)
    nothing = it.release()
    assert (nothing.outcome, nothing.name, nothing.kind, nothing.colour) == (Grip.HOLDS_NOTHING, "", "", "")


def test_a_thing_without_a_name_of_its_own_is_reported_without_one() -> None:
    it = World(scene(TWO + "define crate model( )\n" + CRATE.replace('model( name "box"', "crate("))).robot(
        pace=Unpaced()
    )

    (pushed,) = it.forward(8).pushed

    assert (pushed.name, pushed.kind, pushed.colour) == ("", "crate", "red")
    assert pushed.steps == pytest.approx(5, abs=0.01)


def test_a_mark_is_seen_with_its_number_its_bearing_and_its_distance() -> None:
    """At 0.3 and 0.4 m: 10 steps away, 36.87 degrees to the right."""
    mark = 'model( name "m" size [ 0.02 0.02 1 ] pose [ 0.3 0.4 0 0 ] fiducial_return 7 )'
    text = f"position( size [ 0.1 0.1 0.1 ] pose [ 0 0 0 90 ] fiducial( range_max 8 fov 180 ) ) {mark}"

    (seen,) = World(scene(text)).robot(pace=Unpaced()).scan()

    assert (seen.name, seen.colour, seen.mark) == ("m", "", 7)
    assert (seen.degrees, seen.steps) == pytest.approx((36.8699, 10), abs=0.01)


def test_a_speed_may_change_at_any_time() -> None:
    it = World(scene(TWO)).robot(pace=Unpaced(), speed=2.0)

    for speed in (0.25, 5.0, None):
        it.speed = speed
        assert it.speed == speed


@pytest.mark.parametrize("joined", [False, True])
def test_waits_take_their_time_alone_and_in_company(joined: bool) -> None:
    world = World(scene(TWO))
    alice, bob = (world.robot(name, pace=Unpaced()) for name in ("alice", "bob"))
    if joined:
        alice.join()

    waits = [alice.wait(seconds) for seconds in (1.5, 0.0, -2.0, 0.25)]
    assert (waits, alice.time()) == ([True] * 4, 1.75)
    alice.halt()
    assert alice.wait(1.0)
    assert alice.time() == 2.75
    with pytest.raises(ValueError, match="negative"):
        alice.backward(-1)
    if joined:
        world.expect(["bob"])
        assert world.turn() == ("alice", 2.75)
        bob.leave()
