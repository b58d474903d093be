"""One robot as it moves about: where it is and believes to be, with what it drives, what it carries."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

from devices.ports.robot import Motion, Watcher
from sim.clock import SLICE, Clock
from sim.hand import Hand
from sim.motion import Mover
from sim.placement import Placement
from sim.pushing import Advance, Pushing
from sim.sensors import Spot
from sim.units import pose_of
from sim.wheels import Odometry, Rates

TICK = 1 / 20
"""Seconds of robot time at most in which a robot that others may disturb takes the world to stand still."""


@dataclass(frozen=True, slots=True)
class Whereabouts:
    """Where a robot is, and where it believes to be."""

    truth: Spot
    belief: Spot


class Vehicle:
    """Shared by all movements of one robot. Only ``here`` is for other threads."""

    def __init__(self, mover: Mover, clock: Clock, rates: Rates, watcher: Watcher | None) -> None:
        self.mover = mover
        self.clock = clock
        self.rates = rates
        self.watcher = watcher
        self.hand = Hand(mover)
        self._root = mover.around.root
        self._ground = mover.around.ground
        self._pushing = Pushing(self._ground, mover)
        self._shown = -inf
        self.odometry = Odometry()
        self.here = self._at_start()

    def begin_anew(self, odometry: Odometry) -> None:
        """To the start, with empty hands. What was held stays where it is."""
        self.hand.let_go()
        self.odometry = odometry
        self._shown = -inf
        self.go_to(self._at_start())

    def pass_by(self, where: Whereabouts) -> None:
        """Be there for who asks this robot; the ground learns where a movement ends."""
        self.here = where

    def go_to(self, where: Whereabouts) -> None:
        """Be there for everybody."""
        self.here = where
        if self.mover.around.has_company:
            spot = where.truth
            z = self._ground.start(self._root).z
            self._ground.put(self._root, Placement(spot.x, spot.y, z, spot.yaw))
            self.hand.carry(spot)

    def ahead(self, start: Whereabouts, metres: float, turned: float) -> Whereabouts:
        """So far from ``start`` in the direction that is ``turned`` degrees from the front."""
        truth = start.truth.ahead(metres, start.truth.yaw + turned)
        if self.odometry.is_exact:
            return Whereabouts(truth, truth)
        return Whereabouts(truth, self.odometry.ahead(start.belief, metres, turned))

    def turned(self, start: Whereabouts, degrees: float) -> Whereabouts:
        """Turned counter-clockwise. Whole degrees stay exact."""
        it = start.truth
        truth = Spot(it.x, it.y, (it.yaw + degrees) % 360.0)
        if self.odometry.is_exact:
            return Whereabouts(truth, truth)
        return Whereabouts(truth, self.odometry.turned(start.belief, degrees))

    def way(self, angle: float, length: float) -> Advance:
        """What would become of so many metres (at most a step) to ``angle``, from here."""
        return self._pushing.advance(self.here.truth, angle, length)

    def take_along(self, advance: Advance, angle: float) -> None:
        """Move what the way pushes."""
        self._pushing.take_along(advance, angle)

    def show(self) -> None:
        """Tell where it is just now, some 20 times a second of real time; nothing at unlimited speed."""
        speed, seconds = self.clock.speed, self.clock.seconds
        if speed is not None and self.watcher is not None and seconds - self._shown > 0.9 * SLICE * speed:
            self._shown = seconds
            self.watcher.passing(pose_of(self.here.truth))

    def report(self, motion: Motion) -> None:
        """Tell that it has come a whole step, or so many degrees, further."""
        if self.watcher is not None:
            self.watcher.progressed(motion, pose_of(self.here.belief))

    def _at_start(self) -> Whereabouts:
        start = self._ground.start(self._root)
        spot = Spot(start.x, start.y, start.yaw % 360.0)
        return Whereabouts(spot, spot)
