"""Robots that glide, and hand over their turn once in a step, give the same run as robots that tick."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from random import Random
from unittest.mock import patch

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from devices.ports.robot import STEP, Bearing, RobotProblem
from sim.clock import Clock, Glide
from sim.geometry import Placement, Spot
from sim.ground import Ground
from sim.motion import Mover
from sim.robot import SimulatedRobot
from sim.vehicle import Vehicle
from sim.world import World
from sim.worldfile import load_text
from tests.effort import examples
from tests.timeouts import TIMEOUT
from tests.unit.sim.floors import Unpaced

SONARS = "\n".join(f"sonar( pose [ 0 0 0 {90 * i} ] )" for i in range(4))
HEAD = f"""
define sonars ranger( {SONARS} )
define sonar sensor ( range [ 0.02 3.0 ] fov 15 )
define square position ( size [ 0.14 0.1 0.12 ] sonars( ) gripper( pose [ 0.1 0 -0.1 0 ] ) )
define long position ( size [ 0.3 0.1 0.12 ] velocity_bounds [ -0.03 0.04 0 0 0 0 -30 20 ] sonars( ) )
define soft position ( size [ 0.1 0.1 0.12 ] acceleration_bounds [ -0.01 0.01 0 0 0 0 -9 9 ] sonars( ) )
define can model ( size [ 0.08 0.08 0.2 ] pushable 1 gripper_return 1 )
define box model ( size [ 0.3 0.3 0.4 ] )
"""
KINDS = ("square", "long", "soft")
Trace = list[tuple[object, ...]]


def world_of(chance: Random, robots: int, things: int, side: float) -> str:
    lines = [HEAD]
    for i in range(robots):
        place = (
            f"{chance.uniform(-side, side):.3f} {chance.uniform(-side, side):.3f} 0 {chance.randrange(360)}"
        )
        lines.append(f'{chance.choice(KINDS)}( name "r{i}" pose [ {place} ] )')
    for _ in range(things):
        place = (
            f"{chance.uniform(-side, side):.3f} {chance.uniform(-side, side):.3f} 0 {chance.randrange(90)}"
        )
        lines.append(f"{chance.choice(('can', 'box'))}( pose [ {place} ] )")
    return "\n".join(lines)


def act(robot: SimulatedRobot, chance: Random) -> object:
    """Any command, with its result."""
    steps = chance.choice((1, 1, 2, 5))
    commands = (
        lambda: robot.forward(steps),
        lambda: robot.forward(1),
        lambda: robot.backward(steps),
        lambda: robot.turn(chance.choice((45, -45, 7, 90, 180))),
        lambda: robot.wait(chance.choice((0.1, 0.33, 1.0))),
        lambda: robot.distance(chance.choice(list(Bearing))),
        lambda: robot.known_distances(),
        lambda: robot.grip(),
        lambda: robot.release(),
    )
    try:
        return chance.choice(commands)()
    except RobotProblem as problem:
        return problem.code


def run(text: str, seed: int, commands: int) -> Trace:
    """What every robot did, in the order of the world."""
    world = World(load_text(text, Path("glides.world")))
    robots = [world.robot(name, pace=Unpaced()) for name in world.scene.robot_names]
    world.get_ready()
    trace: Trace = []

    def program(number: int, robot: SimulatedRobot) -> None:
        chance = Random(f"{seed} {number}")
        robot.join()
        try:
            for _ in range(commands):
                result = act(robot, chance)
                trace.append((number, repr(result), robot.time(), robot.placement))
        finally:
            robot.leave()

    world.expect(world.scene.robot_names)
    threads = [threading.Thread(target=program, args=each) for each in enumerate(robots)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(TIMEOUT)
        assert not thread.is_alive()
    trace.append((sorted(world.moved_things().items()),))
    return trace


@contextmanager
def only_ticks() -> Iterator[None]:
    with patch.object(Vehicle, "glides", False):
        yield


@settings(max_examples=examples(25), deadline=None)
@given(st.integers(0, 10**6), st.integers(2, 6), st.integers(0, 8), st.sampled_from((0.4, 1.0, 2.0)))
def test_gliding_changes_nothing(seed: int, robots: int, things: int, side: float) -> None:
    text = world_of(Random(seed), robots, things, side)

    gliding = run(text, seed, 25)
    with only_ticks():
        ticking = run(text, seed, 25)

    assert gliding == ticking


def test_a_robot_that_glides_is_seen_where_its_ticks_have_led() -> None:
    text = HEAD + ('square( name "a" pose [ 0 0 0 0 ] ) square( name "b" pose [ 2 0 0 180 ] )')
    world = World(load_text(text, Path("glides.world")))
    a, b = (world.robot(name, pace=Unpaced()) for name in "ab")
    world.expect("ab")
    seen: list[float] = []

    def walk() -> None:
        a.join()
        a.forward(4)
        a.leave()

    def look() -> None:
        b.join()
        for _ in range(4):
            b.wait(0.5)
            seen.append(world.poses()["b"].x - world.scene_now().models[0].pose.x)
        b.leave()

    threads = [threading.Thread(target=each) for each in (walk, look)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(TIMEOUT)

    assert seen == pytest.approx([2 - 0.025 * i for i in range(1, 5)], abs=0.0026)


def test_a_glide_that_has_just_begun_has_no_past_ticks_and_computes_no_times() -> None:
    def times() -> list[float]:
        raise AssertionError

    clock = Clock(Unpaced(), None)
    glide = Glide(0, clock, times, lambda _: Placement(), (0.0, 0.0, 0.05, 0.0), 0.1)

    assert glide.ticks((0.0, 1.0)) == 0


def test_a_robot_that_is_put_where_it_is_keeps_its_parts() -> None:
    """As one that was seen at the end of its glide."""
    ground = Ground(load_text(HEAD + 'square( name "a" pose [ 0 0 0 0 ] )', Path("glides.world")))
    ground.put(0, Placement(1.0, 0.0, 0.0, 30.0))
    parts = ground.parts_of(0)

    ground.put(0, Placement(1.0, 0.0, 0.0, 30.0))

    assert ground.parts_of(0) is parts
    assert ground.place(0) == Placement(1.0, 0.0, 0.0, 30.0)


def test_only_what_the_way_of_a_robot_comes_to_is_compared_with_its_body() -> None:
    """The robot is .1 m wide and long, the boxes .3 m: two on its way, two .02 m away from it."""
    places = ("0.22 0", "-0.22 0", "0 0.22", "0 -0.22")
    boxes = "".join(f"box( pose [ {place} 0 0 ] )\n" for place in places)
    scene = load_text(f"{HEAD}soft( pose [ 0 0 0 0 ] )\n{boxes}", Path("glides.world"))
    mover = Mover(Ground(scene), 0)

    ahead = mover.on_the_way(Spot(0.0, 0.0, 0.0), 0.0, STEP)
    back = mover.on_the_way(Spot(0.0, 0.0, 0.0), 180.0, STEP)

    assert [part.middle for part in ahead] == [(0.22, 0.0)]
    assert [part.middle for part in back] == [(-0.22, 0.0)]
