"""Things that can be pushed move straight, never into anything, and are seen at their current place."""

import pytest

from devices.ports.robot import Bearing, Grip, RobotProblem, StoppedBy
from sim.cameras import Seen
from sim.geometry import Spot
from sim.ground import Looks
from sim.rangers import Around
from sim.sensors import Senses
from sim.world import World
from tests.unit.sim.floors import BOX_ROBOT, IDEAL, Unpaced, scene

PUSHER = BOX_ROBOT + "blind( pose [ 0 0 0 0 ] )"
BOX = "model( size [ 0.1 0.1 0.2 ] pose [ {} {} 0 0 ] pushable 1 )"
WALL = "model( size [ 0.1 2 1 ] pose [ {} 0 0 0 ] )"


def things(world: World) -> list[tuple[float, float]]:
    return [(round(place.x, 3), round(place.y, 3)) for place in world.moved_things().values()]


def test_a_pushable_thing_is_pushed_and_the_walk_continues() -> None:
    world = World(scene(PUSHER + BOX.format(0.3, 0)))
    moved = world.robot(pace=Unpaced()).forward(10)

    assert (moved.walked, moved.stopped_by) == (10, None)
    assert things(world) == [(0.5 + 0.1 + 0.05, 0)]


def test_a_thing_that_is_not_pushable_is_not_pushed() -> None:
    world = World(scene(PUSHER + BOX.format(0.3, 0).replace("pushable 1", "")))
    moved = world.robot(pace=Unpaced()).forward(10)

    assert moved.stopped_by is StoppedBy.COLLISION
    assert things(world) == []


def test_a_pushed_thing_stops_at_a_wall_and_the_robot_with_it() -> None:
    world = World(scene(PUSHER + BOX.format(0.3, 0) + WALL.format(0.6)))
    robot = world.robot(pace=Unpaced())

    moved = robot.forward(20)
    again = robot.forward(20)

    assert moved.stopped_by is StoppedBy.COLLISION
    assert things(world) == [(0.5, 0)]
    assert moved.pose.x * 0.05 == pytest.approx(0.6 - 0.05 - 0.1 - 0.1, abs=0.001)
    assert (again.walked, again.stopped_by) == (0, StoppedBy.COLLISION)
    assert robot.backward(3).walked == 3


@pytest.mark.parametrize(("x", "y", "yaw"), [(0, 4, 0), (0, -4, 0), (4, 0, 90), (-4, 1, 180), (1, 4, -90)])
def test_a_pushed_thing_stops_at_a_wall_wherever_they_are(x: float, y: float, yaw: int) -> None:
    def at(metres: float) -> str:
        dx, dy = {0: (1, 0), 90: (0, 1), 180: (-1, 0), -90: (0, -1)}[yaw]
        return f"pose [ {x + metres * dx} {y + metres * dy} 0 {yaw} ]"

    box = f"model( size [ 0.1 0.1 0.2 ] {at(0.3)} pushable 1 )"
    wall = f"model( size [ 0.1 0.4 1 ] {at(0.6)} )"
    world = World(scene(BOX_ROBOT + f"blind( {at(0)} )" + box + wall))

    assert world.robot(pace=Unpaced()).forward(20).stopped_by is StoppedBy.COLLISION
    ((there_x, there_y),) = things(world)
    assert abs(there_x - x) + abs(there_y - y) == pytest.approx(0.5, abs=0.001)


def test_one_thing_pushes_the_next() -> None:
    world = World(scene(PUSHER + BOX.format(0.3, 0) + BOX.format(0.5, 0.03) + WALL.format(1)))

    assert world.robot(pace=Unpaced()).forward(20).stopped_by is StoppedBy.COLLISION
    assert things(world) == [(0.8, 0), (0.9, 0.03)]


def test_things_next_to_the_way_stay() -> None:
    world = World(scene(PUSHER + BOX.format(0.3, 0.11)))

    assert world.robot(pace=Unpaced()).forward(20).walked == 20
    assert things(world) == []


