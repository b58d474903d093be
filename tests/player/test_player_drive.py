"""GoDonnie's robot at a Player server, without a server: how it drives, stops, looks and grips.

Ten data a second; a robot has the speed of a command at once. A step is five centimetres.
"""

from __future__ import annotations

from collections.abc import Callable
from math import cos, degrees, hypot, inf, radians, sin
from typing import Any

import pytest

from devices.ports.robot import (
    STEP,
    Bearing,
    Grip,
    GripResult,
    Met,
    Motion,
    Pose,
    RobotProblem,
    StoppedBy,
    TurnResult,
    WalkResult,
)
from donnie_tui.robot import player_robot as module
from donnie_tui.robot.player_robot import PlayerRobot
from donnie_tui.robot.server_link import RobotPart, WheelState
from sim.sensors import Device

TICK = 0.1
SONARS = tuple((0.0, 0.0, 0.0, 0.0, 0.0, radians(yaw)) for yaw in (45, 0, -45, -135, 180, 135))


class Link:
    """A server with a robot on an endless floor; a wall is so many metres ahead of, or behind, its start."""

    def __init__(self) -> None:
        self.name, self.permit, self.epoch, self.is_there = "host:1", 7, 1, True
        self.now = WheelState(5.0, 0.0, 0.0, 0.0, False, False)
        self.shapes: dict[RobotPart, dict[int, Any]] = {}
        self.data: dict[RobotPart, Any] = {}
        self.speed, self.goal = 0.0, None
        self.speeds: list[float] = []
        self.commands: list[tuple[Any, ...]] = []
        self.ahead, self.behind = inf, inf
        self.is_stuck = False
        self.on_tick: Callable[[int], object] = lambda _: None
        self.ticks, self.stopped, self.closed = 0, 0, False

    def wheels(self) -> WheelState:
        return self.now

    def shape(self, part: RobotPart, subtype: int = 1) -> Any:
        return self.shapes.get(part, {}).get(subtype, ())

    def values(self, part: RobotPart) -> Any:
        if part is RobotPart.SONARS and min(self.ahead, self.behind) != inf:
            way = self.now.x * cos(radians(self.now.yaw)) + self.now.y * sin(radians(self.now.yaw))
            return ((inf, self.ahead - way, inf, inf, self.behind + way, inf),)
        return self.data.get(part, ())

    def time_of(self, part: RobotPart) -> float:
        return self.now.time if part in self.data else -inf

    def wait_for_data(self, at: float) -> WheelState | None:
        if at < 0:
            return self.now
        self.ticks += 1
        assert self.ticks < 5000, "it never ends"
        self.on_tick(self.ticks)
        now, speed = self.now, 0.0 if self.is_stuck else self.speed
        yaw = now.yaw if self.goal is None or self.is_stuck else self.goal
        way = speed * TICK
        x, y = now.x + way * cos(radians(yaw)), now.y + way * sin(radians(yaw))
        self.now = WheelState(now.time + TICK, x, y, yaw, now.is_stalled, speed != 0)
        return self.now

    def drive(self, permit: int, speed: float) -> None:
        assert permit == self.permit
        self.speed, self.goal = speed, None
        self.speeds.append(speed)

    def turn_to(self, permit: int, now: WheelState, yaw: float) -> None:
        assert abs(yaw - now.yaw) <= 170.0
        self.goal = now.yaw + max(-30.0, min(30.0, yaw - now.yaw))  # 30 degrees a datum

    def command(self, part: RobotPart, *values: Any) -> None:
        self.commands.append((part, *values))

    def connect(self) -> None:
        self.commands.append(("connect",))

    def close(self) -> None:
        self.closed = True

    def stop(self) -> None:
        self.stopped += 1


class Pace:
    goes_on = True

    def sleep(self, seconds: float) -> bool:
        return self.goes_on


class Watcher:
    def __init__(self) -> None:
        self.motions: list[tuple[Motion, Pose]] = []

    def progressed(self, motion: Motion, pose: Pose) -> None:
        self.motions.append((motion, pose))

    def passing(self, pose: Pose) -> None: ...

    def sense_failed(self, problem: RobotProblem) -> None: ...


class Driven:
    def __init__(self, start: Pose | None = None, now: WheelState | None = None) -> None:
        self.link, self.pace, self.watcher = Link(), Pace(), Watcher()
        self.link.now = now or self.link.now
        link: Any = self.link
        self.robot = PlayerRobot(link, pace=self.pace, watcher=self.watcher)
        self.robot.start = start or Pose(0, 0, 90)
        self.robot.connect()


@pytest.fixture
def driven() -> Driven:
    return Driven()


def place(pose: Pose) -> tuple[float, float, float]:
    return round(pose.x, 1), round(pose.y, 1), round(pose.heading, 1)


# --- walking


