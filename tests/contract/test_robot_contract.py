"""What every robot promises, simulated or real, with a good wire and with a bad one.

The same tests run for the simulator; for the real robot's driver on a device path with a simulated board
behind it, in real time; and for the driver in virtual time under each fault of wire or board with which it
can still work. Then, for each fault with which it can't, every command ends, says why, and leaves no motor
on.

Tolerance between the robots: a fifth of a step, two degrees. In real time a busy machine stops the wheels
late, so only the side and the whole steps are checked there.
"""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from devices.board_simulator.board import SimulatedBoard
from devices.board_simulator.floor import BumperSwitch
from devices.ports.robot import Bearing, Motion, Pose, Robot, RobotProblem, StoppedBy
from devices.serial_robot.config import RobotConfig
from devices.serial_robot.link import SerialLink
from devices.serial_robot.robot import SerialRobot
from devices.wire.link_state import LinkConfig
from sim.world import World
from tests.board_on_pty import PtyBoard
from tests.player.room import ServedRoom, SteppedRobot
from tests.sessions.real_robot import until
from tests.unit.devices.robots import Real, Sonars, wall_ahead
from tests.unit.sim.floors import IDEAL, scene
from tests.walled_floor import WalledFloor

STEPS_TO_THE_WALL = 4
IDEAL_WORLD = (
    IDEAL
    + 'ideal( name "donnie" pose [ 0 0 0 90 ] color "gray" )\n'
    + 'model( name "wall" size [ 4 0.02 0.2 ] pose [ 0 0.21 0 0 ] color "red" )'
)


class Pace:
    """Waits in real time, or not at all; says stop once ``is_stopped`` is set."""

    def __init__(self, waits: bool) -> None:
        self.waits = waits
        self.is_stopped = threading.Event()

    def sleep(self, seconds: float) -> bool:
        return not self.is_stopped.wait(seconds if self.waits else 0.0)


class Progress:
    def __init__(self) -> None:
        self.reported: list[Motion] = []
        self.stops: Callable[[], None] | None = None

    def progressed(self, motion: Motion, pose: Pose) -> None:
        self.reported.append(motion)
        if self.stops is not None:
            self.stops()

    def passing(self, pose: Pose) -> None:
        pass


@dataclass
class RobotUnderTest:
    robot: Robot
    pace: Pace
    progress: Progress

    @property
    def steps_off(self) -> float:
        """Tolerance in steps."""
        return 0.8 if self.pace.waits else 0.2

    @property
    def degrees_off(self) -> float:
        """Tolerance in degrees."""
        return 40 if self.pace.waits else 2


def simulator(closing: ExitStack, pace: Pace, progress: Progress) -> Robot:
    return World(scene(IDEAL_WORLD)).robot(pace=pace, watcher=progress, speed=10.0)


def on_a_device_path(closing: ExitStack, pace: Pace, progress: Progress) -> Robot:
    """With generous limits for a busy machine; the real limits are tested in virtual time."""
    wall = wall_ahead(STEPS_TO_THE_WALL)
    double = closing.enter_context(PtyBoard(SimulatedBoard(wall, boot_loader=-0.9), slowness=2.0))
    link = SerialLink(double.path, LinkConfig(silence=10.0, lease=5.0, runaway=10.0))
    robot = SerialRobot(link, RobotConfig(stall=10.0, stop_timeout=5.0), pace=pace, watcher=progress)
    robot.connect()
    closing.callback(robot.close)
    assert until(lambda: robot.known_distances().keys() == {*Bearing})  # a busy board is late
    return robot


PLAYER = """
driver ( name "stage" plugin "stageplugin" provides [ "7665:simulation:0" ] worldfile "room.world" )
driver ( name "stage" model "donnie" provides [ "7665:position2d:0" "7665:ranger:0" "7665:blobfinder:0" ] )
"""


def on_a_player_server(closing: ExitStack, pace: Pace, progress: Progress) -> Robot:
    """In the same world as the simulator."""
    folder = closing.enter_context(TemporaryDirectory())
    room = closing.enter_context(contextlib.closing(ServedRoom(Path(folder), PLAYER, IDEAL_WORLD)))
    robot = SteppedRobot(room, pace, progress)
    robot.connect()
    closing.callback(robot.close)
    return robot


