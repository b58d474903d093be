"""Real robots for tests: the driver, with a simulated board in virtual time at the end of its link."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from devices.board_simulator.board import SimulatedBoard
from devices.board_simulator.floor import AxlePose, BumperSwitch, EmptyFloor, Floor
from devices.board_simulator.robot import SimulatedSerialRobot
from devices.ports.robot import STEP, LinkNotice, Motion, Pose, RobotProblem
from devices.serial_robot.config import RobotConfig
from tests.noisy_wire import WiredBoard
from tests.walled_floor import WalledFloor

NEAR = 0.1
"""Steps by which the board's true place may differ from what was asked, after a walk."""

TimedAction = tuple[float, Callable[[], None]]
"""Seconds of robot time, and what is done then."""


class ScriptedPace:
    """Doesn't wait in real time. Runs timed actions, and says stop from ``stops_at`` seconds on."""

    def __init__(self, stops_at: float = float("inf")) -> None:
        self.stops_at = stops_at
        self.robot: SimulatedSerialRobot | None = None
        self.due: list[TimedAction] = []

    def sleep(self, seconds: float) -> bool:
        if self.robot is None:
            return True
        now = self.robot.time()
        for timed in [each for each in self.due if each[0] <= now]:
            self.due.remove(timed)
            timed[1]()
        return now < self.stops_at


class RecordingWatcher:
    """A watcher that records what it receives."""

    def __init__(self) -> None:
        self.progress: list[Motion] = []
        self.passed: list[Pose] = []
        self.failed: list[str] = []

    def progressed(self, motion: Motion, pose: Pose) -> None:
        self.progress.append(motion)

    def passing(self, pose: Pose) -> None:
        self.passed.append(pose)

    def sense_failed(self, problem: RobotProblem) -> None:
        self.failed.append(problem.code)


class Sonars(EmptyFloor):
    """A floor whose sonar distances and bumpers a test sets; nothing ever blocks the robot."""

    def __init__(self, far: float | None = None) -> None:
        self.far: dict[int, Callable[[AxlePose], float | None]] = {}
        self.otherwise = far
        self.pressed: frozenset[BumperSwitch] = frozenset()

    def centimetres(self, place: AxlePose, sonar: int, head: int) -> float | None:
        return self.far[sonar](place) if sonar in self.far else self.otherwise

    def touched(self, place: AxlePose) -> frozenset[BumperSwitch]:
        return self.pressed


class Real:
    """A robot with its board, link, pace and watcher. ``at``: actions, seconds after the start."""

    def __init__(
        self,
        floor: Floor | None = None,
        config: RobotConfig | None = None,
        *,
        at: Iterable[TimedAction] = (),
        stops_at: float = float("inf"),
        passes: int = 250,
        board: SimulatedBoard | None = None,
    ) -> None:
        self.notices: list[LinkNotice] = []
        self.watcher = RecordingWatcher()
        self.pace = ScriptedPace(stops_at)
        self.robot = SimulatedSerialRobot(
            board or WiredBoard(floor, boot_loader=0.0, passes=passes),
            config,
            pace=self.pace,
            watcher=self.watcher,
            speed=None,
            on_notice=lambda notice, _: self.notices.append(notice),
        )
        self.board, self.link = self.robot.board, self.robot.link
        self.pace.robot = self.robot
        self.pace.due = list(at)

    @property
    def stands(self) -> bool:
        """Whether its motors are off, once the sent frames have arrived."""
        self.link.advance(0.2)
        return not self.board.is_driving


def wall_ahead(steps: float) -> WalledFloor:
    """A wall across the robot's way, so many steps north of its start."""
    return WalledFloor([(-9, steps * STEP, 9, steps * STEP)])