@pytest.mark.parametrize(("name", "sense"), [("forward", 1), ("backward", -1)])
def test_a_walk_reports_each_step_and_ends_within_a_millimetre(driven: Driven, name: str, sense: int) -> None:
    walk = getattr(driven.robot, name)
    done = walk(3)

    assert (done.asked, done.walked, done.stopped_by, done.met) == (3, 3, None, None)
    assert place(done.pose) == (3 * sense, 0, 90)
    assert abs(abs(driven.link.now.x) - 3 * STEP) < 0.001
    assert [pose.x for _, pose in driven.watcher.motions] == pytest.approx(
        [sense, 2 * sense, 3 * sense], abs=0.12
    )
    assert {each for each, _ in driven.watcher.motions} == {Motion.FORWARD if sense > 0 else Motion.BACKWARD}
    assert driven.link.speeds[0] == pytest.approx(STEP * sense)
    assert max(map(abs, driven.link.speeds)) == pytest.approx(STEP)
    assert driven.link.speeds[-1] == 0.0
    # near the end four times what is left, a second, but at least six millimetres
    slow = [abs(each) for each in driven.link.speeds[:-1] if abs(each) < STEP * 0.999]
    assert slow == sorted(slow, reverse=True)
    assert slow[0] == pytest.approx(4 * (3 * STEP - (len(driven.link.speeds) - 1 - len(slow)) * STEP * TICK))
    assert min(slow) == 0.006


def test_what_a_walk_was_too_short_is_made_up_for_by_the_next(driven: Driven) -> None:
    for number in range(1, 9):
        driven.robot.forward(1)
        assert abs(driven.link.now.x - number * STEP) < 0.001
        assert driven.robot.pose().x == pytest.approx(number, abs=0.002)
        assert place(driven.robot.pose()) == (number, 0, 90)
    driven.robot.backward(8)
    assert abs(driven.link.now.x) < 0.001


@pytest.mark.parametrize(
    ("steps", "walked"), [(3.5, 2), (4.6, 3), (1.7, 0), (1.8, 1), (1.9, 1), (6.7, 5), (20, 5)]
)
@pytest.mark.parametrize(("name", "side", "way"), [("forward", "ahead", 0.0), ("backward", "behind", 180.0)])
def test_a_step_is_begun_only_with_nearly_two_free_ones(
    driven: Driven, steps: float, walked: int, name: str, side: str, way: float
) -> None:
    driven.link.shapes[RobotPart.SONARS] = {1: (SONARS, ()), 5: (0.0, 0.0, 0.0, 0.0, 3.0)}
    setattr(driven.link, side, steps * STEP)
    done = getattr(driven.robot, name)(5)
    is_stopped = walked < 5

    assert (done.walked, done.stopped_by) == (walked, StoppedBy.OBSTACLE if is_stopped else None)
    assert done.met == (Met("something", "", way) if is_stopped else None)
    assert abs(abs(driven.link.now.x) - walked * STEP) < 0.002
    assert abs(driven.robot.pose().x) == pytest.approx(walked, abs=0.002)
    assert len(driven.watcher.motions) == walked


@pytest.mark.parametrize("sense", [1, -1])
def test_what_was_too_short_is_made_up_for_by_a_walk_that_an_obstacle_ends(
    driven: Driven, sense: int
) -> None:
    """The wall is 4.5 steps from the start, and the second walk begins at the end of the first step."""
    driven.link.shapes[RobotPart.SONARS] = {1: (SONARS, ()), 5: (0.0, 0.0, 0.0, 0.0, 3.0)}
    walk = driven.robot.forward if sense > 0 else driven.robot.backward
    walk(1)
    assert abs(driven.link.now.x) < STEP
    setattr(driven.link, "ahead" if sense > 0 else "behind", 4.5 * STEP)
    done = walk(5)

    assert (done.walked, done.stopped_by) == (2, StoppedBy.OBSTACLE)
    assert driven.robot.pose().x == pytest.approx(3 * sense, abs=0.002)


@pytest.mark.parametrize("yaw", [30.0, 90.0, -120.0])
def test_a_walk_is_as_long_in_every_direction_and_from_everywhere(driven: Driven, yaw: float) -> None:
    driven.link.now = WheelState(5.0, 1.0, -2.0, yaw, False, False)
    east, north = cos(radians(yaw)) * STEP, sin(radians(yaw)) * STEP
    driven.robot.forward(3)
    assert (driven.link.now.x, driven.link.now.y) == pytest.approx((1 + 3 * east, -2 + 3 * north), abs=0.001)
    driven.robot.backward(5)
    assert (driven.link.now.x, driven.link.now.y) == pytest.approx((1 - 2 * east, -2 - 2 * north), abs=0.001)


def test_a_robot_that_is_pushed_beyond_the_end_of_its_walk_drives_back(driven: Driven) -> None:
    def push(tick: int) -> None:
        if tick == 5:
            driven.link.now = WheelState(driven.link.now.time, 0.2, 0.0, 0.0, False, False)

    driven.link.on_tick = push
    done = driven.robot.forward(3)

    assert (done.walked, done.stopped_by) == (3, None)
    assert abs(driven.link.now.x - 3 * STEP) < 0.001
    assert min(driven.link.speeds) == pytest.approx(-STEP)


@pytest.mark.parametrize(("tick", "place"), [(2, 0.2), (6, 1.0)])
def test_a_walk_that_ends_within_half_a_step_of_its_end_owes_the_rest(
    driven: Driven, tick: int, place: float
) -> None:
    """A tenth of a step between two data. The wall is 1.6 steps from the start."""
    driven.link.shapes[RobotPart.SONARS] = {1: (SONARS, ()), 5: (0.0, 0.0, 0.0, 0.0, 3.0)}
    driven.link.ahead = 2.0
    driven.link.on_tick = lambda now: setattr(driven.link, "ahead", 0.08 if now >= tick else 2.0)

    assert driven.robot.forward(1).stopped_by is StoppedBy.OBSTACLE
    assert driven.link.now.x == pytest.approx(tick * STEP / 10)
    assert driven.robot.pose().x == pytest.approx(place, abs=0.002)


