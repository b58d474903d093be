"""When movements report what, and where they end. A step takes a second, and 45 degrees do."""

import threading
from math import cos, degrees, radians, sin

import pytest

from devices.ports.robot import Motion, StoppedBy
from sim.geometry import Placement
from sim.movement import _turned
from sim.robot import SimulatedRobot
from sim.vehicle import Rate
from sim.world import World
from tests.timeouts import TIMEOUT
from tests.unit.sim.company import Company
from tests.unit.sim.floors import BOX_ROBOT, Diary, Unpaced, scene

BLIND = BOX_ROBOT + "blind( pose [ 0 0 0 0 ] )\n"
"""0.2 m long, 0.1 m wide, looks to the east."""


def watched(
    text: str, speed: float | None = None, stop_after: float = float("inf")
) -> tuple[SimulatedRobot, Diary]:
    diary = Diary()
    it = World(scene(text)).robot(pace=Unpaced(stop_after), watcher=diary, speed=speed)
    diary.robot = it
    return it, diary


@pytest.mark.parametrize(
    ("steps", "reports"),
    [
        (999, [*range(1, 1000)]),
        (1000, [*range(1, 1001)]),
        (1001, [*range(2, 1001, 2), 1001]),
        (2000, [*range(2, 2001, 2)]),
        (2001, [*range(3, 2002, 3)]),
        (2002, [*range(3, 2002, 3), 2002]),
    ],
)
def test_a_long_walk_reports_every_so_many_steps_and_its_last_one(steps: int, reports: list[int]) -> None:
    it, diary = watched(BLIND)

    it.forward(steps)

    assert [round(pose.x, 6) for _, pose, _ in diary.progress] == reports
    assert [seconds for *_, seconds in diary.progress] == pytest.approx(reports)


@pytest.mark.parametrize(
    ("angle", "reports"),
    [
        (9, [9]),
        (10, [10]),
        (11, [10, 11]),
        (10_000, [*range(10, 10_001, 10)]),
        (10_001, [*range(20, 10_001, 20), 10_001]),
        (10_020, [*range(20, 10_021, 20)]),
    ],
)
def test_a_long_turn_reports_every_so_many_degrees_and_its_last_one(angle: int, reports: list[int]) -> None:
    it, diary = watched(BLIND)

    it.turn(-angle)

    assert [pose.heading for _, pose, _ in diary.progress] == [(90 - each) % 360 for each in reports]
    assert [seconds for *_, seconds in diary.progress] == pytest.approx([each / 45 for each in reports])
    assert {motion for motion, *_ in diary.progress} == {Motion.LEFT}


@pytest.mark.parametrize(
    ("rate", "begin", "end", "stops"),
    [
        (45.0, 0, 45, [*range(2, 45, 2), 45]),
        (45.0, 3, 13, [5, 7, 9, 10, 12, 13]),
        (20.0, 0, 3, [1, 2, 3]),
        (0.1, 0, 2, [1, 2]),
        (140.0, 8, 33, [10, 17, 20, 27, 30, 33]),
        (900.0, 5, 23, [10, 20, 23]),
        (45.0, 7, 7, []),
    ],
)
def test_a_turn_is_divided_into_whole_degrees_of_a_tick_up_to_each_report(
    rate: float, begin: int, end: int, stops: list[int]
) -> None:
    """A tick is a twentieth of a second, and at least a degree."""
    assert _turned(Rate(rate).over(90), begin, end) == stops


def test_the_times_of_reports_go_on_after_other_commands() -> None:
    it, diary = watched(BLIND)
    it.wait(0.5)
    it.turn(45)
    it.turn(-45)
    diary.progress.clear()

    it.forward(2)
    it.backward(1)
    it.turn(10)

    assert [seconds for *_, seconds in diary.progress] == pytest.approx([3.5, 4.5, 5.5, 5.5 + 10 / 45])