def in_virtual_time(
    noise: float = 0.0, cut: float = 0.0, torn: bool = False
) -> Callable[[ExitStack, Pace, Progress], Robot]:
    def make(closing: ExitStack, pace: Pace, progress: Progress) -> Robot:
        real = Real(wall_ahead(STEPS_TO_THE_WALL))
        real.board.wire.noise, real.board.wire.cut = noise, cut
        bad = Tearing(pace, real.board) if torn else pace
        real.robot._virtual_pace._pace = bad
        real.robot._watcher = progress
        return real.robot

    return make


class Tearing:
    """Has an encoder frame torn at every poll."""

    def __init__(self, pace: Pace, board: SimulatedBoard) -> None:
        self._pace, self._board = pace, board

    def sleep(self, seconds: float) -> bool:
        self._board.is_torn = True
        return self._pace.sleep(seconds)


ROBOTS = {
    "simulator": simulator,
    "device-path": on_a_device_path,
    "player-server": on_a_player_server,
    "good-line": in_virtual_time(),
    "noise": in_virtual_time(noise=0.0005),
    "half-frames": in_virtual_time(cut=0.1),
    "torn": in_virtual_time(torn=True),
}


@pytest.fixture(params=ROBOTS)
def tested(request: pytest.FixtureRequest) -> Iterator[RobotUnderTest]:
    pace, progress = Pace(waits=request.param in ("device-path", "player-server")), Progress()
    with ExitStack() as closing:
        yield RobotUnderTest(ROBOTS[request.param](closing, pace, progress), pace, progress)


def test_it_has_a_name_and_the_colours_that_it_distinguishes(tested: RobotUnderTest) -> None:
    assert tested.robot.name == "donnie"
    assert isinstance(tested.robot.colours, frozenset)


def test_forward_walks_whole_steps_the_way_it_looks(tested: RobotUnderTest) -> None:
    moved = tested.robot.forward(2)

    assert (moved.asked, moved.walked, moved.stopped_by) == (2, 2, None)
    assert (moved.pose.x, moved.pose.y) == pytest.approx((0, 2), abs=tested.steps_off)
    assert tested.progress.reported == [Motion.FORWARD] * 2


def test_backward_walks_the_other_way(tested: RobotUnderTest) -> None:
    moved = tested.robot.backward(1)

    assert (moved.walked, moved.stopped_by) == (1, None)
    assert moved.pose.y == pytest.approx(-1, abs=tested.steps_off)
    assert tested.progress.reported == [Motion.BACKWARD]


@pytest.mark.parametrize(("degrees", "heading", "side"), [(45, 45, Motion.RIGHT), (-45, 315, Motion.LEFT)])
def test_a_turn_is_positive_to_the_right(
    tested: RobotUnderTest, degrees: int, heading: int, side: Motion
) -> None:
    turned = tested.robot.turn(degrees)

    assert (turned.asked, turned.turned, turned.stopped_by) == (degrees, degrees, None)
    assert turned.pose.heading == pytest.approx(heading, abs=tested.degrees_off)
    assert tested.progress.reported == [side] * 5


def test_a_movement_of_nothing_takes_no_time(tested: RobotUnderTest) -> None:
    before = tested.robot.time()

    assert tested.robot.forward(0).stopped_by is None
    assert tested.robot.turn(0).stopped_by is None
    assert tested.progress.reported == []
    assert tested.pace.waits or tested.robot.time() == before  # real time passes by itself


def test_a_negative_walk_is_the_callers_mistake(tested: RobotUnderTest) -> None:
    with pytest.raises(ValueError, match="negative"):
        tested.robot.forward(-1)


def test_a_step_that_would_leave_less_than_one_free_is_not_begun(tested: RobotUnderTest) -> None:
    moved = tested.robot.forward(9)

    assert (moved.asked, moved.walked, moved.stopped_by) == (9, STEPS_TO_THE_WALL - 1, StoppedBy.OBSTACLE)
    assert len(tested.progress.reported) == moved.walked


def test_a_sensor_measures_whole_steps(tested: RobotUnderTest) -> None:
    assert tested.robot.distance(Bearing.FRONT) in (STEPS_TO_THE_WALL - 1, STEPS_TO_THE_WALL)
    assert tested.robot.distance(Bearing.BACK) == 60


def test_the_known_distances_are_those_that_the_sensors_measure(tested: RobotUnderTest) -> None:
    asked = {bearing: tested.robot.distance(bearing) for bearing in Bearing}

    known = tested.robot.known_distances()

    assert known.keys() == asked.keys()
    assert all(known[bearing] == pytest.approx(steps, abs=1) for bearing, steps in asked.items())


