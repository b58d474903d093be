"""Movements of a robot at the end of a link; and those of the real robot, from the first count to the last,
with the odometry.

The link stops the wheels by itself at the end of what was allowed, at most one step ahead. This module
decides whether another step is allowed, and why a movement ends early. The pace does all waiting.
"""

from __future__ import annotations

import threading
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable
from math import cos, degrees, pi, radians, sin
from typing import Generic, Protocol, TypeVar

from msgspec import Struct

from devices.ports.robot import (
    DEGREES_A_REPORT,
    STEP,
    Met,
    Motion,
    Pace,
    Pose,
    RobotProblem,
    StoppedBy,
    TurnResult,
    WalkResult,
    Watcher,
)
from devices.serial_robot.config import RobotConfig
from devices.serial_robot.link import RobotLink
from devices.serial_robot.senses import Clearance
from devices.wire.connection import travelled
from devices.wire.frames import MotorDrive
from devices.wire.link_state import LinkState
from devices.wire.telemetry import Telemetry

LACKING = 0.05
"""Of a step or a degree, that may be missing in one that counts as done."""

RENEW_BEFORE = 0.5
"""Of a step before its end, when the next one is decided about, so that the wheels need not stop."""

JITTER = 4
"""Counts that a wheel may go back by its play."""

STILL_AFTER = 0.06
"""Seconds without a count after which a wheel stands."""


def whole(units: float) -> int:
    """The whole steps or degrees that were done; never negative."""
    return max(0, int(units + LACKING))


class Progress:
    """Reports each whole step, or each ten degrees and the rest, of one movement once and in time."""

    def __init__(
        self, motion: Motion, amount: int, every: int, report: Callable[[Motion, Pose], None]
    ) -> None:
        """``amount``: steps or degrees of the movement. After each ``every`` of them comes a report."""
        self._motion, self._amount, self._every, self._report = motion, amount, every, report
        self._reported = 0

    def reached(self, units: float, pose: Pose) -> None:
        """Report the progress up to ``units``; the robot is at ``pose``."""
        while (following := min(self._amount, self._reported + self._every)) > self._reported:
            if whole(units) < following:
                return
            self._reported = following
            self._report(self._motion, pose)

    def finished(self, units: float, stopped_by: StoppedBy | None, pose: Pose) -> int:
        """The whole steps or degrees that were done: all of them, if nothing ended the movement early."""
        if stopped_by is not None:
            return min(self._amount, whole(units))
        self.reached(self._amount, pose)
        return self._amount


class Ending(Struct, frozen=True):
    """What became of a movement."""

    done: int
    """Whole steps or degrees."""
    stopped_by: StoppedBy | None
    met: Met | None


def met_something(stopped_by: StoppedBy | None, way: float, sides: Iterable[float] = ()) -> Met | None:
    """What ended a movement, as far as a real robot senses it: a sonar or a bumper knows only the side.

    ``way``: the direction of the movement, in degrees from the front. ``sides``: those of the bumpers that
    are pressed; the nearest to the way counts.
    """
    if stopped_by not in (StoppedBy.OBSTACLE, StoppedBy.COLLISION):
        return None
    nearest = min(sides, key=lambda side: abs((side - way + 180.0) % 360.0 - 180.0), default=way)
    return Met("something", "", way if stopped_by is StoppedBy.OBSTACLE else nearest)


PASSING_INTERVAL = 0.05
"""Seconds between two poses that are reported for a moving picture."""


class StoppableLink(Protocol):
    """What every link to a robot can do. Any thread and any signal handler may call it."""

    @property
    def name(self) -> str:
        """As it is named to a person."""

    def give_up(self) -> None:
        """End connecting at once, with the problem ``given-up``."""

    def stop(self) -> None:
        """At once. Never raises."""

    def wait_until_standing(self) -> None:
        """Wait until the robot stands after a stop."""


LinkType = TypeVar("LinkType", bound=StoppableLink)