@pytest.mark.parametrize("speed", [None, 4.0])
def test_what_ends_at_a_wall_reports_its_whole_steps_and_degrees(speed: float | None) -> None:
    """The front comes to the wall after 7 steps and 0.999; a corner to the other one after 36.87 degrees."""
    ahead = "model( size [ 0.2 4 1 ] pose [ 0.6 0 0 0 ] )\n"
    aside = "model( size [ 4 0.2 1 ] pose [ 0 0.2 0 0 ] )\n"
    it, diary = watched(BLIND + ahead, speed)
    at_side, other = watched(BLIND + aside, speed)

    walked, turned = it.forward(9), at_side.turn(-90)

    assert (walked.walked, walked.stopped_by, turned.turned, turned.stopped_by) == (
        *(7, StoppedBy.COLLISION),
        *(-36, StoppedBy.COLLISION),
    )
    assert walked.pose.x == pytest.approx(7.998)
    assert it.time() == pytest.approx(7.998)
    assert [seconds for *_, seconds in diary.progress] == pytest.approx([1, 2, 3, 4, 5, 6, 7])
    assert [round(pose.x, 6) for _, pose, _ in diary.progress] == [1, 2, 3, 4, 5, 6, 7]
    assert [pose.heading for _, pose, _ in other.progress] == [80, 70, 60, 54]
    assert at_side.time() == pytest.approx(36 / 45)


@pytest.mark.parametrize("seconds", [2.0, 2.5])
@pytest.mark.parametrize("wall", ["", "model( size [ 0.2 4 1 ] pose [ 0.6 0 0 0 ] )"])
def test_what_a_stop_ends_is_not_reported_and_the_next_command_begins_there(
    wall: str, seconds: float
) -> None:
    """Before it comes to the wall, if there is one."""
    it, diary = watched(BLIND + wall, 1.0, stop_after=seconds)

    walked = it.forward(9)

    assert (walked.walked, walked.stopped_by, walked.pose.x) == (2, StoppedBy.USER, pytest.approx(seconds))
    assert len(diary.progress) == 2
    it.speed = None
    assert it.forward(0).stopped_by is None
    assert it.pose().x == pytest.approx(seconds)


@pytest.mark.parametrize(("stop_after", "done"), [(0.5, 22), (0.6, 26)])
def test_a_stop_ends_a_turn_at_its_last_whole_degree(stop_after: float, done: int) -> None:
    """After the report of 20 degrees it looks every 2.25 degrees: last at 22.25 and 26.75."""
    it, diary = watched(BLIND, 1.0, stop_after)

    turned = it.turn(-90)

    assert (turned.turned, turned.stopped_by, turned.pose.heading) == (-done, StoppedBy.USER, 90 - done)
    assert [pose.heading for _, pose, _ in diary.progress] == [80, 70]


@pytest.mark.parametrize("speed", [1.0, 2.0])
def test_poses_on_the_way_are_a_slice_of_real_time_apart(speed: float) -> None:
    """They begin anew at each report: of a turn after 10 degrees."""
    it, diary = watched(BLIND, speed)

    it.forward(2)
    walked = [pose.x for pose in diary.passed]
    diary.passed.clear()
    it.turn(-90)
    turned = [(90 - pose.heading) % 360 for pose in diary.passed]

    slices = int(2 / 0.05 / speed)
    assert walked == pytest.approx([0.05 * speed * (i + 1) for i in range(slices)])
    parts = [2.25 * speed * (i + 1) for i in range(4) if 2.25 * speed * (i + 1) < 10]
    assert turned == pytest.approx([ten * 10 + part for ten in range(9) for part in parts])


# --- pushing

CRATE = "model( size [ 0.1 0.1 0.2 ] pose [ 0.3 0 0 0 ] pushable 1 )\n"
"""Its side is at 0.25 m, 3 steps ahead."""


