"""Robot time and turns. Robot time is computed, never read; real time is the same run with sleeps.

Of the programs that share a world only one runs at a time: the one with the least robot time. A program keeps
its turn until its robot spends time; then the turn passes to the least time, and among equals to the robot
that is first in the world. So the same programs give the same run, whatever the threads do. A seat that was
announced keeps its place before its program starts; no program waits for a seat that was given up.

This is the only module of the simulator that waits: for real time, and for a turn in a shared world.
"""

from __future__ import annotations

import threading
from bisect import bisect_left
from collections.abc import Callable, Iterable, Sequence
from heapq import heapify, heappop, heappush, heapreplace
from math import inf

from devices.ports.robot import Pace
from sim.geometry import Placement

Now = tuple[float, float]
"""The world's time, and the rank of the robot whose turn it is."""


class Glide:
    """A robot's way of several ticks during which nothing can come near it.

    The robot that glides hands over its turn once, and not in every tick. Meanwhile it is where its ticks up
    to now have led: the ground puts it there when another robot asks about the place. If something moves out
    of turn, the glide is cut at the tick that is due, so that the run is the same as without glides.
    """

    def __init__(
        self,
        root: int,
        rank: int,
        ends: Sequence[float],
        places: Callable[[int], Placement],
        box: tuple[float, float, float, float],
    ) -> None:
        """``ends``: the world's time at the end of each tick; ``places``: where so many ticks lead."""
        self.root = root
        self.rank = rank
        self.ends = ends
        self._places = places
        self.box = box
        """Left, bottom, right and top of all places that its body may touch."""
        self._shown = 0

    def ticks(self, now: Now) -> int:
        """How many ticks are over."""
        time, rank = now
        count = bisect_left(self.ends, time)
        is_before = count < len(self.ends) and self.ends[count] == time and self.rank < rank
        return count + is_before

    def next_end(self, now: Now) -> float:
        """The end of the tick that is due, or of the last one."""
        return self.ends[min(self.ticks(now), len(self.ends) - 1)]

    def new_place(self, now: Now) -> Placement | None:
        """Where it is now; None if it was asked before and has not moved since."""
        ticks = self.ticks(now)
        if ticks == self._shown:
            return None
        self._shown = ticks
        return self._places(ticks)


class Turns:
    """The order of one world. Times are seconds since the world was made; they never go back."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.present = 0.0
        """The time up to which the world has come, and has been waited for in real time."""
        self.holder: Seat | None = None
        self.queue: list[tuple[float, int, Seat]] = []
        self.glides: dict[Seat, tuple[Glide, Clock]] = {}
        """Of robots that glide, whose seat waits for the end of it."""

    def now(self) -> Now:
        """The time of the robot that has the turn, and its rank."""
        holder = self.holder
        return (self.present, inf) if holder is None else (holder.time, holder.rank)

    def cut_glides(self) -> None:
        """Something moves out of turn: robots that glide act again at the end of the tick that is due."""
        with self.lock:
            now = self.now()
            for seat, (glide, clock) in self.glides.items():
                if any(entry[2] is seat for entry in self.queue):
                    clock.cut(glide.next_end(now))
                    self.queue = [entry for entry in self.queue if entry[2] is not seat]
                    self.queue.append((seat.time, seat.rank, seat))
            heapify(self.queue)

    def expect(self, seats: Iterable[Seat]) -> None:
        """These take part from now on, all from the same moment. Their programs may come when they like."""
        with self.lock:
            for seat in seats:
                self._admit(seat)
            self._appoint()

    def admit(self, seat: Seat) -> None:
        """This one takes part, from now on if it did not before."""
        with self.lock:
            self._admit(seat)
            self._appoint()

    def dismiss(self, seat: Seat) -> None:
        """This one takes part no more; without effect if it did not."""
        with self.lock:
            if not seat.takes_part:
                return
            seat.takes_part = False
            seat.wake()
            if self.holder is seat:
                self.holder = None
            else:
                self.queue = [entry for entry in self.queue if entry[2] is not seat]
                heapify(self.queue)
            self._appoint()

    def has_others(self, seat: Seat) -> bool:
        """Whether another robot takes part."""
        with self.lock:
            others = [self.holder, *(entry[2] for entry in self.queue)]
            return any(other is not None and other is not seat for other in others)

    def held_by(self) -> tuple[int, float] | None:
        """The rank of the robot that has the turn while others wait, and the world's time."""
        with self.lock:
            holder = self.holder
            return None if holder is None or not self.queue else (holder.rank, self.present)

    def hand_over(self) -> None:
        """The turn goes to the least; the holder gets in the queue. Under the lock."""
        holder = self.holder
        assert holder is not None
        _, _, self.holder = heapreplace(self.queue, (holder.time, holder.rank, holder))
        self.holder.wake()

    def _admit(self, seat: Seat) -> None:
        if not seat.takes_part:
            seat.takes_part = True
            seat.time = self.present
            heappush(self.queue, (seat.time, seat.rank, seat))

    def _appoint(self) -> None:
        if self.holder is None and self.queue:
            _, _, self.holder = heappop(self.queue)
            self.holder.wake()


