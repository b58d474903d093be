"""Several robots in one world: whose turn it is, what they see of each other, how they stop."""

import threading
from collections.abc import Callable

import pytest

from devices.ports.robot import Bearing, StoppedBy, WalkResult
from language.control import ControlState, ExecutionControl
from sim.robot import SimulatedRobot
from sim.sensors import Senses
from sim.world import World
from tests.timeouts import TIMEOUT
from tests.unit.sim.company import Company
from tests.unit.sim.floors import BOX_ROBOT, IDEAL, Unpaced, scene

TWO = IDEAL + (
    'ideal( name "alice" pose [ 0 0 0 90 ] color "red" ) ideal( name "bob" pose [ 0 1 0 270 ] color "blue" )'
)
APART = IDEAL + 'ideal( name "alice" pose [ 0 0 0 90 ] ) ideal( name "bob" pose [ 5 0 0 90 ] )'


def stroll(robot: SimulatedRobot) -> None:
    for i in range(6):
        robot.forward(i % 3)
        robot.wait(i % 2 + 0.5)
        robot.turn(70 if robot.distance(Bearing.FRONT) > 20 else -110)


@pytest.mark.parametrize("speed", [None, 0.25, 1.0, 7.0, 100.0])
def test_programs_together_give_the_same_at_any_speed(speed: float | None) -> None:
    plain = Company(scene(TWO)).run({"alice": stroll, "bob": stroll})

    assert Company(scene(TWO), speed=speed).run({"alice": stroll, "bob": stroll}) == plain
    assert {name for name, *_ in plain} == {"alice", "bob"}


def test_programs_together_give_the_same_every_time() -> None:
    runs = [Company(scene(TWO)).run({"alice": stroll, "bob": stroll}) for _ in range(20)]

    assert all(run == runs[0] for run in runs)


def test_real_time_passes_once_for_all_robots() -> None:
    paces = {"alice": Unpaced(), "bob": Unpaced()}

    Company(scene(APART), speed=1.0).run(
        {"alice": lambda it: it.forward(5), "bob": lambda it: it.backward(5)}, paces
    )

    assert sum(sum(pace.slept) for pace in paces.values()) == pytest.approx(5.0)


def test_the_least_time_has_the_turn_and_of_equal_times_the_first_of_the_world() -> None:
    company = Company(scene(APART))

    def program(name: str, seconds: float) -> Callable[[SimulatedRobot], None]:
        def run(robot: SimulatedRobot) -> None:
            for _ in range(3):
                company.log.append((name, robot.time()))
                robot.wait(seconds)

        return run

    log = company.run({"bob": program("bob", 2), "alice": program("alice", 3)})

    assert log == [("alice", 0), ("bob", 0), ("bob", 2), ("alice", 3), ("bob", 4), ("alice", 6)]


def test_a_robot_sees_the_current_place_of_another() -> None:
    company = Company(scene(TWO))

    def looks(robot: SimulatedRobot) -> None:
        for _ in range(3):
            company.log.append((robot.time(), robot.distance(Bearing.FRONT), robot.scan()[0].steps))
            robot.wait(2)

    company.run({"alice": lambda it: it.forward(4), "bob": looks})

    seen = [entry for entry in company.log if isinstance(entry[0], float)]  # type: ignore[index]
    assert seen == [(0.0, 20, 20.0), (2.0, 18, 18.0), (4.0, 16, 16.0)]


def test_two_robots_that_walk_towards_each_other_stop_before_they_touch() -> None:
    company, ends = Company(scene(TWO)), {}

    def walks(robot: SimulatedRobot) -> None:
        ends[robot.name] = robot.forward(20)

    company.run({"alice": walks, "bob": walks})

    assert {moved.stopped_by for moved in ends.values()} == {StoppedBy.OBSTACLE}
    assert 1 <= ends["bob"].pose.y - ends["alice"].pose.y <= 2.5


def test_two_robots_without_sensors_bump_into_each_other_and_can_leave() -> None:
    blind = 'blind( name "alice" pose [ 0 0 0 0 ] ) blind( name "bob" pose [ 1 0 0 180 ] )'
    company, bumped, left = Company(scene(BOX_ROBOT + blind)), {}, {}

    def walks(robot: SimulatedRobot) -> None:
        bumped[robot.name] = robot.forward(20)
        robot.wait(20)
        left[robot.name] = robot.backward(3)

    company.run({"alice": walks, "bob": walks})

    assert {moved.stopped_by for moved in bumped.values()} == {StoppedBy.COLLISION}
    gap = (bumped["bob"].pose.x - bumped["alice"].pose.x) * 0.05 - 0.2
    assert 0 <= gap < 0.001
    assert {moved.stopped_by for moved in left.values()} == {None}