def test_a_thing_is_pushed_over_a_floor_that_is_drawn_as_a_box() -> None:
    world = World(scene(PUSHER + "model( size [ 4 4 0.5 ] )" + BOX.format(0.3, 0)))

    assert world.robot(pace=Unpaced()).forward(10).walked == 10
    assert things(world) == [(0.65, 0)]


def test_nothing_is_pushed_into_another_robot() -> None:
    world = World(scene(PUSHER + BOX.format(0.3, 0) + 'blind( name "bob" pose [ 0.6 0 0 0 ] )'))

    assert world.robot(pace=Unpaced()).forward(20).stopped_by is StoppedBy.COLLISION
    assert things(world) == [(0.45, 0)]


def test_a_sonar_measures_a_pushable_thing_and_does_not_stop_the_robot() -> None:
    world = World(scene(IDEAL + "ideal( pose [ 0 0 0 0 ] )" + BOX.format(0.35, 0)))
    robot = world.robot(pace=Unpaced())

    far = robot.distance(Bearing.FRONT)
    moved = robot.forward(10)

    assert (far, moved.walked, robot.distance(Bearing.FRONT)) == (6, 10, 0)
    robot.backward(4)
    assert robot.distance(Bearing.FRONT) == 4


def test_scan_sees_a_thing_at_its_current_place() -> None:
    world = World(
        scene(IDEAL + "ideal( pose [ 0 0 0 0 ] )" + BOX.format(0.35, 0).replace(")", 'color "red" )'))
    )
    robot = world.robot(pace=Unpaced())
    robot.forward(10)
    robot.backward(6)

    (sighting,) = robot.scan()

    assert sighting.steps == pytest.approx(6, abs=0.21)


@pytest.fixture
def looks(monkeypatch: pytest.MonkeyPatch) -> list[Spot]:
    """Where the cameras looked from."""
    seen, look = list[Spot](), Senses.look

    def counted(senses: Senses, around: Around, spot: Spot) -> tuple[Seen, ...]:
        seen.append(spot)
        return look(senses, around, spot)

    monkeypatch.setattr(Senses, "look", counted)
    return seen


def test_the_cameras_look_once_while_nothing_moves(looks: list[Spot]) -> None:
    world = World(
        scene(IDEAL + "ideal( pose [ 0 0 0 0 ] )" + BOX.format(0.35, 0).replace(")", 'color "red" )'))
    )
    robot = world.robot(pace=Unpaced())

    first = robot.scan()
    assert (robot.scan(), len(looks)) == (first, 1)
    robot.forward(10)
    robot.backward(10)

    (pushed,) = robot.scan()
    assert pushed.steps > first[0].steps
    robot.turn(10)
    assert robot.scan() != (pushed,)
    assert len(looks) == 3


def test_worlds_of_one_scene_share_what_their_robots_saw_with_all_at_the_same_places(
    looks: list[Spot],
) -> None:
    again = scene(IDEAL + "ideal( pose [ 0 0 0 0 ] )" + BOX.format(0.35, 0).replace(")", 'color "red" )'))
    shared: Looks = {}
    first, second, alone = (World(again, looks=each).robot(pace=Unpaced()) for each in (shared, shared, None))

    assert first.scan() == second.scan() == alone.scan() != ()
    assert len(looks) == 2  # the first, and the one that shares nothing
    for robot in (first, second, alone):
        robot.forward(10)  # the box is pushed
        robot.backward(10)
    assert first.scan() == second.scan() == alone.scan() != shared[next(iter(shared))]
    assert len(looks) == 4


def test_the_cameras_look_again_when_another_robot_has_moved(looks: list[Spot]) -> None:
    others = 'ideal( name "bob" pose [ 0.5 0 0 0 ] color "red" )'
    world = World(scene(IDEAL + f'ideal( name "alice" pose [ 0 0 0 0 ] )\n{others}'))
    alice, bob = (world.robot(name, pace=Unpaced()) for name in ("alice", "bob"))

    near = alice.scan()
    bob.forward(5)

    assert alice.scan()[0].steps == near[0].steps + 5
    assert len(looks) == 2