class Seat:
    """One robot's place in the order."""

    def __init__(self, turns: Turns, rank: int) -> None:
        """``rank``: its number in the world, which decides among equal times."""
        self.turns = turns
        self.rank = rank
        self.time = 0.0
        self.takes_part = False
        self._gate = threading.Lock()
        """Shut while there is nothing to look at. A condition would cost twice as much."""
        self._gate.acquire()

    def take(self, time: float, halted: Callable[[], bool]) -> bool:
        """Wait until it is this one's turn at ``time``. False if ``halted`` first; ``nudge`` has it asked."""
        self.time = time
        while True:
            with self.turns.lock:
                if not self.takes_part or self._has_the_turn():
                    return True
                if halted():
                    return False
            self._gate.acquire()

    def is_next(self, time: float) -> bool:
        """Whether it would have the turn at ``time`` without any wait."""
        turns = self.turns
        if not self.takes_part:
            return True
        with turns.lock:
            self.time = time
            return turns.holder is self and not self._is_overtaken()

    def free_until(self, enough: float) -> float:
        """The time at which another robot can act, infinity if there is none; perhaps a later one.

        That is where it is below ``enough``. A robot that glides could act at the end of each of its ticks.
        """
        turns = self.turns
        if not self.takes_part or not turns.queue:
            return inf
        with turns.lock:
            until = turns.queue[0][0] if turns.queue else inf
            now = (self.time, self.rank)
            for seat, (glide, _) in turns.glides.items():
                if until < enough:
                    break
                if seat is not self:
                    until = min(until, glide.next_end(now))
            return until

    def nudge(self) -> None:
        """Make a waiting ``take`` check whether it was halted. Any thread."""
        with self.turns.lock:
            self.wake()

    def wake(self) -> None:
        """Let a ``take`` that waits look again. Under the lock."""
        if self._gate.locked():
            self._gate.release()

    def _has_the_turn(self) -> bool:
        """Whether it is this robot's turn; a robot that holds it too early passes it on."""
        if self.turns.holder is self and self._is_overtaken():
            self.turns.hand_over()
        return self.turns.holder is self

    def _is_overtaken(self) -> bool:
        queue = self.turns.queue
        return bool(queue) and queue[0][:2] < (self.time, self.rank)


SLICE = 1 / 20
"""Seconds of real time between two looks at the speed and at the pace's answer."""

Mark = tuple[float, Callable[[], None]]
"""Seconds from the start of a movement, and what to report then."""

Passing = Callable[[float], None]