class LinkedRobot(ABC, Generic[LinkType]):
    """What the commands of robots at the end of a link have in common, whatever drives them.

    A movement that loses the link ends with ``StoppedBy.LINK``, and the next command raises ``link-lost``,
    even if the link is back by then. Nothing resumes by itself. ``halt``, as at the end of a run, makes the
    robot usable again.
    """

    name = "donnie"

    def __init__(self, link: LinkType, *, pace: Pace, watcher: Watcher | None = None) -> None:
        self._link, self._pace, self._watcher = link, pace, watcher
        self._is_link_lost = False
        self._passing_at = 0.0

    @property
    def port(self) -> str:
        return self._link.name

    @property
    def speed(self) -> float | None:
        """A multiple of the robot's own pace; it has only this one."""
        return 1.0

    @speed.setter
    def speed(self, speed: float | None) -> None:
        """Has no effect."""

    def give_up(self) -> None:
        """End ``connect`` at once. Any thread and any signal handler may call it."""
        self._link.give_up()

    def halt(self) -> None:
        self._is_link_lost = False
        self._link.stop()

    def wait_until_standing(self) -> None:
        """Wait until the robot stands after a stop. Any thread and any signal handler may call it."""
        self._link.wait_until_standing()

    def forward(self, steps: int) -> WalkResult:
        """Walk forward. ``ValueError`` if ``steps`` is negative; ``RobotProblem`` if the link is lost."""
        return self._walked(Motion.FORWARD, steps, 1)

    def backward(self, steps: int) -> WalkResult:
        """Walk backward. ``ValueError`` if ``steps`` is negative; ``RobotProblem`` if the link is lost."""
        return self._walked(Motion.BACKWARD, steps, -1)

    def turn(self, degrees: int) -> TurnResult:
        """``RobotProblem`` if the link is lost."""
        self._require_link()
        if degrees == 0:
            return TurnResult(0, 0, None, self.pose())
        sense, motion = (1, Motion.RIGHT) if degrees > 0 else (-1, Motion.LEFT)
        report = Progress(motion, abs(degrees), DEGREES_A_REPORT, self._report_progress)
        end = self._turn(report, abs(degrees), sense)
        return TurnResult(degrees, sense * end.done, end.stopped_by, self.pose(), end.met)

    def _walked(self, motion: Motion, steps: int, sense: int) -> WalkResult:
        if steps < 0:
            raise ValueError("a walk has no negative steps")
        self._require_link()
        if steps == 0:
            return WalkResult(0, 0, None, self.pose())
        end = self._walk(Progress(motion, steps, 1, self._report_progress), steps, sense)
        return WalkResult(steps, end.done, end.stopped_by, self.pose(), end.met)

    def true_pose(self) -> Pose | None:
        """Unknown."""
        return None

    @abstractmethod
    def pose(self) -> Pose: ...

    @abstractmethod
    def _walk(self, report: Progress, steps: int, sense: int) -> Ending:
        """``sense``: 1 forward, -1 backward."""

    @abstractmethod
    def _turn(self, report: Progress, asked: int, sense: int) -> Ending:
        """``asked`` degrees; ``sense``: 1 to the right, -1 to the left."""

    @abstractmethod
    def _is_linked(self) -> bool: ...

    def _link_lost(self) -> RobotProblem:
        return RobotProblem("link-lost", port=self.port)

    def _require_link(self) -> None:
        if self._is_link_lost or not self._is_linked():
            self._is_link_lost = False
            raise self._link_lost()

    def _report_progress(self, motion: Motion, pose: Pose) -> None:
        if self._watcher is not None:
            self._watcher.progressed(motion, pose)

    def _report_passing(self, pose: Pose, now: float) -> None:
        """``now``: seconds on any clock."""
        if self._watcher is not None and now - self._passing_at >= PASSING_INTERVAL:
            self._passing_at = now
            self._watcher.passing(pose)


# --- movements that the wheels' encoders count


class MovementPlan(Struct, frozen=True):
    """What a movement is to do. ``unit`` is in counts: of a step, or of a degree."""

    drive: MotorDrive
    amount: int
    unit: float
    stride: int
    """Units that are allowed at once."""
    coast: int
    """Counts that the wheels roll on after a stop."""
    carried: float
    """Counts by which the previous movement overshot, in the direction of this one."""


class WheelProgress:
    """How far each wheel has come in its own sense of one drive; a wheel that is wired in another way comes
    nowhere, or back."""

    def __init__(self, drive: MotorDrive, telemetry: Telemetry, config: RobotConfig) -> None:
        self._senses = _SENSES[drive]
        self._config = config
        self._zero = self._best = self._now = self._counted(telemetry)
        self._best_at = (telemetry.at, telemetry.at)
        self.is_reversed = False
        """Whether both wheels went back as one that is wired the other way does, and neither came forward."""

    def is_wrong(self, telemetry: Telemetry, since: float, now: float) -> bool:
        """Whether a wheel that turns comes nowhere for too long, or back too far. ``since``: when the wheels
        were last commanded to turn."""
        counted, at = self._counted(telemetry), telemetry.at
        best_at = tuple(
            at if count > best else was
            for count, best, was in zip(counted, self._best, self._best_at, strict=True)
        )
        self._best_at = (best_at[0], best_at[1])
        self._best = (max(counted[0], self._best[0]), max(counted[1], self._best[1]))
        back = [best - count for best, count in zip(self._best, counted, strict=True)]
        is_wrong = max(back) >= self._config.wrong_way or (
            now - max(since, min(self._best_at)) > self._config.stall and max(back) > JITTER
        )
        came = [best - zero for best, zero in zip(self._best, self._zero, strict=True)]
        self.is_reversed = is_wrong and min(back) >= self._config.wrong_way / 2 and max(came) <= JITTER
        return is_wrong

    def _counted(self, telemetry: Telemetry) -> tuple[int, int]:
        return self._senses[0] * telemetry.right, self._senses[1] * telemetry.left


