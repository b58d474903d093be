"""Robot time: computed, never read. Real time is the same run with sleeps between.

The one place of the simulator that waits: for real time through the pace, for its turn in a shared world.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import inf

from devices.ports.robot import Pace
from sim.turns import Seat, Turns

SLICE = 1 / 20
"""Seconds of real time between two looks at the speed and at the pace's answer."""

Mark = tuple[float, Callable[[], None]]
"""Seconds from the start of something, and what is to be told then."""

Passing = Callable[[float], None]


class Clock:
    """The time of one robot. ``speed``: a multiple of real time, None is unlimited; any thread may set it."""

    def __init__(self, pace: Pace, speed: float | None, seat: Seat | None = None) -> None:
        """``seat``: its place among the robots of its world; nobody else is there if it is not given."""
        self.speed = speed
        self.seconds = 0.0
        self._pace = pace
        self._halted = False
        self._seat = seat or Seat(Turns(), 0)
        self._turns = self._seat.turns
        self._joined_at = 0.0
        """What the world's time is ahead of this clock's."""

    def join(self) -> None:
        """Take part in the world's order; returns when it is this robot's turn, or after a stop."""
        self._turns.admit(self._seat)
        self._joined_at = self._seat.time - self.seconds
        self.begin()

    def leave(self) -> None:
        """Take part no more."""
        self._turns.dismiss(self._seat)

    @property
    def takes_part(self) -> bool:
        """Whether this robot takes part in the world's order."""
        return self._seat.takes_part

    @property
    def has_company(self) -> bool:
        """Whether another robot takes part in the world's order."""
        return self._turns.has_others(self._seat)

    def halt(self) -> None:
        """End the command that goes on now. From any thread."""
        self._halted = True
        self._seat.nudge()

    def begin(self) -> bool:
        """A command begins: an earlier halt is over. False if it must stop before its turn came."""
        self._halted = False
        return self._comes_to_turn()

    def goes_on(self) -> bool:
        """Whether the command may go on. No time goes by."""
        return not self._halted and self._rests(0.0)

    def reset(self) -> None:
        """Back to 0; the world's time goes on."""
        self._joined_at += self.seconds
        self.seconds = 0.0

    def undisturbed(self) -> float:
        """Seconds in which nobody else can act."""
        until = self._seat.free_until()
        return until if until == inf else until - self._joined_at - self.seconds

    def leap(self, seconds: float) -> bool:
        """Begin and spend, where nobody waits and nobody else is there. False: did nothing."""
        seat, turns = self._seat, self._turns
        if self.speed is not None or (seat.takes_part and (turns.queue or turns.holder is not seat)):
            return False
        self._halted = False
        self.seconds += seconds
        if seat.takes_part:
            turns.present = self.seconds + self._joined_at
        return True

    def spend(self, seconds: float, marks: Sequence[Mark], passing: Passing | None = None) -> float:
        """Let ``seconds`` go by undisturbed, telling ``marks`` (in order) and ``passing`` in every slice.

        Answers how many seconds went by: less than asked if it was halted, the pace said stop, or another
        robot came and is to act before.
        """
        began, spent = self.seconds, 0.0
        for at, tell in (*marks, (seconds, None)):
            spent = self._reach(began, spent, at, passing)
            if spent < at or self._halted:
                return spent
            if tell is not None:
                tell()
        return spent

    def elapse(self, seconds: float) -> bool:
        """Let ``seconds`` go by in which others act. False if it was cut short."""
        if not self.goes_on():
            return False
        if not self._seat.takes_part:
            return self.spend(seconds, ()) >= seconds
        began = self.seconds
        self.seconds = began + seconds
        if self._comes_to_turn() and self._catch_up():
            return True
        self.seconds = min(self.seconds, max(began, self._turns.present - self._joined_at))
        return False

    def was_halted(self) -> bool:
        """Whether a stop ended what went on since the last command began."""
        return self._halted

    def _reach(self, began: float, spent: float, until: float, passing: Passing | None) -> float:
        while spent < until and not self._halted:
            speed = self.speed
            following = until if speed is None else min(until, spent + SLICE * speed)
            if speed is not None and not self._rests((following - spent) / speed):
                break
            spent = following
            self.seconds = began + spent
            if speed is not None and passing is not None:
                passing(spent)
            if self._seat.takes_part and not self._has_brought_the_world_along():
                break
        return spent

    def _has_brought_the_world_along(self) -> bool:
        """The world's time is this robot's. False if somebody has come who is to act before."""
        self._turns.present = time = self.seconds + self._joined_at
        return self._seat.is_next(time)

    def _rests(self, seconds: float) -> bool:
        """Sleep; what the pace says is remembered until the next command."""
        if self._pace.sleep(seconds):
            return True
        self._halted = True
        return False

    def _comes_to_turn(self) -> bool:
        if not self._seat.takes_part:
            return True
        time = self.seconds + self._joined_at
        return self._seat.is_next(time) or (self._rests(0.0) and self._seat.take(time, self.was_halted))

    def _catch_up(self) -> bool:
        """Wait until real time has come to this robot's time too."""
        time = self.seconds + self._joined_at
        while self._turns.present < time:
            if not self._sleep_towards(time) or not self._comes_to_turn():
                return False
        return True

    def _sleep_towards(self, time: float) -> bool:
        speed, present = self.speed, self._turns.present
        if speed is None:
            self._turns.present = time
            return True
        following = min(time, present + SLICE * speed)
        if not self._rests((following - present) / speed) or self._halted:
            return False
        self._turns.present = following
        return True
