"""Walks: straight forward or backward, step by step, pushing what gives way."""

from __future__ import annotations

from devices.ports.robot import STEP, Bearing, Motion, StoppedBy
from sim.motion import TOUCHING
from sim.movement import Sweeping
from sim.ramps import NEARLY, Rate
from sim.vehicle import Vehicle, Whereabouts


class Walk(Sweeping):
    """Straight forward or backward."""

    def __init__(self, vehicle: Vehicle, motion: Motion, steps: int, rate: Rate) -> None:
        super().__init__(vehicle, motion, steps, rate, 1)
        self._bearing = Bearing.BACK if motion is Motion.BACKWARD else Bearing.FRONT
        self._turned = 180.0 if motion is Motion.BACKWARD else 0.0
        self._angle = self._start.truth.yaw + self._turned
        self._done = 0.0
        """Steps, with fractions."""
        self._must_push = False
        self._is_clear = False
        self._changes = -1

    def _room(self) -> int:
        return super()._room() if self._is_whole and not self._must_push else 0

    @property
    def _is_whole(self) -> bool:
        return abs(self._done - self._whole) < NEARLY

    def _at(self, steps: float) -> Whereabouts:
        return self._vehicle.ahead(self._start, steps * STEP, self._turned)

    def _sweep(self, room: int) -> StoppedBy | None:
        vehicle, begun = self._vehicle, self._whole
        plan = vehicle.mover.walk(vehicle.here.truth, self._bearing, room, vehicle.clock.goes_on)
        amount = plan.metres / STEP
        done, is_all = self._play(plan.steps, amount, lambda steps: self._at(begun + steps), room)
        self._done = begun + done
        self._whole = begun + (plan.steps if is_all else min(plan.steps, int(done + NEARLY)))
        vehicle.go_to(self._at(self._done))
        if not is_all:
            return StoppedBy.USER if vehicle.clock.was_halted() else None
        self._must_push = plan.steps < room
        return plan.stopped_by

    def _tick(self) -> StoppedBy | None:
        vehicle = self._vehicle
        self._is_clear = (self._is_clear or self._is_whole) and vehicle.is_clear()
        if not self._is_clear and self._is_barred():
            return StoppedBy.OBSTACLE
        following = min(self._asked, self._course.next_stop(self._done))
        length = (following - self._done) * STEP
        free = length if self._is_clear else vehicle.way(self._angle, length).metres
        if free < TOUCHING:
            return StoppedBy.COLLISION
        if not vehicle.clock.elapse(self._course.seconds(self._done, free / STEP)):
            return StoppedBy.USER
        self._go(following, length, free)
        return None

    def _push(self, free: float) -> float:
        """Take along what is in the way. Answers how many metres of it are free now."""
        way = self._vehicle.way(self._angle, free)
        self._vehicle.take_along(way, self._angle)
        return way.metres

    def _is_barred(self) -> bool:
        """Sensors are looked at before every step, and within it when something else has moved meanwhile."""
        mover, here, changes = self._vehicle.mover, self._vehicle.here.truth, self._vehicle.changes_around
        if self._is_whole:
            self._changes = changes
            return mover.is_blocked(here, self._bearing)
        if changes == self._changes:
            return False
        return mover.is_met(here, self._bearing, self._whole + 1 - self._done)

    def _go(self, following: float, length: float, free: float) -> None:
        """As far as was free before this robot's turn came, and still is."""
        vehicle = self._vehicle
        metres = free if self._is_clear and vehicle.is_clear() else self._push(free)
        has_come = metres >= length - TOUCHING
        self._done = following if has_come else self._done + metres / STEP
        vehicle.go_to(self._at(self._done))
        vehicle.show()
        if has_come and following == round(following):
            self._whole, self._must_push = round(following), False
            self._tell_in_passing()