def test_after_a_collision_the_robot_is_where_its_wheels_have_counted(driven: Driven) -> None:
    def collide(tick: int) -> None:
        driven.link.data[RobotPart.BUMPERS] = (bytes([tick >= 7]),)

    driven.link.on_tick = collide
    done = driven.robot.forward(1)

    assert (done.walked, done.stopped_by) == (0, StoppedBy.COLLISION)
    assert done.pose.x == pytest.approx(0.7, abs=0.002)


def test_a_wall_that_comes_near_within_a_step_ends_the_walk_there(driven: Driven) -> None:
    driven.link.shapes[RobotPart.SONARS] = {1: (SONARS, ()), 5: (0.0, 0.0, 0.0, 0.0, 3.0)}
    driven.link.ahead = 2.0

    def approach(tick: int) -> None:
        if tick == 5:
            driven.link.ahead = 0.08

    driven.link.on_tick = approach
    done = driven.robot.forward(5)

    assert (done.walked, done.stopped_by) == (0, StoppedBy.OBSTACLE)
    assert driven.link.now.x < STEP


@pytest.mark.parametrize(
    ("name", "pressed", "is_stopped"),
    [
        ("forward", 0, True), ("forward", 1, True), ("forward", 2, False), ("forward", 3, False),
        ("backward", 0, False), ("backward", 1, False), ("backward", 2, True), ("backward", 3, True),
        ("forward", 4, False),
    ],
)  # fmt: skip
@pytest.mark.parametrize("has_places", [False, True])
def test_a_pressed_bar_on_the_side_of_the_walk_ends_it(
    driven: Driven, name: str, pressed: int, is_stopped: bool, has_places: bool
) -> None:
    if has_places:
        driven.link.shapes[RobotPart.BUMPERS] = {1: ([(x, 0, 0, 0, 0, 0) for x in (0.1, 0.0, -0.1, -0.1)],)}
    driven.link.data[RobotPart.BUMPERS] = (bytes(at == pressed for at in range(5)),)
    done = getattr(driven.robot, name)(2)

    assert done.stopped_by == (StoppedBy.COLLISION if is_stopped else None)
    assert done.walked == (0 if is_stopped else 2)
    if is_stopped:
        assert done.met == Met("something", "", 0.0 if name == "forward" else 180.0)


def test_a_stall_is_a_collision_from_the_second_datum_on(driven: Driven) -> None:
    driven.link.now = WheelState(5.0, 0.0, 0.0, 0.0, True, False)
    done = driven.robot.forward(2)

    assert (done.walked, done.stopped_by, driven.link.ticks) == (0, StoppedBy.COLLISION, 1)
    assert driven.robot.turn(90).stopped_by is StoppedBy.COLLISION
    assert driven.link.ticks == 2


def test_a_robot_that_does_not_move_for_three_seconds_has_stalled(driven: Driven) -> None:
    driven.link.is_stuck = True
    assert driven.robot.forward(2).stopped_by is StoppedBy.STALL
    assert 30 <= driven.link.ticks <= 32

    driven.link.ticks = 0
    assert driven.robot.turn(90).stopped_by is StoppedBy.STALL
    assert 30 <= driven.link.ticks <= 32
    assert driven.robot.wait(10) is True, "a wait may stand as long as it likes"


def test_a_pause_of_the_program_is_no_stall(driven: Driven) -> None:
    driven.link.is_stuck = True

    def pause(tick: int) -> None:
        now = driven.link.now
        if tick in (20, 40):
            driven.link.now = WheelState(now.time + 1.2, now.x, now.y, now.yaw, False, False)

    driven.link.on_tick = pause
    driven.robot.forward(2)

    assert driven.link.ticks > 65


@pytest.mark.parametrize("do", [lambda robot: robot.forward(2), lambda robot: robot.turn(90)])
def test_a_movement_ends_by_its_program_and_by_a_lost_server(driven: Driven, do: Any) -> None:
    driven.pace.goes_on = False
    assert do(driven.robot).stopped_by is StoppedBy.USER
    driven.pace.goes_on = True

    def lose(tick: int) -> None:
        driven.link.epoch += tick == driven.link.ticks

    driven.link.on_tick = lose
    assert do(driven.robot).stopped_by is StoppedBy.LINK
    with pytest.raises(RobotProblem, match=r"^link-lost$"):
        do(driven.robot)
    assert do(driven.robot).stopped_by is StoppedBy.LINK
    driven.robot.reset()  # a new run knows nothing of the loss in the one before
    driven.link.on_tick = lambda _: None
    assert do(driven.robot).stopped_by is None


def test_a_halt_of_another_thread_ends_a_walk(driven: Driven) -> None:
    def halt(tick: int) -> None:
        driven.link.permit += tick == 4

    driven.link.on_tick = halt
    driven.link.drive = lambda _, speed: setattr(driven.link, "speed", speed)  # type: ignore[method-assign]
    done = driven.robot.forward(2)

    assert (done.walked, done.stopped_by, driven.link.ticks) == (0, StoppedBy.USER, 4)


