"""One movement of the real robot, from its first count to its last: walked or turned, watched and ended.

The line stops the wheels by itself where they were told to end, one step ahead at most; here it is decided
whether there may be another step, and why a movement ends before its end. All waiting is the pace's.
"""

from __future__ import annotations

from collections.abc import Callable

from devices.ports.robot import Pace, StoppedBy
from devices.ports.values import Frozen
from devices.serial_robot.config import RobotConfig
from devices.serial_robot.line import RobotLine
from devices.wire.commands import Drive
from devices.wire.connection import travelled
from devices.wire.link_state import LinkState
from devices.wire.telemetry import Telemetry

RENEW_BEFORE = 0.5
"""Of a step before its end, at which the next one is decided about, so that the wheels need not stop."""


SETTLED = 0.06
"""Seconds without a count after which a wheel stands."""


class Aim(Frozen):
    """What a movement is to come to. ``unit`` is in counts: of a step, or of a degree."""

    drive: Drive
    amount: int
    unit: float
    stride: int
    """Units that are allowed at once."""
    coast: int
    """Counts that the wheels go on for after a stop."""
    carried: float
    """Counts that the movement before went too far, in the sense of this one."""


class Movement:
    """Runs once. ``done`` and ``stopped_by`` tell what it came to."""

    def __init__(
        self,
        aim: Aim,
        line: RobotLine,
        config: RobotConfig,
        pace: Pace,
        *,
        may_begin: Callable[[Telemetry, float], bool | None],
        bumps: Callable[[Telemetry], bool],
        seen: Callable[[Telemetry, float], None],
    ) -> None:
        """``may_begin`` is asked with what is free of the part that was allowed: True, False, or None for not
        yet known. ``seen`` is told the units done at each look."""
        self.stopped_by: StoppedBy | None = None
        self._aim, self._line, self._config, self._pace = aim, line, config, pace
        self._may_begin, self._bumps, self._seen = may_begin, bumps, seen
        self._permit = line.permit()
        self._era = line.telemetry.era
        self._zero = self._travelled() - aim.carried
        self._allowed = 0
        self._begun = line.now()

    @property
    def counts(self) -> float:
        """How far it came, by what the movement before went too far as well."""
        return self._travelled() - self._zero

    @property
    def units(self) -> float:
        return self.counts / self._aim.unit

    def run(self) -> None:
        """Go, until it is done or something ends it. The wheels are off afterwards."""
        try:
            self.stopped_by = self._go()
        finally:  # whatever is raised by who is told of the movement
            if not self._is_done():
                self._line.stop()
        self._settle()

    def _go(self) -> StoppedBy | None:
        while True:
            telemetry = self._line.telemetry
            self._seen(telemetry, self.units)
            if reason := self._reason_to_end(telemetry):
                return reason
            if self._is_done():
                return None
            if self._allow_more(telemetry) is False:
                return StoppedBy.OBSTACLE
            if not self._is_driven() and not self._is_lost():
                return StoppedBy.USER
            if not self._pace.sleep(self._config.poll):
                return StoppedBy.USER

    def _reason_to_end(self, telemetry: Telemetry) -> StoppedBy | None:
        if self._is_lost():
            return StoppedBy.LINK
        if self._bumps(telemetry):
            return StoppedBy.COLLISION
        return StoppedBy.STALL if self._is_stuck(telemetry) else None

    def _is_lost(self) -> bool:
        return self._line.state is not LinkState.STREAMING or self._line.telemetry.era != self._era

    def _is_stuck(self, telemetry: Telemetry) -> bool:
        """One wheel is enough: the other one would turn the robot about it."""
        since = self._line.driving_since
        if since is None:
            return False
        return self._line.now() - max(since, telemetry.both_moved_at) > self._config.stall

    def _is_done(self) -> bool:
        return self._allowed >= self._aim.amount and self.counts >= self._counts_until(self._allowed)

    def _counts_until(self, units: int) -> float:
        """Where to stop, so that the wheels roll on to the end: after one count at the least."""
        whole = units * self._aim.unit
        return max(whole - self._aim.coast, min(1.0, whole))

    def _stands(self) -> bool:
        return self._line.driving_since is None

    def _allow_more(self, telemetry: Telemetry) -> bool | None:
        """Allow the next stride if it is time to, and free. False if it is known not to be."""
        left = self._allowed - self.units
        if self._allowed and (self._allowed >= self._aim.amount or left > RENEW_BEFORE * self._aim.stride):
            return True
        answer = self._may_begin(telemetry, left)
        if answer:
            self._allowed = min(self._aim.amount, self._allowed + self._aim.stride)
        return None if answer is False and not self._has_come_to_the_end() else answer

    def _has_come_to_the_end(self) -> bool:
        """Of what was allowed."""
        return self._stands() and (self._allowed == 0 or self.counts >= self._counts_until(self._allowed))

    def _is_driven(self) -> bool:
        """Have the wheels turn as far as is allowed. False if somebody stopped them meanwhile."""
        if self._allowed == 0:
            return self._permit == self._line.permit()
        until = self._zero + self._counts_until(self._allowed)
        return self._line.drive(self._permit, self._aim.drive, until)

    def _settle(self) -> None:
        """Let the wheels come to stand, so that the place is the right one."""
        ends = self._line.now() + self._config.settle
        while self._line.now() < ends and not self._is_still():
            if not self._pace.sleep(self._config.poll):
                return
            self._seen(self._line.telemetry, self.units)

    def _is_still(self) -> bool:
        telemetry = self._line.telemetry
        if self._is_lost():
            return True
        return self._stands() and telemetry.at - max(telemetry.moved_at, self._begun) > SETTLED

    def _travelled(self) -> float:
        return travelled(self._aim.drive, self._line.telemetry.right, self._line.telemetry.left)
