"""Real robots for tests: the driver, and a simulated board in virtual time at the end of its line."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from devices.firmware_double.robot import DoubleRobot
from devices.firmware_double.surroundings import OpenFloor, Place, Surroundings, Switch, Walls
from devices.ports.robot import STEP, LinkNews, Motion, Pose
from devices.serial_robot.config import RobotConfig

NEAR = 0.1
"""Steps by which the board's true place may differ from what was asked, after a walk."""

Happening = tuple[float, Callable[[], None]]
"""Seconds of waiting after which something is done."""


class ScriptedPace:
    """Never waits in earnest; does things at their times, and says stop from ``stops_at`` seconds on."""

    def __init__(self, stops_at: float = float("inf")) -> None:
        self.stops_at = stops_at
        self.robot: DoubleRobot | None = None
        self.due: list[Happening] = []

    def sleep(self, seconds: float) -> bool:
        if self.robot is None:
            return True
        now = self.robot.time()
        for happening in [each for each in self.due if each[0] <= now]:
            self.due.remove(happening)
            happening[1]()
        return now < self.stops_at


class Diary:
    """A watcher that writes everything down."""

    def __init__(self) -> None:
        self.progress: list[Motion] = []
        self.passed: list[Pose] = []

    def progressed(self, motion: Motion, pose: Pose) -> None:
        self.progress.append(motion)

    def passing(self, pose: Pose) -> None:
        self.passed.append(pose)


class Sonars(OpenFloor):
    """Sonars that tell what they are told to, and bumpers likewise; nothing is ever in the way."""

    def __init__(self, far: float | None = None) -> None:
        self.far: dict[int, Callable[[Place], float | None]] = {}
        self.otherwise = far
        self.pressed: frozenset[Switch] = frozenset()

    def centimetres(self, place: Place, sonar: int, head: int) -> float | None:
        return self.far[sonar](place) if sonar in self.far else self.otherwise

    def touched(self, place: Place) -> frozenset[Switch]:
        return self.pressed


class Real:
    """A robot with everything that a test asks about it. ``at`` does things, seconds after the start."""

    def __init__(
        self,
        surroundings: Surroundings | None = None,
        config: RobotConfig | None = None,
        *,
        at: Iterable[Happening] = (),
        stops_at: float = float("inf"),
        passes: int = 250,
    ) -> None:
        self.news: list[LinkNews] = []
        self.diary = Diary()
        self.pace = ScriptedPace(stops_at)
        self.robot = DoubleRobot(
            surroundings,
            config,
            pace=self.pace,
            watcher=self.diary,
            speed=None,
            on_event=lambda news, _: self.news.append(news),
            passes=passes,
        )
        self.board, self.line = self.robot.board, self.robot.line
        self.pace.robot = self.robot
        self.pace.due = list(at)

    @property
    def stands(self) -> bool:
        """Whether its motors are off, once what was sent has arrived."""
        self.line.advance(0.2)
        return not self.board.is_driving


def wall_ahead(steps: float) -> Walls:
    """Across the robot's way, so many steps north of where it begins."""
    return Walls([(-9, steps * STEP, 9, steps * STEP)])