_SENSES = {
    MotorDrive.FORWARD: (1, 1),
    MotorDrive.BACKWARD: (-1, -1),
    MotorDrive.LEFT: (1, -1),
    MotorDrive.RIGHT: (-1, 1),
}
"""Of the right and the left wheel."""


class RobotMovement:
    """Runs once. Afterwards ``units`` and ``stopped_by`` say what was done."""

    def __init__(
        self,
        plan: MovementPlan,
        link: RobotLink,
        config: RobotConfig,
        pace: Pace,
        *,
        clearance: Callable[[Telemetry, float], Clearance],
        is_blocked: Callable[[Telemetry, float], bool],
        bumps: Callable[[Telemetry], bool],
        on_poll: Callable[[Telemetry, float], None],
    ) -> None:
        """``clearance`` is asked before each stride, ``is_blocked`` at each poll, with the units left of what
        was allowed. ``on_poll`` is called with the units done at each poll."""
        self.stopped_by: StoppedBy | None = None
        self._plan, self._link, self._config, self._pace = plan, link, config, pace
        self._clearance, self._bumps, self._on_poll = clearance, bumps, on_poll
        self._is_blocked = is_blocked
        self._progress = WheelProgress(plan.drive, link.telemetry, config)
        self._permit = link.permit()
        self._epoch = link.telemetry.epoch
        self._zero = self._travelled() - plan.carried
        self._allowed = 0
        self._commanded_at = link.now()

    @property
    def counts(self) -> float:
        """How far it came, including what the previous movement overshot."""
        return self._travelled() - self._zero

    @property
    def units(self) -> float:
        return self.counts / self._plan.unit

    @property
    def is_reversed(self) -> bool:
        """Whether it ended because both wheels count the wrong way."""
        return self.stopped_by is StoppedBy.WRONG_WAY and self._progress.is_reversed

    def run(self) -> None:
        """Move until it is done or something ends it. The wheels are off afterwards."""
        try:
            self.stopped_by = self._move()
        finally:  # also when a listener raises
            if not self._is_done():
                self._link.stop()
                self._commanded_at = (
                    self._link.now()
                )  # what the wheels count from now on shows whether they stand
        self._wait_until_still()
        if not self._is_still() and not self._link.await_stop():
            self.stopped_by = StoppedBy.RUNAWAY

    def _move(self) -> StoppedBy | None:
        while True:
            telemetry = self._link.telemetry
            self._on_poll(telemetry, self.units)
            if reason := self._reason_to_end(telemetry):
                return reason
            if self._is_done():
                return None
            if self._is_blocked(telemetry, self._allowed - self.units):
                return StoppedBy.OBSTACLE
            if not self._allow_more(telemetry):
                return StoppedBy.OBSTACLE
            if not self._drive() and not self._is_lost():
                return StoppedBy.USER
            if not self._pace.sleep(self._config.poll):
                return StoppedBy.USER

    def _reason_to_end(self, telemetry: Telemetry) -> StoppedBy | None:
        if self._is_lost():
            return StoppedBy.LINK
        if self._bumps(telemetry):
            return StoppedBy.COLLISION
        if self._is_stuck(telemetry):
            return StoppedBy.STALL
        return StoppedBy.WRONG_WAY if self._runs_wrong(telemetry) else None

    def _is_lost(self) -> bool:
        return self._link.state is not LinkState.STREAMING or self._link.telemetry.epoch != self._epoch

    def _is_stuck(self, telemetry: Telemetry) -> bool:
        """One stuck wheel is enough: the other one would turn the robot about it."""
        since = self._link.driving_since
        if since is None:
            return False
        return self._link.now() - max(since, telemetry.both_moved_at) > self._config.stall

    def _runs_wrong(self, telemetry: Telemetry) -> bool:
        since = self._link.driving_since
        return since is not None and self._progress.is_wrong(telemetry, since, self._link.now())

    def _is_done(self) -> bool:
        return self._allowed >= self._plan.amount and self.counts >= self._counts_until(self._allowed)

    def _counts_until(self, units: int) -> float:
        """Where to stop, so that the wheels roll on to the end: after one count at least."""
        total = units * self._plan.unit
        return max(total - self._plan.coast, min(1.0, total))

    def _allow_more(self, telemetry: Telemetry) -> bool:
        """Allow the next stride if it is time to, and the way is free. False once it is blocked, and all that
        was allowed before is done."""
        left = self._allowed - self.units
        if self._allowed and left > RENEW_BEFORE * self._plan.stride:
            return True
        clearance = self._clearance(telemetry, left)
        if clearance is Clearance.FREE:
            self._allowed = min(self._plan.amount, self._allowed + self._plan.stride)
        return clearance is not Clearance.BLOCKED or not self._has_used_allowance()

    def _has_used_allowance(self) -> bool:
        """The link has ended the drive then."""
        return self._allowed == 0 or self.counts >= self._counts_until(self._allowed)

    def _drive(self) -> bool:
        """Turn the wheels as far as is allowed. False if another thread stopped them meanwhile."""
        if self._allowed == 0:
            return self._permit == self._link.permit()
        until = self._zero + self._counts_until(self._allowed)
        return self._link.drive(self._permit, self._plan.drive, until)

    def _wait_until_still(self) -> None:
        """Let the wheels roll out, so that the final pose is right."""
        ends = self._link.now() + self._config.stop_timeout
        while self._link.now() < ends and not self._is_still():
            if not self._pace.sleep(self._config.poll):
                return
            self._on_poll(self._link.telemetry, self.units)

    def _is_still(self) -> bool:
        telemetry = self._link.telemetry
        if self._is_lost():
            return True
        stands_for = telemetry.counted_at - max(telemetry.changed_at, self._commanded_at)
        return self._link.driving_since is None and stands_for > STILL_AFTER

    def _travelled(self) -> float:
        return travelled(self._plan.drive, self._link.telemetry.right, self._link.telemetry.left)


