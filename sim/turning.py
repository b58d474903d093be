"""Turns: on the spot, or, for a car, on the smallest circle that it can drive."""

from __future__ import annotations

from math import ceil, radians, sin

from devices.ports.robot import STEP, Bearing, Motion, StoppedBy
from sim.motion import TOUCHING
from sim.movement import Movement, Sweeping
from sim.ramps import NEARLY, TICK, Rate
from sim.vehicle import Vehicle, Whereabouts

DEGREES_A_REPORT = 10


class Turn(Sweeping):
    """On the spot. ``sign``: 1 counter-clockwise, -1 clockwise."""

    def __init__(self, vehicle: Vehicle, motion: Motion, degrees: int, rate: Rate, sign: int) -> None:
        super().__init__(vehicle, motion, degrees, rate, DEGREES_A_REPORT)
        self._sign = sign

    def _at(self, degrees: float) -> Whereabouts:
        return self._vehicle.turned(self._start, self._sign * degrees)

    def _sweep(self, room: int) -> StoppedBy | None:
        vehicle, begun = self._vehicle, self._whole
        free = self._free(room)
        done, is_all = self._play(free, free, lambda degrees: self._at(begun + degrees), room)
        self._whole = begun + (free if is_all else int(done + NEARLY))
        vehicle.go_to(self._at(self._whole))
        if not is_all:
            return StoppedBy.USER if vehicle.clock.was_halted() else None
        return StoppedBy.COLLISION if free < room else None

    def _tick(self) -> StoppedBy | None:
        vehicle = self._vehicle
        to_report = DEGREES_A_REPORT - self._whole % DEGREES_A_REPORT
        in_a_tick = max(1, int(self._course.further(self._whole, TICK)))
        wanted = min(in_a_tick, self._asked - self._whole, to_report)
        is_clear = vehicle.is_clear()
        free = wanted if is_clear else self._free(wanted)
        if free == 0:
            return StoppedBy.COLLISION
        if not vehicle.clock.elapse(self._course.seconds(self._whole, free)):
            return StoppedBy.USER
        self._whole += free if is_clear and vehicle.is_clear() else self._free(free)
        vehicle.go_to(self._at(self._whole))
        vehicle.show()
        self._tell_in_passing()
        return None

    def _free(self, degrees: int) -> int:
        return abs(self._vehicle.mover.turn(self._vehicle.here.truth, self._sign * degrees))


class Bend(Movement):
    """A car's turn, driving forward on a circle of ``radius`` metres: straight pieces, turned by degrees."""

    def __init__(
        self, vehicle: Vehicle, motion: Motion, degrees: int, rate: Rate, sign: int, radius: float
    ) -> None:
        super().__init__(vehicle, motion, degrees, rate, DEGREES_A_REPORT)
        self._sign = sign
        chord = 2 * radius * sin(radians(0.5))
        self._pieces = ceil(chord / STEP)
        """Of each degree, none longer than a step."""
        self._length = chord / self._pieces
        self._piece = 0

    def _go_on(self) -> StoppedBy | None:
        vehicle = self._vehicle
        if vehicle.mover.is_blocked(vehicle.here.truth, Bearing.FRONT):
            return StoppedBy.OBSTACLE
        if not self._goes():
            return StoppedBy.COLLISION
        done = self._whole + self._piece / self._pieces
        if not vehicle.clock.elapse(self._course.seconds(done, 1 / self._pieces)):
            return StoppedBy.USER
        if not self._goes(really=True):
            return StoppedBy.COLLISION
        vehicle.show()
        self._tell_in_passing()
        return None

    def _goes(self, really: bool = False) -> bool:
        """Whether the next piece is free; if so, and ``really``, drive it."""
        vehicle = self._vehicle
        angle = vehicle.here.truth.yaw + self._sign * 0.5
        way = vehicle.way(angle, self._length)
        there = vehicle.ahead(vehicle.here, self._length, self._sign * 0.5)
        turned = self._sign if self._piece == self._pieces - 1 else 0
        if way.metres < self._length - TOUCHING or vehicle.mover.turn(there.truth, turned) != turned:
            return False
        if really:
            vehicle.take_along(way, angle)
            vehicle.go_to(vehicle.turned(there, turned))
            self._piece = (self._piece + 1) % self._pieces
            self._whole += abs(turned)
        return True