class Clock:
    """The time of one robot. ``speed``: a multiple of real time, None is unlimited; any thread may set it."""

    def __init__(self, pace: Pace, speed: float | None, seat: Seat | None = None) -> None:
        """``seat``: its place among the robots of its world; without it the robot is alone."""
        self.speed = speed
        self.seconds = 0.0
        self._pace = pace
        self._halted = False
        self._seat = seat or Seat(Turns(), 0)
        self._turns = self._seat.turns
        self._joined_at = 0.0
        """What the world's time is ahead of this clock's."""
        self._times: Sequence[float] = ()
        """Of the glide: the times at which its ticks end."""

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
        """End the current command. From any thread."""
        self._halted = True
        self._seat.nudge()

    def begin(self) -> bool:
        """A command begins: an earlier halt is over. False if it must stop before its turn came."""
        self._halted = False
        return self._take_turn()

    def is_active(self) -> bool:
        """Whether the command may continue. Spends no time."""
        return not self._halted and self._rests(0.0)

    def reset(self) -> None:
        """Back to 0; the world's time continues."""
        self._joined_at += self.seconds
        self.seconds = 0.0

    def undisturbed(self, enough: float = inf) -> float:
        """Seconds in which no other robot can act; perhaps more than that if it is below ``enough``."""
        until = self._seat.free_until(enough + self._joined_at + self.seconds)
        return until if until == inf else until - self._joined_at - self.seconds

    def leap(self, seconds: float) -> bool:
        """Begin and spend, if no other robot waits or takes part. False: did nothing."""
        seat, turns = self._seat, self._turns
        if self.speed is not None or (seat.takes_part and (turns.queue or turns.holder is not seat)):
            return False
        self._halted = False
        self.seconds += seconds
        if seat.takes_part:
            turns.present = self.seconds + self._joined_at
        return True

    def spend(
        self, seconds: float, marks: Sequence[Mark], passing: Passing | None = None, end: float | None = None
    ) -> float:
        """Spend ``seconds``, reporting ``marks`` (in order), and calling ``passing`` in every slice.

        ``end``: the exact time afterwards, where a sum would err in its last digits. Returns the seconds
        spent: fewer than asked if it was halted, the pace stopped, or another robot joined that acts first.
        """
        began, spent = self.seconds, 0.0
        for at, tell in (*marks, (seconds, None)):
            spent = self._reach(began, spent, at, passing)
            if spent < at or self._halted:
                return spent
            if end is not None and at >= seconds:
                self.seconds = end
            if not self._take_turn():  # another robot may act first at the very same time
                return spent
            if tell is not None:
                tell()
        return spent

    def elapse(self, seconds: float) -> bool:
        """Let ``seconds`` go by in which others act. False if it was cut short."""
        return self.elapse_until(self.seconds + seconds)

    def elapse_until(self, time: float) -> bool:
        """The same until a time of this robot."""
        if not self.is_active():
            return False
        began = self.seconds
        if not self._seat.takes_part:
            seconds = time - began
            return self.spend(seconds, (), end=time) >= seconds
        self.seconds = time
        if self._take_turn() and self._catch_up():
            return True
        self.seconds = min(self.seconds, max(began, self._turns.present - self._joined_at))
        return False

    def glide(self, times: Sequence[float], make: Callable[[int, Sequence[float]], Glide]) -> Glide | None:
        """A glide whose ticks end at these times of the robot; None if it must not begin.

        ``make`` gets this robot's rank and the same times as times of the world.
        """
        if self.speed is not None or not self._seat.takes_part or not self.is_active():
            return None
        joined_at = self._joined_at
        return make(self._seat.rank, [each + joined_at for each in times])

    def follow(self, glide: Glide, times: Sequence[float]) -> tuple[int, bool]:
        """Let the others act until a glide is over. How many ticks are over, and whether it was not halted.

        The last of these ticks has only taken its time yet.
        """
        began, self._times = self.seconds, times
        with self._turns.lock:
            self._turns.glides[self._seat] = glide, self
            self.seconds = times[-1]
        is_over = self._take_turn() and self._catch_up()
        with self._turns.lock:
            del self._turns.glides[self._seat]
        if is_over:
            return times.index(self.seconds) + 1, True
        self.seconds = min(self.seconds, max(began, self._turns.present - self._joined_at))
        return sum(each <= self.seconds for each in times), False

    def cut(self, end: float) -> None:
        """The glide ends at that time of the world, the end of one of its ticks. Under the lock."""
        self.seconds = next(each for each in self._times if each + self._joined_at == end)
        self._seat.time = end

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
            if self._seat.takes_part and not self._advance_world_time():
                break
        return spent

    def _advance_world_time(self) -> bool:
        """Set the world's time to this robot's. False if another robot has joined that acts first."""
        self._turns.present = time = self.seconds + self._joined_at
        return self._seat.is_next(time)

    def _rests(self, seconds: float) -> bool:
        """Sleep; what the pace says is remembered until the next command."""
        if self._pace.sleep(seconds):
            return True
        self._halted = True
        return False

    def _take_turn(self) -> bool:
        if not self._seat.takes_part:
            return True
        time = self.seconds + self._joined_at
        return self._seat.is_next(time) or (self._rests(0.0) and self._seat.take(time, self.was_halted))

    def _catch_up(self) -> bool:
        """Wait until real time has come to this robot's time too."""
        time = self.seconds + self._joined_at
        while self._turns.present < time:
            if not self._sleep_towards(time) or not self._take_turn():
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