@pytest.mark.parametrize("further", [0.001, 0.003, 0.004, 0.006])
def test_two_robots_that_reach_one_place_in_one_tick_do_not_overlap(further: float) -> None:
    """Both found the last bit of the way free. The second to move finds it taken."""
    blind = f'blind( name "alice" pose [ 0 0 0 0 ] ) blind( name "bob" pose [ {1 + further} 0 0 180 ] )'
    company, ends = Company(scene(BOX_ROBOT + blind)), {}

    def walks(robot: SimulatedRobot) -> None:
        ends[robot.name] = robot.forward(20)

    company.run({"alice": walks, "bob": walks})

    assert {moved.stopped_by for moved in ends.values()} == {StoppedBy.COLLISION}
    assert 0 <= (ends["bob"].pose.x - ends["alice"].pose.x) * 0.05 - 0.2 < 0.001


def test_the_time_of_the_world_continues_after_a_reset() -> None:
    company = Company(scene(APART))

    def anew(robot: SimulatedRobot) -> None:
        robot.wait(3)
        robot.reset()
        company.log.append(("alice", robot.time()))
        robot.wait(2)
        company.log.append(("alice", robot.time()))

    def waits(robot: SimulatedRobot) -> None:
        for _ in range(3):
            robot.wait(2)
            company.log.append(("bob", robot.time()))

    log = company.run({"alice": anew, "bob": waits})

    assert log == [("bob", 2), ("alice", 0), ("bob", 4), ("alice", 2), ("bob", 6)]


def test_a_robot_that_did_not_join_acts_at_once_and_delays_no_other() -> None:
    world = World(scene(APART))
    alice, bob = (world.robot(name, pace=Unpaced()) for name in ("alice", "bob"))
    alice.join()

    assert bob.forward(3).walked == 3
    assert alice.forward(3).walked == 3
    alice.leave()


def test_an_expected_robot_that_never_starts_holds_the_others_until_it_leaves() -> None:
    world = World(scene(APART))
    alice, bob = (world.robot(name, pace=Unpaced()) for name in ("alice", "bob"))
    world.expect(["alice", "bob"])
    begun = threading.Event()

    def run() -> None:
        bob.join()
        begun.set()
        bob.leave()

    thread = threading.Thread(target=run)
    thread.start()

    assert not begun.is_set()
    alice.leave()
    assert begun.wait(TIMEOUT)
    thread.join(TIMEOUT)


class Switch:
    """A pace that the test can stop."""

    def __init__(self) -> None:
        self.stopped = False
        self.asked = threading.Event()

    def sleep(self, seconds: float) -> bool:
        self.asked.set()
        return not self.stopped


def test_the_others_can_be_stopped_while_a_program_computes_without_end() -> None:
    world, switch, bob_ended = World(scene(APART)), Switch(), threading.Event()
    alice, bob = world.robot("alice", pace=Unpaced()), world.robot("bob", pace=switch)
    world.expect(["alice", "bob"])
    alice.join()
    outcome: list[StoppedBy | None] = []

    def run() -> None:
        bob.join()
        outcome.append(bob.forward(3).stopped_by)
        bob.leave()
        bob_ended.set()

    thread = threading.Thread(target=run)
    thread.start()
    assert switch.asked.wait(TIMEOUT)
    switch.stopped = True
    bob.halt()

    assert bob_ended.wait(TIMEOUT)
    assert outcome == [StoppedBy.USER]
    alice.leave()
    thread.join(TIMEOUT)


@pytest.mark.parametrize(
    ("steps", "angle", "answer"), [(10, 0, "alice walked 10 in 10.00"), (0, 450, "alice turned 450 in 10.02")]
)
def test_a_newcomer_gets_its_turn_during_another_robots_long_movement(
    steps: int, angle: int, answer: str
) -> None:
    """At 1.55 s and 69.75 degrees: the last three quarters of a degree, a sixtieth of a second, are lost."""
    world, log = World(scene(APART)), list[str]()
    bob = world.robot("bob", pace=Unpaced(), speed=1.0)
    threads: list[threading.Thread] = []

    class Opening(Unpaced):
        """Lets bob join while alice walks."""

        def sleep(self, seconds: float) -> bool:
            if len(self.slept) == 30:
                threads.append(threading.Thread(target=visit))
                threads[0].start()
                while not bob_waits():
                    pass
            return super().sleep(seconds)

    def bob_waits() -> bool:
        return bool(world._turns.queue)

    def visit() -> None:
        bob.join()
        log.append(f"bob came at {alice.time():.2f}")
        bob.leave()

    alice = world.robot("alice", pace=Opening(), speed=1.0)
    alice.join()
    said = f"walked {alice.forward(steps).walked}" if steps else f"turned {alice.turn(angle).turned}"
    log.append(f"alice {said} in {alice.time():.2f}")
    alice.leave()
    threads[0].join(TIMEOUT)

    assert len(log) == 2
    assert log[0].startswith("bob came at 1.")
    assert log[1] == answer


def test_poses_are_reported_by_name_and_reset_returns_every_robot() -> None:
    company = Company(scene(APART))
    company.run({"alice": lambda it: it.forward(4), "bob": lambda it: it.turn(90)})
    world = company.world
    after = {name: (round(p.x, 6), round(p.y, 6), p.yaw) for name, p in world.poses().items()}

    world.reset()

    assert after == {"alice": (0, 0.2, 90), "bob": (5, 0, 0)}
    assert {name: (p.x, p.y, p.yaw) for name, p in world.poses().items()} == {
        "alice": (0, 0, 90),
        "bob": (5, 0, 90),
    }