def test_a_walk_waits_for_data_that_are_late_and_reports_each_place(driven: Driven) -> None:
    newest, passed = driven.link.wait_for_data, list[float]()
    late = [True, False] * 1000
    driven.link.wait_for_data = lambda at: None if late.pop() else newest(at)  # type: ignore[method-assign]
    driven.watcher.passing = lambda pose: passed.append(pose.x)  # type: ignore[method-assign]
    done = driven.robot.forward(2)

    assert (done.walked, done.stopped_by) == (2, None)
    assert driven.link.now.x == pytest.approx(2 * STEP, abs=0.001)
    assert passed[0] == 0.0  # the next ones follow after a twentieth of a second of this computer's


def test_a_server_that_is_gone_ends_a_wait(driven: Driven) -> None:
    def lose(_: int) -> None:
        driven.link.is_there = False

    driven.link.on_tick = lose
    with pytest.raises(RobotProblem, match=r"^link-lost$"):
        driven.robot.wait(5)


def test_of_nothing_to_do_nothing_is_sent(driven: Driven) -> None:
    here = driven.robot.pose()
    assert driven.robot.forward(0) == driven.robot.backward(0) == WalkResult(0, 0, None, here)
    assert driven.robot.turn(0) == TurnResult(0, 0, None, here)
    for walk in (driven.robot.forward, driven.robot.backward):
        with pytest.raises(ValueError, match="negative"):
            walk(-1)
    assert (driven.link.ticks, driven.link.speeds, driven.link.goal) == (0, [], None)


def test_a_robot_that_was_halted_is_usable_again_after_a_loss(driven: Driven) -> None:
    driven.link.on_tick = lambda _: setattr(driven.link, "epoch", driven.link.epoch + 1)
    assert driven.robot.forward(1).stopped_by is StoppedBy.LINK
    driven.link.on_tick = lambda _: None
    driven.robot.halt()
    assert driven.link.stopped == 1
    assert driven.robot.forward(1).walked == 1

    driven.link.is_there = False
    for do in (driven.robot.forward, driven.robot.turn, driven.robot.wait):
        with pytest.raises(RobotProblem) as caught:
            do(0)
        assert (caught.value.code, caught.value.values) == ("link-lost", {"port": "host:1"})
    with pytest.raises(RobotProblem, match=r"^link-lost$"):
        driven.robot.scan()


def test_a_real_robot_has_one_speed_and_knows_no_true_place(driven: Driven) -> None:
    driven.robot.speed = 9.0
    assert (driven.robot.speed, driven.robot.true_pose(), driven.robot.port) == (1.0, None, "host:1")
    driven.link.give_up = lambda: driven.link.commands.append(("given up",))  # type: ignore[attr-defined]
    driven.link.wait_until_standing = (  # type: ignore[attr-defined]
        lambda: driven.link.commands.append(("stands",))
    )
    driven.robot.give_up()
    driven.robot.wait_until_standing()
    assert driven.link.commands[-2:] == [("given up",), ("stands",)]


def test_places_are_reported_twenty_times_a_second_of_this_computer(
    driven: Driven, monkeypatch: pytest.MonkeyPatch
) -> None:
    times = [100.0]
    monkeypatch.setattr(module, "monotonic", lambda: times[0])
    passed: list[float] = []
    driven.watcher.passing = lambda pose: passed.append(times[0])  # type: ignore[method-assign]
    driven.link.on_tick = lambda _: times.insert(0, times[0] + 1 / 64)
    driven.robot.forward(1)

    assert passed[:3] == [100.0, 100.0625, 100.125]  # of data 1/64 s apart each fourth


# --- turning, waiting, the place


