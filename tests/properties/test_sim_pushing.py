"""A robot pushes only things in its way, or in the way of pushed things."""

from collections.abc import Iterable

from hypothesis import example, given, settings
from hypothesis import strategies as st

from sim.geometry import seen_from
from sim.ground import Ground
from sim.motion import Mover
from sim.world import World
from tests.effort import examples
from tests.properties.test_sim_motion import ROBOTS, SENSOR
from tests.unit.sim.floors import STEP, Unpaced, scene

HAIR = 1e-9
"""Metres that computing errs, at most."""
SIDE = 0.15
"""Metres that a box is wide: boxes on neighbouring places of the lattice touch all along a side."""

Program = list[tuple[str, int]]
places = st.lists(
    st.tuples(st.integers(-4, 4), st.integers(-4, 4)).filter(lambda place: max(map(abs, place)) > 1),
    unique=True,
    max_size=8,
)
programs = st.lists(
    st.one_of(
        st.tuples(st.sampled_from("fb"), st.integers(1, 20)),
        st.tuples(st.just("t"), st.sampled_from((90, -90, 180, 45, 17))),
    ),
    min_size=1,
    max_size=8,
)
Way = tuple[float, float]
"""What a body takes up across a direction, from right to left."""


def across(outlines: Iterable[Iterable[tuple[float, float]]], x: float, y: float, angle: float) -> Way:
    lefts = [left for points in outlines for _, left in seen_from(points, x, y, angle)]
    return min(lefts), max(lefts)


def meet(one: Way, other: Way) -> bool:
    return one[0] < other[1] - HAIR and other[0] < one[1] - HAIR


@settings(max_examples=examples(60))
@example("octagon", [(-4, 0)], [("t", 90), ("t", 90), ("f", 15), ("t", -90), ("f", 5)])
@example("octagon", [(4, 0)], [("f", 15), ("t", 90), ("f", 5), ("b", 9)])
@example("long", [(4, 0), (4, 1), (4, -1), (3, 1)], [("f", 20)])
@given(st.sampled_from(sorted(ROBOTS)), places, programs)
def test_only_things_in_the_way_are_pushed(kind: str, boxes: list[tuple[int, int]], program: Program) -> None:
    lines = (
        f"model( size [ {SIDE} {SIDE} 1 ] pose [ {x * SIDE} {y * SIDE} 0 0 ] pushable 1 )" for x, y in boxes
    )
    it = scene(SENSOR + ROBOTS[kind] + "it( pose [ 0 0 0 0 ] )" + "\n".join(lines))
    world = World(it)
    robot, body = world.robot(pace=Unpaced()), Mover(Ground(it), 0).body

    for command, amount in program:
        pose, ground = robot.pose(), world.ground
        x, y, angle = pose.x * STEP, pose.y * STEP, 90 - pose.heading
        before = {
            root: across((part.points for part in ground.parts_of(root)), x, y, angle)
            for root in ground.pushable
        }
        were = {root: ground.place(root) for root in ground.pushable}
        mine = (-body.radius, body.radius) if body.is_round else across(body.polygons, 0, 0, 0)

        {"f": robot.forward, "b": robot.backward, "t": robot.turn}[command](amount)

        pushed = {root for root in ground.pushable if ground.place(root) != were[root]}
        for root in pushed:
            pushers = (mine, *(before[other] for other in pushed - {root}))
            assert any(meet(before[root], each) for each in pushers)