@pytest.mark.parametrize("speed", [None, 4.0])
@pytest.mark.parametrize(("x", "walked", "end"), [(9, 10, 10), (0.75, 8, 8.996)])
def test_a_walk_that_pushes_takes_as_long_as_any_other(
    speed: float | None, x: float, walked: int, end: float
) -> None:
    """With a wall at 0.65 m the crate ends before it, and the robot before the crate: a skin each."""
    it, diary = watched(f"{BLIND}{CRATE}model( size [ 0.2 4 1 ] pose [ {x} 0 0 0 ] )", speed)

    moved = it.forward(10)

    assert (moved.walked, moved.stopped_by) == (walked, None if x == 9 else StoppedBy.COLLISION)
    assert moved.pose.x == pytest.approx(end, abs=0.005)
    assert it.time() == pytest.approx(moved.pose.x)
    assert [seconds for *_, seconds in diary.progress][:walked] == pytest.approx([*range(1, walked + 1)])
    assert [round(pose.x, 6) for _, pose, _ in diary.progress][:walked] == [*range(1, walked + 1)]
    assert moved.pushed[0].steps == pytest.approx(moved.pose.x - 3, abs=0.005)


def test_a_crate_that_was_pushed_is_pushed_on_by_the_next_walk() -> None:
    it, _ = watched(BLIND + CRATE)

    pushed = [it.forward(steps).pushed for steps in (2, 2, 2)]

    assert pushed[0] == ()
    assert [each[0].steps for each in pushed[1:]] == pytest.approx([1, 2], abs=0.005)


# --- cars


@pytest.mark.parametrize(("wheelbase", "speed"), [(0.5, None), (8.0, None), (0.5, 50.0)])
@pytest.mark.parametrize("angle", [25, -25])
def test_a_car_drives_on_its_circle_in_straight_pieces(
    wheelbase: float, speed: float | None, angle: int
) -> None:
    """Their ends lie on the circle, so that the last one does."""
    text = f'position( size [ 0.2 0.1 0.1 ] drive "car" wheelbase {wheelbase} )'
    it, diary = watched(text, speed)

    turned = it.turn(angle)

    ahead, aside = wheelbase * sin(radians(25)) / 0.05, wheelbase * (1 - cos(radians(25))) / 0.05
    sign = 1 if angle > 0 else -1
    assert (turned.turned, turned.pose.heading) == (angle, 90 + angle)
    assert (turned.pose.x, turned.pose.y) == pytest.approx((ahead, -sign * aside))
    assert [pose.heading for _, pose, _ in diary.progress] == [90 + sign * each for each in (10, 20, 25)]
    rate = min(45, degrees(0.05 / wheelbase))
    assert [seconds for *_, seconds in diary.progress] == pytest.approx([10 / rate, 20 / rate, 25 / rate])
    assert it.time() == pytest.approx(25 / rate)


def test_a_car_pushes_on_its_circle() -> None:
    crate = "model( size [ 0.1 0.1 0.2 ] pose [ 0.2 0 0 0 ] pushable 1 )"
    it, _ = watched(f'position( size [ 0.2 0.1 0.1 ] drive "car" wheelbase 2 ){crate}')

    turned = it.turn(-10)

    assert (turned.turned, turned.stopped_by) == (-10, None)
    assert turned.pushed[0].steps == pytest.approx(2 * radians(10) / 0.05 - 1, abs=0.1)


def test_a_stop_ends_a_turn_of_a_car_between_two_degrees() -> None:
    """A piece of a third of a degree takes 0.931 s: at 50 times the speed a slice is 2.5 s."""
    it, diary = watched('position( size [ 0.2 0.1 0.1 ] drive "car" wheelbase 8 )', 50.0, stop_after=0.7)

    turned = it.turn(90)

    assert (turned.turned, turned.stopped_by) == (12, StoppedBy.USER)
    assert [pose.heading for _, pose, _ in diary.progress] == [100]
    ahead, aside, piece = sin(radians(12)), 1 - cos(radians(12)), 2 * sin(radians(0.5)) / 3
    assert (turned.pose.x, turned.pose.y) == pytest.approx(
        (
            160 * (ahead + piece * cos(radians(12.5))),
            -160 * (aside + piece * sin(radians(12.5))),
        )
    )


# --- in company