@pytest.mark.parametrize("asked", [90, -90, 180, 720, -45, 7, 1])
def test_a_turn_reports_each_ten_degrees_and_ends_at_its_heading(driven: Driven, asked: int) -> None:
    done = driven.robot.turn(asked)

    assert (done.asked, done.turned, done.stopped_by) == (asked, asked, None)
    assert round(done.pose.heading % 360) == (90 + asked) % 360
    assert len(driven.watcher.motions) == -(-abs(asked) // 10)
    assert {each for each, _ in driven.watcher.motions} == {Motion.RIGHT if asked > 0 else Motion.LEFT}
    assert driven.link.speeds[-1] == 0.0


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize(("a_datum", "ends"), [(29.95, 90.0), (29.8, 89.4)])
def test_a_turn_that_ends_within_half_a_degree_of_its_goal_owes_the_rest(
    driven: Driven, sense: int, a_datum: float, ends: float
) -> None:
    """This server begins no turn of less than 0.7 degrees."""
    link = driven.link

    def turn_to(_: int, now: WheelState, yaw: float) -> None:
        by = yaw - now.yaw
        link.goal = now.yaw + max(-a_datum, min(a_datum, by)) * (abs(by) > 0.7)

    link.turn_to = turn_to  # type: ignore[method-assign]
    done = driven.robot.turn(90 * sense)
    is_done = ends == 90.0

    assert (done.turned, done.stopped_by) == (int(ends) * sense, None if is_done else StoppedBy.STALL)
    assert abs(link.now.yaw) == pytest.approx(3 * a_datum)
    assert (driven.robot.pose().heading - 90) * sense % 360 == pytest.approx(ends, abs=0.002)
    assert driven.watcher.motions[0][1].heading == pytest.approx((90 + a_datum * sense) % 360, abs=0.002)
    if is_done:
        driven.robot.turn(90 * sense)
        (_, first) = driven.watcher.motions[9]
        assert first.heading == pytest.approx((90 + 4 * a_datum * sense) % 360, abs=0.002)
        assert abs(link.now.yaw) == pytest.approx(179.7)
        assert driven.robot.turn(-90 * sense).stopped_by is None
        assert driven.robot.pose().heading == pytest.approx((90 + 90 * sense) % 360, abs=0.002)


def test_a_bar_that_is_pressed_newly_ends_a_turn(driven: Driven) -> None:
    driven.link.data[RobotPart.BUMPERS] = (b"\1\0",)
    assert driven.robot.turn(90).stopped_by is None

    def press(tick: int) -> None:
        driven.link.data[RobotPart.BUMPERS] = (b"\1\1",)

    driven.link.on_tick = press
    done = driven.robot.turn(-90)
    assert done.stopped_by is StoppedBy.COLLISION
    assert done.met == Met("something", "", -90.0)
    assert done.pose.heading == pytest.approx((90 - driven.link.now.yaw) % 360, abs=0.002)


@pytest.mark.parametrize(("seconds", "ticks"), [(0, 0), (-1, 0), (1, 10), (2.5, 25)])
def test_a_wait_is_as_long_as_the_servers_time(driven: Driven, seconds: float, ticks: int) -> None:
    assert driven.robot.wait(seconds) is True
    assert driven.link.ticks == ticks
    assert driven.robot.time() == pytest.approx(ticks * TICK)
    driven.robot.reset()
    assert driven.robot.time() == 0.0
    driven.pace.goes_on = False
    assert driven.robot.wait(1) is False


def test_wheels_that_begin_at_0_count_from_the_start_and_others_as_they_are() -> None:
    for x, y, yaw, at in (
        (0.0, 0.0, 0.0, (3, 4, 0)), (0.2, 0.0, 0.0, (4, 0, 90)), (0.0, 0.2, 0.0, (0, 4, 90)),
        (0.0, 0.0, 30.0, (0, 0, 60)),
    ):  # fmt: skip
        it = Driven(Pose(3, 4, 0), WheelState(0.0, x, y, yaw, False, False))
        assert it.link.commands == [("connect",)]
        assert place(it.robot.pose()) == at


def test_a_robot_of_a_server_drives_on_nowhere_as_the_server_stops_it(driven: Driven) -> None:
    assert not driven.robot.may_drive_on
    assert not driven.robot.has_run_away


def test_close_calls_what_is_to_leave_and_then_closes_the_link(driven: Driven) -> None:
    left: list[bool] = []
    driven.robot.leave = (lambda: left.append(driven.link.closed), lambda: left.append(driven.link.closed))
    driven.robot.close()

    assert (left, driven.link.closed) == ([False, False], True)


# --- distances


def test_distances_are_those_of_the_sensors_that_look_there(driven: Driven) -> None:
    driven.link.shapes[RobotPart.SONARS] = {1: (SONARS, ()), 5: (0.0, 0.0, 0.0, 0.0, 3.0)}
    driven.link.data[RobotPart.SONARS] = ((1.0, 0.55, 2.0, 2.99, 2.996, 0.1),)

    assert dict(driven.robot.known_distances()) == {
        Bearing.FRONT_LEFT: 20, Bearing.FRONT: 11, Bearing.FRONT_RIGHT: 40,
        Bearing.BACK_RIGHT: 59, Bearing.BACK: driven.robot.distance(Bearing.BACK), Bearing.BACK_LEFT: 2,
    }  # fmt: skip
    assert driven.robot.distance(Bearing.FRONT) == 11
    assert driven.robot.distance(Bearing.BACK) > 59
    driven.link.data.clear()
    with pytest.raises(RobotProblem, match=r"^no-sensor$"):
        driven.robot.distance(Bearing.FRONT)
    driven.link.is_there = False
    with pytest.raises(RobotProblem, match=r"^link-lost$"):
        driven.robot.distance(Bearing.FRONT)


def test_sonars_without_a_shape_look_as_those_of_the_original(driven: Driven) -> None:
    driven.link.data[RobotPart.SONARS] = ((0.1, 0.2, 0.3, 0.4, 0.5, 0.6),)
    original = {-45.0: 2, 0.0: 4, 45.0: 6, 135.0: 8, 180.0: 10, -135.0: 12}

    known = driven.robot.known_distances()
    for yaw, steps in original.items():
        (bearing,) = (each for each in Bearing if (each.value + yaw) % 360 == 0)
        assert known[bearing] == steps


def test_a_scanner_has_a_sample_for_each_of_its_directions(driven: Driven) -> None:
    """Nine samples of 45 degrees from the right behind on; a bearing is within 7.5 degrees of one."""
    driven.link.shapes[RobotPart.SONARS] = {
        1: ([(0.0,) * 6], ()), 5: (radians(-202.5), radians(202.5), radians(45.0), 0.0, 9.0),
    }  # fmt: skip
    driven.link.data[RobotPart.SONARS] = (tuple(float(at + 1) for at in range(9)),)

    known = driven.robot.known_distances()
    assert known == {
        Bearing.FRONT: 100, Bearing.FRONT_LEFT: 120, Bearing.FRONT_RIGHT: 80, Bearing.BACK_LEFT: 160,
        Bearing.BACK_RIGHT: 40, Bearing.BACK: 20,
    }  # fmt: skip


@pytest.mark.parametrize(
    ("mount", "known"),
    [
        (45.0, {Bearing.FRONT: 1.0, Bearing.FRONT_LEFT: 2.0}),
        (52.0, {Bearing.FRONT: 1.0, Bearing.FRONT_LEFT: 2.0}),
        (53.0, {}),
        (0.0, {Bearing.FRONT_RIGHT: 1.0, Bearing.FRONT: 2.0, Bearing.FRONT_LEFT: 3.0}),
    ],
)
def test_a_scanner_looks_seven_and_a_half_degrees_aside_of_its_mount(
    driven: Driven, mount: float, known: dict[Bearing, float]
) -> None:
    """Three samples of 45 degrees. No bearing is on the left, where the last one may look."""
    driven.link.shapes[RobotPart.SONARS] = {
        1: ([(0.0,) * 5 + (radians(mount),)], ()),
        5: (radians(-67.5), radians(67.5), radians(45.0), 0.0, 9.0),
    }  # fmt: skip
    driven.link.data[RobotPart.SONARS] = ((1.0, 2.0, 3.0),)

    assert driven.robot.known_distances() == {each: metres / STEP for each, metres in known.items()}


@pytest.mark.parametrize(
    ("yaw", "bearings"),
    [
        (22.0, {Bearing.FRONT}),
        (23.0, {Bearing.FRONT_LEFT}),
        (-68.0, set()),
        (-67.0, {Bearing.FRONT_RIGHT}),
        (157.0, {Bearing.BACK_LEFT}),
        (-158.0, {Bearing.BACK}),
    ],
)
@pytest.mark.parametrize("config", [(), (radians(-67.5), radians(67.5), radians(45.0), 0.0, 9.0)])
def test_one_sonar_looks_twenty_two_and_a_half_degrees_aside(
    driven: Driven, yaw: float, bearings: set[Bearing], config: tuple[float, ...]
) -> None:
    driven.link.shapes[RobotPart.SONARS] = {1: ([(0.0,) * 5 + (radians(yaw),)], ()), 5: config}
    driven.link.data[RobotPart.SONARS] = ((1.0,),)

    assert driven.robot.known_distances() == dict.fromkeys(bearings, 20)


def test_samples_whose_directions_are_unknown_are_left_out(driven: Driven) -> None:
    driven.link.shapes[RobotPart.SONARS] = {1: ([(0.0,) * 6], ())}
    driven.link.data[RobotPart.SONARS] = ((1.0, 2.0, 3.0),)

    assert driven.robot.known_distances() == {Bearing.FRONT: 20}


# --- devices


def test_the_devices_are_those_that_the_server_names(driven: Driven) -> None:
    driven.link.shapes = {
        RobotPart.SONARS: {1: (SONARS[:2], ()), 5: (-0.1, 0.1, 0.0, 0.0, 3.0)},
        RobotPart.CAMERA: {},
        RobotPart.BUMPERS: {1: ([(0.1, 0, 0, 0, 0, radians(90)), (0.1, 0, 0, 0, 0, 0.0)],)},
    }
    found = [
        (each.device, round(each.degrees), round(each.width, 1), each.metres) for each in driven.robot.mounted
    ]

    width = round(degrees(0.2), 1)
    assert found[:3] == [
        (Device.RANGER, -45, width, 3.0), (Device.RANGER, 0, width, 3.0), (Device.EYES, 0, 60.0, 5.0),
    ]  # fmt: skip
    assert [each[:2] for each in found[3:]] == [(Device.BUMPER, -90), (Device.BUMPER, 0)]
    assert driven.robot.colours
    driven.link.shapes = {RobotPart.HEAD_SONAR: {1: (SONARS[2:3], ())}}
    assert [(each.device, round(each.degrees), each.width, each.metres) for each in driven.robot.mounted] == [
        (Device.RANGER, 45, 0.0, 0.0)
    ]
    driven.link.shapes.clear()
    assert driven.robot.mounted == ()
    assert driven.robot.colours == frozenset()


@pytest.mark.parametrize(
    ("given", "chosen", "view"),
    [
        (None, None, 60),
        (90, None, 90),
        (19, None, 60),
        (20, None, 20),
        (150, None, 150),
        (151, None, 60),
        (90, 45, 45),
    ],
)
def test_the_view_of_the_camera_is_chosen_or_the_servers_or_the_originals(
    driven: Driven, given: float | None, chosen: float | None, view: float
) -> None:
    if given is not None:
        driven.link.shapes[RobotPart.MARKS] = {
            2: (0.0, radians(given) * (1 + 1e-12 * (given == 20) - 1e-12 * (given == 150)))
        }
    driven.robot.chosen_view = chosen

    assert driven.robot.view == pytest.approx(view)


# --- the gripper, speech, belt


@pytest.mark.parametrize(
    ("state", "beams", "closes_on", "outcome", "moves"),
    [
        (2, 0b0100, 0, Grip.HOLDS_ALREADY, []),
        (2, 0b1000, 0, Grip.HOLDS_ALREADY, []),
        (2, 0b0011, 0b1000, Grip.GRIPPED, [1, 2]),
        (1, 0b1100, 0b0100, Grip.GRIPPED, [1, 2]),
        (1, 0, 0, Grip.NOTHING_THERE, [1, 2, 1]),
    ],
)
def test_the_gripper_opens_closes_and_opens_again_if_there_is_nothing(
    driven: Driven, state: int, beams: int, closes_on: int, outcome: Grip, moves: list[int]
) -> None:
    link = driven.link
    link.shapes[RobotPart.GRIPPER] = {}
    link.data[RobotPart.GRIPPER] = (state, beams, 0)

    def move(_: int) -> None:
        wanted = link.commands[-1][1]
        link.data[RobotPart.GRIPPER] = (wanted, closes_on if wanted == 2 else 0, 0)

    link.on_tick = move
    assert driven.robot.grip() == GripResult(outcome)
    assert [each[1] for each in link.commands if each[0] is RobotPart.GRIPPER] == moves
    assert link.ticks <= len(moves), "each is over with the datum that says so"


@pytest.mark.parametrize(("beams", "outcome"), [(0b0100, Grip.RELEASED), (0, Grip.HOLDS_NOTHING)])
def test_a_gripper_that_never_opens_is_given_up_after_five_seconds(
    driven: Driven, beams: int, outcome: Grip
) -> None:
    driven.link.shapes[RobotPart.GRIPPER] = {}
    driven.link.data[RobotPart.GRIPPER] = (2, beams, 0)

    assert driven.robot.release() == GripResult(outcome)
    assert 50 <= driven.link.ticks <= 52


def test_without_a_gripper_or_eyes_the_robot_says_so(driven: Driven) -> None:
    for do, problem in (
        (driven.robot.grip, "no-gripper"),
        (driven.robot.release, "no-gripper"),
        (driven.robot.scan, "no-eyes"),
    ):
        with pytest.raises(RobotProblem, match=rf"^{problem}$"):
            do()


def test_speech_and_belt_are_commands(driven: Driven) -> None:
    driven.link.commands.clear()
    driven.robot.say("hello")
    driven.robot.show_belt((0, 3) + (0,) * 12)

    assert driven.link.commands[0] == (RobotPart.SPEECH, 1, "hello")
    belts = driven.link.commands[1:]
    assert len(belts) == 28
    assert {each[0] for each in belts} == {RobotPart.BELT, RobotPart.SECOND_BELT}
    assert belts[0][2:] == belts[1][2:]
    assert belts[0][2] != belts[2][2]
    assert belts[0][3] != belts[2][3]
    assert {each[1] for each in belts} == {1}


# --- looking


def blob(left: int, right: int, rgb: int = 0xFF0000, metres: float = 1.0) -> tuple[Any, ...]:
    return (0, rgb, 0, 0, 0, left, right, 0, 0, metres)


def test_a_camera_without_a_head_looks_ahead_once(driven: Driven) -> None:
    driven.link.shapes[RobotPart.CAMERA] = {}
    driven.link.data[RobotPart.CAMERA] = (100, 50, (blob(40, 59), blob(75, 84, 0x0000FF, 2.0)))

    seen = driven.robot.scan()
    assert [(each.colour, round(each.degrees)) for each in seen] == [("red", 0), ("blue", 18)]
    assert [round(each.steps) for each in seen] == [20, 40]
    assert driven.link.ticks == 0


def test_a_head_turns_from_left_to_right_and_ahead_again(driven: Driven) -> None:
    link = driven.link
    link.shapes[RobotPart.CAMERA] = {}
    link.data[RobotPart.CAMERA] = (100, 50, (blob(45, 54),))
    link.data[RobotPart.HEAD] = (0.0, 0.0, 0.0)

    def turn(_: int) -> None:
        link.data[RobotPart.HEAD] = (0.0, 0.0, link.commands[-1][4])

    link.on_tick = turn
    seen = driven.robot.scan()

    assert [round(each.degrees) for each in seen] == [-60, 0, 60]
    goals = dict.fromkeys(round(degrees(each[4])) for each in link.commands if each[0] is RobotPart.HEAD)
    assert [*goals] == [60, 0, -60]
    assert round(degrees(link.commands[-1][4])) == 0
    assert {each[1:4] + each[5:] for each in link.commands if each[0] is RobotPart.HEAD} == {
        (2, 0.0, 0.0, 0.0, 0.0, 0.0, 1)
    }


def test_a_head_that_is_far_away_is_another_robots(driven: Driven) -> None:
    driven.link.shapes[RobotPart.CAMERA] = {}
    driven.link.data[RobotPart.CAMERA] = (100, 50, ())
    driven.link.data[RobotPart.HEAD] = (0.5, 0.0, 0.0)
    driven.robot.scan()
    assert not [each for each in driven.link.commands if each[0] is RobotPart.HEAD]
    assert hypot(0.49, 0) < 0.5
    driven.link.data[RobotPart.HEAD] = (0.49, 0.0, 0.0)
    driven.robot.scan()
    assert [each for each in driven.link.commands if each[0] is RobotPart.HEAD]


def test_a_sonar_on_the_head_finds_things_by_their_echoes(driven: Driven) -> None:
    link = driven.link
    link.shapes[RobotPart.HEAD_SONAR] = {1: ([(0.05, 0, 0, 0, 0, 0.0)], ()), 5: (0.0, 0.0, 0.0, 0.0, 3.0)}
    link.data[RobotPart.HEAD] = (0.0, 0.0, 0.0)
    link.data[RobotPart.HEAD_SONAR] = ((3.0,),)

    def turn(_: int) -> None:
        link.data[RobotPart.HEAD] = (0.0, 0.0, link.commands[-1][4])
        is_thing = abs(round(degrees(link.commands[-1][4])) - 30) <= 15
        link.data[RobotPart.HEAD_SONAR] = ((0.5 if is_thing else 3.0,),)

    link.on_tick = turn
    (seen,) = driven.robot.scan()

    assert (seen.colour, round(seen.degrees), round(seen.steps)) == ("", -30, 10)
    goals = dict.fromkeys(round(degrees(each[4])) for each in link.commands if each[0] is RobotPart.HEAD)
    assert [*goals] == [*range(90, -91, -15)]


@pytest.mark.parametrize(
    ("view", "goals"), [(90.0, [45, -45]), (100.0, [50, -50]), (50.0, [75, 25, -25, -75])]
)
def test_a_head_turns_as_often_as_its_view_asks(driven: Driven, view: float, goals: list[int]) -> None:
    link = driven.link
    link.now = WheelState(5.0, 1.0, 2.0, 90.0, False, False)
    link.shapes[RobotPart.CAMERA] = {}
    link.data[RobotPart.CAMERA] = (100, 50, ())
    link.data[RobotPart.HEAD] = (1.3, 2.3, 0.0)
    link.on_tick = lambda _: link.data.update({RobotPart.HEAD: (1.3, 2.3, link.commands[-1][4])})
    driven.robot.chosen_view = view
    driven.robot.scan()

    turns = [round(degrees(each[4])) for each in link.commands if each[0] is RobotPart.HEAD]
    assert [*dict.fromkeys(turns)] == [90 + each for each in goals] + [90]
    assert {each[2:4] for each in link.commands if each[0] is RobotPart.HEAD} == {(1.0, 2.0)}


@pytest.mark.parametrize(("place", "is_head"), [((1.4, 2.2), True), ((1.2, 2.5), False), ((1.5, 2.1), False)])
def test_a_head_is_within_half_a_metre_of_its_robot(
    driven: Driven, place: tuple[float, float], is_head: bool
) -> None:
    driven.link.now = WheelState(5.0, 1.0, 2.0, 0.0, False, False)
    driven.link.shapes[RobotPart.CAMERA] = {}
    driven.link.data[RobotPart.CAMERA] = (100, 50, ())
    driven.link.data[RobotPart.HEAD] = (*place, 0.0)
    driven.robot.scan()

    assert any(each[0] is RobotPart.HEAD for each in driven.link.commands) is is_head


def test_a_head_that_does_not_turn_is_given_up_after_six_seconds(driven: Driven) -> None:
    """Three looks of 60 data, and one of two: it looks ahead already."""
    driven.link.shapes[RobotPart.CAMERA] = {}
    driven.link.data[RobotPart.CAMERA] = (100, 50, ())
    driven.link.data[RobotPart.HEAD] = (0.0, 0.0, radians(0.6))
    driven.robot.scan()
    assert 122 <= driven.link.ticks <= 128

    driven.link.ticks = 0
    driven.link.data[RobotPart.HEAD] = (0.0, 0.0, radians(0.8))
    driven.robot.scan()
    assert 240 <= driven.link.ticks <= 248


def test_a_scan_that_is_stopped_looks_no_further(driven: Driven) -> None:
    driven.link.shapes[RobotPart.CAMERA] = {}
    driven.link.data[RobotPart.CAMERA] = (100, 50, (blob(40, 59),))
    driven.link.data[RobotPart.HEAD] = (0.0, 0.0, 0.0)
    goes_on = [True] * 1000 + [False]
    driven.pace.sleep = lambda _: goes_on.pop()  # type: ignore[method-assign]

    assert driven.robot.scan() == ()
    goals = dict.fromkeys(
        round(degrees(each[4])) for each in driven.link.commands if each[0] is RobotPart.HEAD
    )
    assert [*goals] == [0]


@pytest.mark.parametrize(
    ("shape", "metres", "steps"),
    [
        ((), 1.0, 20),
        (((), ()), 1.0, 20),
        (([(0.05,) + (0,) * 5], ()), 1.0, 19),
        (([(0.05,) + (0,) * 5], ()), 0.03, 0),
    ],
)
def test_the_distance_of_a_colour_is_that_from_the_sonar_on_the_head(
    driven: Driven, shape: Any, metres: float, steps: int
) -> None:
    driven.link.shapes.update({RobotPart.CAMERA: {}, RobotPart.HEAD_SONAR: {1: shape}})
    driven.link.data[RobotPart.CAMERA] = (100, 50, (blob(0, 49, 0x10C020, metres),))
    (seen,) = driven.robot.scan()

    assert (seen.colour, seen.degrees, round(seen.steps)) == ("green", pytest.approx(-15), steps)


def test_a_camera_that_has_made_no_picture_sees_nothing(driven: Driven) -> None:
    driven.link.shapes[RobotPart.CAMERA] = {}

    assert driven.robot.scan() == ()


@pytest.mark.parametrize(
    ("x", "has_sonar", "has_eyes"), [(0.1, True, True), (0.6, True, False), (0.1, False, False)]
)
def test_without_a_camera_a_scan_needs_a_head_with_a_sonar(
    driven: Driven, x: float, has_sonar: bool, has_eyes: bool
) -> None:
    link = driven.link
    link.data[RobotPart.HEAD] = (x, 0.0, 0.0)
    link.on_tick = lambda _: link.data.update({RobotPart.HEAD: (x, 0.0, link.commands[-1][4])})
    if has_sonar:
        link.shapes[RobotPart.HEAD_SONAR] = {}
        link.data[RobotPart.HEAD_SONAR] = ((inf,),)
    if has_eyes:
        assert driven.robot.scan() == ()
    else:
        with pytest.raises(RobotProblem, match=r"^no-eyes$"):
            driven.robot.scan()
