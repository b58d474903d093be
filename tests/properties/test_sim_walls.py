"""No robot passes a wall, at any speed, heading, wall thickness or drive, alone or with others."""

from math import cos, radians, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from devices.ports.robot import RobotProblem, StoppedBy
from sim.geometry import overlapping, placed
from sim.parts import body_of
from sim.robot import SimulatedRobot
from sim.scene import Scene
from tests.effort import examples
from tests.properties.test_sim_motion import ROBOTS, SENSOR
from tests.unit.sim.company import Company
from tests.unit.sim.floors import scene

Commands = list[tuple[str, int]]
PLACES = ("alice", "bob")

drives = st.sampled_from(['drive "diff"', 'drive "omni"', 'drive "car" wheelbase 0.3', 'drive "car"'])
bounds = st.sampled_from(
    [
        "",
        "velocity_bounds [ -0.02 0.011 0 0 0 0 -13 31 ]",
        "velocity_bounds [ -9 9 0 0 0 0 -999 999 ]",
        "acceleration_bounds [ -0.02 0.01 0 0 0 0 -13 31 ]",
    ]
)
thicknesses = st.sampled_from([0.00001, 0.0001, 0.001, 0.02, 0.05, 0.3])
paces = st.sampled_from([None, 20.0, 1000.0])
programs = st.lists(
    st.one_of(
        st.tuples(st.just("f"), st.integers(1, 70)),
        st.tuples(st.just("b"), st.integers(1, 70)),
        st.tuples(st.just("t"), st.integers(-200, 200)),
    ),
    min_size=1,
    max_size=4,
)


class Bounded:
    """A pace that stops an endless program. The slowest robot calls it some ten thousand times."""

    def __init__(self) -> None:
        self._left = 200_000

    @property
    def is_over(self) -> bool:
        return self._left <= 0

    def sleep(self, seconds: float) -> bool:
        self._left -= 1
        return self._left > 0


def hall(kind: str, wheels: str, yaw: int, away: float, slant: int, thickness: float) -> Scene:
    """Two robots back to back on this side of a wall that is longer than they can walk."""
    x, y = (away + thickness / 2) * cos(radians(yaw)), (away + thickness / 2) * sin(radians(yaw))
    made = ROBOTS[kind].replace("define it position(", f"define it position( {wheels}")
    bx, by = -1.2 * cos(radians(yaw)), -1.2 * sin(radians(yaw))
    return scene(
        f'{SENSOR}{made}\nit( name "alice" pose [ 0 0 0 {yaw} ] )\n'
        f'it( name "bob" pose [ {bx} {by} 0 {yaw} ] )\n'
        f"model( size [ {thickness} 60 1 ] pose [ {x} {y} 0 {yaw + slant} ] )"
    )


def stays_on_its_side(it: Scene, company: Company, robot: SimulatedRobot) -> None:
    """Neither beyond the wall nor in it."""
    wall, me = it.models[-1], it.robot(robot.name)
    place = robot.placement
    c, s = cos(radians(wall.pose.yaw)), sin(radians(wall.pose.yaw))
    depths = [
        (x - wall.pose.x) * c + (y - wall.pose.y) * s for x, y in ((place.x, place.y), (me.pose.x, me.pose.y))
    ]
    assert max(depths) < 0 or min(depths) > 0
    bodies = [placed(each, place.x, place.y, place.yaw) for each in body_of(it, me.index).polygons]
    assert not any(overlapping(body, outline) for body in bodies for outline in wall.outlines())


@settings(max_examples=examples(25))
@given(
    st.sampled_from(sorted(ROBOTS)),
    st.tuples(drives, bounds).map(" ".join),
    st.integers(0, 359),
    st.floats(0.4, 2.5).map(lambda v: round(v, 4)),
    st.integers(-50, 50),
    thicknesses,
    paces,
    st.tuples(programs, st.one_of(st.none(), programs)),
)
def test_no_robot_passes_a_wall(
    kind: str,
    wheels: str,
    yaw: int,
    away: float,
    slant: int,
    thickness: float,
    speed: float | None,
    both: tuple[Commands, Commands | None],
) -> None:
    it = hall(kind, wheels, yaw, away, slant, thickness)
    company = Company(it, speed=speed)
    paces = {name: Bounded() for name in PLACES}

    def doing(program: Commands) -> object:
        def run(robot: SimulatedRobot) -> None:
            for command, amount in program:
                try:
                    {"f": robot.forward, "b": robot.backward, "t": robot.turn}[command](amount)
                except RobotProblem as problem:
                    assert problem.code in ("cannot-turn", "cannot-drive")
                stays_on_its_side(it, company, robot)

        return run

    given_ = {"alice": both[0]} | ({} if both[1] is None else {"bob": both[1]})
    company.run({name: doing(program) for name, program in given_.items()}, paces)  # type: ignore[misc]
    assert not any(pace.is_over for pace in paces.values()), "a command goes on for ever"


def test_a_robot_that_drives_straight_at_a_wall_stops_at_it_forward_and_backward() -> None:
    """Without this the property could hold because no robot reaches the wall."""
    for thickness in (0.00001, 0.3):
        for turned, command in ((0, "forward"), (180, "backward")):
            it = hall("octagon", 'drive "diff"', 0, 1.0, 0, thickness)
            robot = Company(it).robot("alice")
            robot.turn(turned)
            walked = getattr(robot, command)(60).walked
            assert 14 <= walked < 20


@pytest.mark.parametrize("thickness", [0.00001, 0.3])
@pytest.mark.parametrize("wheels", ["", "acceleration_bounds [ -0.02 0.05 0 0 0 0 -90 90 ]"])
def test_robots_without_sensors_bump_into_the_wall_and_into_each_other(thickness: float, wheels: str) -> None:
    """Both move in ticks and have no sensor in that direction, so that only their bodies stop them."""
    it = hall("long", wheels, 0, 0.4, 0, thickness)
    company, paces = Company(it), {name: Bounded() for name in PLACES}
    ends = dict[str, object]()

    def bump(robot: SimulatedRobot) -> None:
        ends[robot.name] = robot.forward(40).stopped_by
        stays_on_its_side(it, company, robot)

    company.run(dict.fromkeys(PLACES, bump), paces)  # type: ignore[arg-type]

    assert ends == dict.fromkeys(PLACES, StoppedBy.COLLISION)
    assert not any(pace.is_over for pace in paces.values())