AHEAD = "model( size [ 0.2 4 1 ] pose [ 0.6 0 0 0 ] )\n"
ASIDE = "model( size [ 4 0.2 1 ] pose [ 0 0.2 0 0 ] )\n"
BLIND_TWO = BOX_ROBOT + 'blind( name "it" pose [ 0 0 0 0 ] ) blind( name "other" pose [ 0 30 0 0 ] )\n'
CAR = 'drive "car" wheelbase 8'
SOFT = "acceleration_bounds [ -0.025 0.025 0 0 0 0 -90 90 ]"
SOFTER = "acceleration_bounds [ -0.025 0.025 0 0 0 0 -60 60 ]"
"""Its first tick of 2 degrees begins at an odd one, 13."""
SLOW = "velocity_bounds [ -0.05 0.05 0 0 0 0 -20 20 ]"


@pytest.mark.parametrize("pause", [0.04, 2.5])
@pytest.mark.parametrize("speed", [None, 100.0])
@pytest.mark.parametrize(
    ("wheels", "things", "steps", "angle", "done", "stopped_by", "seconds", "reports"),
    [
        ("", "", 3, 0, 3, None, 3, [1, 2, 3]),
        ("", "", -3, 0, 3, None, 3, [-1, -2, -3]),
        ("", AHEAD, 9, 0, 7, StoppedBy.COLLISION, 7.998, [1, 2, 3, 4, 5, 6, 7]),
        ("", "", 0, -45, -45, None, 1, [80, 70, 60, 50, 45]),
        ("", "", 0, 25, 25, None, 25 / 45, [100, 110, 115]),
        ("", ASIDE, 0, -90, -36, StoppedBy.COLLISION, 0.8, [80, 70, 60, 54]),
        ("", CRATE, 5, 0, 5, None, 5, [1, 2, 3, 4, 5]),
        (SOFT, "", 4, 0, 4, None, 6, [1, 2, 3, 4]),
        (SOFT, "", 0, -45, -45, None, 1.5, [80, 70, 60, 50, 45]),
        (SOFTER, "", 0, -45, -45, None, 1.75, [80, 70, 60, 50, 45]),
        (CAR, "", 0, 11, 11, None, 11 / degrees(0.05 / 8), [100, 101]),
    ],
)
def test_a_movement_in_company_is_as_long_as_alone(
    wheels: str,
    things: str,
    steps: int,
    angle: int,
    done: int,
    stopped_by: StoppedBy | None,
    seconds: float,
    reports: list[int],
    speed: float | None,
    pause: float,
) -> None:
    """The other robot is far away, and acts all the time."""
    kind = f"define kind position ( size [ 0.2 0.1 0.1 ] {wheels} )\n"
    company = Company(
        scene(f'{kind}kind( name "it" ) kind( name "other" pose [ 30 0 0 0 ] )\n{things}'), speed=speed
    )
    ends, times = list[object](), list[float]()

    def moves(robot: SimulatedRobot) -> None:
        if steps:
            walked = (robot.forward if steps > 0 else robot.backward)(abs(steps))
            ends.extend((walked.walked, walked.stopped_by))
        else:
            turned = robot.turn(angle)
            ends.extend((turned.turned, turned.stopped_by))
        times.append(robot.time())

    def waits(robot: SimulatedRobot) -> None:
        while not times:
            robot.wait(pause)

    log = company.run({"it": moves, "other": waits})

    assert ends == [done, stopped_by]
    assert times == [pytest.approx(seconds)]
    poses = [pose for _, _, pose in log]  # type: ignore[misc]
    assert [round(pose.x if steps else pose.heading, 6) for pose in poses] == reports