def test_a_reset_puts_things_back() -> None:
    world = World(scene(PUSHER + BOX.format(0.3, 0)))
    robot = world.robot(pace=Unpaced())
    first = robot.forward(10)
    robot.reset()

    assert things(world) == []
    assert robot.forward(10) == first


def test_a_stop_in_the_middle_leaves_the_thing_before_the_robot() -> None:
    world = World(scene(PUSHER + BOX.format(0.3, 0)))
    robot = world.robot(pace=Unpaced(stop_after=6.5), speed=1.0)

    moved = robot.forward(20)

    assert (moved.walked, moved.stopped_by) == (6, StoppedBy.USER)
    ((x, _),) = things(world)
    assert x == pytest.approx(moved.pose.x * 0.05 + 0.1 + 0.05, abs=0.001)


# --- grippers

GRIPPER = (
    BOX_ROBOT
    + """
define lifter position ( size [ 0.2 0.2 0.1 ] ranger( sonar( pose [ 0.1 0 0 0 ] ) )
  gripper( pose [ 0.15 0 0 0 ] size [ 0.1 0.1 0.1 ] ) )
lifter( pose [ 0 0 0 0 ] )
define ball model ( size [ 0.05 0.05 0.05 ] gripper_return 1 )
"""
)


def test_a_gripper_takes_carries_and_releases() -> None:
    world = World(scene(GRIPPER + 'ball( name "orange" pose [ 0.4 0 0 0 ] )'))
    robot = world.robot(pace=Unpaced())

    up_to_it = robot.forward(20)
    taken = robot.grip()
    robot.turn(90)
    carried = robot.backward(4)
    released = robot.release()
    robot.backward(4)

    assert up_to_it.stopped_by is StoppedBy.COLLISION
    assert (taken.outcome, taken.name) == (Grip.GRIPPED, "orange")
    assert carried.walked == 4
    assert (released.outcome, released.name) == (Grip.RELEASED, "orange")
    ((x, y),) = things(world)
    ahead = 0.4 - up_to_it.pose.x * 0.05
    assert (x, y) == pytest.approx((up_to_it.pose.x * 0.05, 0.2 - ahead), abs=0.001)


def test_a_held_thing_bumps_into_walls() -> None:
    world = World(scene(GRIPPER + "ball( pose [ 0.23 0 0 0 ] )" + WALL.format(0.6)))
    robot = world.robot(pace=Unpaced())
    alone = World(scene(GRIPPER + WALL.format(0.6))).robot(pace=Unpaced()).forward(20)

    robot.grip()
    moved = robot.forward(20)

    assert moved.stopped_by is not None
    (ball,) = world.moved_things().values()
    assert ball.x + 0.025 < 0.55
    assert moved.pose.x <= alone.pose.x


def test_a_refused_grip_has_a_reason() -> None:
    robot = World(scene(GRIPPER + "ball( pose [ 0.23 0 0 0 ] )")).robot(pace=Unpaced())

    answers = [robot.release(), robot.grip(), robot.grip(), robot.release()]

    assert [answer.outcome for answer in answers] == [
        Grip.HOLDS_NOTHING,
        Grip.GRIPPED,
        Grip.HOLDS_ALREADY,
        Grip.RELEASED,
    ]
    robot.backward(4)
    assert robot.grip().outcome is Grip.NOTHING_THERE


@pytest.mark.parametrize(
    ("x", "y", "grip"),
    [
        *(
            (0.27, 0, Grip.GRIPPED),
            (0.28, 0, Grip.NOTHING_THERE),
        ),  # the paddles end at 0.2, and a step is 0.05
        *((0.2, 0.07, Grip.GRIPPED), (0.2, 0.08, Grip.NOTHING_THERE)),
        *((0.2, -0.07, Grip.GRIPPED), (0.2, -0.08, Grip.NOTHING_THERE)),
    ],
)
def test_what_is_between_the_paddles_or_a_step_before_them_is_taken(x: float, y: float, grip: Grip) -> None:
    world = World(scene(GRIPPER + f"ball( pose [ {x} {y} 0 0 ] )"))

    assert world.robot(pace=Unpaced()).grip().outcome is grip


