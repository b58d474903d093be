"""At equal times the robot that is first in the world has the turn, whichever robot asked first."""

from math import inf

from sim.clock import Clock, Seat, Turns
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
