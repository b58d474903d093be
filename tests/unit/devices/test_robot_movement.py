"""One movement of the real robot, poll by poll: the test is the link, its clock and the wheels."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from msgspec.structs import replace

from devices.ports.robot import StoppedBy
from devices.serial_robot.config import RobotConfig
from devices.serial_robot.movement import MovementPlan, RobotMovement
from devices.serial_robot.senses import Clearance
from devices.wire.frames import MotorDrive
from devices.wire.link_state import LinkState
from devices.wire.telemetry import Telemetry

CONFIG = RobotConfig(poll=0.125, stall=0.5, stop_timeout=1.0)
"""Times that binary numbers hold exactly."""
WALK = MovementPlan(MotorDrive.FORWARD, amount=3, unit=100.0, stride=1, coast=8, carried=0.0)


class Wheels:
    """A link, and the pace of the program: at each sleep both wheels come to the next count."""

    def __init__(self, *counts: int) -> None:
        self.counts = [*counts]
        self.time, self.voided = 0.0, 0
        self.state, self.telemetry = LinkState.STREAMING, Telemetry()
        self.driving_since: float | None = None
        self.until: list[float] = []
        """Where each command to drive was to end."""
        self.stops = 0
        self.obeys = True
        self.on_sleep: Callable[[int], bool] = lambda _: True
        """Called with the number of the sleep; returns whether the program continues."""
        self.sleeps = 0

    def now(self) -> float:
        return self.time

    def permit(self) -> int:
        return self.voided

    def drive(self, permit: int, drive: MotorDrive, until: float) -> bool:
        assert drive is MotorDrive.FORWARD
        self.until.append(until)
        self.driving_since = self.time if self.driving_since is None else self.driving_since
        return permit == self.voided

    def stop(self) -> None:
        self.stops += 1
        self.driving_since = None

    def await_stop(self) -> bool:
        return self.obeys

    def sleep(self, seconds: float) -> bool:
        assert seconds == 0.125
        self.time, self.sleeps = self.time + seconds, self.sleeps + 1
        count = self.counts.pop(0) if self.counts else self.telemetry.right
        moved_at = self.time if count != self.telemetry.right else self.telemetry.changed_at
        self.telemetry = replace(
            self.telemetry,
            at=self.time,
            right=count,
            left=count,
            counted_at=self.time,
            changed_at=moved_at,
            both_moved_at=moved_at,
        )
        if self.until and count >= self.until[-1]:
            self.driving_since = None
        return self.on_sleep(self.sleeps)


class Moved:
    """A movement with what it asked and reported."""

    def __init__(self, link: Any, plan: MovementPlan = WALK) -> None:
        self.asked: list[float] = []
        self.answers: list[Clearance] = []
        """To the first questions; then the way is free."""
        self.bumped = self.blocked = False
        self.watched: list[float] = []
        """The units for which the way was watched."""
        self.units: list[float] = []
        self.movement = RobotMovement(
            plan,
            link,
            CONFIG,
            link,
            clearance=self._clearance,
            is_blocked=self._is_blocked,
            bumps=lambda _: self.bumped,
            on_poll=lambda _, units: self.units.append(units),
        )

    def _is_blocked(self, _: Telemetry, left: float) -> bool:
        self.watched.append(round(left, 6))
        return self.blocked

    def _clearance(self, _: Telemetry, left: float) -> Clearance:
        self.asked.append(round(left, 6))
        return self.answers.pop(0) if self.answers else Clearance.FREE


def test_the_next_step_is_allowed_when_half_of_one_is_left() -> None:
    """Each ends eight counts earlier, as the wheels roll on; at the end they are seen to stand."""
    link = Wheels(0, 49, 50, 149, 150, 249, 291, 292, 300)
    moved = Moved(link)
    link.obeys = False
    moved.movement.run()

    assert link.until == [92, 92, 92, 192, 192, 292, 292, 292]
    assert moved.asked == [0, 0.5, 0.5, 0.09]
    assert moved.watched == [0, 1, 0.51, 0.5, 0.51, 0.5, 0.51, 0.09]
    assert (moved.movement.stopped_by, moved.movement.units, link.stops) == (None, 3.0, 0)
    assert moved.units == [0, 0, 0.49, 0.5, 1.49, 1.5, 2.49, 2.91, 2.92, 3.0, 3.0]


def test_a_step_that_is_doubtful_waits_and_one_that_is_blocked_ends_the_walk() -> None:
    """It ends once the step before is done and the wheels were commanded to stand."""
    link = Wheels(0, 50, 60, 92, 100)
    moved = Moved(link)
    moved.answers = [Clearance.DOUBTFUL, Clearance.FREE, Clearance.DOUBTFUL, *[Clearance.BLOCKED] * 2]
    moved.movement.run()

    assert link.until == [92, 92, 92]
    assert moved.asked == [0, 0, 0.5, 0.4, 0.08]
    assert (moved.movement.stopped_by, moved.movement.units, link.stops) == (StoppedBy.OBSTACLE, 1.0, 1)


@pytest.mark.parametrize("carried", [0.0, 20.0, -20.0])
def test_a_walk_whose_first_step_is_blocked_does_not_begin(carried: float) -> None:
    link = Wheels()
    moved = Moved(link, replace(WALK, carried=carried))
    moved.answers = [Clearance.BLOCKED]
    moved.movement.run()

    assert (moved.movement.stopped_by, link.until) == (StoppedBy.OBSTACLE, [])
    assert moved.units[0] == carried / 100


def test_the_way_of_a_turn_is_asked_for_again_when_half_of_it_is_left() -> None:
    link = Wheels(176, 180, 355)
    moved = Moved(link, MovementPlan(MotorDrive.FORWARD, 90, 4.0, stride=90, coast=5, carried=0.0))
    moved.movement.run()

    assert (moved.asked, link.until) == ([0, 45], [355.0] * 3)


@pytest.mark.parametrize(
    ("unit", "amount", "stride", "coast", "carried", "until"),
    [
        (100.0, 1, 1, 8, 0.0, 92.0),
        (4.0, 90, 90, 5, 0.0, 355.0),
        (4.0, 1, 1, 5, 0.0, 1.0),  # after one count at least
        (0.5, 1, 1, 5, 0.0, 0.5),
        (100.0, 1, 1, 8, 10.0, 82.0),  # what the walk before came too far
        (100.0, 1, 1, 8, -10.0, 102.0),
        (100.0, 1, 1, 8, -60.0, 152.0),
    ],
)
def test_a_movement_ends_before_its_end_by_what_the_wheels_roll_on(
    unit: float, amount: int, stride: int, coast: int, carried: float, until: float
) -> None:
    link = Wheels(1000)
    moved = Moved(link, MovementPlan(MotorDrive.FORWARD, amount, unit, stride, coast, carried))
    moved.movement.run()

    assert link.until == [until]
    assert moved.units[:2] == [carried / unit, (1000 + carried) / unit]


def lose(moved: Moved, link: Wheels) -> None:
    link.state = LinkState.LOST
    moved.bumped = True


def restart(_: Moved, link: Wheels) -> None:
    link.telemetry = replace(link.telemetry, epoch=1)


@pytest.mark.parametrize(
    ("change", "stopped_by"),
    [
        (lose, StoppedBy.LINK),
        (restart, StoppedBy.LINK),
        (lambda moved, _: setattr(moved, "bumped", True), StoppedBy.COLLISION),
        (lambda moved, _: setattr(moved, "blocked", True), StoppedBy.OBSTACLE),
        (lambda _, link: setattr(link, "voided", 1), StoppedBy.USER),
    ],
    ids=["lost", "restarted", "bumped", "blocked", "halted"],
)
def test_why_a_movement_ends_early(change: Callable[[Moved, Wheels], None], stopped_by: StoppedBy) -> None:
    link = Wheels(10, 20, 30, 40, 50)
    moved = Moved(link)

    def on_sleep(number: int) -> bool:
        if number == 3:
            change(moved, link)
        return True

    link.on_sleep = on_sleep
    moved.movement.run()

    assert (moved.movement.stopped_by, link.stops) == (stopped_by, 1)
    assert moved.units[:4] == [0.0, 0.1, 0.2, 0.3]


def test_a_link_that_is_lost_just_before_a_command_has_ended_the_movement() -> None:
    class Unplugged(Wheels):
        def drive(self, permit: int, drive: MotorDrive, until: float) -> bool:
            if len(self.until) == 2:
                self.state, self.voided = LinkState.LOST, 1
            return super().drive(permit, drive, until)

    moved = Moved(Unplugged(10, 20, 30, 40))
    moved.movement.run()

    assert (moved.movement.stopped_by, moved.units) == (StoppedBy.LINK, [0.0, 0.1, 0.2, 0.3])


def test_a_wheel_that_does_not_count_ends_a_movement_after_half_a_second() -> None:
    """It counted last after an eighth of a second; one more look shows that it stands."""
    link = Wheels(10)
    moved = Moved(link)
    moved.movement.run()

    assert (moved.movement.stopped_by, link.time, len(link.until)) == (StoppedBy.STALL, 0.875, 6)
    assert not moved.movement.is_reversed


@pytest.mark.parametrize(
    ("counts", "stopped_by", "is_reversed"),
    [
        ((-20, -59, 92), StoppedBy.OBSTACLE, False),
        ((-20, -60), StoppedBy.WRONG_WAY, True),
        ((50, -10), StoppedBy.WRONG_WAY, False),  # they came forward before
    ],
)
def test_wheels_that_go_back_sixty_counts_end_a_movement(
    counts: tuple[int, ...], stopped_by: StoppedBy, is_reversed: bool
) -> None:
    moved = Moved(Wheels(*counts))
    moved.answers = [Clearance.FREE, *[Clearance.BLOCKED] * 9]
    moved.movement.run()

    assert (moved.movement.stopped_by, moved.movement.is_reversed) == (stopped_by, is_reversed)


def test_a_program_that_is_stopped_ends_a_movement_and_waits_for_no_wheel() -> None:
    link = Wheels(10, 20, 30)
    moved = Moved(link)
    link.on_sleep = lambda number: number < 2
    moved.movement.run()

    assert (moved.movement.stopped_by, link.stops, link.sleeps) == (StoppedBy.USER, 1, 3)


@pytest.mark.parametrize(("obeys", "stopped_by"), [(True, StoppedBy.COLLISION), (False, StoppedBy.RUNAWAY)])
def test_wheels_are_waited_for_a_second_and_may_have_run_away(obeys: bool, stopped_by: StoppedBy) -> None:
    link = Wheels(*range(10, 1000, 10))
    moved = Moved(link)
    link.obeys, moved.bumped = obeys, True
    moved.movement.run()

    assert (moved.movement.stopped_by, link.sleeps) == (stopped_by, 8)
    assert moved.units == [each / 10 for each in range(9)]


@pytest.mark.parametrize(
    ("since", "both_moved_at", "now", "is_stuck"),
    [
        (None, 0.0, 9.0, False),
        (0.0, 0.0, 0.5, False),
        (0.0, 0.0, 0.51, True),
        (0.25, 0.0, 0.75, False),
        (0.25, 0.0, 0.76, True),
        (0.0, 0.25, 0.75, False),
        (0.0, 0.25, 0.76, True),
    ],
)
def test_a_wheel_is_stuck_that_has_not_counted_for_half_a_second_of_a_drive(
    since: float | None, both_moved_at: float, now: float, is_stuck: bool
) -> None:
    link = Wheels()
    moved = Moved(link)
    link.driving_since, link.time = since, now

    assert moved.movement._is_stuck(Telemetry(both_moved_at=both_moved_at)) is is_stuck


@pytest.mark.parametrize(
    ("state", "since", "counted_at", "changed_at", "is_still"),
    [
        (LinkState.STREAMING, None, 0.06, 0.0, False),
        (LinkState.STREAMING, None, 0.07, 0.0, True),
        (LinkState.STREAMING, None, 0.55, 0.5, False),
        (LinkState.STREAMING, None, 0.57, 0.5, True),
        (LinkState.STREAMING, 0.0, 9.0, 0.5, False),
        (LinkState.LOST, 0.0, 9.0, 9.0, True),  # nothing is known of them
    ],
)
def test_wheels_are_still_that_were_stopped_and_count_no_more(
    state: LinkState, since: float | None, counted_at: float, changed_at: float, is_still: bool
) -> None:
    """Other frames, such as the last one here, say nothing of them."""
    link = Wheels()
    moved = Moved(link)
    link.state, link.driving_since = state, since
    link.telemetry = Telemetry(at=9.0, counted_at=counted_at, changed_at=changed_at)

    assert moved.movement._is_still() is is_still
