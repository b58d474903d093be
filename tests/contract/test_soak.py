"""An hour on a bad wire, in virtual time: a learner's robot at work, with one fault after the other.

The faults and the commands are random and seeded; a belt with faults of its own runs as well. To save time
the board makes 30 passes a second instead of 750, but reads as many bytes, and the link is polled 50 times a
second instead of 100.
"""

from __future__ import annotations

import gc
from collections.abc import Callable
from dataclasses import dataclass
from random import Random

import pytest

from devices.ports.robot import Bearing, LinkNotice, RobotProblem
from devices.wire.link_state import LinkState
from tests.contract import soak_belt
from tests.unit.devices.robots import Real, Sonars

pytestmark = pytest.mark.slow

HOUR = 3600.0
PASSES = 30
LOOK = 0.02
LOSS = [LinkNotice.LOST, LinkNotice.RESTORED]
RESTART = [LinkNotice.LOST, LinkNotice.RESTARTED]
"""A board is silent while it starts. One that drives in silence is reset by force."""


@dataclass(frozen=True)
class Fault:
    """A fault of some seconds, and the lists of notices that are correct for it."""

    name: str
    begin: Callable[[Real], None]
    end: Callable[[Real], None]
    seconds: tuple[float, float]
    expected: tuple[list[LinkNotice], ...]


def switch(name: str, on: object, off: object) -> tuple[Callable[[Real], None], Callable[[Real], None]]:
    """Sets ``board.wire.noise``, say, to one value and back to the other."""
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
    Fault("noise", *switch("board.wire.noise", 0.001, 0.0), (2, 20), ([],)),
    Fault("half frames", *switch("board.wire.cut", 0.3, 0.0), (2, 20), ([], RESTART)),
    Fault("a short silence", *switch("board.is_mute", True, False), (0.1, 0.4), ([],)),
    Fault("a long silence", *switch("board.is_mute", True, False), (0.7, 5), (LOSS, RESTART)),
    Fault("unplugged", *switch("link.is_plugged", False, True), (0.1, 10), (LOSS,)),
    Fault("a full port", *switch("link.is_blocked", True, False), (0.3, 3), (LOSS,)),
    Fault("a reset", lambda real: real.board.reset(), nothing, (0.1, 0.2), (RESTART,)),
    Fault("a wheel stuck", *switch("board.wheels.is_stuck", True, False), (1, 5), ([],)),
    Fault("a torn count", *switch("board.is_torn", True, True), (0.1, 1), ([],)),
)


class Hour:
    """One run of an hour. It asserts while it runs."""

    def __init__(self, seed: int) -> None:
        self.random = Random(seed)
        self.belt = soak_belt.Belt(seed)
        self.real = Real(Sonars(far=150.0), passes=PASSES)
        self.real.link.poll = LOOK
        self.fault: Fault | None = None
        self.fault_ends = 0.0
        self.next_fault = 5.0
        self.notices_before = 0
        self.happened: dict[str, int] = {}
        self.real.pace.sleep = self.sleep  # type: ignore[method-assign]

    def sleep(self, seconds: float) -> bool:
        now = self.real.link.now()
        self.belt.live(now)
        if self.fault is not None and now >= self.fault_ends:
            self.fault.end(self.real)
            self.fault_ends = float("inf")
        if self.fault is None and now >= self.next_fault:
            self.fault = self.random.choice(FAULTS)
            self.fault_ends = now + self.random.uniform(*self.fault.seconds)
            self.notices_before = len(self.real.notices)
            self.fault.begin(self.real)
        return True

    def command(self) -> None:
        """One command of a learner, whatever its outcome."""
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
        """Let the fault pass and the link return; then check the notices."""
        assert self.fault is not None
        for _ in range(2000):
            self.sleep(0.0)
            self.real.link.advance(0.02)
            if self.fault_ends == float("inf") and self.real.link.state is LinkState.STREAMING:
                break
        else:
            raise AssertionError(f"never recovered from {self.fault.name}")
        self.real.link.advance(2.0)
        assert self.real.notices[self.notices_before :] in self.fault.expected, self.fault.name
        self.happened[self.fault.name] = self.happened.get(self.fault.name, 0) + 1
        self.fault, self.next_fault = None, self.real.link.now() + self.random.uniform(0.5, 15)

    def run(self, seconds: float) -> int:
        """Returns by how many objects the process grew after the first sixth of the time."""
        link, objects = self.real.link, 0
        while link.now() < seconds:
            began = link.now()
            try:
                self.command()
            except RobotProblem as problem:
                assert problem.code == "link-lost"
                self.real.robot.halt()
            assert link.now() - began < 20.0
            self.real.watcher.passed.clear()
            self.real.watcher.progress.clear()
            if self.fault is not None:
                self.recover()
            link.advance(0.5)
            assert not self.real.board.is_driving
            if not objects and link.now() > seconds / 6:
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
def test_faults_in_another_order_leave_no_motor_on_either(seed: int) -> None:
    hour = Hour(seed)

    assert hour.run(HOUR / 10) < 300
    assert sum(hour.happened.values()) > 10
    assert sum(hour.belt.survived.values()) > 10