def test_of_two_things_the_one_nearer_to_the_middle_of_the_gripper_is_taken() -> None:
    near, far = 'ball( name "near" pose [ 0.2 0.03 0 0 ] )', 'ball( name "far" pose [ 0.2 -0.05 0 0 ] )'
    for balls in (near + far, far + near):
        assert World(scene(GRIPPER + balls)).robot(pace=Unpaced()).grip().name == "near"


def test_a_released_thing_is_no_longer_part_of_the_body() -> None:
    """It walks as far towards a wall behind it as a robot that never held anything."""
    behind = WALL.format(-0.6)
    world = World(scene(GRIPPER + "ball( pose [ 0.23 0 0 0 ] )" + behind))
    robot, never = (world.robot(pace=Unpaced()), World(scene(GRIPPER + behind)).robot(pace=Unpaced()))
    assert (robot.grip().outcome, robot.release().outcome) == (Grip.GRIPPED, Grip.RELEASED)

    ends = []
    for each in (robot, never):
        each.backward(2)
        each.turn(180)
        ends.append(each.forward(20))

    assert ends[0] == ends[1]
    assert ends[0].walked > 2


def test_a_robot_without_a_gripper_says_so() -> None:
    robot = World(scene(PUSHER)).robot(pace=Unpaced())

    with pytest.raises(RobotProblem, match="no-gripper"):
        robot.grip()
    with pytest.raises(RobotProblem, match="no-gripper"):
        robot.release()


def test_another_robot_can_neither_take_nor_push_a_held_thing() -> None:
    world = World(
        scene(GRIPPER + 'ball( pose [ 0.23 0 0 0 ] pushable 1 ) lifter( name "bob" pose [ 0.6 0 0 180 ] )')
    )
    robot, bob = world.robot(pace=Unpaced()), world.robot("bob", pace=Unpaced())
    robot.grip()

    met = bob.forward(20)

    assert met.stopped_by is StoppedBy.COLLISION
    assert bob.grip().outcome is Grip.NOTHING_THERE
    assert things(world) == []


def test_a_held_thing_between_the_paddles_of_another_robot_is_a_wall() -> None:
    narrow = "define narrow position ( size [ 0.2 0.02 0.1 ] ranger( sonar( pose [ 0 0 0 90 ] ) ) )\n"
    ball = "ball( pose [ 0.23 0 0 0 ] pushable 1 )"
    world = World(scene(GRIPPER + narrow + ball + 'narrow( name "bob" pose [ 0.6 0 0 180 ] )'))
    assert world.robot(pace=Unpaced()).grip().outcome is Grip.GRIPPED

    met = world.robot("bob", pace=Unpaced()).forward(20)

    assert met.stopped_by is StoppedBy.COLLISION
    assert met.pose.x * 0.05 == pytest.approx(0.23 + 0.025 + 0.1, abs=0.001)
    assert things(world) == []


def test_a_held_thing_stays_in_its_gripper_when_another_robot_is_reset() -> None:
    world = World(scene(GRIPPER + "ball( pose [ 0.23 0 0 0 ] )" + 'blind( name "bob" pose [ 0 2 0 0 ] )'))
    robot, bob = world.robot(pace=Unpaced()), world.robot("bob", pace=Unpaced())
    robot.grip()
    robot.turn(90)

    bob.reset()

    assert things(world) == [(0, -0.23)]


def test_a_robot_is_never_pushed_whatever_its_file_says() -> None:
    world = World(scene(PUSHER + 'blind( name "bob" pose [ 0.6 0 0 0 ] pushable 1 gripper_return 1 )'))
    bob = world.robot("bob", pace=Unpaced())

    assert world.robot(pace=Unpaced()).forward(20).stopped_by is StoppedBy.COLLISION
    assert world.moved_things() == {}
    assert bob.forward(2).walked == 2