# --- odometry

MOST_DEVIATION = 180.0
"""Counts, some 45 degrees, that a turn corrects; with more, the robot was carried somewhere else."""
TURNED_BY_HAND = 8.0
"""Counts between two movements above which a person turned the robot; fewer are wheels that roll out."""


class WheelOdometry:
    """Dead reckoning from the start pose. Any thread may ask. Metres and radians inside."""

    def __init__(self, config: RobotConfig, telemetry: Telemetry, start: Pose) -> None:
        self._metres_a_count = 2 * pi * config.wheel_radius / config.counts_a_turn
        self._axle = config.axle_length
        self._lock = threading.Lock()
        self.begin(telemetry, start)

    def begin(self, telemetry: Telemetry, start: Pose) -> None:
        """The robot is at ``start``, with the present counts."""
        with self._lock:
            self._right, self._left = telemetry.right, telemetry.left
            self._x, self._y, self._yaw = start.x * STEP, start.y * STEP, radians(90.0 - start.heading)

    def follow(self, telemetry: Telemetry) -> Pose:
        """The pose after the movement of the wheels since the last call."""
        with self._lock:
            right = (telemetry.right - self._right) * self._metres_a_count
            left = (telemetry.left - self._left) * self._metres_a_count
            self._right, self._left = telemetry.right, telemetry.left
            turned = (right - left) / self._axle
            ahead, middle = (right + left) / 2, self._yaw + turned / 2
            self._x += ahead * cos(middle)
            self._y += ahead * sin(middle)
            self._yaw += turned
            heading = round((90.0 - degrees(self._yaw)) % 360.0, 3) % 360.0
            return Pose(round(self._x / STEP, 3) + 0.0, round(self._y / STEP, 3) + 0.0, heading)


class HeadingTracker:
    """The heading that the commanded turns add up to, against the one that the wheels report.

    A turn corrects the difference: what the last turn overshot, and what uneven wheels added in a walk. But
    where a hand, a collision or a lost link turned the robot, its new heading is accepted. All values are
    counts of each wheel, to the right. Only for the program's thread.
    """

    def __init__(self, telemetry: Telemetry) -> None:
        self.begin(telemetry)

    def begin(self, telemetry: Telemetry) -> None:
        """Accept the present heading as the wanted one."""
        self._wanted = self._last = _turned(telemetry)

    def deviation(self, telemetry: Telemetry) -> float:
        """By how much the robot looks too far to the right, as a movement begins."""
        now = _turned(telemetry)
        if abs(now - self._last) > TURNED_BY_HAND:
            self._wanted += now - self._last
        if abs(now - self._wanted) > MOST_DEVIATION:
            self._wanted = now
        self._last = now
        return now - self._wanted

    def finished(self, counts: float, telemetry: Telemetry) -> None:
        """A movement has ended that was to turn the robot by ``counts``: 0 for a walk."""
        self._wanted += counts
        self._last = _turned(telemetry)


def _turned(telemetry: Telemetry) -> float:
    return travelled(MotorDrive.RIGHT, telemetry.right, telemetry.left)