def test_asking_for_the_known_distances_disturbs_no_command(tested: RobotUnderTest) -> None:
    """A halt that came just before counts as well."""

    def halt_and_look() -> None:
        tested.robot.halt()
        tested.robot.known_distances()

    tested.progress.stops = halt_and_look

    assert tested.robot.forward(9).stopped_by is StoppedBy.USER


def test_waiting_takes_the_robots_time(tested: RobotUnderTest) -> None:
    before = tested.robot.time()

    assert tested.robot.wait(0.5) is True
    assert tested.robot.time() - before >= 0.5 - 1e-9


def test_a_stop_ends_a_walk_after_the_step_at_which_it_came(tested: RobotUnderTest) -> None:
    tested.progress.stops = tested.pace.is_stopped.set

    moved = tested.robot.forward(9)

    assert moved.stopped_by is StoppedBy.USER
    assert moved.walked == 1


def test_a_stop_ends_a_wait(tested: RobotUnderTest) -> None:
    tested.pace.is_stopped.set()

    assert tested.robot.wait(1000.0) is False


def test_a_halt_from_another_thread_ends_a_walk(tested: RobotUnderTest) -> None:
    def halt() -> None:
        halting = threading.Thread(target=tested.robot.halt)
        halting.start()
        halting.join()

    tested.progress.stops = halt

    assert tested.robot.forward(9).stopped_by is StoppedBy.USER


def test_a_halt_never_raises_and_ends_no_later_command(tested: RobotUnderTest) -> None:
    for _ in range(3):
        tested.robot.halt()

    assert tested.robot.forward(1).stopped_by is None


def test_a_scan_goes_from_left_to_right(tested: RobotUnderTest) -> None:
    if isinstance(tested.robot, SerialRobot):
        tested.robot._config = type(tested.robot._config)(head_pause=0.25, head_stride=45)

    seen = tested.robot.scan()

    assert [each.degrees for each in seen] == sorted(each.degrees for each in seen)
    assert any(abs(each.degrees) <= (90 if tested.pace.waits else 15) for each in seen)


# --- faults with which the driver can't work

WALL = WalledFloor([(-9, 0.15, 9, 0.15)], radius=0.08)
"""So near that the robot touches it, and too near for the sonars."""


def mute(real: Real) -> None:
    real.board.is_mute = True


def unplugged(real: Real) -> None:
    real.link.is_plugged = False


def restarted(real: Real) -> None:
    real.board.reset()


def stuck(real: Real) -> None:
    real.board.wheels.is_stuck = True


def deaf(real: Real) -> None:
    real.board.wire.cut = 1.0


def full(real: Real) -> None:
    real.link.is_blocked = True


def bumped(real: Real) -> None:
    sonars = real.board.floor
    assert isinstance(sonars, Sonars)
    sonars.pressed = frozenset({BumperSwitch.NE, BumperSwitch.NW})


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
    real.link.advance(3.0 if fault is not full else 0.0)
    real.link.is_blocked = False
    real.link.advance(2.0)
    assert fault is unplugged or not real.board.is_driving


def test_an_unplugged_robot_drives_on_only_until_it_is_plugged_in_again() -> None:
    """Until then it can't be stopped: its connection is gone."""
    real = Real(Sonars())
    real.pace.due = [(1.5, lambda: unplugged(real))]
    real.robot.forward(50)
    real.link.is_plugged = True

    real.link.advance(4.0)

    assert not real.board.is_driving


def test_a_board_that_receives_nothing_is_stopped_by_force() -> None:
    real = Real(Sonars(), stops_at=1.5)
    real.pace.due = [(1.0, lambda: deaf(real))]

    assert real.robot.forward(50).stopped_by is StoppedBy.USER
    real.link.advance(2.0)
    assert not real.board.is_driving


def test_a_wall_that_no_sonar_sees_is_a_collision() -> None:
    sonars = Sonars()
    sonars.touched = WALL.touched  # type: ignore[method-assign]
    sonars.is_free = WALL.is_free  # type: ignore[method-assign]
    real = Real(sonars)

    moved = real.robot.forward(9)

    assert (moved.walked, moved.stopped_by) == (1, StoppedBy.COLLISION)


@pytest.mark.parametrize("fault", [mute, unplugged, full], ids=lambda it: it.__name__)
def test_while_the_link_is_lost_every_command_fails(fault: Callable[[Real], None]) -> None:
    real = Real(Sonars())
    fault(real)
    real.link.advance(1.5)

    for command in (real.robot.scan, lambda: real.robot.forward(1), lambda: real.robot.turn(9)):
        with pytest.raises(RobotProblem) as caught:
            command()
        assert caught.value.code == "link-lost"
    real.robot.halt()
