"""An hour on a bad line, in virtual time: a learner's robot at work, and something goes wrong all the time.

The faults and the commands are random and seeded; a belt beside it has faults of its own. The board makes 30
passes a second instead of 750, and reads as many bytes, and the line is looked at 50 times instead of 100:
that is all that is simplified.
"""

from __future__ import annotations

import gc
from collections.abc import Callable
from dataclasses import dataclass
from random import Random

import pytest

from devices.ports.robot import Bearing, LinkNews, RobotProblem
from devices.wire.link_state import LinkState
from tests.contract import soak_belt
from tests.unit.devices.robots import Real, Sonars

HOUR = 3600.0
PASSES = 30
LOOK = 0.02
LOSS = [LinkNews.LOST, LinkNews.RESTORED]
RESTART = [LinkNews.LOST, LinkNews.RESTARTED]
"""A board is silent while it starts. One that drives in silence is reset by force."""


@dataclass(frozen=True)
class Fault:
    """Something that goes wrong for some seconds; and what may be told about it, each list once."""

    name: str
    begin: Callable[[Real], None]
    end: Callable[[Real], None]
    seconds: tuple[float, float]
    may_be_told: tuple[list[LinkNews], ...]


def switch(name: str, on: object, off: object) -> tuple[Callable[[Real], None], Callable[[Real], None]]:
    """Sets ``line.wire.noise``, say, to one value and back to the other."""
    *path, last = name.split(".")

    def put(real: Real, value: object) -> None:
        owner: object = real
        for part in path:
            owner = getattr(owner, part)
        setattr(owner, last, value)

    return lambda real: put(real, on), lambda real: put(real, off)


def nothing(real: Real) -> None:
    pass


FAULTS = (
    Fault("noise", *switch("line.wire.noise", 0.001, 0.0), (2, 20), ([],)),
    Fault("half frames", *switch("line.wire.cut", 0.3, 0.0), (2, 20), ([], RESTART)),
    Fault("a short silence", *switch("board.is_mute", True, False), (0.1, 0.4), ([],)),
    Fault("a long silence", *switch("board.is_mute", True, False), (0.7, 5), (LOSS, RESTART)),
    Fault("unplugged", *switch("line.is_plugged", False, True), (0.1, 10), (LOSS,)),
    Fault("a full port", *switch("line.is_blocked", True, False), (0.3, 3), (LOSS,)),
    Fault("a reset", lambda real: real.board.reset(), nothing, (0.1, 0.2), (RESTART,)),
    Fault("a wheel stuck", *switch("board.wheels.is_stuck", True, False), (1, 5), ([],)),
    Fault("a torn count", *switch("board.is_torn", True, True), (0.1, 1), ([],)),
)


class Hour:
    """One run of an hour. It asserts as it goes."""

    def __init__(self, seed: int) -> None:
        self.random = Random(seed)
        self.belt = soak_belt.Belt(seed)
        self.real = Real(Sonars(far=150.0), passes=PASSES)
        self.real.line.look = LOOK
        self.fault: Fault | None = None
        self.fault_ends = 0.0
        self.next_fault = 5.0
        self.told_before = 0
        self.happened: dict[str, int] = {}
        self.real.pace.sleep = self.sleep  # type: ignore[method-assign]

    def sleep(self, seconds: float) -> bool:
        now = self.real.line.now()
        self.belt.live(now)
        if self.fault is not None and now >= self.fault_ends:
            self.fault.end(self.real)
            self.fault_ends = float("inf")
        if self.fault is None and now >= self.next_fault:
            self.fault = self.random.choice(FAULTS)
            self.fault_ends = now + self.random.uniform(*self.fault.seconds)
            self.told_before = len(self.real.news)
            self.fault.begin(self.real)
        return True

    def command(self) -> None:
        """One of the learner's, whatever comes of it."""
        robot, amount = self.real.robot, self.random.randint(1, 4)
        self.random.choice(
            (
                lambda: robot.forward(amount),
                lambda: robot.backward(amount),
                lambda: robot.turn(self.random.choice((-90, 90, 30, -7))),
                lambda: robot.distance(Bearing.FRONT),
                lambda: robot.wait(amount),
            )
        )()

    def recover(self) -> None:
        """Let the fault pass, and the line come back; then look at what was told."""
        assert self.fault is not None
        for _ in range(2000):
            self.sleep(0.0)
            self.real.line.advance(0.02)
            if self.fault_ends == float("inf") and self.real.line.state is LinkState.STREAMING:
                break
        else:
            raise AssertionError(f"never recovered from {self.fault.name}")
        self.real.line.advance(2.0)
        assert self.real.news[self.told_before :] in self.fault.may_be_told, self.fault.name
        self.happened[self.fault.name] = self.happened.get(self.fault.name, 0) + 1
        self.fault, self.next_fault = None, self.real.line.now() + self.random.uniform(0.5, 15)

    def run(self, seconds: float) -> int:
        """Answers by how many objects it grew after the first sixth of the time."""
        line, objects = self.real.line, 0
        while line.now() < seconds:
            began = line.now()
            try:
                self.command()
            except RobotProblem as problem:
                assert problem.code == "link-lost"
                self.real.robot.halt()
            assert line.now() - began < 20.0
            self.real.diary.passed.clear()
            self.real.diary.progress.clear()
            if self.fault is not None:
                self.recover()
            line.advance(0.5)
            assert not self.real.board.is_driving
            if not objects and line.now() > seconds / 6:
                objects = object_count()
        return object_count() - objects


def object_count() -> int:
    gc.collect()
    return len(gc.get_objects())


def test_an_hour_of_faults_hangs_nothing_grows_nothing_and_leaves_no_motor_on() -> None:
    hour = Hour(1)

    grown = hour.run(HOUR)

    assert grown < 300
    assert set(hour.happened) == {fault.name for fault in FAULTS}
    assert sum(hour.happened.values()) > 150
    assert set(hour.belt.survived) == {fault.__name__ for fault in soak_belt.FAULTS}
    assert sum(hour.belt.survived.values()) > 150


@pytest.mark.parametrize("seed", [2, 3, 4, 5], ids=lambda seed: f"seed {seed}")
def test_other_faults_in_another_order_do_not_either(seed: int) -> None:
    hour = Hour(seed)

    assert hour.run(HOUR / 10) < 300
    assert sum(hour.happened.values()) > 10
    assert sum(hour.belt.survived.values()) > 10
