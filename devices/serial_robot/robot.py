"""The real robot: the port's commands, done over a line, counted by the encoders.

A movement that loses the line ends with ``StoppedBy.LINK``, and the next command raises ``link-lost``, even
if the line is back by then; what waits or measures raises it at once. Nothing goes on by itself. ``halt``, as
at the end of a run, wipes that slate.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from devices.ports.robot import (
    Bearing,
    Met,
    Motion,
    Moved,
    Pace,
    Pose,
    RobotProblem,
    Sighting,
    StoppedBy,
    Turned,
    Watcher,
)
from devices.serial_robot.config import RobotConfig
from devices.serial_robot.course import Course
from devices.serial_robot.line import RobotLine
from devices.serial_robot.movement import Aim, Movement
from devices.serial_robot.odometry import Odometry
from devices.serial_robot.progress import Progress, whole
from devices.serial_robot.scanning import AHEAD, angles, sightings
from devices.serial_robot.senses import Ahead, Senses, steps_told
from devices.wire import commands
from devices.wire.commands import Drive
from devices.wire.link_state import LinkState
from devices.wire.telemetry import REMEMBERED, Telemetry

DEGREES_A_REPORT = 10
SLICE = 0.05
"""Seconds between two looks of a wait."""
MOST_CARRIED = 100.0
"""Counts that the next walk makes up for; more than that, and the robot has been somewhere else."""
PICTURE = 0.05
"""Seconds between two places that are told for a moving picture."""


class SerialRobot:
    """One robot at the end of a line. All but ``halt``, ``pose``, ``time``, ``speed`` and ``known_distances``
    is the program's thread's."""

    def __init__(
        self,
        line: RobotLine,
        config: RobotConfig | None = None,
        *,
        pace: Pace,
        watcher: Watcher | None = None,
        start: Pose | None = None,
    ) -> None:
        """``start``: what its place is called where it stands when it is connected or reset."""
        self._line = line
        self._start_pose = start or Pose(0.0, 0.0, 0.0)
        self._config = config or RobotConfig()
        self._pace = pace
        self._watcher = watcher
        self._senses = Senses(self._config)
        self._odometry = Odometry(self._config)
        self._began = line.now()
        self._course = Course(line.telemetry)
        self._walked_too_far = 0.0
        self._lost_the_line = False
        self._pictured_at = 0.0

    @property
    def name(self) -> str:
        return "donnie"

    @property
    def colours(self) -> frozenset[str]:
        """None: no camera is part of the robot."""
        return frozenset()

    @property
    def telemetry(self) -> Telemetry:
        """What its board told last: counts of the wheels, sonars, bumpers, battery."""
        return self._line.telemetry

    @property
    def speed(self) -> float | None:
        """Times the real robot's pace, which is the only one that it has."""
        return 1.0

    @speed.setter
    def speed(self, speed: float | None) -> None:
        """Of no effect."""

    def connect(self) -> None:
        """Open the line and wait for the robot, some six seconds at most. RobotProblem says why not."""
        self._line.connect()
        self.reset()

    def give_up(self) -> None:
        """Have ``connect`` end at once, with ``given-up``. Any thread, a signal's handler too."""
        self._line.give_up()

    def wait_until_standing(self) -> None:
        """Behind a stop, before nobody looks after the robot any more. Any thread, a signal's handler too."""
        self._line.wait_until_standing()

    def close(self) -> None:
        """Stop the robot, see it stand and let go of the port. Any thread; never raises."""
        self._line.close()

    def reset(self) -> None:
        """Where the robot stands is its start now; its time begins."""
        self._odometry.begin(self._line.telemetry, self._start_pose)
        self._began = self._line.now()
        self._course.begin(self._line.telemetry)
        self._walked_too_far = 0.0
        self._lost_the_line = False

    # --- moving

    def forward(self, steps: int) -> Moved:
        """Walk forward. ValueError if ``steps`` is negative; RobotProblem if the line is lost."""
        return self._walk(Motion.FORWARD, steps)

    def backward(self, steps: int) -> Moved:
        """Walk backward. ValueError if ``steps`` is negative; RobotProblem if the line is lost."""
        return self._walk(Motion.BACKWARD, steps)

    def turn(self, degrees: int) -> Turned:
        """RobotProblem if the line is lost."""
        self._need_the_line()
        sense = 1 if degrees >= 0 else -1
        if degrees == 0:
            return Turned(0, 0, None, self.pose())
        drive, motion = (Drive.RIGHT, Motion.RIGHT) if sense > 0 else (Drive.LEFT, Motion.LEFT)
        asked, unit = abs(degrees), self._config.counts_a_degree
        astray = self._course.astray(self._line.telemetry)
        aim = Aim(drive, asked, unit, asked, self._config.turn_coast, sense * astray)
        already = self._line.telemetry.bumpers
        report = Progress(motion, asked, DEGREES_A_REPORT, self._tell)
        movement = self._movement(
            aim,
            may_begin=lambda *_: True,
            bumps=lambda now: any(new and not old for new, old in zip(now.bumpers, already, strict=True)),
            report=report,
        )
        done = self._run(movement, report, asked)
        self._keep_course(movement, sense * done * unit)
        new = [
            place for place, pressed in enumerate(self._line.telemetry.bumpers) if pressed > already[place]
        ]
        met = self._met(movement, sense * 90.0, new)
        return Turned(degrees, sense * done, self._end_of(movement), self.pose(), met)

    def halt(self) -> None:
        self._lost_the_line = False
        self._line.stop()

    def _walk(self, motion: Motion, steps: int) -> Moved:
        if steps < 0:
            raise ValueError("a walk has no negative steps")
        self._need_the_line()
        if steps == 0:
            return Moved(0, 0, None, self.pose())
        is_forward = motion is Motion.FORWARD
        sense, drive = (1, Drive.FORWARD) if is_forward else (-1, Drive.BACKWARD)
        bumpers = self._config.front_bumpers if is_forward else self._config.back_bumpers
        sonar = self._senses.sonar_at(Bearing.FRONT if is_forward else Bearing.BACK)
        unit = self._config.counts_a_step
        report = Progress(motion, steps, 1, self._tell)
        movement = self._movement(
            Aim(drive, steps, unit, 1, self._config.walk_coast, sense * self._walked_too_far),
            may_begin=lambda now, left: _VERDICT[self._senses.ahead(now, sonar, left + 2.0, sense)],
            bumps=lambda now: self._senses.touches(now, bumpers),
            report=report,
        )
        self._course.astray(self._line.telemetry)
        done = self._run(movement, report, steps)
        self._keep_course(movement, 0.0)
        self._walked_too_far = sense * _too_far(movement, done * unit)
        pressed = [place for place in sorted(bumpers) if self._line.telemetry.bumpers[place]]
        met = self._met(movement, 0.0 if is_forward else 180.0, pressed)
        return Moved(steps, done, self._end_of(movement), self.pose(), met)

    def _met(self, movement: Movement, way: float, touched: Iterable[int]) -> Met | None:
        """What ended the movement, as far as it is felt: a sonar or a bumper tells the side and no more.

        ``way``: where it went, in degrees from the front; of several bumpers the nearest to that.
        """
        if movement.stopped_by not in (StoppedBy.OBSTACLE, StoppedBy.COLLISION):
            return None
        sides = [self._config.bumper_degrees[place] for place in touched]
        if movement.stopped_by is StoppedBy.OBSTACLE or not sides:
            return Met(SOMETHING, "", way)
        return Met(SOMETHING, "", min(sides, key=lambda side: abs((side - way + 180.0) % 360.0 - 180.0)))

    def _movement(
        self,
        aim: Aim,
        *,
        may_begin: Callable[[Telemetry, float], bool | None],
        bumps: Callable[[Telemetry], bool],
        report: Progress,
    ) -> Movement:
        def seen(telemetry: Telemetry, units: float) -> None:
            pose = self._odometry.follow(telemetry)
            report.reached(units, pose)
            self._picture(pose)

        return Movement(
            aim, self._line, self._config, self._pace, may_begin=may_begin, bumps=bumps, seen=seen
        )

    def _run(self, movement: Movement, report: Progress, asked: int) -> int:
        """Whole steps or degrees that were done: all of them, if nothing ended it before."""
        movement.run()
        if movement.stopped_by is None:
            report.reached(asked, self.pose())
            return asked
        return min(asked, whole(movement.units))

    def _keep_course(self, movement: Movement, turned: float) -> None:
        """What ended otherwise than by its own will may have been turned by something else."""
        if _ended_itself(movement):
            self._course.went(turned, self._line.telemetry)
        else:
            self._course.begin(self._line.telemetry)

    def _end_of(self, movement: Movement) -> StoppedBy | None:
        if movement.stopped_by is StoppedBy.LINK:
            self._lost_the_line = True
            self._line.wait_until_told()
        return movement.stopped_by

    def _need_the_line(self) -> None:
        if self._lost_the_line or self._line.state is not LinkState.STREAMING:
            self._lost_the_line = False
            raise self._link_lost()

    def _need_the_same_line(self, era: int) -> None:
        """A line that was lost meanwhile is another one, even if it is back by now."""
        if self._line.telemetry.era != era or self._line.state is not LinkState.STREAMING:
            self._lost_the_line = True
            raise self._link_lost()

    def _link_lost(self) -> RobotProblem:
        """That it was lost is told before what follows from it."""
        self._line.wait_until_told()
        return RobotProblem("link-lost", port=self._line.name)

    # --- waiting and sensing

    def wait(self, seconds: float) -> bool:
        """RobotProblem ``link-lost`` without a line, or if it is lost meanwhile."""
        self._need_the_line()
        return self._wait(seconds, self._line.telemetry.era)

    def _wait(self, seconds: float, era: int) -> bool:
        ends = self._line.now() + max(0.0, seconds)
        permit = self._line.permit()
        while (left := ends - self._line.now()) > 1e-9:
            goes_on = self._pace.sleep(min(SLICE, left)) and permit == self._line.permit()
            self._need_the_same_line(era)
            if not goes_on:
                return False
        return True

    def time(self) -> float:
        return self._line.now() - self._began

    def pose(self) -> Pose:
        return self._odometry.follow(self._line.telemetry)

    def distance(self, bearing: Bearing) -> int:
        """RobotProblem ``no-sensor`` where none looks, ``link-lost`` without a line."""
        self._need_the_line()
        era = self._line.telemetry.era
        sonar = self._senses.sonar_at(bearing)
        if sonar is None:
            raise RobotProblem("no-sensor", bearing=bearing.name.lower().replace("_", " "))
        return steps_told(self._measured(sonar, era))

    def known_distances(self) -> dict[Bearing, int]:
        """What the sonars told last; of a line that was lost nothing is known."""
        return self._senses.known(self._line.telemetry)

    def scan(self) -> tuple[Sighting, ...]:
        """What the sonar on the head meets, from left to right; without colours or names.

        RobotProblem ``no-camera`` without a head, ``link-lost`` without a line.
        """
        self._need_the_line()
        era = self._line.telemetry.era
        sonar = self._config.head_sonar
        if sonar is None:
            raise RobotProblem("no-camera")
        met: list[tuple[int, float | None]] = []
        for degrees in angles(self._config.head_stride):
            self._line.put(commands.head(AHEAD + degrees))
            if not self._wait(self._config.head_pause, era):
                break
            met.append((degrees, self._measured(sonar, era)))
        self._line.put(commands.head(AHEAD))
        return sightings(met)

    def _measured(self, sonar: int, era: int) -> float | None:
        """Centimetres; waits two refreshes at most for a sonar that has told nothing yet."""
        ends = self._line.now() + REMEMBERED
        while (told := self._senses.newest(self._line.telemetry, sonar)) is None and self._line.now() < ends:
            goes_on = self._pace.sleep(self._config.poll)
            self._need_the_same_line(era)
            if not goes_on:
                break
        return told

    # --- telling

    def _tell(self, motion: Motion, pose: Pose) -> None:
        if self._watcher is not None:
            self._watcher.progressed(motion, pose)

    def _picture(self, pose: Pose) -> None:
        if self._watcher is not None and self._line.now() - self._pictured_at >= PICTURE:
            self._pictured_at = self._line.now()
            self._watcher.passing(pose)


def _too_far(movement: Movement, counts: float) -> float:
    """By how much it went beyond what it is told to have done: little, if it ended by its own will."""
    too_far = movement.counts - counts
    return too_far if _ended_itself(movement) and abs(too_far) <= MOST_CARRIED else 0.0


def _ended_itself(movement: Movement) -> bool:
    return movement.stopped_by in (None, StoppedBy.OBSTACLE)


SOMETHING = "something"
"""What was met, where the robot can't tell."""

_VERDICT = {Ahead.FREE: True, Ahead.DOUBTFUL: None, Ahead.BLOCKED: False}
