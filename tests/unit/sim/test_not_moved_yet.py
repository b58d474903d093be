"""A robot before its first command: what it reports. Creating its parts late changes no result."""

import threading
from collections.abc import Callable

import pytest

from devices.ports.robot import Bearing, Grip, Pose
from sim import vehicle
from sim.geometry import Placement
from sim.ground import Ground
from sim.robot import SimulatedRobot
from sim.scene import Scene
from sim.vehicle import Vehicle
from sim.world import World
from tests.timeouts import TIMEOUT
from tests.unit.sim.floors import BOX_ROBOT, IDEAL, Unpaced, scene

ODOM = 'localization "odom" odom_error [ 0.3 0.3 0.5 ]'
NOISY = (
    "define sonar sensor ( range [ 0 3.0 ] fov 15 noise [ 0.5 0.1 4 ] )\n"
    f"define it position ( size [ 0.2 0.1 0.1 ] {ODOM} ranger( sonar( pose [ 0.1 0 0 0 ] ) ) )\n"
    "define box model ( size [ 0.1 0.1 0.2 ] )\n"
)
HALL = (
    NOISY
    + 'it( name "alice" pose [ 0 0 0 -90 ] ) it( name "bob" pose [ 1 0 0 450 ] ) box( pose [ 0 -2 0 0 ] )'
)


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> list[object]:
    """Records the robots for which a vehicle was created."""
    robots: list[object] = []

    class Counted(Vehicle):
        def __init__(self, *arguments: object) -> None:
            robots.append(arguments[1])
            super().__init__(*arguments)  # type: ignore[arg-type]

    monkeypatch.setattr(vehicle, "Vehicle", Counted)
    return robots


def test_description_and_pose_need_neither_vehicle_nor_senses(made: list[object]) -> None:
    it = World(scene(IDEAL + 'ideal( name "alice" pose [ 0.1 0.2 0 -90 ] )')).robot(pace=Unpaced())

    it.join()
    assert (it.name, it.colours, it.holds) == ("alice", {"red", "green", "blue"}, None)
    assert (it.pose(), it.placement) == (Pose(2.0, 4.0, 180.0), Placement(0.1, 0.2, 0.0, 270.0))
    assert it.wait(2.0)
    assert it.time() == 2.0
    it.halt()
    it.reset()
    it.leave()

    assert made == []
    it.forward(1)
    assert len(made) == 1


def test_the_vehicle_is_created_once_however_many_threads_ask_first(made: list[object]) -> None:
    world = World(scene(HALL))
    alice, together = world.robot("alice", pace=Unpaced()), threading.Barrier(8)

    def ask(what: Callable[[], object]) -> None:
        together.wait(TIMEOUT)
        what()

    asked = (alice.known_distances, world.get_ready, alice.pose, alice.get_ready)
    threads = [threading.Thread(target=ask, args=(each,)) for each in asked * 2]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(TIMEOUT)

    assert made == [0]


def stroll(robot: SimulatedRobot) -> list[object]:
    return [
        each
        for steps in (3, 30, 5)
        for each in (robot.distance(Bearing.FRONT), robot.forward(steps), robot.turn(40), robot.pose())
    ]


@pytest.mark.parametrize("is_ready", [False, True], ids=["late", "early"])
def test_the_error_does_not_depend_on_when_the_vehicle_is_created(is_ready: bool) -> None:
    """In its first run, in each later one, and after a reset before its first movement."""
    plain = stroll(World(scene(HALL), seed=3).robot(pace=Unpaced()))
    world = World(scene(HALL), seed=3)
    robot = world.robot(pace=Unpaced())
    robot.reset()
    if is_ready:
        world.get_ready()
        robot.reset()

    assert stroll(robot) == plain
    robot.reset()
    assert stroll(robot) == plain
    assert plain != stroll(World(scene(HALL)).robot(pace=Unpaced()))


def test_a_layer_does_not_depend_on_whether_things_moved_before_it_was_created() -> None:
    """To the last digit: the speed of the threads decides which robot is ready first."""
    hall: Scene = scene(HALL)
    early, late = Ground(hall), Ground(hall)
    guard = early.guarded(0.3)
    for ground in (early, late):
        ground.put(hall.robot("bob").index, Placement(0.7, 0.3, 0.0, 33.3))
    late.guarded(0.3)

    for x in range(20):
        where = (hall.robot("alice").index, 0.1 * x, 1.0)
        assert early.still_room(*where[1:], guard) == late.still_room(*where[1:], guard)
        way = (*where, (0.7, -0.5 + 0.1 * x), guard, frozenset[int]())
        assert early.free_way(*way) == late.free_way(*way)


def test_a_recreated_robot_stands_at_its_start_for_the_others_too() -> None:
    """The same holds for a simulated robot after a real one replaced it for a while."""
    gripper = "gripper( size [ 0.05 0.1 0.1 ] pose [ 0.12 0 0 0 ] )"
    world = World(
        scene(
            BOX_ROBOT
            + f'box_robot( name "alice" {gripper} ) box_robot( name "bob" pose [ 0 1 0 270 ] )'
            + 'model( name "can" size [ 0.04 0.04 0.1 ] pose [ 0.17 0 0 0 ] gripper_return 1 )'
        )
    )
    bob, before = world.robot("bob", pace=Unpaced()), world.robot("alice", pace=Unpaced())
    seen = bob.distance(Bearing.FRONT)
    assert before.grip().outcome is Grip.GRIPPED
    before.forward(20)
    assert bob.distance(Bearing.FRONT) > seen

    alice = world.robot("alice", pace=Unpaced())

    assert alice.pose() == Pose(0.0, 0.0, 90.0)
    assert bob.distance(Bearing.FRONT) == seen
    alice.forward(20)
    assert alice.grip().outcome is Grip.GRIPPED
