"""Whose turn it is: of the programs that share a world only one runs at a time, the one with the least time.

Rule: a program keeps its turn until its robot spends time. Then the turn goes to the least time, of equals to
the robot that comes first in the world. So the same programs give the same run, whatever the threads do.
A seat that was announced keeps its place before its program has come; nobody waits for one that has left.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable
from heapq import heapify, heappop, heappush, heapreplace
from math import inf


class Turns:
    """The order of one world. Times are seconds since the world was made; they never go back."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.present = 0.0
        """The time up to which the world has come, and has been waited for in real time."""
        self.holder: Seat | None = None
        self.queue: list[tuple[float, int, Seat]] = []

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
        """Whether anybody but this one takes part."""
        with self.lock:
            others = [self.holder, *(entry[2] for entry in self.queue)]
            return any(other is not None and other is not seat for other in others)

    def held_by(self) -> tuple[int, float] | None:
        """The rank of whoever has the turn while others wait, and the time that the world has come to."""
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

    def free_until(self) -> float:
        """The time at which somebody else can act; infinity if there is nobody."""
        queue = self.turns.queue
        if not self.takes_part or not queue:
            return inf
        with self.turns.lock:
            return queue[0][0] if queue else inf

    def nudge(self) -> None:
        """Let a ``take`` that goes on ask whether it was halted. Any thread."""
        with self.turns.lock:
            self.wake()

    def wake(self) -> None:
        """Let a ``take`` that waits look again. Under the lock."""
        if self._gate.locked():
            self._gate.release()

    def _has_the_turn(self) -> bool:
        """Whether it is this one's turn; who holds it too early passes it on."""
        if self.turns.holder is self and self._is_overtaken():
            self.turns.hand_over()
        return self.turns.holder is self

    def _is_overtaken(self) -> bool:
        queue = self.turns.queue
        return bool(queue) and queue[0][:2] < (self.time, self.rank)
