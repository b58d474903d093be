"""At equal times the robot that is first in the world has the turn, whichever robot asked first."""

from sim.clock import Seat, Turns


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
