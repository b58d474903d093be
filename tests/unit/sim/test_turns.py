"""At equal times the robot that is first in the world has the turn, whichever robot asked first."""

import os
import threading
from math import inf
from pathlib import Path
from unittest.mock import patch

import pytest

from sim.clock import MOST_EVENTS, Clock, LockGate, Seat, Turns, new_gate
from tests.timeouts import TIMEOUT
from tests.unit.sim.floors import Unpaced


def test_the_first_robot_of_the_world_gets_the_turn_at_equal_times() -> None:
    turns = Turns()
    alice, bob = Seat(turns, 0), Seat(turns, 1)

    turns.expect([bob, alice])

    assert turns.holder is alice


def test_an_earlier_robot_gives_way_to_the_first_of_the_world_at_equal_times() -> None:
    turns = Turns()
    alice, bob = Seat(turns, 0), Seat(turns, 1)
    turns.admit(bob)
    turns.admit(alice)
    assert turns.holder is bob, "it was alone"

    assert not bob.is_next(0.0)
    assert not bob.take(0.0, halted=lambda: True)
    assert turns.holder is alice


def test_the_first_robot_of_the_world_keeps_its_turn_at_equal_times() -> None:
    turns = Turns()
    alice, bob = Seat(turns, 0), Seat(turns, 1)
    turns.expect([alice, bob])

    assert alice.is_next(0.0)
    assert not alice.is_next(0.1)


def test_a_robot_that_joins_begins_at_the_time_to_which_another_has_leapt() -> None:
    turns = Turns()
    bob = Seat(turns, 1)
    alice = Clock(Unpaced(), None, Seat(turns, 0))
    alice.join()
    assert alice.may_leap()

    alice.leap(2.5)
    alice.reset()
    alice.leap(1.5)
    turns.admit(bob)

    assert (alice.seconds, bob.time) == (1.5, 4.0)
    assert alice.undisturbed() == 0.0
    assert not alice.may_leap(), "the other one may act first"


def test_a_robot_that_takes_no_part_leaps_and_the_time_of_the_world_stays() -> None:
    turns = Turns()
    bob = Seat(turns, 1)
    alice = Clock(Unpaced(), None, Seat(turns, 0))
    turns.expect([bob])
    assert alice.may_leap()

    alice.leap(2.0)

    assert (alice.seconds, turns.present) == (2.0, 0.0)
    assert alice.undisturbed() == inf


def test_a_robot_with_a_speed_does_not_leap() -> None:
    clock = Clock(Unpaced(), 2.0)
    assert not clock.may_leap()

    clock.speed = None
    assert clock.may_leap()


def test_a_leap_ends_an_earlier_halt() -> None:
    clock = Clock(Unpaced(), None)
    clock.halt()
    assert not clock.is_active()

    clock.leap(1.0)

    assert clock.is_active()


@pytest.mark.parametrize("rank", [0, MOST_EVENTS])
def test_an_opening_of_a_gate_lets_one_wait_pass_before_it_or_after_it(rank: int) -> None:
    gate, passed = new_gate(rank), threading.Semaphore(0)

    def wait() -> None:
        gate.wait()
        passed.release()

    for _ in range(2):  # the second wait must not pass by the openings of the first one
        gate.open()
        gate.open()
        gate.wait()
        thread = threading.Thread(target=wait, daemon=True)
        thread.start()
        assert not passed.acquire(blocking=False)
        gate.open()
        assert passed.acquire(timeout=TIMEOUT)
        thread.join(TIMEOUT)


@pytest.mark.skipif(not hasattr(os, "eventfd"), reason="the system has no eventfd")
def test_only_so_many_robots_of_a_world_have_an_event_and_close_its_file() -> None:
    def events() -> int:
        files = (each.readlink() for each in Path("/proc/self/fd").iterdir() if each.is_symlink())
        return sum("eventfd" in each.name for each in files)

    before = events()
    gates = [new_gate(rank) for rank in range(MOST_EVENTS + 10)]
    assert events() == before + MOST_EVENTS

    gates.clear()
    assert events() == before


def test_a_gate_is_a_lock_if_no_more_files_can_be_opened() -> None:
    with patch("os.eventfd", side_effect=OSError("too many open files"), create=True):
        assert isinstance(new_gate(0), LockGate)