@pytest.mark.parametrize(
    ("wheels", "steps", "angle", "passed"),
    [
        ("", 1, 0, [0.05 * (i + 1) for i in range(20)]),
        (SLOW, 0, -5, [89, 88, 87, 86, 85]),
        ("", 0, -20, [88, 84, 80, 76, 72]),  # each tick of 2 degrees is shorter than a slice
        ('drive "car" wheelbase 0.5', 0, 3, [91, 92, 93]),
    ],
)
def test_poses_on_the_way_are_shown_in_company_too(
    wheels: str, steps: int, angle: int, passed: list[float]
) -> None:
    kind = f"define kind position ( size [ 0.2 0.1 0.1 ] {wheels} )\n"
    company, ended = (
        Company(scene(f'{kind}kind( name "it" ) kind( name "other" pose [ 30 0 0 0 ] )'), speed=1),
        [],
    )

    def moves(robot: SimulatedRobot) -> None:
        ended.append(robot.forward(steps) if steps else robot.turn(angle))

    def waits(robot: SimulatedRobot) -> None:
        while not ended:
            robot.wait(0.04)

    company.run({"it": moves, "other": waits})

    assert [pose.x if steps else pose.heading for _, pose in company.passed] == pytest.approx(passed)


@pytest.mark.parametrize(
    ("steps", "angle", "moment", "thing", "is_halted", "done", "stopped_by", "end", "seconds", "reports"),
    [
        (4, 0, 1.33, None, True, 1, StoppedBy.USER, 1.3, 1.33, 1),
        (4, 0, 1.33, (0.2151, 0.0), True, 1, StoppedBy.USER, 1.3, 1.33, 1),
        (4, 0, 1.33, (0.216, 0.0), False, 1, StoppedBy.COLLISION, 1.318, 1.35, 1),
        (4, 0, 1.33, (0.2151, 0.0), False, 1, StoppedBy.COLLISION, 1.3, 1.35, 1),
        (4, 0, 1.33, (0.214, 0.0), False, 1, StoppedBy.COLLISION, 1.3, 1.35, 1),
        (0, -45, 0.3, None, True, -12, StoppedBy.USER, 78, 0.3, 1),
        (0, -45, 0.3, (0.08, 0.1204), True, -12, StoppedBy.USER, 78, 0.3, 1),
        (0, -45, 0.3, (0.08, 0.122), False, -13, StoppedBy.COLLISION, 77, 14 / 45, 2),
        (0, -45, 0.3, (0.08, 0.1204), False, -12, StoppedBy.COLLISION, 78, 14 / 45, 2),
        (0, -45, 0.3, (0.08, 0.119), False, -45, None, 45, 1, 5),
    ],
)
def test_a_stop_or_a_thing_that_is_put_there_ends_a_movement_in_its_tick(
    steps: int,
    angle: int,
    moment: float,
    thing: tuple[float, float] | None,
    is_halted: bool,
    done: int,
    stopped_by: StoppedBy | None,
    end: float,
    seconds: float,
    reports: int,
) -> None:
    """A stop ends it after the last whole tick of 0.05 steps or 2 degrees.

    The thing is 0.1 m wide. It leaves 1 mm of a tick of 2.5 mm, less a skin of 0.1 mm; or 1 degree of 2, as
    the corner comes to 0.072 m after 13.5 degrees; or nothing. A robot may turn out of a thing.
    """
    box = "model( size [ 0.1 0.1 1 ] pose [ 5 5 0 0 ] gripper_return 1 )"
    company = Company(scene(f"{BLIND_TWO}{box}"))
    ground, (root,) = company.world.ground, company.world.ground.grippable
    robots, ends, has_ended = dict[str, SimulatedRobot](), list[object](), threading.Event()

    def moves(robot: SimulatedRobot) -> None:
        robots["it"] = robot
        if steps:
            walked = robot.forward(steps)
            ends.extend((walked.walked, walked.stopped_by, walked.pose.x))
        else:
            turned = robot.turn(angle)
            ends.extend((turned.turned, turned.stopped_by, turned.pose.heading))
        ends.append(robot.time())
        has_ended.set()

    def disturbs(robot: SimulatedRobot) -> None:
        robot.wait(moment)
        if thing:
            ground.put(root, Placement(*thing))
        if is_halted:
            robots["it"].halt()
            assert has_ended.wait(TIMEOUT)

    log = company.run({"it": moves, "other": disturbs})

    assert ends == [done, stopped_by, pytest.approx(end), pytest.approx(seconds)]
    assert len(log) == reports