def test_a_thing_on_a_thing_moves_with_it() -> None:
    box = "model( size [ 0.1 0.1 0.2 ] pose [ 0.3 0 0 0 ] pushable 1 model( size [ 0.2 0.05 0.1 ] ) )"
    world = World(scene(PUSHER + box + WALL.format(0.6)))

    moved = world.robot(pace=Unpaced()).forward(20)

    assert moved.stopped_by is StoppedBy.COLLISION
    assert things(world) == [(0.45, 0)]


FLAG = "model( size [ 0.3 0.1 0.1 ] pose [ 0.1 0 0 0 ] obstacle_return 0 )"
"""On a box it reaches 20 cm beyond it, and touches nothing."""


def test_a_part_of_a_pushed_thing_that_is_not_solid_stops_at_nothing() -> None:
    box = BOX.format(0.3, 0).replace(")", f"{FLAG} )")
    world = World(scene(PUSHER + box + WALL.format(0.8)))

    assert world.robot(pace=Unpaced()).forward(20).stopped_by is StoppedBy.COLLISION
    assert things(world) == [(0.7, 0)]


def test_a_thing_is_pushed_through_what_is_not_solid() -> None:
    world = World(scene(PUSHER + BOX.format(0.3, 0) + WALL.format(0.6).replace(")", "obstacle_return 0 )")))

    assert world.robot(pace=Unpaced()).forward(10).walked == 10
    assert things(world) == [(0.65, 0)]


def test_a_part_of_a_held_thing_that_is_not_solid_bumps_into_nothing() -> None:
    flag = "model( size [ 0.3 0.02 0.02 ] pose [ 0.1 0 0 0 ] obstacle_return 0 )"
    reached = []
    for more in ("", flag):
        world = World(scene(GRIPPER + f"ball( pose [ 0.23 0 0 0 ] {more} )" + WALL.format(0.8)))
        held = world.robot(pace=Unpaced())
        assert held.grip().outcome is Grip.GRIPPED
        reached.append(held.forward(20).pose)

    assert reached[0] == reached[1]


@pytest.mark.parametrize("joined", [False, True])
def test_an_endless_push_can_be_stopped(joined: bool) -> None:
    class Refusing(Unpaced):
        asked = 0

        def sleep(self, seconds: float) -> bool:
            self.asked += 1
            return self.asked < 300

    robot = World(scene(PUSHER + BOX.format(0.3, 0))).robot(pace=Refusing())
    if joined:
        robot.join()

    moved = robot.forward(1_000_000_000)

    assert moved.stopped_by is StoppedBy.USER
    assert 5 < moved.walked < 310, "it asks at least once a step"


@pytest.mark.parametrize(("count", "is_stopped"), [(20, False), (21, True)])
def test_twenty_things_can_be_pushed_at_a_time_and_one_more_is_like_a_wall(
    count: int, is_stopped: bool
) -> None:
    row = "\n".join(BOX.format(round(0.3 + 0.101 * i, 3), 0) for i in range(count))
    world = World(scene(PUSHER + row))

    moved = world.robot(pace=Unpaced()).forward(5)

    assert (moved.stopped_by is StoppedBy.COLLISION) is is_stopped
    assert (moved.walked == 5) is not is_stopped


def test_a_walk_reports_each_pushed_thing_and_how_far_it_moved() -> None:
    kind = "define crate model( size [ 0.1 0.1 0.2 ] pushable 1 )\n"
    world = World(scene(PUSHER + kind + 'crate( name "c" pose [ 0.3 0 0 0 ] color "blue" )'))
    robot = world.robot(pace=Unpaced())

    (pushed,) = robot.forward(10).pushed

    assert (pushed.kind, pushed.name, pushed.colour) == ("crate", "c", "blue")
    assert pushed.steps == pytest.approx(7, abs=0.01)
    assert robot.backward(2).pushed == ()


def test_a_carried_thing_turns_with_the_robot() -> None:
    world = World(scene(GRIPPER + 'ball( name "orange" pose [ 0.23 0 0 30 ] )'))
    robot = world.robot(pace=Unpaced())
    robot.grip()

    robot.turn(90)

    (ball,) = world.moved_things().values()
    assert ball.yaw % 360 == pytest.approx(300)
