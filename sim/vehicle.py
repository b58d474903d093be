"""One robot as it moves about: where it is and believes to be, with what it drives, what it carries."""

from __future__ import annotations

from functools import cached_property
from math import inf, radians
from typing import TYPE_CHECKING

from devices.ports.robot import STEP, Grip, Motion, Watcher
from devices.ports.values import Frozen
from sim.clock import SLICE, Clock
from sim.ground import Ground
from sim.hand import Hand
from sim.motion import Mover
from sim.placement import Placement, Spot, pose_of
from sim.wheels import TICK, Rate, moving, odometry_of, rates_of

if TYPE_CHECKING:
    from random import Random

    from sim.meeting import Meeting
    from sim.pushing import Advance, Pushing

CLEARANCE = 0.3
"""Metres: a robot that has that much room more than it needs looks around again only after a while."""


class Whereabouts(Frozen):
    """Where a robot is, and where it believes to be."""

    truth: Spot
    belief: Spot


class Vehicle:
    """Shared by all movements of one robot. Only ``here`` is for other threads."""

    def __init__(
        self, ground: Ground, robot: int, clock: Clock, watcher: Watcher | None, chance: Random | None
    ) -> None:
        """A robot that stands at its start. ``robot``: the index of its model; ``chance``: of its errors."""
        self.mover = Mover(ground, robot)
        self.clock = clock
        self._wheels = ground.scene.models[robot].wheels
        self.rates = rates_of(self._wheels)
        self.watcher = watcher
        self.hand = Hand(self.mover)
        self._root = robot
        self._ground = ground
        self._jumps = -1
        self.quicken()
        self.pushed: dict[int, float] = {}
        """Roots of things that the movement has pushed so far, and how many metres."""
        self.here = self._begin(chance)

    @cached_property
    def _pushing(self) -> Pushing:
        from sim.pushing import Pushing  # those who move only

        return Pushing(self._ground, self.mover)

    @cached_property
    def meeting(self) -> Meeting:
        """What is found at the end of a movement."""
        from sim.meeting import Meeting  # those who move only

        return Meeting(self.mover, self._ground.scene, self._root)

    def begin_anew(self, chance: Random | None) -> None:
        """To the start, with empty hands. What was held stays where it is."""
        self.hand.let_go()
        self.go_to(self._begin(chance))

    def _begin(self, chance: Random | None) -> Whereabouts:
        """Nothing of what was before counts. Answers where that is."""
        self.odometry = odometry_of(self._wheels, chance)
        self._leaps = self.odometry.is_exact and self.watcher is None
        self._shown = self._clear_until = -inf
        start = self._ground.start(self._root)
        spot = Spot(start.x, start.y, start.yaw)
        return Whereabouts(spot, spot)

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
            if not self.clock.takes_part:
                self._ground.jumps += 1

    def quicken(self) -> None:
        """Its body has changed: let the ground know how fast points of it may be now."""
        self._clear_until = -inf
        rates = self.rates
        turning = radians(max(rates.right.top, rates.left.top)) * self.mover.body.radius
        self._ground.quicken(max(rates.forward.top, rates.backward.top) * STEP + turning)

    @property
    def changes_around(self) -> int:
        """Another number whenever something else was moved."""
        return self._ground.changes_for(self._root)

    def is_clear(self) -> bool:
        """Whether nothing can come in the way of the next tick.

        Known for a while after it was found out; what others do in their last tick takes a step at most.
        """
        seconds, ground = self.clock.seconds, self._ground
        if self._clear_until >= seconds + TICK and self._jumps == ground.jumps:
            return True
        self._clear_until, self._jumps = -inf, ground.jumps
        if self.clock.takes_part and self.mover.is_far(self.here.truth, CLEARANCE + STEP):
            self._clear_until = seconds + CLEARANCE / (2 * ground.fastest)
        return self._clear_until >= seconds + TICK

    def ahead(self, start: Whereabouts, metres: float, turned: float) -> Whereabouts:
        """So far from ``start`` in the direction that is ``turned`` degrees from the front."""
        truth = start.truth.ahead(metres, start.truth.yaw + turned)
        if self.odometry.is_exact:
            return Whereabouts(truth, truth)
        return Whereabouts(truth, self.odometry.ahead(start.belief, metres, turned))

    def leap(self, steps: int, rate: Rate, turned: float) -> bool:
        """Go straight at once, where nothing is near, nobody watches, and nobody waits. False: did nothing.

        The same as a walk, found and played; this is the quick way for most of the commands of most programs.
        RobotProblem ``cannot-drive`` if the rate is 0.
        """
        if not self._leaps:
            return False
        here, metres = self.here.truth, steps * STEP
        there = here.ahead(metres, here.yaw + turned)
        seconds = moving(rate).over(steps).seconds(0.0, metres / STEP)
        if not self.mover.around.has_room(here.x, here.y, there.x, there.y) or not self.clock.leap(seconds):
            return False
        self.go_to(Whereabouts(there, there))
        return True

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

    def grip(self) -> Grip:
        """See ``Hand.grip``."""
        outcome = self.hand.grip(self.here.truth)
        self.quicken()
        return outcome

    def release(self) -> Grip:
        """See ``Hand.release``."""
        outcome = self.hand.release()
        self.quicken()
        return outcome

    def take_along(self, advance: Advance, angle: float) -> None:
        """Move what the way pushes."""
        for root, metres in advance.pushed:
            self.pushed[root] = self.pushed.get(root, 0.0) + metres
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