@pytest.mark.parametrize("pause", [0.04, 1.0, 2.5])
@pytest.mark.parametrize("speed", [None, 100.0])
@pytest.mark.parametrize(("steps", "angle", "done", "seconds"), [(5, 0, 2, 2.0), (0, -180, -20, 20 / 45)])
def test_a_stop_at_a_report_ends_a_movement_there(
    steps: int, angle: int, done: int, seconds: float, speed: float | None, pause: float
) -> None:
    company, robots, ends = (
        Company(scene(BLIND_TWO), speed=speed),
        dict[str, SimulatedRobot](),
        list[object](),
    )

    class Log(list[object]):
        def append(self, report: object) -> None:
            super().append(report)
            if len(self) == 2:
                robots["it"].halt()

    def moves(robot: SimulatedRobot) -> None:
        robots["it"] = robot
        if steps:
            walked = robot.forward(steps)
            ends.extend((walked.walked, walked.stopped_by, robot.time()))
        else:
            turned = robot.turn(angle)
            ends.extend((turned.turned, turned.stopped_by, robot.time()))

    def waits(robot: SimulatedRobot) -> None:
        while not ends:
            robot.wait(pause)

    company.log = Log()
    company.run({"it": moves, "other": waits})

    assert ends == [done, StoppedBy.USER, pytest.approx(seconds)]


@pytest.mark.parametrize(
    ("gap", "moved", "walked", "end"),
    [(0.196, 0, 3, 3), (0.196, 1, 3, 3), (0.196, 5, 2, 2.05), (0.22, 0, 3, 3), (0.22, 5, 3, 3)],
)
def test_the_sensors_end_a_step_only_if_a_robot_has_moved_since_its_beginning(
    gap: float, moved: int, walked: int, end: float
) -> None:
    """A sonar reads whole centimetres: 9.6 are two steps, and 9.35 after a tick are less than 1.95 steps."""
    text = (
        f'{BOX_ROBOT}box_robot( name "it" pose [ 0 0 0 0 ] ) blind( name "other" pose [ 0 30 0 0 ] )\n'
        f'blind( name "ahead" pose [ {0.2 + gap} 0 0 0 ] )\n'
    )
    company, ends = Company(scene(text), speed=100.0), list[object]()

    def walks(robot: SimulatedRobot) -> None:
        moved = robot.forward(5)
        ends.extend((moved.walked, moved.stopped_by, moved.pose.x))

    def waits(robot: SimulatedRobot) -> None:
        while not ends:
            robot.wait(0.04)

    def moves(robot: SimulatedRobot) -> None:
        robot.forward(moved)
        waits(robot)

    company.run({"it": walks, "other": moves, "ahead": waits})

    assert ends == [walked, StoppedBy.OBSTACLE, pytest.approx(end)]


@pytest.mark.parametrize("speed", [None, 100.0])
def test_robots_that_come_near_go_on_in_ticks(speed: float | None) -> None:
    """1.5 m between them, of which each walks half, less half of both bodies: 13 steps. They are blind."""
    text = BOX_ROBOT + 'blind( name "a" ) blind( name "b" pose [ 1.5 0 0 180 ] )\n'
    company, ends = Company(scene(text), speed=speed), dict[str, tuple[int, float, float]]()

    def walks(robot: SimulatedRobot) -> None:
        moved = robot.forward(20)
        ends[robot.name] = moved.walked, moved.pose.x, robot.time()

    company.run({"a": walks, "b": walks})

    assert {walked for walked, *_ in ends.values()} <= {12, 13}
    assert ends["b"][1] - ends["a"][1] == pytest.approx(4, abs=0.005)
    assert ends["a"][1] + ends["b"][1] == pytest.approx(30, abs=0.11)
    for name, way in (("a", ends["a"][1]), ("b", 30 - ends["b"][1])):
        assert ends[name][2] == pytest.approx(way, abs=0.051)  # a tick
