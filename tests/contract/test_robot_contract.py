"""What every robot promises, simulated or real, on a good line and on a bad one.

The same tests for the simulator, for the real robot's driver on a device path with a simulated board behind
it (in real time), and for the driver in virtual time under each fault of line or board with which it can
still work. Then, for each fault with which it can't: every command ends, says why, and leaves no motor on.

Tolerance between the robots: a fifth of a step, two degrees.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import dataclass

import pytest

from devices.firmware_double.board import SimulatedBoard
from devices.firmware_double.on_pty import DoubleOnPty
from devices.firmware_double.surroundings import Switch, Walls
from devices.ports.robot import Bearing, Motion, Pose, Robot, RobotProblem, StoppedBy
from devices.serial_link import SerialLink
from devices.serial_robot.config import RobotConfig
from devices.serial_robot.robot import SerialRobot
from devices.wire.link_config import LinkConfig
from sim.world import World
from tests.unit.devices.robots import Real, Sonars, wall_ahead
from tests.unit.sim.floors import IDEAL, scene

STEPS_TO_THE_WALL = 4
IDEAL_WORLD = (
    IDEAL
    + 'ideal( name "donnie" pose [ 0 0 0 90 ] color "gray" )\n'
    + 'model( name "wall" size [ 4 0.02 0.2 ] pose [ 0 0.21 0 0 ] color "red" )'
)


class Pace:
    """Waits in earnest, or not; says stop once it is told to."""

    def __init__(self, waits: bool) -> None:
        self._waits = waits
        self.is_stopped = threading.Event()

    def sleep(self, seconds: float) -> bool:
        return not self.is_stopped.wait(seconds if self._waits else 0.0)


class Progress:
    def __init__(self) -> None:
        self.told: list[Motion] = []
        self.stops: Callable[[], None] | None = None

    def progressed(self, motion: Motion, pose: Pose) -> None:
        self.told.append(motion)
        if self.stops is not None:
            self.stops()

    def passing(self, pose: Pose) -> None:
        pass


@dataclass
class Kept:
    robot: Robot
    pace: Pace
    progress: Progress


def simulator(closing: ExitStack, pace: Pace, progress: Progress) -> Robot:
    return World(scene(IDEAL_WORLD)).robot(pace=pace, watcher=progress, speed=10.0)


def on_a_device_path(closing: ExitStack, pace: Pace, progress: Progress) -> Robot:
    """Patient with a busy machine; how impatient it is otherwise is tested in virtual time."""
    wall = wall_ahead(STEPS_TO_THE_WALL)
    double = closing.enter_context(DoubleOnPty(SimulatedBoard(wall, boot_loader=-0.9)))
    link = SerialLink(double.path, LinkConfig(silence=10.0, lease=5.0, runaway=10.0))
    robot = SerialRobot(link, RobotConfig(stall=10.0, settle=5.0), pace=pace, watcher=progress)
    robot.connect()
    closing.callback(robot.close)
    return robot


def in_virtual_time(
    noise: float = 0.0, cut: float = 0.0, torn: bool = False
) -> Callable[[ExitStack, Pace, Progress], Robot]:
    def make(closing: ExitStack, pace: Pace, progress: Progress) -> Robot:
        real = Real(wall_ahead(STEPS_TO_THE_WALL))
        real.line.wire.noise, real.line.wire.cut = noise, cut
        bad = Tearing(pace, real.board) if torn else pace
        real.robot._virtual._pace = bad
        real.robot._watcher = progress
        return real.robot

    return make


class Tearing:
    """Has an encoder frame torn at every look."""

    def __init__(self, pace: Pace, board: SimulatedBoard) -> None:
        self._pace, self._board = pace, board

    def sleep(self, seconds: float) -> bool:
        self._board.is_torn = True
        return self._pace.sleep(seconds)


ROBOTS = {
    "simulator": simulator,
    "device-path": on_a_device_path,
    "good-line": in_virtual_time(),
    "noise": in_virtual_time(noise=0.0005),
    "half-frames": in_virtual_time(cut=0.1),
    "torn": in_virtual_time(torn=True),
}


@pytest.fixture(params=ROBOTS)
def kept(request: pytest.FixtureRequest) -> Iterator[Kept]:
    pace, progress = Pace(waits=request.param == "device-path"), Progress()
    with ExitStack() as closing:
        yield Kept(ROBOTS[request.param](closing, pace, progress), pace, progress)


def test_it_has_a_name_and_says_which_colours_it_tells_apart(kept: Kept) -> None:
    assert kept.robot.name == "donnie"
    assert isinstance(kept.robot.colours, frozenset)


def test_forward_walks_whole_steps_the_way_it_looks(kept: Kept) -> None:
    moved = kept.robot.forward(2)

    assert (moved.asked, moved.walked, moved.stopped_by) == (2, 2, None)
    assert (moved.pose.x, moved.pose.y) == (pytest.approx(0, abs=0.2), pytest.approx(2, abs=0.2))
    assert kept.progress.told == [Motion.FORWARD] * 2


def test_backward_walks_the_other_way(kept: Kept) -> None:
    moved = kept.robot.backward(1)

    assert (moved.walked, moved.stopped_by) == (1, None)
    assert moved.pose.y == pytest.approx(-1, abs=0.2)
    assert kept.progress.told == [Motion.BACKWARD]


@pytest.mark.parametrize(("degrees", "heading", "side"), [(45, 45, Motion.RIGHT), (-45, 315, Motion.LEFT)])
def test_a_turn_is_positive_to_the_right(kept: Kept, degrees: int, heading: int, side: Motion) -> None:
    turned = kept.robot.turn(degrees)

    assert (turned.asked, turned.turned, turned.stopped_by) == (degrees, degrees, None)
    assert turned.pose.heading == pytest.approx(heading, abs=2)
    assert kept.progress.told == [side] * 5


def test_nothing_asked_is_nothing_done(kept: Kept) -> None:
    assert kept.robot.forward(0).stopped_by is None
    assert kept.robot.turn(0).stopped_by is None
    assert kept.progress.told == []


def test_a_negative_walk_is_the_callers_mistake(kept: Kept) -> None:
    with pytest.raises(ValueError, match="negative"):
        kept.robot.forward(-1)


def test_a_step_that_would_leave_less_than_one_free_is_not_begun(kept: Kept) -> None:
    moved = kept.robot.forward(9)

    assert (moved.asked, moved.walked, moved.stopped_by) == (9, STEPS_TO_THE_WALL - 1, StoppedBy.OBSTACLE)
    assert len(kept.progress.told) == moved.walked


def test_a_sensor_tells_whole_steps_to_what_is_there(kept: Kept) -> None:
    assert kept.robot.distance(Bearing.FRONT) in (STEPS_TO_THE_WALL - 1, STEPS_TO_THE_WALL)
    assert kept.robot.distance(Bearing.BACK) == 60


def test_what_is_known_of_the_distances_is_what_the_sensors_tell(kept: Kept) -> None:
    asked = {bearing: kept.robot.distance(bearing) for bearing in Bearing}

    known = kept.robot.known_distances()

    assert known.keys() == asked.keys()
    assert all(known[bearing] == pytest.approx(steps, abs=1) for bearing, steps in asked.items())


def test_who_looks_at_the_distances_hinders_no_command(kept: Kept) -> None:
    """A halt that came before counts as well."""

    def halt_and_look() -> None:
        kept.robot.halt()
        kept.robot.known_distances()

    kept.progress.stops = halt_and_look

    assert kept.robot.forward(9).stopped_by is StoppedBy.USER


def test_waiting_takes_the_robots_time(kept: Kept) -> None:
    before = kept.robot.time()

    assert kept.robot.wait(0.5) is True
    assert kept.robot.time() - before >= 0.5 - 1e-9


def test_a_stop_ends_a_walk_after_the_step_at_which_it_came(kept: Kept) -> None:
    kept.progress.stops = kept.pace.is_stopped.set

    moved = kept.robot.forward(9)

    assert moved.stopped_by is StoppedBy.USER
    assert moved.walked == 1


def test_a_stop_ends_a_wait(kept: Kept) -> None:
    kept.pace.is_stopped.set()

    assert kept.robot.wait(1000.0) is False


def test_a_halt_from_another_thread_ends_a_walk(kept: Kept) -> None:
    def halt() -> None:
        halting = threading.Thread(target=kept.robot.halt)
        halting.start()
        halting.join()

    kept.progress.stops = halt

    assert kept.robot.forward(9).stopped_by is StoppedBy.USER


def test_a_halt_never_raises_and_hinders_no_later_command(kept: Kept) -> None:
    for _ in range(3):
        kept.robot.halt()

    assert kept.robot.forward(1).stopped_by is None


def test_a_scan_goes_from_left_to_right(kept: Kept) -> None:
    if isinstance(kept.robot, SerialRobot):
        kept.robot._config = type(kept.robot._config)(head_pause=0.25, head_stride=45)

    seen = kept.robot.scan()

    assert [each.degrees for each in seen] == sorted(each.degrees for each in seen)
    assert any(abs(each.degrees) <= 15 for each in seen)


# --- faults with which it can't work

WALL = Walls([(-9, 0.15, 9, 0.15)], radius=0.08)
"""So near that the robot touches it, for whom the sonars are blind."""


def mute(real: Real) -> None:
    real.board.is_mute = True


def unplugged(real: Real) -> None:
    real.line.is_plugged = False


def restarted(real: Real) -> None:
    real.board.reset()


def stuck(real: Real) -> None:
    real.board.wheels.is_stuck = True


def deaf(real: Real) -> None:
    real.line.wire.cut = 1.0


def full(real: Real) -> None:
    real.line.is_blocked = True


def bumped(real: Real) -> None:
    sonars = real.board.surroundings
    assert isinstance(sonars, Sonars)
    sonars.pressed = frozenset({Switch.NE, Switch.NW})


FAULTS = {
    mute: StoppedBy.LINK,
    unplugged: StoppedBy.LINK,
    restarted: StoppedBy.LINK,
    full: StoppedBy.LINK,
    stuck: StoppedBy.STALL,
    bumped: StoppedBy.COLLISION,
}


@pytest.mark.parametrize("walks", [lambda it: it.forward(50), lambda it: it.turn(3000)], ids=["walk", "turn"])
@pytest.mark.parametrize(("fault", "reason"), FAULTS.items(), ids=lambda it: getattr(it, "__name__", ""))
def test_each_fault_ends_a_movement_with_its_reason_and_no_motor_stays_on(
    fault: Callable[[Real], None], reason: StoppedBy, walks: Callable[[Robot], object]
) -> None:
    real = Real(Sonars())
    real.pace.due = [(1.5, lambda: fault(real))]

    done = walks(real.robot)

    assert getattr(done, "stopped_by", None) is reason
    assert real.robot.time() < 4.0
    real.line.advance(3.0 if fault is not full else 0.0)
    real.line.is_blocked = False
    real.line.advance(2.0)
    assert fault is unplugged or not real.board.is_driving


def test_an_unplugged_robot_drives_on_only_until_it_is_plugged_in_again() -> None:
    """Nobody can stop it before: its line is what was taken away."""
    real = Real(Sonars())
    real.pace.due = [(1.5, lambda: unplugged(real))]
    real.robot.forward(50)
    real.line.is_plugged = True

    real.line.advance(4.0)

    assert not real.board.is_driving


def test_a_board_that_hears_nothing_any_more_is_stopped_by_force() -> None:
    real = Real(Sonars(), stops_at=1.5)
    real.pace.due = [(1.0, lambda: deaf(real))]

    assert real.robot.forward(50).stopped_by is StoppedBy.USER
    real.line.advance(2.0)
    assert not real.board.is_driving


def test_a_wall_that_no_sonar_sees_is_a_collision() -> None:
    sonars = Sonars()
    sonars.touched = WALL.touched  # type: ignore[method-assign]
    sonars.is_free = WALL.is_free  # type: ignore[method-assign]
    real = Real(sonars)

    moved = real.robot.forward(9)

    assert (moved.walked, moved.stopped_by) == (1, StoppedBy.COLLISION)


@pytest.mark.parametrize("fault", [mute, unplugged, full], ids=lambda it: it.__name__)
def test_while_the_line_is_lost_every_command_says_so(fault: Callable[[Real], None]) -> None:
    real = Real(Sonars())
    fault(real)
    real.line.advance(1.5)

    for command in (real.robot.scan, lambda: real.robot.forward(1), lambda: real.robot.turn(9)):
        with pytest.raises(RobotProblem) as told:
            command()
        assert told.value.code == "link-lost"
    real.robot.halt()
