"""A belt in virtual time whose wire and board fail at times. After each fault it shows the right levels."""

from __future__ import annotations

from collections.abc import Callable
from random import Random

from devices.belt import HOLD, LETTERS, MOTORS, OFF, BeltSender
from tests.simulated_belt import SimulatedBelt

STEP = 0.01
SHOWN_WITHIN = 0.5
DARK = ("P",) * MOTORS

Fault = Callable[["Belt", bytes], bytes]


def garbled(belt: Belt, data: bytes) -> bytes:
    return bytes(belt.random.randrange(256) if belt.random.random() < 0.05 else each for each in data)


def shortened(belt: Belt, data: bytes) -> bytes:
    return bytes(each for each in data if belt.random.random() > 0.03)


def unplugged(belt: Belt, data: bytes) -> bytes:
    return b""


def restarted(belt: Belt, data: bytes) -> bytes:
    belt.board = SimulatedBelt()
    return data[belt.random.randrange(36) :]


FAULTS: tuple[Fault, ...] = (garbled, shortened, unplugged, restarted)


class Belt:
    """It asserts while it runs. ``live`` advances it to a time, in seconds."""

    def __init__(self, seed: int) -> None:
        self.random = Random(seed)
        self.board = SimulatedBelt()
        self.survived: dict[str, int] = {}
        self._sender = BeltSender()
        self._now = 0.0
        self._next_round = 1.0

    def live(self, until: float) -> None:
        while self._next_round < until:
            self._pass(self._next_round - self._now, None)
            self._round(self.random.choice(FAULTS))
            self._next_round = self._now + self.random.uniform(1, 10)

    def _round(self, fault: Fault) -> None:
        """It shows something during the fault; afterwards the wire is good again."""
        self._sender.show(self._levels(), self._now)
        self._pass(self.random.uniform(0.05, 3), fault)
        if fault is unplugged:
            self._sender.start_over()
        wanted = self._levels()
        self._sender.show(wanted, self._now)
        shown = self._pass(HOLD + SHOWN_WITHIN, None)
        assert shown == tuple(chr(LETTERS[level]) for level in wanted), fault.__name__
        self._sender.show(OFF, self._now)
        self._pass(HOLD + SHOWN_WITHIN, None)
        assert self.board.motors(self._now) == DARK, fault.__name__
        self.survived[fault.__name__] = self.survived.get(fault.__name__, 0) + 1

    def _levels(self) -> tuple[int, ...]:
        return (*(self.random.randint(0, 3) for _ in OFF[1:]), 1)

    def _pass(self, seconds: float, fault: Fault | None) -> tuple[str, ...]:
        """What it showed last: between two frames a board may be dark."""
        shown, ends = DARK, self._now + seconds
        while self._now < ends:
            self._now = min(ends, self._now + STEP)
            data = self._sender.next(self._now)
            self._sender.receive(self.board.feed(fault(self, data) if fault else data, self._now))
            motors = self.board.motors(self._now)
            shown = shown if motors == DARK else motors
        return shown
