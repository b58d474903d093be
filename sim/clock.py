"""Robot time and turns. Robot time is computed, never read; real time is the same run with sleeps.

Of the programs that share a world only one runs at a time: the one with the least robot time. A program keeps
its turn until its robot spends time; then the turn passes to the least time, and among equals to the robot
that is first in the world. So the same programs give the same run, whatever the threads do. A seat that was
announced keeps its place before its program starts; no program waits for a seat that was given up.

This is the only module of the simulator that waits: for real time, and for a turn in a shared world.
"""

from __future__ import annotations

import os
import sys
import threading
from bisect import bisect_left
from collections.abc import Callable, Collection, Iterable, Sequence
from contextlib import suppress
from enum import Enum, auto
from heapq import heapify, heappop, heappush, heapreplace
from math import hypot, inf
from typing import TypeAlias

from devices.ports.robot import Pace
from sim.geometry import Edge, Placement, edges_apart, point_apart

Now = tuple[float, float]
"""The world's time, and the rank of the robot whose turn it is."""


class Landing(Enum):
    """The end of a glide."""

    WHOLE = auto()
    CUT = auto()
    """Something came near. The time of the last tick has passed, but its movement is not done."""
    HALTED = auto()


class Glide:
    """A movement of several ticks, for which the robot hands over its turn only once.

    When it begins, nothing is near its way. Meanwhile the robot is where its past ticks have led: the
    ground puts it there when another robot asks about the place. An approaching robot cuts the glide at the
    current tick, so that the run is the same as without glides.
    """

    def __init__(
        self,
        root: int,
        clock: Clock,
        times: Callable[[], Sequence[float]],
        places: Callable[[int], Placement],
        way: Edge,
        guard: float,
    ) -> None:
        """``times``: the robot's at the end of each tick; ``places`` gives the place after that many ticks.

        ``way``: of the robot's centre. ``guard``: metres from there in which nothing may come.
        """
        self.root = root
        self.clock = clock
        self._began = clock.seat.time
        self._make_times = times
        self._times: Sequence[float] | None = None
        self._in_the_world: Sequence[float] | None = None
        self._places = places
        self.way = way
        self.guard = guard
        ax, ay, bx, by = way
        self.x, self.y = (ax + bx) / 2, (ay + by) / 2
        self.half = hypot(bx - ax, by - ay) / 2
        """A circle around all of its way."""
        self._shown = 0
        self.count: int | None = None
        """Ticks after which it was cut or halted."""

    @property
    def times(self) -> Sequence[float]:
        """Computed on first use, as most glides end without it."""
        if self._times is None:
            self._times = self._make_times()
        return self._times

    @property
    def _world_times(self) -> Sequence[float]:
        if self._in_the_world is None:
            self._in_the_world = self.clock.in_the_world(self.times)
        return self._in_the_world

    def is_near(self, x: float, y: float, reach: float) -> bool:
        """Whether something within ``reach`` of a place may be too near to its way."""
        return point_apart(x, y, self.way) < self.guard + reach

    def is_near_way(self, way: Edge, reach: float) -> bool:
        """Whether something within ``reach`` of another way may be too near to its own."""
        return edges_apart(self.way, way) < self.guard + reach

    def ticks(self, now: Now) -> int:
        """The number of past ticks."""
        time, rank = now
        if time <= self._began:  # as robots that act at the same times ask
            return 0
        times = self._world_times
        count = bisect_left(times, time)
        is_before = count < len(times) and times[count] == time and self.clock.seat.rank < rank
        return count + is_before

    def cut(self, now: Now) -> float:
        """Ends the glide with the current tick. Returns the robot's time at its end."""
        self.count = min(self.ticks(now) + 1, len(self._world_times))
        return self.times[self.count - 1]

    def new_place(self, now: Now) -> Placement | None:
        """Its place now; None if it has not moved since the last call."""
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
        """The world's time, up to which real time was waited for."""
        self.holder: Seat | None = None
        self.queue: list[tuple[float, int, Seat]] = []
        self.glides: dict[Seat, Glide] = {}
        """The current glides; the seats of their robots wait for their ends."""

    def now(self) -> Now:
        """The time of the robot that has the turn, and its rank."""
        holder = self.holder
        return (self.present, inf) if holder is None else (holder.time, holder.rank)

    def cut(self, glides: Collection[Glide]) -> None:
        """End glides that something approaches; the robots act again at the end of the current tick."""
        if not glides:
            return
        with self.lock:
            now = self.now()
            for glide in glides:
                seat = glide.clock.seat
                if self.glides.get(seat) is glide and glide.count is None and seat.waits:
                    place = self.queue.index((seat.time, seat.rank, seat))
                    glide.clock.cut(glide.cut(now))
                    self.queue[place] = (seat.time, seat.rank, seat)
            heapify(self.queue)

    def expect(self, seats: Iterable[Seat]) -> None:
        """Let seats take part from the same moment on, whenever their programs come; those that do stay."""
        with self.lock:
            for seat in seats:
                if not seat.takes_part:
                    seat.takes_part = True
                    seat.time = self.present
                    heappush(self.queue, (seat.time, seat.rank, seat))
            self._appoint()

    def dismiss(self, seat: Seat) -> None:
        """Let a seat no longer take part; without effect if it does not."""
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

    def hand_over(self) -> Seat:
        """Pass the turn to the least seat, and return it; the holder joins the queue. Under the lock."""
        holder = self.holder
        assert holder is not None
        _, _, self.holder = following = heapreplace(self.queue, (holder.time, holder.rank, holder))
        return following[2]

    def _appoint(self) -> None:
        if self.holder is None and self.queue:
            _, _, self.holder = heappop(self.queue)
            self.holder.wake()


