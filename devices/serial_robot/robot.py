"""The real robot: the port's commands, executed over a link and counted by the encoders.

Waiting and measuring raise ``link-lost`` at once when the link is lost.
"""

from __future__ import annotations

from collections.abc import Callable

from devices.camera import CameraSweep, ColourCamera
from devices.ports.robot import Bearing, LinkNotice, Pace, Pose, RobotProblem, Sighting, StoppedBy, Watcher
from devices.serial_robot.config import RobotConfig
from devices.serial_robot.link import RobotLink
from devices.serial_robot.movement import (
    Ending,
    HeadingTracker,
    LinkedRobot,
    MovementPlan,
    Progress,
    RobotMovement,
    WheelOdometry,
    met_something,
)
from devices.serial_robot.senses import (
    BoardSensors,
    Clearance,
    coloured_sightings,
    head_angle,
    scan_angles,
    sightings,
    to_steps,
)
from devices.wire import frames
from devices.wire.frames import AS_ORIGINAL, MotorDrive
from devices.wire.link_state import LinkState
from devices.wire.telemetry import REMEMBERED, Telemetry

SLICE = 0.05
"""Seconds between two checks during a wait."""
MOST_OVERSHOOT = 100.0
"""Counts that the next walk corrects; with more, the robot was carried somewhere else."""
WATCHED = 0.75
"""Steps that must be free at the end of the step that is being walked. A step is only begun if one would be;
the rest allows for the sonars' resolution."""
_DIAGONALS = {Bearing.FRONT_RIGHT: 45.0, Bearing.FRONT_LEFT: -45.0}
"""In degrees from the front, positive to the right."""