def test_a_name_that_no_robot_has_is_refused() -> None:
    world = World(scene(APART))

    with pytest.raises(KeyError):
        world.robot("eve", pace=Unpaced())
    with pytest.raises(KeyError):
        world.expect(["eve"])


def test_a_paused_program_holds_the_world_and_another_can_still_be_stopped() -> None:
    world, controls = World(scene(APART)), {"alice": ExecutionControl(), "bob": ExecutionControl()}
    robots = {name: world.robot(name, pace=control, speed=50.0) for name, control in controls.items()}
    paused, ends = threading.Event(), dict[str, object]()
    controls["alice"].observe(lambda state: paused.set() if state is ControlState.PAUSED else None)
    world.expect(robots)

    def run(name: str, steps: int) -> None:
        robots[name].join()
        ends[name] = robots[name].forward(steps).stopped_by
        robots[name].leave()

    threads = {
        name: threading.Thread(target=run, args=(name, steps))
        for name, steps in (("alice", 40), ("bob", 99999))
    }
    for thread in threads.values():
        thread.start()
    controls["alice"].pause()
    assert paused.wait(TIMEOUT)
    held_at = robots["bob"].time()
    controls["bob"].stop()
    robots["bob"].halt()
    threads["bob"].join(TIMEOUT)

    assert ends == {"bob": StoppedBy.USER}
    assert robots["bob"].time() - held_at < 0.1
    controls["alice"].resume()
    threads["alice"].join(TIMEOUT)
    assert ends["alice"] is None


def test_a_command_that_is_stopped_before_its_turn_does_nothing() -> None:
    """The other robot holds the world, as its program has not begun."""
    control, ends = ExecutionControl(), list[WalkResult]()
    world = World(scene(APART))
    bob = world.robot("bob", pace=control)
    world.expect(("alice", "bob"))
    before = bob.pose()

    def run() -> None:
        bob.join()
        ends.append(bob.forward(3))

    thread = threading.Thread(target=run)
    thread.start()
    control.stop()
    bob.halt()
    thread.join(TIMEOUT)

    (moved,) = ends
    assert (moved.walked, moved.stopped_by, moved.pose) == (0, StoppedBy.USER, before)


def test_a_stopped_robot_leaves_and_the_others_continue() -> None:
    company, ends = Company(scene(APART), speed=1.0), dict[str, object]()

    def walks(robot: SimulatedRobot) -> None:
        ends[robot.name] = robot.forward(8).stopped_by

    company.run({"alice": walks, "bob": walks}, {"alice": Unpaced(stop_after=1.0), "bob": Unpaced()})

    assert ends == {"alice": StoppedBy.USER, "bob": None}


def test_sixty_robots_run_sixty_programs() -> None:
    names = [f"r{i}" for i in range(60)]
    robots = "".join(
        f'blind( name "{name}" pose [ {i % 8} {i // 8} 0 {i * 37} ] )' for i, name in enumerate(names)
    )
    company, walked = Company(scene(BOX_ROBOT + robots)), dict[str, int]()

    def walks(robot: SimulatedRobot) -> None:
        walked[robot.name] = robot.forward(4).walked

    company.run(dict.fromkeys(names, walks))

    assert walked == dict.fromkeys(names, 4)


@pytest.mark.parametrize("first", ["alice", "bob"])
def test_getting_a_world_ready_early_changes_no_result(first: str) -> None:
    """Two robots in each other's way, which stand inside a thing at the start."""
    text = TWO + "box( pose [ 0 0 0 0 ] ) box( pose [ 0 1 0 0 ] ) box( pose [ 0 0.5 0 0 ] pushable 1 )"

    def outcome(is_ready: bool) -> list[object]:
        world = World(scene(text))
        if is_ready:
            world.get_ready()
            world.get_ready()
        robots = {name: world.robot(name, pace=Unpaced()) for name in ("alice", "bob")}
        moved = robots[first].forward(30)
        return [moved, world.poses(), world.moved_things(), *(it.stands_in for it in robots.values())]

    assert outcome(is_ready=False) == outcome(is_ready=True)


def test_distances_are_cached_while_nothing_moves(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    looks: list[object] = []
    all_steps = Senses.all_steps
    monkeypatch.setattr(
        Senses, "all_steps", lambda self, *where: looks.append(where) or all_steps(self, *where)
    )
    company = Company(scene(TWO))
    alice, bob = company.robot("alice"), company.robot("bob")
    before = alice.known_distances()

    assert alice.known_distances() == before
    assert len(looks) == 1
    bob.backward(1)
    assert alice.known_distances()[Bearing.FRONT] == before[Bearing.FRONT] + 1
    alice.backward(1)
    assert alice.known_distances()[Bearing.FRONT] == before[Bearing.FRONT] + 2
    assert len(looks) == 3