class LockGate:
    """A lock that is held while the gate is closed. A condition would cost twice as much."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._lock.acquire()

    def wait(self) -> None:
        self._lock.acquire()

    def open(self) -> None:
        with suppress(RuntimeError):  # it is open
            self._lock.release()


class EventGate:
    """An event counter of Linux, which costs half as much as a lock.

    A thread that releases a lock keeps the interpreter, so the thread that wakes up has to sleep again until
    the interpreter is free. A thread that writes to a file gives up the interpreter first.
    """

    def __init__(self, file: int) -> None:
        """``file``: the number of an eventfd, which the gate closes at its end."""
        self._file = file

    def __del__(self, close: Callable[[int], None] = os.close) -> None:
        close(self._file)

    def wait(self) -> None:
        os.read(self._file, len(_ONE))

    def open(self) -> None:
        os.write(self._file, _ONE)


TurnGate: TypeAlias = LockGate | EventGate
"""A thread waits here until another one opens it. Each opening lets one wait pass, this or the next."""

_ONE = (1).to_bytes(8, sys.byteorder)
MOST_EVENTS = 200
"""Robots of a world that have an event: far fewer than the files that a process may open."""


def new_gate(rank: int) -> TurnGate:
    """A closed gate for the robot with that number in its world."""
    if rank < MOST_EVENTS and hasattr(os, "eventfd"):
        with suppress(OSError):  # too many files are open
            return EventGate(os.eventfd(0))
    return LockGate()


class Seat:
    """A robot's place in the order."""

    def __init__(self, turns: Turns, rank: int) -> None:
        """``rank``: its number in the world, which decides among equal times."""
        self.turns = turns
        self.rank = rank
        self.time = 0.0
        self.takes_part = False
        self._gate: TurnGate | None = None
        """It is opened when there is something to check. Made at the first wait."""

    def take(self, time: float, halted: Callable[[], bool]) -> bool:
        """Wait for the turn at ``time``. False if ``halted`` comes first, which ``nudge`` lets it check."""
        self.time, turns = time, self.turns
        while True:
            with turns.lock:
                if self.is_next(self.time):
                    return True
                following = turns.hand_over() if turns.holder is self else None
                is_over = halted()
                gate = self._gate = self._gate or new_gate(self.rank)
            if following is not None:
                following.wake()  # without the lock, as the woken thread may soon want it
            if is_over:
                return False
            gate.wait()
            if self.is_next(self.time):
                return True

    def is_next(self, time: float) -> bool:
        """Whether it would have the turn at ``time`` without any wait."""
        if not self.takes_part:
            return True
        self.time = time
        turns = self.turns
        queue = turns.queue
        return turns.holder is self and not (queue and queue[0] < (time, self.rank))

    def free_until(self) -> float:
        """The time at which another robot can act, infinity if there is none.

        A robot that glides could act at the end of each of its ticks: soon.
        """
        turns = self.turns
        if not self.takes_part or not turns.queue:
            return inf
        with turns.lock:
            if turns.glides:
                return self.time
            return turns.queue[0][0] if turns.queue else inf

    @property
    def waits(self) -> bool:
        """Whether it is in the queue."""
        return self.takes_part and self.turns.holder is not self

    def nudge(self) -> None:
        """Make a waiting ``take`` check whether it was halted. Any thread."""
        with self.turns.lock:
            self.wake()

    def wake(self) -> None:
        """Let a waiting ``take`` check again, after a change under the lock."""
        if self._gate is not None:
            self._gate.open()


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
        self.seat = seat or Seat(Turns(), 0)
        """Its place among the robots of its world."""
        self._pace = pace
        self._halted = False
        self._turns = self.seat.turns
        self._joined_at = 0.0
        """What the world's time is ahead of this clock's."""

    def join(self) -> None:
        """Take part in the world's order; returns when it is this robot's turn, or after a stop."""
        self._turns.expect((self.seat,))
        self._joined_at = self.seat.time - self.seconds
        self.begin()

    def leave(self) -> None:
        """Take part no more."""
        self._turns.dismiss(self.seat)

    @property
    def takes_part(self) -> bool:
        """Whether this robot takes part in the world's order."""
        return self.seat.takes_part

    @property
    def has_company(self) -> bool:
        """Whether another robot takes part in the world's order."""
        return self._turns.has_others(self.seat)

    def halt(self) -> None:
        """End the current command. From any thread."""
        self._halted = True
        self.seat.nudge()

    def begin(self) -> bool:
        """Begin a command, which ends an earlier halt. False if it must stop before its turn comes."""
        self._halted = False
        time = self.seconds + self._joined_at
        return self.seat.is_next(time) or self._take_turn()

    def is_active(self) -> bool:
        """Whether the command may continue; takes no time."""
        return not self._halted and self._rests(0.0)

    def reset(self) -> None:
        """Back to 0; the world's time continues."""
        self._joined_at += self.seconds
        self.seconds = 0.0

    def undisturbed(self) -> float:
        """Seconds in which no other robot can act."""
        until = self.seat.free_until()
        return until if until == inf else until - self._joined_at - self.seconds

    @property
    def others_glide(self) -> bool:
        """Whether another robot glides, so that one may act at any time."""
        return bool(self._turns.glides and self._turns.queue) and self.seat.takes_part

    def may_leap(self) -> bool:
        """Whether time may be spent at once: no other robot waits or takes part."""
        seat, turns = self.seat, self._turns
        return self.speed is None and (not seat.takes_part or (not turns.queue and turns.holder is seat))

    def leap(self, seconds: float) -> None:
        """Begins a command and spends its time at once."""
        self._halted = False
        self.seconds += seconds
        if self.seat.takes_part:
            self._turns.present = self.seconds + self._joined_at

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
        """Let ``seconds`` pass, in which others act. False if it was cut short."""
        return self.elapse_until(self.seconds + seconds)

    def elapse_until(self, time: float) -> bool:
        """As ``elapse``, until a time of this robot."""
        if not self.is_active():
            return False
        began = self.seconds
        if not self.seat.takes_part:
            seconds = time - began
            return self.spend(seconds, (), end=time) >= seconds
        self.seconds = time
        if self._take_turn() and self._catch_up():
            return True
        self.seconds = min(self.seconds, max(began, self._turns.present - self._joined_at))
        return False

    def in_the_world(self, times: Sequence[float]) -> Sequence[float]:
        """The world's times at times of this robot."""
        joined_at = self._joined_at
        return [each + joined_at for each in times] if joined_at else times

    def follow(self, glide: Glide, last: float) -> Landing:
        """Let the others act until a glide is over, at the time ``last``."""
        began, turns, seat = self.seconds, self._turns, self.seat
        self.seconds = last
        turns.glides[seat] = glide
        if self._take_turn() and self._catch_up():
            del turns.glides[seat]
            return Landing.WHOLE if glide.count is None else Landing.CUT
        with turns.lock:  # without the turn: another thread may be about to cut the glide
            del turns.glides[seat]
        self.seconds = min(self.seconds, max(began, turns.present - self._joined_at))
        glide.count = sum(each <= self.seconds for each in glide.times)
        return Landing.HALTED

    def cut(self, end: float) -> None:
        """The glide ends at that time. Under the lock."""
        self.seconds = end
        self.seat.time = end + self._joined_at

    def was_halted(self) -> bool:
        """Whether a stop ended the last command."""
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
            if self.seat.takes_part and not self._advance_world_time():
                break
        return spent

    def _advance_world_time(self) -> bool:
        """Set the world's time to this robot's. False if another robot has joined that acts first."""
        self._turns.present = time = self.seconds + self._joined_at
        return self.seat.is_next(time)

    def _rests(self, seconds: float) -> bool:
        """Sleep; the pace's answer is kept until the next command."""
        if self._pace.sleep(seconds):
            return True
        self._halted = True
        return False

    def _take_turn(self) -> bool:
        time = self.seconds + self._joined_at
        return self.seat.is_next(time) or (self._rests(0.0) and self.seat.take(time, self.was_halted))

    def _catch_up(self) -> bool:
        """Wait until real time reaches this robot's time."""
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