class SerialRobot(LinkedRobot[RobotLink]):
    """One robot at the end of a link. Only the program's thread may call its methods, except ``halt``,
    ``pose``, ``time``, ``speed`` and ``known_distances``."""

    def __init__(
        self,
        link: RobotLink,
        config: RobotConfig | None = None,
        *,
        pace: Pace,
        watcher: Watcher | None = None,
        start: Pose | None = None,
        on_notice: Callable[[LinkNotice, str], None] | None = None,
    ) -> None:
        """``start``: the pose that it is taken to have when it is connected or reset. ``on_notice``: as of
        its link, for what only a movement shows; called in the program's thread."""
        super().__init__(link, pace=pace, watcher=watcher)
        self._start_pose = start or Pose(0.0, 0.0, 0.0)
        self._config = config or RobotConfig()
        self._sensors = BoardSensors(self._config)
        self._odometry = WheelOdometry(self._config, link.telemetry, self._start_pose)
        self._began = link.now()
        self._heading = HeadingTracker(link.telemetry)
        self._overshoot = 0.0
        self._on_notice = on_notice
        self._has_moved = False
        """Whether a movement has shown that the wheels count the right way."""
        self.camera: ColourCamera | None = None
        """On its head, if there is one; set after construction."""
        if self._config.wiring != AS_ORIGINAL:
            link.rewire(self._config.wiring)

    @property
    def may_drive_on(self) -> bool:
        """Whether the connection was lost while it drove, and it was not stopped since."""
        return self._link.may_drive_on

    @property
    def has_run_away(self) -> bool:
        """Whether its wheels turn although all was done to stop them."""
        return self._link.has_run_away

    @property
    def colours(self) -> frozenset[str]:
        """Those of its camera."""
        return frozenset() if self.camera is None else self.camera.colours

    @property
    def telemetry(self) -> Telemetry:
        """What its board last reported: counts of the wheels, sonars, bumpers, battery."""
        return self._link.telemetry

    def connect(self) -> None:
        """Open the link and wait for the robot, some six seconds at most. Raises ``RobotProblem``."""
        self._link.connect()
        self.reset()

    def close(self) -> None:
        """Stop the robot, wait until it stands, and close the port. Any thread; never raises."""
        self._link.close()
        if self.camera is not None:
            self.camera.close()

    def reset(self) -> None:
        """Take the robot's present place as its start, and begin its time at 0."""
        self._odometry.begin(self._link.telemetry, self._start_pose)
        self._began = self._link.now()
        self._heading.begin(self._link.telemetry)
        self._overshoot = 0.0
        self._is_link_lost = False

    # --- moving

    def _walk(self, report: Progress, steps: int, sense: int) -> Ending:
        is_forward = sense > 0
        drive = MotorDrive.FORWARD if is_forward else MotorDrive.BACKWARD
        bumpers = self._config.front_bumpers if is_forward else self._config.back_bumpers
        sonar = self._sensors.sonar_at(Bearing.FRONT if is_forward else Bearing.BACK)
        unit = self._config.counts_a_step
        movement = self._movement(
            MovementPlan(drive, steps, unit, 1, self._config.walk_coast, sense * self._overshoot),
            clearance=lambda now, left: self._sensors.ahead(now, sonar, left + 2.0, sense),
            is_blocked=lambda now, left: self._is_blocked(now, sonar, left, sense),
            bumps=lambda now: self._sensors.touches(now, bumpers),
            report=report,
        )
        self._heading.deviation(self._link.telemetry)
        done = self._run(movement, report)
        self._update_heading(movement, 0.0)
        self._overshoot = sense * _overshoot_of(movement, done * unit)
        pressed = [place for place in sorted(bumpers) if self._link.telemetry.bumpers[place]]
        return self._ended(movement, done, self._side_of_obstacle(is_forward=is_forward), pressed)

    def _turn(self, report: Progress, asked: int, sense: int) -> Ending:
        drive, unit = MotorDrive.RIGHT if sense > 0 else MotorDrive.LEFT, self._config.counts_a_degree
        deviation = self._heading.deviation(self._link.telemetry)
        already = self._link.telemetry.bumpers
        movement = self._movement(
            MovementPlan(drive, asked, unit, asked, self._config.turn_coast, sense * deviation),
            clearance=lambda *_: Clearance.FREE,
            is_blocked=lambda *_: False,
            bumps=lambda now: any(new and not old for new, old in zip(now.bumpers, already, strict=True)),
            report=report,
        )
        done = self._run(movement, report)
        self._update_heading(movement, sense * done * unit)
        bumpers = enumerate(self._link.telemetry.bumpers)
        pressed = [place for place, is_pressed in bumpers if is_pressed > already[place]]
        return self._ended(movement, done, sense * 90.0, pressed)

    def _ended(self, movement: RobotMovement, done: int, way: float, pressed: list[int]) -> Ending:
        if movement.stopped_by is StoppedBy.LINK:
            self._is_link_lost = True
            self._link.wait_until_notified()
        sides = [self._config.bumper_degrees[place] for place in pressed]
        return Ending(done, movement.stopped_by, met_something(movement.stopped_by, way, sides))

    def _is_blocked(self, now: Telemetry, sonar: int | None, left: float, sense: int) -> bool:
        """Whether a walk must end in the middle of a step, because something is closer than the step allows.

        A person may step in, and wheels that slip or count wrong come nearer than they count.
        """
        if self._sensors.ahead(now, sonar, max(0.0, left) + WATCHED, sense) is Clearance.BLOCKED:
            return True
        return sense > 0 and self._close_diagonal(now) is not None

    def _close_diagonal(self, now: Telemetry) -> Bearing | None:
        limit = self._config.diagonal_limit
        return next((each for each in _DIAGONALS if self._sensors.is_close(now, each, limit)), None)

    def _side_of_obstacle(self, *, is_forward: bool) -> float:
        """Degrees from the front, positive to the right."""
        if not is_forward:
            return 180.0
        close = self._close_diagonal(self._link.telemetry)
        return 0.0 if close is None else _DIAGONALS[close]

    def _movement(
        self,
        plan: MovementPlan,
        *,
        clearance: Callable[[Telemetry, float], Clearance],
        is_blocked: Callable[[Telemetry, float], bool],
        bumps: Callable[[Telemetry], bool],
        report: Progress,
    ) -> RobotMovement:
        def on_poll(telemetry: Telemetry, units: float) -> None:
            pose = self._odometry.follow(telemetry)
            report.reached(units, pose)
            self._report_passing(pose, self._link.now())

        return RobotMovement(
            plan,
            self._link,
            self._config,
            self._pace,
            clearance=clearance,
            is_blocked=is_blocked,
            bumps=bumps,
            on_poll=on_poll,
        )

    def _run(self, movement: RobotMovement, report: Progress) -> int:
        """The whole steps or degrees that were done: all of them, if nothing ended the movement early."""
        began = self.pose()
        movement.run()
        if movement.is_reversed and self._config.finds_profile and not self._has_moved:
            self._take_profile_of_2018(began)
        self._has_moved = self._has_moved or movement.counts > self._config.wrong_way
        return report.finished(movement.units, movement.stopped_by, self.pose())

    def _take_profile_of_2018(self, began: Pose) -> None:
        """Both wheels counted backward in the first half step of all: its firmware is the newer one.

        The movement has ended, and is not resumed: reversed motors would look the same.
        """
        self._config = self._config.as_of_2018()
        self._link.rewire(self._config.wiring)
        self._odometry.begin(self._link.telemetry, _mirrored(self.pose(), began))
        if self._on_notice is not None:
            self._on_notice(LinkNotice.PROFILE_2018, "")

    def _update_heading(self, movement: RobotMovement, turned: float) -> None:
        """A movement that did not end as planned may have been turned by something else."""
        if _ended_as_planned(movement):
            self._heading.finished(turned, self._link.telemetry)
        else:
            self._heading.begin(self._link.telemetry)

    def _is_linked(self) -> bool:
        return self._link.state is LinkState.STREAMING

    def _require_same_link(self, epoch: int) -> None:
        """A link that was lost meanwhile doesn't count as the same, even if it is back by now."""
        if self._link.telemetry.epoch != epoch or not self._is_linked():
            self._is_link_lost = True
            raise self._link_lost()

    def _link_lost(self) -> RobotProblem:
        """The listener receives the loss before the error that follows from it."""
        self._link.wait_until_notified()
        return super()._link_lost()

    # --- waiting and sensing

    def wait(self, seconds: float) -> bool:
        """Wait. ``RobotProblem`` ``link-lost`` without a link, or if it is lost meanwhile."""
        self._require_link()
        return self._wait(seconds, self._link.telemetry.epoch)

    def _wait(self, seconds: float, epoch: int) -> bool:
        ends = self._link.now() + max(0.0, seconds)
        permit = self._link.permit()
        while (left := ends - self._link.now()) > 1e-9:
            is_running = self._pace.sleep(min(SLICE, left)) and permit == self._link.permit()
            self._require_same_link(epoch)
            if not is_running:
                return False
        return True

    def time(self) -> float:
        return self._link.now() - self._began

    def pose(self) -> Pose:
        return self._odometry.follow(self._link.telemetry)

    def distance(self, bearing: Bearing) -> int:
        """In steps. ``RobotProblem`` ``no-sensor`` where no sensor looks, ``link-lost`` without a link."""
        self._require_link()
        epoch = self._link.telemetry.epoch
        sonar = self._sensors.sonar_at(bearing)
        if sonar is None:
            raise RobotProblem("no-sensor", bearing=bearing.words)
        return to_steps(self._measured(sonar, epoch))

    def known_distances(self) -> dict[Bearing, int]:
        """What the sonars measured last; empty after the link was lost."""
        return self._sensors.known(self._link.telemetry)

    def scan(self) -> tuple[Sighting, ...]:
        """The coloured things that its camera sees, from left to right, as far as the head's sonar measures.

        Without a camera, or if it fails, what the sonar meets, without colours. ``RobotProblem``
        ``no-camera`` without a head, ``link-lost`` without a link.
        """
        self._require_link()
        epoch = self._link.telemetry.epoch
        sonar = self._config.head_sonar
        if sonar is None:
            raise RobotProblem("no-camera")
        sweep, measured = CameraSweep(self.camera), scan_angles(self._config.head_stride)
        measurements: list[tuple[int, float | None]] = []
        for degrees in sorted({*measured, *sweep.directions}):
            self._look(degrees)
            if not self._wait(self._config.head_pause, epoch):
                break
            if degrees in measured:
                measurements.append((degrees, self._measured(sonar, epoch)))
            sweep.look(degrees)
        self._look(0)
        if sweep.problem is not None and self._watcher is not None:
            self._watcher.sense_failed(sweep.problem)
        return sightings(measurements) if sweep.is_blind else coloured_sightings(sweep.things(), measurements)

    def _look(self, degrees: int) -> None:
        angle = head_angle(degrees, is_mirrored=self._config.head_is_mirrored)
        self._link.put(frames.head_frame(angle))

    def _measured(self, sonar: int, epoch: int) -> float | None:
        """Centimetres; waits two refreshes at most for a sonar that has measured nothing yet."""
        ends = self._link.now() + REMEMBERED
        while (
            measured := self._sensors.newest(self._link.telemetry, sonar)
        ) is None and self._link.now() < ends:
            is_running = self._pace.sleep(self._config.poll)
            self._require_same_link(epoch)
            if not is_running:
                break
        return measured


def _mirrored(pose: Pose, began: Pose) -> Pose:
    """As far on the other side of ``began``."""
    heading = (2 * began.heading - pose.heading) % 360.0
    return Pose(2 * began.x - pose.x, 2 * began.y - pose.y, heading)


def _overshoot_of(movement: RobotMovement, counts: float) -> float:
    """By how much a movement exceeded what counts as done; 0 if something else ended it."""
    too_far = movement.counts - counts
    return too_far if _ended_as_planned(movement) and abs(too_far) <= MOST_OVERSHOOT else 0.0


def _ended_as_planned(movement: RobotMovement) -> bool:
    return movement.stopped_by in (None, StoppedBy.OBSTACLE)
