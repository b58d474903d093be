"""Properties of every walk and every turn among any things."""

from math import cos, hypot, radians, sin

from hypothesis import example, given, settings
from hypothesis import strategies as st

from devices.ports.robot import STEP, Bearing, StoppedBy
from sim.geometry import Spot, overlapping, placed
from sim.ground import Ground
from sim.motion import Mover, Surroundings
from sim.parts import body_of
from sim.scene import Scene
from sim.world import World
from tests.effort import examples
from tests.unit.sim.floors import Unpaced, scene

ROBOTS = {
    "octagon": (
        "define it position( size [ 0.128 0.128 0.12 ] block( points 8 point[0] [ 5 0 ] point[1] [ 12 0 ]"
        " point[2] [ 17 5 ] point[3] [ 17 12 ] point[4] [ 12 17 ] point[5] [ 5 17 ] point[6] [ 0 12 ]"
        " point[7] [ 0 5 ] z [ 0 1 ] ) ranger( s( pose [ 0.0635 0 0 0 ] ) s( pose [ -0.0635 0 0 180 ] ) ) )"
    ),
    "long": (
        "define it position( size [ 0.3 0.1 0.1 ] origin [ 0.05 0 0 0 ] ranger( s( pose [ 0 0 0 90 ] ) ) )"
    ),
    "toothed": (
        "define it position( size [ 0.25 0.2 0.2 ] origin [ 0.025 0 0 0 ]"
        " block( points 6 point[5] [ 0 0 ] point[4] [ 0 1 ] point[3] [ 0.75 1 ] point[2] [ 1 0.75 ]"
        " point[1] [ 1 0.25 ] point[0] [ 0.75 0 ] z [ 0 1 ] )"
        " block( points 4 point[3] [ 1 0.75 ] point[2] [ 1.25 0.75 ] point[1] [ 1.25 0.625 ]"
        " point[0] [ 1 0.625 ] z [ 0 0.5 ] )"
        " block( points 4 point[3] [ 1 0.375 ] point[2] [ 1.25 0.375 ] point[1] [ 1.25 0.25 ]"
        " point[0] [ 1 0.25 ] z [ 0 0.5 ] ) ranger( s( pose [ 0.15 0.0375 0 0 ] ) ) )"
    ),
}
SENSOR = "define s sensor( range [ 0.02 3 ] fov 15 )\n"

things = st.lists(
    st.tuples(
        st.floats(-2, 2).map(lambda v: round(v, 3)),
        st.floats(-2, 2).map(lambda v: round(v, 3)),
        st.sampled_from([0.002, 0.05, 0.3, 1.5]),
        st.sampled_from([0.001, 0.1, 0.6]),
        st.integers(0, 359),
    ).filter(lambda thing: hypot(thing[0], thing[1]) > 0.3 + thing[2] / 2 + thing[3] / 2),
    max_size=8,
)
commands = st.lists(
    st.tuples(st.sampled_from("fbt"), st.integers(-200, 200)).map(
        lambda c: (c[0], c[1] if c[0] == "t" else abs(c[1]) % 60)
    ),
    min_size=1,
    max_size=12,
)
STOPPED_A_HAIR_SHORT = [("b", 11), ("f", 25), ("t", -200), ("t", -194), ("b", 41)]
"""Its wall is touched twice: at the second time the disc lies 1e-17 m outside of what touches."""
Thing = tuple[float, float, float, float, int]


def world(kind: str, around: list[Thing], yaw: int) -> Scene:
    lines = [f"it( pose [ 0 0 0 {yaw} ] )"]
    lines += [f"model( size [ {w} {d} 1 ] pose [ {x} {y} 0 {a} ] )" for x, y, w, d, a in around]
    return scene(SENSOR + ROBOTS[kind] + "\n".join(lines))


@settings(max_examples=examples(120))
@example("octagon", [(-0.735, 0, 0.05, 0.6, 287)], 182, STOPPED_A_HAIR_SHORT)
@given(st.sampled_from(sorted(ROBOTS)), things, st.integers(0, 359), commands)
def test_a_robot_is_never_inside_a_thing(
    kind: str, around: list[Thing], yaw: int, program: list[tuple[str, int]]
) -> None:
    it = world(kind, around, yaw)
    robot = World(it).robot(pace=Unpaced())
    body, parts = body_of(it, 0), Surroundings(Ground(it), 0).parts

    for command, amount in program:
        before = robot.pose()
        match command:
            case "f":
                moved = robot.forward(amount)
                assert 0 <= moved.walked <= amount
                assert (moved.walked == amount) is (moved.stopped_by is None)
            case "b":
                moved = robot.backward(amount)
                assert 0 <= moved.walked <= amount
            case _:
                turned = robot.turn(amount)
                assert (before.x, before.y) == (turned.pose.x, turned.pose.y)
        pose = robot.pose()
        at = (pose.x * STEP, pose.y * STEP, 90 - pose.heading)
        bodies = [placed(points, *at) for points in body.polygons]
        assert not any(overlapping(mine, part.points) for mine in bodies for part in parts)


@settings(max_examples=examples(150))
@given(
    st.sampled_from(sorted(ROBOTS)),
    things,
    st.integers(0, 359),
    st.integers(0, 80),
    st.sampled_from([Bearing.FRONT, Bearing.BACK]),
)
def test_a_walk_at_once_equals_a_walk_observed_step_by_step(
    kind: str, around: list[Thing], yaw: int, steps: int, bearing: Bearing
) -> None:
    it = world(kind, around, yaw)
    mover = Mover(Ground(it), 0)
    start = Spot(0, 0, yaw)

    assert mover.walk(start, bearing, steps) == mover.walk(start, bearing, steps, careful=True)


@settings(max_examples=examples(80))
@given(st.integers(0, 359), st.floats(0.3, 2.5), st.integers(-60, 60), st.integers(1, 100))
def test_no_robot_passes_a_thin_wall_on_a_long_walk(yaw: int, away: float, slant: int, steps: int) -> None:
    """A wall thinner than a hair, across the way: the robot ends on its own side of it."""
    x, y = away * cos(radians(yaw)), away * sin(radians(yaw))
    wall = f"model( size [ 0.0001 20 1 ] pose [ {x} {y} 0 {yaw + slant} ] )"
    it = scene(SENSOR + ROBOTS["long"] + f"it( pose [ 0 0 0 {yaw} ] )" + wall)
    robot = World(it).robot(pace=Unpaced())

    moved = robot.forward(steps)

    east, north = moved.pose.x * STEP, moved.pose.y * STEP
    ahead = east * cos(radians(yaw)) + north * sin(radians(yaw))
    assert ahead < away
    if steps * STEP > away:
        assert moved.stopped_by is StoppedBy.COLLISION


@settings(max_examples=examples(40))
@given(things, st.integers(0, 359), commands)
def test_the_same_commands_give_the_same_answers(
    around: list[Thing], yaw: int, program: list[tuple[str, int]]
) -> None:
    def run() -> list[object]:
        robot = World(world("octagon", around, yaw)).robot(pace=Unpaced())
        does = {"f": robot.forward, "b": robot.backward, "t": robot.turn}
        return [does[command](amount) for command, amount in program] + [robot.time()]

    assert run() == run()
