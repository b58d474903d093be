"""Properties of several robots in one world with any things and any programs."""

from itertools import combinations
from math import hypot

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from devices.ports.robot import Pose
from sim.geometry import overlapping, placed
from sim.ground import Ground
from sim.motion import Mover
from sim.robot import SimulatedRobot
from sim.scene import Scene
from tests.effort import examples
from tests.properties.test_sim_motion import ROBOTS, SENSOR, Thing, commands, things
from tests.unit.sim.company import Company, Program
from tests.unit.sim.floors import scene

Commands = list[tuple[str, int]]
PLACES = {"alice": (0.0, 0.0), "bob": (0.6, 0.0), "eve": (0.0, 0.6)}
kinds = st.sampled_from(sorted(ROBOTS))
wheels = st.sampled_from(["", "acceleration_bounds [ -0.02 0.031 0 0 0 0 -40 90 ]"])
strolls = commands.map(lambda program: [(c, n if c == "t" else n % 16) for c, n in program[:6]])
"""Short ones: much is looked at while several robots move."""


def several(kind: dict[str, str], around: list[Thing], yaw: int, pushable: bool, mounted: str = "") -> Scene:
    """A floor with robots of these kinds, without the things that stand too near to one of them."""
    text = SENSOR + "".join(ROBOTS[each].replace("define it", f"define {each}") + "\n" for each in ROBOTS)
    for turn, (name, model) in enumerate(kind.items()):
        x, y = PLACES[name]
        text += f'{model}( name "{name}" pose [ {x} {y} 0 {yaw + 120 * turn} ] {mounted} )\n'
    clear = [
        thing
        for i, thing in enumerate(around)
        if all(
            hypot(thing[0] - x, thing[1] - y) > 0.3 + thing[2] / 2 + thing[3] / 2 for x, y in PLACES.values()
        )
        and all(
            hypot(thing[0] - o[0], thing[1] - o[1]) > (thing[2] + thing[3] + o[2] + o[3]) / 2
            for o in around[:i]
        )
    ]
    for i, (x, y, width, depth, angle) in enumerate(clear):
        gives_way = int(pushable and i % 2 == 0)
        text += f"model( size [ {width} {depth} 1 ] pose [ {x} {y} 0 {angle} ] pushable {gives_way} )\n"
    return scene(text)


def doing(program: Commands, note: Program | None = None) -> Program:
    def run(robot: SimulatedRobot) -> None:
        for command, amount in program:
            {"f": robot.forward, "b": robot.backward, "t": robot.turn}[command](amount)
            if note:
                note(robot)

    return run


def nothing_overlaps(it: Scene, ground: Ground, bodies: dict[str, Mover]) -> bool:
    """No robot or movable thing overlaps with another one or with a fixed thing."""
    solid: dict[int, list[tuple[tuple[float, float], ...]]] = {}
    for root in ground.movable:
        name, now = it.models[root].name, ground.place(root)
        if name in bodies:
            polygons = bodies[name].body.polygons
            solid[root] = [placed(points, now.x, now.y, now.yaw) for points in polygons]
        else:
            solid[root] = [part.points for part in ground.parts_of(root)]
    still = [part.points for part in ground.parts() if part.root not in ground.movable]
    pairs = [(a, b) for one, other in combinations(solid, 2) for a in solid[one] for b in solid[other]]
    pairs += [(a, b) for polygons in solid.values() for a in polygons for b in still]
    return not any(overlapping(a, b) for a, b in pairs)


@settings(max_examples=examples(40))
@given(
    st.tuples(kinds, kinds, kinds),
    things,
    st.integers(0, 359),
    st.booleans(),
    st.lists(strolls, min_size=3, max_size=3),
)
def test_robots_and_things_never_overlap(
    kind: tuple[str, ...], around: list[Thing], yaw: int, pushable: bool, programs: list[Commands]
) -> None:
    it = several(dict(zip(PLACES, kind, strict=True)), around, yaw, pushable)
    company = Company(it)
    ground = company.world.ground
    bodies = {name: Mover(ground, it.robot(name).index) for name in PLACES}

    def check(robot: SimulatedRobot) -> None:
        assert nothing_overlaps(it, ground, bodies), robot.name

    company.run({name: doing(program, check) for name, program in zip(PLACES, programs, strict=True)})


@settings(max_examples=examples(40))
@given(kinds, wheels, things, st.integers(0, 359), st.booleans(), strolls)
def test_ticks_and_one_sweep_give_the_same_where_one_robot_moves(
    kind: str, mounted: str, around: list[Thing], yaw: int, pushable: bool, program: Commands
) -> None:
    it = several({"alice": kind, "bob": "octagon"}, around, yaw, pushable, mounted)

    def run(disturbed: bool) -> tuple[list[object], list[float]]:
        """The exact events, and all numbers of places and times."""
        whats, wheres, over = list[object](), list[float](), list[bool]()
        company = Company(it)

        def acts(robot: SimulatedRobot) -> None:
            for command, amount in program:
                done = {"f": robot.forward, "b": robot.backward, "t": robot.turn}[command](amount)
                whats.append(done.stopped_by)
                wheres.extend((*_numbers(done.pose), robot.time()))
            over.append(True)

        def disturbs(robot: SimulatedRobot) -> None:
            while disturbed and not over:
                robot.wait(0.04)

        for name, motion, pose in company.run({"alice": acts, "bob": disturbs}):  # type: ignore[misc]
            whats.append((name, motion))
            wheres.extend(_numbers(pose))
        for now in company.world.moved_things().values():
            wheres.extend((now.x, now.y, now.yaw))
        return whats, wheres

    whats, wheres = run(disturbed=False)
    ticked = run(disturbed=True)

    assert ticked[0] == whats
    assert ticked[1] == pytest.approx(wheres, abs=1e-6)


def _numbers(pose: Pose) -> tuple[float, float, float]:
    return pose.x, pose.y, pose.heading


@settings(max_examples=examples(25))
@given(st.tuples(kinds, kinds), things, st.integers(0, 359), strolls, strolls)
def test_the_same_programs_give_the_same_run(
    kind: tuple[str, str], around: list[Thing], yaw: int, first: Commands, second: Commands
) -> None:
    it = several(dict(zip(PLACES, kind, strict=False)), around, yaw, pushable=True)

    def run() -> list[object]:
        return Company(it).run({"alice": doing(first), "bob": doing(second)})

    assert run() == run()
